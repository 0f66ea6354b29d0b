//! The functions of the table as the evaluator calls them.

use super::record::Builtin;
use super::table::{BUILTINS, builtin};
use crate::language::eval::{Arguments, Callable, Evaluated, Machine, Slot};

/// The function of that name, for the evaluator.
pub(crate) fn callable(name: &str) -> Option<&'static dyn Callable> {
    builtin(name).map(|builtin| builtin as &dyn Callable)
}

/// The names of all functions.
pub(crate) fn names() -> Vec<&'static str> {
    BUILTINS.iter().map(|builtin| builtin.name).collect()
}

/// Other names for functions.
const SYNONYMS: &[(&str, &str)] = &[
    ("de_casteljau", "casteljau"),
    ("de_boor", "deboor"),
    ("cox_de_boor", "bspline_basis"),
    ("blossom", "polar"),
    ("evaluate", "extended"),
    ("split", "subdivide"),
    ("curve", "bezier"),
    ("rational_bezier", "bezier"),
    ("nurbs", "bspline"),
    ("spline", "bspline"),
    ("hull", "convex_hull"),
    ("boehm", "insert_knots"),
    ("insert", "insert_knots"),
    ("insert_knot", "insert_knots"),
    ("knot_insertion", "insert_knots"),
    ("oslo", "refine"),
    ("basis", "bspline_basis"),
    ("marsden", "spline_of"),
    ("periodic_bspline", "periodic_spline"),
    ("surface", "patch"),
    ("tensor_patch", "patch"),
    ("triangle_surface", "triangle_patch"),
    ("bspline_surface", "spline_surface"),
    ("interpolate", "lagrange"),
    ("natural_spline", "cubic_spline"),
    ("surface_of_revolution", "revolve"),
    ("revolution", "revolve"),
    ("degree_elevation", "elevate"),
    ("degree_reduction", "reduce"),
    ("continuity_conditions", "joining_conditions"),
    ("delta", "differences"),
];

/// The function that somebody means by another name.
pub(crate) fn synonym(name: &str) -> Option<&'static str> {
    SYNONYMS.iter().find(|(other, _)| *other == name).map(|(_, known)| *known)
}

impl Callable for Builtin {
    fn name(&self) -> &'static str {
        self.name
    }

    fn form(&self) -> String {
        self.signature()
    }

    fn takes_word(&self, slot: Slot, word: &str, defined: bool) -> bool {
        match slot {
            Slot::Place(place) => self.takes_word_at(place, word, defined),
            Slot::Name(name) => self.takes_word_under(name, word, defined),
        }
    }

    fn run(&self, machine: &mut Machine, arguments: Arguments) -> Evaluated {
        Builtin::run(self, machine, arguments)
    }
}
