//! Triangular patches by their control points: "a quadratic patch with the points P_{200}, …", b_{ijk} with i + j + k = 2.
//!
//! **Definition.** The *net* of degree n of a letter is all of its members whose three indices add up to n. With it the
//! patch is Σ n!/(i! j! k!) b_{ijk} u^i v^j w^k, in the order in which its function takes u, v, w.

use std::collections::{BTreeMap, BTreeSet};

use super::page::{Page, Section};
use crate::formula::{BigOp, Expr, Kind, Rel, Sign, Term};
use crate::judge::page::object::{Object, Sort, UNNAMED};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::{Head, bases, is_index_letter, own_names, walk};
use crate::language::latex;
use crate::language::lexicon::families;
use crate::math::curve::indices;
use crate::math::number::{Rational, multinomial};

/// Degrees above this one are not followed.
const MOST: i64 = 6;

/// The net that sections speak of.
struct Net {
    /// Its points by their indices.
    points: BTreeMap<[i64; 3], Expr>,
    /// The formula after which it is known.
    number: usize,
}

/// Adds the patches of which sections give the net, by the function with three arguments of which they give values.
///
/// Cost: linear in the formulas.
pub(super) fn tell(sections: &[Section], page: &Page, found: &mut BTreeMap<usize, Vec<Object>>) {
    for Section { topics, numbers, .. } in sections {
        let listed = |object: &&Object| {
            object.sort == Sort::BezierCurve
                && object.points.len() > 1
                && object.points.iter().all(|point| point.items().is_some() && bases(point).is_empty())
        };
        let here = || found.iter().filter(|(number, _)| numbers.contains(number));
        let mut curves = here()
            .flat_map(|(number, list)| list.iter().filter(listed).map(|own| (*number, own.points.clone())));
        if let (Some((number, points)), None) = (curves.next(), curves.next())
            && let Some(letter) = letter_of_points(numbers, page, points.len())
        {
            let names = (0..points.len() as i64).map(|i| Expr::indexed(&letter, i)).collect();
            let own = Object { names, values: points, ..Object::new(Sort::Symbols) };
            found.entry(number).or_default().push(own);
        }
        if topics.has(Topic::Bilinear)
            && let Some((number, own)) = bilinear(numbers, page)
        {
            found.entry(number).or_default().push(own);
        }
        if !topics.has(Topic::Triangle) || topics.has(Topic::Rational) {
            continue;
        }
        let Some(net) = Net::of(numbers, page, *topics) else { continue };
        let Some((name, arguments)) = patch(numbers, page, &net) else { continue };
        // "Un triangle de Bézier de points …" is no curve.
        let other = |object: &Object| {
            let own = |point: &Expr| net.points.values().any(|known| known.same_as(point));
            object.sort == Sort::BezierCurve && object.points.iter().any(own)
        };
        for number in numbers {
            if let Some(list) = found.get_mut(number) {
                list.retain(|object| !other(object));
            }
        }
        let name = Expr::apply(name, arguments.clone());
        let own = Object {
            names: vec![name],
            values: vec![net.formula(&arguments)],
            ..Object::new(Sort::Function)
        };
        found.entry(net.number).or_default().push(own);
    }
}

/// The letter that the sum for a curve has for control points that its section lists without names: b_i.
fn letter_of_points(numbers: &[usize], page: &Page, count: usize) -> Option<String> {
    let said = || numbers.iter().flat_map(|number| page.said(*number));
    let mut letters: BTreeSet<String> = BTreeSet::new();
    for expr in said() {
        walk(expr, &mut |part| {
            let Kind::Big { op: BigOp::Sum, lower, body, .. } = &part.kind else { return };
            let own = own_names(lower);
            walk(body, &mut |part| {
                let head = Head::of(part)
                    .filter(|head| matches!(part.kind, Kind::Subscript(..)) && head.upper.is_empty());
                if let Some(head) = head
                    && matches!(head.lower.as_slice(), [Expr { kind: Kind::Name(index), .. }] if own.contains(index))
                    && !families::is_family(&head.base)
                {
                    letters.insert(head.base);
                }
            });
        });
    }
    // Weights are given by equations.
    letters.retain(|letter| {
        !said().any(|said| {
            let Kind::Chain(left, _) = &said.kind else { return false };
            Head::of(left).is_some_and(|head| head.base == *letter)
        })
    });
    let mut letters = letters.into_iter();
    letters.next().filter(|_| letters.next().is_none() && count > 1)
}

/// The bilinear patch through the four values that equations give of one function at the corners of the unit square.
fn bilinear(numbers: &[usize], page: &Page) -> Option<(usize, Object)> {
    let mut corners: BTreeMap<[i64; 2], Expr> = BTreeMap::new();
    let mut name: Option<(usize, Expr)> = None;
    for number in numbers {
        for said in page.said(*number) {
            let Kind::Chain(left, links) = &said.kind else { continue };
            let ([link], Kind::Apply(callee, groups)) = (links.as_slice(), &left.kind) else { continue };
            let arguments: Option<Vec<i64>> = groups.concat().iter().map(Expr::as_int).collect();
            let Some(&[u, v]) = arguments.as_deref() else { continue };
            let corner = link.rel == Rel::Eq && (0..2).contains(&u) && (0..2).contains(&v);
            let same = name.as_ref().is_none_or(|(_, known)| known.same_as(callee));
            // x(1, 0) = b_{n,0} may be claimed.
            let given = bases(&link.expr).is_empty();
            if corner && given && same && !corners.contains_key(&[u, v]) {
                name.get_or_insert((*number, callee.as_ref().clone()));
                corners.insert([u, v], link.expr.clone());
            }
        }
    }
    let (number, name) = name.filter(|_| corners.len() == 4)?;
    let formula = |said: &Expr| match &said.kind {
        Kind::Chain(left, links) => match &left.kind {
            Kind::Apply(callee, groups) => {
                let variables = groups.concat().iter().all(|argument| matches!(argument.kind, Kind::Name(_)));
                callee.same_as(&name)
                    && variables
                    && links[0].expr.has(&|part| matches!(part.kind, Kind::Big { .. }))
            }
            _ => false,
        },
        _ => false,
    };
    if numbers.iter().flat_map(|number| page.said(*number)).any(formula) {
        return None;
    }
    let variables = ["u", "v"].map(Expr::name);
    let factor = |variable: &Expr, end: i64| match end {
        0 => {
            let rest = [(Sign::Plus, Expr::int(1)), (Sign::Minus, variable.clone())];
            Expr::sum(rest.map(|(sign, expr)| Term { sign, expr }).into()).grouped()
        }
        _ => variable.clone(),
    };
    let term = |([i, j], corner): (&[i64; 2], &Expr)| {
        let weights = [factor(&variables[0], *i), factor(&variables[1], *j)];
        let factors = weights.into_iter().chain([corner.clone()]).collect();
        Term { sign: Sign::Plus, expr: Expr::product(factors) }
    };
    let body = Expr::sum(corners.iter().map(term).collect());
    let names = vec![Expr::apply(name, variables.to_vec())];
    Some((number, Object { names, values: vec![body], ..Object::new(Sort::Function) }))
}

impl Net {
    /// The net whose points formulas list one by one, or as b_{ijk}.
    fn of(numbers: &[usize], page: &Page, topics: Topics) -> Option<Net> {
        let said = |degree: i64| topics.degrees().all(|said| said == degree);
        let mut points: BTreeMap<String, BTreeMap<[i64; 3], Expr>> = BTreeMap::new();
        let mut general: BTreeSet<String> = BTreeSet::new();
        let mut sums = BTreeSet::new();
        let mut number = usize::MAX;
        for at in numbers {
            for expr in page.said(*at) {
                sums.extend(sum_of_indices(expr));
                walk(expr, &mut |part| {
                    let Some((base, indices)) = member(part) else { return };
                    number = number.min(*at);
                    match indices {
                        Some(indices) => drop(points.entry(base).or_default().insert(indices, part.clone())),
                        None => drop(general.insert(base)),
                    }
                });
            }
        }
        let listed: Vec<(&String, i64)> = points
            .iter()
            .filter_map(|(base, net)| {
                let degree = net.keys().next()?.iter().sum::<i64>();
                let count = ((degree + 1) * (degree + 2) / 2) as usize;
                let whole = net.len() == count && net.keys().all(|own| own.iter().sum::<i64>() == degree);
                whole.then_some((base, degree))
            })
            .collect();
        match (listed.as_slice(), points.len()) {
            ([(base, degree)], 1) if (1..=MOST).contains(degree) => {
                let points = points.get(*base)?.clone();
                said(*degree).then_some(Net { points, number })
            }
            // b_{ijk}, i + j + k = 2
            ([], _) if points.len() < 2 && general.len() == 1 => {
                let base = general.first()?;
                let sums: Vec<i64> = sums.into_iter().collect();
                let [degree] = sums.as_slice() else { return None };
                let own = points.keys().all(|other| other == base) && (1..=MOST).contains(degree);
                let all = indices(*degree as usize).into_iter().map(|own| own.map(|index| index as i64));
                let members = all.map(|own| Some((own, written(base, own)?)));
                let points = members.collect::<Option<_>>()?;
                (own && said(*degree)).then_some(Net { points, number })
            }
            _ => None,
        }
    }

    /// The patch in three variables.
    fn formula(&self, variables: &[Expr]) -> Expr {
        let term = |(indices, point): (&[i64; 3], &Expr)| {
            let count = Rational::from_integer(multinomial(&indices.map(|index| index as usize)));
            let powers = variables.iter().zip(indices).filter(|(_, i)| **i > 0);
            let powers = powers.map(|(variable, i)| variable.clone().power(Expr::int(*i)));
            let factors = std::iter::once(Expr::number(&count)).chain(powers).chain([point.clone()]);
            Term { sign: Sign::Plus, expr: Expr::product(factors.collect()) }
        };
        Expr::sum(self.points.iter().map(term).collect())
    }
}

/// b_{200}, as a page writes it.
fn written(base: &str, [i, j, k]: [i64; 3]) -> Option<Expr> {
    let Kind::Subscript(_, lower) = latex::read(&format!("b_{{{i}{j}{k}}}")).ok()?.kind else { return None };
    Some(Kind::Subscript(Box::new(Expr::name(base)), lower).into())
}

/// The letter and the indices of a member of a net, b_{200} or b_{2,0,0}; no indices for b_{ijk}.
fn member(part: &Expr) -> Option<(String, Option<[i64; 3]>)> {
    let Kind::Subscript(..) = &part.kind else { return None };
    let head = Head::of(part).filter(|head| head.upper.is_empty() && head.arguments.is_none())?;
    let digits = match head.lower.as_slice() {
        [one] => one
            .as_int()
            .filter(|number| (100..1000).contains(number))
            .map(|number| [number / 100, number / 10 % 10, number % 10]),
        [i, j, k] => {
            let letter = |index: &Expr| matches!(&index.kind, Kind::Name(name) if is_index_letter(name));
            if [i, j, k].into_iter().all(letter) {
                return Some((head.base, None));
            }
            Some([i.as_int()?, j.as_int()?, k.as_int()?])
        }
        _ => None,
    }?;
    Some((head.base, Some(digits)))
}

/// The number to which the equation i + j + k = 2 says that indices add up.
fn sum_of_indices(expr: &Expr) -> Option<i64> {
    let Kind::Chain(left, links) = &expr.kind else { return None };
    let [link] = links.as_slice() else { return None };
    let Kind::Add(terms) = &left.kind else { return None };
    let letters = terms.iter().all(|term| {
        term.sign == Sign::Plus && matches!(&term.expr.kind, Kind::Name(name) if is_index_letter(name))
    });
    (letters && terms.len() == 3 && link.rel == Rel::Eq).then(|| link.expr.as_int()).flatten()
}

/// The function with three arguments of which values are given, with its variables; one that no page has, if there is
/// none. Nothing if several may be meant, or a formula says what it is.
fn patch(numbers: &[usize], page: &Page, net: &Net) -> Option<(Expr, Vec<Expr>)> {
    let mut names: Vec<Expr> = Vec::new();
    let mut defined = false;
    for expr in numbers.iter().flat_map(|number| page.said(*number)) {
        walk(expr, &mut |part| {
            if let Kind::Apply(callee, groups) = &part.kind
                && groups.concat().len() == 3
                && Head::of(callee).is_some_and(|head| head.lower.is_empty() && head.upper.is_empty())
                && !names.iter().any(|known| known.same_as(callee))
            {
                names.push(callee.as_ref().clone());
            }
        });
        if let Kind::Chain(left, links) = &expr.kind
            && let Kind::Apply(_, groups) = &left.kind
        {
            let plain = |argument: &Expr| matches!(argument.kind, Kind::Name(_));
            let net = |part: &Expr| {
                bases(part).iter().any(|base| net.points.values().any(|own| bases(own).contains(base)))
            };
            let given = groups.concat().len() == 3 && groups.concat().iter().all(plain);
            defined |= given
                && links.iter().any(|link| {
                    net(&link.expr) || link.expr.has(&|part| matches!(part.kind, Kind::Big { .. }))
                });
        }
    }
    let variables = ["u", "v", "w"].map(Expr::name).to_vec();
    match names.as_slice() {
        _ if defined => None,
        [] => Some((Expr::name(format!("{UNNAMED}patch")), variables)),
        [one] => Some((one.clone(), variables)),
        _ => None,
    }
}
