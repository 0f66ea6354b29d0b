//! The pictures of woven documents, as files beside them.

use std::fs;
use std::path::Path;

use crate::document::standing;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::weave::write_file;

/// What the names of the pictures of a document begin with.
pub(in crate::cli) fn picture_prefix(document: &Path) -> String {
    let stem = document.file_stem().map_or("figure".into(), |stem| stem.to_string_lossy());
    let prefix: String = stem.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    format!("{prefix}-figure")
}

/// Writes a picture of a document into its folder, unless it stands there already.
pub(in crate::cli) fn put_picture(folder: &Path, name: &str, svg: &str) -> Result<(), Diagnostic> {
    let path = folder.join(name);
    stays_inside(folder, &path)?;
    let before = standing(&path);
    if before.as_deref() == Some(svg.as_bytes()) {
        return Ok(());
    }
    if path.exists() && !before.is_some_and(|before| is_ours(&before)) {
        let message = format!("{} is there already and no picture of polarform", path.display());
        return Err(Diagnostic::error(Code::File, message).hint("name another file: picture=..."));
    }
    if let Some(parent) = path.parent().filter(|parent| !parent.as_os_str().is_empty()) {
        fs::create_dir_all(parent).map_err(|error| {
            let message = format!("cannot make the folder {}: {error}", parent.display());
            Diagnostic::error(Code::File, message).hint("choose another folder: picture=...")
        })?;
    }
    write_file(&path, svg)
}

/// Pictures stay in the folder of their document: a link that leads out of it is not followed.
pub(in crate::cli) fn stays_inside(folder: &Path, path: &Path) -> Result<(), Diagnostic> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    // What is not there yet will stand in the nearest folder that is.
    let nearest = path.ancestors().find_map(|part| fs::canonicalize(part).ok());
    let inside = fs::canonicalize(folder).is_ok_and(|folder| match nearest {
        Some(nearest) => nearest.starts_with(folder),
        // Nothing of a short path such as a.svg is there yet.
        None => true,
    });
    if inside {
        return Ok(());
    }
    let message = format!("{} leads out of the folder of the document", path.display());
    Err(Diagnostic::error(Code::File, message).hint("remove the link, or name another file: picture=..."))
}

/// Whether a file is a picture that was woven before.
fn is_ours(svg: &[u8]) -> bool {
    let start = String::from_utf8_lossy(&svg[..svg.len().min(2000)]);
    start.contains("class=\"polarform")
}
