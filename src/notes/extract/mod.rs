//! Reading files of notes.

use std::path::Path;

use super::document::Document;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::SourceFile;

/// The file and what it includes.
pub fn read_files(path: &Path) -> Result<Vec<Document>, Diagnostic> {
    let name = path.display().to_string();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Diagnostic::error(Code::File, format!("cannot read {name}: {error}")))?;
    Ok(vec![Document { file: SourceFile::new(name, text), items: Vec::new(), problems: Vec::new() }])
}
