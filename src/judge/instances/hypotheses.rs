//! What hypotheses determine: linear equations in the names that the facts leave open.
//!
//! **Definition.** A hypothesis is an equation between two values. Where it contains open names (symbols
//! with an index, coefficients of unknown functions) it holds for all values of the parameters t, u, …, so
//! each of its coefficients in them is an equation of its own. These equations are linear in the open
//! names that are solved for; everything else is part of their coefficients.

use std::collections::BTreeSet;

use crate::budget;
use crate::judge::page::context::is_variable;
use crate::judge::values::compare;
use crate::judge::values::equality::differences;
use crate::language::lexicon::{families, letters, roles};
use crate::language::value::Value;
use crate::math::linalg::{self, Echelon};
use crate::math::number::integer;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use nalgebra::DMatrix;

/// More equations or names than this are too many.
const MOST: usize = 40;

/// Names in terms of those that stay free.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// Each name and what it is.
    pub values: Vec<(Symbol, Fraction)>,
    /// Whether numbers were put for other names, so that this is one sample only.
    pub sampled: bool,
}

/// With more names than this to be solved for, the others are numbers.
const SYMBOLIC: usize = 3;

/// Numbers for names, different ones in no simple relation.
const NUMBERS: [i64; 12] = [2, 5, 11, 23, 41, 67, 97, 139, 191, 251, 317, 389];

/// A parameter: it may have any value in a hypothesis about open names.
fn is_parameter(symbol: &Symbol) -> bool {
    symbol.is_plain() && is_variable(symbol.base())
}

/// The coefficients of an unknown function.
pub fn is_coefficient(symbol: &Symbol) -> bool {
    symbol.base().starts_with('[')
}

/// The polynomials that vanish when two values are equal for all values of the parameters.
fn equations(a: &Value, b: &Value, is_parameter: &dyn Fn(&Symbol) -> bool) -> Option<Vec<MultiPoly>> {
    let mut found = Vec::new();
    for difference in differences(a, b)? {
        let numerator = difference.numerator().clone();
        if numerator.variables().iter().all(is_parameter) {
            // u + v + w = 1 restricts the parameters themselves.
            continue;
        }
        let parameters: Vec<Symbol> =
            numerator.variables().iter().filter(|symbol| is_parameter(symbol)).cloned().collect();
        let mut parts = vec![numerator];
        for parameter in &parameters {
            parts = parts.iter().flat_map(|part| part.coefficients_in(parameter)).collect();
        }
        found.extend(parts.into_iter().filter(|part| !part.is_empty()));
    }
    Some(found)
}

/// The symbols in which all equations are linear together, those that are wanted most first.
fn linear_symbols(equations: &[MultiPoly], wanted: &dyn Fn(&Symbol) -> bool) -> Vec<Symbol> {
    let rank = |symbol: &Symbol| match (is_coefficient(symbol), wanted(symbol)) {
        (_, true) => 0,
        (true, _) => 1,
        _ => 2,
    };
    let mut symbols: BTreeSet<Symbol> = equations
        .iter()
        .flat_map(|equation| equation.variables())
        .filter(|s| !is_parameter(s))
        .cloned()
        .collect();
    for equation in equations {
        for (powers, _) in equation.terms(crate::math::poly::MonomialOrder::Lex) {
            let used: Vec<(&Symbol, u32)> = powers
                .iter()
                .map(|(symbol, power)| (symbol, *power))
                .filter(|(s, _)| symbols.contains(*s))
                .collect();
            let degree: u32 = used.iter().map(|(_, power)| power).sum();
            if degree <= 1 {
                continue;
            }
            let best =
                used.iter().filter(|(_, power)| *power == 1).map(|(s, _)| (rank(s), (*s).clone())).min();
            let dropped: Vec<Symbol> = used
                .iter()
                .map(|(symbol, _)| (*symbol).clone())
                .filter(|symbol| best.as_ref().is_none_or(|(_, kept)| kept != symbol))
                .collect();
            dropped.iter().for_each(|symbol| {
                symbols.remove(symbol);
            });
        }
    }
    let mut list: Vec<Symbol> = symbols.into_iter().collect();
    list.sort_by_key(|symbol| (rank(symbol), symbol.clone()));
    list
}

/// The equations as rows: coefficients of the symbols, then the constant.
fn rows(equations: &[MultiPoly], symbols: &[Symbol]) -> DMatrix<Fraction> {
    let mut entries = Vec::with_capacity(equations.len() * (symbols.len() + 1));
    for equation in equations {
        let mut rest = equation.clone();
        for symbol in symbols {
            let mut parts = rest.coefficients_in(symbol).into_iter();
            rest = parts.next().unwrap_or_else(MultiPoly::zero);
            entries.push(Fraction::from(parts.next().unwrap_or_else(MultiPoly::zero)));
        }
        entries.push(Fraction::from(rest));
    }
    DMatrix::from_row_iterator(equations.len(), symbols.len() + 1, entries)
}

/// Solves hypotheses for the names they determine, the wanted ones first. `None` if there are no equations,
/// too many, or if they contradict each other.
///
/// Cost: one elimination over the fractions of the other symbols.
///
/// A parameter of which the claim speaks, too, has one value if it has a Greek letter, or if the hypothesis says that two
/// unknown functions agree there: F(s) = G(s) where two curves meet. So has one that something is divided by, the length
/// of an interval.
pub fn solve(
    hypotheses: &[(Value, Value)],
    claimed: &[&Value],
    wanted: &dyn Fn(&Symbol) -> bool,
) -> Option<Solution> {
    let spoken: BTreeSet<Symbol> = claimed.iter().flat_map(|value| compare::symbols(value)).collect();
    let lengths: BTreeSet<Symbol> = hypotheses
        .iter()
        .filter_map(|(a, b)| differences(a, b))
        .flatten()
        .flat_map(|difference| difference.denominator().variables().to_vec())
        .collect();
    let equations = hypotheses.iter().filter_map(|(a, b)| {
        let contact = is_contact(a, b);
        let greek = |symbol: &Symbol| letters::sign(symbol.base()).is_some();
        let fixed = |symbol: &Symbol| {
            lengths.contains(symbol) || spoken.contains(symbol) && (contact || greek(symbol))
        };
        equations(a, b, &|symbol| is_parameter(symbol) && !fixed(symbol))
    });
    let all: Vec<MultiPoly> = equations.flatten().collect();
    let mut symbols = linear_symbols(&all, wanted);
    symbols.retain(|symbol| !is_parameter(symbol));
    solved(&all, symbols)
}

/// Whether two values are those of two unknown functions.
fn is_contact(a: &Value, b: &Value) -> bool {
    let function = |value: &Value| {
        let symbols = compare::symbols(value);
        let mut members = symbols.iter().filter(|symbol| !symbol.is_plain());
        let first = members.next().filter(|symbol| is_coefficient(symbol))?.base().to_owned();
        members.all(|symbol| symbol.base() == first).then_some(first)
    };
    matches!((function(a), function(b)), (Some(f), Some(g)) if f != g)
}

fn solved(all: &[MultiPoly], symbols: Vec<Symbol>) -> Option<Solution> {
    if all.is_empty() || symbols.is_empty() || all.len() > MOST || symbols.len() > MOST {
        return None;
    }
    let others: BTreeSet<&Symbol> =
        all.iter().flat_map(|equation| equation.variables()).filter(|s| !symbols.contains(s)).collect();
    let sampled = symbols.len() > SYMBOLIC && !others.is_empty();
    // No number is any size.
    if sampled && others.iter().any(|symbol| symbol.is_plain() && roles::is_degree(symbol.base())) {
        return None;
    }
    let numbers: Vec<(Symbol, MultiPoly)> = others
        .iter()
        .zip(NUMBERS.iter().cycle().zip(0i64..))
        .filter(|_| sampled)
        .map(|(symbol, (number, at))| {
            ((*symbol).clone(), MultiPoly::constant(integer(number + 400 * (at / NUMBERS.len() as i64))))
        })
        .collect();
    let put: Vec<MultiPoly> = all.iter().map(|equation| equation.substitute(&numbers)).collect();
    // An operation with fractions is some steps.
    let work = all.len() * symbols.len() * all.len().min(symbols.len());
    budget::steps(u32::try_from(4 * work).unwrap_or(u32::MAX));
    let Echelon { matrix, pivots } = linalg::reduced_row_echelon(&rows(&put, &symbols));
    if pivots.contains(&symbols.len()) {
        return None;
    }
    let zero = || Fraction::from(MultiPoly::zero());
    // w_0 (P_0 - Q) = 0, for any P_0 and Q: that all are 0 is no solution that anybody means.
    let homogeneous = (0..matrix.nrows()).all(|row| matrix[(row, symbols.len())] == zero());
    let alone =
        |row: usize, pivot: usize| (pivot + 1..symbols.len()).all(|column| matrix[(row, column)] == zero());
    if homogeneous && pivots.iter().enumerate().any(|(row, &pivot)| alone(row, pivot)) {
        return None;
    }
    let solution = solution(&matrix, &pivots, &symbols).into_iter();
    let numbers = numbers.into_iter().map(|(symbol, number)| (symbol, Fraction::from(number)));
    Some(Solution { values: solution.chain(numbers).collect(), sampled })
}

/// The general solution of equations in the symbols that are asked for, all others being any numbers. `None` if they
/// are not linear, too many, or contradict each other.
///
/// Cost: one elimination over the fractions of the other symbols.
pub fn general(
    equations: &[(Value, Value)],
    unknown: &dyn Fn(&Symbol) -> bool,
) -> Option<Vec<(Symbol, Fraction)>> {
    let mut all: Vec<MultiPoly> = Vec::new();
    for (a, b) in equations {
        let numerators = differences(a, b)?.into_iter().map(|difference| difference.numerator().clone());
        all.extend(numerators.filter(|numerator| !numerator.is_empty()));
    }
    let symbols: BTreeSet<Symbol> =
        all.iter().flat_map(|equation| equation.variables()).filter(|s| unknown(s)).cloned().collect();
    let linear = |equation: &MultiPoly| {
        let terms = equation.terms(crate::math::poly::MonomialOrder::Lex);
        let degree = |powers: &[(Symbol, u32)]| -> u32 {
            powers.iter().filter(|(symbol, _)| unknown(symbol)).map(|(_, power)| power).sum()
        };
        terms.iter().all(|(powers, _)| degree(powers) < 2)
    };
    if symbols.is_empty() || symbols.len() > MOST || all.len() > MOST || !all.iter().all(linear) {
        return None;
    }
    let work = all.len() * symbols.len() * all.len().min(symbols.len());
    budget::steps(u32::try_from(4 * work).unwrap_or(u32::MAX));
    let symbols: Vec<Symbol> = symbols.into_iter().rev().collect();
    let Echelon { matrix, pivots } = linalg::reduced_row_echelon(&rows(&all, &symbols));
    (!pivots.contains(&symbols.len())).then(|| solution(&matrix, &pivots, &symbols))
}

/// The names of the pivots in terms of the other ones.
fn solution(matrix: &DMatrix<Fraction>, pivots: &[usize], symbols: &[Symbol]) -> Vec<(Symbol, Fraction)> {
    let zero = Fraction::from(MultiPoly::zero());
    let value = |(row, &pivot): (usize, &usize)| {
        let mut value = zero.minus(&matrix[(row, symbols.len())]);
        for (column, symbol) in symbols.iter().enumerate().skip(pivot + 1) {
            let entry = &matrix[(row, column)];
            if *entry != zero {
                value = value.minus(&entry.times(&Fraction::from(MultiPoly::symbol(symbol.clone()))));
            }
        }
        (symbols[pivot].clone(), value)
    };
    pivots.iter().enumerate().map(value).collect()
}

/// Whether an equation can be read as saying what the members of a family are that stands on one of its
/// sides only, and whose names the facts leave open; it holds for all values of the arguments.
pub fn introduces(
    left: &Value,
    right: &Value,
    is_open: &dyn Fn(&Symbol) -> bool,
    is_argument: &dyn Fn(&Symbol) -> bool,
) -> bool {
    let (sl, sr) = (compare::symbols(left), compare::symbols(right));
    let same_family = |a: &Symbol, b: &Symbol| {
        a.base() == b.base()
            && a.upper() == b.upper()
            && a.accent() == b.accent()
            && a.indices().len() == b.indices().len()
    };
    let only = |a: &[Symbol], b: &[Symbol]| -> BTreeSet<Symbol> {
        let family = |symbol: &Symbol| {
            let standard = families::is_family(symbol.base());
            !symbol.is_plain()
                && !is_coefficient(symbol)
                && !is_argument(symbol)
                && !standard
                && is_open(symbol)
        };
        let new = |symbol: &&Symbol| family(symbol) && !b.iter().any(|other| same_family(symbol, other));
        a.iter().filter(new).cloned().collect()
    };
    [only(&sr, &sl), only(&sl, &sr)].into_iter().any(|new| {
        let equations = equations(left, right, is_argument).unwrap_or_default();
        let mut symbols = linear_symbols(&equations, &|symbol| new.contains(symbol));
        symbols.retain(|symbol| new.contains(symbol));
        !new.is_empty() && solved(&equations, symbols).is_some()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::values::evaluator;
    use crate::language::syntax;
    use crate::language::value::symbol_expr;

    fn value(text: &str) -> Value {
        evaluator::machine().eval(&syntax::parse(text).unwrap()).unwrap()
    }

    fn found(hypotheses: &[(&str, &str)], wanted: &str) -> Vec<String> {
        let pairs: Vec<(Value, Value)> = hypotheses.iter().map(|(a, b)| (value(a), value(b))).collect();
        let solution = solve(&pairs, &[], &|symbol| symbol.base() == wanted).unwrap_or_default();
        let own = solution.values.into_iter().filter(|(symbol, _)| symbol.base() == wanted);
        own.map(|(symbol, value)| {
            let value = crate::language::write::text(&Value::Scalar(value).to_expr());
            format!("{} = {value}", crate::language::write::text(&symbol_expr(&symbol)))
        })
        .collect()
    }

    #[test]
    fn two_expansions_of_one_line() {
        let found = found(&[("b_0 (1-t) + b_1 t", "c_0 (1-t)^2 + 2 c_1 t (1-t) + c_2 t^2")], "c");
        assert_eq!(found, ["c_0 = b_0", "c_1 = 1/2 b_0 + 1/2 b_1", "c_2 = b_1"]);
    }

    #[test]
    fn contradictions_and_parameters_determine_nothing() {
        assert!(solve(&[(value("a_1"), value("1")), (value("a_1"), value("2"))], &[], &|_| true).is_none());
        assert!(solve(&[(value("u + v"), value("1"))], &[], &|_| true).is_none());
    }

    #[test]
    fn functions_agree_where_they_meet() {
        let functions = [0, 1].map(|k| {
            let coefficient = |name: &str| Value::symbol(Symbol::new(name).numbered(k));
            (coefficient("[F]"), coefficient("[G]"))
        });
        assert!(functions.iter().all(|(f, g)| is_contact(f, g) && !is_contact(f, f)));
        assert!(!is_contact(&value("b_0 (1-t) + b_1 t"), &functions[0].0));
    }

    #[test]
    fn new_names_on_one_side() {
        assert!(introduces(&value("b_0 (1-t) + b_1 t"), &value("c_0 + c_1 t"), &|_| true, &is_parameter));
        assert!(!introduces(&value("b_0 (1-t) + b_1 t"), &value("b_0 + b_1 t"), &|_| true, &is_parameter));
        // c_2 was forgotten: no value of it makes the equation true for all arguments.
        assert!(!introduces(
            &value("c_0 + c_1 (t_1 + t_2)/2 + c_2 t_1 t_2"),
            &value("c_0 + c_1 t_1 t_2"),
            &|_| true,
            &|symbol| is_variable(symbol.base())
        ));
        assert!(!introduces(&value("b_0 (1-t) + b_1 t^2"), &value("c_0 + c_1 t"), &|_| true, &is_parameter));
    }
}
