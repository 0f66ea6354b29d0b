//! The floors of docs/architecture.md, read off the sources: a file imports only from lower floors
//! or from its own. Every path of every file is looked at, also in tests, macros and modules inside
//! modules.

#![allow(clippy::print_stdout, reason = "the circles that there are")]

mod graph;
mod tree;

use std::collections::BTreeSet;
use std::path::Path;
use std::slice;
use std::sync::LazyLock;

pub(crate) use tree::sources;
use tree::{Sources, Tree, add, tree};

/// Modules of one folder by level, lowest first. Those of one level do not import each other.
struct Order {
    folder: &'static [&'static str],
    levels: &'static [&'static [&'static str]],
}

const FLOORS: Order = Order {
    folder: &[],
    levels: &[
        &["budget"],
        &["math"],
        &["formula"],
        &["scene"],
        &["language"],
        &["judge"],
        &["session"],
        &["figure"],
        &["document"],
        &["notes"],
        &["weave"],
        &["cli"],
    ],
};

const MATH: Order = Order {
    folder: &["math"],
    levels: &[
        &["number"],
        &["ring"],
        &["interval"],
        &["linalg", "poly"],
        &["basis", "blossom", "piecewise", "system"],
        &["curve", "interpolate"],
        &["spline"],
        &["approximation", "subdivision"],
    ],
};

const LANGUAGE: Order = Order {
    folder: &["language"],
    levels: &[
        &["diagnostic"],
        &["lexicon"],
        &["syntax"],
        &["latex"],
        &["value"],
        &["derive"],
        &["write"],
        &["ops"],
        &["eval"],
        &["functions"],
    ],
};

const JUDGE: Order = Order {
    folder: &["judge"],
    levels: &[
        &["prove", "written"],
        &["page", "values"],
        &["model"],
        &["instances"],
        &["known"],
        &["repair"],
        &["reasons", "theorems"],
        &["verdict"],
        &["described"],
        &["check"],
    ],
};

/// The rooms of requests; session.rs, above them all, runs what they make.
const SESSION: Order =
    Order { folder: &["session"], levels: &[&["foreign"], &["given"], &["spoken"], &["lines"], &["hints"]] };

const ORDERS: [&Order; 5] = [&FLOORS, &MATH, &LANGUAGE, &JUDGE, &SESSION];

/// The most files that may import each other in a circle.
const LARGEST_CIRCLE: usize = 10;

/// Circles of more files than this are known.
const SMALL_CIRCLE: usize = 5;

/// The large circles: by imports those of a folder, by methods those of a type, which cost no import; with the number of
/// their files, and why they are there.
const CIRCLES: &[(&str, usize, &str)] = &[
    ("cli", 10, "mod.rs starts the commands, which give back its status; some start others"),
    ("document", 9, "a part is read as a document is, and all write into one collector"),
    ("judge/model", 6, "mod.rs has the model, the others the meanings for which it asks them"),
    ("language/value", 10, "a value may be made of values of each kind"),
    ("notes/objects", 10, "phrases name objects, and objects are described by phrases"),
    ("notes/speech", 9, "the languages stand in one table, of whose types their files are made"),
    ("session/spoken", 10, "a request is read by rules that read parts of it as requests"),
    ("judge::model::Model", 17, "a formula is evaluated by the kind of its node, and its parts again"),
    (
        "language::eval::machine::Machine",
        26,
        "a formula is evaluated by the kind of its node, and its parts again",
    ),
    ("language::latex::reader::Reader", 11, "a reader by descent: an atom may be a formula in brackets"),
    ("language::syntax::parser::Parser", 6, "a reader by descent: an operand may be a formula in brackets"),
    ("notes::objects::Reader", 7, "phrases name objects, and objects are described by phrases"),
    ("session::Session", 12, "the session asks each reading of a line, which hands its parts to the session"),
];

/// The aim is 600.
const LONGEST_FILE: usize = 650;

/// An import that goes up.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Upward {
    file: String,
    path: String,
    from: String,
    to: String,
}

impl Order {
    fn level(&self, name: &str) -> Option<usize> {
        self.levels.iter().position(|level| level.contains(&name))
    }

    /// The module of the folder to which the names belong; tests of the folder itself see all of it.
    fn member<'a>(&self, names: &'a [String]) -> Option<&'a str> {
        let (folder, rest) = names.split_at_checked(self.folder.len())?;
        (folder == self.folder)
            .then(|| rest.first().map(String::as_str))
            .flatten()
            .filter(|name| *name != "tests")
    }

    fn full(&self, member: &str) -> String {
        [self.folder, &[member]].concat().join("::")
    }

    /// Modules that have no place in the order.
    fn unplaced(&self, tree: &Tree) -> BTreeSet<String> {
        let members = tree.keys().filter_map(|names| self.member(names));
        members.filter(|member| self.level(member).is_none()).map(|member| self.full(member)).collect()
    }

    fn allows(&self, from: &str, to: &str) -> bool {
        from == to || matches!((self.level(from), self.level(to)), (Some(from), Some(to)) if to < from)
    }
}

/// What breaks the orders in a tree.
fn upward(tree: &Tree) -> BTreeSet<Upward> {
    tree.keys().flat_map(|module| upward_from(tree, module)).collect()
}

/// What breaks the orders in a module. A path counts as it is written and as it is meant: both the
/// module it names and the one in which the item stands must lie lower.
fn upward_from(tree: &Tree, module: &[String]) -> BTreeSet<Upward> {
    let mut found = BTreeSet::new();
    let content = &tree[module];
    for reference in &content.references {
        let mut tell = |from: String, to: String| {
            found.insert(Upward { file: content.file.clone(), path: reference.names.join("::"), from, to });
        };
        let written = graph::absolute(module, &reference.names);
        // What lib.rs passes on is for users; inside, everything has one name.
        let root = written.as_ref().and_then(|names| names.first());
        let by_root = root.filter(|name| !module.is_empty() && !tree.contains_key(slice::from_ref(*name)));
        if let Some(name) = by_root {
            tell(module[0].clone(), format!("{name} of lib.rs"));
        }
        let meant = graph::home(tree, module, &reference.names);
        let written = written.as_ref().filter(|_| by_root.is_none());
        for order in ORDERS {
            let Some(from) = order.member(module) else { continue };
            for to in [written, meant.as_ref()].into_iter().flatten() {
                let member = order.member(to).filter(|_| tree.contains_key(&to[..=order.folder.len()]));
                if let Some(to) = member.filter(|to| !order.allows(from, to)) {
                    tell(order.full(from), order.full(to));
                }
            }
        }
    }
    found
}

static SOURCES: LazyLock<Sources> =
    LazyLock::new(|| sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")));
static TREE: LazyLock<Tree> = LazyLock::new(|| tree(&SOURCES));

#[test]
fn every_module_has_a_place() {
    for order in ORDERS {
        assert_eq!(order.unplaced(&TREE), BTreeSet::new());
    }
}

/// The picture in docs/architecture.md, from the top down: floors, and rooms as `a · b, c · d`.
#[test]
fn the_picture_of_the_house_is_right() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/architecture.md");
    let page = std::fs::read_to_string(page).expect("the page is there");
    let mut floors: Vec<(&str, String)> = Vec::new();
    for line in page.lines().filter(|line| line.starts_with('│')) {
        let mut cells = line.split('│').skip(1).map(str::trim);
        let (name, text) = (cells.next().unwrap_or(""), cells.next().unwrap_or(""));
        match floors.last_mut().filter(|_| name.is_empty()) {
            Some((_, before)) => *before += &format!(" {text}"),
            None => floors.push((name, text.to_owned())),
        }
    }
    floors.reverse();
    let told: Vec<Vec<&str>> = floors.iter().map(|(name, _)| vec![*name]).collect();
    assert_eq!(told, FLOORS.levels);
    for order in [&MATH, &LANGUAGE, &JUDGE, &SESSION] {
        let text = floors.iter().find(|(name, _)| order.folder == [*name]).map_or("", |(_, text)| text);
        let mut rooms: Vec<Vec<&str>> = text.split(" · ").map(|level| level.split(", ").collect()).collect();
        rooms.reverse();
        assert_eq!(rooms, order.levels);
    }
}

#[test]
fn every_file_is_read() {
    let read: BTreeSet<&str> = TREE.values().map(|module| module.file.as_str()).collect();
    let unread: Vec<&String> =
        SOURCES.keys().filter(|file| *file != "main.rs" && !read.contains(file.as_str())).collect();
    assert!(unread.is_empty(), "not part of the library: {unread:?}");
}

#[test]
fn imports_go_down() {
    let lines: Vec<String> = upward(&TREE)
        .iter()
        .map(|Upward { file, path, from, to }| format!("{file}: {from} may not import {to}: {path}"))
        .collect();
    assert!(lines.is_empty(), "\n{}", lines.join("\n"));
}

/// A method that is called by `self` needs no import, wherever it stands.
#[test]
fn methods_are_called_downwards() {
    let names = |file: &str| -> Vec<String> {
        let path = file.trim_end_matches(".rs").trim_end_matches("/mod");
        path.split('/').map(str::to_owned).collect()
    };
    let mut wrong = Vec::new();
    for (of, needs) in graph::by_methods(&TREE) {
        for (file, others) in needs {
            for (order, other) in
                ORDERS.iter().flat_map(|order| others.iter().map(move |other| (order, other)))
            {
                let (from, to) = (names(file), names(other));
                let rooms = order.member(&from).zip(order.member(&to));
                if rooms.is_some_and(|(from, to)| !order.allows(from, to)) {
                    wrong.push(format!("{file} may not call methods of {of} in {other}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// The program only starts the command line.
#[test]
fn the_program_is_the_command_line() {
    let mut main = Tree::new();
    let declared = add(&mut main, "main.rs", &SOURCES["main.rs"], Vec::new(), String::new());
    assert!(declared.is_empty());
    let paths =
        main.values().flat_map(|module| &module.references).map(|reference| reference.names.join("::"));
    let of_ours: BTreeSet<String> = paths.filter(|path| path.starts_with("polarform")).collect();
    assert_eq!(of_ours, BTreeSet::from(["polarform::cli::main".to_owned()]));
}

/// The folder in which all of some files lie; session.rs belongs to session.
fn folder_of<'a>(files: &[&'a str]) -> &'a str {
    let (first, others) = files.split_first().expect("a circle has files");
    let first = first.trim_end_matches(".rs");
    let folders = first.rmatch_indices('/').map(|(end, _)| &first[..end]);
    let holds = |folder: &&str, file: &&str| {
        file.strip_prefix(*folder).is_some_and(|rest| rest.starts_with('/') || rest == ".rs")
    };
    let shared =
        [first].into_iter().chain(folders).find(|folder| others.iter().all(|file| holds(folder, file)));
    shared.unwrap_or("")
}

/// `cargo test --test main circles -- --nocapture` lists them all.
#[test]
fn circles_are_known() {
    let by_imports = graph::files(&TREE);
    let by_imports = graph::circles(&by_imports);
    let largest = by_imports.first().map_or(0, Vec::len);
    let by_imports = by_imports.into_iter().map(|files| (folder_of(&files).to_owned(), files));
    let by_methods = graph::by_methods(&TREE);
    let by_methods = by_methods.iter().flat_map(|(of, needs)| {
        let circles = graph::circles(needs).into_iter();
        circles.map(|files| (of.clone(), files))
    });
    let all: Vec<(String, Vec<&str>)> = by_imports.chain(by_methods).collect();
    let lines: Vec<String> = all
        .iter()
        .map(|(place, files)| format!("{place}: {} files, {}", files.len(), files.join(", ")))
        .collect();
    println!("{}", lines.join("\n"));
    assert!(largest <= LARGEST_CIRCLE, "more than {LARGEST_CIRCLE} files import each other");
    for (place, files) in all.iter().filter(|(_, files)| files.len() > SMALL_CIRCLE) {
        let known = CIRCLES.iter().any(|(known, most, _)| known == place && files.len() <= *most);
        assert!(known, "a new circle in {place}: {files:#?}");
    }
    for (place, ..) in CIRCLES {
        let there = all.iter().any(|(circle, files)| circle == place && files.len() > SMALL_CIRCLE);
        assert!(there, "{place} has no large circle any more: take it off the list");
    }
}

#[test]
fn files_stay_readable() {
    for (file, text) in &*SOURCES {
        let lines = text.lines().count();
        assert!(lines <= LONGEST_FILE, "{file} has {lines} lines");
    }
}

/// A test that is not named in `main.rs` would never run.
#[test]
fn every_test_is_run() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let main = std::fs::read_to_string(folder.join("main.rs")).expect("the tests are there");
    for entry in std::fs::read_dir(folder).expect("the tests are there") {
        let path = entry.expect("it is readable").path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_some_and(|e| e == "rs") && stem != "main" {
            assert!(main.contains(&format!("mod {stem};\n")), "tests/main.rs does not name {stem}");
        }
    }
}

/// A small crate with these files; modules are declared by hand.
fn crate_of(files: &[(&str, &str)]) -> Tree {
    let sources = files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
    tree(&sources.collect())
}

/// What is found when a text stands in a file of `math`.
fn planted(text: &str) -> BTreeSet<(String, String)> {
    let tree = crate_of(&[
        ("lib.rs", "pub mod budget; pub mod math; pub mod session; pub mod cli; pub use math::poly;"),
        ("budget.rs", "pub fn step() {}"),
        ("math/mod.rs", "pub mod poly; pub mod spline;"),
        ("math/poly/mod.rs", "mod gcd; pub struct Poly; pub use gcd::gcd;"),
        ("math/poly/gcd.rs", &format!("pub fn gcd() {{}} {text}")),
        ("math/spline.rs", "pub fn knots() {}"),
        ("session.rs", "pub struct Session; pub use crate::math::poly::Poly;"),
        ("cli.rs", "pub fn run() {}"),
    ]);
    upward(&tree).into_iter().map(|import| (import.from, import.to)).collect()
}

#[test]
fn imports_downwards_are_allowed() {
    for text in [
        "use crate::budget::step;",
        "use super::Poly; use super::super::poly::gcd as other;",
        "use std::fmt; use num_bigint::{BigInt, Sign}; fn f() { ::session::x() }",
        "pub(crate) fn f() { crate::budget::step(); self::gcd(); }",
        "#[cfg(test)] mod tests { use super::*; use crate::math::poly::Poly; }",
        "// crate::session::Session\nconst A: &str = \"crate::session::Session\";",
    ] {
        assert_eq!(planted(text), BTreeSet::new(), "{text}");
    }
}

#[test]
fn planted_upward_imports_are_found() {
    let up = |from: &str, to: &str| BTreeSet::from([(from.to_owned(), to.to_owned())]);
    for (text, to) in [
        ("use crate::session::Session;", "session"),
        ("pub use crate::session;", "session"),
        ("use crate::session as other;", "session"),
        ("use crate::session::*;", "session"),
        ("use crate::{budget::step, session::{self, Session}};", "session"),
        ("fn f() { use crate::session::Session; }", "session"),
        ("fn f() -> crate::session::Session { todo!() }", "session"),
        ("fn f() { let _ = <crate::session::Session as Default>::default(); }", "session"),
        ("fn f(_: Vec<crate::session::Session>) {}", "session"),
        ("use super::super::super::session::Session;", "session"),
        ("use crate::budget; mod a { mod b { use super::super::super::super::super::cli; } }", "cli"),
        ("#[cfg(test)] mod tests { mod deep { fn f() { crate::cli::run() } } }", "cli"),
        ("fn f() { assert!(crate::cli::run() == (), \"\"); }", "cli"),
        ("fn f() { vec![vec![1, { crate::cli::run(); 2 }]]; }", "cli"),
        ("macro_rules! m { () => { $crate::cli::run() } }", "cli"),
        ("macro_rules! m { () => { use crate::{budget, cli}; } }", "cli"),
        ("thing! { use crate::session::Poly as _; }", "session"),
        ("#[arg(value_parser = crate::cli::run)] struct A;", "cli"),
        ("#[cfg_attr(test, derive(crate::session::Session))] struct A;", "session"),
        // A name of a user, and one that is lower but reached from above.
        ("use crate::poly::Poly;", "poly of lib.rs"),
        ("use crate::session::Poly;", "session"),
    ] {
        assert_eq!(planted(text), up("math", to), "{text}");
    }
    let inside = up("math::poly", "math::spline");
    assert_eq!(planted("use crate::math::spline::knots;"), inside);
    assert_eq!(planted("use super::super::spline;"), inside);
}

#[test]
fn an_upward_import_planted_here_is_found() {
    let mut tree = TREE.clone();
    let module = ["math", "number", "int"].map(str::to_owned).to_vec();
    let planted = ["math", "number", "int", "planted"].map(str::to_owned);
    let text = "#[cfg(test)]\nmod planted {\n    use crate::{budget, judge::{self as other}};\n}\n";
    add(&mut tree, "math/number/int.rs", text, module, "math/number/int/".to_owned());
    let found = upward_from(&tree, &planted);
    assert!(found.len() == 1 && found.iter().all(|import| import.to == "judge"), "{found:?}");
}

#[test]
fn planted_circles_are_found() {
    let ring = |last: &str| {
        let files: Vec<(String, String)> = (0..11)
            .map(|i| {
                let next = if i < 10 { format!("a{}", i + 1) } else { last.to_owned() };
                (format!("math/a{i}.rs"), format!("use super::{next}::f as next; pub fn f() {{ next() }}"))
            })
            .collect();
        let modules: String = (0..11).map(|i| format!("pub mod a{i}; pub use a{i}::f as f{i};")).collect();
        let mut all = vec![("lib.rs", "pub mod math;"), ("math/mod.rs", modules.as_str())];
        all.extend(files.iter().map(|(name, text)| (name.as_str(), text.as_str())));
        crate_of(&all)
    };
    // The last file calls the first one, by its own name or by that of the folder: `use super::f0::f` is none.
    for (text, size) in [("a0", Some(11)), ("a7", Some(4)), ("a10", None)] {
        let tree = ring(text);
        let needs = graph::files(&tree);
        let circles: Vec<usize> = graph::circles(&needs).iter().map(Vec::len).collect();
        assert_eq!(circles, size.into_iter().collect::<Vec<usize>>(), "{text}");
    }
}

#[test]
fn names_passed_on_lead_to_where_they_stand() {
    let tree = crate_of(&[
        ("lib.rs", "pub mod math;"),
        ("math/mod.rs", "mod a; mod b; mod c; pub use a::*; pub use b::second as other;"),
        ("math/a.rs", "pub fn first() { super::other() }"),
        ("math/b.rs", "use crate::math::first; pub fn second() { first() }"),
        ("math/c.rs", "#[path = \"c_tests.rs\"] mod tests; pub fn third() { super::first() }"),
        ("math/c_tests.rs", "use super::*; fn check() { third(); }"),
    ]);
    let needs = graph::files(&tree);
    assert_eq!(needs["math/mod.rs"].len(), 0);
    assert_eq!(needs["math/c.rs"].iter().copied().collect::<Vec<_>>(), ["math/a.rs"]);
    assert_eq!(needs["math/c_tests.rs"].iter().copied().collect::<Vec<_>>(), ["math/c.rs"]);
    assert_eq!(graph::circles(&needs), [["math/a.rs", "math/b.rs"]]);
}

#[test]
fn methods_in_circles_are_found() {
    let tree = crate_of(&[
        ("lib.rs", "pub mod math;"),
        ("math/mod.rs", "pub struct A; mod a; mod b; mod c;"),
        ("math/a.rs", "impl super::A { pub fn first(&self) { assert!(self.second()); } }"),
        ("math/b.rs", "use super::A; impl A { pub fn second(&self) -> bool { Self::third() } }"),
        (
            "math/c.rs",
            "use crate::math::A; impl A { pub fn third() -> bool { true } fn f(&self) { self.first() } }",
        ),
    ]);
    let needs = graph::by_methods(&tree);
    assert_eq!(needs.keys().collect::<Vec<_>>(), ["math::A"]);
    assert_eq!(graph::circles(&needs["math::A"]), [["math/a.rs", "math/b.rs", "math/c.rs"]]);
}
