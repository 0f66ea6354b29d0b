//! What is asked for in words: `polar form of t^3`, `racines de t^2 - 1`, `t^2 的极形式`.

mod asides;
mod features;
mod names;
mod table;

use std::collections::HashMap;
use std::sync::LazyLock;

#[cfg(test)]
pub(crate) use self::names::lines as names_of_functions;

use self::asides::ASIDES;
use self::features::FEATURES;
use self::table::PHRASES;
use super::letters::is_ideograph;
use crate::formula::BigOp;
use crate::language::diagnostic::nearest;

/// What a phrase of a request says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phrase {
    /// A function of the program: polar form.
    Function(&'static str),
    /// A function, by a word that commands it: expand.
    Command(&'static str),
    /// One of the things that a function gives: left part.
    Part(&'static str, i64),
    /// A sum or product.
    Total(BigOp),
    /// A degree: cubic.
    Degree(i64),
    /// How often: second.
    Ordinal(i64),
    /// What follows belongs to a parameter: knots.
    Label(Label),
    /// A function of what stands before and after it: choose.
    Between(&'static str),
    /// What it is a function of follows.
    Of,
    /// Two of a kind.
    And,
    /// One of two.
    Or,
    /// With weights: rational.
    Rational,
    /// A question, or what is claimed: is.
    Is,
    /// Something has a value: equals.
    Equals,
    /// Something has a value somewhere: takes the value.
    Takes,
    /// Something has the value 0: vanishes.
    Vanishes,
    /// Values are asked for: for which.
    Which,
    /// A place of a curve or a triangle: in the middle.
    Place(Place),
    /// Whether something is so: closed, open.
    Flag(&'static str, i64),
    /// Where a largest or smallest value is taken, which is told with it.
    Where,
    /// A polar form: symmetric and affine in each argument.
    Multiaffine,
    /// How often a knot stands: a double knot.
    Multiplicity(i64),
    /// The knots are equally spaced.
    Uniform,
    /// A way to do it follows: using.
    Using,
    /// Something has a property: has derivative 0.
    Has,
    /// So many of them, from the first on: first three.
    First(i64),
    /// A curve, of which it is not said which kind it is.
    Curve,
    /// The degree that a polynomial has, where one is given that it may have.
    TrueDegree,
    /// What follows is applied to something: apply.
    Apply,
    /// What it is applied to follows.
    AppliedTo,
    /// It says nothing: the, please.
    Filler,
    /// It carries no role and may be left aside, which the answer tells: quickly, some.
    Aside,
}

/// A place that has a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Where the parameter begins.
    Start,
    /// In the middle.
    Middle,
    /// Where it ends.
    End,
    /// The centroid.
    Centre,
}

/// What a label says of that which follows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Label {
    /// A parameter or the values of names: at.
    At,
    /// An interval, or knots: over.
    Over,
    /// The start of an interval: from.
    From,
    /// Its end, or a degree: to.
    To,
    /// A variable, or the form that is wanted: in.
    In,
    /// A value, a condition or another label: with, for.
    With,
    /// Points that are met: through.
    Through,
    /// The degree.
    OfDegree,
    /// The knots.
    Knots,
    /// The nodes of an interpolation.
    Nodes,
    /// The values there.
    Values,
    /// The weights.
    Weights,
    /// Control points or coefficients.
    Points,
    /// How often.
    Times,
    /// The number of a member: index.
    Number,
    /// Weights are expected: rational.
    Rational,
    /// Knots are equally spaced: uniform.
    Uniform,
    /// How often a knot stands.
    Multiplicity,
    /// The points of a triangle.
    Net,
}

impl Label {
    /// Whether it gives the names in a formula their values: knots.
    pub(crate) fn names_values(self) -> bool {
        matches!(self, Knots | Nodes | Points | Through)
    }

    /// The function that the same word names: the degree of t^3.
    pub(crate) fn function(self) -> Option<&'static str> {
        Some(match self {
            OfDegree => "degree",
            Knots => "knots",
            Weights => "weights",
            Points => "coefficients",
            _ => return None,
        })
    }
}

use self::Label::*;
use self::Phrase::{Between, Command, Filler, Function, Of};

/// What a word may end with that is declined or in the plural, in any of the languages.
const ENDINGS: &[&str] = &["", "s", "e", "en", "er", "es", "em", "n", "a", "o", "as", "os", "i", "he", "x"];

/// Words that may stand inside of a phrase: insert the knot.
const ARTICLES: &[&str] = &["the", "a", "an", "den", "die", "das", "le", "la", "les", "el", "los"];

/// All phrases of the tables.
fn all() -> impl Iterator<Item = (Phrase, &'static str)> {
    let listed = PHRASES.iter().chain(FEATURES).chain(ASIDES);
    listed.flat_map(|(phrase, names)| names.split(" | ").map(|name| (*phrase, name)))
}

/// The same, with the names of functions in languages that set no blanks.
fn all_with_names() -> impl Iterator<Item = (Phrase, &'static str)> {
    let named = names::all().map(|named| (Phrase::Function(named.function), named.name));
    all().chain(named.filter(|(_, name)| name.contains(is_ideograph)))
}

/// The ways in which words of the tables are written.
fn forms_of(name: &str) -> Vec<String> {
    name.split(' ').map(forms).fold(vec![String::new()], |starts, forms| {
        let with = |start: &String, form: &String| match start.is_empty() {
            true => form.clone(),
            false => format!("{start} {form}"),
        };
        starts.iter().flat_map(|start| forms.iter().map(move |form| with(start, form))).collect()
    })
}

/// The phrase that words in small letters are by the tables.
fn listed(written: &str) -> Option<Phrase> {
    let own = BY_START.get(written.split(' ').next()?)?;
    own.iter().find(|(_, name)| says(written, name)).map(|(phrase, _)| *phrase)
}

/// The phrases that begin with a word, or with an ideograph.
static BY_START: LazyLock<HashMap<String, Vec<(Phrase, &str)>>> = LazyLock::new(|| {
    let mut found: HashMap<String, Vec<(Phrase, &str)>> = HashMap::new();
    for (phrase, name) in all_with_names() {
        let start = match name.char_indices().nth(1) {
            Some((second, _)) if name.starts_with(is_ideograph) => name.get(..second),
            _ => name.split(' ').next(),
        };
        for form in forms(start.unwrap_or(name)) {
            found.entry(form).or_default().push((phrase, name));
        }
    }
    found
});

const LONGEST_MIXED: usize = 14;

/// The phrases of letters and ideographs.
static MIXED: LazyLock<Vec<(Phrase, &str)>> = LazyLock::new(|| {
    let mixed = |name: &str| !name.starts_with(is_ideograph) && name.contains(is_ideograph);
    all_with_names().filter(|(_, name)| mixed(name)).collect()
});

/// The forms of a word of the table.
fn forms(word: &str) -> Vec<String> {
    match word.strip_suffix('~') {
        Some(stem) => ENDINGS.iter().map(|ending| format!("{stem}{ending}")).collect(),
        None => vec![word.to_owned()],
    }
}

/// Whether words are those of a phrase of the table.
fn says(written: &str, name: &str) -> bool {
    let same = |(written, name): (&str, &str)| match name.strip_suffix('~') {
        Some(stem) => written.strip_prefix(stem).is_some_and(|ending| ENDINGS.contains(&ending)),
        None => written == name,
    };
    written.split(' ').count() == name.split(' ').count() && written.split(' ').zip(name.split(' ')).all(same)
}

/// The phrase at the start of a text, and its length in bytes. Other names of functions are looked up by
/// `function`, with blanks as they stand.
///
/// A phrase ends with a word, but for those of languages that set no blanks.
pub(crate) fn phrase(text: &str, function: &dyn Fn(&str) -> Option<&'static str>) -> Option<(Phrase, usize)> {
    const LONGEST: usize = 7;
    const SHORTEST_NAME: usize = 3;
    if text.starts_with(is_ideograph) {
        let second = text.char_indices().nth(1).map_or(text.len(), |(at, _)| at);
        let listed = BY_START.get(text.get(..second)?)?.iter();
        let (phrase, name) =
            listed.filter(|(_, name)| text.starts_with(name)).max_by_key(|(_, name)| name.len())?;
        return Some((*phrase, name.len()));
    }
    if word(text).len() < text.len()
        && text
            .get(word(text).len()..)
            .is_some_and(|rest| rest.strip_prefix(' ').unwrap_or(rest).starts_with(is_ideograph))
    {
        // B样条
        let lower: String = text.chars().take(LONGEST_MIXED).flat_map(char::to_lowercase).collect();
        let mixed = MIXED.iter().filter(|(_, name)| lower.starts_with(name));
        if let Some((phrase, name)) = mixed.max_by_key(|(_, name)| name.len()) {
            return Some((*phrase, text.chars().take(name.chars().count()).map(char::len_utf8).sum()));
        }
    }
    let mut found = None;
    let mut listed: Option<&[(Phrase, &str)]> = None;
    let (mut written, mut short) = (String::new(), String::new());
    let mut at = 0;
    for number in 0..LONGEST {
        let rest = text.get(at..)?;
        let separator: usize =
            rest.chars().take_while(|c| c.is_whitespace() || *c == '-').map(char::len_utf8).sum();
        // w.r.t.
        let separator = if separator == 0 && number > 0 && rest.starts_with('.') { 1 } else { separator };
        if (separator == 0) != (number == 0) || rest.get(..separator)?.contains('\n') {
            break;
        }
        let word = word(rest.get(separator..)?);
        if word.is_empty() {
            break;
        }
        let small: String =
            word.chars().flat_map(char::to_lowercase).map(|c| if c == '’' { '\'' } else { c }).collect();
        if number > 0 {
            written.push(' ');
            if !ARTICLES.contains(&small.as_str()) {
                short.extend([" ", &small]);
            }
        } else {
            short.clone_from(&small);
        }
        written.push_str(&small);
        at += separator + word.len();
        let own = listed.get_or_insert_with(|| BY_START.get(written.as_str()).map_or(&[][..], Vec::as_slice));
        // Most letters of formulas begin no phrase.
        if own.is_empty() && written.len() < SHORTEST_NAME && !names::begins(&written) {
            break;
        }
        let article = number > 0 && ARTICLES.contains(&small.as_str());
        let is = |name: &str| says(&written, name) || !article && says(&short, name);
        let known = own.iter().find(|(_, name)| is(name)).map(|(phrase, _)| *phrase);
        let name = || function(&written.replace(' ', "_")).filter(|_| written.len() >= SHORTEST_NAME);
        // A spline of degree 2 is no spline_of.
        let goes_on = found.is_some() && written.ends_with(" of");
        let both = |read: fn(&str) -> Option<Phrase>| {
            read(&written).or_else(|| read(&short).filter(|_| !article && short != written))
        };
        let name = || name().filter(|_| !goes_on).map(Function);
        if let Some(phrase) =
            known.or_else(|| both(names::named)).or_else(name).or_else(|| both(names::spelled))
        {
            found = Some((phrase, at));
        }
    }
    if found.is_some() {
        return found;
    }
    // l'intégrale, d'interpolation
    ["l'", "l’", "d'", "d’"].iter().find_map(|article| {
        let start = text.get(..article.len())?.to_lowercase();
        let of = if start.starts_with('d') { Of } else { Filler };
        (start == *article).then_some((of, article.len()))
    })
}

/// The function that a word names by itself, also at its end where no blanks stand between words.
pub(crate) fn function_named(word: &str) -> Option<&'static str> {
    let joined = word.chars().any(is_ideograph);
    let starts = word.char_indices().map(|(at, _)| at).take(if joined { word.len() } else { 1 });
    starts.filter_map(|at| word.get(at..)).find_map(|rest| match phrase(rest, &|_| None)? {
        (_, length) if length < rest.len() => None,
        (Function(function) | Command(function) | Between(function), _) => Some(function),
        (Phrase::Label(label), _) => label.function(),
        _ => None,
    })
}

/// The degree that a word of a phrase says, also at its end: regression line, Ausgleichsgerade.
pub(crate) fn degree_within(phrase: &str) -> Option<i64> {
    const SHORTEST: usize = 4;
    let degree = |word: &str| match listed(word)? {
        Phrase::Degree(degree) => Some(degree),
        _ => None,
    };
    phrase.split([' ', '-']).find_map(|word| {
        let ends = word.char_indices().filter_map(|(at, _)| word.get(at..));
        ends.filter(|end| end.len() >= SHORTEST).find_map(degree)
    })
}

/// The phrase of one or two words that somebody may have misspelled with these.
pub(crate) fn misspelled(word: &str, next: &str) -> Option<&'static str> {
    let known = |word: &str| phrase(word, &|_| None).is_some_and(|(_, length)| length == word.len());
    if known(word) {
        return None;
    }
    let named = |phrase: &Phrase| matches!(phrase, Function(_) | Command(_));
    let listed = all().filter(|(phrase, _)| named(phrase)).map(|(_, name)| name);
    listed.chain(names::all().map(|named| named.name)).find(|name| {
        let stem = name.trim_end_matches('~');
        // No word in letters is meant for one with other signs.
        if stem.contains(is_ideograph) && !word.contains(is_ideograph) {
            return false;
        }
        match stem.split_once(' ') {
            Some((first, second)) => second == next && first != word && nearest(word, [first]).is_some(),
            None => word.len() > SHORTEST_MISSPELLED && stem != word && nearest(word, [stem]).is_some(),
        }
    })
}

/// Shorter words are close to many.
const SHORTEST_MISSPELLED: usize = 5;

/// The word at the start of a text: letters, and apostrophes between them.
fn word(text: &str) -> &str {
    let letter = |c: char| c.is_alphabetic() && !is_ideograph(c);
    let mut end = 0;
    let mut chars = text.char_indices().peekable();
    while let Some((at, c)) = chars.next() {
        let inside =
            matches!(c, '\'' | '’') && end > 0 && chars.peek().is_some_and(|(_, next)| letter(*next));
        if !(letter(c) || inside) {
            break;
        }
        end = at + c.len_utf8();
    }
    text.get(..end).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_phrase_stands_twice() {
        let mut seen = std::collections::BTreeSet::new();
        for form in all().flat_map(|(_, name)| forms_of(name)) {
            assert!(seen.insert(form.clone()), "{form}");
        }
    }
}
