//! What can be wrong with data that are to be interpolated.

use std::fmt;

use crate::math::basis::BasisError;

/// Why there is no such interpolant, spline, approximation or parameterisation.
///
/// Indices count from 0, as in the formulas: nodes x_0, x_1, …, points P_0, P_1, …
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum InterpolationError {
    /// There are fewer nodes or points than needed.
    TooFewPoints {
        /// How many are needed.
        needed: usize,
        /// How many there are.
        given: usize,
    },
    /// Two lists that belong together have different lengths.
    Lengths {
        /// What the offending list holds: "values", "weights", …
        what: &'static str,
        /// How many there are of these.
        given: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A point has another number of coordinates than the first one.
    Dimensions {
        /// What the offending datum is: "point", "condition", …
        what: &'static str,
        /// Its place.
        index: usize,
        /// Its number of coordinates.
        given: usize,
        /// That of the first point.
        needed: usize,
    },
    /// Two nodes are equal.
    EqualNodes {
        /// The place of the first of them.
        first: usize,
        /// The place of the second.
        second: usize,
    },
    /// Two equal nodes, meant as one repeated node, do not stand next to each other.
    NodesApart {
        /// The place of the first of them.
        first: usize,
        /// The place of the second.
        second: usize,
    },
    /// A node is not larger than the one before it.
    NotIncreasing {
        /// The place of the offending node.
        index: usize,
    },
    /// A datum of a node has another number of coordinates than the first one.
    DatumDimensions {
        /// The place of the node.
        node: usize,
        /// The place of the datum: 0 for the value, 1 for the derivative, …
        datum: usize,
        /// Its number of coordinates.
        given: usize,
        /// That of the first value.
        needed: usize,
    },
    /// A node of Hermite data has no value.
    NoData {
        /// The place of the node.
        index: usize,
    },
    /// The first and the last value of a periodic function differ.
    NotPeriodic,
    /// A system of equations has not exactly one solution.
    Singular {
        /// The number of its unknowns.
        unknowns: usize,
        /// The rank of its matrix.
        rank: usize,
    },
    /// The columns of the matrix of a least squares problem are linearly dependent (in the rows
    /// of weight other than 0).
    DependentColumns {
        /// The first column that is a combination of those before it.
        column: usize,
    },
    /// There are not enough distinct nodes (of weight other than 0) for the degree.
    TooFewNodes {
        /// The degree asked for; degree + 1 nodes are needed.
        degree: usize,
        /// The number of distinct nodes.
        distinct: usize,
    },
    /// There are more conditions than coefficients.
    TooManyConditions {
        /// The number of conditions.
        conditions: usize,
        /// The number of coefficients.
        unknowns: usize,
    },
    /// A condition is a combination of those before it.
    DependentCondition {
        /// The place of the offending condition.
        index: usize,
    },
    /// A weight is negative.
    NegativeWeight {
        /// The place of the offending weight.
        index: usize,
    },
    /// The ends of the interval, or the nodes, are no basis of the polynomials of this degree.
    Basis(BasisError),
    /// Two neighbouring points coincide.
    CoincidentPoints {
        /// The place of the first of them.
        index: usize,
    },
    /// The parameters are irrational, and no number of decimals is asked for.
    Irrational {
        /// The first segment P_i P_{i+1} whose length is to blame.
        segment: usize,
        /// Why it is irrational.
        why: &'static str,
    },
    /// Two neighbouring parameters are equal when rounded.
    TooFewDecimals {
        /// The place of the first of them.
        index: usize,
        /// The number of decimals asked for.
        decimals: u32,
    },
}

impl fmt::Display for InterpolationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use InterpolationError as E;
        match self {
            E::TooFewPoints { needed, given } => {
                let plural = if *needed == 1 { "" } else { "s" };
                write!(f, "at least {needed} point{plural} needed, {given} given")
            }
            E::Lengths { what, given, needed } => write!(f, "{needed} {what} needed, {given} given"),
            E::Dimensions { what, index, given, needed } => {
                let plural = if *given == 1 { "" } else { "s" };
                write!(f, "{what} {index} has {given} coordinate{plural}, the first point has {needed}")
            }
            E::DatumDimensions { node, datum, given, needed } => {
                let plural = if *given == 1 { "" } else { "s" };
                write!(f, "datum {datum} of node {node} has {given} coordinate{plural}, ")?;
                write!(f, "the first point has {needed}")
            }
            E::EqualNodes { first, second } => write!(f, "the nodes x_{first} and x_{second} are equal"),
            E::NodesApart { first, second } => write!(
                f,
                "the equal nodes x_{first} and x_{second} must stand next to each other to be a repeated node"
            ),
            E::NotIncreasing { index } => {
                write!(f, "the node x_{index} is not larger than the one before it")
            }
            E::NoData { index } => write!(f, "the node x_{index} has no value"),
            E::NotPeriodic => f.write_str("the first and the last value of a periodic spline must be equal"),
            E::Singular { unknowns, rank } => {
                write!(f, "the system of {unknowns} equations is singular, its rank is {rank}")
            }
            E::DependentColumns { column: 0 } => {
                f.write_str("column 0 of the matrix is zero in all rows of weight other than 0")
            }
            E::DependentColumns { column } => {
                write!(f, "column {column} of the matrix is a combination of the columns before it")
            }
            E::TooFewNodes { degree, distinct } => write!(
                f,
                "degree {degree} needs {} distinct nodes of weight other than 0, there are {distinct}",
                degree.saturating_add(1)
            ),
            E::TooManyConditions { conditions, unknowns } => {
                write!(f, "{conditions} conditions for {unknowns} coefficients")
            }
            E::DependentCondition { index } => {
                write!(f, "condition {index} is a combination of the conditions before it")
            }
            E::NegativeWeight { index } => write!(f, "weight {index} is negative"),
            E::Basis(error) => error.fmt(f),
            E::CoincidentPoints { index } => {
                write!(f, "the points P_{index} and P_{} coincide", index + 1)
            }
            E::Irrational { segment, why } => write!(
                f,
                "the parameters are irrational: segment {segment}, from P_{segment} to P_{}, {why}; \
                 ask for a number of decimals",
                segment + 1
            ),
            E::TooFewDecimals { index, decimals } => {
                let plural = if *decimals == 1 { "" } else { "s" };
                write!(
                    f,
                    "the parameters t_{index} and t_{} are equal to {decimals} decimal{plural}",
                    index + 1
                )
            }
        }
    }
}

impl std::error::Error for InterpolationError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            InterpolationError::Basis(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BasisError> for InterpolationError {
    fn from(error: BasisError) -> Self {
        match error {
            BasisError::EqualNodes { first, second } => InterpolationError::EqualNodes { first, second },
            other => InterpolationError::Basis(other),
        }
    }
}
