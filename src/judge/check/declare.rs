//! Declarations: what a comment or a side file says about the names of the notes.
//!
//! A declaration is a sequence of statements of the query language: definitions
//! (`F(t) := t^2 + 1`), conditions (`0 <= i <= n`, `a + b + c = 1`), or `ignore`, after which the next
//! formula is not judged. What a block of queries defines is declared, too: weaving runs the block, and
//! the text around it speaks of its names.

use std::collections::BTreeSet;
use std::rc::Rc;

use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::tally::Tally;
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::definable;
use crate::judge::page::context::{Body, Definition, Source};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{Head, bases, operated, walk};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::{latex, syntax};

fn read(statement: &str) -> Result<Expr, Diagnostic> {
    if syntax::looks_like_latex(statement) { latex::read(statement) } else { syntax::parse(statement) }
}

impl Checker {
    /// H = FG, where the section is on polar forms: h is that of H, as f and g are those of F and G.
    pub(in crate::judge) fn convention(&mut self, head: &Head, body: &Expr, statement: &Statement) {
        let function = |base: &String| {
            let object = self.context.object_called(base, &statement.place);
            let defined = || {
                self.context
                    .visible(base, &statement.place)
                    .any(|(_, d, near)| near && d.head.arguments.is_some())
            };
            base.starts_with(char::is_uppercase)
                && (object.is_some_and(|d| d.object.is_function()) || object.is_none() && defined())
        };
        let made = matches!(body.kind, Kind::Mul(_) | Kind::Add(_) | Kind::Compose(_) | Kind::Prime(..));
        let small = head.base.to_lowercase();
        let whole = head.arguments.is_none() && head.lower.is_empty() && head.upper.is_empty();
        let alike = whole && small != head.base && !head.base.contains(' ');
        let free = self.context.object_called(&small, &statement.place).is_none();
        if made && alike && free && statement.topics.has(Topic::PolarForm) && bases(body).iter().all(function)
        {
            let (names, of) = (vec![Expr::name(small)], Some(Expr::name(&head.base)));
            let object = Object { names, of, ..Object::new(Sort::PolarForm) };
            self.object(&object, &statement.place);
        }
    }

    /// (B_n q)(x), where the page says what (B_n f)(x) is: the same with q in the place of f.
    pub(in crate::judge) fn operators(&mut self, chain: &Chain, place: &Place) {
        let mut wanted: Vec<(String, String, Expr)> = Vec::new();
        for side in &chain.sides {
            walk(&side.expr, &mut |part| {
                if let Kind::Group(product) = &part.kind
                    && let (Some(whole), Some((operator, function))) = (Head::of(part), operated(product))
                    && self.context.visible(&whole.base, place).next().is_none()
                {
                    wanted.push((whole.base, operator.base, function.clone()));
                }
            });
        }
        for (base, operator, function) in wanted {
            let like = |known: &str| {
                known.strip_prefix(operator.as_str()).is_some_and(|rest| {
                    // Not one that was made of it.
                    rest.starts_with('[') && rest.chars().all(|c| c.is_alphabetic() || matches!(c, '[' | ']'))
                })
            };
            let definitions = &self.context.definitions;
            let known = definitions.iter().rev().find(|definition| {
                like(&definition.head.base) && place.in_reach(&definition.place, definition.assumed)
            });
            let Some(Definition { head, body: Body::Formula(body), conditions, .. }) = known.cloned() else {
                continue;
            };
            let argument = head.base[operator.len()..].trim_matches(['[', ']']).to_owned();
            let body = body.with_name(&argument, &function);
            self.define(Head { base, ..head }, Body::Formula(body.clone()), &conditions, place, body.span);
        }
    }

    /// "They join if and only if c_0 = b_n": what is known of the join leads to it, or to something else.
    pub(in crate::judge) fn as_a_consequence(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
    ) {
        let named: BTreeSet<String> = chain.sides.iter().flat_map(|side| bases(&side.expr)).collect();
        let told = self.context.objects.iter().filter(|told| {
            told.object.sort == Sort::BezierCurve && statement.place.knows(&told.place, false)
        });
        let letters = |object: &Object| object.points.first().and_then(Head::of).map(|head| head.base);
        let curves: Vec<(String, String)> = told
            .filter_map(|told| Some((Head::of(told.object.names.first()?)?.base, letters(&told.object)?)))
            .collect();
        let joined = curves
            .iter()
            .any(|(curve, points)| named.contains(points) && self.is_constrained(curve, &statement.place));
        if !joined {
            return;
        }
        let claim = Statement { role: Some(Role::Claimed), ..statement.clone() };
        let kept = self.context.clone();
        let tried = self.chain(chain, &claim);
        self.context = kept;
        for (finding, tried) in findings.iter_mut().zip(tried) {
            let refuted = tried.verdict == Verdict::Refuted && tried.determined;
            if refuted || matches!(tried.verdict, Verdict::Proved | Verdict::Sampled) {
                *finding = tried;
            }
        }
    }

    /// A natural spline has no second derivative at its first and last knot, as far as the page names these.
    pub(in crate::judge) fn natural(&mut self, object: &Object, place: &Place) {
        let listed = || {
            let letter = self.context.objects.iter().rev().find_map(|told| {
                let knots =
                    matches!(told.object.sort, Sort::Knots | Sort::Nodes) && place.knows(&told.place, false);
                Head::of(told.object.names.first().filter(|_| knots)?).map(|head| head.base)
            });
            let letter = letter.unwrap_or_else(|| "x".to_owned());
            let (first, last) = self.context.listed(&letter, place)?;
            let member =
                |index: Expr| Expr::from(Kind::Subscript(Box::new(Expr::name(&letter)), vec![index]));
            Some((member(first), member(last)))
        };
        let ends = match object.knots.as_slice() {
            [first, .., last] if last.kind != Kind::Ellipsis => Some((first.clone(), last.clone())),
            _ => listed(),
        };
        let ([name], Some((first, last))) = (object.names.as_slice(), ends) else { return };
        for end in [first, last] {
            let second = Expr::from(Kind::Prime(Box::new(name.clone()), 2));
            let equation = Expr::relation(Expr::apply(second, vec![end]), Rel::Eq, Expr::int(0));
            self.condition(equation, name.span, false, place);
        }
    }

    /// Whether a name is defined by a spline of which no more is known.
    pub(in crate::judge) fn is_of_any_spline(&self, head: &Head, place: &Place) -> bool {
        self.is_covered(head, place)
            && self.context.visible(&head.base, place).any(|(_, definition, _)| match &definition.body {
                Body::Formula(body) => bases(body).iter().any(|base| {
                    self.context.object_called(base, place).is_some_and(|known| {
                        known.object.sort == Sort::SplineCurve && known.object.points.is_empty()
                    })
                }),
                Body::Value(_) => false,
            })
    }

    /// Whether it is a value of a spline of which no more is known, or of a derivative of it.
    pub(in crate::judge) fn is_value_of_spline(&self, expr: &Expr, place: &Place) -> bool {
        let Kind::Apply(callee, _) = &expr.kind else { return false };
        let mut function = callee.as_ref();
        while let Kind::Prime(inner, _) = &function.kind {
            function = inner;
        }
        Head::of(function).is_some_and(|head| {
            self.context
                .object(&head, place)
                .is_some_and(|known| known.object.sort == Sort::SplineCurve && known.object.points.is_empty())
                && self.context.visible(&head.base, place).next().is_none()
        })
    }

    /// s(x_i) = y_i for a spline of which no more is known: the y_i are its values.
    pub(in crate::judge) fn names_a_value_of_spline(&mut self, chain: &Chain, place: &Place) -> bool {
        let [left, right] = [&chain.sides[0].expr, &chain.sides[1].expr];
        let Kind::Apply(_, groups) = &left.kind else { return false };
        let spline = self.is_value_of_spline(left, place);
        let member = |expr: &Expr| Head::of(expr).filter(|head| head.index().is_some());
        let same = |head: &Head| match groups.concat().as_slice() {
            [argument] => match (member(argument).and_then(|own| own.index().cloned()), head.index()) {
                (Some(a), Some(b)) => a.same_as(b),
                _ => false,
            },
            _ => false,
        };
        let named = definable(right).filter(|head| head.arguments.is_none() && head.upper.is_empty());
        let Some(head) = named.filter(|head| spline && same(head)) else { return false };
        let new = !self.context.visible(&head.base, place).any(|(_, _, near)| near);
        if new {
            self.define(head, Body::Formula(left.clone()), &[], place, left.span);
        }
        new
    }

    /// Whether it is about two functions that words introduced and of which no more is known.
    pub(in crate::judge) fn is_of_two_functions(&self, tally: &Tally) -> bool {
        tally.record.unknown.len() > 1
    }

    /// "They join with C^1 continuity": what the last two curves of the section, over adjacent intervals, fulfil.
    pub(in crate::judge) fn join(&mut self, expr: &Expr, statement: &Statement) {
        let Kind::Pow(letter, order) = &expr.kind else { return };
        let (Kind::Name(letter), Some(order)) = (&letter.kind, order.as_int()) else { return };
        let place = &statement.place;
        if letter != "C" || !(0..4).contains(&order) || statement.denied {
            return;
        }
        let curves = self.context.objects.iter().rev().filter(|told| {
            told.object.sort == Sort::BezierCurve
                && told.object.names.len() == 1
                && place.knows(&told.place, false)
        });
        let curves: Vec<Rc<Object>> = curves.take(2).map(|told| told.object.clone()).collect();
        let adjacent = match curves.as_slice() {
            [second, first] => match (&first.interval, &second.interval) {
                (Some((_, end)), Some((start, _))) if end.same_as(start) => {
                    Some((first.names[0].clone(), second.names[0].clone(), end.clone()))
                }
                _ => None,
            },
            _ => None,
        };
        let Some((first, second, end)) = adjacent.or_else(|| self.contact(place)) else { return };
        for k in 0..=order {
            let value = |name: &Expr| {
                let name = name.clone();
                let name = if k == 0 { name } else { Kind::Prime(Box::new(name), k as u32).into() };
                Expr::apply(name, vec![end.clone()])
            };
            let equation = Expr::relation(value(&first), Rel::Eq, value(&second));
            self.condition(equation, expr.span, false, place);
        }
    }

    /// "Two cubics F and G meet at a": the two polynomials of which the paragraph speaks, and the parameter that it
    /// names last.
    fn contact(&self, place: &Place) -> Option<(Expr, Expr, Expr)> {
        let here = |other: &Place| other.group == place.group;
        let told = self.context.objects.iter().filter(|told| here(&told.place));
        let polynomials = told.filter(|told| told.object.sort == Sort::Polynomial);
        let mut names: Vec<Expr> = Vec::new();
        for name in polynomials.flat_map(|told| &told.object.names) {
            if !names.iter().any(|known| known.same_as(name)) {
                names.push(name.clone());
            }
        }
        let [first, second] = names.as_slice() else { return None };
        let (_, last) = self.context.heard.iter().rev().filter(|(other, _)| here(other)).nth(1)?;
        let Kind::Name(parameter) = &last.kind else { return None };
        let free = self.context.object_called(parameter, place).is_none();
        free.then(|| (first.clone(), second.clone(), last.as_ref().clone()))
    }

    /// "There is one symmetric multiaffine f with f(t, …, t) = F(t)": f is the polar form of F.
    pub(in crate::judge) fn diagonal(&mut self, chain: &Chain, statement: &Statement) {
        let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return };
        let place = &statement.place;
        let (one, other) = (&chain.sides[0].expr, &chain.sides[1].expr);
        for (form, function) in [(one, other), (other, one)] {
            let (Kind::Apply(f, all), Kind::Apply(of, own)) = (&form.kind, &function.kind) else { continue };
            let ([all], [own]) = (all.as_slice(), own.as_slice()) else { continue };
            let (Kind::Name(name), [argument @ Expr { kind: Kind::Name(_), .. }]) = (&f.kind, own.as_slice())
            else {
                continue;
            };
            let same = |item: &Expr| match &item.kind {
                Kind::Brace(items, _) => {
                    items.iter().all(|item| item.same_as(argument) || item.kind == Kind::Ellipsis)
                }
                _ => item.same_as(argument) || item.kind == Kind::Ellipsis,
            };
            let open = matches!(all.as_slice(), [Expr { kind: Kind::Name(_), .. }]);
            let known = self.context.object_called(name, place).is_some_and(|d| d.object.is_function())
                || self.context.visible(name, place).next().is_some();
            if open
                || known
                || f.same_as(of)
                || !all.iter().all(same)
                || !statement.topics.has(Topic::PolarForm)
            {
                continue;
            }
            let (names, of) = (vec![f.as_ref().clone()], Some(of.as_ref().clone()));
            self.object(&Object { names, of, ..Object::new(Sort::PolarForm) }, place);
            return;
        }
    }

    /// Takes in declarations; `span` is their place in the file, if they stand there.
    pub fn declare(&mut self, text: &str, place: &Place, span: Option<Span>) {
        let text = text.trim();
        if text == "ignore" || text == "ignore next" {
            self.ignored += 1;
            return;
        }
        let pieces = match syntax::statements(text) {
            Ok(spans) => spans,
            Err(problem) => {
                self.complain(&problem.message, span);
                return;
            }
        };
        for piece in pieces {
            let part = &text[piece.range()];
            match read(part) {
                Ok(expr) => self.declaration(&expr, place, span),
                Err(problem) => self.complain(&problem.message, span),
            }
        }
    }

    /// Takes in the definitions of a block of queries. Other statements are its own business, and so is
    /// what is wrong with it: weaving tells.
    pub(in crate::judge) fn queries(&mut self, text: &str, place: &Place, span: Span) {
        for piece in syntax::statements(text).unwrap_or_default() {
            let Ok(expr) = read(&text[piece.range()]) else { continue };
            let Kind::Chain(left, links) = &expr.kind else { continue };
            let Some(head) = Head::of(left) else { continue };
            let known = || self.context.definitions.iter().any(|known| known.head.base == head.base);
            let defines = match links.as_slice() {
                [link] => link.rel == Rel::Define || (link.rel == Rel::Eq && !known()),
                _ => false,
            };
            if defines {
                self.define_by(Source::Query, head, Body::Formula(links[0].expr.clone()), &[], place, span);
            }
        }
    }

    fn declaration(&mut self, expr: &Expr, place: &Place, span: Option<Span>) {
        let at = span.unwrap_or_default();
        if let Kind::Chain(left, links) = &expr.kind {
            let defines = links[0].rel == Rel::Define
                || (links[0].rel == Rel::Eq && links.len() == 1 && matches!(left.kind, Kind::Apply(..)));
            if defines && let Some(head) = Head::of(left) {
                let body = Body::Formula(links[0].expr.clone());
                self.define_by(Source::Declaration, head, body, &[], place, at);
                return;
            }
            self.condition(expr.clone(), at, false, place);
            return;
        }
        self.complain(
            "a declaration is a definition such as F(t) := t^2, a condition, or the word ignore",
            span,
        );
    }

    fn complain(&mut self, message: &str, span: Option<Span>) {
        let problem =
            Diagnostic::warning(Code::BadDefinition, format!("this declaration is passed over: {message}"))
                .hint("write, for example, <!-- polarform: F(t) := t^2 + 1 -->");
        self.problems.push(match span {
            Some(span) => problem.at(span),
            None => problem,
        });
    }
}
