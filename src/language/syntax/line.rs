//! A line of several formulas with words of sentences between them: `Let $f(t) = t^2$. Compute $f(1)$ and $f(2)$.`
//!
//! Only the words that say what a formula is for are read here: let, with, for, and, compute, is. A piece that has other
//! words is left as it is, and whoever reads it tells what it means or that nobody knows.

use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::asking;
use crate::language::lexicon::letters::is_ideograph;
use crate::language::lexicon::words::{self, Aside};

/// What a piece of a line is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// No word says it.
    Free,
    /// A definition or a condition for all that is asked: let.
    Given,
    /// A value or a condition in its own sentence, or for all values: for, for all.
    Condition { all: bool },
    /// It is asked for: compute.
    Asked,
    /// It is to be shown, or asked whether it is so: show that, is.
    Claimed,
}

/// A formula of a line, or words about some.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Where it stands.
    pub span: Span,
    /// What it is for.
    pub role: Role,
    /// The number of its sentence.
    pub sentence: usize,
    /// Whether it stands directly behind the word that says its role.
    pub direct: bool,
    /// Whether a question mark or an equals sign without a right side ends it.
    pub question: bool,
}

/// A line taken apart.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    /// Its pieces, in their order.
    pub pieces: Vec<Piece>,
    /// Whether it is cut between formulas in dollars.
    pub cut_at_dollars: bool,
}

/// The pieces of a line with more than one formula; `None` if it is one formula without words. A name that is `known` is
/// no word.
///
/// Cost: linear in the length of the text.
pub(crate) fn line(text: &str, known: &dyn Fn(&str) -> bool) -> Option<Line> {
    let mut cutter = Cutter {
        text,
        known,
        pieces: Vec::new(),
        start: 0,
        role: Role::Free,
        sentence: 0,
        cues: 0,
        direct: false,
        claims: false,
        open: false,
        empty: false,
    };
    cutter.run();
    let Cutter { mut pieces, cues, claims, open, empty, .. } = cutter;
    // Where is t^2 largest? A word of conditions with nothing behind it says something else.
    if open || empty {
        return None;
    }
    // For all n, a = b: the last of conditions alone is what they are conditions of.
    let last: Vec<usize> = (0..pieces.len())
        .filter(|at| pieces.get(at + 1).is_none_or(|next| next.sentence != pieces[*at].sentence))
        .collect();
    for at in last {
        let own = pieces.iter().filter(|piece| piece.sentence == pieces[at].sentence);
        if own.clone().count() > 1
            && !pieces[at].direct
            && own.clone().all(|piece| matches!(piece.role, Role::Condition { .. }))
        {
            pieces[at].role = if claims { Role::Claimed } else { Role::Free };
        }
    }
    let in_dollars = |piece: &Piece| text.piece(piece.span.range()).contains(['$', '\\']);
    let cut_at_dollars = pieces.iter().filter(|piece| in_dollars(piece)).count() > 1;
    let asks = pieces.iter().any(|piece| piece.question);
    (pieces.len() > 1 || (cues > 0 || asks) && !pieces.is_empty()).then_some(Line { pieces, cut_at_dollars })
}

struct Cutter<'a> {
    text: &'a str,
    known: &'a dyn Fn(&str) -> bool,
    pieces: Vec<Piece>,
    /// Where the piece begins that is being read.
    start: usize,
    role: Role,
    sentence: usize,
    cues: usize,
    /// Whether no stop has come since the last word.
    direct: bool,
    /// Whether a label says that the line is a claim.
    claims: bool,
    /// Whether nothing has come since a word of conditions.
    open: bool,
    /// Whether nothing stood behind a word of conditions.
    empty: bool,
}

impl Cutter<'_> {
    fn run(&mut self) {
        let text = self.text;
        let (mut at, mut depth, mut dollar) = (0, 0_usize, false);
        let mut before = ' ';
        while let Some(c) = text.piece(at..).chars().next() {
            let length = c.len_utf8();
            let outside = depth == 0 && !dollar;
            if outside
                && c.is_alphabetic()
                && (before.is_whitespace()
                    || !before.is_alphanumeric() && !matches!(before, '_' | '^' | '\\' | '{')
                    || is_ideograph(c))
            {
                if let Some(end) = self.cue(at) {
                    at = end;
                    before = ' ';
                    continue;
                }
                // The rest of the word.
                let word = text.piece(at..).chars().take_while(|c| c.is_alphanumeric() && !is_ideograph(*c));
                let word: usize = word.map(char::len_utf8).sum();
                at += word.max(length);
                before = 'a';
                continue;
            }
            match c {
                '\\' => {
                    if outside && let Some(end) = self.label_in_command(at) {
                        at = end;
                        before = ' ';
                        continue;
                    }
                    // \( and \[ are no brackets of a formula.
                    let next = text.piece(at + 1..).chars().next();
                    match next {
                        Some('(' | '[') => dollar = true,
                        Some(')' | ']') => dollar = false,
                        _ => {}
                    }
                    let skipped = next.filter(|next| !next.is_alphanumeric()).map_or(0, char::len_utf8);
                    at += length + skipped;
                    before = '\\';
                    continue;
                }
                '$' => dollar = !dollar,
                '(' | '[' | '{' => depth += usize::from(!dollar),
                ')' | ']' | '}' => depth = depth.saturating_sub(usize::from(!dollar)),
                _ if outside => {
                    if let Some(stop) = self.stop(at, c) {
                        self.end(at, stop.question);
                        at += length;
                        self.start = at;
                        if stop.sentence {
                            self.sentence += 1;
                            self.role = Role::Free;
                        }
                        before = ' ';
                        continue;
                    }
                }
                _ => {}
            }
            before = c;
            at += length;
        }
        self.end(text.len(), false);
    }

    /// Takes the word at a place that says what the next piece is for; the place behind it.
    fn cue(&mut self, at: usize) -> Option<usize> {
        let rest = self.text.piece(at..);
        let word: String = rest.chars().take_while(|c| c.is_alphabetic() && (!is_ideograph(*c))).collect();
        if (self.known)(&word) {
            return None;
        }
        let fresh = self.text.piece(self.start..at).trim().is_empty();
        // Short words may be names: so t.
        let apart = |length: usize| {
            let next = rest.piece(length..).chars().next();
            rest.piece(..length).chars().all(is_ideograph)
                || next.is_none_or(|next| matches!(next, ' ' | '$' | ',' | ':' | '\n' | '\\'))
        };
        // Given a > 0 show that a + 1 > 0
        const LONG: usize = 4;
        let given = matches!(self.role, Role::Given | Role::Condition { .. });
        if !fresh
            && given
            && let Some(found) =
                asking::asks(rest).filter(|found| found.length >= LONG && apart(found.length))
        {
            self.cues += 1;
            self.end(at, false);
            self.role = if found.claims { Role::Claimed } else { Role::Asked };
            return self.after(at + found.length);
        }
        if fresh {
            if let Some(length) = asking::noun(rest) {
                self.cues += 1;
                return self.after(at + length);
            }
            if let Some(found) = asking::asks(rest).filter(|found| apart(found.length)) {
                self.cues += 1;
                self.role = if found.claims { Role::Claimed } else { Role::Asked };
                return self.after(at + found.length);
            }
            if let Some(length) = asking::introduces(rest).filter(|length| apart(*length)) {
                self.cues += 1;
                self.open = true;
                self.role = Role::Given;
                return self.after(at + length);
            }
            if let Some(label) = asking::label(rest) {
                self.cues += 1;
                self.claims |= label.claims;
                self.role = if label.claims { Role::Claimed } else { Role::Free };
                return self.after(at + label.length);
            }
        }
        // Find a such that a^2 = 2; a > 1 implies a > 0
        if let Some(length) = asking::conditions_follow(rest).filter(|length| apart(*length)) {
            self.cues += 1;
            self.end(at, false);
            self.role = Role::Condition { all: false };
            return self.after(at + length);
        }
        if let Some(length) = asking::follows_from(rest).filter(|length| !fresh && apart(*length)) {
            if self.role == Role::Free {
                self.role = Role::Given;
            }
            self.cues += 1;
            self.direct = true;
            self.end(at, false);
            self.role = Role::Claimed;
            return self.after(at + length);
        }
        let ideograph = rest.chars().next().filter(|c| is_ideograph(*c)).map(String::from);
        let word = ideograph.unwrap_or(word);
        if word.is_empty() || !apart(word.len()) {
            return None;
        }
        let role = match words::aside(&word)? {
            Aside::Condition => Role::Condition { all: false },
            Aside::Every if matches!(self.role, Role::Condition { .. }) && fresh => {
                Role::Condition { all: true }
            }
            Aside::ForAll => Role::Condition { all: true },
            Aside::Let if fresh => Role::Given,
            Aside::Question if fresh || matches!(self.role, Role::Condition { .. }) => Role::Claimed,
            // Between formulas in dollars; else it belongs to the formula.
            Aside::Joint
                if fresh || self.between_dollars(at, word.len()) || self.joins_relations(at, word.len()) =>
            {
                self.role
            }
            _ => return None,
        };
        self.cues += 1;
        self.end(at, false);
        self.empty |= self.open && matches!(role, Role::Claimed);
        self.open = matches!(role, Role::Condition { all: false });
        self.role = role;
        self.after(at + word.len())
    }

    /// Takes a label that is set in another type, `\textbf{Claim.}`; the place behind it.
    fn label_in_command(&mut self, at: usize) -> Option<usize> {
        const COMMANDS: &[&str] = &["\\textbf{", "\\emph{", "\\textit{", "\\textsc{", "\\text{"];
        let rest = self.text.piece(at..);
        let command = COMMANDS.iter().find(|command| rest.starts_with(**command))?;
        let inside = rest.piece(command.len()..);
        let close = inside.find('}')?;
        let words = inside.piece(..close).trim().trim_end_matches(['.', ':']);
        let label = asking::label(&format!("{words}: "))?;
        if label.length < words.len() || !self.text.piece(self.start..at).trim().is_empty() {
            return None;
        }
        self.cues += 1;
        self.claims |= label.claims;
        self.role = if label.claims { Role::Claimed } else { Role::Free };
        self.after(at + command.len() + close + 1)
    }

    fn after(&mut self, at: usize) -> Option<usize> {
        let rest = self.text.piece(at..);
        let gap = rest.len()
            - rest
                .trim_start_matches(|c: char| c.is_whitespace() || matches!(c, ':' | ',' | '¿' | '¡'))
                .len();
        self.start = at + gap;
        self.direct = true;
        Some(self.start)
    }

    /// Whether formulas in dollars stand at both sides.
    fn between_dollars(&self, at: usize, length: usize) -> bool {
        let closes = |text: &str| text.ends_with(['$']) || text.ends_with("\\)");
        let before = self.text.piece(..at).trim_end().trim_end_matches(',');
        let after = self.text.piece(at + length..).trim_start();
        closes(before)
            && (after.starts_with('$') || after.starts_with("\\(") || after.starts_with(char::is_alphabetic))
    }

    /// Whether relations stand at both sides: x + y = 5 and x y = 6.
    fn joins_relations(&self, at: usize, length: usize) -> bool {
        let relation = |text: &str| text.contains(['=', '<', '>', '≤', '≥']);
        let after = self.text.piece(at + length..);
        let end = after.find([',', ';', '?', ':']).unwrap_or(after.len());
        let end = end.min(after.find(". ").unwrap_or(after.len()));
        relation(self.text.piece(self.start..at)) && relation(after.piece(..end))
    }

    /// What a sign outside of formulas ends.
    fn stop(&self, at: usize, c: char) -> Option<Stop> {
        let rest = self.text.piece(at + c.len_utf8()..);
        let apart = rest.is_empty() || rest.starts_with(char::is_whitespace);
        match c {
            // t ? 2 is no question.
            '?' | '？' if rest.trim().is_empty() || !self.text.piece(..at).ends_with(char::is_whitespace) => {
                Some(Stop { sentence: true, question: true })
            }
            '。' => Some(Stop { sentence: true, question: false }),
            '.' if apart => Some(Stop { sentence: true, question: false }),
            ';' | '；' => Some(Stop { sentence: true, question: false }),
            // c: 3 gives c its value elsewhere; a = 2: a + 1
            ':' | '：' if apart && self.text.piece(self.start..at).contains(['=', '<', '>', '$']) => {
                Some(Stop { sentence: false, question: false })
            }
            ',' | '，' => {
                let next = rest.trim_start();
                let cue = asking::asks(next).is_some()
                    || next.split(|c: char| !c.is_alphabetic()).next().is_some_and(|word| {
                        matches!(words::aside(word), Some(Aside::Question | Aside::Let | Aside::Condition))
                    });
                (self.between_dollars(at, c.len_utf8()) || cue)
                    .then_some(Stop { sentence: false, question: false })
            }
            _ => None,
        }
    }

    /// Ends the piece before a place.
    fn end(&mut self, to: usize, question: bool) {
        let piece = self.text.piece(self.start..to);
        let inner = piece.trim().trim_end_matches([',', ' ']);
        let start = self.start + (piece.len() - piece.trim_start().len());
        self.start = to;
        if inner.is_empty() {
            // Is $a = b$? has a question mark behind its piece.
            return;
        }
        // Is a = b true?
        let inner = match self.role == Role::Claimed || question {
            true => asking::without_truth(inner),
            false => inner,
        };
        self.open = false;
        let mut span = Span::new(start, start + inner.len());
        // $f(1) = ?$
        let mut question = question;
        let unclosed = inner.trim_matches('$').trim_end();
        let open = unclosed.trim_end_matches(['?', '？']).trim_end();
        let asks = open.trim_end_matches('=').trim_end();
        if unclosed.ends_with(['=', '?', '？']) && !asks.is_empty() {
            question = true;
            if inner.starts_with('$') && inner.ends_with('$') && !asks.contains('$') {
                let from = start + inner.len() - inner.trim_start_matches('$').len();
                span = Span::new(from, from + asks.len());
            }
        }
        let direct = std::mem::take(&mut self.direct);
        self.pieces.push(Piece { span, role: self.role, sentence: self.sentence, direct, question });
    }
}

/// What ends at a sign.
struct Stop {
    sentence: bool,
    question: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(text: &str) -> Vec<(String, Role)> {
        let found = line(text, &|_| false).map(|line| line.pieces).unwrap_or_default();
        found.into_iter().map(|piece| (text[piece.span.range()].to_owned(), piece.role)).collect()
    }

    fn is(text: &str, pieces: &[(&str, Role)]) {
        let expected: Vec<(String, Role)> =
            pieces.iter().map(|(text, role)| ((*text).to_owned(), *role)).collect();
        assert_eq!(taken(text), expected, "{text}");
    }

    #[test]
    fn formulas_get_their_roles_from_the_words_between_them() {
        use Role::{Asked, Claimed, Free, Given};
        let condition = Role::Condition { all: false };
        is(
            "Let $f(t) = t^2$. Compute $f(1)$ and $f(2)$.",
            &[("$f(t) = t^2$", Given), ("$f(1)$", Asked), ("$f(2)$", Asked)],
        );
        is(
            "$p(t) = b_0 t$ with $b = (1, 0)$, $p(2)=?$",
            &[("$p(t) = b_0 t$", Free), ("$b = (1, 0)$", condition), ("p(2)", condition)],
        );
        is("$a(t) = t$, is $a(t) = 1$?", &[("$a(t) = t$", Free), ("$a(t) = 1$", Claimed)]);
        is("x > 0 and y > 0. is x + y > 0?", &[("x > 0", Free), ("y > 0", Free), ("x + y > 0", Claimed)]);
        is(
            "Claim: $t^2 >= 0$ for all $t$",
            &[("$t^2 >= 0$", Claimed), ("$t$", Role::Condition { all: true })],
        );
    }

    #[test]
    fn one_formula_is_no_line() {
        for text in ["t^2 + 1", "$t^2$", "f(x, y)", "[1, 2, 3]", "a, b", ""] {
            assert_eq!(line(text, &|_| false), None, "{text}");
        }
    }
}
