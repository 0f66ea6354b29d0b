//! Equations evaluated for given integers, as rational functions of the other letters. This
//! shares nothing with the prover but the arithmetic of rational functions.

use std::collections::BTreeMap;

use num_traits::{One, ToPrimitive, Zero};

use crate::formula::{Accent, BigOp, Expr, Kind, Rel, Sign};
use crate::math::number::{Rational, binomial, factorial, integer};
use crate::math::poly::{Coefficients, Fraction, Index, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};

/// Values of the integers.
pub type Values = BTreeMap<String, i64>;

/// The names that stand for integers here.
pub const INTEGERS: [&str; 5] = ["i", "j", "k", "m", "n"];

fn symbol(name: &str) -> Fraction {
    Fraction::from(MultiPoly::symbol(Symbol::new(name)))
}

/// The value, if it is defined and this evaluator knows all constructs.
pub fn value(expr: &Expr, values: &Values) -> Option<Fraction> {
    match &expr.kind {
        Kind::Number(x) => Some(Fraction::from(x.clone())),
        Kind::Name(name) => match values.get(name) {
            Some(x) => Some(Fraction::from(integer(*x))),
            None if INTEGERS.contains(&name.as_str()) => None,
            None => Some(symbol(name)),
        },
        Kind::Group(body) => value(body, values),
        Kind::Accent(Accent::Bold, body) => match &body.kind {
            Kind::Name(name) => Some(symbol(&format!("bold {name}"))),
            _ => None,
        },
        Kind::Add(terms) => {
            let mut sum = Fraction::zero();
            for term in terms {
                let x = value(&term.expr, values)?;
                sum += if term.sign == Sign::Minus { -x } else { x };
            }
            Some(sum)
        }
        Kind::Mul(factors) => product(factors, values),
        Kind::Div(a, b, _) => Some(value(a, values)?.times(&value(b, values)?.inverse()?)),
        Kind::Binomial(n, k, _) => choose(whole(n, values)?, whole(k, values)?),
        Kind::Factorial(n) => {
            let n = usize::try_from(whole(n, values)?).ok()?;
            Some(Fraction::from(Rational::from_integer(factorial(n))))
        }
        Kind::Subscript(base, indices) => {
            let mut list = Vec::new();
            for index in indices {
                match &index.kind {
                    Kind::Mul(letters) => {
                        for letter in letters {
                            list.push(Index::Number(whole(letter, values)?));
                        }
                    }
                    _ => list.push(Index::Number(whole(index, values)?)),
                }
            }
            let name = match &base.kind {
                Kind::Name(name) => name.clone(),
                Kind::Accent(Accent::Bold, body) => match &body.kind {
                    Kind::Name(name) => format!("bold {name}"),
                    _ => return None,
                },
                _ => return None,
            };
            Some(Fraction::from(MultiPoly::symbol(Symbol::new(name).with_indices(list))))
        }
        Kind::Pow(base, exponent) => {
            if let Some((index, degree, order)) = bernstein_name(expr) {
                return bernstein(whole(index, values)?, whole(degree, values)?, order, &symbol("t"));
            }
            let e = i32::try_from(whole(exponent, values)?).ok()?;
            if let Kind::Apply(callee, groups) = &base.kind
                && bernstein_name(callee).is_none()
            {
                return Some(value(callee, values)?.times(&power(&value(&groups[0][0], values)?, e)?));
            }
            power(&value(base, values)?, e)
        }
        Kind::Apply(callee, groups) => apply(callee, &groups[0], values),
        Kind::Upper(..) => apply(expr, &[Expr::name("t")], values),
        Kind::Big { op, lower, upper, body } => big(*op, lower, upper.as_deref(), body, values),
        Kind::Derivative { variables, body: Some(body), .. } => {
            let mut f = value(body, values)?;
            for (variable, order) in variables {
                let Kind::Name(name) = &variable.kind else { return None };
                let order = order.as_ref().map_or(Some(1), |order| whole(order, values))?;
                for _ in 0..order {
                    f = f.derivative(&Symbol::new(name.clone()));
                }
            }
            Some(f)
        }
        Kind::Integral { lower: Some(from), upper: Some(to), body, variable } => {
            let Kind::Name(name) = &variable.kind else { return None };
            let t = Symbol::new(name.clone());
            let f = value(body, values)?;
            if f.denominator().variables().contains(&t) {
                return None;
            }
            let whole = Coefficients::new(f.numerator().coefficients_in(&t)).antiderivative();
            let whole = MultiPoly::from_coefficients_in(&t, &whole);
            let whole = Fraction::new(whole, f.denominator().clone()).ok()?;
            let at = |end: &Expr| whole.substitute(&[(t.clone(), value(end, values)?)]).ok();
            Some(at(to)?.minus(&at(from)?))
        }
        Kind::At { body, lower, .. } => {
            let Kind::Chain(first, links) = &lower[0].kind else { return None };
            let Kind::Name(name) = &first.kind else { return None };
            value(body, values)?
                .substitute(&[(Symbol::new(name.clone()), value(&links[0].expr, values)?)])
                .ok()
        }
        Kind::Cases(cases) => {
            for (result, condition) in cases {
                if condition.as_ref().is_none_or(|c| holds(c, values) == Some(true)) {
                    return value(result, values);
                }
            }
            None
        }
        Kind::Prime(..) => {
            let (index, degree, order) = bernstein_name(expr)?;
            bernstein(whole(index, values)?, whole(degree, values)?, order, &symbol("t"))
        }
        _ => None,
    }
}

fn product(factors: &[Expr], values: &Values) -> Option<Fraction> {
    if let Some(dots) = factors.iter().position(|x| matches!(x.kind, Kind::Ellipsis)) {
        return dotted(&factors[..dots], &factors[dots + 1..], values);
    }
    let Some((first, rest)) = factors.split_first() else { return Some(Fraction::one()) };
    let is_delta = |e: &Expr| matches!(&e.kind, Kind::Name(name) if name == "Delta");
    let order = match &first.kind {
        Kind::Pow(base, order) if is_delta(base) => whole(order, values)?,
        _ if is_delta(first) => 1,
        _ => return Some(value(first, values)?.times(&product(rest, values)?)),
    };
    let (member, rest) = rest.split_first()?;
    let Kind::Subscript(base, indices) = &member.kind else { return None };
    let i = whole(&indices[0], values)?;
    let order = usize::try_from(order).ok()?;
    let mut sum = Fraction::zero();
    for j in 0..=order {
        let moved: Expr = Kind::Subscript(base.clone(), vec![Expr::int(i + i64::try_from(j).ok()?)]).into();
        let c = Fraction::from(Rational::from_integer(binomial(order, j)));
        let term = c.times(&value(&moved, values)?);
        sum += if (order - j) % 2 == 1 { -term } else { term };
    }
    Some(sum.times(&product(rest, values)?))
}

/// a b ⋯ z, where a, b, …, z have equal distances, times what follows.
fn dotted(before: &[Expr], after: &[Expr], values: &Values) -> Option<Fraction> {
    let mut list = Vec::new();
    for factor in before {
        match &factor.kind {
            Kind::Apply(callee, groups) => list.extend([&**callee, &groups[0][0]]),
            _ => list.push(factor),
        }
    }
    let ([first, second, ..], [last, rest @ ..]) = (list.as_slice(), after) else { return None };
    let (first, last) = (whole(first, values)?, whole(last, values)?);
    let step = whole(second, values)? - first;
    let count = (last - first).checked_div(step)? + 1;
    if step.abs() != 1 || count < 0 {
        return None;
    }
    let product = (0..count).map(|k| first + k * step).product::<i64>();
    Some(Fraction::from(integer(product)).times(&self::product(rest, values)?))
}

fn whole(expr: &Expr, values: &Values) -> Option<i64> {
    let x = value(expr, values)?.as_rational()?;
    x.is_integer().then(|| x.to_integer().to_i64())?
}

fn choose(n: i64, k: i64) -> Option<Fraction> {
    let n = usize::try_from(n).ok()?;
    let c = usize::try_from(k).map_or(crate::math::number::Int::ZERO, |k| binomial(n, k));
    Some(Fraction::from(Rational::from_integer(c)))
}

fn power(base: &Fraction, exponent: i32) -> Option<Fraction> {
    base.pow(exponent).ok()
}

fn bernstein(i: i64, n: i64, order: u32, x: &Fraction) -> Option<Fraction> {
    let c = choose(n, i)?;
    if c.is_zero() {
        return Some(c);
    }
    let t = Symbol::new("argument");
    let t_value = Fraction::from(MultiPoly::symbol(t.clone()));
    let mut f = c
        .times(&power(&t_value, i32::try_from(i).ok()?)?)
        .times(&power(&(Fraction::one() - t_value), i32::try_from(n - i).ok()?)?);
    for _ in 0..order {
        f = f.derivative(&t);
    }
    f.substitute(&[(t, x.clone())]).ok()
}

/// Index, degree, number of primes and dots.
fn bernstein_name(expr: &Expr) -> Option<(&Expr, &Expr, u32)> {
    match &expr.kind {
        Kind::Group(body) => bernstein_name(body),
        Kind::Prime(body, k) => bernstein_name(body).map(|(i, n, order)| (i, n, order + k)),
        Kind::Upper(base, degree) => lower(base).map(|(i, order)| (i, &degree[0], order)),
        Kind::Pow(base, degree) => lower(base).map(|(i, order)| (i, &**degree, order)),
        _ => None,
    }
}

fn lower(base: &Expr) -> Option<(&Expr, u32)> {
    let Kind::Subscript(base, indices) = &base.kind else { return None };
    let (base, order) = match &base.kind {
        Kind::Accent(Accent::Dot, base) => (base, 1),
        _ => (base, 0),
    };
    let is_b = matches!(&base.kind, Kind::Name(name) if name == "B");
    (is_b && indices.len() == 1).then(|| (&indices[0], order))
}

fn apply(callee: &Expr, arguments: &[Expr], values: &Values) -> Option<Fraction> {
    if let Some((index, degree, order)) = bernstein_name(callee) {
        let [argument] = arguments else { return None };
        return bernstein(whole(index, values)?, whole(degree, values)?, order, &value(argument, values)?);
    }
    match &callee.kind {
        Kind::Pow(base, degree) if matches!(&base.kind, Kind::Subscript(_, list) if list.len() == 3) => {
            let Kind::Subscript(_, indices) = &base.kind else { return None };
            let n = usize::try_from(whole(degree, values)?).ok()?;
            let mut result = Fraction::from(Rational::from_integer(factorial(n)));
            let mut total = 0;
            for (index, x) in indices.iter().zip(arguments) {
                let i = whole(index, values)?;
                total += i;
                if i < 0 {
                    return Some(Fraction::zero());
                }
                let i_factorial = Rational::from_integer(factorial(usize::try_from(i).ok()?));
                result = result
                    .times(&power(&value(x, values)?, i32::try_from(i).ok()?)?)
                    .scaled(&i_factorial.recip());
            }
            Some(if usize::try_from(total) == Ok(n) { result } else { Fraction::zero() })
        }
        Kind::Subscript(base, indices) if matches!(&base.kind, Kind::Name(s) if s == "sigma" || s == "e") => {
            if let [Expr { kind: Kind::Name(_), .. }, _, t] = arguments {
                let (i, n) = (whole(&indices[0], values)?, whole(&indices[1], values)?);
                return if (0..=n).contains(&i) {
                    power(&value(t, values)?, i32::try_from(i).ok()?)
                } else {
                    (n >= 0).then(Fraction::zero)
                };
            }
            let Kind::Subscript(letter, last) = &arguments.last()?.kind else { return None };
            let n = whole(&last[0], values)?;
            let i = whole(&indices[0], values)?;
            if n < 0 || i < 0 || i > n {
                return (n >= 0).then(Fraction::zero);
            }
            let mut e = vec![Fraction::zero(); usize::try_from(n).ok()? + 2];
            e[0] = Fraction::one();
            for k in 1..=n {
                let t = value(&Kind::Subscript(letter.clone(), vec![Expr::int(k)]).into(), values)?;
                for at in (1..e.len()).rev() {
                    let more = e[at - 1].times(&t);
                    e[at] += more;
                }
            }
            let result = e[usize::try_from(i).ok()?].clone();
            match indices.get(1) {
                None => Some(result),
                Some(count) if whole(count, values)? == n => Some(result.times(&choose(n, i)?.inverse()?)),
                Some(_) => None,
            }
        }
        _ => {
            let [argument] = arguments else { return None };
            Some(value(callee, values)?.times(&value(argument, values)?))
        }
    }
}

fn limit(expr: &Expr, values: &Values) -> Option<i64> {
    let Kind::Apply(callee, groups) = &expr.kind else { return whole(expr, values) };
    let list: Option<Vec<i64>> = groups[0].iter().map(|x| whole(x, values)).collect();
    match &callee.kind {
        Kind::Name(name) if name == "max" => list?.into_iter().max(),
        Kind::Name(name) if name == "min" => list?.into_iter().min(),
        _ => whole(expr, values),
    }
}

fn big(op: BigOp, lower: &[Expr], upper: Option<&Expr>, body: &Expr, values: &Values) -> Option<Fraction> {
    let [Expr { kind: Kind::Chain(first, links), .. }] = lower else { return None };
    let mut result = if op == BigOp::Sum { Fraction::zero() } else { Fraction::one() };
    let mut add = |values: &Values| {
        let x = value(body, values)?;
        result = if op == BigOp::Sum { result.plus(&x) } else { result.times(&x) };
        Some(())
    };
    match (&first.kind, upper) {
        (Kind::Name(name), Some(upper)) => {
            for i in limit(&links[0].expr, values)?..=limit(upper, values)? {
                let mut inner = values.clone();
                inner.insert(name.clone(), i);
                add(&inner)?;
            }
        }
        (Kind::Add(terms), None) => {
            let total = whole(&links[0].expr, values)?;
            let names: Option<Vec<&String>> = terms
                .iter()
                .map(|term| match &term.expr.kind {
                    Kind::Name(name) => Some(name),
                    _ => None,
                })
                .collect();
            let names = names?;
            let mut lists = vec![vec![]];
            for _ in 0..names.len() {
                lists = lists
                    .into_iter()
                    .flat_map(|list: Vec<i64>| (0..=total).map(move |i| [list.clone(), vec![i]].concat()))
                    .collect();
            }
            for list in lists.into_iter().filter(|list| list.iter().sum::<i64>() == total) {
                let mut inner = values.clone();
                names.iter().zip(list).for_each(|(name, i)| {
                    inner.insert((*name).clone(), i);
                });
                add(&inner)?;
            }
        }
        _ => return None,
    }
    Some(result)
}

fn holds(condition: &Expr, values: &Values) -> Option<bool> {
    let Kind::Chain(first, links) = &condition.kind else { return None };
    let mut left = whole(first, values)?;
    for link in links {
        let right = whole(&link.expr, values)?;
        let good = match link.rel {
            Rel::Eq => left == right,
            Rel::Ne => left != right,
            Rel::Lt => left < right,
            Rel::Le => left <= right,
            Rel::Gt => left > right,
            Rel::Ge => left >= right,
            _ => return None,
        };
        if !good {
            return Some(false);
        }
        left = right;
    }
    Some(true)
}

/// Upper entries of binomials, degrees and arguments of factorials, with the lower entries.
fn uppers<'a>(expr: &'a Expr, found: &mut Vec<(&'a Expr, Option<&'a Expr>)>) {
    match &expr.kind {
        Kind::Binomial(n, k, _) => found.push((n, Some(k))),
        Kind::Factorial(n) => found.push((n, None)),
        Kind::Apply(callee, arguments) => {
            if let Kind::Subscript(base, indices) = &callee.kind
                && matches!(&base.kind, Kind::Name(s) if s == "sigma" || s == "e")
                && let Some(Kind::Subscript(_, last)) = arguments[0].last().map(|x| &x.kind)
            {
                found.push((&last[0], Some(&indices[0])));
            } else if let Kind::Subscript(base, indices) = &callee.kind
                && matches!(&base.kind, Kind::Name(s) if s == "sigma")
            {
                found.push((&indices[1], Some(&indices[0])));
            }
        }
        Kind::Pow(..) | Kind::Upper(..) => {
            if let Some((i, n, _)) = bernstein_name(expr) {
                found.push((n, Some(i)));
            } else if let Kind::Pow(base, n) = &expr.kind
                && matches!(&base.kind, Kind::Subscript(b, list)
                    if list.len() == 3 && matches!(&b.kind, Kind::Name(s) if s == "B"))
            {
                found.push((n, None));
            }
        }
        _ => {}
    }
    expr.for_each_child(&mut |child| uppers(child, found));
}

/// Lower and upper ends of sums whose lower end is no number.
fn lengths<'a>(expr: &'a Expr, found: &mut Vec<(&'a Expr, &'a Expr)>) {
    if let Kind::Big { op: BigOp::Sum, lower, upper: Some(upper), .. } = &expr.kind
        && let [Expr { kind: Kind::Chain(_, links), .. }] = lower.as_slice()
        && value(&links[0].expr, &Values::new()).is_none()
    {
        found.push((&links[0].expr, upper));
    }
    expr.for_each_child(&mut |child| lengths(child, found));
}

/// All values of the integers up to `bound` for which the equation makes sense; with `narrow`
/// only those with 0 ≤ i ≤ n for some B_i^n or C(n, i) with this letter i.
pub fn range(left: &Expr, right: &Expr, bound: i64, narrow: bool) -> Vec<Values> {
    let mut free = Vec::new();
    let mut names = |expr: &Expr| free_names(expr, &mut Vec::new(), &mut free);
    names(left);
    names(right);
    free.sort_unstable();
    free.dedup();
    let mut list = vec![Values::new()];
    for name in &free {
        list = list
            .into_iter()
            .flat_map(|values| {
                (0..=bound).map(move |x| {
                    let mut more = values.clone();
                    more.insert(name.clone(), x);
                    more
                })
            })
            .collect();
    }
    let mut found = Vec::new();
    uppers(left, &mut found);
    uppers(right, &mut found);
    list.retain(|values| found.iter().all(|(n, _)| whole(n, values).is_none_or(|n| !n.is_negative())));
    if narrow {
        let mut sums = Vec::new();
        lengths(left, &mut sums);
        lengths(right, &mut sums);
        list.retain(|values| {
            sums.iter().all(|(a, b)| match (limit(a, values), limit(b, values)) {
                (Some(a), Some(b)) => b >= a - 1,
                _ => true,
            })
        });
        let letters: Vec<&String> = free
            .iter()
            .filter(|f| !found.iter().any(|(n, k)| k.is_some() && mentions(n, f)))
            .filter(|f| {
                let mut lower =
                    found.iter().filter(|(n, _)| list.iter().any(|values| whole(n, values).is_some()));
                lower.any(|(_, k)| k.is_some_and(|k| is_letter(k, f)))
            })
            .collect();
        list.retain(|values| {
            letters.iter().all(|letter| {
                found.iter().any(|(n, k)| {
                    k.is_some_and(|k| is_letter(k, letter))
                        && whole(n, values).is_some_and(|n| values[*letter] <= n)
                })
            })
        });
    }
    list
}

/// Whether the formula is just a letter, perhaps as i + 1 − 1.
fn is_letter(expr: &Expr, name: &str) -> bool {
    let at = |x: i64| {
        let values: Values = INTEGERS.iter().map(|other| ((*other).to_owned(), 7)).collect();
        whole(expr, &Values::from_iter(values.into_iter().chain([(name.to_owned(), x)])))
    };
    at(3) == Some(3) && at(5) == Some(5)
}

fn mentions(expr: &Expr, name: &str) -> bool {
    let mut found = matches!(&expr.kind, Kind::Name(x) if x == name);
    expr.for_each_child(&mut |child| found |= mentions(child, name));
    found
}

fn free_names(expr: &Expr, bound: &mut Vec<String>, free: &mut Vec<String>) {
    match &expr.kind {
        Kind::Name(name) if INTEGERS.contains(&name.as_str()) && !bound.contains(name) => {
            free.push(name.clone())
        }
        Kind::Big { lower, upper, body, .. } => {
            let depth = bound.len();
            let mut inside = Vec::new();
            for item in lower {
                if let Kind::Chain(first, links) = &item.kind {
                    links.iter().for_each(|link| free_names(&link.expr, bound, free));
                    first.for_each_child(&mut |x| {
                        if let Kind::Name(name) = &x.kind {
                            inside.push(name.clone());
                        }
                    });
                    if let Kind::Name(name) = &first.kind {
                        inside.push(name.clone());
                    }
                }
            }
            upper.iter().for_each(|x| free_names(x, bound, free));
            bound.extend(inside);
            free_names(body, bound, free);
            bound.truncate(depth);
        }
        _ => expr.for_each_child(&mut |child| free_names(child, bound, free)),
    }
}

/// The first values of the integers up to `bound` for which both sides are defined and differ,
/// and the number of values for which they are defined.
pub fn refutation(left: &Expr, right: &Expr, bound: i64, narrow: bool) -> (Option<Values>, usize) {
    let mut tried = 0;
    for values in range(left, right, bound, narrow) {
        if let (Some(a), Some(b)) = (value(left, &values), value(right, &values)) {
            tried += 1;
            if a != b {
                return (Some(values), tried);
            }
        }
    }
    (None, tried)
}
