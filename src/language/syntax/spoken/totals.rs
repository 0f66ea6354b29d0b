//! Sums and products in words.

use super::{Call, Reader, Said, Total, What};
use crate::formula::BigOp;
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation};

impl Reader<'_> {
    /// The Bernstein polynomials of degree 3, all of which are added.
    pub(super) fn all_of_them(&mut self, op: BigOp) -> Option<Call> {
        let start = self.at;
        while self.take(Phrase::Of) {}
        let mut labels = Vec::new();
        while let Some(Phrase::Degree(degree)) = self.phrase() {
            labels.push(Said { label: Label::OfDegree, what: What::Degree(degree) });
            self.at += 1;
        }
        if let (
            BigOp::Sum,
            Some(Part::Phrase(Phrase::Function(function @ ("bernstein" | "bspline_basis")), phrase)),
        ) = (op, self.next())
        {
            self.at += 1;
            while self.at_label()
                && let Some(said) = self.said()
            {
                labels.extend(said);
            }
            return Some(Call { function, phrase, subject: None, labels, part: None });
        }
        self.at = start;
        None
    }

    /// The formulas that are added or multiplied, if they stand side by side: t + 1 and t - 1; and whether words say that they
    /// are Bernstein coefficients.
    pub(super) fn joined(&mut self) -> Option<(Vec<Span>, bool)> {
        let start = self.at;
        self.take(Phrase::Of);
        let own = |part: &Part| {
            matches!(part, Part::Phrase(Phrase::Function("in_bernstein" | "bernstein" | "bezier"), _))
        };
        let curves = self.parts.iter().any(own);
        let mut found = Vec::new();
        loop {
            let before = self.at;
            // multiply bezier [1, 2] by bezier [0, 1, 3]
            while curves && matches!(self.phrase(), Some(Phrase::Degree(_)))
                || self.next().as_ref().is_some_and(own)
            {
                self.at += 1;
            }
            let Some(Part::Piece(span)) = self.next() else {
                self.at = before;
                break;
            };
            self.at += 1;
            found.push(span);
            let goes_on = [Phrase::And, Phrase::Label(Label::In), Phrase::Label(Label::With)];
            let more = self.at;
            if !goes_on.into_iter().any(|word| self.take(word)) {
                break;
            }
            // in Bernstein form of degree 5
            if !matches!(self.next(), Some(Part::Piece(_))) && !self.next().as_ref().is_some_and(own) {
                self.at = more;
                break;
            }
        }
        // The form of the product says nothing of its factors.
        let formula = |span: &Span| self.text.piece(span.range()).contains(char::is_alphabetic);
        let curves = curves && !(self.leads_to_form() && found.iter().any(formula));
        let equations = found.iter().any(|span| self.text.piece(span.range()).contains('='));
        // in Bernstein form
        if found.len() > 1 && curves {
            while self.take(Phrase::Label(Label::In)) || self.next().as_ref().is_some_and(own) {
                self.at += usize::from(self.next().as_ref().is_some_and(own));
            }
        }
        let form = self.leads_to_form();
        if found.len() > 1 && !equations && (self.next().is_none() || form) {
            return Some((found, curves));
        }
        self.at = start;
        None
    }

    /// What is added up: sum i = 0..5 of i^2, sum of i^2 for i = 0..5, sum of i from i = 0 to 5.
    pub(super) fn total(&mut self, op: BigOp, phrase: Span) -> Option<Total> {
        let piece = |reader: &mut Self| {
            let Some(Part::Piece(span)) = reader.next() else { return None };
            reader.at += 1;
            Some(span)
        };
        let text = self.text;
        let is_range = |span: Span| begins_equation(text.piece(span.range()));
        while self.take(Phrase::Of) {}
        // the sum from k = 1 to 5 of k^3
        let leads = matches!(self.parts.get(self.at + 1), Some(Part::Piece(span)) if is_range(*span));
        if leads && matches!(self.phrase(), Some(Phrase::Label(Label::From | Label::With | Label::Over))) {
            self.at += 1;
        }
        let first = piece(self)?;
        let (mut body, mut range) = if is_range(first) { (None, Some(first)) } else { (Some(first), None) };
        let mut end = None;
        let mut index = None;
        // sum i^2, i = 1..10
        if let (None, Some(Part::Piece(span))) = (range, self.next())
            && is_range(span)
        {
            self.at += 1;
            range = Some(span);
        }
        while let Some(next) = self.phrase() {
            match next {
                // die Summe der k^2 von k = 1 bis 5
                Phrase::Of
                    if range.is_none()
                        && matches!(self.parts.get(self.at + 1), Some(Part::Piece(span)) if is_range(*span)) =>
                {
                    self.at += 1;
                    range = Some(piece(self)?);
                }
                Phrase::Of if body.is_none() => {
                    self.at += 1;
                    body = Some(piece(self)?);
                }
                Phrase::Label(Label::With | Label::From | Label::Over) if range.is_none() => {
                    self.at += 1;
                    range = Some(piece(self)?);
                }
                // for i from 1 to n
                Phrase::Label(Label::From)
                    if end.is_none() && index.is_none() && range.is_some_and(|range| !is_range(range)) =>
                {
                    self.at += 1;
                    index = range;
                    range = Some(piece(self)?);
                }
                Phrase::Label(Label::To) if range.is_some() && end.is_none() => {
                    self.at += 1;
                    end = Some(piece(self)?);
                }
                _ if range.is_none()
                    && body.is_some_and(|body| family_index(self.text.piece(body.range())).is_some()) =>
                {
                    break;
                }
                _ => return None,
            }
        }
        // the sum of all B_i^4
        if range.is_none()
            && let Some(family) = body.filter(|body| family_index(self.text.piece(body.range())).is_some())
        {
            return Some(Total { op, phrase, body: family, range: family, end: None, index: None });
        }
        let range = range.filter(|range| index.is_some() || is_range(*range))?;
        if index.is_some() && end.is_none() {
            return None;
        }
        Some(Total { op, phrase, body: body?, range, end, index })
    }
}

/// The letter of the index and the degree of all members of a family: B_i^4.
pub(crate) fn family_index(text: &str) -> Option<(&str, &str)> {
    let rest = text.strip_prefix('B')?.strip_prefix('_')?;
    let (index, upper) = rest.split_once('^')?;
    let index = index.trim_start_matches('{').trim_end_matches('}');
    let upper = upper.split('(').next()?.trim();
    let upper = upper.trim_start_matches('{').trim_end_matches('}');
    let letter = index.chars().count() == 1 && index.chars().all(|c| matches!(c, 'i' | 'j' | 'k'));
    let degree = !upper.is_empty() && upper.chars().all(char::is_alphanumeric);
    (letter && degree).then_some((index, upper))
}
