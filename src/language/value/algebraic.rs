//! Real algebraic numbers as values.

use super::{Value, grouped_expr};
use crate::formula::Expr;
use crate::math::poly::{AlgebraicNumber, Fraction, MultiPoly, Poly, RealRoot, Symbol};

/// A real number that is no rational number, as the root of a polynomial in some letter.
#[derive(Clone, Debug)]
pub struct Algebraic {
    /// The number.
    pub number: AlgebraicNumber,
    /// The letter in which its polynomial is written.
    pub variable: Symbol,
}

impl PartialEq for Algebraic {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Algebraic {
    /// root_of(F, a, b), which reads back as the number.
    pub fn to_expr(&self) -> Expr {
        let (lower, upper) = self.number.ends();
        let polynomial = grouped_expr(&Fraction::from(in_letter(self.number.polynomial(), &self.variable)));
        Expr::apply(Expr::name("root_of"), vec![polynomial, Expr::number(&lower), Expr::number(&upper)])
    }
}

impl Value {
    /// A real root of a polynomial in some letter.
    pub fn root(root: RealRoot, variable: &Symbol) -> Self {
        match root {
            RealRoot::Rational(q) => Value::number(q),
            RealRoot::Irrational(number) => {
                Value::Algebraic(std::sync::Arc::new(Algebraic { number, variable: variable.clone() }))
            }
        }
    }

    /// The real number that a value is, if it is one.
    pub fn as_real(&self) -> Option<RealRoot> {
        match self {
            Value::Algebraic(root) => Some(RealRoot::Irrational(root.number.clone())),
            other => other.as_rational().map(RealRoot::Rational),
        }
    }
}

/// A polynomial in one variable, written in a letter.
pub fn in_letter(polynomial: &Poly, variable: &Symbol) -> MultiPoly {
    let list: Vec<MultiPoly> = polynomial.coefficients().into_iter().map(MultiPoly::constant).collect();
    MultiPoly::from_coefficients_in(variable, &list)
}
