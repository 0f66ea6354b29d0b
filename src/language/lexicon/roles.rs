//! What a letter usually stands for, where nothing on the page says it.

use super::families;

/// Functions when they have no value: `f(t + 1)` is then a question.
pub(crate) const FUNCTIONS: &[&str] = &["f", "g", "h", "phi", "psi", "varphi"];

/// Families of functions when they have indices but no value.
pub(crate) const FAMILIES: &[&str] = &["B", "N", "L", "H", "T"];

/// Functions, too; with indices they are points or numbers.
const POLYNOMIALS: &[&str] = &["p", "q"];

/// Functions with an index, such as the pieces of a curve F or of a spline S, and e, which is exp.
const PIECES: &[&str] = &["F", "G", "S", "e"];

/// Parameters and coordinates.
const PARAMETERS: &[&str] = &["r", "s", "t", "u", "v", "x", "y", "z"];

/// Numbers that depend on no parameter.
const CONSTANTS: &[&str] = &["a", "b", "c", "h", "k", "alpha", "beta", "lambda", "mu", "omega"];

/// Whether it usually takes an argument.
pub(crate) fn is_function(letter: &str) -> bool {
    FUNCTIONS.contains(&letter) || POLYNOMIALS.contains(&letter) || families::is_family(letter)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_their_usual_roles() {
        assert!(is_function("f") && is_function("sigma") && is_function("p") && !is_function("b"));
        assert!(is_constant("lambda") && !is_constant("t"));
        assert!(is_indexed_constant("p") && !is_indexed_constant("B") && !is_indexed_constant("t"));
    }
}
