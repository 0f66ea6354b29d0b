//! What is said of the arguments of a call, put where it belongs.

use super::draft::{Draft, is_points, list};
use super::{Read, one_term};
use crate::formula::{Expr, Kind, Link, Rel, Sign, Term};
use crate::judge::written::names::bases;
use crate::language::eval;
use crate::language::functions::{Need, Takes};
use crate::language::lexicon::phrases::Label;

impl Draft {
    /// Takes points for the second parameter, if that is a list and has to be given: in the triangle (0, 0), (1, 0), (0, 1).
    pub(super) fn take_second(&mut self, read: Read) -> Option<Read> {
        let label = matches!(read.label, Label::In | Label::With | Label::Over | Label::At | Label::Points);
        let second = self.builtin.parameters.get(1).filter(|p| {
            p.need == Need::Required && p.kind == Takes::Points && p.has_name() && self.placed.len() == 1
        });
        let known = |name: &str| self.named.iter().any(|(own, _)| *own == name);
        match second {
            Some(second)
                if label && !known(second.name) && read.items.len() > 1 && is_points(&read.items) =>
            {
                self.named.push((second.name, list(read.items)));
                None
            }
            _ => Some(read),
        }
    }

    pub(super) fn take_degree(&mut self, read: Read, degree: Expr) -> Option<Read> {
        // Are the cubics 0, 0, 1, 2 and 2, 3, 5, 9 C^2?
        if matches!(self.builtin.name, "continuity" | "geometric_continuity") && self.placed.len() == 2 {
            let count = |curve: &Expr| match &curve.kind {
                Kind::Apply(_, groups) => groups.first()?.first()?.items().map(<[_]>::len),
                _ => None,
            };
            let number = degree.as_int().and_then(|n| usize::try_from(n + 1).ok());
            let agrees = number.is_some() && self.placed.iter().any(|curve| count(curve) == number);
            return (!agrees).then_some(read);
        }
        // The cubic is what is elevated, not what comes out: elevate the cubic 1, 2, 3.
        let of_object =
            read.label == Label::OfDegree && (degree.span.is_empty() || degree.span == self.phrase);
        if matches!(self.builtin.name, "elevate" | "reduce") && self.degree.is_none() && !of_object {
            self.degree = Some(degree);
            return None;
        }
        // the biquadratic patch [[0, 1, 2], …]
        if let ("patch", Some(rows)) = (self.builtin.name, self.placed.first().and_then(Expr::items)) {
            let size = degree.as_int().and_then(|n| usize::try_from(n + 1).ok());
            let fits = |row: &Expr| row.items().is_some_and(|row| Some(row.len()) == size);
            return (Some(rows.len()) != size || !rows.iter().all(fits)).then_some(read);
        }
        // As many points as the degree says: a cubic 0, 1, 1, 0.
        if let ("bezier" | "lagrange" | "newton" | "triangle_patch", Some(points)) =
            (self.builtin.name, self.placed.first().and_then(Expr::items))
        {
            let agrees = degree.as_int().is_some_and(|n| {
                usize::try_from(n).is_ok_and(|n| match self.builtin.name {
                    "triangle_patch" => {
                        n.checked_add(2).and_then(|m| (n + 1).checked_mul(m)) == Some(2 * points.len())
                    }
                    _ => n.checked_add(1) == Some(points.len()),
                })
            });
            return (!agrees).then_some(read);
        }
        let parameter =
            self.parameter(&["degree", "n"]).filter(|p| p.kind == Takes::Size || p.name == "degree");
        match parameter {
            Some(parameter) => {
                self.named.push((parameter.name, degree));
                None
            }
            None => Some(read),
        }
    }

    /// [0, 2] over which a curve is given, or the knots of a spline.
    pub(super) fn take_interval(&mut self, read: Read) -> Option<Read> {
        let ends = match read.items.as_slice() {
            [Expr { kind: Kind::List(ends) | Kind::Tuple(ends), .. }] => ends.clone(),
            // [0;1]
            [Expr { kind: Kind::Matrix(rows, _), .. }] if rows.iter().all(|row| row.len() == 1) => {
                match rows.iter().flatten().cloned().collect::<Option<Vec<_>>>() {
                    Some(ends) => ends,
                    None => return Some(read),
                }
            }
            [Expr { kind: Kind::Chain(_, links), .. }] => match links.as_slice() {
                [link] if link.rel == Rel::In => link.expr.items().unwrap_or_default().to_vec(),
                _ => return Some(read),
            },
            _ => read.items.clone(),
        };
        if let (Some(a), Some(b), [from, to]) =
            (self.parameter(&["a", "r"]), self.parameter(&["b", "s"]), ends.as_slice())
        {
            self.named.extend([(a.name, from.clone()), (b.name, to.clone())]);
            return None;
        }
        if let (Some(interval), [_, _]) = (self.parameter(&["interval"]), ends.as_slice()) {
            // Bernstein polynomials over [0, 2] are those of the interval.
            let of_interval = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if name == "bernstein");
            if let Some((_, basis)) =
                self.named.iter_mut().find(|(name, basis)| *name == "basis" && of_interval(basis))
            {
                *basis = list([basis.clone(), ends[0].clone(), ends[1].clone()].to_vec());
            }
            self.named.push((interval.name, list(ends)));
            return None;
        }
        match self.parameter(&["knots"]) {
            Some(knots) if ends.len() > 1 => {
                self.named.push((knots.name, list(ends)));
                None
            }
            _ => Some(read),
        }
    }

    /// The curve, or the set F(x, y) = 0, that a curve meets: with the line y = 1/2.
    pub(super) fn take_other(&mut self, read: Read) -> Option<Read> {
        let second = self.builtin.parameters.get(1).filter(|p| p.name == "other" && self.placed.len() < 2);
        let taken = self.named.iter().any(|(name, _)| *name == "other");
        let ([item], Some(second), false) = (read.items.as_slice(), second, taken) else { return Some(read) };
        if !matches!(read.label, Label::With | Label::In | Label::At | Label::Over) {
            return Some(read);
        }
        let Kind::Chain(left, links) = &item.kind else { return Some(read) };
        let [link @ Link { rel: Rel::Eq, .. }] = links.as_slice() else { return Some(read) };
        if !bases(item).iter().all(|name| matches!(name.as_str(), "x" | "y" | "z")) {
            return Some(read);
        }
        let terms = vec![
            Term { sign: Sign::Plus, expr: one_term((**left).clone()) },
            Term { sign: Sign::Minus, expr: one_term(link.expr.clone()) },
        ];
        self.named.push((second.name, Expr { span: item.span, ..Expr::sum(terms) }));
        None
    }

    /// A value for the parameter that comes after what the function is applied to.
    pub(super) fn take_parameter(&mut self, read: Read) -> Option<Read> {
        let given = self.named.iter().any(|(name, _)| name.is_empty());
        let takes = self.builtin.parameters.get(1).is_some_and(|p| {
            let point = p.kind == Takes::Point && matches!(p.need, Need::Optional(_)) && !given;
            (point || matches!(p.need, Need::Many(..)) || p.need == Need::Required && !given)
                && matches!(
                    p.kind,
                    Takes::Scalar
                        | Takes::Number
                        | Takes::ScalarOrList
                        | Takes::Point
                        | Takes::Any
                        | Takes::OneOf(_)
                )
        });
        // Neville's scheme at 2
        let last = self
            .builtin
            .parameters
            .iter()
            .skip(2)
            .find(|p| p.kind == Takes::Scalar && matches!(p.need, Need::Optional(_)));
        if let ([item], Some(_), 2) = (read.items.as_slice(), last, self.placed.len()) {
            let value = eval::named(item).map_or(item, |(_, value)| value);
            self.named.push(("", value.clone()));
            return None;
        }
        if !takes || self.placed.len() > 1 {
            return Some(read);
        }
        let values = read.items.iter().map(|item| match eval::named(item) {
            Some((_, value)) => value.clone(),
            None => item.clone(),
        });
        self.named.extend(values.map(|value| ("", value)));
        None
    }
}
