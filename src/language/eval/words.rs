//! Words without a value: products of letters where that makes sense, otherwise errors.
//!
//! `uvw` and `at^2` are products when no such word is known: a factor for each letter, and what is
//! attached to the word belongs to its last letter, as in print. A note says so. Four letters and
//! more are a product only if each of them has a value or is a parameter here; else the word was
//! meant as a word.

use super::machine::Machine;
use super::names::name_of;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::latex::Word;
use crate::language::lexicon::{letters, words};
use crate::language::value::Value;
use crate::math::poly::Symbol;

/// Up to so many letters without a value make a product.
const FEW: usize = 3;

impl Machine {
    /// The product of letters that a formula stands for whose innermost name is a word without a
    /// value; `None` if the formula is anything else.
    ///
    /// # Errors
    /// The word with something attached to it has two readings.
    pub(super) fn spelled_out(&mut self, expr: &Expr) -> Result<Option<Expr>, Diagnostic> {
        let Some(word) = innermost(expr).filter(|_| self.reading.is_none()) else { return Ok(None) };
        let Kind::Name(text) = &word.kind else { return Ok(None) };
        if !self.is_product_of_letters(text) || self.has_own_value(expr) {
            return Ok(None);
        }
        if let Some((callee, groups)) = call_of(expr, word) {
            self.last_letter_is_called(text, callee, groups)?;
        }
        let letters = one_by_one(text, word.span);
        self.not_a_value(text, &letters, word)?;
        let spaced: Vec<&str> = text.split("").filter(|letter| !letter.is_empty()).collect();
        self.note_product(text, &spaced.join(" "), word.span);
        let Some((last, others)) = letters.split_last() else { return Ok(None) };
        let mut factors = others.to_vec();
        factors.push(with_innermost(expr, last));
        Ok(Some(Expr::new(Kind::Mul(factors), expr.span)))
    }

    /// Refuses a word of prose that stands between blanks among factors: it is no product of its letters. What the words
    /// around it ask for, if anything, is told by those who read requests.
    pub(super) fn is_no_prose(&self, statement: &Expr) -> Result<(), Diagnostic> {
        if self.reading.is_some() {
            return Ok(());
        }
        let Some((word, text)) = self.prose_in(statement) else { return Ok(()) };
        let error = Diagnostic::error(Code::UnknownName, format!("'{text}' is a word, not a formula"))
            .at(word.span)
            .reason("words are not read");
        let advice = words::elsewhere(text).or_else(|| words::prose(text)).unwrap_or_default();
        Err(error.hint(if advice.is_empty() {
            "write a formula; polarform functions lists the functions"
        } else {
            advice
        }))
    }

    fn prose_in<'a>(&self, expr: &'a Expr) -> Option<(&'a Expr, &'a str)> {
        if let Kind::Mul(factors) = &expr.kind {
            for (at, factor) in factors.iter().enumerate() {
                let Kind::Name(word) = &factor.kind else { continue };
                let spaced = (at == 0 || factors[at - 1].span.end < factor.span.start)
                    && factors.get(at + 1).is_none_or(|next| factor.span.end < next.span.start);
                if spaced && words::prose(word).is_some() && self.lookup(&Symbol::new(word)).is_none() {
                    return Some((factor, word));
                }
            }
        }
        let mut children = Vec::new();
        expr.for_each_child(&mut |child| children.push(child));
        children.into_iter().find_map(|child| self.prose_in(child))
    }

    /// `fx` may be f(x), if f is a function and x is none.
    fn not_a_value(&mut self, word: &str, letters: &[Expr], place: &Expr) -> Result<(), Diagnostic> {
        for pair in letters.windows(2) {
            if self.is_function(&pair[0]) && !self.is_function(&pair[1]) {
                let (Kind::Name(f), Kind::Name(x)) = (&pair[0].kind, &pair[1].kind) else { continue };
                return Err(Diagnostic::error(
                    Code::AmbiguousProduct,
                    format!("'{word}' is not defined: is it a value of {f} or a product?"),
                )
                .at(place.span)
                .reason("not defined")
                .hint(format!("write {f}({x}) for the value"))
                .hint(format!("or write {f} {x} for the product")));
            }
        }
        Ok(())
    }

    /// Whether a name has a value that can be called.
    fn is_function(&mut self, name: &Expr) -> bool {
        let name = name_of(name, self);
        matches!(
            name.and_then(|name| self.lookup(&name)),
            Some(
                Value::Function(_)
                    | Value::Polar(_)
                    | Value::Geometry(_)
                    | Value::Piecewise(_)
                    | Value::Builtin(_)
            )
        )
    }

    /// One note for all the products of a statement.
    fn note_product(&mut self, word: &str, product: &str, span: Span) {
        let read = format!("'{word}' is {product}");
        match self.notes.iter_mut().find(|note| note.code == Code::Letters) {
            Some(known) if known.message.contains(&read) => {}
            Some(known) => {
                known.message = format!("{}, {read}", known.message);
            }
            None => {
                self.notes
                    .push(Diagnostic::note(Code::Letters, format!("read as a product: {read}")).at(span));
            }
        }
    }

    /// Whether a word has no meaning, and each of its letters may be a factor.
    pub(crate) fn is_product_of_letters(&self, word: &str) -> bool {
        let count = word.len();
        let lone = |letter: char| self.lookup(&Symbol::new(letter.to_string())).is_some();
        count > 1
            && word.bytes().all(|byte| byte.is_ascii_alphabetic())
            && !self.is_known_word(word)
            && words::elsewhere(word).is_none()
            && (count <= FEW || word.chars().all(lone))
    }

    /// What a run of letters in LaTeX is, where products of letters are usual and need no note:
    /// `called` says whether a parenthesis follows, `alone` which letters stand by themselves in
    /// the same formula.
    pub(crate) fn word_in_latex(&self, word: &str, called: bool, alone: &dyn Fn(char) -> bool) -> Word {
        let is_letter =
            |letter: char| alone(letter) || self.lookup(&Symbol::new(letter.to_string())).is_some();
        let spaced = || word.chars().map(String::from).collect::<Vec<_>>().join(" ");
        let function = (self.tools.function)(word).or((self.tools.alias)(word)).is_some()
            || crate::language::syntax::is_special(word);
        if self.lookup(&Symbol::new(word)).is_some() || (function && called) {
            return Word::Name;
        }
        if word.len() > FEW && (function || (self.tools.argument_word)(word)) {
            return Word::Name;
        }
        if letters::sign(word).is_some() {
            let message = format!("'{word}' is a Greek letter or a product of letters?");
            return Word::Refused(Box::new(
                Diagnostic::error(Code::UnknownName, message)
                    .reason("not defined")
                    .hint(format!("write \\{word} for the letter"))
                    .hint(format!("write {} for the product", spaced())),
            ));
        }
        // nPr(5, 2)
        let elsewhere = called && words::elsewhere(word).is_some();
        match elsewhere
            || words::is_foreign_function(word)
            || (word.len() > FEW && !word.chars().all(is_letter))
        {
            true => Word::Refused(Box::new(self.unknown_word(word))),
            false => Word::Letters,
        }
    }

    /// Whether a word means something here: a value, a function, a letter of another alphabet.
    pub(super) fn is_known_word(&self, word: &str) -> bool {
        self.lookup(&Symbol::new(word)).is_some()
            || (self.tools.function)(word).is_some()
            || (self.tools.is_word)(word)
            || (self.tools.synonym)(word).is_some()
            || letters::sign(word).is_some()
            || crate::language::syntax::is_special(word)
    }

    /// `foo_1` may be defined though foo is not.
    fn has_own_value(&mut self, expr: &Expr) -> bool {
        let mut at = expr;
        loop {
            match &at.kind {
                Kind::Subscript(base, _) | Kind::Upper(base, _) => {
                    if name_of(at, self).is_some_and(|name| self.lookup(&name).is_some()) {
                        return true;
                    }
                    at = base;
                }
                Kind::Pow(base, _) | Kind::Prime(base, _) | Kind::Factorial(base) | Kind::Apply(base, _) => {
                    at = base;
                }
                _ => return false,
            }
        }
    }

    /// In `tF(2)` the F is called, if it is a function; `ab(c + d)` might be a call of ab.
    fn last_letter_is_called(
        &mut self,
        word: &str,
        callee: &Expr,
        groups: &[Vec<Expr>],
    ) -> Result<(), Diagnostic> {
        let letters = one_by_one(word, callee.span);
        let functions: Vec<bool> = letters.iter().map(|letter| self.is_function(letter)).collect();
        let mut functions = functions.into_iter();
        let family = letters.last().map(|letter| with_innermost(callee, letter));
        let last = functions.next_back().unwrap_or(false)
            || family.is_some_and(|member| matches!(self.indexed_callee(&member), Ok(Some(_))));
        let before = functions.any(|function| function);
        let spaced: Vec<String> = word.chars().map(String::from).collect();
        match (before, last) {
            (false, true) => Ok(()),
            (true, true) => Err(Diagnostic::error(
                Code::AmbiguousProduct,
                format!(
                    "'{word}' is not defined: is the product of the functions called, or the last of them?"
                ),
            )
            .at(callee.span)
            .reason("not defined")
            .hint(format!("write ({})(...) for the value of the product", spaced.join(" ")))),
            _ => {
                let error = self.unknown_function(word, callee);
                Err(match groups {
                    [group] if group.len() == 1 => {
                        error.hint(format!("for a product write {} * (...)", spaced.join(" ")))
                    }
                    _ => error,
                })
            }
        }
    }

    /// Refuses a word that is a product of letters where it is not clear how far it goes.
    pub(super) fn is_one_factor(&mut self, expr: &Expr, place: &str) -> Result<(), Diagnostic> {
        let Some(Expr { kind: Kind::Name(word), span }) = innermost(expr) else { return Ok(()) };
        if !self.is_product_of_letters(word) || self.has_own_value(expr) {
            return Ok(());
        }
        let spaced: Vec<String> = word.chars().map(String::from).collect();
        Err(Diagnostic::error(Code::AmbiguousProduct, format!("how far does the {place} go?"))
            .at(*span)
            .reason(format!("'{word}' is not defined"))
            .hint(format!("write ({}) in parentheses for the product of the letters", spaced.join(" "))))
    }
}

/// The name under indices, powers, primes, factorials and arguments.
fn innermost(expr: &Expr) -> Option<&Expr> {
    let mut at = expr;
    loop {
        match &at.kind {
            Kind::Name(name) => return (name.len() > 1).then_some(at),
            Kind::Subscript(base, _)
            | Kind::Upper(base, _)
            | Kind::Pow(base, _)
            | Kind::Prime(base, _)
            | Kind::Factorial(base)
            | Kind::Apply(base, _) => at = base,
            _ => return None,
        }
    }
}

/// The same formula with another innermost name.
fn with_innermost(expr: &Expr, name: &Expr) -> Expr {
    let inner = |base: &Expr| Box::new(with_innermost(base, name));
    let kind = match &expr.kind {
        Kind::Subscript(base, indices) => Kind::Subscript(inner(base), indices.clone()),
        Kind::Upper(base, indices) => Kind::Upper(inner(base), indices.clone()),
        Kind::Pow(base, exponent) => Kind::Pow(inner(base), exponent.clone()),
        Kind::Prime(base, order) => Kind::Prime(inner(base), *order),
        Kind::Factorial(base) => Kind::Factorial(inner(base)),
        Kind::Apply(base, groups) => Kind::Apply(inner(base), groups.clone()),
        _ => return name.clone(),
    };
    Expr::new(kind, Span::new(name.span.start, expr.span.end.max(name.span.end)))
}

/// The call of which the word is the callee, with its primes and indices.
fn call_of<'a>(expr: &'a Expr, word: &Expr) -> Option<(&'a Expr, &'a [Vec<Expr>])> {
    let mut at = expr;
    let mut found = None;
    while !std::ptr::eq(at, word) {
        at = match &at.kind {
            Kind::Apply(base, groups) => {
                found = Some((base.as_ref(), groups.as_slice()));
                base
            }
            Kind::Subscript(base, _)
            | Kind::Upper(base, _)
            | Kind::Pow(base, _)
            | Kind::Prime(base, _)
            | Kind::Factorial(base) => base,
            _ => return None,
        };
    }
    found
}

/// The letters of a word as names.
fn one_by_one(word: &str, span: Span) -> Vec<Expr> {
    let place = |at: usize| match span.len() == word.len() {
        true => Span::new(span.start + at, span.start + at + 1),
        false => span,
    };
    word.char_indices().map(|(at, letter)| Expr::new(Kind::Name(letter.to_string()), place(at))).collect()
}
