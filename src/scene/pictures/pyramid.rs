//! Triangular schemes.

use crate::budget;
use crate::formula::Expr;
use crate::scene::{Aspect, Direction, Ink, Label, Path, Scene, SceneError, Spot, Style};

/// Where the last level of a scheme is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Apex {
    /// On the right: level 0 is a column.
    #[default]
    Right,
    /// At the top: level 0 is the lowest row.
    Top,
    /// At the bottom.
    Bottom,
}

/// A scheme such as de Casteljau's, de Boor's, or that of divided differences: each entry comes
/// from two neighbours in the level before.
///
/// ```
/// use polarform::expr::Expr;
/// use polarform::scene::pictures::{PyramidPicture, casteljau_labels};
/// let name = Expr::name;
/// let levels = casteljau_labels(&name("f"), 2, &Expr::int(0), &Expr::int(1), &name("t"));
/// assert!(PyramidPicture::of(levels).scene().is_ok());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PyramidPicture {
    /// The entries by level; entry i of a level comes from entries i and i + 1 of the one before.
    pub levels: Vec<Vec<Expr>>,
    /// What is written at the two arrows to entry i of level r + 1: `weights[r][i]`, first at
    /// that from entry i. Missing ones are not shown.
    pub weights: Vec<Vec<[Expr; 2]>>,
    /// Where the last level is.
    pub apex: Apex,
    /// Entries (level, i) that stand out.
    pub marked: Vec<(usize, usize)>,
}

impl PyramidPicture {
    /// The scheme with these entries, without weights, its last level on the right.
    pub fn of(levels: Vec<Vec<Expr>>) -> Self {
        PyramidPicture { levels, weights: Vec::new(), apex: Apex::Right, marked: Vec::new() }
    }

    /// The picture.
    ///
    /// # Errors
    /// [`SceneError::Empty`] without entries; [`SceneError::Shape`] when a level has more entries
    /// than its predecessor has neighbours.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let longest = self.levels.first().map_or(0, Vec::len);
        if longest == 0 {
            return Err(SceneError::Empty { what: "entries" });
        }
        for (level, pair) in self.levels.windows(2).enumerate() {
            if pair[1].len() + 1 > pair[0].len().max(1) {
                return Err(SceneError::Shape {
                    what: format!("level {} of the scheme has too many entries", level + 1),
                });
            }
        }
        budget::charge_terms(self.levels.iter().map(|level| 5 * level.len() as u64).sum());
        // Weights need room between neighbours; in schemes of many levels, whose entries are long and whose
        // columns are narrow, all of it is above and below the arrows.
        let narrow = self.levels.len().saturating_sub(6) as f64;
        let row = if self.weights.is_empty() { 46.0 } else { 68.0 + 12.0 * narrow };
        let rows = match self.apex {
            Apex::Right => longest - 1,
            Apex::Top | Apex::Bottom => self.levels.len() - 1,
        };
        let height = (rows as f64 * row * if self.apex == Apex::Right { 1.0 } else { 1.15 }).max(24.0);
        let mut scene =
            Scene::new("Triangular scheme").also("zh", "三角形格式").with_aspect(Aspect::Free { height });
        for (r, level) in self.levels.iter().enumerate() {
            for (i, entry) in level.iter().enumerate() {
                let at = self.place(r, i)?;
                if r > 0 {
                    for side in 0..2 {
                        self.arrow(&mut scene, (r, i), side)?;
                    }
                }
                let ink = if self.marked.contains(&(r, i)) { Ink::Accent } else { Ink::Text };
                scene.add(Label::centred(at, entry.clone()).inked(ink));
            }
        }
        Ok(scene.with_description(format!(
            "A scheme of {} levels that begins with {longest} entries.",
            self.levels.len()
        )))
    }

    fn place(&self, level: usize, i: usize) -> Result<Spot, SceneError> {
        let (along, across) = (level as f64, i as f64 + level as f64 / 2.0);
        match self.apex {
            Apex::Right => Spot::new(along, -across),
            Apex::Top => Spot::new(across, along),
            Apex::Bottom => Spot::new(across, -along),
        }
    }

    /// The arrow to entry i of level r from entry i + side of the level before.
    fn arrow(&self, scene: &mut Scene, (r, i): (usize, usize), side: usize) -> Result<(), SceneError> {
        let (from, to) = (self.place(r - 1, i + side)?, self.place(r, i)?);
        scene.add(Path::line(from, to, Style::guide()).with_arrow().trim());
        let weights = self.weights.get(r - 1).and_then(|level| level.get(i));
        if let Some(weight) = weights.map(|pair| &pair[side]) {
            let direction = match (self.apex, side) {
                (Apex::Right, 0) | (Apex::Bottom, 1) => Direction::NorthEast,
                (Apex::Right, _) | (Apex::Top, 1) => Direction::SouthEast,
                (Apex::Top, _) => Direction::SouthWest,
                (Apex::Bottom, _) => Direction::NorthWest,
            };
            let label = Label::beside(from.toward(to, 0.5), weight.clone(), direction).small();
            scene.add(Label { gap: 4.0, ..label });
        }
        Ok(())
    }
}
