//! Chinese.

use num_traits::One;

use super::{AtEnds, Reason, Title, power_of};
use crate::math::blossom::Method;

/// What is derived.
pub(super) fn title(title: Title) -> String {
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
        Title::Positivity => "用伯恩斯坦系数判定多项式的符号".into(),
        Title::Clipping => "用贝塞尔裁剪求实根".into(),
        Title::ConnectionMatrix(k) => format!("`G^{k}` 连续的 beta 矩阵"),
        Title::Coons => "四条曲线的孔斯曲面（布尔和）".into(),
        Title::Multirational => "多元有理极形式".into(),
        Title::Sturm => "用斯图姆序列计算实根个数".into(),
        Title::Resultant => "结式作为西尔维斯特行列式".into(),
        Title::Hull => "控制点凸包中的点".into(),
        Title::Curvature => "曲线的曲率".into(),
        Title::GeometricContinuity(k) => format!("两条曲线的 `G^{k}` 拼接"),
        Title::Implicit => "用贝祖行列式求曲线的隐式方程".into(),
        Title::Roots => "用伯恩斯坦系数与笛卡尔符号法则分离实根".into(),
    }
}

/// Why a line holds.
pub(super) fn reason(reason: &Reason) -> String {
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
        Reason::MixedPoint(i) => format!("新的控制顶点 `{i}`"),
        Reason::NewKnots => "插入后的节点向量".into(),
        Reason::NewControlPoints => "全部控制顶点，其余控制顶点不变".into(),

        Reason::Extrapolated(j) => format!("用 de Casteljau 算法外推 `{j}` 步，到区间之外"),
        Reason::LastControlPoint => "第一条曲线的最后一个控制顶点".into(),
        Reason::ControlPointOfSecond(j) => format!("第二条曲线的控制顶点 `{j}`"),
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

        Reason::SquareFreeFactors => "与导数求最大公因式，分解为无重根多项式的幂".into(),
        Reason::SimpleRoots => "根相同，且都是单根".into(),
        Reason::SignChanges { changes: 0, lower, upper } => {
            format!("符号不变：`{lower}` 与 `{upper}` 之间没有根")
        }
        Reason::SignChanges { changes: 1, lower, upper } => {
            format!("变号一次：`{lower}` 与 `{upper}` 之间恰有一个根")
        }
        Reason::SignChanges { changes, lower, upper } => {
            format!("变号 `{changes}` 次：`{lower}` 与 `{upper}` 之间至多 `{changes}` 个根，区间二等分")
        }
        Reason::EndIsRoot => "区间端点是根".into(),
        Reason::NoRoots => "因此没有根".into(),
        Reason::RootsFound(multiplicities) if multiplicities.iter().all(|m| *m == 1) => {
            "全部根，无理根给出所在区间".into()
        }
        Reason::RootsFound(multiplicities) => {
            let list: Vec<String> = multiplicities.iter().map(|m| format!("`{m}`")).collect();
            format!("全部根，重数依次为 {}", list.join("、"))
        }

        Reason::Negative => "取负值".into(),
        Reason::WithoutSquares => "重数为奇数的因式，各取一次".into(),
        Reason::SquareTimes => "平方非负，故与 `G` 同号或为零".into(),
        Reason::NoneNegative { lower, upper, strict: false } => {
            format!("系数均非负：在 `{lower}` 到 `{upper}` 上非负")
        }
        Reason::NoneNegative { lower, upper, .. } => {
            format!("系数均非负，首末系数为正：在 `{lower}` 到 `{upper}` 上为正")
        }
        Reason::NoneNegativeBeyond { end, up, strict } => {
            let (before, sign) = if *strict {
                ("系数均非负，常数项为正", "为正")
            } else {
                ("系数均非负", "非负")
            };
            if *up {
                format!("{before}：从 `{end}` 起{sign}")
            } else {
                format!("{before}：到 `{end}` 为止{sign}")
            }
        }
        Reason::PositiveConstant { strict: false } => "非负常数".into(),
        Reason::PositiveConstant { .. } => "正常数".into(),
        Reason::NotPositive => "零点：在此不为正".into(),
        Reason::SignOfQuotient => "分母在此没有零点：`F` 与此多项式同号".into(),
        Reason::WithArguments(n) => format!("其 {n} 元极形式"),
        Reason::ChainStarts => "序列从 `F` 开始".into(),
        Reason::ItsDerivative => "其导数".into(),
        Reason::SturmRemainder(k) => format!("`P_{}` 除以 `P_{}` 的余式的相反数，乘以正因子", k - 2, k - 1),
        Reason::SturmSigns { at, changes } => format!("在 `{at}` 处变号 {changes} 次（不计零）"),
        Reason::SturmCount { lower, upper } => format!("大于 `{lower}` 且不超过 `{upper}` 的不同实根个数"),
        Reason::Sylvester { m, n } => format!("`F` 的系数 {n} 行，`G` 的系数 {m} 行，逐行右移一列"),
        Reason::CommonFactor => "为零：`F` 与 `G` 有公共根或公因式".into(),
        Reason::NoCommonFactor => "当且仅当 `F` 与 `G` 有公共根或公因式时为零".into(),
        Reason::WeightsNotNegative => "伯恩斯坦多项式在区间上非负".into(),
        Reason::WeightsSumToOne => "其和为 1".into(),
        Reason::ConvexCombination => "因此该点在控制点的凸包中".into(),
        Reason::TangentVector => "一阶导数".into(),
        Reason::SecondDerivative => "二阶导数".into(),
        Reason::LengthSquared(of) => format!("`|{of}|^2`"),
        Reason::InnerProduct => "二者的数量积".into(),
        Reason::SquaredCurvature => {
            "二者所张平行四边形面积的平方（拉格朗日恒等式），除以 `|c'|` 的六次方".into()
        }
        Reason::DerivativesAtEnd => "`F` 终点处的导数".into(),
        Reason::DerivativesAtStart => "`G` 起点处的导数".into(),
        Reason::BetaWanted(j) => format!("由链式法则，`G^{j}` 要求它等于 `beta_{j} F'`"),
        Reason::BetaFound(j) => format!("因此两曲线 `G^{j}` 连续"),
        Reason::BetaMissing(j) => format!("不是 `F'` 的倍数：两曲线不是 `G^{j}` 连续"),
        Reason::BetaNegative => "只能是 `F'` 的负倍数：切向相反，为尖点".into(),
        Reason::CurvatureWithSign => "其平方根；在平面中左转时为正".into(),
        Reason::NoneNegativeOver(corners) => format!("伯恩斯坦系数均非负：在 {corners} 上非负"),
        Reason::EdgesNotNegative => "在每条边上是一元多项式，由其实根知非负".into(),
        Reason::FacesNotNegative => "在每个面上是二元多项式，同样证得非负".into(),
        Reason::CriticalPoints => "内部的最小值在各偏导数的公共零点处取到".into(),
        Reason::NoCriticalPoints => "内部没有公共零点：最小值在边界上取到".into(),
        Reason::CriticalNotNegative => "区域内的公共零点，在各点处的值均非负".into(),

        Reason::CommonRoot => "在点 `(x, y)` 的参数处为零".into(),
        Reason::BoundaryCurves(t) => format!("以 `{t}` 为参数的曲线"),
        Reason::Corners => "它们在角点处相交".into(),
        Reason::RuledBetween(c, t) => format!("`{c}_0` 与 `{c}_1` 之间的直纹面，关于 `{t}` 是线性的"),
        Reason::BilinearOfCorners => "角点的双线性曲面，两者都含有它".into(),
        Reason::BooleanSum => "布尔和：公共部分只计一次".into(),
        Reason::AllFourCurves => "它包含全部四条曲线".into(),
        Reason::SeriesOfArguments(d) => format!("`x` 的幂级数，取到 {d} 次"),
        Reason::CoefficientsOfSeries(d) => format!("它的系数；`t^k` 的极形式是 `e_k/binomial({d}, k)`"),
        Reason::RationalAntiderivative => "一个有理函数，其导数是 `F` 的倍数".into(),
        Reason::DerivativeIs(k) => format!("它的 {k} 阶导数"),
        Reason::FactorsOfArguments => "每个使极形式为仿射的变元各乘一个因子".into(),
        Reason::Bezout => "`(P(t) Q(s) - P(s) Q(t))/(t - s)` 中 `t^i s^j` 的系数".into(),
        Reason::Determinant => "当 `P` 与 `Q` 有公共根时为零".into(),
        Reason::EquationOfCurve => "在曲线上为零的不可约因子".into(),

        Reason::HullMisses => "系数同号：凸包不与轴相交，无根".into(),
        Reason::HullAtEnd(end) => format!("凸包仅在端点与轴相交：`{end}` 是根"),
        Reason::HullMeets(lower, upper) => {
            format!("凸包与轴的交落在下一个区间内（向外舍入）：`{lower}` 到 `{upper}`")
        }
        Reason::HullTooWide(middle) => format!("裁去不足五分之一：在 `{middle}` 处二分"),
        Reason::HullOneRoot => "短区间上恰有一次变号：恰有一个根".into(),

        Reason::ChangeOfParameter => "`G^k` 要求存在参数变换 `phi`，`phi' > 0`，使此式直到 `k` 阶成立".into(),
        Reason::ChainRule => "对上一行求导，用乘积法则与链式法则；`F` 及其导数取在 `phi(t)` 处".into(),
        Reason::BetasNamed => "在连接点处".into(),
    }
}
