//! What is judged: chains of relations with what is said of them, and where they stand.

use std::ops::{Deref, DerefMut};
use std::rc::Rc;

use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::page::object::Object;
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::bases;
use crate::language::diagnostic::Diagnostic;

impl Statement {
    /// Whether it is said as a case, which the claims of its sentence carry as a condition.
    pub fn is_case(&self) -> bool {
        matches!(self.role, Some(Role::Case | Role::Except | Role::Elsewhere | Role::Odd | Role::Even))
    }
}

/// Where a statement stands: shared, since all that is read there asks for it.
#[derive(Clone, Debug, Default)]
pub struct Place(Rc<Layout>);

/// What a place is in the layout of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// The sections, quotations and environments around it, outermost first.
    pub scope: Vec<u32>,
    /// Formulas with the same number stand in one paragraph or list.
    pub group: u32,
    /// The number of the formula.
    pub formula: usize,
    /// The example and case it stands in, whose facts end with them, outermost first.
    pub blocks: Vec<u32>,
    /// The proofs and solutions it stands in: they speak of what they prove, but what they suppose ends with them.
    pub proofs: Vec<u32>,
    /// The end of an earlier example that its paragraph goes back to: "in Example 2".
    pub recalled: Option<Place>,
    /// The items of lists it stands in, outermost first.
    pub items: Vec<u32>,
    /// How often words before it said that data change: "if b_1 is replaced by …".
    pub changes: u32,
    /// The letters of which they said for certain that something else stands in their place.
    pub replaced: Vec<String>,
    /// The formula of its sentence with the last number that nothing took; 0 if there is none.
    pub spare: usize,
    /// The names that words of its paragraph let be anything: "let a and b be arbitrary".
    pub arbitrary: Vec<String>,
}

impl From<Layout> for Place {
    fn from(layout: Layout) -> Self {
        Place(Rc::new(layout))
    }
}

impl Deref for Place {
    type Target = Layout;

    fn deref(&self) -> &Layout {
        &self.0
    }
}

impl DerefMut for Place {
    fn deref_mut(&mut self) -> &mut Layout {
        Rc::make_mut(&mut self.0)
    }
}

impl PartialEq for Place {
    fn eq(&self, other: &Place) -> bool {
        Rc::ptr_eq(&self.0, &other.0) || self.0 == other.0
    }
}

impl Eq for Place {}

impl Place {
    /// Whether data from there may be others here: words change them, or they belong to another item of a list.
    pub fn may_change(&self, earlier: &Place) -> bool {
        let here = self.recalled.as_ref().unwrap_or(self);
        earlier.changes < here.changes || self.is_apart(earlier)
    }

    /// Whether data from there belong to another item of a list, or numbers were told since that nothing took.
    pub fn is_apart(&self, earlier: &Place) -> bool {
        // What an example said that the paragraph goes back to holds here.
        let here = self.recalled.as_ref().unwrap_or(self);
        earlier.formula < self.spare || !here.items.starts_with(&earlier.items)
    }

    /// Whether words said since then that something else stands in the place of a letter.
    pub fn is_replaced(&self, letter: &str, earlier: &Place) -> bool {
        let here = self.recalled.as_ref().unwrap_or(self);
        let times = |place: &Place| place.replaced.iter().filter(|own| *own == letter).count();
        times(earlier) < times(here)
    }

    /// Whether both stand in sections of one section.
    pub fn is_beside(&self, other: &Place) -> bool {
        let parent = self.scope.len().saturating_sub(1);
        parent > 0 && other.scope.len() == self.scope.len() && other.scope[..parent] == self.scope[..parent]
    }

    /// Whether a fact from there can be alive here: what is assumed ends with its paragraph, what is said
    /// in an example, proof or case ends with it.
    pub fn in_reach(&self, earlier: &Place, assumed: bool) -> bool {
        let within = self.blocks.starts_with(&earlier.blocks) && self.proofs.starts_with(&earlier.proofs);
        within && (!assumed || earlier.group == self.group)
            || self
                .recalled
                .as_ref()
                .is_some_and(|recalled| !earlier.blocks.is_empty() && recalled.knows(earlier, assumed))
    }

    /// Whether it stands in the section, and there in the examples and proofs, of another place.
    pub fn is_in_the_blocks_of(&self, other: &Place) -> bool {
        self.scope == other.scope && self.blocks == other.blocks
    }

    /// Whether its paragraph lets a name be anything, whatever was said of it there.
    pub fn frees(&self, name: &str, earlier: &Place) -> bool {
        self.group != earlier.group && self.arbitrary.iter().any(|own| own == name)
    }

    /// Whether a fact from there is alive here.
    pub fn knows(&self, earlier: &Place, assumed: bool) -> bool {
        self.sees(earlier) && self.in_reach(earlier, assumed)
    }

    /// Whether what was said there holds here, as far as the layout tells.
    pub fn sees(&self, earlier: &Place) -> bool {
        self.scope.starts_with(&earlier.scope)
            || self.recalled.as_ref().is_some_and(|recalled| {
                !earlier.blocks.is_empty() && recalled.scope.starts_with(&earlier.scope)
            })
    }
}

/// A condition m = n = 1 as m = 1 and n = 1, a = b = c as a = b and b = c; anything else as it is.
pub(crate) fn links(condition: &Expr) -> Vec<Expr> {
    let Kind::Chain(left, links) = &condition.kind else { return vec![condition.clone()] };
    let Some(last) = links.last().filter(|_| links.len() > 1 && links.iter().all(|link| link.rel == Rel::Eq))
    else {
        return vec![condition.clone()];
    };
    let value = bases(&last.expr).is_empty();
    let sides = std::iter::once(left.as_ref()).chain(links.iter().map(|link| &link.expr));
    let one = |(left, link): (&Expr, &Link)| {
        let link = if value { last } else { link };
        Expr::new(Kind::Chain(Box::new(left.clone()), vec![link.clone()]), condition.span)
    };
    sides.zip(links).map(one).collect()
}

/// What a formula is said as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Then …, we get …: it is claimed.
    Claimed,
    /// Always …: it is claimed for all values of its variables.
    Always,
    /// For all …: a case, or variables for all values of which the sentence claims.
    All,
    /// Let …, where …: it introduces a name.
    Introduced,
    /// Suppose …: it is taken for true, to the end of the paragraph.
    Assumed,
    /// If …, for …, at …: what its sentence claims is claimed for this case only.
    Case,
    /// Unless …: what its sentence claims is claimed outside of this case only.
    Except,
    /// Otherwise: it is claimed where other cases do not apply.
    Elsewhere,
    /// … is odd: a case.
    Odd,
    /// … is even: a case.
    Even,
    /// Solve …, find …, it is wrong that …: nothing is asserted.
    Asked,
    /// Solve …, the equation …: what is to be solved, so that a solution has to fulfil it.
    Sought,
    /// If and only if …: a condition that means the same as something else.
    Equivalent,
    /// For some …, there is …: a name of which something holds for one value.
    Exists,
}

/// One side of a relation.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// The formula, with spans in the file.
    pub expr: Expr,
    /// As written.
    pub latex: String,
}

impl Side {
    /// Whether some part of it could not be read.
    pub fn is_unread(&self) -> bool {
        fn unread(expr: &Expr) -> bool {
            if matches!(expr.kind, Kind::Unread(_)) {
                return true;
            }
            let mut found = false;
            expr.for_each_child(&mut |child| found = found || unread(child));
            found
        }
        unread(&self.expr)
    }
}

/// A chain of relations.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// At least two sides.
    pub sides: Vec<Side>,
    /// The relations between them, with their places.
    pub relations: Vec<(Rel, Span)>,
    /// Conditions said with it.
    pub conditions: Vec<Expr>,
    /// Whether it is itself said as a condition of another one ("where a = b").
    pub given: bool,
    /// Whether it is claimed for a part only that no condition says: "otherwise".
    pub partial: bool,
    /// Whether it is claimed for all values of its variables.
    pub universal: bool,
    /// Names of which its sentence speaks for all values, whatever they were before.
    pub quantified: Vec<String>,
    /// Whether a condition beside it could not be read.
    pub blocked: bool,
    /// Names of which its sentence says that they exist: no instance refutes what is claimed of them.
    pub exists: Vec<String>,
    /// Why parts could not be read.
    pub problems: Vec<Diagnostic>,
}

impl Chain {
    /// Sides and the relations between them, of which nothing more is said.
    pub fn new(sides: Vec<Side>, relations: Vec<(Rel, Span)>) -> Self {
        Chain {
            sides,
            relations,
            conditions: Vec::new(),
            given: false,
            partial: false,
            universal: false,
            quantified: Vec::new(),
            blocked: false,
            exists: Vec::new(),
            problems: Vec::new(),
        }
    }

    /// The chain as one formula.
    pub fn whole(&self) -> Expr {
        let mut sides = self.sides.iter();
        let first = sides.next().map(|side| side.expr.clone());
        let links: Vec<Link> = sides
            .zip(&self.relations)
            .map(|(side, (rel, span))| Link { rel: *rel, span: *span, expr: side.expr.clone() })
            .collect();
        let first = first.unwrap_or_else(|| Expr::int(0));
        if links.is_empty() {
            return first;
        }
        let span = self.sides.last().map_or(first.span, |last| first.span.to(last.expr.span));
        Expr::new(Kind::Chain(Box::new(first), links), span)
    }
}

/// A table of numbers or points with one less in each column than in the one before, as an algorithm fills it in.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// As many numbers before the first column.
    pub nodes: Option<Vec<Side>>,
    /// At least three columns, each from the top.
    pub columns: Vec<Vec<Side>>,
}

/// What words say of functions that agree somewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The functions, as far as the sentence names them.
    pub names: Vec<Expr>,
    /// Where they agree.
    pub places: Vec<Expr>,
    /// The orders of the derivatives that agree for sure.
    pub certain: Vec<u32>,
    /// Those that may be said to agree; nothing if the words are not understood.
    pub possible: Option<Vec<u32>>,
}

/// What a formula says.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// Relations.
    Chain(Chain),
    /// A condition: a range, a membership, a sum of weights.
    Condition(Side),
    /// A formula without a relation.
    Bare(Side, Vec<Diagnostic>),
    /// What words say that names stand for.
    Object(Box<Object>),
    /// What words say of functions that agree somewhere.
    Contact(Contact),
    /// A table of numbers in the shape of a triangle, by its columns or by its rows; the cells that are formulas.
    Triangles(Vec<Triangle>, Vec<Side>),
    /// A declaration by comment.
    Declaration(String, Span),
    /// A block of queries, of which the definitions count.
    Queries(String, Span),
}

/// A statement with its surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What is said.
    pub said: Said,
    /// Where.
    pub place: Place,
    /// What the words around it make of it, if they say.
    pub role: Option<Role>,
    /// What its section speaks of, up to it.
    pub topics: Topics,
    /// What the sentences right before it speak of.
    pub near: Topics,
    /// What its sentence speaks of, where the section names degrees or lengths by words.
    pub sentence: Topics,
    /// The words between the formula before and this one.
    pub gap: String,
    /// Whether these words deny it.
    pub denied: bool,
    /// Whether its sentence draws a conclusion before it, or says nothing but it.
    pub concludes: bool,
    /// The name for which it is an equation: its sentence goes on to the solution.
    pub solved: Option<String>,
    /// Names of which it is said as of any of their kind, whatever they were in an example before.
    pub released: Vec<String>,
    /// Whether its sentence begins with a kind of things of which it may be said: "the polynomials with".
    pub of_a_kind: bool,
}

impl Statement {
    /// A statement without words around it.
    pub fn new(said: Said, place: Place) -> Self {
        let (topics, near, sentence, gap) = Default::default();
        let (denied, concludes, solved, released, of_a_kind) = Default::default();
        let role = None;
        Statement {
            said,
            place,
            role,
            topics,
            near,
            sentence,
            gap,
            denied,
            concludes,
            solved,
            released,
            of_a_kind,
        }
    }

    /// Whether its section speaks of splines and not of Bézier curves.
    pub(in crate::judge) fn is_on_splines_only(&self) -> bool {
        self.topics.has(Topic::Spline)
            && !self.topics.has(Topic::BezierCurve)
            && !self.topics.has(Topic::ControlPoints)
    }

    /// The Bézier curve that its sentence speaks of without naming its points, if it speaks of its polar form.
    pub(in crate::judge) fn curve(&self) -> Option<Curve> {
        let spoken = self.near.has(Topic::BezierCurve) && self.near.has(Topic::PolarForm);
        spoken.then(|| Curve { points: "b".to_owned() })
    }
}

/// The curve that a sentence speaks of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curve {
    /// The letter of its control points.
    pub points: String,
}

/// Whether it says that two functions or their derivatives have one value somewhere: F'(a) = G'(a).
pub(in crate::judge) fn equates_values(chain: &Chain) -> bool {
    let call = |side: &Side| matches!(side.expr.kind, Kind::Apply(..)) && !side.is_unread();
    matches!(chain.sides.as_slice(), [one, other] if call(one) && call(other))
        && matches!(chain.relations.as_slice(), [(Rel::Eq, _)])
}
