//! The environments and commands of LaTeX that say how a text is built.

/// Environments whose content is shown as it is typed, or not at all.
pub(super) const VERBATIM: &[&str] = &[
    "verbatim",
    "Verbatim",
    "lstlisting",
    "minted",
    "comment",
    "filecontents",
    "tikzpicture",
    "pgfpicture",
    "algorithmic",
    "algpseudocode",
    "alltt",
    "polarform",
];

/// Signs of a program within an algorithm: the ends of its lines, its loops and what goes in.
pub(super) const PROGRAM: &[&str] =
    &[r"\;", r"\Kw", r"\If{", r"\If(", r"\eIf", r"\For{", r"\For(", r"\ForEach", r"\While", r"\Repeat"];

pub(super) const QUOTATIONS: &[&str] = &["quote", "quotation", "displayquote", "verse"];

pub(super) const LISTS: &[&str] =
    &["itemize", "enumerate", "description", "list", "compactitem", "compactenum"];

pub(super) const TABLES: &[&str] = &["tabular", "tabularx", "tabulary", "longtable", "tabu"];

/// Theorems and their kin; others are declared with `\newtheorem`.
pub(super) const THEOREMS: &[&str] = &[
    "theorem",
    "lemma",
    "corollary",
    "proposition",
    "definition",
    "example",
    "examples",
    "remark",
    "remarks",
    "proof",
    "exercise",
    "problem",
    "solution",
    "claim",
    "fact",
    "note",
    "notation",
    "conjecture",
    "axiom",
    "property",
    "observation",
    "question",
    "answer",
    "block",
    "exampleblock",
    "alertblock",
    "thm",
    "lem",
    "cor",
    "prop",
    "defn",
    "ex",
    "rem",
    "satz",
    "beispiel",
    "beweis",
    "bemerkung",
    "aufgabe",
];

/// Headings by level.
pub(super) const HEADINGS: &[(&str, u8)] = &[
    ("part", 1),
    ("chapter", 2),
    ("section", 3),
    ("subsection", 4),
    ("subsubsection", 5),
    ("frametitle", 5),
    ("paragraph", 6),
    ("subparagraph", 7),
];

/// Commands that are no words, with their arguments.
pub(super) const SILENT: &[&str] = &[
    "label",
    "includegraphics",
    "usepackage",
    "RequirePackage",
    "documentclass",
    "bibliography",
    "bibliographystyle",
    "url",
    "vspace",
    "hspace",
    "setlength",
    "setcounter",
    "addtocounter",
    "pagestyle",
    "thispagestyle",
    "hypersetup",
    "graphicspath",
    "newenvironment",
    "renewenvironment",
    "hline",
    "cline",
    "toprule",
    "midrule",
    "bottomrule",
    "cmidrule",
    "maketitle",
    "tableofcontents",
    "newpage",
    "clearpage",
    "centering",
    "noindent",
    "hfill",
    "qedhere",
];

/// Other words with a number behind them.
const NUMBERED: &[&str] = &[
    "eq",
    "eqn",
    "equation",
    "formula",
    "fig",
    "figure",
    "table",
    "section",
    "chapter",
    "step",
    "case",
    "page",
    "ex",
    "prop",
    "def",
    "rem",
    "satz",
    "gleichung",
    "formel",
    "beispiel",
    "aufgabe",
    "kapitel",
    "abschnitt",
    "schritt",
    "fall",
    "seite",
    "théorème",
    "lemme",
    "équation",
    "formule",
    "exemple",
    "exercice",
    "chapitre",
    "étape",
    "cas",
    "teorema",
    "ecuación",
    "fórmula",
    "ejemplo",
    "ejercicio",
    "capítulo",
    "paso",
    "caso",
];

/// Whether a word is one of what a text numbers: Theorem 5, Eq. 3, Gleichung 7.
pub(super) fn is_numbered(word: &str) -> bool {
    let word = word.to_lowercase();
    THEOREMS.iter().chain(NUMBERED).any(|own| *own == word)
}
