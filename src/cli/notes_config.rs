//! `polarform.toml`: what is checked and what is not reported, and what all files share.
//!
//! ```toml
//! [notes]
//! files = ["lectures"]
//! context = "definitions.txt"
//! macros = "macros.tex"
//! ignore = ["undecided", "E601"]
//! exclude = ["drafts"]
//! baseline = "known.json"
//! ```
//! Paths are relative to the folder of the file.

use std::collections::BTreeSet;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::argument_reader::Failed;
use crate::document::read_string;
use crate::formula::source::{SourceFile, Span};
use crate::judge::page::finding::{FileReport, Finding};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::notes::report::{Rule, fingerprints};
use crate::session::Failure;

/// The name of the file.
pub(super) const NAME: &str = "polarform.toml";

/// What stands in its section.
const KEYS: [&str; 6] = ["files", "context", "macros", "ignore", "exclude", "baseline"];

/// The settings for a check.
#[derive(Debug, Default)]
pub(super) struct Config {
    /// What is checked if nothing else is named.
    pub files: Vec<PathBuf>,
    pub context: Option<PathBuf>,
    pub macros: Option<PathBuf>,
    rules: Vec<Rule>,
    codes: Vec<Code>,
    exclude: Vec<PathBuf>,
    /// Fingerprints of what is known.
    known: BTreeSet<(String, String)>,
    /// How many findings were left out.
    left_out: AtomicUsize,
}

impl Config {
    /// Reads the settings: from the file that is named, else from the nearest one in a folder or above it.
    pub fn load(named: Option<&Path>, folder: &Path) -> Failed<Config> {
        let found = || folder.ancestors().map(|folder| folder.join(NAME)).find(|path| path.is_file());
        let Some(path) = named.map(Path::to_owned).or_else(found) else { return Ok(Config::default()) };
        let text = read_string(&path)
            .map_err(|problem| Box::new(Failure { problem, file: SourceFile::new("<files>", "") }))?;
        let file = SourceFile::new(path.display().to_string(), text);
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        Config::parse(&file, &folder).map_err(|problem| Box::new(Failure { problem, file }))
    }

    fn parse(file: &SourceFile, folder: &Path) -> Result<Config, Diagnostic> {
        let table = DeTable::parse(file.text()).map_err(|error| {
            let span = error.span().unwrap_or_default();
            wrong(span, format!("this is not TOML: {}", error.message()))
                .hint("docs/notes.md shows such a file")
        })?;
        let mut config = Config::default();
        for (name, section) in table.get_ref() {
            let unknown = || {
                wrong(name.span(), format!("'{}' is unknown here", name.get_ref()))
                    .hint("all settings stand below the line [notes]")
            };
            let section = section.get_ref().as_table().filter(|_| name.get_ref() == "notes");
            for (key, value) in section.ok_or_else(unknown)? {
                config.set(key, value, folder)?;
            }
        }
        Ok(config)
    }

    fn set(
        &mut self,
        key: &Spanned<impl AsRef<str>>,
        value: &Spanned<DeValue>,
        folder: &Path,
    ) -> Result<(), Diagnostic> {
        let name = key.get_ref().as_ref();
        let path = || one(name, value).map(|text| folder.join(text));
        let paths = || Ok(strings(name, value)?.into_iter().map(|(text, _)| folder.join(text)).collect());
        match name {
            "files" => self.files = paths()?,
            "context" => self.context = Some(path()?),
            "macros" => self.macros = Some(path()?),
            "exclude" => self.exclude = paths()?,
            "baseline" => {
                self.known = baseline(&path()?).map_err(|problem| problem.at(place(value.span())))?;
            }
            "ignore" => {
                for (word, span) in strings(name, value)? {
                    match (Rule::ALL.into_iter().find(|rule| rule.id() == word), word.parse::<Code>()) {
                        (Some(rule), _) => self.rules.push(rule),
                        (None, Ok(code)) => self.codes.push(code),
                        (None, Err(())) => {
                            let rules = Rule::ALL.map(Rule::id);
                            let hint = match nearest(word, rules) {
                                Some(best) => format!("did you mean \"{best}\"?"),
                                None => format!(
                                    "the rules are {}, and codes of problems such as E601",
                                    rules.join(", ")
                                ),
                            };
                            return Err(wrong(span, format!("'{word}' is no rule")).hint(hint));
                        }
                    }
                }
            }
            _ => {
                let hint = match nearest(name, KEYS) {
                    Some(best) => format!("did you mean '{best}'?"),
                    None => format!("the settings are {}", KEYS.join(", ")),
                };
                return Err(wrong(key.span(), format!("there is no setting '{name}'")).hint(hint));
            }
        }
        Ok(())
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
        report.left_out = left_out;
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

fn place(range: Range<usize>) -> Span {
    Span::new(range.start, range.end)
}

fn wrong(range: Range<usize>, what: String) -> Diagnostic {
    Diagnostic::error(Code::Usage, what).at(place(range))
}

/// One string, which names something.
fn one<'a>(key: &str, value: &'a Spanned<DeValue>) -> Result<&'a str, Diagnostic> {
    let text = value.get_ref().as_str().filter(|text| !text.is_empty());
    text.ok_or_else(|| {
        wrong(value.span(), format!("'{key}' takes one string")).hint(format!("write {key} = \"…\""))
    })
}

/// One string or a list of them, with their places.
fn strings<'a>(key: &str, value: &'a Spanned<DeValue>) -> Result<Vec<(&'a str, Range<usize>)>, Diagnostic> {
    let found: Option<Vec<_>> = match value.get_ref() {
        DeValue::String(text) => Some(vec![(text.as_ref(), value.span())]),
        DeValue::Array(all) => all.iter().map(|one| Some((one.get_ref().as_str()?, one.span()))).collect(),
        _ => None,
    };
    found.ok_or_else(|| {
        wrong(value.span(), format!("'{key}' takes strings")).hint(format!("write {key} = [\"…\", \"…\"]"))
    })
}

fn baseline(path: &Path) -> Result<BTreeSet<(String, String)>, Diagnostic> {
    let wrong = |what: &str| {
        Diagnostic::error(Code::File, format!("{}: {what}", path.display()))
            .hint(format!("write it anew with --write-baseline {}", path.display()))
    };
    let text = read_string(path)?;
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
        Config::parse(&SourceFile::new(NAME, text), Path::new("book"))
    }

    #[test]
    fn settings() {
        let config = parse(
            "[notes]\nignore = [\"undecided\", \"E601\"]\ncontext = \"a.txt\"\nmacros = 'm.tex'\n\
             files = ['a', 'b.md']\n",
        )
        .unwrap();
        assert_eq!((config.rules, config.codes), (vec![Rule::Undecided], vec![Code::UnclosedFormula]));
        assert_eq!(config.context.as_deref(), Some(Path::new("book/a.txt")));
        assert_eq!(config.macros.as_deref(), Some(Path::new("book/m.tex")));
        assert_eq!(config.files, [Path::new("book/a"), Path::new("book/b.md")]);
        assert!(parse("").unwrap().files.is_empty());
    }

    #[test]
    fn what_is_wrong_is_shown_where_it_stands() {
        for (text, at, words) in [
            ("[notes]\nignore = [\"E601\", \"nothing\"]", "\"nothing\"", "'nothing' is no rule"),
            ("[notes]\nignore = \"refutd\"", "\"refutd\"", "is no rule"),
            ("[notes]\nignores = []", "ignores", "no setting 'ignores'"),
            ("[other]", "other", "'other' is unknown"),
            ("notes = 3", "notes", "'notes' is unknown"),
            ("[notes]\nignore = 3", "3", "takes strings"),
            ("[notes]\nfiles = ['a', 3]", "['a', 3]", "takes strings"),
            ("[notes]\ncontext = ['a', 'b']", "['a', 'b']", "takes one string"),
            ("[notes]\nmacros = ''", "''", "takes one string"),
            ("[notes]\nbaseline = \"none.json\"", "\"none.json\"", "none.json"),
        ] {
            let problem = parse(text).unwrap_err();
            assert!(problem.message.contains(words) && !problem.hints.is_empty(), "{problem:?}");
            assert_eq!(&text[problem.span.expect("it has a place").range()], at, "{problem:?}");
        }
        assert!(parse("[notes").unwrap_err().message.contains("not TOML"));
        assert_eq!(parse("[notes]\nignore = 'refutd'").unwrap_err().hints, ["did you mean \"refuted\"?"]);
    }
}
