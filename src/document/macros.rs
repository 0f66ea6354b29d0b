//! The macros of authors: `\newcommand`, `\def`, `\let` and their kin.
//!
//! **Definition.** A macro is a command whose call, its name with arguments, stands for a text
//! into which the arguments are put. [`Macros::expand`] replaces the calls in a formula, again in
//! what came out, and says of every byte of the result where it comes from: those of an argument
//! from its place, all others from the whole call.
//!
//! TeX expands while it reads and can compute anything. Here definitions are read in the order of
//! the text, arguments are braces or single tokens or end at given signs, and what a macro grows
//! into is limited: one that calls itself is a problem, not an endless loop.
//!
//! Reference: Knuth, *The TeXbook*, chapter 20; for `\NewDocumentCommand` the LaTeX manual `usrguide`.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::arguments::{
    Argument, Given, MAX_GROUP, MAX_GROUP_AFTER_FAILURE, Reader, call, command_name, specification,
};
use super::text::Text;
use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic};

/// How deep macros may stand in what macros stand for.
const MAX_DEPTH: usize = 60;

/// How long a formula may become, and how many calls it may have.
const MAX_BYTES: usize = 1 << 16;
const MAX_CALLS: usize = 10_000;

#[derive(Clone, Debug)]
struct Macro {
    arguments: Vec<Argument>,
    body: String,
}

/// The macros defined so far.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    table: HashMap<String, Macro>,
    /// Environments of the kind of theorems: `\newtheorem{name}{Title}`.
    pub(super) theorems: HashMap<String, String>,
    /// Whether a group had no end.
    failed: bool,
}

/// What packages for formulas define: physics, commath and their like. A page may define it in its own way.
const PACKAGES: &str = r"
    \NewDocumentCommand{\abs}{s m}{\left|#2\right|}
    \NewDocumentCommand{\norm}{s m}{\left\|#2\right\|}
    \NewDocumentCommand{\vb}{s m}{\mathbf{#2}}
    \newcommand{\dd}{\mathrm{d}}
    \NewDocumentCommand{\dv}{s m m}{\frac{\mathrm{d}#2}{\mathrm{d}#3}}
    \NewDocumentCommand{\pdv}{s m m}{\frac{\partial #2}{\partial #3}}
    \newcommand{\qty}{}
    \newcommand{\pmqty}[1]{\begin{pmatrix}#1\end{pmatrix}}
    \newcommand{\bmqty}[1]{\begin{bmatrix}#1\end{bmatrix}}
";

static OF_PACKAGES: LazyLock<Macros> = LazyLock::new(|| {
    let mut known = Macros::default();
    for (at, _) in PACKAGES.match_indices('\\').filter(|(at, _)| is_definer(command_name(PACKAGES, *at))) {
        known.define(PACKAGES, at);
    }
    known
});

/// The commands that define others.
const DEFINERS: &[&str] = &[
    "newcommand",
    "renewcommand",
    "providecommand",
    "DeclareRobustCommand",
    "def",
    "gdef",
    "edef",
    "xdef",
    "let",
    "DeclareMathOperator",
    "NewDocumentCommand",
    "RenewDocumentCommand",
    "ProvideDocumentCommand",
    "DeclareDocumentCommand",
    "DeclarePairedDelimiter",
];

/// Whether the command defines another.
pub(super) fn is_definer(name: &str) -> bool {
    DEFINERS.contains(&name)
}

impl Macros {
    /// What the page, or else a package, defines under a name.
    fn known(&self, name: &str) -> Option<&Macro> {
        self.table.get(name).or_else(|| OF_PACKAGES.table.get(name))
    }

    /// What a macro without arguments stands for.
    pub(super) fn body(&self, name: &str) -> Option<&str> {
        self.table.get(name).filter(|known| known.arguments.is_empty()).map(|known| known.body.as_str())
    }

    /// The names of the macros that stand for just this.
    pub(super) fn names_of(&self, body: &str) -> Vec<&str> {
        let known = self.table.iter();
        let mut names: Vec<_> = known
            .filter(|(_, known)| known.arguments.is_empty() && known.body.trim() == body)
            .map(|(name, _)| name.as_str())
            .collect();
        names.sort_unstable();
        names
    }

    /// Takes note of the definition at `at`, where its backslash stands: the byte after it. Without
    /// result it is not complete.
    pub(super) fn define(&mut self, text: &str, at: usize) -> Option<usize> {
        let end = self.definition(text, at);
        self.failed |= end.is_none();
        end
    }

    fn reach(&self) -> usize {
        if self.failed { MAX_GROUP_AFTER_FAILURE } else { MAX_GROUP }
    }

    fn definition(&mut self, text: &str, at: usize) -> Option<usize> {
        let definer = command_name(text, at);
        let mut reader = Reader { text, at: at + 1 + definer.len(), reach: self.reach() };
        reader.star();
        let name = reader.name()?;
        let known = match definer {
            "def" | "gdef" | "edef" | "xdef" => {
                let arguments = reader.pattern()?;
                Macro { arguments, body: reader.group()? }
            }
            "let" => {
                reader.spaces();
                reader.sign("=");
                reader.spaces();
                let target = reader.token()?;
                let target = text.piece(target);
                let known = target.strip_prefix('\\').and_then(|target| self.table.get(target));
                known.cloned().unwrap_or(Macro { arguments: Vec::new(), body: target.to_owned() })
            }
            "DeclareMathOperator" => {
                let body = format!(r"\operatorname{{{}}}", reader.group()?);
                Macro { arguments: Vec::new(), body }
            }
            "DeclarePairedDelimiter" => {
                let body = format!("{}#3{}", reader.group()?, reader.group()?);
                let arguments = vec![Argument::Star, Argument::Optional(String::new()), Argument::Mandatory];
                Macro { arguments, body }
            }
            "NewDocumentCommand"
            | "RenewDocumentCommand"
            | "ProvideDocumentCommand"
            | "DeclareDocumentCommand" => {
                let arguments = specification(&reader.group()?)?;
                Macro { arguments, body: reader.group()? }
            }
            _ => {
                let count = reader
                    .bracket()
                    .map_or(Some(0), |count| text.piece(count).trim().parse::<usize>().ok())?;
                let mut arguments = vec![Argument::Mandatory; count.min(9)];
                if let Some(default) = reader.bracket()
                    && let Some(first) = arguments.first_mut()
                {
                    *first = Argument::Optional(text.piece(default).to_owned());
                }
                Macro { arguments, body: reader.group()? }
            }
        };
        let keeps = matches!(definer, "providecommand" | "ProvideDocumentCommand");
        if !(keeps && self.table.contains_key(&name)) {
            self.table.insert(name, Macro { body: uncommented(&known.body), ..known });
        }
        Some(reader.at)
    }

    /// The text without its definitions and with its macros replaced, and the first problem met.
    pub(super) fn expand(&mut self, input: Text) -> (Text, Option<Diagnostic>) {
        let mut commands = input.text.match_indices('\\').map(|(at, _)| command_name(&input.text, at));
        if !commands.any(|name| is_definer(name) || self.known(name).is_some()) {
            return (input, None);
        }
        let mut output = Text::default();
        let mut run = Expansion { macros: self, calls: 0, problem: None, output: &mut output };
        run.expand(&input, 0);
        match run.problem {
            // Half of an expansion is of no use: the reader says what it does not know.
            Some(problem) if problem.code == Code::MacroTooLarge => (input, Some(problem)),
            problem => (output, problem),
        }
    }
}

struct Expansion<'a> {
    macros: &'a mut Macros,
    calls: usize,
    problem: Option<Diagnostic>,
    output: &'a mut Text,
}

impl Expansion<'_> {
    fn expand(&mut self, input: &Text, depth: usize) {
        let text = &input.text;
        let mut said = 0;
        let mut at = 0;
        while let Some(found) = text.piece(at..).find('\\') {
            at += found;
            let name = command_name(text, at);
            let after = at + 1 + name.len();
            if is_definer(name) {
                self.output.push_part(input, said..at);
                at = match self.macros.define(text, at) {
                    Some(end) => end,
                    None => {
                        let place = input.places.span(Span::new(at, after));
                        self.problem.get_or_insert_with(|| half_definition(place));
                        after
                    }
                };
                said = at;
                continue;
            }
            let Some(known) = self.macros.known(name) else {
                at = after;
                continue;
            };
            let Some((arguments, end)) = call(text, after, &known.arguments, self.macros.reach()) else {
                self.macros.failed = true;
                at = after;
                continue;
            };
            let place = input.places.span(Span::new(at, end));
            self.calls += 1;
            if depth >= MAX_DEPTH || self.calls > MAX_CALLS || self.output.text.len() > MAX_BYTES {
                self.problem.get_or_insert_with(|| too_large(name, place));
                return;
            }
            let grown = substituted(input, known, &arguments, place);
            if grown.text.len() > MAX_BYTES {
                self.problem.get_or_insert_with(|| too_large(name, place));
                return;
            }
            self.output.push_part(input, said..at);
            self.output.separate(&grown.text, place);
            self.expand(&grown, depth + 1);
            if self.problem.as_ref().is_some_and(|problem| problem.code == Code::MacroTooLarge) {
                return;
            }
            self.output.separate(text.piece(end..), place);
            (said, at) = (end, end);
        }
        self.output.push_part(input, said..text.len());
    }
}

/// What a call stands for.
fn substituted(input: &Text, known: &Macro, arguments: &[Given], place: Span) -> Text {
    let mut grown = Text::default();
    let mut rest = known.body.as_str();
    while let Some(at) = rest.find('#') {
        grown.push_whole(rest.piece(..at), place);
        let number = rest.piece(at + 1..).chars().next();
        rest = rest.piece(at + 1 + number.map_or(0, char::len_utf8)..);
        let index = number.and_then(|c| c.to_digit(10)).and_then(|digit| (digit as usize).checked_sub(1));
        match index.and_then(|index| arguments.get(index)) {
            Some(Given::At(range)) => {
                grown.separate(input.text.piece(range.clone()), place);
                grown.push_part(input, range.clone());
            }
            Some(Given::Default(text)) => {
                grown.separate(text, place);
                grown.push_whole(text, place);
            }
            // ## in a definition within a definition.
            None if number == Some('#') => grown.push_whole("#", place),
            None => {}
        }
    }
    grown.separate(rest, place);
    grown.push_whole(rest, place);
    grown
}

/// A body without the comments in it.
fn uncommented(body: &str) -> String {
    if !body.contains('%') {
        return body.to_owned();
    }
    let mut plain = String::new();
    for line in body.split_inclusive('\n') {
        let escaped =
            |at: usize| line.piece(..at).bytes().rev().take_while(|&byte| byte == b'\\').count() % 2 == 1;
        match line.match_indices('%').find(|&(at, _)| !escaped(at)) {
            Some((at, _)) => plain.push_str(line.piece(..at)),
            None => plain.push_str(line),
        }
    }
    plain
}

/// The definition at the place has no end, or is of a kind that is not read.
pub(super) fn half_definition(place: Span) -> Diagnostic {
    Diagnostic::warning(Code::HalfDefinition, "this definition of a macro cannot be read")
        .at(place)
        .reason("its braces do not close, or it is of a kind that is not read")
        .hint(r"write it as \newcommand{\name}[1]{…}")
}

fn too_large(name: &str, place: Span) -> Diagnostic {
    Diagnostic::warning(Code::MacroTooLarge, format!("the macro \\{name} grows without end"))
        .at(place)
        .reason("called here")
        .hint("does it call itself? the formula was left as it is")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expansion of the formula after the definitions, with the place of each byte from `@` on.
    fn expanded(definitions: &str, formula: &str) -> (String, Vec<Diagnostic>) {
        let mut macros = Macros::default();
        let (_, first) = macros.expand(Text::plain(definitions, 0));
        let (text, second) = macros.expand(Text::plain(formula, 0));
        (text.text, first.into_iter().chain(second).collect())
    }

    #[test]
    fn every_kind_of_definition() {
        for (definitions, formula, wanted) in [
            (r"\newcommand{\R}{\mathbb{R}}", r"t\in\R^n", r"t\in\mathbb{R}^n"),
            (r"\newcommand\R{\mathbb R}", r"\R x", r"\mathbb R x"),
            (r"\newcommand*{\v}[1]{\mathbf #1}", r"\v{b}_0 + \v x", r"\mathbf b_0 + \mathbf x"),
            (r"\newcommand{\B}[2][n]{B_{#2}^{#1}}", r"\B{i} = \B[m] j", r"B_{i}^{n} = B_{j}^{m}"),
            (r"\def\half{\frac12}", r"\half x", r"\frac12 x"),
            (r"\def\pair#1#2{(#1, #2)}", r"\pair ab", r"(a, b)"),
            (r"\def\at(#1,#2)/{f_{#1}^{#2}}", r"\at(1,{a,b})/", r"f_{1}^{{a,b}}"),
            (r"\let\eps=\varepsilon \let\to\rightarrow", r"\eps\to 0", r"\varepsilon\rightarrow 0"),
            (r"\newcommand{\a}{b}\let\c\a\renewcommand{\a}{d}", r"\a\c", r"db"),
            (r"\DeclareMathOperator{\bl}{bl}", r"\bl(f)", r"\operatorname{bl}(f)"),
            (r"\DeclareMathOperator*{\amax}{max}", r"\amax f", r"\operatorname{max} f"),
            (r"\NewDocumentCommand{\p}{s O{0} m}{p_{#2}(#3)}", r"\p*{t} \p[1]{t}", r"p_{0}(t) p_{1}(t)"),
            (
                r"\DeclarePairedDelimiter{\abs}{\lvert}{\rvert}",
                r"\abs{x} \abs*{y}",
                r"\lvert x\rvert \lvert y\rvert",
            ),
            (r"\providecommand{\q}{1}\providecommand{\q}{2}", r"\q", "1"),
            (r"\newcommand{\x}{\y{1}}\newcommand{\y}[1]{\z_#1}\newcommand{\z}{t}", r"\x^2", "t_1^2"),
            ("\\newcommand{\\x}{a% b\n c\\%}", r"\x", r"a c\%"),
            (r"", r"\newcommand{\u}{2} \u + \u", r" 2 + 2"),
        ] {
            let (text, problems) = expanded(definitions, formula);
            assert_eq!(text, wanted, "{definitions} {formula}");
            assert!(problems.is_empty(), "{problems:?}");
        }
    }

    #[test]
    fn places_lead_to_calls_and_arguments() {
        let mut macros = Macros::default();
        macros.define(r"\newcommand{\B}[2]{B_{#1}^{#2}}", 0).unwrap();
        let formula = r"1 + \B{i}{nn} = x";
        let text = macros.expand(Text::plain(formula, 100)).0;
        assert_eq!(text.text, "1 + B_{i}^{nn} = x");
        let at = |part: &str| {
            let start = text.text.find(part).unwrap();
            let span = text.places.span(Span::new(start, start + part.len()));
            &formula[span.start - 100..span.end - 100]
        };
        assert_eq!(at("1 +"), "1 +");
        assert_eq!(at("nn"), "nn");
        assert_eq!(at("i"), "i");
        assert_eq!(at("B_"), r"\B{i}{nn}");
        assert_eq!(at("= x"), "= x");
    }

    #[test]
    fn endless_macros_stop() {
        for definitions in [
            r"\def\x{\x}",
            r"\def\x{\y a}\def\y{\x b}",
            r"\def\x{\x\x}",
            r"\def\a{\b\b}\def\b{\c\c}\def\c{\d\d\d\d}\def\d{\e\e\e\e}\def\e{\f\f\f\f\f}\def\f{\g\g\g\g\g}\def\g{\h\h\h\h\h}\def\h{\i\i\i}\def\i{aaaa}\def\x{\a\a\a}",
            r"\def\x#1{\x{#1#1}}",
        ] {
            let (text, problems) = expanded(definitions, r"1 + \x y");
            assert_eq!(text, r"1 + \x y");
            assert_eq!(problems[0].code, Code::MacroTooLarge, "{definitions}");
            assert_eq!(problems[0].span.map(|span| span.start), Some(4));
        }
    }

    #[test]
    fn half_definitions() {
        for definition in [
            r"\newcommand{\x}[1]{a",
            r"\def",
            r"\newcommand",
            r"\let\x",
            r"\def\x#2{a}",
            r"\newcommand{x}{y}",
        ] {
            let (_, problems) = expanded(definition, "");
            assert_eq!(problems.len(), 1, "{definition}");
            assert_eq!(problems[0].code, Code::HalfDefinition);
        }
        // A call without its arguments stays.
        assert_eq!(expanded(r"\newcommand{\x}[2]{a}", r"\x{1}").0, r"\x{1}");
    }
}
