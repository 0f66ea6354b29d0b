//! What the evaluator is handed: the functions of the program, and a judge of claims.

use super::arguments::Arguments;
use super::machine::{Evaluated, Machine};
use crate::formula::{Expr, Link};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::Judgement;

/// A place among the arguments of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot<'a> {
    /// Counted from 0.
    Place(usize),
    /// `name = …`.
    Name(&'a str),
}

/// A function of the program, as the evaluator calls it.
pub trait Callable {
    /// Its name.
    fn name(&self) -> &'static str;

    /// How it is called, for messages.
    fn form(&self) -> String;

    /// Whether a bare name as the argument there is a word that is not evaluated, as in
    /// `labels=points`; `defined` says whether the name has a value.
    fn takes_word(&self, slot: Slot, word: &str, defined: bool) -> bool;

    /// Whether a polynomial is expected at that place.
    fn takes_polynomial(&self, place: usize) -> bool;

    /// Whether unknowns of equations are expected there.
    fn takes_unknowns(&self, slot: Slot) -> bool;

    /// Whether a function whose values are points is given there as the list of its coordinates.
    fn takes_coordinates(&self, place: usize) -> bool;

    /// Whether an argument is given by this name.
    fn takes_name(&self, name: &str) -> bool;

    /// Whether values of any names may be given: t=3, c_0=1.
    fn takes_values(&self) -> bool;

    /// Whether it works on equations, which nobody judges then.
    fn takes_equations(&self) -> bool;

    /// Whether what it gives is a function, also where the formula of that is a number.
    fn gives_function(&self) -> bool;

    /// Its value.
    ///
    /// # Errors
    /// A [`Diagnostic`], with a place if it is about one argument.
    fn run(&self, machine: &mut Machine, arguments: Arguments) -> Evaluated;
}

/// Judges the relations of a chain, one after the other.
pub type Judge = fn(&mut Machine, &Expr, &[Link]) -> Result<Vec<Judgement>, Diagnostic>;

/// What the evaluator is handed.
#[derive(Clone, Copy)]
pub struct Tools {
    /// The function of a name.
    pub function: fn(&str) -> Option<&'static dyn Callable>,
    /// The names of all functions.
    pub names: fn() -> Vec<&'static str>,
    /// The function that has another name, too, by which it is called as well.
    pub alias: fn(&str) -> Option<&'static dyn Callable>,
    /// The function that somebody means by another name.
    pub synonym: fn(&str) -> Option<&'static str>,
    /// Whether a name that stands alone is a word that means itself, such as that of a basis.
    pub is_word: fn(&str) -> bool,
    /// Whether a word names an argument of a function, or is one.
    pub argument_word: fn(&str) -> bool,
    /// The judge of the claims in a formula.
    pub judge: Judge,
}
