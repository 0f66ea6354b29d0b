//! Files: read exactly, replaced whole.
//!
//! A file to be woven is read as UTF-8 or not at all: guessing its characters would change bytes that
//! are not ours. It is written beside its place and then renamed, so that whatever happens in between,
//! the old file or the new one stands there, whole.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::document::{read_string, standing};
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
    let text = read_string(path)?;
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
    let old = whole(input.file.text());
    // Only a file that was not touched in the meantime is replaced.
    write(&input.path, whole(text).as_bytes(), || {
        if standing(&input.path).as_deref() == Some(old.as_bytes()) {
            return Ok(());
        }
        let message = format!("{} was changed while it was woven; nothing was written", input.file.name());
        Err(Diagnostic::error(Code::Changed, message).hint("weave it again"))
    })
}

/// Writes a file: beside its place first, then it is renamed. Permissions and owner stay; a link is followed.
///
/// # Errors
/// When that is not possible; what stood there is as it was. A file with several names (hard links) is refused, because
/// only one of them would show the new content, and one whose owner could not be kept.
pub fn write_file(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Diagnostic> {
    write(path, content.as_ref(), || Ok(()))
}

/// Writes a file if, when everything is ready, `agreed` says so.
fn write(path: &Path, content: &[u8], agreed: impl Fn() -> Result<(), Diagnostic>) -> Result<(), Diagnostic> {
    let failed = |error: io::Error| {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "the folder must exist",
            io::ErrorKind::PermissionDenied => "check the permissions of the file and of its folder",
            _ => "give another name",
        };
        problem(&format!("cannot write {}: {error}", path.display()), hint)
    };
    let refused = |why: &str, hint: &str| problem(&format!("cannot write {}: {why}", path.display()), hint);
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if target.is_symlink() {
        return Err(refused("it is a link that leads nowhere", "remove the link, or give another name"));
    }
    let old = fs::metadata(&target).ok();
    if let Some(old) = &old {
        if old.is_dir() {
            return Err(refused("this is a directory", "give the name of a file"));
        }
        if !old.is_file() {
            // A device or a pipe cannot be replaced.
            agreed()?;
            return fs::write(&target, content).map_err(failed);
        }
        if old.permissions().readonly() {
            return Err(refused("it may only be read", "check its permissions"));
        }
        #[cfg(unix)]
        if std::os::unix::fs::MetadataExt::nlink(old) > 1 {
            let hint = "write a copy with -o, or make it a file of its own: cp FILE NEW, then mv NEW FILE";
            return Err(refused("it has several names (hard links), of which one would change", hint));
        }
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    remove_leftovers(folder);
    let mut beside = beside(folder).map_err(failed)?;
    beside.write_all(content).map_err(failed)?;
    if let Some(old) = old {
        #[cfg(unix)]
        if !kept_owner(&old, beside.as_file()).map_err(failed)? {
            let hint = "let its owner weave it, or write a copy with -o";
            return Err(refused("it belongs to somebody else, and would then belong to you", hint));
        }
        beside.as_file().set_permissions(old.permissions()).map_err(failed)?;
    }
    beside.as_file().sync_all().map_err(failed)?;
    agreed()?;
    beside.persist(&target).map_err(|error| failed(error.error))?;
    Ok(())
}

/// Names of files that are written but not yet renamed.
const BESIDE: (&str, usize, &str) = (".polarform-", 6, ".tmp");

/// A new file in a folder. It is locked as long as it is written, which tells it from what a killed run left.
fn beside(folder: &Path) -> io::Result<NamedTempFile> {
    let (prefix, random, suffix) = BESIDE;
    let mut builder = Builder::new();
    builder.prefix(prefix).rand_bytes(random).suffix(suffix);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What the user's mask leaves of it, as for any new file.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    loop {
        let file = builder.tempfile_in(folder)?;
        // Where there are no locks, nothing is taken for a leftover.
        if file.as_file().lock().is_err() || file.path().exists() {
            return Ok(file);
        }
        // Another run took it for a leftover before it was locked.
    }
}

/// Removes what a killed run left in a folder.
fn remove_leftovers(folder: &Path) {
    let (prefix, random, suffix) = BESIDE;
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let middle = name.to_str().and_then(|name| name.strip_prefix(prefix)?.strip_suffix(suffix));
        let is_ours = middle.is_some_and(|middle| {
            middle.len() == random && middle.bytes().all(|byte| byte.is_ascii_alphanumeric())
        });
        if !is_ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        if let Ok(file) = File::open(entry.path())
            && file.try_lock().is_ok()
        {
            // If it cannot be removed it does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Gives a new file the owner and group of an old one; false if that is not allowed.
#[cfg(unix)]
fn kept_owner(old: &fs::Metadata, new: &File) -> io::Result<bool> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let now = new.metadata()?;
    let user = (now.uid() != old.uid()).then(|| old.uid());
    let group = (now.gid() != old.gid()).then(|| old.gid());
    Ok((user, group) == (None, None) || fchown(new, user, group).is_ok())
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
        fs::remove_file(&path).unwrap();
        assert!(write_file(&link, "c").unwrap_err().message.ends_with("leads nowhere"));
        assert!(!path.exists());
    }

    #[cfg(unix)]
    #[test]
    fn several_names_of_a_file_stay_one_file() {
        let folder = tempfile::tempdir().unwrap();
        let (path, other) = (folder.path().join("a.md"), folder.path().join("b.md"));
        fs::write(&path, "a").unwrap();
        fs::hard_link(&path, &other).unwrap();
        assert!(write_file(&path, "b").unwrap_err().message.contains("several names"));
        assert_eq!(fs::read_to_string(&other).unwrap(), "a");
    }

    #[test]
    fn what_a_killed_run_left_is_removed() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let kept = [".polarform-notes", ".polarform-ab.tmp", ".polarform-abc def.tmp", "a.tmp"];
        for name in kept.iter().chain(&[".polarform-Ab12Cd.tmp"]) {
            fs::write(at(name), "a").unwrap();
        }
        // What is being written now is locked.
        let writing = beside(folder.path()).unwrap();
        write_file(&at("a.md"), "a").unwrap();
        assert!(!at(".polarform-Ab12Cd.tmp").exists());
        assert!(kept.iter().all(|name| at(name).exists()));
        assert!(writing.path().exists());
        drop(writing);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), kept.len() + 1);
    }

    #[test]
    fn a_change_at_the_last_moment_is_seen() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.md");
        fs::write(&path, "a").unwrap();
        let seen = write(&path, b"b", || {
            // The new text stands beside it by now.
            assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
            Err(problem("changed", "again"))
        });
        assert_eq!(seen.unwrap_err().message, "changed");
        assert_eq!(fs::read_to_string(&path).unwrap(), "a");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
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
