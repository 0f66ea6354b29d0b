//! Polar forms (blossoms): values, operations, derivations, laws.
mod chebyshev;
mod display;
mod evaluator;
mod expand;
pub mod laws;
mod methods;
mod multirational;
mod operations;
mod polar_form;
mod shifted;
mod tensor;
mod total_degree;

pub use chebyshev::{Osculation, chebyshev_point};
pub use evaluator::PreparedForm;
pub use expand::{Written, expand_tensor, expand_total, expand_univariate, symmetrize};
pub use methods::{Method, Step, Weights, Worked};
pub use multirational::{MultirationalError, multirational, rational_antiderivative};
pub use polar_form::{Argument, PolarError, PolarForm};
pub use shifted::{apolar_product, h_blossom, homogeneous_value, moebius, q_blossom};
pub use tensor::TensorPolarForm;
pub use total_degree::{PointArgument, TotalDegreePolarForm};
