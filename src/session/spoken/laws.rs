//! Formulas that are polar forms, or are said to be: the polynomial on their diagonal, and the laws that they have to fulfil.

use super::draft::Draft;
use super::utterance::Utterance;
use super::{Reader, apposition, lists};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel, applied, call};
use crate::judge::written::names::bases;
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::eval::Equals;
use crate::language::value::Value;
use crate::session::{Failure, defines, guarded, items_in};

/// Letters that stand for arguments of polar forms.
const ARGUMENTS: &[char] = &['r', 's', 't', 'u', 'v', 'w', 'x', 'y', 'z'];

impl Reader<'_> {
    /// The polynomial F(t) = f(t, ..., t) of a formula f: the diagonal of u v + u + v.
    pub(super) fn on_diagonal(&self, asked: &Utterance) -> Result<Option<Expr>, Box<Failure>> {
        let ([Draft { builtin, .. }], [item], []) =
            (asked.drafts.as_slice(), asked.items.as_slice(), asked.said.as_slice())
        else {
            return Ok(None);
        };
        if builtin.name != "diagonal" {
            return Ok(None);
        }
        let item = &self.with_products(item.clone());
        let (form, named) = match &item.kind {
            Kind::Chain(..) => match apposition::signature(item) {
                Some((letters, form)) => (form.clone(), Some(letters.to_vec())),
                None => return Ok(None),
            },
            Kind::Name(_) | Kind::Apply(..) => return Ok(None),
            _ => (item.clone(), None),
        };
        let letters = named.unwrap_or_else(|| lists::letters(&form, &Expr::int(0)));
        let letter = |letter: &Expr| match &letter.kind {
            Kind::Subscript(base, _) => matches!(base.kind, Kind::Name(_)),
            kind => matches!(kind, Kind::Name(_)),
        };
        if letters.len() < 2 || !letters.iter().all(letter) {
            return Ok(None);
        }
        if let Some(law) = self.broken_law(&form, &letters) {
            let problem = Diagnostic::error(Code::Usage, format!("this is no polar form: it is not {law}"))
                .at(item.span)
                .reason("a polar form is symmetric, and affine in each argument")
                .hint("laws(expression, [u, v], F) tells which law fails, and why");
            return Err(self.fail(problem));
        }
        let named_t = letters.iter().any(|own| matches!(&own.kind, Kind::Name(name) if name == "t"));
        let letter = if named_t && letters.len() > 2 { "x" } else { "t" };
        let variable = Expr { span: form.span, ..Expr::name(letter) };
        let by: Vec<(Expr, Expr)> = letters.into_iter().map(|own| (own, variable.clone())).collect();
        Ok(Some(form.with_parts(&by)))
    }

    /// Which law of polar forms a formula in some letters does not fulfil.
    fn broken_law(&self, form: &Expr, letters: &[Expr]) -> Option<&'static str> {
        let value = |mut formula: Expr| {
            let outcome = self.session.clone().evaluate(&mut formula, Equals::Claims).ok()?;
            match outcome.value {
                Value::Scalar(value) => Some(value),
                _ => None,
            }
        };
        let own = value(form.clone())?;
        for letter in letters {
            let second = call("diff", vec![form.clone(), letter.clone(), Expr::int(2)], form.span);
            if value(second).is_some_and(|second| !num_traits::Zero::is_zero(&second)) {
                return Some("affine in each argument");
            }
        }
        for pair in letters.windows(2) {
            let [one, other] = [pair[0].clone(), pair[1].clone()];
            let swapped = form.with_parts(&[(one.clone(), other.clone()), (other, one)]);
            if value(swapped).is_some_and(|swapped| swapped != own) {
                return Some("symmetric");
            }
        }
        None
    }

    /// The laws of a formula that is asked to be symmetric and affine: is u v + u + v symmetric and affine in each argument?
    pub(super) fn laws_of(&self, asked: &Utterance) -> Option<Expr> {
        let ([Draft { builtin, .. }], [form], []) =
            (asked.drafts.as_slice(), asked.items.as_slice(), asked.said.as_slice())
        else {
            return None;
        };
        if builtin.name != "laws" || matches!(form.kind, Kind::Chain(..) | Kind::List(_)) {
            return None;
        }
        let form = self.with_products(form.clone());
        let letters = lists::letters(&form, &Expr::int(0));
        let names: Vec<String> = letters.iter().flat_map(bases).collect();
        let letter = if names.iter().any(|name| name == "t") { "x" } else { "t" };
        let variable = Expr { span: form.span, ..Expr::name(letter) };
        let diagonal = names.iter().fold(form.clone(), |form, name| form.with_name(name, &variable));
        let span = form.span;
        (names.len() > 1)
            .then(|| call("laws", vec![form, Expr::new(Kind::List(letters), span), diagonal], span))
    }

    /// The claim that a formula is the polar form of something with more arguments than the formula has letters: is u^2 v the
    /// blossom of t^3?
    pub(super) fn is_form_of(&self, claimed: &Expr, asked: &Utterance) -> Option<Expr> {
        let ([Draft { builtin, .. }], [of], []) =
            (asked.drafts.as_slice(), asked.items.as_slice(), asked.said.as_slice())
        else {
            return None;
        };
        let claim = match &claimed.kind {
            Kind::Chain(..) => return None,
            _ => claimed.clone(),
        };
        if builtin.name != "polar" || matches!(of.kind, Kind::List(_) | Kind::Tuple(_) | Kind::Chain(..)) {
            return None;
        }
        let mut letters = lists::letters(&claim, of);
        let mut degree = call("degree", vec![of.clone()], of.span);
        let degree = self.session.clone().evaluate(&mut degree, Equals::Claims).ok()?.value.as_int()?;
        let missing =
            usize::try_from(degree).ok()?.checked_sub(letters.len()).filter(|missing| *missing > 0)?;
        if letters.is_empty() {
            return None;
        }
        let used: Vec<String> = letters.iter().chain([of]).flat_map(bases).collect();
        let free = ["u", "v", "w", "r", "s", "p", "q"]
            .into_iter()
            .filter(|name| !used.iter().any(|own| own == name));
        letters.extend(free.take(missing).map(|name| Expr { span: claim.span, ..Expr::name(name) }));
        let span = claim.span.to(of.span);
        let form = applied(call("polar", vec![of.clone()], of.span), letters, span);
        Some(Expr { span, ..Expr::relation(form, Rel::Eq, claim) })
    }

    /// A polar value in brackets: p[0, 0, 3].
    pub(super) fn in_brackets(&self, span: Span) -> Option<Result<Expr, Box<Failure>>> {
        let span = span.shifted(self.start);
        let text = self.file.slice(span);
        let letter = text.chars().next().filter(|letter| letter.is_alphabetic())?;
        let start = letter.len_utf8();
        text.get(start..)?
            .strip_prefix('[')?
            .strip_suffix(']')
            .filter(|inner| !inner.contains(['[', ']']))?;
        let inner = Span::new(span.start + start + 1, span.end - 1);
        let name = Expr { span: Span::new(span.start, span.start + start), ..Expr::name(letter.to_string()) };
        let session = self.session;
        let items = guarded(&session.limits, || items_in(&session.env, self.file, inner));
        Some(items.map(|items| applied(name, items, span)).map_err(|problem| self.fail(problem)))
    }

    /// A formula with products in place of words of letters that stand for arguments, or that stand in it by themselves:
    /// u v for uv, a b in ab + a + b.
    pub(super) fn with_products(&self, mut formula: Expr) -> Expr {
        let names = bases(&formula);
        let stands = |letter: char| ARGUMENTS.contains(&letter) || names.contains(&letter.to_string());
        self.split_words(&mut formula, &stands);
        formula
    }

    fn split_words(&self, formula: &mut Expr, stands: &dyn Fn(char) -> bool) {
        let span = formula.span;
        let Kind::Name(word) = &formula.kind else {
            return formula.for_each_child_mut(&mut |child| self.split_words(child, stands));
        };
        if word.chars().count() > 1 && word.chars().all(stands) && !defines(&self.session.env, word) {
            let names = word.chars().map(|letter| Expr { span, ..Expr::name(letter.to_string()) });
            *formula = Expr { span, ..Expr::product(names.collect()) }.grouped();
        }
    }
}
