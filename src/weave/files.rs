//! Files: read exactly, replaced whole.
//!
//! A file to be woven is read as UTF-8 or not at all: guessing its characters would change bytes that
//! are not ours. It is written beside its place and then renamed, so that whatever happens in between,
//! the old file or the new one stands there, whole.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use tempfile::Builder;

use crate::document::MAX_BYTES;
use crate::formula::source::SourceFile;
use crate::language::diagnostic::{Code, Diagnostic};

const MARK: &str = "\u{feff}";

/// A file as it was read.
#[derive(Clone, Debug)]
pub struct Input {
    /// Its text, without a mark of the byte order.
    pub file: SourceFile,
    path: PathBuf,
    marked: bool,
}

/// Reads a file exactly.
///
/// # Errors
/// When it is missing, a directory, unreadable, too long, or not UTF-8 (with the place of the first
/// byte that is not).
pub fn read_input(path: &Path) -> Result<Input, Diagnostic> {
    let name = path.display().to_string();
    let failed = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => problem(&format!("{name}: there is no such file"), "check the path"),
        io::ErrorKind::PermissionDenied => {
            problem(&format!("{name}: the file may not be read"), "check its permissions")
        }
        _ => problem(&format!("{name}: {error}"), "check the path"),
    };
    if fs::metadata(path).map_err(failed)?.is_dir() {
        return Err(problem(&format!("{name}: this is a directory"), "name the files in it"));
    }
    let mut bytes = Vec::new();
    File::open(path).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes)).map_err(failed)?;
    if bytes.len() as u64 > MAX_BYTES {
        let what = format!("{name}: the file has more than {} MiB, which is the limit", MAX_BYTES >> 20);
        return Err(problem(&what, "split it"));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count() + 1;
        Diagnostic::error(Code::Encoding, format!("{name}: line {line} is not UTF-8 (byte {at})"))
            .hint("save the file as UTF-8; its other characters could not be kept exactly")
    })?;
    let marked = text.starts_with(MARK);
    let text = text.strip_prefix(MARK).unwrap_or(&text).to_owned();
    Ok(Input { file: SourceFile::new(name, text), path: path.to_owned(), marked })
}

/// Writes a new text in the place of a file that was read; mark and permissions stay.
///
/// # Errors
/// When the file may not be written or was changed since it was read; it is then as it was.
pub fn replace_file(input: &Input, text: &str) -> Result<(), Diagnostic> {
    let whole = |text: &str| if input.marked { format!("{MARK}{text}") } else { text.to_owned() };
    // Only a file that was not touched in the meantime is replaced.
    if fs::read(&input.path).ok().as_deref() != Some(whole(input.file.text()).as_bytes()) {
        let message = format!("{} was changed while it was woven; nothing was written", input.file.name());
        return Err(Diagnostic::error(Code::Changed, message).hint("weave it again"));
    }
    write_file(&input.path, whole(text))
}

/// Writes a file: beside its place first, then it is renamed. Permissions stay; a link is followed.
///
/// # Errors
/// When that is not possible; what stood there is as it was.
pub fn write_file(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Diagnostic> {
    let content = content.as_ref();
    let failed = |error: io::Error| {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "the folder must exist",
            io::ErrorKind::PermissionDenied => "check the permissions of the file and of its folder",
            _ => "give another name",
        };
        problem(&format!("cannot write {}: {error}", path.display()), hint)
    };
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&target).ok();
    if let Some(old) = &old {
        if old.is_dir() {
            let message = format!("cannot write {}: this is a directory", path.display());
            return Err(problem(&message, "give the name of a file"));
        }
        if !old.is_file() {
            // A device or a pipe cannot be replaced.
            return fs::write(&target, content).map_err(failed);
        }
        if old.permissions().readonly() {
            let message = format!("cannot write {}: it may only be read", path.display());
            return Err(problem(&message, "check its permissions"));
        }
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".polarform-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What the user's mask leaves of it, as for any new file.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut beside = builder.tempfile_in(folder).map_err(failed)?;
    beside.write_all(content).map_err(failed)?;
    if let Some(old) = old {
        beside.as_file().set_permissions(old.permissions()).map_err(failed)?;
    }
    beside.as_file().sync_all().map_err(failed)?;
    beside.persist(&target).map_err(|error| failed(error.error))?;
    Ok(())
}

fn problem(message: &str, hint: &str) -> Diagnostic {
    Diagnostic::error(Code::File, message).hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_permissions_stay() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.md");
        fs::write(&path, "\u{feff}a\r\n").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        #[cfg(unix)]
        std::os::unix::fs::PermissionsExt::set_mode(&mut permissions, 0o640);
        fs::set_permissions(&path, permissions).unwrap();
        let input = read_input(&path).unwrap();
        assert_eq!(input.file.text(), "a\r\n");
        replace_file(&input, "b\r\n").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "\u{feff}b\r\n");
        let now = fs::metadata(&path).unwrap().permissions();
        #[cfg(unix)]
        assert_eq!(std::os::unix::fs::PermissionsExt::mode(&now) & 0o777, 0o640);
        assert!(!now.readonly());
        // It has changed since it was read.
        assert_eq!(replace_file(&input, "c").unwrap_err().code, Code::Changed);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("a.md"), folder.path().join("b.md"));
        fs::write(&path, "a").unwrap();
        std::os::unix::fs::symlink(&path, &link).unwrap();
        write_file(&link, "b").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(&path).unwrap(), "b");
    }

    #[test]
    fn what_cannot_be_read_or_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.md");
        assert!(read_input(&path).unwrap_err().message.ends_with("no such file"));
        assert!(read_input(folder.path()).unwrap_err().message.ends_with("directory"));
        fs::write(&path, b"a\n\xffb").unwrap();
        let problem = read_input(&path).unwrap_err();
        assert_eq!(problem.code, Code::Encoding);
        assert!(problem.message.contains("line 2") && problem.message.contains("byte 2"), "{problem:?}");
        assert!(write_file(&folder.path().join("none/a.md"), "a").is_err());
        assert!(write_file(folder.path(), "a").is_err());
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert!(write_file(&path, "a").unwrap_err().message.contains("only be read"));
    }
}
