//! Every way to the same polynomial; degenerate and symbolic data.

use crate::math::interval::Interval;
use nalgebra::DMatrix;
use num_traits::Zero;
use proptest::prelude::*;

use super::hermite::end_derivatives;
use super::*;
use crate::math::basis::{Basis, change_of_basis};
use crate::math::blossom::PolarForm;
use crate::math::linalg::surd::Surd;
use crate::math::linalg::{LinalgError, determinant, inverse, solve};
use crate::math::number::{Int, Rational, factorial, integer as z, rational as q};
use crate::math::poly::{Coefficients, Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};

fn s(name: &str) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::new(name)))
}

fn x(i: i64) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::indexed("x", i)))
}

fn f(k: i64) -> Fraction {
    Fraction::from_rational(&z(k))
}

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-4i64..=4).prop_map(z),
        3 => (-9i64..=9, 1i64..=6).prop_map(|(p, d)| q(p, d)),
        1 => (any::<i64>(), 1..=i64::MAX).prop_map(|(p, d)| q(p, d)),
        1 => (-3i64..=3).prop_map(|p| Rational::from_integer(Int::from(10).pow(40)) + z(p)),
    ]
}

fn distinct_nodes(most: usize) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(number(), 1..=most).prop_map(|mut nodes| {
        let mut kept: Vec<Rational> = Vec::new();
        nodes.retain(|node| {
            let fresh = !kept.contains(node);
            kept.push(node.clone());
            fresh
        });
        nodes
    })
}

fn data(most: usize) -> impl Strategy<Value = (Vec<Rational>, Vec<Rational>)> {
    distinct_nodes(most).prop_flat_map(|nodes| {
        let count = nodes.len();
        (Just(nodes), prop::collection::vec(number(), count))
    })
}

/// f^{(k)}(t)/k! = f[t, …, t], by repeated differentiation.
fn derivative_at<C: Ring>(p: &[C], k: usize, t: &C) -> C {
    in_powers(p).nth_derivative(k).value(t)
}

fn in_powers<C: Ring>(coefficients: &[C]) -> Coefficients<C> {
    Coefficients::new(coefficients.to_vec())
}

fn check_all_ways<C: Field>(nodes: &[C], values: &[C], t: &C) {
    let n = nodes.len() - 1;
    let table = DividedDifferences::new(nodes, values).unwrap();
    let newton = table.newton_form();
    let power = newton.to_power();
    assert_eq!(power.len(), n + 1);
    let lagrange = LagrangeForm::new(nodes, values).unwrap();
    assert_eq!(lagrange.to_power(), power);
    let matrix = vandermonde(nodes, n);
    let column = DMatrix::from_column_slice(n + 1, 1, values);
    assert_eq!(solve(&matrix, &column).unwrap().as_slice(), power);
    assert_eq!(determinant(&matrix).unwrap(), vandermonde_determinant(nodes));
    let expected = in_powers(&power).value(t);
    for (node, value) in nodes.iter().zip(values) {
        assert_eq!(in_powers(&power).value(node), *value);
        assert_eq!(lagrange.value(node), *value);
    }
    assert_eq!(newton.value(t), expected);
    assert_eq!(lagrange.value(t), expected);
    assert_eq!(value_of(&power, t), Some(expected.clone()));
    for scheme in [Scheme::Neville, Scheme::Aitken] {
        let tableau = Tableau::new(scheme, nodes, values, t).unwrap();
        assert_eq!(*tableau.value(), expected);
        for k in 1..=n {
            for i in 0..=n - k {
                let (left, right) = tableau.weights(k, i).unwrap();
                assert!(left.plus(&right).is_one());
                let (a, b) = tableau.parents(k, i).unwrap();
                let below = &tableau.levels()[k - 1];
                assert_eq!(left.times(&below[a]).plus(&right.times(&below[b])), tableau.levels()[k][i]);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn all_ways_agree((nodes, values) in data(6), t in number()) {
        check_all_ways(&nodes, &values, &t);
        let basis = change_of_basis(nodes.len() - 1, &Basis::Lagrange(nodes.clone()), &Basis::Power).unwrap();
        prop_assert_eq!(inverse(&vandermonde(&nodes, nodes.len() - 1)).unwrap(), basis);
    }

    #[test]
    fn order_of_nodes_does_not_matter((nodes, values) in data(6)) {
        let table = DividedDifferences::new(&nodes, &values).unwrap();
        let (mut other_nodes, mut other_values) = (nodes.clone(), values.clone());
        other_nodes.reverse();
        other_values.reverse();
        other_nodes.rotate_left(nodes.len() / 2);
        other_values.rotate_left(nodes.len() / 2);
        let other = DividedDifferences::new(&other_nodes, &other_values).unwrap();
        prop_assert_eq!(table.coefficients().last().unwrap().clone(), other.coefficients().last().unwrap().clone());
        prop_assert_eq!(table.newton_form().to_power(), other.newton_form().to_power());
    }

    #[test]
    fn hermite_data_of_a_polynomial_give_it_back(
        nodes in distinct_nodes(4),
        multiplicities in prop::collection::vec(1usize..4, 4),
        polynomial in prop::collection::vec(number(), 0..12),
        a in number(),
    ) {
        let total: usize = multiplicities.iter().take(nodes.len()).sum();
        let mut polynomial = polynomial;
        polynomial.resize(total, Rational::zero());
        let taken: Vec<(Rational, Vec<Rational>)> = nodes.iter().zip(&multiplicities).map(|(node, m)| {
            (node.clone(), (0..*m).map(|k| derivative_at(&polynomial, k, node)).collect())
        }).collect();
        let table = DividedDifferences::hermite(&taken).unwrap();
        prop_assert_eq!(table.newton_form().to_power(), polynomial.clone());
        // the system of equations
        let sizes: Vec<(Rational, usize)> = nodes.iter().cloned().zip(multiplicities).collect();
        let matrix = confluent_vandermonde(&sizes);
        let right: Vec<Rational> = taken.iter().flat_map(|(_, values)| values.clone()).collect();
        let solution = solve(&matrix, &DMatrix::from_column_slice(total, 1, &right)).unwrap();
        prop_assert_eq!(solution.as_slice(), &polynomial[..]);
        // the basis: the columns of the inverse
        let basis: Vec<Rational> = hermite_basis(&sizes).unwrap().into_iter().flatten().flatten().collect();
        let inverted = inverse(&matrix).unwrap();
        prop_assert_eq!(inverted.as_slice(), &basis[..]);
        // insertion, one datum after the other, the nodes by turns
        let first = &taken[0];
        let mut grown = DividedDifferences::new(std::slice::from_ref(&first.0), &first.1[..1]).unwrap();
        for k in 0..3 {
            for (i, (node, values)) in taken.iter().enumerate() {
                if (k > 0 || i > 0) && let Some(value) = values.get(k) {
                    grown.insert(node.clone(), value.clone()).unwrap();
                }
            }
        }
        prop_assert_eq!(grown, table);
        // the error, also when there are fewer nodes than the degree needs
        let remainder = Remainder::new(&polynomial, &nodes).unwrap();
        let product = in_powers(&remainder.quotient).times(&in_powers(&remainder.nodal));
        let sum = product.plus(&in_powers(&remainder.interpolant.to_power()));
        prop_assert_eq!(sum, in_powers(&polynomial));
        let values: Vec<Rational> = nodes.iter().map(|node| in_powers(&polynomial).value(node)).collect();
        prop_assert_eq!(
            &remainder.interpolant,
            &DividedDifferences::new(&nodes, &values).unwrap().newton_form()
        );
        // the quotient is the divided difference with one node more
        if !nodes.contains(&a) {
            let (mut more, mut values) = (nodes.clone(), values);
            values.push(in_powers(&polynomial).value(&a));
            more.push(a.clone());
            let last = DividedDifferences::new(&more, &values).unwrap().coefficients().pop().unwrap();
            prop_assert_eq!(in_powers(&remainder.quotient).value(&a), last);
        }
    }

    #[test]
    fn bezier_points_of_hermite_data(
        left in prop::collection::vec(number(), 0..4),
        right in prop::collection::vec(number(), 0..4),
        a in number(),
        b in number(),
    ) {
        prop_assume!(a != b && !(left.is_empty() && right.is_empty()));
        let points = hermite_bezier(&Interval::new(a.clone(), b.clone()).unwrap(), &left, &right).unwrap();
        let ends = [(a.clone(), left.clone()), (b.clone(), right.clone())];
        let given: Vec<_> = ends.into_iter().filter(|(_, values)| !values.is_empty()).collect();
        let power = DividedDifferences::hermite(&given).unwrap().newton_form().to_power();
        let form = PolarForm::with_degree(power.clone(), points.len() - 1).unwrap();
        prop_assert_eq!(&points, &form.bezier_points(&Interval::new(a.clone(), b.clone()).unwrap()));
        if !left.is_empty() {
            prop_assert_eq!(end_derivatives(&a, &b, &points, left.len() - 1).unwrap(), left);
        }
    }

    #[test]
    fn points_are_their_coordinates((nodes, values) in data(5), others in prop::collection::vec(number(), 5), t in number()) {
        let others = &others[..nodes.len()];
        let points: Vec<Vec<Rational>> =
            values.iter().zip(others).map(|(a, b)| vec![a.clone(), b.clone()]).collect();
        let both = |a: Vec<Rational>, b: Vec<Rational>| -> Vec<Vec<Rational>> {
            a.into_iter().zip(b).map(|(a, b)| vec![a, b]).collect()
        };
        let one = |values: &[Rational]| polynomial_through(&nodes, values).unwrap();
        let power = both(one(&values), one(others));
        prop_assert_eq!(polynomial_through(&nodes, &points).unwrap(), power.clone());
        prop_assert_eq!(DividedDifferences::new(&nodes, &points).unwrap().newton_form().to_power(), power.clone());
        let tableau = Tableau::new(Scheme::Neville, &nodes, &points, &t).unwrap();
        prop_assert_eq!(tableau.value(), &value_of(&power, &t).unwrap());
        prop_assert_eq!(&LagrangeForm::new(&nodes, &points).unwrap().value(&t), tableau.value());
    }
}

#[test]
fn all_ways_agree_for_symbols() {
    let values: Vec<Fraction> =
        (0..3).map(|i| Fraction::from(MultiPoly::symbol(Symbol::indexed("y", i)))).collect();
    check_all_ways(&[x(0), x(1)], &values[..2], &s("t"));
    check_all_ways(&[s("a"), f(0), s("a") + f(1)], &values, &s("t"));
    check_all_ways(&[s("a")], &values[..1], &s("t"));
}

#[test]
fn all_ways_agree_for_surds() {
    let root = Surd(z(0), z(1));
    let nodes = [Surd(z(0), z(0)), root.clone(), -root.clone(), Surd(z(1), q(1, 2))];
    let values = [root.clone(), Surd(z(1), z(0)), Surd(z(3), z(-1)), Surd(z(0), z(0))];
    check_all_ways(&nodes, &values, &Surd(q(1, 3), z(2)));
}

/// f[x_0, …, x_k] of t^m is the sum of all monomials of degree m − k in x_0, …, x_k.
#[test]
fn differences_of_powers_are_complete_symmetric_functions() {
    let nodes = [x(0), x(1), x(2)];
    let cubes: Vec<Fraction> = nodes.iter().map(|x| x.powered(3)).collect();
    let table = DividedDifferences::new(&nodes, &cubes).unwrap();
    assert_eq!(table.column(2)[0], x(0) + x(1) + x(2));
    assert_eq!(table.column(1)[0], x(0) * x(0) + x(0) * x(1) + x(1) * x(1));
    // equal nodes: the limit
    let data = [x(0).powered(3), f(3) * x(0) * x(0), x(1).powered(3)];
    let table = DividedDifferences::with_repeats(&[x(0), x(0), x(1)], &data).unwrap();
    assert_eq!(table.column(2)[0], x(0) + x(0) + x(1));
    // as polynomials in the last node
    let remainder = Remainder::new(&[f(0), f(0), f(0), f(1)], &[x(0), x(1)]).unwrap();
    assert_eq!(remainder.quotient, [x(0) + x(1), f(1)]);
}

/// Stoer, Bulirsch (2002): the examples of section 2.1.3 and of section 2.1.5.
#[test]
fn textbook_tables() {
    let table = DividedDifferences::new(&[0, 1, 3].map(z), &[1, 3, 2].map(z)).unwrap();
    assert_eq!(table.coefficients(), [z(1), z(2), q(-5, 6)]);
    let row: Vec<_> = (0..3).map(|k| table.column(k)[2 - k].clone()).collect();
    assert_eq!(row, [z(2), q(-1, 2), q(-5, 6)]);
    assert_eq!(table.newton_form().value(&z(2)), q(10, 3));
    let data = [(z(0), vec![z(-1), z(-2)]), (z(1), vec![z(0), z(10), z(40)])];
    let table = DividedDifferences::hermite(&data).unwrap();
    assert_eq!(table.coefficients(), [-1, -2, 3, 6, 5].map(z));
    assert_eq!(table.column(1), [-2, 1, 10, 10].map(z));
    assert_eq!(table.column(2), [3, 9, 20].map(z));
}

#[test]
fn one_node() {
    let table = DividedDifferences::new(&[z(7)], &[z(3)]).unwrap();
    assert_eq!(table.degree(), 0);
    assert_eq!(table.newton_form().to_power(), [z(3)]);
    assert_eq!(table.newton_form().value(&z(100)), z(3));
    assert_eq!(LagrangeForm::new(&[z(7)], &[z(3)]).unwrap().weights(), [z(1)]);
    assert_eq!(vandermonde_determinant::<Rational>(&[]), z(1));
    assert_eq!(nodal_polynomial::<Rational>(&[]), [z(1)]);
    // k equal nodes: Taylor's polynomial
    let table = DividedDifferences::hermite(&[(z(1), vec![z(5), z(4), z(6), z(12)])]).unwrap();
    assert_eq!(table.coefficients(), [5, 4, 3, 2].map(z));
    assert_eq!(hermite_bezier(&Interval::unit(), &[z(4)], &[]), Ok(vec![z(4)]));
    assert_eq!(hermite_bezier(&Interval::unit(), &[], &[z(4), z(2)]), Ok(vec![z(2), z(4)]));
}

#[test]
fn degenerate_points() {
    // of dimension 0, and all equal
    let nothing: Vec<Vec<Rational>> = vec![vec![]; 3];
    let table = DividedDifferences::new(&[0, 1, 2].map(z), &nothing).unwrap();
    assert_eq!(table.newton_form().to_power(), nothing);
    let same = vec![vec![z(2), z(5)]; 3];
    let power = polynomial_through(&[0, 1, 2].map(z), &same).unwrap();
    assert_eq!(power, [[2, 5].map(z), [0, 0].map(z), [0, 0].map(z)]);
}

#[test]
fn quintic_points() {
    // value, slope and curvature at both ends, by hand: b_1 = p + m/5, b_2 = p + 2m/5 + M/20
    let points = hermite_bezier(&Interval::unit(), &[1, 5, 20].map(z), &[0, 10, 40].map(z)).unwrap();
    assert_eq!(points, [1, 2, 4, -2, -2, 0].map(z));
    // the ends may stand in any order, and be symbols
    let back =
        hermite_bezier(&Interval::new(z(1), z(0)).unwrap(), &[0, 10, 40].map(z), &[1, 5, 20].map(z)).unwrap();
    assert!(back.iter().eq(points.iter().rev()));
    let points =
        hermite_bezier(&Interval::new(s("a"), s("b")).unwrap(), &[s("p"), s("m")], &[s("q"), s("n")])
            .unwrap();
    assert_eq!(points[1], s("p") + (s("b") - s("a")) * s("m") / f(3));
    assert_eq!(points[2], s("q") - (s("b") - s("a")) * s("n") / f(3));
}

/// κ(A_n) = (n+1) 2^i C(n,i) at i = ⌊2(n+1)/3⌋ in both norms (Farouki 2012, section 6).
#[test]
fn condition_of_the_change_of_basis() {
    for n in 0..12 {
        let i = 2 * (n + 1) / 3;
        let expected = Int::from(n + 1) * Int::from(2).pow(i as u32) * crate::math::number::binomial(n, i);
        for norm in [Norm::One, Norm::Infinity] {
            assert_eq!(power_bernstein_condition(n, norm).number(), Rational::from_integer(expected.clone()));
        }
    }
    assert_eq!(Norm::One.of(&DMatrix::zeros(0, 0)), z(0));
    let singular = DMatrix::from_element(2, 2, z(1));
    assert!(matches!(matrix_condition(&singular, Norm::One), Err(LinalgError::Singular { .. })));
}

/// Equidistant nodes: Δ^k f = k! h^k f[x_0, …, x_k].
#[test]
fn forward_differences() {
    let values: Vec<Rational> = [3, 1, 4, 1, 5, 9].map(z).to_vec();
    let nodes: Vec<Rational> = (0..6).map(|i| q(i, 2)).collect();
    let table = DividedDifferences::new(&nodes, &values).unwrap();
    let mut row = values;
    for k in 0..6 {
        let scale = Rational::from_integer(factorial(k)) * num_traits::pow(q(1, 2), k);
        assert_eq!(row[0], &table.column(k)[0] * scale);
        row = row.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    }
}

#[test]
fn errors_name_the_offender() {
    use InterpolationError as E;
    let (nodes, values) = ([0, 1, 0].map(z), [1, 2, 3].map(z));
    let equal = E::EqualNodes { first: 0, second: 2 };
    assert_eq!(DividedDifferences::new(&nodes, &values), Err(equal.clone()));
    assert_eq!(LagrangeForm::new(&nodes, &values), Err(equal.clone()));
    assert_eq!(Tableau::new(Scheme::Aitken, &nodes, &values, &z(0)), Err(equal.clone()));
    assert_eq!(barycentric_weights(&nodes), Err(equal.clone()));
    assert_eq!(equal.to_string(), "the nodes x_0 and x_2 are equal");
    assert_eq!(
        DividedDifferences::with_repeats(&nodes, &values).unwrap_err().to_string(),
        "the equal nodes x_0 and x_2 must stand next to each other to be a repeated node"
    );
    assert_eq!(
        DividedDifferences::new(&nodes[..2], &values).unwrap_err().to_string(),
        "2 values needed, 3 given"
    );
    assert_eq!(
        DividedDifferences::<Rational>::new(&[], &[]).unwrap_err().to_string(),
        "at least 1 point needed, 0 given"
    );
    let ragged = [vec![z(0)], vec![z(1), z(2)]];
    assert_eq!(
        polynomial_through(&nodes[..2], &ragged).unwrap_err().to_string(),
        "point 1 has 2 coordinates, the first point has 1"
    );
    let uneven = [(z(0), vec![vec![z(1)]]), (z(1), vec![vec![z(2)], vec![]])];
    assert_eq!(
        DividedDifferences::hermite(&uneven).unwrap_err().to_string(),
        "datum 1 of node 1 has 0 coordinates, the first point has 1"
    );
    let hermite = DividedDifferences::hermite(&[(z(0), vec![z(1)]), (z(1), vec![])]);
    assert_eq!(hermite.unwrap_err().to_string(), "the node x_1 has no value");
    assert_eq!(end_derivatives(&z(0), &z(1), &[z(0)], 1), Err(E::TooFewPoints { needed: 2, given: 1 }));
    assert!(NewtonForm::new(vec![z(1)], vec![z(1)]).is_err());
    assert!(Remainder::<Rational>::new(&[], &[z(0)]).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    /// Numbers go another way than symbols; both give the same.
    #[test]
    fn numbers_agree_with_the_general_way(
        nodes in prop::collection::btree_set((-40i64..40, 1i64..7).prop_map(|(p, d)| q(p, d)), 1..14),
        draws in prop::collection::vec((-99i64..99, 1i64..9), 28),
    ) {
        let nodes: Vec<Rational> = nodes.into_iter().collect();
        let values: Vec<Rational> = draws.iter().take(nodes.len()).map(|(p, d)| q(*p, *d)).collect();
        let points: Vec<Vec<Rational>> =
            draws.chunks(2).take(nodes.len()).map(|pair| pair.iter().map(|(p, d)| q(*p, *d)).collect()).collect();
        prop_assert_eq!(barycentric_weights(&nodes).unwrap(), lagrange::weights_by_differences(&nodes));
        let form = LagrangeForm::new(&nodes, &values).unwrap();
        let power = form.to_power();
        prop_assert_eq!(&power, &form.to_power_by_basis());
        prop_assert_eq!(power.len(), nodes.len());
        for (x, y) in nodes.iter().zip(&values) {
            prop_assert_eq!(value_of(&power, x).unwrap(), y.clone());
        }
        let newton = DividedDifferences::new(&nodes, &values).unwrap().newton_form();
        prop_assert_eq!(newton.to_power(), newton.to_power_by_steps());
        prop_assert_eq!(newton.to_power(), power);
        let curve = LagrangeForm::new(&nodes, &points).unwrap();
        prop_assert_eq!(curve.to_power(), curve.to_power_by_basis());
        for (polynomial, k) in form.basis_polynomials().iter().zip(0..) {
            for (x, j) in nodes.iter().zip(0..) {
                prop_assert_eq!(value_of(polynomial, x).unwrap(), z(i64::from(j == k)));
            }
        }
    }
}
