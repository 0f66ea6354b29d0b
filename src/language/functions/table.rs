//! All functions, and how one is found.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::record::Builtin;
use super::{
    arrange, blends, blossoms, curves, derive, differential, features, figures, geometric, interpolation,
    intersections, joins, matrices, measure, numbers, polar, polynomials, rational, rational_blossoms,
    regions, roots, sections, solve, splines, subdivision, surface_schemes, surfaces, symmetric,
    triangulations, vertices,
};

/// All functions, by topic.
pub static BUILTINS: &[&Builtin] = &{
    const fn all<const N: usize>(tables: &[&'static [Builtin]]) -> [&'static Builtin; N] {
        let mut list = [&tables[0][0]; N];
        let (mut at, mut table) = (0, 0);
        while table < tables.len() {
            let mut i = 0;
            while i < tables[table].len() {
                list[at] = &tables[table][i];
                at += 1;
                i += 1;
            }
            table += 1;
        }
        assert!(at == N);
        list
    }
    const fn count(tables: &[&'static [Builtin]]) -> usize {
        let (mut sum, mut i) = (0, 0);
        while i < tables.len() {
            sum += tables[i].len();
            i += 1;
        }
        sum
    }
    const TABLES: &[&[Builtin]] = &[
        polar::TABLE,
        symmetric::TABLE,
        blossoms::TABLE,
        rational_blossoms::TABLE,
        polynomials::TABLE,
        arrange::TABLE,
        roots::TABLE,
        features::TABLE,
        regions::TABLE,
        solve::TABLE,
        matrices::TABLE,
        curves::TABLE,
        splines::TABLE,
        subdivision::TABLE,
        vertices::TABLE,
        rational::TABLE,
        intersections::TABLE,
        surface_schemes::TABLE,
        sections::TABLE,
        differential::TABLE,
        measure::TABLE,
        surfaces::TABLE,
        blends::TABLE,
        triangulations::TABLE,
        joins::TABLE,
        geometric::TABLE,
        joins::CONVERSIONS,
        derive::TABLE,
        interpolation::POLYNOMIALS,
        interpolation::SPLINES,
        interpolation::APPROXIMATION,
        interpolation::SPLINE_FITS,
        interpolation::ENERGY,
        figures::TABLE,
        numbers::TABLE,
    ];
    all::<{ count(TABLES) }>(TABLES)
};

/// The function of that name.
pub fn builtin(name: &str) -> Option<&'static Builtin> {
    static BY_NAME: LazyLock<HashMap<&str, &Builtin>> =
        LazyLock::new(|| BUILTINS.iter().map(|builtin| (builtin.name, *builtin)).collect());
    BY_NAME.get(name).copied()
}
