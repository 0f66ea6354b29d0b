//! Words that mean something in other systems or in prose, and what to write for them here.

use super::phrases;

/// Functions that somebody may expect that have no exact rational values.
const TRANSCENDENTAL: &[&str] = &[
    "sqrt", "root", "sin", "cos", "tan", "cot", "sec", "csc", "exp", "log", "ln", "lg", "sinh", "cosh",
    "tanh", "arcsin", "arccos", "arctan", "asin", "acos", "atan", "tg", "ctg", "arctg",
];

/// Functions of linear algebra and of numbers that pages write as words.
const OF_OBJECTS: &[&str] = &[
    "det", "tr", "rank", "rang", "dim", "ker", "deg", "grad", "gcd", "lcm", "ggT", "pgcd", "sgn", "arg",
    "max", "min", "sup", "inf", "inner", "norm", "abs",
];

/// Whether a word is a function everywhere, so that no formula for a value of it says what it is.
pub fn is_function_word(word: &str) -> bool {
    TRANSCENDENTAL.contains(&word) || OF_OBJECTS.contains(&word)
}

/// What is said of sets.
const SETS: &str = "sets have no value; a list is written [1, 2, 3], an interval as claims a <= t and t <= b";

/// What is said of quantifiers.
const QUANTIFIED: &str = "a claim for all values is written x^2 - 2x + 4 > 0 for all x, an equation for some is solved by solve(x^2 = 4)";

/// What is said of decimal places.
const EXACT: &str =
    "numbers stay exact; roots(x^2 - 2, width=1/1000) makes the interval around a root shorter";

/// What is said of searches for roots.
const ISOLATED: &str = "real roots are isolated exactly by roots(x^3 - 2)";

/// Words and what to write for them.
const ELSEWHERE: &[(&str, &str)] = &[
    ("let", "a definition is written x := 3"),
    ("def", "a function is defined by F(t) := t^2"),
    ("var", "a name needs no declaration; a definition is written x := 3"),
    ("set", "a definition is written x := 3"),
    ("where", "what follows gives names their values: t^2 where t = 2"),
    ("with", "what follows gives names their values: t^2 with t = 2"),
    ("for", "what follows gives names their values or says where a claim holds: t^2 <= t for 0 <= t <= 1"),
    ("and", "write two statements, with ';' between them"),
    ("or", "write two statements, with ';' between them"),
    ("is", "claims are written with =, !=, <, <=, > or >="),
    ("the", "words are not read; write a formula"),
    ("lim", "a limit is written in LaTeX: \\lim_{t \\to 0} t^2"),
    ("eval", "write the formula alone, or F(2) for a value of F"),
    ("print", "write the formula alone"),
    ("compute", "write the formula alone"),
    ("calculate", "write the formula alone"),
    ("evaluate", "write the formula alone, or t^2 at t = 2"),
    ("find", "equations are solved by solve(2t = 1)"),
    ("berechne", "write the formula alone"),
    ("calculer", "write the formula alone"),
    ("minus", "an exponent of several characters needs braces: t^{-1}"),
    ("plus", "an exponent of several characters needs braces: t^{-1}"),
    ("dt", "a derivative is written diff(F, t) or d/dt F"),
    ("dx", "a derivative is written diff(F, x) or d/dx F"),
    ("help", "polarform functions lists the functions; :help at the prompt"),
    ("quit", "leave the prompt with :quit"),
    ("exit", "leave the prompt with :quit"),
    ("limit", "a limit is written in LaTeX: \\lim_{t \\to 0} t^2"),
    ("plot", "figures are drawn by polarform figure, for example figure_functions([t^2], 0, 1)"),
    ("rightopen", "intervals have no value; write a <= t and t < b as claims"),
    ("leftopen", "intervals have no value; write a < t and t <= b as claims"),
    ("vars", "the names are listed by :vars at the prompt"),
    ("who", "the names are listed by :vars at the prompt"),
    ("clear", ":forget NAME takes a name away at the prompt, :reset all of them"),
    ("del", ":forget NAME takes a name away at the prompt"),
    ("save", "a session is saved by :save FILE at the prompt"),
    ("load", "a script is run by :load FILE at the prompt, or by polarform run FILE"),
    ("draw", "figures are drawn by polarform figure, for example figure_functions([t^2], 0, 1)"),
    ("not", "claims are negated with !=, and with the other inequality"),
    ("infty", "infinite sums are not computed; put in a number"),
    ("löse", "equations are solved by solve(2t = 1)"),
    ("résoudre", "equations are solved by solve(2t = 1)"),
    ("cup", SETS),
    ("cap", SETS),
    ("setminus", SETS),
    ("emptyset", SETS),
    ("inner", "the scalar product is dot([1, 2], [3, 4])"),
    ("syms", "a name needs no declaration; a definition is written x := 3"),
    ("symbols", "a name needs no declaration; a definition is written x := 3"),
    ("import", "nothing needs to be imported; polarform functions lists the functions"),
    ("series", "a polynomial around a is in_powers(F, a)"),
    ("mean", "the mean of two points is (a + b)/2"),
    ("matrix", "a matrix is written [1, 2; 3, 4]; those between bases are change_of_basis(...)"),
    ("polyval", "a value of a polynomial is written t^3 - 2t + 5 at t = 3"),
    ("conv", "a product of polynomials is written (t + 2)(t + 3); coefficients(F) lists its coefficients"),
    ("ones", "a matrix of ones with its numbers of rows and columns is ones(2, 2), a list [1 for i = 1..2]"),
    (
        "zeros",
        "a matrix of zeros with its numbers of rows and columns is zeros(2, 2), the roots of F are roots(F)",
    ),
    ("nPr", "the number of arrangements is n!/(n-k)!, that of choices binomial(n, k)"),
    ("ast", "a star for an argument has no value: write the function alone, f"),
    ("cdot", "a dot for an argument has no value: write the function alone, f"),
    ("kron", "products of matrices are A B and tensor products of polynomials polar_tensor(F)"),
    ("odd", "a claim says the same: F(-t) = -F(t)"),
    ("even", "a claim says the same: F(-t) = F(t)"),
    ("Reduce", QUANTIFIED),
    ("reduce_inequalities", QUANTIFIED),
    ("ForAll", QUANTIFIED),
    ("Exists", QUANTIFIED),
    ("Resolve", QUANTIFIED),
    ("FindInstance", QUANTIFIED),
    ("apart", "partial fractions are not computed; quotient(F, G) and remainder(F, G) divide"),
    ("parfrac", "partial fractions are not computed; quotient(F, G) and remainder(F, G) divide"),
    ("evalf", EXACT),
    ("vpa", EXACT),
    ("fsolve", ISOLATED),
    ("FindRoot", ISOLATED),
    ("nroots", ISOLATED),
    ("fzero", ISOLATED),
    ("BSplineFunction", "write bspline(2, [0, 0, 0, 1, 1, 1], [1, 3, 2]) with the degree and all knots"),
    ("BSplineCurve", "write bspline(2, [0, 0, 0, 1, 1, 1], [1, 3, 2]) with the degree and all knots"),
    ("log2", "only polynomials and rational functions with rational coefficients are exact here"),
];

/// Words of prose that may stand among factors, with what to write instead if the words beside them do
/// not tell.
const PROSE: &[(&str, &str)] = &[
    ("of", ""),
    ("the", ""),
    ("at", "a value is F(2) for a function F, or t^2 at t = 2"),
    ("in", ""),
    ("is", "claims are written with =, !=, <, <=, > or >="),
    ("are", "claims are written with =, !=, <, <=, > or >="),
    ("has", "claims are written with =, !=, <, <=, > or >="),
    ("from", ""),
    ("to", ""),
    ("by", ""),
    ("for", ""),
    ("where", ""),
    ("with", ""),
    ("on", ""),
    ("over", ""),
    ("form", ""),
    ("basis", ""),
    ("polynomial", ""),
    ("polynomials", ""),
    ("curve", ""),
    ("points", ""),
    ("between", ""),
    ("through", ""),
    ("choose", ""),
    ("non", ""),
    ("pas", ""),
    ("von", ""),
    ("für", ""),
    ("bei", "a value is F(2) for a function F, or subs(t^2, t=2)"),
    ("mit", ""),
    ("mal", "write * for a product"),
    ("de", ""),
    ("du", ""),
    ("en", "a value is F(2) for a function F, or subs(t^2, t=2)"),
    ("pour", ""),
    ("avec", ""),
    ("sur", ""),
];

/// What a word of a question is about, as a function, if it is no phrase of requests.
const TOPICS: &[(&str, &str)] = &[
    ("symmetric", "laws"),
    ("affine", "laws"),
    ("multiaffine", "laws"),
    ("value", "subs"),
    ("curve", "bezier"),
    ("basis", "bernstein"),
    ("interpolation", "lagrange"),
    ("elevation", "elevate"),
    ("insertion", "insert_knots"),
];

/// What to write instead of a word of prose; empty if the words beside it have to tell.
pub(crate) fn prose(word: &str) -> Option<&'static str> {
    let word = without_capital(word);
    PROSE.iter().find(|(known, _)| *known == word).map(|(_, advice)| *advice)
}

/// Whether a word only stands between two statements.
pub(crate) fn joins_statements(word: &str) -> bool {
    aside(word.trim()) == Some(Aside::Joint)
}

/// What a word beside a formula says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aside {
    /// A condition follows: for, where.
    Condition,
    /// All values are meant: every.
    Every,
    /// Both: ∀.
    ForAll,
    /// Two of a kind: and.
    Joint,
    /// A definition follows: let.
    Let,
    /// It is asked: is … ?
    Question,
}

/// The words of conditions and definitions in one language, beside a formula of a query and of a page.
pub(crate) struct Conditions {
    /// Before a case: for, if.
    pub(crate) cases: &'static [&'static str],
    /// Before what a name stands for: where.
    pub(crate) values: &'static [&'static str],
    /// Before a definition: let.
    pub(crate) definitions: &'static [&'static str],
}

pub(crate) const ENGLISH: Conditions = Conditions {
    cases: &[
        "if",
        "for",
        "when",
        "whenever",
        "provided",
        "at",
        "setting",
        "putting",
        "taking",
        "letting",
        "choosing",
        "inserting",
        "substituting",
    ],
    values: &["where", "with"],
    definitions: &["let"],
};

pub(crate) const GERMAN: Conditions = Conditions {
    cases: &["wenn", "falls", "sobald", "für", "bei"],
    values: &["wobei", "mit"],
    definitions: &["sei", "seien"],
};

pub(crate) const FRENCH: Conditions = Conditions {
    cases: &["si", "lorsque", "quand", "pour"],
    values: &["où", "avec"],
    definitions: &["soit", "soient"],
};

pub(crate) const CHINESE: Conditions =
    Conditions {
        cases: &["若", "如果", "当", "对", "对于"], values: &["其中"], definitions: &["设", "令"]
    };

/// A word of queries alone.
const GIVEN: &str = "given";

const ASIDES: &[(Aside, &[&str])] = &[
    (
        Aside::Every,
        &[
            "all", "every", "any", "each", "alle", "jedes", "jeden", "tout", "tous", "toute", "toutes",
            "chaque", "所有", "任意", "real", "reals", "numbers", "zahlen", "nombres", "reellen", "réel",
            "réels", "réelle", "实数",
        ],
    ),
    (Aside::ForAll, &["\\forall", "∀"]),
    (Aside::Joint, &["and", "und", "et", "且", "和", "及", "时", "puis"]),
    (Aside::Question, &["is", "ist", "gilt", "stimmt", "?", "？"]),
];

/// What a word says that stands beside a formula.
pub(crate) fn aside(word: &str) -> Option<Aside> {
    let small = match word.chars().skip(1).all(char::is_lowercase) {
        true => word.to_lowercase(),
        false => word.to_owned(),
    };
    let small = small.as_str();
    let conditions = [ENGLISH, GERMAN, FRENCH, CHINESE];
    if small == GIVEN
        || conditions.iter().any(|own| own.cases.contains(&small) || own.values.contains(&small))
    {
        return Some(Aside::Condition);
    }
    if conditions.iter().any(|own| own.definitions.contains(&small)) {
        return Some(Aside::Let);
    }
    ASIDES.iter().find(|(_, words)| words.contains(&small)).map(|(aside, _)| *aside)
}

/// Whether a text begins with the word of a question: Is.
pub(crate) fn is_question(text: &str) -> bool {
    let word: String = text.chars().take_while(|c| c.is_alphabetic()).collect();
    aside(&word) == Some(Aside::Question)
}

/// Whether an interval may stand behind a word, through which the variable of a claim runs: on.
pub(crate) fn is_before_interval(word: &str) -> bool {
    ["on", "over", "auf", "sur"].contains(&word)
}

/// Whether a word is a sign with bounds below it, written without its backslash: `sum_{i=0}^n`, not `sum_rules`.
pub(crate) fn is_sign_with_bounds(word: &str, after: &str) -> bool {
    let mut next = after.strip_prefix('_').unwrap_or_default().chars();
    let bound = match next.next() {
        Some('{') => true,
        Some(first) => first.is_alphanumeric() && !next.next().is_some_and(|c| c.is_alphabetic() || c == '_'),
        None => false,
    };
    bound && ["sum", "prod", "int"].contains(&word)
}

/// Whether a command sets words in a formula: `\text`.
pub(crate) fn is_text_command(command: &str) -> bool {
    ["\\text", "\\textrm", "\\textit", "\\textnormal", "\\mathrm", "\\mbox", "\\hbox", "\\operatorname"]
        .contains(&command)
}

/// The function that a word of a question is about.
pub(crate) fn topic(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    let listed = TOPICS.iter().find(|(known, _)| *known == lower).map(|(_, function)| *function);
    listed.or_else(|| phrases::function_named(&lower))
}

/// Names whose calls have a form of their own.
pub const FORMS: &[(&str, &str)] = &[
    ("sum", "sum(k=1..4, k^2)"),
    ("prod", "prod(k=1..4, k)"),
    ("product", "product(k=1..4, k)"),
    ("union", "union(i=1..3, A_i)"),
    ("intersection", "intersection(i=1..3, A_i)"),
    ("integral", "integral(t^2, t=0..1)"),
    ("int", "integral(t^2, t=0..1)"),
    ("binom", "binomial(5, 2)"),
    ("cases", "cases(t^2 if t < 1, 2t - 1 otherwise)"),
    ("hat", "hat(1)"),
    ("vec", "vec(d)"),
    ("bar", "bar(z)"),
    ("tilde", "tilde(z)"),
    ("ddot", "ddot(F)"),
    ("bold", "bold(b)"),
    ("abs", "abs(x)"),
    ("norm", "norm(x)"),
    ("floor", "floor(x)"),
    ("ceil", "ceil(x)"),
];

/// How a name is called whose calls have a form of their own.
pub fn form(name: &str) -> Option<&'static str> {
    FORMS.iter().find(|(known, _)| *known == name).map(|(_, form)| *form)
}

/// What to write for a word that is known elsewhere; `None` if it is not.
///
/// ```
/// use polarform::language::lexicon::words::elsewhere;
/// assert!(elsewhere("sin").unwrap().starts_with("only polynomials"));
/// assert!(elsewhere("let").unwrap().contains(":="));
/// assert_eq!(elsewhere("uvw"), None);
/// ```
pub fn elsewhere(word: &str) -> Option<&'static str> {
    if is_foreign_function(word) {
        return Some("only polynomials and rational functions with rational coefficients are exact here");
    }
    let small = without_capital(word);
    ELSEWHERE.iter().find(|(known, _)| *known == small || *known == word).map(|(_, advice)| *advice)
}

/// A word at the beginning of a sentence: Let, Set. Two letters are more likely names: Of, At.
fn without_capital(word: &str) -> String {
    let small = word.chars().skip(1).all(char::is_lowercase);
    if small && word.len() > 2 { word.to_lowercase() } else { word.to_owned() }
}

/// Whether a word is a function that has no exact rational values.
pub fn is_foreign_function(word: &str) -> bool {
    TRANSCENDENTAL.contains(&word)
}

/// Whether a word belongs to sentences: no name is called so.
pub(crate) fn is_prose(word: &str) -> bool {
    prose(word).is_some() || aside(word).is_some() || word.chars().count() > 3
}
