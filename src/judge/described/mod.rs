//! Formulas judged by what the words of their section describe, where no formula of the page says what a name is.
//!
//! `meanings` has new control points and unnamed `curves`, `de_casteljau` points of that scheme, `insertion` those
//! after knot insertion, `derived` rows of numbers, `curvature` that of a curve, `tables` schemes cell by cell, `follows` what other
//! equations of the page say, `facts` what was said of a name before its formula.

mod curvature;
mod curves;
mod de_casteljau;
mod derived;
mod facts;
mod follows;
mod insertion;
pub(in crate::judge) mod meanings;
mod tables;
mod weights;
