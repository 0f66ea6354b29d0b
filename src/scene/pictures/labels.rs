//! Names of control points as values of the polar form.

use crate::budget;
use crate::formula::Expr;

/// f(r, …, r), f(r, …, r, s), …, f(s, …, s): the control points of degree n over [r, s].
///
/// ```
/// use polarform::{expr::Expr, scene::pictures::polar_labels, write::text};
/// let labels = polar_labels(&Expr::name("f"), 2, &Expr::int(0), &Expr::int(1));
/// assert_eq!(labels.iter().map(text).collect::<Vec<_>>(), ["f(0, 0)", "f(0, 1)", "f(1, 1)"]);
/// ```
pub fn polar_labels(form: &Expr, degree: usize, r: &Expr, s: &Expr) -> Vec<Expr> {
    casteljau_labels(form, degree, r, s, r).into_iter().next().unwrap_or_default()
}

/// The names of all levels of de Casteljau's algorithm at t: f(r, …, t, …, s, …), level k with k
/// arguments t.
///
/// ```
/// use polarform::{expr::Expr, scene::pictures::casteljau_labels, write::text};
/// let name = Expr::name;
/// let labels = casteljau_labels(&name("f"), 2, &name("r"), &name("s"), &name("t"));
/// assert_eq!(labels[1].iter().map(text).collect::<Vec<_>>(), ["f(r, t)", "f(t, s)"]);
/// ```
pub fn casteljau_labels(form: &Expr, degree: usize, r: &Expr, s: &Expr, t: &Expr) -> Vec<Vec<Expr>> {
    budget::charge_terms((degree as u64).saturating_add(1).saturating_pow(2));
    let label = |level: usize, i: usize| {
        let counts = [(r, degree - level - i), (t, level), (s, i)];
        let arguments = counts.iter().flat_map(|(e, count)| std::iter::repeat_n((*e).clone(), *count));
        Expr::apply(form.clone(), arguments.collect())
    };
    (0..=degree).map(|level| (0..=degree - level).map(|i| label(level, i)).collect()).collect()
}

/// f(t_{i+1}, …, t_{i+n}) for i = 0, 1, …: the de Boor points of degree n over the knots
/// t_1, t_2, …, t_{m}; one for each n neighbours.
///
/// ```
/// use polarform::{expr::Expr, scene::pictures::bspline_labels, write::text};
/// let knots = [0, 0, 1, 2].map(Expr::int);
/// let labels = bspline_labels(&Expr::name("f"), 2, &knots);
/// assert_eq!(labels.iter().map(text).collect::<Vec<_>>(), ["f(0, 0)", "f(0, 1)", "f(1, 2)"]);
/// ```
pub fn bspline_labels(form: &Expr, degree: usize, knots: &[Expr]) -> Vec<Expr> {
    if degree == 0 {
        return Vec::new();
    }
    knots.windows(degree).map(|arguments| Expr::apply(form.clone(), arguments.to_vec())).collect()
}

/// f(a^i, b^j, c^k) with each argument repeated, in the order of
/// [`TriangleDomain`](super::TriangleDomain).
///
/// ```
/// use polarform::{expr::Expr, scene::pictures::triangle_labels, write::text};
/// let name = Expr::name;
/// let labels = triangle_labels(&name("f"), 1, [&name("a"), &name("b"), &name("c")]);
/// assert_eq!(labels.iter().map(text).collect::<Vec<_>>(), ["f(a)", "f(b)", "f(c)"]);
/// ```
pub fn triangle_labels(form: &Expr, degree: usize, corners: [&Expr; 3]) -> Vec<Expr> {
    let label = |counts: [usize; 3]| {
        let arguments =
            corners.iter().zip(counts).flat_map(|(e, count)| std::iter::repeat_n((*e).clone(), count));
        Expr::apply(form.clone(), arguments.collect())
    };
    super::triangle::indices(degree).into_iter().map(label).collect()
}
