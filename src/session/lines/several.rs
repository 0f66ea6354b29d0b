//! A line of several formulas: what is defined and supposed in it, then what is asked, wherever each of them stands.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Link, Rel, call, named, spread};
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, bases};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::{Equals, name_of};
use crate::language::functions::function_called;
use crate::language::lexicon::phrases::{Phrase, phrase};
use crate::language::lexicon::{roles, words};
use crate::language::syntax::{self, Line, Piece, Role, Sentence};
use crate::language::value::{Value, symbol_expr};
use crate::math::poly::Symbol;
use crate::session::given::is_equation;
use crate::session::given::{Given, each_equal, in_order};
use crate::session::{Answer, Failure, Session, defines, read_as};

/// What the pieces of a line are, put in their places.
#[derive(Default)]
struct Taken {
    definitions: Vec<Given>,
    /// With the number of their sentence, whether they are meant for all values, and whether only that sentence has them.
    conditions: Vec<(Piece, bool)>,
    asked: Vec<(Piece, bool)>,
    notes: Vec<Diagnostic>,
}

impl Session {
    /// Runs a line that is no single formula or request; `None` if it cannot be cut, or only into pieces that nobody reads.
    pub(in crate::session) fn run_line(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let known = |word: &str| defines(&self.env, word);
        let Some(mut line) = syntax::line(file.slice(whole), &known) else { return Ok(None) };
        for piece in &mut line.pieces {
            piece.span = piece.span.shifted(whole.start);
        }
        // A piece that is all of it says no more than before.
        if let [piece] = line.pieces.as_slice()
            && piece.span.len() >= file.slice(whole).trim().len()
        {
            return Ok(None);
        }
        let mut there = self.clone();
        let ran = there.run_pieces(file, whole, &line, equals);
        match ran {
            Ok(answers) => {
                self.env = there.env;
                Ok(Some(answers))
            }
            Err(failure) if line.cut_at_dollars || is_one_question(&line) => Err(failure),
            Err(_) => Ok(None),
        }
    }

    fn run_pieces(
        &mut self,
        file: &SourceFile,
        whole: Span,
        line: &Line,
        equals: Equals,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let mut taken = self.taken(file, line)?;
        if taken.asked.is_empty() && taken.definitions.is_empty() {
            let problem = Diagnostic::error(Code::Usage, "nothing is asked here")
                .at(line.pieces[0].span)
                .hint("write what is wanted behind it: compute f(1)");
            return Err(Box::new(Failure { problem, file: file.clone() }));
        }
        // What a sentence without a question supposes holds for all that is asked.
        let asks_in = |sentence: usize| taken.asked.iter().any(|(piece, _)| piece.sentence == sentence);
        if let Some((piece, _)) = taken.conditions.first().filter(|_| taken.asked.is_empty()) {
            let problem = Diagnostic::error(Code::Usage, "nothing is asked under this condition")
                .at(piece.span)
                .hint("write what is wanted behind it: compute f(1)");
            return Err(Box::new(Failure { problem, file: file.clone() }));
        }
        let lonely: Vec<bool> = taken.conditions.iter().map(|(piece, _)| !asks_in(piece.sentence)).collect();
        for ((_, own), lonely) in taken.conditions.iter_mut().zip(lonely) {
            *own &= !lonely;
        }
        let mut answers = Vec::new();
        // Lists for the notations of the field: knots for N_{i,n}.
        if let ([(asked, false)], []) = (taken.asked.as_slice(), taken.conditions.as_slice())
            && let Ok(question) = self.read(file, asked.span)
        {
            let items = taken.definitions.iter().map(|one| one.statement.clone()).chain([question]).collect();
            let span = line.pieces.iter().map(|piece| piece.span).reduce(Span::to).unwrap_or_default();
            let mut there = self.clone();
            let list = Expr::new(Kind::Sequence(items), span);
            let meant =
                |answer: &Answer| answer.outcome.notes.iter().any(|note| note.code == Code::StandardMeaning);
            if let Ok(Some(mut found)) = there.run_data(file, &list, true)
                && found.iter().any(meant)
            {
                self.env = there.env;
                if let Some(first) = found.first_mut() {
                    first.outcome.notes.splice(0..0, taken.notes);
                }
                return Ok(found);
            }
        }
        let definitions = in_order(first_cases_first(std::mem::take(&mut taken.definitions)));
        let functions: Vec<Expr> = definitions.iter().filter_map(|one| function_of(&one.statement)).collect();
        // What words such as "its" mean.
        let topic = functions.first().filter(|_| functions.len() == 1);
        for one in definitions {
            answers.push(self.evaluated(file, one.statement, Equals::DefinesUnbound, false)?);
        }
        for (piece, claims) in &taken.asked {
            let conditions: Vec<(Span, bool)> = taken
                .conditions
                .iter()
                .filter(|(condition, own)| !own || condition.sentence == piece.sentence)
                .map(|(condition, _)| (condition.span, condition.role == Role::Condition { all: true }))
                .collect();
            let claims_here = if *claims { Equals::Claims } else { equals };
            // The words behind it may belong to what is asked: the blossom at (1, 2).
            let behind = line
                .pieces
                .iter()
                .filter(|other| other.sentence == piece.sentence && other.span.start > piece.span.start);
            let last = behind
                .clone()
                .next_back()
                .filter(|_| behind.clone().all(|other| matches!(other.role, Role::Condition { .. })));
            if let Some(rest) = last.map(|last| piece.span.to(last.span)).filter(|rest| *rest != piece.span)
                && !conditions.is_empty()
                // Those before it would be lost: for which k is …
                && conditions.iter().all(|(condition, _)| condition.start > piece.span.start)
                && rest.len() < file.slice(whole).trim().len()
            {
                let mut there = self.clone();
                if let Ok(found) = there.run_about(file, rest, claims_here, topic) {
                    self.env = there.env;
                    answers.extend(found);
                    continue;
                }
            }
            if let Some(formula) = self.unknown_of(file, piece.span, &conditions) {
                answers.push(self.evaluated_as(file, formula, piece.span, Equals::Claims)?);
                continue;
            }
            let said = match conditions.is_empty() {
                true => None,
                false => {
                    let sentence = Sentence { formula: piece.span, conditions, asked: *claims };
                    Some(self.run_sentence(file, &sentence, claims_here)?)
                }
            };
            match said {
                None => answers.extend(self.run_about(file, piece.span, claims_here, topic)?),
                Some(Some(found)) => answers.extend(found),
                Some(None) => {
                    let problem = Diagnostic::error(Code::Usage, "these conditions are not read here")
                        .at(taken.conditions[0].0.span)
                        .hint("write t^2 <= t for 0 <= t <= 1, or give a name its value: t^2 for t = 2");
                    return Err(Box::new(Failure { problem, file: file.clone() }));
                }
            }
        }
        if let Some(first) = answers.first_mut() {
            first.outcome.notes.splice(0..0, taken.notes);
        }
        Ok(answers)
    }

    /// Runs a part in which a word such as "its" may stand for the topic of the line.
    fn run_about(
        &mut self,
        file: &SourceFile,
        span: Span,
        equals: Equals,
        topic: Option<&Expr>,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let Some((formula, true)) = self.spoken_about(file, span, topic)? else {
            return self.run_part(file, span, equals);
        };
        Ok(vec![self.evaluated_as(file, formula, span, equals)?])
    }

    /// The equations of conditions, to be solved for a name that is asked for and has no value: x + a = 0, find a.
    pub(in crate::session) fn unknown_of(
        &self,
        file: &SourceFile,
        asked: Span,
        conditions: &[(Span, bool)],
    ) -> Option<Expr> {
        let mut equations = Vec::new();
        for (span, _) in conditions {
            let read = self.read(file, *span).ok()?;
            match read.kind {
                Kind::Sequence(items) => {
                    equations.extend(items.into_iter().filter(|item| !matches!(item.kind, Kind::Text(_))))
                }
                _ => equations.push(read),
            }
        }
        self.solved_for(file, asked, equations)
    }

    /// The call that solves equations for a name that has no value.
    pub(in crate::session) fn solved_for(
        &self,
        file: &SourceFile,
        asked: Span,
        equations: Vec<Expr>,
    ) -> Option<Expr> {
        let names = self.names_in(file, asked)?;
        let mut machine = evaluator::machine_in(&self.env);
        let mut free =
            |name: &Expr| name_of(name, &mut machine).filter(|symbol| self.env.get(symbol).is_none());
        if equations.is_empty() || !equations.iter().all(is_equation) {
            return None;
        }
        let symbols = names.iter().map(&mut free).collect::<Option<Vec<_>>>()?;
        // f[0, 1] for f = x^2: f is given
        let given = |equation: &Expr| {
            matches!(&equation.kind, Kind::Chain(left, _)
                if matches!(&left.kind, Kind::Name(name)
                    if symbols.iter().any(|symbol| !symbol.is_plain() && *name == symbol.base())))
        };
        if equations.iter().any(given) {
            return None;
        }
        // The names in what the equations say, also through sums and values of functions.
        let mut names: Vec<Symbol> = Vec::new();
        for equation in &equations {
            let outcome = self.clone().evaluate(&mut equation.clone(), Equals::Claims).ok()?;
            let Value::Claim(claim) = outcome.value else { return None };
            for value in claim.judgements.iter().filter_map(|judgement| judgement.difference.as_ref()) {
                names.extend(value.as_scalar()?.variables());
            }
        }
        names.sort();
        names.dedup();
        let indexed = symbols.iter().any(|symbol| !symbol.is_plain());
        let is = |symbol: &Symbol, other: &Symbol| match symbol.is_plain() {
            true => other == symbol,
            false => other.base() == symbol.base(),
        };
        if !symbols.iter().all(|symbol| names.iter().any(|other| is(symbol, other))) {
            return None;
        }
        let like = |other: &&Symbol| symbols.iter().any(|symbol| is(symbol, other));
        let unknowns: Vec<Expr> =
            names.iter().filter(like).map(|name| Expr { span: asked, ..symbol_expr(name) }).collect();
        let list = |items: Vec<Expr>| Expr::new(Kind::List(items), asked);
        let variable =
            names.iter().find(|name| indexed && name.is_plain() && roles::is_variable(name.base()));
        let count = equations.len();
        let mut arguments = vec![list(equations)];
        if indexed || count == 1 || symbols.len() > 1 {
            arguments.push(list(unknowns));
        }
        arguments.extend(variable.map(|name| named("all", symbol_expr(name))));
        Some(call("solve", arguments, asked))
    }

    /// What each piece is: by the words before it, else by what it says.
    fn taken(&self, file: &SourceFile, line: &Line) -> Result<Taken, Box<Failure>> {
        let mut taken = Taken::default();
        let read: Vec<Option<Expr>> =
            line.pieces.iter().map(|piece| self.read(file, piece.span).ok()).collect();
        let relation = |expr: &Option<Expr>| expr.as_ref().is_some_and(is_relation);
        let asks = |at: usize| {
            let piece = &line.pieces[at];
            let condition = match piece.role {
                Role::Condition { all } => all || piece.direct,
                Role::Given => piece.direct,
                _ => false,
            };
            piece.question && !condition
                || matches!(piece.role, Role::Asked | Role::Claimed)
                || !relation(&read[at]) && !condition
        };
        let any = (0..line.pieces.len()).any(asks);
        // Whether a name stands in a piece that is asked for, or in one that is not.
        let stands = |name: &String, asked: bool, but: usize| {
            let mut pieces = (0..read.len()).filter(|at| *at != but && asks(*at) == asked);
            pieces.any(|at| read[at].as_ref().is_some_and(|piece| bases(piece).contains(name)))
        };
        // What has been defined so far: p(1) = 0 is no definition behind p(x) = x + a.
        let mut there = self.clone();
        let mut before: Option<Expr> = None;
        for (at, piece) in line.pieces.iter().enumerate() {
            let own = matches!(piece.role, Role::Condition { .. });
            // F(t) = t^2 with polar form f
            if own
                && read[at].is_none()
                && let Some(before) = &before
                && let Some(definition) = self.named_function(file, piece.span, before)
            {
                taken.notes.push(read_as(&definition, piece.span));
                taken.definitions.push(Given { file: file.clone(), statement: definition });
                continue;
            }
            if asks(at) {
                if read[at].is_none() && (own || piece.role == Role::Given) {
                    self.read(file, piece.span)?;
                }
                let claims = piece.role == Role::Claimed || piece.question && relation(&read[at]);
                taken.asked.push((*piece, claims));
                continue;
            }
            let parts = match &read[at] {
                Some(Expr { kind: Kind::Sequence(items), .. }) => {
                    let said = |item: &&Expr| !matches!(item.kind, Kind::Text(_));
                    spread(items.iter().filter(said).cloned().collect())
                }
                Some(one) => vec![one.clone()],
                None => Vec::new(),
            };
            let parts: Vec<Expr> = parts.into_iter().flat_map(each_equal).collect();
            // xy = 1 beside x and y
            let others =
                (0..read.len()).filter(|other| *other != at).filter_map(|other| read[other].as_ref());
            let parts = self.with_products(&others.flat_map(bases).collect(), parts);
            // A value for a name of what is asked holds there alone: F(t) for t = 2. One of a definition stays: b in
            // p(t) = b_0 + b_1 t.
            let here = |part: &Expr| {
                defined_name(part).is_some_and(|name| stands(&name, true, at) || !stands(&name, false, at))
            };
            let defines = !parts.is_empty() && parts.iter().all(|part| there.is_definition(part));
            if defines && !(own && parts.iter().all(here)) {
                for part in parts {
                    let statement = defining(part);
                    before = Some(statement.clone());
                    there.evaluate(&mut statement.clone(), Equals::DefinesUnbound).ok();
                    taken.definitions.push(Given { file: file.clone(), statement });
                }
            } else if !any && piece.role == Role::Free {
                taken.asked.push((*piece, true));
            } else {
                taken.conditions.push((*piece, own));
            }
        }
        Ok(taken)
    }

    /// Whether a relation gives a new name its meaning.
    fn is_definition(&self, part: &Expr) -> bool {
        evaluator::machine_in(&self.env).defines(part)
    }

    /// The definition of a name that words give to a function of what stands before: $F(t) = t^2$ with polar form $f$.
    fn named_function(&self, file: &SourceFile, span: Span, before: &Expr) -> Option<Expr> {
        let text = file.slice(span);
        let known = |word: &str| function_called(word);
        let (Phrase::Function(function), length) = phrase(text, &known)? else { return None };
        let rest = text.get(length..)?;
        let start = span.start + length + (rest.len() - rest.trim_start().len());
        let name = self.read(file, Span::new(start, span.end)).ok()?;
        let head = defined_name(before)?;
        let letter = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
        let name = match &name.kind {
            Kind::Name(word) if !words::is_prose(word) => name,
            Kind::Apply(callee, groups) if letter(callee) && groups.iter().flatten().all(letter) => {
                (**callee).clone()
            }
            _ => return None,
        };
        let of = Expr { span, ..Expr::name(head) };
        Some(Expr { span, ..Expr::relation(name, Rel::Define, call(function, vec![of], span)) })
    }
}

/// Whether there is nothing but one formula that is asked for.
fn is_one_question(line: &Line) -> bool {
    matches!(line.pieces.as_slice(), [piece] if !matches!(piece.role, Role::Condition { .. } | Role::Given))
}

/// The name of the function that a definition is of.
fn function_of(definition: &Expr) -> Option<Expr> {
    let Kind::Chain(left, _) = &definition.kind else { return None };
    match &left.kind {
        Kind::Apply(callee, _) => Some((**callee).clone()),
        _ => None,
    }
}

/// The first case of a recursion goes before it: a_n = 2 a_{n-1}, a_0 = 1.
fn first_cases_first(definitions: Vec<Given>) -> Vec<Given> {
    let is_case = |one: &Given| match &one.statement.kind {
        Kind::Chain(left, _) => match &left.kind {
            Kind::Subscript(_, indices) => indices.iter().all(|index| matches!(index.kind, Kind::Number(_))),
            _ => false,
        },
        _ => false,
    };
    let (mut first, others): (Vec<Given>, Vec<Given>) = definitions.into_iter().partition(is_case);
    first.extend(others);
    first
}

/// The name on the left of a definition.
fn defined_name(part: &Expr) -> Option<String> {
    let Kind::Chain(left, links) = &part.kind else { return None };
    matches!(links.as_slice(), [Link { rel: Rel::Eq | Rel::Define, .. }])
        .then(|| Head::of(left))?
        .map(|head| head.base)
}

/// A definition with := in place of =.
pub(in crate::session) fn defining(mut part: Expr) -> Expr {
    if let Kind::Chain(_, links) = &mut part.kind
        && let [link @ Link { rel: Rel::Eq, .. }] = links.as_mut_slice()
    {
        link.rel = Rel::Define;
    }
    part
}

fn is_relation(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Chain(..) => true,
        Kind::Sequence(items) => {
            !items.is_empty() && items.iter().all(|item| matches!(item.kind, Kind::Chain(..) | Kind::Text(_)))
        }
        _ => false,
    }
}
