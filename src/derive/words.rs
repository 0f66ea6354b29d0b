//! All words of derivations, in every language.
//!
//! A further language is a variant of [`Language`] and a pair of functions here: one for the
//! reasons and one for the titles. Formulas stand between backticks, in plain notation.

use crate::blossom::Method;
use crate::number::{Int, Rational};
use crate::poly::Symbol;
use crate::value::{Language, Words};
use num_traits::One;

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
    /// Control point j of the second curve.
    ControlPointOf {
        /// j
        index: usize,
    },
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
}

impl Title {
    /// The title in every language.
    pub fn words(self) -> Words {
        Words::new(|language| match language {
            Language::English => title_in_english(self),
            Language::Chinese => title_in_chinese(self),
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
            Language::English => english(self),
            Language::Chinese => chinese(self),
        })
    }
}

fn title_in_english(title: Title) -> String {
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
    }
}

fn title_in_chinese(title: Title) -> String {
    match title {
        Title::Polar(Method::Elementary) => "用初等对称函数求极形式".into(),
        Title::Polar(Method::Probability) => "用数学期望求极形式".into(),
        Title::Polar(Method::Taylor) => "用泰勒公式求极形式".into(),
        Title::Polar(Method::Parts) => "用分部积分求极形式".into(),
        Title::Polar(Method::Laguerre) => "用拉盖尔极化求极形式".into(),
        Title::Polar(Method::Bezier) => "用贝塞尔控制顶点求极形式".into(),
        Title::Sum => "和的极形式".into(),
        Title::Product => "乘积的极形式".into(),
        Title::Composition => "复合多项式的极形式".into(),
        Title::Derivative(k) => format!("用极形式求 `{k}` 阶导数"),
        Title::Elevation(k) => format!("升阶 `{k}` 次"),
        Title::PowerMatrix(n) => format!("矩阵 `A_{n}`"),
        Title::BernsteinMatrix(n) => format!("矩阵 `A_{n}` 的逆矩阵"),
        Title::DeCasteljau => "de Casteljau 算法".into(),
        Title::DeBoor => "de Boor 算法".into(),
        Title::Insertion => "节点插入".into(),
        Title::Joining(k) => format!("两条曲线的 `C^{k}` 拼接条件"),
        Title::Newton => "差商与牛顿插值公式".into(),
        Title::Moments => "三次样条的三弯矩法".into(),
    }
}

/// t^i, or t alone.
fn power_of(variable: &Symbol, power: usize) -> String {
    if power == 1 { format!("`{variable}`") } else { format!("`{variable}^{power}`") }
}

fn english(reason: &Reason) -> String {
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
        Reason::MixedPoint(i) => format!("the new control point number {i}"),
        Reason::NewKnots => "the knots with the new one".into(),
        Reason::NewControlPoints => "all control points; the others stay".into(),

        Reason::Extrapolated(j) => {
            format!(
                "continued beyond the interval, by {j} step{} of de Casteljau",
                if *j == 1 { "" } else { "s" }
            )
        }
        Reason::ControlPointOf { index } => format!("control point {index} of the second curve"),
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
    }
}

fn chinese(reason: &Reason) -> String {
    match reason {
        Reason::Given => "已知".into(),
        Reason::DegreeAtMost(n) => format!("次数不超过 `{n}` 的多项式"),
        Reason::Wanted => "求 `H` 的极形式 `h`".into(),
        Reason::PolarFormOf(name) => format!("`{name}` 的极形式"),
        Reason::PutTogether => "整理即得".into(),
        Reason::PowerToMean { variable, power, of } if of.is_one() => {
            format!("替换 {}：只有一个乘积", power_of(variable, *power))
        }
        Reason::PowerToMean { variable, power, of } => {
            format!("替换 {}：`{of}` 个乘积的平均值", power_of(variable, *power))
        }
        Reason::PowersReplaced => "各次幂换成相应的平均值".into(),
        Reason::Expectation { size, of, probability } => {
            format!("从 `{of}` 个变元中随机取 `{size}` 个，每种取法的概率为 `{probability}`，乘积的数学期望")
        }
        Reason::ExpectationIsLinear => "各次幂换成乘积的数学期望".into(),
        Reason::Auxiliary => "辅助函数".into(),
        Reason::TaylorForm => "极形式的泰勒型公式".into(),
        Reason::TermNumber(i) => format!("`i = {i}` 的项"),
        Reason::TauDropsOut(tau) => format!("各项相加，`{tau}` 消去"),
        Reason::ProductRule => "由乘积求导法则".into(),
        Reason::CancelsWithTheTermBefore => "由乘积求导法则，第一部分与上一项的最后一部分抵消".into(),
        Reason::Telescopes => "相邻两项抵消，故各项之和为常数".into(),
        Reason::TauIsZero(tau) => format!("取 `{tau} = 0`"),
        Reason::AnyTau(tau) => format!("和与 `{tau}` 无关，可取 `{tau} = 0`"),
        Reason::StartOfPolars => "从多项式本身出发".into(),
        Reason::PolarBy(argument) => format!("关于 `{argument}` 的极化"),
        Reason::AfterAllPolars(tau) => format!("全部极化之后 `{tau}` 消去"),
        Reason::InBernsteinBasis(n) => {
            format!("用伯恩斯坦基表示：`b_i = sum(j=0..i, binomial(i, j)/binomial({n}, j) c_j)`")
        }
        Reason::PolarOfBernstein { index, degree } => format!("`B_{index}^{degree}` 的极形式"),
        Reason::PolarFormIsLinear => "和的极形式等于极形式的和".into(),
        Reason::ProductsOfMeans => "每个变量的幂换成该组变元中相应个数的乘积的平均值".into(),
        Reason::HandedOut => "每个单项式换成把各因子分配给不同变元的所有方式的平均值".into(),

        Reason::LeaveOut { from, to } if from + 1 == *to => {
            format!("从 `{to}` 个变元中依次去掉一个，取平均值")
        }
        Reason::LeaveOut { from, to } => {
            format!("从 `{to}` 个变元中任取 `{from}` 个，对所有取法求平均值")
        }
        Reason::SameArguments => "两者的变元个数相同".into(),
        Reason::Added => "相加即得".into(),
        Reason::ConstantFactor => "有一个因子是常数".into(),
        Reason::ConstantInside => "常数".into(),
        Reason::DistinctArguments => "取不同的变元相乘".into(),
        Reason::SymmetrisedProduct { count, m, n } => {
            format!("对称化：从 `{}` 个变元中取 `{m}` 个给 `f`，对全部 `{count}` 种取法求平均值", m + n)
        }
        Reason::DistinctInside => "把不同变元的 `g` 代入 `f`".into(),
        Reason::SymmetrisedComposition { count, .. } if count.is_one() => "已经对称".into(),
        Reason::SymmetrisedComposition { count, m, n } => format!(
            "对称化：把 `{}` 个变元分成 `{m}` 组，每组 `{n}` 个，对全部 `{count}` 种分法求平均值",
            m * n
        ),

        Reason::DerivativeByHats { n, k } => {
            format!("用向量变元求导，系数为 `{n}!/({n} - {k})!`")
        }
        Reason::MoreHatsThanArguments { n, k } => format!("次数不超过 `{n}`，小于 `{k}`"),
        Reason::Diagonal => "令各变元相等".into(),
        Reason::HatIsDifference => "`hat(1) = 1 - 0`，利用多重仿射性展开".into(),
        Reason::ValueOfForm => "极形式的值".into(),
        Reason::BezierPoints => "区间 `[0, 1]` 上的贝塞尔控制顶点".into(),
        Reason::RaisedPoint { i, n } if *i == 0 || *i == n + 1 => "端点不变".into(),
        Reason::RaisedPoint { i, n } => {
            format!("以 `{i}/{m}` 和 `1 - {i}/{m}` 为权的加权平均", m = n + 1)
        }

        Reason::BinomialExpansion { n, j } => {
            format!("`t^i` 的系数为 `(-1)^(i-j) binomial({n}, i) binomial(i, j)`，其中 `j = {j}`")
        }
        Reason::ColumnsOfPowers(n) => {
            format!("第 `j` 列是 `B_j^{n}` 的系数，`j = 0, ..., {n}`")
        }
        Reason::BasesByMatrix => "由幂基得到伯恩斯坦基".into(),
        Reason::BinomialOfOne { n, j } => {
            format!("`B_i^{n}` 的系数为 `binomial(i, j)/binomial({n}, j)`，其中 `j = {j}`")
        }
        Reason::ColumnsOfBernstein(n) => {
            format!("第 `j` 列是 `t^j` 的系数，`j = 0, ..., {n}`")
        }
        Reason::Inverse => "由一组基变到另一组基，再变回来".into(),

        Reason::ControlPoints => "控制顶点".into(),
        Reason::Level(r) => format!("第 `{r}` 层"),
        Reason::PointOfCurve => "曲线上的点".into(),
        Reason::DivideByWeight => "除以权因子，即最后一个坐标".into(),
        Reason::Knots => "节点向量".into(),
        Reason::KnotInterval(j) => format!("参数落在 `t_{j}` 到 `t_{}` 的节点区间内", j + 1),
        Reason::InsertionRatio { i, n } => {
            format!("`alpha_{i} = (t - t_{i})/(t_{} - t_{i})`", i + n)
        }
        Reason::MixedPoint(i) => format!("第 `{i}` 个新控制顶点"),
        Reason::NewKnots => "插入后的节点向量".into(),
        Reason::NewControlPoints => "全部控制顶点，其余控制顶点不变".into(),

        Reason::Extrapolated(j) => format!("用 de Casteljau 算法外推 `{j}` 步，到区间之外"),
        Reason::ControlPointOf { index } => format!("第二条曲线的第 `{index}` 个控制顶点"),
        Reason::ConditionHolds(j) => format!("两者相等，`{j}` 阶条件成立"),
        Reason::ConditionFails(j) => format!("不为零，`{j}` 阶条件不成立"),
        Reason::Condition(j) => format!("`{j}` 阶条件"),
        Reason::ConditionOnDifference(j) => format!("须为零，即 `{j}` 阶条件"),

        Reason::Nodes => "插值节点".into(),
        Reason::Data => "给定数据".into(),
        Reason::DividedDifference(k) => format!("`{k}` 阶差商"),
        Reason::EqualNodes(k) => format!("重节点：`{k}` 阶导数除以 `{k}!`"),
        Reason::NewtonForm => "牛顿插值公式".into(),
        Reason::NumbersPutIn => "代入数值".into(),
        Reason::ByPowers => "展开".into(),

        Reason::StepLength => "区间长度".into(),
        Reason::CoefficientOf { moment } => format!("`M_{moment}` 的系数"),
        Reason::RightSide { i, next } => {
            format!("方程 `mu_{i} M_{} + 2 M_{i} + lambda_{i} M_{next} = d_{i}` 的右端", i - 1)
        }
        Reason::EndSlope { i, next } => format!("方程 `2 M_{i} + M_{next} = d_{i}` 的右端，`S'` 已给定"),
        Reason::MomentSystem(AtEnds::Natural) => "三弯矩方程组，自然边界条件 `S'' = 0`".into(),
        Reason::MomentSystem(AtEnds::Clamped) => "三弯矩方程组，固支边界条件".into(),
        Reason::MomentSystem(AtEnds::NotAKnot) => {
            "三弯矩方程组，非扭结边界条件：`S'''` 在端点的相邻节点处连续".into()
        }
        Reason::MomentSystem(AtEnds::Periodic) => "三弯矩方程组，周期边界条件".into(),
        Reason::MomentSystem(AtEnds::Given) => "三弯矩方程组，含给定的边界条件".into(),
        Reason::SystemSolved => "用消元法求解".into(),
        Reason::Piece(i) => format!("区间 `[x_{i}, x_{}]` 上的一段", i + 1),
    }
}
