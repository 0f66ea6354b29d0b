//! Drawings as TikZ.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::measure::measure;
use super::number;
use super::palette::{colour, name};
use crate::language::write::latex;
use crate::scene::{Dash, Ink, Mark, Placed, Scene, Shape, Size, Stroke, Style, Text, layout};

/// How a drawing becomes TikZ.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TikzOptions {
    /// A whole document (class `standalone`) instead of a picture to be put into one.
    pub standalone: bool,
}

/// Points for a pixel: letters of 16 pixels are letters of 10 points.
const POINT: f64 = 0.625;

/// The drawing as a `tikzpicture`, for a document with `\usepackage{tikz}`.
///
/// Labels that are formulas are set as `$…$` by [`crate::language::write::latex()`], which needs amsmath
/// for matrices, binomials and absolute values. Words in scripts other than Latin need a TeX
/// that has them, as XeLaTeX does.
///
/// ```
/// use polarform::figure::{TikzOptions, tikz};
/// use polarform::scene::Scene;
/// let empty = tikz(&Scene::new("nothing"), &TikzOptions { standalone: true });
/// assert!(empty.starts_with("% nothing\n\\documentclass"));
/// ```
pub fn tikz(scene: &Scene, options: &TikzOptions) -> String {
    let page = layout(scene, &measure);
    let mut writer = Writer { height: page.height, out: String::new() };
    let title: String = scene.title().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    writer.line(&format!("% {title}"));
    if options.standalone {
        writer.line("\\documentclass[tikz,border=2pt]{standalone}");
        writer.line("\\usepackage{amsmath,amssymb}");
        writer.line("\\begin{document}");
    }
    writer.line("\\begin{tikzpicture}[x=1pt,y=1pt,line cap=round,line join=round,>=stealth,inner sep=0pt]");
    let inks: BTreeSet<String> = page.marks.iter().flat_map(inks).filter_map(definition).collect();
    inks.iter().for_each(|definition| writer.line(definition));
    writer.line(&format!(
        "\\path[use as bounding box] (0,0) rectangle ({},{});",
        number(page.width * POINT),
        number(page.height * POINT)
    ));
    page.marks.iter().for_each(|mark| writer.mark(mark));
    writer.line("\\end{tikzpicture}");
    if options.standalone {
        writer.line("\\end{document}");
    }
    writer.out
}

fn inks(mark: &Mark) -> Vec<Ink> {
    match mark {
        Mark::Path { style, .. } => style.stroke.into_iter().chain(style.fill).collect(),
        Mark::Marker { ink, .. } => vec![*ink],
        Mark::Text(text) => vec![text.ink],
    }
}

/// The name of an ink in the picture.
fn tone(ink: Ink) -> String {
    match ink {
        Ink::Text => "black".to_owned(),
        ink => format!("polarform-{}", name(ink)),
    }
}

fn definition(ink: Ink) -> Option<String> {
    (ink != Ink::Text).then(|| format!("\\definecolor{{{}}}{{HTML}}{{{}}}", tone(ink), colour(ink, false)))
}

struct Writer {
    height: f64,
    out: String,
}

impl Writer {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A place in points, upwards from the lower left corner.
    fn place(&self, [x, y]: [f64; 2]) -> String {
        format!("({},{})", number(x * POINT), number((self.height - y) * POINT))
    }

    fn mark(&mut self, mark: &Mark) {
        let text = match mark {
            Mark::Path { start, strokes, closed, style, arrow } => {
                self.path(*start, strokes, *closed, style, *arrow)
            }
            Mark::Marker { at, shape, radius, ink } => self.marker(*at, *shape, *radius, *ink),
            Mark::Text(text) => self.node(text),
        };
        self.line(&text);
    }

    fn path(&self, start: [f64; 2], strokes: &[Stroke], closed: bool, style: &Style, arrow: bool) -> String {
        let mut options = Vec::new();
        if arrow {
            options.push("->".to_owned());
        }
        if let Some(ink) = style.stroke {
            options.push(format!("draw={}", tone(ink)));
            options.push(format!("line width={}pt", number(style.width * POINT)));
            match style.dash {
                Dash::Solid => {}
                Dash::Dashed => options.push("dash pattern=on 3.75pt off 2.5pt".to_owned()),
            }
        }
        if let Some(ink) = style.fill {
            options.push(format!("fill={}", tone(ink)));
            options.push(format!("fill opacity={}", number(style.opacity.clamp(0.0, 1.0))));
        }
        let mut text = format!("\\path[{}] {}", options.join(","), self.place(start));
        for (i, stroke) in strokes.iter().enumerate() {
            // TeX reads long lines, people do not
            text.push_str(if i % 4 == 3 { "\n  " } else { " " });
            match stroke {
                Stroke::Line(to) => text.push_str(&format!("-- {}", self.place(*to))),
                Stroke::Cubic([b, c, d]) => {
                    let [b, c, d] = [b, c, d].map(|point| self.place(*point));
                    text.push_str(&format!(".. controls {b} and {c} .. {d}"));
                }
            }
        }
        text.push_str(if closed { " -- cycle;" } else { ";" });
        text
    }

    fn marker(&self, at: [f64; 2], shape: Shape, radius: f64, ink: Ink) -> String {
        let tone = tone(ink);
        let place = self.place(at);
        let corner = |right: f64, down: f64| self.place([at[0] + right * radius, at[1] + down * radius]);
        match shape {
            Shape::Dot => format!("\\fill[{tone}] {place} circle[radius={}];", number(radius * POINT)),
            Shape::Ring => {
                let radius = number(radius * POINT);
                format!("\\draw[{tone},line width=1pt] {place} circle[radius={radius}];")
            }
            Shape::Square => format!("\\fill[{tone}] {} rectangle {};", corner(-1.0, -1.0), corner(1.0, 1.0)),
            Shape::Diamond => {
                let corners = [(-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| corner(x, y));
                format!("\\fill[{tone}] {} -- cycle;", corners.join(" -- "))
            }
            Shape::Cross => format!(
                "\\draw[{tone},line width=1.1pt] {} -- {} {} -- {};",
                corner(-1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
                corner(1.0, -1.0)
            ),
        }
    }

    fn node(&self, text: &Placed) -> String {
        let area = &text.area;
        let side = |k: usize, fixed: i8| match fixed {
            -1 => area.low[k],
            0 => (area.low[k] + area.high[k]) / 2.0,
            _ => area.high[k],
        };
        let at = self.place([side(0, text.fixed.0), side(1, text.fixed.1)]);
        let anchor = match (text.fixed.0, text.fixed.1) {
            (0, 0) => "center",
            (0, -1) => "north",
            (0, _) => "south",
            (-1, 0) => "west",
            (-1, -1) => "north west",
            (-1, _) => "south west",
            (_, 0) => "east",
            (_, -1) => "north east",
            _ => "south east",
        };
        let words = match &text.text {
            Text::Formula(formula) => format!("${}$", latex(formula)),
            Text::Words(words) => escaped(words),
        };
        let mut options = format!("anchor={anchor}");
        if text.ink != Ink::Text {
            let _ = write!(options, ",text={}", tone(text.ink));
        }
        if text.size == Size::Small {
            options.push_str(",font=\\footnotesize");
        }
        format!("\\node[{options}] at {at} {{{words}}};")
    }
}

/// Words in LaTeX, with the signs that mean something there written out.
fn escaped(words: &str) -> String {
    // a formula of one text is \text{…}: what stands in its braces
    let text = latex(&crate::formula::Kind::Text(words.to_owned()).into());
    match text.strip_prefix("\\text{").and_then(|rest| rest.strip_suffix('}')) {
        Some(inner) => inner.to_owned(),
        None => format!("${text}$"),
    }
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn words() {
        assert_eq!(escaped("50% of A & B_1"), r"50\% of A \& B\_1");
        assert_eq!(escaped("plain"), "plain");
    }
}
