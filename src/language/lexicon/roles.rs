//! What a letter usually stands for, where nothing on the page says it.

use super::families;
use super::letters::is_one_letter;
use crate::formula::{Expr, Kind};

/// Functions when they have no value: `f(t + 1)` is then a question.
pub(crate) const FUNCTIONS: &[&str] = &["f", "g", "h", "phi", "psi", "varphi"];

/// Families of functions when they have indices but no value: Lagrange's, Hermite's, Chebyshev's besides those with notations.
pub(crate) const FAMILIES: &[&str] = &[families::BERNSTEIN, families::SPLINE, "L", "H", "T"];

/// Functions, too; with indices they are points or numbers.
const POLYNOMIALS: &[&str] = &["p", "q"];

/// Functions with an index, such as the pieces of a curve F or of a spline S, and e, which is exp.
const PIECES: &[&str] = &["F", "G", "S", "e"];

/// Parameters and coordinates.
const PARAMETERS: &[&str] = &["r", "s", "t", "u", "v", "x", "y", "z"];

/// Numbers that depend on no parameter.
const CONSTANTS: &[&str] = &["a", "b", "c", "h", "k", "alpha", "beta", "lambda", "mu", "omega"];

/// What a degree or an order is called; the usual ones first.
pub(crate) const DEGREES: &[&str] = &["n", "d", "m", "N"];

/// Integers when they are indices.
const INDICES: &[&str] =
    &["i", "j", "k", "l", "m", "n", "d", "r", "s", "q", "p", "N", "M", "ell", "nu", "mu"];

/// What runs under a sum.
const RUNNING: &[&str] = &["i", "j", "k", "l"];

/// Curves and functions on a page.
pub(crate) const NAMED_FUNCTIONS: &[&str] =
    &["f", "g", "h", "F", "G", "H", "phi", "psi", "varphi", "Phi", "Psi"];

/// Variables that values may be put in for.
const VARIABLES: &[&str] = &["t", "u", "v", "w", "x", "y", "z", "s", "r", "tau", "xi", "theta", "lambda"];

/// Variables of a formula that names none; t comes before them.
const OTHER_VARIABLES: &[&str] = &["u", "v", "w", "x", "y", "z", "s", "tau"];

/// Numbers even before a parenthesis.
const FACTORS: &[&str] =
    &["n", "i", "j", "k", "m", "d", "alpha", "beta", "gamma", "lambda", "mu", "t", "u", "v", "pi"];

/// Control points of the curve with the same letter.
const CONTROL_POINTS: &[&str] = &["b", "p", "P"];

/// What the members of a list are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Listed {
    /// Control points.
    Points,
    /// Knots.
    Knots,
    /// Nodes of an interpolation.
    Nodes,
    /// Values at nodes.
    Values,
    /// Weights.
    Weights,
    /// Lengths of intervals.
    Lengths,
    /// Slopes at nodes.
    Slopes,
}

/// What letters stand for when they have an index or are a list.
const LISTS: &[(Listed, &[&str])] = &[
    (Listed::Points, &["b", "c", "d", "p", "q", "B", "C", "D", "P", "Q", "V"]),
    (Listed::Knots, &["t", "u", "T", "U", "tau", "xi", "knots"]),
    (Listed::Nodes, &["x"]),
    (Listed::Values, &["y"]),
    (Listed::Weights, &["w", "omega"]),
    (Listed::Lengths, &["h"]),
    (Listed::Slopes, &["m"]),
];

/// What a letter usually stands for when it has an index or is a list.
pub(crate) fn listed(letter: &str) -> Option<Listed> {
    LISTS.iter().find(|(_, letters)| letters.contains(&letter)).map(|(what, _)| *what)
}

/// Places that exist somewhere, in mean value theorems and remainders.
const INTERMEDIATE: &[&str] = &["xi", "eta", "zeta"];

/// Barycentric coordinates, and parameters in [0, 1].
const BARYCENTRIC: &[&str] = &["u", "v", "w", "r", "s", "t", "alpha", "beta", "gamma"];

/// Whether it usually is a place that exists, if it only is an argument.
pub(crate) fn is_intermediate(letter: &str) -> bool {
    INTERMEDIATE.contains(&letter)
}

/// Whether it usually is a degree.
pub(crate) fn is_degree(letter: &str) -> bool {
    DEGREES.contains(&letter)
}

/// The letters that usually stand for such members.
pub(crate) fn letters_of(role: Listed) -> impl Iterator<Item = &'static str> {
    LISTS.iter().filter(move |(own, _)| *own == role).flat_map(|(_, letters)| letters.iter().copied())
}

/// Whether it usually is the last value of an index.
pub(crate) fn is_size(letter: &str) -> bool {
    is_degree(letter) || letter == "M"
}

/// Whether it stands for an integer when it is an index.
pub(crate) fn is_index_letter(letter: &str) -> bool {
    INDICES.contains(&letter)
}

/// Whether it usually runs under a sum.
pub(crate) fn is_running(letter: &str) -> bool {
    RUNNING.contains(&letter)
}

/// Whether it usually is a variable.
pub(crate) fn is_variable(letter: &str) -> bool {
    VARIABLES.contains(&letter)
}

/// Whether a formula with this letter and others that are no variables is one in this letter.
pub(crate) fn is_variable_of_formulas(letter: &str) -> bool {
    OTHER_VARIABLES.contains(&letter)
}

/// Whether it is a factor even before a parenthesis.
pub(crate) fn is_factor(letter: &str) -> bool {
    FACTORS.contains(&letter)
}

/// Whether it usually is a barycentric coordinate.
pub(crate) fn is_barycentric(letter: &str) -> bool {
    BARYCENTRIC.contains(&letter)
}

/// Whether it usually takes an argument.
pub(crate) fn is_function(letter: &str) -> bool {
    FUNCTIONS.contains(&letter) || POLYNOMIALS.contains(&letter) || families::is_family(letter)
}

/// Whether its members with the indices 0, 1, … usually are the control points of a curve of that name.
pub(crate) fn is_control_point(letter: &str) -> bool {
    CONTROL_POINTS.contains(&letter)
}

/// Whether it usually is a parameter or coordinate.
pub(crate) fn is_parameter(letter: &str) -> bool {
    PARAMETERS.contains(&letter) || matches!(letter, "w" | "tau")
}

/// Whether it usually depends on no parameter.
pub(crate) fn is_constant(letter: &str) -> bool {
    CONSTANTS.contains(&letter)
}

/// Whether it usually depends on no parameter if it has an index.
pub(crate) fn is_indexed_constant(letter: &str) -> bool {
    ![FUNCTIONS, FAMILIES, PIECES, PARAMETERS].iter().any(|letters| letters.contains(&letter))
}

/// Whether an exponent in round brackets above a sum in brackets is one: `(1-t)^{(n-i)}` is a power, `f^{(k)}` and
/// `(f+g)^{(n-1)}` are derivatives, and `(x+1)^{(k)}` may be a rising factorial.
pub(crate) fn is_power_of_sum(base: &Expr, exponent: &Expr) -> bool {
    fn is_of_letters(expr: &Expr) -> bool {
        let mut all = match &expr.kind {
            Kind::Name(name) => is_one_letter(name) && !NAMED_FUNCTIONS.contains(&name.as_str()),
            Kind::Number(_)
            | Kind::Group(_)
            | Kind::Add(_)
            | Kind::Mul(_)
            | Kind::Div(..)
            | Kind::Pow(..)
            | Kind::Subscript(..) => true,
            _ => false,
        };
        expr.for_each_child(&mut |child| all = all && is_of_letters(child));
        all
    }
    let is_sum = |expr: &Expr| matches!(expr.kind, Kind::Add(_));
    let is_sum_of_letters = |expr: &Expr| is_sum(expr) && is_of_letters(expr);
    let power = match &base.kind {
        Kind::Group(inner) => is_sum_of_letters(inner),
        // t^i(1-t)^{(n-i)} is read as a value of t^i at first.
        Kind::Apply(callee, groups) => {
            let factor = if let Kind::Pow(factor, _) = &callee.kind { factor } else { callee };
            let is_number = matches!(&factor.kind, Kind::Name(name) if is_factor(name) || is_parameter(name));
            is_number
                && matches!(groups.as_slice(), [group] if matches!(group.as_slice(), [sum] if is_sum_of_letters(sum)))
        }
        _ => false,
    };
    power && is_sum(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_their_usual_roles() {
        assert!(is_function("f") && is_function("sigma") && is_function("p") && !is_function("b"));
        assert!(is_constant("lambda") && !is_constant("t"));
        assert!(is_degree("n") && is_size("M") && !is_degree("M") && !is_size("i"));
        assert!(RUNNING.iter().chain(DEGREES).all(|letter| is_index_letter(letter)));
        assert!(OTHER_VARIABLES.iter().chain(PARAMETERS).all(|letter| is_variable(letter)));
        assert!(is_indexed_constant("p") && !is_indexed_constant("B") && !is_indexed_constant("t"));
    }
}
