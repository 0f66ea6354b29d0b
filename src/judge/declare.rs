//! Declarations: what a comment or a side file says about the names of the notes.
//!
//! A declaration is a sequence of statements of the query language: definitions
//! (`F(t) := t^2 + 1`), conditions (`0 <= i <= n`, `a + b + c = 1`), or `ignore`, after which the next
//! formula is not judged. What a block of queries defines is declared, too: weaving runs the block, and
//! the text around it speaks of its names.

use super::check::Checker;
use super::context::{Body, Definition, Source};
use super::names::{Head, bases, operated, walk};
use super::object::{Object, Sort};
use super::statement::{Chain, Place, Statement};
use super::topic::Topic;
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::{latex, syntax};

fn read(statement: &str) -> Result<Expr, Diagnostic> {
    if syntax::looks_like_latex(statement) { latex::read(statement) } else { syntax::parse(statement) }
}

impl Checker {
    /// H = FG, where the section is on polar forms: h is that of H, as f and g are those of F and G.
    pub(super) fn convention(&mut self, head: &Head, body: &Expr, statement: &Statement) {
        let function = |base: &String| {
            let object = self.context.object_called(base, &statement.place);
            base.starts_with(char::is_uppercase) && object.is_some_and(|d| d.object.is_function())
        };
        let made = matches!(body.kind, Kind::Mul(_) | Kind::Add(_) | Kind::Compose(_));
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
    pub(super) fn operators(&mut self, chain: &Chain, place: &Place) {
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

    /// "There is one symmetric multiaffine f with f(t, …, t) = F(t)": f is the polar form of F.
    pub(super) fn diagonal(&mut self, chain: &Chain, statement: &Statement) {
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
    pub(super) fn queries(&mut self, text: &str, place: &Place, span: Span) {
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
