//! Words of sentences around what is defined, asked and claimed: let, what is, show that, such that, `Claim:`.

/// How a name is said to be something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Copula {
    /// A sign: =.
    Sign,
    /// A word: is, be.
    Word,
}

/// Words before a definition.
const INTRODUCTIONS: &[&str] = &[
    "let",
    "if",
    "given",
    "given that",
    "gegeben",
    "gegeben sei",
    "gegeben ist",
    "étant donné",
    "on donne",
    "dado",
    "dada",
    "dato",
    "已知",
    "给定",
    "suppose",
    "suppose that",
    "assume",
    "sei",
    "es sei",
    "wenn",
    "falls",
    "soit",
    "si",
    "sea",
    "sia",
    "se",
    "supongamos que",
    "supposons que",
    "angenommen",
    "where",
    "wobei",
    "où",
    "设",
    "令",
    "若",
];

/// Words between a name and what it is.
const COPULAS: &[&str] = &[
    "be",
    "is",
    "denote",
    "denotes",
    "sei",
    "ist",
    "bezeichne",
    "soit",
    "est",
    "es",
    "sea",
    "è",
    "sia",
    "为",
    "是",
];

/// Words before what is asked after a definition.
const CONTINUATIONS: &[&str] = &[
    "then",
    "so",
    "solve for",
    "löse nach",
    "résoudre pour",
    "resuelve para",
    "risolvi per",
    "what is",
    "what's",
    "what are",
    "find",
    "compute",
    "calculate",
    "determine",
    "evaluate",
    "dann",
    "was ist",
    "berechne",
    "bestimme",
    "alors",
    "que vaut",
    "combien vaut",
    "calculer",
    "calcule",
    "entonces",
    "calcula",
    "cuánto vale",
    "cuál es",
    "allora",
    "calcola",
    "quanto vale",
    "calculez",
    "déterminer",
    "déterminez",
    "trouver",
    "trouvez",
    "donner",
    "donnez",
    "quelle est",
    "quel est",
    "halla",
    "trova",
    "give",
    "gib",
    "wie lautet",
    "gesucht",
    "gesucht ist",
    "how much is",
    "wie viel ist",
    "wie groß ist",
    "puis",
    "danach",
    "和",
    "求",
    "计算",
    "and",
];

/// The length of the word with which a text begins, if it introduces a definition.
pub(crate) fn introduces(text: &str) -> Option<usize> {
    starts_with_one_of(text, INTRODUCTIONS)
}

/// The sign or word by which a name is said to be something.
pub(crate) fn copula(text: &str) -> Option<(Copula, usize)> {
    let sign = [":=", "="].into_iter().find(|sign| text.starts_with(sign) && !text.starts_with("=="));
    match sign {
        Some(sign) => Some((Copula::Sign, sign.len())),
        None => starts_with_one_of(text, COPULAS).map(|length| (Copula::Word, length)),
    }
}

/// Words before what is to be shown.
const TASKS: &[&str] = &[
    "show that",
    "show",
    "prove",
    "verify",
    "check",
    "beweise",
    "zeige",
    "montrer",
    "vérifier",
    "证明",
    "prove that",
    "prove",
    "beweise",
    "verify that",
    "check that",
    "check whether",
    "is it true that",
    "zeige dass",
    "beweise dass",
    "prüfe ob",
    "zeige, dass",
    "zeigen sie, dass",
    "beweise, dass",
    "prüfe, ob",
    "stimmt es, dass",
    "montrer que",
    "montre que",
    "montrez que",
    "démontrer que",
    "vérifier que",
    "est-ce que",
    "判断",
    "demuestra que",
    "muestra que",
    "dimostra che",
    "验证",
];

/// What is asked with the words with which a text begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Asking {
    /// The length of the words.
    pub length: usize,
    /// Whether what follows is a claim: show that.
    pub claims: bool,
}

/// The words with which a text begins, if they say that something is asked now.
pub(crate) fn asks(text: &str) -> Option<Asking> {
    let task = starts_with_one_of(text, TASKS).map(|length| Asking { length, claims: true });
    task.or_else(|| starts_with_one_of(text, CONTINUATIONS).map(|length| Asking { length, claims: false }))
}

/// Words between what is asked and a condition on it.
const SUCH: &[&str] = &[
    "such that",
    "so that",
    "subject to",
    "provided that",
    "assuming",
    "under the condition",
    "sodass",
    "so dass",
    "unter der bedingung",
    "tel que",
    "telle que",
    "tels que",
    "telles que",
    "sachant que",
    "sous la condition",
    "tal que",
    "tale che",
    "使得",
    "满足",
];

/// Words between a condition and what follows from it.
const THUS: &[&str] = &[
    "then",
    "implies",
    "implies that",
    "dann",
    "impliziert",
    "folgt",
    "alors",
    "implique",
    "implique que",
    "entonces",
    "implica",
    "allora",
    "则",
    "那么",
    "推出",
];

/// Nouns before a name that is defined: the polynomial $p(t) = t^2$.
const NOUNS: &[&str] = &[
    "matrix",
    "vector",
    "function",
    "polynomial",
    "curve",
    "point",
    "points",
    "number",
    "numbers",
    "sequence",
    "vektor",
    "funktion",
    "polynom",
    "kurve",
    "punkt",
    "punkte",
    "zahl",
    "zahlen",
    "folge",
    "matrice",
    "vecteur",
    "fonction",
    "polynôme",
    "courbe",
    "suite",
    "矩阵",
    "函数",
    "多项式",
    "向量",
];

const ARTICLES: &[&str] =
    &["the", "a", "an", "die", "der", "das", "eine", "ein", "la", "le", "les", "une", "un"];

/// The length of the noun with which a text begins, with its article, if a name and its value follow.
pub(crate) fn noun(text: &str) -> Option<usize> {
    let article = starts_with_one_of(text, ARTICLES).unwrap_or(0);
    let rest = text.get(article..)?;
    let gap = rest.len() - rest.trim_start().len();
    let length = starts_with_one_of(rest.trim_start(), NOUNS)?;
    let end = article + gap + length;
    let next = text.get(end..)?;
    if !next.starts_with(|c: char| c.is_whitespace() || c == '$' || super::letters::is_ideograph(c)) {
        return None;
    }
    let next = next.trim_start();
    let name = next.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
    let defines =
        next.len() > name.len() && name.trim_start().starts_with(['=', '(', ':']) && name.contains('=');
    (next.starts_with('$') || defines).then_some(end)
}

/// The length of the words with which a text begins, if a condition follows: such that.
pub(crate) fn conditions_follow(text: &str) -> Option<usize> {
    starts_with_one_of(text, SUCH)
}

/// The same, if what goes before is a condition: implies, then.
pub(crate) fn follows_from(text: &str) -> Option<usize> {
    starts_with_one_of(text, THUS)
}

/// Words that deny, or that say which of several things is meant.
const DENYING: &[&str] = &[
    "not",
    "no",
    "without",
    "except",
    "never",
    "neither",
    "last",
    "first",
    "middle",
    "half",
    "mean",
    "average",
    "absolute",
    "nur",
    "seulement",
    "sólo",
    "solo",
    "unless",
    "before",
    "after",
    "other",
    "another",
    "instead",
    "rather",
    "opposite",
    "again",
    "every",
    "each",
    "any",
    "nor",
    "more",
    "less",
    "than",
    "least",
    "most",
    "second",
    "sauf",
    "ni",
    "sinon",
    "despite",
    "besides",
    "negative",
    "positive",
    "nicht",
    "kein",
    "keine",
    "ohne",
    "außer",
    "letzte",
    "erste",
    "mittlere",
    "pas",
    "sans",
    "sauf",
    "dernier",
    "premier",
    "sin",
    "excepto",
    "senza",
];

/// Whether a word denies, or says which of several things is meant: not, last.
pub(crate) fn denies(word: &str) -> bool {
    DENYING.contains(&word.to_lowercase().as_str())
}

/// Words that ask for no more than what is asked anyway.
const ASIDES: &[&str] = &[
    "please",
    "show steps",
    "show your work",
    "show all steps",
    "with steps",
    "with proof",
    "with all steps",
    "explain",
    "explain why",
    "explain your answer",
    "why",
    "why not",
    "justify",
    "justify your answer",
    "prove it",
    "if possible",
    "possible",
    "yes or no",
    "is that right",
    "is this right",
    "correct",
    "right",
    "thanks",
    "thank you",
    "exactly",
    "no decimals",
    "as fractions",
    "as a fraction",
    "in lowest terms",
    "hint",
    "equal intervals",
    "mit begründung",
    "begründe",
    "warum",
    "mit rechenweg",
    "wenn möglich",
    "ja oder nein",
    "bitte",
    "danke",
    "justifie",
    "justifier",
    "justifiez",
    "pourquoi",
    "si possible",
    "oui ou non",
    "merci",
    "justifica",
    "por qué",
    "por favor",
    "si es posible",
    "gracias",
    "sí o no",
    "perché",
    "per favore",
    "grazie",
    "为什么",
    "请",
    "谢谢",
    "说明理由",
];

/// The length of the words with which a text begins, if they ask for nothing more.
pub(crate) fn aside(text: &str) -> Option<usize> {
    starts_with_one_of(text, ASIDES)
}

/// Where a line may be cut into clauses, outside of brackets: the end of the one, the start of the next; the last place first.
pub(crate) fn clauses(text: &str) -> Vec<(usize, usize)> {
    let mut depth = 0_i32;
    let mut found: Vec<(usize, usize)> = super::wanted::conjunctions(text);
    let mut before = ' ';
    for (at, c) in text.char_indices() {
        depth += i32::from(matches!(c, '(' | '[' | '{')) - i32::from(matches!(c, ')' | ']' | '}'));
        let after = at + c.len_utf8();
        let next = text.get(after..).unwrap_or_default();
        let apart = next.starts_with(char::is_whitespace);
        let cut = match c {
            '?' | '？' | ';' | '；' | '。' => true,
            // 1, 2, 3
            ',' | '，' => (apart || c == '，') && next.trim_start().starts_with(char::is_alphabetic),
            '.' | ':' | '!' | '：' => apart || !c.is_ascii(),
            // a curve - its length
            '-' | '–' | '—' => {
                before == ' ' && next.trim_start().starts_with(char::is_alphabetic) && apart
            }
            // (with steps)
            '(' => depth == 1 && before == ' ' && next.trim_end().ends_with(')'),
            _ => false,
        };
        if cut && (depth == 0 || c == '(' && depth == 1) && !next.trim().is_empty() {
            found.push((at, after));
        }
        before = c;
    }
    found.sort_unstable();
    found.reverse();
    found
}

/// Words behind a claim that say nothing more.
const TRUTH: &[&str] = &[
    "true or false",
    "wahr oder falsch",
    "vrai ou faux",
    "right or wrong",
    "true",
    "correct",
    "right",
    "valid",
    "always true",
    "an identity",
    "wahr",
    "richtig",
    "korrekt",
    "immer wahr",
    "vrai",
    "vraie",
    "exact",
    "exacte",
    "toujours vrai",
    "verdadero",
    "vero",
    "成立",
    "正确",
    "对吗",
    "是否成立",
    "是否正确",
    "吗",
];

/// A claim without a word behind it such as "true".
pub(crate) fn without_truth(text: &str) -> &str {
    let own = |word: &&&str| {
        let before = text.strip_suffix(**word).filter(|before| !before.trim().is_empty());
        let ideographs = word.chars().all(super::letters::is_ideograph);
        before.is_some_and(|before| ideographs || before.ends_with([' ', '$', ',']))
    };
    match TRUTH.iter().filter(own).map(|word| word.len()).max() {
        Some(length) => text.get(..text.len() - length).unwrap_or(text).trim_end_matches([' ', ',']),
        None => text,
    }
}

/// A text without the words behind it that ask whether it is so: true or false?
pub(crate) fn without_question_of_truth(text: &str) -> Option<&str> {
    const QUESTIONS: &[&str] = &[
        "true or false",
        "right or wrong",
        "wahr oder falsch",
        "richtig oder falsch",
        "vrai ou faux",
        "verdadero o falso",
        "vero o falso",
        "是否成立",
        "是否正确",
        "对吗",
    ];
    let text = text.trim_end().trim_end_matches(['?', '？']).trim_end();
    let rest = QUESTIONS.iter().find_map(|words| text.strip_suffix(words))?;
    let rest = rest.trim_end().trim_end_matches([',', ':', '：', '，']);
    (!rest.trim().is_empty()).then_some(rest)
}

/// Labels before a claim.
const CLAIMS: &[&str] = &[
    "claim",
    "statement",
    "assertion",
    "theorem",
    "lemma",
    "proposition",
    "true or false",
    "behauptung",
    "satz",
    "aussage",
    "wahr oder falsch",
    "richtig oder falsch",
    "affirmation",
    "théorème",
    "lemme",
    "vrai ou faux",
    "命题",
    "定理",
    "断言",
    "判断",
];

/// Labels before anything.
const LABELS: &[&str] = &[
    "question",
    "problem",
    "exercise",
    "example",
    "task",
    "quiz",
    "q",
    "answer",
    "solution",
    "frage",
    "aufgabe",
    "beispiel",
    "übung",
    "exercice",
    "exemple",
    "problème",
    "ejemplo",
    "ejercicio",
    "pregunta",
    "问题",
    "例",
    "例题",
    "练习",
    "题",
];

/// A label with its colon at the start of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Labelled {
    /// Its length, with the colon.
    pub length: usize,
    /// Whether what follows is claimed.
    pub claims: bool,
}

/// The label with which a text begins: `Claim:`, `check:`, `Aufgabe:`.
pub(crate) fn label(text: &str) -> Option<Labelled> {
    let found = starts_with_one_of(text, CLAIMS).map(|length| (length, true));
    let found = found.or_else(|| starts_with_one_of(text, TASKS).map(|length| (length, true)));
    let (length, claims) =
        found.or_else(|| starts_with_one_of(text, LABELS).map(|length| (length, false)))?;
    // Exercise 3:
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | ' ' | '\u{a0}');
    let rest = text.get(length..)?.trim_start_matches(number);
    let sign = rest.chars().next().filter(|sign| matches!(sign, ':' | '：'))?.len_utf8();
    let after = rest.get(sign..)?.chars().next()?;
    if after == '=' {
        return None;
    }
    Some(Labelled { length: text.len() - rest.len() + sign, claims })
}

/// The length of the longest of some words with which a text begins, whatever its capitals.
pub(super) fn starts_with_one_of(text: &str, words: &[&str]) -> Option<usize> {
    let ends = |rest: &str, word: &str| {
        !rest.starts_with(char::is_alphanumeric) || word.chars().all(super::letters::is_ideograph)
    };
    let begins = |word: &&&str| {
        text.get(..word.len()).is_some_and(|start| {
            let same = match start.is_ascii() {
                true => start.bytes().map(|byte| byte.to_ascii_lowercase()).eq(word.bytes()),
                false => start.to_lowercase() == **word,
            };
            same && text.get(word.len()..).is_some_and(|rest| ends(rest, word))
        })
    };
    words.iter().filter(begins).map(|word| word.len()).max()
}
