//! What sentences say of functions that agree: "F and G share their value at 1".
//!
//! **Definition.** Two functions agree to some *orders* at a place: the derivatives of these orders have the same value
//! there. *Certain* orders are those that a sentence says for sure, *possible* ones all that it may say.

use crate::formula::{Expr, Kind, Rel, interval};
use crate::judge::page::statement::Contact;
use crate::language::lexicon::roles::is_variable;
use crate::notes::sentence::Piece;
use crate::notes::speech::{self, Agreement};

use std::collections::{BTreeMap, BTreeSet};

/// Orders above this one are not followed.
const MOST: u32 = 8;

/// What the sentences say of functions that agree, by the formula before which that is known: an equation that they draw
/// as a conclusion, or the next one after them.
pub(super) fn contacts(
    sentences: &[Vec<Piece>],
    formulas: &BTreeMap<usize, Vec<Expr>>,
) -> BTreeMap<usize, Vec<Contact>> {
    let call = |expr: &Expr| matches!(expr.kind, Kind::Apply(..));
    let equates =
        |item: &Expr| matches!(&item.kind, Kind::Chain(left, links) if call(left) && call(&links[0].expr));
    let equation = |number: &usize| formulas.get(number).is_some_and(|said| said.iter().any(equates));
    let mut found: BTreeMap<usize, Vec<Contact>> = BTreeMap::new();
    for (count, sentence) in sentences.iter().enumerate() {
        let Some(contact) = contact(sentence, formulas) else { continue };
        let own = numbers(sentence);
        let concludes =
            sentence.iter().any(|piece| matches!(piece, Piece::Words(words) if speech::concludes(words)));
        let first = match contact.possible {
            // What is not understood counts for all of its sentence.
            None => own.first().copied(),
            Some(_) => own.iter().copied().find(equation).filter(|_| concludes),
        };
        let next = || sentences[count + 1..].iter().find_map(|later| numbers(later).first().copied());
        if let Some(number) = first.or_else(next) {
            found.entry(number).or_default().push(contact);
        }
    }
    found
}

/// The numbers of the formulas of a sentence.
pub(super) fn numbers(sentence: &[Piece]) -> Vec<usize> {
    let number = |piece: &Piece| match piece {
        Piece::Formula(number) => Some(*number),
        Piece::Words(_) => None,
    };
    sentence.iter().filter_map(number).collect()
}

/// What a sentence says of functions that agree; nothing if it is understood and
/// says nothing of that.
fn contact(sentence: &[Piece], formulas: &BTreeMap<usize, Vec<Expr>>) -> Option<Contact> {
    let mut reader = Reader::default();
    let concludes =
        matches!(sentence.first(), Some(Piece::Words(words)) if speech::goes_on_from_before(words));
    if concludes {
        return None;
    }
    for piece in sentence {
        match piece {
            Piece::Words(words) => reader.words(words),
            Piece::Formula(number) => {
                for item in formulas.get(number).map_or(&[][..], Vec::as_slice) {
                    reader.formula(item);
                }
            }
        }
    }
    reader.contact()
}

/// A part of a sentence between commas, conjunctions that contrast included.
#[derive(Default)]
struct Reader {
    /// What the words said, in their order; `None` is a comma.
    cues: Vec<Option<Agreement>>,
    names: Vec<Expr>,
    places: Vec<Expr>,
    /// The ends of the interval that was spoken of last.
    ends: Option<(Expr, Expr)>,
    /// Whether the last formula was a place.
    at_place: bool,
    /// The words since the last formula.
    since: Vec<Option<Agreement>>,
    orders: BTreeSet<u32>,
    /// A formula that is none of a name, a place, an interval.
    other: bool,
}

impl Reader {
    fn words(&mut self, words: &str) {
        let cues = speech::cues(words);
        self.since.extend(&cues);
        self.cues.extend(cues);
    }

    fn formula(&mut self, item: &Expr) {
        let since = std::mem::take(&mut self.since);
        let last = since.iter().rev().flatten().next().copied();
        let joined = since.iter().flatten().all(|cue| *cue == Agreement::Neutral) && since.len() <= 2;
        let placed = last == Some(Agreement::Place) || self.at_place && joined;
        self.at_place = false;
        let plain = |expr: &Expr| matches!(expr.kind, Kind::Name(_) | Kind::Subscript(..));
        match &item.kind {
            Kind::Pow(letter, order) if matches!(&letter.kind, Kind::Name(name) if name == "C") => {
                match order.as_int().and_then(|order| u32::try_from(order).ok()).filter(|order| *order < MOST)
                {
                    Some(order) => self.orders.extend(0..=order),
                    None => self.other = true,
                }
            }
            _ if interval(item).is_some() => {
                self.ends = interval(item).map(|([from, to], _)| (from.clone(), to.clone()));
            }
            // t = 1
            Kind::Chain(left, links) if matches!(&left.kind, Kind::Name(name) if is_variable(name)) => {
                match links.as_slice() {
                    [link] if link.rel == Rel::Eq => {
                        self.places.push(link.expr.clone());
                        self.at_place = true;
                    }
                    _ => {}
                }
            }
            // F(1) = G(1) speaks for itself.
            Kind::Chain(..) => {}
            _ if matches!(last, Some(Agreement::Order | Agreement::UpTo)) && item.as_int().is_some() => {
                let order = item.as_int().and_then(|order| u32::try_from(order).ok()).unwrap_or(MOST);
                self.cues.push(Some(Agreement::Ordinal(order)));
            }
            _ if item.as_number().is_some() || placed && plain(item) => {
                self.places.push(item.clone());
                self.at_place = true;
            }
            Kind::Name(name) if is_variable(name) => {}
            _ if plain(item) => self.names.push(item.clone()),
            Kind::Apply(callee, _) if plain(callee) => self.names.push(callee.as_ref().clone()),
            Kind::Ellipsis => {}
            _ => self.other = true,
        }
    }

    /// The cues without the clauses that deny something: ", while nothing is known about their derivatives".
    fn asserted(&self) -> Vec<Agreement> {
        let end = self.cues.iter().position(|cue| *cue == Some(Agreement::So)).unwrap_or(self.cues.len());
        let clauses = self.cues[..end].split(Option::is_none).map(|clause| clause.iter().flatten().copied());
        let clauses = clauses
            .map(Iterator::collect::<Vec<Agreement>>)
            .filter(|clause| !clause.contains(&Agreement::Not));
        clauses.flatten().collect()
    }

    fn contact(mut self) -> Option<Contact> {
        let cues = self.asserted();
        let has = |cue: Agreement| cues.contains(&cue);
        let agrees = [Agreement::Agree, Agreement::Touch, Agreement::Join].into_iter().any(has);
        // "F and G with C^1 continuity", but not "a C^1 spline"
        let agrees = agrees || !self.orders.is_empty() && self.names.len() > 1;
        let spoken = [Agreement::Derivative, Agreement::Slope, Agreement::Smooth].into_iter().any(has);
        // "The difference vanishes at these places" says it again.
        let again = has(Agreement::There) && self.places.is_empty() && !spoken;
        let agrees = agrees && !again;
        let unknown = has(Agreement::Unknown) || self.other;
        if !agrees && !unknown && !spoken {
            return None;
        }
        let nothing = Contact { names: Vec::new(), places: Vec::new(), certain: Vec::new(), possible: None };
        if !agrees {
            return Some(nothing);
        }
        let mut complete = !unknown;
        // Ends of the interval
        let both = has(Agreement::Ends) || has(Agreement::Start) && has(Agreement::End);
        let mut value = has(Agreement::Value);
        if both || has(Agreement::Start) || has(Agreement::End) {
            let Some((from, to)) = self.ends.clone() else { return Some(nothing) };
            if both || has(Agreement::Start) {
                self.places.push(from);
            }
            if both || has(Agreement::End) {
                self.places.push(to);
            }
            value = true;
        }
        let joins = !self.orders.is_empty();
        let mut derivatives: BTreeSet<u32> = BTreeSet::new();
        let (mut pending, mut count, mut upto): (Vec<u32>, Option<u32>, bool) = (Vec::new(), None, false);
        // Whatever number stands before "derivatives" may be how many agree.
        let (mut numbers, mut most_possible) = (Vec::new(), 0);
        for (at, cue) in cues.iter().enumerate() {
            match cue {
                Agreement::Ordinal(number) | Agreement::Count(number) => numbers.push(*number),
                Agreement::Derivative => most_possible = numbers.drain(..).fold(most_possible, u32::max),
                Agreement::Neutral | Agreement::Order | Agreement::UpTo | Agreement::Including => {}
                _ => numbers.clear(),
            }
            let counted = count.take();
            match cue {
                Agreement::Ordinal(order) => {
                    pending.push(*order);
                    count = counted;
                }
                // "derivatives up to order two"
                Agreement::Count(number) => {
                    let order = at > 0 && matches!(cues[at - 1], Agreement::Order);
                    if order { pending.push(*number) } else { count = Some(*number) }
                }
                Agreement::UpTo => upto = true,
                Agreement::Order
                | Agreement::Neutral
                | Agreement::Twice
                | Agreement::Value
                | Agreement::There => count = counted,
                Agreement::Slope => {
                    derivatives.insert(1);
                }
                Agreement::Smooth => self.orders.extend(0..=counted.unwrap_or(1)),
                Agreement::Touch => self.orders.extend(0..=1),
                Agreement::Derivative => {
                    let most = pending.iter().max().copied();
                    match (most, counted) {
                        (Some(most), _) if upto => derivatives.extend(1..=most),
                        // "the first two derivatives"
                        (Some(1) | None, Some(count)) if pending.len() < 2 => derivatives.extend(1..=count),
                        (Some(_), _) => derivatives.extend(pending.iter().copied()),
                        // "their derivatives up to order 2", or of which order?
                        (None, _) => {
                            let rest: Vec<&Agreement> =
                                cues[at + 1..].iter().filter(|cue| **cue != Agreement::Neutral).collect();
                            match rest.as_slice() {
                                [
                                    Agreement::UpTo,
                                    Agreement::Order,
                                    Agreement::Ordinal(order) | Agreement::Count(order),
                                    ..,
                                ] => {
                                    derivatives.extend(1..=*order);
                                }
                                _ => complete = false,
                            }
                        }
                    }
                    pending.clear();
                }
                _ => {}
            }
        }
        let including = has(Agreement::Including) || has(Agreement::UpTo);
        let alone = derivatives.is_empty() && self.orders.is_empty();
        complete &= derivatives.iter().chain(&self.orders).all(|order| *order < MOST) && pending.is_empty();
        // They may meet with more than their values.
        let more = has(Agreement::Join) && alone;
        complete &= !more && !self.places.is_empty();
        let mut certain = self.orders;
        if value || including || alone {
            certain.insert(0);
        }
        certain.extend(derivatives);
        let agreements = cues.iter().filter(|cue| matches!(cue, Agreement::Agree | Agreement::Touch)).count();
        // "The values agree at 0, and the slopes at 1": what belongs where is not followed.
        let split = self.places.len() > 1 && certain.len() > 1 && !joins;
        if split || self.places.is_empty() || has(Agreement::Not) {
            certain.clear();
            complete = false;
        }
        let mut possible = certain.clone();
        let most = possible.last().copied().unwrap_or(0).max(most_possible);
        possible.extend(0..=most);
        complete &= agreements < 4;
        Some(Contact {
            names: self.names,
            places: self.places,
            certain: certain.into_iter().collect(),
            possible: complete.then(|| possible.into_iter().collect()),
        })
    }
}
