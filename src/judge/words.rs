//! The curve that a sentence speaks of without naming its points.

use super::model::Curve;

/// The Bézier curve that the words before a formula speak of, if they speak of its polar form.
pub fn curve_spoken_of(recent: &str) -> Option<Curve> {
    let text = recent.to_lowercase();
    let tail: String = {
        let letters: Vec<char> = text.chars().rev().take(400).collect();
        letters.into_iter().rev().collect()
    };
    let bezier = [
        "bezier curve",
        "bézier curve",
        "贝塞尔曲线",
        "bezier曲线",
        "bezier 曲线",
        "bézierkurve",
        "courbe de bézier",
    ]
    .iter()
    .any(|word| tail.contains(word));
    let polar = ["polar form", "blossom", "极形式", "开花", "polarform", "forme polaire"]
        .iter()
        .any(|word| tail.contains(word));
    (bezier && polar).then(|| Curve { points: "b".to_owned() })
}
