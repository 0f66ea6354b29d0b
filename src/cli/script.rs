//! Texts of the language that are not typed as an argument: scripts, and formulas on standard input.

use std::io;
use std::path::Path;

use crate::document::{read_bytes, read_stream, utf8};
use crate::formula::source::SourceFile;
use crate::session::Failure;

/// The text of a script; `-` is standard input.
pub(super) fn script_file(path: &Path) -> Result<SourceFile, Box<Failure>> {
    let (name, bytes) = match path == Path::new("-") {
        true => ("<stdin>".to_owned(), read_stream("standard input", io::stdin().lock())),
        false => (path.display().to_string(), read_bytes(path)),
    };
    match bytes.and_then(|bytes| utf8(&name, bytes)) {
        Ok(text) => Ok(SourceFile::new(name, text)),
        Err(problem) => Err(Box::new(Failure { problem, file: SourceFile::new(name, "") })),
    }
}

/// A formula; '-' stands for the text on standard input.
pub(super) fn formula(text: &str) -> Result<String, String> {
    if text != "-" {
        return Ok(text.to_owned());
    }
    let file = script_file(Path::new(text)).map_err(|failure| failure.problem.message)?;
    match file.text().trim_end() {
        "" => Err("nothing stands on standard input, or another '-' has taken it".to_owned()),
        text => Ok(text.to_owned()),
    }
}
