//! Named, subscripted indeterminates.
//!
//! **Order.** Symbols are in natural order: by base name, then accent, then indices with
//! numbers as numbers (t < t_1 < t_2 < t_10 < t_i), then upper indices. The order is total
//! and two symbols are equal only if all parts are.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// An index: a number or a word.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Index {
    /// `t_1`
    Number(i64),
    /// `t_i`, `b_{01}`
    Word(String),
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Index::Number(i) => write!(f, "{i}"),
            Index::Word(word) => f.write_str(word),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Parts {
    /// The first bytes of the base, in the order of texts: most bases are no longer, and numbers are compared faster.
    start: u64,
    base: String,
    accent: String,
    indices: Vec<Index>,
    upper: Vec<Index>,
}

/// The first eight bytes of a text as a number, in the order of texts.
fn start(text: &str) -> u64 {
    let mut bytes = [0; 8];
    for (byte, own) in bytes.iter_mut().zip(text.bytes()) {
        *byte = own;
    }
    u64::from_be_bytes(bytes)
}

impl Ord for Parts {
    fn cmp(&self, other: &Self) -> Ordering {
        let long = self.base.len() > 8 || other.base.len() > 8;
        let base = || if long { self.base.cmp(&other.base) } else { self.base.len().cmp(&other.base.len()) };
        self.start
            .cmp(&other.start)
            .then_with(base)
            .then_with(|| self.accent.cmp(&other.accent))
            .then_with(|| self.indices.cmp(&other.indices))
            .then_with(|| self.upper.cmp(&other.upper))
    }
}

impl PartialOrd for Parts {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A symbol such as t, t_1, p_{1,2} or p_0^{(3)}. Cheap to clone.
///
/// ```
/// use polarform::poly::Symbol;
/// assert!(Symbol::indexed("t", 2) < Symbol::indexed("t", 10));
/// assert_eq!(Symbol::indexed("t", 2).to_string(), "t2");
/// assert_eq!(Symbol::indexed("c", 2).to_string(), "c_2");
/// ```
#[derive(Clone, Eq)]
pub struct Symbol(Arc<Parts>);

impl PartialEq for Symbol {
    /// Indices first: members of one family differ in these, and numbers are compared faster than letters.
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (&*self.0, &*other.0);
        Arc::ptr_eq(&self.0, &other.0)
            || a.start == b.start
                && a.base.len() == b.base.len()
                && a.indices == b.indices
                && (a.base.len() <= 8 || a.base == b.base)
                && a.upper == b.upper
                && a.accent == b.accent
    }
}

impl Hash for Symbol {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash(state);
    }
}

impl PartialOrd for Symbol {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Symbol {
    fn cmp(&self, other: &Self) -> Ordering {
        if Arc::ptr_eq(&self.0, &other.0) { Ordering::Equal } else { self.0.cmp(&other.0) }
    }
}

impl Symbol {
    /// A plain symbol.
    pub fn new(base: impl Into<String>) -> Self {
        let base = base.into();
        let (accent, indices, upper) = (String::new(), Vec::new(), Vec::new());
        Symbol(Arc::new(Parts { start: start(&base), base, accent, indices, upper }))
    }

    /// base_index
    pub fn indexed(base: impl Into<String>, index: i64) -> Self {
        Symbol::new(base).with_indices([Index::Number(index)])
    }

    /// This symbol with further indices below.
    pub fn with_indices(&self, indices: impl IntoIterator<Item = Index>) -> Self {
        let mut parts = (*self.0).clone();
        parts.indices.extend(indices);
        Symbol(Arc::new(parts))
    }

    /// This symbol with one more number below: t gives t_3, t_i gives t_{i,3}.
    pub fn numbered(&self, index: i64) -> Self {
        self.with_indices([Index::Number(index)])
    }

    /// This symbol with further indices above.
    pub fn with_upper(&self, indices: impl IntoIterator<Item = Index>) -> Self {
        let mut parts = (*self.0).clone();
        parts.upper.extend(indices);
        Symbol(Arc::new(parts))
    }

    /// This symbol with a mark over it (`hat`, `bar`, …); an empty mark changes nothing.
    pub fn with_accent(&self, accent: &str) -> Self {
        let mut parts = (*self.0).clone();
        parts.accent.push_str(accent);
        Symbol(Arc::new(parts))
    }

    /// The name without indices.
    pub fn base(&self) -> &str {
        &self.0.base
    }

    /// The mark over it, or an empty text.
    pub fn accent(&self) -> &str {
        &self.0.accent
    }

    /// The indices below.
    pub fn indices(&self) -> &[Index] {
        &self.0.indices
    }

    /// The indices above.
    pub fn upper(&self) -> &[Index] {
        &self.0.upper
    }

    /// Whether it has neither indices nor accent.
    pub fn is_plain(&self) -> bool {
        self.0.accent.is_empty() && self.0.indices.is_empty() && self.0.upper.is_empty()
    }
}

fn list(f: &mut fmt::Formatter<'_>, indices: &[Index]) -> fmt::Result {
    for (i, index) in indices.iter().enumerate() {
        if i > 0 {
            f.write_str(",")?;
        }
        write!(f, "{index}")?;
    }
    Ok(())
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.accent() {
            "" => f.write_str(self.base())?,
            accent => write!(f, "{accent}({})", self.base())?,
        }
        match self.indices() {
            [] => {}
            // The arguments t1, t2, … of polar forms are written as one types them.
            [Index::Number(i)]
                if *i >= 0 && matches!(self.base(), "s" | "t" | "u" | "v" | "w" | "x" | "y" | "z") =>
            {
                write!(f, "{i}")?;
            }
            [Index::Number(i)] if *i >= 0 => write!(f, "_{i}")?,
            [Index::Word(word)] if word.chars().count() == 1 => write!(f, "_{word}")?,
            many => {
                f.write_str("_{")?;
                list(f, many)?;
                f.write_str("}")?;
            }
        }
        if !self.upper().is_empty() {
            f.write_str("^{(")?;
            list(f, self.upper())?;
            f.write_str(")}")?;
        }
        Ok(())
    }
}

impl fmt::Debug for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn natural_order_and_text() {
        let word = |w: &str| Index::Word(w.to_owned());
        let ordered = [
            Symbol::new("c"),
            Symbol::new("t"),
            Symbol::indexed("t", 1),
            Symbol::indexed("t", 1).numbered(2),
            Symbol::indexed("t", 2),
            Symbol::indexed("t", 10),
            Symbol::new("t").with_indices([word("i")]),
            Symbol::new("t").with_accent("hat"),
            Symbol::new("t1"),
            Symbol::new("tangential"),
            Symbol::new("tangentials"),
            Symbol::new("tangents"),
            Symbol::new("\u{3c4}"),
        ];
        assert!(ordered.windows(2).all(|pair| pair[0] < pair[1]));
        let texts: Vec<String> = ordered.iter().map(Symbol::to_string).collect();
        assert_eq!(texts[..9], ["c", "t", "t1", "t_{1,2}", "t2", "t10", "t_i", "hat(t)", "t1"]);
        assert_eq!(Symbol::indexed("p", 0).with_upper([Index::Number(3)]).to_string(), "p_0^{(3)}");
        assert_eq!(Symbol::indexed("t", -1).to_string(), "t_{-1}");
    }
}
