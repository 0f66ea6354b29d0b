//! Equations as arguments: `solve(2 t = 1, t)`.

use std::sync::Arc;

use super::machine::Machine;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::Diagnostic;
use crate::language::value::{Claim, Judgement, Value, Verdict};

impl Machine {
    /// The relations of an argument, side by side or in a list, with the values of their sides; nobody
    /// judges them. `None` if it has none.
    pub(super) fn equations(&mut self, item: &Expr) -> Result<Option<Value>, Diagnostic> {
        let mut judgements = Vec::new();
        match self.collect_equations(item, &mut judgements)? && !judgements.is_empty() {
            true => Ok(Some(Value::Claim(Arc::new(Claim { judgements })))),
            false => Ok(None),
        }
    }

    /// Whether there is nothing but relations.
    fn collect_equations(&mut self, item: &Expr, found: &mut Vec<Judgement>) -> Result<bool, Diagnostic> {
        match &item.kind {
            Kind::Chain(first, links) => {
                let mut left = self.eval(first)?;
                for link in links {
                    let right = self.eval(&link.expr)?;
                    found.push(Judgement {
                        rel: link.rel,
                        left: std::mem::replace(&mut left, right.clone()),
                        right,
                        verdict: Verdict::Undecided,
                        difference: None,
                        witness: None,
                        reasons: Vec::new(),
                    });
                }
                Ok(true)
            }
            Kind::List(items) | Kind::Tuple(items) | Kind::Set(items, None) | Kind::Sequence(items) => {
                for item in items {
                    if !self.collect_equations(item, found)? {
                        return Ok(false);
                    }
                }
                Ok(true)
            }
            Kind::Group(body) => self.collect_equations(body, found),
            _ => Ok(false),
        }
    }
}
