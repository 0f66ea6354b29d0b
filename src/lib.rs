//! Exact polynomials and their polar forms (blossoms).
//!
//! The polar form of a polynomial F of degree at most n is the unique function f of n
//! arguments that is symmetric, affine in each argument, and has F(t) = f(t, …, t). It is kept
//! as n + 1 coefficients; what can be done with these is never done on its 2^n monomials.
//!
//! ```
//! use polarform::blossom::{Argument, PolarForm};
//! use polarform::number::integer;
//!
//! // F(t) = t^2 + 2t, whose polar form is f(t1, t2) = t1 t2 + t1 + t2
//! let f = PolarForm::new([0, 2, 1].map(integer).to_vec());
//! assert_eq!(f.to_string(), "f(t1, t2) = t1 t2 + (t1 + t2)");
//! assert_eq!(f.value(&[integer(2), integer(3)])?, integer(11));
//!
//! // Vectors give derivatives: F'(3) = 2 f(3, 1̂) = 8
//! let half = f.value(&[Argument::Point(integer(3)), Argument::Vector(integer(1))])?;
//! assert_eq!(half * integer(2), integer(8));
//! # Ok::<(), polarform::blossom::PolarError>(())
//! ```
//!
//! The same in the language of the command line, which also reads symbols and claims:
//!
//! ```
//! use polarform::session::Session;
//! use polarform::value::{Value, Verdict};
//!
//! let mut session = Session::default();
//! session.run("f := polar(t^2 + 2t)")?;
//! let answer = session.run("f(r, s) = r s + r + s")?;
//! let Value::Claim(claim) = answer.outcome.value else { unreachable!() };
//! assert_eq!(claim.verdict(), Verdict::Proved);
//! # Ok::<(), Box<polarform::session::Failure>>(())
//! ```
//!
//! # Where to look
//! | for | see |
//! | --- | --- |
//! | numbers: fractions of integers of any size | [`number`] |
//! | polynomials, fractions of them, symbols | [`poly`] |
//! | curves, surfaces, splines, interpolation | [`curve`], [`spline`], [`interpolate`], [`piecewise`] |
//! | subdivision of polygons and around vertices of meshes | [`subdivision`] |
//! | Gram matrices, energies, best approximations, splines from values | [`approximation`] |
//! | polar forms: in one variable, tensor-product, of total degree | [`blossom`] |
//! | A_n, raising the degree, change of basis | [`basis`] |
//! | exact solving, inverse, rank, determinant | [`linalg`] |
//! | statements, names, claims | [`session`], [`eval`], [`value`] |
//! | reading and writing formulas | [`syntax`], [`latex`], [`mod@write`] |
//! | verdicts: models, proofs, what is wrong and why | [`judge`] |
//! | checking lecture notes | [`notes`] |
//! | drawings: what is on them; SVG, TikZ, terminal | [`scene`], [`figure`] |
//! | results woven into lecture notes | [`weave`] |
//! | limits on time and size | [`budget`] |
//!
//! # Features
//! | feature | gives | for |
//! | --- | --- | --- |
//! | none | mathematics, language, judge, session, [`scene`] | `default-features = false`: at most 40 crates |
//! | `figure` | [`figure`] | scenes as SVG, TikZ, JSON and in characters |
//! | `document` | [`document`] | notes taken apart; part of `notes` and `weave` |
//! | `files` | files in [`document`] | in any encoding, with those that they include |
//! | `writing` | files in [`weave`] | written whole, or left as they were |
//! | `clock` | limits on time | without it, and without a clock of the program, limits count steps |
//! | `notes` | [`notes`] | a verdict for every formula of lecture notes, and reports |
//! | `weave` | [`weave`] | results filled into lecture notes, with `figure` |
//! | `cli` (default) | the program `polarform` | with all of the above |
//!
//! The modules form floors, described in `docs/architecture.md`; `docs/design.md` says why.
//!
//! # What is not supported
//! - floating-point numbers: every number is rational, decimals are read as fractions
//! - functions that are not rational, such as sin, exp and roots
//! - systems of equations with infinitely many solutions (linear ones apart), and general simplification
//! - coefficients in finite fields or in algebraic extensions of Q
//!
//! # Limits and panics
//! Library functions work without limits; run them under [`budget::run`] to bound time and
//! size. Functions that panic say so; what can go wrong with an input is an error.
pub mod budget;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[cfg(feature = "document")]
pub mod document;
#[cfg(feature = "figure")]
pub mod figure;
#[doc(hidden)]
pub mod formula;
pub mod judge;
#[doc(hidden)]
pub mod language;
#[doc(hidden)]
pub mod math;
#[cfg(feature = "notes")]
pub mod notes;
pub mod scene;
pub mod session;
#[cfg(feature = "weave")]
pub mod weave;

// What programs write is flat: `polarform::blossom::PolarForm`. The floors are for those who work on them.
#[doc(inline)]
pub use formula as expr;
#[doc(inline)]
pub use formula::source;
#[doc(inline)]
pub use language::{derive, diagnostic, eval, functions, latex, syntax, value, write};
#[doc(inline)]
pub use math::{
    approximation, basis, blossom, curve, interpolate, interval, linalg, number, piecewise, poly, ring,
    spline, subdivision, system,
};
