//! Weaving a file with 200 results: everything run, and nothing changed.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use polarform::source::SourceFile;
use polarform::weave::{Mode, Options, weave_latex, weave_markdown};

/// A lecture with 200 results: in each of 40 sections a definition, a table of values, a derivation,
/// and two formulas in the text.
fn lecture() -> String {
    let mut text = String::from("# Polar forms\n\nWords before the first section.\n");
    for section in 1..=40 {
        let (a, b) = (section % 7 + 1, section % 5 + 2);
        write!(
            text,
            "\n## Section {section}\n\nLet $F(t) = {a} t^3 + {b} t$, as in the section before.\n\n\
             ```polarform\nF(t) := {a} t^3 + {b} t\nf := polar(F)\n```\n\n\
             Then $f(0, 1, \\frac12) = {{{{ f(0, 1, 1/2) }}}}$ and ${{{{ f(r, s, t) }}}}$.\n\n\
             ```polarform steps=true hide=true\npolar(F)\n```\n",
        )
        .expect("memory takes everything");
    }
    text
}

fn weave(c: &mut Criterion) {
    let mut group = c.benchmark_group("weave");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    let text = lecture();
    group.throughput(Throughput::Elements(200));
    let source = SourceFile::new("lecture.md", text.as_str());
    let options = Options::default();
    let woven = weave_markdown(&source, &options);
    assert_eq!((woven.results, woven.failed), (200, false));
    group.bench_function("200 results", |b| b.iter(|| weave_markdown(black_box(&source), &options)));
    let template = Options { mode: Mode::Template, ..Options::default() };
    group.bench_function("200 results, a copy", |b| b.iter(|| weave_markdown(black_box(&source), &template)));
    let settled = SourceFile::new("lecture.md", woven.text);
    assert!(weave_markdown(&settled, &options).unchanged);
    group.bench_function("nothing changed", |b| b.iter(|| weave_markdown(black_box(&settled), &options)));
    group.finish();
}

/// The same as a LaTeX document.
fn latex(c: &mut Criterion) {
    let mut group = c.benchmark_group("weave LaTeX");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    let mut text = String::from("\\documentclass{article}\n\\usepackage{polarform}\n\\begin{document}\n");
    for section in 1..=50 {
        write!(
            text,
            "\\section{{{section}}}\n\\begin{{polarform}}\nf := polar(t^3 + {section} t)\nf(0, 1, 2)\n\
             \\end{{polarform}}\nso $f = \\polarform{{f(r, s, t)}}$ and \\polarform{{f(t, t, hat(1))}}.\n",
        )
        .expect("memory takes everything");
    }
    text.push_str("\\end{document}\n");
    let document = SourceFile::new("lecture.tex", text);
    let options = Options::default();
    let woven = weave_latex(&document, "", &mut |_| None, &options);
    assert_eq!((woven.results, woven.failed), (200, false));
    group.throughput(Throughput::Elements(200));
    group.bench_function("200 results", |b| {
        b.iter(|| weave_latex(black_box(&document), "", &mut |_| None, &options));
    });
    group.bench_function("nothing changed", |b| {
        b.iter(|| weave_latex(black_box(&document), &woven.text, &mut |_| None, &options));
    });
    group.finish();
}

criterion_group!(benches, weave, latex);
criterion_main!(benches);
