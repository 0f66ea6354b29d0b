//! The files named on the command line: folders, standard input, reading them side by side.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, IsTerminal};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use rayon::{ThreadPool, prelude::*};

use super::script::STANDARD;
use crate::document::{Container, Document, Reading, read_files, read_stream, read_text};
use crate::formula::source::SourceFile;
use crate::judge::page::finding::FileReport;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::notes::report::{Fix, fixes};

/// What a file named on the command line led to.
pub(super) struct Input {
    pub path: PathBuf,
    /// Its report and those of the files it includes.
    pub reports: Vec<FileReport>,
    /// The fixes of each report.
    pub fixes: Vec<Vec<Fix>>,
    /// Whether it could be read.
    pub read: bool,
}

/// The files with those of the folders in place of these, in the order of their names.
pub(super) fn expanded(files: &[PathBuf], excluded: impl Fn(&Path) -> bool) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for path in files {
        let before = all.len();
        if path.is_dir() {
            walk(path, &mut all, 0);
        }
        if all.len() == before {
            // A file, or a folder without notes, which is told when it is read.
            all.push(path.clone());
        }
    }
    let mut seen = BTreeSet::new();
    all.retain(|path| seen.insert(path.clone()) && (files.contains(path) || !excluded(path)));
    all
}

/// Deeper folders are not looked into.
const MAX_DEPTH: usize = 50;

/// Adds the pages in a folder; hidden ones and links to folders are passed over.
fn walk(folder: &Path, all: &mut Vec<PathBuf>, depth: usize) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<(PathBuf, bool)> = entries
        .filter(|entry| !entry.file_name().to_string_lossy().starts_with('.'))
        .filter_map(|entry| Some((entry.path(), entry.file_type().ok()?.is_dir())))
        .collect();
    paths.sort();
    for (path, is_folder) in paths {
        if is_folder {
            if depth < MAX_DEPTH {
                walk(&path, all, depth + 1);
            }
        } else if is_page(&path) && path.is_file() {
            all.push(path);
        }
    }
}

/// Whether a file in a folder is taken for notes: texts of any other kind are often called .txt, too.
fn is_page(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let other = |ending: &str| matches!(ending, "txt" | "text" | "sty" | "cls");
    ending.is_some_and(|ending| !other(&ending)) && Container::of(path).is_ok()
}

/// Reads files side by side and makes a report of every document in them.
pub(super) fn read_all(
    pool: &ThreadPool,
    files: &[PathBuf],
    reading: &Reading,
    fixing: bool,
    quiet: bool,
    report: impl Fn(&Document) -> FileReport + Sync,
) -> Vec<Input> {
    let bar = if quiet { ProgressBar::hidden() } else { progress(files.len()) };
    let inputs = pool.install(|| {
        files
            .par_iter()
            .map(|path| {
                let input = read_one(path, reading, fixing, &report);
                bar.inc(1);
                input
            })
            .collect()
    });
    bar.finish_and_clear();
    inputs
}

/// Shown on standard error if that is a terminal.
fn progress(files: usize) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(files as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos} of {len} files, {elapsed}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(250));
    bar
}

fn read_one(path: &Path, reading: &Reading, fixing: bool, report: impl Fn(&Document) -> FileReport) -> Input {
    let name = path.display().to_string();
    let documents = if path.is_dir() {
        Err(Diagnostic::error(Code::File, format!("{name} is a directory without notes"))
            .hint("name the files in it; their endings tell how they are written, or --as does"))
    } else if name == STANDARD {
        let document = guarded(|| {
            let (bytes, kind) = standard_input(reading.kind)?;
            read_text("standard input", bytes, kind, &reading.macros)
        });
        document.and_then(|result| result).map(|document| vec![document])
    } else {
        guarded(|| read_files(path, reading)).and_then(|result| result)
    };
    let unread = |file: SourceFile, problem| FileReport::new(file, Vec::new(), vec![problem]);
    match documents {
        Err(problem) => {
            let reports = vec![unread(SourceFile::new(name, ""), problem)];
            Input { path: path.to_owned(), reports, fixes: Vec::new(), read: false }
        }
        Ok(documents) => {
            let mut read = true;
            let reports: Vec<FileReport> = documents
                .iter()
                .map(|document| {
                    guarded(|| report(document)).unwrap_or_else(|problem| {
                        read = false;
                        unread(document.file.clone(), problem)
                    })
                })
                .collect();
            let both = documents.iter().zip(&reports).filter(|_| fixing);
            let fixes = both.map(|(document, report)| fixes(document, report)).collect();
            Input { path: path.to_owned(), reports, fixes, read }
        }
    }
}

/// The page on standard input, and how it is written: without --as it is LaTeX or a notebook if it looks like one,
/// else Markdown.
pub(super) fn standard_input(kind: Option<Container>) -> Result<(Vec<u8>, Container), Diagnostic> {
    let bytes = read_stream("standard input", io::stdin().lock())?;
    let kind = kind.unwrap_or_else(|| Container::guess(&bytes));
    Ok((bytes, kind))
}

/// A defect in one file does not spoil the others.
fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Diagnostic> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| {
        Diagnostic::error(Code::Internal, "polarform met a defect of its own")
            .hint("please report the file that led here")
    })
}

/// The same for all names of a file.
pub(super) fn identity(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

/// All reports, each file once: a file that another one includes is reported there, where it has
/// more context.
pub(super) fn gather(inputs: &[Input]) -> Vec<FileReport> {
    let name = |report: &FileReport| identity(Path::new(report.file.name()));
    let included: BTreeSet<PathBuf> =
        inputs.iter().flat_map(|input| input.reports.iter().skip(1)).map(name).collect();
    let mut seen = BTreeSet::new();
    let mut reports = Vec::new();
    for input in inputs {
        for (place, report) in input.reports.iter().enumerate() {
            let name = name(report);
            if (place > 0 || !included.contains(&name)) && seen.insert(name) {
                reports.push(report.clone());
            }
        }
    }
    reports
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(names: &[&str]) -> Input {
        let report = |name: &&str| FileReport::new(SourceFile::new(*name, ""), Vec::new(), Vec::new());
        Input {
            path: PathBuf::from(names[0]),
            reports: names.iter().map(report).collect(),
            fixes: Vec::new(),
            read: true,
        }
    }

    fn gathered(inputs: &[Input]) -> Vec<String> {
        gather(inputs).iter().map(|report| report.file.name().to_owned()).collect()
    }

    #[test]
    fn every_file_is_reported_once() {
        assert_eq!(gathered(&[input(&["a"]), input(&["b"]), input(&["a"])]), ["a", "b"]);
        assert_eq!(gathered(&[input(&["b"]), input(&["a", "b", "c"]), input(&["c"])]), ["a", "b", "c"]);
        assert_eq!(gathered(&[input(&["a", "b"]), input(&["b", "a"])]), ["b", "a"]);
    }

    #[test]
    fn a_defect_or_a_directory_spoils_one_file_only() {
        let empty = std::env::temp_dir().join(format!("polarform-{}-empty", std::process::id()));
        fs::create_dir_all(&empty).expect("it can be made");
        let folder = read_one(&empty, &Reading::default(), false, |_| unreachable!("there is no document"));
        assert!(!folder.read);
        assert!(folder.reports[0].problems[0].message.ends_with("is a directory without notes"));
        fs::remove_dir(&empty).expect("it is empty");
        assert_eq!(
            guarded(|| panic!("a defect")).map_err(|problem: Diagnostic| problem.code),
            Err::<(), _>(Code::Internal)
        );
    }
}
