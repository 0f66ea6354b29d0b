//! Requests in words as calls of functions: `derivative of t^3 at t = 2` is `subs(derivative(t^3), t=2)`.
//!
//! What is said of the arguments goes to the innermost function that has such a parameter; values that no function takes
//! are put into the result. Calls by names that other programs may have are requests, too (`habits`).

mod applied;
mod apposition;
mod bound;
mod draft;
mod habits;
mod knots;
mod laws;
mod lists;
mod loosely;
mod notations;
mod objects;
mod reading;
mod senses;
mod taking;
mod utterance;
mod values;

use self::draft::Draft;
use self::utterance::Utterance;
use self::values::{Nature, Values, has_values, is_in_t, value_of};
use std::cell::Cell;

use super::{Failure, Session, defines};
use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel, applied, call, named};
use crate::language::diagnostic::{Code, Diagnostic, NO_DEGREE, NO_PLACE};
use crate::language::eval::{self, Equals, Outcome};
use crate::language::functions::{Gives, Takes, builtin, function_in_words};
use crate::language::lexicon::phrases::{Label, Place};
use crate::language::lexicon::{fractions, roles, wanted};
use crate::language::syntax::{self, Asked, Call, Request, Said, What};
use crate::language::value::{Value, symbol_expr};
use crate::math::poly::Symbol;

/// How the note begins that numbers are read as a curve.
const KINDS_NOTE: &str = "read as the curve bezier([";

/// Something that a label says, read.
#[derive(Clone)]
struct Read {
    label: Label,
    items: Vec<Expr>,
}

impl Session {
    /// The formula that a request in words stands for; `None` if it is none, or says what no function takes.
    pub(super) fn spoken(&self, file: &SourceFile, whole: Span) -> Result<Option<Expr>, Box<Failure>> {
        self.spoken_about(file, whole, None).map(|found| found.map(|(formula, _)| formula))
    }

    /// The same, where data alone describe a curve: b0 = 1, b1 = 3, b2 = 1.
    pub(super) fn spoken_data(&self, file: &SourceFile, whole: Span) -> Option<Expr> {
        self.spoken_as(file, whole, None, true).ok().flatten().map(|(formula, _)| formula)
    }

    /// The same, where a name is known that all is about: F(t) = t^2, what is its derivative? Tells whether it was needed.
    pub(super) fn spoken_about(
        &self,
        file: &SourceFile,
        whole: Span,
        topic: Option<&Expr>,
    ) -> Result<Option<(Expr, bool)>, Box<Failure>> {
        self.spoken_as(file, whole, topic, topic.is_some())
    }

    /// What is wrong with "derivative of t^3 at t =", of which the text before the sign is given.
    pub(super) fn lacks_value(&self, text: &str, sign: Span) -> Option<Diagnostic> {
        let known = |word: &str| defines(&self.env, word);
        let name = syntax::place_without_value(text, &known, &function_in_words)?;
        let problem = Diagnostic::error(Code::Usage, "nothing stands after '='").at(sign);
        Some(problem.hint(format!("write the value of {name} there: {name} = 1/2")))
    }

    fn spoken_as(
        &self,
        file: &SourceFile,
        whole: Span,
        topic: Option<&Expr>,
        about: bool,
    ) -> Result<Option<(Expr, bool)>, Box<Failure>> {
        if topic.is_none() && wanted::is_of_another(file.slice(whole)) {
            return Ok(None);
        }
        // at one third
        let masked = fractions::with_digits(file.slice(whole)).map(|text| {
            let mut all = file.text().to_owned();
            all.replace_range(whole.range(), &text);
            SourceFile::new(file.name(), all)
        });
        let file = masked.as_ref().unwrap_or(file);
        let known = |word: &str| defines(&self.env, word);
        let Some(asked) = syntax::request(file.slice(whole), &known, &function_in_words, about) else {
            return Ok(None);
        };
        let reader = Reader { session: self, file, start: whole.start, topic, used_topic: Cell::new(false) };
        let formula = reader.formula(asked)?;
        Ok(formula.map(|formula| (formula, reader.used_topic.get())))
    }
}

/// A formula with a list for its notations, such as knots for N_{i,n}; `None` if it has none of them.
pub(super) fn with_list(formula: &Expr, label: Label, items: &[Expr]) -> Option<Expr> {
    let mut said = vec![Read { label, items: items.to_vec() }];
    notations::with_values(formula, &mut said).map(|read| read.formula)
}

struct Reader<'a> {
    session: &'a Session,
    file: &'a SourceFile,
    start: usize,
    /// What the line is about, for words such as "its".
    topic: Option<&'a Expr>,
    used_topic: Cell<bool>,
}

impl Reader<'_> {
    fn formula(&self, Asked { request, equals }: Asked) -> Result<Option<Expr>, Box<Failure>> {
        // u v is a product here, no list.
        let claimed = match equals {
            Some(What::Formula(span)) => Some(self.with_products(self.one(span)?)),
            Some(What::Degree(number)) => Some(Expr::int(number)),
            _ => None,
        };
        let Some(mut asked) = self.collected(request)? else { return Ok(None) };
        if let Some(laws) = self.laws_of(&asked) {
            return Ok(Some(laws));
        }
        if let Some(laws) = claimed.as_ref().and_then(|claimed| apposition::is_polar(claimed, &asked)) {
            return Ok(Some(laws));
        }
        let variables = |of: &Expr| self.variables(of).iter().map(symbol_expr).collect();
        if let Some(claim) =
            claimed.as_ref().and_then(|claimed| apposition::is_polar_of(claimed, &asked, &variables))
        {
            return Ok(Some(claim));
        }
        if let Some(laws) = claimed.as_ref().and_then(|claimed| self.is_form_of(claimed, &asked)) {
            return Ok(Some(laws));
        }
        if let Some(problem) = self.of_polygon(&asked) {
            return Err(self.fail(problem));
        }
        apposition::meets_points(&asked.drafts, asked.through).map_err(|problem| self.fail(problem))?;
        self.only_basis_function(&mut asked);
        asked.settle();
        apposition::has_rows(&asked.drafts, &asked.items).map_err(|problem| self.fail(problem))?;
        if let Some(whole) = asked.whole() {
            return Ok(Some(whole));
        }
        asked.put_into_notations();
        if asked.formula.is_none() {
            if asked.drafts.is_empty()
                && asked.items.is_empty()
                && asked.said.iter().all(|read| read.label == Label::At)
                && let Some(topic) = self.topic
            {
                self.used_topic.set(true);
                asked.items.push(topic.clone());
            }
            // compute 3 + 4
            if asked.drafts.is_empty() {
                if let ([one], [Read { label: Label::Times, items }]) =
                    (asked.items.as_slice(), asked.said.as_slice())
                    && let [count] = items.as_slice()
                {
                    return Ok(applied::repeated(one, count));
                }
                return Ok(match (asked.items.as_slice(), asked.said.as_slice()) {
                    ([one], []) => Some(match claimed {
                        Some(right) => equation(one.clone(), right),
                        None => one.clone(),
                    }),
                    ([one], [read]) if claimed.is_some() => {
                        self.value_at(one, read).and_then(|value| Some(equation(value, claimed?)))
                    }
                    ([one], [read]) => self.value_at(one, read).or_else(|| {
                        self.values_at(one, std::slice::from_ref(read)).filter(|_| read.label == Label::At)
                    }),
                    // t^2 at 2 and at 3
                    ([one], reads)
                        if claimed.is_none() && reads.iter().all(|read| read.label == Label::At) =>
                    {
                        self.values_at(one, reads)
                    }
                    _ => None,
                });
            }
            // the Newton form for 1, 3, 11 at 0, 1, 2
            let of_data =
                |draft: &Draft| matches!(draft.builtin.name, "newton" | "lagrange" | "divided_differences");
            if asked.items.is_empty()
                && asked.drafts.iter().any(of_data)
                && let [Read { label: Label::With, items }, Read { label: Label::At, .. }] =
                    asked.said.as_slice()
                && items.len() > 1
            {
                asked.items = asked.said.remove(0).items;
            }
            if let [innermost] = asked.drafts.as_slice()
                && let Some((meant, used)) =
                    apposition::meant(innermost, &asked.items, &asked.said, &self.session.env, self.topic)
            {
                self.used_topic.set(self.topic.is_some());
                asked.said.drain(..used);
                asked.formula = Some(meant);
                asked.drafts.clear();
                return self.assembled(asked, claimed);
            }
        }
        if let Some(diagonal) = self.on_diagonal(&asked)? {
            return Ok(Some(diagonal));
        }
        apposition::letters_of_polar(&asked.drafts, &mut asked.said);
        self.find_subject(&mut asked);
        self.in_sense_of_object(&mut asked);
        if let Some(area) = self.area_under_curve(&asked) {
            return Ok(Some(area));
        }
        if let Some(difference) = self.divided_difference(&asked) {
            return Ok(Some(difference));
        }
        self.name_variables(&mut asked);
        if !asked.apply_innermost() {
            return Ok(None);
        }
        let several = asked.said.iter().filter(|read| read.label == Label::OfDegree).count() > 1;
        let copy = several.then(|| asked.clone());
        let failure = match self.assembled(asked, claimed.clone()) {
            Err(failure) => failure,
            assembled => return assembled,
        };
        match copy.and_then(|copy| self.for_each_degree(&copy)) {
            Some(all) if claimed.is_none() => Ok(Some(all)),
            _ => Err(failure),
        }
    }

    /// A result for each of several degrees: the Bernstein coefficients of t^2 for degree 2 and degree 3.
    fn for_each_degree(&self, asked: &Utterance) -> Option<Expr> {
        let is_degree = |read: &Read| read.label == Label::OfDegree;
        let (degrees, others): (Vec<Read>, Vec<Read>) = asked.said.iter().cloned().partition(is_degree);
        let mut asked = asked.clone();
        // Of a list each item is arranged as usual, so the coefficients are wanted.
        if let [Draft { builtin: own, .. }] = asked.drafts.as_mut_slice()
            && own.name == "in_bernstein"
        {
            *own = builtin("bezier_points")?;
        }
        let of_one = |degree: Read| {
            let said = others.iter().cloned().chain([degree]).collect();
            self.assembled(Utterance { said, ..asked.clone() }, None).ok().flatten()
        };
        degrees.into_iter().map(of_one).collect::<Option<Vec<_>>>().map(draft::list)
    }

    /// What a request says, read: its functions from the outermost to the innermost, their object and what is said besides.
    fn collected(&self, request: Request) -> Result<Option<Utterance>, Box<Failure>> {
        let mut asked = Utterance::default();
        let mut rest = Some(Box::new(request));
        while let Some(request) = rest.take() {
            let (labels, phrase) = match *request {
                Request::Call(Call { function, phrase, subject, labels, part }) => {
                    let Some(builtin) = builtin(function) else { return Ok(None) };
                    let phrase = phrase.shifted(self.start);
                    let mut draft = Draft::new(builtin, phrase);
                    draft.part = match part {
                        Some(What::Formula(span)) => Some(self.one(span)?),
                        Some(What::Degree(number)) => Some(Expr { span: phrase, ..Expr::int(number) }),
                        _ => None,
                    };
                    draft.take_words(&self.file.slice(phrase).to_lowercase());
                    asked.drafts.push(draft);
                    rest = subject;
                    (labels, phrase)
                }
                Request::Formula(spans, labels) => {
                    let polar = asked.drafts.last().is_some_and(|draft| draft.builtin.name == "polar");
                    let of_form = |draft: &Draft| matches!(draft.builtin.name, "laws" | "diagonal");
                    let form = asked.drafts.last().is_some_and(of_form);
                    let of_formula = asked.drafts.last().is_some_and(Draft::is_of_a_formula);
                    for span in spans {
                        // u v is a product here, no list.
                        if form || of_formula && lists::is_product(self.file.slice(span.shifted(self.start)))
                        {
                            asked.items.push(self.with_products(self.one(span)?));
                            continue;
                        }
                        match self.in_brackets(span).filter(|_| polar) {
                            Some(value) => asked.items.push(value?),
                            None => asked.items.extend(self.items(span)?),
                        }
                    }
                    (labels, Span::default())
                }
                Request::Curves(curves) => {
                    let Some(curves) = self.curves(curves)? else { return Ok(None) };
                    asked.items.extend(curves);
                    (Vec::new(), Span::default())
                }
                Request::Joined(op, spans, curves) => {
                    let Some(joined) = self.joined(op, spans, curves)? else { return Ok(None) };
                    asked.items.push(joined);
                    (Vec::new(), Span::default())
                }
                Request::Count(count) => {
                    asked.items.push(self.count(&count)?);
                    (Vec::new(), Span::default())
                }
                Request::Added(own) => {
                    let whole = Asked { request: Request::Call(own), equals: None };
                    let Some(functions) = self.formula(whole)? else { return Ok(None) };
                    let span = functions.span;
                    asked.items.push(call("sum", vec![functions], span));
                    (Vec::new(), Span::default())
                }
                Request::Total(total) => {
                    asked.items.push(self.total(&total)?);
                    (Vec::new(), Span::default())
                }
            };
            for Said { label, what } in labels {
                let items = match what {
                    What::Formula(span) => self.items(span)?,
                    What::Degree(degree) => vec![Expr { span: phrase, ..Expr::int(degree) }],
                    What::Place(place) => {
                        asked.places.push(place);
                        continue;
                    }
                    What::Flag(name, value) => {
                        asked.flags.push((name, Expr { span: phrase, ..Expr::int(value) }));
                        continue;
                    }
                    What::Basis(function) => match basis_of(function) {
                        Some(basis) => vec![Expr { span: phrase, ..Expr::name(basis) }],
                        None => return Ok(None),
                    },
                };
                let polar = asked.drafts.iter().any(|draft| draft.builtin.name.starts_with("polar"));
                asked.hear(label, lists::assigned(items, polar));
            }
        }
        // the left half of 0, 2, 6
        let half = |draft: &Draft| {
            let phrase = self.file.slice(draft.phrase).to_lowercase();
            draft.part.is_some()
                && ["half", "hälfte", "moitié", "mitad", "metà"].iter().any(|own| phrase.contains(own))
        };
        if asked.drafts.iter().any(half) && !asked.has_place() {
            asked.places.push(Place::Middle);
        }
        Ok(Some(asked))
    }

    /// Finds what the innermost function is about, if no formula stands behind it.
    fn find_subject(&self, asked: &mut Utterance) {
        let (None, Some(innermost)) = (&asked.formula, asked.drafts.first_mut()) else { return };
        if asked.items.is_empty() {
            asked.items = innermost.subject_among(&mut asked.said);
        }
        // F(t) = t^2, what is its derivative?
        if asked.items.is_empty()
            && innermost.placed.is_empty()
            && let Some(name) = self.topic
        {
            self.used_topic.set(true);
            let topic = Expr { span: innermost.phrase, ..name.clone() };
            // What words describe is inside of the functions as any other object.
            match &name.kind {
                Kind::Name(_) => asked.items.push(topic),
                _ => {
                    asked.formula = Some(topic);
                    return;
                }
            }
        }
        if innermost.wants_curve(&asked.items)
            && let Some(bezier) = builtin("bezier")
        {
            let phrase = innermost.phrase;
            asked.drafts.insert(0, Draft::new(bezier, phrase));
        }
    }

    /// The letters of the tensor polar form of u^2 v.
    fn name_variables(&self, asked: &mut Utterance) {
        if let ([Draft { builtin, .. }], [of]) = (asked.drafts.as_slice(), asked.items.as_slice())
            && builtin.name == "polar_tensor"
            && let [u, v] = self.variables(of).as_slice()
        {
            let span = of.span;
            asked.items.extend([u, v].map(|letter| Expr { span, ..symbol_expr(letter) }));
        }
    }

    /// The calls, one in another, with what is said put where it belongs.
    fn assembled(&self, asked: Utterance, mut claimed: Option<Expr>) -> Result<Option<Expr>, Box<Failure>> {
        let Utterance { mut drafts, mut said, mut formula, flags, .. } = asked;
        for (name, value) in flags {
            let takes = |draft: &&mut Draft| {
                draft.builtin.parameters.iter().any(|own| own.name == name && own.kind == Takes::Flag)
            };
            let Some(draft) = drafts.iter_mut().find(takes) else { return Ok(None) };
            draft.named.push((name, value));
        }
        // Whether there are weights is known after all the others.
        said.sort_by_key(|read| read.label == Label::Rational);
        let mut after = Vec::new();
        for read in said {
            self.is_of_one(&read, &drafts)?;
            let mut left = Some(read);
            // What is solved for, before variables of what is solved; the part that is wanted, before the interval.
            let (first, others): (Vec<_>, Vec<_>) = drafts
                .iter_mut()
                .partition(|draft| draft.builtin.on_equations.is_some() || draft.needs_ends());
            for draft in first.into_iter().chain(others) {
                left = left.and_then(|read| draft.take(read));
            }
            after.extend(left);
        }
        let mut values = Values(after);
        let forms: Vec<String> = drafts.iter().map(|draft| draft.builtin.signature()).collect();
        let number = |formula: &Expr| self.nature(formula);
        for draft in drafts {
            // What is solved has its values before: solve for a: f(1, 2) equals 3
            if draft.builtin.on_equations.is_some()
                && let Some(left) = formula.take()
            {
                let left = values.put_into(left, &number).map_err(|left| self.unused(&left, &forms))?;
                formula =
                    Some(claimed.take().map_or_else(|| left.clone(), |right| equation(left.clone(), right)));
            }
            formula = draft.applied_to(formula);
            if formula.is_none() {
                return Ok(None);
            }
        }
        let Some(formula) = formula else { return Ok(None) };
        let formula = values.put_into(formula, &number).map_err(|left| self.unused(&left, &forms))?;
        Ok(Some(match claimed {
            Some(right) => equation(formula, right),
            None => formula,
        }))
    }

    fn fail(&self, problem: Diagnostic) -> Box<Failure> {
        Box::new(Failure { problem, file: self.file.clone() })
    }

    /// A formula at what stands behind "at" or "for": a function called, or values put in for names.
    fn value_at(&self, formula: &Expr, read: &Read) -> Option<Expr> {
        let equations = read.items.iter().all(|item| eval::named(item).is_some());
        let claim = |expr: &Expr| matches!(expr.kind, Kind::Chain(..) | Kind::Name(_));
        if claim(formula) || !equations && (read.label != Label::At || read.items.iter().any(claim)) {
            return None;
        }
        if equations {
            return value_of(formula, read, &|_| Nature::Other);
        }
        let outcome = self.session.clone().evaluate(&mut formula.clone(), Equals::Claims).ok()?;
        let span = formula.span;
        match (&outcome.value, read.items.as_slice()) {
            (Value::Scalar(value), [at]) => match value.variables().as_slice() {
                [variable] => {
                    let value = named(&variable.to_string(), at.clone());
                    Some(call("subs", vec![formula.clone(), value], span))
                }
                // x y^2 at (2, 1)
                variables => {
                    let Kind::Tuple(values) = &at.kind else { return None };
                    let usual =
                        variables.iter().all(|name| name.is_plain() && roles::is_variable(name.base()));
                    let values = variables
                        .iter()
                        .zip(values)
                        .map(|(name, value)| named(&name.to_string(), value.clone()));
                    (usual && at.items().is_some_and(|items| items.len() == variables.len()))
                        .then(|| call("subs", std::iter::once(formula.clone()).chain(values).collect(), span))
                }
            },
            (Value::Geometry(_) | Value::Piecewise(_) | Value::Polar(_) | Value::Function(_), _) => {
                value_of(formula, read, &|_| Nature::Other)
            }
            _ => None,
        }
    }

    /// A formula at several places: t^2 at 1, 2 and 3.
    fn values_at(&self, formula: &Expr, reads: &[Read]) -> Option<Expr> {
        let items: Vec<&Expr> = reads.iter().flat_map(|read| &read.items).collect();
        let decimal = items.windows(2).any(|pair| eval::is_decimal_comma(pair[0], pair[1]));
        let at =
            |item: &&Expr| self.value_at(formula, &Read { label: Label::At, items: vec![(*item).clone()] });
        let found = items.iter().map(at).collect::<Option<Vec<_>>>()?;
        (found.len() > 1 && !decimal).then(|| draft::list(found))
    }

    /// The symbols in the value of a formula.
    fn variables(&self, formula: &Expr) -> Vec<Symbol> {
        match self.session.clone().evaluate(&mut formula.clone(), Equals::Claims) {
            Ok(Outcome { value: Value::Scalar(formula), .. }) => formula.variables(),
            _ => Vec::new(),
        }
    }

    /// The error for something that is said and that nothing takes.
    fn unused(&self, left: &Read, forms: &[String]) -> Box<Failure> {
        let place = left.items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default();
        let (message, reason) = match left.label {
            Label::OfDegree => (NO_DEGREE, "another degree, or another number of points"),
            Label::Rational => ("weights are missing", "a rational curve has a weight for each point"),
            _ => (NO_PLACE, "what is asked for does not depend on it"),
        };
        let problem = Diagnostic::error(Code::Usage, message).at(place).reason(reason);
        let problem = forms.iter().fold(problem, |problem, form| problem.hint(format!("the form is {form}")));
        Box::new(Failure { problem, file: self.file.clone() })
    }

    /// Refuses an interval that may be that of a curve or that of what is asked about it.
    fn is_of_one(&self, read: &Read, drafts: &[Draft]) -> Result<(), Box<Failure>> {
        let [curve, rest @ ..] = drafts else { return Ok(()) };
        let asked = rest.iter().find(|draft| draft.has_ends());
        let ends = match read.items.as_slice() {
            [Expr { kind: Kind::List(ends) | Kind::Tuple(ends), .. }] => ends,
            items => items,
        };
        let unit = matches!(ends, [a, b] if a.as_int() == Some(0) && b.as_int() == Some(1));
        let (Label::Over, "bezier", Some(asked), false) = (read.label, curve.builtin.name, asked, unit)
        else {
            return Ok(());
        };
        let function = asked.builtin.name;
        let problem = Diagnostic::error(Code::Usage, format!("the interval of the curve, or of {function}?"))
            .at(read.items.iter().map(|item| item.span).reduce(Span::to).unwrap_or_default())
            .reason("two functions take an interval")
            .hint(format!("of the curve: {function}(bezier([0, 1, 1], 0, 2))"))
            .hint(format!("of {function}: {function}(bezier([0, 1, 1]), a=0, b=1/2)"));
        Err(Box::new(Failure { problem, file: self.file.clone() }))
    }

    /// What a result is, as to its values: the degree of t^3 has none at 2.
    fn nature(&self, formula: &Expr) -> Nature {
        let function = match &formula.kind {
            Kind::Apply(callee, _) => match &callee.kind {
                Kind::Name(name) => builtin(name),
                _ => None,
            },
            _ => None,
        };
        if function.is_some_and(|function| {
            function.gives == Gives::Function && !matches!(function.name, "derivative" | "bernstein")
        }) {
            return Nature::Other;
        }
        match self.session.clone().evaluate(&mut formula.clone(), Equals::Claims) {
            Ok(outcome) if outcome.value.as_rational().is_some() => match function {
                Some(function) if function.gives == Gives::Function => Nature::Other,
                _ => Nature::Number,
            },
            Ok(Outcome { value: Value::Geometry(geometry), .. }) if !geometry.is_surface() => Nature::OfOne,
            Ok(Outcome { value: Value::Piecewise(_), .. }) => Nature::OfOne,
            Ok(Outcome { value: Value::List(items), .. })
                if !items.is_empty() && items.iter().all(has_values) =>
            {
                Nature::Several
            }
            Ok(Outcome { value: Value::List(items), .. })
                if !items.is_empty() && items.iter().all(is_in_t) =>
            {
                Nature::Formulas
            }
            Ok(Outcome { value: Value::Scalar(formula), .. }) if formula.variables().len() == 1 => {
                Nature::OfOne
            }
            _ => Nature::Other,
        }
    }
}

/// What a basis is called in which a function gives coefficients.
fn basis_of(function: &str) -> Option<&'static str> {
    Some(match function {
        "in_bernstein" | "bernstein" | "bezier" => "bernstein",
        "expand" | "in_powers" | "power" => "power",
        _ => return None,
    })
}

/// A sum in parentheses.
fn one_term(expr: Expr) -> Expr {
    let span = expr.span;
    match expr.kind {
        Kind::Add(_) => Expr { span, ..expr.grouped() },
        _ => expr,
    }
}

/// That a result is what is claimed; a polar form without arguments is meant at the letters of the claim.
fn equation(left: Expr, right: Expr) -> Expr {
    let polar = matches!(&left.kind, Kind::Apply(callee, _)
        if matches!(&callee.kind, Kind::Name(name) if name == "polar"));
    let span = left.span.to(right.span);
    let left = match lists::letters(&right, &left) {
        letters if polar && !letters.is_empty() => {
            // (t1 + t2)/2 is the polar form of t for the degree 2.
            let mut form = left;
            if let Kind::Apply(_, groups) = &mut form.kind
                && let [arguments] = groups.as_mut_slice()
                && arguments.len() == 1
            {
                let count = i64::try_from(letters.len()).unwrap_or(i64::MAX);
                arguments.push(named("degree", Expr { span, ..Expr::int(count) }));
            }
            applied(form, letters, span)
        }
        _ => left,
    };
    Expr { span, ..Expr::relation(left, Rel::Eq, right) }
}
