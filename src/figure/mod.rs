//! Drawings as SVG, TikZ, or characters on a terminal.
//!
//! **Definition.** Each function takes a [`Scene`](crate::scene::Scene), has it laid out
//! ([`crate::scene::layout()`]), and writes the marks in one graphics language:
//!
//! | function | gives | for |
//! | --- | --- | --- |
//! | [`svg()`] | one SVG document, or element of a page | browsers, Markdown, Inkscape |
//! | [`tikz()`] | a `tikzpicture`, or a document with it | LaTeX |
//! | [`terminal()`] | lines of braille characters | a quick look |
//! | [`figure_json()`] | title, description, SVG, TikZ | programs |
//!
//! **Invariants.** The output is deterministic and complete: no scripts, no fonts or files from
//! elsewhere, coordinates with at most two decimals. Text from outside is escaped; the SVG is
//! well-formed XML whatever the labels say. Formulas are set as mathematics: names slanted,
//! numbers upright, indices small and moved.
//!
//! ```
//! use polarform::figure::{SvgOptions, svg};
//! use polarform::number::integer as z;
//! use polarform::scene::pictures::{BezierPicture, Curve};
//!
//! let curve = Curve::new(vec![[z(0), z(0)], [z(1), z(2)], [z(3), z(2)], [z(4), z(0)]]);
//! let picture = svg(&BezierPicture::of(curve).scene()?, &SvgOptions::default());
//! assert!(picture.starts_with("<svg"));
//! # Ok::<(), polarform::scene::SceneError>(())
//! ```

mod json;
mod measure;
mod palette;
mod runs;
mod svg;
mod terminal;
mod tikz;

pub use json::{figure_json, value_json};
pub use measure::measure;
pub use svg::{SvgOptions, Theme, svg};
pub use terminal::terminal;
pub use tikz::{TikzOptions, tikz};

/// A coordinate with at most two decimals.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short() {
        for (value, text) in
            [(1.0, "1"), (0.126, "0.13"), (-0.001, "0"), (-2.5, "-2.5"), (100.0, "100"), (0.1 + 0.2, "0.3")]
        {
            assert_eq!(number(value), text);
        }
    }
}
