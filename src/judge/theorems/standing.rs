//! What it means that a claim fits a theorem: which sizes, letters and intervals the page speaks of decides.

use std::collections::BTreeSet;

use super::entry::{Equation, Theorem};
use super::fit::{Claim, Standing};
use super::letters::{Said, Way, is_end};
use super::roles;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::instances::integers::as_values;
use crate::judge::known::checker::Checker;
use crate::judge::page::context::{Body, is_variable};
use crate::judge::page::object::{Declared, Sort};
use crate::judge::page::statement::Place;
use crate::judge::page::topic::Topic;
use crate::judge::values::evaluator;
use crate::judge::values::inequality::is_unit;
use crate::judge::written::names::{Head, bases, walk};

impl Checker {
    /// What it means that a claim fits a theorem in a way.
    pub(super) fn standing(
        &self,
        theorem: &Theorem,
        equation: &Equation,
        way: &Way,
        claim: &Claim,
        said: &Said,
    ) -> Standing {
        let unlike = |theirs: &str, ours: &Expr| {
            roles::clash(theirs, ours, &self.context, claim.place)
                || roles::is_no_basis(theirs, ours, &self.context, claim.place)
        };
        // What a ratio is the page says.
        let given = |(theirs, ours): &(String, Expr)| {
            theirs == "a" && Head::of(ours).is_some_and(|head| self.is_given(&head, claim.place))
        };
        if way.letters.iter().any(given) {
            return Standing::Doubtful;
        }
        // The a_i are coefficients of powers where the page says so.
        let of_powers = |(theirs, ours): &(String, Expr)| {
            theirs != "a" || Head::of(ours).is_some_and(|head| self.has_powers(&head.base, claim.place))
        };
        if theorem.means("powers") && !way.letters.iter().all(of_powers) {
            return Standing::Doubtful;
        }
        let named = |letter: &String| equation.profile.is_family(letter) || letter.starts_with(['B', 'N']);
        if way.letters.iter().any(|(theirs, ours)| named(theirs) && unlike(theirs, ours)) {
            return Standing::Doubtful;
        }
        if let Some(standing) = self.standing_of_contact(theorem, way, claim.place) {
            return standing;
        }
        if self.is_of_another_size(theorem, equation, way, said, claim.place)
            || self.is_of_another_degree(theorem, way, claim.place)
            || self.are_of_another_order(theorem, way, claim.place)
            || self.are_of_other_degrees(theorem, equation, way, said, claim.place)
            || self.is_over_named_ends(theorem, equation, claim.place)
            || is_over_another_interval(theorem, equation, said)
        {
            return Standing::Doubtful;
        }
        let within =
            |name: &Expr| said.intervals.iter().any(|(from, to)| from.same_as(name) || to.same_as(name));
        // The points are those of the interval spoken of last.
        if let ([from, to], [latest, .., _]) = (way.ends.as_slice(), said.intervals.as_slice())
            && within(from)
            && within(to)
            && !(latest.0.same_as(from) && latest.1.same_as(to))
        {
            return Standing::Doubtful;
        }
        let sizes =
            way.integers.iter().skip(way.anchored).filter(|(letter, _)| letter != "i" && letter != "j");
        for (_, value) in sizes.clone() {
            let Kind::Add(_) = &value.kind else { continue };
            let name = bases(value).into_iter().next().unwrap_or_default();
            // Of degree n - 1, or of degree n raised from n - 1: words or sums tell.
            let points = way.letters.iter().find(|(letter, _)| letter == "b").map(|(_, value)| value);
            let said = self.said_as_order(&Expr::name(&name), claim.place) == Some(false)
                || theorem.has_orders() && self.context.spline_has_degree(claim.place) == Some(true)
                || points.is_some_and(|points| self.sums_to(&name, points, claim.place));
            return if said && !equation.order { Standing::Shifted } else { Standing::Doubtful };
        }
        if theorem.has_orders() {
            let said = way.size().and_then(|size| self.said_as_order(size, claim.place));
            // Where words say that it is the degree, the other is the likely slip. Many say order for the degree.
            return match said {
                Some(true) if !equation.order => Standing::Doubtful,
                Some(said) if said != equation.order => Standing::Shifted,
                Some(_) => Standing::Certain,
                None if equation.order => Standing::Doubtful,
                None => Standing::Certain,
            };
        }
        Standing::Certain
    }

    /// Whether an instance with a number for the degree has none that the page names, by words or as the last of some
    /// points.
    fn is_of_another_size(
        &self,
        theorem: &Theorem,
        equation: &Equation,
        way: &Way,
        said: &Said,
        place: &Place,
    ) -> bool {
        let number = |letter: &str| {
            let at = way.integers.iter().position(|(known, _)| known == letter)?;
            Some((at < way.anchored, way.integers[at].1.as_int()?))
        };
        let Some((anchored, size)) = number("n") else {
            // A theorem on cubics
            let own = theorem.degree().filter(|_| !said.degrees.is_empty());
            return own.is_some_and(|own| !said.degrees.contains(&own));
        };
        let degree = size - i64::from(equation.order);
        let listed = |degree: i64| {
            way.letters.iter().filter_map(|(_, own)| Head::of(own)).any(|head| {
                self.context.listed(&head.base, place).is_some_and(|(_, last)| last.as_int() == Some(degree))
            })
        };
        // For n = 2
        let given = |degree: i64| {
            self.context.sizes_heard(|other| place.knows(other, false)).any(|(_, size)| size == degree)
        };
        let known = |degree: i64| said.degrees.contains(&degree) || listed(degree) || given(degree);
        // A quadratic as a cubic is none of degree 3 as one of degree 4.
        if theorem.is_about(Topic::Elevation) && said.degrees.len() > 1 && !known(degree + 1) {
            return true;
        }
        let raised = number("r").filter(|_| theorem.is_about(Topic::Elevation));
        if raised.is_some_and(|(_, by)| !known(degree + by)) {
            return true;
        }
        let free = !anchored || !said.degrees.is_empty();
        free && !known(degree)
    }

    /// Whether words give something else than its n as the degree: n + 1, n for an order, from n - 1 on.
    fn is_of_another_degree(&self, theorem: &Theorem, way: &Way, place: &Place) -> bool {
        let raised = theorem.is_about(Topic::Elevation);
        let Some(Expr { kind: Kind::Name(size), .. }) = way.size() else {
            return false;
        };
        let letter = Expr::name(size);
        let near = |other: &Place| other.group == place.group && place.in_reach(other, false);
        let mut told = self.context.sizes_of(size).filter(|own| near(&own.place)).peekable();
        let is_it = |own: &Declared| {
            let degree = own.object.degree.as_ref().map(bare_degree);
            let raised = |degree: &Expr| raised && degree.same_as(&letter.clone().plus(1));
            own.object.sort != Sort::Order
                && degree.is_none_or(|degree| degree.same_as(&letter) || raised(degree))
        };
        if told.peek().is_some() && !theorem.has_orders() && !told.any(is_it) {
            return true;
        }
        // "From n - 1 to n"
        let sizes = self.context.heard.iter().filter(|(other, expr)| {
            near(other) && matches!(expr.kind, Kind::Add(_)) && bases(expr).into_iter().eq([size.clone()])
        });
        let next = letter.clone().plus(1);
        let mut sizes = sizes.map(|(_, expr)| expr).peekable();
        raised && sizes.peek().is_some() && !sizes.any(|expr| expr.same_as(&next))
    }

    /// Whether derivatives of another order stand for those of the theorem: moments, M_i = s''(x_i), for slopes.
    fn are_of_another_order(&self, theorem: &Theorem, way: &Way, place: &Place) -> bool {
        let order = |letter: &str| match letter {
            "M" => Some(2),
            "m" if theorem.means("spline") => Some(1),
            _ => None,
        };
        way.letters.iter().any(|(theirs, ours)| {
            let (Some(order), Some(head)) = (order(theirs), Head::of(ours)) else { return false };
            let mut own =
                self.context.visible(&head.base, place).filter_map(|(_, own, near)| match &own.body {
                    Body::Formula(Expr { kind: Kind::Apply(callee, _), .. }) if near => match callee.kind {
                        Kind::Prime(_, order) => Some(order),
                        _ => None,
                    },
                    _ => None,
                });
            own.next().is_some_and(|own| own != order)
        })
    }

    /// Whether a curve that words give another degree, or points that end elsewhere, stand for those of the theorem: y of
    /// degree n, where x has degree m.
    fn are_of_other_degrees(
        &self,
        theorem: &Theorem,
        equation: &Equation,
        way: &Way,
        said: &Said,
        place: &Place,
    ) -> bool {
        if theorem.is_about(Topic::Elevation) || equation.order {
            return false;
        }
        let size = way.size().cloned().or_else(|| theorem.degree().map(Expr::int));
        // n - 1 for n is a slip.
        let Some(size) = size.filter(is_plain) else { return false };
        let differs = |told: &Declared| has_another_degree(told, &size, said, place);
        let theirs = way.letters.iter();
        theirs.filter(|(theirs, _)| matches!(theirs.as_str(), "b" | "p" | "f" | "F")).any(|(theirs, ours)| {
            let Some(head) = Head::of(ours) else { return false };
            let told = match theirs.as_str() {
                "b" => self.curve_of_points(&head, place),
                _ => self.context.object_called(&head.base, place),
            };
            // Of a spline without its knots the ends are not known.
            let open = told
                .is_some_and(|told| told.object.sort == Sort::SplineCurve && told.object.knots.is_empty());
            let of = told.and_then(|told| Head::of(told.object.of.as_ref()?));
            let of = of.and_then(|of| self.context.object_called(&of.base, place));
            let ends_elsewhere = || {
                let listed = self.context.listed(&head.base, place);
                listed.is_some_and(|(first, last)| first.as_int() == Some(0) && is_another(&last, &size))
            };
            let curve = theorem.means("curve");
            told.is_some_and(differs)
                || of.is_some_and(differs)
                || theirs == "p" && open && curve
                || theirs == "b" && curve && ends_elsewhere()
        })
    }

    /// The curve told of last that has points with a letter.
    fn curve_of_points(&self, points: &Head, place: &Place) -> Option<&Declared> {
        let mut told = self.context.objects.iter().rev().filter(|told| place.knows(&told.place, false));
        told.find(|told| {
            let first = told.object.points.first().and_then(Head::of);
            told.object.is_function() && first.is_some_and(|first| first.base == points.base)
        })
    }

    /// Whether an equation over [0, 1] is claimed where the paragraph speaks last of an interval [a, b].
    fn is_over_named_ends(&self, theorem: &Theorem, equation: &Equation, place: &Place) -> bool {
        let named = |[from, to]: [&Expr; 2]| !bases(from).is_empty() || !bases(to).is_empty();
        let last = self.context.intervals_beside(place).next_back();
        is_for_the_unit_interval(theorem, equation) && last.is_some_and(|(_, ends, _)| named(ends))
    }

    /// What the order of contact that the page supposes makes of a theorem on contact.
    fn standing_of_contact(&self, theorem: &Theorem, way: &Way, place: &Place) -> Option<Standing> {
        if let Some(needed) = theorem.smoothness() {
            let said = self.smoothness(place);
            let known = said.is_some_and(|order| order >= needed);
            if theorem.contact.is_some() || said.is_some() || self.meets_by_geometry_only(place) {
                return Some(if known { Standing::Certain } else { Standing::Doubtful });
            }
        }
        let (_, free) = way.integers.iter().find(|(letter, _)| theorem.contact.as_ref() == Some(letter))?;
        let order = self.order_of_contact(place)?;
        // Both are a name or a neighbour of one.
        let parts = |expr: &Expr| match &expr.kind {
            Kind::Add(_) => {
                let at = |value: i64| {
                    let names: Vec<_> = bases(expr).into_iter().map(|name| (name, value)).collect();
                    evaluator::machine().with_locals(as_values(&names), |machine| machine.eval_int(expr)).ok()
                };
                Some((bases(expr), at(0)?))
            }
            Kind::Name(_) => Some((bases(expr), 0)),
            _ => expr.as_int().map(|value| (BTreeSet::new(), value)),
        };
        let ((letter, own), (other, supposed)) = (parts(free)?, parts(&order)?);
        Some(match own - supposed {
            _ if letter != other => Standing::Doubtful,
            0 => Standing::Certain,
            1 => Standing::Shifted,
            _ => Standing::Doubtful,
        })
    }

    /// How many derivatives of two curves agree where they meet, as C^2 or equations F''(a) = G''(a) say, if they
    /// say one thing; where both C^1 and C^2 are spoken of, the last of them in the paragraph.
    pub(super) fn smoothness(&self, place: &Place) -> Option<i64> {
        let derived = |side: &Expr| match &side.kind {
            Kind::Apply(callee, _) => match &callee.kind {
                Kind::Prime(function, order) => Some((Head::of(function)?.base, i64::from(*order))),
                _ => Some((Head::of(callee).filter(|head| head.upper.is_empty())?.base, 0)),
            },
            _ => None,
        };
        let mut said: BTreeSet<i64> = BTreeSet::new();
        let mut equated: BTreeSet<i64> = BTreeSet::new();
        let mut latest = None;
        for (other, expr) in self.context.heard.iter().filter(|(other, _)| place.knows(other, false)) {
            match &expr.kind {
                Kind::Pow(base, order) if matches!(&base.kind, Kind::Name(name) if name == "C") => {
                    said.extend(order.as_int());
                    if other.group == place.group {
                        latest = order.as_int();
                    }
                }
                Kind::Chain(left, links) => {
                    if let [link] = links.as_slice()
                        && link.rel == Rel::Eq
                        && let (Some((one, order)), Some((other, same))) =
                            (derived(left), derived(&link.expr))
                        && one != other
                        && order == same
                    {
                        equated.insert(order);
                    }
                }
                _ => {}
            }
        }
        // Up to the first order that no equation has
        let reached = (0..).take_while(|order| equated.contains(order)).last();
        match (said.first(), said.last(), reached) {
            (Some(least), Some(most), None) if least == most => Some(*least),
            (Some(least), Some(most), Some(reached)) if least == most && *least == reached => Some(reached),
            (None, None, reached) => reached,
            (Some(_), Some(_), None) => latest,
            _ => None,
        }
    }

    /// Whether the paragraph speaks of G^k: no derivatives have to agree.
    fn meets_by_geometry_only(&self, place: &Place) -> bool {
        self.context.heard.iter().any(|(other, expr)| {
            let geometric = matches!(&expr.kind, Kind::Pow(base, _) if matches!(&base.kind, Kind::Name(name) if name == "G"));
            geometric && other.group == place.group
        })
    }

    /// The r of F^{(k)}(a) = G^{(k)}(a) for k = 0, …, r.
    pub(super) fn order_of_contact(&self, place: &Place) -> Option<Expr> {
        let index = |side: &Expr| {
            let Kind::Apply(callee, _) = &side.kind else { return None };
            let head = Head::of(callee).filter(|head| head.parenthesized)?;
            match head.upper.as_slice() {
                [Expr { kind: Kind::Name(index), .. }] => Some(index.clone()),
                _ => None,
            }
        };
        let supposed = |expr: &Expr| {
            let Kind::Chain(left, links) = &expr.kind else { return None };
            let [link] = links.as_slice() else { return None };
            index(left).filter(|own| index(&link.expr).as_ref() == Some(own))
        };
        let open = self.context.conditions.iter().flat_map(|condition| {
            std::iter::once(&condition.expr).chain(&condition.ranges).map(|expr| (expr, &condition.place))
        });
        let said = self.context.heard.iter().map(|(place, expr)| (&**expr, place));
        let all: Vec<&Expr> =
            open.chain(said).filter(|(_, other)| place.knows(other, false)).map(|(expr, _)| expr).collect();
        let index = all.iter().rev().find_map(|expr| supposed(expr))?;
        all.iter().rev().find_map(|expr| {
            let Kind::Chain(left, links) = &expr.kind else { return None };
            let last = &links.last()?.expr;
            let about = |side: &Expr| matches!(&side.kind, Kind::Name(name) if *name == index);
            match (&last.kind, links.as_slice()) {
                (Kind::Range(_, last), [link]) if about(left) && link.rel == Rel::Eq => {
                    Some(last.as_ref().clone())
                }
                (_, [first, second]) if about(&first.expr) && left.as_int() == Some(0) => match second.rel {
                    Rel::Le => Some(last.clone()),
                    Rel::Lt => Some(last.clone().plus(-1)),
                    _ => None,
                },
                _ => None,
            }
        })
    }

    /// Whether a formula of the page multiplies members of a family by powers of a variable: Σ a_i t^i, a_0 + a_1 t + a_2 t^2.
    fn has_powers(&self, letter: &str, place: &Place) -> bool {
        let member = |factor: &Expr| Head::of(factor).is_some_and(|head| head.base == letter);
        let power = |factor: &Expr| match &factor.kind {
            Kind::Pow(base, _) => matches!(&base.kind, Kind::Name(name) if is_variable(name)),
            _ => false,
        };
        let mut found = false;
        let mut look = |part: &Expr| {
            if let Kind::Mul(factors) = &part.kind {
                found |= factors.len() == 2 && factors.iter().any(member) && factors.iter().any(power);
            }
        };
        self.heard(place).for_each(|expr| walk(expr, &mut look));
        for definition in self.context.definitions.iter().filter(|known| place.sees(&known.place)) {
            if let Body::Formula(body) = &definition.body {
                walk(body, &mut look);
            }
        }
        found
    }

    /// Whether a sum of the page over some points ends with a letter.
    fn sums_to(&self, end: &str, points: &Expr, place: &Place) -> bool {
        let bodies = self.context.definitions.iter().filter(|known| place.sees(&known.place));
        let mut found = false;
        for definition in bodies {
            let Body::Formula(body) = &definition.body else { continue };
            walk(body, &mut |part| {
                if let Kind::Big { upper: Some(upper), body, .. } = &part.kind {
                    let own = matches!(&upper.kind, Kind::Name(name) if name == end);
                    let base = Head::of(points).map(|head| head.base);
                    found |= own && base.is_some_and(|base| bases(body).contains(&base));
                }
            });
        }
        found
    }

    /// Whether words say that a size is an order (true), or a degree (false).
    fn said_as_order(&self, size: &Expr, place: &Place) -> Option<bool> {
        let Kind::Name(letter) = &size.kind else { return None };
        let spoken = self.context.sizes_of(letter).filter(|declared| place.in_reach(&declared.place, false));
        let (mut said, mut less) = (None, false);
        for declared in spoken {
            // "of degree n - 1": n is no degree.
            let other =
                declared.object.degree.as_ref().is_some_and(|degree| degree.same_as(&size.clone().plus(-1)));
            match declared.object.sort {
                // "the order k, so the degree is k - 1"
                Sort::Degree if other => said = said.or(Some(true)),
                _ if other => less = true,
                Sort::Order => said = said.or(Some(true)),
                Sort::Degree => said = said.or(Some(false)),
                _ => {}
            }
        }
        said.filter(|order| *order || !less)
    }
}

/// Whether an equation over [0, 1] is claimed where the section speaks of another interval.
fn is_over_another_interval(theorem: &Theorem, equation: &Equation, said: &Said) -> bool {
    let unit = |(from, to): &(Expr, Expr)| is_unit([from, to]);
    let numbers = |(from, to): &(Expr, Expr)| bases(from).is_empty() && bases(to).is_empty();
    is_for_the_unit_interval(theorem, equation)
        && (said.intervals.iter().any(|ends| numbers(ends) && !unit(ends))
            || theorem.means("hermite") && said.intervals.first().is_some_and(|ends| !unit(ends)))
}

/// Whether an equation holds over [0, 1] and has no other ends in it.
fn is_for_the_unit_interval(theorem: &Theorem, equation: &Equation) -> bool {
    let over_unit = ["curve", "powers", "casteljau", "hermite", "interval"];
    let lengths = |name: &Expr| matches!(&name.kind, Kind::Name(name) if is_end(name) || name == "h");
    over_unit.into_iter().any(|kind| theorem.means(kind)) && !equation.profile.variables.iter().any(lengths)
}

/// m of a degree m ≥ 2.
fn bare_degree(degree: &Expr) -> &Expr {
    match &degree.kind {
        Kind::Chain(left, _) => left,
        _ => degree,
    }
}

/// Whether a size is a letter or a number.
fn is_plain(size: &Expr) -> bool {
    matches!(size.kind, Kind::Name(_) | Kind::Number(_))
}

/// Whether words give a curve another degree. "For a quadratic" a polynomial of degree n may be meant, elsewhere.
fn has_another_degree(told: &Declared, size: &Expr, said: &Said, place: &Place) -> bool {
    let Some(degree) = told.object.degree.as_ref().map(bare_degree) else { return false };
    let comparable = match (degree.as_int(), size.as_int()) {
        (Some(_), Some(size)) => !said.degrees.contains(&size),
        (None, None) => true,
        _ => told.place.group == place.group,
    };
    comparable && is_plain(degree) && !degree.same_as(size)
}

/// Whether points end with another number than the degree: c_0, …, c_{n-1} beside n.
fn is_another(last: &Expr, size: &Expr) -> bool {
    match (last.as_int(), size.as_int()) {
        (Some(last), Some(size)) => last != size,
        (None, None) => bases(last) == bases(size) && !last.same_as(size),
        _ => false,
    }
}
