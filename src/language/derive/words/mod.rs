//! All words of derivations, in every language.
//!
//! A further language is a variant of [`Language`] and a file like `english.rs`: one function for
//! the titles and one for the reasons. Formulas stand between backticks, in plain notation.

mod chinese;
mod english;

use crate::language::value::{Language, Words};
use crate::math::blossom::Method;
use crate::math::number::{Int, Rational};
use crate::math::poly::Symbol;

/// What is derived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Title {
    /// A polar form by a method.
    Polar(Method),
    /// Polar form of a sum.
    Sum,
    /// Polar form of a product.
    Product,
    /// Polar form of a composition.
    Composition,
    /// Derivative of order k.
    Derivative(usize),
    /// Elevation by k.
    Elevation(usize),
    /// A_n.
    PowerMatrix(usize),
    /// The inverse of A_n.
    BernsteinMatrix(usize),
    /// De Casteljau's scheme.
    DeCasteljau,
    /// De Boor's scheme.
    DeBoor,
    /// Knot insertion.
    Insertion,
    /// C^k conditions.
    Joining(usize),
    /// Divided differences.
    Newton,
    /// A cubic spline by moments.
    Moments,
    /// Real roots by halved intervals.
    Roots,
    /// The sign of a polynomial on an interval.
    Positivity,
    /// Real roots by convex hulls.
    Clipping,
    /// The matrix of G^k.
    ConnectionMatrix(usize),
    /// The equation of a plane curve.
    Implicit,
    /// Coons' surface.
    Coons,
    /// A multirational blossom.
    Multirational,
    /// Sturm's chain.
    Sturm,
    /// Sylvester's determinant.
    Resultant,
    /// The hull property.
    Hull,
    /// A curvature.
    Curvature,
    /// How two curves meet G^k.
    GeometricContinuity(usize),
}

/// What is asked of a cubic spline at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtEnds {
    /// S'' = 0.
    Natural,
    /// S' is given.
    Clamped,
    /// S''' is continuous at the nodes next to them.
    NotAKnot,
    /// The same at both.
    Periodic,
    /// Something else, or a condition of its own for each.
    Given,
}

/// Why a line of a derivation holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Something given.
    Given,
    /// F, a polynomial of degree at most n.
    DegreeAtMost(usize),
    /// The polynomial whose polar form is asked for.
    Wanted,
    /// The polar form of F or G.
    PolarFormOf(&'static str),
    /// All parts together.
    PutTogether,

    /// t^i becomes the mean of some products.
    PowerToMean {
        /// t
        variable: Symbol,
        /// i
        power: usize,
        /// How many products there are.
        of: Int,
    },
    /// Each power has become a mean.
    PowersReplaced,
    /// The expected product of a random subset.
    Expectation {
        /// Its size.
        size: usize,
        /// n
        of: usize,
        /// The probability of each subset.
        probability: Rational,
    },
    /// Expectations may be added.
    ExpectationIsLinear,
    /// Φ.
    Auxiliary,
    /// The sum over all derivatives.
    TaylorForm,
    /// Term i of that sum.
    TermNumber(usize),
    /// τ is gone.
    TauDropsOut(Symbol),
    /// The derivative of a product.
    ProductRule,
    /// The first part cancels the last part of the term before.
    CancelsWithTheTermBefore,
    /// All parts cancel.
    Telescopes,
    /// A value at τ = 0.
    TauIsZero(Symbol),
    /// Any τ will do.
    AnyTau(Symbol),
    /// p_0 = F.
    StartOfPolars,
    /// The polar by an argument.
    PolarBy(Symbol),
    /// After n polars.
    AfterAllPolars(Symbol),
    /// F in the Bernstein basis.
    InBernsteinBasis(usize),
    /// The polar form of B_i^n.
    PolarOfBernstein {
        /// i
        index: usize,
        /// n
        degree: usize,
    },
    /// The polar form of a sum is the sum of the polar forms.
    PolarFormIsLinear,
    /// Each u^i v^j becomes the product of two means.
    ProductsOfMeans,
    /// Each monomial becomes a mean over all ways to hand out its factors.
    HandedOut,

    /// The mean over all ways to leave out arguments.
    LeaveOut {
        /// Arguments before.
        from: usize,
        /// Arguments after.
        to: usize,
    },
    /// Both forms have as many arguments now.
    SameArguments,
    /// Added.
    Added,
    /// One factor is a constant.
    ConstantFactor,
    /// A constant is put in, or is all there is.
    ConstantInside,
    /// f and g with different arguments.
    DistinctArguments,
    /// The mean over all ways to share out the arguments of a product.
    SymmetrisedProduct {
        /// The number of ways.
        count: Int,
        /// Arguments of f.
        m: usize,
        /// Arguments of g.
        n: usize,
    },
    /// g with different arguments inside f.
    DistinctInside,
    /// The mean over all ways to share out the arguments of a composition.
    SymmetrisedComposition {
        /// The number of ways.
        count: Int,
        /// Arguments of f.
        m: usize,
        /// Arguments of g.
        n: usize,
    },

    /// The derivative of order k as a value at vectors.
    DerivativeByHats {
        /// n
        n: usize,
        /// k
        k: usize,
    },
    /// k > n.
    MoreHatsThanArguments {
        /// n
        n: usize,
        /// k
        k: usize,
    },
    /// f(t, …, t) = F(t).
    Diagonal,
    /// 1̂ = 1 − 0.
    HatIsDifference,
    /// A value of the polar form.
    ValueOfForm,
    /// Bézier points as values of the polar form.
    BezierPoints,
    /// Point i of degree n + 1 as a mean of two of degree n.
    RaisedPoint {
        /// i
        i: usize,
        /// n
        n: usize,
    },

    /// B_j^n multiplied out.
    BinomialExpansion {
        /// n
        n: usize,
        /// j
        j: usize,
    },
    /// A_n has these coefficients in its columns.
    ColumnsOfPowers(usize),
    /// The two bases by A_n.
    BasesByMatrix,
    /// t^j times a power of t + (1 − t).
    BinomialOfOne {
        /// n
        n: usize,
        /// j
        j: usize,
    },
    /// The inverse has these coefficients in its columns.
    ColumnsOfBernstein(usize),
    /// One is the inverse of the other.
    Inverse,

    /// Control points with their labels.
    ControlPoints,
    /// A point of level r of a scheme.
    Level(usize),
    /// The last point is the point of the curve.
    PointOfCurve,
    /// Homogeneous coordinates are divided by the weight.
    DivideByWeight,
    /// The knots.
    Knots,
    /// The interval number j with the parameter.
    KnotInterval(usize),
    /// The ratio of a new knot.
    InsertionRatio {
        /// i
        i: usize,
        /// n
        n: usize,
    },
    /// The new control point i between two old ones.
    MixedPoint(usize),
    /// The knots with the new one.
    NewKnots,
    /// All control points afterwards.
    NewControlPoints,

    /// A value of f beyond its interval, by j steps.
    Extrapolated(usize),
    /// The last control point of the first curve.
    LastControlPoint,
    /// Control point j of the second curve.
    ControlPointOfSecond(usize),
    /// The condition of this order holds.
    ConditionHolds(usize),
    /// The condition of this order fails.
    ConditionFails(usize),
    /// What a control point has to be.
    Condition(usize),
    /// What has to be 0.
    ConditionOnDifference(usize),

    /// The nodes.
    Nodes,
    /// The values given at the nodes.
    Data,
    /// A divided difference of order k.
    DividedDifference(usize),
    /// A divided difference of k + 1 equal nodes.
    EqualNodes(usize),
    /// Newton's form.
    NewtonForm,
    /// With its numbers.
    NumbersPutIn,
    /// Multiplied out.
    ByPowers,

    /// h_i.
    StepLength,
    /// The coefficient of a moment.
    CoefficientOf {
        /// Its number.
        moment: usize,
    },
    /// d_i.
    RightSide {
        /// i
        i: usize,
        /// The number of the next moment: i + 1, or 1 again.
        next: usize,
    },
    /// The right side of an equation for an end where S' is given.
    EndSlope {
        /// Its number.
        i: usize,
        /// The number of the moment next to it.
        next: usize,
    },
    /// The system of equations, with these conditions at the ends.
    MomentSystem(AtEnds),
    /// Its solution.
    SystemSolved,
    /// Piece i.
    Piece(usize),

    /// F as a product of powers of polynomials with simple roots.
    SquareFreeFactors,
    /// The polynomial with the same roots, each simple.
    SimpleRoots,
    /// The Bernstein coefficients over an interval, and how often their signs change.
    SignChanges {
        /// How often.
        changes: usize,
        /// The lower end of the interval.
        lower: Rational,
        /// Its upper end.
        upper: Rational,
    },
    /// An end of an interval is a root.
    EndIsRoot,
    /// There are none.
    NoRoots,
    /// All roots, with these multiplicities.
    RootsFound(Vec<usize>),

    /// A value is negative.
    Negative,
    /// G, which has simple roots only.
    WithoutSquares,
    /// F = S² G.
    SquareTimes,
    /// No Bernstein coefficient over an interval is negative.
    NoneNegative {
        /// The lower end of the interval.
        lower: Rational,
        /// Its upper end.
        upper: Rational,
        /// Whether those at the ends are positive, too.
        strict: bool,
    },
    /// No coefficient of F(c + x) or F(c − x) is negative.
    NoneNegativeBeyond {
        /// c
        end: Rational,
        /// Whether it is F(c + x).
        up: bool,
        /// Whether the constant term is positive, too.
        strict: bool,
    },
    /// A constant that is not negative.
    PositiveConstant {
        /// Whether it is positive.
        strict: bool,
    },
    /// A value is 0.
    NotPositive,
    /// F = P/Q, and this polynomial is P Q.
    SignOfQuotient,
    /// The polar form with so many arguments.
    WithArguments(usize),

    /// The first polynomial of Sturm's chain.
    ChainStarts,
    /// The derivative of the line before.
    ItsDerivative,
    /// A positive multiple of minus the remainder of the two before; its number.
    SturmRemainder(usize),
    /// How often the signs change at an end.
    SturmSigns {
        /// The end.
        at: Rational,
        /// How often.
        changes: usize,
    },
    /// The number of roots.
    SturmCount {
        /// The lower end, not counted.
        lower: Rational,
        /// The upper end.
        upper: Rational,
    },
    /// Sylvester's matrix, for these degrees.
    Sylvester {
        /// The degree of F.
        m: usize,
        /// The degree of G.
        n: usize,
    },
    /// The resultant is 0.
    CommonFactor,
    /// The resultant is not 0.
    NoCommonFactor,

    /// Bernstein polynomials are not negative on the interval.
    WeightsNotNegative,
    /// They add up to 1.
    WeightsSumToOne,
    /// A combination with such weights.
    ConvexCombination,

    /// c'
    TangentVector,
    /// c''
    SecondDerivative,
    /// |c'|² or |c''|²
    LengthSquared(&'static str),
    /// c' · c''
    InnerProduct,
    /// κ² by Lagrange's identity.
    SquaredCurvature,
    /// κ
    CurvatureWithSign,

    /// The derivatives of the first curve where it ends.
    DerivativesAtEnd,
    /// Those of the second one where it starts.
    DerivativesAtStart,
    /// What β_j has to be for G^j.
    BetaWanted(usize),
    /// β_j.
    BetaFound(usize),
    /// There is no β_j.
    BetaMissing(usize),
    /// β_1 would be negative.
    BetaNegative,
    /// No Bernstein coefficient over a rectangle or triangle with these corners is negative.
    NoneNegativeOver(String),
    /// On the edges it is a polynomial in one variable.
    EdgesNotNegative,
    /// On each face a polynomial in two variables is not negative.
    FacesNotNegative,
    /// Critical points are common zeros of both derivatives.
    CriticalPoints,
    /// There are none in the region.
    NoCriticalPoints,
    /// Not negative at all of them.
    CriticalNotNegative,

    /// The parameter of a point of the curve is a root of both.
    CommonRoot,
    /// Bézout's matrix.
    Bezout,
    /// 0 if and only if there is a common root.
    Determinant,
    /// The irreducible factor that is 0 on the curve.
    EquationOfCurve,

    /// The hull of the Bézier points does not meet the axis.
    HullMisses,
    /// It meets it at an end only.
    HullAtEnd(Rational),
    /// Between these numbers, rounded outwards.
    HullMeets(Rational, Rational),
    /// Too little is cut off.
    HullTooWide(Rational),
    /// One sign change on a short interval.
    HullOneRoot,

    /// Curves whose parameter is u, or v.
    BoundaryCurves(Symbol),
    /// Where they meet.
    Corners,
    /// The ruled surface between two of them, linear in the other parameter.
    RuledBetween(&'static str, Symbol),
    /// The bilinear surface of the corners.
    BilinearOfCorners,
    /// Their sum without what both contain.
    BooleanSum,
    /// It contains all four curves.
    AllFourCurves,

    /// Its coefficients up to x^d are wanted.
    SeriesOfArguments(usize),
    /// e_0, …, e_d; t^k becomes e_k/C(d, k).
    CoefficientsOfSeries(usize),
    /// A rational function G.
    RationalAntiderivative,
    /// G^(k) is a multiple of F.
    DerivativeIs(usize),
    /// A factor t − u_i for each argument on the left.
    FactorsOfArguments,

    /// G = F ∘ φ.
    ChangeOfParameter,
    /// The line before, differentiated.
    ChainRule,
    /// β_i = φ^(i) at the joint.
    BetasNamed,
}

impl Title {
    /// The title in every language.
    pub fn words(self) -> Words {
        Words::new(|language| match language {
            Language::English => english::title(self),
            Language::Chinese => chinese::title(self),
        })
    }
}

impl Reason {
    /// The reason in every language.
    ///
    /// ```
    /// use polarform::derive::words::Reason;
    /// use polarform::value::Language;
    /// let words = Reason::HatIsDifference.words();
    /// assert_eq!(words.text(Language::Chinese), "`hat(1) = 1 - 0`，利用多重仿射性展开");
    /// ```
    pub fn words(&self) -> Words {
        Words::new(|language| match language {
            Language::English => english::reason(self),
            Language::Chinese => chinese::reason(self),
        })
    }
}

/// t^i, or t alone.
fn power_of(variable: &Symbol, power: usize) -> String {
    if power == 1 { format!("`{variable}`") } else { format!("`{variable}^{power}`") }
}
