//! Divided differences of a function, as they are written: f[x_0, x_1, x_2].

use super::machine::{Evaluated, Machine};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::calculus::nth_derivative;
use crate::language::ops::errors::division_by_zero;
use crate::language::value::{Function, Value};
use crate::math::interpolate::DividedDifferences;
use crate::math::poly::Fraction;

impl Machine {
    /// (x -> x^3)[1, 2, 4]
    pub(super) fn difference_of_lambda(&mut self, expr: &Expr) -> Result<Option<Value>, Diagnostic> {
        let Kind::Subscript(base, indices) = &expr.kind else { return Ok(None) };
        let (Kind::Group(inner), [Expr { kind: Kind::List(nodes), .. }]) = (&base.kind, indices.as_slice())
        else {
            return Ok(None);
        };
        match inner.kind {
            Kind::Lambda(..) => match self.eval(inner)? {
                Value::Function(function) => self.divided_difference(&function, nodes, expr.span).map(Some),
                _ => Ok(None),
            },
            _ => Ok(None),
        }
    }

    /// f[x_0, …, x_n] by the scheme of the values; where nodes are equal, derivatives stand for them.
    pub(super) fn divided_difference(
        &mut self,
        function: &Function,
        nodes: &[Expr],
        span: Span,
    ) -> Evaluated {
        let Some((variable, formula)) = function.as_formula() else {
            // f[2, 3] of a function of two variables is a call, as in Mathematica.
            if function.shape.arity() == nodes.len() && nodes.len() > 1 {
                let values = nodes.iter().map(|node| Ok((self.eval(node)?, node.span))).collect::<Result<
                    _,
                    Diagnostic,
                >>(
                )?;
                return self.call(&std::sync::Arc::new(function.clone()), values, span);
            }
            let error = Diagnostic::error(Code::Type, "divided differences are of functions of one variable");
            return Err(error.at(span).hint("divided_differences(nodes, values) takes values"));
        };
        // Equal nodes stand together; the order of the nodes does not matter.
        let mut groups: Vec<(Fraction, usize)> = Vec::new();
        for node in nodes {
            let node = self.eval_scalar(node)?;
            match groups.iter_mut().find(|(known, _)| *known == node) {
                Some((_, count)) => *count += 1,
                None => groups.push((node, 1)),
            }
        }
        let (mut places, mut values) = (Vec::new(), Vec::new());
        for (node, count) in groups {
            for order in 0..count {
                let derivative = nth_derivative(formula, variable, order);
                let value = derivative.substitute(&[(variable.clone(), node.clone())]);
                values.push(value.map_err(|_| division_by_zero()).at(span)?);
                places.push(node.clone());
            }
        }
        let table = DividedDifferences::with_repeats(&places, &values)
            .map_err(|error| Diagnostic::error(Code::Coincident, error.to_string()).at(span))?;
        let last = table.columns().last().and_then(|column| column.first());
        last.cloned()
            .map(Value::Scalar)
            .ok_or_else(|| Diagnostic::error(Code::Empty, "a divided difference needs nodes").at(span))
    }
}
