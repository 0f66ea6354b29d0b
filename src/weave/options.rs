//! How the results of a block are shown: `steps=true notation=sigma style=list`.
//!
//! The options stand after the name of the language in the first line of a fenced block, separated by
//! blanks or commas, also in the braces of Pandoc (`{.polarform style=list}`), or in the brackets of
//! `\begin{polarform}[style=list]`.

use crate::formula::source::{Pieces, Span};
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::functions::Arrangement;
use crate::language::value::{Language, Notation};
use crate::language::write::{ARTICLE, Breaks};
use crate::math::blossom::Method;

/// How several results are arranged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Style {
    /// Each on lines of its own.
    #[default]
    Display,
    /// All in one line.
    Inline,
    /// A list with a point for each.
    List,
    /// A table: statements on the left, results on the right.
    Table,
    /// As on a terminal.
    Code,
}

/// Which results of a block are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Show {
    /// Of every statement.
    #[default]
    All,
    /// Of the last statement.
    Last,
    /// None: the block defines names for others.
    Nothing,
}

/// The options of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockOptions {
    /// Show the derivation of polar forms, by this method.
    pub steps: Option<Method>,
    /// How polar forms are written.
    pub notation: Notation,
    /// How formulas are arranged.
    pub arrange: Arrangement,
    /// How several results stand together.
    pub style: Style,
    /// Show the results only.
    pub hide: bool,
    /// Which results are shown.
    pub show: Show,
    /// Write `query = value` rather than the value.
    pub equation: bool,
    /// The language of derivations.
    pub lang: Language,
    /// The width of display formulas in points: longer ones are broken. As wide as an article if not
    /// given; 0 breaks nothing.
    pub width: Option<u16>,
    /// How wider ones are broken, in LaTeX.
    pub breaks: Breaks,
    /// The file for a figure, without its extension, relative to the document.
    pub picture: Option<String>,
}

const NAMES: [&str; 11] = [
    "steps", "notation", "arrange", "style", "hide", "show", "equation", "lang", "width", "breaks", "picture",
];

const STYLES: [(&str, Style); 5] = [
    ("display", Style::Display),
    ("inline", Style::Inline),
    ("list", Style::List),
    ("table", Style::Table),
    ("code", Style::Code),
];

const NOTATIONS: [(&str, Notation); 4] = [
    ("grouped", Notation::Grouped),
    ("expanded", Notation::Expanded),
    ("sigma", Notation::Sigma),
    ("ellipsis", Notation::Ellipsis),
];

const SHOWS: [(&str, Show); 3] = [("all", Show::All), ("last", Show::Last), ("none", Show::Nothing)];

const LANGUAGES: [(&str, Language); 2] = [("en", Language::English), ("zh", Language::Chinese)];

const SWITCH: [(&str, bool); 2] = [("true", true), ("false", false)];

impl BlockOptions {
    /// How wide a display formula may be, in points.
    pub(super) fn room(&self) -> f64 {
        match self.width {
            None => ARTICLE,
            Some(0) => f64::INFINITY,
            Some(points) => f64::from(points),
        }
    }

    /// These options changed as a text says; it stands at byte `start` of its file.
    ///
    /// # Errors
    /// One problem, with its place and a hint, for each option that does not exist or takes no such value.
    ///
    /// ```
    /// use polarform::weave::{BlockOptions, Style};
    /// let options = BlockOptions::default().with("style=list, hide", 0).unwrap();
    /// assert_eq!((options.style, options.hide), (Style::List, true));
    /// let problems = BlockOptions::default().with("stile=list", 0).unwrap_err();
    /// assert_eq!(problems[0].hints, ["did you mean 'style'?"]);
    /// ```
    pub fn with(&self, text: &str, start: usize) -> Result<BlockOptions, Vec<Diagnostic>> {
        let mut options = self.clone();
        let mut problems = Vec::new();
        for word in words(text) {
            // Labels and classes of Pandoc are for others.
            if word.text.starts_with(['#', '.']) {
                continue;
            }
            if let Err(problem) = options.set(&word) {
                let span = Span::new(start + word.start, start + word.start + word.text.len());
                problems.push(problem.at(span));
            }
        }
        if problems.is_empty() { Ok(options) } else { Err(problems) }
    }

    fn set(&mut self, word: &Word) -> Result<(), Diagnostic> {
        let (name, value) = word.text.split_once('=').unwrap_or((word.text, "true"));
        let value = value.trim_matches('"');
        match name {
            "steps" => {
                self.steps = match value {
                    "true" => Some(Method::Elementary),
                    "false" => None,
                    _ => Some(value.parse().map_err(|_| {
                        let known = Method::ALL.iter().map(|method| method.name());
                        wrong_value(name, value, ["true", "false"].into_iter().chain(known))
                    })?),
                }
            }
            "notation" => self.notation = chosen(name, value, &NOTATIONS)?,
            "arrange" => {
                let known = Arrangement::ALL.map(|one| (one.name(), one));
                self.arrange = chosen(name, value, &known)?;
            }
            "style" => self.style = chosen(name, value, &STYLES)?,
            "hide" => self.hide = chosen(name, value, &SWITCH)?,
            "show" => self.show = chosen(name, value, &SHOWS)?,
            "equation" => self.equation = chosen(name, value, &SWITCH)?,
            "lang" => self.lang = chosen(name, value, &LANGUAGES)?,
            "width" => {
                let points = value.strip_suffix("pt").unwrap_or(value).parse();
                self.width =
                    Some(points.map_err(|_| wrong_value(name, value, ["points such as 345"].into_iter()))?);
            }
            "breaks" => self.breaks = chosen(name, value, &Breaks::ALL.map(|one| (one.name(), one)))?,
            "picture" => self.picture = Some(file_name(value)?),
            _ => {
                let problem = Diagnostic::error(Code::BlockOption, format!("there is no option '{name}'"));
                return Err(match nearest(name, NAMES) {
                    Some(best) => problem.hint(format!("did you mean '{best}'?")),
                    None => problem.hint(format!("the options are {}", NAMES.join(", "))),
                });
            }
        }
        Ok(())
    }
}

/// A name for a file below the folder of the document.
fn file_name(value: &str) -> Result<String, Diagnostic> {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | '/');
    let inside = value.split('/').all(|part| !part.is_empty() && part != "." && part != "..");
    if inside && value.chars().all(plain) {
        return Ok(value.strip_suffix(".svg").unwrap_or(value).to_owned());
    }
    Err(Diagnostic::error(Code::BlockOption, format!("'{value}' is no name for a file beside the document"))
        .hint("letters, digits, '-', '_' and '/' for folders below it: picture=figures/curve"))
}

fn chosen<T: Copy>(name: &str, value: &str, known: &[(&'static str, T)]) -> Result<T, Diagnostic> {
    let found = known.iter().find(|(word, _)| *word == value).map(|(_, meaning)| *meaning);
    found.ok_or_else(|| wrong_value(name, value, known.iter().map(|(word, _)| *word)))
}

fn wrong_value(name: &str, value: &str, known: impl Iterator<Item = &'static str>) -> Diagnostic {
    let known: Vec<&str> = known.collect();
    Diagnostic::error(Code::BlockOption, format!("the option {name} does not take '{value}'"))
        .hint(format!("it takes {}", known.join(", ")))
}

struct Word<'a> {
    text: &'a str,
    start: usize,
}

/// The words between blanks and commas; quotation marks keep a word together.
fn words(text: &str) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let mut begin = None;
    let mut quoted = false;
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        let separates = !quoted && (c.is_whitespace() || c == ',');
        match begin {
            Some(start) if separates => {
                words.push(Word { text: text.piece(start..at), start });
                begin = None;
            }
            None if !separates => begin = Some(at),
            _ => {}
        }
    }
    words.extend(begin.map(|start| Word { text: text.piece(start..), start }));
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::options_in;

    fn read(text: &str) -> BlockOptions {
        BlockOptions::default().with(text, 0).unwrap()
    }

    #[test]
    fn all_options() {
        let options =
            read("steps=taylor,notation=\"sigma\" style=table  show=last equation lang=en #eq:a .b");
        assert_eq!(options.steps, Some(Method::Taylor));
        assert_eq!((options.notation, options.style), (Notation::Sigma, Style::Table));
        assert_eq!((options.show, options.equation, options.hide), (Show::Last, true, false));
        assert_eq!(read("steps"), read("steps=true"));
        assert_eq!(read("steps=false"), BlockOptions::default());
    }

    #[test]
    fn problems_have_a_place_and_a_hint() {
        let problems = BlockOptions::default().with("a style=lists steps=some", 100).unwrap_err();
        let spans: Vec<_> = problems.iter().map(|problem| problem.span.unwrap()).collect();
        assert_eq!(spans, [Span::new(100, 101), Span::new(102, 113), Span::new(114, 124)]);
        assert!(problems.iter().all(|problem| problem.hints.len() == 1));
    }

    #[test]
    fn infos() {
        for info in ["polarform", " polarform ", "{polarform}", "{ .polarform }", "polarform,hide"] {
            assert!(options_in(info).is_some(), "{info}");
        }
        for info in ["", "{", "{}", "polarforms", "{=polarform}", "text polarform"] {
            assert_eq!(options_in(info), None, "{info}");
        }
    }
}
