//! Where movable labels go.
//!
//! Each label has 24 candidates: eight directions at three distances. What a candidate covers of
//! lines, markers and fixed labels is found once. Labels are put down in order, each where it is
//! cheapest; then, a few times over, each is moved to its best candidate given all others, so
//! the total cost falls in every round. What still covers another label is left out.

use super::obstacles::{LABEL, Obstacles};
use super::page::{Extent, Pixel, Rect};
use super::{Direction, Ink, Placed, Size, Text};
use crate::budget;

/// A label that may be moved.
pub(super) struct Movable<'a> {
    pub(super) text: &'a Text,
    pub(super) at: Pixel,
    pub(super) gap: f64,
    pub(super) extent: Extent,
    pub(super) direction: Direction,
    pub(super) size: Size,
    pub(super) ink: Ink,
}

/// Distances, in gaps, and what each costs.
const RINGS: [(f64, f64); 3] = [(1.0, 0.0), (2.0, 1.5), (3.4, 3.5)];
/// What an eighth of a turn away from the direction wanted costs.
const TURN: f64 = 0.3;
const ROUNDS: usize = 6;
/// Pixels between two labels.
const APART: f64 = 4.0;

struct Candidate {
    area: Rect,
    direction: Direction,
    cost: f64,
}

/// The labels with their places, in order; `None` for those left out.
pub(super) fn place(labels: &[Movable], obstacles: &Obstacles) -> Vec<Option<Placed>> {
    budget::charge_terms(24 * labels.len() as u64);
    let candidates: Vec<Vec<Candidate>> = labels.iter().map(|label| label.candidates(obstacles)).collect();
    let mut chosen: Vec<Option<usize>> = vec![None; labels.len()];
    for _ in 0..ROUNDS {
        let mut moved = false;
        for i in 0..labels.len() {
            let cost = |k: usize| {
                let Candidate { area, cost, .. } = &candidates[i][k];
                let covers = |j: usize| {
                    j != i
                        && chosen[j]
                            .is_some_and(|other| area.grown(APART).overlap(&candidates[j][other].area) > 0.0)
                };
                cost + LABEL * (0..labels.len()).filter(|&j| covers(j)).count() as f64
            };
            let best = (0..candidates[i].len()).min_by(|&a, &b| cost(a).total_cmp(&cost(b)));
            budget::steps(u32::try_from(labels.len()).unwrap_or(u32::MAX));
            moved |= best != chosen[i];
            chosen[i] = best;
        }
        if !moved {
            break;
        }
    }
    let mut kept: Vec<Rect> = Vec::new();
    let settle = |(i, label): (usize, &Movable)| {
        let candidate = &candidates[i][chosen[i]?];
        let free = kept.iter().all(|other| candidate.area.overlap(other) == 0.0);
        (free && candidate.cost < LABEL).then(|| {
            kept.push(candidate.area);
            label.placed(candidate)
        })
    };
    labels.iter().enumerate().map(settle).collect()
}

impl Movable<'_> {
    fn candidates(&self, obstacles: &Obstacles) -> Vec<Candidate> {
        let rings = RINGS.iter().flat_map(|ring| Direction::ALL.map(|direction| (ring, direction)));
        rings
            .map(|(&(ring, far), direction)| {
                let area = self.area(direction, self.gap * ring);
                let turn = TURN * direction.turn(self.direction) as f64;
                Candidate { area, direction, cost: far + turn + obstacles.cost(&area.grown(1.0)) }
            })
            .collect()
    }

    /// The space taken in this direction at this distance; in diagonal directions the corner is
    /// at that distance.
    fn area(&self, direction: Direction, gap: f64) -> Rect {
        let (right, up) = direction.signs();
        let gap = if right != 0 && up != 0 { gap * 0.62 } else { gap };
        let side = |sign: i8, length: f64, at: f64| match sign {
            1 => at + gap,
            0 => at - length / 2.0,
            _ => at - gap - length,
        };
        let low = [side(right, self.extent.width, self.at[0]), side(-up, self.extent.height(), self.at[1])];
        Rect { low, high: [low[0] + self.extent.width, low[1] + self.extent.height()] }
    }

    fn placed(&self, candidate: &Candidate) -> Placed {
        let (right, up) = candidate.direction.signs();
        Placed {
            text: self.text.clone(),
            area: candidate.area,
            baseline: candidate.area.low[1] + self.extent.ascent,
            fixed: (-right, up),
            size: self.size,
            ink: self.ink,
        }
    }
}
