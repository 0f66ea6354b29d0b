//! What equations say of another one, whatever their names mean.
//!
//! **Definition.** A *term* is what is not put together by +, −, products and quotients: b_1, f(0, 1, 3), H'(1), a sum. Equations
//! between points hold for each coordinate. As equations in the products of terms they are linear, so a claim *follows* if it
//! is a combination of them; it is *wrong* if they leave a term one value in those that the claim has, and it has another.

use std::collections::BTreeSet;

use crate::budget;
use crate::formula::{Accent, Expr, Kind, Sign, Term};
use crate::judge::values::equality::differences;
use crate::judge::values::evaluator::{self, number};
use crate::judge::written::names::Head;
use crate::language::lexicon::roles::is_variable;
use crate::math::linalg::{self, Echelon};
use crate::math::number::Rational;
use crate::math::poly::{MonomialOrder, MultiPoly, Powers};
use nalgebra::DMatrix;
use num_traits::{Signed, Zero};

/// An equation by its sides.
pub type Sides = (Expr, Expr);

/// What comes of a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Consequence {
    /// It is a combination of the equations.
    Follows,
    /// Its left side is this, and not its right side.
    Differs(Expr),
}

/// More equations or products of terms than this are too many.
const MOST: usize = 120;

/// What equations say of a claim; `None` if they say nothing, or contradict each other.
///
/// Cost: one elimination over the rational numbers for each coordinate.
pub fn consequence(equations: &[Sides], claim: &Sides) -> Option<Consequence> {
    let count = dimension(equations, claim)?;
    let found: Vec<Found> =
        (0..count).map(|at| in_coordinate(equations, claim, at, count)).collect::<Option<_>>()?;
    if found.iter().all(|one| one.follows) {
        return Some(Consequence::Follows);
    }
    let formulas: Vec<Expr> = found.into_iter().map(|one| one.left).collect::<Option<_>>()?;
    let same = formulas.iter().all(|formula| formula.same_as(&formulas[0]));
    let number = formulas.iter().all(|formula| number(formula).is_some());
    match formulas.as_slice() {
        [one, rest @ ..] if rest.is_empty() || same && !number => Some(Consequence::Differs(one.clone())),
        _ if number => Some(Consequence::Differs(Kind::Tuple(formulas).into())),
        _ => None,
    }
}

/// What comes of one coordinate.
struct Found {
    /// Whether the claim is a combination of the equations.
    follows: bool,
    /// The left side by the other terms of the claim, if it is determined.
    left: Option<Expr>,
}

/// In how many coordinates the points of equations are given; `None` if the claim has others.
fn dimension(equations: &[Sides], claim: &Sides) -> Option<usize> {
    let mut own = BTreeSet::new();
    lengths(&claim.0, &mut own);
    lengths(&claim.1, &mut own);
    let number = number(&claim.0).or_else(|| number(&claim.1)).is_some();
    if own.is_empty() && !number {
        for (left, right) in equations.iter().filter(|(left, right)| !has_matrix(left) && !has_matrix(right))
        {
            lengths(left, &mut own);
            lengths(right, &mut own);
        }
    }
    match own.len() {
        0 => Some(1),
        1 => own.pop_first(),
        _ => None,
    }
}

/// The points in a formula: rows, and columns of matrices with one column.
fn point(expr: &Expr) -> Option<Vec<&Expr>> {
    match &expr.kind {
        Kind::Tuple(items) | Kind::List(items) => Some(items.iter().collect()),
        Kind::Matrix(rows, _) if rows.len() > 1 && rows.iter().all(|row| row.len() == 1) => {
            rows.iter().map(|row| row[0].as_ref()).collect()
        }
        Kind::Transpose(body) => point(body),
        _ => None,
    }
}

fn lengths(expr: &Expr, found: &mut BTreeSet<usize>) {
    if let Some(items) = point(expr) {
        found.insert(items.len());
        return;
    }
    if is_term(expr) {
        return;
    }
    expr.for_each_child(&mut |child| lengths(child, found));
}

/// Whether a matrix stands in it that is no point: then it is an equation of its entries.
fn has_matrix(expr: &Expr) -> bool {
    expr.has(&|part| matches!(&part.kind, Kind::Matrix(rows, _) if rows.iter().any(|row| row.len() > 1)))
}

/// A formula in one coordinate; `None` if a point in it has less.
fn coordinate(expr: &Expr, at: usize, count: usize) -> Option<Expr> {
    if let Some(items) = point(expr) {
        return (items.len() == count).then(|| items[at].clone());
    }
    if is_term(expr) {
        return Some(expr.clone());
    }
    let mut sound = true;
    let mut found = expr.clone();
    found.for_each_child_mut(&mut |child| match coordinate(child, at, count) {
        Some(new) => *child = new,
        None => sound = false,
    });
    sound.then_some(found)
}

/// What is not put together of others.
fn is_term(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_)
        | Kind::Add(_)
        | Kind::Mul(_)
        | Kind::Div(..)
        | Kind::Group(_)
        | Kind::Tuple(_)
        | Kind::List(_)
        | Kind::Matrix(..)
        | Kind::Transpose(_) => false,
        Kind::Name(name) => !is_variable(name),
        Kind::Pow(base, exponent) => {
            exponent.as_signed_int().is_none() || Head::of(base).is_some_and(|head| !head.lower.is_empty())
        }
        _ => true,
    }
}

/// Bold letters as plain ones, indices and arguments as numbers where they are some.
pub fn plain(expr: &Expr) -> Expr {
    if let Kind::Accent(Accent::Bold, inner) = &expr.kind {
        return plain(inner);
    }
    let mut found = expr.clone();
    found.for_each_child_mut(&mut |child| *child = plain(child));
    let settle = |item: &mut Expr| {
        if !matches!(item.kind, Kind::Number(_) | Kind::Name(_))
            && let Some(value) = number(item)
        {
            *item = Expr::number(&value);
        }
    };
    match &mut found.kind {
        Kind::Subscript(_, items) | Kind::Upper(_, items) => items.iter_mut().for_each(settle),
        Kind::Apply(_, groups) => groups.iter_mut().flatten().for_each(settle),
        _ => {}
    }
    found.without_spans()
}

/// The terms of formulas.
pub fn terms<'a>(formulas: impl Iterator<Item = &'a Expr>) -> Vec<Expr> {
    let mut terms = Terms::default();
    formulas.for_each(|formula| {
        terms.put(formula);
    });
    terms.0
}

/// Terms, each with a name of its own.
#[derive(Default)]
struct Terms(Vec<Expr>);

impl Terms {
    /// A formula with names in the places of its terms.
    fn put(&mut self, expr: &Expr) -> Expr {
        if is_term(expr) {
            let at = self.0.iter().position(|known| known == expr).unwrap_or_else(|| {
                self.0.push(expr.clone());
                self.0.len() - 1
            });
            return Expr::name(private(at));
        }
        let mut found = expr.clone();
        found.for_each_child_mut(&mut |child| *child = self.put(child));
        found
    }

    /// What stands behind a name.
    fn behind(&self, name: &str) -> Option<&Expr> {
        let letter = name.chars().next()?;
        self.0.get((letter as usize).checked_sub(FIRST as usize)?)
    }
}

const FIRST: u32 = 0xe000;

/// A letter that no page uses.
pub fn private(number: usize) -> String {
    char::from_u32(FIRST + number as u32).map_or_else(String::new, String::from)
}

/// A formula a·x + … by the products of its terms.
type Row = Vec<(Powers, Rational)>;

/// The numerators of the difference of two sides.
fn rows((left, right): &Sides) -> Option<Vec<Row>> {
    let [left, right] = [left, right].map(|side| evaluator::machine().eval(side).ok());
    let rows = differences(&left?, &right?)?;
    let row = |numerator: &MultiPoly| numerator.terms(MonomialOrder::Lex);
    Some(rows.iter().map(|one| row(one.numerator())).filter(|row| !row.is_empty()).collect())
}

fn in_coordinate(equations: &[Sides], claim: &Sides, at: usize, count: usize) -> Option<Found> {
    let mut terms = Terms::default();
    let mut put = |(left, right): &Sides| {
        let whole = has_matrix(left) || has_matrix(right);
        let one = |side: &Expr| match whole {
            true => Some(side.clone()),
            false => coordinate(side, at, count),
        };
        let (left, right) = (one(left)?, one(right)?);
        Some((terms.put(&left), terms.put(&right)))
    };
    let claim = put(claim)?;
    let mut all: Vec<Sides> = equations.iter().filter_map(&mut put).collect();
    // Numbers first: products with them are linear.
    let values: Vec<(usize, String, Expr)> = all
        .iter()
        .enumerate()
        .filter_map(|(at, (left, right))| match (&left.kind, number(right)) {
            (Kind::Name(name), Some(value)) => Some((at, name.clone(), Expr::number(&value).grouped())),
            _ => None,
        })
        .collect();
    let with_values = |own: Option<usize>, side: &Expr| {
        let others = values.iter().filter(|(at, ..)| Some(*at) != own);
        others.fold(side.clone(), |side, (_, name, value)| side.with_name(name, value))
    };
    for (at, (left, right)) in all.iter_mut().enumerate() {
        (*left, *right) = (with_values(Some(at), left), with_values(Some(at), right));
    }
    let known: Vec<Row> = all.iter().filter_map(rows).flatten().collect();
    let claimed = rows(&(claim.0.clone(), with_values(None, &claim.1)))?;
    let left = match &claim.0.kind {
        Kind::Name(name) => Some(name.clone()),
        _ => None,
    };
    let found: Vec<Found> = match claimed.as_slice() {
        [claimed] => return decide(&known, claimed, left.as_deref(), &terms),
        _ => claimed.iter().map(|row| decide(&known, row, None, &terms)).collect::<Option<_>>()?,
    };
    Some(Found { follows: found.iter().all(|one| one.follows), left: None })
}

/// What rows say of another one, in which the term with a name stands alone on one side.
fn decide(known: &[Row], claimed: &Row, left: Option<&str>, terms: &Terms) -> Option<Found> {
    let is_left = |powers: &Powers| matches!(powers.as_slice(), [(symbol, 1)] if Some(symbol.base()) == left);
    let mut columns: Vec<&Powers> = Vec::new();
    for (powers, _) in known.iter().flatten() {
        if !powers.is_empty() && !claimed.iter().any(|(own, _)| own == powers) && !columns.contains(&powers) {
            columns.push(powers);
        }
    }
    let first = columns.len();
    let mut own: Vec<&Powers> = claimed.iter().map(|(powers, _)| powers).filter(|p| !p.is_empty()).collect();
    own.sort_by_key(|powers| !is_left(powers));
    columns.extend(own);
    if columns.len() > MOST || known.len() > MOST {
        return None;
    }
    budget::steps(u32::try_from(known.len() * columns.len()).unwrap_or(u32::MAX));
    let width = columns.len() + 1;
    let entry = |row: &Row, column: usize| {
        let wanted = columns.get(column).copied();
        row.iter()
            .find(|(powers, _)| wanted.map_or(powers.is_empty(), |wanted| wanted == powers))
            .map_or_else(Rational::zero, |(_, value)| value.clone())
    };
    let matrix = DMatrix::from_fn(known.len(), width, |row, column| entry(&known[row], column));
    let Echelon { matrix, pivots } = linalg::reduced_row_echelon(&matrix);
    if pivots.contains(&(width - 1)) {
        return None;
    }
    let mut rest: Vec<Rational> = (0..width).map(|column| entry(claimed, column)).collect();
    for (row, &pivot) in pivots.iter().enumerate() {
        let factor = rest[pivot].clone();
        if !factor.is_zero() {
            for (column, value) in rest.iter_mut().enumerate() {
                *value -= &factor * &matrix[(row, column)];
            }
        }
    }
    // The term on the left by the other terms of the claim; one that is new there may be anything.
    let old = |powers: &&Powers| known.iter().flatten().any(|(other, _)| other == *powers);
    let left = left.filter(|_| columns[first..].iter().all(old));
    let left = left.filter(|_| columns.get(first).is_some_and(|powers| is_left(powers))).and_then(|_| {
        let row = pivots.iter().position(|&pivot| pivot == first)?;
        let mut sum = Vec::new();
        for column in first + 1..width {
            let factor = -&matrix[(row, column)];
            if factor.is_zero() {
                continue;
            }
            let sign = if factor.is_negative() { Sign::Minus } else { Sign::Plus };
            let mut factors = vec![Expr::number(&factor.abs())];
            for (symbol, power) in columns.get(column).copied().into_iter().flatten() {
                let behind = terms.behind(symbol.base()).cloned();
                let base = behind.unwrap_or_else(|| Expr::name(symbol.base()));
                factors.push(if *power == 1 { base } else { base.power(Expr::int(i64::from(*power))) });
            }
            if factors.len() > 1 && factors[0].as_int() == Some(1) {
                factors.remove(0);
            }
            sum.push(Term { sign, expr: Expr::product(factors) });
        }
        Some(if sum.is_empty() { Expr::int(0) } else { Expr::sum(sum) })
    });
    Some(Found { follows: rest.iter().all(Zero::is_zero), left })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{latex, write};

    fn sides(formula: &str) -> Sides {
        let Kind::Chain(left, links) = latex::read(formula).unwrap().kind else { panic!("{formula}") };
        (plain(&left), plain(&links[0].expr))
    }

    fn found(equations: &[&str], claim: &str) -> String {
        let equations: Vec<Sides> = equations.iter().map(|one| sides(one)).collect();
        match consequence(&equations, &sides(claim)) {
            Some(Consequence::Follows) => "follows".to_owned(),
            Some(Consequence::Differs(value)) => write::text(&value),
            None => "open".to_owned(),
        }
    }

    #[test]
    fn combinations_of_equations() {
        let hermite = ["H'(1) = m_1", "H'(1) = 3(b_3 - b_2)", "b_3 = p_1"];
        assert_eq!(found(&hermite, r"b_2 = p_1 - \frac13 m_1"), "follows");
        assert_eq!(found(&hermite, r"b_2 = p_1 + \frac13 m_1"), "p_1 - 1/3 m_1");
        // Nothing says what it is.
        assert_eq!(found(&hermite, r"b_1 = p_1 + \frac13 m_1"), "open");
        assert_eq!(found(&hermite, r"b_2 = p_0"), "open");
    }

    #[test]
    fn points_and_matrices() {
        let join = ["b_2 = (3, 1)", "b_3 = (5, 2)", "c_0 = b_3", r"\frac32 (b_3 - b_2) = 3 (c_1 - c_0)"];
        assert_eq!(found(&join, r"\mathbf c_1 = (6, \frac52)"), "follows");
        assert_eq!(found(&join, r"\mathbf c_1 = (9, 4)"), "(6, 5/2)");
        assert_eq!(found(&join, r"\mathbf c_1 = (6, 4)"), "(6, 5/2)");
        let normal = [
            r"\begin{pmatrix}4&6\\6&14\end{pmatrix}\begin{pmatrix}\alpha\\\beta\end{pmatrix}=\begin{pmatrix}12\\23\end{pmatrix}",
        ];
        assert_eq!(found(&normal, r"\alpha = \frac32"), "follows");
        assert_eq!(found(&normal, r"\beta = \frac{11}{10}"), "1");
    }

    #[test]
    fn contradictions_and_free_terms_say_nothing() {
        assert_eq!(found(&["a_1 = 1", "a_1 = 2"], "a_1 = 3"), "open");
        assert_eq!(found(&["a_1 = a_2"], "a_1 = 3"), "open");
        // The parameter may be another one there.
        assert_eq!(found(&["q = (1 - t) b_0 + t b_1"], r"q = \frac12 b_0 + \frac12 b_1"), "open");
        // Products of terms are no squares of others.
        assert_eq!(found(&["a_1 a_2 = 3", "a_1 = 2"], r"a_2 = \frac32"), "follows");
    }
}
