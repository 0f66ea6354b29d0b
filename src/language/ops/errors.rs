//! The words for what goes wrong with values. Errors know no place yet.

use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::Value;
use crate::math::blossom::PolarError;
use crate::math::curve::CurveError;
use crate::math::linalg::LinalgError;
use crate::math::piecewise::PiecewiseError;
use crate::math::spline::SplineError;
use crate::math::subdivision::SubdivisionError;

/// "expected X, found Y".
pub(crate) fn wrong_kind(expected: &str, found: &Value) -> Diagnostic {
    let error = Diagnostic::error(Code::Type, format!("expected {expected}, found {}", found.kind()))
        .reason(format!("this is {}", found.kind()));
    match found {
        Value::Scalar(formula)
            if (expected.starts_with("an integer") || expected == "a number")
                && formula.as_rational().is_none() =>
        {
            let names: Vec<String> = formula.variables().iter().map(ToString::to_string).collect();
            error.hint(format!("give {} a value first, for example {} := 3", names.join(", "), names[0]))
        }
        _ => error,
    }
}

/// The diagnostic for what has no meaning here.
pub(crate) fn unsupported(what: &str) -> Diagnostic {
    Diagnostic::error(Code::Unsupported, what)
}

/// The diagnostic for an operation that two kinds of values do not have.
pub(crate) fn mismatch(operation: &str, left: &Value, right: &Value) -> Diagnostic {
    let message = format!("{} and {} cannot be {operation}", left.kind(), right.kind());
    let error = Diagnostic::error(Code::Type, message);
    match (left, right) {
        (Value::Algebraic(_), _) | (_, Value::Algebraic(_)) => {
            error.hint("numbers that are not rational are only compared: root_of(t^2 - 2, 1, 2) < 3/2")
        }
        _ => error,
    }
}

/// The diagnostic for a quotient without a value.
pub(crate) fn division_by_zero() -> Diagnostic {
    Diagnostic::error(Code::DivisionByZero, "division by zero").reason("this is 0")
}

/// The diagnostic for an error of linear algebra.
pub(crate) fn linalg_error(error: LinalgError) -> Diagnostic {
    let code = match error {
        LinalgError::Singular { .. } => Code::Singular,
        _ => Code::Shape,
    };
    Diagnostic::error(code, error.to_string())
}

/// The diagnostic for an error of polar forms.
pub(crate) fn polar_error(error: PolarError) -> Diagnostic {
    let code = match error {
        PolarError::ArgumentCount { .. } | PolarError::TooManyArguments { .. } => Code::Arity,
        PolarError::DegreeTooSmall { .. } => Code::DegreeTooSmall,
        PolarError::NotReducible { .. } => Code::NotReducible,
        PolarError::DegreeMismatch { .. } | PolarError::NoCoefficients => Code::Shape,
    };
    Diagnostic::error(code, error.to_string())
}

/// The diagnostic for an error of curves.
pub(crate) fn curve_error(error: impl Into<CurveError>) -> Diagnostic {
    let error = error.into();
    let message = error.to_string();
    let (code, hint) = match error {
        CurveError::TooFewPoints { .. } => (Code::ControlPoints, "a point is a list such as [1, 2]"),
        CurveError::Dimensions { .. } => {
            (Code::ControlPoints, "give every point the same number of coordinates")
        }
        CurveError::EmptyInterval => (Code::Coincident, "choose two different ends, such as 0 and 1"),
        CurveError::WeightCount { .. } => (Code::ControlPoints, "give one weight for each control point"),
        CurveError::ZeroWeight { .. } => (
            Code::ZeroWeight,
            "a weight of 0 needs homogeneous points: homogeneous=1, coordinates with the weight last",
        ),
        CurveError::ZeroDenominator => (Code::ZeroWeight, "the point lies at infinity"),
        CurveError::OutsideDomain => {
            (Code::OutsideDomain, "extended(c, t) gives the value of the polynomial there")
        }
        CurveError::Arguments { .. } => (Code::Arity, "a polar form has as many arguments as its degree"),
        CurveError::Degrees { .. } => (Code::Shape, "elevate(c, k) raises a degree"),
        CurveError::DimensionsOf { .. } => (Code::Shape, "both need the same number of coordinates"),
        CurveError::NotReducible { .. } => (
            Code::NotReducible,
            "differences(control_points(c), n) shows the difference that would have to vanish",
        ),
        CurveError::RaggedNet { .. } => (Code::ControlPoints, "give every row the same number of points"),
        CurveError::NotTriangular { .. } => {
            (Code::ControlPoints, "a triangular patch of degree n has (n+1)(n+2)/2 points")
        }
        CurveError::Degenerate => (Code::Degenerate, "choose corners in general position"),
        CurveError::NoCommonEdge => (Code::Coincident, "the domains have to share an edge"),
        CurveError::NoCommonEnd => (Code::Coincident, "over(c, a, b) moves a curve to another interval"),
        CurveError::Irrational { .. } => {
            (Code::Irrational, "choose numbers whose root is rational, or another parameterization")
        }
        CurveError::Impossible { .. } => (Code::Domain, "there is no such object"),
    };
    Diagnostic::error(code, message).hint(hint)
}

/// The diagnostic for an error of splines.
pub(crate) fn spline_error(error: SplineError) -> Diagnostic {
    let message = error.to_string();
    let (code, hint) = match error {
        SplineError::Curve(inner) => return curve_error(inner),
        SplineError::TooFewKnots { .. } | SplineError::PointCount { .. } => {
            (Code::Knots, "m control points of degree n need m + n + 1 knots")
        }
        SplineError::DecreasingKnots { .. } => (Code::Knots, "write the knots in increasing order"),
        SplineError::Multiplicity { .. } => (Code::Knots, "a knot can be repeated degree + 1 times at most"),
        SplineError::NoDomain => (Code::Knots, "the domain is [t_n, t_m], for m control points of degree n"),
        SplineError::NoSuchFunction { .. } => (Code::Domain, "choose a smaller number"),
        SplineError::OutsideDomain => (Code::OutsideDomain, "extended(s, t) takes the nearest piece"),
        SplineError::Unordered => {
            (Code::Undecided, "name the knot interval: deboor(s, t, span=j) for t_j <= t < t_(j+1)")
        }
        SplineError::MissingKnot { .. } => (Code::Knots, "finer knots contain all knots of the spline"),
        SplineError::NotAKnot { .. } => (Code::Domain, "only inner knots can be removed"),
        SplineError::NotSmooth { .. } => (Code::NotReducible, "smoothness(s) tells how the pieces meet"),
        SplineError::PieceDegree { .. } => (Code::NotReducible, "pieces(s) are its polynomial pieces"),
        SplineError::Domains => (Code::Shape, "both need the same domain, piece by piece"),
    };
    Diagnostic::error(code, message).hint(hint)
}

/// The diagnostic for an error of piecewise polynomials.
pub(crate) fn piecewise_error(error: PiecewiseError) -> Diagnostic {
    let code = match error {
        PiecewiseError::Counts { .. } | PiecewiseError::Order { .. } => Code::Knots,
        PiecewiseError::OutsideDomain => Code::OutsideDomain,
        PiecewiseError::Unordered => Code::Undecided,
    };
    let hint = match code {
        Code::Undecided => "give the variable a number, or take one of its pieces",
        Code::OutsideDomain => "the function is given between its breakpoints only",
        _ => "m pieces stand between m + 1 increasing breakpoints",
    };
    Diagnostic::error(code, error.to_string()).hint(hint)
}

/// The diagnostic for an error of subdivision.
pub(crate) fn subdivision_error(error: SubdivisionError) -> Diagnostic {
    use SubdivisionError as E;
    let message = error.to_string();
    let (code, hint) = match error {
        E::EmptyMask => (Code::Shape, "such as [1, 3, 3, 1]/4"),
        E::TooFewPoints { .. } => (Code::ControlPoints, "closed=1 takes any number of points"),
        E::Dimensions { .. } => (Code::ControlPoints, "give every point the same number of coordinates"),
        E::Symbols => (Code::Undecided, "give the symbols values first"),
        E::NotShown { .. } => (Code::Undecided, "subdivision_smoothness(scheme) tells what is known"),
        E::NotDetermined { .. } => (Code::Undecided, "eigenvalues(local_matrix(scheme)) shows why"),
        E::Valence { .. } => (Code::Domain, "the regular valence is 4, for triangles 6"),
    };
    Diagnostic::error(code, message).hint(hint)
}
