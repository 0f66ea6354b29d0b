//! Numerals: digits, groups of digits, decimals.

use super::commands::Role;
use super::lexer::{Lexer, MAX_DIGITS};
use super::token::Tok;
use crate::formula::source::Pieces;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::math::number::{LiteralError, Rational, parse_decimal};

impl Lexer<'_> {
    pub(super) fn number(&mut self) {
        let start = self.at;
        let is_digit = |byte: u8| byte.is_ascii_digit();
        let mut length = self.run(is_digit);
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let mut parts = 1;
        // `1.` before a space is the end of a sentence, `1..n` a range
        while let Some(tail) = self.rest().piece(length..).strip_prefix('.') {
            let fraction = digits(tail);
            if fraction == 0 {
                break;
            }
            length += 1 + fraction;
            parts += 1;
        }
        if let Some((tail, problem)) = self.number_tail(length, parts) {
            return match problem {
                Some(problem) => self.bad(start, start + tail, problem),
                None => self.push(Tok::Number, tail),
            };
        }
        let end = start + length;
        if parts > 2 {
            let problem = Diagnostic::error(Code::BadNumber, "a number with two decimal points")
                .hint("write a product with \\cdot and a list with commas");
            self.bad(start, end, problem);
        } else if length > MAX_DIGITS {
            let problem = Diagnostic::error(
                Code::TooManyDigits,
                format!("a number of {length} digits; at most {MAX_DIGITS} can be read"),
            );
            self.bad(start, end, problem);
        } else {
            self.push(Tok::Number, length);
        }
    }

    /// What goes on with the number of `length` bytes here: groups of three digits, digits after a
    /// decimal comma, or what cannot be read. Its whole length, and what is wrong with it.
    fn number_tail(&self, length: usize, parts: usize) -> Option<(usize, Option<Diagnostic>)> {
        let rest = self.rest();
        let (number, tail) = rest.split_at(length);
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let malformed = |end: usize| {
            Diagnostic::error(Code::BadNumber, format!("malformed number '{}'", rest.piece(..end)))
        };
        // 2.5E2
        if let Some(power) = tail.strip_prefix(['e', 'E']) {
            let sign = usize::from(power.starts_with(['+', '-']));
            let count = digits(power.piece(sign..));
            let named = power.piece(sign + count..).starts_with(|c: char| c.is_alphabetic());
            if count > 0 && tail.starts_with('E') && !named {
                return Some((length + 1 + sign + count, None));
            }
            if count > 0 {
                let power = power.piece(..sign + count);
                let problem = malformed(length + 1 + sign + count)
                    .reason("a power of ten, or the name e?")
                    .hint(format!("write {number} \\cdot 10^{{{power}}} for the power of ten"));
                return Some((length + 1 + sign + count, Some(problem)));
            }
        }
        // 12.5 e 3, which prints as 12.5e3
        let apart = tail.trim_start_matches(' ');
        if let Some(power) = apart.strip_prefix(['e', 'E']) {
            let exponent = power.trim_start_matches(' ');
            let count = digits(exponent);
            if count > 0 && (apart.len() < tail.len() || exponent.len() < power.len()) {
                let problem = malformed(rest.len() - exponent.len() + count)
                    .reason("a power of ten, or the name e?")
                    .hint(format!(
                        "write {number} \\cdot 10^{{{}}} for the power of ten",
                        exponent.piece(..count)
                    ));
                return Some((rest.len() - exponent.len() + count, Some(problem)));
            }
        }
        // 0.1\overline{6}
        if let Some(end) = repeating_end(rest, if parts == 1 { length + 1 } else { length })
            && (parts > 1 || tail.starts_with('.'))
        {
            return Some((end, None));
        }
        // 0.\dot3, 0.\dot{1}42\dot{7}
        let point = if parts == 1 { usize::from(tail.starts_with('.')) } else { 0 };
        if parts + point == 2
            && let Some((_, more)) = dotted(tail.piece(point..))
        {
            return Some((length + point + more, None));
        }
        // 0.(3)
        if let Some(period) = tail.strip_prefix(".(")
            && let count @ 1.. = digits(period)
            && period.piece(count..).starts_with(')')
        {
            let end = length + 2 + count + 1;
            let problem = malformed(end).reason("repeating decimals are not read").hint(format!(
                "write a fraction: ({number} + \\frac{{{}}}{{{}}})",
                period.piece(..count),
                "9".repeat(count)
            ));
            return Some((end, Some(problem)));
        }
        if parts > 1 {
            let end =
                self.decimals_in_groups(length, number.rfind('.').map_or(0, |point| length - point - 1));
            return (end > length).then_some((end, None));
        }
        // 2,5 where the side of a relation begins: a decimal, or two numbers?
        if let Some(fraction) = tail.strip_prefix(',')
            && let count @ 1.. = digits(fraction)
            && self.begins_side()
            && !goes_on_as_list(fraction.piece(count..))
            && !(self.has_name_before() && is_next(number, fraction.piece(..count)))
        {
            let end = length + 1 + count;
            let problem = malformed(end)
                .reason("a decimal comma, or two numbers?")
                .hint(format!("write {number}{{,}}{0}, or a space: {number}, {0}", fraction.piece(..count)));
            return Some((end, Some(problem)));
        }
        // 1{,}5 is a decimal comma, 1{,}024 may be a thousand and 24
        if let Some(fraction) = tail.strip_prefix("{,}")
            && let count @ 1.. = digits(fraction)
        {
            let end = length + 3 + count;
            if let Some(end) = thousands(rest, length) {
                return Some((end, None));
            }
            let problem = (count == 3 && length <= 3 && !number.starts_with('0')).then(|| {
                malformed(end).reason("a decimal comma, or thousands?").hint(format!(
                    "write {number}{} or {number}.{}",
                    fraction.piece(..count),
                    fraction.piece(..count)
                ))
            });
            return Some((end, problem));
        }
        // 10\,000
        let mut end = length;
        let group = |text: &str| {
            let blank = ["\\,", "~"].into_iter().find(|blank| text.starts_with(blank))?;
            (digits(text.piece(blank.len()..)) == 3).then_some(blank.len() + 3)
        };
        while length <= 3
            && let Some(more) = group(rest.piece(end..))
        {
            end += more;
        }
        // 10\,000.123\,456
        if end > length
            && let Some(fraction) = rest.piece(end..).strip_prefix('.')
            && let count @ 1.. = digits(fraction)
        {
            return Some((self.decimals_in_groups(end + 1 + count, count), None));
        }
        // 12\,34 is neither one number nor clearly two; of x^2 and \frac12 TeX takes single digits
        let is_argument = matches!(self.last(), Some(Tok::Sup | Tok::Sub | Tok::Command(_)));
        let more = ["\\,", "~"].into_iter().find_map(|blank| rest.piece(end..).strip_prefix(blank));
        if let Some(more) = more.filter(|more| !is_argument && digits(more) > 0) {
            let end = rest.len() - more.len() + digits(more);
            let problem = malformed(end)
                .reason("groups of a number have three digits")
                .hint("write the number without spaces, or a product with \\cdot");
            return Some((end, Some(problem)));
        }
        (end > length).then_some((end, None))
    }

    /// The end of the decimals that end at `end`, of which `last` stand in the last group: each group but the
    /// last has three digits.
    fn decimals_in_groups(&self, end: usize, last: usize) -> usize {
        let (mut end, mut last) = (end, last);
        while last == 3
            && let Some(more) =
                ["\\,", "~"].into_iter().find_map(|blank| self.rest().piece(end..).strip_prefix(blank))
            && let count @ 1..=3 = more.bytes().take_while(u8::is_ascii_digit).count()
        {
            end = self.rest().len() - more.len() + count;
            last = count;
        }
        end
    }

    /// Whether the side of a relation begins here, perhaps with a sign.
    fn begins_side(&self) -> bool {
        let mut before = self.kinds_before();
        match before.next() {
            None | Some(Tok::Rel(_)) => true,
            Some(Tok::Minus) => matches!(before.next(), None | Some(Tok::Rel(_))),
            _ => false,
        }
    }

    /// Whether a relation whose left side is a name stands before: `i = 0,1`.
    fn has_name_before(&self) -> bool {
        let mut before = self.kinds_before();
        matches!(before.next(), Some(Tok::Rel(_)))
            && matches!(before.next(), Some(Tok::Letter(_) | Tok::Symbol(_)))
            && match before.next() {
                None => true,
                Some(Tok::Command(role)) => role == Role::ForAll,
                Some(kind) => matches!(
                    kind,
                    Tok::Comma
                        | Tok::Gap
                        | Tok::Text(..)
                        | Tok::Open(_)
                        | Tok::OpenBrace
                        | Tok::RowBreak
                        | Tok::Align
                        | Tok::Begin(_)
                ),
            }
    }

    fn kinds_before(&self) -> impl Iterator<Item = Tok> {
        self.tokens.iter().rev().map(|token| token.kind).filter(|kind| *kind != Tok::Skip)
    }
}

/// The end of the period that begins at `start`, as in `0.1\overline{6}`.
fn repeating_end(text: &str, start: usize) -> Option<usize> {
    let tail = text.get(start..)?.strip_prefix("\\overline{")?;
    let count = tail.bytes().take_while(u8::is_ascii_digit).count();
    (count > 0 && tail.piece(count..).starts_with('}')).then(|| text.len() - tail.len() + count + 1)
}

/// The end of a number with two groups of thousands or more, or with one and a decimal point, after the first
/// `length` digits: 1{,}234{,}567, 1{,}234.5.
fn thousands(text: &str, length: usize) -> Option<usize> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let mut end = length;
    while let Some(group) = text.piece(end..).strip_prefix("{,}").filter(|group| digits(group) == 3) {
        end = text.len() - group.len() + 3;
    }
    let groups = (end - length) / 6;
    let decimals = text.piece(end..).strip_prefix('.').map_or(0, digits);
    let fits = length <= 3 && !text.starts_with('0') && (groups > 1 || groups == 1 && decimals > 0);
    fits.then_some(if decimals > 0 { end + 1 + decimals } else { end })
}

/// The period whose first and last digit have dots at the beginning of the text, and how many bytes it takes:
/// `\dot3`, `\dot{1}4285\dot{7}`.
fn dotted(text: &str) -> Option<(String, usize)> {
    fn digit(text: &str) -> Option<(char, &str)> {
        let rest = text.strip_prefix("\\dot")?.trim_start_matches(' ');
        let braced = rest.strip_prefix('{');
        let rest = braced.unwrap_or(rest);
        let digit = rest.chars().next().filter(char::is_ascii_digit)?;
        Some((digit, if braced.is_some() { rest.piece(1..).strip_prefix('}')? } else { rest.piece(1..) }))
    }
    let (first, rest) = digit(text)?;
    let plain = rest.bytes().take_while(u8::is_ascii_digit).count();
    let (period, rest) = match digit(rest.piece(plain..)) {
        Some((last, after)) => (format!("{first}{}{last}", rest.piece(..plain)), after),
        None if plain == 0 => (first.to_string(), rest),
        None => return None,
    };
    Some((period, text.len() - rest.len()))
}

/// The value of a decimal with a period: 0.1\overline{6}, 0.1\dot6; `None` if it has none.
pub(super) fn repeating(text: &str) -> Option<std::result::Result<Rational, LiteralError>> {
    let (head, period) = match text.find("\\dot") {
        Some(at) => (text.piece(..at), dotted(text.piece(at..))?.0),
        None => {
            let (head, period) = text.strip_suffix('}')?.split_once("\\overline{")?;
            (head, period.to_owned())
        }
    };
    let places = head.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let nines = "9".repeat(period.len()) + &"0".repeat(places);
    let value = || {
        let before = parse_decimal(head.trim_end_matches('.'))?;
        Ok(before + parse_decimal(&period)? / parse_decimal(&nines)?)
    };
    Some(value())
}

/// Whether more items of a list follow: `1,3,5`, `1,3, \dots, n`.
fn goes_on_as_list(text: &str) -> bool {
    let item = text.trim_start().strip_prefix(',');
    let rest = item.unwrap_or(text).trim_start();
    let rest = rest.strip_prefix("\\,").unwrap_or(rest).trim_start();
    let dots = ["..", "…", "\\dots", "\\ldots", "\\cdots"];
    let ends = rest.starts_with("\\q") || rest.starts_with("\\text") || rest.starts_with(['}', '&', '$']);
    let glued = item.is_some_and(|item| item.starts_with(|c: char| !c.is_whitespace())) && !ends;
    let number = item.is_some() && rest.starts_with(|c: char| c.is_ascii_digit());
    glued || number || dots.iter().any(|dots| rest.starts_with(dots))
}

/// Whether the second number follows the first: 0,1 are indices.
fn is_next(first: &str, second: &str) -> bool {
    match (first.parse::<u64>(), second.parse::<u64>()) {
        (Ok(first), Ok(second)) => first.checked_add(1) == Some(second),
        _ => false,
    }
}
