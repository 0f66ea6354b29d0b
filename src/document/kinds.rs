//! How pages are written: by the endings of their names, or by their text.

use std::path::Path;

use super::Container;
use crate::language::diagnostic::{Code, Diagnostic};

/// Endings of files by how they are written; a name without ending is Markdown.
const ENDINGS: &[(Container, &[&str])] = &[
    (
        Container::Markdown,
        &[
            "md", "markdown", "mdown", "mkd", "mkdn", "mdwn", "mdx", "qmd", "rmd", "jmd", "myst", "txt",
            "text",
        ],
    ),
    (Container::Rst, &["rst", "rest"]),
    (Container::Latex, &["tex", "ltx", "latex", "sty", "cls"]),
    (Container::Notebook, &["ipynb"]),
];

/// Endings of files that pandoc turns into Markdown, with the names of their formats.
const CONVERTIBLE: &[(&str, &str)] = &[
    ("typ", "Typst"),
    ("org", "Org"),
    ("html", "HTML"),
    ("htm", "HTML"),
    ("xhtml", "HTML"),
    ("docx", "Word"),
    ("odt", "OpenDocument"),
    ("epub", "EPUB"),
    ("textile", "Textile"),
    ("wiki", "MediaWiki"),
    ("mediawiki", "MediaWiki"),
    ("typst", "Typst"),
];

impl Container {
    /// How a page is written that says so in no other way: LaTeX if it begins a document, a notebook if it looks like one,
    /// else Markdown.
    pub fn guess(page: &[u8]) -> Container {
        // A page in Markdown may show a document of LaTeX, in a block of code.
        let fenced = |line: &[u8]| line.starts_with(b"```") || line.starts_with(b"~~~");
        let opens =
            |line: &[u8]| line.starts_with(br"\documentclass") || line.starts_with(br"\begin{document}");
        let holds = |part: &[u8]| page.windows(part.len()).any(|window| window == part);
        let mut before =
            page.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii).take_while(|line| !fenced(line));
        match () {
            () if before.any(opens) => Container::Latex,
            () if page.trim_ascii_start().starts_with(b"{") && holds(b"\"cells\"") => Container::Notebook,
            () => Container::Markdown,
        }
    }

    /// The kind of a file by the ending of its name.
    ///
    /// # Errors
    /// [`Code::FileKind`] if files with this ending are not read.
    pub fn of(path: &Path) -> Result<Container, Diagnostic> {
        let Some(ending) = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase())
        else {
            return Ok(Container::Markdown);
        };
        let known = ENDINGS.iter().find(|(_, endings)| endings.contains(&ending.as_str()));
        if let Some((kind, _)) = known {
            return Ok(*kind);
        }
        let name = path.display();
        Err(match CONVERTIBLE.iter().find(|(known, _)| *known == ending) {
            Some((_, format)) => {
                let stem = path.with_extension("md");
                Diagnostic::error(Code::FileKind, format!("{name}: {format} is not read")).hint(format!(
                    "turn it into Markdown and check that: pandoc {name} -t markdown -o {}",
                    stem.display()
                ))
            }
            None => Diagnostic::error(
                Code::FileKind,
                format!("{name}: files that end with .{ending} are not known"),
            )
            .hint(
                "if it is text with formulas, say how it is written: --as markdown, rst, latex or notebook",
            ),
        })
    }
}
