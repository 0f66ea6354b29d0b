//! What is asked for in words: `polar form of t^3`, `racines de t^2 - 1`, `t^2 的极形式`.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::letters::is_ideograph;
use crate::formula::BigOp;
use crate::language::diagnostic::nearest;

/// What a phrase of a request says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phrase {
    /// A function of the program: polar form.
    Function(&'static str),
    /// A function, by a word that commands it: expand.
    Command(&'static str),
    /// One of the things that a function gives: left part.
    Part(&'static str, i64),
    /// A sum or product.
    Total(BigOp),
    /// A degree: cubic.
    Degree(i64),
    /// How often: second.
    Ordinal(i64),
    /// What follows belongs to a parameter: knots.
    Label(Label),
    /// A function of what stands before and after it: choose.
    Between(&'static str),
    /// What it is a function of follows.
    Of,
    /// Two of a kind.
    And,
    /// One of two.
    Or,
    /// With weights: rational.
    Rational,
    /// A question, or what is claimed: is.
    Is,
    /// Something has a value: equals.
    Equals,
    /// Values are asked for: for which.
    Which,
    /// It says nothing: the, please.
    Filler,
}

/// What a label says of that which follows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Label {
    /// A parameter or the values of names: at.
    At,
    /// An interval, or knots: over.
    Over,
    /// The start of an interval: from.
    From,
    /// Its end, or a degree: to.
    To,
    /// A variable, or the form that is wanted: in.
    In,
    /// A value, a condition or another label: with, for.
    With,
    /// The degree.
    OfDegree,
    /// The knots.
    Knots,
    /// The nodes of an interpolation.
    Nodes,
    /// The values there.
    Values,
    /// The weights.
    Weights,
    /// Control points or coefficients.
    Points,
    /// How often.
    Times,
    /// The number of a member: index.
    Number,
    /// Weights are expected: rational.
    Rational,
}

impl Label {
    /// Whether it gives the names in a formula their values: knots.
    pub(crate) fn names_values(self) -> bool {
        matches!(self, Knots | Nodes | Points)
    }

    /// The function that the same word names: the degree of t^3.
    pub(crate) fn function(self) -> Option<&'static str> {
        Some(match self {
            OfDegree => "degree",
            Knots => "knots",
            Weights => "weights",
            Points => "coefficients",
            _ => return None,
        })
    }
}

use self::Label::*;
use self::Phrase::{And, Between, Command, Degree, Filler, Function, Of, Ordinal};

/// What a word may end with that is declined or in the plural, in any of the languages.
const ENDINGS: &[&str] = &["", "s", "e", "en", "er", "es", "em", "n", "a", "o", "as", "os", "i", "he", "x"];

/// Words that may stand inside of a phrase: insert the knot.
const ARTICLES: &[&str] = &["the", "a", "an", "den", "die", "das", "le", "la", "les", "el", "los"];

/// Phrases, in small letters and between bars; a hyphen or more blanks stand for one blank, `~` for any of the endings.
const PHRASES: &[(Phrase, &str)] = &[
    (
        Function("polar"),
        "polar form~ | polarform~ | blossom~ | polar value~ | forme~ polaire~ | blüte | 极形式 | 开花 | \
         polarization | forma~ polar~",
    ),
    (Command("polar"), "polarize | polarise | polarisiere~ | polariser | polarizar"),
    (Function("diagonal"), "diagonal | diagonale | diagonal value"),
    (
        Function("derivative"),
        "derivative~ | first derivative | ableitung~ | erste~ ableitung | dérivée~ | derivee | 导数 | \
         derivada~ | derivata | tangent | tangent vector | tangentenvektor | vecteur tangent | 切向量 | velocity",
    ),
    (
        Command("derivative"),
        "differentiate | derive | dérive | dériver | differenziere~ | 求导 | derivar | deriva",
    ),
    (
        Function("integrate"),
        "integral~ | antiderivada | antiderivative | indefinite integral | definite integral | stammfunktion | \
         intégrale | primitive | 积分 | 不定积分 | 定积分",
    ),
    (
        Function("integrate"),
        "area under | area below | fläche unter | flächeninhalt unter | aire sous | área bajo | area sotto",
    ),
    (Command("integrate"), "integrate | integriere~ | intègre | intégrer | 求积分 | integrar | integra"),
    (
        Command("expand"),
        "which polynomial has | what polynomial has | welches polynom hat | quel polynôme a | expand | multiply out | multipliziere | développe~ | développer | 展开 | desarrolla | \
         desarrollar | espandi",
    ),
    (
        Command("factor"),
        "factor | factorise | factorize | faktorisiere~ | factoriser | 因式分解 | factoriza | \
         factorizar | fattorizza",
    ),
    (Function("factor"), "factorization | factorisation | prime factorization | faktorisierung"),
    (
        Command("simplify"),
        "simplify | vereinfache~ | simplifie~ | simplifier | 化简 | simplifica~ | simplificar",
    ),
    (
        Command("solve"),
        "solve | löse~ | résous | résoudre | resuelve | resolver | risolvi | 解 | 求解 | solution | solutions | lösungen | lösung",
    ),
    (
        Function("roots"),
        "root~ | real roots | zeros | zeroes | nullstelle~ | racine~ | zéro~ | 零点 | 根 | raíz | raíces | \
         radici | ceros",
    ),
    (
        Function("count_roots"),
        "how many roots has | how many real roots has | how many solutions has | how many real solutions has | \
         how many real zeros has | how many zeros has | how many real roots does | how many roots does | \
         number of roots | number of real roots | number of solutions | number of real solutions | \
         number of real zeros | wie viele nullstellen hat | wie viele lösungen hat | anzahl der nullstellen | \
         combien de racines a | nombre de racines | nombre de racines réelles",
    ),
    (
        Function("least_squares"),
        "least squares | least squares fit | least squares approximation | least squares polynomial | regression | \
         kleinste quadrate | moindres carrés | best fit",
    ),
    (Degree(1), "line | gerade | droite"),
    (
        Function("taylor"),
        "taylor polynomial~ | taylor expansion | taylor series | taylorpolynom~ | polynôme~ de taylor | \
         polinomio de taylor | 泰勒多项式",
    ),
    (Function("discriminant"), "diskriminante | 判别式"),
    (Function("degree"), "polynomial degree"),
    (Function("coefficients"), "power coefficients | koeffizienten der potenzbasis"),
    (Function("coefficient"), "coefficient | koeffizient | coeff | 系数"),
    (
        Function("in_bernstein"),
        "bernstein | bernstein form | bernstein basis | bernstein coefficients | bernstein coeffs | \
         coeficientes de bernstein | coefficienti di bernstein | \
         b form | bézier form | bezier form | bernsteinbasis | bernsteinform | \
         bernstein darstellung | bernstein koeffizienten | bernsteinkoeffizienten | \
         base de bernstein | forme de bernstein | coefficients de bernstein | 伯恩斯坦基 | 伯恩斯坦形式 | \
         bernstein representation | bernstein bézier form | bernstein bezier form",
    ),
    (
        Function("expand"),
        "monomial~ | monomial form | monomial basis | power form | power basis | \
         powers | standard form | monombasis | potenzbasis | potenzform | base canonique | \
         base monomiale | 幂基 | 幂形式 | polynomial form | normal form",
    ),
    (
        Function("bernstein"),
        "bernstein polynomial~ | bernsteinpolynom~ | bernstein polynom~ | polinomio~ de bernstein | \
         polinomio~ di bernstein | bernstein basis polynomials | bernstein basis functions | \
         polynômes de bernstein | polynôme de bernstein | 伯恩斯坦多项式",
    ),
    (
        Function("bezier_points"),
        "bézier point~ | bezier point~ | bézierpunkt~ | bezierpunkt~ | point~ de bézier | puntos de bézier | \
         puntos de bezier | punti di bézier | points de bezier | bezier ordinates | bézierordinaten | \
         bezierordinaten | bézier koeffizient~ | \
         bézier control points | bezier control points | 贝塞尔控制点 | bézier coefficients | \
         bezier coefficients | bézier ordinates | 贝塞尔点",
    ),
    (
        Function("control_points"),
        "control point~ | control polygon | kontrollpunkt~ | point~ de contrôle | 控制点 | steuerpunkt~ | \
         puntos de control | punti di controllo",
    ),
    (
        Function("bezier"),
        "conic | conic section | kegelschnitt | conique | cónica | 二次曲线 | bezier | bézier | bezier curve~ | bézier curve~ | bezierkurve~ | bézierkurve~ | \
         curva~ de bézier | curva~ de bezier | curva~ di bézier | curva~ di bezier | \
         courbe de bézier | courbe de bezier | 贝塞尔曲线 | point on bezier | point on bezier curve | \
         bezier polynomial | bézier polynomial | bezier polygon | bezier segment | bézier segment",
    ),
    (Function("casteljau"), "de casteljau | casteljau | 德卡斯特里奥"),
    (
        Command("elevate"),
        "elevate | raise degree | elevate degree | raise the degree | elevate the degree | degree elevate | \
         degree raise | erhöhe den grad | elevar el grado | 升阶",
    ),
    (
        Function("elevate"),
        "degree elevation | graderhöhung | élévation du degré | élévation de degré | \
         elevación de grado | elevación del grado",
    ),
    (
        Command("reduce"),
        "degree reduce | reduce degree | reduce the degree | lower degree | lower the degree | 降阶",
    ),
    (Function("reduce"), "degree reduction | gradreduktion | réduction du degré | reducción de grado"),
    (
        Command("subdivide"),
        "split | subdivide | unterteile~ | teile | subdivise~ | subdiviser | subdividir | suddividi | 细分 | 分割",
    ),
    (Function("subdivide"), "subdivision | unterteilung | subdivisión"),
    (Function("part"), "restriction | einschränkung | restricción"),
    (Command("reverse"), "reverse"),
    (
        Command("part"),
        "extend | extrapolate | verlängere | prolonger | restrict | beschränke | einschränken | restreindre",
    ),
    (
        Phrase::Part("subdivide", 0),
        "left part | left half | first half | linker teil | linke hälfte | partie gauche",
    ),
    (
        Phrase::Part("subdivide", 1),
        "right part | right half | second half | rechter teil | rechte hälfte | partie droite",
    ),
    (Phrase::Total(BigOp::Sum), "sum | summe | somme | suma | somma"),
    (Phrase::Total(BigOp::Product), "product | produkt | produit"),
    (
        Command("max"),
        "which is bigger | which is larger | which is greater | was ist größer | lequel est plus grand | \
         larger | bigger | greater",
    ),
    (Command("min"), "which is smaller | which is less | was ist kleiner | smaller"),
    (
        Function("raising"),
        "matrix of degree elevation | degree elevation matrix | elevation matrix | degree raising matrix | \
         matrix for degree elevation | graderhöhungsmatrix | matrix der graderhöhung | matrice d'élévation",
    ),
    (
        Function("change_of_basis"),
        "conversion matrix | basis conversion matrix | change of basis matrix | matrix of change of basis | \
         basis change | basis change matrix | transformation matrix | matrix for conversion | basiswechsel | \
         basiswechselmatrix | transformationsmatrix | matrice de passage",
    ),
    (
        Function("polar_tensor"),
        "tensor polar form~ | tensor product polar form~ | tensor product blossom | tensor blossom | \
         tensorprodukt polarform",
    ),
    (Function("hodograph"), "hodograph | hodographe"),
    (Function("curvature"), "krümmung | courbure | 曲率"),
    (
        Function("bspline_basis"),
        "cox de boor | b spline~ | bspline~ | b spline basis function~ | b spline basis | basis function~ | \
         basisfunktion~ | bspline basis function~ | b spline funktion~ | 样条基函数 | b样条",
    ),
    (
        Function("bspline"),
        "nurbs | nurbs curve~ | rational b spline | spline~ | b spline curve~ | spline curve~ | b spline kurve~ | splinekurve~ | courbe b spline | \
         b样条曲线",
    ),
    (
        Function("patch"),
        "tensor product patch | tensor product surface | tensor product bézier patch | bézier patch | \
         bezier patch | bézier surface | bezier surface | bézierfläche | bezierfläche | surface de bézier | \
         tensorproduktfläche | tensor product bezier patch | tensor product bezier surface | bilinear patch",
    ),
    (
        Function("triangle_patch"),
        "triangular bezier patch | triangular bézier patch | bezier triangle | bézier triangle | \
         triangular patch | bézierdreieck | bezierdreieck | triangle de bézier",
    ),
    (
        Function("esym"),
        "elementary symmetric polynomial~ | elementary symmetric function~ | elementarsymmetrisch~ funktion~ | \
         elementarsymmetrisch~ polynom~ | polynôme~ symétrique~ élémentaire~ | \
         fonction~ symétrique~ élémentaire~",
    ),
    (Function("deboor"), "de boor | deboor"),
    (
        Function("greville"),
        "greville abscissae | greville points | greville | greville abszissen | \
         abscisses de greville | abscisas de greville",
    ),
    (Command("insert_knots"), "insert knot | insert knots | knot insertion"),
    (
        Function("lagrange"),
        "interpolation polynomial | interpolating polynomial | lagrange polynomial~ | interpolant~ | \
         polinomio interpolador | polinomio de lagrange | polinomio interpolante | \
         polinomio di lagrange | polynôme de lagrange | lagrange polynom~ | lagrangepolynom~ | \
         polinomio de interpolación | lagrange | \
         interpolationspolynom | polynôme d'interpolation | polynôme interpolateur | 插值多项式 | \
         polynomial through | polynom durch | polynôme passant par | polinomio por | \
         polinomio que pasa por | lagrange interpolation | polynomial interpolation | lagrange interpolation polynomial",
    ),
    (
        Function("hermite"),
        "hermite interpolation | hermite interpolant | hermite polynomial | hermite interpolationspolynom | \
         interpolation d'hermite | polynôme d'hermite | interpolación de hermite",
    ),
    (Command("lagrange"), "interpolate | interpoliere~ | interpole~ | interpoler | interpolar | 插值"),
    (
        Function("newton"),
        "newton polynomial~ | newton form | newton interpolation | newton interpolation polynomial | \
         newton interpolation form | newtonform | polynôme de newton | polinomio de newton | 牛顿插值",
    ),
    (
        Function("divided_differences"),
        "divided differences | newton divided differences | divided difference table | newton divided difference table | \
         newton divided difference | \
         dividierte~ differenz~ | différence~ divisée~ | 差商 | \
         divided difference | diferencia~ dividida~ | differenze divise",
    ),
    (Function("lagrange_basis"), "lagrange basis | lagrange basis polynomial~ | lagrangebasis"),
    (Function("det"), "determinant~ | déterminant | 行列式"),
    (Function("inverse"), "inverse matrix | inverse of matrix | inverse"),
    (Command("inverse"), "invert | invertiere | inverser"),
    (Function("gcd"), "greatest common divisor | ggt | pgcd | 最大公约数 | 最大公因式"),
    (Function("lcm"), "least common multiple | kgv | ppcm | 最小公倍数"),
    (Function("binomial"), "binomial coefficient | binomialkoeffizient"),
    (Between("binomial"), "choose | parmi"),
    (Function("factorial"), "fakultät | factorielle | 阶乘"),
    (Function("sqrt"), "square root | wurzel | quadratwurzel | racine carrée"),
    (Function("resultant"), "resultante"),
    (Function("symmetrize"), "symmetrization"),
    (Command("symmetrize"), "symmetrise | symmetrize | symmetrisiere | symétriser | 对称化"),
    (Degree(1), "linear~ | linéaire~ | 线性"),
    (
        Degree(2),
        "parabola | parabel | parabole | quadratic~ | quadratisch~ | quadratique~ | cuadrátic~ | cuadratic~ | 二次",
    ),
    (Degree(3), "cubic~ | kubisch~ | cubique~ | cúbic~ | 三次"),
    (Degree(4), "quartic~ | quartique~ | cuártic~ | 四次"),
    (
        Ordinal(2),
        "second~ | zweite~ | deuxième~ | segund~ | twice | two times | zweimal | deux fois | dos veces | due volte | 二阶",
    ),
    (
        Ordinal(3),
        "third | dritte~ | troisième~ | tercer~ | terz~ | thrice | three times | dreimal | trois fois | tres veces | 三阶",
    ),
    (Ordinal(1), "once | one | one time | einmal | une fois"),
    (Degree(5), "quintic~ | quintique~ | 五次"),
    (
        Of,
        "of | von | vom | des | der | de | du | d' | de la | de l' | del | de los | de las | di | della | \
         dei | 的",
    ),
    (Phrase::Rational, "rational~ | rationnel~ | rationnelle~ | racional~ | razional~"),
    (Phrase::Is, "is | ist | est | gilt | does | do | stimmt"),
    (
        Phrase::Equals,
        "equals | equal to | is equal to | gleich | ist gleich | égal à | est égal à | es igual a",
    ),
    (Phrase::Which, "for which | for what | für welche~ | pour quel~ | para qué"),
    (And, "and | und | et | 和 | divided by | geteilt durch | divisé par | dividido por"),
    (Phrase::Or, "or | oder | ou"),
    (
        Phrase::Label(At),
        "at | en el punto | nel punto | at parameter | at the parameter | at the point | bei | an der stelle | für t | \
         im punkt | en | au point | 在 | evaluated at | ausgewertet bei | évaluée en | value at | \
         wert bei",
    ),
    (
        Phrase::Label(Over),
        "over | on | on the interval | over the interval | über | auf | im intervall | sur | \
         sur l'intervalle | in the interval | interval | intervall | \
         intervalle | 区间 | sobre | en el intervalo | intervalo | nell'intervallo | intervallo",
    ),
    (Phrase::Label(From), "from | desde | 从 | between | zwischen | entre"),
    (
        Phrase::Label(To),
        "to | hasta | bis | à | jusqu'à | auf grad | into | nach | in die | 到 | 转换为 | 转化为 | dans la | \
         as | as a | regarded as | regarded as a | seen as | seen as a | considered as a | als | comme | \
         写成 | 表示为",
    ),
    (
        Phrase::Label(In),
        "in | with respect to | wrt | w r t | nach der variablen | bezüglich | par rapport à | by | \
         关于",
    ),
    (
        Phrase::Label(With),
        "for | with | where | when | given | für | mit | avec | pour | wobei | con | para | through | durch | \
         passing through | passant par | par | por | zu | zum | donde",
    ),
    (
        Phrase::Label(OfDegree),
        "degree | deg | grad~ | degré~ | vom grad | of degree | de degré | de grado | di grado | \
         du degré | 次数",
    ),
    (
        Phrase::Label(Knots),
        "knots | nudos | nodos | nodi | vector de nudos | knot vector | knot sequence | knoten | knotenvektor~ | knotenfolge | nœuds | noeuds | \
         vecteur nodal | 节点",
    ),
    (Phrase::Label(Nodes), "nodes | node | stützstellen | abscissae | abscissas | abscisses"),
    (Phrase::Label(Values), "values | ordinates | werte | werten | valeurs | valores | valori"),
    (Phrase::Label(Weights), "weights | gewicht~ | poids | pesos | pesi | 权"),
    (
        Phrase::Label(Points),
        "points | coefficients | coeffs | koeffizienten | coeficientes | coefficienti | \
         de boor point~ | punkt~ | puntos | punti | control net | kontrollnetz | net | \
         corners | corner points",
    ),
    (Phrase::Label(Times), "times | mal | fois | veces | volte | 次"),
    (Phrase::Label(Number), "index"),
    (
        Filler,
        "constant | konstante | constante | horner | horner scheme | hornerschema | évalue | évaluer | 值 | 用 | 算法 | \
         the | a | an | its | what is | what's | whats | what are | compute | calculate | find | \
         give | give me | show | show me | list | list all | all | tell me | please | pls | \
         determine | write | express | convert | transform | rewrite | evaluate | value | \
         value of | point | point on | exactly | exact | polynomial | function | curve | curve with | funktion | kurve | \
         polynom | was ist | berechne | bestimme | finde | gib | wandle | schreibe | um | die | \
         das | den | dem | calcule | calculer | calculez | donne | donner | donnez | trouvez | déterminez | détermine | \
         déterminer | trouve | trouver | la | le | les | l' | un | une | convertir | convertis | \
         écrire | quelle est | quel est | courbe | polynôme | svp | bitte | matrix | \
         求 | 计算 | 将 | 把 | 处 | 上 | 处的点 | 处的值 | 请 | 矩阵 | 多项式 | 函数 | 曲线 | 过点 | poly | \
         scheme | schema | schemas | schéma | algorithm | algorithmus | algorithme | algoritmo | \
         wie lautet | how much is | que vaut | combien vaut | cuánto vale | quanto vale | symbolic~ | barycentric~ | barycentric coordinates | calcula | calcular | halla | hallar | encuentra | el | los | las | \
         curva~ | wert | función | polinomio~ | valor | valeur | calcola | trova | qué es | cuál es | \
         form | basis | equation | gleichung | l'équation | 方程 | aus | arguments",
    ),
];

/// The phrases that begin with a word, or with an ideograph.
static BY_START: LazyLock<HashMap<String, Vec<(Phrase, &str)>>> = LazyLock::new(|| {
    let mut found: HashMap<String, Vec<(Phrase, &str)>> = HashMap::new();
    for (phrase, names) in PHRASES {
        for name in names.split(" | ") {
            let start = match name.char_indices().nth(1) {
                Some((second, _)) if name.starts_with(is_ideograph) => name.get(..second),
                _ => name.split(' ').next(),
            };
            for form in forms(start.unwrap_or(name)) {
                found.entry(form).or_default().push((*phrase, name));
            }
        }
    }
    found
});

/// The forms of a word of the table.
fn forms(word: &str) -> Vec<String> {
    match word.strip_suffix('~') {
        Some(stem) => ENDINGS.iter().map(|ending| format!("{stem}{ending}")).collect(),
        None => vec![word.to_owned()],
    }
}

/// Whether words are those of a phrase of the table.
fn says(written: &str, name: &str) -> bool {
    let same = |(written, name): (&str, &str)| match name.strip_suffix('~') {
        Some(stem) => written.strip_prefix(stem).is_some_and(|ending| ENDINGS.contains(&ending)),
        None => written == name,
    };
    written.split(' ').count() == name.split(' ').count() && written.split(' ').zip(name.split(' ')).all(same)
}

/// The phrase at the start of a text, and its length in bytes. Other names of functions are looked up by
/// `function`, with blanks as they stand.
///
/// A phrase ends with a word, but for those of languages that set no blanks.
pub(crate) fn phrase(text: &str, function: &dyn Fn(&str) -> Option<&'static str>) -> Option<(Phrase, usize)> {
    const LONGEST: usize = 5;
    const SHORTEST_NAME: usize = 3;
    if text.starts_with(is_ideograph) {
        let second = text.char_indices().nth(1).map_or(text.len(), |(at, _)| at);
        let listed = BY_START.get(text.get(..second)?)?.iter();
        let (phrase, name) =
            listed.filter(|(_, name)| text.starts_with(name)).max_by_key(|(_, name)| name.len())?;
        return Some((*phrase, name.len()));
    }
    let mut found = None;
    let mut listed: Option<&[(Phrase, &str)]> = None;
    let (mut written, mut short) = (String::new(), String::new());
    let mut at = 0;
    for number in 0..LONGEST {
        let rest = text.get(at..)?;
        let separator: usize =
            rest.chars().take_while(|c| c.is_whitespace() || *c == '-').map(char::len_utf8).sum();
        // w.r.t.
        let separator = if separator == 0 && number > 0 && rest.starts_with('.') { 1 } else { separator };
        if (separator == 0) != (number == 0) || rest.get(..separator)?.contains('\n') {
            break;
        }
        let word = word(rest.get(separator..)?);
        if word.is_empty() {
            break;
        }
        let small: String =
            word.chars().flat_map(char::to_lowercase).map(|c| if c == '’' { '\'' } else { c }).collect();
        if number > 0 {
            written.push(' ');
            if !ARTICLES.contains(&small.as_str()) {
                short.extend([" ", &small]);
            }
        } else {
            short.clone_from(&small);
        }
        written.push_str(&small);
        at += separator + word.len();
        let own = listed.get_or_insert_with(|| BY_START.get(written.as_str()).map_or(&[][..], Vec::as_slice));
        // Most letters of formulas begin no phrase.
        if own.is_empty() && written.len() < SHORTEST_NAME {
            break;
        }
        let article = number > 0 && ARTICLES.contains(&small.as_str());
        let is = |name: &str| says(&written, name) || !article && says(&short, name);
        let known = own.iter().find(|(_, name)| is(name)).map(|(phrase, _)| *phrase);
        let name = || function(&written.replace(' ', "_")).filter(|_| written.len() >= SHORTEST_NAME);
        // A spline of degree 2 is no spline_of.
        let goes_on = found.is_some() && written.ends_with(" of");
        if let Some(phrase) = known.or_else(|| name().filter(|_| !goes_on).map(Function)) {
            found = Some((phrase, at));
        }
    }
    if found.is_some() {
        return found;
    }
    // l'intégrale, d'interpolation
    ["l'", "l’", "d'", "d’"].iter().find_map(|article| {
        let start = text.get(..article.len())?.to_lowercase();
        let of = if start.starts_with('d') { Of } else { Filler };
        (start == *article).then_some((of, article.len()))
    })
}

/// The function that a word names by itself, also at its end where no blanks stand between words.
pub(crate) fn function_named(word: &str) -> Option<&'static str> {
    let joined = word.chars().any(is_ideograph);
    let starts = word.char_indices().map(|(at, _)| at).take(if joined { word.len() } else { 1 });
    starts.filter_map(|at| word.get(at..)).find_map(|rest| match phrase(rest, &|_| None)? {
        (_, length) if length < rest.len() => None,
        (Function(function) | Command(function) | Between(function), _) => Some(function),
        (Phrase::Label(label), _) => label.function(),
        _ => None,
    })
}

/// The phrase of one or two words that somebody may have misspelled with these.
pub(crate) fn misspelled(word: &str, next: &str) -> Option<&'static str> {
    let known = |word: &str| phrase(word, &|_| None).is_some_and(|(_, length)| length == word.len());
    if known(word) {
        return None;
    }
    let named = |phrase: &Phrase| matches!(phrase, Function(_) | Command(_));
    let mut close =
        PHRASES.iter().filter(|(phrase, _)| named(phrase)).flat_map(|(_, names)| names.split(" | "));
    close.find(|name| {
        let stem = name.trim_end_matches('~');
        match stem.split_once(' ') {
            Some((first, second)) => second == next && first != word && nearest(word, [first]).is_some(),
            None => word.len() > SHORTEST_MISSPELLED && stem != word && nearest(word, [stem]).is_some(),
        }
    })
}

/// Shorter words are close to many.
const SHORTEST_MISSPELLED: usize = 5;

/// The word at the start of a text: letters, and apostrophes between them.
fn word(text: &str) -> &str {
    let letter = |c: char| c.is_alphabetic() && !is_ideograph(c);
    let mut end = 0;
    let mut chars = text.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let inside =
            matches!(c, '\'' | '’') && end > 0 && chars.peek().is_some_and(|(_, next)| letter(*next));
        if !(letter(c) || inside) {
            break;
        }
        end = at + c.len_utf8();
    }
    text.get(..end).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_phrase_stands_twice() {
        let mut seen = std::collections::BTreeSet::new();
        for name in PHRASES.iter().flat_map(|(_, names)| names.split(" | ")) {
            let words = name.split(' ').map(forms);
            let all = words.fold(vec![String::new()], |starts, forms| {
                starts
                    .iter()
                    .flat_map(|start| forms.iter().map(move |form| format!("{start} {form}")))
                    .collect()
            });
            for form in all {
                assert!(seen.insert(form.clone()), "{form}");
            }
        }
    }
}
