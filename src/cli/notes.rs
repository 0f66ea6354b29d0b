//! The commands for lecture notes: check them, list what they hold, watch them.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use rayon::{ThreadPool, ThreadPoolBuilder, prelude::*};

use super::Status;
use super::arguments::{Global, Notes, NotesCheck, ReportKind};
use super::commands::{Ran, Stop};
use super::output::Output;
use super::watch::Watch;
use crate::document::{Container, Document, read_files};
use crate::formula::source::SourceFile;
use crate::judge::finding::{FileReport, Verdict};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::write::Format;
use crate::notes::report::{
    TextOptions, render_html, render_json, render_listing, render_listing_json, render_sarif, render_summary,
    render_text,
};
use crate::notes::{Options, check_document, listing};
use crate::session::Failure;

/// Seconds for one formula where nothing else is said.
const SECONDS: f64 = 60.0;

/// Formulas are nested; a thread gets more than the usual two megabytes.
const STACK: usize = 16 << 20;

pub(super) fn run(notes: &Notes, global: &Global, output: &Output) -> Ran {
    match notes {
        Notes::List { files, kind, jobs } => list(files, kind.map(Container::from), *jobs, global, output),
        Notes::Check(arguments) => {
            let check = Check { arguments, kind: kind(arguments, global.format())?, global, output };
            check.refuse_overwriting()?;
            if arguments.watch { check.watch() } else { check.once() }
        }
    }
}

/// What a file named on the command line led to.
struct Input {
    path: PathBuf,
    /// Its report and those of the files it includes.
    reports: Vec<FileReport>,
    /// Whether it could be read.
    read: bool,
}

fn list(
    files: &[PathBuf],
    kind: Option<Container>,
    jobs: Option<NonZeroUsize>,
    global: &Global,
    output: &Output,
) -> Ran {
    if matches!(global.format(), Format::Sympy) {
        return Err(usage("a list of formulas is printed as text or JSON", "choose another --format"));
    }
    let pool = pool(jobs, files.len())?;
    let inputs = read_all(&pool, files, kind, |document| FileReport {
        file: document.file.clone(),
        findings: listing(document),
        problems: document.problems.clone(),
    });
    let reports = gather(&inputs);
    show_problems(&reports, output);
    let color = global.color.wanted(io::stdout().is_terminal());
    output.text(&match global.format() {
        Format::Json => render_listing_json(&reports),
        _ => render_listing(&reports, color),
    })?;
    Ok(if inputs.iter().all(|input| input.read) { Status::Fine } else { Status::Failed })
}

/// The kind of report that the arguments ask for.
fn kind(arguments: &NotesCheck, format: Format) -> Result<ReportKind, Stop> {
    let by_name = || {
        let name = arguments.output.as_ref()?.file_name()?.to_str()?.to_ascii_lowercase();
        let ends = |endings: &[&str]| endings.iter().any(|ending| name.ends_with(ending));
        match () {
            () if ends(&[".sarif", ".sarif.json"]) => Some(ReportKind::Sarif),
            () if ends(&[".json"]) => Some(ReportKind::Json),
            () if ends(&[".html", ".htm"]) => Some(ReportKind::Html),
            () => None,
        }
    };
    match (arguments.report, format) {
        (Some(kind), _) => Ok(kind),
        (None, Format::Json) => Ok(ReportKind::Json),
        (None, Format::Text | Format::Unicode) => Ok(by_name().unwrap_or(ReportKind::Text)),
        (None, Format::Latex | Format::Sympy) => {
            Err(usage("a report has no such format", "choose --report text, json, sarif or html"))
        }
    }
}

/// `notes check` with its arguments.
struct Check<'a> {
    arguments: &'a NotesCheck,
    kind: ReportKind,
    global: &'a Global,
    output: &'a Output,
}

impl Check<'_> {
    /// A report must not take the place of the notes.
    fn refuse_overwriting(&self) -> Result<(), Stop> {
        let Some(target) = &self.arguments.output else { return Ok(()) };
        let sources = self.arguments.files.iter().chain(&self.arguments.context);
        if sources.into_iter().any(|source| identity(source) == identity(target)) {
            let message = format!("the report would overwrite {}", target.display());
            return Err(usage(&message, "give another name after -o"));
        }
        Ok(())
    }

    fn options(&self) -> Result<Options, Stop> {
        let context = match &self.arguments.context {
            None => None,
            Some(path) => Some(fs::read_to_string(path).map_err(|error| {
                failed(Diagnostic::error(Code::File, format!("cannot read {}: {error}", path.display())))
            })?),
        };
        Ok(Options { limits: self.global.limits_or(SECONDS), context })
    }

    fn once(&self) -> Ran {
        let options = self.options()?;
        let pool = pool(self.arguments.jobs, self.arguments.files.len())?;
        let inputs = self.checked(&pool, &self.arguments.files, &options);
        self.publish(&inputs)
    }

    fn checked(&self, pool: &ThreadPool, files: &[PathBuf], options: &Options) -> Vec<Input> {
        read_all(pool, files, self.arguments.kind.map(Container::from), |document| {
            check_document(document, options)
        })
    }

    /// Writes the report and says how the check ended.
    fn publish(&self, inputs: &[Input]) -> Ran {
        let reports = gather(inputs);
        show_problems(&reports, self.output);
        let color = self.global.color;
        let text = match self.kind {
            ReportKind::Text => {
                let terminal = self.arguments.output.is_none() && io::stdout().is_terminal();
                let options = TextOptions { color: color.wanted(terminal), verbose: self.arguments.verbose };
                render_text(&reports, options)
            }
            ReportKind::Json => render_json(&reports),
            ReportKind::Sarif => render_sarif(&reports),
            ReportKind::Html => render_html(&reports),
        };
        match &self.arguments.output {
            None => self.output.text(&text)?,
            Some(path) => {
                fs::write(path, text).map_err(|error| {
                    let message = format!("cannot write {}: {error}", path.display());
                    failed(Diagnostic::error(Code::File, message))
                })?;
                let summary = render_summary(&reports, color.wanted(io::stdout().is_terminal()));
                self.output.text(&format!("{summary}written to {}\n", path.display()))?;
            }
        }
        let refuted = reports.iter().any(|report| report.count(Verdict::Refuted) > 0);
        let read = inputs.iter().all(|input| input.read);
        Ok(match (refuted, read) {
            (true, _) => Status::Refuted,
            (false, false) => Status::Failed,
            (false, true) => Status::Fine,
        })
    }

    /// Checks, and checks again what changes, until Ctrl-C.
    fn watch(&self) -> Ran {
        let files = &self.arguments.files;
        let mut options = self.options()?;
        let pool = pool(self.arguments.jobs, files.len())?;
        let trouble = |error: notify::Error| {
            failed(Diagnostic::error(Code::File, format!("cannot watch the files: {error}")))
        };
        let mut watch = Watch::new().map_err(trouble)?;
        let interrupt = options.limits.interrupt.clone();
        let stop = watch.stopper();
        let flag = interrupt.clone();
        let handler = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                // A second Ctrl-C does not wait for the check to notice the first.
                std::process::exit(130);
            }
            stop();
        });
        if let Err(error) = handler {
            return Err(failed(Diagnostic::error(
                Code::Internal,
                format!("Ctrl-C cannot be handled: {error}"),
            )));
        }
        // What changes during the check is noticed afterwards.
        for path in files.iter().chain(&self.arguments.context) {
            watch.follow(path, path).map_err(trouble)?;
        }
        let mut inputs = self.checked(&pool, files, &options);
        let mut status = Status::Fine;
        loop {
            if interrupt.load(Ordering::Relaxed) {
                return Ok(status);
            }
            status = self.publish(&inputs)?;
            for input in &inputs {
                for report in &input.reports {
                    watch.follow(Path::new(report.file.name()), &input.path).map_err(trouble)?;
                }
            }
            say(&format!("watching {}; Ctrl-C ends", counted(files.len())));
            let Some(changed) = watch.wait() else { return Ok(status) };
            let names: Vec<String> = changed.iter().map(|path| path.display().to_string()).collect();
            say(&format!("{} changed", names.join(", ")));
            let everything = self.arguments.context.as_ref().is_some_and(|path| changed.contains(path));
            if everything {
                match self.options() {
                    // The interrupt that Ctrl-C sets stays the same.
                    Ok(new) => options.context = new.context,
                    Err(Stop::Failed(failure)) => self.output.failure(&failure),
                    Err(other) => return Err(other),
                }
            }
            let again: Vec<PathBuf> =
                files.iter().filter(|path| everything || changed.contains(*path)).cloned().collect();
            for new in self.checked(&pool, &again, &options) {
                if let Some(old) = inputs.iter_mut().find(|input| input.path == new.path) {
                    *old = new;
                }
            }
        }
    }
}

/// A remark on standard error.
fn say(text: &str) {
    // When standard error is gone there is nobody left to tell.
    let _ = writeln!(io::stderr().lock(), "{text}");
}

fn counted(files: usize) -> String {
    if files == 1 { "1 file".to_owned() } else { format!("{files} files") }
}

fn failed(problem: Diagnostic) -> Stop {
    Stop::Failed(Box::new(Failure { problem, file: SourceFile::new("<files>", "") }))
}

fn usage(message: &str, hint: &str) -> Stop {
    failed(Diagnostic::error(Code::Usage, message).hint(hint))
}

fn pool(jobs: Option<NonZeroUsize>, files: usize) -> Result<ThreadPool, Stop> {
    let processors = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let threads = jobs.map_or(processors, NonZeroUsize::get).min(files.max(1));
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build().map_err(|error| {
        failed(Diagnostic::error(Code::Internal, format!("cannot start {threads} threads: {error}")))
    })
}

/// Reads files side by side and makes a report of every document in them.
fn read_all(
    pool: &ThreadPool,
    files: &[PathBuf],
    kind: Option<Container>,
    report: impl Fn(&Document) -> FileReport + Sync,
) -> Vec<Input> {
    let bar = progress(files.len());
    let inputs = pool.install(|| {
        files
            .par_iter()
            .map(|path| {
                let input = read_one(path, kind, &report);
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

fn read_one(path: &Path, kind: Option<Container>, report: impl Fn(&Document) -> FileReport) -> Input {
    let name = path.display().to_string();
    let documents = if path.is_dir() {
        Err(Diagnostic::error(Code::File, format!("{name} is a directory"))
            .hint(format!("name the files in it, for example {}", path.join("*.md").display())))
    } else {
        guarded(|| read_files(path, kind)).and_then(|result| result)
    };
    let unread =
        |file: SourceFile, problem| FileReport { file, findings: Vec::new(), problems: vec![problem] };
    match documents {
        Err(problem) => {
            let reports = vec![unread(SourceFile::new(name, ""), problem)];
            Input { path: path.to_owned(), reports, read: false }
        }
        Ok(documents) => {
            let mut read = true;
            let reports = documents
                .iter()
                .map(|document| {
                    guarded(|| report(document)).unwrap_or_else(|problem| {
                        read = false;
                        unread(document.file.clone(), problem)
                    })
                })
                .collect();
            Input { path: path.to_owned(), reports, read }
        }
    }
}

/// A defect in one file does not spoil the others.
fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Diagnostic> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|_| {
        Diagnostic::error(Code::Internal, "polarform met a defect of its own")
            .hint("please report the file that led here")
    })
}

/// The same for all names of a file.
fn identity(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
}

/// All reports, each file once: a file that another one includes is reported there, where it has
/// more context.
fn gather(inputs: &[Input]) -> Vec<FileReport> {
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

fn show_problems(reports: &[FileReport], output: &Output) {
    for report in reports {
        for problem in &report.problems {
            output.problem(problem, &report.file);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(names: &[&str]) -> Input {
        let report = |name: &&str| FileReport {
            file: SourceFile::new(*name, ""),
            findings: Vec::new(),
            problems: Vec::new(),
        };
        Input { path: PathBuf::from(names[0]), reports: names.iter().map(report).collect(), read: true }
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
    fn the_kind_of_report() {
        let kind = |report, output: Option<&str>, format| {
            let arguments = NotesCheck {
                files: Vec::new(),
                kind: None,
                context: None,
                verbose: false,
                report,
                output: output.map(PathBuf::from),
                watch: false,
                jobs: None,
            };
            kind(&arguments, format).ok()
        };
        let text = Format::Text;
        assert_eq!(kind(None, None, text), Some(ReportKind::Text));
        assert_eq!(kind(None, None, Format::Json), Some(ReportKind::Json));
        assert_eq!(kind(None, Some("a.HTML"), text), Some(ReportKind::Html));
        assert_eq!(kind(None, Some("a.sarif.json"), text), Some(ReportKind::Sarif));
        assert_eq!(kind(Some(ReportKind::Text), Some("a.json"), Format::Json), Some(ReportKind::Text));
        assert_eq!(kind(None, None, Format::Sympy), None);
    }

    #[test]
    fn a_defect_or_a_directory_spoils_one_file_only() {
        let folder = read_one(&std::env::temp_dir(), None, |_| unreachable!("there is no document"));
        assert!(!folder.read);
        assert!(folder.reports[0].problems[0].message.ends_with("is a directory"));
        assert_eq!(
            guarded(|| panic!("a defect")).map_err(|problem: Diagnostic| problem.code),
            Err::<(), _>(Code::Internal)
        );
    }
}
