//! Numerals: digits, groups of digits, decimals.

use super::lexer::{Lexer, MAX_DIGITS};
use super::token::Tok;
use crate::language::diagnostic::{Code, Diagnostic};

impl Lexer<'_> {
    pub(super) fn number(&mut self) {
        let start = self.at;
        let is_digit = |byte: u8| byte.is_ascii_digit();
        let mut length = self.run(is_digit);
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let mut parts = 1;
        // `1.` before a space is the end of a sentence, `1..n` a range
        while let Some(tail) = self.rest()[length..].strip_prefix('.') {
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
        let malformed =
            |end: usize| Diagnostic::error(Code::BadNumber, format!("malformed number '{}'", &rest[..end]));
        // 2.5E2
        if let Some(power) = tail.strip_prefix(['e', 'E']) {
            let sign = usize::from(power.starts_with(['+', '-']));
            let count = digits(&power[sign..]);
            if count > 0 {
                let power = &power[..sign + count];
                let problem = malformed(length + 1 + sign + count)
                    .reason("a power of ten, or the name e?")
                    .hint(format!("write {number} \\cdot 10^{{{power}}} for the power of ten"));
                return Some((length + 1 + sign + count, Some(problem)));
            }
        }
        // 0.(3)
        if let Some(period) = tail.strip_prefix(".(")
            && let count @ 1.. = digits(period)
            && period[count..].starts_with(')')
        {
            let end = length + 2 + count + 1;
            let problem = malformed(end).reason("repeating decimals are not read").hint(format!(
                "write a fraction: ({number} + \\frac{{{}}}{{{}}})",
                &period[..count],
                "9".repeat(count)
            ));
            return Some((end, Some(problem)));
        }
        if parts > 1 {
            return None;
        }
        // 1{,}5 is a decimal comma, 1{,}024 may be a thousand and 24
        if let Some(fraction) = tail.strip_prefix("{,}")
            && let count @ 1.. = digits(fraction)
        {
            let end = length + 3 + count;
            let problem = (count == 3 && length <= 3 && !number.starts_with('0')).then(|| {
                malformed(end).reason("a decimal comma, or thousands?").hint(format!(
                    "write {number}{} or {number}.{}",
                    &fraction[..count],
                    &fraction[..count]
                ))
            });
            return Some((end, problem));
        }
        // 10\,000
        let mut end = length;
        let group = |text: &str| {
            let blank = ["\\,", "~"].into_iter().find(|blank| text.starts_with(blank))?;
            (digits(&text[blank.len()..]) == 3).then_some(blank.len() + 3)
        };
        while length <= 3
            && let Some(more) = group(&rest[end..])
        {
            end += more;
        }
        (end > length).then_some((end, None))
    }
}
