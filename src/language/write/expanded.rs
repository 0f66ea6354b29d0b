//! Polar forms written out, streamed: 2^n monomials without building any of them.
//!
//! f = Σ_k w_k e_k(t_1, …, t_n) has one coefficient for all monomials of a degree, so a
//! monomial costs no more than copying its letters. Degrees descend, and within a degree
//! the monomials follow each other lexicographically. Neighbouring monomials share a
//! prefix; only what differs is written anew into a line buffer.

use std::io::{self, Write};

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::Format;
use crate::budget;
use crate::math::blossom::PolarForm;
use crate::math::number::{Rational, binomials_where};

/// Bytes collected before they are handed on.
const CHUNK: usize = 1 << 16;

/// Number of monomials of the expanded form, saturating.
///
/// ```
/// use polarform::{blossom::PolarForm, number::integer, write::expanded_terms};
/// let f = PolarForm::new([1, 0, 5].map(integer).to_vec()); // 5 t1 t2 + 1
/// assert_eq!(expanded_terms(&f), 2);
/// ```
pub fn expanded_terms(form: &PolarForm<Rational>) -> u64 {
    let coefficients = form.coefficients();
    let mut counts = binomials_where(form.degree(), |i| !coefficients[i].is_zero());
    // The first count that is too large ends it: those further inward are larger still.
    let sum = counts.try_fold(0u64, |sum, (_, count)| sum.checked_add(count.to_u64()?));
    sum.unwrap_or(u64::MAX)
}

/// Writes the polar form with every monomial, in text, Unicode, LaTeX or SymPy syntax.
///
/// `names` are the arguments as they are to be printed, one for each of the n arguments.
/// Cost: the number of bytes written.
///
/// # Errors
/// Those of the output. JSON has no expanded form and is written as text.
///
/// ```
/// use polarform::{blossom::PolarForm, number::integer, write::{Format, write_expanded}};
/// let f = PolarForm::new([1, 2, 0, 3].map(integer).to_vec());
/// let names = ["t1", "t2", "t3"].map(String::from);
/// let mut out = Vec::new();
/// write_expanded(&mut out, &f, &names, Format::Text).unwrap();
/// assert_eq!(out, b"3 t1 t2 t3 + 2/3 t1 + 2/3 t2 + 2/3 t3 + 1");
/// ```
pub fn write_expanded(
    out: &mut dyn Write,
    form: &PolarForm<Rational>,
    names: &[impl AsRef<[u8]>],
    format: Format,
) -> io::Result<()> {
    stream(out, form, names, format, false)
}

/// The same with the monomials of each degree in brackets behind their common coefficient, as
/// the formula of a polar form in grouped notation is printed.
///
/// # Errors
/// Those of the output.
///
/// ```
/// use polarform::{blossom::PolarForm, number::integer, write::{Format, write_grouped}};
/// let f = PolarForm::new([1, 2, 0, 3].map(integer).to_vec());
/// let names = ["t1", "t2", "t3"].map(String::from);
/// let mut out = Vec::new();
/// write_grouped(&mut out, &f, &names, Format::Text).unwrap();
/// assert_eq!(out, b"3 t1 t2 t3 + 2/3 (t1 + t2 + t3) + 1");
/// ```
pub fn write_grouped(
    out: &mut dyn Write,
    form: &PolarForm<Rational>,
    names: &[impl AsRef<[u8]>],
    format: Format,
) -> io::Result<()> {
    stream(out, form, names, format, true)
}

fn stream(
    out: &mut dyn Write,
    form: &PolarForm<Rational>,
    names: &[impl AsRef<[u8]>],
    format: Format,
    grouped: bool,
) -> io::Result<()> {
    let n = form.degree();
    assert_eq!(names.len(), n, "one name for each argument");
    budget::charge_terms(expanded_terms(form));
    let times: &[u8] = match format {
        Format::Unicode => b"",
        Format::Sympy => b"*",
        _ => b" ",
    };
    let mut sink = Sink { out, buffer: Vec::with_capacity(2 * CHUNK) };
    let coefficients = form.coefficients();
    let mut weights: Vec<(usize, Rational)> = binomials_where(n, |k| !coefficients[k].is_zero())
        .filter(|(k, _)| !coefficients[*k].is_zero())
        .map(|(k, binomial)| (k, &coefficients[k] / Rational::from_integer(binomial)))
        .collect();
    weights.sort_unstable_by_key(|(k, _)| *k);
    // A single sum needs no brackets.
    let alone = weights.len() == 1 && weights[0].1.is_one();
    let mut first = true;
    for (k, w) in weights.into_iter().rev() {
        let bracket = grouped && k > 0 && k < n;
        let lead = coefficient(&w.abs(), k == 0, bracket, format);
        let separator: &[u8] = if w.is_negative() { b" - " } else { b" + " };
        let mut prefix = separator.to_vec();
        prefix.extend_from_slice(lead.as_bytes());
        let mut skip = 0;
        if first {
            sink.buffer.extend_from_slice(if w.is_negative() { b"-" } else { b"" });
            skip = separator.len();
            first = false;
        }
        if bracket {
            sink.buffer.extend_from_slice(&prefix[skip..]);
            sink.buffer.extend_from_slice(if alone { b"" } else { b"(" });
            sink.monomials(b" + ", 3, k, names, times)?;
            sink.buffer.extend_from_slice(if alone { b"" } else { b")" });
        } else {
            sink.monomials(&prefix, skip, k, names, times)?;
        }
    }
    if first {
        sink.buffer.push(b'0');
    }
    sink.out.write_all(&sink.buffer)
}

/// The magnitude before a monomial, with what separates it from the first name.
fn coefficient(w: &Rational, alone: bool, bracket: bool, format: Format) -> String {
    if w.is_one() && !alone {
        return String::new();
    }
    let number = match (format, w.denom().is_one()) {
        (_, true) => w.numer().to_string(),
        (Format::Latex, false) => format!("\\frac{{{}}}{{{}}}", w.numer(), w.denom()),
        (Format::Sympy, false) => format!("Rational({}, {})", w.numer(), w.denom()),
        _ => format!("{}/{}", w.numer(), w.denom()),
    };
    match (alone, format) {
        (true, _) => number,
        (false, Format::Sympy) => number + "*",
        // 4t₁t₂, but 4 (t₁ + t₂) and 1/2 t₁.
        (false, Format::Unicode) if !bracket && w.denom().is_one() => number,
        (false, _) => number + " ",
    }
}

struct Sink<'a> {
    out: &'a mut dyn Write,
    buffer: Vec<u8>,
}

impl Sink<'_> {
    /// All k-subsets of the names, each as prefix + product; the first one without the first
    /// `skip` bytes of the prefix.
    fn monomials(
        &mut self,
        prefix: &[u8],
        skip: usize,
        k: usize,
        names: &[impl AsRef<[u8]>],
        times: &[u8],
    ) -> io::Result<()> {
        let n = names.len();
        // The current monomial with its prefix, and where in it each factor starts.
        let mut line = prefix.to_vec();
        let mut starts = vec![0usize; k];
        let mut chosen: Vec<usize> = (0..k).collect();
        let mut from = 0;
        let mut skip = skip;
        loop {
            for i in from..k {
                if i > 0 {
                    line.extend_from_slice(times);
                }
                starts[i] = line.len();
                line.extend_from_slice(names[chosen[i]].as_ref());
            }
            // The last place runs through all remaining names: the innermost loop.
            if let Some(last) = k.checked_sub(1) {
                for name in &names[chosen[last]..] {
                    line.truncate(starts[last]);
                    line.extend_from_slice(name.as_ref());
                    self.buffer.extend_from_slice(&line[skip..]);
                    skip = 0;
                }
                chosen[last] = n - 1;
            } else {
                self.buffer.extend_from_slice(&line[skip..]);
            }
            if self.buffer.len() >= CHUNK {
                budget::steps(64);
                self.out.write_all(&self.buffer)?;
                self.buffer.clear();
            }
            let Some(i) = (0..k).rev().find(|&i| chosen[i] < n - k + i) else { return Ok(()) };
            chosen[i] += 1;
            for j in i + 1..k {
                chosen[j] = chosen[j - 1] + 1;
            }
            line.truncate(if i == 0 { prefix.len() } else { starts[i] - times.len() });
            from = i;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::{Combinations, integer, rational};

    fn written(form: &PolarForm<Rational>, format: Format) -> String {
        let names: Vec<String> = (1..=form.degree()).map(|i| format!("t{i}")).collect();
        let mut out = Vec::new();
        write_expanded(&mut out, form, &names, format).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// The same text joined from the definition.
    fn joined(form: &PolarForm<Rational>) -> String {
        let n = form.degree();
        let mut text = String::new();
        for (k, w) in form.weights().iter().enumerate().rev().filter(|(_, w)| !w.is_zero()) {
            for subset in Combinations::new(n, k) {
                text += match (text.is_empty(), w.is_negative()) {
                    (true, true) => "-",
                    (true, false) => "",
                    (false, true) => " - ",
                    (false, false) => " + ",
                };
                let mut parts = Vec::new();
                if !w.abs().is_one() || k == 0 {
                    parts.push(w.abs().to_string());
                }
                parts.extend(subset.iter().map(|i| format!("t{}", i + 1)));
                text += &parts.join(" ");
            }
        }
        if text.is_empty() { "0".into() } else { text }
    }

    #[test]
    fn agrees_with_the_definition() {
        for n in 0..9usize {
            for seed in 0..6i64 {
                let c = (0..=n as i64).map(|i| rational((seed * i * i - 7 * i + seed) % 9, 1 + i % 3));
                let form = PolarForm::new(c.collect());
                assert_eq!(written(&form, Format::Text), joined(&form), "n = {n}, seed {seed}");
            }
        }
    }

    #[test]
    fn grouped_as_the_formula_is_printed() {
        use crate::language::value::{Notation, Polar, PolarKind, symbol_expr};
        use crate::language::write::write_expr;
        use crate::math::poly::{Fraction, Symbol};
        for n in 0..7usize {
            for seed in 0..8i64 {
                let c = (0..=n as i64).map(|i| match seed {
                    7 => integer(i64::from(i == 1) * n as i64),
                    _ => rational((seed * i * i - 7 * i + seed) % 5, 1 + i % 3),
                });
                let form = PolarForm::new(c.collect::<Vec<Rational>>());
                let polar = Polar {
                    kind: PolarKind::Univariate(form.map(|c| Fraction::from(c.clone()))),
                    variables: vec![Symbol::new("t")],
                };
                for format in [Format::Text, Format::Unicode, Format::Latex, Format::Sympy] {
                    let names: Vec<String> = polar.arguments()[0]
                        .iter()
                        .map(|argument| write_expr(&symbol_expr(&argument[0]), format).unwrap())
                        .collect();
                    for (notation, grouped) in [(Notation::Grouped, true), (Notation::Expanded, false)] {
                        let mut out = Vec::new();
                        stream(&mut out, &form, &names, format, grouped).unwrap();
                        let printed = write_expr(&polar.body(notation), format).unwrap();
                        assert_eq!(String::from_utf8(out).unwrap(), printed, "{form:?} {format}");
                    }
                }
            }
        }
    }

    #[test]
    fn formats() {
        let form = PolarForm::new(vec![integer(0), integer(-1), rational(-5, 3)]);
        assert_eq!(written(&form, Format::Text), "-5/3 t1 t2 - 1/2 t1 - 1/2 t2");
        assert_eq!(written(&form, Format::Latex), r"-\frac{5}{3} t1 t2 - \frac{1}{2} t1 - \frac{1}{2} t2");
        assert_eq!(
            written(&form, Format::Sympy),
            "-Rational(5, 3)*t1*t2 - Rational(1, 2)*t1 - Rational(1, 2)*t2"
        );
    }
}
