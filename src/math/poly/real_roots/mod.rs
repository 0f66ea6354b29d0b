//! Real roots of [`Poly`](super::Poly): counted, isolated and compared, all exactly.
//!
//! | for | see |
//! | --- | --- |
//! | how many there are, by Sturm's theorem | `sturm` |
//! | each in an interval of its own, by Bernstein coefficients and Descartes' rule of signs | `isolate` |
//! | the same by convex hulls (Bézier clipping) | `clip` |
//! | a root that is not rational, as a number that can be compared | [`AlgebraicNumber`] |
//! | the largest or smallest value on an interval, and where | [`Extreme`] |
//! | F ≥ 0 on an interval, with a certificate | [`Positivity`] |
//! | integer Bernstein coefficients, and how they are halved | `bernstein` |

mod algebraic;
mod bernstein;
mod clip;
mod extreme;
mod isolate;
mod sign;
mod sturm;
#[cfg(test)]
mod tests;

pub use algebraic::{AlgebraicNumber, RealRoot};
pub use bernstein::sign_changes;
pub use clip::{Clip, ClipOutcome};
pub use extreme::Extreme;
pub use isolate::Part;
pub use sign::Positivity;
