//! Formulas for what words describe: the new control points after a change of the degree or of the interval, the Bézier
//! points of a spline, a curve that has no name.
//!
//! **Definition.** A *meaning* of a new name is something that the words of the section let it be, of a curve whose
//! control points the section gives.
//!
//! **Rule.** A formula for a new name holds if it holds with a meaning. It is wrong if it fails with the meaning with
//! which other formulas for that name hold, or if there is one meaning only and it agrees with that in most of its items
//! or terms.

use std::rc::Rc;

use crate::budget;
use crate::formula::{Accent, Expr, Kind, Rel};
use crate::judge::instances::setting;
use crate::judge::instances::tally::{Failure, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::known::found::{Curve, Made, Meaning, Taken};
use crate::judge::page::context::{Mark, is_variable};
use crate::judge::page::finding::{Evidence, Finding, Verdict};
use crate::judge::page::object::{Declared, Object, Sort};
use crate::judge::page::statement::{Chain, Place, Role, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::reasons::counterexample;
use crate::judge::repair;
use crate::judge::values::compare;
use crate::judge::values::inequality::is_unit;
use crate::judge::written::names::{Head, bases};
use crate::language::value::Value;
use crate::language::write;
use crate::math::number::integer;
use crate::math::poly::Symbol;

/// A letter that no page has, for points without a name.
const POINTS: &str = "\u{25aa}";

/// The left side of a formula, as what is described there.
pub(in crate::judge) struct New {
    pub letter: String,
    names: Vec<Expr>,
    /// The side in which they stand.
    side: Expr,
    /// How many points are given at once.
    points: Option<i64>,
    /// How many arguments are given.
    pub arguments: usize,
    /// The number at which a value is given.
    point: Option<Expr>,
}

impl New {
    pub(in crate::judge) fn of(left: &Expr, right: &Expr) -> Option<New> {
        let items = |expr: &Expr| match &expr.kind {
            Kind::Matrix(rows, _) if rows.len() > 2 && rows.iter().all(|row| row.len() == 1) => {
                rows.iter().map(|row| row[0].clone()).collect()
            }
            _ => expr.items().filter(|items| items.len() > 2).map(<[Expr]>::to_vec),
        };
        let given = items(right).filter(|items| items.iter().all(|item| item.kind != Kind::Ellipsis));
        let points = given.map(|items| items.len() as i64);
        if let Some(names) = items(left) {
            let heads: Vec<Head> = names
                .iter()
                .filter(|name| name.kind != Kind::Ellipsis)
                .map(Head::of)
                .collect::<Option<_>>()?;
            let first = heads.first()?;
            let family =
                |head: &Head| head.base == first.base && head.lower.len() == 1 && head.arguments.is_none();
            return heads.iter().all(family).then(|| New {
                letter: first.base.clone(),
                names,
                side: left.clone(),
                points,
                arguments: 0,
                point: None,
            });
        }
        if let Some((callee, arguments)) = derivative(left) {
            let letter = Head::of(callee).filter(|head| head.lower.is_empty() && head.upper.is_empty())?.base;
            let (names, side) = (vec![callee.clone()], left.clone());
            return Some(New { letter, names, side, points: None, arguments, point: None });
        }
        let head = Head::of(left).filter(|head| head.upper.is_empty())?;
        let arguments = head.flat().len();
        match (head.lower.as_slice(), &left.kind) {
            // b_{-1} = b_{n+1} = 0: points that there are not.
            ([index], _) if index.as_signed_int().is_some_and(|index| index < 0) => None,
            ([_], _) if head.arguments.is_none() => Some(New {
                letter: head.base,
                names: vec![left.clone()],
                side: left.clone(),
                points: None,
                arguments: 0,
                point: None,
            }),
            ([], Kind::Apply(callee, groups)) if groups.len() == 1 => Some(New {
                letter: head.base,
                names: vec![callee.as_ref().clone()],
                side: left.clone(),
                points: None,
                arguments,
                point: match groups[0].as_slice() {
                    [only] if bases(only).is_empty() => Some(only.clone()),
                    _ => None,
                },
            }),
            // t_3(x, y, z), the polar form of T_3(x)
            ([label], Kind::Apply(callee, groups)) if groups.len() == 1 && label.as_int().is_some() => {
                Some(New {
                    letter: head.base,
                    names: vec![callee.as_ref().clone()],
                    side: left.clone(),
                    points: None,
                    arguments,
                    point: None,
                })
            }
            // q = (1, 5/2, 5/2, 1)
            ([], _) if head.arguments.is_none() => {
                let names: Vec<Expr> = (0..points?).map(|i| Expr::indexed(POINTS, i)).collect();
                let side = Expr::from(Kind::List(names.clone()));
                Some(New { letter: head.base, names, side, points, arguments: 0, point: None })
            }
            _ => None,
        }
    }
}

impl Checker {
    /// Judges a formula for a new name by what words say that it is for.
    pub(in crate::judge) fn by_description(
        &mut self,
        chain: &Chain,
        statement: &Statement,
        findings: &mut [Finding],
        before: Mark,
    ) {
        let place = &statement.place;
        let (left, right) = (&chain.sides[0], &chain.sides[1]);
        if !matches!(findings[0].verdict, Verdict::Definition | Verdict::Undecided)
            || chain.blocked
            || statement.is_case()
            || !statement.topics.any()
            || chain.relations[0].0 != Rel::Eq
            || left.is_unread()
            || right.is_unread()
        {
            return;
        }
        let Some(new) = New::of(&left.expr, &right.expr) else { return };
        // What its paragraph tells as a whole needs no guess.
        if self.context.is_told(&new.letter, place) {
            return;
        }
        let limits = self.limits.clone();
        let kept = self.context.clone();
        let finding = findings[0].clone();
        let found = budget::run(&limits, || self.meant(&new, chain, statement, &finding, before));
        self.context = kept;
        let Ok(Some((found, meaning))) = found else { return };
        if found.verdict == Verdict::Refuted {
            Rc::make_mut(&mut self.context).forget(before);
        }
        findings[0] = found;
        let taken = meaning.map(|meaning| Taken { letter: new.letter, place: place.clone(), meaning });
        self.taken.extend(taken);
    }

    /// The verdict that the meanings of a new name lead to, with the meaning that it has.
    fn meant(
        &mut self,
        new: &New,
        chain: &Chain,
        statement: &Statement,
        finding: &Finding,
        before: Mark,
    ) -> Option<(Finding, Option<Meaning>)> {
        let place = &statement.place;
        let right = &chain.sides[1].expr;
        // b'(t) = 3 (b_1^2 - b_0^2), b(1/4) = b_0^3: points of a scheme, whose numbers belong to one t.
        let scheme = |part: &Expr| {
            matches!(part.kind, Kind::Pow(..) | Kind::Upper(..))
                && Head::of(part).is_some_and(|head| !head.lower.is_empty() && !head.upper.is_empty())
        };
        if new.arguments == 1 && right.has(&scheme) {
            return None;
        }
        let sides = [&new.side, right].map(|expr| Side { expr: expr.clone(), latex: String::new() });
        let chain = Chain { sides: sides.into(), relations: vec![chain.relations[0]], ..chain.clone() };
        let told = self
            .taken
            .iter()
            .rev()
            .find(|taken| taken.letter == new.letter && place.knows(&taken.place, false))
            .filter(|taken| taken.meaning.has_points() && !self.is_given_anew(taken, place));
        let certain = told.is_some();
        let meanings = match told {
            Some(told) => vec![told.meaning.clone()],
            None => self.meanings(new, right, statement),
        };
        if meanings.is_empty() {
            return None;
        }
        Rc::make_mut(&mut self.context).forget(before);
        let mut failures: Vec<(Failure, Meaning)> = Vec::new();
        for meaning in meanings {
            let objects = meaning.curve.object.iter().cloned().chain([meaning.object(new)]);
            let tally = self.with_objects(objects, &chain, statement);
            if !tally.errors.is_empty() || !tally.unclear.is_empty() {
                continue;
            }
            if let Some(failure) = tally.fails.iter().find(|failure| failure.inner).or(tally.fails.first()) {
                failures.push((failure.clone(), meaning));
                continue;
            }
            if tally.nonzero == 0 {
                continue;
            }
            let held = Finding {
                verdict: if tally.holds > 1 { Verdict::Sampled } else { Verdict::Proved },
                reason: Some(format!("{}, as the words say", meaning.words())),
                witness: None,
                suggestion: None,
                ..finding.clone()
            };
            // c_0 = b_0 and c_0 = 4 are true with many meanings, c_1 = 4 with few.
            let inner = |index: &Expr| {
                index.as_int().is_some_and(|at| at > 0 && meaning.degree().is_some_and(|last| at < last))
            };
            let several = !bases(right).is_empty()
                || right.items().is_some()
                || Head::of(&new.side).is_some_and(|head| head.index().is_some_and(inner));
            let named = Head::of(right).is_some_and(|head| head.arguments.is_none());
            let tells = !certain && !named && several;
            return Some((held, tells.then_some(meaning)));
        }
        // Points that are told by words and by formulas are one curve.
        let (failure, meaning) = failures.first()?;
        if failures.iter().any(|(other, _)| other.left != failure.left || other.right != failure.right) {
            return None;
        }
        // A number is one slip away from many of those that a new point may be.
        let telling = !bases(right).is_empty() || matches!(meaning.made, Made::PolarForm);
        let mut near = || telling && self.is_one_slip_from(new, meaning, &chain, statement);
        // C(t) = a_0 + a_1 t + … says what the a_i are, and so do numbers for what is made of the a_i.
        let data = |value: &Value| -> Vec<String> {
            let parameter = |symbol: &Symbol| symbol.is_plain() && is_variable(symbol.base());
            let symbols = compare::symbols(value).into_iter().filter(|symbol| !parameter(symbol));
            symbols.map(|symbol| symbol.base().to_owned()).collect()
        };
        let (known, used) = (data(&failure.left), data(&failure.right));
        if !used.iter().all(|base| known.contains(base)) || used.is_empty() && !known.is_empty() {
            return None;
        }
        // P(t) is on the curve with the points P_i.
        let itself = matches!(meaning.made, Made::Itself | Made::Coordinate(_));
        let own = itself && meaning.curve.points.as_ref() == Some(&new.letter);
        // The complementary segment is often called \bar x.
        let plain = !new.names.iter().any(|name| {
            name.has(&|part| matches!(part.kind, Kind::Accent(Accent::Bar | Accent::Hat | Accent::Tilde, _)))
        });
        // "For t = 1/2 we get the point c(1/2) = (b_0 + 2 b_1 + b_2)/4": a point made of its control points
        let point = itself
            && new.point.is_some()
            && !statement.topics.has(Topic::Join)
            && (is_mean_of(&failure.right, meaning.curve.points.as_deref().unwrap_or_default())
                // x(1/2) = (4/5, 3/5) beside points in the plane and their weights
                || meaning.curve.has_weights() && plain && is_like(&failure.left, &failure.right));
        let evidence = match (certain, own || point) {
            (true, _) => Evidence::Names,
            (_, true) => Evidence::Field,
            _ => Evidence::Terms,
        };
        // "For P(t) = …": data of an example
        let given = statement.role == Some(Role::Introduced);
        let said = certain || own || point || compare::agree_in_most(&failure.left, &failure.right) || near();
        (said && !given).then(|| {
            let wrong = Finding {
                verdict: Verdict::Refuted,
                reason: Some(format!("it differs from {}", meaning.words())),
                witness: counterexample::counterexample(failure),
                suggestion: None,
                evidence: vec![evidence],
                ..finding.clone()
            };
            (wrong, None)
        })
    }

    /// Whether its curve has another formula since: P(t) = Σ a_k t^k, and then P(t) = 1 - 3t of an example.
    fn is_given_anew(&self, taken: &Taken, place: &Place) -> bool {
        let Some(head) = Head::of(&taken.meaning.curve.name) else { return false };
        self.context
            .visible(&head.base, place)
            .any(|(_, definition, _)| definition.place.formula > taken.place.formula)
    }

    /// Whether a small edit of the formula holds with a meaning.
    fn is_one_slip_from(
        &mut self,
        new: &New,
        meaning: &Meaning,
        chain: &Chain,
        statement: &Statement,
    ) -> bool {
        let right = &chain.sides[1].expr;
        let start = budget::spent();
        let points = meaning.curve.points.as_deref().unwrap_or_default();
        let moved = [-1, 1].map(|by| with_indices_moved(right, points, by));
        repair::edits(right, &new.side, &None).into_iter().chain(moved).any(|edit| {
            if budget::spent() - start > setting::share(&self.limits, 4) {
                return false;
            }
            let objects = meaning.curve.object.iter().cloned().chain([meaning.object(new)]);
            let mut edited = chain.clone();
            edited.sides[1].expr = edit;
            let tally = self.with_objects(objects, &edited, statement);
            tally.errors.is_empty() && tally.unclear.is_empty() && tally.fails.is_empty() && tally.nonzero > 0
        })
    }

    pub(super) fn with_objects(
        &mut self,
        objects: impl Iterator<Item = Object>,
        chain: &Chain,
        statement: &Statement,
    ) -> Tally {
        let mark = self.context.mark();
        let place = &statement.place;
        for object in objects {
            let declared = Declared { object: Rc::new(object), place: place.clone(), line: 0 };
            Rc::make_mut(&mut self.context).declare(declared);
        }
        let setting = self.setting(chain, place, None).without_equations();
        let sides: Vec<&Expr> = chain.sides.iter().map(|side| &side.expr).collect();
        let mut attempt = self.attempts(&setting, &sides, &[Rel::Eq]);
        Rc::make_mut(&mut self.context).forget(mark);
        attempt.outcomes.tallies.remove(0)
    }

    /// What a new name can be.
    fn meanings(&self, new: &New, right: &Expr, statement: &Statement) -> Vec<Meaning> {
        let (topics, near) = (statement.topics, statement.near);
        let mut found = Vec::new();
        for curve in self.curves(new, right, statement) {
            let mut add = |made: Made| found.push(Meaning { curve: curve.clone(), made });
            let degree = curve.degree.as_int();
            match new.arguments {
                // The points of a rational curve change with their weights.
                0 if topics.has(Topic::Rational) => continue,
                1 if topics.has(Topic::Rational) && !curve.has_weights() => continue,
                0 => {}
                1 if curve.object.is_some() => {
                    // x(t) = …, y(t) = …
                    let letter = ["x", "y", "z"].iter().position(|own| new.letter.eq_ignore_ascii_case(own));
                    match letter.filter(|_| right.items().is_none() && curve.dimension().is_some()) {
                        Some(number) => add(Made::Coordinate(number)),
                        None => add(Made::Itself),
                    }
                    continue;
                }
                count if topics.has(Topic::PolarForm) && degree.is_some_and(|own| own <= count as i64) => {
                    add(Made::PolarForm);
                    continue;
                }
                _ => continue,
            }
            let points = new.points.or_else(|| self.points_heard(&new.letter, &statement.place));
            let more = points.zip(degree).map(|(points, degree)| points - 1 - degree);
            if topics.has(Topic::Elevation) && more.is_none_or(|more| more > 0) {
                add(Made::Elevated(more.unwrap_or(1)));
            }
            if more.is_some_and(|more| more != 0) {
                continue;
            }
            let named = statement.near.has(Topic::ControlPoints) && statement.role != Some(Role::Introduced);
            let part = topics.has(Topic::Subdivision) || topics.has(Topic::Half);
            if named && curve.object.is_none() && !curve.segment && !part {
                let part = self.interval_heard(&curve, &statement.place);
                // Numbers that nobody claims are data of another curve.
                if statement.role == Some(Role::Claimed) || !bases(right).is_empty() {
                    let (from, to) = part.unwrap_or_else(|| curve.interval.clone());
                    add(Made::Part(from, to));
                }
            }
            if curve.segment {
                add(Made::Part(curve.interval.0.clone(), curve.interval.1.clone()));
            } else if part {
                let part = self.interval_heard(&curve, &statement.place).or_else(|| {
                    let half = || {
                        (topics.has(Topic::Half) && own_unit(&curve))
                            .then(|| Expr::number(&(integer(1) / integer(2))))
                    };
                    let number = self.number_heard(&statement.place).or_else(half);
                    let middle = number.or_else(|| self.parameter_heard(&statement.place))?;
                    let (from, to) = curve.interval.clone();
                    match (near.has(Topic::First), near.has(Topic::Second)) {
                        (true, false) => Some((from, middle)),
                        (false, true) => Some((middle, to)),
                        _ => None,
                    }
                });
                if let Some((from, to)) = part {
                    add(Made::Part(from, to));
                }
            }
        }
        found
    }

    /// How many points of a letter the section listed: 5, for c_0, …, c_4.
    fn points_heard(&self, letter: &str, place: &Place) -> Option<i64> {
        let heads = self.heard(place).filter_map(Head::of).filter(|head| head.base == letter);
        let numbers: Vec<i64> = heads.filter_map(|head| head.index()?.as_int()).collect();
        let last = *numbers.iter().max()?;
        (last > 0 && numbers.contains(&0)).then_some(last + 1)
    }

    /// The part of its interval that the paragraph speaks of.
    fn interval_heard(&self, curve: &Curve, place: &Place) -> Option<(Expr, Expr)> {
        let (_, [from, to], _) = self.context.intervals_beside(place).next_back()?;
        let whole = from.same_as(&curve.interval.0) && to.same_as(&curve.interval.1);
        (!whole).then(|| (from.clone(), to.clone()))
    }

    /// The number of which the section speaks as a parameter: 1/2, t = 1/2.
    fn number_heard(&self, place: &Place) -> Option<Expr> {
        let number = |expr: &Expr| {
            let value = match &expr.kind {
                Kind::Chain(left, links) if Head::of(left).is_some() => &links.last()?.expr,
                _ => expr,
            };
            let inside = matches!(value.kind, Kind::Number(_) | Kind::Div(..)) && bases(value).is_empty();
            inside.then(|| value.clone())
        };
        self.heard(place).find_map(number)
    }

    /// The parameter that the section speaks of: 1/2, t = 1/2, λ.
    pub(in crate::judge) fn parameter_heard(&self, place: &Place) -> Option<Expr> {
        let letter = |expr: &Expr| match &expr.kind {
            Kind::Name(name) if is_variable(name) => Some(expr.clone()),
            _ => None,
        };
        self.number_heard(place).or_else(|| self.heard(place).find_map(letter))
    }
}

impl Meaning {
    fn words(&self) -> String {
        match &self.made {
            Made::Elevated(_) => "the control points at a higher degree".to_owned(),
            Made::Part(..) => "the Bézier points of this part of the curve".to_owned(),
            Made::Itself => "the curve with these control points".to_owned(),
            Made::Coordinate(_) => "a coordinate of the curve with these control points".to_owned(),
            Made::PolarForm if self.curve.object.is_some() => {
                "the polar form of the curve with these control points".to_owned()
            }
            Made::PolarForm => format!("the polar form of {}", write::text(&self.curve.name)),
        }
    }

    /// The number of the last of the points that it gives.
    fn degree(&self) -> Option<i64> {
        let by = match self.made {
            Made::Elevated(by) => by,
            Made::Part(..) => 0,
            _ => return None,
        };
        Some(self.curve.degree.as_int()? + by)
    }

    /// Whether it tells the control points of the curve, or another formula for it.
    fn has_points(&self) -> bool {
        self.curve.object.as_ref().is_none_or(|object| !object.points.is_empty())
    }

    fn object(&self, new: &New) -> Object {
        let Curve { name, degree, interval, object, .. } = &self.curve;
        let names = new.names.clone();
        let points = |degree: Expr, interval: (Expr, Expr)| Object {
            names: names.clone(),
            degree: Some(degree),
            of: Some(name.clone()),
            interval: Some(interval),
            ..Object::new(Sort::ControlPoints)
        };
        match (&self.made, object) {
            (Made::Elevated(by), _) => points(degree.clone().plus(*by), interval.clone()),
            (Made::Part(from, to), _) => points(degree.clone(), (from.clone(), to.clone())),
            (Made::Itself, Some(object)) => Object { names, ..object.clone() },
            (Made::Coordinate(number), Some(object)) => {
                let coordinate = |point: &Expr| point.items().and_then(|all| all.get(*number)).cloned();
                let points = object.points.iter().filter_map(coordinate).collect();
                Object { names, points, ..object.clone() }
            }
            (Made::PolarForm | Made::Itself | Made::Coordinate(_), _) => {
                Object { names, of: Some(name.clone()), ..Object::new(Sort::PolarForm) }
            }
        }
    }
}

/// Whether a curve is parametrised by [0, 1].
fn own_unit(curve: &Curve) -> bool {
    let (from, to) = &curve.interval;
    is_unit([from, to])
}

/// Whether a value is a sum of members of a letter, with numbers before them that have the sum 1.
fn is_mean_of(value: &Value, letter: &str) -> bool {
    let Value::Scalar(formula) = value else { return false };
    let one = |symbol: &Symbol| (symbol.base() == letter).then(|| integer(1));
    let Some(polynomial) = formula.as_polynomial() else { return false };
    polynomial.total_degree() == Some(1)
        && polynomial.variables().iter().all(|symbol| symbol.base() == letter)
        && formula.value(&|_: &Symbol| Some(integer(0))) == Some(integer(0))
        && formula.value(&one) == Some(integer(1))
}

/// Whether both are points with as many coordinates.
fn is_like(left: &Value, right: &Value) -> bool {
    let count = |value: &Value| value.clone().coordinates().map(|all| all.len()).filter(|count| *count > 1);
    count(left).is_some() && count(left) == count(right)
}

/// The function and the number of arguments of x'(0), x''(a).
fn derivative(expr: &Expr) -> Option<(&Expr, usize)> {
    let Kind::Apply(callee, groups) = &expr.kind else { return None };
    let Kind::Prime(function, _) = &callee.kind else { return None };
    let function = match &function.kind {
        Kind::Group(inner) => inner,
        _ => function,
    };
    (groups.len() == 1).then_some((function, groups[0].len()))
}

/// A formula with all numbers of a letter moved: b_1, b_2 for b_0, b_1.
fn with_indices_moved(expr: &Expr, letter: &str, by: i64) -> Expr {
    fn moved(expr: &mut Expr, letter: &str, by: i64) {
        if let Kind::Subscript(base, lower) = &mut expr.kind
            && base.has(&|part| matches!(&part.kind, Kind::Name(own) if own == letter))
            && let [index] = lower.as_mut_slice()
            && let Some(number) = index.as_int()
        {
            *index = Expr::int(number + by);
        } else {
            expr.for_each_child_mut(&mut |child| moved(child, letter, by));
        }
    }
    let mut copy = expr.clone();
    moved(&mut copy, letter, by);
    copy
}
