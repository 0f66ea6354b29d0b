//! What a chain says of names beside its verdict: definitions, values, formulas that hold.

use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Definition, Source, is_variable};
use crate::judge::page::finding::{Finding, Verdict};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Chain, Place, Role, Statement};
use crate::judge::reasons::lint;
use crate::judge::written::features::missing_argument;
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::lexicon::families;
use crate::language::lexicon::roles::{self, Listed};
use num_traits::Zero;

impl Checker {
    /// The knot vector T = (0, 0, 0, 1, 2, 2, 2) gives t_0, t_1, …, where the page writes its members so.
    pub(in crate::judge) fn gives_knots(&mut self, head: &Head, list: &Expr, place: &Place) {
        let letter = head.base.to_lowercase();
        let whole = head.is_bare();
        let numbers = |items: &&[Expr]| {
            let values: Option<Vec<_>> = items.iter().map(Expr::as_number).collect();
            values.is_some_and(|values| values.len() > 3 && values.is_sorted())
        };
        let Some(items) = list.elements().filter(numbers) else { return };
        let usual = roles::listed(&letter) == Some(Listed::Knots) && letter != head.base;
        let named = self.context.letters.has_members(&letter);
        if !whole || !usual || !named || self.context.visible(&letter, place).next().is_some() {
            return;
        }
        for (number, item) in (0..).zip(items.to_vec()) {
            let member = Head { base: letter.clone(), lower: vec![Expr::int(number)], ..head.clone() };
            self.define(member, Body::Formula(item), &[], place, list.span);
        }
    }

    pub(in crate::judge) fn definition(
        &mut self,
        chain: &Chain,
        head: &Head,
        statement: &Statement,
        finding: &mut Finding,
    ) {
        let place = &statement.place;
        let body = &chain.sides[1];
        if body.is_unread() {
            return;
        }
        finding.verdict = Verdict::Definition;
        finding.reason = Some(format!("introduces {}", head.base));
        finding.warning = lint::definition(head, &body.expr, &chain.conditions);
        if self.is_queried(head, place) {
            return;
        }
        // A derivative is not defined by a formula for it, nor f(t) by one in t_1, …, t_n.
        let derivative = head.parenthesized
            && head.arguments.is_some()
            && head.upper.iter().all(|upper| matches!(&upper.kind, Kind::Name(_) | Kind::Number(_)));
        // The pieces of one B-spline follow from the recursion for all.
        let pieces = head.base == families::SPLINE
            && !head.lower.is_empty()
            && matches!(body.expr.kind, Kind::Cases(_))
            && head.lower.iter().all(|index| matches!(index.kind, Kind::Number(_)));
        // If p is prime, φ(p) = p - 1: of other p it says nothing.
        let restricted = head.flat().iter().filter_map(|argument| Head::of(argument)).any(|argument| {
            self.context
                .object_called(&argument.base, place)
                .is_some_and(|declared| matches!(declared.object.sort, Sort::Other(_)))
        });
        // N_j^p = 0 for j < 0 or j > n
        let vanishes = matches!(&body.expr.kind, Kind::Number(q) if q.is_zero()) && head.notation().is_some();
        // f(x) = f(1 - x), N^p(x) = Σ c_k N^p(2x - k): a law of the function.
        if relates_its_own_values(head, &body.expr) {
            finding.reason = Some(format!("a condition on {}", head.base));
            let line = self.line(body.expr.span);
            self.laws.push((head.base.clone(), place.clone(), line));
            return;
        }
        if self.is_last_member(head, place) {
            let equation = Expr::relation(chain.sides[0].expr.clone(), Rel::Eq, body.expr.clone());
            self.condition(equation, body.expr.span, false, place);
            return;
        }
        if derivative || pieces || vanishes || restricted || missing_argument(head, &body.expr).is_some() {
            return;
        }
        let given = matches!(statement.role, None | Some(Role::Introduced));
        let source = if given { Source::Given } else { Source::Page };
        let mut formula = body.expr.clone();
        for (member, value) in self.members_listed(head, &formula, place) {
            self.define_by(source, member, Body::Formula(value), &chain.conditions, place, body.expr.span);
        }
        // p(t) = B_3^5 + B_4^5: all at t
        if let [variable @ Expr { kind: Kind::Name(name), .. }] = head.flat().as_slice()
            && is_variable(name)
            && !bases(&formula).contains(name)
        {
            self.apply_families(&mut formula, variable, place);
            formula = self.with_parameter(formula, name, place);
        }
        let head = &with_its_variables(head, &formula);
        self.define_by(
            source,
            head.clone(),
            Body::Formula(formula),
            &chain.conditions,
            place,
            body.expr.span,
        );
        // s = Σ c_i N_{i,p} is s(x) = Σ c_i N_{i,p}(x).
        let plain = head.is_bare();
        if plain && body.expr.has(&|part| matches!(part.kind, Kind::Big { .. })) {
            let used = bases(&body.expr);
            let Some(variable) = ["x", "t", "u"].into_iter().find(|name| !used.contains(*name)) else {
                return;
            };
            let mut applied = body.expr.clone();
            if self.apply_families(&mut applied, &Expr::name(variable), place) {
                let head = Head { arguments: Some(vec![vec![Expr::name(variable)]]), ..head.clone() };
                self.define(head, Body::Formula(applied), &chain.conditions, place, body.expr.span);
            }
        }
    }

    /// b(u) = Σ b_i B_i^n(t) with t = (u - a)/(b - a): what t is there, wherever another t comes later.
    fn with_parameter(&self, formula: Expr, variable: &str, place: &Place) -> Expr {
        let inner = |name: &String| {
            let (_, own, _) = self.context.visible(name, place).next()?;
            let Body::Formula(body) = &own.body else { return None };
            let alone = own.head.lower.is_empty() && own.head.arguments.is_none();
            let here = own.place.group == place.group && own.place.formula + 1 >= place.formula;
            (is_variable(name) && alone && here && bases(body).contains(variable))
                .then(|| body.clone().grouped())
        };
        match bases(&formula).iter().find_map(|name| Some((name.clone(), inner(name)?))) {
            Some((name, body)) => formula.with_name(&name, &body),
            None => formula,
        }
    }

    /// b = (0, 6, 3, 3), where the page speaks of b_0, b_1, …: what these are.
    fn members_listed(&self, head: &Head, list: &Expr, place: &Place) -> Vec<(Head, Expr)> {
        let plain = head.is_bare();
        let constant = |value: &Expr| bases(value).is_empty() && value.kind != Kind::Ellipsis;
        // Of (1, 2) it is not known whether it is one point.
        let values = list.items().filter(|values| {
            let points = values.iter().all(|value| value.items().is_some());
            plain && values.iter().all(constant) && (values.len() > 2 || points && values.len() > 1)
        });
        let Some(values) = values.filter(|_| self.context.letters.has_members(&head.base)) else {
            return Vec::new();
        };
        // P = (1, 2, 3) is another point than P_0 = (0, 0, 1).
        let point = |(_, definition, _): (usize, &Definition, bool)| match &definition.body {
            Body::Formula(body) => !definition.head.lower.is_empty() && body.items().is_some(),
            Body::Value(value) => value.as_scalar().is_none(),
        };
        if values[0].items().is_none() && self.context.visible(&head.base, place).any(point) {
            return Vec::new();
        }
        let first = self.context.listed(&head.base, place).map_or(Some(0), |(first, _)| first.as_int());
        let Some(first) = first else { return Vec::new() };
        let member =
            |(value, i): (&Expr, i64)| (Head { lower: vec![Expr::int(i)], ..head.clone() }, value.clone());
        values.iter().zip(first..).map(member).collect()
    }

    /// (a_0, a_1, a_2) = (1, 2, 1), of which nothing is known: takes in what each of them is.
    pub(in crate::judge) fn gives_members(&mut self, chain: &Chain, place: &Place) {
        let [left, right] = chain.sides.as_slice() else { return };
        let (Some(names), Some(values)) = (left.expr.items(), right.expr.items()) else { return };
        let member = |name: &Expr| {
            Head::of(name).filter(|head| head.index().is_some_and(|index| index.as_int().is_some()))
        };
        let heads: Vec<Head> = names.iter().filter_map(member).collect();
        if heads.len() == names.len() && heads.len() == values.len() {
            for (head, value) in heads.into_iter().zip(values) {
                self.define(head, Body::Formula(value.clone()), &[], place, value.span);
            }
        }
    }

    /// A formula that holds for Lagrange polynomials says what they are for other nodes, too, and one for what is known from its
    /// paragraph only says what it is in the next ones.
    pub(in crate::judge) fn keep(&mut self, chain: &Chain, head: &Head, place: &Place, finding: &Finding) {
        let spoken = self
            .context
            .object(head, place)
            .is_some_and(|known| known.object.sort == Sort::Lagrange || known.object.local);
        let holds = matches!(finding.verdict, Verdict::Proved | Verdict::Sampled);
        if spoken && holds && !head.flat().is_empty() && !self.is_covered(head, place) {
            let body = &chain.sides[1].expr;
            self.define(head.clone(), Body::Formula(body.clone()), &chain.conditions, place, body.span);
        }
    }

    /// Gives an argument to each member of a family of functions that has none; whether there is one.
    fn apply_families(&self, expr: &mut Expr, argument: &Expr, place: &Place) -> bool {
        if let Kind::Apply(..) = expr.kind {
            return false;
        }
        let one = |head: &Head| (1..3).contains(&head.lower.len());
        let member = Head::of(expr).filter(one).is_some_and(|head| {
            let spoken = self.context.object(&head, place).is_some_and(|known| known.object.is_function());
            spoken || head.notation().is_some()
        });
        if member {
            *expr = Expr::apply(expr.clone(), vec![argument.clone()]);
            return true;
        }
        if let Kind::Big { body, .. } = &mut expr.kind {
            return self.apply_families(body, argument, place);
        }
        let mut found = false;
        expr.for_each_child_mut(&mut |child| found |= self.apply_families(child, argument, place));
        found
    }

    /// r_n, where the points are r_0, …, r_n: a formula for it says what the last one is, and nothing of the others.
    fn is_last_member(&self, head: &Head, place: &Place) -> bool {
        let [index] = head.lower.as_slice() else { return false };
        head.arguments.is_none()
            && !matches!(index.kind, Kind::Number(_))
            && self.context.listed(&head.base, place).is_some_and(|(_, last)| index.same_as(&last))
    }

    /// (z_{ij}) = a matrix: takes in its entries.
    pub(in crate::judge) fn gives_entries(&mut self, chain: &Chain, place: &Place) -> bool {
        let ([left, right], [(Rel::Eq | Rel::Define, _)]) =
            (chain.sides.as_slice(), chain.relations.as_slice())
        else {
            return false;
        };
        let (Kind::Group(member), Kind::Matrix(rows, _)) = (&left.expr.kind, &right.expr.kind) else {
            return false;
        };
        let letter = |index: &Expr| matches!(&index.kind, Kind::Name(name) if is_index_letter(name));
        let Some(head) = Head::of(member).filter(|head| {
            head.lower.len() == 2 && head.arguments.is_none() && head.lower.iter().all(letter)
        }) else {
            return false;
        };
        let first = self.context.letters.first_row();
        for (i, row) in (first..).zip(rows) {
            for (j, entry) in (first..).zip(row) {
                if let Some(entry) = entry {
                    let lower = vec![Expr::int(i), Expr::int(j)];
                    let body = Body::Formula(entry.clone());
                    self.define(Head { lower, ..head.clone() }, body, &[], place, entry.span);
                }
            }
        }
        true
    }

    /// [a, b] = [0, 2], (p, q) = (1, 3): takes in the values of names that mean nothing in this section.
    pub(in crate::judge) fn gives_values(&mut self, chain: &Chain, statement: &Statement) -> bool {
        let place = &statement.place;
        let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return false };
        let (Some(names), Some(values)) = (chain.sides[0].expr.items(), chain.sides[1].expr.items()) else {
            return false;
        };
        let new = |name: &Expr| match &name.kind {
            Kind::Name(base) if self.context.letters.is_beside_bold(name) => {
                !self.context.is_named_alone(base, place)
            }
            Kind::Name(base) => !self.context.visible(base, place).any(|(_, _, near)| near),
            // t_j = j elsewhere, and other knots in an example
            Kind::Subscript(..) => Head::of(name).is_some_and(|head| {
                let anew = statement.role == Some(Role::Introduced);
                let mut known =
                    self.context.visible(&head.base, place).filter(|(_, _, near)| *near).peekable();
                head.index().is_some_and(|index| index.as_int().is_some())
                    && known.peek().is_some()
                    && known.all(|(_, own, _)| {
                        own.place.blocks.len() < place.blocks.len() && (anew || own.is_datum())
                    })
            }),
            _ => false,
        };
        let constant = |value: &Expr| bases(value).is_empty() && value.kind != Kind::Ellipsis;
        let gives = names.len() == values.len()
            && statement.role != Some(Role::Claimed)
            && names.iter().all(new)
            && values.iter().all(constant);
        if gives {
            for (head, value) in names.iter().filter_map(Head::of).zip(values) {
                self.define(head, Body::Formula(value.clone()), &[], place, value.span);
            }
        }
        gives
    }
}

/// Whether a formula for a function contains other values of the same function.
fn relates_its_own_values(head: &Head, body: &Expr) -> bool {
    let alike = |a: &[Expr], b: &[Expr]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.same_as(b));
    let itself = |part: &Expr| {
        matches!(part.kind, Kind::Apply(..))
            && Head::of(part).is_some_and(|own| {
                own.base == head.base && alike(&own.lower, &head.lower) && alike(&own.upper, &head.upper)
            })
    };
    head.arguments.is_some() && body.has(&itself)
}

/// S_{uv} = … in u and v is S_{uv}(u, v).
fn with_its_variables(head: &Head, body: &Expr) -> Head {
    let letters: Vec<String> = head.lower.iter().flat_map(bases).collect();
    let used: Vec<String> = bases(body).into_iter().filter(|name| is_variable(name)).collect();
    let partial = head.arguments.is_none()
        && head.upper.is_empty()
        && !letters.is_empty()
        && used.len() > 1
        && letters.iter().all(|letter| used.contains(letter));
    let arguments = partial.then(|| vec![used.into_iter().map(Expr::name).collect()]);
    Head { arguments: arguments.or(head.arguments.clone()), ..head.clone() }
}
