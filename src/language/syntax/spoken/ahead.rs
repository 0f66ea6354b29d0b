//! What the next parts of a request are.

use super::{Reader, Said, What};
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation, is_several};

impl Reader<'_> {
    /// Whether a label stands here.
    pub(super) fn at_label(&self) -> bool {
        let says_degree = matches!(self.phrase(), Some(Phrase::Degree(_)))
            && !matches!(
                self.parts.get(self.at + 1),
                Some(
                    Part::Piece(_)
                        | Part::Phrase(Phrase::Function(_) | Phrase::Degree(_) | Phrase::Rational, _)
                )
            );
        matches!(
            self.phrase(),
            Some(Phrase::Label(_) | Phrase::Place(_) | Phrase::Flag(..) | Phrase::Uniform)
        ) || says_degree
            || self.at_points()
    }

    /// Whether points follow their name here: control points 0, 1, 3.
    pub(super) fn at_points(&self) -> bool {
        matches!(
            self.parts.get(self.at..self.at + 2),
            Some([Part::Phrase(Phrase::Function("control_points" | "bezier_points"), _), Part::Piece(span)])
                if is_several(self.text.piece(span.range()))
        )
    }

    /// Whether data stand here before what is asked: given b0 = 1, b1 = 3, b2 = 1.
    pub(super) fn at_data(&self) -> bool {
        matches!(
            self.parts.get(self.at..self.at + 3),
            Some([Part::Phrase(Phrase::Label(Label::With), _), Part::Piece(span), _])
                if begins_equation(self.text.piece(span.range())) && is_several(self.text.piece(span.range()))
        )
    }

    /// Whether points go before their curve here: 控制点为 0, 1, 3 的贝塞尔曲线
    pub(super) fn at_points_of_curve(&self) -> bool {
        let rest = self.parts.get(self.at + 2..).unwrap_or_default();
        let between = |part: &&Part| matches!(part, Part::Phrase(Phrase::Of | Phrase::Degree(_), _));
        let curve = rest.iter().find(|part| !between(part));
        self.at_points()
            && matches!(rest.first(), Some(Part::Phrase(Phrase::Of, _)))
            && matches!(
                curve,
                Some(Part::Phrase(Phrase::Function("bezier" | "bspline" | "bspline_basis"), _))
            )
    }

    /// Whether a function follows a label, or what goes before it: into the Bernstein basis.
    pub(super) fn leads_to_function(&self) -> bool {
        let label = matches!(self.phrase(), Some(Phrase::Label(Label::In | Label::To | Label::With)));
        label && matches!(self.parts.get(self.at + 1), Some(Part::Phrase(Phrase::Function(_), _)))
    }

    /// Whether the form that is wanted follows: in the degree 5 Bernstein basis.
    pub(super) fn leads_to_form(&self) -> bool {
        let function = |part: &&Part| matches!(part, Part::Phrase(Phrase::Function(_), _));
        let form = self.parts.iter().skip(self.at).find(function);
        matches!(self.phrase(), Some(Phrase::Label(Label::In | Label::To)))
            && matches!(form, Some(Part::Phrase(Phrase::Function("in_bernstein" | "expand"), _)))
            && self.leads_to_qualified_function()
    }

    /// The same, with what it is like between them: into the quadratic spline, into a degree 2 spline.
    pub(super) fn leads_to_qualified_function(&self) -> bool {
        let rest = self.parts.get(self.at + 1..).unwrap_or_default();
        let quality = |part: &&Part| match part {
            Part::Piece(span) => !is_several(self.text.piece(span.range())),
            Part::Phrase(phrase, _) => {
                matches!(phrase, Phrase::Degree(_) | Phrase::Rational | Phrase::Label(Label::OfDegree))
            }
        };
        let qualities = rest.iter().take_while(quality).count();
        qualities < 3 && matches!(rest.get(qualities), Some(Part::Phrase(Phrase::Function(_), _)))
    }

    /// The member of a family that is wanted: the Bézier point b_1 of t^2.
    pub(super) fn member(&mut self) -> Option<Span> {
        let [Part::Piece(span), Part::Phrase(Phrase::Of, _)] = self.parts.get(self.at..self.at + 2)? else {
            return None;
        };
        let piece = self.text.piece(span.range());
        let (letter, index) = piece.split_once('_')?;
        let number = index.trim_start_matches('{').trim_end_matches('}');
        let named = letter.chars().all(char::is_alphabetic) && letter.chars().count() == 1;
        if !named || number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        self.at += 1;
        let start = span.end - index.len() + index.find(number)?;
        Some(Span::new(start, start + number.len()))
    }

    /// The bases between which coefficients are converted: from Bernstein to powers.
    pub(super) fn bases(&mut self, function: &str, labels: &mut Vec<Said>) {
        // Bernstein to power is the name of a function.
        if let (
            "change_of_basis",
            Some([Part::Phrase(Phrase::Label(Label::From), _), Part::Phrase(Phrase::Function(both), _)]),
        ) = (function, self.parts.get(self.at..self.at + 2))
            && let Some((from, to)) = both.split_once("_to_")
        {
            labels.push(Said { label: Label::From, what: What::Basis(from) });
            labels.push(Said { label: Label::To, what: What::Basis(to) });
            self.at += 2;
        }
        while function == "change_of_basis"
            && let Some(
                [
                    Part::Phrase(Phrase::Label(label @ (Label::From | Label::To)), _),
                    Part::Phrase(Phrase::Function(basis), _),
                ],
            ) = self.parts.get(self.at..self.at + 2)
        {
            labels.push(Said { label: *label, what: What::Basis(basis) });
            self.at += 2;
            // from the Bernstein basis of degree 2 to the power basis
            if let Some([Part::Phrase(Phrase::Label(Label::OfDegree), _), Part::Piece(degree), ..]) =
                self.parts.get(self.at..self.at + 2)
            {
                labels.push(Said { label: Label::OfDegree, what: What::Formula(*degree) });
                self.at += 2;
            }
            // to_bernstein is the name of a function
            if let Some(Part::Phrase(Phrase::Function(basis), _)) = self.next() {
                labels.push(Said { label: Label::To, what: What::Basis(basis) });
                self.at += 1;
            }
        }
    }
}
