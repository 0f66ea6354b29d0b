//! Claims about signs on a region, answered by what shows them: `prove t^2 - t + 1 >= 0 on [0, 1]` is `positivity(t^2 - t + 1, 0, 1)`.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel, Sign, Term, applied, call, named};
use crate::language::eval::{Equals, Outcome};
use crate::language::lexicon::signs::{self, Shape, SignClaim};
use crate::language::syntax::{self, Sentence};
use crate::language::value::{Value, symbol_expr};
use crate::math::poly::Symbol;
use crate::session::{Answer, Failure, Session, defines, guarded, read_as, read_in};

impl Session {
    /// The formula of such a claim; `None` if the text is none. Strict inequalities over several variables are other claims.
    pub(in crate::session) fn certified(
        &self,
        file: &SourceFile,
        whole: Span,
        found: &SignClaim,
    ) -> Result<Option<Expr>, Box<Failure>> {
        let text = file.slice(whole);
        let word: String = text.trim_start().chars().take_while(|c| c.is_alphabetic()).collect();
        if found.asked && defines(&self.env, &word) {
            return Ok(None);
        }
        let SignClaim { claim, shape, region, condition: None, .. } = *found else { return Ok(None) };
        let place = |(a, b): (usize, usize)| Span::new(whole.start + a, whole.start + b);
        let read = |span: Span| {
            guarded(&self.limits, || read_in(&self.env, file, Some(span)))
                .map_err(|problem| Box::new(Failure { problem, file: file.clone() }))
        };
        let (claimed, region_of_object) = match (self.object_claimed(file, place(claim)), read(place(claim)))
        {
            (Some((claimed, ends)), _) => (claimed, Some(ends)),
            (None, Ok(claimed)) => (claimed, None),
            (None, Err(_)) => return Ok(None),
        };
        let Some((function, strict)) = function(claimed, shape) else { return Ok(None) };
        let positivity = |mut arguments: Vec<Expr>| {
            arguments.extend(strict.then(|| named("strict", Expr { span: whole, ..Expr::int(1) })));
            call("positivity", arguments, whole)
        };
        let Some(region) = region else {
            if let Some([a, b]) = region_of_object {
                return Ok(Some(positivity(vec![function, a, b])));
            }
            // Over all numbers.
            return Ok(Some(positivity(vec![function])));
        };
        let span = place(region);
        let inner = file.slice(span);
        let mut items = Vec::new();
        for (a, b) in signs::factors(inner) {
            let Ok(item) = read(Span::new(span.start + a, span.start + b)) else { return Ok(None) };
            items.push(item);
        }
        Ok(match region_of(items) {
            Some(Region::Interval(a, b)) => Some(positivity(vec![function, a, b])),
            Some(Region::Rows(rows)) if !strict => {
                let list = Expr { span, ..Kind::List(rows).into() };
                Some(call("positivity_over", vec![function, list], whole))
            }
            Some(Region::Rows(_)) | None => None,
        })
    }
}

impl Session {
    /// The claim with the direction in which a function can only be monotone: from its values at the ends.
    pub(in crate::session) fn directed(&self, file: &SourceFile, whole: Span, found: SignClaim) -> SignClaim {
        let Some(shape) = found.shape.filter(|shape| shape.has_no_direction()) else { return found };
        let place = |(a, b): (usize, usize)| Span::new(whole.start + a, whole.start + b);
        let claim = place(found.claim);
        let read = |span: Span| self.read(file, span).ok();
        let (claimed, ends) = match self.object_claimed(file, claim) {
            Some((claimed, ends)) => (Some(claimed), Some(ends)),
            None => (read(claim), None),
        };
        let ends = found.region.and_then(|region| self.ends(file, place(region))).or(ends);
        let falls = claimed.is_some_and(|claimed| self.falls(&claimed, ends.as_ref()));
        SignClaim { shape: Some(shape.in_direction(falls)), ..found }
    }

    /// The ends of the interval that stands at a place.
    fn ends(&self, file: &SourceFile, region: Span) -> Option<[Expr; 2]> {
        let read = self.read(file, region).ok()?;
        read.items()?.to_vec().try_into().ok()
    }

    /// Whether a formula is smaller at the second end, or 1, than at the first, or 0.
    fn falls(&self, claimed: &Expr, ends: Option<&[Expr; 2]>) -> bool {
        let [first, second] = ends.cloned().unwrap_or([Expr::int(0), Expr::int(1)]);
        let scalar = |mut formula: Expr| match self.clone().evaluate(&mut formula, Equals::Claims) {
            Ok(Outcome { value: Value::Scalar(value), .. }) => Some(value),
            _ => None,
        };
        let Some(own) = scalar(claimed.clone()) else { return false };
        let [variable] = own.variables().try_into().unwrap_or_else(|_| [Symbol::new("t")]);
        let at = |end: &Expr| {
            let value = named(&variable.to_string(), end.clone());
            scalar(call("subs", vec![claimed.clone(), value], claimed.span))
                .and_then(|value| value.as_rational())
        };
        matches!((at(&first), at(&second)), (Some(first), Some(second)) if second < first)
    }

    /// What is claimed of the sign or the shape of an object that was described before: is it positive on [0, 1]?
    pub(in crate::session) fn claimed_of(
        &self,
        file: &SourceFile,
        text: Span,
        object: &Expr,
        name: Option<&str>,
    ) -> Option<Expr> {
        let said = file.slice(text);
        let found = signs::sign_claim(said)?;
        let (shape, None) = (found.shape?, found.condition) else { return None };
        let subject = said.get(found.claim.0..found.claim.1)?;
        if !(signs::is_pronoun(subject) || name.is_some_and(|name| name == subject.trim())) {
            return None;
        }
        let place = |(a, b): (usize, usize)| Span::new(text.start + a, text.start + b);
        let region = match found.region {
            None => None,
            Some(region) => Some(self.ends(file, place(region))?),
        };
        let (claimed, own) = match is_bezier(object) {
            true => along(object, text).map(|(claimed, ends)| (claimed, Some(ends)))?,
            false => (object.clone(), None),
        };
        let ends = region.or(own);
        let shape = match shape.has_no_direction() {
            true => shape.in_direction(self.falls(&claimed, ends.as_ref())),
            false => shape,
        };
        match ends {
            Some([a, b]) => self.sign_over(&claimed, shape, [&a, &b], text),
            None => Some(sign_of(claimed, shape, text)),
        }
    }

    /// The Bézier polynomial that words describe, at a parameter, and the interval over which it is given.
    fn object_claimed(&self, file: &SourceFile, claim: Span) -> Option<(Expr, [Expr; 2])> {
        // A polygon is none of its curve.
        let text = file.slice(claim).to_lowercase();
        if ["polygon", "polígono", "poligono", "多边形"].iter().any(|word| text.contains(word)) {
            return None;
        }
        along(&self.spoken_data(file, claim)?, claim)
    }

    /// Judges what is said of the sign of a function, as the relation that says it: `t^2 + 1 is positive for all t`.
    pub(in crate::session) fn run_relation(
        &mut self,
        file: &SourceFile,
        whole: Span,
        found: &SignClaim,
        shape: Shape,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let place = |(a, b): (usize, usize)| Span::new(whole.start + a, whole.start + b);
        let claim = place(found.claim);
        let (claimed, ends) = match (self.object_claimed(file, claim), self.read(file, claim)) {
            (Some((claimed, ends)), _) => (claimed, Some(ends)),
            (None, Ok(claimed)) => (claimed, None),
            (None, Err(_)) => return Ok(None),
        };
        if let (Some([a, b]), None) = (&ends, found.region)
            && found.condition.is_none()
            && let Some(relation) = self.sign_over(&claimed, shape, [a, b], claim)
        {
            return self.evaluated_as(file, relation, whole, Equals::Claims).map(|answer| Some(vec![answer]));
        }
        if matches!(claimed.kind, Kind::Chain(..) | Kind::Sequence(_)) {
            return Ok(None);
        }
        // p is positive
        let claimed = match self.clone().evaluate(&mut claimed.clone(), Equals::Claims) {
            Ok(Outcome { value: Value::Function(function), .. }) => match function.as_formula() {
                Some((letter, _)) => applied(claimed, vec![symbol_expr(letter)], claim),
                None => claimed,
            },
            _ => claimed,
        };
        let relation = sign_of(claimed, shape, claim);
        let note = read_as(&relation, claim);
        let mut conditions: Vec<(Span, bool)> =
            found.region.map(|region| (place(region), false)).into_iter().collect();
        if let Some(condition) = found.condition {
            let Some(said) =
                syntax::conditions(file.slice(place(condition)), &|word| defines(&self.env, word))
            else {
                return Ok(None);
            };
            conditions
                .extend(said.into_iter().map(|(span, all)| (span.shifted(whole.start + condition.0), all)));
        }
        let sentence = Sentence { formula: claim, conditions, asked: true };
        let Some(mut answers) = self.run_said(file, &sentence, Some(relation), Equals::Claims)? else {
            return Ok(None);
        };
        if let Some(first) = answers.first_mut() {
            first.outcome.notes.insert(0, note);
        }
        Ok(Some(answers))
    }
}

impl Session {
    /// A strict claim on an interval by the least or largest value there: minimum(F, 0, 1) > 0.
    fn sign_over(&self, claimed: &Expr, shape: Shape, [a, b]: [&Expr; 2], span: Span) -> Option<Expr> {
        let function = derived(claimed.clone(), shape, span);
        let extreme = match shape.relation() {
            Rel::Gt | Rel::Ge => "minimum",
            Rel::Lt | Rel::Le => "maximum",
            _ => return None,
        };
        let value = call(extreme, vec![function, a.clone(), b.clone()], span);
        let zero = Expr { span, ..Expr::int(0) };
        Some(Expr { span, ..Expr::relation(value, shape.relation(), zero) })
    }
}

fn is_bezier(object: &Expr) -> bool {
    matches!(&object.kind, Kind::Apply(callee, _) if matches!(&callee.kind, Kind::Name(name) if name == "bezier"))
}

/// A Bézier curve at a parameter, and its interval.
fn along(object: &Expr, span: Span) -> Option<(Expr, [Expr; 2])> {
    let Kind::Apply(_, groups) = &object.kind else { return None };
    let ends = match groups.first().filter(|_| is_bezier(object))?.as_slice() {
        [_] => [Expr::int(0), Expr::int(1)],
        [_, a, b] => [a.clone(), b.clone()],
        _ => return None,
    };
    Some((applied(object.clone(), vec![Expr { span, ..Expr::name("t") }], span), ends))
}

/// The derivative whose sign a shape speaks of.
fn derived(function: Expr, shape: Shape, span: Span) -> Expr {
    (0..shape.order).fold(function, |function, _| call("diff", vec![function], span))
}

/// What a shape says of the sign of a function, or of a derivative.
fn sign_of(claimed: Expr, shape: Shape, span: Span) -> Expr {
    let function = derived(claimed, shape, span);
    let zero = Expr { span, ..Expr::int(0) };
    Expr { span, ..Expr::relation(function, shape.relation(), zero) }
}

/// What is not negative if the claim holds, and whether it has to be positive.
fn function(claimed: Expr, shape: Option<Shape>) -> Option<(Expr, bool)> {
    let span = claimed.span;
    let minus = |left: Expr, right: Expr| {
        let zero = |expr: &Expr| matches!(&expr.kind, Kind::Number(q) if num_traits::Zero::is_zero(q));
        if zero(&right) {
            return left;
        }
        let term = |sign, expr: Expr| Term {
            sign,
            expr: if matches!(expr.kind, Kind::Add(_)) { expr.grouped() } else { expr },
        };
        Expr { span, ..Expr::sum(vec![term(Sign::Plus, left), term(Sign::Minus, right)]) }
    };
    match (shape, claimed.kind) {
        (Some(shape), kind) if !matches!(kind, Kind::Chain(..)) => {
            let start = Expr { span, ..kind.into() };
            let derived = derived(start, shape, span);
            let turned = shape.is_turned();
            Some((if turned { minus(Expr { span, ..Expr::int(0) }, derived) } else { derived }, false))
        }
        (None, Kind::Chain(left, mut links)) if links.len() == 1 => {
            let link = links.remove(0);
            match link.rel {
                Rel::Ge | Rel::Gt => Some((minus(*left, link.expr), link.rel == Rel::Gt)),
                Rel::Le | Rel::Lt => Some((minus(link.expr, *left), link.rel == Rel::Lt)),
                _ => None,
            }
        }
        _ => None,
    }
}

enum Region {
    Interval(Expr, Expr),
    Rows(Vec<Expr>),
}

/// Two numbers, several pairs, or points.
fn region_of(items: Vec<Expr>) -> Option<Region> {
    let row = |expr: Expr| -> Option<Vec<Expr>> {
        match expr.kind {
            Kind::List(list) | Kind::Tuple(list) => Some(list),
            _ => None,
        }
    };
    let many = items.len() > 1;
    let mut rows = Vec::new();
    for item in items {
        match item.kind {
            // [0, 1]^3
            Kind::Pow(base, exponent) => {
                let Kind::Number(q) = &exponent.kind else { return None };
                let count =
                    num_traits::ToPrimitive::to_usize(&q.to_integer()).filter(|n| (1..=3).contains(n))?;
                rows.extend(std::iter::repeat_n(row(*base)?, count));
            }
            Kind::Sequence(points) if !many => {
                for point in points {
                    rows.push(row(point)?);
                }
            }
            Kind::List(list)
                if !many && list.iter().all(|part| matches!(part.kind, Kind::List(_) | Kind::Tuple(_))) =>
            {
                for point in list {
                    rows.push(row(point)?);
                }
            }
            kind => rows.push(row(kind.into())?),
        }
    }
    match rows.as_mut_slice() {
        [one] if one.len() == 2 => {
            let (b, a) = (one.pop()?, one.pop()?);
            Some(Region::Interval(a, b))
        }
        [_] => None,
        _ => Some(Region::Rows(rows.into_iter().map(|row| Kind::List(row).into()).collect())),
    }
}
