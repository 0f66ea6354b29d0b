//! Polar forms of the pieces of a spline: "f and g, the polar forms of its pieces on [2, 3] and [3, 4]".

use super::Reader;
use super::tokens::Token;
use crate::formula::Expr;
use crate::judge::page::object::{Object, Sort};
use crate::notes::speech::Word;

impl Reader<'_> {
    /// Polar forms of pieces of a spline of which no control points are given, each with its interval; whether they are
    /// that.
    pub(super) fn of_pieces(&mut self, object: &Object, names: &[Expr], of: &[Expr], number: usize) -> bool {
        let (([owner], _) | ([], [owner])) = (of, self.talk.topic.as_slice()) else { return false };
        let owner = &owner.clone();
        let spline = self.known(owner).filter(|known| {
            let degree = known.degree.as_ref().is_some_and(|degree| degree.as_int().is_some());
            known.sort == Sort::SplineCurve && known.points.is_empty() && known.interval.is_none() && degree
        });
        if spline.is_none() || object.sort != Sort::PolarForm {
            return false;
        }
        let intervals: Vec<(Expr, Expr)> =
            (0..self.tokens.len()).filter_map(|at| self.interval_at(at)).collect();
        if intervals.len() != names.len() {
            return false;
        }
        self.introduce(std::slice::from_ref(owner), number);
        for (name, interval) in names.iter().zip(intervals) {
            let (names, of) = (vec![name.clone()], Some(owner.clone()));
            let own = Object { names, of, interval: Some(interval), ..object.clone() };
            self.found.entry(number).or_default().push(own);
        }
        true
    }

    /// The token after "of its pieces on [2, 3] and [3, 4]", if intervals are listed there.
    pub(super) fn after_intervals(&self, from: usize) -> Option<usize> {
        let joins = |at: &usize| {
            let word = matches!(
                self.tokens.get(*at),
                Some(
                    Token::Comma
                        | Token::Word(Word::Of | Word::Its | Word::The | Word::On | Word::And | Word::Piece)
                )
            );
            word || self.interval_at(*at).is_some()
        };
        let to = (from..self.tokens.len()).find(|at| !joins(at))?;
        (from..to).any(|at| self.interval_at(at).is_some()).then_some(to)
    }
}
