//! Polar forms of products and compositions: by symmetrising and by the diagonal.
#![allow(clippy::print_stdout)]

use polarform::blossom::PolarForm;
use polarform::number::{Rational, integer};

/// The weights w_k of f = Σ w_k e_k, where e_k is the sum of all products of k arguments.
fn shown(form: &PolarForm<Rational>) -> String {
    let weights: Vec<String> = form.weights().iter().map(Rational::to_string).collect();
    weights.join(", ")
}

fn main() {
    let f = PolarForm::new([0, 2, 1].map(integer).to_vec()); // F(t) = t^2 + 2t
    let g = PolarForm::new([1, 0, 0, 1].map(integer).to_vec()); // G(t) = t^3 + 1

    let sum = f.sum(&g);
    println!("F + G: degree {}, weights of e_0, e_1, ...: {}", sum.degree(), shown(&sum));

    // Multiply f(t1, t2) by g(t3, t4, t5) and take the mean over all orders of the arguments,
    // or multiply the polynomials first.
    let product = f.product_by_symmetrizing(&g);
    assert_eq!(product, f.product(&g));
    println!("F G: degree {}, weights: {}", product.degree(), shown(&product));

    // f(g(t1, t2, t3), g(t4, t5, t6)) is not symmetric; its mean over all orders is.
    let composition = f.compose_by_symmetrizing(&g);
    assert_eq!(composition, f.compose(&g));
    println!("F(G(t)): degree {}, weights: {}", composition.degree(), shown(&composition));
}
