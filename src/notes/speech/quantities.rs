//! Words for a point on a curve or a surface.

use super::{LANGUAGES, mentions, plain};
use crate::formula::source::Pieces;

/// Words for it.
const POINTS: &[&str] = &[
    "point",
    "shoulder point",
    "value",
    "punkt",
    "flächenpunkt",
    "kurvenpunkt",
    "schulterpunkt",
    "wert",
    "valeur",
    "点",
    "值",
];

/// Words beside them with which they mean something else: control points, de Boor points.
const OTHERS_BEFORE: &[&str] =
    &["control ", "bézier ", "bezier ", "boor ", "end ", "data ", "inflection ", "控制", "中", "端", "节"];
const OTHERS_AFTER: &[&str] = &["de contrôle", "de bézier", "de bezier", "de de boor", "milieu"];

/// Words for the point whose barycentric coordinates are equal.
const CENTROIDS: &[&str] = &["centroid", "schwerpunkt", "barycentre", "centre de gravité", "重心"];

/// Whether words speak of a point on a curve or a surface.
pub fn speaks_of_a_point(words: &str) -> bool {
    let text = plain(words);
    let own = |phrase: &str| {
        text.match_indices(phrase).any(|(at, _)| {
            let (before, after) = (text.piece(..at), text.piece(at + phrase.len()..).trim_start());
            !OTHERS_BEFORE.iter().any(|other| before.ends_with(other))
                && !OTHERS_AFTER.iter().any(|other| after.starts_with(other))
        })
    };
    POINTS
        .iter()
        .any(|phrase| LANGUAGES.iter().any(|language| mentions(&text, phrase, true, language)) && own(phrase))
}

/// Whether words speak of the centroid of a triangle.
pub fn speaks_of_the_centroid(words: &str) -> bool {
    let text = plain(words);
    // 重心坐标: barycentric coordinates
    let text = text.replace("重心坐标", "");
    CENTROIDS.iter().any(|word| text.contains(word))
}
