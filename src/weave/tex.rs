//! Weaving LaTeX: the results go to a file beside the document, in the manner of SageTeX.
//!
//! The document says `\usepackage{polarform}`, `\polarform{…}` and `\begin{polarform}`; it is never
//! changed. The package finds a result by the text of its query, so that the document compiles without
//! the program, too, and what is missing or belongs to another query shows as `??`. Equal queries are
//! told apart by the *state*: the number of queries before them that define a name. TeX counts states
//! itself; a running number of queries would go wrong wherever TeX sets a text twice.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::markdown::signature;
use super::markup::Markup;
use super::options::BlockOptions;
use super::runner::Runner;
use super::side::{Before, Entry, Key, block_result, body, file as side_file, inline_result};
use super::stamp::Digest;
use super::{Options, Woven};
use crate::document::{Part, PartKind, latex_parts};
use crate::formula::source::{Pieces, SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::session::Session;

/// Finds the files that a document reads with `\input` and its kin, by the name that stands there.
pub type Load<'a> = dyn FnMut(&str) -> Option<SourceFile> + 'a;

/// One document reads not more files than this, nor deeper.
const MAX_FILES: usize = 1000;
const MAX_DEPTH: usize = 20;

/// The name of the file of results of a document.
///
/// ```
/// use std::path::Path;
/// use polarform::weave::side_name;
/// assert_eq!(side_name(Path::new("a/lecture.tex")), Path::new("a/lecture.polarform.tex"));
/// ```
pub fn side_name(document: &Path) -> PathBuf {
    document.with_extension("polarform.tex")
}

/// Weaves a LaTeX document; the text of the outcome is that of its file of results, of which `before`
/// is the text after the last run. Included files are read in their places.
///
/// A query that fails keeps its result of before. If the stamp says that nothing changed, nothing is run.
///
/// Cost: the queries, and time linear in the length of the text.
///
/// ```
/// use polarform::source::SourceFile;
/// use polarform::weave::{Options, weave_latex};
/// let text = "\\documentclass{article}\\usepackage{polarform}\n\\begin{document}\n\
///             $1 + 1 = \\polarform{1 + 1}$\n\\end{document}\n";
/// let document = SourceFile::new("a.tex", text);
/// let woven = weave_latex(&document, "", &mut |_| None, &Options::default());
/// assert!(woven.text.contains("\\polarformresult{0}{0}{1 + 1}{2}"));
/// assert!(weave_latex(&document, &woven.text, &mut |_| None, &Options::default()).unchanged);
/// ```
pub fn weave_latex(document: &SourceFile, before: &str, load: &mut Load, options: &Options) -> Woven {
    let mut runner = Runner::new(Session::new(options.limits.clone()));
    let mut gathered = Gathered::default();
    gathered.file(document, load, &mut runner, 0);
    let old = Before::new(before);
    let mut digest = Digest::new(&signature(options));
    for Query { file, part } in &gathered.queries {
        digest.add(raw(file, part));
    }
    let mut unchanged = digest.clone();
    unchanged.add(old.body);
    if !options.fresh && runner.problems.is_empty() && old.stamp == Some(unchanged.text().as_str()) {
        return Woven::unchanged(before);
    }
    let mut woven = Woven::default();
    let mut entries: Vec<Entry> = Vec::new();
    let mut state = 0;
    let mut known: BTreeMap<(usize, Key), String> = BTreeMap::new();
    for query in &gathered.queries {
        let key = query.key();
        let defined = runner.definitions;
        let result = query.run(&mut runner, &options.blocks);
        let next = state + usize::from(runner.definitions > defined);
        let result = match result {
            Some(result) => {
                if !old.has(&key, &result) {
                    woven.stale.push((query.file.clone(), query.part.span));
                }
                result
            }
            // The old result stays.
            None => match old.result(&key, state) {
                Some(result) => result.to_owned(),
                None => {
                    state = next;
                    continue;
                }
            },
        };
        if known.get(&(state, key.clone())).is_some_and(|before| *before != result) {
            runner.problem(
                Diagnostic::error(Code::Unsupported, "LaTeX cannot tell this query from an equal one before")
                    .at(query.part.span)
                    .reason("it has another result here")
                    .hint("give a value a name, such as a := f(0, 1), and write it instead of ans"),
                &query.file,
            );
            continue;
        }
        known.insert((state, key.clone()), result.clone());
        entries.push(Entry { key, result, state, next });
        state = next;
    }
    if let Some(first) = gathered.queries.first().filter(|_| gathered.complete && !gathered.package) {
        runner.problem(
            Diagnostic::warning(Code::Usage, "the package polarform is not loaded")
                .at(first.part.span)
                .reason("LaTeX does not know this")
                .hint(r"write \usepackage{polarform} in the preamble"),
            &first.file,
        );
    }
    woven.take(runner);
    let name = Path::new(document.name()).file_name().map(|name| name.to_string_lossy().into_owned());
    let body = body(&name.unwrap_or_default(), &entries);
    if woven.stale.is_empty() && woven.is_clean() && body != old.body {
        // The results are the same, but TeX would not find all of them.
        woven.stale.extend(gathered.queries.first().map(|first| (first.file.clone(), first.part.span)));
    }
    digest.add(&body);
    let stamp = digest.text();
    woven.text = side_file(&body, Some(stamp.as_str()).filter(|_| woven.is_clean()));
    woven
}

/// The queries of a document and of the files it reads.
#[derive(Default)]
struct Gathered {
    queries: Vec<Query>,
    /// Whether the package is loaded.
    package: bool,
    /// Whether the preamble is there.
    complete: bool,
    names: BTreeSet<String>,
}

struct Query {
    file: SourceFile,
    part: Part,
}

impl Gathered {
    fn file(&mut self, file: &SourceFile, load: &mut Load, runner: &mut Runner, depth: usize) {
        self.complete |= file.text().contains(r"\documentclass");
        let (parts, problems) = latex_parts(file.text());
        for problem in problems {
            runner.problem(problem, file);
        }
        for part in parts {
            match &part.kind {
                PartKind::Include => {
                    // A file that is missing is told by LaTeX; one that is read twice is woven once.
                    let room = depth < MAX_DEPTH && self.names.len() < MAX_FILES;
                    if room
                        && self.names.insert(part.text.clone())
                        && let Some(inner) = load(&part.text)
                    {
                        self.file(&inner, load, runner, depth + 1);
                    }
                }
                PartKind::Package => self.package |= part.text == "polarform",
                PartKind::Code { info, closed: false } => {
                    runner.problem(
                        Diagnostic::error(Code::UnclosedQuery, r"\begin{polarform} is never closed")
                            .at(Span::new(part.span.start, info.end))
                            .reason("it begins here")
                            .hint(r"write \end{polarform} after the last statement"),
                        file,
                    );
                }
                PartKind::Query | PartKind::Code { .. } => {
                    self.queries.push(Query { file: file.clone(), part });
                }
                PartKind::Formula { .. } | PartKind::Comment => {}
            }
        }
    }
}

/// The text by which TeX finds a query: between the braces, or from the options to the end.
fn raw<'a>(file: &'a SourceFile, part: &Part) -> &'a str {
    let text = file.slice(part.span);
    match &part.kind {
        PartKind::Code { .. } => {
            let text = text.strip_suffix(r"\end{polarform}").unwrap_or(text);
            text.strip_prefix(r"\begin{polarform}").unwrap_or(text)
        }
        _ => {
            let open = text.find('{').map_or(0, |open| open + 1);
            text.piece(open..text.len().saturating_sub(1).max(open))
        }
    }
}

impl Query {
    fn key(&self) -> Key {
        let raw = raw(&self.file, &self.part).to_owned();
        match self.part.kind {
            PartKind::Code { .. } => Key::Block(raw),
            _ => Key::Inline(raw),
        }
    }

    /// What TeX is to set, or nothing if it fails.
    fn run(&self, runner: &mut Runner, defaults: &BlockOptions) -> Option<String> {
        let part = &self.part;
        let place = |span: Span| part.places.span(span);
        let PartKind::Code { info, .. } = &part.kind else {
            let piece = runner.query(&part.text, &self.file, &place, defaults)?;
            return Some(inline_result(&Markup::Latex.inline(&piece, true)));
        };
        let options = match defaults.with(self.file.slice(*info), info.start) {
            Ok(options) => options,
            Err(problems) => {
                problems.into_iter().for_each(|problem| runner.problem(problem, &self.file));
                return None;
            }
        };
        let pieces = runner.block(&part.text, &self.file, &place, &options)?;
        Some(block_result(!options.hide, &Markup::Latex.block(&pieces, &options)))
    }
}
