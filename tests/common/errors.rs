//! The corpus of errors: Markdown pages in `tests/corpus/errors`, one section for each case, with
//! the query in a `polarform` block and the error as it is printed in a `text` block after it.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// A page with its cases, in order.
pub struct Page {
    pub path: PathBuf,
    pub text: String,
    /// What stands before the first section.
    head: String,
    pub cases: Vec<Case>,
}

/// A wrong query and what is printed for it.
pub struct Case {
    pub title: String,
    pub query: String,
    /// Empty where it is not written yet.
    pub error: String,
}

/// All pages, by name.
pub fn pages() -> Vec<Page> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/errors");
    let entries = fs::read_dir(folder).expect("the corpus exists");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("it is readable").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "the corpus is empty");
    paths.into_iter().map(page).collect()
}

fn page(path: PathBuf) -> Page {
    let text = fs::read_to_string(&path).expect("the corpus is readable");
    let mut sections = text.split("\n## ");
    let head = sections.next().unwrap_or_default().to_owned();
    let read = |section: &str| case(section).unwrap_or_else(|| panic!("{}: {section}", path.display()));
    let cases = sections.map(read).collect();
    Page { head, cases, path, text }
}

fn case(section: &str) -> Option<Case> {
    let (title, rest) = section.split_once("\n```polarform\n")?;
    let (query, rest) = rest.split_once("\n```\n")?;
    let error = match rest {
        "" => "",
        _ => rest.strip_prefix("```text\n")?.strip_suffix("\n```\n")?,
    };
    Some(Case { title: title.to_owned(), query: query.to_owned(), error: error.to_owned() })
}

impl Page {
    /// The page with these errors in place of its own.
    pub fn with_errors(&self, errors: &[String]) -> String {
        let mut text = self.head.clone();
        for (Case { title, query, .. }, error) in self.cases.iter().zip(errors) {
            let _ = write!(text, "\n## {title}\n```polarform\n{query}\n```\n```text\n{error}\n```\n");
        }
        text
    }
}
