//! A quick look at a drawing, in characters.
//!
//! Lines are drawn with braille characters, each of which is a grid of 2 by 4 dots (Unicode
//! block U+2800); points are marked, and labels stand beside them where there is room.

use crate::language::write::unicode;
use crate::scene::{Dash, Extent, Ink, Mark, Placed, Scene, Stroke, Style, Text, layout, trace};

/// The drawing in `columns` by `rows` characters at most; lines have no blanks at their ends.
///
/// Both are taken between 1 and 1000. Fillings are not shown. A drawing whose shape matters
/// keeps it if the characters are twice as high as wide.
///
/// ```
/// use polarform::figure::terminal;
/// use polarform::scene::{Path, Scene, Spot, Style};
/// let mut scene = Scene::new("a line");
/// scene.add(Path::line(Spot::new(0.0, 0.0)?, Spot::new(1.0, 0.0)?, Style::curve(0)));
/// assert_eq!(terminal(&scene, 4, 4), "⠤⠤⠤⠤\n");
/// # Ok::<(), polarform::scene::SceneError>(())
/// ```
pub fn terminal(scene: &Scene, columns: usize, rows: usize) -> String {
    let (columns, rows) = (columns.clamp(1, 1000), rows.clamp(1, 1000));
    let page = layout(&scene.clone().without_words_below(), &|_, _| Extent::default());
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for mark in &page.marks {
        // what is seen: not the widths of lines
        let mut add = |[x, y]: [f64; 2]| {
            low = [low[0].min(x), low[1].min(y)];
            high = [high[0].max(x), high[1].max(y)];
        };
        match mark {
            Mark::Path { start, strokes, .. } => {
                add(*start);
                trace(*start, strokes, &mut |_, to| add(to));
            }
            Mark::Marker { at, .. } => add(*at),
            Mark::Text(text) => add(text.area.low),
        }
    }
    if low[0] > high[0] {
        return String::new();
    }
    let dots = [2.0 * columns as f64 - 1.0, 4.0 * rows as f64 - 1.0];
    let size = [high[0] - low[0], high[1] - low[1]];
    let ratio = |k: usize| if size[k] > 0.0 { dots[k] / size[k] } else { f64::INFINITY };
    let scale = ratio(0).min(ratio(1));
    let scale = if scale.is_finite() { scale } else { 0.0 };
    let used = size[1] * scale;
    // a whole number of rows of characters, the drawing in their middle
    let rows = ((used / 4.0).floor() as usize + 1).min(rows);
    let top = ((4.0 * rows as f64 - 1.0 - used) / 2.0).max(0.0);
    let mut canvas = Canvas::new(columns, rows);
    let dot = |[x, y]: [f64; 2]| [(x - low[0]) * scale, (y - low[1]) * scale + top];
    for mark in &page.marks {
        match mark {
            Mark::Path { start, strokes, closed, style, .. } => {
                canvas.path(*start, strokes, *closed, style, &dot);
            }
            Mark::Marker { at, .. } => canvas.sign(dot(*at), '●'),
            Mark::Text(_) => {}
        }
    }
    page.texts().for_each(|text| canvas.label(text, &dot));
    canvas.into_string()
}

struct Canvas {
    columns: usize,
    /// The dots of each character, as the last byte of its code.
    dots: Vec<u8>,
    /// Characters of markers and labels, which hide dots.
    signs: Vec<Option<char>>,
}

/// The bit of each dot of a braille character, by row and column.
const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

impl Canvas {
    fn new(columns: usize, rows: usize) -> Self {
        Canvas { columns, dots: vec![0; columns * rows], signs: vec![None; columns * rows] }
    }

    /// The character of a dot.
    fn cell(&self, [x, y]: [f64; 2]) -> Option<usize> {
        if x < -0.5 || y < -0.5 {
            return None;
        }
        let (column, row) = (x.round() as usize / 2, y.round() as usize / 4);
        let cell = row * self.columns + column;
        (column < self.columns && cell < self.dots.len()).then_some(cell)
    }

    fn path(
        &mut self,
        start: [f64; 2],
        strokes: &[Stroke],
        closed: bool,
        style: &Style,
        dot: &dyn Fn([f64; 2]) -> [f64; 2],
    ) {
        let Some(ink) = style.stroke else { return };
        // what only guides the eye has every third dot
        let sparse = ink == Ink::Guide || style.dash != Dash::Solid;
        let mut count = 0_usize;
        let mut draw = |a: [f64; 2], b: [f64; 2]| {
            let (a, b) = (dot(a), dot(b));
            let steps = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()).ceil().clamp(1.0, 1e5) as usize;
            for k in 0..=steps {
                let t = k as f64 / steps as f64;
                let place = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
                count += 1;
                if sparse && !count.is_multiple_of(3) {
                    continue;
                }
                if let Some(cell) = self.cell(place) {
                    let (x, y) = (place[0].round().max(0.0) as usize, place[1].round().max(0.0) as usize);
                    self.dots[cell] |= BITS[y % 4][x % 2];
                }
            }
        };
        trace(start, strokes, &mut draw);
        if closed && let Some(last) = strokes.last() {
            draw(last.end(), start);
        }
    }

    fn sign(&mut self, place: [f64; 2], sign: char) {
        if let Some(cell) = self.cell(place) {
            self.signs[cell] = Some(sign);
        }
    }

    /// The label in one line near its place, if these characters hold no other sign.
    fn label(&mut self, text: &Placed, dot: &dyn Fn([f64; 2]) -> [f64; 2]) {
        let words = match &text.text {
            Text::Formula(formula) => unicode(formula),
            Text::Words(words) => words.clone(),
        };
        let signs: Vec<char> = words.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let [x, y] = dot([text.area.low[0], text.area.low[1]]);
        let (column, row) = ((x / 2.0).max(0.0) as usize, (y / 4.0).max(0.0) as usize);
        let length = signs.len();
        let latest = self.columns.saturating_sub(length);
        let (right, left, middle) =
            (column + 2, column.saturating_sub(length), column.saturating_sub(length / 2).min(latest));
        let wanted = match text.fixed.0 {
            -1 => column + 1,
            0 => middle,
            _ => left,
        };
        let above = row.saturating_sub(1);
        for (row, start) in
            [(row, wanted), (row, right), (row, left), (above, middle), (row + 1, middle), (above, right)]
        {
            let first = row * self.columns + start;
            if start <= latest
                && length <= self.columns
                && let Some(cells) = self.signs.get_mut(first..first + length)
                && cells.iter().all(Option::is_none)
            {
                cells.iter_mut().zip(signs).for_each(|(cell, sign)| *cell = Some(sign));
                return;
            }
        }
    }

    fn into_string(self) -> String {
        let mut text = String::new();
        for (dots, signs) in self.dots.chunks(self.columns).zip(self.signs.chunks(self.columns)) {
            let row: String = dots
                .iter()
                .zip(signs)
                .map(|(&dots, sign)| match sign {
                    Some(sign) => *sign,
                    None if dots == 0 => ' ',
                    None => char::from_u32(0x2800 + u32::from(dots)).unwrap_or(' '),
                })
                .collect();
            text.push_str(row.trim_end());
            text.push('\n');
        }
        text
    }
}
