//! What words of a question are about that is no request here, and what to write for it: the point in which two lines
//! meet, a midpoint, a fraction for a decimal.

/// Something that can be written, or advice for what cannot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Advice {
    /// A query.
    Write(&'static str),
    /// The function of which the example is one.
    Function(&'static str),
    /// All equations of the question are solved together.
    Equations(&'static str),
    /// What there is instead.
    Say(&'static str),
}

use self::Advice::{Equations, Function, Say, Write};

/// How many letters may follow a stem.
const ENDING: usize = 4;

/// Words in several languages, with bars between them; `~` stands for an ending.
const TOPICS: &[(&str, Advice)] = &[
    (
        "intersect~ | meet | meets | schnittpunkt~ | schneid~ | schnittmenge | croise~ | se coupent | 交点 | 相交 | interseca~ | intersección | intersezion~",
        Equations("solve([y = x^2, y = 3x - 2], [x, y])"),
    ),
    ("intersect~ | schnittpunkt~ | 交点", Function("intersections")),
    (
        "distance~ | abstand~ | entfernung~ | 距离 | distancia | distanza",
        Write("dot((4, 6) - (1, 2), (4, 6) - (1, 2))"),
    ),
    (
        "distance~ | abstand~ | 距离",
        Say("that is the square of a distance, which is rational where the distance is not"),
    ),
    (
        "midpoint~ | mittelpunkt~ | mitte | milieu | middle | 中点 | punto medio",
        Write("bezier([4, 0, 2])(1/2)"),
    ),
    (
        "tangent~ | slope~ | steigung~ | pente | 切线 | 斜率 | velocity",
        Write("derivative(bezier([(0, 0), (1, 2), (2, 0)]))(1/2)"),
    ),
    ("area | fläche~ | aire | 面积 | superficie", Function("area")),
    ("area | fläche~ | aire | 面积", Write("integrate(t^2, 0, 1)")),
    (
        "double root~ | repeated root~ | multiple root~ | doppelte~ nullstelle~ | racine double | 重根",
        Write("solve(discriminant(x^2 + k x + 9, x) = 0)"),
    ),
    (
        "for which | für welche~ | pour quel~ | para qué",
        Say("for which values an inequality holds is not found; where it begins to fail an equation holds: \
             solve(discriminant(t^2 + k t + 1, t) = 0, k)"),
    ),
    (
        "continuous | continuity | stetig~ | continue | continuité | smooth~ | glatt | 连续 | c1 | c2 | g1",
        Function("continuity"),
    ),
    ("join~ | anschluss | raccord~ | 拼接", Function("joining_conditions")),
    (
        "entry | entries | element | row | column | eintrag | zeile | spalte | ligne | colonne | 元素",
        Write("[1, 2; 3, 4]_{1,2}"),
    ),
    ("eigenvalue~ | eigenwert~ | valeur~ propre~ | 特征值", Function("eigenvalues")),
    (
        "eigenvector~ | eigenvektor~ | vecteur~ propre~ | 特征向量",
        Write("null_space([4, 1; 2, 3] - 5 identity(2))"),
    ),
    (
        "chebyshev | tschebyscheff | tchebychev | 切比雪夫",
        Say("Chebyshev polynomials are no basis here; legendre(n) and bernstein(n) are"),
    ),
    (
        "fraction~ | decimal~ | bruch | dezimal~ | 分数 | 小数",
        Say("decimals are fractions here: 0.125 + 0.7 gives 33/40"),
    ),
    ("odd | ungerade~ | impair~ | 奇数", Write("sum(k=1..5, (2k - 1)^2)")),
    ("even | gerade zahl~ | pair~ | 偶数", Write("sum(k=1..5, (2k)^2)")),
    ("squares | quadrate | carrés | cubes | 平方和", Write("sum(k=1..4, k^2)")),
    (
        "perfect square | quadrat | prime | irreducible | primzahl | irreduzibel | premier | irréductible | 素数 | 质数",
        Function("factor"),
    ),
    ("divisible | teilbar~ | divisible par | 整除", Write("2^10 mod 7")),
    ("sum | summe | somme | suma | 求和", Write("sum(k=1..100, k)")),
    ("plot | graph | draw | sketch | zeichne~ | skizzier~ | tracer | 画", Function("figure_functions")),
    ("monoton~ | increas~ | decreas~ | wachsend | croissant~ | 单调", Write("t^3 is increasing on [0, 1]")),
    ("positiv~ | nonnegativ~ | positif~ | 正定", Write("t^2 - t + 1 > 0 for all t")),
    ("critical | stationary | extrem~ | extrema | turning | kritisch~ | 极值", Write("roots(diff(t^3 - t))")),
    ("inflection~ | wendepunkt~ | inflexion", Function("inflections")),
    (
        "vertex | scheitel~ | sommet | complete the square | completing the square | quadratische~ ergänzung | 顶点",
        Write("in_powers(x^2 - 4x + 7, 2)"),
    ),
    (
        "angle~ | winkel | orthogonal | perpendicular | senkrecht | scalar product | skalarprodukt | produit scalaire | 角",
        Function("dot"),
    ),
    ("parallel | cross product | kreuzprodukt | produit vectoriel | 叉积", Function("cross")),
    ("length~ | länge~ | longueur | bogenlänge | 弧长", Function("arc_length")),
    ("largest | maximal~ | maximi~ | greatest | größte~ | 最大", Function("maximum")),
    ("smallest | minimal~ | minimi~ | least | kleinste~ | 最小", Function("minimum")),
    ("double point~ | self intersection~ | doppelpunkt~ | 二重点", Function("double_points")),
    ("symmetric | affine | multiaffine | symmetrisch~ | symétrique", Function("laws")),
    ("curve | kurve | courbe | 曲线", Function("bezier")),
    ("interpolat~ | through | durch | passant | 插值", Function("lagrange")),
    ("elevat~ | erhöh~ | élev~ | 升阶", Function("elevate")),
    ("insert~ | einfüg~ | insér~ | 插入", Function("insert_knots")),
    ("einfügen | einzufügen", Function("insert_knots")),
    ("split~ | subdivi~ | halbier~ | unterteil~ | 细分", Function("subdivide")),
    (
        "partition of unity | sum to 1 | sum to one | add up to 1 | zerlegung der eins | partition de l'unité",
        Write("sum(i=0..3, B_i^3(t)) = 1"),
    ),
    (
        "convert | to powers | to monomial | power basis | umwandeln | umrechn~ | powers | potenz~ | 转换",
        Write("bezier([1, 0, 0, 1])(t)"),
    ),
    ("centroid | schwerpunkt~ | 重心", Write("triangle_patch([0, 1, 3, 2, 1, 4])(1/3, 1/3, 1/3)")),
    ("matrix | matrices | 矩阵", Write("[1, 2; 3, 4]")),
    ("value~ | wert | werte | valeur~ | 值", Write("t^3 - 2t at t = 2")),
    ("basis", Function("bernstein")),
    ("limit~ | grenzwert | limite | 极限", Write("\\lim_{h \\to 0} \\frac{(t+h)^2 - t^2}{h}")),
    ("root~ | zero~ | nullstelle~ | lösung~ | racine~ | solution~ | 根 | 零点", Function("roots")),
    ("satisf~ | such | fulfil~ | so that | sodass | tel que | 使得", Write("solve(a + 3 = 0, a)")),
];

/// What the words of a question, in small letters with single blanks, are about; several words first.
pub(crate) fn advice(text: &str) -> Vec<Advice> {
    let mut found: Vec<(usize, usize, Advice)> = Vec::new();
    for (at, (names, advice)) in TOPICS.iter().enumerate() {
        let words = |name: &str| name.split(' ').count();
        let most = names.split(" | ").filter(|name| stands_in(text, name)).map(words).max();
        found.extend(most.map(|most| (usize::MAX - most, at, *advice)));
    }
    found.sort_by_key(|(words, at, _)| (*words, *at));
    found.into_iter().map(|(_, _, advice)| advice).collect()
}

/// Whether a phrase stands in a text, with any short ending of its words.
fn stands_in(text: &str, name: &str) -> bool {
    if name.chars().any(super::letters::is_ideograph) {
        return text.contains(name);
    }
    let words: Vec<&str> = text.split(' ').collect();
    let own: Vec<&str> = name.split(' ').collect();
    words.windows(own.len()).any(|window| {
        window.iter().zip(&own).all(|(word, name)| match name.strip_suffix('~') {
            Some(stem) => word.strip_prefix(stem).is_some_and(|rest| rest.chars().count() <= ENDING),
            None => word == name,
        })
    })
}

/// The queries among the advice.
#[cfg(test)]
pub(crate) fn queries() -> impl Iterator<Item = &'static str> {
    TOPICS.iter().filter_map(|(_, advice)| match advice {
        Write(query) | Equations(query) => Some(*query),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_with_their_endings() {
        let first = |text: &str| advice(text).first().copied();
        assert_eq!(
            first("schnittpunkte der geraden"),
            Some(Equations("solve([y = x^2, y = 3x - 2], [x, y])"))
        );
        assert!(advice("intermediate").is_empty());
        assert_eq!(
            first("for which k is there a double root"),
            Some(Write("solve(discriminant(x^2 + k x + 9, x) = 0)"))
        );
    }
}
