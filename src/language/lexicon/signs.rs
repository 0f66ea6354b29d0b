//! Words of claims about the sign or the shape of a function on a region: `prove F >= 0 on [0, 1]`, `t^3 is increasing on [0, 2]`.

use super::{asking, words};
use crate::formula::Rel;

/// Words before what is to be shown, beside those of sentences.
const TASKS: &[&str] = &["certify", "is", "are", "ist", "sind", "gilt", "est"];

/// Words between a function and what is said of it.
const COPULAS: &[&str] = &[
    "is", "are", "stays", "remains", "ist", "sind", "bleibt", "est", "reste", "est-il", "est-elle", "è",
    "es", "是", "为",
];

/// Words that say that no value is left out, which a claim says anyway.
const ALWAYS: &[&str] = &[
    "always",
    "everywhere",
    "immer",
    "überall",
    "stets",
    "toujours",
    "partout",
    "siempre",
    "sempre",
    "恒",
    "总",
    "恒为",
    "总是",
];

/// Words between a claim and its region.
const PLACES: &[&str] = &[" on ", " over ", " auf ", " sur ", " in ", " 在 "];

/// Words before a region.
const REGIONS: &[&str] = &[
    "the interval ",
    "the box ",
    "the square ",
    "the cube ",
    "the rectangle ",
    "the triangle ",
    "the tetrahedron ",
    "triangle ",
    "tetrahedron ",
    "interval ",
    "box ",
    "dem intervall ",
    "l'intervalle ",
    "区间 ",
    "dem dreieck ",
];

/// What is claimed of a function: a sign of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The order of the derivative.
    pub order: usize,
    /// How it is related to 0.
    pub sign: &'static str,
}

impl Shape {
    /// Whether it is not positive, in place of not negative.
    pub(crate) fn is_turned(self) -> bool {
        self.sign.starts_with('<')
    }

    /// Whether it is said that the function is monotone, but not in which direction.
    pub(crate) fn has_no_direction(self) -> bool {
        self.sign == MONOTONE
    }

    /// The same with its direction.
    pub(crate) fn in_direction(self, falls: bool) -> Shape {
        Shape { sign: if falls { "<=" } else { ">=" }, ..self }
    }

    /// The relation to 0.
    pub(crate) fn relation(self) -> Rel {
        match self.sign {
            ">" => Rel::Gt,
            "<" => Rel::Lt,
            ">=" => Rel::Ge,
            "<=" => Rel::Le,
            "!=" => Rel::Ne,
            _ => Rel::Eq,
        }
    }

    /// Whether it is a claim of its own, not the one that a certificate shows.
    pub(crate) fn is_strict(self) -> bool {
        !matches!(self.sign, "<=" | ">=")
    }
}

/// One of the two directions, which is not said.
const MONOTONE: &str = "<=>";

/// What is said of functions, in all languages; each with a sign of a derivative.
const SHAPES: &[(usize, &str, &[&str])] = &[
    (
        0,
        ">",
        &[
            "positive",
            "strictly positive",
            "positiv",
            "strikt positiv",
            "echt positiv",
            "positif",
            "strictement positive",
            "strictement positif",
            "positivo",
            "positiva",
            "正",
            "正的",
            "正数",
        ],
    ),
    (
        0,
        "<",
        &[
            "negative",
            "strictly negative",
            "negativ",
            "strikt negativ",
            "echt negativ",
            "négatif",
            "négative",
            "strictement négatif",
            "strictement négative",
            "negativo",
            "negativa",
            "负",
            "负的",
            "负数",
        ],
    ),
    (
        0,
        ">=",
        &[
            "nonnegative",
            "non-negative",
            "not negative",
            "positiv oder null",
            "positive or zero",
            "nicht negativ",
            "nichtnegativ",
            "positif ou nul",
            "positive ou nulle",
            "非负",
            "非负的",
        ],
    ),
    (
        0,
        "<=",
        &[
            "nonpositive",
            "non-positive",
            "not positive",
            "negative or zero",
            "negativ oder null",
            "nicht positiv",
            "nichtpositiv",
            "négatif ou nul",
            "négative ou nulle",
            "非正",
        ],
    ),
    (0, "=", &["zero", "identically zero", "null", "gleich null", "nul", "nulle", "cero", "零"]),
    (
        0,
        "!=",
        &[
            "nonzero",
            "non-zero",
            "never zero",
            "not zero",
            "nie null",
            "non nul",
            "non nulle",
            "jamais nul",
            "jamais nulle",
            "非零",
        ],
    ),
    (
        1,
        MONOTONE,
        &[
            "monotone",
            "monotonic",
            "monotonous",
            "monoton",
            "monotonically",
            "monotono",
            "monotona",
            "monótono",
            "monótona",
            "monótone",
            "单调",
            "单调的",
        ],
    ),
    (
        1,
        ">=",
        &[
            "monotonically increasing",
            "monotone increasing",
            "increasing",
            "nondecreasing",
            "non-decreasing",
            "monoton wachsend",
            "monoton steigend",
            "wachsend",
            "steigend",
            "croissante",
            "croissant",
            "creciente",
            "crescente",
            "递增",
            "单调递增",
            "递增的",
        ],
    ),
    (
        1,
        "<=",
        &[
            "monotonically decreasing",
            "monotone decreasing",
            "decreasing",
            "nonincreasing",
            "non-increasing",
            "monoton fallend",
            "fallend",
            "décroissante",
            "décroissant",
            "decreciente",
            "decrescente",
            "递减",
            "单调递减",
            "递减的",
        ],
    ),
    (2, ">=", &["convex", "konvex", "convexe", "convexa", "convesso", "convessa", "凸", "凸的", "凸函数"]),
    (2, "<=", &["concave", "konkav", "cóncava", "concava", "凹", "凹的", "凹函数"]),
];

/// A claim taken apart; places are bytes of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SignClaim {
    /// Whether a word asks for a proof.
    pub asked: bool,
    /// The function or inequality.
    pub claim: (usize, usize),
    /// What is said of the function; `None` for an inequality.
    pub shape: Option<Shape>,
    /// The region.
    pub region: Option<(usize, usize)>,
    /// For which values it is said: for all t.
    pub condition: Option<(usize, usize)>,
}

/// What stands for an object that was described before, in claims about it.
const PRONOUNS: &[&str] = &[
    "it",
    "this",
    "the curve",
    "the polynomial",
    "the function",
    "the spline",
    "the parabola",
    "the cubic",
    "the quadratic",
    "the bezier curve",
    "the bézier curve",
    "the graph",
    "er",
    "sie",
    "es",
    "die kurve",
    "das polynom",
    "die funktion",
    "la courbe",
    "le polynôme",
    "la fonction",
    "elle",
    "il",
    "la curva",
    "el polinomio",
    "la función",
    "il polinomio",
    "la funzione",
    "曲线",
    "它",
    "多项式",
    "函数",
];

/// Whether what is claimed to be something is an object that was described before.
pub(crate) fn is_pronoun(claim: &str) -> bool {
    PRONOUNS.contains(&claim.trim().to_lowercase().as_str())
}

/// A text as a claim about signs; whether its parts are formulas is not asked.
pub(crate) fn sign_claim(text: &str) -> Option<SignClaim> {
    let lower = text.to_ascii_lowercase();
    let end =
        text.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '?' | '.' | '？' | '。')).len();
    let start = text.len() - text.trim_start().len();
    let (begin, asked) = after_task(&lower, start);
    let body = lower.get(begin..end)?;
    let said = adjective(body, asked);
    let (claim_end, shape, behind) = match said {
        Some((length, shape, behind)) => (begin + length, Some(shape), Some(begin + behind)),
        None => (end, None, None),
    };
    // A region behind the claim, or before what is said of the function: F auf [0, 1] positiv.
    let place = |from: usize, to: usize| -> Option<(usize, usize)> {
        let piece = lower.get(from..to)?;
        let found = PLACES.iter().filter_map(|word| {
            let own =
                if piece.starts_with(word.trim_start()) && from > begin { 0 } else { piece.rfind(word)? };
            Some((own, own + word.len() - usize::from(own == 0 && piece.starts_with(word.trim_start()))))
        });
        let (at, length) = found.max()?;
        let mut inside = from + length;
        let named =
            REGIONS.iter().filter(|word| lower.get(inside..).is_some_and(|rest| rest.starts_with(**word)));
        inside += named.map(|word| word.len()).max().unwrap_or(0);
        let bracket = lower.get(inside..to)?.trim_start().starts_with(['[', '(']);
        bracket.then_some((from + at, inside))
    };
    let tail = behind.map(|behind| {
        behind + (lower.get(behind..end).map_or(0, |rest| rest.len() - rest.trim_start().len()))
    });
    let (claim_end, region, condition) = match tail {
        Some(tail) if tail < end => match place(tail, end) {
            Some((at, inside)) if at == tail => (claim_end, Some((inside, end)), None),
            _ if is_condition(text.get(tail..end)?) => (claim_end, None, Some((tail, end))),
            _ => return None,
        },
        Some(_) | None => match place(begin, claim_end) {
            Some((at, inside)) => (at, Some((inside, claim_end)), None),
            None => (claim_end, None, None),
        },
    };
    let claim = (begin, begin + text.get(begin..claim_end)?.trim_end().len());
    if shape.is_none() && region.is_none() || claim.0 >= claim.1 {
        return None;
    }
    Some(SignClaim { asked, claim, shape, region, condition })
}

/// The place behind words that ask, and whether there are some.
fn after_task(text: &str, start: usize) -> (usize, bool) {
    let rest = text.get(start..).unwrap_or_default();
    let length = asking::asks(rest).filter(|found| found.claims).map(|found| found.length);
    let own = TASKS.iter().filter(|task| rest.starts_with(**task)).map(|task| task.len()).max();
    match length.max(own) {
        Some(length) if rest.get(length..).is_some_and(|rest| rest.starts_with(' ')) => {
            (start + length + 1, true)
        }
        _ => (start, false),
    }
}

/// What is said of a function: the length of its formula, the shape, and where the rest begins.
fn adjective(body: &str, asked: bool) -> Option<(usize, Shape, usize)> {
    let mut best: Option<(usize, Shape, usize)> = None;
    for (order, sign, words) in SHAPES {
        for word in *words {
            for (at, _) in body.match_indices(word) {
                let end = at + word.len();
                let ideograph = word.chars().all(super::letters::is_ideograph);
                let apart =
                    ideograph || !body.get(end..).is_some_and(|rest| rest.starts_with(char::is_alphanumeric));
                let Some(head) = body
                    .get(..at)
                    .filter(|_| apart)
                    .and_then(|head| before_adjective(head, asked, ideograph))
                else {
                    continue;
                };
                // The longest of the words that fit: not negative.
                if best.is_none_or(|(_, _, other)| end > other)
                    || best.is_some_and(|(length, _, other)| end == other && head < length)
                {
                    best = Some((head, Shape { order: *order, sign }, end));
                }
            }
        }
    }
    best
}

/// The length of what stands before a copula, or before an adjective if a word asks at the start.
fn before_adjective(head: &str, asked: bool, ideograph: bool) -> Option<usize> {
    let mut rest = head.trim_end();
    if rest.len() == head.len() && !ideograph {
        return None;
    }
    let stripped = |rest: &str, words: &[&str]| {
        let found = words.iter().filter_map(|word| {
            let before = rest.strip_suffix(word)?;
            let own = word.chars().all(super::letters::is_ideograph);
            (own || before.ends_with(char::is_whitespace)).then_some(before.trim_end().len())
        });
        found.min()
    };
    while let Some(length) = stripped(rest, ALWAYS) {
        rest = rest.get(..length)?;
    }
    let copula = stripped(rest, COPULAS);
    let shorter = rest.len() < head.trim_end().len();
    copula.or((asked || shorter).then_some(rest.len())).filter(|length| *length > 0)
}

/// Whether a text begins with a word of conditions.
fn is_condition(text: &str) -> bool {
    let word: String = text.trim_start().chars().take_while(|c| c.is_alphabetic()).collect();
    words::aside(&word) == Some(words::Aside::Condition)
}

/// The parts of a region: `[0, 1] x [0, 2]` has two.
pub(crate) fn factors(region: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut from = 0;
    for (at, word) in region.char_indices().filter_map(|(at, _)| {
        let rest = region.get(at..)?;
        ["\\times", " x ", "x[", "×", " × "]
            .into_iter()
            .find(|word| rest.starts_with(word))
            .map(|word| (at, word))
    }) {
        if at >= from {
            found.push((from, at));
            from = at + word.trim_end_matches('[').len();
        }
    }
    found.push((from, region.len()));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn claims_are_taken_apart() {
        let parts = |text: &str| {
            sign_claim(text).map(|found| {
                let of = |(a, b): (usize, usize)| text[a..b].trim().to_owned();
                (
                    found.asked,
                    of(found.claim),
                    found.shape.map(|s| (s.order, s.is_turned())),
                    found.region.map(of),
                )
            })
        };
        let some = |asked, claim: &str, shape, region: Option<&str>| {
            Some((asked, claim.to_owned(), shape, region.map(str::to_owned)))
        };
        assert_eq!(parts("prove t^2 >= 0 on [0, 1]"), some(true, "t^2 >= 0", None, Some("[0, 1]")));
        assert_eq!(
            parts("t^3 is convex over the interval [0, 1]"),
            some(false, "t^3", Some((2, false)), Some("[0, 1]"))
        );
        assert_eq!(parts("is t^3 concave on [-1, 0]?"), some(true, "t^3", Some((2, true)), Some("[-1, 0]")));
        assert_eq!(
            parts("show that t^4 is nondecreasing on [0, 1]."),
            some(true, "t^4", Some((1, false)), Some("[0, 1]"))
        );
        assert_eq!(
            parts("x + y <= 1 on the triangle (0,0), (1,0), (0,1)"),
            some(false, "x + y <= 1", None, Some("(0,0), (1,0), (0,1)"))
        );
        assert_eq!(
            parts("Ist t^2 - t auf [0, 1] immer positiv?"),
            some(true, "t^2 - t", Some((0, false)), Some("[0, 1]"))
        );
        assert_eq!(
            parts("t^2 est-il positif sur [0, 1] ?"),
            some(false, "t^2", Some((0, false)), Some("[0, 1]"))
        );
        assert_eq!(parts("is t^2 + 1 always positive?"), some(true, "t^2 + 1", Some((0, false)), None));
        assert_eq!(parts("t^2 is not negative for all t"), some(false, "t^2", Some((0, false)), None));
        assert_eq!(parts("t^2 + 1"), None);
        assert_eq!(parts("derivative of t^3 on t"), None);
        assert_eq!(factors("[0, 1] x [0, 2]"), [(0, 6), (9, 15)]);
    }
}
