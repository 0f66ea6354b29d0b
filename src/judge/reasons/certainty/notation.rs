//! Doubts about notation: operators, matrices, families, brackets, words.

use std::collections::BTreeSet;

use super::Suspect;
use crate::formula::{Accent, Expr, Kind};
use crate::judge::page::context::{Body, Definition};
use crate::judge::page::object::Sort;
use crate::judge::page::statement::{Place, Side};
use crate::judge::page::topic::Topic;
use crate::judge::written::bare::is_word;
use crate::judge::written::features::is_repeated;
use crate::judge::written::names::{Head, bases, is_index_letter, walk};
use crate::language::lexicon::families;
use crate::language::lexicon::letters;
use crate::language::write;
use crate::math::poly::Symbol;

impl Suspect<'_> {
    /// A letter before a bracket is a factor only if it stands somewhere else without one.
    pub(super) fn operator(&self) -> Option<String> {
        let mut callees: Vec<&str> = Vec::new();
        let mut plain: BTreeSet<&str> = BTreeSet::new();
        fn collect<'e>(expr: &'e Expr, callees: &mut Vec<&'e str>, plain: &mut BTreeSet<&'e str>) {
            match &expr.kind {
                Kind::Apply(callee, groups) => {
                    match &callee.kind {
                        Kind::Name(name) => callees.push(name),
                        _ => collect(callee, callees, plain),
                    }
                    groups.iter().flatten().for_each(|argument| collect(argument, callees, plain));
                }
                Kind::Name(name) => {
                    plain.insert(name);
                }
                _ => expr.for_each_child(&mut |child| collect(child, callees, plain)),
            }
        }
        for side in &self.chain.sides {
            collect(&side.expr, &mut callees, &mut plain);
        }
        let place = &self.statement.place;
        let context = &self.checker.context;
        // 𝔼[X + Y], 𝕍X
        let blackboard = |part: &Expr| matches!(part.kind, Kind::Accent(Accent::Blackboard, _));
        if self.any(&mut |part| matches!(&part.kind, Kind::Mul(factors) if factors.iter().any(blackboard))) {
            return Some("a letter with double strokes may be an operator".to_owned());
        }
        let star = |side: &Side| side.latex.contains("\\ast");
        if self.chain.sides[self.at..self.at + 2].iter().any(star) {
            return Some("the star may be another operation".to_owned());
        }
        if let Some(name) = self.function_without_argument() {
            return Some(format!("{name} has no argument here"));
        }
        // E(f) = …, for any function f, may be the error of another rule here.
        let functional = |definition: &Definition| {
            definition.head.flat().iter().any(
                |argument| matches!(&argument.kind, Kind::Name(name) if self.tally.record.unknown.contains(name)),
            )
        };
        if let Some(definition) = self.used().find(|definition| functional(definition)) {
            return Some(format!("{} depends on a function", definition.head.base));
        }
        // y(x + h) = y + h y' + O(h^2)
        let order = |part: &Expr| matches!(&part.kind, Kind::Apply(callee, _) if matches!(&callee.kind, Kind::Name(name) if name == "O"));
        let rest =
            |definition: &Definition| matches!(&definition.body, Body::Formula(body) if body.has(&order));
        if let Some(definition) = self.used().find(|definition| rest(definition)) {
            return Some(format!("{} is given up to a rest only", definition.head.base));
        }
        // (a + bi)(a - bi)
        let unit = |symbol: &Symbol| symbol.is_plain() && symbol.base() == "i";
        if self.symbols().iter().any(unit) && !self.is_spoken_of("i") {
            return Some("i may be the imaginary unit".to_owned());
        }
        // dt, d(t^n)
        let differential =
            callees.contains(&"d") && !self.failure.integers.iter().any(|(name, _)| name == "d");
        if differential {
            return Some("d may be a differential".to_owned());
        }
        let known = |name: &str| {
            plain.contains(name)
                || name.chars().count() > 1 && letters::sign(name).is_none()
                || context.letters.is_function(name)
                || self.is_spoken_of(name)
                || context.visible(name, place).next().is_some()
                || self.tally.record.unknown.contains(name)
                || is_index_letter(name) && self.failure.integers.iter().any(|(own, _)| own == name)
        };
        if let Some(name) = callees.into_iter().find(|name| !known(name)) {
            return Some(format!("{name} may be a function or an operator"));
        }
        // f^{-1}(y) is a value of the inverse.
        let function = |name: &str| {
            // M (b_0, b_1)^T is a product, where M is a matrix.
            let mut plain = context.visible(name, place).map(|(_, definition, _)| &definition.head);
            let value = plain.next().is_some_and(|head| head.arguments.is_none() && head.lower.is_empty());
            context.letters.is_function(name) && !value
                || context.visible(name, place).any(|(_, definition, _)| definition.head.arguments.is_some())
        };
        let inverse = self.any(&mut |part| match &part.kind {
            Kind::Pow(base, exponent) => {
                matches!(&base.kind, Kind::Name(name) if function(name)) && is_minus_one(exponent)
            }
            _ => false,
        });
        if inverse {
            return Some("it may be an inverse function".to_owned());
        }
        // b^0(0), b[t^n]: a value of b, or a product?
        let value = self.any(&mut |part| match &part.kind {
            Kind::Mul(factors) => factors.windows(2).any(|pair| {
                let inner = match &pair[1].kind {
                    Kind::Group(inner) => inner,
                    Kind::List(items) if items.len() == 1 => &items[0],
                    _ => return false,
                };
                let lonely = |name: &Expr| matches!(&without_accents(name).kind, Kind::Name(name) if !plain_elsewhere(name, part, &self.sides()));
                match &pair[0].kind {
                    Kind::Pow(base, _) => lonely(base) && matches!(inner.kind, Kind::Number(_) | Kind::Name(_)),
                    _ => lonely(&pair[0]) && is_repeated(inner),
                }
            }),
            _ => false,
        });
        if value {
            return Some("what stands before the bracket may be a function".to_owned());
        }
        // ΔS_i, where nothing says of what sequence it is a difference
        let difference = self.any(&mut |part| match &part.kind {
            Kind::Mul(factors) => factors.windows(2).any(|pair| {
                matches!(&pair[0].kind, Kind::Name(name) if name == "Delta")
                    && bases(&pair[1]).iter().all(|name| !self.is_spoken_of(name))
            }),
            _ => false,
        });
        let named = self.symbols().iter().any(|symbol| symbol.base() == "Delta");
        (named || difference && !self.claimed()).then(|| "what Δ means is not said".to_owned())
    }

    /// r s r s = r^2 s^2: elements of a group.
    pub(super) fn word_of_a_group(&self) -> Option<String> {
        self.sides().into_iter().any(is_word).then(|| "its letters may be no numbers".to_owned())
    }

    /// Whether a name without upper indices is a member of a family that never has arguments.
    fn is_control_point(&self, head: &Head) -> bool {
        let place = &self.statement.place;
        let mut known = self.checker.context.visible(&head.base, place);
        head.upper.is_empty()
            && !head.lower.is_empty()
            && known.all(|(_, own, _)| own.head.arguments.is_none() || !own.head.upper.is_empty())
    }

    /// A function of the page that stands in a sum or product without an argument, and with one elsewhere:
    /// 2 T_1 T_1(x).
    fn function_without_argument(&self) -> Option<String> {
        let functions: Vec<&Definition> =
            self.used().filter(|definition| definition.head.arguments.is_some()).collect();
        let same = |head: &Head| {
            functions
                .iter()
                // b_i is a control point, where b_i^r(t) are those of the algorithm.
                .any(|known| {
                    known.head.base == head.base
                        && known.head.lower.len() == head.lower.len()
                        && (known.head.upper.len() == head.upper.len() || !self.is_control_point(head))
                })
        };
        let bare = |part: &Expr| Head::of(part).is_some_and(|head| head.arguments.is_none() && same(&head));
        let called = self.any(&mut |part| matches!(&part.kind, Kind::Apply(callee, _) if bare(callee)));
        fn search(expr: &Expr, bare: &dyn Fn(&Expr) -> bool) -> Option<Expr> {
            let inside: Vec<&Expr> = match &expr.kind {
                Kind::Apply(_, groups) => {
                    return groups.iter().flatten().find_map(|inner| search(inner, bare));
                }
                Kind::Add(terms) => terms.iter().map(|term| &term.expr).collect(),
                Kind::Mul(factors) => factors.iter().collect(),
                Kind::Pow(base, _) => vec![base.as_ref()],
                _ => Vec::new(),
            };
            let mut found = inside.into_iter().find(|inner| bare(inner)).cloned();
            expr.for_each_child(&mut |child| found = found.take().or_else(|| search(child, bare)));
            found
        }
        let found = self.sides().into_iter().find_map(|side| search(side, &bare));
        found.filter(|_| called).map(|name| write::text(&name))
    }

    /// Products of matrices, inverses and transposes of what nobody introduced.
    pub(super) fn matrices(&self) -> Option<String> {
        let place = &self.statement.place;
        let context = &self.checker.context;
        let known = |name: &str| self.is_spoken_of(name) || context.visible(name, place).next().is_some();
        let capital = |expr: &Expr| match &expr.kind {
            Kind::Name(name) => name.starts_with(char::is_uppercase).then_some(name.clone()),
            Kind::Subscript(base, _) => match &base.kind {
                Kind::Name(name) if name == "I" => Some(name.clone()),
                _ => None,
            },
            _ => None,
        };
        let mut unknown: Option<String> = None;
        let mut look = |expr: &Expr| {
            if let Some(name) = capital(expr).filter(|name| !known(name)) {
                unknown.get_or_insert(name);
            }
        };
        let mut matrix = false;
        for side in self.sides() {
            walk(side, &mut |part| match &part.kind {
                Kind::Transpose(inner) => {
                    matrix = true;
                    look(inner);
                }
                Kind::Pow(base, exponent) if is_minus_one(exponent) && capital(base).is_some() => {
                    matrix = true;
                    look(base);
                }
                Kind::Mul(factors) => {
                    let capitals = factors.iter().filter(|factor| capital(factor).is_some()).count();
                    if capitals > 1 {
                        matrix = true;
                    }
                    factors.iter().for_each(&mut look);
                }
                Kind::Add(terms) => terms.iter().for_each(|term| look(&term.expr)),
                Kind::Matrix(..) => matrix = true,
                _ => {}
            });
        }
        // \begin{bmatrix} n \\ k \end{bmatrix} counts something.
        let counts = self.any(&mut |part| match &part.kind {
            Kind::Matrix(rows, _) => rows.iter().flatten().flatten().all(|entry| {
                let names = bases(entry);
                let mut member = false;
                walk(entry, &mut |part| member |= matches!(part.kind, Kind::Subscript(..)));
                !member && !names.is_empty() && names.iter().all(|name| is_index_letter(name))
            }),
            _ => false,
        });
        if counts {
            return Some("the bracket may be a number".to_owned());
        }
        let declared = self.any(&mut |part| match &part.kind {
            Kind::Name(name) => {
                context.object_called(name, place).is_some_and(|d| d.object.sort == Sort::Matrix)
            }
            _ => false,
        });
        // Those of a factorisation have properties that words give.
        let determinant = self.any(&mut |part| matches!(&part.kind, Kind::Name(name) if name == "det"));
        let generic = self.tally.record.matrices;
        if determinant && generic {
            return Some("which matrices these are is not said".to_owned());
        }
        if generic && !self.claimed() {
            return Some("it may be a condition on these matrices".to_owned());
        }
        let unit = self.any(&mut |part| matches!(&part.kind, Kind::Name(name) if name == "I"));
        if unit && (matrix || declared) {
            return Some("I may be the unit matrix".to_owned());
        }
        let name = unknown.filter(|_| matrix || declared)?;
        Some(format!("{name} may be a matrix"))
    }

    /// B_i^k on a page about B-splines, or without an argument.
    pub(super) fn family_of_another_kind(&self) -> Option<String> {
        let mut family = |part: &Expr| Head::of(part).is_some_and(|head| head.is_bernstein());
        let assumed = self.tally.record.standard.iter().any(|note| note.contains("Bernstein"));
        if !assumed || !self.any(&mut family) {
            return None;
        }
        let topics = self.statement.topics;
        let mut called = |part: &Expr| matches!(&part.kind, Kind::Apply(callee, _) if Head::of(callee).is_some_and(|head| head.is_bernstein()));
        let agreed = |(letter, place): &(String, Place)| {
            letter == families::BERNSTEIN && self.statement.place.knows(place, false)
        };
        let told = topics.has(Topic::Bernstein)
            || self.checker.context.letters.binomial_family
            || self.checker.agreed.iter().any(agreed);
        // For t_i < t < t_{i+k}: these are knots.
        let member = |condition: &Expr| {
            let mut found = false;
            walk(condition, &mut |part| found |= matches!(part.kind, Kind::Subscript(..)));
            found
        };
        let knots = topics.has(Topic::Spline) || self.chain.conditions.iter().any(member);
        (!told && (knots || !self.any(&mut called)))
            .then(|| "nothing says that the B are Bernstein polynomials".to_owned())
    }
}

/// Whether a name stands in formulas outside of one part of them, without an index.
fn plain_elsewhere(name: &str, part: &Expr, sides: &[&Expr]) -> bool {
    fn count(expr: &Expr, name: &str) -> usize {
        match &expr.kind {
            Kind::Name(own) => usize::from(own == name),
            Kind::Subscript(_, indices) => indices.iter().map(|index| count(index, name)).sum(),
            _ => {
                let mut found = 0;
                expr.for_each_child(&mut |child| found += count(child, name));
                found
            }
        }
    }
    sides.iter().map(|side| count(side, name)).sum::<usize>() > count(part, name)
}

fn without_accents(expr: &Expr) -> &Expr {
    match &expr.kind {
        Kind::Accent(_, inner) => without_accents(inner),
        _ => expr,
    }
}

fn is_minus_one(exponent: &Expr) -> bool {
    exponent.as_signed_int() == Some(-1)
}
