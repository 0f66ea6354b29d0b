//! Files: missing ones, included ones, other encodings.

use std::fs;
use std::path::PathBuf;

use super::*;

/// The file itself, without those that it includes.
fn read_file(path: &std::path::Path) -> Result<Document, crate::language::diagnostic::Diagnostic> {
    Ok(read_files(path, &Reading::default())?.swap_remove(0))
}

/// A folder of its own, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &[u8])]) -> Folder {
        let path = std::env::temp_dir().join(format!("polarform-{}-{name}", std::process::id()));
        for (file, content) in files {
            let file = path.join(file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, content).unwrap();
        }
        Folder(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Nothing depends on it.
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn found(notes: &[Document]) -> Vec<(String, Vec<&str>)> {
    let name = |notes: &Document| notes.file.name().rsplit(['/', '\\']).next().unwrap().to_owned();
    notes
        .iter()
        .map(|notes| {
            (name(notes), formulas(notes).into_iter().map(|formula| formula.text.as_str()).collect())
        })
        .collect()
}

#[test]
fn included_files() {
    let folder = Folder::new(
        "include",
        &[
            ("main.tex", b"\\input{macros}\n\\begin{document}\n$a$ \\include{parts/one} $\\y$\\input macros\n\\end{document}"),
            ("macros.tex", b"$no$ \\newcommand{\\x}{X}"),
            ("parts/one.tex", b"$\\x$ \\newcommand{\\y}{Y} \\input{two} \\subfile{three.tex}"),
            ("parts/two.tex", b"$two$"),
            ("parts/three.tex", b"\\documentclass{subfiles} $no$\n\\begin{document}\n$three$\n\\end{document}"),
        ],
    );
    let all = read_files(&folder.0.join("main.tex"), &Reading::default()).unwrap();
    let wanted: [(&str, Vec<&str>); 5] = [
        ("main.tex", vec!["a", "Y"]),
        ("macros.tex", vec![]),
        ("one.tex", vec!["X"]),
        ("two.tex", vec!["two"]),
        ("three.tex", vec!["three"]),
    ];
    assert_eq!(found(&all), wanted.map(|(name, formulas)| (name.to_owned(), formulas)));
    assert!(all.iter().all(|notes| notes.problems.is_empty()));
    let alone = read_file(&folder.0.join("main.tex")).unwrap();
    assert_eq!(found(&[alone])[0].1, ["a", "Y"]);
}

#[test]
fn inclusions_that_fail() {
    let folder = Folder::new(
        "cycle",
        &[
            ("a.tex", b"$a$ \\input{b}\n\\input{nowhere} $c$"),
            ("b.tex", b"$b$\\input{a}"),
            ("n.tex", b"\\input{bin}"),
            ("bin.tex", b"\0"),
        ],
    );
    let all = read_files(&folder.0.join("a.tex"), &Reading::default()).unwrap();
    assert_eq!(found(&all).into_iter().map(|notes| notes.1).collect::<Vec<_>>(), [vec!["a", "c"], vec!["b"]]);
    let place = |notes: &Document| {
        let problem = &notes.problems[0];
        assert_eq!((problem.code, notes.problems.len()), (Code::Include, 1));
        notes.file.line_column(problem.span.unwrap().start)
    };
    assert_eq!(place(&all[0]), (2, 1));
    assert_eq!(place(&all[1]), (1, 4));
    assert_eq!(place(&read_file(&folder.0.join("n.tex")).unwrap()), (1, 1));
}

#[test]
fn files_that_cannot_be_read() {
    let folder = Folder::new("bad", &[("x.md", b"PK\0\0")]);
    for (path, code, words) in [
        (folder.0.join("none.md"), Code::File, "no such file"),
        (folder.0.clone(), Code::File, "directory"),
        (folder.0.join("x.md"), Code::Encoding, "not a text file"),
    ] {
        let problem = read_file(&path).unwrap_err();
        assert_eq!(problem.code, code);
        assert!(problem.message.contains(words) && !problem.hints.is_empty(), "{problem:?}");
    }
}

#[test]
fn kinds_that_are_not_read() {
    let folder =
        Folder::new("foreign", &[("a.typ", b"$ a = b $"), ("b.xyz", b"$b$"), ("c.rst", b":math:`c`")]);
    let typst = read_file(&folder.0.join("a.typ")).unwrap_err();
    assert_eq!(typst.code, Code::FileKind);
    assert!(typst.message.contains("Typst is not read") && typst.hints[0].contains("pandoc"), "{typst:?}");
    let unknown = read_file(&folder.0.join("b.xyz")).unwrap_err();
    assert!(unknown.message.contains(".xyz") && unknown.hints[0].contains("--as"), "{unknown:?}");
    let named = read_files(
        &folder.0.join("b.xyz"),
        &Reading { kind: Some(Container::Markdown), ..Reading::default() },
    )
    .unwrap();
    assert_eq!(found(&named)[0].1, ["b"]);
    assert_eq!(found(&[read_file(&folder.0.join("c.rst")).unwrap()])[0].1, ["c"]);
    let missing = read_file(&folder.0.join("none.typ")).unwrap_err();
    assert_eq!(missing.code, Code::File);
}

#[test]
fn text_from_elsewhere() {
    let notes =
        read_text("standard input", b"$a$".to_vec(), Container::Markdown, &Macros::default()).unwrap();
    assert_eq!((notes.file.name(), formulas(&notes).len()), ("standard input", 1));
    assert_eq!(
        read_text("x", b"\0".to_vec(), Container::Markdown, &Macros::default()).unwrap_err().code,
        Code::Encoding
    );
}

#[test]
fn a_file_beyond_the_limit() {
    let folder = Folder::new("long", &[("x.md", b"")]);
    let path = folder.0.join("x.md");
    fs::File::create(&path).and_then(|file| file.set_len(MAX_BYTES + 1)).unwrap();
    let problem = read_file(&path).unwrap_err();
    assert!(problem.code == Code::File && problem.message.contains("64 MiB"), "{problem:?}");
}

#[test]
fn kinds_of_files() {
    let folder = Folder::new(
        "kinds",
        &[
            ("a.md", b"\xef\xbb\xbf$a$"),
            ("b.TEX", b"$b % $\n$"),
            ("c", b"*x* $c$"),
            ("d.txt", b"Fl\xe4che $d$\r$e$"),
        ],
    );
    let texts = |name: &str| {
        let notes = read_file(&folder.0.join(name)).unwrap();
        formulas(&notes)
            .into_iter()
            .map(|formula| (formula.text.clone(), notes.file.line_column(formula.span.start)))
            .collect::<Vec<_>>()
    };
    assert_eq!(texts("a.md"), [("a".to_owned(), (1, 2))]);
    assert_eq!(texts("b.TEX"), [("b".to_owned(), (1, 2))]);
    assert_eq!(texts("c"), [("c".to_owned(), (1, 6))]);
    assert_eq!(texts("d.txt"), [("d".to_owned(), (1, 9)), ("e".to_owned(), (2, 2))]);
}

#[test]
fn files_that_pages_include() {
    let folder = Folder::new(
        "pages",
        &[
            ("book/a.md", b"$\\x$\n\n```{include} parts/b.md\n:relative-docs: x\n```\n\n:::{include} /c.md\n:::\n\n$a$\n"),
            ("book/parts/b.md", b"$\\newcommand{\\x}{X}$ $b$\n\n{{< include d.qmd >}}\n{{#include ../a.md}}\n"),
            ("c.md", b"$c$ `{{#include no.md}}` \\{{#include no.md}}\n\n```\n{{#include no.md}}\n```\n"),
            ("book/parts/d.qmd", b"$d$\n"),
            ("e.rst", b":math:`e`\n\n.. include:: book/parts/f.rst\n\n.. include:: no.rst\n   :literal:\n"),
            ("book/parts/f.rst", b":math:`f`\n"),
            ("g.md", b"{{#include c.md:3}} {{#include no.md}} {{< include a.html >}}\n\n```{include} c.md\n:start-line: 2\n```\n$g$\n"),
        ],
    );
    let all = read_files(&folder.0.join("book/a.md"), &Reading::default()).unwrap();
    let wanted = [
        ("a.md".to_owned(), vec!["X", "a"]),
        ("b.md".to_owned(), vec!["b"]),
        ("d.qmd".to_owned(), vec!["d"]),
        ("c.md".to_owned(), vec!["c"]),
    ];
    assert_eq!(found(&all), wanted);
    let told: Vec<&str> = all.iter().flat_map(|notes| &notes.problems).map(|p| p.message.as_str()).collect();
    assert_eq!(told, ["../a.md includes itself"]);
    let all = read_files(&folder.0.join("e.rst"), &Reading::default()).unwrap();
    assert_eq!(found(&all), [("e.rst".to_owned(), vec!["e"]), ("f.rst".to_owned(), vec!["f"])]);
    let all = read_files(&folder.0.join("g.md"), &Reading::default()).unwrap();
    assert_eq!(found(&all), [("g.md".to_owned(), vec!["g"])]);
    let codes: Vec<Code> = all[0].problems.iter().map(|problem| problem.code).collect();
    assert_eq!(codes, [Code::Include; 4]);
    let text = read_text(
        "standard input",
        b"{{< include a.qmd >}} $a$\n".to_vec(),
        Container::Markdown,
        &Macros::default(),
    )
    .unwrap();
    assert_eq!((formulas(&text).len(), text.problems[0].code), (1, Code::Include));
}
