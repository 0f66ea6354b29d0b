//! Texts of the language that are not typed as an argument: scripts, and formulas on standard input.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use crate::formula::source::SourceFile;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::session::Failure;

/// Larger scripts are refused rather than read.
const LONGEST_INPUT: u64 = 64 << 20;

/// The text of a script; `-` is standard input.
pub(super) fn script_file(path: &Path) -> Result<SourceFile, Box<Failure>> {
    let standard = path == Path::new("-");
    let name = if standard { "<stdin>".to_owned() } else { path.display().to_string() };
    let failed = |message: String| {
        Box::new(Failure {
            problem: Diagnostic::error(Code::File, message),
            file: SourceFile::new(name.clone(), ""),
        })
    };
    let mut bytes = Vec::new();
    let result = if standard {
        io::stdin().lock().take(LONGEST_INPUT + 1).read_to_end(&mut bytes)
    } else {
        fs::File::open(path).and_then(|file| file.take(LONGEST_INPUT + 1).read_to_end(&mut bytes))
    };
    result.map_err(|error| failed(format!("cannot read {name}: {error}")))?;
    if bytes.len() as u64 > LONGEST_INPUT {
        return Err(failed(format!("{name} is longer than {} MB", LONGEST_INPUT >> 20)));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        failed(format!("{name} is not UTF-8 text (byte {at})"))
    })?;
    Ok(SourceFile::new(name.clone(), text))
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
