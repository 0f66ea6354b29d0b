//! Every entry of the table, spoilt in each way in which slips happen, fits none; on pages where its letters mean
//! something else it says nothing.

use std::rc::Rc;

use super::{all, instances, random_sides};
use crate::budget::Limits;
use crate::formula::source::SourceFile;
use crate::formula::{Expr, Kind, Rel, Sign, Term};
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::blank;
use crate::judge::page::object::{Declared, Object, Sort};
use crate::judge::page::statement::{Chain, Layout, Place, Said, Side, Statement};
use crate::judge::theorems::entry::{Equation, Theorem, known};
use crate::judge::theorems::fit::Standing;
use crate::judge::written::names::{Head, walk};

/// A side with one slip: a sign, an index, a factor, two members exchanged.
fn slips(side: &Expr) -> Vec<Expr> {
    let mut found = vec![Expr::product(vec![Expr::int(2), side.clone().grouped()])];
    let mut parts: Vec<Expr> = Vec::new();
    walk(side, &mut |part| parts.push(part.clone()));
    let mut put = |old: &Expr, new: Expr| {
        let mut edit = side.clone();
        replace_first(&mut edit, old, &new);
        found.push(edit);
    };
    let members: Vec<&Expr> = parts.iter().filter(|part| matches!(part.kind, Kind::Subscript(..))).collect();
    if let Some(sum) = parts.iter().find(|part| matches!(&part.kind, Kind::Add(terms) if terms.len() > 1))
        && let Kind::Add(terms) = &sum.kind
    {
        let mut terms: Vec<Term> = terms.clone();
        let last = terms.len() - 1;
        terms[last].sign = if terms[last].sign == Sign::Plus { Sign::Minus } else { Sign::Plus };
        put(sum, Expr::new(Kind::Add(terms), sum.span));
    }
    if let Some(member) = members.first()
        && let Kind::Subscript(base, indices) = &member.kind
    {
        let mut indices = indices.clone();
        indices[0] = indices[0].clone().plus(1);
        put(member, Expr::new(Kind::Subscript(base.clone(), indices), member.span));
    }
    if let [one, .., other] = members.as_slice()
        && !one.same_as(other)
    {
        let between = Expr::name("between");
        let mut edit = side.clone();
        for (old, new) in [(*one, &between), (*other, *one), (&between, *other)] {
            replace_all(&mut edit, old, new);
        }
        found.push(edit);
    }
    found
}

fn replace_first(expr: &mut Expr, old: &Expr, new: &Expr) -> bool {
    if expr.same_as(old) {
        *expr = new.clone().grouped();
        return true;
    }
    let mut done = false;
    expr.for_each_child_mut(&mut |child| done = done || replace_first(child, old, new));
    done
}

fn replace_all(expr: &mut Expr, old: &Expr, new: &Expr) {
    match expr.same_as(old) {
        true => *expr = new.clone(),
        false => expr.for_each_child_mut(&mut |child| replace_all(child, old, new)),
    }
}

fn place() -> Place {
    Place::from(Layout { formula: 1, ..Layout::default() })
}

/// A claim in a section that speaks of all that a theorem is about.
fn claimed(theorem: &Theorem, left: &Expr, right: &Expr) -> (Chain, Statement) {
    let side = |expr: &Expr| Side { expr: expr.clone(), latex: String::new() };
    let chain = Chain::new(vec![side(left), side(right)], vec![(Rel::Eq, right.span)]);
    let mut statement = Statement::new(Said::Chain(chain.clone()), place());
    for topic in theorem.first_topics() {
        statement.topics.add(topic);
    }
    (chain, statement)
}

/// Whether a claim is certainly an instance of some theorem.
fn is_proved(checker: &Checker, theorem: &Theorem, left: &Expr, right: &Expr) -> Option<String> {
    let (chain, statement) = claimed(theorem, left, right);
    let known = known();
    let claim = checker.claim(left, right, &chain, &statement.place);
    let instances = checker.instances(&known, &claim, &statement, &blank(&chain, 0));
    let certain = instances.iter().filter(|instance| instance.standing == Standing::Certain);
    certain.filter(|instance| claim.fits(instance)).map(|instance| instance.theorem.name.to_owned()).next()
}

/// Whether a spoilt right side is another one where its letters are known.
fn is_wrong(theorem: &Theorem, equation: &Equation, right: &Expr) -> bool {
    instances(theorem, &equation.profile).into_iter().take(6).any(|integers| {
        random_sides(theorem, equation, &[right], integers).is_some_and(|values| values[0] != values[1])
    })
}

#[test]
fn what_is_spoilt_fits_nothing() {
    let checker = Checker::new(&SourceFile::new("page", ""), &Limits::default(), &[]);
    let (mut wrong, mut tried, mut right) = (Vec::new(), 0, 0);
    for (number, theorem) in all().iter().filter(|theorem| theorem.meaning != "elsewhere").enumerate() {
        // Each kind of slip in every third entry
        for equation in theorem.equations.iter().filter(|equation| !equation.order).take(1) {
            right += usize::from(is_proved(&checker, theorem, &equation.left, &equation.right).is_some());
            for (_, slip) in
                slips(&equation.right).into_iter().enumerate().filter(|(at, _)| (at + number) % 3 == 0)
            {
                if !is_wrong(theorem, equation, &slip) {
                    continue;
                }
                tried += 1;
                if let Some(name) = is_proved(&checker, theorem, &equation.left, &slip) {
                    let text = crate::language::write::text(&slip);
                    wrong.push(format!("{}: {text} is taken for {name}", theorem.name));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(tried > 100 && right > 80, "{tried} slips, {right} right ones");
}

#[test]
fn letters_that_mean_something_else_are_no_instance() {
    let mut tried = 0;
    for theorem in all().iter() {
        for equation in theorem.equations.iter().take(1) {
            let Some(head) = Head::of(&equation.left).filter(|head| head.arguments.is_none()) else {
                continue;
            };
            if !matches!(head.base.as_str(), "b" | "c" | "d" | "p" | "q") {
                continue;
            }
            let mut checker = Checker::new(&SourceFile::new("page", ""), &Limits::default(), &[]);
            let name = Expr::from(Kind::Subscript(Box::new(Expr::name(&head.base)), vec![Expr::name("i")]));
            let object = Rc::new(Object { names: vec![name], ..Object::new(Sort::Knots) });
            let before = Place::default();
            Rc::make_mut(&mut checker.context).declare(Declared { object, place: before, line: 1 });
            tried += 1;
            assert_eq!(
                is_proved(&checker, theorem, &equation.left, &equation.right),
                None,
                "{}: {} are knots",
                theorem.name,
                head.base
            );
        }
    }
    assert!(tried > 30, "{tried}");
}
