use super::*;
use crate::document::{self, Container};
use crate::formula::source::SourceFile;
use crate::language::write;
use crate::notes::statement::statements;

/// What a page says of its names, an object a line.
fn said(page: &str) -> Vec<String> {
    let file = SourceFile::new("page.md", page);
    let document = document::document(file, Container::Markdown);
    let objects = statements(&document).into_iter().filter_map(|statement| match statement.said {
        Said::Object(object) if !matches!(object.sort, Sort::Degree | Sort::Order) => Some(*object),
        _ => None,
    });
    let list = |items: &[Expr]| items.iter().map(write::text).collect::<Vec<_>>().join(" ");
    let line = |object: Object| {
        let mut line = format!("{}: {:?}", list(&object.names), object.sort);
        for (what, items) in [
            (" degree ", object.degree.as_slice()),
            (" of ", object.of.as_slice()),
            (" knots ", &object.knots),
            (" points ", &object.points),
        ] {
            if !items.is_empty() {
                line += what;
                line += &list(items);
            }
        }
        if let Some((from, to)) = &object.interval {
            line += &format!(" on {}..{}", write::text(from), write::text(to));
        }
        line + if object.uniform { " uniform" } else { "" }
    };
    objects.map(line).collect()
}

#[test]
fn objects_in_four_languages() {
    let mut wrong = Vec::new();
    for (page, wanted) in [
        ("Let $f$ be the polar form of $F$.", vec!["f: PolarForm of F"]),
        (
            "Let $F$ be a polynomial of degree $n$ and $f$ its polar form.",
            vec!["F: Polynomial degree n", "f: PolarForm of F"],
        ),
        ("Let $F(t)=t^3$ and let $g$ be its blossom.", vec!["g: PolarForm of F"]),
        (
            "Let $f$ be the polar form of $t^2+2t$, taken as degree 3, and $g$ the polar form of $t^3+1$.",
            vec!["f: PolarForm degree 3 of t^2 + 2 t", "g: PolarForm of t^3 + 1"],
        ),
        (
            "Let $H=fg$ be the product and $h$ the polar form of $H$, of degree 2.",
            vec!["h: PolarForm degree 2 of H"],
        ),
        (
            "Let $f_j$ be the polar form of the piece of $\\mathbf C$ on $[u_j,u_{j+1})$.",
            vec!["f_j: PolarForm of bold(C) on u_j..u_{j+1}"],
        ),
        (
            "Let $N_{0,2}$ be the B-spline of degree 2 on the knots $0,1,2,3$.",
            vec!["N_{0,2}: BSpline degree 2 knots 0 1 2 3"],
        ),
        (
            "let $N_i^k(t)$ be the B-spline of order $k$, that is of degree $k-1$, on the simple knots $t_i,\\dots,t_{i+k}$.",
            vec!["N_i^k: BSpline degree k - 1 knots t_i ... t_{i+k}"],
        ),
        (
            "Let $\\mathbf p(t)$, $0\\le t\\le 1$, be one segment of the uniform cubic B-spline with the de Boor points $d_0,d_1,d_2,d_3$.",
            vec!["bold(p): SplineCurve degree 3 points d_0 d_1 d_2 d_3 on 0..1 uniform"],
        ),
        (
            "Let $\\ell_i$ be the polynomial of degree at most $n$ with $\\ell_i(x_j)=\\delta_{ij}$.",
            vec!["ell_i: Polynomial degree n"],
        ),
        (
            "Let $F$ be quadratic and let $g$ be affine.",
            vec!["F: Polynomial degree 2", "g: Polynomial degree 1"],
        ),
        (
            "Let $F$ be a quadratic polynomial and $f(s,t)$ its polar form.",
            vec!["F: Polynomial degree 2", "f: PolarForm of F"],
        ),
        (
            "Seien $x_0,\\dots,x_n$ paarweise verschieden und $L_0,\\dots,L_n$ die zugehörigen Lagrange-Polynome vom Grad $n$.",
            vec!["L_0 ... L_n: Lagrange degree n knots x0 ... x_n"],
        ),
        ("Let $p$ be a prime.", vec!["p: Other(\"prime\")"]),
        ("Let $G$ be a finite group.", vec!["G: Other(\"finite group\")"]),
        ("Let $A$ and $B$ be invertible matrices.", vec!["A B: Matrix"]),
        (
            "Polynomials $F$ and $G$ with polar forms $f$ and $g$.",
            vec!["F G: Polynomial", "f: PolarForm of F", "g: PolarForm of G"],
        ),
        (
            "The cubic Bézier curve $p$ with control points $b_0,b_1,b_2,b_3$ is drawn.",
            vec!["p: BezierCurve degree 3 points b_0 b_1 b_2 b_3"],
        ),
        (
            "Let $f$ be the polar form of a cubic $F$ and $\\hat 1 = 1 - 0$.",
            vec!["f: PolarForm degree 3 of F", "F: Polynomial degree 3"],
        ),
        (
            "Let $f$ be the polar form of a cubic piece $F$ over $[t_2,t_3]$; its control points are $d_i = 1$.",
            vec![
                "f: PolarForm degree 3 of F on t2..t3",
                "F: Polynomial degree 3 on t2..t3",
                "d_i: ControlPoints of F",
            ],
        ),
        (
            "Let $F$ be a cubic with polar form $f$, $G$ a quadratic with polar form $g$, and $S(t) = 1$ with polar form $s$.",
            vec![
                "F: Polynomial degree 3",
                "f: PolarForm of F",
                "G: Polynomial degree 2",
                "g: PolarForm of G",
                "s: PolarForm of S",
            ],
        ),
        ("Sei $f$ die Polarform von $F$.", vec!["f: PolarForm of F"]),
        (
            "Es sei $F$ ein Polynom vom Grad $n$ und $f$ seine Polarform.",
            vec!["F: Polynomial degree n", "f: PolarForm of F"],
        ),
        ("Soit $f$ la forme polaire de $F$.", vec!["f: PolarForm of F"]),
        (
            "Soit $P$ un polynôme de degré 3 et $p$ sa forme polaire.",
            vec!["P: Polynomial degree 3", "p: PolarForm of P"],
        ),
        ("设 $f$ 是 $F$ 的极形式。", vec!["f: PolarForm of F"]),
        ("设 $F$ 是 $n$ 次多项式，$f$ 是其极形式。", vec!["F: Polynomial degree n", "f: PolarForm of F"]),
        ("The curve is drawn in $t$.", vec![]),
    ] {
        let found = said(page);
        if found != wanted {
            wrong.push(format!("{page}\n    {found:?}\n    {wanted:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
