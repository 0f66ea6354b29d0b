//! Bases and subdivision schemes by their words: each is written down once, with how it is read.

use crate::formula::source::Span;
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::Arguments;
use crate::language::ops::errors::{curve_error, subdivision_error, wrong_kind};
use crate::language::ops::takes::{Notion, Takes, alternatives, word_of};
use crate::language::value::Value;
use crate::math::basis::Basis;
use crate::math::interval::{EmptyInterval, Interval};
use crate::math::number::rational;
use crate::math::poly::Fraction;
use crate::math::subdivision::{Scheme, VertexScheme};
type Result<T> = std::result::Result<T, Diagnostic>;

/// How something with a name is written, and what it is for the numbers behind its name.
type Way<T> = (&'static str, fn(&[Fraction]) -> Option<T>);

/// The words of choices, and how ways are written.
pub(crate) const fn words_of<T, const N: usize>(choices: &[(&'static str, T); N]) -> [&'static str; N] {
    let (mut words, mut i) = ([""; N], 0);
    while i < N {
        words[i] = choices[i].0;
        i += 1;
    }
    words
}

/// What the word stands for that was chosen.
pub(crate) fn chosen<T: Copy>(given: Option<(&Value, Span)>, choices: &[(&str, T)]) -> Result<T> {
    let known = |word: &str| choices.iter().find(|(own, _)| *own == word).map(|(_, meant)| *meant);
    given.and_then(|(value, _)| word_of(value)).and_then(known).ok_or_else(|| {
        let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
        let words = alternatives(&words);
        match given {
            Some((value, span)) => wrong_kind(&words, value).at(span),
            None => Diagnostic::error(Code::Arity, format!("one of {words} is missing")),
        }
    })
}

const BASES: [Way<Over<Basis<Fraction>>>; 10] = [
    ("power", |n| n.is_empty().then_some(Ok(Basis::Power))),
    ("bernstein", |n| alone(n).map(Basis::Bernstein).map(Ok)),
    ("[bernstein, a, b]", |n| over(n).map(|interval| interval.map(Basis::Bernstein))),
    ("[taylor, a]", |n| one(n).map(|at| Ok(Basis::Taylor { at }))),
    ("[lagrange, t_0, t_1, ...]", |n| Some(Ok(Basis::Lagrange(n.to_vec())))),
    ("[newton, t_0, t_1, ...]", |n| Some(Ok(Basis::Newton(n.to_vec())))),
    ("hermite", |n| alone(n).map(Basis::HermiteEndpoints).map(Ok)),
    ("[hermite, a, b]", |n| over(n).map(|interval| interval.map(Basis::HermiteEndpoints))),
    ("legendre", |n| alone(n).map(Basis::Legendre).map(Ok)),
    ("[legendre, a, b]", |n| over(n).map(|interval| interval.map(Basis::Legendre))),
];

const SCHEMES: [Way<Scheme<Fraction>>; 8] = [
    ("chaikin", |n| n.is_empty().then(|| Scheme::lane_riesenfeld(2))),
    ("cubic", |n| n.is_empty().then(|| Scheme::lane_riesenfeld(3))),
    ("four_point", |n| n.is_empty().then(|| Scheme::four_point(&number(1, 16)))),
    ("de_rham", |n| n.is_empty().then(|| Scheme::corner_cutting(&number(1, 3), &number(1, 3)))),
    ("[lane_riesenfeld, n]", |n| {
        let degree = Value::Scalar(one(n)?).as_int()?;
        usize::try_from(degree).ok().map(Scheme::lane_riesenfeld)
    }),
    ("[four_point, w]", |n| one(n).map(|w| Scheme::four_point(&w))),
    ("[corner_cutting, lambda]", |n| one(n).map(|both| Scheme::corner_cutting(&both, &both))),
    ("[corner_cutting, lambda, mu]", |n| ends(n).map(|(lambda, mu)| Scheme::corner_cutting(&lambda, &mu))),
];

/// Subdivision of meshes around a vertex.
const MESHES: [(&str, VertexScheme); 4] = [
    ("catmull_clark", VertexScheme::CatmullClark),
    ("doo_sabin", VertexScheme::DooSabin),
    ("loop", VertexScheme::Loop),
    ("warren", VertexScheme::Warren),
];

const BASIS_NOTION: Notion = Notion { what: "a basis", forms: &words_of(&BASES), unnamed: None };

const SCHEME_NOTION: Notion = Notion {
    what: "a subdivision scheme",
    forms: &words_of(&SCHEMES),
    unnamed: Some("a mask such as [1, 3, 3, 1]/4"),
};

/// A basis of polynomials.
pub(crate) const BASIS: Takes = Takes::Named(&BASIS_NOTION);

/// A basis of polynomials, or the knots of B-splines.
pub(crate) const BASIS_OR_KNOTS: Takes = Takes::Named(&Notion { unnamed: Some("knots"), ..BASIS_NOTION });

/// A subdivision scheme, or its mask.
pub(crate) const SCHEME: Takes = Takes::Named(&SCHEME_NOTION);

/// A scheme for meshes.
pub(super) const MESH: Takes = Takes::Word(&words_of(&MESHES));

/// The scheme for meshes at a place.
pub(super) fn mesh(args: &Arguments, i: usize) -> Result<VertexScheme> {
    chosen(args.given(i), &MESHES)
}

fn number(p: i64, q: i64) -> Fraction {
    Fraction::from(rational(p, q))
}

fn one(numbers: &[Fraction]) -> Option<Fraction> {
    if let [one] = numbers { Some(one.clone()) } else { None }
}

fn ends(numbers: &[Fraction]) -> Option<(Fraction, Fraction)> {
    if let [a, b] = numbers { Some((a.clone(), b.clone())) } else { None }
}

fn alone(numbers: &[Fraction]) -> Option<Interval<Fraction>> {
    numbers.is_empty().then(Interval::unit)
}

/// What is given over an interval, if that has two ends.
type Over<T> = std::result::Result<T, EmptyInterval>;

fn over(numbers: &[Fraction]) -> Option<Over<Interval<Fraction>>> {
    ends(numbers).map(|(a, b)| Interval::new(a, b))
}

/// Whether a word that stands alone names a basis or a scheme. Before a bracket it is the function of that name;
/// `bernstein` is so by itself.
pub(crate) fn is_word(word: &str) -> bool {
    word != "bernstein" && [BASIS, SCHEME, MESH].iter().any(|kind| kind.has_word(word))
}

/// The word of a value and the numbers behind it.
fn word_and_numbers(value: &Value) -> Option<(&str, Vec<Fraction>)> {
    let (name, rest) = match value {
        Value::List(items) => items.split_first()?,
        single => (single, &[] as &[Value]),
    };
    let numbers: Option<Vec<Fraction>> = rest.iter().map(|item| item.as_scalar().cloned()).collect();
    Some((word_of(name)?, numbers?))
}

fn read<T>(ways: &[Way<T>], kind: Takes, value: &Value, span: Span) -> Result<T> {
    word_and_numbers(value)
        .and_then(|(word, numbers)| {
            ways.iter().filter(|(form, _)| Notion::name(form) == word).find_map(|(_, read)| read(&numbers))
        })
        .ok_or_else(|| kind.refuses(value))
        .at(span)
}

/// `power`, `bernstein`, `[bernstein, a, b]`, `[lagrange, t_0, …]` and so on.
pub(super) fn read_basis(value: &Value, span: Span) -> Result<Basis<Fraction>> {
    read(&BASES, BASIS, value, span)?.map_err(curve_error).at(span)
}

/// The basis at a place.
pub(super) fn basis(args: &Arguments, i: usize) -> Result<Basis<Fraction>> {
    read_basis(args.value(i)?, args.span(i))
}

/// The scheme at a place: a word, a list such as [four_point, w], or a mask.
pub(super) fn scheme(args: &Arguments, i: usize) -> Result<Scheme<Fraction>> {
    let (value, span) = (args.value(i)?, args.span(i));
    if let Value::List(items) = value
        && let Some(mask) = items.iter().map(|item| item.as_scalar().cloned()).collect::<Option<Vec<_>>>()
    {
        // As many coefficients before the middle as the masks with names have.
        let first = -((mask.len().max(1) as i64 - 1) / 2);
        return Scheme::new(mask, first).map_err(subdivision_error).at(span);
    }
    read(&SCHEMES, SCHEME, value, span)
}
