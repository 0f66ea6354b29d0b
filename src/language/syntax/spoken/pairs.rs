//! Two curves and how they meet: do 0, 1, 3 on [0, 1] and 3, 5, 8 on [1, 2] join C^1?

use super::{Call, Reader, Request, Said, What};
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase};
use crate::language::syntax::pieces::{Part, is_several};

/// C^1, G2
pub(super) fn is_order(text: &str) -> bool {
    let number = text.get(1..).unwrap_or_default().trim_start_matches('^');
    text.starts_with(['C', 'G']) && !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit())
}

/// [0, 1]
fn is_interval(text: &str) -> bool {
    let inside = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    inside.is_some_and(|inside| inside.matches([',', ';']).count() == 1 && !inside.contains(['[', ']']))
}

impl Reader<'_> {
    /// The request whether two curves meet smoothly; `None` if it says anything else besides.
    pub(super) fn two_curves(&self) -> Option<Request> {
        let names = |part: &Part| match part {
            Part::Phrase(Phrase::Function(name @ ("continuity" | "geometric_continuity")), span) => {
                Some((*name, *span))
            }
            _ => None,
        };
        // 2, 3, 5 C^1
        let apart = |span: Span| {
            let text = self.text.piece(span.range());
            // on [1, 2]: C1? C2?
            let ends = [',', ' ', '?', ':', ';'];
            let (mut rest, mut order) = (text.trim_end_matches(ends), None);
            while let Some(word) = rest.split_whitespace().next_back().filter(|word| is_order(word)) {
                order = Some(word);
                rest = rest.strip_suffix(word).unwrap_or(rest).trim_end_matches(ends);
            }
            (Span::new(span.start, span.start + rest.len()), order)
        };
        let orders: Vec<&str> = self
            .parts
            .iter()
            .filter_map(|part| match part {
                Part::Piece(span) => apart(*span).1,
                Part::Phrase(..) => None,
            })
            .collect();
        let named = self.parts.iter().find_map(names);
        if named.is_none() && orders.is_empty() {
            return None;
        }
        let geometric = orders.iter().any(|text| text.starts_with('G'));
        let mut curves: Vec<(Span, Option<Span>)> = Vec::new();
        let mut degrees = Vec::new();
        let mut over = false;
        // on [0, 1] and [1, 2]
        let mut both: Vec<Span> = Vec::new();
        for part in &self.parts {
            let part = match part {
                Part::Piece(span) => Part::Piece(apart(*span).0),
                part => *part,
            };
            match &part {
                Part::Piece(span) if span.is_empty() => {}
                Part::Piece(span)
                    if curves.len() == 2
                        && (over || !both.is_empty())
                        && is_interval(self.text.piece(span.range())) =>
                {
                    both.push(*span);
                    over = false;
                }
                Part::Piece(span) if over => {
                    let (_, interval) = curves.last_mut()?;
                    if interval.replace(*span).is_some() {
                        return None;
                    }
                    over = false;
                }
                Part::Piece(span) if is_several(self.text.piece(span.range())) => curves.push((*span, None)),
                Part::Phrase(Phrase::Label(Label::Over), _) if !over && !curves.is_empty() => over = true,
                Part::Phrase(Phrase::Degree(degree), _) => degrees.push(*degree),
                Part::Phrase(
                    Phrase::Function("bezier" | "continuity" | "geometric_continuity" | "smoothness")
                    | Phrase::Is
                    | Phrase::And
                    | Phrase::Of
                    | Phrase::Label(Label::With | Label::At),
                    _,
                ) => {}
                _ => return None,
            }
        }
        match (both.as_slice(), curves.as_mut_slice()) {
            ([], _) => {}
            ([one], [_, (_, interval)]) if interval.is_none() => *interval = Some(*one),
            ([one, other], [(_, first), (_, second)]) if first.is_none() && second.is_none() => {
                *first = Some(*one);
                *second = Some(*other);
            }
            _ => return None,
        }
        if over || curves.len() != 2 {
            return None;
        }
        let phrase = named.map_or(curves[0].0, |(_, span)| span);
        let function = if geometric { "geometric_continuity" } else { "continuity" };
        let labels =
            degrees.into_iter().map(|degree| Said { label: Label::OfDegree, what: What::Degree(degree) });
        Some(Request::Call(Call {
            function,
            phrase,
            subject: Some(Box::new(Request::Curves(curves))),
            labels: labels.collect(),
            part: None,
        }))
    }
}
