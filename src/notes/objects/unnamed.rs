//! Functions of a basis that the words of a section name and its formulas write, without a word that ties the two:
//! "products of Bernstein polynomials", and then ∫ b_{i,n}(x) b_{j,n}(x) dx.

use std::collections::{BTreeMap, BTreeSet};

use super::page::{Page, Section};
use crate::formula::{Expr, Kind};
use crate::judge::page::object::{Object, Sort};
use crate::judge::written::names::{Head, walk};
use crate::language::lexicon::roles::is_variable;
use crate::notes::speech;

/// Letters that such functions have where nobody says more.
const LETTERS: &[&str] = &["b", "beta", "phi"];

/// A letter with two indices that is called with a variable, in a section that speaks of Bernstein polynomials without a
/// name, stands for them, if nothing on the page says what it is.
///
/// Cost: linear in the words and formulas.
pub(super) fn tell(sections: &[Section], page: &Page, found: &mut BTreeMap<usize, Vec<Object>>) {
    let known: BTreeSet<String> = found
        .values()
        .flatten()
        .flat_map(|own| own.names.iter().filter_map(Head::of))
        .map(|head| head.base)
        .collect();
    let mut defined = BTreeSet::new();
    for said in page.formulas.values().flatten() {
        if let Kind::Chain(left, _) = &said.kind
            && let Some(head) = Head::of(left)
        {
            defined.insert(head.base);
        }
    }
    for section in sections {
        if !section.words().any(|words| speech::speaks_of(words, &Sort::Bernstein)) {
            continue;
        }
        let mut told = BTreeSet::new();
        for number in &section.numbers {
            let mut members = Vec::new();
            for said in page.said(*number) {
                walk(said, &mut |part| members.extend(member(part)));
            }
            for (letter, name) in members {
                let free = !known.contains(&letter) && !defined.contains(&letter);
                if free && told.insert(letter) {
                    let own = Object { names: vec![name], ..Object::new(Sort::Bernstein) };
                    found.entry(*number).or_default().push(own);
                }
            }
        }
    }
}

/// The letter and the name of b_{i,n}(x).
fn member(part: &Expr) -> Option<(String, Expr)> {
    let Kind::Apply(callee, groups) = &part.kind else { return None };
    let head = Head::of(callee).filter(|head| LETTERS.contains(&head.base.as_str()))?;
    let variable = |argument: &Expr| matches!(&argument.kind, Kind::Name(name) if is_variable(name));
    let called = matches!(groups.as_slice(), [only] if matches!(only.as_slice(), [one] if variable(one)));
    let named = |index: &&Expr| matches!(index.kind, Kind::Name(_));
    let indices: Vec<&Expr> = head.lower.iter().chain(&head.upper).collect();
    (called && indices.len() == 2 && indices.iter().all(named)).then(|| (head.base, callee.as_ref().clone()))
}
