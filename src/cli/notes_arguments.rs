//! The arguments of the commands for lecture notes.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use crate::document::Container;

/// What to do with lecture notes.
#[derive(Debug, Subcommand)]
pub(super) enum Notes {
    /// A verdict for every formula: Markdown, reStructuredText, LaTeX or Jupyter notebooks
    #[command(after_help = "Examples:\n  \
        polarform notes check lecture.md\n  \
        polarform notes check lectures/*.tex --context definitions.txt\n  \
        polarform notes check lecture.md -o report.html --watch\n  \
        polarform notes check lectures --diff\n  \
        polarform notes check - < lecture.md\n  \
        polarform notes check lectures --report github      in GitHub Actions\n\n\
        Exit status: 1 if a formula is refuted, else 2 if a file or all of its formulas could not be read, else 0.")]
    Check(NotesCheck),
    /// The formulas as they are read, printed anew as LaTeX
    List {
        /// Files of notes, folders of them, '-' for standard input
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        /// How the files are written (if not given: by the endings of their names)
        #[arg(long = "as", value_enum, value_name = "KIND")]
        kind: Option<PageKind>,
        /// Files read at the same time (as many as there are processors if not given)
        #[arg(long, short = 'j', value_name = "N")]
        jobs: Option<NonZeroUsize>,
    },
}

/// How to check lecture notes.
#[derive(Debug, Args)]
pub(super) struct NotesCheck {
    /// Files of notes, folders of them, '-' for standard input (if not given: those of polarform.toml)
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// How the files are written (if not given: by the endings of their names)
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub kind: Option<PageKind>,
    /// Declarations for all files: definitions, degrees, ranges, in the query language
    #[arg(long, value_name = "FILE")]
    pub context: Option<PathBuf>,
    /// Macros for all files: LaTeX with \newcommand and its kin
    #[arg(long, value_name = "FILE")]
    pub macros: Option<PathBuf>,
    /// A line for every formula
    #[arg(long, short)]
    pub verbose: bool,
    /// The kind of report (if not given: by the name of the output file, else text)
    #[arg(long, value_enum, value_name = "KIND")]
    pub report: Option<ReportKind>,
    /// Write the report to a file, and only a summary to standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Check again whenever a file changes, until Ctrl-C
    #[arg(long, short)]
    pub watch: bool,
    /// Put the suggestions into the files, as long as there are any, and report what is left
    #[arg(long, conflicts_with_all = ["watch", "diff"])]
    pub fix: bool,
    /// Show what --fix would write first, as a patch; write nothing
    #[arg(long, conflicts_with_all = ["watch", "report", "output"])]
    pub diff: bool,
    /// Read the settings from this file (if not given: polarform.toml here or in a folder above)
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Write what is refuted or suspicious today to a file; where it is named as baseline, only new findings are
    /// reported
    #[arg(long, value_name = "FILE", conflicts_with_all = ["watch", "fix", "diff"])]
    pub write_baseline: Option<PathBuf>,
    /// Files checked at the same time (as many as there are processors if not given)
    #[arg(long, short = 'j', value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
}

/// How pages are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum PageKind {
    /// Markdown in its dialects, plain text
    Markdown,
    /// reStructuredText
    Rst,
    /// LaTeX
    Latex,
    /// A Jupyter notebook
    Notebook,
}

impl From<PageKind> for Container {
    fn from(kind: PageKind) -> Container {
        match kind {
            PageKind::Markdown => Container::Markdown,
            PageKind::Rst => Container::Rst,
            PageKind::Latex => Container::Latex,
            PageKind::Notebook => Container::Notebook,
        }
    }
}

/// How to report on lecture notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ReportKind {
    /// For a terminal
    Text,
    /// For programs
    Json,
    /// SARIF 2.1.0, for code hosts and editors
    Sarif,
    /// A page for a browser
    Html,
    /// Annotations of GitHub Actions, on standard output
    Github,
    /// The XML of JUnit, for GitLab, Jenkins and others
    Junit,
}
