//! Polar forms of sums, products and compositions: distinct arguments, then symmetrise.

use super::lines::{TERMS_UP_TO, call, chain, factor, line, mean, product, subscript, symbol};
use super::polar::{given, univariate};
use super::words::{Reason, Title};
use crate::formula::{Expr, Sign, Term};
use crate::language::value::{Derivation, Line, Notation, Polar, grouped_expr, polynomial_expr, symbol_expr};
use crate::math::blossom::PolarForm;
use crate::math::number::{Combinations, Int, binomial};
use crate::math::poly::{Fraction, Symbol};

/// How two polynomials are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// F + G
    Sum,
    /// F G
    Product,
    /// F∘G
    Composition,
}

/// The derivation of the polar form of a sum, product or composition, given those of the operands
/// and the result, in whose variable all is written: F, G and H with the polar forms f, g and h.
///
/// Cost: that of writing out what stands in it.
pub fn combination(
    kind: Combination,
    f: &PolarForm<Fraction>,
    g: &PolarForm<Fraction>,
    result: &Polar,
) -> Derivation {
    let title = match kind {
        Combination::Sum => Title::Sum,
        Combination::Product => Title::Product,
        Combination::Composition => Title::Composition,
    };
    let lines = Pair { left: f, right: g, t: &result.variables[0] }.lines(kind, result);
    Derivation { title: title.words(), lines, language: None }
}

/// The polar form of F with `degree` arguments: the polar form with one or more arguments left
/// out, in all ways. `None` if there are too many of them to be written.
pub(super) fn left_out(name: &Expr, form: &PolarForm<Fraction>, degree: usize, t: &Symbol) -> Option<Expr> {
    let count = binomial(degree, form.degree());
    (count <= Int::from(TERMS_UP_TO)).then(|| {
        let calls = Combinations::new(degree, form.degree()).map(|chosen| {
            let arguments = chosen.iter().map(|&k| symbol_expr(&t.numbered(k as i64 + 1))).collect();
            value_of(name, form, arguments)
        });
        mean(calls.collect())
    })
}

/// name(arguments); the constant itself for a form without arguments.
fn value_of(name: &Expr, form: &PolarForm<Fraction>, arguments: Vec<Expr>) -> Expr {
    if arguments.is_empty() {
        return polynomial_expr(&form.coefficients()[0]);
    }
    call(name.clone(), arguments)
}

struct Pair<'a> {
    left: &'a PolarForm<Fraction>,
    right: &'a PolarForm<Fraction>,
    t: &'a Symbol,
}

impl Pair<'_> {
    fn lines(&self, kind: Combination, result: &Polar) -> Vec<Line> {
        let (f, g) = (univariate(self.left.clone(), self.t), univariate(self.right.clone(), self.t));
        let mut lines =
            vec![given(Expr::name("F"), &f, Reason::Given), given(Expr::name("G"), &g, Reason::Given)];
        let at = |name: &str, argument: Expr| Expr::apply(Expr::name(name), vec![argument]);
        let t = || symbol_expr(self.t);
        let plus = |expr| Term { sign: Sign::Plus, expr };
        let combined = match kind {
            Combination::Sum => Expr::sum(vec![plus(at("F", t())), plus(at("G", t()))]),
            Combination::Product => Expr::product(vec![at("F", t()), at("G", t())]),
            Combination::Composition => at("F", at("G", t())),
        };
        let whole = chain([at("H", t()), combined, grouped_expr(&result.diagonal())]);
        lines.push(line(whole, Reason::Wanted));
        lines.push(line(f.equation(Expr::name("f"), Notation::Grouped), Reason::PolarFormOf("F")));
        lines.push(line(g.equation(Expr::name("g"), Notation::Grouped), Reason::PolarFormOf("G")));
        let last = match kind {
            Combination::Sum => self.sum(&mut lines),
            Combination::Product => self.product(&mut lines),
            Combination::Composition => self.composition(&mut lines),
        };
        lines.push(line(result.equation(Expr::name("h"), Notation::Grouped), last));
        lines
    }

    fn argument(&self, k: usize) -> Expr {
        symbol_expr(&self.t.numbered(k as i64))
    }

    fn range(&self, from: usize, to: usize) -> Vec<Expr> {
        (from..=to).map(|k| self.argument(k)).collect()
    }

    /// h(t_1, …, t_n)
    fn whole(&self, n: usize) -> Expr {
        call(Expr::name("h"), self.range(1, n))
    }

    fn sum(&self, lines: &mut Vec<Line>) -> Reason {
        let degree = self.left.degree().max(self.right.degree());
        let mut operand = |letter: &str, form: &PolarForm<Fraction>| {
            let name = Expr::name(letter);
            if form.degree() == degree {
                return value_of(&name, form, self.range(1, degree));
            }
            let raised = univariate(form.elevate(degree - form.degree()), self.t);
            let left = raised.call(subscript(letter, &[degree]));
            let mean = left_out(&name, form, degree, self.t);
            let body = raised.body(Notation::Grouped);
            lines.push(line(
                chain([left.clone()].into_iter().chain(mean).chain([body])),
                Reason::LeaveOut { from: form.degree(), to: degree },
            ));
            left
        };
        let sum = [operand("f", self.left), operand("g", self.right)];
        let terms = sum.into_iter().map(|expr| Term { sign: Sign::Plus, expr }).collect();
        lines.push(line(chain([self.whole(degree), Expr::sum(terms)]), Reason::SameArguments));
        Reason::Added
    }

    fn product(&self, lines: &mut Vec<Line>) -> Reason {
        let (m, n) = (self.left.degree(), self.right.degree());
        let pair = |first: Vec<Expr>, second: Vec<Expr>| {
            let f = value_of(&Expr::name("f"), self.left, first);
            product(vec![factor(f), factor(value_of(&Expr::name("g"), self.right, second))])
        };
        let body = |form: &PolarForm<Fraction>, offset: usize| {
            let arguments: Vec<Fraction> =
                (1..=form.degree()).map(|k| symbol(&self.t.numbered((offset + k) as i64))).collect();
            form.value(&arguments).map_or_else(|_| Expr::int(0), |value| polynomial_expr(&value))
        };
        if m == 0 || n == 0 {
            lines.push(line(
                chain([self.whole(m + n), pair(self.range(1, m), self.range(m + 1, m + n))]),
                Reason::ConstantFactor,
            ));
            return Reason::PutTogether;
        }
        let written = product(vec![factor(body(self.left, 0)), factor(body(self.right, m))]);
        lines.push(line(
            chain([pair(self.range(1, m), self.range(m + 1, m + n)), written]),
            Reason::DistinctArguments,
        ));
        let count = binomial(m + n, m);
        if count <= Int::from(TERMS_UP_TO) {
            let items = Combinations::new(m + n, m).map(|chosen| {
                let take = |inside: bool| {
                    (0..m + n)
                        .filter(|k| chosen.contains(k) == inside)
                        .map(|k| self.argument(k + 1))
                        .collect()
                };
                pair(take(true), take(false))
            });
            let sides = [self.whole(m + n), mean(items.collect())];
            lines.push(line(chain(sides), Reason::SymmetrisedProduct { count: count.clone(), m, n }));
            return Reason::PutTogether;
        }
        Reason::SymmetrisedProduct { count, m, n }
    }

    fn composition(&self, lines: &mut Vec<Line>) -> Reason {
        let (m, n) = (self.left.degree(), self.right.degree());
        let inner = |block: &[usize]| {
            let arguments = block.iter().map(|&k| self.argument(k + 1)).collect();
            value_of(&Expr::name("g"), self.right, arguments)
        };
        let outer = |blocks: &[Vec<usize>]| {
            value_of(&Expr::name("f"), self.left, blocks.iter().map(|b| inner(b)).collect())
        };
        if m == 0 || n == 0 {
            let blocks = vec![Vec::new(); m];
            let value = if m == 0 { polynomial_expr(&self.left.coefficients()[0]) } else { outer(&blocks) };
            lines.push(line(chain([self.whole(0), value]), Reason::ConstantInside));
            return Reason::PutTogether;
        }
        let first: Vec<Vec<usize>> = (0..m).map(|k| (k * n..(k + 1) * n).collect()).collect();
        let values: Option<Vec<Fraction>> = first
            .iter()
            .map(|block| {
                let arguments: Vec<Fraction> =
                    block.iter().map(|&k| symbol(&self.t.numbered(k as i64 + 1))).collect();
                self.right.value(&arguments).ok()
            })
            .collect();
        if let Some(value) = values.and_then(|values| self.left.value(&values).ok()) {
            lines.push(line(chain([outer(&first), polynomial_expr(&value)]), Reason::DistinctInside));
        }
        let count = block_count(m, n);
        if count <= Int::from(TERMS_UP_TO) {
            let items = blocks(m, n).iter().map(|blocks| outer(blocks)).collect();
            let sides = [self.whole(m * n), mean(items)];
            lines.push(line(chain(sides), Reason::SymmetrisedComposition { count: count.clone(), m, n }));
            return Reason::PutTogether;
        }
        Reason::SymmetrisedComposition { count, m, n }
    }
}

/// The number of ways to share out mn arguments among m blocks of n: ∏ C(kn − 1, n − 1).
fn block_count(m: usize, n: usize) -> Int {
    (1..=m).map(|k| binomial(k * n - 1, n - 1)).product()
}

/// All these ways; each block begins with the first argument that is left.
fn blocks(m: usize, n: usize) -> Vec<Vec<Vec<usize>>> {
    fn share(left: &[usize], n: usize, sofar: &mut Vec<Vec<usize>>, found: &mut Vec<Vec<Vec<usize>>>) {
        let Some((first, rest)) = left.split_first() else {
            found.push(sofar.clone());
            return;
        };
        for chosen in Combinations::new(rest.len(), n - 1) {
            let block: Vec<usize> = std::iter::once(*first).chain(chosen.iter().map(|&k| rest[k])).collect();
            let others: Vec<usize> = rest.iter().copied().filter(|k| !block.contains(k)).collect();
            sofar.push(block);
            share(&others, n, sofar, found);
            sofar.pop();
        }
    }
    let mut found = Vec::new();
    share(&(0..m * n).collect::<Vec<_>>(), n, &mut Vec::new(), &mut found);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_counted() {
        for (m, n, count) in [(1, 4, 1), (2, 2, 3), (2, 3, 10), (3, 2, 15), (4, 1, 1)] {
            let all = blocks(m, n);
            assert_eq!((all.len(), block_count(m, n)), (count, Int::from(count)), "{m} blocks of {n}");
            assert!(all.iter().flatten().all(|block| block.len() == n));
        }
    }
}
