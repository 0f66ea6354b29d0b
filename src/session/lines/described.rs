//! An object that words describe, and then questions about it: `quadratic spline, knots 0, 0, 0, 1, 1, 1, control points 1, 2, 4;
//! s(1/3) = ?`, `the blossom of t^2 and its value at (1, 2)`.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind, Rel, call};
use crate::language::diagnostic::Code;
use crate::language::eval::{Equals, Outcome};
use crate::language::functions::function_called;
use crate::language::lexicon::{asking, wanted};
use crate::language::syntax;
use crate::language::value::Value;
use crate::session::{Answer, Failure, Session, defines};

/// A question about an object: the formula that answers it, and where it stands.
pub(in crate::session) type Question = (Expr, Span);

/// At how many places a text is cut at most.
const PLACES: usize = 12;

/// How many questions one object may have.
const MOST: usize = 4;

impl Session {
    /// Answers what is asked about an object that words describe; `None` if the text is something else.
    pub(in crate::session) fn run_described(
        &mut self,
        file: &SourceFile,
        whole: Span,
        equals: Equals,
    ) -> Result<Option<Vec<Answer>>, Box<Failure>> {
        let Some(questions) = self.described(file, whole) else { return Ok(None) };
        let mut answers = Vec::new();
        for (formula, place) in questions {
            answers.push(self.evaluated_as(file, formula, place, equals)?);
        }
        Ok(Some(answers))
    }

    /// The questions about an object that words describe before them.
    pub(in crate::session) fn described(&self, file: &SourceFile, whole: Span) -> Option<Vec<Question>> {
        let text = file.slice(whole);
        if !text.contains(char::is_alphabetic) {
            return None;
        }
        let stops = syntax::continuations(text).into_iter().filter_map(|found| {
            let rest = found.rest(text)?;
            // No item of a list.
            let asks = text.get(rest.start..)?.starts_with(char::is_alphabetic);
            asks.then_some((found, rest))
        });
        let behind = stops.take(PLACES).find_map(|(found, rest)| {
            let rest = rest.shifted(whole.start);
            let (object, name) = self.object(file, Span::new(whole.start, whole.start + found.end))?;
            self.questions(file, rest, &object, name.as_deref(), MOST)
        });
        // B(1/2) for the Bézier curve 0, 3, 0
        behind.or_else(|| {
            wanted::of_objects(text).into_iter().take(PLACES).find_map(|(end, start)| {
                let (object, name) = self.object(file, Span::new(whole.start + start, whole.end))?;
                let asked = Span::new(whole.start, whole.start + end);
                let letter = self.question(file, asked, &object, name.as_deref(), true)?;
                Some(vec![letter])
            })
        })
    }

    /// The same, where the answer to the description is asked for, too: the polar form of t^3 and its value at (0, 1, 2).
    pub(in crate::session) fn described_and_asked(
        &self,
        file: &SourceFile,
        whole: Span,
    ) -> Option<Vec<Question>> {
        let text = file.slice(whole);
        let (end, start) = wanted::and_its(text)?;
        let head = Span::new(whole.start, whole.start + end);
        let (object, _) = self.object(file, head)?;
        let rest = Span::new(whole.start + start, whole.end);
        let mut questions = self.questions(file, rest, &object, None, MOST)?;
        questions.insert(0, (object, head));
        Some(questions)
    }

    /// What words describe, if it is something of which there are values, and the name it is given.
    fn object(&self, file: &SourceFile, head: Span) -> Option<(Expr, Option<String>)> {
        let text = file.slice(head);
        // the cubic F has the points 0, 1, 3, 2
        if let Some(letter) = syntax::letter_of_object(text, &function_called)
            && let name = text.get(letter.range())?.trim_matches('$').to_owned()
            && !defines(&self.env, &name)
        {
            let mut masked = file.text().to_owned();
            masked.replace_range(letter.shifted(head.start).range(), &" ".repeat(letter.len()));
            let (object, _) = self.object(&SourceFile::new(file.name(), masked), head)?;
            return Some((object, Some(name)));
        }
        let (body, name) = match (self.named_with_is(text), syntax::clause(text)) {
            (Some((name, start)), _) => (Span::new(head.start + start, head.end), Some(name)),
            (None, Some(clause)) if !defines(&self.env, clause.name) => {
                (clause.rest.shifted(head.start), Some(clause.name.to_owned()))
            }
            _ => (Span::new(head.start + syntax::after_introduction(text), head.end), None),
        };
        let spoken = self.spoken_data(file, body).map(of_its_points);
        let has = spoken.as_ref().map(|object| self.has_values(object));
        let defined = || self.defined(file, head).filter(|object| self.has_values(object) == Some(true));
        let object = match has {
            Some(Some(true)) => spoken,
            // What is wrong with the object is told as the answer.
            Some(None) => defined().or(spoken),
            _ => defined(),
        };
        Some((object?, name))
    }

    /// Whether a formula gives something of which there are values; `None` if something is wrong with it. What is missing may
    /// stand behind it.
    fn has_values(&self, object: &Expr) -> Option<bool> {
        match &self.clone().evaluate(&mut object.clone(), Equals::Claims) {
            Ok(Outcome { value, .. }) => Some(match value {
                Value::Scalar(formula) => formula.variables().len() == 1,
                Value::Geometry(_) | Value::Piecewise(_) | Value::Polar(_) | Value::Function(_) => true,
                Value::List(_) => true,
                _ => false,
            }),
            Err(problem) => (problem.code == Code::Arity).then_some(false),
        }
    }

    /// The formula of a function of one variable that is defined, by a formula or by conditions, or the polar form that
    /// conditions determine: F(t) = t^2.
    fn defined(&self, file: &SourceFile, head: Span) -> Option<Expr> {
        let formula = |statement: &Expr| {
            let Kind::Chain(left, links) = &statement.kind else { return None };
            let ([link], Kind::Apply(callee, groups)) = (links.as_slice(), &left.kind) else { return None };
            let variable = matches!(groups.as_slice(), [one] if matches!(one.as_slice(),
                [Expr { kind: Kind::Name(_), .. }]));
            let free = matches!(&callee.kind, Kind::Name(name) if !defines(&self.env, name));
            let defines = matches!(link.rel, Rel::Eq | Rel::Define);
            (variable && free && defines).then(|| link.expr.clone().grouped())
        };
        if let Some(found) = self.read(file, head).ok().as_ref().and_then(formula) {
            return Some(found);
        }
        let answers = self.clone().run_unknown(file, head, Equals::DefinesUnbound).ok().flatten()?;
        let statement = &answers.last()?.statement;
        match &statement.kind {
            // f := polar(…)
            Kind::Chain(left, links) if matches!(left.kind, Kind::Name(_)) => {
                Some(links.first()?.expr.clone())
            }
            _ => formula(statement),
        }
    }

    /// The letter that a description begins with: f is the blossom of t^2.
    fn named_with_is(&self, text: &str) -> Option<(String, usize)> {
        let start = syntax::after_introduction(text);
        let letter = text.get(start..)?.chars().next().filter(|letter| letter.is_alphabetic())?;
        let name = letter.to_string();
        let rest = text.get(start + letter.len_utf8()..)?;
        // f(u, v) is …
        let rest = match rest.strip_prefix('(').and_then(|inside| inside.split_once(')')) {
            Some((letters, rest)) if letters.chars().all(|c| c.is_alphabetic() || matches!(c, ',' | ' ')) => {
                rest
            }
            Some(_) => return None,
            None => rest,
        };
        let rest = rest.strip_prefix(' ')?;
        let (_, length) = asking::copula(rest)?;
        (!defines(&self.env, &name)).then_some((name, text.len() - rest.len() + length))
    }

    /// The questions of a text about an object; `None` if anything else is said.
    fn questions(
        &self,
        file: &SourceFile,
        text: Span,
        object: &Expr,
        name: Option<&str>,
        most: usize,
    ) -> Option<Vec<Question>> {
        if most == 0 {
            return None;
        }
        let cut = |(end, start): (usize, usize)| {
            let first = self.question(file, Span::new(text.start, text.start + end), object, name, false)?;
            let rest = Span::new(text.start + start, text.end);
            let mut found = self.questions(file, rest, object, name, most - 1)?;
            found.insert(0, first);
            Some(found)
        };
        // its value at 2 and its derivative at 1
        if let Some(found) = wanted::and_its(file.slice(text)).and_then(cut) {
            return Some(found);
        }
        if let Some(one) = self.question(file, text, object, name, false) {
            return Some(vec![one]);
        }
        let mut cuts: Vec<(usize, usize)> = wanted::conjunctions(file.slice(text));
        let stops = syntax::continuations(file.slice(text)).into_iter();
        cuts.extend(stops.filter_map(|stop| Some((stop.end, stop.rest(file.slice(text))?.start))));
        cuts.sort_unstable();
        cuts.into_iter().take(PLACES).find_map(cut)
    }

    /// One question: a formula with a letter for the object, or words about it.
    fn question(
        &self,
        file: &SourceFile,
        text: Span,
        object: &Expr,
        name: Option<&str>,
        by_letter: bool,
    ) -> Option<Question> {
        let ends = |c: char| c.is_whitespace() || matches!(c, '?' | '？' | '=' | '.' | '。');
        let inner = file.slice(text).trim_end_matches(ends);
        let place = Span::new(text.start, text.start + inner.len());
        if inner.trim().is_empty() {
            return None;
        }
        if !by_letter && let Some(claim) = self.claimed_of(file, place, object, name) {
            return Some((claim, place));
        }
        if !by_letter && let Ok(Some((formula, true))) = self.spoken_about(file, place, Some(object)) {
            return Some((formula, place));
        }
        let asked = syntax::asked(inner).map_or(place, |(span, _)| span.shifted(text.start));
        if let Ok(formula) = self.read(file, asked)
            && let Some(letter) = self.letter_called(&formula)
            && name.is_none_or(|name| name == letter)
        {
            return Some((with_object(&formula, &letter, object), place));
        }
        // what is c_1?
        if let Ok(formula) = self.read(file, asked)
            && let Kind::Subscript(letter, index) = &formula.kind
            && let (Kind::Name(letter), [number]) = (&letter.kind, index.as_slice())
            && number.as_int().is_some()
            && !defines(&self.env, letter)
            && name.is_none_or(|name| name == letter)
        {
            let index = vec![Expr::new(Kind::List(vec![number.clone()]), number.span)];
            return Some((Expr::new(Kind::Subscript(Box::new(object.clone()), index), place), place));
        }
        None
    }

    /// The only letter without a value that is called in a formula: s(1), p'(0).
    fn letter_called(&self, formula: &Expr) -> Option<String> {
        let mut letters = Vec::new();
        gather(formula, &mut letters);
        letters.sort();
        letters.dedup();
        let [letter] = letters.as_slice() else { return None };
        let free = !defines(&self.env, letter) && function_called(letter).is_none();
        let plain = !matches!(formula.kind, Kind::Sequence(_) | Kind::Chain(..));
        (free && plain && letter.chars().count() == 1).then(|| letter.clone())
    }
}

/// "The cubic has the control points 0, 1, 2, 4" speaks of the curve with these points, and not of the points.
fn of_its_points(object: Expr) -> Expr {
    let called = |expr: &Expr, names: &[&str]| match &expr.kind {
        Kind::Apply(callee, groups) => match (&callee.kind, groups.as_slice()) {
            (Kind::Name(own), [arguments]) if names.contains(&own.as_str()) => Some(arguments.clone()),
            _ => None,
        },
        _ => None,
    };
    match called(&object, &["control_points"]).as_deref() {
        Some([curve]) if called(curve, &["bezier", "bspline"]).is_some() => curve.clone(),
        _ => object,
    }
}

/// The letter of a function or of its derivative: p, p'.
fn letter_of(callee: &Expr) -> Option<&str> {
    match &callee.kind {
        Kind::Name(name) => Some(name),
        Kind::Prime(inner, _) => letter_of(inner),
        _ => None,
    }
}

fn gather(formula: &Expr, letters: &mut Vec<String>) {
    if let Kind::Apply(callee, groups) = &formula.kind {
        letters.extend(letter_of(callee).filter(|name| function_called(name).is_none()).map(str::to_owned));
        groups.iter().flatten().for_each(|argument| gather(argument, letters));
        return;
    }
    formula.for_each_child(&mut |child| gather(child, letters));
}

/// A formula with the object in place of the letter that is called.
fn with_object(formula: &Expr, letter: &str, object: &Expr) -> Expr {
    let mut formula = formula.clone();
    put(&mut formula, letter, object);
    formula
}

fn put(formula: &mut Expr, letter: &str, object: &Expr) {
    if let Kind::Apply(callee, groups) = &mut formula.kind {
        if letter_of(callee) == Some(letter) {
            let several = matches!(groups.as_slice(), [one] if one.len() > 1);
            let place = match &mut callee.kind {
                Kind::Prime(inner, _) => inner,
                _ => callee,
            };
            let span = place.span;
            let form = matches!(&object.kind, Kind::Apply(callee, _)
                if matches!(&callee.kind, Kind::Name(name) if name == "polar"));
            let one = matches!(groups.as_slice(), [one] if one.len() == 1);
            // f(0, 1) of a curve of one parameter is a polar value.
            let curve = match &object.kind {
                Kind::Apply(callee, _) => matches!(&callee.kind, Kind::Name(name) if name == "bezier"),
                _ => true,
            };
            **place = match several && curve {
                true => call("polar", vec![object.clone()], span),
                // F(t) where f is its polar form
                false if form && one => call("diagonal", vec![object.clone()], span),
                false => Expr { span, ..object.clone() },
            };
        }
        groups.iter_mut().flatten().for_each(|argument| put(argument, letter, object));
        return;
    }
    formula.for_each_child_mut(&mut |child| put(child, letter, object));
}
