//! What labels should not cover.

use super::page::{Mark, Pixel, Rect, trace};
use super::{Ink, Shape};
use crate::budget;

/// Lines and boxes on the page, each with what it costs to cover it.
#[derive(Default)]
pub(super) struct Obstacles {
    lines: Vec<(Pixel, Pixel, f64)>,
    boxes: Vec<(Rect, f64)>,
}

/// What it costs to cover another label.
pub(super) const LABEL: f64 = 60.0;
/// What it costs to cover a marker.
const MARKER: f64 = 14.0;
/// What it costs to cover ten pixels of a line, besides touching it at all.
const LINE: f64 = 1.0;

impl Obstacles {
    pub(super) fn add(&mut self, mark: &Mark) {
        match mark {
            Mark::Path { start, strokes, closed, style, .. } => {
                let Some(ink) = style.stroke else { return };
                let weight = match ink {
                    Ink::Guide => 1.2,
                    _ => 2.2,
                };
                trace(*start, strokes, &mut |a, b| self.lines.push((a, b, weight)));
                if *closed && let Some(last) = strokes.last() {
                    self.lines.push((last.end(), *start, weight));
                }
            }
            Mark::Marker { at, radius, shape, .. } => {
                let reach = match shape {
                    Shape::Dot => radius * 0.9,
                    Shape::Ring => radius + 1.0,
                    _ => *radius,
                };
                self.boxes.push((Rect::around(*at, reach), MARKER));
            }
            Mark::Text(text) => self.boxes.push((text.area, LABEL)),
        }
    }

    /// What it costs to put something there.
    pub(super) fn cost(&self, area: &Rect) -> f64 {
        budget::steps(u32::try_from(self.lines.len() / 64 + 1).unwrap_or(u32::MAX));
        let mut cost = 0.0;
        for (a, b, weight) in &self.lines {
            let apart = (0..2).any(|k| a[k].max(b[k]) < area.low[k] || a[k].min(b[k]) > area.high[k]);
            if !apart && let Some((first, last)) = area.clip(*a, *b) {
                let length = (last - first) * (a[0] - b[0]).hypot(a[1] - b[1]);
                cost += weight * LINE * (0.8 + length / 10.0);
            }
        }
        for (other, weight) in &self.boxes {
            if area.overlap(other) > 0.0 {
                cost += weight;
            }
        }
        cost
    }
}
