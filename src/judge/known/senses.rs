//! What a page says that its names mean, all of it, for formulas that fail with the meaning that they were given.

use std::rc::Rc;

use crate::formula::Expr;
use crate::judge::known::checker::Checker;
use crate::judge::page::context::Context;
use crate::judge::page::object::Object;
use crate::judge::page::statement::{Chain, Place, Statement};
use crate::judge::written::names::Head;

/// A formula of which a relation was refuted, with what was known before it.
#[derive(Clone)]
pub(in crate::judge) struct Appeal {
    /// The number of its first finding.
    pub(in crate::judge) first: usize,
    pub(in crate::judge) chain: Chain,
    pub(in crate::judge) statement: Statement,
    pub(in crate::judge) known: Rc<Context>,
}

/// What a page says that a name means.
#[derive(Clone)]
pub(in crate::judge) struct Sense {
    pub(in crate::judge) means: Means,
    pub(in crate::judge) scope: Vec<u32>,
    pub(in crate::judge) blocks: Vec<u32>,
    pub(in crate::judge) paragraph: u32,
    pub(in crate::judge) formula: usize,
    /// Whether its sentence supposes it: "suppose now that b_1 = 3 b_0".
    pub(in crate::judge) supposed: bool,
    /// The finding that says it, if one does.
    pub(in crate::judge) finding: Option<usize>,
}

/// The same, without its place.
#[derive(Clone)]
pub(in crate::judge) enum Means {
    Formula(Head, Expr),
    Object(Rc<Object>),
    /// Numbers or points, which may be weights or control points.
    List(Vec<Expr>),
    /// Two numbers, which may be the ends of an interval.
    Interval(Expr, Expr),
    /// What everybody means by a letter, to which the page gives a meaning of its own.
    Usual(String),
}

impl Sense {
    /// What is said at a place, without a finding that says it.
    pub(in crate::judge) fn at(place: &Place, means: Means) -> Self {
        Sense {
            means,
            scope: place.scope.clone(),
            blocks: place.blocks.clone(),
            paragraph: place.group,
            formula: place.formula,
            supposed: false,
            finding: None,
        }
    }

    /// The letters that it gives a meaning.
    pub(in crate::judge) fn bases(&self) -> Vec<String> {
        match &self.means {
            Means::Formula(head, _) => vec![head.base.clone()],
            Means::Object(object) => object.names.iter().filter_map(Head::of).map(|head| head.base).collect(),
            Means::Usual(base) => vec![base.clone()],
            Means::List(_) | Means::Interval(..) => Vec::new(),
        }
    }
}

impl Checker {
    /// Keeps that the page gives a letter with a usual meaning one of its own.
    pub(in crate::judge) fn means_its_own(&mut self, base: &str, place: &Place) {
        self.senses.push(Sense::at(place, Means::Usual(base.to_owned())));
    }
}
