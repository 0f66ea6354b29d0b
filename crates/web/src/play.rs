//! Curves in the plane with movable control points: every point of the algorithm, exact and labelled.

use num_traits::ToPrimitive;
use polarform::curve::{BezierCurve, Interval, Point, Tableau};
use polarform::expr::Expr;
use polarform::number::Rational;
use polarform::scene::{Segment, Spot, bezier_path};
use polarform::session::Session;
use polarform::spline::{BSpline, KnotVector};
use polarform::write::{latex, text};
use serde_json::{Value, json};

use super::{Refusal, Request, bounded, field};

/// A number is not longer.
const LONGEST: usize = 60;

/// Nobody moves more points.
const MOST: usize = 40;

/// Labels of a larger degree do not fit beside points.
const LARGEST_DEGREE: usize = 9;

/// The scheme of de Casteljau or de Boor at a parameter, and the curve.
pub(crate) fn scheme(request: &Request) -> Result<Value, Refusal> {
    let points = points(request)?;
    let t = number(field(request, "t")?, "t")?;
    match field(request, "kind")? {
        "bezier" => bezier(request, points, &t),
        "bspline" => bspline(request, points, &t),
        other => Err(format!("there is no curve of the kind {other}")),
    }
}

fn bezier(request: &Request, points: Vec<Vec<Rational>>, t: &Rational) -> Result<Value, Refusal> {
    let (a, b) = match request.get("ends") {
        None => (number("0", "a")?, number("1", "b")?),
        Some(ends) => match numbers(ends, "the ends")?.as_slice() {
            [a, b] => (a.clone(), b.clone()),
            _ => return Err("an interval has two ends".to_owned()),
        },
    };
    if a >= b {
        return Err(format!("the interval [{a}, {b}] is empty"));
    }
    let degree = points.len() - 1;
    degree_fits(degree)?;
    let interval = Interval::new(a.clone(), b.clone()).map_err(|error| error.to_string())?;
    let curve = BezierCurve::new(points.clone(), interval).map_err(|error| error.to_string())?;
    let tableau = curve.tableau(&vec![t.clone(); degree]).map_err(|error| error.to_string())?;
    let tangent = curve.derivative().value(t);
    let query = format!("figure_casteljau(bezier({}, {a}, {b}), {t})", list(&points));
    let numbers = Numbers { t, ends: (&a, &b), degree, query };
    let control = &tableau.labels[0];
    finished(numbers, &tableau, control, curve.points(), std::slice::from_ref(&curve), tangent)
}

fn bspline(request: &Request, points: Vec<Vec<Rational>>, t: &Rational) -> Result<Value, Refusal> {
    let degree = request.get("degree").and_then(Value::as_u64).ok_or("a spline has a degree")? as usize;
    degree_fits(degree)?;
    let list_of_knots = numbers(request.get("knots").ok_or("a spline has knots")?, "the knots")?;
    let knots = KnotVector::new(degree, list_of_knots.clone()).map_err(|error| error.to_string())?;
    let spline = BSpline::new(knots.clone(), points.clone()).map_err(|error| error.to_string())?;
    let (a, b) = spline.interval().ends();
    let span = knots.span_of(t).map_err(|error| error.to_string())?;
    let scheme = spline.de_boor(span, &vec![t.clone(); degree]).map_err(|error| error.to_string())?;
    let pieces = spline.bezier_pieces();
    let piece = spline.bezier_piece(span).map_err(|error| error.to_string())?;
    let tangent = piece.derivative().value(t);
    let shown: Vec<String> = list_of_knots.iter().map(Rational::to_string).collect();
    let query = format!("figure_bspline(bspline({degree}, [{}], {}))", shown.join(", "), list(&points));
    let labels: Vec<Vec<Rational>> = (0..points.len()).map(|i| knots.label(i).to_vec()).collect();
    let numbers = Numbers { t, ends: (a, b), degree, query };
    let mut out = finished(numbers, &scheme.tableau, &labels, spline.points(), &pieces, tangent)?;
    out["span"] = span.into();
    out["first"] = (span - degree).into();
    out["knots"] = list_of_knots.iter().map(exact).collect();
    out["joints"] = knots
        .multiplicities()
        .iter()
        .filter(|(knot, _)| knot >= a && knot <= b)
        .filter_map(|(knot, times)| {
            let at = spline.value(knot).ok()?;
            Some(json!({"knot": exact(knot), "times": times, "at": place(&at)}))
        })
        .collect();
    Ok(out)
}

/// What a scheme is told with.
struct Numbers<'a> {
    t: &'a Rational,
    ends: (&'a Rational, &'a Rational),
    degree: usize,
    query: String,
}

fn finished(
    numbers: Numbers,
    tableau: &Tableau<Rational>,
    labels: &[Vec<Rational>],
    points: &[Point<Rational>],
    pieces: &[BezierCurve<Rational>],
    tangent: Point<Rational>,
) -> Result<Value, Refusal> {
    let Numbers { t, ends: (a, b), degree, query } = numbers;
    let control: Vec<Value> =
        points.iter().zip(labels).map(|(at, arguments)| entry(at, arguments, t, 0)).collect();
    let levels: Vec<Vec<Value>> = tableau
        .levels
        .iter()
        .zip(&tableau.labels)
        .enumerate()
        .map(|(r, (level, labels))| {
            level.iter().zip(labels).map(|(at, arguments)| entry(at, arguments, t, r)).collect()
        })
        .collect();
    let paths: Vec<String> = pieces.iter().map(path).collect::<Result<_, _>>()?;
    let equation = |name: &str, value: &Point<Rational>| {
        let [x, y] = coordinates(value);
        format!(
            "{name}\\left({}\\right) = \\left({}, {}\\right)",
            exact_latex(t),
            exact_latex(x),
            exact_latex(y)
        )
    };
    Ok(json!({
        "t": exact(t), "domain": [exact(a), exact(b)], "degree": degree, "query": query,
        "control": control, "levels": levels, "paths": paths,
        "value": equation("F", tableau.result()), "tangent": equation("F'", &tangent),
    }))
}

/// A point with its name: the value of the polar form at these arguments, r of which are t.
fn entry(at: &Point<Rational>, arguments: &[Rational], t: &Rational, r: usize) -> Value {
    let mut left = r;
    let argument = |value: &Rational| {
        if left > 0 && value == t {
            left -= 1;
            return Expr::name("t");
        }
        Expr::number(value)
    };
    let arguments: Vec<Expr> = arguments.iter().map(argument).collect();
    let name = if arguments.is_empty() { Expr::name("f") } else { Expr::apply(Expr::name("f"), arguments) };
    let [x, y] = coordinates(at);
    json!({
        "label": text(&name), "label_latex": latex(&name), "x": x.to_string(), "y": y.to_string(),
        "latex": format!("\\left({}, {}\\right)", exact_latex(x), exact_latex(y)), "at": place(at),
    })
}

fn coordinates(point: &Point<Rational>) -> [&Rational; 2] {
    [&point[0], &point[1]]
}

/// Where it is drawn.
fn place(point: &Point<Rational>) -> Value {
    coordinates(point).iter().map(|value| value.to_f64().unwrap_or(0.0)).collect()
}

fn exact(value: &Rational) -> Value {
    json!({"text": value.to_string(), "latex": exact_latex(value), "at": value.to_f64().unwrap_or(0.0)})
}

fn exact_latex(value: &Rational) -> String {
    latex(&Expr::number(value))
}

/// The curve as data of an SVG path, y upwards.
fn path(curve: &BezierCurve<Rational>) -> Result<String, Refusal> {
    let spot = |point: &Point<Rational>| {
        let [x, y] = coordinates(point);
        Spot::exact(&[x.clone(), y.clone()])
    };
    let spots: Vec<Spot> =
        curve.points().iter().map(spot).collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    let segments = bezier_path(&spots).map_err(|error| error.to_string())?;
    let pair = |spot: &Spot| format!("{} {}", spot.x(), spot.y());
    let mut data = format!("M{}", pair(&spots[0]));
    for segment in &segments {
        data += &match segment {
            Segment::Line(end) => format!("L{}", pair(end)),
            Segment::Cubic([b, c, d]) => format!("C{} {} {}", pair(b), pair(c), pair(d)),
        };
    }
    Ok(data)
}

/// The points as they are typed.
fn list(points: &[Vec<Rational>]) -> String {
    let shown: Vec<String> = points.iter().map(|point| format!("[{}, {}]", point[0], point[1])).collect();
    format!("[{}]", shown.join(", "))
}

fn degree_fits(degree: usize) -> Result<(), Refusal> {
    match degree {
        1..=LARGEST_DEGREE => Ok(()),
        _ => Err(format!("curves of degree 1 to {LARGEST_DEGREE} are shown here, not of degree {degree}")),
    }
}

fn points(request: &Request) -> Result<Vec<Vec<Rational>>, Refusal> {
    let given = request.get("points").and_then(Value::as_array).ok_or("a curve has points")?;
    if given.is_empty() || given.len() > MOST {
        return Err(format!("a curve has 1 to {MOST} control points here, not {}", given.len()));
    }
    let point = |value: &Value| match numbers(value, "the coordinates")? {
        pair if pair.len() == 2 => Ok(pair),
        other => Err(format!("a point of the plane has 2 coordinates, not {}", other.len())),
    };
    given.iter().map(point).collect()
}

fn numbers(list: &Value, what: &str) -> Result<Vec<Rational>, Refusal> {
    let list = list.as_array().ok_or_else(|| format!("{what} are a list"))?;
    if list.len() > MOST + LARGEST_DEGREE + 1 {
        return Err(format!("{what} are too many"));
    }
    list.iter()
        .map(|item| number(item.as_str().ok_or("a number is a text, such as \"1/2\"")?, what))
        .collect()
}

/// A number as it is typed in a query: 1/2, 0.5, -3.
fn number(typed: &str, what: &str) -> Result<Rational, Refusal> {
    let typed = bounded(typed.trim(), LONGEST, "a number")?;
    let value =
        Session::new(Default::default()).run(typed).map_err(|failure| failure.problem.message.clone());
    value?.outcome.value.as_rational().ok_or_else(|| format!("{what}: {typed} is no number"))
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use serde_json::{Value, json};

    fn played(request: Value) -> Value {
        serde_json::from_str(&answer(&request.to_string())).unwrap()
    }

    #[test]
    fn levels_agree_with_the_value_of_the_polynomial() {
        let points = json!([["0", "0"], ["1", "3"], ["4", "3.5"], ["6", "1"]]);
        let out = played(json!({"do": "play", "kind": "bezier", "points": points, "t": "2/5"}));
        let last = &out["levels"][3][0];
        // The same by the Bernstein polynomials.
        let power = |coordinate: &str, formula: &str| {
            let input = format!("F(t) := {formula}; F(2/5)");
            let asked = played(json!({"do": "ask", "session": [], "input": input}));
            assert_eq!(asked["answers"][1]["text"], last[coordinate], "{asked}");
        };
        power("x", "3 t (1-t)^2 + 12 t^2 (1-t) + 6 t^3");
        power("y", "9 t (1-t)^2 + 21/2 t^2 (1-t) + t^3");
        assert_eq!(last["label"], "f(t, t, t)");
        assert_eq!(out["levels"][1][1]["label"], "f(0, t, 1)");
        let figure = played(json!({"do": "ask", "session": [], "input": out["query"]}));
        assert_eq!(figure["answers"][0]["kind"], "picture", "{figure}");
    }

    #[test]
    fn splines_have_the_labels_of_their_knots() {
        let request = json!({"do": "play", "kind": "bspline", "degree": 2, "t": "3/2",
            "knots": ["0", "0", "0", "1", "2", "2", "2"], "points": [["0", "0"], ["1", "3"], ["4", "3"], ["5", "0"]]});
        let out = played(request);
        let labels = |list: &Value| -> Vec<String> {
            list.as_array().unwrap().iter().map(|entry| entry["label"].as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(labels(&out["control"]), ["f(0, 0)", "f(0, 1)", "f(1, 2)", "f(2, 2)"]);
        assert_eq!(labels(&out["levels"][1]), ["f(1, t)", "f(t, 2)"]);
        assert_eq!(out["paths"].as_array().unwrap().len(), 2);
        assert_eq!(out["joints"][1]["knot"]["text"], "1");
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        for request in [
            json!({"kind": "bezier", "points": [], "t": "0"}),
            json!({"kind": "bezier", "points": [["0", "x"], ["1", "1"]], "t": "0"}),
            json!({"kind": "bezier", "points": [["0", "0", "0"], ["1", "1"]], "t": "0"}),
            json!({"kind": "bezier", "points": [["0", "0"], ["1", "1"]], "t": "0", "ends": ["1", "1"]}),
            json!({"kind": "bspline", "points": [["0", "0"], ["1", "1"]], "t": "0", "degree": 1, "knots": ["0", "1"]}),
            json!({"kind": "bspline", "points": [["0", "0"], ["1", "1"]], "t": "9", "degree": 1,
                "knots": ["0", "0", "1", "1"]}),
            json!({"kind": "circle", "points": [["0", "0"]], "t": "0"}),
        ] {
            let mut request = request;
            request["do"] = "play".into();
            let out = played(request.clone());
            assert!(out["refused"].is_string(), "{request}: {out}");
        }
    }
}
