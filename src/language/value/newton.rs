//! Newton's form of a polynomial, which is kept as it is written.

use std::sync::Arc;

use num_traits::{Signed, Zero};

use super::to_expr::{push_term, weighted};
use super::{Clause, Function, Parameter, Shape, Value, polynomial_expr, symbol_expr};
use crate::formula::{Expr, Kind, Sign, Term};
use crate::math::interpolate::NewtonForm;
use crate::math::poly::{Fraction, MultiPoly, Symbol};

/// (t − x_0) (t − x_1) ⋯ with equal neighbours as powers; `None` for no nodes.
///
/// ```
/// use polarform::poly::{Fraction, Symbol};
/// use polarform::number::integer;
/// use polarform::{value::nodes_expr, write::text};
/// let nodes = [0, 1, 1, -2].map(|x| Fraction::from(integer(x)));
/// let product = nodes_expr(&nodes, &Symbol::new("t")).unwrap();
/// assert_eq!(text(&product), "t (t - 1)^2 (t + 2)");
/// ```
pub fn nodes_expr(nodes: &[Fraction], variable: &Symbol) -> Option<Expr> {
    let mut factors: Vec<Expr> = Vec::new();
    for run in nodes.chunk_by(|x, y| x == y) {
        let base = linear(&run[0], variable);
        factors.push(match run.len() {
            1 => base,
            k => base.power(Expr::int(k as i64)),
        });
    }
    (!factors.is_empty()).then(|| Expr::product(factors))
}

/// t, (t − x) or (t + x), with its brackets.
fn linear(node: &Fraction, variable: &Symbol) -> Expr {
    let t = symbol_expr(variable);
    if node.is_zero() {
        return t;
    }
    let (sign, magnitude) = match node.as_rational() {
        Some(q) if q.is_negative() => (Sign::Plus, Expr::number(&q.abs())),
        Some(q) => (Sign::Minus, Expr::number(&q)),
        None => {
            let expr = polynomial_expr(node);
            (Sign::Minus, if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr })
        }
    };
    Expr::sum(vec![Term { sign: Sign::Plus, expr: t }, Term { sign, expr: magnitude }]).grouped()
}

/// c_0 + c_1 (t − x_0) + c_2 (t − x_0) (t − x_1) + …, terms with coefficient 0 left out.
///
/// ```
/// use polarform::interpolate::NewtonForm;
/// use polarform::number::integer;
/// use polarform::poly::{Fraction, Symbol};
/// use polarform::{value::newton_expr, write::text};
/// let numbers = |list: &[i64]| list.iter().map(|&x| Fraction::from(integer(x))).collect::<Vec<_>>();
/// let form = NewtonForm::new(numbers(&[0, 1]), numbers(&[2, -1, 3]))?;
/// assert_eq!(text(&newton_expr(&form, &Symbol::new("t"))), "2 - t + 3 t (t - 1)");
/// # Ok::<(), polarform::interpolate::InterpolationError>(())
/// ```
pub fn newton_expr(form: &NewtonForm<Fraction>, variable: &Symbol) -> Expr {
    let mut terms = Vec::new();
    for (k, c) in form.coefficients().iter().enumerate().filter(|(_, c)| !c.is_zero()) {
        match nodes_expr(&form.nodes()[..k], variable) {
            None => push_term(&mut terms, Term { sign: Sign::Plus, expr: polynomial_expr(c) }),
            Some(product) => {
                let Term { sign, expr } = weighted(c, None);
                let one = matches!(&expr.kind, Kind::Number(q) if num_traits::One::is_one(q));
                let mut factors = match expr.kind {
                    _ if one => Vec::new(),
                    Kind::Add(_) => vec![expr.grouped()],
                    _ => vec![expr],
                };
                match product.kind {
                    Kind::Mul(parts) => factors.extend(parts),
                    _ => factors.push(product),
                }
                terms.push(Term { sign, expr: Expr::product(factors) });
            }
        }
    }
    match Expr::sum(terms) {
        Expr { kind: Kind::Group(body), .. } => *body,
        sum => sum,
    }
}

/// The polynomial as a function of its variable that is shown in Newton's form.
pub fn newton_function(form: &NewtonForm<Fraction>, variable: &Symbol) -> Value {
    let t = Fraction::from(MultiPoly::symbol(variable.clone()));
    Value::Function(Arc::new(Function {
        name: None,
        shape: Shape::plain(1),
        clauses: vec![Clause {
            parameters: vec![Parameter::Name(variable.clone())],
            body: newton_expr(form, variable),
            written: true,
            formula: Some(form.value(&t)),
            scope: Default::default(),
        }],
    }))
}
