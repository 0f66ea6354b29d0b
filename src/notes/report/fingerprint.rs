//! Names of findings that stay when lines move: for code hosts, and for lists of what is known.

use std::collections::HashMap;

use super::states_something;
use crate::judge::page::finding::{FileReport, Finding, Verdict};

/// What somebody should look at, by kind. These are the rules of SARIF, and what a configuration ignores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// A wrong formula.
    Refuted,
    /// A formula with a warning.
    Suspicious,
    /// A formula for which something is missing.
    Undecided,
    /// A formula that could not be read.
    Unread,
}

impl Rule {
    /// All rules, in the order of reports.
    pub const ALL: [Rule; 4] = [Rule::Refuted, Rule::Suspicious, Rule::Undecided, Rule::Unread];

    /// Its name.
    pub fn id(self) -> &'static str {
        match self {
            Rule::Refuted => "refuted",
            Rule::Suspicious => "suspicious",
            Rule::Undecided => "undecided",
            Rule::Unread => "unread",
        }
    }

    /// The rule that the verdict of a finding falls under, if any.
    pub fn of(finding: &Finding) -> Option<Rule> {
        match finding.verdict {
            _ if !states_something(finding) => None,
            Verdict::Refuted => Some(Rule::Refuted),
            Verdict::Undecided => Some(Rule::Undecided),
            Verdict::Unread => Some(Rule::Unread),
            Verdict::Definition | Verdict::Proved | Verdict::Sampled => None,
        }
    }
}

/// A fingerprint for each finding of a file: of its formula without blanks, and of how many of the same stood
/// before it. It does not depend on the verdict, on lines or on the name of the file.
///
/// Cost: linear.
pub fn fingerprints(report: &FileReport) -> Vec<String> {
    let mut seen: HashMap<u64, usize> = HashMap::new();
    report
        .findings
        .iter()
        .map(|finding| {
            let hash = hash(&finding.latex);
            let count = seen.entry(hash).or_default();
            *count += 1;
            format!("{hash:016x}:{count}")
        })
        .collect()
}

/// FNV-1a of what is not blank; the same in every version and on every machine.
fn hash(text: &str) -> u64 {
    let bytes = text.bytes().filter(|byte| !byte.is_ascii_whitespace());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::source::{SourceFile, Span};

    #[test]
    fn fingerprints_follow_the_formula() {
        assert_eq!(hash(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(hash("a"), 0xaf63_dc4c_8601_ec8c);
        let finding = |latex: &str| {
            Finding::new(Span::new(0, 1), Span::new(0, 1), latex.to_owned(), latex.to_owned(), 1)
        };
        let findings = vec![finding("a = b"), finding("a=b"), finding("c")];
        let report = FileReport::new(SourceFile::new("a.md", "x"), findings, Vec::new());
        let all = fingerprints(&report);
        assert_eq!(all[0].split(':').next(), all[1].split(':').next());
        assert!(all[0].ends_with(":1") && all[1].ends_with(":2") && all[2] != all[0]);
    }
}
