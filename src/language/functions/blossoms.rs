//! More blossoms: q and h, Möbius changes of parameter, apolarity; Bézier points of tetrahedra.

use super::gives::Gives;
use std::sync::Arc;

use super::Builtin;
use super::parameter::{Parameter, VARIABLE, named, optional, required};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated};
use crate::language::ops::errors::{curve_error, linalg_error, polar_error, wrong_kind};
use crate::language::ops::formula::symbol_of;
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Polar, PolarKind, Table, Value};
use crate::math::blossom::{PolarForm, TotalDegreePolarForm, apolar_product, h_blossom, moebius, q_blossom};
use crate::math::curve::{Point, affine};
use crate::math::linalg::determinant;
use crate::math::number::{Rational, multinomial, rational};
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::{One, Zero};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Polar forms");

const POLYNOMIAL: Parameter = required("F", Takes::Polynomial, "a polynomial");

const DEGREE: Parameter = named("degree=n", Takes::Size, "the degree of F", "the number of arguments");

const LETTERS: Parameter = required("variables", Takes::Variables, "three variables").shown("[u, v, w]");

const TETRAHEDRON: Parameter =
    optional("corners", Takes::List, "[0, 0, 0] and the three unit points", "the corners of the tetrahedron")
        .shown("[p, q, r, s]");

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "qblossom",
        parameters: &[POLYNOMIAL, required("q", Takes::Scalar, "the factor"), DEGREE, VARIABLE],
        summary: "the symmetric multiaffine f with f(t, q t, ..., q^(n-1) t) = F(t)",
        gives: Gives::Polar,
        example: "qblossom(t^2, 2)",
        call: |_, args| {
            let (list, variable) = coefficients(args, 0)?;
            let form = q_blossom(&list, &args.scalar(1)?).ok_or_else(|| {
                let message = "there is no q-blossom: a Gaussian binomial coefficient is 0 for this q";
                Diagnostic::error(Code::Domain, message)
                    .at(args.span(1))
                    .hint("choose q other than 0 and roots of unity")
            })?;
            Ok(form_value(form, variable))
        },
        ..NEW
    },
    Builtin {
        name: "hblossom",
        parameters: &[POLYNOMIAL, required("h", Takes::Scalar, "the step"), DEGREE, VARIABLE],
        summary: "the symmetric multiaffine f with f(t, t - h, ..., t - (n-1) h) = F(t)",
        gives: Gives::Polar,
        example: "hblossom(t^2, 1)",
        call: |_, args| {
            let (list, variable) = coefficients(args, 0)?;
            Ok(form_value(h_blossom(&list, &args.scalar(1)?), variable))
        },
        ..NEW
    },
    Builtin {
        name: "mobius",
        parameters: &[
            POLYNOMIAL,
            required("a", Takes::Scalar, "a, in (a t + b)/(c t + d)"),
            required("b", Takes::Scalar, "b"),
            required("c", Takes::Scalar, "c"),
            required("d", Takes::Scalar, "d"),
            DEGREE,
            VARIABLE,
        ],
        summary: "(c t + d)^n F((a t + b)/(c t + d)), as a polar form: a rational change of parameter",
        gives: Gives::Polar,
        example: "mobius(t^2, 1, 0, 1, 1)",
        call: |_, args| {
            let (list, variable) = coefficients(args, 0)?;
            let entries = [args.scalar(1)?, args.scalar(2)?, args.scalar(3)?, args.scalar(4)?];
            Ok(form_value(moebius(&list, &entries), variable))
        },
        ..NEW
    },
    Builtin {
        name: "apolar",
        parameters: &[POLYNOMIAL, required("G", Takes::Polynomial, "another one"), DEGREE, VARIABLE],
        summary: "the apolar product: c f(r_1, ..., r_n) for G = c (t - r_1) ... (t - r_n)",
        gives: Gives::Scalar,
        example: "apolar(t^2 - 1, t^2 + 1)",
        call: |_, args| {
            let (f, g) = (args.univariate(0)?.coefficients, args.univariate(1)?.coefficients);
            let least = f.len().max(g.len()).max(1);
            let n = args.named_size("degree")?.map_or(least, |n| n.saturating_add(1));
            if n < least {
                return Err(too_small(args, least - 1));
            }
            crate::budget::charge_terms(n as u64);
            let filled = |mut list: Vec<Fraction>| {
                list.resize(n, Fraction::zero());
                list
            };
            Ok(Value::Scalar(apolar_product(&filled(f), &filled(g))))
        },
        ..NEW
    },
    Builtin {
        name: "tetrahedral_points",
        parameters: &[
            required("F", Takes::Scalar, "a polynomial in three variables"),
            LETTERS,
            TETRAHEDRON,
            named("degree=d", Takes::Size, "the total degree of F", "the degree"),
        ],
        summary: "the Bézier points f(p^i, q^j, r^k, s^l) of a polynomial over a tetrahedron",
        gives: Gives::Table,
        example: "tetrahedral_points(u v + w, [u, v, w])",
        call: |_, args| tetrahedral_points(args),
        ..NEW
    },
    Builtin {
        name: "from_tetrahedral",
        parameters: &[
            required("points", Takes::Scalars, "the Bézier points, i, then j, then k descending")
                .shown("[b_d000, ..., b_000d]"),
            LETTERS,
            TETRAHEDRON,
        ],
        summary: "the polynomial with these Bézier points over a tetrahedron",
        gives: Gives::Scalar,
        example: "from_tetrahedral([1, 0, 0, 2], [u, v, w])",
        call: |_, args| from_tetrahedral(args),
        ..NEW
    },
    Builtin {
        name: "tetrahedral_value",
        parameters: &[TETRAHEDRAL, required("p", Takes::Point, "the point of space"), TETRAHEDRON],
        summary: "the value of a polynomial with these Bézier points over a tetrahedron, by de Casteljau",
        gives: Gives::Point,
        example: "tetrahedral_value([1, 0, 0, 2], [1/4, 1/4, 1/4])",
        call: |_, args| {
            let levels = tetrahedral_levels(args)?;
            let (value, _) = &levels[levels.len() - 1][0];
            Ok(Value::Scalar(value.clone()))
        },
        ..NEW
    },
    Builtin {
        name: "subdivide_tetrahedron",
        parameters: &[TETRAHEDRAL, required("p", Takes::Point, "the point of space"), TETRAHEDRON],
        summary: "the Bézier points over the four tetrahedra of a point and the faces, corner by corner",
        gives: Gives::List,
        example: "subdivide_tetrahedron([1, 0, 0, 2], [1/4, 1/4, 1/4])",
        call: |_, args| {
            let levels = tetrahedral_levels(args)?;
            let degree = levels.len() - 1;
            // With p in place of corner m: b(p^e_m, the other corners) stands on level e_m.
            let part = |m: usize| -> Option<Value> {
                let point = |index: [usize; 4]| {
                    let level = index[m];
                    let mut own = index;
                    own[m] = 0;
                    levels[level]
                        .iter()
                        .find(|(_, at)| *at == own)
                        .map(|(value, _)| Value::Scalar(value.clone()))
                };
                tetrahedral_indices(degree)
                    .into_iter()
                    .map(point)
                    .collect::<Option<Vec<_>>>()
                    .map(Value::list)
            };
            (0..4)
                .map(part)
                .collect::<Option<Vec<_>>>()
                .map(Value::list)
                .ok_or_else(|| Diagnostic::error(Code::Internal, "a point of the scheme is missing"))
        },
        ..NEW
    },
];

const TETRAHEDRAL: Parameter =
    required("points", Takes::Scalars, "the Bézier points, i, then j, then k descending")
        .shown("[b_d000, ..., b_000d]");

/// (i, j, k, l) with the sum n, i, then j, then k descending.
fn tetrahedral_indices(n: usize) -> Vec<[usize; 4]> {
    let last = |i: usize, j: usize| move |k: usize| [i, j, k, n - i - j - k];
    let middle = |i: usize| move |j: usize| (0..=n - i - j).rev().map(last(i, j));
    (0..=n).rev().flat_map(|i| (0..=n - i).rev().flat_map(middle(i))).collect()
}

/// The degree for which there are so many Bézier points.
fn tetrahedral_degree(args: &Arguments, count: usize) -> Result<usize> {
    let degree = (0..=count).find(|n| (n + 1) * (n + 2) * (n + 3) / 6 >= count);
    degree.filter(|n| (n + 1) * (n + 2) * (n + 3) / 6 == count).ok_or_else(|| {
        let message = format!("{count} points form no tetrahedron: 1, 4, 10, 20, ... points do");
        Diagnostic::error(Code::ControlPoints, message).at(args.span(0))
    })
}

/// A level of de Casteljau's scheme, each point with its exponents.
type Level = Vec<(Fraction, [usize; 4])>;

/// All levels of de Casteljau's scheme: b_e^r = Σ_m λ_m b_{e + m}^{r−1} with the barycentric coordinates λ of the point. The polar values of
/// level r have the point r times.
fn tetrahedral_levels(args: &Arguments) -> Result<Vec<Level>> {
    let points = args.scalars(0)?;
    let degree = tetrahedral_degree(args, points.len())?;
    let weights =
        affine::barycentric(&corners(args)?, &args.point(1)?).map_err(curve_error).at(args.span(1))?;
    let mut levels: Vec<Level> = vec![points.into_iter().zip(tetrahedral_indices(degree)).collect()];
    for r in 1..=degree {
        let last = &levels[r - 1];
        crate::budget::charge_terms(last.len() as u64);
        let places: std::collections::BTreeMap<[usize; 4], &Fraction> =
            last.iter().map(|(value, index)| (*index, value)).collect();
        let next = |index: [usize; 4]| {
            let term = |m: usize| {
                let mut own = index;
                own[m] += 1;
                weights[m].times(places[&own])
            };
            let value = (0..4).fold(Fraction::zero(), |sum, m| sum.plus(&term(m)));
            (value, index)
        };
        levels.push(tetrahedral_indices(degree - r).into_iter().map(next).collect());
    }
    Ok(levels)
}

fn too_small(args: &Arguments, needed: usize) -> Diagnostic {
    let error = Diagnostic::error(
        Code::DegreeTooSmall,
        format!("the polynomial has degree {needed}, more than the bound"),
    );
    error.at(args.span(0)).hint(format!("use degree={needed} or more"))
}

/// The coefficients of a polynomial, as many as the degree asks for, and its variable.
fn coefficients(args: &Arguments, i: usize) -> Result<(Vec<Fraction>, Symbol)> {
    let given = args.univariate(i)?;
    let mut list = given.coefficients;
    if list.is_empty() {
        list.push(Fraction::zero());
    }
    if let Some(degree) = args.named_size("degree")? {
        if degree + 1 < list.len() {
            return Err(too_small(args, list.len() - 1));
        }
        crate::budget::charge_terms(degree as u64);
        list.resize(degree + 1, Fraction::zero());
    }
    Ok((list, given.variable))
}

fn form_value(form: PolarForm<Fraction>, variable: Symbol) -> Value {
    Value::Polar(Arc::new(Polar { kind: PolarKind::Univariate(form), variables: vec![variable] }))
}

/// Three variables and four corners.
fn tetrahedron(args: &Arguments) -> Result<([Symbol; 3], Vec<Point<Fraction>>)> {
    let (value, span) =
        args.given(1).ok_or_else(|| wrong_kind("three variables", &Value::list(Vec::new())))?;
    let wrong = || wrong_kind("three variables", value).at(span).hint("such as [u, v, w]");
    let Value::List(items) = value else { return Err(wrong()) };
    let symbols: Option<Vec<Symbol>> = items.iter().map(symbol_of).collect();
    let symbols: [Symbol; 3] = symbols.and_then(|list| list.try_into().ok()).ok_or_else(wrong)?;
    let corners = corners(args)?;
    Ok((symbols, corners))
}

/// Four corners in space that do not lie in a plane.
fn corners(args: &Arguments) -> Result<Vec<Point<Fraction>>> {
    let corners = match args.given(2) {
        None => {
            let unit = |k: usize| -> Point<Fraction> {
                (0..3).map(|i| Fraction::from(rational(i64::from(i + 1 == k), 1))).collect()
            };
            vec![unit(1), unit(2), unit(3), unit(0)]
        }
        Some((_, span)) => {
            let (points, _) = args.control_points(2)?;
            if points.len() != 4 || points.iter().any(|p| p.len() != 3) {
                return Err(Diagnostic::error(Code::Shape, "a tetrahedron has four corners in space")
                    .at(span)
                    .hint("such as [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]"));
            }
            points
        }
    };
    let [first, rest @ ..] = corners.as_slice() else { return Ok(corners) };
    let edges: Vec<Fraction> =
        rest.iter().flat_map(|p| (0..3).map(|k| p[k].minus(&first[k])).collect::<Vec<_>>()).collect();
    let volume = determinant(&nalgebra::DMatrix::from_row_slice(3, 3, &edges)).map_err(linalg_error)?;
    if volume.is_zero() {
        let error = Diagnostic::error(Code::Degenerate, "the corners of the tetrahedron lie in a plane");
        return Err(error.at(args.span(2)).hint("choose corners in general position"));
    }
    Ok(corners)
}

fn tetrahedral_points(args: &Arguments) -> Evaluated {
    let (symbols, corners) = tetrahedron(args)?;
    let f = args.scalar(0)?;
    let polynomial = f
        .as_polynomial()
        .ok_or_else(|| wrong_kind("a polynomial", &Value::Scalar(f.clone())).at(args.span(0)))?;
    let mut terms = vec![(Vec::new(), polynomial.clone())];
    for s in &symbols {
        terms = terms
            .into_iter()
            .flat_map(|(e, c): (Vec<u32>, MultiPoly)| {
                (0u32..).zip(c.coefficients_in(s)).filter(|(_, c)| !c.is_empty()).map(move |(k, c)| {
                    let mut e = e.clone();
                    e.push(k);
                    (e, c)
                })
            })
            .collect();
    }
    let own = terms.iter().map(|(e, _)| e.iter().sum::<u32>()).max().unwrap_or(0) as usize;
    let degree = args.named_size("degree")?.unwrap_or(own);
    if degree < own {
        return Err(too_small(args, own));
    }
    let terms = terms.into_iter().map(|(e, c)| (e, Fraction::from(c)));
    let form = TotalDegreePolarForm::new(3, degree, terms).map_err(polar_error).at(args.span(0))?;
    let corners: Vec<Vec<Fraction>> = corners.into_iter().map(Vec::from).collect();
    let points = form.bezier_points(&corners).map_err(polar_error).at(args.span(2))?;
    let mut table = Table::with_header(["i j k l", "point"]);
    for (index, value) in points {
        let index: Vec<String> = index.iter().map(ToString::to_string).collect();
        table.rows.push(vec![Cell::words(index.join(" ")), Cell::Value(Value::Scalar(value))]);
    }
    Ok(Value::Table(Arc::new(table)))
}

fn from_tetrahedral(args: &Arguments) -> Evaluated {
    let (symbols, corners) = tetrahedron(args)?;
    let points = args.scalars(0)?;
    let degree = tetrahedral_degree(args, points.len())?;
    let at: Point<Fraction> = symbols.iter().map(|s| Fraction::from(MultiPoly::symbol(s.clone()))).collect();
    let weights = affine::barycentric(&corners, &at).map_err(curve_error).at(args.span(2))?;
    let mut sum = Fraction::zero();
    for (index, point) in tetrahedral_indices(degree).into_iter().zip(&points) {
        let scale = Rational::from_integer(multinomial(&index));
        let factor = index
            .iter()
            .zip(&weights)
            .fold(Fraction::one(), |product, (e, w)| product.times(&w.powered(*e as u32)));
        sum = sum.plus(&point.times(&factor).scaled(&scale));
    }
    Ok(Value::Scalar(sum))
}
