//! What was found on the way, for relations that come later.

use std::collections::BTreeSet;

use crate::formula::Expr;
use crate::judge::page::finding::Finding;
use crate::judge::page::object::Object;
use crate::judge::page::statement::Place;
use crate::judge::page::topic::Topics;
use crate::math::number::Rational;

/// A theorem that gave a member of a family on the page.
#[derive(Clone, Debug)]
pub(in crate::judge) struct Agreement {
    pub(in crate::judge) theorem: &'static str,
    /// What stands for its letters and for its sizes.
    pub(in crate::judge) letters: Vec<(String, Expr)>,
    pub(in crate::judge) sizes: Vec<(String, Expr)>,
    pub(in crate::judge) member: Expr,
    pub(in crate::judge) place: Place,
}

/// A scheme of which a point agreed.
#[derive(Clone)]
pub(in crate::judge) struct Scheme {
    pub(in crate::judge) letter: String,
    pub(in crate::judge) parameter: Rational,
    pub(in crate::judge) place: Place,
}

/// A meaning with which a formula for a letter holds.
#[derive(Clone)]
pub(in crate::judge) struct Taken {
    pub(in crate::judge) letter: String,
    pub(in crate::judge) place: Place,
    pub(in crate::judge) meaning: Meaning,
}

/// What a name can be.
#[derive(Clone)]
pub(in crate::judge) struct Meaning {
    pub(in crate::judge) curve: Curve,
    pub(in crate::judge) made: Made,
}

/// What is made of a curve.
#[derive(Clone)]
pub(in crate::judge) enum Made {
    /// Its control points at a higher degree.
    Elevated(i64),
    /// The control points of a part of it.
    Part(Expr, Expr),
    Itself,
    /// One of its coordinates.
    Coordinate(usize),
    PolarForm,
}

/// The coordinates of a point, or one number.
pub(in crate::judge) type Point = Vec<Rational>;

/// An equation of the page: others may follow from it.
#[derive(Clone)]
pub(in crate::judge) struct Equation {
    /// Its sides, with plain letters and numbers in the places of indices.
    pub(in crate::judge) sides: (Expr, Expr),
    /// For which indices it is said.
    pub(in crate::judge) ranges: Vec<Expr>,
    /// The letters in it that are no variables.
    pub(in crate::judge) letters: BTreeSet<String>,
    pub(in crate::judge) place: Place,
    pub(in crate::judge) line: usize,
    /// Whether it is supposed for its paragraph only.
    pub(in crate::judge) assumed: bool,
    /// Whether it is given or holds.
    pub(in crate::judge) sure: bool,
}

/// Numbers that a page gives: a list, or members of one family one after the other.
#[derive(Clone)]
pub(in crate::judge) struct Row {
    /// The family; empty for a list without names.
    pub(in crate::judge) letter: String,
    pub(in crate::judge) first: i64,
    /// The points, each with the number of the finding that is about it.
    pub(in crate::judge) items: Vec<(Point, Option<usize>)>,
    pub(in crate::judge) place: Place,
    pub(in crate::judge) topics: Topics,
    /// Whether it is given, and not claimed.
    pub(in crate::judge) given: bool,
}

/// A curve of the section.
#[derive(Clone)]
pub(in crate::judge) struct Curve {
    pub(in crate::judge) name: Expr,
    pub(in crate::judge) degree: Expr,
    pub(in crate::judge) interval: (Expr, Expr),
    /// The letter of its points.
    pub(in crate::judge) points: Option<String>,
    /// What says it in place of the page, if it has no name there.
    pub(in crate::judge) object: Option<Object>,
    /// Whether it is a segment of a uniform spline.
    pub(in crate::judge) segment: bool,
}

/// A relation that was judged.
#[derive(Clone)]
pub(in crate::judge) struct Use {
    pub(in crate::judge) finding: usize,
    pub(in crate::judge) grounds: BTreeSet<Ground>,
    pub(in crate::judge) outcome: Outcome,
    /// What it is if its names are confirmed.
    pub(in crate::judge) wrong: Option<Finding>,
}

/// What a relation rests on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::judge) enum Ground {
    /// A definition of the page: the number of its formula, and its name.
    Definition(usize, String),
    Name(String),
}

/// How it came out.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::judge) enum Outcome {
    Holds,
    Refuted,
    /// It fails, and nothing shows that it is wrong.
    Unfounded,
    Open,
}
