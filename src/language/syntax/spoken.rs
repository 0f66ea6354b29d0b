//! Requests in words: `polar form of t^3`, `derivative of t^2 at t = 1`, `(1+t)^2 in Bernstein form`.
//!
//! A request is made of phrases (see `lexicon::phrases`) and of the formulas between them. Only a text all of
//! whose words are known is one; what its words mean together is settled here, what a function makes of
//! it, where functions are known.

mod ahead;
mod asks;
mod counts;
mod loose;
mod meant;
mod moved;
mod pairs;
mod questions;
mod totals;

pub(crate) use self::counts::Count;
pub(crate) use self::loose::loosely;
pub(crate) use self::totals::family_index;
use super::pieces::{
    Part, begins_equation, has_words, is_sum, may_have_words, parts, without_asides, without_text_commands,
};
use crate::formula::BigOp;
use crate::formula::source::{Pieces, Span};
use crate::language::lexicon::phrases::{Label, Phrase, Place};

/// What is asked for, and what it is claimed or wanted to be.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Asked {
    /// What is asked for.
    pub request: Request,
    /// Its value, if one is said.
    pub equals: Option<What>,
}

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Request {
    /// A formula, or several between which "and" stands, and what is said of them.
    Formula(Vec<Span>, Vec<Said>),
    /// A function of something.
    Call(Call),
    /// A sum or product.
    Total(Total),
    /// A sum or product of formulas that stand side by side, or of what Bernstein coefficients give: the product of t + 1 and t - 1.
    Joined(BigOp, Vec<Span>, bool),
    /// The sum of the functions that a function gives: of all Bernstein polynomials of degree 3.
    Added(Call),
    /// Curves by their control points, each perhaps with its interval.
    Curves(Vec<(Span, Option<Span>)>),
    /// A number that follows from others.
    Count(Count),
}

/// A function, and what is said of its arguments.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Call {
    /// The name of the function.
    pub function: &'static str,
    /// Where its phrase stands.
    pub phrase: Span,
    /// What it is applied to.
    pub subject: Option<Box<Request>>,
    /// What is said besides.
    pub labels: Vec<Said>,
    /// Which of the things it gives is wanted.
    pub part: Option<What>,
}

/// A sum or product in words.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Total {
    /// Which of the two.
    pub op: BigOp,
    /// Where its phrase stands.
    pub phrase: Span,
    /// What is added up.
    pub body: Span,
    /// The range of its index: `i = 0..5`, or `i = 0` before its end.
    pub range: Span,
    /// The end of the range, if it is said apart.
    pub end: Option<Span>,
    /// The index, if it is said apart from its first value, which is the range then: i from 1 to n.
    pub index: Option<Span>,
}

/// Something said of the arguments.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Said {
    /// What it is said of.
    pub label: Label,
    /// What is said.
    pub what: What,
}

/// A formula, or a number in a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum What {
    /// Where the formula stands.
    Formula(Span),
    /// cubic
    Degree(i64),
    /// A basis, by the function that gives coefficients in it.
    Basis(&'static str),
    /// at the end
    Place(Place),
    /// closed
    Flag(&'static str, i64),
}

/// What the words of a text ask for; `None` if they are no request or some of them are not known.
///
/// A name that is `known` is no word, and `function` finds a function by its name. If it is `about` something that was
/// said before, a value may be all that is asked: value at 1/2. Cost: linear in the length of the text.
pub(crate) fn request(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
    about: bool,
) -> Option<Asked> {
    let (text, parts) = prepared(text, known, function, about)?;
    if parts.iter().any(|part| matches!(part, Part::Phrase(Phrase::Aside, _))) {
        return None;
    }
    let parts = meant::told(&text, parts, known)?;
    let mut reader = Reader { text: &text, parts, at: 0 };
    let asked = reader.asked()?;
    (reader.at == reader.parts.len()).then_some(asked)
}

/// The name whose value is missing at the end of a text: t in "derivative of t^3 at t", which "=" follows.
pub(crate) fn place_without_value<'a>(
    text: &'a str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
) -> Option<&'a str> {
    let name = text.split_whitespace().next_back()?;
    if !may_have_words(text) || !name.chars().all(char::is_alphabetic) || name.chars().nth(1).is_some() {
        return None;
    }
    let parts = parts(text, known, function);
    let at = |part: &Part| matches!(part, Part::Phrase(Phrase::Label(Label::At), _));
    matches!(parts.as_slice(), [.., label, Part::Piece(span)] if at(label) && text.piece(span.range()).trim() == name)
        .then_some(name)
}

/// A text without asides in brackets, and its parts, if their words are known and ask for something.
fn prepared(
    text: &str,
    known: &dyn Fn(&str) -> bool,
    function: &dyn Fn(&str) -> Option<&'static str>,
    about: bool,
) -> Option<(String, Vec<Part>)> {
    if !may_have_words(text) {
        return None;
    }
    let masked = without_text_commands(text);
    let text = without_asides(masked.as_ref(), known, function).into_owned();
    let parts = parts(&text, known, function);
    if !(asks::is_request(&text, &parts) || about && asks::is_about_something(&text, &parts)) {
        return None;
    }
    let unknown =
        |part: &Part| matches!(part, Part::Piece(span) if has_words(text.piece(span.range()), known));
    (!parts.iter().any(unknown)).then_some((text, parts))
}

/// Each knot as a place where it is inserted.
fn at_each(knots: &[Span]) -> Vec<Said> {
    knots.iter().map(|span| Said { label: Label::At, what: What::Formula(*span) }).collect()
}

struct Reader<'a> {
    text: &'a str,
    parts: Vec<Part>,
    at: usize,
}

impl Reader<'_> {
    fn next(&self) -> Option<Part> {
        self.parts.get(self.at).copied()
    }

    fn phrase(&self) -> Option<Phrase> {
        match self.next()? {
            Part::Phrase(phrase, _) => Some(phrase),
            Part::Piece(_) => None,
        }
    }

    fn take(&mut self, phrase: Phrase) -> bool {
        let found = self.phrase() == Some(phrase);
        self.at += usize::from(found);
        found
    }

    /// A formula or a function of something, and what is done with that.
    fn request(&mut self) -> Option<Request> {
        while self.take(Phrase::Of) {}
        // with Bernstein coefficients 1, 0, 1
        self.at += usize::from(self.leads_to_function());
        // at 2/3 of the Bézier curve 0, 1, 3; weights 1, 2, 1 and points 0, 1, 3
        let mut early = Vec::new();
        while matches!(
            self.phrase(),
            Some(Phrase::Label(Label::At | Label::Points | Label::Weights | Label::Knots))
        ) && !matches!(self.parts.get(self.at + 1), Some(Part::Phrase(Phrase::Of, _)))
            || self.at_points_of_curve()
            || self.at_points()
            || self.at_data()
            || !early.is_empty()
                && matches!(self.next(), Some(Part::Piece(span)) if begins_equation(self.text.piece(span.range())))
        {
            early.extend(self.said()?);
            while matches!(self.phrase(), Some(Phrase::Of | Phrase::And)) {
                self.at += 1;
            }
        }
        let mut request = match self.next() {
            None if !early.is_empty() => Request::Formula(Vec::new(), Vec::new()),
            // Bézier points 0, 4, 2 over [2, 4]
            Some(_) if !early.is_empty() && self.at_label() => Request::Formula(Vec::new(), Vec::new()),
            _ => self.subject()?,
        };
        if !early.is_empty() {
            request.labels()?.extend(early);
        }
        while let Some(next) = self.next() {
            match next {
                Part::Phrase(Phrase::Equals | Phrase::Takes | Phrase::Is, _) => break,
                // a spline with control points 0, 1, 3
                Part::Phrase(Phrase::Function(_), _) if self.at_points() => {
                    let said = self.said()?;
                    request.labels()?.extend(said);
                }
                // insert the knot 1: quadratic spline, knots …
                Part::Phrase(Phrase::Function("bspline" | "bspline_basis"), _)
                    if let Request::Call(Call { function: "insert_knots", subject, labels, .. }) =
                        &mut request
                        && let Some(Request::Formula(knots, _)) = subject.as_deref()
                        && !knots.is_empty() =>
                {
                    labels.extend(at_each(knots));
                    *subject = Some(Box::new(self.subject()?));
                }
                // t^2 in Bernstein form, u^3, blossom
                Part::Phrase(Phrase::Function(function) | Phrase::Command(function), phrase) => {
                    self.at += 1;
                    request = Request::Call(Call {
                        function,
                        phrase,
                        subject: Some(Box::new(request)),
                        labels: Vec::new(),
                        part: None,
                    });
                }
                // split bezier 0, 1, 4 at 1/2 and give the left part
                Part::Phrase(Phrase::Part(part, number), _)
                    if let Request::Call(Call { function, part: wanted @ None, .. }) = &mut request
                        && *function == part =>
                {
                    *wanted = Some(What::Degree(number));
                    self.at += 1;
                }
                // 7 choose 3
                Part::Phrase(Phrase::Between(function), phrase) => {
                    let (Request::Formula(mut spans, _), Some(Part::Piece(span))) =
                        (request, self.parts.get(self.at + 1).copied())
                    else {
                        return None;
                    };
                    self.at += 2;
                    spans.push(span);
                    if spans.iter().any(|span| is_sum(self.text.piece(span.range()))) {
                        return None;
                    }
                    let subject = Some(Box::new(Request::Formula(spans, Vec::new())));
                    request =
                        Request::Call(Call { function, phrase, subject, labels: Vec::new(), part: None });
                }
                // (t + 1)^5 coefficient of t^3
                Part::Phrase(Phrase::Of, _)
                    if let Request::Call(Call {
                        function: "coefficient",
                        subject: Some(subject),
                        labels,
                        ..
                    }) = &mut request
                        && let (Request::Formula(whole, _), Some(Part::Piece(monomial))) =
                            (subject.as_mut(), self.parts.get(self.at + 1)) =>
                {
                    let whole = std::mem::replace(whole, vec![*monomial]);
                    labels.extend(
                        whole.into_iter().map(|span| Said { label: Label::In, what: What::Formula(span) }),
                    );
                    self.at += 2;
                }
                // t^3 的导数
                Part::Phrase(Phrase::Of, _)
                    if !matches!(self.parts.get(self.at + 1), Some(Part::Piece(_))) =>
                {
                    self.at += 1;
                }
                // insert the knot 1/2 into bspline(…)
                Part::Phrase(Phrase::Label(Label::To | Label::In), _)
                    if let Request::Call(Call { function: "insert_knots", subject, labels, .. }) =
                        &mut request
                        && let Some(Request::Formula(knots, _)) = subject.as_deref()
                        && let Some(Part::Piece(spline)) = self.parts.get(self.at + 1)
                        && self.text.piece(spline.range()).contains("spline") =>
                {
                    let spline = *spline;
                    self.at += 2;
                    labels.extend(at_each(knots));
                    *subject = Some(Box::new(Request::Formula(vec![spline], Vec::new())));
                }
                // a product in the degree 5 Bernstein basis
                Part::Phrase(Phrase::Label(Label::To | Label::In), _)
                    if self.leads_to_form()
                        && (matches!(request, Request::Joined(..)) || !self.leads_to_function()) =>
                {
                    self.at += 1;
                    let mut labels = Vec::new();
                    while !matches!(self.phrase(), Some(Phrase::Function(_))) {
                        labels.extend(self.said()?);
                    }
                    let Some(Part::Phrase(Phrase::Function(function), phrase)) = self.next() else {
                        return None;
                    };
                    self.at += 1;
                    request = Request::Call(Call {
                        function,
                        phrase,
                        subject: Some(Box::new(request)),
                        labels,
                        part: None,
                    });
                }
                // insert the knot 1/2 into a spline
                Part::Phrase(Phrase::Label(Label::To | Label::In), _)
                    if let Request::Call(Call { function: "insert_knots", subject, labels, .. }) =
                        &mut request
                        && let Some(Request::Formula(knots, _)) = subject.as_deref()
                        && self.leads_to_qualified_function() =>
                {
                    self.at += 1;
                    labels.extend(at_each(knots));
                    *subject = Some(Box::new(self.subject()?));
                }
                Part::Phrase(Phrase::Label(_), _) if self.leads_to_function() => self.at += 1,
                _ => {
                    let said = self.said()?;
                    request.labels()?.extend(said);
                }
            }
        }
        Some(request)
    }

    /// A formula, or a function of something.
    fn subject(&mut self) -> Option<Request> {
        let mut labels = Vec::new();
        loop {
            let (label, number) = match self.phrase() {
                Some(Phrase::Degree(degree)) => (Label::OfDegree, degree),
                Some(Phrase::Ordinal(number)) => (Label::Times, number),
                Some(Phrase::Rational) => (Label::Rational, 1),
                Some(Phrase::Uniform) => (Label::Uniform, 1),
                // degree 2 spline
                Some(Phrase::Label(Label::OfDegree))
                    if let Some([Part::Piece(span), Part::Phrase(Phrase::Function(_), _)]) =
                        self.parts.get(self.at + 1..self.at + 3) =>
                {
                    labels.push(Said { label: Label::OfDegree, what: What::Formula(*span) });
                    self.at += 2;
                    continue;
                }
                _ => break,
            };
            labels.push(Said { label, what: What::Degree(number) });
            self.at += 1;
            // one step of Chaikin's scheme
            if label == Label::Times && self.take(Phrase::Label(Label::Times)) {
                while self.take(Phrase::Of) {}
            }
        }
        // a rational quadratic with points 0, 1, 3
        if !labels.is_empty() && matches!(self.phrase(), Some(Phrase::Label(_))) && self.at_label() {
            return Some(Request::Formula(Vec::new(), labels));
        }
        match self.next()? {
            Part::Piece(span) if labels.is_empty() => {
                self.at += 1;
                Some(Request::Formula(std::iter::once(span).chain(self.others()).collect(), Vec::new()))
            }
            // the cubic 0, 0, 8, 8
            Part::Piece(span) => {
                self.at += 1;
                Some(Request::Formula(vec![span], labels))
            }
            Part::Phrase(Phrase::Total(op), phrase) if labels.is_empty() => {
                self.at += 1;
                if let Some(call) = self.all_of_them(op) {
                    return Some(Request::Added(call));
                }
                match self.joined() {
                    Some((formulas, curves)) => Some(Request::Joined(op, formulas, curves)),
                    None => self.total(op, phrase).map(Request::Total),
                }
            }
            Part::Phrase(word, phrase) => {
                let of = matches!(self.parts.get(self.at + 1), Some(Part::Phrase(Phrase::Of, _)));
                let function = match word {
                    Phrase::Function(function) | Phrase::Command(function) | Phrase::Part(function, _) => {
                        function
                    }
                    // the degree of t^3, the knots of a spline
                    Phrase::Label(label) if of => label.function()?,
                    _ => return None,
                };
                self.at += 1;
                let part = match word {
                    Phrase::Part(_, number) => Some(What::Degree(number)),
                    _ => self.member().map(What::Formula),
                };
                self.bases(function, &mut labels);
                let subject = self.argument(&mut labels)?;
                Some(Request::Call(Call { function, phrase, subject: subject.map(Box::new), labels, part }))
            }
        }
    }

    /// The formulas that go on with "and".
    fn others(&mut self) -> Vec<Span> {
        let mut found = Vec::new();
        // the larger of 3/7 or 2/5
        let choice = |part: &Part| {
            matches!(part, Part::Phrase(Phrase::Command("max" | "min") | Phrase::Function("max" | "min"), _))
        };
        let or = self.parts.iter().any(choice);
        while (self.phrase() == Some(Phrase::And) || or && self.phrase() == Some(Phrase::Or))
            && let Some(Part::Piece(span)) = self.parts.get(self.at + 1)
        {
            found.push(*span);
            self.at += 2;
        }
        found
    }

    /// What a function is applied to: nothing if labels follow at once, which may also stand before it.
    fn argument(&mut self, labels: &mut Vec<Said>) -> Option<Option<Request>> {
        // 贝塞尔曲线的极形式 is the polar form of the curve
        if let [Part::Phrase(Phrase::Of, of), Part::Phrase(Phrase::Function(_), _), ..] =
            self.parts.get(self.at..).unwrap_or_default()
            && self.text.piece(of.range()) == "的"
        {
            return Some(None);
        }
        loop {
            while self.take(Phrase::Of) {}
            match self.next() {
                None | Some(Part::Phrase(Phrase::Equals | Phrase::Takes | Phrase::Is, _)) => {
                    return Some(None);
                }
                // bezier 0, 1, 3 at 1/2 and give the left part
                Some(Part::Phrase(Phrase::Part(..), _)) if !labels.is_empty() => return Some(None),
                // degree elevation twice: 1, 0, 1
                Some(Part::Phrase(Phrase::Ordinal(_), _)) => labels.extend(self.said()?),
                // with b0 = 1, b1 = 3
                Some(Part::Piece(span))
                    if !labels.is_empty() && begins_equation(self.text.piece(span.range())) =>
                {
                    labels.extend(self.said()?);
                }
                _ if self.at_label() => {
                    let count = labels.len();
                    // Degree 2 on 0, 1, 2; but: at 1/2 of t^3
                    labels.extend(self.said()?);
                    if count == labels.len() && self.at_label() {
                        continue;
                    }
                    while self.phrase() == Some(Phrase::And) {
                        self.at += 1;
                    }
                    let goes_on = |piece: Span| begins_equation(self.text.piece(piece.range()));
                    let more = matches!(self.next(), Some(Part::Piece(span)) if goes_on(span));
                    if !(more || self.phrase() == Some(Phrase::Of) || self.at_label()) {
                        // control points 0, 1, 3
                        return match self.next() {
                            None
                            | Some(Part::Phrase(
                                Phrase::Equals | Phrase::Takes | Phrase::Is | Phrase::Part(..),
                                _,
                            )) => Some(None),
                            // with coefficients 1, 0, 1 as a polynomial
                            Some(Part::Phrase(Phrase::Function(_), _)) if self.at + 1 == self.parts.len() => {
                                Some(None)
                            }
                            // with control points 0, 3, 3 twice
                            Some(Part::Phrase(Phrase::Ordinal(_), _)) => continue,
                            Some(_) => self.subject().map(Some),
                        };
                    }
                }
                Some(_) => return self.subject().map(Some),
            }
        }
    }

    /// What a label says; several equations are several things. A label before another one says nothing.
    fn said(&mut self) -> Option<Vec<Said>> {
        let label = match self.next()? {
            Part::Phrase(Phrase::Label(label), _) => label,
            Part::Phrase(Phrase::Function(_), _) if self.at_points() => Label::Points,
            // von 0 bis 1
            Part::Phrase(Phrase::Of, _)
                if matches!(
                    self.parts.get(self.at + 1..self.at + 3),
                    Some([Part::Piece(_), Part::Phrase(Phrase::Label(Label::To), _)])
                ) =>
            {
                Label::From
            }
            Part::Phrase(Phrase::And | Phrase::Of, _) => {
                self.at += 1;
                return Some(Vec::new());
            }
            Part::Phrase(Phrase::Degree(degree), _) => {
                self.at += 1;
                return Some(vec![Said { label: Label::OfDegree, what: What::Degree(degree) }]);
            }
            Part::Phrase(Phrase::Place(place), _) => {
                self.at += 1;
                return Some(vec![Said { label: Label::At, what: What::Place(place) }]);
            }
            Part::Phrase(Phrase::Uniform, _) => {
                self.at += 1;
                return Some(vec![Said { label: Label::Uniform, what: What::Degree(1) }]);
            }
            Part::Phrase(Phrase::Flag(name, value), _) => {
                self.at += 1;
                return Some(vec![Said { label: Label::With, what: What::Flag(name, value) }]);
            }
            Part::Phrase(Phrase::Ordinal(number), _) => {
                self.at += 1;
                // one step
                self.take(Phrase::Label(Label::Times));
                return Some(vec![Said { label: Label::Times, what: What::Degree(number) }]);
            }
            // bezier 0, 1, 4, t = 1/2
            Part::Piece(span)
                if self.text.piece(span.range()).contains('=')
                    || begins_equation(self.text.piece(span.range())) =>
            {
                self.at += 1;
                return Some(vec![Said { label: Label::With, what: What::Formula(span) }]);
            }
            _ => return None,
        };
        self.at += 1;
        // Marsden's identity: coefficients of t^2
        if label == Label::Points && self.phrase() == Some(Phrase::Of) {
            return Some(Vec::new());
        }
        while self.take(Phrase::Of) {}
        match self.next()? {
            // between 0 and 1
            Part::Piece(from)
                if label == Label::From
                    && let Some([Part::Phrase(Phrase::And, _), Part::Piece(to)]) =
                        self.parts.get(self.at + 1..self.at + 3) =>
            {
                let to = Said { label: Label::To, what: What::Formula(*to) };
                self.at += 3;
                Some(vec![Said { label, what: What::Formula(from) }, to])
            }
            Part::Piece(span) => {
                self.at += 1;
                // with 3 times, in 3 times
                let label = match self.phrase() {
                    Some(Phrase::Label(Label::Times)) => {
                        self.at += 1;
                        Label::Times
                    }
                    _ => label,
                };
                // at 1/2 and 3/4; with control points 1, 3, 2 and t = 1/3
                let equation = |span: Span| begins_equation(self.text.piece(span.range()));
                let other = matches!(self.parts.get(self.at..self.at + 2),
                    Some([Part::Phrase(Phrase::And, _), Part::Piece(next)]) if equation(*next) && !equation(span));
                let others = if other { Vec::new() } else { self.others() };
                let all = std::iter::once(span).chain(others);
                Some(all.map(|span| Said { label, what: What::Formula(span) }).collect())
            }
            // to a cubic
            Part::Phrase(Phrase::Degree(degree), _)
                if label == Label::To
                    && !matches!(self.parts.get(self.at + 1), Some(Part::Phrase(Phrase::Function(_), _))) =>
            {
                self.at += 1;
                Some(vec![Said { label, what: What::Degree(degree) }])
            }
            Part::Phrase(
                Phrase::Label(_)
                | Phrase::Degree(_)
                | Phrase::Ordinal(_)
                | Phrase::Flag(..)
                | Phrase::Place(_),
                _,
            ) => Some(Vec::new()),
            // for the control points 0, 1
            Part::Phrase(..) if self.at_points() => Some(Vec::new()),
            Part::Phrase(..) => None,
        }
    }
}
