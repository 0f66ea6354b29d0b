//! Figures as PNG and PDF, made of their SVG.
//!
//! Letters come from the fonts of the system: the SVG names some for mathematics, and the last of its
//! choices is any font with serifs.

use resvg::{tiny_skia, usvg};

use crate::language::diagnostic::{Code, Diagnostic};

/// Pixels for each unit of the SVG: sharp also on a slide.
const SCALE: f32 = 2.0;

/// More pixels are refused.
const LARGEST: f32 = 20_000.0;

/// The picture of an SVG as PNG, with twice as many pixels as the SVG has units.
///
/// # Errors
/// Without fonts, or if the picture is too large.
pub(super) fn png(svg: &str) -> Result<Vec<u8>, Diagnostic> {
    let tree = tree(svg)?;
    let size = tree.size();
    let (width, height) = ((size.width() * SCALE).ceil(), (size.height() * SCALE).ceil());
    if width.max(height) > LARGEST {
        return Err(problem("the picture is too large for pixels").hint("write it as .svg or .pdf"));
    }
    let Some(mut pixels) = tiny_skia::Pixmap::new(width as u32, height as u32) else {
        return Err(problem("an empty picture has no pixels").hint("write it as .svg"));
    };
    resvg::render(&tree, tiny_skia::Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| problem(&error.to_string()).hint("write it as .svg"))
}

/// The picture of an SVG as a PDF of one page; a unit of the SVG is 3/4 of a point, as on the web.
///
/// # Errors
/// Without fonts.
pub(super) fn pdf(svg: &str) -> Result<Vec<u8>, Diagnostic> {
    let page = svg2pdf::PageOptions { dpi: 96.0 };
    svg2pdf::to_pdf(&tree(svg)?, svg2pdf::ConversionOptions::default(), page)
        .map_err(|error| problem(&error.to_string()).hint("write it as .svg"))
}

fn tree(svg: &str) -> Result<usvg::Tree, Diagnostic> {
    let mut options = usvg::Options::default();
    let fonts = options.fontdb_mut();
    fonts.load_system_fonts();
    let serif = usvg::fontdb::Query { families: &[usvg::fontdb::Family::Serif], ..Default::default() };
    if fonts.query(&serif).is_none() {
        let family = |face: &usvg::fontdb::FaceInfo| face.families.first().map(|(name, _)| name.clone());
        let all: Vec<String> = fonts.faces().filter_map(family).collect();
        let Some(usual) = all.iter().find(|name| name.contains("Serif")).or(all.first()) else {
            return Err(problem("there are no fonts here for the text of the figure")
                .hint("install a font, or write the figure as .svg or .tex"));
        };
        fonts.set_serif_family(usual);
    }
    usvg::Tree::from_str(svg, &options).map_err(|error| problem(&error.to_string()).hint("write it as .svg"))
}

fn problem(message: &str) -> Diagnostic {
    Diagnostic::error(Code::Undrawable, message)
}
