//! English.

use num_traits::One;

use super::{AtEnds, Reason, Title, power_of};
use crate::math::blossom::Method;

/// What is derived.
pub(super) fn title(title: Title) -> String {
    match title {
        Title::Polar(Method::Elementary) => "The polar form by elementary symmetric functions".into(),
        Title::Polar(Method::Probability) => "The polar form as an expected value".into(),
        Title::Polar(Method::Taylor) => "The polar form by Taylor's formula".into(),
        Title::Polar(Method::Parts) => "The polar form by integration by parts".into(),
        Title::Polar(Method::Laguerre) => "The polar form by Laguerre's polars".into(),
        Title::Polar(Method::Bezier) => "The polar form by Bézier points".into(),
        Title::Sum => "The polar form of a sum".into(),
        Title::Product => "The polar form of a product".into(),
        Title::Composition => "The polar form of a composition".into(),
        Title::Derivative(k) => format!("The derivative of order {k} by the polar form"),
        Title::Elevation(k) => format!("The degree raised by {k}"),
        Title::PowerMatrix(n) => format!("The matrix `A_{n}`"),
        Title::BernsteinMatrix(n) => format!("The inverse of the matrix `A_{n}`"),
        Title::DeCasteljau => "De Casteljau's algorithm".into(),
        Title::DeBoor => "De Boor's algorithm".into(),
        Title::Insertion => "Insertion of a knot".into(),
        Title::Joining(k) => format!("Conditions for two curves to meet `C^{k}`"),
        Title::Newton => "Divided differences and Newton's form".into(),
        Title::Moments => "A cubic spline by its moments".into(),
        Title::Positivity => "The sign of a polynomial, by its Bernstein coefficients".into(),
        Title::Clipping => "Real roots by Bézier clipping".into(),
        Title::ConnectionMatrix(k) => format!("The beta-matrix of `G^{k}`"),
        Title::Coons => "Coons' surface of four curves as a Boolean sum".into(),
        Title::Multirational => "The multirational blossom".into(),
        Title::Sturm => "The number of real roots by Sturm's chain".into(),
        Title::Resultant => "The resultant as Sylvester's determinant".into(),
        Title::Hull => "A point in the convex hull of the control points".into(),
        Title::Curvature => "The curvature of a curve".into(),
        Title::GeometricContinuity(k) => format!("How two curves meet `G^{k}`"),
        Title::Implicit => "The equation of a curve by Bézout's determinant".into(),
        Title::Roots => "Real roots by Bernstein coefficients and Descartes' rule of signs".into(),
    }
}

/// Why a line holds.
pub(super) fn reason(reason: &Reason) -> String {
    match reason {
        Reason::Given => "given".into(),
        Reason::DegreeAtMost(n) => format!("a polynomial of degree at most {n}"),
        Reason::Wanted => "the polar form `h` of `H` is wanted".into(),
        Reason::PolarFormOf(name) => format!("the polar form of `{name}`"),
        Reason::PutTogether => "put together".into(),
        Reason::PowerToMean { variable, power, of } if of.is_one() => {
            format!("replaces {}: the only product", power_of(variable, *power))
        }
        Reason::PowerToMean { variable, power, of } => {
            format!("replaces {}: the mean of {of} products", power_of(variable, *power))
        }
        Reason::PowersReplaced => "every power replaced by its mean".into(),
        Reason::Expectation { size, of, probability } => format!(
            "the expected product of {size} of {of} arguments drawn at random, each choice with probability `{probability}`"
        ),
        Reason::ExpectationIsLinear => "every power replaced by its expected product".into(),
        Reason::Auxiliary => "the auxiliary function".into(),
        Reason::TaylorForm => "the polar form in Taylor's manner".into(),
        Reason::TermNumber(i) => format!("the term `i = {i}`"),
        Reason::TauDropsOut(tau) => format!("the sum of all terms; `{tau}` drops out"),
        Reason::ProductRule => "by the product rule".into(),
        Reason::CancelsWithTheTermBefore => {
            "by the product rule; the first part cancels the last one before".into()
        }
        Reason::Telescopes => "neighbours cancel: the sum of all terms is constant".into(),
        Reason::TauIsZero(tau) => format!("at `{tau} = 0`"),
        Reason::AnyTau(tau) => format!("the sum does not depend on `{tau}`, so `{tau} = 0` will do"),
        Reason::StartOfPolars => "the polynomial itself".into(),
        Reason::PolarBy(argument) => format!("the polar by `{argument}`"),
        Reason::AfterAllPolars(tau) => format!("after all polars `{tau}` is gone"),
        Reason::InBernsteinBasis(n) => {
            format!("in the Bernstein basis: `b_i = sum(j=0..i, binomial(i, j)/binomial({n}, j) c_j)`")
        }
        Reason::PolarOfBernstein { index, degree } => {
            format!("the polar form of `B_{index}^{degree}`")
        }
        Reason::PolarFormIsLinear => "the polar form of a sum is the sum of the polar forms".into(),
        Reason::ProductsOfMeans => {
            "each power of each variable replaced by the mean of the products of so many of its arguments"
                .into()
        }
        Reason::HandedOut => {
            "each monomial replaced by the mean over all ways to hand its factors to different arguments"
                .into()
        }

        Reason::LeaveOut { from, to } if from + 1 == *to => {
            format!("the mean over all ways to leave out one of {to} arguments")
        }
        Reason::LeaveOut { from, to } => {
            format!("the mean over all ways to choose {from} of {to} arguments")
        }
        Reason::SameArguments => "both with the same number of arguments".into(),
        Reason::Added => "added".into(),
        Reason::ConstantFactor => "one factor is constant".into(),
        Reason::ConstantInside => "a constant".into(),
        Reason::DistinctArguments => "multiplied, with different arguments".into(),
        Reason::SymmetrisedProduct { count, m, n } => {
            format!(
                "symmetrised: the mean over all {count} ways to choose {m} of {} arguments for `f`",
                m + n
            )
        }
        Reason::DistinctInside => "`g` with different arguments put into `f`".into(),
        Reason::SymmetrisedComposition { count, .. } if count.is_one() => "already symmetric".into(),
        Reason::SymmetrisedComposition { count, m, n } => format!(
            "symmetrised: the mean over all {count} ways to split {} arguments into {m} groups of {n}",
            m * n
        ),

        Reason::DerivativeByHats { n, k } => {
            format!("the derivative by vector arguments, with the factor `{n}!/({n} - {k})!`")
        }
        Reason::MoreHatsThanArguments { n, k } => {
            format!("the degree is at most {n}, less than {k}")
        }
        Reason::Diagonal => "the diagonal of the polar form".into(),
        Reason::HatIsDifference => "`hat(1) = 1 - 0`, and `f` is multi-affine".into(),
        Reason::ValueOfForm => "a value of the polar form".into(),
        Reason::BezierPoints => "the Bézier points over `[0, 1]`".into(),
        Reason::RaisedPoint { i, n } if *i == 0 || *i == n + 1 => "the end stays".into(),
        Reason::RaisedPoint { i, n } => {
            format!("the mean with the weights `{i}/{m}` and `1 - {i}/{m}`", m = n + 1)
        }

        Reason::BinomialExpansion { n, j } => {
            format!("the coefficient of `t^i` is `(-1)^(i-j) binomial({n}, i) binomial(i, j)`, `j = {j}`")
        }
        Reason::ColumnsOfPowers(n) => {
            format!("the coefficients of `B_j^{n}` are column `j`, `j = 0, ..., {n}`")
        }
        Reason::BasesByMatrix => "from the powers to the Bernstein polynomials".into(),
        Reason::BinomialOfOne { n, j } => {
            format!("the coefficient of `B_i^{n}` is `binomial(i, j)/binomial({n}, j)`, `j = {j}`")
        }
        Reason::ColumnsOfBernstein(n) => {
            format!("the coefficients of `t^j` are column `j`, `j = 0, ..., {n}`")
        }
        Reason::Inverse => "from one basis to the other and back".into(),

        Reason::ControlPoints => "control points".into(),
        Reason::Level(r) => format!("level {r}"),
        Reason::PointOfCurve => "the point of the curve".into(),
        Reason::DivideByWeight => "divided by the weight, the last coordinate".into(),
        Reason::Knots => "the knots".into(),
        Reason::KnotInterval(j) => {
            format!("the parameter lies in the interval from `t_{j}` to `t_{}`", j + 1)
        }
        Reason::InsertionRatio { i, n } => {
            format!("`alpha_{i} = (t - t_{i})/(t_{} - t_{i})`", i + n)
        }
        Reason::MixedPoint(i) => format!("the new control point {i}"),
        Reason::NewKnots => "the knots with the new one".into(),
        Reason::NewControlPoints => "all control points; the others stay".into(),

        Reason::Extrapolated(j) => {
            format!(
                "continued beyond the interval, by {j} step{} of de Casteljau",
                if *j == 1 { "" } else { "s" }
            )
        }
        Reason::LastControlPoint => "the last control point of the first curve".into(),
        Reason::ControlPointOfSecond(j) => format!("control point {j} of the second curve"),
        Reason::ConditionHolds(j) => format!("equal: the condition of order {j} holds"),
        Reason::ConditionFails(j) => format!("not 0: the condition of order {j} fails"),
        Reason::Condition(j) => format!("the condition of order {j}"),
        Reason::ConditionOnDifference(j) => format!("has to be 0: the condition of order {j}"),

        Reason::Nodes => "the nodes".into(),
        Reason::Data => "the data".into(),
        Reason::DividedDifference(k) => format!("divided difference of order {k}"),
        Reason::EqualNodes(k) => format!("equal nodes: the derivative of order {k} over `{k}!`"),
        Reason::NewtonForm => "Newton's form".into(),
        Reason::NumbersPutIn => "with the numbers".into(),
        Reason::ByPowers => "multiplied out".into(),

        Reason::StepLength => "the length of the interval".into(),
        Reason::CoefficientOf { moment } => format!("the coefficient of `M_{moment}`"),
        Reason::RightSide { i, next } => {
            format!("the right side of `mu_{i} M_{} + 2 M_{i} + lambda_{i} M_{next} = d_{i}`", i - 1)
        }
        Reason::EndSlope { i, next } => {
            format!("the right side of `2 M_{i} + M_{next} = d_{i}`: `S'` is given")
        }
        Reason::MomentSystem(AtEnds::Natural) => {
            "the system of equations, with natural ends: `S'' = 0`".into()
        }
        Reason::MomentSystem(AtEnds::Clamped) => "the system of equations, with clamped ends".into(),
        Reason::MomentSystem(AtEnds::NotAKnot) => {
            "the system of equations; no knots: `S'''` is continuous at the nodes next to the ends".into()
        }
        Reason::MomentSystem(AtEnds::Periodic) => "the system of equations of a periodic spline".into(),
        Reason::MomentSystem(AtEnds::Given) => {
            "the system of equations, with the conditions at the ends".into()
        }
        Reason::SystemSolved => "its solution, by elimination".into(),
        Reason::Piece(i) => format!("the piece on `[x_{i}, x_{}]`", i + 1),

        Reason::SquareFreeFactors => {
            "powers of polynomials with simple roots, by gcds with derivatives".into()
        }
        Reason::SimpleRoots => "the same roots, each simple".into(),
        Reason::SignChanges { changes: 0, lower, upper } => {
            format!("no change of sign: no root between `{lower}` and `{upper}`")
        }
        Reason::SignChanges { changes: 1, lower, upper } => {
            format!("one change of sign: exactly one root between `{lower}` and `{upper}`")
        }
        Reason::SignChanges { changes, lower, upper } => format!(
            "{changes} changes of sign: at most {changes} roots between `{lower}` and `{upper}`, the interval is halved"
        ),
        Reason::EndIsRoot => "an end of an interval is a root".into(),
        Reason::NoRoots => "so there is no root".into(),
        Reason::RootsFound(multiplicities) if multiplicities.iter().all(|m| *m == 1) => {
            "the roots, those that are not rational with an interval".into()
        }
        Reason::RootsFound(multiplicities) => {
            let list: Vec<String> = multiplicities.iter().map(ToString::to_string).collect();
            format!("the roots, with the multiplicities {}", list.join(", "))
        }

        Reason::Negative => "a negative value".into(),
        Reason::WithoutSquares => "the factors of odd multiplicity, each once".into(),
        Reason::SquareTimes => "a square is not negative: it has the sign of `G` or is 0".into(),
        Reason::NoneNegative { lower, upper, strict: false } => {
            format!("no coefficient is negative: not negative from `{lower}` to `{upper}`")
        }
        Reason::NoneNegative { lower, upper, .. } => {
            format!("no coefficient is negative, the first and the last are positive: positive from `{lower}` to `{upper}`")
        }
        Reason::NoneNegativeBeyond { end, up, strict } => {
            let (from, tail) = if *up { ("from", " on") } else { ("up to", "") };
            match strict {
                false => format!("no coefficient is negative: not negative {from} `{end}`{tail}"),
                true => format!("no coefficient is negative, the last is positive: positive {from} `{end}`{tail}"),
            }
        }
        Reason::PositiveConstant { strict: false } => "a constant that is not negative".into(),
        Reason::PositiveConstant { .. } => "a positive constant".into(),
        Reason::NotPositive => "a zero: not positive there".into(),
        Reason::SignOfQuotient => "the denominator has no zero there: `F` has the sign of this polynomial".into(),
        Reason::WithArguments(n) => format!("its polar form with {n} arguments"),
        Reason::ChainStarts => "the chain starts with `F`".into(),
        Reason::ItsDerivative => "its derivative".into(),
        Reason::SturmRemainder(k) => {
            format!("a positive multiple of minus the remainder of `P_{}` by `P_{}`", k - 2, k - 1)
        }
        Reason::SturmSigns { at, changes: 1 } => format!("one change of sign at `{at}`, zeros left out"),
        Reason::SturmSigns { at, changes } => format!("{changes} changes of sign at `{at}`, zeros left out"),
        Reason::SturmCount { lower, upper } => {
            format!("so many different roots are larger than `{lower}` and at most `{upper}`")
        }
        Reason::Sylvester { m, n } => {
            format!("{n} rows with the coefficients of `F` and {m} with those of `G`, each moved by one column")
        }
        Reason::CommonFactor => "0: `F` and `G` have a common root or factor".into(),
        Reason::NoCommonFactor => "0 if and only if `F` and `G` have a common root or factor".into(),
        Reason::WeightsNotNegative => "Bernstein polynomials are not negative on the interval".into(),
        Reason::WeightsSumToOne => "their sum is 1".into(),
        Reason::ConvexCombination => "so the point lies in the convex hull of the control points".into(),
        Reason::TangentVector => "the first derivative".into(),
        Reason::SecondDerivative => "the second derivative".into(),
        Reason::LengthSquared(of) => format!("`|{of}|^2`"),
        Reason::InnerProduct => "the scalar product of both".into(),
        Reason::SquaredCurvature => {
            "the squared area of their parallelogram, by Lagrange's identity, over the sixth power of `|c'|`".into()
        }
        Reason::DerivativesAtEnd => "the derivatives where `F` ends".into(),
        Reason::DerivativesAtStart => "the derivatives where `G` starts".into(),
        Reason::BetaWanted(j) => format!("has to be `beta_{j} F'` for `G^{j}`, by the chain rule"),
        Reason::BetaFound(j) => format!("so the curves meet `G^{j}`"),
        Reason::BetaMissing(j) => format!("no multiple of `F'`: the curves do not meet `G^{j}`"),
        Reason::BetaNegative => "only a negative multiple of `F'`: the tangents are opposite, a cusp".into(),
        Reason::CurvatureWithSign => "its root; in the plane it is positive in a left turn".into(),
        Reason::NoneNegativeOver(corners) => {
            format!("no Bernstein coefficient is negative: not negative over {corners}")
        }
        Reason::EdgesNotNegative => {
            "on each edge a polynomial in one variable that is not negative, by its real roots".into()
        }
        Reason::FacesNotNegative => "on each face a polynomial in two variables that is not negative, shown in the same way".into(),
        Reason::CriticalPoints => "a least value inside is at a common zero of all derivatives".into(),
        Reason::NoCriticalPoints => "there is none inside: the least value is on the boundary".into(),
        Reason::CriticalNotNegative => {
            "the common zeros in the region; the value at each of them is not negative".into()
        }

        Reason::CommonRoot => "0 at the parameter of the point `(x, y)`".into(),
        Reason::BoundaryCurves(t) => format!("the curves in `{t}`"),
        Reason::Corners => "they meet at the corners".into(),
        Reason::RuledBetween(c, t) => format!("the ruled surface between `{c}_0` and `{c}_1`, linear in `{t}`"),
        Reason::BilinearOfCorners => "the bilinear surface of the corners, which is part of both".into(),
        Reason::BooleanSum => "the Boolean sum: what both contain is counted once".into(),
        Reason::AllFourCurves => "it contains all four curves".into(),
        Reason::SeriesOfArguments(d) => format!("a series in `x`, wanted up to the power {d}"),
        Reason::CoefficientsOfSeries(d) => format!("its coefficients; `t^k` has the blossom `e_k/binomial({d}, k)`"),
        Reason::RationalAntiderivative => "a rational function with a multiple of `F` as derivative".into(),
        Reason::DerivativeIs(1) => "its derivative".into(),
        Reason::DerivativeIs(k) => format!("its derivative of order {k}"),
        Reason::FactorsOfArguments => "with a factor for each argument in which the blossom is affine".into(),
        Reason::Bezout => "the coefficients of `t^i s^j` in `(P(t) Q(s) - P(s) Q(t))/(t - s)`".into(),
        Reason::Determinant => "0 where `P` and `Q` have a common root".into(),
        Reason::EquationOfCurve => "the irreducible factor that is 0 on the curve".into(),

        Reason::HullMisses => "all of one sign: the hull does not meet the axis, no root".into(),
        Reason::HullAtEnd(end) => format!("the hull meets the axis at the end only: `{end}` is a root"),
        Reason::HullMeets(lower, upper) => {
            format!("the hull meets the axis within the next interval, rounded outwards: `{lower}` to `{upper}`")
        }
        Reason::HullTooWide(middle) => format!("less than a fifth is cut off: halved at `{middle}`"),
        Reason::HullOneRoot => "one change of sign on a short interval: exactly one root".into(),

        Reason::ChangeOfParameter => {
            "`G^k` asks for a change of parameter `phi` with `phi' > 0` for which this holds up to order `k`"
                .into()
        }
        Reason::ChainRule => {
            "the line before differentiated, by the product and the chain rule; `F` and its derivatives at `phi(t)`"
                .into()
        }
        Reason::BetasNamed => "where the curves meet".into(),
    }
}
