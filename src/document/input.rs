//! What is read from files and streams: never more than a limit, and told in one way if it cannot be read.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use crate::language::diagnostic::{Code, Diagnostic};

/// A longer file is refused.
pub const MAX_BYTES: u64 = 64 << 20;

/// All bytes of a file.
///
/// # Errors
/// [`Code::File`] if it is missing, a directory, unreadable, or longer than [`MAX_BYTES`].
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Diagnostic> {
    let name = path.display().to_string();
    match File::open(path) {
        // Where directories cannot be opened, that says nothing of permissions.
        Err(_) if path.is_dir() => Err(unread(&name, &io::ErrorKind::IsADirectory.into())),
        Err(error) => Err(unread(&name, &error)),
        Ok(file) => read_stream(&name, file),
    }
}

/// All bytes of what is called `name`, such as standard input.
///
/// # Errors
/// As for [`read_bytes`].
pub fn read_stream(name: &str, stream: impl Read) -> Result<Vec<u8>, Diagnostic> {
    let mut bytes = Vec::new();
    stream.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(|error| unread(name, &error))?;
    if bytes.len() as u64 > MAX_BYTES {
        let what = format!("{name}: longer than {} MiB, which is the limit", MAX_BYTES >> 20);
        return Err(Diagnostic::error(Code::File, what).hint("split it"));
    }
    Ok(bytes)
}

/// Bytes as text. Nothing is guessed.
///
/// # Errors
/// [`Code::Encoding`] with the place of the first byte that is not UTF-8.
pub fn utf8(name: &str, bytes: Vec<u8>) -> Result<String, Diagnostic> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes().iter().take(at).filter(|byte| **byte == b'\n').count() + 1;
        Diagnostic::error(Code::Encoding, format!("{name}: line {line} is not UTF-8 (byte {at})"))
            .hint("save the file as UTF-8; its other characters could not be kept exactly")
    })
}

/// The text of a file in UTF-8.
///
/// # Errors
/// As for [`read_bytes`] and [`utf8`].
pub fn read_string(path: &Path) -> Result<String, Diagnostic> {
    utf8(&path.display().to_string(), read_bytes(path)?)
}

/// What stands where something is to be written; nothing if that is no plain file (a pipe would wait for a writer) or
/// cannot be read.
pub fn standing(path: &Path) -> Option<Vec<u8>> {
    fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    read_bytes(path).ok()
}

fn unread(name: &str, error: &io::Error) -> Diagnostic {
    let (what, hint) = match error.kind() {
        io::ErrorKind::NotFound => ("there is no such file".to_owned(), "check the path"),
        io::ErrorKind::PermissionDenied => ("the file may not be read".to_owned(), "check its permissions"),
        io::ErrorKind::IsADirectory => ("this is a directory".to_owned(), "name the files in it"),
        _ => (error.to_string(), "check the path"),
    };
    Diagnostic::error(Code::File, format!("{name}: {what}")).hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_endless_or_no_text_is_refused() {
        let problem = read_stream("endless", io::repeat(b'a')).unwrap_err();
        assert_eq!((problem.code, problem.message.contains("longer than 64 MiB")), (Code::File, true));
        assert_eq!(read_stream("short", b"a".as_slice()).unwrap(), b"a");
        let problem = utf8("a.md", b"a\n\xffb".to_vec()).unwrap_err();
        assert_eq!(problem.code, Code::Encoding);
        assert_eq!(problem.message, "a.md: line 2 is not UTF-8 (byte 2)");
        assert!(read_string(&std::env::temp_dir()).unwrap_err().message.ends_with("this is a directory"));
        let missing = std::env::temp_dir().join("polarform/no/such/file");
        assert!(read_bytes(&missing).unwrap_err().message.ends_with("there is no such file"));
        assert_eq!(standing(&missing), None);
        assert_eq!(standing(&std::env::temp_dir()), None);
    }

    #[cfg(unix)]
    #[test]
    fn devices_without_an_end_are_refused() {
        let zero = Path::new("/dev/zero");
        if zero.exists() {
            assert!(read_bytes(zero).unwrap_err().message.contains("longer than 64 MiB"));
            assert_eq!(standing(zero), None);
        }
    }
}
