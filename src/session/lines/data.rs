//! A question and its data in one line, in any order: `p(2), p(x) = x^3`, `f(u, v) = u v ⇒ f(1, 2) = ?`,
//! `N_{1,2}(1), U = (0, 0, 0, 1, 2, 2, 2)`, `b_0 = 1, b_1 = 3, b(1/2) = ?`.

use std::collections::BTreeMap;

use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, Link, Rel, call};
use crate::judge::written::names::bases;
use crate::language::eval::Equals;
use crate::language::lexicon::phrases::Label;
use crate::language::lexicon::roles;
use crate::session::given::{Given, in_order};
use crate::session::{Answer, Failure, Session, defines, read_as, spoken};

/// What is asked, and what is given for it.
struct Data {
    question: Expr,
    given: Vec<Expr>,
    /// Whether all that is given stands before the question.
    before: bool,
}

/// The parts of a line: items of a list, the sides of an implication.
fn parts(statement: &Expr) -> Vec<Expr> {
    match &statement.kind {
        Kind::Sequence(items) => items.iter().flat_map(parts).collect(),
        Kind::Chain(left, links) if links.iter().any(|link| link.rel == Rel::Implies) => {
            let mut parts = vec![(**left).clone()];
            for link in links {
                match (link.rel, parts.last_mut()) {
                    (Rel::Implies, _) | (_, None) => parts.push(link.expr.clone()),
                    (_, Some(last)) => {
                        let span = last.span.to(link.expr.span);
                        let mut own = match &last.kind {
                            Kind::Chain(_, own) => own.clone(),
                            _ => Vec::new(),
                        };
                        let first = match &last.kind {
                            Kind::Chain(first, _) => first.clone(),
                            _ => Box::new(last.clone()),
                        };
                        own.push(link.clone());
                        *last = Expr::new(Kind::Chain(first, own), span);
                    }
                }
            }
            parts
        }
        _ => vec![statement.clone()],
    }
}

/// A definition with := in place of =: x = 1, x_0 = 1, (t_i) = (0, 1), p(x) = x^2.
fn definition(item: &Expr) -> Option<Expr> {
    let Kind::Chain(left, links) = &item.kind else { return None };
    let [link @ Link { rel: Rel::Eq | Rel::Define, .. }] = links.as_slice() else { return None };
    let name = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..) | Kind::Accent(..));
    let fits = match &left.kind {
        Kind::Apply(callee, groups) => name(callee) && groups.iter().flatten().all(name),
        Kind::Group(_) | Kind::Tuple(_) => family_of(left).is_some() && link.expr.items().is_some(),
        _ => name(left),
    };
    let link = Link { rel: Rel::Define, ..link.clone() };
    fits.then(|| Expr::new(Kind::Chain(left.clone(), vec![link]), item.span))
}

/// t for (t_i)
fn family_of(left: &Expr) -> Option<String> {
    let inner = match &left.kind {
        Kind::Group(inner) => inner,
        Kind::Tuple(items) => match items.as_slice() {
            [inner] => inner,
            _ => return None,
        },
        _ => return None,
    };
    match &inner.kind {
        Kind::Subscript(base, index) => match (&base.kind, index.as_slice()) {
            (Kind::Name(name), [Expr { kind: Kind::Name(_), .. }]) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    }
}

impl Data {
    fn of(statement: &Expr) -> Option<Data> {
        let parts = parts(statement);
        let given: Vec<Option<Expr>> = parts.iter().map(definition).collect();
        let asked: Vec<usize> = (0..parts.len()).filter(|&at| given[at].is_none()).collect();
        let [at] = asked[..] else { return None };
        let question = parts[at].clone();
        let relation = matches!(question.kind, Kind::Chain(..) | Kind::Text(_));
        if parts.len() < 2 || relation || at != 0 && at + 1 != parts.len() {
            return None;
        }
        let before = at > 0;
        let given: Vec<Expr> = given.into_iter().flatten().collect();
        Some(Data { question, given, before })
    }

    /// The lists that are given, as one or member by member, with their letters and the definitions they are made of.
    fn lists(&self) -> Vec<(String, Vec<Expr>, Vec<usize>)> {
        let mut found = Vec::new();
        let mut members: BTreeMap<String, BTreeMap<usize, (usize, Expr)>> = BTreeMap::new();
        for (at, one) in self.given.iter().enumerate() {
            let Kind::Chain(left, links) = &one.kind else { continue };
            let value = &links[0].expr;
            match &left.kind {
                // b_i = i^3, n = 3
                Kind::Subscript(base, index)
                    if let [Expr { kind: Kind::Name(index), .. }] = index.as_slice() =>
                {
                    if let (Some(letter), Some((degree, last))) = (letter_of(base), self.degree()) {
                        let item = |i: i64| value.with_name(index, &Expr::int(i)).grouped();
                        found.push((letter, (0..=last).map(item).collect(), vec![at, degree]));
                    }
                }
                Kind::Subscript(base, index) => {
                    if let (Some(letter), [index]) = (letter_of(base), index.as_slice())
                        && let Some(number) = index.as_int().and_then(|index| usize::try_from(index).ok())
                    {
                        members.entry(letter).or_default().insert(number, (at, value.clone()));
                    }
                }
                _ => {
                    let letter = letter_of(left).or_else(|| family_of(left));
                    if let (Some(letter), Some(items)) = (letter, value.items()) {
                        found.push((letter, items.to_vec(), vec![at]));
                    }
                }
            }
        }
        for (letter, items) in members {
            if items.len() > 1 && items.keys().copied().eq(0..items.len()) {
                let (places, values) = items.into_values().unzip();
                found.push((letter, values, places));
            }
        }
        found
    }

    /// Which of the data says the degree: n = 3.
    fn degree(&self) -> Option<(usize, i64)> {
        const MOST: i64 = 100;
        self.given.iter().enumerate().find_map(|(at, one)| match &one.kind {
            Kind::Chain(left, links) => match &left.kind {
                Kind::Name(name) if roles::is_degree(name) => links[0]
                    .expr
                    .as_int()
                    .filter(|degree| (0..=MOST).contains(degree))
                    .map(|degree| (at, degree)),
                _ => None,
            },
            _ => None,
        })
    }

    /// Gives the notations of the field their lists: knots to N_{i,n}, nodes to ℓ_i, points to b(t).
    fn meant(&mut self, known: &dyn Fn(&str) -> bool) -> bool {
        for (letter, items, places) in self.lists() {
            if known(&letter) {
                continue;
            }
            let labels = match letter.as_str() {
                "x" | "y" => vec![Label::Nodes, Label::Knots],
                "b" | "p" | "P" | "c" | "d" => vec![Label::Points],
                _ => vec![Label::Knots, Label::Nodes],
            };
            let mut question = curve_of(&self.question, &letter, &items);
            for label in labels {
                question = question.or_else(|| spoken::with_list(&self.question, label, &items));
            }
            if let Some(question) = question {
                self.question = question;
                let mut at = 0..self.given.len();
                self.given.retain(|_| at.next().is_none_or(|at| !places.contains(&at)));
                return true;
            }
        }
        false
    }
}

/// b, also in bold.
fn letter_of(expr: &Expr) -> Option<String> {
    match &expr.kind {
        Kind::Name(name) => Some(name.clone()),
        Kind::Accent(_, inner) => letter_of(inner),
        _ => None,
    }
}

/// The question with the Bézier curve of the points b_0, …, b_n in place of b, where b has one argument.
fn curve_of(question: &Expr, letter: &str, points: &[Expr]) -> Option<Expr> {
    let is_curve = |callee: &Expr| match &callee.kind {
        Kind::Prime(inner, _) => letter_of(inner).is_some_and(|name| name == letter),
        _ => letter_of(callee).is_some_and(|name| name == letter),
    };
    let called = question.has(&|part| match &part.kind {
        Kind::Apply(callee, groups) => {
            is_curve(callee) && matches!(groups.as_slice(), [group] if group.len() == 1)
        }
        _ => false,
    });
    if !called || !matches!(letter, "b" | "p" | "P" | "c" | "d") {
        return None;
    }
    fn put(expr: &mut Expr, letter: &str, points: &[Expr]) {
        if let Kind::Apply(callee, groups) = &mut expr.kind {
            let place = match &mut callee.kind {
                Kind::Prime(inner, _) => inner,
                _ => callee,
            };
            if letter_of(place).is_some_and(|name| name == letter) {
                let span = place.span;
                **place = call("bezier", vec![Expr::new(Kind::List(points.to_vec()), span)], span);
            }
            groups.iter_mut().flatten().for_each(|argument| put(argument, letter, points));
            return;
        }
        expr.for_each_child_mut(&mut |child| put(child, letter, points));
    }
    let mut question = question.clone();
    put(&mut question, letter, points);
    Some(question)
}

impl Session {
    /// Answers a question whose data stand beside it; `None` if the line is something else. If `asked`, its last part
    /// has a question mark.
    pub(in crate::session) fn run_data(
        &mut self,
        file: &SourceFile,
        statement: &Expr,
        asked: bool,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let known = |word: &str| defines(&self.env, word);
        let Some(mut data) = Data::of(statement) else { return Ok(None) };
        let meant = data.meant(&known);
        // Definitions before a formula stay defined, and are none of this; so do they before "= ?".
        if data.before && !meant && !asked && matches!(statement.kind, Kind::Sequence(_)) {
            return Ok(None);
        }
        let given: Vec<Given> =
            data.given.drain(..).map(|statement| Given { file: file.clone(), statement }).collect();
        let used: Vec<String> = given
            .iter()
            .filter_map(Given::definition)
            .flat_map(|(_, body)| bases(body))
            .chain(bases(&data.question))
            .collect();
        if !given.iter().all(|one| one.definition().is_some_and(|(name, _)| used.contains(&name))) {
            return Ok(None);
        }
        let mut there = self.clone();
        for one in in_order(given) {
            there.evaluated(file, one.statement, Equals::DefinesUnbound, false)?;
        }
        if data.before {
            self.env = there.env.clone();
        }
        let note = meant.then(|| read_as(&data.question, statement.span));
        let mut answer = there.evaluated(file, data.question, Equals::Claims, false)?;
        answer.outcome.notes.splice(0..0, note);
        Ok(Some(vec![answer]))
    }
}
