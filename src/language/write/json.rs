//! Values and verdicts as JSON. Numbers are strings such as "5/3", so that nothing is lost.

use serde_json::{Value as Json, json};

use super::plain::Plain;
use super::text::Text;
use super::{latex, text};
use crate::formula::Rel;
use crate::language::value::{Claim, Geometry, Language, Notation, Polar, PolarKind, Value};
use crate::math::poly::{Fraction, Symbol};

fn scalar(f: &Fraction) -> String {
    text(&crate::language::value::polynomial_expr(f))
}

/// A value with its kind, its data, and its text and LaTeX.
///
/// Of a figure only its title and description; [`crate::figure::value_json`] draws it, too.
///
/// ```
/// use polarform::{value::Value, write::value_json};
/// assert_eq!(value_json(&Value::int(3), Default::default())["number"], "3");
/// ```
pub fn value_json(value: &Value, notation: Notation) -> Json {
    match value {
        Value::Scalar(f) => match (f.as_rational(), f.as_polynomial()) {
            (Some(q), _) => json!({"kind": "number", "number": q.to_string(),
                "text": q.to_string(), "latex": latex(&value.to_expr())}),
            (None, Some(p)) => {
                let terms: Vec<Json> = p
                    .terms(crate::math::poly::MonomialOrder::GrLex)
                    .into_iter()
                    .map(|(powers, c)| {
                        let powers: serde_json::Map<String, Json> =
                            powers.into_iter().map(|(symbol, e)| (symbol.to_string(), json!(e))).collect();
                        json!({"coefficient": c.to_string(), "powers": powers})
                    })
                    .collect();
                json!({"kind": "polynomial", "terms": terms, "text": scalar(f),
                    "latex": latex(&value.to_expr())})
            }
            _ => json!({"kind": "fraction",
                "numerator": scalar(&Fraction::from(f.numerator().clone())),
                "denominator": scalar(&Fraction::from(f.denominator().clone())),
                "text": scalar(f), "latex": latex(&value.to_expr())}),
        },
        Value::Algebraic(root) => {
            let (lower, upper) = root.number.ends();
            let list: Vec<String> =
                root.number.polynomial().coefficients().iter().map(ToString::to_string).collect();
            json!({"kind": "algebraic", "coefficients": list,
                "interval": [lower.to_string(), upper.to_string()],
                "text": text(&value.to_expr()), "latex": latex(&value.to_expr())})
        }
        Value::Vector(f) => json!({"kind": "vector", "coordinate": scalar(f),
            "text": text(&value.to_expr()), "latex": latex(&value.to_expr())}),
        Value::Polar(polar) => polar_json(polar, notation),
        Value::Function(_) | Value::Builtin(_) => json!({"kind": "function",
            "text": text(&value.to_expr()), "latex": latex(&value.to_expr())}),
        Value::List(items) => json!({"kind": "list",
            "items": items.iter().map(|item| value_json(item, notation)).collect::<Vec<_>>()}),
        Value::Matrix(matrix) => {
            let rows: Vec<Vec<String>> = (0..matrix.nrows())
                .map(|i| (0..matrix.ncols()).map(|j| scalar(&matrix[(i, j)])).collect())
                .collect();
            json!({"kind": "matrix", "rows": rows, "latex": latex(&value.to_expr())})
        }
        Value::Geometry(geometry) => geometry_json(geometry),
        Value::Piecewise(function) => json!({"kind": "piecewise", "variable": function.variable.to_string(),
            "breaks": function.function.breaks().iter().map(scalar).collect::<Vec<_>>(),
            "pieces": function.formulas().iter().map(scalar).collect::<Vec<_>>(),
            "outside": matches!(function.function.outside(), crate::math::piecewise::Outside::Zero).then_some("0"),
            "text": text(&value.to_expr()), "latex": latex(&function.display_expr())}),
        Value::Table(table) => super::table_json(table),
        Value::Derivation(derivation) => super::derivation_json(derivation, Language::default()),
        Value::Figure(scene) => json!({"kind": "figure", "title": scene.title(),
            "description": scene.description()}),
        Value::Claim(claim) => claim_json(claim),
        Value::Written(written) => {
            let mut json = value_json(&written.value, notation);
            json["text"] = json!(text(&written.expr));
            json["latex"] = json!(latex(&written.expr));
            json
        }
        Value::Text(words) => json!({"kind": "text", "text": words}),
    }
}

fn geometry_json(geometry: &Geometry) -> Json {
    let form = geometry.form();
    let row = |point: &[Fraction]| point.iter().map(scalar).collect::<Vec<_>>();
    // With weight 0 there is no point: then the homogeneous coordinates have to do.
    let homogeneous: Vec<_> = geometry.control_points().iter().map(|point| row(point)).collect();
    let split = form.rational.then(|| form.split(&geometry.control_points())).flatten();
    let coordinates = |value: &Value| match value {
        Value::List(items) => items.iter().filter_map(Value::as_scalar).map(scalar).collect(),
        Value::Scalar(x) => vec![scalar(x)],
        _ => Vec::new(),
    };
    let points: Vec<Vec<String>> = match &split {
        Some((values, _)) => values.iter().map(coordinates).collect(),
        None => homogeneous.clone(),
    };
    let mut data = match geometry {
        Geometry::Bezier(curve, _) => {
            let (a, b) = curve.interval().ends();
            json!({"kind": "bezier", "degree": curve.degree(), "interval": [scalar(a), scalar(b)]})
        }
        Geometry::Patch(patch, _) => {
            let (m, n) = patch.degrees();
            let interval = |i: &crate::math::curve::Interval<Fraction>| [scalar(i.start()), scalar(i.end())];
            json!({"kind": "patch", "degrees": [m, n], "intervals": [interval(patch.u()), interval(patch.v())]})
        }
        Geometry::Triangle(patch, _) => json!({"kind": "triangle", "degree": patch.degree(),
            "corners": patch.triangle().corners().iter().map(|corner| row(corner)).collect::<Vec<_>>()}),
        Geometry::Surface(surface, _) => {
            let (u, v) = surface.knots();
            let list = |knots: &[Fraction]| knots.iter().map(scalar).collect::<Vec<_>>();
            json!({"kind": "spline_surface", "degrees": [u.degree(), v.degree()],
                "knots": [list(u.knots()), list(v.knots())]})
        }
        Geometry::Spline(spline, _) => json!({"kind": "bspline", "degree": spline.degree(),
            "knots": spline.knots().knots().iter().map(scalar).collect::<Vec<_>>()}),
    };
    data["points"] = json!(points);
    data["rational"] = json!(form.rational);
    if form.rational {
        data["weights"] = json!(split.map(|(_, weights)| weights.iter().map(scalar).collect::<Vec<_>>()));
        data["homogeneous"] = json!(homogeneous);
    }
    data["text"] = json!(text(&geometry.to_expr()));
    data["latex"] = json!(latex(&geometry.display_expr()));
    data
}

/// Forms of a larger degree are written with σ_{i,n} in JSON.
const LONGEST_WRITTEN_OUT: usize = 12;

fn polar_json(polar: &Polar, notation: Notation) -> Json {
    let groups: Vec<Json> = polar
        .arguments()
        .iter()
        .map(|group| {
            group
                .iter()
                .map(|argument| match argument.as_slice() {
                    [one] => json!(one.to_string()),
                    many => json!(many.iter().map(Symbol::to_string).collect::<Vec<_>>()),
                })
                .collect()
        })
        .collect();
    let (form, coefficients) = match &polar.kind {
        PolarKind::Univariate(form) => {
            ("univariate", json!(form.coefficients().iter().map(scalar).collect::<Vec<_>>()))
        }
        PolarKind::Tensor(form) => {
            let rows: Vec<Vec<String>> =
                form.coefficients().iter().map(|row| row.iter().map(scalar).collect()).collect();
            ("tensor", json!(rows))
        }
        PolarKind::Total(form) => {
            let terms: Vec<Json> =
                form.terms().map(|(e, c)| json!({"exponents": e, "coefficient": scalar(c)})).collect();
            ("total", json!(terms))
        }
    };
    // The coefficients say all; the formula is not written out at length beside them.
    let long = polar.arity().iter().any(|&n| n > LONGEST_WRITTEN_OUT);
    let body = polar.body(if long { Notation::Sigma } else { notation });
    json!({"kind": "polar", "form": form, "degree": polar.arity(), "arguments": groups,
        "coefficients": coefficients, "text": text(&body), "latex": latex(&body)})
}

/// A claim with the verdict of each relation.
pub fn claim_json(claim: &Claim) -> Json {
    let relations: Vec<Json> = claim
        .judgements
        .iter()
        .map(|judgement| {
            let witness = judgement.witness.as_ref().map(|witness| {
                let at: serde_json::Map<String, Json> = witness
                    .assignment
                    .iter()
                    .map(|(symbol, value)| (symbol.to_string(), json!(value.to_string())))
                    .collect();
                json!({"at": at, "left": witness.left.to_string(), "right": witness.right.to_string()})
            });
            json!({
                "relation": <Text as Plain>::relation(rel_of_claim(judgement.rel)).trim(),
                "verdict": judgement.verdict.word(),
                "left": text(&judgement.left.to_expr()),
                "right": text(&judgement.right.to_expr()),
                "difference": judgement.difference.as_ref().map(|d| text(&d.to_expr())),
                "witness": witness,
                "reasons": judgement.reasons,
            })
        })
        .collect();
    json!({"kind": "claim", "verdict": claim.verdict().word(), "relations": relations})
}

/// A definition that is checked claims equality.
fn rel_of_claim(rel: Rel) -> Rel {
    if rel == Rel::Define { Rel::Eq } else { rel }
}
