//! Roots of quadratic polynomials as they stand on a board: (1 + √5)/2 for root_of(x² − x − 1, 1, 2).

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::formula::{Expr, Kind, Sign, Term};
use crate::math::number::{Int, Rational, integer};

/// root_of(F, a, b)
fn root_arguments(expr: &Expr) -> Option<&[Expr]> {
    let Kind::Apply(callee, groups) = &expr.kind else { return None };
    match (&callee.kind, groups.as_slice()) {
        (Kind::Name(name), [arguments]) if name == "root_of" => Some(arguments),
        _ => None,
    }
}

/// The formula with radicals for the roots of quadratic polynomials in it; `None` if there are none.
pub(super) fn with_radicals(expr: &Expr) -> Option<Expr> {
    fn put_in(expr: &mut Expr) {
        match root_arguments(expr).and_then(as_radical) {
            Some(radical) => *expr = radical,
            None => expr.for_each_child_mut(&mut put_in),
        }
    }
    // A tree may be deeper than the stack.
    let mut open = vec![expr];
    while let Some(part) = open.pop() {
        if root_arguments(part).is_some() {
            let mut shown = expr.clone();
            put_in(&mut shown);
            return Some(shown);
        }
        part.for_each_child(&mut |child| open.push(child));
    }
    None
}

/// p, p/q or −p/q as it is written.
fn number(expr: &Expr) -> Option<Rational> {
    match &expr.kind {
        Kind::Number(q) => Some(q.clone()),
        Kind::Div(above, below, _) => {
            let below = number(below).filter(|q| !q.is_zero())?;
            Some(number(above)? / below)
        }
        Kind::Add(terms) => match terms.as_slice() {
            [Term { sign: Sign::Minus, expr }] => number(expr).map(|q| -q),
            _ => None,
        },
        _ => None,
    }
}

/// The integer coefficients of 1, x, x² of a formula that is written as a sum of multiples of powers of one letter.
fn coefficients(formula: &Expr) -> Option<[Rational; 3]> {
    let single;
    let terms = match &formula.kind {
        Kind::Add(terms) => terms,
        _ => {
            single = vec![Term { sign: Sign::Plus, expr: formula.clone() }];
            &single
        }
    };
    let mut sums = [Rational::zero(), Rational::zero(), Rational::zero()];
    for term in terms {
        let factors = match &term.expr.kind {
            Kind::Mul(factors) => factors.as_slice(),
            _ => std::slice::from_ref(&term.expr),
        };
        let (mut weight, mut power) = (Rational::one(), 0);
        for factor in factors {
            match &factor.kind {
                Kind::Number(q) => weight *= q,
                Kind::Name(_) | Kind::Subscript(..) => power += 1,
                Kind::Pow(base, exponent) => match (&base.kind, &exponent.kind) {
                    (Kind::Name(_), Kind::Number(q)) if *q == Rational::from_integer(2.into()) => power += 2,
                    _ => return None,
                },
                _ => return None,
            }
        }
        let signed = if term.sign == Sign::Minus { -weight } else { weight };
        *sums.get_mut(power)? += signed;
    }
    Some(sums)
}

/// √n = s √d, with the largest s whose prime factors are small.
fn square_out(n: &Int) -> (Int, Int) {
    /// Larger primes are left below the root.
    const LARGEST_PRIME: i64 = 1000;
    let (mut outside, mut inside) = (Int::ONE, n.clone());
    for p in 2..=LARGEST_PRIME {
        let square = Int::from(p * p);
        while (&inside % &square).is_zero() {
            inside = &inside / &square;
            outside *= Int::from(p);
        }
    }
    (outside, inside)
}

/// (−b ± s √d)/(2 a), for the arguments of root_of; `None` unless the polynomial is quadratic.
pub(super) fn as_radical(arguments: &[Expr]) -> Option<Expr> {
    let [formula, _, upper] = arguments else { return None };
    let [c, b, a] = coefficients(formula)?;
    if a.is_zero() {
        return None;
    }
    let upper = number(upper)?;
    // The only root between the ends is the larger one if F has at the upper end the sign that it has far to the right.
    let at_upper = (&a * &upper + &b) * &upper + &c;
    let larger = at_upper.is_negative() == a.is_negative();
    let discriminant = &b * &b - integer(4) * &a * &c;
    if !discriminant.is_positive() || !discriminant.is_integer() {
        return None;
    }
    let (s, d) = square_out(&discriminant.to_integer());
    let twice = integer(2) * &a;
    let (rest, size) = (-b / &twice, (Rational::from_integer(s) / &twice).abs());
    let below = Rational::from_integer(rest.denom().lcm(size.denom()));
    let (rest, size) = (rest * &below, size * &below);
    let root = Expr::apply(Expr::name("sqrt"), vec![Expr::number(&Rational::from_integer(d))]);
    let product = if size.is_one() { root } else { Expr::product(vec![Expr::number(&size), root]) };
    let over = |above: Expr| if below.is_one() { above } else { above.over(Expr::number(&below)) };
    let sign = |minus: bool| if minus { Sign::Minus } else { Sign::Plus };
    if rest.is_zero() {
        return Some(Expr::sum(vec![Term { sign: sign(!larger), expr: over(product) }]));
    }
    let first = Term { sign: sign(rest.is_negative()), expr: Expr::number(&rest.abs()) };
    Some(over(Expr::sum(vec![first, Term { sign: sign(!larger), expr: product }])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::value::Value;
    use crate::math::poly::{Poly, Symbol};
    use proptest::prelude::*;

    /// (p ± q √d)/r as it is written, by a formula of its own.
    fn value(expr: &Expr) -> f64 {
        match &expr.kind {
            Kind::Number(q) => q.to_string().parse().unwrap(),
            Kind::Div(above, below, _) => value(above) / value(below),
            Kind::Mul(factors) => factors.iter().map(value).product(),
            Kind::Add(terms) => terms
                .iter()
                .map(|t| if t.sign == Sign::Minus { -value(&t.expr) } else { value(&t.expr) })
                .sum(),
            Kind::Apply(_, groups) => value(&groups[0][0]).sqrt(),
            other => panic!("{other:?}"),
        }
    }

    proptest! {
        #[test]
        fn both_roots_are_found(a in 1i64..9, b in -30i64..30, c in -40i64..40, turned in any::<bool>()) {
            let k = if turned { -1 } else { 1 };
            let f: Poly = [c * k, b * k, a * k].map(integer).into_iter().collect();
            for (root, _) in f.real_roots(None, None).unwrap() {
                let written = Value::root(root.clone(), &Symbol::new("t")).to_expr();
                let Some(shown) = with_radicals(&written) else { continue };
                let found = value(&shown);
                let ends = match root {
                    crate::math::poly::RealRoot::Irrational(number) => number.refined(&Rational::new(1.into(), 1_000_000.into())).ends(),
                    _ => continue,
                };
                let [lower, upper] = [ends.0, ends.1].map(|q| {
                    q.numer().to_string().parse::<f64>().unwrap() / q.denom().to_string().parse::<f64>().unwrap()
                });
                prop_assert!(lower - 1e-9 <= found && found <= upper + 1e-9, "{found} in [{lower}, {upper}]");
            }
        }
    }

    #[test]
    fn as_on_a_board() {
        let latex = |f: &[i64], i: usize| {
            let f: Poly = f.iter().map(|&c| integer(c)).collect();
            let root = f.real_roots(None, None).unwrap().swap_remove(i).0;
            crate::language::write::latex(&Value::root(root, &Symbol::new("t")).to_expr())
        };
        assert_eq!(latex(&[-2, 0, 1], 1), r"\sqrt{2}");
        assert_eq!(latex(&[-2, 0, 1], 0), r"-\sqrt{2}");
        assert_eq!(latex(&[-1, -1, 1], 1), r"\frac{1 + \sqrt{5}}{2}");
        assert_eq!(latex(&[-4, 0, 125], 1), r"\frac{2 \sqrt{5}}{25}");
        assert!(latex(&[-2, 0, 0, 1], 0).contains("root"));
    }
}
