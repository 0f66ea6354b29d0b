//! From a scene to marks on a page.
//!
//! The scale follows from the space that remains beside the labels, and the labels are placed by
//! the scale; so each panel is laid out a few times until both fit.

use super::obstacles::Obstacles;
use super::page::{Extent, Layout, Mark, Pixel, Placed, Rect, Stroke, hundredths};
use super::place::{Movable, place};
use super::sample::cubic_at;
use super::{
    Anchor, Aspect, Axis, Entry, Ink, Item, Label, Orientation, Panel, Path, Scene, Segment, Size, Spot,
    Style, Text,
};
use crate::budget;

/// How large a text is in a size.
pub(super) type Measure<'a> = &'a dyn Fn(&Text, Size) -> Extent;

/// Around everything.
const MARGIN: f64 = 8.0;
/// Between panels.
const GAP: f64 = 28.0;
/// The greatest height of a picture whose shape is kept, in widths.
const TALLEST: f64 = 0.8;
/// How often the scale is adapted to the labels.
const ROUNDS: usize = 4;
/// How often a panel is enlarged when fixed labels cover each other.
const ENLARGEMENTS: usize = 24;
/// The length of a tick, and how far an axis goes beyond its data.
const TICK: f64 = 5.0;
const BEYOND: f64 = 14.0;

/// The scene as marks on a page, whose texts have the extents that `measure` tells.
///
/// Labels that are not fixed are placed where they cover no other label, and if possible no
/// marker and no line; those for which there is no room are left out and counted. Nothing is
/// outside of the page.
///
/// Cost: linear in the pieces of paths times the number of movable labels.
///
/// ```
/// use polarform::scene::{Direction, Extent, Label, Scene, Spot, layout};
/// let mut scene = Scene::new("two points");
/// for x in [0.0, 1.0] {
///     scene.add(Label::beside(Spot::new(x, 0.0)?, "here", Direction::North));
/// }
/// let page = layout(&scene, &|_, size| Extent { width: 30.0, ascent: size.em(), descent: 4.0 });
/// assert_eq!(page.texts().count(), 2);
/// assert!(page.texts().all(|text| text.area.low[0] >= 0.0 && text.area.high[0] <= page.width));
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
pub fn layout(scene: &Scene, measure: &dyn Fn(&Text, Size) -> Extent) -> Layout {
    let count = scene.panels().len().max(1) as f64;
    let width = ((scene.width() - 2.0 * MARGIN - GAP * (count - 1.0)) / count).max(40.0);
    let panels: Vec<Sheet> = scene.panels().iter().map(|panel| fitted(panel, width, measure)).collect();
    let height = panels.iter().map(|sheet| sheet.bounds.height()).fold(0.0, f64::max);
    let mut page = Layout { width: MARGIN, height: 0.0, marks: Vec::new(), hidden: 0 };
    for sheet in panels {
        let left = page.width - sheet.bounds.low[0];
        let top = MARGIN - sheet.bounds.low[1] + (height - sheet.bounds.height()) / 2.0;
        for mut mark in sheet.marks {
            mark.shift([left, top]);
            page.marks.push(mark);
        }
        page.width += sheet.bounds.width() + GAP;
        page.hidden += sheet.hidden;
    }
    page.width = (page.width - GAP + MARGIN).ceil();
    page.height = (height + 2.0 * MARGIN).ceil();
    page
}

/// A panel laid out, in pixels from the upper left corner of its data.
struct Sheet {
    marks: Vec<Mark>,
    bounds: Rect,
    hidden: usize,
}

/// No length on the page that a caller gives is larger, in pixels.
const LARGEST: f64 = 1e4;

/// A length that a caller gives, within bounds; 0 for what is no number.
fn sane(pixels: f64, least: f64) -> f64 {
    if pixels.is_nan() { 0.0 } else { pixels.clamp(least, LARGEST) }
}

/// The panel in this width, or wider when fixed labels need it.
fn fitted(panel: &Panel, width: f64, measure: Measure) -> Sheet {
    let world = bounds(panel);
    let map = |inner: f64| Map::new(world, panel.aspect, inner);
    let mut inner = (width - 48.0).max(0.4 * width);
    for _ in 0..ENLARGEMENTS {
        if !crowded(panel, &map(inner), measure) {
            break;
        }
        inner *= 1.12;
    }
    let mut sheet = laid_out(panel, &map(inner), width, measure);
    for _ in 0..ROUNDS {
        let missing = width - sheet.bounds.width();
        let next = (inner + missing).clamp(0.4 * width, width);
        let enough = missing.abs() < 1.0 || (next - inner).abs() < 0.5;
        // a picture limited by its height stays narrower, one with wide labels wider
        let narrower = missing > 0.0 && map(next).size[0] < next;
        let wider = missing < 0.0 && crowded(panel, &map(next), measure);
        if enough || narrower || wider {
            break;
        }
        inner = next;
        sheet = laid_out(panel, &map(inner), width, measure);
    }
    sheet
}

/// Whether centred labels cover each other.
fn crowded(panel: &Panel, map: &Map, measure: Measure) -> bool {
    let mut areas: Vec<Rect> = Vec::new();
    for item in &panel.items {
        if let Item::Label(label) = item
            && label.anchor == Anchor::Centre
        {
            let area = centred(label, map, measure).area.grown(4.0);
            budget::steps(u32::try_from(areas.len() / 16 + 1).unwrap_or(u32::MAX));
            if areas.iter().any(|other| other.overlap(&area) > 0.0) {
                return true;
            }
            areas.push(area);
        }
    }
    false
}

/// What the data take, in their own coordinates.
#[derive(Clone, Copy)]
struct World {
    low: Spot,
    size: [f64; 2],
}

fn bounds(panel: &Panel) -> World {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    let mut add = |place: Spot| {
        for (k, value) in [place.x(), place.y()].into_iter().enumerate() {
            low[k] = low[k].min(value);
            high[k] = high[k].max(value);
        }
    };
    for item in &panel.items {
        match item {
            Item::Path(path) => {
                add(path.start);
                let mut from = path.start;
                for segment in &path.segments {
                    if let Segment::Cubic([b, c, d]) = segment {
                        (1..8).for_each(|k| add(cubic_at(&[from, *b, *c, *d], f64::from(k) / 8.0)));
                    }
                    from = segment.end();
                    add(from);
                }
            }
            Item::Marker(marker) => add(marker.at),
            Item::Label(label) => add(label.at),
            Item::Axis(axis) => {
                add(axis.from);
                add(axis.at(axis.end()));
            }
        }
    }
    let inside = |value: f64| if value.is_finite() { value } else { 0.0 };
    World {
        low: Spot::default().moved(inside(low[0]), inside(low[1])),
        size: [inside(high[0] - low[0]), inside(high[1] - low[1])],
    }
}

impl Axis {
    /// The coordinate along the axis at its end.
    fn end(&self) -> f64 {
        let from = match self.orientation {
            Orientation::Horizontal => self.from.x(),
            Orientation::Vertical => self.from.y(),
        };
        from + if self.length.is_finite() { self.length } else { 0.0 }
    }

    /// The place on the axis with this coordinate along it.
    fn at(&self, value: f64) -> Spot {
        match self.orientation {
            Orientation::Horizontal => self.from.moved(value - self.from.x(), 0.0),
            Orientation::Vertical => self.from.moved(0.0, value - self.from.y()),
        }
    }
}

/// From coordinates of the data to pixels.
struct Map {
    low: Spot,
    world: [f64; 2],
    size: [f64; 2],
}

impl Map {
    fn new(World { low, size: world }: World, aspect: Aspect, width: f64) -> Self {
        let size = match aspect {
            Aspect::Free { height } => {
                [width, if height.is_finite() { height.clamp(20.0, 1e4) } else { width }]
            }
            Aspect::Equal => {
                let tallest = TALLEST * width;
                let (across, up) = (world[0], world[1]);
                if across == 0.0 && up == 0.0 {
                    [width * 0.4, width * 0.2]
                } else if up <= TALLEST * across {
                    [width, (up / across) * width]
                } else {
                    [(across / up) * tallest, tallest]
                }
            }
        };
        Map { low, world, size }
    }

    fn place(&self, spot: Spot) -> Pixel {
        // dividing first cannot overflow; what has no extent is in the middle
        let part = |value: f64, low: f64, size: f64| if size > 0.0 { (value - low) / size } else { 0.5 };
        let right = part(spot.x(), self.low.x(), self.world[0]) * self.size[0];
        let up = part(spot.y(), self.low.y(), self.world[1]) * self.size[1];
        [hundredths(right), hundredths(self.size[1] - up)]
    }
}

fn laid_out(panel: &Panel, map: &Map, width: f64, measure: Measure) -> Sheet {
    let fixed: Vec<Placed> = panel
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Label(label) if label.anchor == Anchor::Centre => Some(centred(label, map, measure)),
            _ => None,
        })
        .collect();
    let mut marks = Vec::new();
    let mut movable = Vec::new();
    for item in &panel.items {
        match item {
            Item::Path(path) => marks.push(drawn(path, map, &fixed)),
            Item::Marker(marker) => {
                let [x, y] = map.place(marker.at);
                let [right, up] = marker.offset.map(|pixels| sane(pixels, -LARGEST));
                let at = [x + right, y - up];
                marks.push(Mark::Marker {
                    at,
                    shape: marker.shape,
                    radius: sane(marker.radius, 0.0),
                    ink: marker.ink,
                });
            }
            Item::Axis(axis) => axis_marks(axis, map, measure, &mut marks),
            Item::Label(label) => {
                if let Anchor::Beside(direction) = label.anchor {
                    movable.push(Movable {
                        text: &label.text,
                        at: map.place(label.at),
                        gap: sane(label.gap, 0.0),
                        extent: measure(&label.text, label.size),
                        direction,
                        size: label.size,
                        ink: label.ink,
                    });
                }
            }
        }
    }
    marks.extend(fixed.into_iter().map(Mark::Text));
    let mut obstacles = Obstacles::default();
    marks.iter().for_each(|mark| obstacles.add(mark));
    let placed = place(&movable, &obstacles);
    let hidden = placed.iter().filter(|label| label.is_none()).count();
    marks.extend(placed.into_iter().flatten().map(Mark::Text));

    let mut bounds = Rect::EMPTY;
    marks.iter().for_each(|mark| bounds.add(&mark.area()));
    if marks.is_empty() {
        bounds = Rect { low: [0.0, 0.0], high: map.size };
    }
    below(panel, width, measure, &mut bounds, &mut marks);
    Sheet { marks, bounds, hidden }
}

fn centred(label: &Label, map: &Map, measure: Measure) -> Placed {
    let extent = measure(&label.text, label.size);
    let [x, y] = map.place(label.at);
    text_at(&label.text, extent, [x, y], (0, 0), label.size, label.ink)
}

/// A text whose fixed sides are at this place.
fn text_at(text: &Text, extent: Extent, [x, y]: Pixel, fixed: (i8, i8), size: Size, ink: Ink) -> Placed {
    let from = |at: f64, length: f64, side: i8| at - length * f64::from(side + 1) / 2.0;
    let low = [from(x, extent.width, fixed.0), from(y, extent.height(), fixed.1)];
    let area = Rect { low, high: [low[0] + extent.width, low[1] + extent.height()] };
    Placed { text: text.clone(), area, baseline: low[1] + extent.ascent, fixed, size, ink }
}

fn drawn(path: &Path, map: &Map, fixed: &[Placed]) -> Mark {
    let mut start = map.place(path.start);
    let mut strokes: Vec<Stroke> = path
        .segments
        .iter()
        .map(|segment| match segment {
            Segment::Line(to) => Stroke::Line(map.place(*to)),
            Segment::Cubic(points) => Stroke::Cubic(points.map(|p| map.place(p))),
        })
        .collect();
    if path.trimmed
        && let [Stroke::Line(end)] = strokes.as_mut_slice()
    {
        (start, *end) = (outside(start, *end, fixed), outside(*end, start, fixed));
    }
    let width = sane(path.style.width, 0.0);
    let opacity = sane(path.style.opacity, 0.0).min(1.0);
    let style = Style { width, opacity, ..path.style };
    Mark::Path { start, strokes, closed: path.closed, style, arrow: path.arrow }
}

/// The first place on the way from `from` to `to` that is outside of the label around `from`.
fn outside(from: Pixel, to: Pixel, fixed: &[Placed]) -> Pixel {
    let Some(label) = fixed.iter().find(|label| label.area.contains(from)) else {
        return from;
    };
    match label.area.grown(4.0).clip(from, to) {
        Some((_, leave)) => [0, 1].map(|k| hundredths(from[k] + leave * (to[k] - from[k]))),
        None => from,
    }
}

fn axis_marks(axis: &Axis, map: &Map, measure: Measure, marks: &mut Vec<Mark>) {
    let (from, to) = (map.place(axis.from), map.place(axis.at(axis.end())));
    let style = Style::line(Ink::Text, 1.0);
    // along the axis, and across it to the side of the numbers
    let (along, across): (Pixel, Pixel) = match axis.orientation {
        Orientation::Horizontal => ([1.0, 0.0], [0.0, 1.0]),
        Orientation::Vertical => ([0.0, -1.0], [-1.0, 0.0]),
    };
    let tip = [0, 1].map(|k| to[k] + BEYOND * along[k]);
    let line = |start: Pixel, end: Pixel, arrow: bool| Mark::Path {
        start,
        strokes: vec![Stroke::Line(end)],
        closed: false,
        style,
        arrow,
    };
    marks.push(line(from, tip, true));
    let fixed = match axis.orientation {
        Orientation::Horizontal => (0, -1),
        Orientation::Vertical => (1, 0),
    };
    let mut last = Rect::EMPTY;
    for tick in axis.ticks.iter().filter(|tick| tick.at.is_finite()) {
        let at = map.place(axis.at(tick.at));
        marks.push(line(at, [0, 1].map(|k| at[k] + TICK * across[k]), false));
        if let Some(label) = &tick.label {
            let beside = [0, 1].map(|k| at[k] + (TICK + 4.0) * across[k]);
            let text = text_at(label, measure(label, Size::Small), beside, fixed, Size::Small, Ink::Text);
            // numbers too close to the one before are left out
            if last == Rect::EMPTY || text.area.grown(2.0).overlap(&last) == 0.0 {
                last = text.area;
                marks.push(Mark::Text(text));
            }
        }
    }
    if let Some(name) = &axis.name {
        let beyond = [0, 1].map(|k| tip[k] + 5.0 * along[k]);
        let fixed = match axis.orientation {
            Orientation::Horizontal => (-1, 0),
            Orientation::Vertical => (0, 1),
        };
        let extent = measure(name, Size::Normal);
        marks.push(Mark::Text(text_at(name, extent, beyond, fixed, Size::Normal, Ink::Text)));
    }
}

/// The length of the line that explains a curve.
const SWATCH: f64 = 24.0;

/// The legend in rows below the picture, and the words below it.
fn below(panel: &Panel, width: f64, measure: Measure, bounds: &mut Rect, marks: &mut Vec<Mark>) {
    let middle = (bounds.low[0] + bounds.high[0]) / 2.0;
    let mut rows: Vec<(f64, Vec<(&Entry, Extent)>)> = Vec::new();
    for entry in &panel.legend {
        let extent = measure(&entry.text, Size::Small);
        let length = SWATCH + 6.0 + extent.width;
        match rows.last_mut() {
            Some((sum, row)) if *sum + 20.0 + length <= width => {
                *sum += 20.0 + length;
                row.push((entry, extent));
            }
            _ => rows.push((length, vec![(entry, extent)])),
        }
    }
    let mut top = bounds.high[1] + 14.0;
    for (length, row) in rows {
        let ascent = row.iter().map(|(_, extent)| extent.ascent).fold(0.0, f64::max);
        let descent = row.iter().map(|(_, extent)| extent.descent).fold(0.0, f64::max);
        let line = top + ascent - 0.3 * Size::Small.em();
        let mut left = middle - length / 2.0;
        for (entry, extent) in row {
            explained(entry, [left, line], marks);
            let at = [left + SWATCH + 6.0, top + ascent - extent.ascent];
            let text = text_at(&entry.text, extent, at, (-1, -1), Size::Small, Ink::Text);
            bounds.add(&text.area.grown(1.0));
            bounds.add(&Rect::around([left, line], 5.0));
            marks.push(Mark::Text(text));
            left += SWATCH + 26.0 + extent.width;
        }
        top += ascent + descent + 6.0;
    }
    if let Some(caption) = &panel.caption {
        let at = [middle, bounds.high[1] + 14.0];
        let text = text_at(caption, measure(caption, Size::Normal), at, (0, -1), Size::Normal, Ink::Text);
        bounds.add(&text.area);
        marks.push(Mark::Text(text));
    }
}

/// The line and the marker that a legend explains.
fn explained(entry: &Entry, [left, line]: Pixel, marks: &mut Vec<Mark>) {
    let path = |strokes: Vec<Stroke>, closed: bool, style: Style| Mark::Path {
        start: [left, line],
        strokes,
        closed,
        style,
        arrow: false,
    };
    match entry.style {
        Some(style) if style.fill.is_some() => {
            let corners = [[left + SWATCH, line], [left + SWATCH, line - 8.0], [left, line - 8.0]];
            let mut mark = path(corners.map(Stroke::Line).to_vec(), true, style);
            mark.shift([0.0, 4.0]);
            marks.push(mark);
        }
        Some(style) => marks.push(path(vec![Stroke::Line([left + SWATCH, line])], false, style)),
        None => {}
    }
    if let Some((shape, ink)) = entry.marker {
        let marker = super::Marker::new(Spot::default(), shape, ink);
        marks.push(Mark::Marker { at: [left + SWATCH / 2.0, line], shape, radius: marker.radius, ink });
    }
}
