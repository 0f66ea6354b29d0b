//! The stamp of a woven file: how the next run knows that nothing changed.
//!
//! A stamp is a number made of everything the results depend on (the version of the program, the
//! options, all queries in their order) and of the results themselves. It stands in a comment at the
//! end of the woven file. A file whose stamp is right is up to date: nothing needs to be computed. A
//! file with a problem gets no stamp, so that the problem is told each time.
//!
//! Reference: the hash is FNV-1a with 64 bits (Fowler, Noll, Vo, draft-eastlake-fnv), enough to notice
//! a change; nobody is kept from forging it.

use crate::formula::source::Pieces;

const OPENING: &str = "<!-- woven by polarform ";
const CLOSING: &str = " -->";

/// The version of the program that is part of every stamp.
pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Collects what a stamp depends on.
#[derive(Clone, Debug)]
pub(super) struct Digest(u64);

impl Digest {
    /// A digest of nothing but the version and a text that stands for all options.
    pub(super) fn new(options: &str) -> Self {
        let mut digest = Digest(0xcbf2_9ce4_8422_2325);
        digest.add(VERSION);
        digest.add(options);
        digest
    }

    /// Adds a text; where it ends counts.
    pub(super) fn add(&mut self, text: &str) {
        // 0xff occurs in no UTF-8.
        for byte in text.bytes().chain([0xff]) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The number as it is written.
    pub(super) fn text(&self) -> String {
        format!("{:016x}", self.0)
    }
}

/// A text without its stamp, and the stamp.
///
/// A text that does not end with a line end has a stamp that does not, either, so that nothing is lost.
pub(super) fn without_stamp(text: &str) -> (&str, Option<&str>) {
    let line = text.strip_suffix("\r\n").or_else(|| text.strip_suffix('\n')).unwrap_or(text);
    let start = line.rfind('\n').map_or(0, |at| at + 1);
    let Some(inner) = line.piece(start..).strip_prefix(OPENING).and_then(|rest| rest.strip_suffix(CLOSING))
    else {
        return (text, None);
    };
    let Some((_, stamp)) = inner.split_once(": ").filter(|(_, stamp)| is_stamp(stamp)) else {
        return (text, None);
    };
    let mut body = text.piece(..start);
    if line.len() == text.len() {
        body = body.strip_suffix("\r\n").or_else(|| body.strip_suffix('\n')).unwrap_or(body);
    }
    (body, Some(stamp))
}

pub(super) fn is_stamp(text: &str) -> bool {
    text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// The text with a stamp at its end.
pub(super) fn with_stamp(body: &str, stamp: &str, line_end: &str) -> String {
    let line = format!("{OPENING}{VERSION}: {stamp}{CLOSING}");
    if body.is_empty() || body.ends_with('\n') {
        format!("{body}{line}{line_end}")
    } else {
        format!("{body}{line_end}{line}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stamp_comes_off_again() {
        let stamp = Digest::new("").text();
        for end in ["\n", "\r\n"] {
            for body in ["", "a", "a\n", "a\r\n", "a\n\n", "\n"] {
                let stamped = with_stamp(body, &stamp, end);
                assert_eq!(without_stamp(&stamped), (body, Some(stamp.as_str())), "{body:?} {end:?}");
            }
        }
        for other in ["a\n", "<!-- woven by polarform 0.1.0: 12 -->\n", "<!-- woven by polarform -->"] {
            assert_eq!(without_stamp(other), (other, None));
        }
    }

    #[test]
    fn everything_counts() {
        let digest = |parts: &[&str]| {
            let mut digest = Digest::new("x");
            parts.iter().for_each(|part| digest.add(part));
            digest.text()
        };
        assert_ne!(digest(&["a", "b"]), digest(&["ab"]));
        assert_ne!(digest(&["a", "b"]), digest(&["b", "a"]));
        assert_ne!(Digest::new("x").text(), Digest::new("y").text());
        assert_eq!(digest(&["a"]), digest(&["a"]));
    }
}
