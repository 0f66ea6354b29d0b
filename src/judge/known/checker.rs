//! All that is known while a page is checked.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use crate::budget::Limits;
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::known::found::{Agreement, Equation, Row, Scheme, Taken, Use};
use crate::judge::known::senses::{Appeal, Sense};
use crate::judge::known::unread::Unread;
use crate::judge::model::{Ambiguity, holds};
use crate::judge::page::context::{Body, Condition, Context, Definition, Mark, Source};
use crate::judge::page::finding::Finding;
use crate::judge::page::letters::Letters;
use crate::judge::page::statement::{Place, Statement, links};
use crate::judge::values::evaluator;
use crate::judge::written::names::{Head, symbol_of};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::Value;

/// Judges statements in their order.
#[derive(Clone)]
pub struct Checker {
    pub(in crate::judge) file: SourceFile,
    pub(in crate::judge) context: Rc<Context>,
    pub(in crate::judge) limits: Limits,
    /// How many of the next formulas are not to be judged.
    pub(in crate::judge) ignored: usize,
    /// Names that stand beside something that could not be read.
    pub(in crate::judge) unread: Vec<Unread>,
    /// What could not be judged, for formulas that come later.
    pub(in crate::judge) open: Vec<Condition>,
    /// What relied on definitions of the page.
    pub(in crate::judge) uses: Vec<Use>,
    /// What new names were found to mean.
    pub(in crate::judge) taken: Vec<Taken>,
    /// Schemes of which points agreed.
    pub(in crate::judge) schemes: Vec<Scheme>,
    /// The letters that occurred so far.
    pub(in crate::judge) seen: BTreeSet<String>,
    /// Letters of control points that words speak of, of which one agreed.
    pub(in crate::judge) agreed: Vec<(String, Place)>,
    /// Theorems that gave a member of a family.
    pub(in crate::judge) agreements: Vec<Agreement>,
    /// How ambiguous notations were found to be meant: true is the second reading.
    pub(in crate::judge) settled: RefCell<BTreeMap<Ambiguity, bool>>,
    /// Equations that the page gives or that hold on it.
    pub(in crate::judge) equations: Vec<Rc<Equation>>,
    /// Numbers that the page gives, for later ones.
    pub(in crate::judge) rows: Vec<Row>,
    /// Letters of the operators that the page defines.
    pub(in crate::judge) operators: BTreeSet<String>,
    /// Letters that with a prime are new things, and no derivatives.
    pub(in crate::judge) marked: BTreeSet<String>,
    /// Functions with laws that stayed open, each with its place and line.
    pub(in crate::judge) laws: Vec<(String, Place, usize)>,
    /// What was known before the statement that is judged.
    pub(in crate::judge) before: Mark,
    /// All that was said of what names mean.
    pub(in crate::judge) senses: Vec<Sense>,
    /// The last formula that is or gives a number, and the number, if it is not one of a list.
    pub(in crate::judge) last_number: Option<(usize, Option<Expr>)>,
    /// What may be taken back in the end.
    pub(in crate::judge) appeals: Vec<Appeal>,
    /// Whether a repair is judged, for which no other is looked for.
    pub(in crate::judge) confirming: bool,
    /// What was found so far, one finding for each relation.
    pub findings: Vec<Finding>,
    /// What is wrong with declarations.
    pub problems: Vec<Diagnostic>,
}

impl Checker {
    /// Before the first statement; `statements` are all that will come, for what letters are used as.
    pub fn new(file: &SourceFile, limits: &Limits, statements: &[Statement]) -> Self {
        let letters = Letters::of(statements);
        Checker {
            file: file.clone(),
            context: Rc::new(Context::new(letters)),
            limits: limits.clone(),
            ignored: 0,
            unread: Vec::new(),
            open: Vec::new(),
            uses: Vec::new(),
            taken: Vec::new(),
            schemes: Vec::new(),
            seen: BTreeSet::new(),
            agreed: Vec::new(),
            agreements: Vec::new(),
            settled: RefCell::default(),
            equations: Vec::new(),
            rows: Vec::new(),
            marked: BTreeSet::new(),
            operators: BTreeSet::new(),
            laws: Vec::new(),
            before: Mark::default(),
            senses: Vec::new(),
            last_number: None,
            appeals: Vec::new(),
            confirming: false,
            findings: Vec::new(),
            problems: Vec::new(),
        }
    }

    /// A state of an earlier run to go on from in this one, if letters are used alike on both pages, of which what was
    /// judged must be the same.
    pub fn resumed(&self, earlier: &Checker) -> Option<Checker> {
        (self.context.letters == earlier.context.letters).then(|| Checker {
            file: self.file.clone(),
            limits: self.limits.clone(),
            ..earlier.clone()
        })
    }

    pub(in crate::judge) fn line(&self, span: Span) -> usize {
        self.file.line(span.start)
    }

    /// Adds a condition that later formulas may need.
    pub(in crate::judge) fn condition(&mut self, expr: Expr, span: Span, assumed: bool, place: &Place) {
        self.condition_for(expr, &[], span, assumed, place);
    }

    /// The same for some values of its indices: F^{(k)}(τ) = G^{(k)}(τ) for k = 0, …, r.
    pub(in crate::judge) fn condition_for(
        &mut self,
        expr: Expr,
        ranges: &[Expr],
        span: Span,
        assumed: bool,
        place: &Place,
    ) {
        let line = self.line(span);
        for expr in links(&expr) {
            self.give_up_what_contradicts(&expr, place);
            let condition = Condition { expr, assumed, place: place.clone(), line, ranges: ranges.to_vec() };
            Rc::make_mut(&mut self.context).conditions.push(condition);
        }
    }

    /// "Suppose that a = b. … Suppose now that a ≠ b": what is supposed ends where the opposite is supposed in its paragraph.
    fn give_up_what_contradicts(&mut self, new: &Expr, place: &Place) {
        let Kind::Chain(left, links) = &new.kind else { return };
        let [link] = links.as_slice() else { return };
        if !matches!(link.rel, Rel::Ne | Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge) {
            return;
        }
        let (left, right) = (left.as_ref(), &link.expr);
        let opposite = |known: &Condition| match &known.expr.kind {
            Kind::Chain(one, links) if link.rel == Rel::Ne && known.place.group == place.group => {
                let same = |other: &Expr| {
                    one.same_as(left) && other.same_as(right) || one.same_as(right) && other.same_as(left)
                };
                matches!(links.as_slice(), [own] if own.rel == Rel::Eq && same(&own.expr))
            }
            _ => false,
        };
        let Some(head) = Head::of(left).filter(|head| head.arguments.is_none()) else { return };
        let given = |own: &Definition| match (&own.body, link.rel) {
            (Body::Formula(body), Rel::Ne) => body.same_as(right),
            (Body::Formula(_), _) => {
                let value = own.number().and_then(|body| body.as_number().cloned()).map(Value::number);
                let held = value.map(|value| {
                    let name = [(symbol_of(&head.base), value)];
                    evaluator::machine().with_locals(name, |machine| Ok(holds(machine, new)))
                });
                held.is_some_and(|held| held == Ok(Some(false)))
            }
            (Body::Value(_), _) => false,
        };
        let latest = self.context.visible(&head.base, place).next();
        let ended = latest.is_some_and(|(_, own, _)| own.place.group == place.group && given(own));
        if ended {
            self.context = Rc::new(self.context.without(std::slice::from_ref(&head.base)));
        }
        if self.context.conditions.iter().any(opposite) {
            Rc::make_mut(&mut self.context).conditions.retain(|known| !opposite(known));
        }
    }

    /// Adds a definition that later formulas use.
    pub(in crate::judge) fn define(
        &mut self,
        head: Head,
        body: Body,
        conditions: &[Expr],
        place: &Place,
        span: Span,
    ) {
        self.define_by(Source::Page, head, body, conditions, place, span);
    }

    pub(in crate::judge) fn define_by(
        &mut self,
        source: Source,
        head: Head,
        body: Body,
        conditions: &[Expr],
        place: &Place,
        span: Span,
    ) {
        let (conditions, place, line) = (conditions.to_vec(), place.clone(), self.line(span));
        let definition = Definition { head, body, conditions, place, line, assumed: false, source };
        Rc::make_mut(&mut self.context).define(definition);
    }

    /// What the section said, the latest first.
    pub(in crate::judge) fn heard<'a>(&'a self, place: &'a Place) -> impl Iterator<Item = &'a Expr> {
        self.context
            .heard
            .iter()
            .rev()
            .filter(|(other, _)| place.knows(other, false))
            .map(|(_, expr)| &**expr)
    }
}
