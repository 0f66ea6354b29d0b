//! Control sequences to tokens: what a command is, with the arguments that are no formulas.

use super::super::Word;
use super::super::characters::is_letter_in_braces;
use super::super::commands::{self, Role};
use super::super::environments;
use super::super::token::{Env, Fence, Tok};
use super::Lexer;
use crate::formula::source::{Pieces, Span};
use crate::formula::{Accent, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::letters;

/// Words, labels and column specifications may be this long.
pub(super) const MAX_RAW: usize = 2_000;
/// Once an argument was found without end, later ones must be shorter (keeps the lexer linear).
const MAX_RAW_AFTER_FAILURE: usize = 100;

impl Lexer<'_> {
    pub(super) fn command(&mut self) {
        let start = self.at;
        let tail = self.rest().piece(1..);
        let letters = tail.bytes().take_while(u8::is_ascii_alphabetic).count();
        let length = if letters > 0 { letters } else { tail.chars().next().map_or(0, char::len_utf8) };
        let name = tail.piece(..length).to_owned();
        let end = start + 1 + length;
        // A line break after a backslash is a space to TeX; beside an alignment it is what Markdown or a converter
        // left of two backslashes.
        let name = match name.as_str() {
            "\n" | "\r" if self.text.contains('&') => "\\".to_owned(),
            "\n" | "\r" | "\t" => " ".to_owned(),
            _ => name,
        };
        let Some(command) = commands::lookup(&name).or_else(|| operator_of(&name)) else {
            // \polar(F): the name of a function
            let called = self.text.piece(end..self.end).trim_start().starts_with('(');
            return match (self.words)(&name, called) {
                Word::Name if called => self.push_from(start, Tok::Word(start as u32 + 1, end as u32), end),
                _ => self.unknown(start, end, &name),
            };
        };
        self.at = end;
        if self.peek() == Some('*') && matches!(name.as_str(), "operatorname" | "tag" | "hspace" | "vspace") {
            self.at += 1;
        }
        self.known(start, self.at, command.role(), &name);
    }

    fn unknown(&mut self, start: usize, end: usize, name: &str) {
        let problem = match name {
            "" => Diagnostic::error(Code::UnexpectedEnd, "a lone backslash at the end"),
            "(" | ")" | "[" | "]" => {
                Diagnostic::error(Code::UnexpectedCharacter, format!("a '\\{name}' inside a formula"))
                    .reason("it delimits a whole formula")
                    .hint("read each formula by itself")
            }
            _ => {
                // the reader adds a hint if it comes to report this
                Diagnostic::error(Code::UnknownCommand, format!("unknown command \\{name}"))
            }
        };
        self.bad(start, end, problem);
    }

    pub(in crate::language::latex) fn known(&mut self, start: usize, end: usize, role: Role, name: &str) {
        match role {
            Role::Symbol(symbol) => self.push_from(start, Tok::Symbol(symbol), end),
            Role::Prime => self.push_from(start, Tok::Prime(1), end),
            Role::Relation(Rel::Implies | Rel::Iff) if self.begins_formula() => {
                self.push_from(start, Tok::Text(start as u32 + 1, end as u32), end);
            }
            Role::Word => self.push_from(start, Tok::Text(start as u32 + 1, end as u32), end),
            Role::Relation(rel) => self.push_from(start, Tok::Rel(rel), end),
            Role::Percent => self.push_from(start, Tok::Percent, end),
            Role::Dot => self.push_from(start, Tok::Dot, end),
            Role::Star => self.push_from(start, Tok::Star, end),
            Role::Slash => self.push_from(start, Tok::Slash, end),
            Role::Cross => self.push_from(start, Tok::Cross, end),
            Role::Circ => self.push_from(start, Tok::Circ, end),
            Role::Binary(symbol) => self.push_from(start, Tok::Binary(symbol), end),
            Role::Ellipsis => self.push_from(start, Tok::Ellipsis, end),
            Role::Open(fence) => self.push_from(start, Tok::Open(fence), end),
            Role::Close(fence) => self.push_from(start, Tok::Close(fence), end),
            Role::Bar => self.push_from(start, Tok::Bar, end),
            Role::DoubleBar => self.push_from(start, Tok::DoubleBar, end),
            Role::Mid => self.push_from(start, Tok::Mid, end),
            Role::Gap => self.push_from(start, Tok::Gap, end),
            Role::Space => self.control_spaces(start),
            Role::Transparent => {}
            Role::Sized => {
                self.skip_spaces();
                if self.starts_with(".") {
                    self.at += 1; // an invisible bracket
                    self.sized = None;
                } else {
                    self.sized.get_or_insert(start);
                }
            }
            Role::Dropped(count) => {
                for _ in 0..count {
                    if self.raw_argument(start, name).is_none() {
                        return;
                    }
                }
                if matches!(name, "hspace" | "tag") {
                    self.push_from(start, Tok::Gap, self.at);
                }
            }
            Role::DroppedFirst => {
                self.raw_argument(start, name);
            }
            Role::RowBreak => {
                self.row_break_argument();
                self.push_from(start, Tok::RowBreak, self.at);
            }
            Role::Left | Role::Right | Role::Middle => self.delimiter(start, role, name),
            // \textbf{Q}_i: a letter, not a word.
            Role::Text if name == "textbf" && is_letter_in_braces(self.rest().piece(end - self.at..)) => {
                self.push_from(start, Tok::Command(Role::Accent(Accent::Bold)), end);
            }
            Role::Text => {
                if let Some(content) = self.raw_argument(start, name) {
                    let word = self.text.piece(content.range());
                    // \text{err}_i is a name, not a word beside one.
                    let named = word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_alphabetic());
                    let (from, to) = (content.start as u32, content.end as u32);
                    let kind = if named && self.starts_with("_") {
                        Tok::Word(from, to)
                    } else {
                        Tok::Text(from, to)
                    };
                    self.push_from(start, kind, self.at);
                }
            }
            Role::Upright => self.upright(start, name),
            Role::Begin | Role::End => self.environment(start, role == Role::Begin, name),
            Role::Not => self.not(start),
            Role::Unsupported(reason) => {
                let problem = Diagnostic::error(Code::UnsupportedLatex, format!("\\{name} is not supported"))
                    .reason(reason);
                self.bad(start, end, problem);
            }
            Role::Function
            | Role::Big(_)
            | Role::Integral
            | Role::IntegralOver(_)
            | Role::Modulus
            | Role::Accent(_)
            | Role::Switch(_)
            | Role::Fraction
            | Role::Binomial
            | Role::Root
            | Role::Brace
            | Role::Stacked
            | Role::LongArrow
            | Role::Infix(_)
            | Role::ForAll
            | Role::Lines
            | Role::Plain(_) => self.push_from(start, Tok::Command(role), end),
        }
    }

    /// One `\ ` is nothing, two or more in a row separate formulas like `\quad`.
    fn control_spaces(&mut self, start: usize) {
        let mut count = 1;
        let mut end = self.at;
        loop {
            let tail = self.text.piece(end..self.end);
            let next = tail.trim_start_matches([' ', '\t', '\n', '\r']);
            let Some(after) = next.strip_prefix("\\ ") else { break };
            end = self.end - after.len();
            count += 1;
        }
        if count > 1 {
            self.push_from(start, Tok::Gap, end);
        }
    }

    /// The star or the length in brackets that may follow `\\`.
    fn row_break_argument(&mut self) {
        if self.starts_with("*") {
            self.at += 1;
        }
        let Some(tail) = self.rest().strip_prefix('[') else { return };
        let Some(close) = tail.bytes().take(24).position(|byte| byte == b']') else { return };
        let length = tail.piece(..close).trim();
        let unit =
            length.trim_start_matches(['-', '+', '.', ' ', '0', '1', '2', '3', '4', '5', '6', '7', '8', '9']);
        if unit.len() < length.len() && matches!(unit, "pt" | "em" | "ex" | "mm" | "cm" | "in" | "mu" | "px")
        {
            self.at += close + 2;
        }
    }

    /// The content of the `{…}` that follows; otherwise adds a bad token.
    fn raw_argument(&mut self, start: usize, name: &str) -> Option<Span> {
        self.skip_spaces();
        if self.peek() != Some('{') {
            let problem =
                Diagnostic::error(Code::UnexpectedToken, format!("\\{name} needs an argument in braces"));
            self.bad(start, self.at, problem);
            return None;
        }
        let open = self.at;
        let mut depth = 0_usize;
        let mut escaped = false;
        for (offset, byte) in self.rest().bytes().enumerate().take(self.max_raw) {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'{' => depth += 1,
                b'}' => {
                    depth -= 1;
                    if depth == 0 {
                        self.at = open + offset + 1;
                        return Some(Span::new(open + 1, open + offset));
                    }
                }
                _ => {}
            }
        }
        self.max_raw = MAX_RAW_AFTER_FAILURE;
        let problem = Diagnostic::error(
            Code::Unbalanced,
            format!("the argument of \\{name} has no end within {MAX_RAW} bytes"),
        );
        self.bad(start, open + 1, problem.hint("add the missing '}'"));
        None
    }

    /// `\mathrm{area}` and `\operatorname{area}` are one name; `\mathrm{F(t)}` is read as it stands.
    fn upright(&mut self, start: usize, name: &str) {
        self.skip_spaces();
        if let Some(letter) = self.peek().filter(char::is_ascii_alphabetic) {
            let content = (self.at as u32, (self.at + letter.len_utf8()) as u32);
            return self.push_from(start, Tok::Word(content.0, content.1), content.1 as usize);
        }
        let open = self.at;
        let hyphen = name == "operatorname";
        let word = self.run(|byte| match byte {
            b'{' | b' ' | b'\t' | b'\n' | b'\r' => true,
            b'-' => hyphen,
            _ => byte.is_ascii_alphanumeric(),
        });
        let content = self.rest().piece(..word);
        let is_name = content.strip_prefix('{').is_some_and(|inner| {
            !inner.contains('{') && inner.trim_start().starts_with(|c: char| c.is_ascii_alphabetic())
        });
        if is_name && self.rest().piece(word..).starts_with('}') {
            let kind = Tok::Word((open + 1) as u32, (open + word) as u32);
            self.push_from(start, kind, open + word + 1);
        } else if name == "operatorname" && !self.is_greek_in_braces() {
            let problem = Diagnostic::error(Code::UnexpectedToken, "\\operatorname needs a word in braces");
            self.bad(start, open, problem.hint("write \\operatorname{area}"));
        }
    }

    /// Whether one Greek letter stands in braces here.
    fn is_greek_in_braces(&self) -> bool {
        let letter = self.rest().strip_prefix("{\\").and_then(|rest| rest.split_once('}'));
        letter.is_some_and(|(name, _)| letters::sign(name.trim_end()).is_some())
    }

    fn delimiter(&mut self, start: usize, role: Role, name: &str) {
        self.skip_spaces();
        let from = self.at;
        let Some(c) = self.peek() else {
            let problem = Diagnostic::error(Code::UnexpectedEnd, format!("\\{name} needs a bracket"));
            return self.bad(start, from, problem);
        };
        let (fence, length) = if c == '\\' {
            let tail = self.rest().piece(1..);
            let letters = tail.bytes().take_while(u8::is_ascii_alphabetic).count();
            let length = if letters > 0 { letters } else { tail.chars().next().map_or(0, char::len_utf8) };
            let fence = match commands::lookup(tail.piece(..length)).map(|command| command.role()) {
                Some(Role::Open(fence)) if role != Role::Right => Some(fence),
                Some(Role::Close(fence)) if role != Role::Left => Some(fence),
                Some(Role::Bar | Role::Mid) => Some(Fence::Bar),
                Some(Role::DoubleBar) => Some(Fence::Norm),
                _ => None,
            };
            (fence, 1 + length)
        } else {
            let fence = match (c, role == Role::Left) {
                ('(', true) | (')', false) => Some(Fence::Paren),
                ('[', true) | (']', false) => Some(Fence::Square),
                ('<', true) | ('>', false) => Some(Fence::Angle),
                ('|', _) => Some(Fence::Bar),
                ('‖', _) => Some(Fence::Norm),
                ('.', _) => Some(Fence::Dot),
                // a square bracket may close what a parenthesis opens, also the other way round
                _ => None,
            };
            (fence, c.len_utf8())
        };
        let end = from + length;
        match (fence, role) {
            (Some(fence), Role::Left) => self.push_from(start, Tok::Left(fence), end),
            (Some(fence), Role::Right) => self.push_from(start, Tok::Right(fence), end),
            (Some(Fence::Bar), _) => self.push_from(start, Tok::Mid, end),
            _ => {
                let problem = Diagnostic::error(
                    Code::UnsupportedLatex,
                    format!("'{}' cannot be read after \\{name}", self.text.piece(from..end)),
                );
                self.bad(start, end, problem);
            }
        }
    }

    fn environment(&mut self, start: usize, begins: bool, name: &str) {
        let Some(argument) = self.raw_argument(start, name) else { return };
        let environment = self.text.piece(argument.range()).trim().to_owned();
        let Some(env) = environments::lookup(&environment) else {
            let problem = Diagnostic::error(
                Code::UnknownCommand,
                format!("unknown environment {}", environment.escape_debug()),
            );
            let problem = match environments::nearest_known(&environment) {
                Some(near) => problem.hint(format!("did you mean {near}?")),
                None => problem.hint("the environments that can be read are listed in docs/latex.md"),
            };
            return self.bad(start, self.at, problem);
        };
        if !begins {
            return self.push_from(start, Tok::End(env), self.at);
        }
        let plain = environment.trim_end_matches('*');
        let takes_columns = matches!(plain, "array" | "subarray" | "alignat" | "alignedat");
        match env {
            Env::Matrix(_) if environment.ends_with('*') => self.optional_position(&["l", "c", "r"]),
            Env::Array | Env::Rows => self.optional_position(&["t", "c", "b"]),
            Env::Matrix(_) => self.columns(),
            Env::Cases => {}
        }
        if takes_columns {
            let before = self.at;
            self.skip_spaces();
            // without columns it is an error to TeX, but the cells can be read all the same
            if self.peek() == Some('{') {
                if self.raw_argument(start, "begin").is_none() {
                    return;
                }
            } else {
                self.at = before;
            }
        }
        self.push_from(start, Tok::Begin(env), self.at);
    }

    /// The alignment of columns in brackets, as some packages have it: `[ll]`.
    fn columns(&mut self) {
        let Some(tail) = self.rest().strip_prefix('[') else { return };
        let columns = tail.bytes().take_while(|byte| matches!(byte, b'l' | b'c' | b'r')).count();
        if columns > 0 && tail.piece(columns..).starts_with(']') {
            self.at += columns + 2;
        }
    }

    /// One of the `positions`, in brackets.
    fn optional_position(&mut self, positions: &[&str]) {
        let rest = self.rest();
        let trimmed = rest.trim_start();
        let Some(tail) = trimmed.strip_prefix('[') else { return };
        let Some(close) = tail.bytes().take(8).position(|byte| byte == b']') else { return };
        if positions.contains(&tail.piece(..close).trim()) {
            self.at += rest.len() - trimmed.len() + close + 2;
        }
    }

    fn not(&mut self, start: usize) {
        self.skip_spaces();
        if self.peek() == Some('=') {
            return self.push_from(start, Tok::Rel(Rel::Ne), self.at + 1);
        }
        if let Some(rest) = self.rest().strip_prefix("\\in")
            && !rest.starts_with(|c: char| c.is_ascii_alphabetic())
        {
            return self.push_from(start, Tok::Rel(Rel::NotIn), self.at + 3);
        }
        let end = self.at;
        let problem = Diagnostic::error(Code::UnsupportedLatex, "\\not is read only before = and \\in");
        self.bad(start, end, problem);
    }
}

/// The operator that a macro of another file surely stands for: \Sum, \Prod, \Int.
fn operator_of(name: &str) -> Option<&'static commands::Command> {
    let small = name.to_lowercase();
    let capital = small.len() > 2 && name.chars().skip(1).eq(small.chars().skip(1));
    commands::lookup(&small).filter(|known| capital && matches!(known.role(), Role::Big(_) | Role::Integral))
}
