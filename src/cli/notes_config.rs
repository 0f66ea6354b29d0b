//! `polarform.toml`: what is not reported, and declarations for all files.
//!
//! ```toml
//! [notes]
//! context = "definitions.txt"
//! ignore = ["undecided", "E601"]
//! exclude = ["drafts"]
//! baseline = "known.json"
//! ```
//! Paths are relative to the folder of the file.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::{Value, json};
use toml::Table;

use crate::judge::finding::{FileReport, Finding};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::notes::report::{Rule, fingerprints};

/// The name of the file.
const NAME: &str = "polarform.toml";

/// The settings for a check.
#[derive(Debug, Default)]
pub(super) struct Config {
    pub context: Option<PathBuf>,
    rules: Vec<Rule>,
    codes: Vec<Code>,
    exclude: Vec<PathBuf>,
    /// Fingerprints of what is known.
    known: BTreeSet<(String, String)>,
    /// How many findings were left out.
    left_out: AtomicUsize,
}

impl Config {
    /// Reads the settings: from the file that is named, else from the nearest one here or in a folder above.
    pub fn load(named: Option<&Path>) -> Result<Config, Diagnostic> {
        let here = std::env::current_dir().unwrap_or_default();
        let found = || here.ancestors().map(|folder| folder.join(NAME)).find(|path| path.is_file());
        let Some(path) = named.map(Path::to_owned).or_else(found) else { return Ok(Config::default()) };
        let text = fs::read_to_string(&path).map_err(|error| {
            Diagnostic::error(Code::File, format!("cannot read {}: {error}", path.display()))
        })?;
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        Config::parse(&text, &path, &folder)
    }

    fn parse(text: &str, path: &Path, folder: &Path) -> Result<Config, Diagnostic> {
        let wrong = |what: String, hint: &str| {
            Diagnostic::error(Code::Usage, format!("{}: {what}", path.display())).hint(hint.to_owned())
        };
        let table: Table = text
            .parse()
            .map_err(|error: toml::de::Error| wrong(error.message().to_owned(), "see docs/notes.md"))?;
        let mut config = Config::default();
        for (name, section) in &table {
            let section = section.as_table().filter(|_| name == "notes");
            let section =
                section.ok_or_else(|| wrong(format!("{name} is unknown"), "the section is [notes]"))?;
            for (key, value) in section {
                let words =
                    || strings(value).ok_or_else(|| wrong(format!("{key} takes strings"), "write [\"…\"]"));
                match key.as_str() {
                    "context" => config.context = words()?.first().map(|name| folder.join(name)),
                    "exclude" => config.exclude = words()?.iter().map(|name| folder.join(name)).collect(),
                    "ignore" => {
                        for word in words()? {
                            let rule = Rule::ALL.into_iter().find(|rule| rule.id() == word);
                            match (rule, word.parse::<Code>()) {
                                (Some(rule), _) => config.rules.push(rule),
                                (None, Ok(code)) => config.codes.push(code),
                                _ => {
                                    let rules = Rule::ALL.map(Rule::id).join(", ");
                                    let hint =
                                        format!("the rules are {rules}, and codes of problems such as E601");
                                    return Err(wrong(format!("{word} is no rule"), &hint));
                                }
                            }
                        }
                    }
                    "baseline" => {
                        if let Some(name) = words()?.first() {
                            config.known = baseline(&folder.join(name))?;
                        }
                    }
                    _ => {
                        let hint = "context, ignore, exclude and baseline are known";
                        return Err(wrong(format!("{key} is unknown"), hint));
                    }
                }
            }
        }
        Ok(config)
    }

    /// Whether a file in a folder is left out.
    pub fn excludes(&self, path: &Path) -> bool {
        let full = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        !self.exclude.is_empty() && self.exclude.iter().any(|excluded| full(path).starts_with(full(excluded)))
    }

    /// The report without what is ignored and, unless `all`, without what is known.
    pub fn filtered(&self, mut report: FileReport, all: bool) -> FileReport {
        let before = report.findings.len() + report.problems.len();
        report.problems.retain(|problem| !self.codes.contains(&problem.code));
        let mut prints = fingerprints(&report).into_iter();
        let known = |finding: &Finding, print: &str| {
            !all && finding.is_suspicious()
                && self.known.contains(&(file_name(&report.file), print.to_owned()))
        };
        let kept: Vec<Finding> = std::mem::take(&mut report.findings)
            .into_iter()
            .filter(|finding| {
                let known = prints.next().is_some_and(|print| known(finding, &print));
                !known && Rule::of(finding).is_none_or(|rule| !self.rules.contains(&rule))
            })
            .map(|mut finding| {
                if self.rules.contains(&Rule::Suspicious) {
                    finding.warning = None;
                }
                finding
            })
            .collect();
        report.findings = kept;
        let left_out = before - report.findings.len() - report.problems.len();
        self.left_out.fetch_add(left_out, Ordering::Relaxed);
        report
    }

    /// How many findings were left out so far, in words.
    pub fn remark(&self) -> Option<String> {
        let count = self.left_out.swap(0, Ordering::Relaxed);
        let findings = if count == 1 { "finding" } else { "findings" };
        (count > 0).then(|| format!("{count} {findings} not reported: ignored or known, as {NAME} says"))
    }

    /// What is refuted or suspicious in some reports, as a list to be named as baseline.
    pub fn baseline_of(reports: &[FileReport]) -> String {
        let mut known = Vec::new();
        for report in reports {
            for (finding, print) in report.findings.iter().zip(fingerprints(report)) {
                if finding.is_suspicious() {
                    known.push(json!({
                        "file": file_name(&report.file),
                        "fingerprint": print,
                        "verdict": finding.verdict.word(),
                        "latex": finding.latex,
                    }));
                }
            }
        }
        format!("{:#}\n", json!({"version": 1, "known": known}))
    }
}

/// The last part of the name of a file: lists of what is known may move with it.
fn file_name(file: &crate::formula::source::SourceFile) -> String {
    let path = Path::new(file.name());
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// One string or a list of them.
fn strings(value: &toml::Value) -> Option<Vec<String>> {
    match value {
        toml::Value::String(one) => Some(vec![one.clone()]),
        toml::Value::Array(all) => all.iter().map(|one| one.as_str().map(str::to_owned)).collect(),
        _ => None,
    }
}

fn baseline(path: &Path) -> Result<BTreeSet<(String, String)>, Diagnostic> {
    let wrong = |what: &str| {
        Diagnostic::error(Code::File, format!("{}: {what}", path.display()))
            .hint(format!("write it anew with --write-baseline {}", path.display()))
    };
    let text = fs::read_to_string(path).map_err(|error| wrong(&error.to_string()))?;
    let list: Value = serde_json::from_str(&text).map_err(|_| wrong("this is not a baseline"))?;
    let known = list["known"].as_array().ok_or_else(|| wrong("this is not a baseline"))?;
    let word = |entry: &Value, name: &str| entry[name].as_str().map(str::to_owned);
    let entries = known.iter().map(|entry| Some((word(entry, "file")?, word(entry, "fingerprint")?)));
    entries.collect::<Option<_>>().ok_or_else(|| wrong("an entry lacks its file or fingerprint"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Config, Diagnostic> {
        Config::parse(text, Path::new("polarform.toml"), Path::new(""))
    }

    #[test]
    fn settings() {
        let config = parse("[notes]\nignore = [\"undecided\", \"E601\"]\ncontext = \"a.txt\"\n").unwrap();
        assert_eq!((config.rules, config.codes), (vec![Rule::Undecided], vec![Code::UnclosedFormula]));
        assert_eq!(config.context.as_deref(), Some(Path::new("a.txt")));
        for (text, words) in [
            ("[notes]\nignore = [\"nothing\"]", "nothing is no rule"),
            ("[notes]\nignores = []", "ignores is unknown"),
            ("[other]", "other is unknown"),
            ("[notes]\nignore = 3", "takes strings"),
            ("[notes", "polarform.toml"),
            ("[notes]\nbaseline = \"none.json\"", "none.json"),
        ] {
            let problem = parse(text).unwrap_err();
            assert!(problem.message.contains(words) && !problem.hints.is_empty(), "{problem:?}");
        }
    }
}
