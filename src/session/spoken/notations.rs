//! Notations whose lists are given in words: `N_{0,2}(3/2) with knots 0, 1, 2, 3`, `L_1(x) for the nodes 0, 1, 3`.

use super::Read;
use super::draft::list;
use crate::formula::{Expr, Kind, Link, Rel, applied, call};
use crate::language::eval;
use crate::language::lexicon::families;
use crate::language::lexicon::phrases::Label;

/// A formula whose notations are calls, and the function that they call.
pub(super) struct Meant {
    pub(super) formula: Expr,
    pub(super) function: &'static str,
}

/// A member of a family: its letter, its number and its degree or level.
struct Member<'a> {
    letter: &'a str,
    number: &'a Expr,
    degree: Option<&'a Expr>,
}

/// A formula with the lists that are said for its notations; `None` if it has none of them.
///
/// What was used is no longer among what is said.
pub(super) fn with_values(formula: &Expr, said: &mut Vec<Read>) -> Option<Meant> {
    let find = |label: Label| {
        said.iter().position(|read| read.label == label || label == Label::Knots && is_knots(read))
    };
    for (label, function, letters) in [
        (Label::Knots, "bspline_basis", [families::SPLINE, families::BERNSTEIN].as_slice()),
        (Label::Nodes, "lagrange_basis", families::LAGRANGE),
        (Label::Points, "bezier", ["b"].as_slice()),
    ] {
        let Some(at) = find(label) else { continue };
        let items = match said[at].items.as_slice() {
            [Expr { kind: Kind::List(items) | Kind::Tuple(items), .. }] => items.clone(),
            items => items.to_vec(),
        };
        let mut found = Found { function, letters, values: list(items), degree: degree_of(said), count: 0 };
        let meant = found.rewritten(formula.clone());
        if let (Some(formula), true) = (meant, found.count > 0) {
            said.remove(at);
            if found.degree.is_some() {
                said.retain(|read| read.label != Label::OfDegree);
            }
            return Some(Meant { formula, function });
        }
    }
    None
}

/// An elementary symmetric polynomial: e_2(1, 2, 3).
pub(super) fn symmetric(formula: &Expr) -> Option<Expr> {
    let Kind::Apply(callee, groups) = &formula.kind else { return None };
    let Kind::Subscript(letter, index) = &callee.kind else { return None };
    let ([index], [arguments]) = (index.as_slice(), groups.as_slice()) else { return None };
    let known =
        matches!(&letter.kind, Kind::Name(name) if matches!(name.as_str(), "e" | "E" | "s" | "sigma"));
    known.then(|| call("esym", std::iter::once(index).chain(arguments).cloned().collect(), formula.span))
}

/// Puts values into formulas that need them to have a meaning: the polar form of t^n for n = 4.
pub(super) fn exponents(items: &mut [Expr], said: &mut Vec<Read>) {
    let is_exponent = |formula: &Expr, name: &str| {
        formula.has(&|part| match &part.kind {
            Kind::Pow(_, exponent) => {
                exponent.has(&|inner| matches!(&inner.kind, Kind::Name(own) if own == name))
            }
            _ => false,
        })
    };
    said.retain(|read| {
        let [item] = read.items.as_slice() else { return true };
        let Some((name, value)) = eval::named(item) else { return true };
        let used = matches!(read.label, Label::With | Label::At)
            && items.iter().any(|formula| is_exponent(formula, &name));
        if used {
            for formula in items.iter_mut() {
                *formula = formula.with_name(&name, &value.clone().grouped());
            }
        }
        !used
    });
}

/// over 0, 1, 2, 3
fn is_knots(read: &Read) -> bool {
    read.label == Label::Over && read.items.len() > 2
}

fn degree_of(said: &[Read]) -> Option<i64> {
    let read = said.iter().find(|read| read.label == Label::OfDegree)?;
    read.items.first()?.as_int()
}

struct Found<'a> {
    function: &'static str,
    letters: &'a [&'a str],
    values: Expr,
    degree: Option<i64>,
    count: usize,
}

impl Found<'_> {
    /// The formula with calls for notations; `None` if a notation says something else than the words.
    fn rewritten(&mut self, mut expr: Expr) -> Option<Expr> {
        let span = expr.span;
        if let Kind::Apply(callee, groups) = &expr.kind
            && let [arguments] = groups.as_slice()
            && let Some(member) = self.member(callee)
        {
            let [argument] = arguments.as_slice() else { return None };
            let called = self.called(&member, Some(argument), span)?;
            self.count += 1;
            return Some(called);
        }
        if let Some(member) = self.member(&expr) {
            let called = self.called(&member, None, span)?;
            self.count += 1;
            return Some(called);
        }
        let mut whole = true;
        expr.for_each_child_mut(&mut |child| match self.rewritten(child.clone()) {
            Some(new) => *child = new,
            None => whole = false,
        });
        whole.then_some(expr)
    }

    /// N_{i,n}, N_i^n, L_i
    fn member<'e>(&self, expr: &'e Expr) -> Option<Member<'e>> {
        let (indexed, upper) = match &expr.kind {
            Kind::Pow(base, exponent) => (&**base, Some(&**exponent)),
            _ => (expr, None),
        };
        let Kind::Subscript(base, lower) = &indexed.kind else { return None };
        let Kind::Name(letter) = &base.kind else { return None };
        let known = self.letters.contains(&letter.as_str());
        let (number, degree) = match (lower.as_slice(), upper) {
            ([number, degree], None) | ([number], Some(degree)) => (number, Some(degree)),
            ([number], None) => (number, None),
            _ => return None,
        };
        let lagrange = self.function == "lagrange_basis";
        (known && lagrange == degree.is_none()).then_some(Member { letter, number, degree })
    }

    fn called(
        &self,
        member: &Member,
        argument: Option<&Expr>,
        span: crate::formula::source::Span,
    ) -> Option<Expr> {
        let number = member.number.clone();
        match (self.function, member.degree) {
            ("bspline_basis", Some(degree)) => {
                let degree = self.degree_meant(degree)?;
                let function = call("bspline_basis", vec![degree, self.values.clone(), number], span);
                Some(match argument {
                    // The whole function of t.
                    None | Some(Expr { kind: Kind::Name(_), .. }) => function,
                    Some(argument) => applied(function, vec![argument.clone()], span),
                })
            }
            ("lagrange_basis", None) => {
                let all = call("lagrange_basis", vec![self.values.clone()], span);
                let one = Expr::new(Kind::Subscript(Box::new(all), vec![list(vec![number])]), span);
                Some(match argument {
                    Some(argument) => {
                        let name = Expr { span, ..Expr::name("t") };
                        let value = Expr::new(
                            Kind::Chain(
                                Box::new(name),
                                vec![Link { rel: Rel::Eq, span, expr: argument.clone() }],
                            ),
                            span,
                        );
                        call("subs", vec![one, value], span)
                    }
                    None => one,
                })
            }
            // b_i^k(t), a point of de Casteljau's scheme: f(0, ..., t, ..., 1)
            ("bezier", Some(level)) if member.letter == "b" => {
                let degree = self.values.items()?.len().checked_sub(1)?;
                let (index, level) =
                    (usize::try_from(number.as_int()?).ok()?, usize::try_from(level.as_int()?).ok()?);
                let zeros = degree.checked_sub(index.checked_add(level)?)?;
                let number = |value: i64| Expr { span, ..Expr::int(value) };
                let arguments = std::iter::repeat_n(number(0), zeros)
                    .chain(std::iter::repeat_n(argument?.clone(), level))
                    .chain(std::iter::repeat_n(number(1), index));
                let form = call("polar", vec![call("bezier", vec![self.values.clone()], span)], span);
                Some(applied(form, arguments.collect(), span))
            }
            _ => None,
        }
    }

    /// The degree by a notation whose upper number is the order in some books, if words tell.
    fn degree_meant(&self, written: &Expr) -> Option<Expr> {
        match (self.degree, written.as_int()) {
            (Some(degree), Some(number)) if number == degree + 1 => {
                Some(Expr { span: written.span, ..Expr::int(degree) })
            }
            (Some(degree), number) if number != Some(degree) => None,
            _ => Some(written.clone()),
        }
    }
}
