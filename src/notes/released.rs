//! Names that a sentence speaks of as of any of their kind: what an example said of them is no proof there.

use std::collections::BTreeSet;

use super::speech::{self, Around};
use crate::formula::{Expr, Kind};
use crate::judge::page::statement::{Role, Said, Statement};
use crate::judge::written::names::{Head, bases, walk};

/// Names of which a paragraph speaks as of any of their kind.
pub(super) struct Released<'a> {
    around: &'a [Around],
    paragraph: u32,
    names: BTreeSet<String>,
    /// Those of them that words let be anything.
    arbitrary: BTreeSet<String>,
}

impl<'a> Released<'a> {
    /// Of none yet.
    pub(super) fn new(around: &'a [Around]) -> Self {
        Released { around, paragraph: 0, names: BTreeSet::new(), arbitrary: BTreeSet::new() }
    }

    /// "For every cubic F with polar form f, …"; "Let h > 0 be arbitrary. Then …"; "If f is convex, then …"
    pub(super) fn sentence(&mut self, statements: &mut [Statement]) {
        let Some(first) = statements.first() else { return };
        if self.paragraph != first.place.group {
            (self.paragraph, self.names) = (first.place.group, BTreeSet::new());
            self.arbitrary.clear();
        }
        let around = self.around;
        let words_of = |formula: usize| around.get(formula.wrapping_sub(1)).cloned().unwrap_or_default();
        let general = speech::generalises(&words_of(first.place.formula).left, true);
        let mut own = BTreeSet::new();
        let mut claims = false;
        for statement in statements {
            let words = words_of(statement.place.formula);
            let releases = || speech::releases(&words.left, &words.right);
            let case = || speech::role(&words, false) == Some(Role::Case);
            if let Said::Bare(side, _) | Said::Condition(side) = &statement.said
                && speech::is_arbitrary(&words.right)
            {
                self.arbitrary.extend(bases(&side.expr));
            }
            match &statement.said {
                Said::Bare(side, _) => {
                    // "If f is convex"
                    let named = matches!(side.expr.kind, Kind::Name(_)) && !words.right.trim().is_empty();
                    if releases() || named && case() {
                        own.extend(bases(&side.expr));
                    }
                }
                // "For 0 < α < 1"
                Said::Condition(side) if releases() || case() => own.extend(bases(&side.expr)),
                Said::Chain(chain) => {
                    // "A patch has points b_ij. With b_ij = i j we get …"
                    let given = matches!(
                        speech::role(&words, false),
                        Some(Role::Introduced | Role::Assumed | Role::Case)
                    );
                    let named = chain.sides.first().and_then(|side| Head::of(&side.expr));
                    if let Some(head) = named.filter(|_| given) {
                        self.names.remove(&head.base);
                    }
                    claims = true;
                    own.extend(chain.quantified.iter().cloned());
                    // What is said "in general" of a function is said of that one, for other numbers.
                    if general || speech::holds_for_any(&words.left) {
                        let mut functions = BTreeSet::new();
                        for side in &chain.sides {
                            walk(&side.expr, &mut |part| {
                                // w_0(1 - t) is a product.
                                if let Kind::Apply(callee, _) = &part.kind
                                    && !is_numbered(callee)
                                {
                                    functions.extend(bases(callee));
                                }
                            });
                        }
                        let names = chain.sides.iter().flat_map(|side| bases(&side.expr));
                        own.extend(names.filter(|name| !functions.contains(name)));
                    }
                }
                _ => {}
            }
            statement.place.arbitrary = self.arbitrary.iter().cloned().collect();
            statement.released = self.names.union(&own).cloned().collect();
            statement.of_a_kind = words.first && speech::speaks_of_a_kind(&words.left);
        }
        if !claims {
            self.names.extend(own);
        }
    }
}

/// b_0
fn is_numbered(callee: &Expr) -> bool {
    matches!(&callee.kind, Kind::Subscript(_, lower) if lower.iter().all(|index| index.as_int().is_some()))
}
