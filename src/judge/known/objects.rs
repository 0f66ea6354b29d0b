//! What words say that names stand for, taken in, and what follows of it at once.

use std::rc::Rc;

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::known::meaning::definable;
use crate::judge::page::context::Body;
use crate::judge::page::object::{Declared, Object, Sort};
use crate::judge::page::statement::{Chain, Place, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::written::names::{Head, bases};

impl Checker {
    /// Takes in what words say that names stand for.
    pub(in crate::judge) fn object(&mut self, object: &Object, place: &Place) {
        let line = object.names.first().map_or(0, |name| self.line(name.span));
        let mut object = object.clone();
        // "The polynomial pieces of B_{0,4}" are no other B_{0,4}.
        if let (Some(of), [name]) = (&object.of, object.names.as_slice())
            && of.same_as(name)
        {
            return;
        }
        // The pieces of a spline meet at the data, if nothing else is said.
        if object.sort == Sort::SplineCurve && object.knots.is_empty() && object.points.is_empty() {
            object.knots = object.data.iter().map(|(x, _)| x.clone()).collect();
        }
        // f(0, 1) in a table: a value of f says nothing of what f is.
        if let (Sort::Symbols, [name @ Expr { kind: Kind::Apply(..), .. }], [value]) =
            (&object.sort, object.names.as_slice(), object.values.as_slice())
        {
            let equation = Expr::relation(name.clone(), Rel::Eq, value.clone());
            self.condition(equation, name.span, false, place);
            return;
        }
        // "The point b_i arises …": the b_i that are known
        let known = |head: Head| {
            let known = self.context.object(&head, place).filter(|known| known.place.scope == place.scope);
            known.is_some_and(|known| known.object.has_values())
        };
        if matches!(object.sort, Sort::Symbols | Sort::ControlPoints)
            && object.is_bare()
            && object.names.iter().filter_map(Head::of).all(known)
        {
            return;
        }
        let object = Rc::new(object);
        let declared = Declared { object: object.clone(), place: place.clone(), line };
        Rc::make_mut(&mut self.context).declare(declared);
        if let [name] = object.names.as_slice() {
            for (x, y) in &object.data {
                let value = Expr::apply(name.clone(), vec![x.clone()]);
                self.condition(Expr::relation(value, Rel::Eq, y.clone()), name.span, false, place);
            }
        }
        if object.natural {
            self.natural(&object, place);
        }
        for (head, value) in object.members() {
            let span = value.span;
            self.define(head, Body::Formula(value), &[], place, span);
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
}
