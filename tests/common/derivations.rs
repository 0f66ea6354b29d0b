//! Every line of a derivation judged: by the language, and by the checker of lecture notes, which
//! knows only the lines themselves.

use polarform::diagnostic::Code;
use polarform::document::{Container, document};
use polarform::expr::{Expr, Kind, Rel};
use polarform::judge::finding::Verdict as NotesVerdict;
use polarform::notes::{Options, check_document};
use polarform::session::Session;
use polarform::source::SourceFile;
use polarform::value::{Derivation, Value, Verdict};
use polarform::write::{latex, text};

pub fn run(session: &mut Session, statement: &str) -> Value {
    session.run(statement).unwrap_or_else(|f| panic!("{statement}: {:?}", f.problem)).outcome.value
}

/// What `derive(…)` gives after some definitions.
pub fn derived(context: &[String], query: &str) -> Derivation {
    let mut session = Session::default();
    context.iter().for_each(|statement| drop(run(&mut session, statement)));
    match run(&mut session, query) {
        Value::Derivation(derivation) => (*derivation).clone(),
        other => panic!("{query}: {other:?}"),
    }
}

/// The formulas of a line, one after the other.
pub fn formulas(formula: &Expr) -> &[Expr] {
    match &formula.kind {
        Kind::Sequence(items) => items,
        _ => std::slice::from_ref(formula),
    }
}

/// Each line is a definition whose further sides are equal, or a claim that is true, in the
/// language with these definitions. Gives the number of equations that were proved.
pub fn assert_true(query: &str, context: &[String], derivation: &Derivation) -> usize {
    let mut session = Session::default();
    context.iter().for_each(|statement| drop(run(&mut session, statement)));
    let mut proved = 0;
    for formula in derivation.lines.iter().flat_map(|line| formulas(&line.formula)) {
        let mut shown = text(formula);
        let mut answer = session.run(&shown);
        // Beside f, the language takes f_3(…) = … for a definition only if that is said.
        if let (Err(failure), Kind::Chain(left, links)) = (&answer, &formula.kind)
            && failure.problem.code == Code::AmbiguousProduct
        {
            let definition = Expr::relation((**left).clone(), Rel::Define, links[0].expr.clone());
            run(&mut session, &text(&definition));
            if links.len() == 1 {
                continue;
            }
            shown = text(&Kind::Chain(Box::new(links[0].expr.clone()), links[1..].to_vec()).into());
            answer = session.run(&shown);
        }
        let answer = answer.unwrap_or_else(|f| panic!("{query}: {shown}: {:?}", f.problem));
        let doubts = answer.outcome.notes.iter().any(|note| note.code == Code::Undecided);
        assert!(!doubts, "{query}: {shown}: {:?}", answer.outcome.notes);
        match &answer.outcome.value {
            Value::Claim(claim) => {
                let all = claim.judgements.iter().all(|judgement| judgement.verdict == Verdict::Proved);
                assert!(all, "{query}: {shown}: {claim:?}");
                proved += claim.judgements.len();
            }
            _ => assert!(answer.outcome.defined.is_some(), "{query}: {shown} says nothing"),
        }
    }
    proved
}

/// Each line is a definition or proved in a file of notes that has them as displays.
pub fn assert_true_in_notes(query: &str, before: &str, derivation: &Derivation) {
    let mut page = format!("# Derivation\n\n{before}\n\n");
    for line in &derivation.lines {
        page += &format!("$${}$$\n\n", latex(&line.formula));
    }
    let report = check_document(
        &document(SourceFile::new("notes.md", page.clone()), Container::Markdown),
        &Options::default(),
    );
    assert!(report.problems.is_empty(), "{query}: {:?}", report.problems);
    assert!(report.findings.len() >= derivation.lines.len(), "{query}");
    for finding in &report.findings {
        let fine = matches!(finding.verdict, NotesVerdict::Proved | NotesVerdict::Definition);
        assert!(fine, "{query}: {} is {}: {finding:?}", finding.latex, finding.verdict.word());
    }
}
