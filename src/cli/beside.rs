//! What stands beside a LaTeX document that is woven: the file of its results, and the package that reads it.

use std::path::{Path, PathBuf};

use crate::document::standing;
use crate::formula::source::SourceFile;
use crate::language::diagnostic::Diagnostic;
use crate::weave::{Options, PACKAGE, Woven, read_input, side_name, weave_latex, write_file};

/// The name of the LaTeX package.
pub(super) const STYLE: &str = "polarform.sty";

/// Reads what a LaTeX document in a folder includes.
pub(super) fn loader(folder: &Path) -> impl FnMut(&str) -> Option<SourceFile> + '_ {
    move |name| {
        let named = [folder.join(format!("{name}.tex")), folder.join(name)];
        let path = named.into_iter().find(|path| path.is_file())?;
        // What cannot be read is LaTeX's to tell.
        read_input(&path).ok().map(|input| input.file)
    }
}

/// The results of a LaTeX document, and those that stand beside it.
pub(super) fn beside(path: &Path, file: &SourceFile, options: &Options) -> (Woven, String) {
    let before = standing_text(&side_name(path)).unwrap_or_default();
    let folder = path.parent().unwrap_or(Path::new(""));
    (weave_latex(file, &before, &mut loader(folder), options), before)
}

/// Writes what LaTeX reads beside a document: its results, and the package, if it is not there; its path.
pub(super) fn put_beside(
    path: &Path,
    file: &SourceFile,
    options: &Options,
) -> Result<(Woven, Option<PathBuf>), Diagnostic> {
    let (woven, before) = beside(path, file, options);
    if !woven.unchanged && woven.text != before {
        write_file(&side_name(path), &woven.text)?;
    }
    let style = path.with_file_name(STYLE);
    let missing = !style.exists() && file.text().contains(r"\documentclass");
    if missing {
        write_file(&style, PACKAGE)?;
    }
    Ok((woven, missing.then_some(style)))
}

/// The text that stands where one is to be written.
pub(super) fn standing_text(path: &Path) -> Option<String> {
    standing(path).and_then(|bytes| String::from_utf8(bytes).ok())
}
