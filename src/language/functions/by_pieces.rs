//! Functions of Bézier curves and polynomials on splines: they are called on each piece, and what they say is put together.

use std::cmp::Ordering;
use std::sync::Arc;

use super::Builtin;
use super::parameter::Parameter;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::arithmetic::add;
use crate::language::ops::errors::curve_error;
use crate::language::ops::geometry::{bezier, polynomial_pieces, scalar_list};
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Form, Geometry, Table, Value};
use crate::math::curve::{BezierCurve, Interval};
use crate::math::number::Rational;
use crate::math::poly::{Fraction, RealRoot};

type Result<T> = std::result::Result<T, Diagnostic>;

/// What a function says of one piece.
pub(super) struct Piece {
    /// Where the piece lies.
    interval: Interval<Fraction>,
    /// What the function gives for it.
    value: Value,
    /// Its remarks.
    notes: Vec<Diagnostic>,
}

/// How what is said of the pieces becomes what is said of the spline.
pub(super) type Merge = fn(&mut Machine, Vec<Piece>) -> Evaluated;

/// Bézier curves one after the other.
type Curves = (Vec<BezierCurve<Fraction>>, Form);

/// The Bézier curves of a spline or piecewise polynomial; `None` for anything else.
pub(super) fn pieces_of(value: &Value) -> Option<Result<Curves>> {
    match value {
        Value::Geometry(geometry) => match &**geometry {
            Geometry::Spline(s, form) => Some(Ok((s.bezier_pieces(), *form))),
            _ => None,
        },
        _ => {
            let scalar = matches!(value, Value::Piecewise(_));
            let pieces = polynomial_pieces(value)?.map_err(curve_error);
            Some(pieces.map(|pieces| (pieces, Form { scalar, rational: false })))
        }
    }
}

impl Builtin {
    /// What the function gives for a spline among its arguments, by its pieces; `None` if there is none.
    pub(super) fn by_its_pieces(&self, machine: &mut Machine, args: &Arguments) -> Option<Evaluated> {
        let merge = self.by_pieces?;
        let spline = |place: &usize| args.given(*place).and_then(|(value, _)| pieces_of(value));
        let place = (0..args.len()).find(|place| spline(place).is_some())?;
        let span = args.span(place);
        let (curves, form) = match spline(&place)?.at(span) {
            Ok(found) => found,
            Err(error) => return Some(Err(error)),
        };
        let ends = [self.end(args, "a"), self.end(args, "b")];
        let mut list = Vec::with_capacity(curves.len());
        for curve in curves {
            let interval = curve.interval().clone();
            let mut own = args.clone();
            own.put(place, bezier(curve, form), span);
            match self.within(own, &interval, &ends) {
                None => continue,
                Some(own) => match machine.aside(|machine| self.run(machine, own)) {
                    (Ok(value), notes) => list.push(Piece { interval, value, notes }),
                    (Err(error), _) => {
                        let (a, b) = interval.ends();
                        let [a, b] = [a, b].map(|end| Value::Scalar(end.clone()).to_expr());
                        let [a, b] = [&a, &b].map(crate::language::write::text);
                        let reason = match error.reason.as_deref() {
                            Some(reason) => format!("{reason}; on the piece over [{a}, {b}]"),
                            None => format!("on the piece over [{a}, {b}]"),
                        };
                        return Some(Err(error.reason(reason)));
                    }
                },
            }
        }
        Some(merge(machine, list))
    }

    /// The place of an end of the interval, and where that is given the number.
    fn end(&self, args: &Arguments, name: &str) -> Option<(usize, Option<Rational>)> {
        let of_end = |own: &&Parameter| own.has_place() && own.kind == Takes::Number;
        let place = self
            .parameters
            .iter()
            .filter(|own| own.has_place())
            .position(|own| own.name == name && of_end(&own))?;
        let given =
            args.given(place).map(|(value, _)| value).or_else(|| args.named(name).map(|(value, _)| value));
        Some((place, given.and_then(Value::as_rational)))
    }

    /// The arguments for a piece, within the ends that are asked for; `None` if it lies outside of them.
    fn within(
        &self,
        mut args: Arguments,
        interval: &Interval<Fraction>,
        ends: &[Option<(usize, Option<Rational>)>; 2],
    ) -> Option<Arguments> {
        let [Some((at_a, a)), Some((at_b, b))] = ends else { return Some(args) };
        let (c, d) = interval.ends();
        let (Some(c), Some(d)) = (c.as_rational(), d.as_rational()) else { return Some(args) };
        if a.is_none() && b.is_none() {
            return Some(args);
        }
        let from = a.clone().map_or(c.clone(), |a| a.max(c));
        let to = b.clone().map_or(d.clone(), |b| b.min(d));
        let span = args.span(0);
        for (place, name, end) in [(*at_a, "a", &from), (*at_b, "b", &to)] {
            args.take_named(name);
            args.put(place, Value::number(end.clone()), span);
        }
        (from <= to).then_some(args)
    }
}

/// A root at a knot belongs to two pieces: it is one of the multiplicity of the spline, the smaller of both.
pub(super) fn roots(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    let mut all: Vec<Value> = Vec::new();
    let mut end: Option<RealRoot> = None;
    for piece in pieces {
        let Value::List(found) = &piece.value else { continue };
        let start = piece.interval.start().as_rational().map(RealRoot::Rational);
        let is = |value: &Value, at: &Option<RealRoot>| at.is_some() && value.as_real() == *at;
        let here = found.iter().filter(|value| is(value, &start)).count();
        if end.is_some() && end == start {
            let before = all.iter().rev().take_while(|value| is(value, &start)).count();
            all.truncate(all.len() - before);
            all.extend(found.iter().take(before.min(here)).cloned());
            all.extend(found.iter().skip(here).cloned());
        } else {
            all.extend(found.iter().cloned());
        }
        piece
            .notes
            .into_iter()
            .filter(|note| note.code != Code::StandardMeaning)
            .for_each(|n| machine.note(n));
        end = piece.interval.end().as_rational().map(RealRoot::Rational);
    }
    Ok(Value::List(all.into()))
}

/// The value that comes last in an order, with the remark where it is taken.
fn extreme(machine: &mut Machine, pieces: Vec<Piece>, better: Ordering) -> Evaluated {
    let mut best: Option<(Value, Vec<Diagnostic>)> = None;
    for piece in pieces {
        let order = best.as_ref().and_then(|(value, _)| Some(piece.value.as_real()?.cmp(&value.as_real()?)));
        match order {
            Some(order) if order == better => best = Some((piece.value, piece.notes)),
            None => best = Some((piece.value, piece.notes)),
            Some(Ordering::Equal) => {
                if let Some((_, notes)) = &mut best {
                    notes.extend(piece.notes);
                }
            }
            Some(_) => {}
        }
    }
    let (value, notes) =
        best.ok_or_else(|| Diagnostic::error(Code::Empty, "the spline has no piece in this interval"))?;
    notes.into_iter().filter(|note| note.code != Code::StandardMeaning).for_each(|note| machine.note(note));
    Ok(value)
}

/// The largest of all values.
pub(super) fn largest(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    extreme(machine, pieces, Ordering::Greater)
}

/// The smallest of all values.
pub(super) fn smallest(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    extreme(machine, pieces, Ordering::Less)
}

/// A number, or bounds [lower, upper] of one, of each piece: their sum.
pub(super) fn sum(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    let mut bounds = [Value::int(0), Value::int(0)];
    for piece in pieces {
        let [lower, upper] = match &piece.value {
            Value::List(ends) if ends.len() == 2 => [ends[0].clone(), ends[1].clone()],
            exact => [exact.clone(), exact.clone()],
        };
        bounds = [add(bounds[0].clone(), lower)?, add(bounds[1].clone(), upper)?];
        piece.notes.into_iter().for_each(|note| machine.note(note));
    }
    match bounds {
        [lower, upper] if lower == upper => Ok(lower),
        [lower, upper] => Ok(Value::list(vec![lower, upper])),
    }
}

/// Rows of all tables, those at a common knot once.
pub(super) fn rows(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    let mut all: Option<Table> = None;
    for piece in pieces {
        piece.notes.into_iter().for_each(|note| machine.note(note));
        let Value::Table(table) = &piece.value else { continue };
        let all = all.get_or_insert_with(|| Table { header: table.header.clone(), rows: Vec::new() });
        // Points that one piece leaves out are left out everywhere.
        let width = all.header.len().min(table.header.len());
        all.header.truncate(width);
        all.rows.iter_mut().for_each(|row| row.truncate(width));
        for row in &table.rows {
            let row = row[..width].to_vec();
            if !all.rows.iter().any(|known| same(known, &row)) {
                all.rows.push(row);
            }
        }
    }
    Ok(all.map_or_else(|| Value::list(Vec::new()), |table| Value::Table(Arc::new(table))))
}

/// Whether the parameters of two rows are the same numbers.
fn same(left: &[Cell], right: &[Cell]) -> bool {
    let real = |cell: &Cell| match cell {
        Cell::Value(value) => value.as_real(),
        _ => None,
    };
    left.iter().zip(right).all(|(a, b)| real(a) == real(b))
}

/// The piece and what is said of it, in rows.
pub(super) fn each(machine: &mut Machine, pieces: Vec<Piece>) -> Evaluated {
    let mut table = Table::with_header(["interval", "equation"]);
    for piece in pieces {
        let (a, b) = piece.interval.ends();
        piece.notes.into_iter().for_each(|note| machine.note(note));
        table.rows.push(vec![Cell::Value(scalar_list([a.clone(), b.clone()])), Cell::Value(piece.value)]);
    }
    Ok(Value::Table(Arc::new(table)))
}
