//! Texts of the language that are not typed as an argument: scripts, and formulas on standard input.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::document::{read_bytes, read_stream, utf8};
use crate::formula::source::SourceFile;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::session::Failure;

/// Standard input and standard output are called so on the command line.
pub(super) const STANDARD: &str = "-";

pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new(STANDARD)
}

/// What a file holds, or what stands on standard input, and how that is called.
pub(super) fn content(path: &Path) -> (String, Result<Vec<u8>, Diagnostic>) {
    match is_standard(path) {
        true => ("<stdin>".to_owned(), read_stream("standard input", io::stdin().lock())),
        false => (path.display().to_string(), read_bytes(path)),
    }
}

/// The text of a script.
pub(super) fn script_file(path: &Path) -> Result<SourceFile, Box<Failure>> {
    let (name, bytes) = content(path);
    match bytes.and_then(|bytes| utf8(&name, bytes)) {
        Ok(text) => Ok(SourceFile::new(name, text)),
        Err(problem) => Err(Box::new(Failure { problem, file: SourceFile::new(name, "") })),
    }
}

/// The scripts in a folder, in the order of their names.
pub(super) fn scripts_in(folder: &Path) -> Result<Vec<PathBuf>, Box<Failure>> {
    let name = folder.display().to_string();
    let listed = fs::read_dir(folder).and_then(|entries| {
        let paths: io::Result<Vec<PathBuf>> = entries.map(|entry| Ok(entry?.path())).collect();
        paths
    });
    let is_script =
        |path: &PathBuf| path.extension().is_some_and(|ending| ending == "polar") && path.is_file();
    let scripts = listed.map(|mut paths| {
        paths.retain(is_script);
        paths.sort();
        paths
    });
    let (message, hint) = match scripts {
        Ok(scripts) if !scripts.is_empty() => return Ok(scripts),
        Ok(_) => (
            format!("{name}: this directory has no scripts"),
            "they end with .polar; any other file is run by its own name",
        ),
        Err(error) => (format!("{name}: {error}"), "check the path"),
    };
    let problem = Diagnostic::error(Code::File, message).hint(hint);
    Err(Box::new(Failure { problem, file: SourceFile::new(name, "") }))
}

/// A formula; '-' stands for the text on standard input.
pub(super) fn formula(text: &str) -> Result<String, String> {
    if text != STANDARD {
        return Ok(text.to_owned());
    }
    let file = script_file(Path::new(text)).map_err(|failure| failure.problem.message)?;
    match file.text().trim_end() {
        "" => Err("nothing stands on standard input, or another '-' has taken it".to_owned()),
        text => Ok(text.to_owned()),
    }
}
