//! What is asked as a whole: a claim, for which values something holds, what follows from other numbers.

use super::{Asked, Call, Reader, Request, Said, What};
use crate::formula::source::Pieces;
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::Part;

impl Reader<'_> {
    /// A request, or what it is claimed to be: is u v the polar form of t^2? The degree of t^2 equals 2.
    pub(super) fn asked(&mut self) -> Option<Asked> {
        if let Some(request) = self.two_curves() {
            self.at = self.parts.len();
            return Some(Asked { request, equals: None });
        }
        if let Some(request) = self.counted() {
            self.at = self.parts.len();
            return Some(Asked { request, equals: None });
        }
        if let Some(request) = self.diagonal() {
            return Some(Asked { request, equals: None });
        }
        // for which x is x^2 = 1
        if self.take(Phrase::Which) {
            let (Part::Piece(name), true) = (self.next()?, {
                self.at += 1;
                self.take(Phrase::Is)
            }) else {
                return None;
            };
            let Part::Piece(equation) = self.next()? else { return None };
            self.at += 1;
            let labels = vec![Said { label: Label::With, what: What::Formula(name) }];
            let subject = Some(Box::new(Request::Formula(vec![equation], Vec::new())));
            let call = Call { function: "solve", phrase: name, subject, labels, part: None };
            return Some(Asked { request: Request::Call(call), equals: None });
        }
        let asks = self.take(Phrase::Is);
        // is B_0^3(1/2) equal to 1/8?
        if let Some([Part::Piece(left), Part::Phrase(Phrase::Equals, _), Part::Piece(right)]) =
            self.parts.get(self.at..)
        {
            self.at += 3;
            let request = Request::Formula(vec![*left], Vec::new());
            return Some(Asked { request, equals: Some(What::Formula(*right)) });
        }
        // is u v + u + v symmetric and affine in each argument?
        if let Some([Part::Piece(form), Part::Phrase(Phrase::Multiaffine, phrase)]) =
            self.parts.get(self.at..)
            && asks
            && self.text.piece(phrase.range()).to_lowercase().contains("affin")
        {
            self.at += 2;
            let subject = Some(Box::new(Request::Formula(vec![*form], Vec::new())));
            let call = Call { function: "laws", phrase: *phrase, subject, labels: Vec::new(), part: None };
            return Some(Asked { request: Request::Call(call), equals: None });
        }
        // are B_1^2 and 2t(1 - t) equal?
        if let Some(
            [
                Part::Piece(left),
                Part::Phrase(Phrase::And, _),
                Part::Piece(right),
                Part::Phrase(Phrase::Equals, _),
            ],
        ) = self.parts.get(self.at..)
        {
            self.at += 4;
            let request = Request::Formula(vec![*left], Vec::new());
            return Some(Asked { request, equals: Some(What::Formula(*right)) });
        }
        // does t^3 - t have roots in [0, 1]?
        let finds = |part: &Part| {
            matches!(
                part,
                Part::Phrase(
                    Phrase::Function("roots" | "double_points" | "cusps" | "inflections" | "intersections"),
                    _
                )
            )
        };
        let found = self.parts.iter().filter(|part| finds(part)).count();
        let asks = asks && (found != 1 || self.next().is_some_and(|part| finds(&part)));
        if asks
            && let Some(Part::Piece(claimed)) = self.next()
            && !matches!(
                self.parts.get(self.at + 1),
                Some(Part::Phrase(Phrase::Label(_) | Phrase::Equals, _)) | None
            )
        {
            self.at += 1;
            self.take(Phrase::Is);
            let request = self.request()?;
            return matches!(request, Request::Call(_))
                .then_some(Asked { request, equals: Some(What::Formula(claimed)) });
        }
        let mut request = self.request()?;
        let mut equals = None;
        let takes = self.take(Phrase::Takes);
        if (takes || self.take(Phrase::Equals) || self.take(Phrase::Is))
            && let Some(value) = match self.next() {
                Some(Part::Piece(value)) => Some(What::Formula(value)),
                Some(Part::Phrase(Phrase::Degree(degree), _)) => Some(What::Degree(degree)),
                _ => None,
            }
            && (request.has_value() || self.has_value_at(&request))
        {
            self.at += 1;
            equals = Some(value);
            // has the value 2 at 1/2
            while self.at_label()
                && let Some(labels) = request.labels().map(|_| self.said())
            {
                request.labels()?.extend(labels?);
            }
        }
        // Does it take the value 1? Somewhere, not everywhere.
        if takes && !request.has_place() {
            return None;
        }
        (!asks || equals.is_some()).then_some(Asked { request, equals })
    }

    /// Whether a formula may be claimed to have a value at a place that is said behind it: does t^2 - 4 vanish at 2?
    fn has_value_at(&self, request: &Request) -> bool {
        matches!(request, Request::Formula(items, _) if items.len() == 1)
            && matches!(self.parts.get(self.at + 1), Some(Part::Phrase(Phrase::Label(Label::At), _)))
    }

    /// The polynomial with a polar form that is given: the polynomial whose blossom is u v + u + v.
    fn diagonal(&mut self) -> Option<Request> {
        let [
            Part::Phrase(Phrase::Function("diagonal") | Phrase::Command("expand"), phrase),
            Part::Phrase(Phrase::Function("polar"), _),
            rest @ ..,
        ] = self.parts.as_slice()
        else {
            return None;
        };
        let between =
            |part: &&Part| matches!(part, Part::Phrase(Phrase::Is | Phrase::Of | Phrase::Equals, _));
        let skipped = rest.iter().take_while(between).count();
        let [Part::Piece(form)] = rest.get(skipped..)? else { return None };
        let (phrase, form) = (*phrase, *form);
        self.at = self.parts.len();
        let subject = Some(Box::new(Request::Formula(vec![form], Vec::new())));
        Some(Request::Call(Call { function: "diagonal", phrase, subject, labels: Vec::new(), part: None }))
    }
}
