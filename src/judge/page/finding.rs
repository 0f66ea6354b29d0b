//! What comes of a file of notes: one finding for each relation.

use crate::formula::Expr;
use crate::formula::source::{SourceFile, Span};
use crate::judge::page::statement::{Chain, Side};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::write;

/// What is said of a relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Verdict {
    /// Introduces a name, a value for one, or a condition; used afterwards.
    Definition,
    /// An exact identity, for all values of its symbols.
    Proved,
    /// A family: exact for every instance tried.
    Sampled,
    /// Wrong, with a counterexample.
    Refuted,
    /// Read, but a condition or a definition is missing.
    Undecided,
    /// Outside what the reader knows.
    Unread,
}

impl Verdict {
    /// All verdicts, in the order of reports.
    pub const ALL: [Verdict; 6] = [
        Verdict::Definition,
        Verdict::Proved,
        Verdict::Sampled,
        Verdict::Refuted,
        Verdict::Undecided,
        Verdict::Unread,
    ];

    /// The word used in reports.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Definition => "definition",
            Verdict::Proved => "proved",
            Verdict::Sampled => "sampled",
            Verdict::Refuted => "refuted",
            Verdict::Undecided => "undecided",
            Verdict::Unread => "unread",
        }
    }
}

/// What shows that a relation that fails is wrong, and not only read otherwise than it was meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// A small change of it gives a truth.
    Near,
    /// It is said to hold for all values of its letters.
    ForAll,
    /// It speaks of what the field, or the page, determines.
    Field,
    /// All facts about its functions leave it open.
    Facts,
    /// Nothing in it needs a meaning.
    Closed,
    /// It calculates with numbers, or says x = x + 1.
    Calculation,
    /// It is the value of a function that is given right there.
    Value,
    /// It writes any function by its own values or derivatives.
    Expansion,
    /// Its sides agree in most of their terms.
    Terms,
    /// Other relations of the page hold with every name in it.
    Names,
}

impl Evidence {
    /// The words used in reports.
    pub fn words(self) -> &'static str {
        match self {
            Evidence::Near => "a small change makes it true",
            Evidence::ForAll => "it is said of all values",
            Evidence::Field => "what it speaks of is determined",
            Evidence::Facts => "what is said of its functions leaves it open",
            Evidence::Closed => "nothing in it needs a meaning",
            Evidence::Calculation => "it is a calculation",
            Evidence::Value => "the function is given right there",
            Evidence::Expansion => "it would hold for any function",
            Evidence::Terms => "most of its terms agree",
            Evidence::Names => "all that is said besides with its names holds",
        }
    }
}

/// One relation of a file with its verdict. A formula without a relation has one finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Both sides of the relation in the file.
    pub span: Span,
    /// What the caret points at: the relation sign, or the side that is wrong.
    pub mark: Span,
    /// Both sides as written.
    pub latex: String,
    /// How it was understood, printed anew as LaTeX.
    pub reading: String,
    /// Counted from 1 in its chain; 0 for a formula without a relation.
    pub relation: usize,
    /// The verdict.
    pub verdict: Verdict,
    /// Why.
    pub reason: Option<String>,
    /// A counterexample: "n = 2, i = 1, t = 1/2: left 1/4, right 0".
    pub witness: Option<String>,
    /// The likely repair, as LaTeX that can be pasted over the relation.
    pub suggestion: Option<String>,
    /// Which instances were tried, if it is a family: "54 instances: n from 0 to 6, …".
    pub instances: Option<String>,
    /// Something suspicious that is no refutation.
    pub warning: Option<String>,
    /// What shows that it is wrong, if it was refuted on a page.
    pub evidence: Vec<Evidence>,
    /// Whether hypotheses were solved for what it speaks of.
    pub determined: bool,
    /// Meanings that were assumed: "B_i^n is the Bernstein polynomial".
    pub notes: Vec<String>,
}

impl Finding {
    /// A finding that says nothing yet: undecided, without reasons.
    pub fn new(span: Span, mark: Span, latex: String, reading: String, relation: usize) -> Self {
        Finding {
            span,
            mark,
            latex,
            reading,
            relation,
            verdict: Verdict::Undecided,
            reason: None,
            witness: None,
            suggestion: None,
            instances: None,
            warning: None,
            evidence: Vec::new(),
            determined: false,
            notes: Vec::new(),
        }
    }

    /// Whether a person should look at it.
    pub fn is_suspicious(&self) -> bool {
        self.verdict == Verdict::Refuted || self.warning.is_some()
    }
}

/// All findings of a file.
#[derive(Clone, Debug)]
pub struct FileReport {
    /// The file.
    pub file: SourceFile,
    /// Its relations in order.
    pub findings: Vec<Finding>,
    /// What is wrong with the file itself.
    pub problems: Vec<Diagnostic>,
    /// How many findings and problems are not reported, as they are ignored or known.
    pub left_out: usize,
}

impl FileReport {
    /// A report of which nothing is left out.
    pub fn new(file: SourceFile, findings: Vec<Finding>, problems: Vec<Diagnostic>) -> Self {
        FileReport { file, findings, problems, left_out: 0 }
    }

    /// Whether something is wrong with the file as a whole, so that there is nothing in it.
    pub fn is_broken(&self) -> bool {
        let broken = |problem: &Diagnostic| problem.code == Code::BrokenNotebook;
        self.findings.is_empty() && self.problems.iter().any(broken)
    }

    /// How many findings have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.findings.iter().filter(|finding| finding.verdict == verdict).count()
    }
}

/// A finding for a relation, not judged yet.
pub fn blank(chain: &Chain, at: usize) -> Finding {
    let (left, right) = (&chain.sides[at], &chain.sides[at + 1]);
    let (rel, sign) = chain.relations[at];
    let sign_text = write::latex(&Expr::relation(Expr::name("a"), rel, Expr::name("b")));
    let sign_text = sign_text.trim_start_matches('a').trim_end_matches('b').trim().to_owned();
    let reading = Expr::relation(left.expr.clone(), rel, right.expr.clone());
    let latex = format!("{} {} {}", left.latex, sign_text, right.latex);
    let span = left.expr.span.to(sign).to(right.expr.span);
    Finding::new(span, sign, latex, write::latex(&reading), at + 1)
}

/// The finding for a formula that states nothing.
pub(in crate::judge) fn without_statement(side: &Side) -> Finding {
    let reason = Some("it states nothing to check".to_owned());
    Finding { reason, ..of_side(side, Verdict::Undecided, 0) }
}

/// A finding for a formula without a relation.
pub fn of_side(side: &Side, verdict: Verdict, relation: usize) -> Finding {
    let span = side.expr.span;
    let finding = Finding::new(span, span, side.latex.clone(), write::latex(&side.expr), relation);
    Finding { verdict, ..finding }
}
