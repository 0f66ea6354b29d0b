//! Whether the left side of an equation has a meaning already: then the equation is a claim, else a
//! definition.

use std::collections::BTreeSet;

use crate::formula::{Expr, Kind, Rel, Term};
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, Condition, Definition, Source, is_variable, value_given};
use crate::judge::page::object::{Object, Sort};
use crate::judge::page::statement::{Chain, Curve, Place};
use crate::judge::written::names::{
    Head, base_of, bases, calls, capital_of, has_members, integer_names, is_capital, is_index_letter,
    is_range, polar_names, primed, underived, walk,
};
use crate::language::lexicon::families::{self, Family};
use crate::language::lexicon::words::is_function_word;
use crate::language::write;
use crate::math::poly::Symbol;
use num_traits::Zero;

/// The left side of a definition: a name, perhaps with indices, applied to distinct names.
pub fn definable(expr: &Expr) -> Option<Head> {
    let head = Head::of(expr).filter(|head| !is_function_word(&head.base) || head.base == "inner")?;
    // q_{2i+1} beside q_{2i}, but not F_{n+1}, of which F_n is one, too
    let odd = |index: &Expr| match &index.kind {
        Kind::Add(terms) => {
            matches!(
                terms.as_slice(),
                [
                    Term { expr: Expr { kind: Kind::Mul(_), .. }, .. },
                    Term { expr: Expr { kind: Kind::Number(_), .. }, .. }
                ]
            )
        }
        _ => false,
    };
    let simple = |index: &Expr| {
        let name = matches!(
            index.kind,
            Kind::Name(_) | Kind::Number(_) | Kind::Text(_) | Kind::Accent(..) | Kind::Mul(_)
        );
        name || odd(index)
    };
    if !head.lower.iter().chain(&head.upper).all(simple) {
        return None;
    }
    // t^j is a power, unless the name is applied to something or has another index.
    if head.arguments.is_none() && head.lower.is_empty() && !head.upper.is_empty() && !head.parenthesized {
        return None;
    }
    // Δ f_i and D f are values of operators; Δ = t_1 - t_0 gives a name.
    if matches!(head.base.as_str(), "Delta" | "nabla" | "D") && head.arguments.is_some() {
        return None;
    }
    // f(t_1, t_2, t_3) has places; f(t_2, t_3, t) is a value at knots.
    let numbered: Vec<(String, i64)> = head
        .flat()
        .iter()
        .filter_map(|argument| {
            // K_3 in P(K_3, k) is a thing.
            let own = Head::of(argument).filter(|own| !is_capital(&own.base))?;
            let index = own.index()?.as_int()?;
            Some((own.base, index))
        })
        .collect();
    if let Some((_, first)) = numbered.first()
        && !head.flat().iter().any(|argument| argument.kind == Kind::Ellipsis)
    {
        let mut expected: Option<(String, i64)> = None;
        let in_order = numbered.iter().all(|(base, index)| {
            let fits = match &expected {
                Some((known, next)) if known == base => index == next,
                _ => *index <= 1,
            };
            expected = Some((base.clone(), index + 1));
            fits
        });
        if numbered.len() != head.flat().len() || !in_order || *first > 1 {
            return None;
        }
    }
    let mut names: Vec<String> = Vec::new();
    let arguments = head.flat();
    let dots = arguments.iter().any(|argument| argument.kind == Kind::Ellipsis);
    for argument in arguments {
        if argument.kind == Kind::Ellipsis {
            continue;
        }
        // f((x_1, y_1), (x_2, y_2))
        if let Some(coordinates) = argument.items() {
            for coordinate in coordinates {
                Head::of(coordinate).filter(|own| own.arguments.is_none() && own.upper.is_empty())?;
                let text = write::text(coordinate);
                if names.contains(&text) {
                    return None;
                }
                names.push(text);
            }
            continue;
        }
        let own = Head::of(argument)?;
        if own.arguments.is_some() || !own.upper.is_empty() {
            return None;
        }
        // S(x_i) is a value at a node.
        let at_node = !dots && own.lower.iter().any(|index| !matches!(index.kind, Kind::Number(_)))
            || !dots && head.flat().len() == 1 && own.lower.len() == 1;
        if at_node {
            return None;
        }
        let text = write::text(argument);
        if names.contains(&text) {
            return None;
        }
        names.push(text);
    }
    Some(head)
}

/// Whether a definition could be the one of a head: the same numbers of indices and arguments, and
/// every index of the head is covered.
fn covers(definition: &Definition, head: &Head) -> bool {
    let own = &definition.head;
    let index = |pattern: &Expr, index: &Expr| match (&pattern.kind, &index.kind) {
        (Kind::Name(name), _) if is_index_letter(name) => true,
        _ => pattern.same_as(index),
    };
    let dots = |head: &Head| head.flat().iter().any(|argument| argument.kind == Kind::Ellipsis);
    is_alike(own, head)
        && own.lower.iter().zip(&head.lower).all(|(a, b)| index(a, b))
        && own.upper.iter().zip(&head.upper).all(|(a, b)| index(a, b))
        && (dots(own) || dots(head) || own.flat().len() == head.flat().len())
}

/// Whether a formula gives a function by cases between members with its own index: B_{j,1}(x) = 1 for t_j ≤ x < t_{j+1}.
/// So begin B-splines, whatever their letter.
fn is_between_knots(head: &Head, body: &Expr) -> bool {
    let Kind::Cases(cases) = &body.kind else { return false };
    let Some(Expr { kind: Kind::Name(index), .. }) = head.lower.first() else { return false };
    let member = |part: &Expr| match &part.kind {
        Kind::Subscript(_, lower) => lower.iter().any(|own| bases(own).contains(index)),
        _ => false,
    };
    let ranged = |condition: &Expr| is_range(condition) && condition.has(&member);
    cases.iter().filter_map(|(_, condition)| condition.as_ref()).any(ranged)
}

/// Whether two names have as many indices, and both or neither of them arguments.
fn is_alike(one: &Head, other: &Head) -> bool {
    one.lower.len() == other.lower.len()
        && one.upper.len() == other.upper.len()
        && one.arguments.is_some() == other.arguments.is_some()
}

impl Checker {
    /// Whether a recursion of the section leads to a member from those before it: T_3(x), after T_0(x), T_1(x) and
    /// T_{n+1}(x) = 2x T_n(x) - T_{n-1}(x).
    fn follows_by_recursion(&self, head: &Head, place: &Place) -> bool {
        let [index] = head.lower.as_slice() else { return false };
        let Some(number) = index.as_int().filter(|_| head.arguments.is_some()) else { return false };
        let own = |definition: &Definition| {
            let [index] = definition.head.lower.as_slice() else { return None };
            Some((index.clone(), definition.is_recursive()))
        };
        let near = || {
            let visible = self.context.visible(&head.base, place).filter(|(_, _, near)| *near);
            visible.filter_map(|(_, definition, _)| own(definition))
        };
        let steps = near().any(|(index, recursive)| recursive && matches!(index.kind, Kind::Add(_)));
        let before: Vec<i64> = near().filter_map(|(index, _)| index.as_int()).collect();
        steps && before.iter().filter(|other| **other < number).count() > 1
    }

    /// Whether a query nearby gives a value for a name as a whole.
    pub(in crate::judge) fn is_queried(&self, head: &Head, place: &Place) -> bool {
        let whole = head.is_bare();
        whole
            && self.context.visible(&head.base, place).next().is_some_and(|(_, d, near)| {
                near && d.source == Source::Query && d.head.lower.is_empty() && d.head.arguments.is_none()
            })
    }

    /// Whether a name is where a recursion begins that the page gave before: b_i^0, after b_i^k.
    fn begins(&self, recursion: &Definition, head: &Head, place: &Place) -> bool {
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        let bare = |own: &Head| !own.lower.iter().chain(&own.upper).any(number);
        recursion.is_recursive()
            && bare(&recursion.head)
            && !bare(head)
            && self
                .context
                .visible(&head.base, place)
                .filter(|(_, d, _)| is_alike(&d.head, head))
                .all(|(_, d, _)| d.is_recursive() && bare(&d.head))
    }

    /// "At t = 1/3 we get b_0^1 = …", where what b_0^1 is was said at t = 1/2; "if p(1) = p'(1) = 0, then p(t) = …", where
    /// another formula for p was said if p(1) = 0.
    pub(in crate::judge) fn is_of_another_case(&self, head: &Head, chain: &Chain, place: &Place) -> bool {
        let own: BTreeSet<String> = head.flat().into_iter().flat_map(bases).collect();
        let other = |condition: &Expr| match value_given(condition) {
            // What is said of p(t) at t = 1 is said of all t.
            Some((name, _)) if own.contains(name) => false,
            Some((name, value)) => {
                let mut here = chain.conditions.iter().filter_map(value_given);
                here.any(|(same, now)| same == name && !now.same_as(value))
            }
            None => {
                let equation = matches!(&condition.kind, Kind::Chain(_, links) if links.iter().all(|link| link.rel == Rel::Eq));
                equation
                    && !chain.conditions.is_empty()
                    && !chain.conditions.iter().any(|here| here.same_as(condition))
                    && bases(condition).contains(&head.base)
            }
        };
        let mut known = self.context.visible(&head.base, place);
        let known = known.find(|(_, definition, near)| *near && covers(definition, head));
        known.is_some_and(|(_, definition, _)| {
            is_alike(&definition.head, head) && definition.conditions.iter().any(other)
        })
    }

    /// Whether words say what a name is, and all that it is made of is known.
    pub(in crate::judge) fn is_determined(&self, head: &Head, place: &Place) -> bool {
        let Some(object) = self.context.object(head, place).map(|declared| &declared.object) else {
            return false;
        };
        // "Let the polar form be f(u, v) = …" says what f is, if F is unknown.
        let known = |of: &Expr| match Head::of(of).filter(|head| head.upper.is_empty()) {
            Some(head) => {
                self.context.object_called(&head.base, place).is_some()
                    || self.context.visible(&head.base, place).next().is_some()
            }
            None => true,
        };
        object.determines() && object.of.as_ref().is_none_or(known)
    }

    /// Whether a formula of another section says what a name is.
    pub(in crate::judge) fn is_covered(&self, head: &Head, place: &Place) -> bool {
        self.context.visible(&head.base, place).any(|(_, definition, _)| covers(definition, head))
    }

    /// Whether a name has a meaning already, so that an equation for it is a claim.
    pub(in crate::judge) fn is_known(
        &self,
        head: &Head,
        body: &Expr,
        place: &Place,
        curve: &Option<Curve>,
    ) -> bool {
        let own = self.context.is_own(&head.base, place) || is_between_knots(head, body);
        let standard = match head.notation().map(|notation| notation.family).filter(|_| !own) {
            Some(Family::Bernstein | Family::Triangular) => true,
            Some(Family::SymmetricMean) => head.arguments.is_some(),
            // N_{1,2} on the knots 0, 0, 0, 1, 1, 1
            Some(Family::Spline) => {
                let letters = self.context.knot_letters(place, &[]);
                let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
                head.lower.iter().all(number)
                    && self.context.visible(&head.base, place).next().is_none()
                    && !self.context.given_knots(&letters, place).is_empty()
            }
            None => false,
        };
        let right = bases(body);
        let recursive = right.contains(&head.base);
        if standard
            || self.is_determined(head, place)
            || self
                .context
                .visible(&head.base, place)
                .any(|(_, d, near)| covers(d, head) && (near || recursive) && !self.begins(d, head, place))
            || self.follows_by_recursion(head, place)
        {
            return true;
        }
        if curve.as_ref().is_some_and(|curve| curve.points == head.base)
            && head.arguments.is_none()
            && head.upper.is_empty()
        {
            return true;
        }
        // b_1 of a list b that a query gives, f(t_1, t_2) of a polar form f
        let part = match (&*head.lower, &head.arguments) {
            ([Expr { kind: Kind::Number(_), .. }], None) | ([], Some(_)) => head.upper.is_empty(),
            _ => false,
        };
        let given = |definition: &Definition| {
            definition.source == Source::Query
                && definition.head.lower.is_empty()
                && definition.head.arguments.is_none()
        };
        if part && self.context.visible(&head.base, place).next().is_some_and(|(_, d, near)| near && given(d))
        {
            return true;
        }
        // g = f', and then g(t) = …
        let derived = |definition: &Definition| {
            definition.head.is_bare()
                && matches!(&definition.body, Body::Formula(Expr { kind: Kind::Prime(..), .. }))
        };
        if head.lower.is_empty()
            && head.upper.is_empty()
            && head.arguments.is_some()
            && self
                .context
                .visible(&head.base, place)
                .next()
                .is_some_and(|(_, own, near)| near && derived(own))
        {
            return true;
        }
        let function = self.context.letters.is_function(&head.base);
        let plain = head.lower.is_empty() && head.upper.is_empty();
        let plain_below = head.lower.is_empty();
        let base_known = || {
            plain_below
                && self.context.visible(&head.base, place).any(|(_, d, near)| {
                    near && d.head.upper.is_empty()
                        && d.head.arguments.is_some()
                        && d.head.lower.len() == head.lower.len()
                })
        };
        // F^{(q)}(u), f^r(t), f^{(+1)}(…), f_u(u, v)
        if let ([upper], Some(_)) = (head.upper.as_slice(), &head.arguments)
            && function
        {
            let order = match &upper.kind {
                Kind::Name(name) => is_index_letter(name),
                Kind::Number(_) => head.parenthesized,
                _ => false,
            };
            let spoken = || {
                let plain = Head { upper: Vec::new(), ..head.clone() };
                self.context.object(&plain, place).is_some_and(|known| known.object.is_function())
            };
            if order
                && (head.parenthesized
                    && (spoken()
                        || polar_names(&head.base).any(|name| calls(body, &name))
                        || calls(body, &head.base))
                    || base_known())
            {
                return true;
            }
        }
        if head.upper.is_empty() && self.context.variables_of_partial(head, place).is_some() {
            return true;
        }
        if !plain {
            return false;
        }
        // The polar form of a function that is known, or that the right-hand side speaks of.
        let capital = capital_of(&head.base);
        let count = head.flat().len();
        let of_known = || {
            self.context.visible(&capital, place).any(|(_, definition, _)| {
                definition.head.flat().len() == 1
                    && definition.head.lower.is_empty()
                    && definition.head.upper.is_empty()
            })
        };
        if capital != head.base {
            // What words call a curve or a polynomial is no polar form for its small letter.
            let spoken = self.context.object(head, place).map(|declared| &declared.object);
            if spoken.is_some_and(|object| object.is_function() && object.sort != Sort::PolarForm) {
                return false;
            }
            if head.arguments.is_some() {
                let polar = count > 1 || curve.is_some();
                return polar
                    && (of_known()
                        || curve.is_some()
                        || right.contains(&capital) && !has_members(body, std::slice::from_ref(&capital))
                        || calls_itself(body, &head.base))
                    || count == 1 && of_known();
            }
            return function && of_known();
        }
        // F(t) = f(t, …, t), F(t) = Σ F^{(i)}(τ) …
        head.arguments.is_some()
            && polar_names(&head.base).any(|name| {
                calls_plain(body, &name) && self.context.letters.is_function(&name)
                    || calls_itself(body, &head.base)
            })
    }

    /// Whether a formula without the indices of its name cannot be one for all members of a family that another formula
    /// gives.
    pub(in crate::judge) fn is_of_some_members(&self, head: &Head, body: &Expr, place: &Place) -> bool {
        let letters =
            |head: &Head| head.lower.iter().chain(&head.upper).flat_map(bases).collect::<Vec<String>>();
        let indices = letters(head);
        let inside = bases(body);
        let given = |definition: &Definition| match &definition.body {
            Body::Formula(own) => {
                let (theirs, own) = (letters(&definition.head), bases(own));
                indices.len() == theirs.len()
                    && covers(definition, head)
                    && theirs.iter().any(|index| own.contains(index))
            }
            Body::Value(_) => false,
        };
        !indices.is_empty()
            && !indices.iter().any(|index| inside.contains(index))
            && self.context.visible(&head.base, place).any(|(_, definition, near)| near && given(definition))
    }

    /// Whether an equation is the only one for members of a family of which the page gives some by number, as a_0 = 1 and
    /// a_{n+1} = 2 a_n; with its left side if it is a recursion.
    pub(in crate::judge) fn recursion(
        &self,
        left: &Expr,
        right: &Expr,
        place: &Place,
    ) -> Option<Option<Head>> {
        let own = Head::of(left).filter(|own| !own.lower.is_empty())?;
        // T_{n+1}(x) = 2x T_n(x) - T_{n-1}(x)
        let variable = |argument: &&Expr| matches!(&argument.kind, Kind::Name(name) if is_variable(name));
        if own.arguments.is_some() && (own.notation().is_some() || !own.flat().iter().all(variable)) {
            return None;
        }
        let given = |head: &Head| head.lower.iter().all(|index| matches!(index.kind, Kind::Number(_)));
        let members: Vec<&Head> =
            self.context.visible(&own.base, place).map(|(_, definition, _)| &definition.head).collect();
        let mut alike = members.into_iter().filter(|head| head.lower.len() == own.lower.len()).peekable();
        if alike.peek().is_none() || given(&own) || !alike.all(given) {
            return None;
        }
        let steps = own.lower.iter().all(|index| integer_names(index).len() <= 1);
        let recursive = bases(right).contains(&own.base) && steps;
        Some(recursive.then_some(own))
    }

    /// Whether an equation says what the value of a function or a derivative is at a place: S(x_i) = y_i. What is
    /// made of the function itself says nothing new of it.
    pub(in crate::judge) fn is_datum(&self, left: &Expr, right: &Expr, place: &Place) -> bool {
        let Kind::Apply(callee, _) = &left.kind else { return false };
        let mut function = callee.as_ref();
        while let Kind::Prime(inner, _) | Kind::Accent(_, inner) = &function.kind {
            function = inner;
        }
        Head::of(function).is_some_and(|head| {
            let inside = self.context.reached(&[right], place);
            let another = |expr: &Expr| {
                matches!(&expr.kind, Kind::Apply(_, groups)
                    if groups.iter().flatten().all(|argument| matches!(argument.kind, Kind::Number(_))))
            };
            !inside.contains(&head.base) && !polar_names(&head.base).any(|name| inside.contains(&name))
                || another(left) && another(right)
        })
    }

    /// S''(x) = … of an unknown S tells what its derivative is.
    pub(in crate::judge) fn new_derivative(&self, chain: &Chain, place: &Place) -> Option<Head> {
        let Kind::Apply(callee, groups) = &chain.sides[0].expr.kind else { return None };
        let Kind::Prime(function, order) = &callee.kind else { return None };
        let head = Head::of(function)?;
        let own = Head {
            base: primed(&head.base, *order as usize),
            arguments: Some(groups.clone()),
            ..head.clone()
        };
        let bare = groups
            .iter()
            .flatten()
            .all(|argument| matches!(&argument.kind, Kind::Name(name) if is_variable(name)));
        // F'(s) = G'(s) says that two functions agree.
        let class = |head: &Head| self.context.object_of_a_class(&head.base, place).is_some();
        if let Kind::Apply(other, _) = &chain.sides[1].expr.kind
            && let Kind::Prime(other, _) = &other.kind
            && class(&head)
            && Head::of(other).is_some_and(|other| class(&other))
        {
            return None;
        }
        let right = bases(&chain.sides[1].expr);
        // s = Σ c_i N_{i,p} is a function, too.
        let of_functions = |d: &Definition| match &d.body {
            Body::Formula(body) => bases(body).iter().any(|base| {
                families::is_family(base)
                    || self.context.object_called(base, place).is_some_and(|known| known.object.is_function())
            }),
            Body::Value(_) => false,
        };
        let known = self.context.object(&head, place).is_some_and(|known| known.object.determines())
            || self
                .context
                .visible(&head.base, place)
                .any(|(_, d, near)| d.head.arguments.is_some() || near && of_functions(d))
            || right.contains(&head.base)
            || right.contains(&head.base.to_lowercase())
            || self.context.visible(&own.base, place).any(|(.., near)| near);
        (bare && !known).then_some(own)
    }

    /// x_1^2 = 4 x_0 x_2, where the page says what x_1 is: a power, and no name. In b_0^2 = (1 - t) b_0^1 + t b_1^1 nothing of
    /// the family is multiplied by its own.
    pub(in crate::judge) fn is_power_of_member(&self, head: &Head, right: &Expr, place: &Place) -> bool {
        let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
        let [upper] = head.upper.as_slice() else { return false };
        if head.arguments.is_some() || head.parenthesized || head.lower.is_empty() || !number(upper) {
            return false;
        }
        let own = |factor: &Expr| Head::of(factor).is_some_and(|other| other.base == head.base);
        let product = right.has(&|part| match &part.kind {
            Kind::Mul(factors) => factors.iter().filter(|factor| own(factor)).count() > 1,
            _ => false,
        });
        let member = Head { upper: Vec::new(), ..head.clone() };
        product && self.is_covered(&member, place)
    }

    /// Whether a claim rests on knots that the page does not give.
    pub(in crate::judge) fn invents_knots(&self, left: &Expr, right: &Expr, place: &Place) -> bool {
        let letters = self.context.knot_letters(place, &[left, right]);
        let indexed = [left, right].iter().any(|side| has_members(side, &letters));
        let bases = bases(left).into_iter().chain(bases(right));
        // s(1): between which knots 1 lies decides.
        let at_number = [left, right].iter().any(|side| {
            side.has(&|part| {
                matches!(&part.kind, Kind::Apply(_, groups)
                    if matches!(groups.concat().as_slice(), [only] if self::bases(only).is_empty()))
            })
        });
        // N_1 on the knots t_1, …, t_4: formulas without them are for numbers.
        let member = |name: &Expr| {
            let number = |index: &Expr| matches!(index.kind, Kind::Number(_));
            Head::of(name).is_some_and(|head| head.lower.iter().any(number) && head.arguments.is_none())
        };
        let numbered = at_number
            || [left, right]
                .iter()
                .any(|side| side.has(&|part| matches!(&part.kind, Kind::Apply(callee, _) if member(callee))));
        let number = |knot: &Expr| self::bases(knot).is_empty() && knot.kind != Kind::Ellipsis;
        let mut heads = Vec::new();
        for side in [left, right] {
            walk(side, &mut |part| heads.extend(Head::of(part).filter(|head| !head.lower.is_empty())));
        }
        let given = bases.into_iter().any(|base| {
            self.context.object_called(&base, place).is_some_and(|declared| {
                let Object { knots, sort, .. } = &*declared.object;
                // The knots of N_0 are not those of N_1.
                let own = *sort != Sort::BSpline
                    || heads.iter().all(|head| head.base != base || declared.object.name_for(head).is_some());
                !knots.is_empty() && (!numbered || own && knots.iter().any(number))
            }) || !at_number
                && self.context.visible(&base, place).any(|(_, d, _)| {
                    d.head.arguments.is_some()
                        && !d.head.lower.iter().any(|i| matches!(i.kind, Kind::Number(_)))
                })
        });
        let listed = !self.context.given_knots(&letters, place).is_empty();
        let open = !indexed || at_number;
        open && !given && !listed && (numbered || self.context.stated_knots(place).is_empty())
    }

    /// Whether a hypothesis of the section speaks of a name.
    pub(in crate::judge) fn is_constrained(&self, base: &str, place: &Place) -> bool {
        self.conditions_on(base, place)
            .any(|condition| matches!(&condition.kind, Kind::Chain(_, links) if links[0].rel == Rel::Eq))
    }

    /// Whether a condition introduced a name: a ≠ b, 0 < c < 1.
    pub(in crate::judge) fn is_restricted(&self, base: &str, place: &Place) -> bool {
        self.conditions_on(base, place).any(is_range)
    }

    /// The conditions of the section that speak of a name.
    fn conditions_on<'a>(&'a self, base: &'a str, place: &'a Place) -> impl Iterator<Item = &'a Expr> {
        let alive = |c: &&Condition| place.knows(&c.place, c.assumed);
        let expressions = self.context.conditions.iter().filter(alive).map(|condition| &condition.expr);
        expressions.filter(|expr| bases(expr).contains(base))
    }

    /// Whether words make a symbol one of the points of something: c has the control points b_0, …, b_n.
    pub(in crate::judge) fn is_point_of_an_object(&self, symbol: &Symbol, place: &Place) -> bool {
        let own = |point: &Expr| Head::of(point).is_some_and(|head| head.base == base_of(symbol));
        let told = self.context.objects.iter().filter(|told| place.knows(&told.place, false));
        told.into_iter().any(|told| told.object.points.iter().any(own))
    }

    /// Whether no definition speaks of the family of a symbol.
    pub(in crate::judge) fn is_open(&self, symbol: &Symbol, curve: &Option<Curve>) -> bool {
        let points = curve.as_ref().is_some_and(|curve| curve.points == symbol.base());
        let mut mentioned = false;
        for definition in &self.context.definitions {
            if let Body::Formula(body) = &definition.body {
                walk(body, &mut |part| {
                    mentioned |= Head::of(part).is_some_and(|head| {
                        head.base == base_of(symbol) && head.upper.len() == symbol.upper().len()
                    });
                });
            }
        }
        !points && !mentioned
    }

    /// Whether the page says that a member of one of these families is another one: b_3 = b_0.
    pub(in crate::judge) fn has_equal_members(&self, letters: &BTreeSet<String>, place: &Place) -> bool {
        let member = |head: &Head| head.arguments.is_none() && head.lower.len() == 1 && head.upper.is_empty();
        letters.iter().any(|letter| {
            self.context.visible(letter, place).any(|(_, definition, near)| {
                let Body::Formula(body) = &definition.body else { return false };
                let same = Head::of(body).filter(&member).is_some_and(|other| other.base == *letter);
                near && member(&definition.head) && same
            })
        })
    }
}

/// Whether a function or one of its derivatives is called: F(t), F'(t), F^{(i)}(t), but no B_i^n(t) for a B.
fn calls_itself(expr: &Expr, base: &str) -> bool {
    expr.has(&|part| match &part.kind {
        Kind::Apply(callee, _) => Head::of(underived(callee)).is_some_and(|head| {
            head.base == base && head.lower.is_empty() && (head.upper.is_empty() || head.parenthesized)
        }),
        _ => false,
    })
}

/// Whether a letter without indices is called in a formula.
fn calls_plain(expr: &Expr, base: &str) -> bool {
    let mut found = false;
    walk(expr, &mut |part| {
        if let Kind::Apply(callee, _) = &part.kind {
            found = found
                || Head::of(callee)
                    .is_some_and(|head| head.base == base && head.lower.is_empty() && head.upper.is_empty());
        }
    });
    found
}

/// f(x) = 0 says that x is a root of f, not that f is 0.
pub(in crate::judge) fn is_root_of(head: &Head, chain: &Chain) -> bool {
    let zero = matches!(&chain.sides[1].expr.kind, Kind::Number(q) if q.is_zero());
    head.arguments.is_some() && chain.relations[0].0 == Rel::Eq && !chain.universal && zero
}
