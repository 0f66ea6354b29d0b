//! Waiting for files to change.
//!
//! The folders of the files are watched, not the files: many editors write a new file and rename
//! it over the old one, which a watch on the old one would not outlive.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use notify::{EventKind, RecommendedWatcher, RecursiveMode, Watcher};

/// A change is over when nothing happens for this long.
const QUIET: Duration = Duration::from_millis(100);

/// But after this long at the latest.
const LONGEST: Duration = Duration::from_secs(2);

/// How long a file may be missing while an editor puts another in its place.
const MISSING: Duration = Duration::from_millis(500);

enum Message {
    Changed(PathBuf),
    /// Something was missed; any file may have changed.
    AnyChanged,
    Stop,
}

/// Notices changes of files.
pub(super) struct Watch {
    watcher: RecommendedWatcher,
    sender: Sender<Message>,
    receiver: Receiver<Message>,
    folders: BTreeSet<PathBuf>,
    /// The files to look at, under the name that events have, and what changes with them.
    files: BTreeMap<PathBuf, BTreeSet<PathBuf>>,
}

impl Watch {
    pub fn new() -> notify::Result<Self> {
        let (sender, receiver) = channel();
        let events = sender.clone();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let messages = match event {
                Ok(event) if event.need_rescan() => vec![Message::AnyChanged],
                // Reading a file is no change; it would never end.
                Ok(event) if matches!(event.kind, EventKind::Access(_)) => vec![],
                Ok(event) => event.paths.into_iter().map(Message::Changed).collect(),
                Err(_) => vec![Message::AnyChanged],
            };
            for message in messages {
                // Without a receiver the watch is over.
                let _ = events.send(message);
            }
        })?;
        Ok(Watch { watcher, sender, receiver, folders: BTreeSet::new(), files: BTreeMap::new() })
    }

    /// Ends [`Watch::wait`] from another thread.
    pub fn stopper(&self) -> impl Fn() + Send + 'static {
        let sender = self.sender.clone();
        move || {
            let _ = sender.send(Message::Stop);
        }
    }

    /// When `path` changes, `root` is reported: itself or the file that includes it. A file in a
    /// folder that does not exist is not followed.
    pub fn follow(&mut self, path: &Path, root: &Path) -> notify::Result<()> {
        let Some(name) = path.file_name() else { return Ok(()) };
        let folder = match path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let Ok(folder) = fs::canonicalize(folder) else { return Ok(()) };
        let named = folder.join(name);
        // A link and what it leads to may both change.
        let target = fs::canonicalize(&named).unwrap_or_else(|_| named.clone());
        for file in [named, target] {
            if let Some(folder) = file.parent()
                && !self.folders.contains(folder)
            {
                self.watcher.watch(folder, RecursiveMode::NonRecursive)?;
                self.folders.insert(folder.to_owned());
            }
            self.files.entry(file).or_default().insert(root.to_owned());
        }
        Ok(())
    }

    /// Waits until files have changed and are quiet again, and tells which; `None` when stopped.
    pub fn wait(&self) -> Option<BTreeSet<PathBuf>> {
        let mut changed = BTreeSet::new();
        let mut deadline: Option<Instant> = None;
        loop {
            let message = match deadline {
                None => self.receiver.recv().ok()?,
                Some(deadline) => {
                    let left = deadline.saturating_duration_since(Instant::now());
                    match self.receiver.recv_timeout(QUIET.min(left)) {
                        Ok(message) => message,
                        Err(RecvTimeoutError::Timeout) => break,
                        Err(RecvTimeoutError::Disconnected) => return None,
                    }
                }
            };
            match message {
                Message::Stop => return None,
                Message::AnyChanged => changed.extend(self.files.values().flatten().cloned()),
                Message::Changed(path) => {
                    changed.extend(self.files.get(&path).into_iter().flatten().cloned())
                }
            }
            if !changed.is_empty() {
                deadline.get_or_insert_with(|| Instant::now() + LONGEST);
            }
        }
        let patience = Instant::now() + MISSING;
        while changed.iter().any(|path| !path.exists()) && Instant::now() < patience {
            thread::sleep(QUIET / 2);
        }
        Some(changed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder that is removed at the end of the test.
    struct Scratch(PathBuf);

    impl Scratch {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("polarform-{name}-{}", std::process::id()));
            fs::create_dir_all(&path).expect("the folder for temporary files is writable");
            Scratch(path)
        }

        fn write(&self, name: &str) -> PathBuf {
            let path = self.0.join(name);
            fs::write(&path, name).expect("the folder is writable");
            path
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn written_and_replaced_files_have_changed() {
        let folder = Scratch::new("watch");
        let (notes, part) = (folder.write("notes.md"), folder.write("part.md"));
        let mut watch = Watch::new().expect("the system can watch files");
        watch.follow(&notes, &notes).expect("the folder exists");
        watch.follow(&part, &notes).expect("the folder exists");
        let expected = Some(BTreeSet::from([notes.clone()]));
        for _ in 0..2 {
            let new = folder.write("notes.md~");
            fs::rename(new, &notes).expect("it can be renamed");
            assert_eq!(watch.wait(), expected);
        }
        fs::remove_file(&notes).expect("it is there");
        folder.write("notes.md");
        assert_eq!(watch.wait(), expected);
        folder.write("part.md");
        assert_eq!(watch.wait(), expected);
    }

    #[test]
    fn other_files_and_reading_are_no_change() {
        let folder = Scratch::new("quiet");
        let notes = folder.write("notes.md");
        let mut watch = Watch::new().expect("the system can watch files");
        watch.follow(&notes, &notes).expect("the folder exists");
        watch.follow(Path::new("/no/such/folder/file"), &notes).expect("it is left out");
        folder.write("other.md");
        fs::read(&notes).expect("it is there");
        let stop = watch.stopper();
        thread::spawn(move || {
            thread::sleep(3 * QUIET);
            stop();
        });
        assert_eq!(watch.wait(), None);
    }
}
