//! The project's lecture notes: every result and picture in them is what the program computes, and
//! every formula is proved, sampled or a definition.

use std::path::{Path, PathBuf};

use polarform::document::Item;
use polarform::document::{Reading, read_files};
use polarform::judge::finding::{Finding, Verdict};
use polarform::notes::{Options as CheckOptions, check_document};
use polarform::source::SourceFile;
use polarform::weave::{Options, PACKAGE, side_name, weave_latex, weave_markdown, write_file};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/notes")
}

fn chapters() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder()).expect("the notes are there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("it is readable").path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    files.sort();
    assert!(files.len() >= 14, "{files:?}");
    files
}

fn name(path: &Path) -> String {
    path.file_name().expect("it is a file").to_string_lossy().into_owned()
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn results_and_pictures_are_up_to_date() {
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut pictures = Vec::new();
    for path in chapters() {
        let text = read(&path);
        let source = SourceFile::new(name(&path), text.as_str());
        let stem = path.file_stem().expect("it is a file").to_string_lossy().into_owned();
        let options = Options { fresh: true, pictures: Some(format!("{stem}-figure")), ..Options::default() };
        let woven = weave_markdown(&source, &options);
        let problems: Vec<_> = woven.problems.iter().map(|failure| &failure.problem).collect();
        assert!(!woven.failed && woven.refuted == 0, "{}: {problems:#?}", path.display());
        if update {
            write_file(&path, &woven.text).expect("the notes are writable");
        } else {
            let stale: Vec<&str> = woven.stale.iter().map(|(file, span)| file.slice(*span)).collect();
            assert!(woven.text == text, "{}: UPDATE_DOCS=1 weaves anew {stale:?}", path.display());
        }
        for (file, svg) in woven.pictures {
            let target = folder().join(&file);
            if update {
                write_file(&target, &svg).expect("the figures are writable");
            }
            assert!(read(&target) == svg, "{file} is out of date: UPDATE_DOCS=1 draws it anew");
            pictures.push(file.trim_start_matches("figures/").to_owned());
        }
    }
    pictures.sort();
    let entries = std::fs::read_dir(folder().join("figures")).expect("the figures are there");
    let mut files: Vec<String> = entries.map(|entry| name(&entry.expect("it is readable").path())).collect();
    files.sort();
    assert_eq!(files, pictures, "each figure is drawn by a block");
}

#[test]
fn every_formula_is_right() {
    let mut statements = 0;
    for path in chapters() {
        for document in read_files(&path, &Reading::default()).expect("the notes are readable") {
            let report = check_document(&document, &CheckOptions::default());
            assert!(report.problems.is_empty(), "{}: {:#?}", path.display(), report.problems);
            let unread = |finding: &&Finding| finding.verdict == Verdict::Unread;
            let (said, bare): (Vec<&Finding>, Vec<&Finding>) =
                report.findings.iter().partition(|finding| finding.relation > 0);
            let good = [Verdict::Proved, Verdict::Sampled, Verdict::Definition];
            let bad: Vec<_> = said.iter().filter(|finding| !good.contains(&finding.verdict)).collect();
            assert!(bad.is_empty(), "{}: {bad:#?}", path.display());
            assert_eq!(bare.into_iter().find(unread), None, "{}", path.display());
            let suspicious: Vec<_> = said.iter().filter(|finding| finding.is_suspicious()).collect();
            assert!(suspicious.is_empty(), "{}: {suspicious:#?}", path.display());
            statements += said.len();
        }
    }
    assert!(statements > 350, "only {statements} statements were found");
}

#[test]
fn a_real_renderer_accepts_every_formula() {
    let options = katex::Opts::builder().output_type(katex::OutputType::Mathml).build().expect("all is set");
    for path in chapters() {
        for document in read_files(&path, &Reading::default()).expect("the notes are readable") {
            for item in &document.items {
                let Item::Formula(formula) = item else { continue };
                if let Err(error) = katex::render_with_opts(&formula.text, &options) {
                    panic!("{}: {}: {error}", path.display(), formula.text);
                }
            }
        }
    }
}

#[test]
fn all_chapters_are_listed() {
    let contents = read(&folder().join("README.md"));
    for path in chapters() {
        let name = name(&path);
        assert!(name == "README.md" || contents.contains(&format!("({name})")), "{name} is not listed");
    }
}

#[test]
fn the_lecture_of_two_pages_is_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/lecture");
    let path = folder.join("composition.tex");
    let source = SourceFile::new("composition.tex", read(&path));
    let side = side_name(&path);
    let before = read(&side);
    let woven = weave_latex(&source, &before, &mut |_| None, &Options { fresh: true, ..Options::default() });
    assert!(!woven.failed && woven.refuted == 0, "{:?}", woven.problems);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        write_file(&side, &woven.text).expect("the results are writable");
        write_file(&folder.join("polarform.sty"), PACKAGE).expect("the package is writable");
    }
    assert!(read(&side) == woven.text, "UPDATE_DOCS=1 weaves anew; then run pdflatex");
    assert!(read(&folder.join("polarform.sty")) == PACKAGE, "UPDATE_DOCS=1 writes the package anew");

    // Equations to be solved are no claims.
    for document in read_files(&path, &Reading::default()).expect("the lecture is readable") {
        let report = check_document(&document, &CheckOptions::default());
        let bad = [Verdict::Refuted, Verdict::Unread];
        let wrong: Vec<_> = report.findings.iter().filter(|finding| bad.contains(&finding.verdict)).collect();
        assert!(wrong.is_empty() && report.problems.is_empty(), "{wrong:#?} {:?}", report.problems);
        let open = |f: &&Finding| f.relation > 0 && f.verdict == Verdict::Undecided;
        assert_eq!(report.findings.iter().filter(open).count(), 3, "F(G(t)) = 0, t^3 = -1, t^3 = -3");
    }
}
