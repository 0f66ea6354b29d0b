//! The thread that checks pages: a moment after the last edit, each page by itself, until it is edited again.

use std::collections::{HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

use super::places::Places;
use crate::budget::Limits;
use crate::cli::notes_config::Config;
use crate::document::{Container, Document, Reading, read_files, read_macros, read_string, read_text};
use crate::formula::source::SourceFile;
use crate::judge::page::finding::FileReport;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::notes::{Memory, Options, check_again};

/// A page is checked when nothing was typed for so long; an edit ends the check before it.
const QUIET: Duration = Duration::from_millis(10);

/// The verdict on what was typed is told if all that follows is not judged by then.
const EARLY: Duration = Duration::from_millis(30);

/// If even that takes long, the verdicts on the rest are told.
const LATE: Duration = Duration::from_millis(60);

/// So many pages are remembered.
const PAGES: usize = 8;

/// A longer page is not checked while it is edited.
const LONGEST: usize = 2 << 20;

/// Formulas are nested; a thread gets more than the usual two megabytes.
pub(super) const STACK: usize = 16 << 20;

/// A page to be checked.
pub(super) struct Job {
    pub uri: String,
    pub version: i32,
    pub text: String,
    /// Where it stands, if it is a file.
    pub path: Option<PathBuf>,
    /// How it is written, if its name does not tell.
    pub kind: Option<Container>,
    /// Set when there is a newer text.
    pub outdated: Arc<AtomicBool>,
}

/// What came of a page.
pub(super) struct Checked {
    pub uri: String,
    pub version: i32,
    /// Whether all of it is judged.
    pub whole: bool,
    pub document: Document,
    pub report: FileReport,
    pub places: Places,
    /// What is wrong with the settings.
    pub remark: Option<String>,
}

/// Starts the thread. It ends with the sender; `done` is called for each page that was not edited meanwhile.
pub(super) fn start(limits: Limits, done: impl Fn(Checked) + Send + 'static) -> std::io::Result<Sender<Job>> {
    let (sender, receiver) = mpsc::channel();
    let work = move || {
        let mut jobs = Jobs { receiver, waiting: VecDeque::new() };
        let mut memories: HashMap<String, Memory> = HashMap::new();
        while let Some(job) = jobs.next() {
            let outdated = job.outdated.clone();
            let tell = |checked: Checked| {
                if !outdated.load(Ordering::Relaxed) {
                    done(checked);
                }
            };
            if memories.len() >= PAGES {
                memories.retain(|uri, _| *uri == job.uri);
            }
            let mut memory = memories.remove(&job.uri).unwrap_or_default();
            let uri = job.uri.clone();
            let checked = check(job, &limits, &mut memory, &tell);
            memories.insert(uri, memory);
            tell(checked);
        }
    };
    thread::Builder::new().name("checker".to_owned()).stack_size(STACK).spawn(work)?;
    Ok(sender)
}

/// The newest text of each page that waits.
struct Jobs {
    receiver: Receiver<Job>,
    waiting: VecDeque<Job>,
}

impl Jobs {
    fn next(&mut self) -> Option<Job> {
        loop {
            let received = match self.waiting.is_empty() {
                true => self.receiver.recv().map_err(|_| RecvTimeoutError::Disconnected),
                false => self.receiver.recv_timeout(QUIET),
            };
            match received {
                Ok(job) => {
                    self.waiting.retain(|other| other.uri != job.uri);
                    self.waiting.push_back(job);
                }
                Err(RecvTimeoutError::Disconnected) => return None,
                Err(RecvTimeoutError::Timeout) => {
                    self.waiting.retain(|job| !job.outdated.load(Ordering::Relaxed));
                    if let Some(job) = self.waiting.pop_front() {
                        return Some(job);
                    }
                }
            }
        }
    }
}

/// Checks a page; what prevents that is a problem of the page.
fn check(job: Job, limits: &Limits, memory: &mut Memory, tell: &dyn Fn(Checked)) -> Checked {
    let name = job.path.as_ref().map_or_else(|| job.uri.clone(), |path| path.display().to_string());
    let file = SourceFile::new(name, job.text.as_str());
    let mut remark = None;
    let result = if job.text.len() > LONGEST {
        let message =
            format!("the page has more than {} MiB and is not checked while it is edited", LONGEST >> 20);
        Err(Diagnostic::note(Code::File, message).hint("polarform notes check reads it"))
    } else {
        catch_unwind(AssertUnwindSafe(|| judged(&job, limits, memory, tell, &mut remark))).unwrap_or_else(
            |_| {
                *memory = Memory::default();
                Err(Diagnostic::error(Code::Internal, "polarform met a defect of its own")
                    .hint("please report the page that led here"))
            },
        )
    };
    let (document, report) = result.unwrap_or_else(|problem| {
        let document =
            Document { file: file.clone(), items: Vec::new(), problems: Vec::new(), escaped: false };
        (document, FileReport::new(file, Vec::new(), vec![problem]))
    });
    let places = Places::new(report.file.text());
    Checked { uri: job.uri, version: job.version, whole: true, document, report, places, remark }
}

fn judged(
    job: &Job,
    limits: &Limits,
    memory: &mut Memory,
    tell: &dyn Fn(Checked),
    remark: &mut Option<String>,
) -> Result<(Document, FileReport), Diagnostic> {
    // Without its settings a page is still checked.
    let folder = job.path.as_ref().and_then(|path| path.parent());
    let config = folder.map(|folder| Config::load(None, folder)).transpose().unwrap_or_else(|failure| {
        *remark = Some(format!("{}: {}", failure.file.name(), failure.problem.message));
        None
    });
    let config = config.unwrap_or_default();
    let mut macros = Default::default();
    if let Some(path) = &config.macros {
        match read_macros(path) {
            Ok(read) => macros = read,
            Err(problem) => *remark = Some(problem.message),
        }
    }
    let context = config
        .context
        .as_ref()
        .and_then(|path| read_string(path).map_err(|problem| *remark = Some(problem.message)).ok());
    let document = match &job.path {
        Some(path) => {
            let reading = Reading { kind: job.kind, macros, text: Some(job.text.clone()) };
            read_files(path, &reading)?.swap_remove(0)
        }
        None => {
            let kind = job.kind.unwrap_or(Container::Markdown);
            read_text(&job.uri, job.text.clone().into_bytes(), kind, &macros)?
        }
    };
    let limits = Limits { interrupt: job.outdated.clone(), ..limits.clone() };
    let began = Instant::now();
    // Of a page that was never checked nothing is told before the end.
    let (mut edited, mut rest) = (memory.is_empty(), memory.is_empty());
    let report = check_again(&document, &Options { limits, context }, memory, &mut |progress| {
        let wanted = match progress.edited {
            true => !edited && began.elapsed() >= EARLY,
            false => !rest && began.elapsed() >= LATE,
        };
        if wanted {
            (edited, rest) = (progress.edited, true);
            tell(Checked {
                uri: job.uri.clone(),
                version: job.version,
                whole: false,
                document: document.clone(),
                report: config.filtered(progress.report(), false),
                places: Places::new(document.file.text()),
                remark: None,
            });
        }
    });
    let report = config.filtered(report, false);
    Ok((document, report))
}
