//! Lists by other names: `b0 = 1, b1 = 4, b2 = 2`, `A = (0, 0), B = (3, 6)`, `w = {1, 3, 1}`.

use super::super::foreign::as_list;
use super::Read;
use super::draft::is_points;
use crate::formula::{Expr, Kind, Rel};
use crate::language::lexicon::phrases::Label;
use crate::language::lexicon::roles::{Listed, listed};
use crate::language::write;

/// What a list with this letter is.
fn role(letter: &str) -> Option<Label> {
    Some(match listed(letter)? {
        Listed::Points => Label::Points,
        Listed::Weights => Label::Weights,
        Listed::Knots => Label::Knots,
        Listed::Nodes => Label::Nodes,
        Listed::Values => Label::Values,
        Listed::Lengths | Listed::Slopes => return None,
    })
}

/// Makes lists of runs of names with their values, and labels of the letters of lists.
pub(super) fn gather(items: &mut Vec<Expr>, said: &mut Vec<Read>) {
    // Equations are not what a function is of, but say what its arguments are.
    if !items.is_empty() && items.iter().all(|item| Equation::of(item).is_some_and(|one| one.is_argument())) {
        said.insert(0, Read { label: Label::With, items: std::mem::take(items) });
    }
    // for x = 0, 1, 3 and y = 1, 2, 10
    for read in said.iter_mut().filter(|read| read.label == Label::With && read.items.len() > 1) {
        let (first, rest) = read.items.split_at(1);
        let plain = |item: &Expr| !matches!(item.kind, Kind::Chain(..));
        if let Kind::Chain(name, links) = &first[0].kind
            && let [link] = links.as_slice()
            && matches!(&name.kind, Kind::Name(letter) if role(letter).is_some())
            && plain(&link.expr)
            && rest.iter().all(plain)
        {
            let values = std::iter::once(&link.expr).chain(rest).cloned().collect();
            let list = Expr::new(Kind::List(values), link.expr.span);
            let whole = Expr::relation((**name).clone(), Rel::Eq, list);
            read.items = vec![Expr { span: first[0].span, ..whole }];
        }
    }
    triangles(said);
    let mut runs: Vec<(Label, Vec<Equation>)> = Vec::new();
    for read in &mut *said {
        if !matches!(read.label, Label::With | Label::Points | Label::Weights | Label::Knots) {
            continue;
        }
        let label = read.label;
        read.items.retain(|item| {
            let Some(one) = Equation::of(item) else { return true };
            let Some(own) = one.run() else { return true };
            let label = if label == Label::With { own } else { label };
            match runs.last_mut() {
                Some((before, run))
                    if *before == label && run.last().is_some_and(|last| last.precedes(&one)) =>
                {
                    run.push(one);
                }
                _ => runs.push((label, vec![one])),
            }
            false
        });
    }
    said.retain(|read| !read.items.is_empty());
    for (label, run) in runs {
        let items = match run.as_slice() {
            // w = [1, 2, 1]; a single b_0 = 1 is a value
            [one] if one.value.items().is_some() && one.index.is_none() => vec![one.value.clone()],
            [one] => {
                said.push(Read { label: Label::With, items: vec![one.whole.clone()] });
                continue;
            }
            _ => run.into_iter().map(|one| one.value).collect(),
        };
        said.push(Read { label, items });
    }
}

/// The points of a triangle by their three indices, i and then j descending: b200 = 1, b110 = 2, …
fn triangles(said: &mut Vec<Read>) {
    let mut found: Vec<([i64; 3], String, Expr)> = Vec::new();
    for read in said.iter().filter(|read| matches!(read.label, Label::With | Label::Points)) {
        for item in &read.items {
            let Some(one) = Equation::of(item) else { continue };
            let Some(indices) = one.three() else { continue };
            found.push((indices, one.letter, one.value));
        }
    }
    let Some((first, letter, _)) = found.first() else { return };
    let degree: i64 = first.iter().sum();
    let alike = found.iter().all(|(own, other, _)| own.iter().sum::<i64>() == degree && other == letter);
    let needed = degree.checked_add(2).and_then(|next| (degree + 1).checked_mul(next)).map(|twice| twice / 2);
    if !alike || degree < 1 || i64::try_from(found.len()).ok() != needed {
        return;
    }
    found.sort_by_key(|(indices, ..)| std::cmp::Reverse(*indices));
    if found.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return;
    }
    for read in said.iter_mut().filter(|read| matches!(read.label, Label::With | Label::Points)) {
        read.items.retain(|item| Equation::of(item).is_none_or(|one| one.three().is_none()));
    }
    said.retain(|read| !read.items.is_empty());
    said.push(Read { label: Label::Net, items: found.into_iter().map(|(.., value)| value).collect() });
}

/// A name with its value.
struct Equation {
    letter: String,
    index: Option<i64>,
    value: Expr,
    whole: Expr,
}

impl Equation {
    fn of(item: &Expr) -> Option<Equation> {
        let Kind::Chain(left, links) = &item.kind else { return None };
        let [link] = links.as_slice() else { return None };
        let (letter, index) = match &left.kind {
            Kind::Name(letter) => (letter.clone(), None),
            Kind::Subscript(base, indices) => match (&base.kind, indices.as_slice()) {
                (Kind::Name(letter), [index]) => (letter.clone(), index.as_int()),
                (Kind::Name(letter), [_, _, _]) => (letter.clone(), None),
                _ => return None,
            },
            _ => return None,
        };
        let value = as_list(link.expr.clone());
        (link.rel == crate::formula::Rel::Eq).then(|| Equation { letter, index, value, whole: item.clone() })
    }

    /// Its three indices: b_{210}, b_{2,1,0}.
    fn three(&self) -> Option<[i64; 3]> {
        let Kind::Chain(left, _) = &self.whole.kind else { return None };
        let Kind::Subscript(_, indices) = &left.kind else { return None };
        match indices.as_slice() {
            [i, j, k] => Some([i.as_int()?, j.as_int()?, k.as_int()?]),
            // b_020, where the zero counts
            [number] => {
                let digits = write::text(number);
                let digits: Vec<i64> =
                    digits.chars().map(|c| c.to_digit(10).map(i64::from)).collect::<Option<_>>()?;
                match digits.as_slice() {
                    [i, j, k] => Some([*i, *j, *k]),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Whether it gives a value rather than a function.
    fn is_argument(&self) -> bool {
        matches!(self.value.kind, Kind::Number(_) | Kind::List(_) | Kind::Tuple(_))
            || matches!(self.value.kind, Kind::Div(..) | Kind::Add(_))
                && letters(&self.value, &Expr::int(0)).is_empty()
    }

    /// What its list is, if it may be a part of one.
    fn run(&self) -> Option<Label> {
        match self.index {
            Some(_) => role(&self.letter),
            None if matches!(self.value.kind, Kind::List(_)) => role(&self.letter),
            // A = (0, 0), B = (1, 2)
            None if self.capital().is_some() && is_points(std::slice::from_ref(&self.value)) => {
                Some(Label::Points)
            }
            None => None,
        }
    }

    fn capital(&self) -> Option<u8> {
        match self.letter.as_bytes() {
            [letter] if letter.is_ascii_uppercase() => Some(*letter),
            _ => None,
        }
    }

    /// Whether the other one is the next of a run.
    fn precedes(&self, next: &Equation) -> bool {
        match (self.index, next.index) {
            (Some(own), Some(other)) => self.letter == next.letter && own + 1 == other,
            (None, None) => self.capital().is_some_and(|own| next.capital() == Some(own + 1)),
            _ => false,
        }
    }
}

/// Whether single letters stand beside each other, perhaps after a number, with only blanks between them: `2 x y`. Where a
/// formula is wanted they are a product.
pub(super) fn is_product(text: &str) -> bool {
    let mut words = text.split_whitespace().peekable();
    words.next_if(|word| word.bytes().all(|byte| byte.is_ascii_digit()));
    let letter = |word: &str| word.chars().count() == 1 && word.starts_with(char::is_alphabetic);
    words.peek().is_some() && words.all(letter)
}

/// Where names with their values stand that have only blanks between them: `b200=1 b020=3`.
pub(super) fn members(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut at = 0;
    for word in text.split_whitespace() {
        let Some(start) = text.get(at..).and_then(|rest| rest.find(word)).map(|start| at + start) else {
            return Vec::new();
        };
        at = start + word.len();
        let named = word.split_once('=').is_some_and(|(name, value)| {
            name.starts_with(char::is_alphabetic)
                && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '{' | '}' | ','))
                && !value.is_empty()
                && !value.contains('=')
        });
        if !named {
            return Vec::new();
        }
        found.push((start, at));
    }
    if found.len() > 1 { found } else { Vec::new() }
}

/// Where pairs of numbers stand that have only blanks between them: `0,0 1,2 2,0`.
pub(super) fn pairs(text: &str) -> Vec<(usize, usize)> {
    let number = |text: &str| {
        let digits = text.strip_prefix('-').unwrap_or(text);
        !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'/'))
    };
    // 0->1, 1->2
    let mapped =
        |part: &str| part.split_once("->").is_some_and(|(x, y)| number(x.trim()) && number(y.trim()));
    if text.contains("->") && text.split(',').count() > 1 && text.split(',').all(mapped) {
        let ends = text.match_indices(',').map(|(at, _)| at).chain([text.len()]);
        return ends
            .scan(0, |start, end| {
                let place = (*start, end);
                *start = end + 1;
                Some(place)
            })
            .collect();
    }
    let pair = |word: &str| word.split_once(',').is_some_and(|(x, y)| number(x) && number(y));
    let words: Vec<&str> = text.split_whitespace().collect();
    if words.len() < 2 || !words.iter().all(|word| pair(word)) {
        return Vec::new();
    }
    let mut at = 0;
    let mut place = |word: &&str| {
        let start = at + text.get(at..)?.find(*word)?;
        at = start + word.len();
        Some((start, at))
    };
    words.iter().filter_map(&mut place).collect()
}

/// The names in a formula, with their indices, that do not occur in another one.
pub(super) fn letters(formula: &Expr, other: &Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    gather_letters(formula, &mut found);
    let mut there = Vec::new();
    gather_letters(other, &mut there);
    found.retain(|letter| !there.iter().any(|known| write::text(known) == write::text(letter)));
    found
}

fn gather_letters(formula: &Expr, found: &mut Vec<Expr>) {
    match &formula.kind {
        Kind::Name(_) | Kind::Subscript(..) => {
            if !found.iter().any(|known| write::text(known) == write::text(formula)) {
                found.push(formula.clone());
            }
        }
        Kind::Apply(_, groups) => groups.iter().flatten().for_each(|item| gather_letters(item, found)),
        _ => formula.for_each_child(&mut |child| gather_letters(child, found)),
    }
}

/// (x, y) = (2, 1) as x = 2 and y = 1; of a polar form only the values, whatever its arguments are called.
pub(super) fn assigned(items: Vec<Expr>, polar: bool) -> Vec<Expr> {
    let one = |item: Expr| {
        let Kind::Chain(left, links) = &item.kind else { return vec![item] };
        let ([link], Some(names)) = (links.as_slice(), left.items()) else { return vec![item] };
        let Some(values) = link.expr.items().filter(|values| values.len() == names.len()) else {
            return vec![item];
        };
        let letter = |name: &Expr| matches!(name.kind, Kind::Name(_) | Kind::Subscript(..));
        if link.rel != Rel::Eq || !names.iter().all(letter) {
            return vec![item];
        }
        match polar {
            true => values.to_vec(),
            false => {
                let pairs = names.iter().zip(values);
                pairs.map(|(name, value)| Expr::relation(name.clone(), Rel::Eq, value.clone())).collect()
            }
        }
    };
    items.into_iter().flat_map(one).collect()
}
