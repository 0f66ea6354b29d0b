//! Drawings as SVG.

use maud::{Markup, PreEscaped, html};

use super::measure::measure;
use super::number;
use super::palette::{self, colour};
use super::runs::{Face, runs};
use crate::scene::{Dash, Ink, Layout, Mark, Placed, Scene, Shape, Stroke, Style, layout};

/// The colours a drawing is made for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Theme {
    /// For both: colours follow the reader's preference, text the page around it.
    #[default]
    Auto,
    /// For white paper.
    Light,
    /// For a dark page.
    Dark,
}

/// How a drawing becomes SVG.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SvgOptions {
    /// The colours.
    pub theme: Theme,
    /// Whether the page behind the drawing is painted; it is transparent otherwise.
    pub background: bool,
}

/// Fonts with true italics first; none is fetched from anywhere.
const FONTS: &str = "'STIX Two Text','Latin Modern Roman','CMU Serif',Cambria,'STIX Two Math',\
                     'Latin Modern Math','Cambria Math','Times New Roman',serif";

/// The drawing as one SVG element, which is also a complete document.
///
/// Width and height are in pixels, and a page too narrow shrinks it. Every colour is an
/// attribute; with [`Theme::Auto`] a style sheet inside changes them where the reader prefers
/// dark pages, and text has the colour of the text around the drawing. The title and the
/// description of the scene are there for screen readers.
///
/// ```
/// use polarform::figure::{SvgOptions, svg};
/// use polarform::scene::Scene;
/// let empty = svg(&Scene::new("a < b"), &SvgOptions::default());
/// assert!(empty.contains("<title>a &lt; b</title>"));
/// ```
pub fn svg(scene: &Scene, options: &SvgOptions) -> String {
    let page = layout(scene, &measure);
    let painter = Painter { dark: options.theme == Theme::Dark };
    let size = format!("0 0 {} {}", number(page.width), number(page.height));
    let class = match options.theme {
        Theme::Auto => "polarform pf-auto",
        Theme::Light => "polarform pf-light",
        Theme::Dark => "polarform pf-dark",
    };
    // standing alone, an automatic drawing is black on white unless its style sheet says otherwise
    let text = (options.theme != Theme::Auto).then(|| format!("#{}", colour(Ink::Text, painter.dark)));
    let paper = format!("#{}", palette::PAPER[usize::from(painter.dark)]);
    let document = html! {
        svg xmlns="http://www.w3.org/2000/svg" class=(class) role="img" viewBox=(size)
            width=(number(page.width)) height=(number(page.height)) style="max-width:100%;height:auto"
            color=[text] font-family=(FONTS) {
            (line())
            title { (clean(scene.title())) }
            (line())
            @if let Some(words) = description(scene, &page) {
                desc { (words) }
                (line())
            }
            @if options.theme == Theme::Auto {
                style { (PreEscaped(style_sheet())) }
                (line())
            }
            @if options.background {
                rect class="paper" width="100%" height="100%" fill=(paper) {}
                (line())
            }
            @for mark in &page.marks {
                (painter.mark(mark))
                (line())
            }
        }
        (line())
    };
    document.into_string()
}

fn line() -> Markup {
    PreEscaped("\n".to_owned())
}

/// Without the characters that XML forbids.
fn clean(text: &str) -> String {
    let allowed = |c: &char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().map(|c| if matches!(c, '\n' | '\t') { ' ' } else { c }).filter(allowed).collect()
}

fn description(scene: &Scene, page: &Layout) -> Option<String> {
    let mut words = clean(scene.description());
    if page.hidden > 0 {
        let plural = if page.hidden == 1 { " is" } else { "s are" };
        let blank = if words.is_empty() { "" } else { " " };
        words.push_str(&format!("{blank}{} label{plural} left out for lack of room.", page.hidden));
    }
    (!words.is_empty()).then_some(words)
}

/// What changes where dark pages are preferred.
fn style_sheet() -> String {
    let series = (0..palette::COUNT).map(Ink::Series);
    let mut sheet = String::from("@media (prefers-color-scheme:dark){");
    sheet.push_str(&format!("svg.pf-auto:root{{color:#{}}}", palette::TEXT[1]));
    for ink in [Ink::Guide, Ink::Accent].into_iter().chain(series) {
        sheet.push_str(&format!(".pf-auto .{}{{color:#{}}}", palette::name(ink), colour(ink, true)));
    }
    sheet.push_str(&format!(".pf-auto .paper{{fill:#{}}}}}", palette::PAPER[1]));
    sheet
}

struct Painter {
    dark: bool,
}

impl Painter {
    /// The class and the colour of an ink; text has that of its surroundings.
    fn ink(&self, ink: Ink) -> (Option<String>, Option<String>) {
        match ink {
            Ink::Text => (None, None),
            ink => (Some(palette::name(ink)), Some(format!("#{}", colour(ink, self.dark)))),
        }
    }

    fn mark(&self, mark: &Mark) -> Markup {
        match mark {
            Mark::Path { start, strokes, closed, style, arrow } => {
                self.path(*start, strokes, *closed, style, *arrow)
            }
            Mark::Marker { at, shape, radius, ink } => self.marker(*at, *shape, *radius, *ink),
            Mark::Text(text) => self.text(text),
        }
    }

    fn path(&self, start: [f64; 2], strokes: &[Stroke], closed: bool, style: &Style, arrow: bool) -> Markup {
        let data = data(start, strokes, closed);
        let head = if arrow { head(start, strokes, style.width) } else { None };
        let dashes = match style.dash {
            Dash::Solid => None,
            Dash::Dashed => Some("6 4"),
        };
        html! {
            @if let Some(ink) = style.fill {
                @let (class, color) = self.ink(ink);
                // crisp edges leave no light seams between neighbours
                @let crisp = style.stroke.is_none().then_some("crispEdges");
                path class=[class] color=[color] d=(data) fill="currentColor"
                    fill-opacity=(number(style.opacity.clamp(0.0, 1.0))) shape-rendering=[crisp] {}
            }
            @if let Some(ink) = style.stroke {
                @let (class, color) = self.ink(ink);
                path class=[class.clone()] color=[color.clone()] d=(data) fill="none" stroke="currentColor"
                    stroke-width=(number(style.width)) stroke-dasharray=[dashes]
                    stroke-linecap="round" stroke-linejoin="round" {}
                @if let Some(head) = head {
                    path class=[class] color=[color] d=(head) fill="currentColor" {}
                }
            }
        }
    }

    fn marker(&self, at: [f64; 2], shape: Shape, radius: f64, ink: Ink) -> Markup {
        let (class, color) = self.ink(ink);
        let [x, y] = at;
        let (left, right, top, bottom) =
            (number(x - radius), number(x + radius), number(y - radius), number(y + radius));
        let (x, y, r) = (number(x), number(y), number(radius));
        match shape {
            Shape::Dot => html! {
                circle class=[class] color=[color] cx=(x) cy=(y) r=(r) fill="currentColor" {}
            },
            Shape::Ring => html! {
                circle class=[class] color=[color] cx=(x) cy=(y) r=(r) fill="none" stroke="currentColor"
                    stroke-width="1.6" {}
            },
            Shape::Square => {
                let d = format!("M{left} {top}H{right}V{bottom}H{left}Z");
                html! { path class=[class] color=[color] d=(d) fill="currentColor" {} }
            }
            Shape::Diamond => {
                let d = format!("M{left} {y}L{x} {top}L{right} {y}L{x} {bottom}Z");
                html! { path class=[class] color=[color] d=(d) fill="currentColor" {} }
            }
            Shape::Cross => {
                let d = format!("M{left} {top}L{right} {bottom}M{left} {bottom}L{right} {top}");
                html! {
                    path class=[class] color=[color] d=(d) fill="none" stroke="currentColor"
                        stroke-width="1.8" stroke-linecap="round" {}
                }
            }
        }
    }

    fn text(&self, text: &Placed) -> Markup {
        let (class, color) = self.ink(text.ink);
        let em = text.size.em();
        let area = &text.area;
        let (x, anchor) = match text.fixed.0 {
            -1 => (area.low[0], None),
            0 => ((area.low[0] + area.high[0]) / 2.0, Some("middle")),
            _ => (area.high[0], Some("end")),
        };
        let runs = runs(&text.text);
        let before = std::iter::once(0.0).chain(runs.iter().map(|run| run.rise));
        html! {
            text class=[class] color=[color] x=(number(x)) y=(number(text.baseline)) fill="currentColor"
                font-size=(number(em)) text-anchor=[anchor] xml:space="preserve" {
                @for (run, before) in runs.iter().zip(before) {
                    @let up = (run.rise - before) * em;
                    @let dy = (up.abs() > 0.004).then(|| number(-up));
                    @let dx = (run.shift.abs() > 0.004).then(|| number(run.shift * em));
                    @let size = (run.scale != 1.0).then(|| number(run.scale * em));
                    @let slant = (run.face == Face::Italic).then_some("italic");
                    @let bold = (run.face == Face::Bold).then_some("bold");
                    tspan dx=[dx] dy=[dy] font-size=[size] font-style=[slant] font-weight=[bold] {
                        (clean(&run.text))
                    }
                }
            }
        }
    }
}

/// The commands of a path.
fn data(start: [f64; 2], strokes: &[Stroke], closed: bool) -> String {
    let place = |[x, y]: [f64; 2]| format!("{} {}", number(x), number(y));
    let mut data = format!("M{}", place(start));
    for stroke in strokes {
        match stroke {
            Stroke::Line(to) => data.push_str(&format!("L{}", place(*to))),
            Stroke::Cubic([b, c, d]) => {
                data.push_str(&format!("C{} {} {}", place(*b), place(*c), place(*d)));
            }
        }
    }
    if closed {
        data.push('Z');
    }
    data
}

/// The triangle at the end of an arrow.
fn head(start: [f64; 2], strokes: &[Stroke], width: f64) -> Option<String> {
    let last = strokes.last()?;
    let from = match last {
        Stroke::Cubic([_, control, _]) => *control,
        Stroke::Line(_) => strokes.len().checked_sub(2).map_or(start, |i| strokes[i].end()),
    };
    let tip = last.end();
    let (dx, dy) = (tip[0] - from[0], tip[1] - from[1]);
    let length = dx.hypot(dy);
    if length == 0.0 {
        return None;
    }
    let (dx, dy) = (dx / length, dy / length);
    let (long, wide) = (6.0 + width, 2.2 + 0.6 * width);
    let corner = |side: f64| {
        let x = tip[0] - long * dx - side * wide * dy;
        let y = tip[1] - long * dy + side * wide * dx;
        format!("{} {}", number(x), number(y))
    };
    let tip = format!("{} {}", number(tip[0] + dx), number(tip[1] + dy));
    Some(format!("M{tip}L{}L{}Z", corner(1.0), corner(-1.0)))
}
