//! The commands for lecture notes: check them, list what they hold, watch them.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::Status;
use super::arguments::Global;
use super::commands::{Ran, Stop};
use super::notes_arguments::{Notes, NotesCheck, ReportKind};
use super::notes_config::Config;
use super::notes_input::{Input, expanded, gather, identity, read_all};
use super::output::{Output, shown};
use super::script::{content, is_standard};
use super::watch::Watch;
use crate::document::{Container, Reading, macros_in, utf8};
use crate::formula::source::SourceFile;
use crate::judge::page::finding::{FileReport, Verdict};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::write::Format;
use crate::notes::report::{
    Tally, TextOptions, fixed, render_github, render_html, render_json, render_junit, render_listing,
    render_listing_json, render_sarif, render_summary, render_text,
};
use crate::notes::{Options, check_document, listing};
use crate::session::Failure;
use crate::weave::{read_input, replace_file};

/// Seconds for one formula where nothing else is said.
pub(super) const SECONDS: f64 = 60.0;

/// So often the files are checked again after suggestions were put in.
const MAX_ROUNDS: usize = 20;

/// Formulas are nested; a thread gets more than the usual two megabytes.
const STACK: usize = 16 << 20;

pub(super) fn run(notes: &Notes, global: &Global, output: &Output) -> Ran {
    match notes {
        Notes::List { files, kind, jobs } => list(files, kind.map(Container::from), *jobs, global, output),
        Notes::Check(arguments) => {
            let here = std::env::current_dir().unwrap_or_default();
            let config = Config::load(arguments.config.as_deref(), &here)?;
            let named = match arguments.files.is_empty() {
                // In reports they are called as if they were named here.
                true => config.files.iter().map(|path| short(path, &here)).collect(),
                false => arguments.files.clone(),
            };
            if named.is_empty() {
                let hint =
                    "name files or folders, or list them in polarform.toml: [notes] files = [\"lectures\"]";
                return Err(usage("there is nothing to check", hint));
            }
            let files = expanded(&named, |path| config.excludes(path));
            let kind = kind(arguments, global.format())?;
            let check = Check { arguments, files, config, kind, global, output };
            check.refuse_overwriting()?;
            match () {
                () if arguments.watch => check.watch(),
                () if arguments.diff => check.diff(),
                () if arguments.fix => check.fix(),
                () => check.once(),
            }
        }
    }
}

/// The name of a file as it would be given here.
fn short(path: &Path, here: &Path) -> PathBuf {
    match path.strip_prefix(here) {
        Ok(rest) if rest.as_os_str().is_empty() => PathBuf::from("."),
        Ok(rest) => rest.to_owned(),
        Err(_) => path.to_owned(),
    }
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
    let files = expanded(files, |_| false);
    let pool = pool(jobs, files.len())?;
    let reading = Reading { kind, ..Reading::default() };
    let inputs = read_all(&pool, &files, &reading, false, output.quiet, |document| {
        FileReport::new(document.file.clone(), listing(document), document.problems.clone())
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
            () if ends(&[".xml"]) => Some(ReportKind::Junit),
            () => None,
        }
    };
    match (arguments.report, format) {
        (Some(kind), _) => Ok(kind),
        (None, Format::Json) => Ok(ReportKind::Json),
        (None, Format::Text | Format::Unicode) => Ok(by_name().unwrap_or(ReportKind::Text)),
        (None, Format::Latex | Format::Sympy) => Err(usage(
            "a report has no such format",
            "choose --report text, json, sarif, html, github or junit",
        )),
    }
}

/// `notes check` with its arguments.
struct Check<'a> {
    arguments: &'a NotesCheck,
    /// The files, also those in folders.
    files: Vec<PathBuf>,
    config: Config,
    kind: ReportKind,
    global: &'a Global,
    output: &'a Output,
}

impl Check<'_> {
    /// A report must not take the place of the notes.
    fn refuse_overwriting(&self) -> Result<(), Stop> {
        let shared = || self.arguments.context.iter().chain(&self.arguments.macros);
        let sources = || self.files.iter().chain(shared());
        if sources().filter(|path| is_standard(path)).count() > 1 {
            return Err(usage(
                "standard input is read once",
                "name a file for one of the two, in place of '-'",
            ));
        }
        let Some(target) = self.target() else { return Ok(()) };
        if sources().any(|source| identity(source) == identity(target)) {
            let message = format!("the report would overwrite {}", target.display());
            return Err(usage(&message, "give another name after -o"));
        }
        Ok(())
    }

    /// The file of the report, if it goes to one.
    fn target(&self) -> Option<&Path> {
        self.arguments.output.as_deref().filter(|path| !is_standard(path))
    }

    fn options(&self) -> Result<Options, Stop> {
        let context = match self.arguments.context.as_ref().or(self.config.context.as_ref()) {
            None => None,
            Some(path) => {
                let (name, bytes) = content(path);
                Some(bytes.and_then(|bytes| utf8(&name, bytes)).map_err(failed)?)
            }
        };
        Ok(Options { limits: self.global.limits_or(SECONDS), context })
    }

    fn reading(&self) -> Result<Reading, Stop> {
        let macros = self.arguments.macros.as_ref().or(self.config.macros.as_ref());
        let macros = macros.map(|path| {
            let (name, bytes) = content(path);
            bytes.and_then(|bytes| macros_in(&name, bytes))
        });
        let macros = macros.transpose().map_err(failed)?;
        let kind = self.arguments.kind.map(Container::from);
        Ok(Reading { kind, macros: macros.unwrap_or_default(), text: None })
    }

    fn once(&self) -> Ran {
        let inputs = self.all()?;
        if let Some(path) = &self.arguments.write_baseline {
            let known = Config::baseline_of(&gather(&inputs));
            fs::write(path, known).map_err(|error| {
                failed(Diagnostic::error(Code::File, format!("cannot write {}: {error}", path.display())))
            })?;
        }
        self.publish(&inputs)
    }

    fn all(&self) -> Result<Vec<Input>, Stop> {
        let options = self.options()?;
        let pool = pool(self.arguments.jobs, self.files.len())?;
        self.checked(&pool, &self.files, &options)
    }

    fn checked(&self, pool: &ThreadPool, files: &[PathBuf], options: &Options) -> Result<Vec<Input>, Stop> {
        let fixing = self.arguments.fix || self.arguments.diff;
        let reading = self.reading()?;
        Ok(read_all(pool, files, &reading, fixing, self.output.quiet, |document| {
            self.config.filtered(check_document(document, options), self.arguments.write_baseline.is_some())
        }))
    }

    /// Shows the suggestions as a patch.
    fn diff(&self) -> Ran {
        let inputs = self.all()?;
        let mut status = Status::Fine;
        for input in &inputs {
            show_problems(if input.read { &[] } else { &input.reports }, self.output);
            for (report, fixes) in input.reports.iter().zip(&input.fixes) {
                let (old, name) = (report.file.text(), report.file.name());
                let new = fixed(old, fixes);
                let patch = similar::TextDiff::from_lines(old, new.as_str());
                if !fixes.is_empty() {
                    let (before, after) = (format!("a/{name}"), format!("b/{name}"));
                    self.output.text(&patch.unified_diff().header(&before, &after).to_string())?;
                    status = Status::Refuted;
                }
            }
        }
        let read = inputs.iter().all(|input| input.read);
        Ok(if read || matches!(status, Status::Refuted) { status } else { Status::Failed })
    }

    /// Puts the suggestions into the files until none is left, and reports.
    fn fix(&self) -> Ran {
        if self.files.iter().any(|path| is_standard(path)) {
            return Err(usage("standard input cannot be fixed in place", "--diff shows a patch for it"));
        }
        let options = self.options()?;
        let pool = pool(self.arguments.jobs, self.files.len())?;
        let mut inputs = self.checked(&pool, &self.files, &options)?;
        let mut written = 0;
        for _ in 0..MAX_ROUNDS {
            let mut changed = Vec::new();
            for input in &inputs {
                let mut count = 0;
                for (report, fixes) in input.reports.iter().zip(&input.fixes) {
                    if !fixes.is_empty() && self.put(report, &fixed(report.file.text(), fixes)) {
                        count += fixes.len();
                    }
                }
                if count > 0 {
                    changed.push(input.path.clone());
                    written += count;
                }
            }
            if changed.is_empty() {
                break;
            }
            for new in self.checked(&pool, &changed, &options)? {
                if let Some(old) = inputs.iter_mut().find(|input| input.path == new.path) {
                    *old = new;
                }
            }
        }
        self.output.remark(&format!("{written} {} put in", if written == 1 { "change" } else { "changes" }));
        self.publish(&inputs)
    }

    /// Writes the new text of a file, if what was checked is what stands there; whether it was written.
    fn put(&self, report: &FileReport, text: &str) -> bool {
        let path = Path::new(report.file.name());
        let written = read_input(path).and_then(|input| {
            if input.file.text() != report.file.text() {
                let what = format!("{} was not changed: its bytes could not be kept exactly", path.display());
                return Err(Diagnostic::error(Code::Encoding, what)
                    .hint("save it as UTF-8 with line feeds at the ends of lines"));
            }
            replace_file(&input, text)
        });
        match written {
            Ok(()) => true,
            Err(problem) => {
                self.output.problem(&problem, &report.file);
                false
            }
        }
    }

    /// Writes the report and says how the check ended.
    fn publish(&self, inputs: &[Input]) -> Ran {
        let reports = gather(inputs);
        show_problems(&reports, self.output);
        let color = self.global.color;
        let text = match self.kind {
            ReportKind::Text => {
                let terminal = self.target().is_none() && io::stdout().is_terminal();
                let (color, verbose) = (color.wanted(terminal), self.arguments.verbose);
                let options = TextOptions { color, verbose, quiet: self.output.quiet };
                render_text(&reports, options)
            }
            ReportKind::Json => render_json(&reports),
            ReportKind::Sarif => render_sarif(&reports),
            ReportKind::Html => render_html(&reports),
            ReportKind::Github => render_github(&reports, self.arguments.verbose),
            ReportKind::Junit => render_junit(&reports),
        };
        match self.target() {
            None => self.output.text(&text)?,
            Some(path) => {
                fs::write(path, text).map_err(|error| {
                    let message = format!("cannot write {}: {error}", path.display());
                    failed(Diagnostic::error(Code::File, message))
                })?;
                if !self.output.quiet {
                    let summary = render_summary(&reports, color.wanted(io::stdout().is_terminal()));
                    self.output.text(&format!("{summary}written to {}\n", shown(path)))?;
                }
            }
        }
        if let Some(remark) = self.config.remark() {
            self.output.remark(&remark);
        }
        let refuted = reports.iter().any(|report| report.count(Verdict::Refuted) > 0);
        let mut read = inputs.iter().all(|input| input.read);
        for report in &reports {
            read &= !report.is_broken();
            if report.left_out == 0 && Tally::of(std::slice::from_ref(report)).is_all_unread() {
                say(&format!("{}: none of its formulas could be read", report.file.name()));
                read = false;
            }
        }
        Ok(match (refuted, read) {
            (true, _) => Status::Refuted,
            (false, false) => Status::Failed,
            (false, true) => Status::Fine,
        })
    }

    /// Checks, and checks again what changes, until Ctrl-C.
    fn watch(&self) -> Ran {
        let files = &self.files;
        if files.iter().any(|path| is_standard(path)) {
            return Err(usage("standard input cannot be watched", "name a file"));
        }
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
        for path in files.iter().chain(&self.arguments.context).chain(&self.arguments.macros) {
            watch.follow(path, path).map_err(trouble)?;
        }
        let mut inputs = self.checked(&pool, files, &options)?;
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
            self.output.remark(&format!("watching {}; Ctrl-C ends", counted(files.len())));
            let Some(changed) = watch.wait() else { return Ok(status) };
            let names: Vec<String> = changed.iter().map(|path| shown(path)).collect();
            self.output.remark(&format!("{} changed", names.join(", ")));
            let mut shared = self.arguments.context.iter().chain(&self.arguments.macros);
            let everything = shared.any(|path| changed.contains(path));
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
            for new in self.checked(&pool, &again, &options)? {
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

    #[test]
    fn the_kind_of_report() {
        let kind = |report, output: Option<&str>, format| {
            let arguments = NotesCheck {
                files: Vec::new(),
                kind: None,
                fix: false,
                diff: false,
                config: None,
                write_baseline: None,
                context: None,
                macros: None,
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
        assert_eq!(kind(None, Some("a.xml"), text), Some(ReportKind::Junit));
        assert_eq!(kind(Some(ReportKind::Text), Some("a.json"), Format::Json), Some(ReportKind::Text));
        assert_eq!(kind(None, None, Format::Sympy), None);
    }
}
