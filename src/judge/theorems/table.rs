//! Equations of the field, as textbooks have them.
//!
//! On the left stands what the page may define or claim; a bound index is called ν, so that no letter of a page is
//! caught by it. Where degrees and orders of B-splines make a difference, both are given.

use crate::judge::topic::Topic;

/// An equation for a quantity of the field.
pub(super) struct Theorem {
    /// What it is called in reports.
    pub(super) name: &'static str,
    /// In sections on this it is looked for.
    pub(super) topic: Topic,
    /// Its left side.
    pub(super) left: &'static str,
    /// Its right side, where n is a degree.
    pub(super) right: &'static str,
    /// Its right side where n is an order, if that differs.
    pub(super) by_order: Option<&'static str>,
    /// Whether all intervals have to have one length.
    pub(super) equal_lengths: bool,
}

const fn known(topic: Topic, name: &'static str, left: &'static str, right: &'static str) -> Theorem {
    Theorem { name, topic, left, right, by_order: None, equal_lengths: false }
}

/// Where two curves over intervals of one length meet.
const fn even_join(name: &'static str, left: &'static str, right: &'static str) -> Theorem {
    Theorem { name, topic: Topic::Join, left, right, by_order: None, equal_lengths: true }
}

/// A segment between knots at equal distances.
const fn even_segment(name: &'static str, left: &'static str, right: &'static str) -> Theorem {
    Theorem { name, topic: Topic::Spline, left, right, by_order: None, equal_lengths: true }
}

const fn spline(
    name: &'static str,
    left: &'static str,
    right: &'static str,
    by_order: &'static str,
) -> Theorem {
    Theorem { name, topic: Topic::Spline, left, right, by_order: Some(by_order), equal_lengths: false }
}

/// Prautzsch, Boehm, Paluszny: Bézier and B-spline techniques, chapters 3 to 10; Farin: Curves and surfaces for
/// CAGD, chapters 5 to 13.
pub(super) const THEOREMS: &[Theorem] = &[
    known(
        Topic::Elevation,
        "degree elevation",
        r"c_i",
        r"\frac{i}{n+1} b_{i-1} + \left(1 - \frac{i}{n+1}\right) b_i",
    ),
    known(
        Topic::Elevation,
        "degree elevation by r",
        r"c_i^r",
        r"\sum_{\nu=0}^{n} \frac{\binom{n}{\nu}\binom{r}{i-\nu}}{\binom{n+r}{i}} b_\nu",
    ),
    known(
        Topic::Elevation,
        "degree elevation of triangular patches",
        r"c_{i,j,k}",
        r"\frac{1}{n+1}\left(i\, b_{i-1,j,k} + j\, b_{i,j-1,k} + k\, b_{i,j,k-1}\right)",
    ),
    known(
        Topic::Elevation,
        "degree elevation of rational curves",
        r"c_i",
        r"\frac{i\, w_{i-1} b_{i-1} + (n+1-i)\, w_i b_i}{i\, w_{i-1} + (n+1-i)\, w_i}",
    ),
    known(Topic::Subdivision, "the points of the left part", r"a_i", r"b_0^i"),
    known(Topic::Subdivision, "the points of the right part", r"c_i", r"b_i^{n-i}"),
    known(Topic::Subdivision, "Chaikin's scheme", r"p_{2i}^{k+1}", r"\frac34 p_i^k + \frac14 p_{i+1}^k"),
    known(Topic::Subdivision, "Chaikin's scheme", r"p_{2i+1}^{k+1}", r"\frac14 p_i^k + \frac34 p_{i+1}^k"),
    known(
        Topic::Subdivision,
        "the cubic scheme",
        r"p_{2i}^{k+1}",
        r"\frac18 p_{i-1}^k + \frac68 p_i^k + \frac18 p_{i+1}^k",
    ),
    known(Topic::Subdivision, "the cubic scheme", r"p_{2i+1}^{k+1}", r"\frac12 p_i^k + \frac12 p_{i+1}^k"),
    known(Topic::Subdivision, "the cubic scheme", r"p_{2i}^{k+1}", r"\frac12 p_i^k + \frac12 p_{i+1}^k"),
    known(
        Topic::Subdivision,
        "the cubic scheme",
        r"p_{2i+1}^{k+1}",
        r"\frac18 p_i^k + \frac68 p_{i+1}^k + \frac18 p_{i+2}^k",
    ),
    known(
        Topic::Subdivision,
        "the four-point scheme",
        r"p_{2i+1}^{k+1}",
        r"\frac{9}{16} \left(p_i^k + p_{i+1}^k\right) - \frac{1}{16} \left(p_{i-1}^k + p_{i+2}^k\right)",
    ),
    spline(
        "the ratio of de Boor's algorithm",
        r"a_i^r",
        r"\frac{x - t_i}{t_{i+n+1-r} - t_i}",
        r"\frac{x - t_i}{t_{i+n-r} - t_i}",
    ),
    spline(
        "the ratio of de Boor's algorithm",
        r"a_i^r",
        r"\frac{x - t_{i+r}}{t_{i+n+1} - t_{i+r}}",
        r"\frac{x - t_{i+r}}{t_{i+n} - t_{i+r}}",
    ),
    spline(
        "de Boor's algorithm",
        r"d_i^r",
        r"\frac{t_{i+n+1-r} - x}{t_{i+n+1-r} - t_i} d_{i-1}^{r-1} + \frac{x - t_i}{t_{i+n+1-r} - t_i} d_i^{r-1}",
        r"\frac{t_{i+n-r} - x}{t_{i+n-r} - t_i} d_{i-1}^{r-1} + \frac{x - t_i}{t_{i+n-r} - t_i} d_i^{r-1}",
    ),
    known(
        Topic::Spline,
        "de Boor's algorithm",
        r"d_i^r",
        r"\left(1 - a_i^r\right) d_{i-1}^{r-1} + a_i^r d_i^{r-1}",
    ),
    spline(
        "the ratio of knot insertion",
        r"a_i",
        r"\frac{x - t_i}{t_{i+n} - t_i}",
        r"\frac{x - t_i}{t_{i+n-1} - t_i}",
    ),
    known(Topic::Spline, "knot insertion", r"c_i", r"\left(1 - a_i\right) d_{i-1} + a_i d_i"),
    spline(
        "knot insertion",
        r"c_i",
        r"\frac{t_{i+n} - x}{t_{i+n} - t_i} d_{i-1} + \frac{x - t_i}{t_{i+n} - t_i} d_i",
        r"\frac{t_{i+n-1} - x}{t_{i+n-1} - t_i} d_{i-1} + \frac{x - t_i}{t_{i+n-1} - t_i} d_i",
    ),
    spline(
        "the Greville abscissa",
        r"c_i",
        r"\frac{1}{n} \sum_{\nu=1}^{n} t_{i+\nu}",
        r"\frac{1}{n-1} \sum_{\nu=1}^{n-1} t_{i+\nu}",
    ),
    spline(
        "the derivative of a spline",
        r"c_i",
        r"\frac{n}{t_{i+n} - t_i} \left(d_i - d_{i-1}\right)",
        r"\frac{n-1}{t_{i+n-1} - t_i} \left(d_i - d_{i-1}\right)",
    ),
    spline(
        "the derivative of a spline",
        r"c_i",
        r"\frac{n}{t_{i+n+1} - t_{i+1}} \left(d_{i+1} - d_i\right)",
        r"\frac{n-1}{t_{i+n} - t_{i+1}} \left(d_{i+1} - d_i\right)",
    ),
    spline(
        "the recursion of B-splines",
        r"N_{i,n}(x)",
        r"\frac{x - t_i}{t_{i+n} - t_i} N_{i,n-1}(x) + \frac{t_{i+n+1} - x}{t_{i+n+1} - t_{i+1}} N_{i+1,n-1}(x)",
        r"\frac{x - t_i}{t_{i+n-1} - t_i} N_{i,n-1}(x) + \frac{t_{i+n} - x}{t_{i+n} - t_{i+1}} N_{i+1,n-1}(x)",
    ),
    known(Topic::Join, "the C^1 join", r"b_n", r"\frac{h_1 b_{n-1} + h_0 b_{n+1}}{h_0 + h_1}"),
    known(Topic::Join, "the C^1 join", r"c_1", r"b_n + \frac{h_1}{h_0} \left(b_n - b_{n-1}\right)"),
    known(Topic::Join, "the C^1 join", r"c_0", r"\frac{h_1 b_{n-1} + h_0 c_1}{h_0 + h_1}"),
    known(Topic::Join, "the C^1 join", r"b_n", r"\frac{h_1 b_{n-1} + h_0 c_1}{h_0 + h_1}"),
    even_join("the C^1 join over intervals of one length", r"c_1", r"2 b_n - b_{n-1}"),
    even_join("the C^2 join over intervals of one length", r"c_2", r"b_{n-2} - 4 b_{n-1} + 4 b_n"),
    known(
        Topic::Subdivision,
        "the four-point scheme",
        r"p_{2i+1}^{k+1}",
        r"\left(\frac12 + w\right) \left(p_i^k + p_{i+1}^k\right) - w \left(p_{i-1}^k + p_{i+2}^k\right)",
    ),
    even_segment(
        "the uniform quadratic segment",
        r"s(x)",
        r"\frac12 \left((1-x)^2 d_0 + (1 + 2x - 2x^2) d_1 + x^2 d_2\right)",
    ),
    even_segment(
        "the uniform cubic segment",
        r"s(x)",
        r"\frac16 \left((1-x)^3 d_0 + (3x^3 - 6x^2 + 4) d_1 + (1 + 3x + 3x^2 - 3x^3) d_2 + x^3 d_3\right)",
    ),
    known(
        Topic::Neville,
        "Neville's recursion",
        r"p_{i,j}(x)",
        r"\frac{(x - x_i) p_{i+1,j}(x) - (x - x_j) p_{i,j-1}(x)}{x_j - x_i}",
    ),
    known(
        Topic::Neville,
        "Neville's recursion",
        r"p_{i,k}(x)",
        r"\frac{(x - x_i) p_{i+1,k-1}(x) - (x - x_{i+k}) p_{i,k-1}(x)}{x_{i+k} - x_i}",
    ),
    known(
        Topic::Rational,
        "the rational algorithm of de Casteljau",
        r"p_i^r",
        r"\frac{(1-x) w_i^{r-1}}{w_i^r} p_i^{r-1} + \frac{x w_{i+1}^{r-1}}{w_i^r} p_{i+1}^{r-1}",
    ),
    known(
        Topic::Interpolation,
        "the form of Newton",
        r"p(x)",
        r"\sum_{\nu=0}^{n} f[x_0,\dots,x_\nu] \prod_{\mu=0}^{\nu-1} (x-x_\mu)",
    ),
    known(Topic::Rational, "the shoulder point", r"s", r"\frac{b_0 + 2 w b_1 + b_2}{2 (1 + w)}"),
    known(Topic::Rational, "the implicit form of a conic", r"\tau_1^2", r"4 w^2 \tau_0 \tau_2"),
];
