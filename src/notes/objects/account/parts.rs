//! The parts of a curve that a paragraph speaks of, and where it is cut.

use super::read::Told;
use super::signs::Sign;
use super::{Account, formulas};
use crate::formula::{Expr, Kind, Rel, Sign as Plus, Term};
use crate::judge::written::names::bases;
use crate::math::number::integer;
use crate::notes::speech::Hint;

impl Told<'_> {
    /// The parts that are spoken of, each with its place, in their order: true for the second one.
    pub(super) fn parts(&self) -> Vec<(usize, bool)> {
        let mut found = Vec::new();
        for (at, sign) in self.all.iter().enumerate() {
            let second = match sign {
                Sign::Hint(Hint::First) => false,
                Sign::Hint(Hint::Second) => true,
                _ => continue,
            };
            let part = |sign: &Sign| matches!(sign, Sign::Hint(Hint::Half | Hint::Part));
            let joins = |sign: &Sign| {
                matches!(
                    sign,
                    Sign::Filler | Sign::Join | Sign::Article | Sign::Hint(Hint::First | Hint::Second)
                )
            };
            let after = self.all[at + 1..].iter().find(|sign| !joins(sign)).is_some_and(part);
            let before = self.all[..at].iter().rev().find(|sign| !joins(sign)).is_some_and(part);
            let told = self.all[..at].iter().any(part);
            // "Die linke Hälfte … die rechte", "左段 … 右段的"
            if after || before || told {
                found.push((at, second));
            }
        }
        found
    }

    /// Where the curve is cut.
    pub(super) fn middle(&self, whole: &(Expr, Expr), account: &Account) -> Option<Expr> {
        let mut numbers: Vec<Expr> = Vec::new();
        let named = |name: &str| account.letters.iter().any(|own| own == name);
        for number in formulas(self.all) {
            let [said] = self.page.said(number) else { continue };
            let own = match &said.kind {
                Kind::Chain(left, links) if matches!(left.kind, Kind::Name(_)) => match links.as_slice() {
                    [link] if link.rel == Rel::Eq && bases(&link.expr).is_empty() => Some(&link.expr),
                    _ => None,
                },
                Kind::Number(_) | Kind::Div(..) if bases(said).is_empty() => Some(said),
                Kind::Name(name) if named(name) && !said.same_as(&account.name) => Some(said),
                _ => None,
            };
            if let Some(own) = own
                && !numbers.iter().any(|known| known.same_as(own))
            {
                numbers.push(own.clone());
            }
        }
        let half = self.all.iter().any(|sign| matches!(sign, Sign::Hint(Hint::Half | Hint::Middle)));
        match numbers.as_slice() {
            [one] => Some(one.clone()),
            [] if half => {
                let sum =
                    [&whole.0, &whole.1].map(|end| Term { sign: Plus::Plus, expr: end.clone().grouped() });
                let half = Expr::number(&(integer(1) / integer(2)));
                Some(Expr::product(vec![half, Expr::from(Kind::Add(sum.into())).grouped()]))
            }
            _ => None,
        }
    }
}
