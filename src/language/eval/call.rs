//! Calls of functions that the input defined.

use std::sync::Arc;

use super::machine::{Evaluated, Machine, without_end};
use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::ops::errors::division_by_zero;
use crate::language::value::{Clause, Function, Parameter, Shape, Value};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::Ring;
use num_traits::Zero;

impl Machine {
    /// Calls a function with its index and bracket arguments.
    pub(crate) fn call(
        &mut self,
        function: &Arc<Function>,
        values: Vec<(Value, Span)>,
        span: Span,
    ) -> Evaluated {
        let shape = function.shape;
        let values = if shape.dimension > 0 { in_coordinates(values, shape) } else { values };
        if values.len() != shape.arity() {
            let name = function.name.as_ref().map_or("the function".to_owned(), Symbol::to_string);
            let given = values.len().saturating_sub(shape.lower + shape.upper);
            return Err(Diagnostic::error(
                Code::Arity,
                format!(
                    "{name} takes {} argument{}, not {given}",
                    shape.inner,
                    if shape.inner == 1 { "" } else { "s" }
                ),
            )
            .at(span));
        }
        let numbers: Option<Vec<Rational>> = values.iter().map(|(value, _)| value.as_rational()).collect();
        let key = function.name.clone().zip(numbers);
        if let Some(key) = &key
            && let Some(known) = self.memo.get(key)
        {
            return Ok(known.clone());
        }
        let Some(clause) = choose(function, &values) else {
            return Err(
                Diagnostic::error(Code::Domain, "no case of the definition fits these arguments").at(span)
            );
        };
        let result = self.run_clause(function, clause, &values, span)?;
        if let Some(key) = key
            && self.memo.len() < 100_000
        {
            self.memo.insert(key, result.clone());
        }
        Ok(result)
    }

    fn run_clause(
        &mut self,
        function: &Arc<Function>,
        clause: &Clause,
        values: &[(Value, Span)],
        span: Span,
    ) -> Evaluated {
        let bindings: Vec<(Symbol, Value)> = clause
            .parameters
            .iter()
            .zip(values)
            .filter_map(|(parameter, (value, _))| match parameter {
                Parameter::Name(symbol) => Some((symbol.clone(), value.clone())),
                Parameter::Exactly(_) => None,
            })
            .collect();
        if let Some(value) = self.at_vectors(function, clause, values, &bindings, span)? {
            return Ok(value);
        }
        if let Some(formula) = &clause.formula {
            let scalars: Option<Vec<(Symbol, Fraction)>> = bindings
                .iter()
                .map(|(symbol, value)| Some((symbol.clone(), value.as_scalar()?.clone())))
                .collect();
            if let Some(scalars) = scalars {
                return formula
                    .substitute(&scalars)
                    .map(Value::Scalar)
                    .map_err(|_| division_by_zero())
                    .at(span);
            }
        }
        let deepest = crate::budget::depth();
        if self.depth >= deepest {
            return Err(without_end(format!("calls nested more than {deepest} deep")).at(span));
        }
        // The body sees the names of its definition and its parameters, nothing of the caller.
        let caller =
            (std::mem::replace(&mut self.scope, clause.scope.clone()), std::mem::take(&mut self.locals));
        let answers = std::mem::take(&mut self.answers);
        self.depth += 1;
        if let Some(name) = &function.name {
            self.locals.push((name.clone(), Value::Function(function.clone())));
        }
        self.locals.extend(bindings);
        let result = self.eval(&clause.body);
        self.depth -= 1;
        self.answers = answers;
        (self.scope, self.locals) = caller;
        // A place inside another definition means nothing to the caller.
        result.map_err(|mut error| {
            error.span = Some(span);
            error
        })
    }
}

impl Machine {
    /// f(1̂, t) of a form that is written as a formula: an affine function c_0 + c_1 t_1 has the value
    /// c_1 v at a vector v, and so in each argument if these are points. `None` without vectors, and for functions of one
    /// argument that are linear: those take vectors to vectors.
    fn at_vectors(
        &mut self,
        function: &Arc<Function>,
        clause: &Clause,
        values: &[(Value, Span)],
        bindings: &[(Symbol, Value)],
        span: Span,
    ) -> Result<Option<Value>, Diagnostic> {
        if !bindings.iter().any(|(_, value)| matches!(value, Value::Vector(_))) {
            return Ok(None);
        }
        let Some(formula) = &clause.formula else {
            let Some(coordinates) = self.coordinates_of(function) else { return Ok(None) };
            let value = |coordinate: &Value| match coordinate {
                Value::Function(one) => {
                    let one = Function { shape: function.shape, ..(**one).clone() };
                    self.call(&Arc::new(one), values.to_vec(), span)
                }
                other => Ok(other.clone()),
            };
            return coordinates
                .iter()
                .map(value)
                .collect::<Result<_, _>>()
                .map(|all| Some(Value::point(all)));
        };
        // A vector has no coordinates of its own among those of the other arguments: each argument is one step.
        let (outside, size) = (function.shape.lower + function.shape.upper, function.shape.dimension.max(1));
        let all: Vec<(&Parameter, &Value)> =
            clause.parameters.iter().zip(values).map(|(parameter, (value, _))| (parameter, value)).collect();
        let (indices, inner) = all.split_at(outside.min(all.len()));
        let (mut slope, mut given) = (formula.clone(), Vec::new());
        for argument in indices.chunks(1).chain(inner.chunks(size)) {
            let named = argument.iter().filter_map(|(parameter, value)| match parameter {
                Parameter::Name(name) => Some((name, *value)),
                Parameter::Exactly(_) => None,
            });
            let (mut along, mut names) = (Vec::new(), Vec::new());
            for (name, value) in named {
                match value {
                    Value::Vector(v) => {
                        // v may have symbols that are names of arguments.
                        let length = Symbol::new(format!("\u{25e6}{}", given.len()));
                        let factor = Fraction::from(MultiPoly::symbol(length.clone()));
                        along.push(slope.derivative(name).times(&factor));
                        names.push(name);
                        given.push((length, v.clone()));
                    }
                    Value::Scalar(point) => given.push((name.clone(), point.clone())),
                    _ => return Ok(None),
                }
            }
            if along.is_empty() {
                continue;
            }
            if along.len() < argument.len() {
                let message = "an argument has coordinates of a vector and of a point";
                return Err(Diagnostic::error(Code::Type, message).at(span).hint("a vector is hat([1, 2])"));
            }
            slope = along.iter().fold(Fraction::zero(), |sum, part| sum.plus(part));
            if let Some(name) = names.into_iter().find(|name| slope.variables().contains(name)) {
                let message = format!("this is not affine in {name}, so it takes no vector there");
                return Err(Diagnostic::error(Code::Domain, message)
                    .at(span)
                    .hint("polar forms take vectors, such as hat(1): they are affine in each argument"));
            }
        }
        if inner.len() == size
            && bindings.len() == size
            && inner.iter().all(|(_, v)| matches!(v, Value::Vector(_)))
        {
            let origin: Vec<_> = bindings.iter().map(|(name, _)| (name.clone(), Fraction::zero())).collect();
            if formula.substitute(&origin).is_ok_and(|start| start.is_zero()) {
                return Ok(None);
            }
        }
        slope
            .substitute(&given)
            .map_err(|_| division_by_zero())
            .at(span)
            .map(|value| Some(Value::Scalar(value)))
    }
}

/// The arguments with points taken apart, where a function has points as arguments.
fn in_coordinates(values: Vec<(Value, Span)>, shape: Shape) -> Vec<(Value, Span)> {
    let mut all = Vec::with_capacity(shape.arity());
    for (value, span) in values {
        match value {
            Value::List(items) if items.len() == shape.dimension => {
                all.extend(items.into_iter().map(|item| (item, span)));
            }
            Value::Matrix(column) if column.shape() == (shape.dimension, 1) => {
                all.extend(column.iter().map(|entry| (Value::Scalar(entry.clone()), span)));
            }
            other => all.push((other, span)),
        }
    }
    all
}

/// The clause that fits: exact parameters count before names, earlier before later.
fn choose<'a>(function: &'a Function, values: &[(Value, Span)]) -> Option<&'a Clause> {
    let fits = |clause: &&Clause| {
        clause.parameters.iter().zip(values).all(|(parameter, (value, _))| match parameter {
            Parameter::Name(_) => true,
            Parameter::Exactly(q) => value.as_rational().as_ref() == Some(q),
        })
    };
    let exact =
        |clause: &Clause| clause.parameters.iter().filter(|p| matches!(p, Parameter::Exactly(_))).count();
    function.clauses.iter().filter(fits).reduce(
        |best, clause| {
            if exact(clause) > exact(best) { clause } else { best }
        },
    )
}
