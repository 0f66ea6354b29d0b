//! The command that weaves.

use std::collections::BTreeSet;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use serde_json::json;

use super::Status;
use super::arguments::{Global, Weave};
use super::beside::{STYLE, beside, loader, put_beside, standing_text};
use super::commands::{Ran, Stop};
use super::notes_config::Config;
use super::notes_input::{expanded, identity, standard_input};
use super::output::{Output, shown};
use super::pictures::{picture_prefix, put_picture, stays_inside};
use super::script::is_standard;
use crate::document::{Container, read_bytes, read_stream, standing, utf8};
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic, harmless};
use crate::language::write::Format;
use crate::notes::report::mathml_within;
use crate::session::Failure;
use crate::weave::{
    BlockOptions, Input, Mode, Options, PACKAGE, Woven, copy_is_fresh, pictures_in, read_input, replace_file,
    weave_book, weave_copy, weave_latex, weave_markdown, weave_notebook, write_file,
};

pub(super) fn run(arguments: &Weave, global: &Global, output: &Output) -> Ran {
    if matches!(global.format(), Format::Latex | Format::Sympy | Format::Unicode) {
        return Err(usage("weaving has no such format", "choose --format text or json, for messages"));
    }
    let mode = if arguments.output.is_some() { Mode::Template } else { Mode::InPlace };
    let blocks = BlockOptions {
        notation: global.notation(),
        arrange: global.arrange,
        lang: global.lang,
        ..BlockOptions::default()
    };
    let limits = global.limits();
    let set: Option<fn(&str, bool) -> Option<String>> = arguments.mathml.then_some(mathml_within);
    let options = Options { mode, limits, blocks, fresh: arguments.fresh, pictures: None, set };
    let weaver = Weaver { arguments, options, output };
    if arguments.mdbook {
        return weaver.book();
    }
    if let Some(folder) = &arguments.write_style {
        let path = folder.join(STYLE);
        write_file(&path, PACKAGE).map_err(failed)?;
        weaver.say(&format!("{} written", shown(&path)))?;
    }
    if let (Some(target), [_, _, ..]) = (&arguments.output, arguments.files.as_slice()) {
        let message = format!("several files cannot go to {}", target.display());
        return Err(usage(&message, "weave them one after the other"));
    }
    let here = std::env::current_dir().unwrap_or_default();
    let config = Config::load(None, &here)?;
    let mut status = Status::Fine;
    for path in &weavable(&arguments.files, &config) {
        let result = catch_unwind(AssertUnwindSafe(|| weaver.file(path))).unwrap_or_else(|_| {
            Err(failed(
                Diagnostic::error(Code::Internal, "polarform met a defect of its own")
                    .hint("please report the file that led here"),
            ))
        });
        status = status.max(match result {
            Err(Stop::Failed(failure)) => {
                output.failure(&failure);
                Status::Failed
            }
            result => result?,
        });
    }
    Ok(status)
}

/// The files, and those of folders into which results can be written: LaTeX is woven from its main file.
fn weavable(files: &[PathBuf], config: &Config) -> Vec<PathBuf> {
    let mut all = expanded(files, |path| config.excludes(path));
    all.retain(|path| {
        files.contains(path)
            || match Container::of(path) {
                Ok(Container::Latex) => read_bytes(path)
                    .is_ok_and(|bytes| String::from_utf8_lossy(&bytes).contains(r"\documentclass")),
                kind => matches!(kind, Ok(Container::Markdown | Container::Notebook)),
            }
    });
    all
}

struct Weaver<'a> {
    arguments: &'a Weave,
    options: Options,
    output: &'a Output,
}

impl Weaver<'_> {
    fn say(&self, line: &str) -> io::Result<()> {
        if self.output.format == Format::Json || self.output.quiet { Ok(()) } else { self.output.line(line) }
    }

    /// Standard input with its results, on standard output.
    fn standard(&self) -> Ran {
        let (bytes, kind) = standard_input(self.arguments.kind.map(Container::from)).map_err(failed)?;
        let text = utf8("standard input", bytes).map_err(failed)?;
        let file = SourceFile::new("standard input", text);
        let woven = match kind {
            Container::Markdown => weave_markdown(&file, &self.options),
            Container::Notebook => weave_notebook(&file, &self.options),
            // What LaTeX reads stands in a file of its own: that is what goes to standard output.
            Container::Latex if !self.arguments.check => {
                weave_latex(&file, "", &mut loader(Path::new("")), &self.options)
            }
            Container::Latex => {
                let hint = "the results of LaTeX stand in another file; check the document by its name";
                return Err(usage("standard input has no results that could be out of date", hint));
            }
            Container::Rst => {
                let hint = "weave Markdown, LaTeX or a notebook; one that was taken for it: --as markdown, latex or notebook";
                return Err(usage("results are not written into reStructuredText", hint));
            }
        };
        self.tell(&woven);
        if !self.arguments.check {
            self.output.text(&woven.text)?;
            return Ok(ended(&woven));
        }
        self.finish(file.name(), &woven)
    }

    fn file(&self, path: &Path) -> Ran {
        if is_standard(path) {
            return match self.arguments.output.as_deref() {
                Some(target) if !is_standard(target) => Err(usage(
                    "a page from standard input goes to standard output",
                    "leave out -o, and write > FILE after the command",
                )),
                _ => self.standard(),
            };
        }
        let input = read_input(path).map_err(failed)?;
        match (Container::of(path).map_err(failed)?, &self.arguments.output) {
            (Container::Rst, _) => Err(usage(
                "results are not written into reStructuredText",
                "weave Markdown, LaTeX or a notebook; `polarform notes check` reads reStructuredText",
            )),
            (Container::Latex, Some(_)) => Err(usage(
                "a LaTeX document is not copied",
                "its results go to a file beside it; leave out -o",
            )),
            (Container::Latex, None) => self.latex(path, &input),
            (kind, Some(target)) => self.copy(kind, path, &input, target),
            (kind, None) => {
                let mut woven = match kind {
                    Container::Notebook => weave_notebook(&input.file, &self.options),
                    _ => {
                        let options = self.with_pictures(path);
                        let gone = !options.fresh && pictures_are_gone(path, input.file.text());
                        weave_markdown(&input.file, &Options { fresh: options.fresh || gone, ..options })
                    }
                };
                self.tell(&woven);
                self.pictures(path, &mut woven)?;
                if !self.arguments.check && woven.text != input.file.text() {
                    replace_file(&input, &woven.text).map_err(failed)?;
                }
                self.finish(&path.display().to_string(), &woven)
            }
        }
    }

    /// Prints what is wrong.
    fn tell(&self, woven: &Woven) {
        for failure in &woven.problems {
            self.output.failure(failure);
        }
    }

    /// Says what was done, and how it ended.
    fn finish(&self, name: &str, woven: &Woven) -> Ran {
        let changed = woven.stale.len();
        if self.arguments.check {
            for (file, span) in &woven.stale {
                let stale = Diagnostic::error(Code::OutOfDate, "the result of this query is out of date");
                self.output.problem(&stale.at(*span).hint(self.remedy()), file);
            }
        }
        let what = match (woven.unchanged, self.arguments.check) {
            (true, _) => "nothing changed".to_owned(),
            (false, true) => format!("{}, {changed} out of date", counted(woven.results)),
            (false, false) => format!("{}, {changed} changed", counted(woven.results)),
        };
        if self.output.format == Format::Json {
            self.output.line(&summary(name, woven).to_string())?;
        } else {
            self.say(&format!("{}: {what}", harmless(name)))?;
        }
        let stale = if self.arguments.check && changed > 0 { Status::Refuted } else { Status::Fine };
        Ok(ended(woven).max(stale))
    }

    /// The options for a document whose pictures stand beside it.
    fn with_pictures(&self, document: &Path) -> Options {
        Options { pictures: Some(picture_prefix(document)), ..self.options.clone() }
    }

    /// Writes the pictures of a document, or says which are out of date.
    fn pictures(&self, document: &Path, woven: &mut Woven) -> Result<(), Stop> {
        let folder = document.parent().unwrap_or(Path::new(""));
        for (name, svg) in &woven.pictures {
            let path = folder.join(name);
            if self.arguments.check && standing(&path).as_deref() != Some(svg.as_bytes()) {
                stays_inside(folder, &path).map_err(failed)?;
                let file = SourceFile::new(path.display().to_string(), "");
                woven.stale.push((file, Span::default()));
            } else {
                put_picture(folder, name, svg).map_err(failed)?;
            }
        }
        Ok(())
    }

    fn remedy(&self) -> String {
        let files: Vec<String> = self.arguments.files.iter().map(|path| path.display().to_string()).collect();
        let target = self.arguments.output.as_ref();
        let target = target.map(|target| format!(" -o {}", target.display())).unwrap_or_default();
        format!("run polarform weave {}{target}", files.join(" "))
    }

    /// A copy that holds results in place of queries. With a problem there is none.
    fn copy(&self, kind: Container, path: &Path, input: &Input, target: &Path) -> Ran {
        let name = path.display().to_string();
        let standard = is_standard(target);
        if !standard && identity(path) == identity(target) {
            return Err(usage(
                "the copy would take the place of its source",
                "leave out -o to weave in place",
            ));
        }
        let before = if standard { None } else { standing_text(target) };
        let markdown = kind == Container::Markdown;
        if let Some(before) = before.as_ref().filter(|_| markdown)
            && copy_is_fresh(&input.file, before, &self.with_pictures(target))
        {
            return self.finish(&name, &Woven { unchanged: true, ..Woven::default() });
        }
        let mut woven = match kind {
            Container::Notebook => weave_notebook(&input.file, &self.options),
            _ if standard => weave_markdown(&input.file, &self.options),
            _ => weave_copy(&input.file, &self.with_pictures(target)),
        };
        self.tell(&woven);
        if self.arguments.check {
            woven.stale.clear();
            if before.as_deref() != Some(woven.text.as_str()) && !woven.failed {
                let old = SourceFile::new(target.display().to_string(), before.unwrap_or_default());
                woven.stale.push((old.clone(), first_difference(old.text(), &woven.text)));
            }
        } else if woven.failed {
            self.say(&format!("{} was not written", shown(target)))?;
        } else if standard {
            self.output.text(&woven.text)?;
            return Ok(if woven.refuted > 0 { Status::Refuted } else { Status::Fine });
        } else if before.as_deref() != Some(woven.text.as_str()) {
            write_file(target, &woven.text).map_err(failed)?;
        }
        if !woven.failed {
            self.pictures(target, &mut woven)?;
        }
        self.finish(&name, &woven)
    }

    fn latex(&self, path: &Path, input: &Input) -> Ran {
        let name = path.display().to_string();
        if self.arguments.check {
            let (woven, _) = beside(path, &input.file, &self.options);
            self.tell(&woven);
            return self.finish(&name, &woven);
        }
        let (woven, style) = put_beside(path, &input.file, &self.options).map_err(failed)?;
        self.tell(&woven);
        if let Some(style) = style {
            self.say(&format!("{} written", shown(&style)))?;
        }
        self.finish(&name, &woven)
    }

    /// `polarform weave --mdbook`, and `… --mdbook supports html`.
    fn book(&self) -> Ran {
        if self.arguments.files.first().is_some_and(|word| word == Path::new("supports")) {
            // Markdown with formulas is for every renderer.
            return Ok(Status::Fine);
        }
        let text = read_stream("the book", io::stdin().lock()).and_then(|bytes| utf8("the book", bytes));
        let text = text.map_err(failed)?;
        let woven = weave_book(&text, &self.options)
            .map_err(|error| usage(&error.to_string(), "mdBook starts this command; see docs/weave.md"))?;
        self.tell(&woven);
        if woven.failed {
            return Ok(Status::Failed);
        }
        self.output.text(&woven.text)?;
        Ok(if woven.refuted > 0 { Status::Refuted } else { Status::Fine })
    }
}

/// How the queries went.
fn ended(woven: &Woven) -> Status {
    match (woven.failed, woven.refuted) {
        (true, _) => Status::Failed,
        (false, 0) => Status::Fine,
        (false, _) => Status::Refuted,
    }
}

fn summary(name: &str, woven: &Woven) -> serde_json::Value {
    let stale: BTreeSet<(String, usize)> =
        woven.stale.iter().map(|(file, span)| (file.name().to_owned(), file.line(span.start))).collect();
    let stale: Vec<_> = stale.iter().map(|(file, line)| json!({"file": file, "line": line})).collect();
    json!({
        "file": name,
        "unchanged": woven.unchanged,
        "results": woven.results,
        "changed": stale,
        "refuted": woven.refuted,
        "failed": woven.failed,
    })
}

fn counted(results: usize) -> String {
    if results == 1 { "1 result".to_owned() } else { format!("{results} results") }
}

/// The first line of the old text that is another one in the new text.
fn first_difference(old: &str, new: &str) -> Span {
    let mut at = 0;
    for (a, b) in old.split_inclusive('\n').zip(new.split_inclusive('\n')) {
        if a != b {
            return Span::new(at, at + a.trim_end().len());
        }
        at += a.len();
    }
    Span::new(at.min(old.len()), old.len())
}

fn failed(problem: Diagnostic) -> Stop {
    Stop::Failed(Box::new(Failure { problem, file: SourceFile::new("<files>", "") }))
}

fn usage(message: &str, hint: &str) -> Stop {
    failed(Diagnostic::error(Code::Usage, message).hint(hint))
}

/// Whether a picture that was woven into a document is not there any more.
fn pictures_are_gone(document: &Path, text: &str) -> bool {
    let folder = document.parent().unwrap_or(Path::new(""));
    pictures_in(text).iter().any(|name| !folder.join(name).exists())
}
