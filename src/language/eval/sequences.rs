//! Sequences by their index: `a_n = n^2`, and `a_{n+1} = 2 a_n + 1` after `a_0 = 1`.

use std::sync::Arc;

use super::machine::{Evaluated, Machine};
use super::names::{indices_in_brackets, name_of};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Sign, Term};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::{Clause, Function, Parameter, Shape, Value};
use crate::language::write::text;
use crate::math::number::Rational;
use crate::math::poly::{Index, Symbol};

/// One argument, written as an index.
const SHAPE: Shape = Shape { lower: 1, upper: 0, inner: 0, dimension: 0 };

/// `a_{n+k}` on the left of a definition.
struct Member {
    base: Symbol,
    letter: String,
    shift: i64,
}

impl Machine {
    /// The sequence that `a_{n+k} = body` defines; `None` if it defines one symbol, or nothing: an index without a
    /// value has to stand on the right, and a recursion needs its first members.
    pub(super) fn sequence(
        &mut self,
        left: &Expr,
        body: &Expr,
    ) -> Result<Option<(Symbol, Value)>, Diagnostic> {
        let Some(Member { base, letter, shift }) = self.member_of_sequence(left) else { return Ok(None) };
        let recursive = body.has(&|part| match &part.kind {
            Kind::Subscript(of, _) => matches!(&of.kind, Kind::Name(name) if name == base.base()),
            _ => false,
        });
        let mut clauses = self.first_members(&base);
        let own = body.has(&|part| matches!(&part.kind, Kind::Name(name) if *name == letter));
        if !own || recursive && clauses.is_empty() {
            if own && shift != 0 {
                let note = format!("this gives one symbol a value, {}", text(left));
                let hint = format!("a recursion begins with its first member: {base}_0 = 1");
                self.note(Diagnostic::note(Code::BadDefinition, note).at(left.span).hint(hint));
            }
            return Ok(None);
        }
        let body = match shift {
            0 => body.clone(),
            _ => {
                let mut body = body.with_name(&letter, &shifted(&letter, -shift).grouped());
                without_brackets_in_indices(&mut body);
                body
            }
        };
        let function =
            |clauses| Value::Function(Arc::new(Function { name: Some(base.clone()), shape: SHAPE, clauses }));
        let parameters = vec![Parameter::Name(Symbol::new(&*letter))];
        let mut clause = self.with_locals([(base.clone(), function(Vec::new()))], |machine| {
            machine.clause(parameters, &body)
        })?;
        Arc::make_mut(&mut clause.scope).remove(&base);
        if recursive {
            clause.formula = None;
        }
        clauses.push(clause);
        Ok(Some((base.clone(), function(clauses))))
    }

    fn member_of_sequence(&mut self, left: &Expr) -> Option<Member> {
        let Kind::Subscript(base, indices) = &left.kind else { return None };
        let [index] = indices_in_brackets(indices) else { return None };
        let base = name_of(base, self).filter(|base| base.is_plain() && self.lookup(base).is_none())?;
        let (letter, shift) = match &index.kind {
            Kind::Name(letter) => (letter, 0),
            Kind::Add(terms) => match terms.as_slice() {
                [
                    Term { sign: Sign::Plus, expr: Expr { kind: Kind::Name(letter), .. } },
                    Term { sign, expr },
                ] => {
                    let step = expr.as_int()?;
                    (letter, if *sign == Sign::Plus { step } else { step.checked_neg()? })
                }
                _ => return None,
            },
            _ => return None,
        };
        let free = letter.chars().count() == 1 && self.lookup(&Symbol::new(letter)).is_none();
        free.then(|| Member { base, letter: letter.clone(), shift })
    }

    /// The members that have values already: a_0 = 1.
    fn first_members(&self, base: &Symbol) -> Vec<Clause> {
        let of_base = |(name, value): (&Symbol, &Value)| {
            let [Index::Number(number)] = name.indices() else { return None };
            let Value::Scalar(formula) = value else { return None };
            (name.base() == base.base() && name.accent().is_empty() && name.upper().is_empty()).then(|| {
                Clause {
                    parameters: vec![Parameter::Exactly(Rational::from_integer((*number).into()))],
                    body: value.to_expr(),
                    written: false,
                    formula: Some(formula.clone()),
                    scope: self.scope.clone(),
                }
            })
        };
        self.scope.iter().filter_map(of_base).collect()
    }

    /// The member of a sequence; `None` if the function is none.
    pub(super) fn member_at(
        &mut self,
        function: &Arc<Function>,
        indices: &[Expr],
        span: Span,
    ) -> Option<Evaluated> {
        let [index] = indices_in_brackets(indices) else { return None };
        let base = function.name.as_ref().map_or("a", Symbol::base);
        if function.shape != SHAPE || function.clauses.is_empty() {
            return None;
        }
        Some(self.eval(index).and_then(|value| {
            let first =
                function.clauses.iter().flat_map(|clause| &clause.parameters).filter_map(|parameter| {
                    match parameter {
                        Parameter::Exactly(number) => Some(number),
                        Parameter::Name(_) => None,
                    }
                });
            let explicit = function.clauses.iter().all(|clause| clause.formula.is_some());
            match (value.as_rational(), first.min()) {
                (Some(number), Some(first)) if !explicit && (number < *first || !number.is_integer()) => {
                    Err(Diagnostic::error(Code::Domain, format!("the members begin with {base}_{first}"))
                        .at(span))
                }
                (None, _) if !explicit => {
                    Err(Diagnostic::error(Code::BadExponent, "an index without a value")
                        .at(index.span)
                        .hint("give the letters values, or sum over them"))
                }
                _ => self.call(function, vec![(value, index.span)], span),
            }
        }))
    }
}

/// a_{n-1} for a_{(n-1)}
fn without_brackets_in_indices(expr: &mut Expr) {
    if let Kind::Subscript(_, indices) = &mut expr.kind {
        for index in indices {
            if let Kind::Group(inner) = &index.kind {
                *index = (**inner).clone();
            }
        }
    }
    expr.for_each_child_mut(&mut without_brackets_in_indices);
}

/// n + k
fn shifted(letter: &str, by: i64) -> Expr {
    let sign = if by < 0 { Sign::Minus } else { Sign::Plus };
    let name = Term { sign: Sign::Plus, expr: Expr::name(letter) };
    Expr::sum(vec![name, Term { sign, expr: Expr::int(by.saturating_abs()) }])
}
