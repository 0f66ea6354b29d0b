//! Calls of functions elsewhere that are formulas of the functions here: `linspace(0, 1, 5)`, `Tangent(2, x^2)`.

use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::syntax;

use super::as_list;

/// A call elsewhere, and what it is here; each letter stands for an argument.
pub(super) struct Template {
    names: &'static [&'static str],
    letters: &'static [&'static str],
    meaning: &'static str,
}

/// The index of lists in [`TEMPLATES`].
pub(super) const INDEX: &str = "iota";

pub(super) const TEMPLATES: &[Template] = &[
    of(&["linspace"], &["a", "b", "n"], "[a + (b - a) iota/(n - 1) for iota = 0..n - 1]"),
    of(&["arange", "range"], &["a", "b", "s"], "[a + s iota for iota = 0..ceil((b - a)/s) - 1]"),
    of(&["interp", "polyinterp", "PolynomialInterpolation"], &["a", "b", "x"], "lagrange(a, b, variable=x)"),
    of(&["PolynomialInterpolation", "barycentric_interpolate"], &["a", "b"], "lagrange(a, b)"),
    of(&["Series", "series"], &["F", "x", "a", "n"], "taylor(F, a, n, x)"),
    of(&["TaylorPolynomial"], &["F", "a", "n"], "taylor(F, a, n)"),
    of(&["Tangent"], &["a", "F"], "taylor(F, a, 1)"),
    of(&["Range"], &["b"], "[iota for iota = 1..b]"),
    of(&["Range"], &["a", "b"], "[iota for iota = a..b]"),
    of(&["discrim", "disc"], &["F"], "discriminant(F)"),
    of(&["discrim", "disc"], &["F", "x"], "discriminant(F, x)"),
    of(&["Res", "res"], &["F", "G", "x"], "resultant(F, G, x)"),
    of(&["Total"], &["a"], "sum(a)"),
    of(&["Mean", "mean"], &["a"], "sum(a)/length(a)"),
    of(&["lcoeff", "LC"], &["F", "x"], "coefficient(F, x, degree(F, x))"),
    of(&["tcoeff"], &["F", "x"], "coefficient(F, x, 0)"),
    of(&["Exponent"], &["F", "x"], "degree(F, x)"),
    of(&["floordiv", "iquo", "Quotient"], &["a", "b"], "floor(a/b)"),
    of(&["div", "PolynomialQuotientRemainder"], &["F", "G"], "[quotient(F, G), remainder(F, G)]"),
    of(
        &["div", "PolynomialQuotientRemainder", "quo_rem"],
        &["F", "G", "x"],
        "[quotient(F, G, x), remainder(F, G, x)]",
    ),
    of(&["all_coeffs"], &["F"], "reverse(coefficients(F))"),
    of(&["BezierFunction", "BezierCurve"], &["a"], "bezier(a)"),
    of(&["Distance", "distance"], &["a", "b"], "norm(a - b)"),
    of(&["EuclideanDistance"], &["a", "b"], "norm(a - b)"),
    of(&["Extremum", "TurningPoint"], &["F"], "roots(diff(F))"),
    of(&["InflectionPoint"], &["F"], "roots(diff(diff(F)))"),
    of(&["LinearSolve", "linear_solve", "mldivide"], &["M", "b"], "solve(M, b)"),
    of(&["Curve"], &["a", "b", "t", "c", "d"], "curve_of([a, b], c, d, variable=t)"),
];

const fn of(
    names: &'static [&'static str],
    letters: &'static [&'static str],
    meaning: &'static str,
) -> Template {
    Template { names, letters, meaning }
}

/// Whether a name is that of such a function.
pub(super) fn is_called_elsewhere(name: &str) -> bool {
    TEMPLATES.iter().any(|template| template.names.contains(&name))
}

impl Template {
    /// What a call means; `None` if it is none of these.
    pub(super) fn filled(&self, name: &str, arguments: &[Expr], span: Span) -> Option<Kind> {
        let arguments: Vec<Expr> = match arguments.len() == self.letters.len() {
            true => arguments.iter().cloned().map(as_list).collect(),
            false => arguments
                .iter()
                .flat_map(|argument| match &argument.kind {
                    // Series[F, {x, 0, 3}]
                    Kind::Set(items, None) => items.clone(),
                    _ => vec![argument.clone()],
                })
                .collect(),
        };
        let own =
            arguments.iter().any(|argument| crate::judge::written::names::bases(argument).contains(INDEX));
        if !self.names.contains(&name) || self.letters.len() != arguments.len() || own {
            return None;
        }
        let mut meaning = syntax::parse(self.meaning).ok()?;
        self.put_into(&mut meaning, &arguments, span);
        match meaning.kind {
            kind @ (Kind::Apply(..) | Kind::List(_)) => Some(kind),
            _ => Some(Kind::Group(Box::new(meaning))),
        }
    }

    fn put_into(&self, expr: &mut Expr, arguments: &[Expr], span: Span) {
        expr.span = span;
        // variable=x is no relation about x
        if let Kind::Name(name) = &expr.kind
            && let Some(at) = self.letters.iter().position(|letter| letter == name)
        {
            *expr = match &arguments[at].kind {
                Kind::Name(_) | Kind::Number(_) | Kind::List(_) => arguments[at].clone(),
                _ => arguments[at].clone().grouped(),
            };
            return;
        }
        expr.for_each_child_mut(&mut |child| self.put_into(child, arguments, span));
    }
}
