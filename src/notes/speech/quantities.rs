//! Words for a point on a curve or a surface.

use super::plain;
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
const OTHERS_BEFORE: &[&str] = &[
    "control ",
    "bézier ",
    "bezier ",
    "boor ",
    "end ",
    "data ",
    "inflection ",
    "intersection ",
    "first ",
    "mean ",
    "控制",
    "中",
    "端",
    "节",
];
const OTHERS_AFTER: &[&str] = &["de contrôle", "de bézier", "de bezier", "de de boor", "milieu"];

/// Words for the point whose barycentric coordinates are equal.
const CENTROIDS: &[&str] = &["centroid", "schwerpunkt", "barycentre", "centre de gravité", "重心"];

/// Whether words before a name end with the noun: "its point".
pub fn ends_with_a_point(words: &str) -> bool {
    let text = plain(words);
    nouns(text.trim_end()).any(|(_, after)| after.is_empty())
}

/// Whether words after a name soon come to the noun: "denotes the point with". What is of a point is another thing.
pub fn leads_to_a_point(words: &str) -> bool {
    let text = plain(words);
    nouns(&text).any(|(before, after)| {
        let between = before.split_whitespace();
        let other = |word: &str| matches!(word, "of" | "von" | "vom" | "de" | "du" | "des" | "与" | "和");
        !OTHERS_AFTER.iter().any(|other| after.trim_start().starts_with(other))
            && between.clone().count() < 5
            && !between.into_iter().any(other)
    })
}

/// The words before and after each noun for a point on a curve or a surface.
fn nouns(text: &str) -> impl Iterator<Item = (&str, &str)> {
    POINTS.iter().flat_map(move |noun| text.match_indices(noun).map(move |(at, _)| (at, *noun))).filter_map(
        move |(at, noun)| {
            let (before, after) = (text.piece(..at), text.piece(at + noun.len()..));
            let spaced = noun.is_ascii() || !noun.starts_with(['点', '值']);
            let whole = !spaced
                || !before.ends_with(char::is_alphanumeric) && !after.starts_with(char::is_alphanumeric);
            let other = OTHERS_BEFORE.iter().any(|other| before.ends_with(other));
            (whole && !other).then_some((before, after))
        },
    )
}

/// Whether words speak of the centroid of a triangle.
pub fn speaks_of_the_centroid(words: &str) -> bool {
    let text = plain(words);
    // 重心坐标: barycentric coordinates
    let text = text.replace("重心坐标", "");
    CENTROIDS.iter().any(|word| text.contains(word))
}

/// Whether words are one for the first derivative, and nothing else.
pub fn is_the_derivative(words: &str) -> bool {
    let text = plain(words);
    DERIVATIVE.contains(&text.trim())
}

/// The words for the first derivative.
const DERIVATIVE: &[&str] = &[
    "derivative",
    "first derivative",
    "hodograph",
    "ableitung",
    "erste ableitung",
    "dérivée",
    "导数",
    "一阶导数",
];
