//! Files of notes, and the files they include.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::collect::{Collector, Include};
use super::decode::decode;
use super::input::read_bytes;
use super::macros::Macros;
use super::{Container, one, scan, tex};
use crate::document::Document;
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic, Severity};

/// How many files one may include, and how deep.
const MAX_FILES: usize = 1000;
const MAX_DEPTH: usize = 20;

/// How files are read.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// How the first file is written, if the ending of its name does not tell.
    pub kind: Option<Container>,
    /// Macros that are known before the first line.
    pub macros: Macros,
    /// What stands in the first file, if that is not yet saved: it is then not read.
    pub text: Option<String>,
}

/// Reads a file of notes and all that it includes (by `\input` and its kin in LaTeX, by the directive `include` of
/// MyST and reStructuredText, by `{{< include … >}}` of Quarto, by `{{#include …}}` of mdBook), in this order: the
/// file itself, then the others in the order of reading. They share their macros.
///
/// The ending of the name tells how it is written, unless `reading` says so.
///
/// # Errors
/// [`Code::File`] if the file cannot be read or is too long, [`Code::FileKind`] if its ending is unknown; an
/// included one is a problem of the one that includes it.
pub fn read_files(path: &Path, reading: &Reading) -> Result<Vec<Document>, Diagnostic> {
    let known = reading.kind.map_or_else(|| Container::of(path), Ok);
    if let Err(problem) = &known
        && path.is_file()
    {
        return Err(problem.clone());
    }
    let (file, problems) = match &reading.text {
        None => load(path)?,
        Some(text) => (SourceFile::new(path.display().to_string(), text.as_str()), Vec::new()),
    };
    let kind = known?;
    let out = Collector::with(reading.macros.clone(), problems);
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let mut loader = Loader { folder, documents: Vec::new(), open: Vec::new(), read: HashSet::new() };
    match kind {
        Container::Latex => loader.latex(path, file, true, out),
        kind => loader.page(path, file, kind, out),
    };
    Ok(loader.documents.into_iter().flatten().collect())
}

/// Takes apart what was read from somewhere else than a file, such as standard input; it is called `name`.
///
/// # Errors
/// If the bytes are no text.
pub fn read_text(
    name: &str,
    bytes: Vec<u8>,
    kind: Container,
    macros: &Macros,
) -> Result<Document, Diagnostic> {
    let (file, problems) = decoded(name, bytes)?;
    Ok(one(file, kind, Collector::with(macros.clone(), problems)))
}

/// The macros that a file of LaTeX defines.
///
/// # Errors
/// If the file cannot be read, or is too long.
pub fn read_macros(path: &Path) -> Result<Macros, Diagnostic> {
    macros_in(&path.display().to_string(), read_bytes(path)?)
}

/// The same of what was read from somewhere else; it is called `name`.
///
/// # Errors
/// If the bytes are no text.
pub fn macros_in(name: &str, bytes: Vec<u8>) -> Result<Macros, Diagnostic> {
    let (file, problems) = decoded(name, bytes)?;
    let mut out = Collector::with(Macros::default(), problems);
    scan(file.text(), Container::Latex, &mut out);
    Ok(out.macros)
}

/// Reads files and those that they include into documents.
struct Loader {
    /// The folder of the first file.
    folder: PathBuf,
    /// In the order in which they were begun.
    documents: Vec<Option<Document>>,
    /// The files that include each other, up to the one that is being read.
    open: Vec<PathBuf>,
    read: HashSet<PathBuf>,
}

impl Loader {
    /// Takes a file of LaTeX apart; its macros are handed back.
    fn latex(&mut self, path: &Path, file: SourceFile, body: bool, mut out: Collector) -> Macros {
        let slot = self.begin(path);
        tex::scan(file.text(), body, &mut out, &mut |name, place, body, out| {
            let path = self.find(name);
            self.include(name, path, place, out, |loader, path, file, inner| {
                loader.latex(path, file, body, inner)
            });
        });
        self.end(slot, file, out)
    }

    /// Takes another file apart, after those that it includes, so that their macros are known.
    ///
    /// Cost: it is taken apart twice if it includes some.
    fn page(&mut self, path: &Path, file: SourceFile, kind: Container, mut out: Collector) -> Macros {
        let slot = self.begin(path);
        let (macros, problems) = out.known();
        scan(file.text(), kind, &mut out);
        if out.includes.is_empty() {
            return self.end(slot, file, out);
        }
        let includes = std::mem::replace(&mut out, Collector::with(macros, problems)).includes;
        for Include { name, place } in includes {
            let path = self.find_page(&name);
            let kind = path.as_deref().map_or(Ok(kind), Container::of);
            match kind {
                Ok(kind) => {
                    self.include(&name, path, place, &mut out, |loader, path, file, inner| match kind {
                        Container::Latex => loader.latex(path, file, true, inner),
                        kind => loader.page(path, file, kind, inner),
                    })
                }
                Err(problem) => out.problem(Diagnostic {
                    code: Code::Include,
                    severity: Severity::Warning,
                    span: Some(place),
                    ..problem
                }),
            }
        }
        scan(file.text(), kind, &mut out);
        self.end(slot, file, out)
    }

    /// The place of the document of a file that is read from here on.
    fn begin(&mut self, path: &Path) -> usize {
        self.documents.push(None);
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        self.read.insert(path.clone());
        self.open.push(path);
        self.documents.len() - 1
    }

    fn end(&mut self, slot: usize, file: SourceFile, mut out: Collector) -> Macros {
        self.open.pop();
        let macros = std::mem::take(&mut out.macros);
        self.documents[slot] = Some(out.into_document(file));
        macros
    }

    fn include(
        &mut self,
        name: &str,
        path: Option<PathBuf>,
        place: Span,
        out: &mut Collector,
        read: impl FnOnce(&mut Self, &Path, SourceFile, Collector) -> Macros,
    ) {
        let Some(path) = path else {
            // Packages and class files of the system are not looked for.
            let missing =
                Diagnostic::warning(Code::Include, format!("the included file {name} was not found"));
            out.problem(missing.at(place).hint("its formulas and macros are not known; check the path"));
            return;
        };
        let known = fs::canonicalize(&path).unwrap_or_else(|_| path.clone());
        if self.open.contains(&known) {
            let cycle = Diagnostic::warning(Code::Include, format!("{name} includes itself"));
            out.problem(cycle.at(place).hint("remove one of the inclusions; it is read once"));
            return;
        }
        if self.read.contains(&known) {
            return;
        }
        if self.open.len() >= MAX_DEPTH || self.documents.len() >= MAX_FILES {
            let many = Diagnostic::warning(Code::Include, format!("{name} was not read: too many files"));
            out.problem(many.at(place).hint("check it by itself"));
            return;
        }
        match load(&path) {
            Ok((file, problems)) => {
                let inner = Collector::with(std::mem::take(&mut out.macros), problems);
                out.macros = read(self, &path, file, inner);
            }
            Err(problem) => out.problem(Diagnostic { code: Code::Include, span: Some(place), ..problem }),
        }
    }

    /// The file of this name beside the one that includes it; a name that begins with `/` belongs to the folder of
    /// the whole book, which is one of those around it.
    fn find_page(&self, name: &str) -> Option<PathBuf> {
        let folder = self.open.last()?.parent()?;
        let beside = folder.join(name.trim_start_matches('/'));
        let book = || folder.ancestors().skip(1).map(|folder| folder.join(name.trim_start_matches('/')));
        let around = book().take(if name.starts_with('/') { MAX_DEPTH } else { 0 });
        [beside].into_iter().chain(around).find(|path| path.is_file())
    }

    /// The file of this name, with or without its ending: beside the first file, as LaTeX looks
    /// for it, or beside the one that includes it.
    fn find(&self, name: &str) -> Option<PathBuf> {
        let folders = [Some(self.folder.as_path()), self.open.last().and_then(|path| path.parent())];
        let named = |folder: &Path| [folder.join(format!("{name}.tex")), folder.join(name)];
        folders.into_iter().flatten().flat_map(named).find(|path| path.is_file())
    }
}

/// The text of a file, with what had to be guessed.
fn load(path: &Path) -> Result<(SourceFile, Vec<Diagnostic>), Diagnostic> {
    decoded(&path.display().to_string(), read_bytes(path)?)
}

fn decoded(name: &str, bytes: Vec<u8>) -> Result<(SourceFile, Vec<Diagnostic>), Diagnostic> {
    let (text, problems) = decode(bytes).map_err(|problem| {
        let message = format!("{name}: {}", problem.message);
        Diagnostic { message, ..problem }
    })?;
    Ok((SourceFile::new(name, text), problems))
}
