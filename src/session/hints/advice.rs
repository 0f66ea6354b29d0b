//! What to write for words that nobody reads: queries about what they name, made of what stands between them where
//! that is possible. Whatever is proposed here was tried.

use std::collections::BTreeSet;

use crate::budget::Limits;
use crate::formula::source::{Pieces, SourceFile, Span};
use crate::formula::{Expr, Kind, call};
use crate::language::diagnostic::{Code, Diagnostic, may_be_of_words};
use crate::language::eval::Equals;
use crate::language::functions::{Builtin, Need, builtin, function_called};
use crate::language::lexicon::letters::{self, is_ideograph};
use crate::language::lexicon::phrases::{self, Label, Phrase, phrase};
use crate::language::lexicon::topics::{self, Advice};
use crate::language::lexicon::{asking, words};
use crate::language::write;
use crate::session::{Failure, Session, defines, guarded, read_in};

/// How many queries are proposed.
const MOST: usize = 3;

/// Examples for words that any question may have: value, sum, such.
const GENERAL: &[&str] = &[
    "t^3 - 2t at t = 2",
    "[1, 2; 3, 4]",
    "solve(a + 3 = 0, a)",
    "bezier([1, 0, 0, 1])(t)",
    "length([1, 2, 3])",
];

/// Shorter unknown words may be products of letters.
const SHORTEST_WORD: usize = 4;

/// A text by its words.
#[derive(Default)]
struct Words {
    /// The functions that its phrases name.
    functions: Vec<&'static str>,
    /// A function to which its words belong, if none is named.
    likely: Option<&'static str>,
    /// The words that are in no list.
    unknown: Vec<Span>,
    /// How many words there are.
    count: usize,
    /// What stands between them.
    pieces: Vec<Span>,
    /// Those of the pieces that no word says to be a parameter, an interval or the like.
    objects: Vec<Span>,
}

impl Session {
    /// A failure of a text in words, with advice in place of what a formula would need.
    pub(in crate::session) fn advised(
        &self,
        file: &SourceFile,
        whole: Span,
        failure: Box<Failure>,
    ) -> Box<Failure> {
        let of_words = may_be_of_words(&failure.problem);
        if !(of_words || failure.problem.code == Code::Type) || failure.file.text() != file.text() {
            return failure;
        }
        let text = file.slice(whole);
        let found = self.words_of(text);
        let asked = text.trim_end().ends_with(['?', '？']) && !found.unknown.is_empty();
        let named = !(found.unknown.is_empty() && found.functions.is_empty() && found.likely.is_none());
        // sum of k^2
        if found.count < 2 && !asked || !named && topics::advice(&small_words(text).join(" ")).is_empty() {
            return failure;
        }
        // derivative is a function, which its letters are multiplied with
        if failure.problem.code == Code::Type && !found.pieces.is_empty() {
            return failure;
        }
        if found.unknown.is_empty()
            && let Some(problem) = self.broken_piece(file, whole, &found)
        {
            return Box::new(Failure { problem, file: file.clone() });
        }
        let problem = self.advice_for(file, whole, &found);
        Box::new(Failure { problem, file: file.clone() })
    }

    /// What is wrong with a formula between words that are all known: t^3 + on [0, 1].
    fn broken_piece(&self, file: &SourceFile, whole: Span, found: &Words) -> Option<Diagnostic> {
        let incomplete =
            |problem: &Diagnostic| matches!(problem.code, Code::UnexpectedEnd | Code::Unbalanced);
        let text = file.slice(whole);
        // B-spline
        let hyphen = |piece: &&Span| {
            let mut signs = text.piece(piece.range()).chars().rev();
            signs.next() == Some('-') && signs.next().is_none_or(char::is_alphabetic)
        };
        let balance = |signs: [char; 3]| text.matches(signs).count();
        if balance(['(', '[', '{']) != balance([')', ']', '}']) {
            return None;
        }
        found
            .pieces
            .iter()
            .filter(|piece| !hyphen(piece) && !text.piece(piece.range()).ends_with('='))
            .find_map(|piece| {
                let read =
                    guarded(&self.limits, || read_in(&self.env, file, Some(piece.shifted(whole.start))));
                read.err().filter(incomplete)
            })
    }

    fn advice_for(&self, file: &SourceFile, whole: Span, found: &Words) -> Diagnostic {
        let text = file.slice(whole);
        let at = |span: Span| span.shifted(whole.start);
        let mut problem = match found.unknown.first() {
            Some(word) => {
                let message = format!("'{}' is a word that is not read here", text.piece(word.range()));
                Diagnostic::error(Code::UnknownName, message).at(at(*word)).reason("not understood")
            }
            None => Diagnostic::error(Code::UnknownName, "these words are not read together")
                .at(whole)
                .reason("not understood"),
        };
        let small = small_words(text);
        let misspelled = found.unknown.iter().find_map(|span| {
            let word = text.piece(span.range()).to_lowercase();
            let next = small.iter().skip_while(|other| **other != word).nth(1).map_or("", String::as_str);
            phrases::misspelled(&word, next)
        });
        let about = topics::advice(&small.join(" "));
        let without = self.without_words(text, found, misspelled);
        let without = without.or_else(|| {
            let word = text.piece(found.unknown.first()?.range());
            let (query, clause) = self.without_clause(text, word, &|query| self.tried(query))?;
            Some(format!("without '{clause}' it is {query}"))
        });
        let without = without.or_else(|| self.understood(text, found));
        let read_without = without.is_some();
        if let Some(hint) = without {
            problem = problem.hint(hint);
            if about.is_empty() {
                return problem;
            }
        }
        if let Some(meant) = misspelled.filter(|_| about.is_empty()) {
            problem = problem.hint(format!("did you mean '{}'?", meant.trim_end_matches('~')));
        }
        if let Some(word) =
            small.iter().find(|word| words::is_foreign_function(word) && phrase(word, &|_| None).is_none())
        {
            problem = problem.hint(words::elsewhere(word).unwrap_or_default());
        }
        // Each with whether it is made of what stands there.
        let mut proposed: Vec<(bool, String)> = Vec::new();
        let mut said: Vec<&str> = Vec::new();
        let read = |piece: &Span| self.piece(file, at(*piece));
        let pieces: Vec<Expr> = found.pieces.iter().filter_map(read).collect();
        let items: Vec<Expr> = found.objects.iter().filter_map(read).collect();
        // over Q
        let short = |piece: &&Span| piece.len() > 1 || text.piece(piece.range()).contains(char::is_numeric);
        let alone = found.functions.len() < 2
            && found.pieces.iter().filter(short).count() == 1
            && !found.unknown.iter().any(|span| matters(text, *span));
        // Several words side by side say more than one of them.
        for advice in about {
            match advice {
                Advice::Write(query) => proposed.push((false, query.to_owned())),
                Advice::Equations(query) => proposed.push(match self.system(&pieces) {
                    Some(query) => (true, query),
                    None => (false, query.to_owned()),
                }),
                Advice::Function(_) if read_without => {}
                Advice::Function(name) => proposed.extend(self.example(name, &items, alone)),
                Advice::Say(advice) => said.push(advice),
            }
        }
        // The control points of a B-spline are those of a B-spline.
        let mut functions = found.functions.clone();
        functions.sort_by_key(|name| matches!(*name, "control_points" | "bezier_points" | "coefficients"));
        let own: Vec<(bool, String)> = functions
            .iter()
            .filter(|_| !read_without)
            .filter_map(|name| self.example(name, &items, alone))
            .collect();
        if proposed.is_empty() && own.is_empty() && said.is_empty() {
            proposed.extend(found.likely.and_then(|name| self.example(name, &items, alone)));
        }
        // What words of requests name is surer.
        let place = usize::from(!proposed.is_empty());
        proposed.splice(place..place, own);
        // What any question has to do with is no help where words name more.
        if proposed.iter().any(|(own, query)| *own || !GENERAL.contains(&query.as_str())) {
            proposed.retain(|(own, query)| *own || !GENERAL.contains(&query.as_str()));
        }
        let mut seen = BTreeSet::new();
        proposed.retain(|query| seen.insert(query.clone()));
        for (own, query) in proposed.into_iter().take(MOST) {
            problem =
                problem.hint(if own { format!("write {query}") } else { format!("for example {query}") });
        }
        for advice in said {
            problem = problem.hint(advice);
        }
        match problem.hints.is_empty() {
            true => problem.hint(
                "write a formula, or ask for a function: derivative of t^3; polarform functions lists them",
            ),
            false => problem,
        }
    }

    /// A failure for want of an argument, with what may be said besides: maximum of t^2 — on [0, 1].
    pub(in crate::session) fn with_what_is_missing(
        &self,
        file: &SourceFile,
        whole: Span,
        mut failure: Box<Failure>,
    ) -> Box<Failure> {
        const BESIDES: &[&str] = &["on [0, 1]", "at 1/2", "of degree 2"];
        if !matches!(failure.problem.code, Code::Arity | Code::Domain) {
            return failure;
        }
        let ends = |c: char| c.is_whitespace() || matches!(c, '?' | '？' | '.' | ',' | ';' | '!');
        let text = file.slice(whole).trim().trim_end_matches(ends);
        let works = |more: &&&str| {
            let file = SourceFile::new("<proposed>", format!("{text} {more}"));
            let whole = Span::new(0, file.text().len());
            let formula = self.spoken(&file, whole).ok().flatten();
            let answered = formula.is_some_and(|formula| self.tried(formula).is_some());
            answered || self.spoken_loosely(&file, whole).is_some()
        };
        if let Some(more) = BESIDES.iter().find(works) {
            failure.problem.hints.insert(0, format!("say more, for example: {text} {more}"));
        }
        failure
    }

    /// What the text asks for with a word spelled as it may be meant, or without the words that nobody reads.
    fn without_words(&self, text: &str, found: &Words, misspelled: Option<&str>) -> Option<String> {
        let (first, last) = (found.unknown.first()?, found.unknown.last()?);
        let written = |text: String| {
            let file = SourceFile::new("<proposed>", text);
            let whole = Span::new(0, file.text().len());
            let formula = self.spoken(&file, whole).ok().flatten();
            let own = formula.and_then(|formula| self.tried(formula));
            own.or_else(|| self.spoken_loosely(&file, whole).and_then(|formula| self.tried(formula)))
        };
        if let (Some(meant), true) = (misspelled, first == last) {
            let meant = meant.trim_end_matches('~');
            let start = text.piece(..first.start);
            // Two words are proposed for the first of them.
            let word = meant.split(' ').next().unwrap_or(meant);
            let corrected = format!("{start}{word}{}", text.piece(first.end..));
            if let Some(query) = written(corrected) {
                return Some(format!("did you mean '{meant}'? write {query}"));
            }
            return None;
        }
        // What changes the question cannot be left out: the true degree, the support of a spline, not, only.
        // A part of catmull-rom is no word of its own.
        let part =
            |span: &Span| text.piece(span.end..).starts_with('-') || text.piece(..span.start).ends_with('-');
        if found.unknown.iter().any(|span| part(span) || matters(text, *span)) {
            return None;
        }
        // One word, or words side by side.
        let between = |pair: &[Span]| text.piece(pair[0].end..pair[1].start).trim().is_empty();
        if !found.unknown.windows(2).all(between) {
            return None;
        }
        let mut masked = text.as_bytes().to_vec();
        found.unknown.iter().for_each(|span| masked[span.range()].fill(b' '));
        let query = written(String::from_utf8(masked).ok()?)?;
        let words: Vec<String> =
            found.unknown.iter().map(|span| format!("'{}'", text.piece(span.range()))).collect();
        Some(format!("without {} it is {query}", words.join(" and ")))
    }

    /// What is understood where several words, or words that change the question, are not: the rest of it, which has an answer.
    fn understood(&self, text: &str, found: &Words) -> Option<String> {
        if found.unknown.is_empty()
            || found.unknown.iter().any(|span| asking::denies(text.piece(span.range())))
        {
            return None;
        }
        // Two formulas with a word between them are no product.
        let formula = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit() || "()[]{}".contains(c));
        let between = |span: &Span| {
            formula(text.piece(..span.start).trim_end().chars().next_back())
                && formula(text.piece(span.end..).trim_start().chars().next())
        };
        if found.unknown.iter().any(between) {
            return None;
        }
        let mut masked = text.as_bytes().to_vec();
        found.unknown.iter().for_each(|span| masked[span.range()].fill(b' '));
        let file = SourceFile::new("<proposed>", String::from_utf8(masked).ok()?);
        let whole = Span::new(0, file.text().len());
        let usual = self.spoken(&file, whole).ok().flatten().and_then(|formula| self.tried(formula));
        let query =
            usual.or_else(|| self.spoken_loosely(&file, whole).and_then(|formula| self.tried(formula)))?;
        Some(format!("the rest, which may be another question, is {query}"))
    }

    /// A formula or a list that stands between words.
    fn piece(&self, file: &SourceFile, span: Span) -> Option<Expr> {
        let read = guarded(&self.limits, || read_in(&self.env, file, Some(span))).ok()?;
        match read.kind {
            // 0, 1, 4
            Kind::Sequence(items)
                if !items.iter().any(|item| matches!(item.kind, Kind::Chain(..) | Kind::Text(_))) =>
            {
                Some(Expr { span, ..Expr::new(Kind::List(items), span) })
            }
            Kind::Sequence(_) | Kind::Text(_) => None,
            _ => Some(read),
        }
    }

    /// The equations of a question, to be solved.
    fn system(&self, items: &[Expr]) -> Option<String> {
        let equations: Vec<Expr> =
            items.iter().filter(|item| matches!(item.kind, Kind::Chain(..))).cloned().collect();
        if equations.len() < 2 {
            return None;
        }
        let list = Expr::new(Kind::List(equations), Span::default());
        self.tried(call("solve", vec![list], Span::default()))
    }

    /// A call of a function with what is there, or its own example.
    fn example(&self, name: &str, items: &[Expr], alone: bool) -> Option<(bool, String)> {
        let function = builtin(name)?;
        // What leaves something out is another question.
        let fitting = items.iter().find(|item| takes(function, item)).filter(|_| alone).cloned();
        let own = fitting.and_then(|item| self.tried(call(function.name, vec![item], Span::default())));
        Some(match own {
            Some(query) => (true, query),
            None => (false, function.example.to_owned()),
        })
    }

    /// A query as it is written, if it has an answer.
    fn tried(&self, query: Expr) -> Option<String> {
        // Nobody multiplies by a word: -rom 0 is the rest of catmull-rom.
        let word = |factor: &Expr| match &factor.kind {
            Kind::Name(name) => {
                !letters::is_one_letter(name) && !name.contains('_') && !defines(&self.env, name)
            }
            _ => false,
        };
        if query.has(&|part| matches!(&part.kind, Kind::Mul(factors) if factors.iter().any(word))) {
            return None;
        }
        let written = write::text(&query);
        let mut there = self.clone();
        there.limits = Limits { steps: Some(TRIED_STEPS), ..there.limits };
        let file = SourceFile::new("<proposed>", written.as_str());
        let mut read = there.read(&file, Span::new(0, written.len())).ok()?;
        there.evaluate(&mut read, Equals::Claims).ok()?;
        Some(written)
    }

    /// The words of a text outside of formulas, and what stands between them.
    fn words_of(&self, text: &str) -> Words {
        let mut found = Words::default();
        let mut start = 0;
        let mut at = 0;
        let mut before = ' ';
        let mut depth = 0_usize;
        let mut labelled = false;
        let end_piece = |found: &mut Words, from: usize, to: usize, labelled: bool| {
            let piece = text.piece(from..to);
            let separates = |c: char| {
                c.is_whitespace() || matches!(c, ',' | ';' | ':' | '.' | '?' | '？' | '，' | '。' | '：')
            };
            let inner = piece.trim_start_matches(separates);
            let from = from + (piece.len() - inner.len());
            let inner = inner.trim_end_matches(separates);
            if !inner.is_empty() {
                let span = Span::new(from, from + inner.len());
                found.pieces.push(span);
                found.objects.extend(Some(span).filter(|_| !labelled));
            }
        };
        while let Some(c) = text.piece(at..).chars().next() {
            let apart = is_ideograph(c)
                || !(before.is_alphanumeric() && !is_ideograph(before)
                    || matches!(before, '_' | '^' | '\\' | '{'));
            if !(c.is_alphabetic() && apart) {
                depth += usize::from(matches!(c, '(' | '[' | '{'));
                depth = depth.saturating_sub(usize::from(matches!(c, ')' | ']' | '}')));
                before = c;
                at += c.len_utf8();
                continue;
            }
            let word = self.word_at(text, at, before, depth);
            match word {
                Some((length, meant)) => {
                    end_piece(&mut found, start, at, labelled);
                    labelled = match meant {
                        Meant::Label => true,
                        Meant::Known => labelled && text.piece(start..at).trim().is_empty(),
                        _ => false,
                    };
                    found.count += text.piece(at..at + length).split_whitespace().count();
                    match meant {
                        Meant::Function(function) => found.functions.push(function),
                        Meant::Likely(function) => found.likely = found.likely.max(Some(function)),
                        Meant::Known | Meant::Label => {}
                        Meant::Unknown => found.unknown.push(Span::new(at, at + length)),
                    }
                    at += length;
                    start = at;
                    before = ' ';
                }
                None => {
                    let length = run(text.piece(at..)).max(c.len_utf8());
                    at += length;
                    before = 'a';
                }
            }
        }
        end_piece(&mut found, start, text.len(), labelled);
        found
    }

    /// The word of prose or the phrase at a place, with its length.
    fn word_at(&self, text: &str, at: usize, before: char, depth: usize) -> Option<(usize, Meant)> {
        let rest = text.piece(at..);
        let length = run(rest);
        let word = rest.piece(..length);
        let ideographs = rest.starts_with(is_ideograph);
        if !ideographs && (word.len() < 2 || defines(&self.env, word)) {
            return None;
        }
        // Names of functions before their arguments, names with an index, products.
        let closes = |after: &str| {
            after.is_empty()
                || after.starts_with(|c: char| {
                    c.is_whitespace()
                        || is_ideograph(c)
                        || matches!(
                            c,
                            ',' | '.' | ';' | ':' | '?' | '？' | '!' | '。' | '，' | '：' | '-' | '$' | '\''
                        )
                })
        };
        if let Some((said, own)) = phrase(rest, &|name| function_called(name))
            && (closes(rest.piece(own..)) || ideographs)
            && own > 1
        {
            let meant = match said {
                Phrase::Function(function)
                | Phrase::Command(function)
                | Phrase::Part(function, _)
                | Phrase::Between(function) => Meant::Function(function),
                Phrase::Label(Label::Weights) => Meant::Label,
                Phrase::Label(Label::Points) | Phrase::Rational | Phrase::Degree(2..) => {
                    Meant::Likely("bezier")
                }
                Phrase::Label(Label::Knots) => Meant::Likely("bspline"),
                Phrase::Label(_) => Meant::Label,
                Phrase::First(_) => Meant::Unknown,
                Phrase::Multiaffine => Meant::Likely("laws"),
                Phrase::Which => Meant::Likely("solve"),
                _ => Meant::Known,
            };
            return Some((own, meant));
        }
        if ideographs {
            let known = words::aside(word).is_some() || asking::asks(rest).is_some();
            return Some((length, if known { Meant::Known } else { Meant::Unknown }));
        }
        if !closes(rest.piece(length..))
            || depth > 0 && !matches!(before, ' ')
            || matches!(before, '*' | '/' | '+' | '(' | '[')
        {
            return None;
        }
        if words::aside(word).is_some()
            || words::prose(word).is_some()
            || asking::asks(rest).is_some()
            || asking::introduces(rest).is_some()
        {
            return Some((length, Meant::Known));
        }
        // Letters of formulas stand beside each other, too: x ab y.
        let next = rest.piece(length..).trim_start();
        let leads = run(next) > 1 && rest.piece(length..).starts_with(' ');
        let greek = letters::sign(word).is_some();
        let long = word.chars().count() >= SHORTEST_WORD || leads && word.chars().count() > 2;
        (long && !greek).then_some((length, Meant::Unknown))
    }
}

/// Whether an unknown word says which question it is: before what it is about, before what is asked for, or where it denies.
fn matters(text: &str, span: Span) -> bool {
    if asking::denies(text.piece(span.range())) {
        return true;
    }
    match phrase(text.piece(span.end..).trim_start(), &|name| function_called(name)) {
        Some((said, _)) => matches!(
            said,
            Phrase::Of
                | Phrase::Function(_)
                | Phrase::Command(_)
                | Phrase::Part(..)
                | Phrase::Degree(_)
                | Phrase::Rational
                | Phrase::Uniform
                | Phrase::Curve
        ),
        None => false,
    }
}

/// The words of a text in small letters.
fn small_words(text: &str) -> Vec<String> {
    let lower = text.to_lowercase();
    lower.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// The steps for a query that is only proposed.
const TRIED_STEPS: u64 = 200_000;

enum Meant {
    Function(&'static str),
    /// A function to which the word belongs, if none is named.
    Likely(&'static str),
    /// A word that says something elsewhere.
    Known,
    /// A word behind which a parameter, an interval or the like stands.
    Label,
    Unknown,
}

/// The length of the letters at the start of a text; ideographs by themselves.
fn run(text: &str) -> usize {
    let first = text.chars().next().is_some_and(is_ideograph);
    let same = |c: &char| c.is_alphabetic() && is_ideograph(*c) == first;
    text.chars().take_while(same).map(char::len_utf8).sum()
}

/// Whether a function may be asked of one formula or list.
fn takes(function: &Builtin, item: &Expr) -> bool {
    let Some((first, rest)) = function.parameters.split_first() else { return false };
    let alone = rest.iter().all(|parameter| parameter.need != Need::Required);
    let fits = match first.kind {
        kind if kind.is_formula() => {
            matches!(item.kind, Kind::Add(_) | Kind::Mul(_) | Kind::Pow(..) | Kind::Div(..) | Kind::Apply(..))
        }
        _ => matches!(item.kind, Kind::List(_)) && function.name == "bezier",
    };
    alone && fits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_proposed_works() {
        for query in topics::queries() {
            assert!(Session::default().run(query).is_ok(), "{query}");
        }
    }

    #[test]
    fn formulas_keep_their_errors() {
        for text in ["polra(t^2)", "1/(t - t)", "fooo + 1", "t^2 +", "2 nonsense"] {
            let failure = Session::default().run(text).map(|answer| answer.outcome.value).unwrap_err();
            assert!(!failure.problem.message.contains("not read here"), "{text}");
        }
        let failure = Session::default().run("apex of the bezier 4, 0, 2").unwrap_err();
        assert!(failure.problem.message.starts_with("'apex'"));
    }
}
