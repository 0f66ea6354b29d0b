//! Where a path leads, which file needs which, and circles of files.

use std::collections::{BTreeMap, BTreeSet};
use std::slice;

use super::tree::{Module, Names, Tree};

/// How many `use` may follow each other before a name is given up.
const LONGEST_CHAIN: usize = 12;

/// The names from the root that `crate`, `self` and `super` stand for; nothing without one of these.
pub fn absolute(module: &[String], path: &[String]) -> Option<Names> {
    let (first, mut rest) = path.split_first()?;
    let mut start = match first.as_str() {
        "crate" => Names::new(),
        "self" => module.to_vec(),
        "super" => module[..module.len().saturating_sub(1)].to_vec(),
        _ => return None,
    };
    while let Some((_, further)) = rest.split_first().filter(|(name, _)| *name == "super") {
        start.pop();
        rest = further;
    }
    start.extend_from_slice(rest);
    Some(start)
}

/// The module in which the item stands that a path of a module names, `use` of others followed.
/// Nothing if it is not of this crate.
pub fn home(tree: &Tree, module: &[String], path: &[String]) -> Option<Names> {
    follow(tree, module, path, LONGEST_CHAIN)
}

fn follow(tree: &Tree, module: &[String], path: &[String], left: usize) -> Option<Names> {
    match absolute(module, path) {
        Some(names) => Some(walk(tree, Names::new(), &names, left).unwrap_or_else(|| deepest(tree, &names))),
        None => walk(tree, module.to_vec(), path, left),
    }
}

fn walk(tree: &Tree, mut at: Names, path: &[String], left: usize) -> Option<Names> {
    let left = left.checked_sub(1)?;
    for (i, name) in path.iter().enumerate() {
        let below = [at.as_slice(), slice::from_ref(name)].concat();
        if tree.contains_key(&below) {
            at = below;
            continue;
        }
        let here: &Module = tree.get(&at)?;
        if here.items.contains(name) {
            return Some(at);
        }
        let further = |start: &Names| [start, &path[i + 1..]].concat();
        let imported = here.imported.get(name).into_iter().flatten();
        let mut named = imported.filter(|start| start.first() != Some(name) || start.len() > 1);
        let found = named.find_map(|start| follow(tree, &at, &further(start), left));
        return found.or_else(|| {
            here.globs.iter().find_map(|glob| {
                let from = follow(tree, &at, glob, left)?;
                (from != at).then(|| walk(tree, from, &path[i..], left)).flatten()
            })
        });
    }
    Some(at)
}

/// The longest beginning that is a module.
fn deepest(tree: &Tree, names: &[String]) -> Names {
    let length = (0..=names.len()).rev().find(|&length| tree.contains_key(&names[..length]));
    names[..length.unwrap_or(0)].to_vec()
}

/// Which file needs which others. What `pub use` passes on counts where it is used.
pub fn files(tree: &Tree) -> BTreeMap<&str, BTreeSet<&str>> {
    let mut needs: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (names, module) in tree {
        let own = needs.entry(&module.file).or_default();
        for reference in module.references.iter().filter(|reference| !reference.passed_on) {
            if let Some(other) = home(tree, names, &reference.names).and_then(|home| tree.get(&home)) {
                own.insert(&other.file);
            }
        }
        own.remove(module.file.as_str());
    }
    needs
}

/// Which file calls methods that stand in which others, for each type with methods in more than one: a method that is
/// called by `self` needs no import.
pub fn by_methods(tree: &Tree) -> BTreeMap<String, BTreeMap<&str, BTreeSet<&str>>> {
    let full = |module: &[String], of: &Names| {
        let name = of.last()?;
        Some([home(tree, module, of)?.as_slice(), slice::from_ref(name)].concat().join("::"))
    };
    let mut stand: BTreeMap<(String, &str), BTreeSet<&str>> = BTreeMap::new();
    for (names, module) in tree {
        for (of, method) in &module.methods {
            let Some(of) = full(names, of) else { continue };
            stand.entry((of, method)).or_default().insert(&module.file);
        }
    }
    let mut needs: BTreeMap<String, BTreeMap<&str, BTreeSet<&str>>> = BTreeMap::new();
    for (names, module) in tree {
        for (of, method) in &module.calls {
            let Some(of) = full(names, of) else { continue };
            let others = stand.get(&(of.clone(), method.as_str())).into_iter().flatten();
            let others = others.filter(|other| **other != module.file);
            needs.entry(of).or_default().entry(&module.file).or_default().extend(others);
        }
    }
    needs
}

/// Groups of files each of which needs, by way of others, all of its group; the largest first.
pub fn circles<'a>(needs: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> Vec<Vec<&'a str>> {
    // Kosaraju: files in the order in which they are left, then backwards over the reversed graph.
    let mut order = Vec::new();
    let mut seen = BTreeSet::new();
    for file in needs.keys() {
        visit(file, needs, &mut seen, &mut order);
    }
    let mut needed: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (file, others) in needs {
        for other in others {
            needed.entry(other).or_default().insert(file);
        }
    }
    let mut seen = BTreeSet::new();
    let mut circles = Vec::new();
    for file in order.into_iter().rev() {
        let mut circle = Vec::new();
        visit(file, &needed, &mut seen, &mut circle);
        if circle.len() > 1 {
            circle.sort_unstable();
            circles.push(circle);
        }
    }
    circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
    circles
}

fn visit<'a>(
    file: &'a str,
    edges: &BTreeMap<&'a str, BTreeSet<&'a str>>,
    seen: &mut BTreeSet<&'a str>,
    left: &mut Vec<&'a str>,
) {
    if seen.insert(file) {
        for other in edges.get(file).into_iter().flatten() {
            visit(other, edges, seen, left);
        }
        left.push(file);
    }
}
