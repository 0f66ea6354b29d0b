//! Results as files, written whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use tempfile::Builder;

use crate::diagnostic::{Code, Diagnostic};

/// Writes a file: beside its place first, then it is renamed, so that the old file or the new one
/// stands there, whole. Permissions stay; a link is followed; devices are written to.
///
/// # Errors
/// When that is not possible; what stood there is as it was.
pub(super) fn write_file(path: &Path, text: &str) -> Result<(), Diagnostic> {
    let problem = |what: &dyn std::fmt::Display, hint: &str| {
        Diagnostic::error(Code::File, format!("cannot write {}: {what}", path.display())).hint(hint)
    };
    let failed = |error: io::Error| {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "the folder must exist",
            io::ErrorKind::PermissionDenied => "check the permissions of the file and of its folder",
            _ => "give another name",
        };
        problem(&error, hint)
    };
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&target).ok();
    match &old {
        Some(old) if old.is_dir() => return Err(problem(&"this is a directory", "give the name of a file")),
        // a device or a pipe cannot be replaced
        Some(old) if !old.is_file() => return fs::write(&target, text).map_err(failed),
        Some(old) if old.permissions().readonly() => {
            return Err(problem(&"it may only be read", "check its permissions"));
        }
        _ => {}
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = Builder::new();
    builder.prefix(".polarform-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // what the user's mask leaves of it, as for any new file
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut beside = builder.tempfile_in(folder).map_err(failed)?;
    beside.write_all(text.as_bytes()).map_err(failed)?;
    if let Some(old) = old {
        beside.as_file().set_permissions(old.permissions()).map_err(failed)?;
    }
    beside.persist(&target).map_err(|error| failed(error.error))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        write_file(&path, "one").unwrap();
        write_file(&path, "two").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        let missing = folder.path().join("missing").join("a.svg");
        assert_eq!(write_file(&missing, "x").unwrap_err().hints, ["the folder must exist"]);
        assert!(write_file(folder.path(), "x").unwrap_err().message.contains("directory"));
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert!(write_file(&path, "three").unwrap_err().message.contains("may only be read"));
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
    }
}
