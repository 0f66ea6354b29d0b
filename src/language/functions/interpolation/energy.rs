//! Inner products and energies of curves, and what is nearest.

use super::NEW;
use super::data::{Result, scalar_polynomial};
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::functions::Builtin;
use crate::language::functions::gives::Gives;
use crate::language::functions::matrices::basis_error;
use crate::language::functions::notions::{BASIS_OR_KNOTS, read_basis};
use crate::language::functions::parameter::{
    CURVE, DEGREE, Parameter, RESULT_VARIABLE, named, optional, required,
};
use crate::language::functions::splines::piecewise;
use crate::language::ops::errors::{curve_error, linalg_error, spline_error};
use crate::language::ops::geometry::{as_spline, bezier, polynomial_pieces};
use crate::language::ops::takes::Takes;
use crate::language::value::{Form, Geometry, Value, polynomial_expr};
use crate::math::approximation::{
    ApproximationError, bernstein_gram, best_reduction, dual_bernstein, spline_energy, spline_gram,
};
use crate::math::basis::{Basis, change_of_basis, legendre_all};
use crate::math::curve::Interval;
use crate::math::linalg::{inverse, multiply};
use crate::math::poly::Fraction;
use crate::math::ring::Ring;
use crate::math::spline::{BSpline, KnotVector};
use nalgebra::DMatrix;

const FUNCTIONS: Parameter = required("basis", BASIS_OR_KNOTS, "the functions; knots stand for B-splines");

const INTERVAL: Parameter =
    named("interval=[a, b]", Takes::Interval, "that of the basis, or [0, 1]", "over which is integrated");

pub(crate) const TABLE: &[Builtin] = &[
    Builtin {
        name: "gram",
        parameters: &[
            DEGREE,
            FUNCTIONS,
            named(
                "derivative=r",
                Takes::Size,
                "0",
                "which derivative: 0 for the mass matrix, 1 for the stiffness matrix",
            ),
            INTERVAL,
        ],
        summary: "the matrix of the integrals of F_i F_j, or of their derivatives, for a basis",
        gives: Gives::Matrix,
        example: "gram(2, bernstein)",
        call: |_, args| {
            let order = args.size_named("derivative")?;
            Functions::read(args)?.gram(args, order).map(Value::Matrix)
        },
        ..NEW
    },
    Builtin {
        name: "dual_basis",
        parameters: &[DEGREE, FUNCTIONS, INTERVAL, RESULT_VARIABLE],
        summary: "the functions D_i for which the integral of D_i F_j is 1 for i = j, else 0",
        gives: Gives::Functions,
        example: "dual_basis(1, bernstein)",
        call: |_, args| {
            let functions = Functions::read(args)?;
            let coefficients = functions.dual(args)?;
            functions.combinations(args, &coefficients)
        },
        ..NEW
    },
    Builtin {
        name: "legendre",
        parameters: &[
            DEGREE,
            required("t", Takes::Scalar, "the parameter"),
            optional("a", Takes::Scalar, "-1", "the start of the interval"),
            optional("b", Takes::Scalar, "1", "its end"),
        ],
        summary: "the Legendre polynomial of an interval: orthogonal to all of lower degree, 1 at b",
        gives: Gives::Function,
        example: "legendre(2, t)",
        call: |_, args| {
            let (n, t) = (args.size(0)?, args.scalar(1)?);
            let a = args.scalar(2)?;
            let b = args.scalar(3)?;
            let interval = Interval::new(a.clone(), b.clone()).map_err(curve_error).at(args.span(3))?;
            let x = t.plus(&t).minus(&a).minus(&b).times(interval.inverse_width());
            Ok(Value::Scalar(legendre_all(n, &x).swap_remove(n)))
        },
        ..NEW
    },
    Builtin {
        name: "energy",
        parameters: &[CURVE, optional("k", Takes::Size, "2", "which derivative; 2 is the bending energy")],
        summary: "the integral of |c^(k)|^2 over the interval of a curve or the domain of a spline",
        gives: Gives::Scalar,
        example: "energy(bezier([[0, 0], [1, 2], [2, 0]]), 1)",
        call: |_, args| {
            let order = args.size(1)?;
            let (s, _) = spline_of(args, 0)?;
            Ok(Value::Scalar(spline_energy(&s, order)))
        },
        ..NEW
    },
    Builtin {
        name: "squared_distance",
        parameters: &[CURVE, required("other", Takes::Curve, "another curve").shown("d")],
        summary: "the integral of |c - d|^2 over their common interval",
        gives: Gives::Scalar,
        example: "squared_distance(bezier([0, 0, 1]), bezier([0, 1]))",
        call: |_, args| {
            let ((c, _), (d, _)) = (spline_of(args, 0)?, spline_of(args, 1)?);
            squared_distance(&c, &d).at(args.span(1)).map(Value::Scalar)
        },
        ..NEW
    },
    Builtin {
        name: "best_reduction",
        parameters: &[
            CURVE,
            optional("k", Takes::Size, "1", "by how many degrees"),
            named(
                "ends=r",
                Takes::Size,
                "0",
                "what stays at both ends: 1 the points, 2 the slopes, too, ...",
            ),
        ],
        summary: "the curve of degree n - k with the least integral of |c - d|^2",
        gives: Gives::Curve,
        example: "best_reduction(bezier([0, 0, 1]))",
        call: |machine, args| {
            let (by, ends) = (args.size(1)?, args.size_named("ends")?);
            let (curve, form) = args.bezier(0)?;
            polynomial(form, args.span(0))?;
            let Some(degree) = curve.degree().checked_sub(by) else {
                let message = format!("the curve has degree {}", curve.degree());
                return Err(Diagnostic::error(Code::DegreeTooSmall, message).at(args.span(1)));
            };
            let found = best_reduction(&curve, degree, ends).map_err(|error| {
                let place = args.named("ends").map_or_else(|| args.span(0), |(_, span)| span);
                approximation_error(error).at(place)
            })?;
            let both = as_spline(&curve).and_then(|c| Ok((c, as_spline(&found)?))).map_err(spline_error)?;
            let error = squared_distance(&both.0, &both.1).at(args.span(0))?;
            let error = crate::language::write::text(&polynomial_expr(&error));
            let note = format!("the integral of |c - d|^2 is {error}");
            machine.note(Diagnostic::note(Code::StandardMeaning, note).at(args.span(0)));
            Ok(bezier(found, form))
        },
        ..NEW
    },
];

/// ∫ |c − d|² over the common interval.
fn squared_distance(c: &BSpline<Fraction>, d: &BSpline<Fraction>) -> Result<Fraction> {
    let points = d.points().iter().map(|point| point.iter().map(|x| -x.clone()).collect::<Vec<_>>());
    let turned = BSpline::new(d.knots().clone(), points.collect());
    let difference = turned.and_then(|turned| c.sum(&turned)).map_err(spline_error)?;
    Ok(spline_energy(&difference, 0))
}

/// The diagnostic for an error of approximation.
pub(super) fn approximation_error(error: ApproximationError) -> Diagnostic {
    use ApproximationError as E;
    let message = error.to_string();
    let (code, hint) = match error {
        E::Spline(inner) => return spline_error(inner),
        E::Interpolation(inner) => return super::data::interpolation_error(inner),
        E::TooManyEnds { .. } => (Code::Shape, "choose a smaller ends=r, or reduce by fewer degrees"),
        E::SchoenbergWhitney { .. } => (Code::Singular, "averaged_knots(n, nodes) are knots that fit"),
        E::NoNodeFor { .. } => (Code::Singular, "choose fewer knots there, or smoothing=lambda"),
        E::NodeCount { .. } => (Code::Shape, "averaged_knots(n, nodes) are knots for these nodes"),
    };
    Diagnostic::error(code, message).hint(hint)
}

/// A rational curve is none of what is integrated here.
pub(super) fn polynomial(form: Form, place: Span) -> Result<()> {
    if !form.rational {
        return Ok(());
    }
    Err(Diagnostic::error(Code::NotPolynomial, "this curve is rational, not polynomial")
        .at(place)
        .hint("homogeneous(c) is the polynomial curve of its homogeneous coordinates"))
}

/// The integral of |c''|^2 of a curve or spline.
pub(super) fn bending(args: &Arguments) -> crate::language::eval::Evaluated {
    let (s, _) = spline_of(args, 0)?;
    Ok(Value::Scalar(spline_energy(&s, 2)))
}

/// A polynomial curve of any kind as a spline.
fn spline_of(args: &Arguments, i: usize) -> Result<(BSpline<Fraction>, Form)> {
    let value = args.value(i)?;
    let is_spline = match value {
        Value::Geometry(geometry) => matches!(**geometry, Geometry::Spline(..)),
        other => polynomial_pieces(other).is_some(),
    };
    let (spline, form) = if is_spline {
        args.spline(i)?
    } else {
        let (curve, form) = args.bezier(i)?;
        (as_spline(&curve).map_err(spline_error).at(args.span(i))?, form)
    };
    polynomial(form, args.span(i))?;
    Ok((spline, form))
}

/// The functions of a basis.
enum Functions {
    Polynomials(usize, Box<Basis<Fraction>>, Box<Interval<Fraction>>),
    Splines(KnotVector<Fraction>),
}

impl Functions {
    /// Degree and basis at the first two places.
    fn read(args: &Arguments) -> Result<Self> {
        let (n, value, place) = (args.size(0)?, args.value(1)?, args.span(1));
        crate::budget::charge_terms((n as u64).saturating_add(1).saturating_pow(2));
        let given = args.named_interval("interval")?;
        if let Value::List(items) = value
            && items.iter().all(|item| item.as_scalar().is_some())
        {
            if let Some((_, span)) = args.named("interval") {
                let message = "B-splines are integrated over their domain";
                return Err(Diagnostic::error(Code::Arity, message).at(span).hint("leave the interval out"));
            }
            let knots = KnotVector::new(n, args.scalars(1)?).map_err(spline_error).at(place)?;
            return Ok(Functions::Splines(knots));
        }
        let basis = read_basis(value, place).map_err(|error| error.hint("or the knots of B-splines"))?;
        basis.validate(n).map_err(basis_error).at(place)?;
        let own = match &basis {
            Basis::Bernstein(own) | Basis::Legendre(own) | Basis::HermiteEndpoints(own) => own.clone(),
            _ => Interval::unit(),
        };
        Ok(Functions::Polynomials(n, Box::new(basis), Box::new(given.unwrap_or(own))))
    }

    fn gram(&self, args: &Arguments, order: usize) -> Result<DMatrix<Fraction>> {
        match self {
            Functions::Splines(knots) => spline_gram(knots, order).map_err(spline_error).at(args.span(1)),
            Functions::Polynomials(n, basis, interval) => {
                let gram = bernstein_gram(*n, interval, order);
                let bernstein = bernstein(interval);
                if **basis == bernstein {
                    return Ok(gram);
                }
                let change = change_of_basis(*n, basis, &bernstein).map_err(basis_error).at(args.span(1))?;
                let half = multiply(&change.transpose(), &gram).map_err(linalg_error)?;
                multiply(&half, &change).map_err(linalg_error)
            }
        }
    }

    /// The coefficients of the dual basis, one column for each function.
    fn dual(&self, args: &Arguments) -> Result<DMatrix<Fraction>> {
        match self {
            Functions::Polynomials(n, basis, interval) if **basis == bernstein(interval) => {
                Ok(dual_bernstein(*n).map(|q| interval.inverse_width().scaled(&q)))
            }
            _ => inverse(&self.gram(args, 0)?).map_err(linalg_error).at(args.span(1)),
        }
    }

    /// The functions with given coefficients.
    fn combinations(&self, args: &Arguments, coefficients: &DMatrix<Fraction>) -> Result<Value> {
        match self {
            Functions::Polynomials(n, basis, _) => {
                let variable = args.letter()?;
                let power = change_of_basis(*n, basis, &Basis::Power).map_err(basis_error)?;
                let product = multiply(&power, coefficients).map_err(linalg_error)?;
                let column = |j: usize| {
                    let list: Vec<Fraction> = product.column(j).iter().cloned().collect();
                    scalar_polynomial(&list, &variable)
                };
                Ok(Value::List((0..=*n).map(column).collect()))
            }
            Functions::Splines(knots) => {
                let function = |j: usize| {
                    let points = coefficients.column(j).iter().map(|x| vec![x.clone()]).collect();
                    let s = BSpline::new(knots.clone(), points).map_err(spline_error)?;
                    Ok(piecewise(s.power_pieces().swap_remove(0)))
                };
                (0..knots.count()).map(function).collect::<Result<_>>().map(Value::List)
            }
        }
    }
}

fn bernstein(interval: &Interval<Fraction>) -> Basis<Fraction> {
    Basis::Bernstein(interval.clone())
}
