//! Running the queries of a file, one after the other, in one session.

use super::options::{BlockOptions, Show};
use super::render::{Piece, render, words_as_text};
use crate::formula::source::{Pieces, SourceFile, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::language::derive::{self, Combination};
use crate::language::diagnostic::{Code, Diagnostic, Severity};
use crate::language::eval::Equals;
use crate::language::syntax;
use crate::language::value::{Claim, Line, PolarKind, Value, Verdict, symbol_expr};
use crate::language::write::verdict_in_words;
use crate::math::blossom::Method;
use crate::math::poly::Symbol;
use crate::session::{Answer, Failure, Session, guarded, read};

/// Where the bytes of a query stand in its file.
pub(super) type Place<'a> = dyn Fn(Span) -> Span + 'a;

/// A session, and what it has found wrong so far.
#[derive(Default)]
pub(super) struct Runner {
    session: Session,
    pub(super) problems: Vec<Failure>,
    /// How many claims are refuted.
    pub(super) refuted: usize,
    /// How many results there are.
    pub(super) results: usize,
    /// How many of them define a name.
    pub(super) definitions: usize,
    /// What the names of picture files begin with; `None` where pictures go into the text.
    beside: Option<String>,
    /// The pictures: file and contents.
    pub(super) pictures: Vec<(String, String)>,
}

impl Runner {
    pub(super) fn new(session: Session) -> Self {
        Runner { session, ..Runner::default() }
    }

    /// Puts pictures into files whose names begin so.
    pub(super) fn with_pictures(mut self, beside: Option<&str>) -> Self {
        self.beside = beside.map(str::to_owned);
        self
    }

    /// Gives a picture its file.
    fn placed(&mut self, piece: &mut Piece, options: &BlockOptions) {
        let (Piece::Picture(picture), Some(prefix)) = (piece, &self.beside) else { return };
        let taken = |name: &String| self.pictures.iter().any(|(file, _)| file == name);
        let wanted = options.picture.as_ref().map(|name| format!("{name}.svg"));
        let numbered = |k: usize| match &options.picture {
            Some(name) => format!("{name}-{k}.svg"),
            None => format!("{prefix}-{k}.svg"),
        };
        let free = (1..).map(numbered).find(|name| !taken(name));
        if let Some(name) = wanted.filter(|name| !taken(name)).or(free) {
            self.pictures.push((name.clone(), picture.svg.clone()));
            picture.file = Some(name);
        }
    }

    /// Notes a problem of a file.
    pub(super) fn problem(&mut self, problem: Diagnostic, file: &SourceFile) {
        self.problems.push(Failure { problem, file: file.clone() });
    }

    /// Whether something could not be read, evaluated or decided.
    pub(super) fn failed(&self) -> bool {
        self.problems.iter().any(|Failure { problem, .. }| {
            problem.severity == Severity::Error && problem.code != Code::Refuted
        })
    }

    /// The result of a query within a line; nothing if it fails.
    pub(super) fn query(
        &mut self,
        code: &str,
        file: &SourceFile,
        place: &Place,
        options: &BlockOptions,
    ) -> Option<Piece> {
        let inner = SourceFile::new(file.name(), code);
        if syntax::statements(code).is_ok_and(|statements| statements.is_empty())
            && let Err(problem) = read(&inner, None)
        {
            // An empty query has no byte of its own; the blanks in it will do.
            let problem = Diagnostic { span: Some(Span::new(0, code.len())), ..problem };
            self.found(problem, file, place);
            return None;
        }
        let piece = self.block(code, file, place, options)?.pop();
        if matches!(piece, Some(Piece::Picture(_))) {
            let problem = Diagnostic::error(Code::Unsupported, "a figure does not stand within a line")
                .at(Span::new(0, code.len()))
                .hint("put it into a block of its own: ```polarform, in LaTeX \\begin{polarform}");
            self.found(problem, file, place);
            return None;
        }
        piece
    }

    /// The results of the statements of a block; nothing if one of them fails. The others are run.
    pub(super) fn block(
        &mut self,
        code: &str,
        file: &SourceFile,
        place: &Place,
        options: &BlockOptions,
    ) -> Option<Vec<Piece>> {
        let inner = SourceFile::new(file.name(), code);
        let mut session = std::mem::take(&mut self.session);
        session.arrangement = options.arrange;
        let mut pieces = Some(Vec::new());
        let mut defined = Vec::new();
        let drawn = self.pictures.len();
        session.run_file(&inner, |session, result| {
            let piece = result.map_err(|failure| failure.problem).and_then(|answer| {
                for note in &answer.outcome.notes {
                    self.found(note.clone(), file, place);
                }
                if let Value::Claim(claim) = &answer.outcome.value {
                    self.judged(claim, answer.statement.span, file, place);
                }
                self.definitions += usize::from(answer.outcome.defined.is_some());
                defined.extend(answer.outcome.defined.clone());
                let span = answer.statement.span;
                let piece = self.shown(session, &answer, options).map_err(|problem| problem.at(span))?;
                self.results += 1;
                Ok(piece)
            });
            match piece {
                Ok(mut piece) => {
                    self.placed(&mut piece, options);
                    pieces.iter_mut().for_each(|pieces: &mut Vec<Piece>| pieces.push(piece.clone()));
                }
                Err(problem) => {
                    self.found(problem, file, place);
                    pieces = None;
                }
            }
            true
        });
        if pieces.is_none() {
            // What follows must not get the old value of a name whose new definition failed.
            for name in names_defined(code).filter(|name| !defined.contains(name)) {
                session.env.remove(&name);
            }
            self.pictures.truncate(drawn);
        }
        self.session = session;
        let mut pieces = pieces?;
        match options.show {
            Show::All => {}
            Show::Last => drop(pieces.drain(..pieces.len().saturating_sub(1))),
            Show::Nothing => pieces.clear(),
        }
        Some(pieces)
    }

    fn shown(&self, session: &Session, answer: &Answer, options: &BlockOptions) -> Result<Piece, Diagnostic> {
        guarded(&session.limits, || {
            let lines = match options.steps {
                Some(method) => steps(session, answer, method),
                None => Vec::new(),
            };
            render(answer, &lines, options)
        })
    }

    fn judged(&mut self, claim: &Claim, span: Span, file: &SourceFile, place: &Place) {
        let (verdict, code) = match claim.verdict() {
            Verdict::Proved | Verdict::Sampled => return,
            Verdict::Refuted => (Verdict::Refuted, Code::Refuted),
            Verdict::Undecided => (Verdict::Undecided, Code::Undecided),
        };
        self.refuted += usize::from(verdict == Verdict::Refuted);
        let what =
            if verdict == Verdict::Refuted { "this claim is false" } else { "this claim is undecided" };
        let mut problem = Diagnostic::error(code, what).at(span);
        if let Some(judgement) = claim.judgements.iter().find(|judgement| judgement.verdict == verdict) {
            problem = problem.reason(words_as_text(&verdict_in_words(judgement)));
            problem.hints.extend(judgement.reasons.iter().cloned());
        }
        if problem.hints.is_empty() {
            problem = problem.hint(match verdict {
                Verdict::Refuted => "correct it, or write the left side alone to get its value",
                _ => "give the symbols values, or state the condition",
            });
        }
        self.found(problem, file, place);
    }

    /// Notes a problem of a query, where it stands in the file.
    fn found(&mut self, mut problem: Diagnostic, file: &SourceFile, place: &Place) {
        problem.span = problem.span.map(place);
        for label in &mut problem.labels {
            label.span = place(label.span);
        }
        self.problem(problem, file);
    }
}

/// The names that statements define with `:=`.
fn names_defined(code: &str) -> impl Iterator<Item = Symbol> {
    let spans = syntax::statements(code).unwrap_or_default();
    let exprs = spans.into_iter().filter_map(move |span| syntax::parse(code.piece(span.range())).ok());
    exprs.filter_map(|expr| {
        let Kind::Chain(left, links) = expr.kind else { return None };
        let head = match left.kind {
            Kind::Apply(callee, _) => *callee,
            _ => *left,
        };
        match (&head.kind, links[0].rel) {
            (Kind::Name(name), Rel::Define) => Some(Symbol::new(name)),
            (Kind::Subscript(base, indices), Rel::Define) => match (&base.kind, indices.as_slice()) {
                (Kind::Name(name), [Expr { kind: Kind::Number(i), .. }]) => {
                    i.numer().as_small().map(|i| Symbol::indexed(name, i))
                }
                _ => None,
            },
            _ => None,
        }
    })
}

/// The derivation of the value of an answer; empty if it has none.
fn steps(session: &Session, answer: &Answer, method: Method) -> Vec<Line> {
    let forms = match &answer.outcome.value {
        Value::Polar(polar) => vec![polar.clone()],
        // A curve is derived coordinate by coordinate.
        Value::List(items) => items
            .iter()
            .map(|item| if let Value::Polar(polar) = item { Some(polar.clone()) } else { None })
            .collect::<Option<Vec<_>>>()
            .unwrap_or_default(),
        _ => Vec::new(),
    };
    let (call, name) = asked(answer);
    let mut lines = match (combined(session, call), forms.as_slice()) {
        (_, []) => return Vec::new(),
        (Some((kind, Value::Polar(f), Value::Polar(g))), [result]) => match (&f.kind, &g.kind) {
            (PolarKind::Univariate(f), PolarKind::Univariate(g)) => {
                derive::combination(kind, f, g, result).lines
            }
            _ => derive::polar_of_curve(&forms, method).lines,
        },
        _ => derive::polar_of_curve(&forms, method).lines,
    };
    rename(&mut lines, call, name);
    lines
}

/// The formula that was evaluated, and the name that it was given.
fn asked(answer: &Answer) -> (&Expr, Option<Expr>) {
    let call = match &answer.statement.kind {
        Kind::Chain(_, links) => links.last().map_or(&answer.statement, |link| &link.expr),
        _ => &answer.statement,
    };
    (call, answer.outcome.defined.as_ref().map(symbol_expr))
}

fn callee(call: &Expr) -> Option<(&str, &[Expr])> {
    let Kind::Apply(callee, groups) = &call.kind else { return None };
    match (&callee.kind, groups.as_slice()) {
        (Kind::Name(name), [arguments]) => Some((name, arguments)),
        _ => None,
    }
}

/// A sum, product or composition: its name and the polar forms of its operands.
fn combined(session: &Session, call: &Expr) -> Option<(Combination, Value, Value)> {
    let (name, arguments) = callee(call)?;
    let kind = match name {
        "polar_sum" => Combination::Sum,
        "polar_product" => Combination::Product,
        "polar_compose" => Combination::Composition,
        _ => return None,
    };
    let [f, g] = arguments else { return None };
    let polar = |operand: &Expr| {
        let mut call = Expr::apply(Expr::name("polar"), vec![operand.clone()]);
        session.clone().evaluate(&mut call, Equals::Claims).ok().map(|outcome| outcome.value)
    };
    Some((kind, polar(f)?, polar(g)?))
}

/// Derivations speak of F and f (a combination of its result h): here they get the names of the file.
fn rename(lines: &mut [Line], call: &Expr, name: Option<Expr>) {
    let source = match callee(call) {
        Some(("polar", [first, ..])) if matches!(first.kind, Kind::Name(_)) => Some(first),
        _ => None,
    };
    let combination = callee(call).is_some_and(|(name, _)| name.starts_with("polar_"));
    let result = if combination { "h" } else { "f" };
    let names: Vec<(&str, Kind)> =
        [name.map(|name| (result, name.kind)), source.map(|source| ("F", source.kind.clone()))]
            .into_iter()
            .flatten()
            .filter(|(old, new)| *new != Kind::Name((*old).to_owned()))
            .collect();
    if names.is_empty() {
        return;
    }
    for line in lines {
        replace(&mut line.formula, &names);
        line.reason = line.reason.map(|words| {
            let pieces = words.split('`').enumerate().map(|(i, piece)| match syntax::parse(piece) {
                Ok(mut formula) if i % 2 == 1 => {
                    replace(&mut formula, &names);
                    crate::language::write::text(&formula)
                }
                _ => piece.to_owned(),
            });
            pieces.collect::<Vec<_>>().join("`")
        });
    }
}

fn replace(expr: &mut Expr, names: &[(&str, Kind)]) {
    if let Kind::Name(name) = &expr.kind
        && let Some((_, new)) = names.iter().find(|(old, _)| old == name)
    {
        expr.kind = new.clone();
        return;
    }
    expr.for_each_child_mut(&mut |child| replace(child, names));
}
