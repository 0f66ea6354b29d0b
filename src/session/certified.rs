//! Claims about signs on a region, answered by what shows them: `prove t^2 - t + 1 >= 0 on [0, 1]` is `positivity(t^2 - t + 1, 0, 1)`.

use super::{Answer, Failure, Session, defines, guarded, read_in};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel, Sign, Term, call};
use crate::language::eval::Equals;
use crate::language::lexicon::signs::{self, Shape, SignClaim};

impl Session {
    /// The formula of such a claim; `None` if the text is none. Strict inequalities are other claims.
    pub(super) fn certified(
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
        let SignClaim { claim, shape, region, .. } = *found;
        let place = |(a, b): (usize, usize)| Span::new(whole.start + a, whole.start + b);
        let read = |span: Span| {
            guarded(&self.limits, || read_in(&self.env, file, Some(span)))
                .map_err(|problem| Box::new(Failure { problem, file: file.clone() }))
        };
        let Ok(claimed) = read(place(claim)) else { return Ok(None) };
        let Some(function) = function(claimed, shape) else { return Ok(None) };
        let Some(region) = region else {
            // Over all numbers.
            return Ok(Some(call("positivity", vec![function], whole)));
        };
        let span = place(region);
        let inner = file.slice(span);
        let mut items = Vec::new();
        for (a, b) in signs::factors(inner) {
            let Ok(item) = read(Span::new(span.start + a, span.start + b)) else { return Ok(None) };
            items.push(item);
        }
        Ok(match region_of(items) {
            Some(Region::Interval(a, b)) => Some(call("positivity", vec![function, a, b], whole)),
            Some(Region::Rows(rows)) => {
                let list = Expr { span, ..Kind::List(rows).into() };
                Some(call("positivity_over", vec![function, list], whole))
            }
            None => None,
        })
    }
}

impl Session {
    /// Judges that a function is positive or negative on an interval, as the inequality that says it.
    pub(super) fn run_strict(
        &mut self,
        file: &SourceFile,
        whole: Span,
        found: &SignClaim,
        shape: Shape,
        equals: Equals,
    ) -> Result<Vec<Answer>, Box<Failure>> {
        let text = file.slice(whole);
        let part = |(a, b): (usize, usize)| text.get(a..b).unwrap_or_default().trim();
        let sign = if shape.turned { '<' } else { '>' };
        let place = found.region.map_or_else(String::new, |region| format!(" on {}", part(region)));
        let file = SourceFile::new(file.name(), format!("{} {sign} 0{place}", part(found.claim)));
        let end = file.text().len();
        self.run_part(&file, Some(Span::new(0, end)), equals)
    }
}

/// What is not negative if the claim holds.
fn function(claimed: Expr, shape: Option<Shape>) -> Option<Expr> {
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
        (Some(Shape { order, turned, .. }), kind) if !matches!(kind, Kind::Chain(..)) => {
            let start = Expr { span, ..kind.into() };
            let derived = (0..order).fold(start, |f, _| call("diff", vec![f], span));
            Some(if turned { minus(Expr { span, ..Expr::int(0) }, derived) } else { derived })
        }
        (None, Kind::Chain(left, mut links)) if links.len() == 1 => {
            let link = links.remove(0);
            match link.rel {
                Rel::Ge => Some(minus(*left, link.expr)),
                Rel::Le => Some(minus(link.expr, *left)),
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
