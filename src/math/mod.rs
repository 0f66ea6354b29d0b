//! The mathematics: exact numbers, polynomials, polar forms, curves and splines. It knows no text,
//! no formulas and no places; what can go wrong is a small error of its own.

/// `Debug` by the name of the type and its text.
macro_rules! debug_by_text {
    ($($type:ident),*) => {$(
        impl<C> std::fmt::Debug for $type<C>
        where
            $type<C>: std::fmt::Display,
        {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, concat!(stringify!($type), "({})"), self)
            }
        }
    )*};
}

/// `Debug` by the fields, some of which are written as texts.
macro_rules! debug_by_fields {
    ($type:ident $(<$other:ident>)?: $($field:ident),*) => {
        impl<C: crate::math::ring::Field + std::fmt::Display $(, $other: std::fmt::Debug)?> std::fmt::Debug
            for $type<C $(, $other)?>
        {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.debug_struct(stringify!($type))$(.field(stringify!($field), &self.$field))*.finish()
            }
        }
    };
}

pub mod approximation;
pub mod basis;
pub mod blossom;
pub mod curve;
pub mod interpolate;
pub mod interval;
pub mod linalg;
pub mod number;
pub mod piecewise;
pub mod poly;
pub mod ring;
pub mod spline;
pub mod subdivision;
pub mod system;
