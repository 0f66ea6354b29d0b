//! Tokens to tree: the grammar, windows, sequences and relations.
//!
//! ```text
//! formula  = row { rowbreak row }                     rows that begin with a relation join the row above
//! row      = item { ("," | ";" | "." | gap) item }    side by side: Sequence
//! item     = words | "∀" items [":" row] | chain { ("⇒" | "⇔") chain }
//! chain    = range { relation range }
//! range    = sum [".." sum]
//! sum      = [sign] product { sign product }
//! product  = operand { ["·" | "*" | "/"] operand }    from the left; "/" takes one operand
//! operand  = factor { ("∘" | "×" | "∪" | …) factor }
//! factor   = atom { script | "'" | "!" | arguments }
//! script   = ("_" | "^") argument                     subscripts first, then primes, then superscripts
//! arguments= "(" row { ";" row } ")"                  only after a name, see `postfix`
//! atom     = number | name | word | "…" | brackets | matrix | cases
//!          | big [bounds] product | integral | function operand | fraction | derivative [product]
//!          | accent argument | "√" argument | binomial | brace
//! argument = "{" row "}" | one token
//! brackets = "(" items ")" | "[" items "]" | "{" items ["|" row] "}" | "|" sum "|" | "‖" sum "‖" | "⌊" sum "⌋" …
//! ```
//!
//! A [`Reader`] walks over a *window* of the tokens; the content of a pair of
//! brackets, an argument, a cell and a row are windows of their own, so no rule
//! can read past the end of what it stands in. Nesting costs one level of
//! recursion each and is capped, length is handled by loops.

use super::commands::{self, Role};
use super::lexer::lex;
use super::nesting::pair;
use super::token::{ALONE, Tok, Token};
use super::{Word, Words};
use crate::formula::source::{Pieces, Span};
use crate::formula::{Enclosure, Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};

/// Levels of nesting that are read at most. Brackets and arguments count two, so that the deepest
/// formula can be read, and its tree walked, within the 2 MiB stack of a thread.
pub(super) const MAX_DEPTH: u32 = 256;
/// Factorials, slashes and the like on one operand before they count as nesting.
const FREE_WRAPPERS: u32 = 4;
/// All wrappers beyond the free ones, in one formula.
const MAX_WRAPPERS: u32 = 256;

/// After so many problems in one formula, no more corrections are looked for.
const MAX_HINTS: usize = 100;

pub(super) type Result<T> = std::result::Result<T, Box<Diagnostic>>;

/// A range of token indices.
pub(super) type Window = std::ops::Range<usize>;

/// What is being read, and how far.
pub(super) struct Reader<'t> {
    pub text: &'t str,
    pub tokens: Vec<Token>,
    /// Problems of bad tokens, by their numbers.
    lexical: Vec<Diagnostic>,
    /// The next token.
    pub pos: usize,
    /// One past the window.
    pub end: usize,
    /// In a row, words and wide spaces separate formulas; elsewhere they do not.
    pub row: bool,
    /// Unreadable pieces become [`Kind::Unread`] instead of an error.
    pub tolerant: bool,
    /// The formula is a query, not a part of a page.
    pub query: bool,
    /// Where a `|` that opens nothing and a `:` end the expression (in sets).
    pub in_set: bool,
    /// Where a `:` ends the expression (after ∀).
    pub colon_ends: bool,
    /// The bars that are open in this window, innermost last.
    pub bars: Vec<Enclosure>,
    pub depth: u32,
    wrappers: u32,
    /// Whether `\over` or `\choose` occurs at all.
    has_infix: bool,
    /// What the tolerant reader passed over.
    pub problems: Vec<Diagnostic>,
}

impl<'t> Reader<'t> {
    /// A reader of `text[range]`.
    pub fn new(text: &'t str, range: Span, tolerant: bool) -> Self {
        Reader::with_words(text, range, tolerant, &|_, _| Word::Letters)
    }

    /// A reader of a query, told what runs of letters are.
    pub fn of_query(text: &'t str, range: Span, words: Words) -> Self {
        Reader { query: true, ..Reader::with_words(text, range, false, words) }
    }

    fn with_words(text: &'t str, range: Span, tolerant: bool, words: Words) -> Self {
        let (mut tokens, mut lexical) = lex(text, range, words);
        pair(&mut tokens, &mut lexical);
        let end = tokens.len();
        let has_infix = tokens.iter().any(|token| matches!(token.kind, Tok::Command(Role::Infix(_))));
        Reader {
            text,
            tokens,
            lexical,
            pos: 0,
            end,
            row: false,
            tolerant,
            query: false,
            in_set: false,
            colon_ends: false,
            bars: Vec::new(),
            depth: 0,
            wrappers: 0,
            has_infix,
            problems: Vec::new(),
        }
    }

    // ---- tokens -------------------------------------------------------------

    /// The next token of the window, past layout.
    pub fn peek(&mut self) -> Option<Tok> {
        while self.pos < self.end {
            let kind = self.tokens[self.pos].kind;
            match kind {
                Tok::Skip | Tok::RowBreak | Tok::Align => self.pos += 1,
                Tok::Gap if !self.row => self.pos += 1,
                _ => return Some(kind),
            }
        }
        None
    }

    /// The token at or after `at` within the window, past layout: its index and kind.
    pub fn look(&self, at: usize) -> Option<(usize, Tok)> {
        (at..self.end).map(|i| (i, self.tokens[i].kind)).find(|&(_, kind)| !is_layout(kind))
    }

    /// Takes the token that [`Reader::peek`] showed.
    pub fn bump(&mut self) -> Span {
        let span = self.tokens[self.pos].span();
        self.pos += 1;
        span
    }

    /// Takes the next token if it is `kind`.
    pub fn eat(&mut self, kind: Tok) -> Option<Span> {
        (self.peek() == Some(kind)).then(|| self.bump())
    }

    pub fn span_at(&self, at: usize) -> Span {
        self.tokens.get(at).map_or_else(|| self.here(), |token| token.span())
    }

    pub fn text_at(&self, at: usize) -> &'t str {
        self.text.piece(self.span_at(at).range())
    }

    /// The bracket that belongs to the one at `at`.
    pub fn partner(&self, at: usize) -> Option<usize> {
        let partner = self.tokens.get(at)?.partner;
        (partner != ALONE).then_some(partner as usize)
    }

    /// The window between the bracket at `at` and its partner.
    pub fn inside(&self, at: usize) -> Result<Window> {
        match self.partner(at) {
            Some(close) => Ok(at + 1..close),
            None => Err(self.unexpected(at)),
        }
    }

    /// From the first of `window`'s tokens to the last, without layout at the ends.
    pub fn trim(&self, window: Window) -> Window {
        let Window { mut start, mut end } = window;
        while start < end && is_layout(self.tokens[start].kind) {
            start += 1;
        }
        while start < end && is_layout(self.tokens[end - 1].kind) {
            end -= 1;
        }
        start..end
    }

    /// The bytes of a window.
    pub fn span_of(&self, window: Window) -> Span {
        let window = self.trim(window);
        if window.is_empty() {
            return self.span_at(window.start.min(self.tokens.len().saturating_sub(1)));
        }
        self.span_at(window.start).to(self.span_at(window.end - 1))
    }

    /// The place after the last token taken.
    pub fn here(&self) -> Span {
        if let Some(token) = self.tokens.get(self.pos).filter(|token| token.cut && self.pos < self.end) {
            return Span::new(token.span().start, token.span().start);
        }
        match self.pos.checked_sub(1).and_then(|at| self.tokens.get(at)) {
            Some(token) => Span::new(token.span().end, token.span().end),
            None => {
                self.tokens.first().map_or_else(Span::default, |t| Span::new(t.span().start, t.span().start))
            }
        }
    }

    /// Where the next token begins.
    pub fn start(&mut self) -> usize {
        self.peek();
        if self.pos < self.end { self.tokens[self.pos].span().start } else { self.here().start }
    }

    /// From `start` to the end of the last token taken.
    pub fn since(&self, start: usize) -> Span {
        Span::new(start, self.here().end)
    }

    pub fn node(&self, kind: Kind, start: usize) -> Expr {
        Expr::new(kind, self.since(start))
    }

    // ---- problems -----------------------------------------------------------

    /// Why the token at `at` cannot stand there.
    pub fn unexpected(&self, at: usize) -> Box<Diagnostic> {
        if at >= self.end {
            return self.ended();
        }
        let token = self.tokens[at];
        if let Tok::Bad(number) = token.kind
            && let Some(problem) = self.lexical.get(number as usize)
        {
            let problem = problem.clone();
            let name = self.text_at(at).trim_start_matches('\\');
            let wants_hint = problem.code == Code::UnknownCommand && problem.hints.is_empty();
            return Box::new(if wants_hint && self.problems.len() < MAX_HINTS {
                problem.hint(commands::hint(name))
            } else {
                problem
            });
        }
        let text = shorten(self.text_at(at));
        let problem = Diagnostic::error(Code::UnexpectedToken, format!("'{text}' cannot stand here"));
        let problem = match token.kind {
            Tok::Rel(_) => problem.reason("something should stand on its left"),
            Tok::Sub | Tok::Sup => problem.reason("there is nothing it could be attached to"),
            Tok::Plus | Tok::Minus | Tok::Dot | Tok::Star | Tok::Slash | Tok::Cross | Tok::Circ => {
                problem.reason("an operand is missing beside it")
            }
            Tok::Comma | Tok::Semicolon => problem.reason("an item of the list is missing"),
            Tok::Command(Role::Infix(_)) => {
                problem.reason("it must stand in a group of its own").hint("write {a \\over b}")
            }
            _ => problem,
        };
        Box::new(problem.at(token.span()))
    }

    /// The window ends where something is missing.
    pub fn ended(&self) -> Box<Diagnostic> {
        let (what, span) = match self.pos.checked_sub(1).filter(|&at| at < self.tokens.len()) {
            Some(at) => {
                (format!("something is missing after '{}'", shorten(self.text_at(at))), self.span_at(at))
            }
            None => ("there is nothing to read".to_owned(), self.here()),
        };
        let code = if self.pos == 0 { Code::Empty } else { Code::UnexpectedEnd };
        Box::new(Diagnostic::error(code, what).at(span))
    }

    /// The problem of whatever comes next.
    pub fn stuck<T>(&mut self) -> Result<T> {
        self.peek();
        Err(self.unexpected(self.pos))
    }

    fn too_deep(&self) -> Box<Diagnostic> {
        let problem = Diagnostic::error(Code::TooDeep, "the formula is nested too deeply")
            .reason(format!("at most {MAX_DEPTH} levels can be read"))
            .hint("define parts of it under names of their own");
        Box::new(problem.at(self.span_at(self.pos.min(self.tokens.len().saturating_sub(1)))))
    }

    // ---- nesting ------------------------------------------------------------

    /// One level further in.
    pub fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if self.depth >= MAX_DEPTH {
            return Err(self.too_deep());
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Counts the `count`-th layer around one operand (`n!!!…`, `a/b/c/…`).
    pub fn wrap(&mut self, count: u32) -> Result<()> {
        if count > FREE_WRAPPERS {
            self.wrappers += 1;
            if self.wrappers > MAX_WRAPPERS {
                return Err(self.too_deep());
            }
        }
        Ok(())
    }

    /// Reads all of `window`; the reader then stands where it stood before.
    pub fn within<T>(&mut self, window: Window, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let outer = (self.pos, self.end, self.row, self.tolerant, self.in_set, self.colon_ends);
        let bars = std::mem::take(&mut self.bars);
        (self.pos, self.end) = (window.start, window.end);
        (self.row, self.tolerant, self.in_set, self.colon_ends) = (false, false, false, false);
        // a bracket and its content are two levels of the tree
        let result = if self.depth + 2 > MAX_DEPTH { Err(self.too_deep()) } else { self.whole(read) };
        (self.pos, self.end, self.row, self.tolerant, self.in_set, self.colon_ends) = outer;
        self.bars = bars;
        result
    }

    /// Reads the window, all of it, one level further in.
    fn whole<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        self.depth += 2;
        let result = read(self);
        self.depth -= 2;
        if result.is_ok() && self.peek().is_some() { self.stuck() } else { result }
    }

    /// Whether a window holds nothing but layout.
    pub fn is_blank(&self, window: Window) -> bool {
        window.into_iter().all(|at| is_layout(self.tokens[at].kind))
    }

    /// The parts of a window between the tokens that `separates` accepts, brackets passed over.
    pub fn split(&self, window: Window, separates: impl Fn(Tok) -> bool) -> Vec<Window> {
        let mut parts = Vec::new();
        let mut start = window.start;
        let mut at = window.start;
        while at < window.end {
            if separates(self.tokens[at].kind) {
                parts.push(start..at);
                start = at + 1;
            }
            at = self.after(at).min(window.end);
        }
        parts.push(start..window.end);
        parts
    }

    /// The index after the token at `at`, and after its partner if it opens something.
    pub fn after(&self, at: usize) -> usize {
        match self.partner(at) {
            Some(close) if close > at => close + 1,
            _ => at + 1,
        }
    }

    // ---- windows of several kinds ---------------------------------------------

    /// A window read as one row: formulas and words side by side.
    pub fn row_in(&mut self, window: Window) -> Result<Expr> {
        self.whole_row(window, false, false)
    }

    /// A window read as one row. If `tolerant`, unreadable pieces are passed over; if `columns`,
    /// also the first `&` may separate two formulas.
    pub fn whole_row(&mut self, window: Window, tolerant: bool, columns: bool) -> Result<Expr> {
        self.separate_gaps(window.clone(), columns);
        self.within(window, |reader| {
            reader.row = true;
            reader.tolerant = tolerant;
            reader.content()
        })
    }

    /// A window read as one expression, or several with commas between.
    pub fn expr_in(&mut self, window: Window) -> Result<Expr> {
        self.within(window, Self::content)
    }

    /// A window read as a list with commas between.
    pub fn list_in(&mut self, window: Window) -> Result<Vec<Expr>> {
        self.within(window, Self::list)
    }

    /// Items, or the one fraction that `\over` makes of the window.
    pub fn list(&mut self) -> Result<Vec<Expr>> {
        if self.has_infix
            && let Some(fraction) = self.infix()?
        {
            return Ok(vec![fraction]);
        }
        self.items()
    }

    /// Leaves only those wide spaces and `&` that stand between two formulas. The first `&` of a
    /// row marks where its formula is aligned, unless its `columns` hold formulas.
    fn separate_gaps(&mut self, window: Window, columns: bool) {
        let mut aligned = !columns;
        self.resolve(window, |kind| match kind {
            Tok::Gap => Some(Tok::Gap),
            Tok::Align if std::mem::take(&mut aligned) => Some(Tok::Skip),
            Tok::Align => Some(Tok::Gap),
            _ => None,
        });
    }

    /// In a set, a new row begins a new item.
    pub fn separate_rows(&mut self, window: Window) {
        self.resolve(window, |kind| (kind == Tok::RowBreak).then_some(Tok::Comma));
    }

    /// Replaces the layout tokens that `separator` names a separator for: by that where complete
    /// formulas stand on both sides, otherwise by nothing.
    fn resolve(&mut self, window: Window, mut separator: impl FnMut(Tok) -> Option<Tok>) {
        let mut at = window.start;
        let mut before: Option<Tok> = None;
        let mut pending: Option<(usize, Tok)> = None;
        while at < window.end {
            let kind = self.tokens[at].kind;
            let after = self.after(at).min(window.end);
            if let Some(becomes) = separator(kind) {
                self.tokens[at].kind = Tok::Skip;
                if becomes != Tok::Skip {
                    pending = Some((at, becomes));
                }
            } else if !is_layout(kind) {
                if let Some((place, becomes)) = pending.take()
                    && before.is_some_and(|kind| !waits(kind) && !is_separator(kind))
                    && !continues(kind)
                    && !is_separator(kind)
                {
                    self.tokens[place].kind = becomes;
                }
                before = Some(self.tokens[after - 1].kind);
            }
            at = after;
        }
    }
}

fn is_layout(kind: Tok) -> bool {
    matches!(kind, Tok::Skip | Tok::RowBreak | Tok::Align | Tok::Gap)
}

pub(super) fn is_separator(kind: Tok) -> bool {
    matches!(kind, Tok::Comma | Tok::Semicolon | Tok::Period | Tok::Gap)
}

/// Whether this token stands between two operands.
fn joins(kind: Tok) -> bool {
    kind.is_operator() || matches!(kind, Tok::Rel(_) | Tok::Circ | Tok::Binary(_) | Tok::Sub | Tok::Sup)
}

/// Whether an operand is still to come after this token.
pub(super) fn waits(kind: Tok) -> bool {
    joins(kind) || matches!(kind, Tok::Open(_) | Tok::Left(_) | Tok::Command(_))
}

/// Whether this token goes on with what stands before it.
pub(super) fn continues(kind: Tok) -> bool {
    joins(kind)
        || matches!(kind, Tok::Close(_) | Tok::Right(_) | Tok::Command(Role::Stacked | Role::LongArrow))
}

/// The beginning of a long text.
fn shorten(text: &str) -> String {
    let mut characters = text.chars();
    let head: String = characters.by_ref().take(24).collect();
    if characters.next().is_some() { format!("{head}…") } else { head }
}
