//! What the table says, read.
//!
//! ```text
//! # degree elevation
//! about elevation
//! where 1 \le i \le n
//! c_i = \frac{i}{n+1} b_{i-1} + \left(1 - \frac{i}{n+1}\right) b_i
//! ```
//! `about` names topics of which the section has to speak, with bars between those of which one will do; `polar f(n)`
//! says that f is symmetric with n arguments; `even` that all intervals have one length; `contact r` that two curves
//! have contact of order r. Every other line is the
//! equation, or the same one written in another way. After `order` n is an order, in the others a degree. `not` gives a right
//! side of the equation before it that is often taken for it, `or` one of which nothing can be said, since with it the
//! left side is something else that is as usual. `mean` says to the tests what the letters are, so that both
//! sides can be calculated from that.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::forms::with_windows;
use super::letters::Profile;
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::topic::{Topic, Topics};
use crate::language::latex;

const TABLES: &[&str] = &[
    include_str!("tables/polar.txt"),
    include_str!("tables/bernstein.txt"),
    include_str!("tables/curves.txt"),
    include_str!("tables/splines.txt"),
    include_str!("tables/interpolation.txt"),
    include_str!("tables/surfaces.txt"),
];

/// An equation of the field.
pub(super) struct Equation {
    pub(super) left: Expr,
    pub(super) right: Expr,
    /// Whether n is an order in it.
    pub(super) order: bool,
    pub(super) profile: Profile,
    /// Right sides that are often taken for it.
    pub(super) misremembered: Vec<Expr>,
    /// Right sides with which the letter on the left stands for something else, as it does for many.
    pub(super) conventions: Vec<Expr>,
}

/// A theorem of the field.
pub(super) struct Theorem {
    /// What it is called in reports.
    pub(super) name: &'static str,
    /// Of each of these groups the section speaks of one.
    about: Vec<Vec<Topic>>,
    /// Polar forms with the number of their arguments.
    pub(super) polar: Vec<(String, Expr)>,
    /// What its letters stand for where it is checked.
    pub(super) meaning: &'static str,
    /// For which integers it holds.
    pub(super) conditions: Vec<Expr>,
    /// Whether all intervals have to have one length.
    pub(super) even: bool,
    /// So many arguments are free where two curves meet; the page says with how many derivatives.
    pub(super) contact: Option<String>,
    /// The equation in the ways in which it is written.
    pub(super) equations: Vec<Equation>,
}

impl Theorem {
    fn new(name: &'static str) -> Self {
        Theorem {
            name,
            about: Vec::new(),
            polar: Vec::new(),
            meaning: "",
            conditions: Vec::new(),
            even: false,
            contact: None,
            equations: Vec::new(),
        }
    }

    /// Whether a section speaks of it. Where weights are spoken of nothing is known without them.
    pub(super) fn is_spoken_of(&self, topics: Topics) -> bool {
        (!topics.has(Topic::Rational) || self.is_about(Topic::Rational))
            && self.about.iter().all(|group| group.iter().any(|topic| topics.has(*topic)))
    }

    /// One topic of each group.
    #[cfg(test)]
    pub(super) fn first_topics(&self) -> impl Iterator<Item = Topic> {
        self.about.iter().filter_map(|group| group.first().copied())
    }

    /// Whether it differs by whether n is a degree or an order.
    pub(super) fn has_orders(&self) -> bool {
        self.equations.iter().any(|equation| equation.order)
    }

    /// The degree of what it is about, if that is a number.
    pub(super) fn degree(&self) -> Option<i64> {
        self.meaning.split(' ').find_map(|word| word.strip_prefix("degree")?.parse().ok())
    }

    /// Whether its letters stand for something of this kind where it is checked.
    pub(super) fn means(&self, kind: &str) -> bool {
        self.meaning.split(' ').any(|word| word == kind)
    }

    /// How many derivatives have to agree where two curves meet: 1, if it is one on C^1.
    pub(super) fn smoothness(&self) -> Option<i64> {
        let contact = self.contact.as_ref().and_then(|order| order.parse().ok());
        contact.or_else(|| self.name.split(' ').find_map(|word| word.strip_prefix("C^")?.parse().ok()))
    }

    pub(super) fn is_about(&self, topic: Topic) -> bool {
        self.about.iter().flatten().any(|own| *own == topic)
    }

    fn line(&mut self, line: &'static str) -> Result<(), String> {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        let read = |text: &str| latex::read(text).map_err(|error| error.message);
        match word {
            "about" => {
                let topic = |word: &str| Topic::of_word(word).ok_or_else(|| format!("no topic {word}"));
                let group = |words: &str| words.split('|').map(topic).collect::<Result<Vec<_>, _>>();
                self.about = rest.split(' ').map(group).collect::<Result<_, _>>()?;
            }
            "polar" => {
                for one in rest.split(' ') {
                    let (letter, arity) = one.trim_end_matches(')').split_once('(').ok_or("no number")?;
                    self.polar.push((letter.to_owned(), read(arity)?));
                }
            }
            // What the letters stand for where that is checked.
            "mean" => self.meaning = rest,
            "not" => {
                let wrong = read(rest)?.without_spans();
                self.equations.last_mut().ok_or("not what?")?.misremembered.push(wrong);
            }
            "or" => {
                let other = read(rest)?.without_spans();
                self.equations.last_mut().ok_or("or what?")?.conventions.push(other);
            }
            "where" => self.conditions = rest.split(';').map(read).collect::<Result<_, _>>()?,
            "even" => self.even = true,
            "contact" => self.contact = Some(rest.to_owned()),
            _ => {
                let (order, text) = if word == "order" { (true, rest) } else { (false, line) };
                let Kind::Chain(left, links) = read(text)?.kind else { return Err("no equation".to_owned()) };
                let [link] = links.as_slice() else { return Err("no equation".to_owned()) };
                if link.rel != Rel::Eq {
                    return Err("no equation".to_owned());
                }
                let (left, right) = (with_windows(&left), with_windows(&link.expr));
                let profile = Profile::of(&[&left, &right], &BTreeSet::new(), &|_| false);
                let (left, right) = (left.without_spans(), right.without_spans());
                let (misremembered, conventions) = Default::default();
                self.equations.push(Equation { left, right, order, profile, misremembered, conventions });
            }
        }
        Ok(())
    }
}

thread_local! {
    static KNOWN: Rc<Vec<Theorem>> = Rc::new(TABLES.iter().flat_map(|text| of_text(text)).collect());
}

/// All theorems, read when they are first asked for.
pub(super) fn known() -> Rc<Vec<Theorem>> {
    KNOWN.with(Rc::clone)
}

/// The theorems of a table.
pub(super) fn of_text(text: &'static str) -> Vec<Theorem> {
    let mut found: Vec<Theorem> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        match line.strip_prefix("# ") {
            Some(name) => found.push(Theorem::new(name)),
            None => {
                // The tests say what is wrong with a line.
                if let Some(theorem) = found.last_mut() {
                    let result = theorem.line(line);
                    debug_assert!(result.is_ok(), "{}: {line}: {result:?}", theorem.name);
                }
            }
        }
    }
    found
}
