//! A request whose words stand in no order that is known, or with words between them that carry no role: what its parts are is
//! known, so each goes where it belongs. What a request says beside that, such as a claim or a choice, has an order.

use super::{Asked, Call, Reader, Request, Said, What, meant, prepared};
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, begins_equation, is_several};

/// A way to read a request that is not read word by word.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Loose {
    /// What is asked.
    pub asked: Asked,
    /// The words that were left aside.
    pub aside: Vec<Span>,
}

/// How a text may be read that is no request word by word, the best way first.
pub(crate) fn loosely(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> Vec<Loose> {
    let Some((text, parts)) = prepared(text, known, function, false) else { return Vec::new() };
    let aside: Vec<Span> = parts
        .iter()
        .filter_map(|part| match part {
            Part::Phrase(Phrase::Aside, span) => Some(*span),
            _ => None,
        })
        .collect();
    let parts: Vec<Part> =
        parts.into_iter().filter(|part| !matches!(part, Part::Phrase(Phrase::Aside, _))).collect();
    let Some(parts) = meant::told(&text, parts, known) else { return Vec::new() };
    let mut reader = Reader { text: &text, parts, at: 0 };
    let ordered = reader.asked().filter(|_| reader.at == reader.parts.len());
    let apart = || gathered(&text, &reader.parts).map(|request| Asked { request, equals: None });
    let both = ordered.clone().into_iter().chain(apart());
    both.map(|asked| Loose { asked, aside: aside.clone() }).collect()
}

/// What has been found of a request.
#[derive(Default)]
struct Found {
    /// The functions before the object, the outermost first, and those after it, the innermost first.
    before: Vec<(&'static str, Span)>,
    after: Vec<(&'static str, Span)>,
    objects: Vec<Span>,
    said: Vec<Said>,
}

/// Functions that say what an object is.
const KINDS: &[&str] =
    &["bezier", "bspline", "bspline_basis", "patch", "triangle_patch", "lagrange", "bernstein", "hermite"];

/// The request that parts are, wherever they stand.
fn gathered(text: &str, parts: &[Part]) -> Option<Request> {
    const MOST_FUNCTIONS: usize = 2;
    let mut found = Found::default();
    let mut at = 0;
    while let Some(part) = parts.get(at) {
        at += 1;
        match *part {
            Part::Piece(span) if begins_equation(text.piece(span.range())) => {
                found.said.push(Said { label: Label::With, what: What::Formula(span) });
            }
            // two rounds of the scheme
            Part::Piece(span)
                if matches!(parts.get(at), Some(Part::Phrase(Phrase::Label(Label::Times), _))) =>
            {
                at += 1;
                found.said.push(Said { label: Label::Times, what: What::Formula(span) });
            }
            Part::Piece(span) => {
                // Formulas at several places are several things.
                let joined = at > 1 && matches!(parts[at - 2], Part::Phrase(Phrase::And, _));
                // of a line with the curve 0, 1, 3
                let other = at > 2
                    && matches!(parts[at - 2], Part::Phrase(Phrase::Function("bezier"), _))
                    && matches!(parts[at - 3], Part::Phrase(Phrase::Label(Label::With) | Phrase::And, _));
                match (found.objects.is_empty(), joined, other) {
                    (true, ..) | (_, true, _) => found.objects.push(span),
                    (_, _, true) => {
                        found.said.push(Said { label: Label::With, what: What::Formula(span) });
                    }
                    _ => return None,
                }
            }
            // "The minimum and the maximum" are two answers, not one of the other.
            Part::Phrase(Phrase::And, _)
                if matches!(
                    parts.get(at),
                    Some(Part::Phrase(Phrase::Function(_) | Phrase::Command(_), _))
                ) =>
            {
                return None;
            }
            Part::Phrase(phrase, span) => at += found.take(text, phrase, span, &parts[at..])?,
        }
    }
    let mut functions: Vec<(&'static str, Span)> = found.before;
    functions.dedup_by_key(|(function, _)| *function);
    functions.reverse();
    functions.extend(found.after);
    let kinds = functions.iter().filter(|(function, _)| KINDS.contains(function)).count();
    if functions.is_empty() || functions.len() - kinds > MOST_FUNCTIONS || kinds > 1 {
        return None;
    }
    // What something is goes before what is done with it.
    functions.sort_by_key(|(function, _)| !KINDS.contains(function));
    let object = Request::Formula(found.objects, found.said);
    Some(functions.into_iter().fold(object, |subject, (function, phrase)| {
        Request::Call(Call {
            function,
            phrase,
            subject: Some(Box::new(subject)),
            labels: Vec::new(),
            part: None,
        })
    }))
}

impl Found {
    /// Takes a phrase, and tells how many of the parts behind it belong to it; `None` if its place matters.
    fn take(&mut self, text: &str, phrase: Phrase, span: Span, rest: &[Part]) -> Option<usize> {
        let several = |part: Option<&Part>| matches!(part, Some(Part::Piece(span)) if is_several(text.piece(span.range())));
        let mut say = |label: Label, what: What| self.said.push(Said { label, what });
        match phrase {
            Phrase::Function("control_points" | "bezier_points") if several(rest.first()) => {
                Some(self.labelled(text, Label::Points, rest))
            }
            Phrase::Function(function) | Phrase::Command(function) => {
                match self.objects.is_empty() && self.said.is_empty() {
                    true => self.before.push((function, span)),
                    false => self.after.push((function, span)),
                }
                Some(0)
            }
            Phrase::Degree(degree) => {
                say(Label::OfDegree, What::Degree(degree));
                Some(0)
            }
            Phrase::Ordinal(count) => {
                say(Label::Times, What::Degree(count));
                Some(usize::from(matches!(rest.first(), Some(Part::Phrase(Phrase::Label(Label::Times), _)))))
            }
            Phrase::Place(place) => {
                say(Label::At, What::Place(place));
                Some(0)
            }
            Phrase::Flag(name, value) => {
                say(Label::With, What::Flag(name, value));
                Some(0)
            }
            Phrase::Uniform => {
                say(Label::Uniform, What::Degree(1));
                Some(0)
            }
            Phrase::Rational => {
                say(Label::Rational, What::Degree(1));
                Some(0)
            }
            // eliminate t from x = t^2, y = t^3
            Phrase::Label(Label::From)
                if matches!(rest.first(), Some(Part::Piece(span)) if begins_equation(text.piece(span.range())))
                    && !matches!(
                        rest.get(1),
                        Some(Part::Phrase(Phrase::And | Phrase::Label(Label::To), _))
                    )
                    && self.objects.is_empty() =>
            {
                let equations = rest.iter().map_while(|part| match part {
                    Part::Piece(span) => Some(*span),
                    Part::Phrase(..) => None,
                });
                self.objects.extend(equations);
                Some(self.objects.len())
            }
            Phrase::Label(label) => match rest.first() {
                Some(Part::Piece(_)) => Some(self.labelled(text, label, rest)),
                // with knots 0, 1, 2; into Bézier segments
                Some(Part::Phrase(
                    Phrase::Label(_)
                    | Phrase::Function(_)
                    | Phrase::Degree(_)
                    | Phrase::Ordinal(_)
                    | Phrase::Rational
                    | Phrase::Uniform
                    | Phrase::Place(_)
                    | Phrase::Of,
                    _,
                )) => Some(0),
                _ => None,
            },
            Phrase::Of | Phrase::And | Phrase::Using | Phrase::Curve | Phrase::Filler => Some(0),
            // What degree does t^2 have?
            Phrase::Is if self.objects.is_empty() && self.said.is_empty() && !self.before.is_empty() => {
                Some(0)
            }
            _ => None,
        }
    }

    /// What a label says with the pieces behind it.
    fn labelled(&mut self, text: &str, label: Label, rest: &[Part]) -> usize {
        let mut taken = 0;
        while let Some(Part::Piece(span)) = rest.get(taken) {
            let equation = begins_equation(text.piece(span.range()));
            let label = match (label, taken) {
                // between 0 and 1
                (Label::From, 2) => Label::To,
                _ => label,
            };
            if equation && taken > 0 && label != Label::To {
                return taken;
            }
            self.said.push(Said { label, what: What::Formula(*span) });
            taken += 1;
            match rest.get(taken..taken + 2) {
                Some([Part::Phrase(Phrase::And, _), Part::Piece(_)]) => taken += 1,
                _ => break,
            }
        }
        taken
    }
}
