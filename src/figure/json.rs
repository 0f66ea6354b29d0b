//! Figures as data.

use serde_json::{Value as Json, json};

use super::{SvgOptions, TikzOptions, svg, tikz};
use crate::language::value::{Notation, Value};
use crate::language::write;
use crate::scene::Scene;

/// A drawing with its title, its description, its SVG and its TikZ.
///
/// ```
/// use polarform::{figure::figure_json, scene::Scene};
/// assert_eq!(figure_json(&Scene::new("nothing"))["kind"], "figure");
/// ```
pub fn figure_json(scene: &Scene) -> Json {
    json!({
        "kind": "figure",
        "title": scene.title(),
        "description": scene.description(),
        "svg": svg(scene, &SvgOptions::default()),
        "tikz": tikz(scene, &TikzOptions::default()),
    })
}

/// A value as by [`crate::language::write::value_json`], with all figures in it drawn.
///
/// ```
/// use polarform::{figure::value_json, value::Value};
/// assert_eq!(value_json(&Value::int(3), Default::default())["number"], "3");
/// ```
pub fn value_json(value: &Value, notation: Notation) -> Json {
    match value {
        Value::Figure(scene) => figure_json(scene),
        Value::List(items) if items.iter().any(holds_figure) => json!({
            "kind": "list",
            "items": items.iter().map(|item| value_json(item, notation)).collect::<Vec<_>>(),
        }),
        _ => write::value_json(value, notation),
    }
}

fn holds_figure(value: &Value) -> bool {
    match value {
        Value::Figure(_) => true,
        Value::List(items) => items.iter().any(holds_figure),
        _ => false,
    }
}
