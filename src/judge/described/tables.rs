//! Tables of numbers, cell by cell, against the scheme that the section names.
//!
//! **Definition.** A cell of column r follows from the two beside it in column r − 1, the upper one a and the lower one
//! b: (1 − t) a + t b in the scheme of de Casteljau at t; (b − a)/(x_{i+r} − x_i) for divided differences with the
//! nodes x_i; b − a for differences; ((x − x_i) b − (x − x_{i+r}) a)/(x_{i+r} − x_i) in the scheme of Neville at x.
//!
//! **Rule.** A cell is right if it follows from the cells beside it, or from the first column alone. It is wrong if it
//! does neither, and at least twice as many others are right. A table of which less is right is not that scheme, and
//! nothing is said of it.

use crate::formula::source::Span;
use crate::formula::{Expr, Kind};
use crate::judge::known::checker::Checker;
use crate::judge::known::found::Point;
use crate::judge::page::finding::{Evidence, Finding, Verdict, of_side, without_statement};
use crate::judge::page::statement::{Side, Statement, Triangle};
use crate::judge::page::topic::Topic;
use crate::judge::values::evaluator;
use crate::judge::values::rounding::last_digit;
use crate::language::write;
use crate::math::number::{Rational, integer, rational};
use num_traits::{One, Signed, Zero};

/// How a column of the scheme follows from the one before.
enum Rule {
    Casteljau(Rational),
    Divided(Vec<Rational>),
    Difference,
    Neville(Rational, Vec<Rational>),
}

impl Rule {
    fn name(&self) -> String {
        match self {
            Rule::Casteljau(t) => format!("de Casteljau's scheme at {t}"),
            Rule::Divided(_) => "the scheme of divided differences".to_owned(),
            Rule::Difference => "the scheme of differences".to_owned(),
            Rule::Neville(x, _) => format!("Neville's scheme at {x}"),
        }
    }

    /// Whether cells lie between their neighbours, as far as that can be.
    fn is_between(&self) -> bool {
        !matches!(self, Rule::Casteljau(t) if t.is_negative() || *t > Rational::one())
    }

    /// The factors of the upper and the lower neighbour of cell `i` of column `level`; none where nodes are equal.
    fn weights(&self, level: usize, i: usize) -> Option<(Rational, Rational)> {
        let width = |nodes: &[Rational]| {
            let width = &nodes[i + level] - &nodes[i];
            (!width.is_zero()).then_some(width)
        };
        Some(match self {
            Rule::Casteljau(t) => (Rational::one() - t, t.clone()),
            Rule::Divided(nodes) => {
                let factor = width(nodes)?.recip();
                (-factor.clone(), factor)
            }
            Rule::Difference => (-Rational::one(), Rational::one()),
            Rule::Neville(x, nodes) => {
                let width = width(nodes)?;
                ((&nodes[i + level] - x) / &width, (x - &nodes[i]) / width)
            }
        })
    }

    /// Cell `i` of column `level` from the column before.
    fn cell(&self, level: usize, i: usize, before: &[Point]) -> Option<Point> {
        let (upper, lower) = self.weights(level, i)?;
        Some(before[i].iter().zip(&before[i + 1]).map(|(a, b)| a * &upper + b * &lower).collect())
    }
}

/// What a rule says of a table: for each cell after the first column what it should be, and whether it is.
struct Comparison {
    cells: Vec<(usize, usize, Point, bool)>,
}

impl Comparison {
    fn of(rule: &Rule, columns: &[Vec<Point>], written: &[Vec<Side>]) -> Option<Self> {
        let mut cells = Vec::new();
        let mut exact = columns[0].clone();
        for level in 1..columns.len() {
            let next = (0..columns[level].len()).map(|i| rule.cell(level, i, &exact));
            let next: Vec<Point> = next.collect::<Option<_>>()?;
            for (i, own) in columns[level].iter().enumerate() {
                let near = rule.cell(level, i, &columns[level - 1])?;
                let decimal = written[level][i].latex.contains(['.', ',']);
                let right = [&near, &next[i]].into_iter().any(|value| agrees(own, value, decimal));
                cells.push((level, i, near, right));
            }
            exact = next;
        }
        let found = Comparison { cells };
        let (wrong, all) = (found.wrong(), found.cells.len());
        (all > 0 && all >= 3 * wrong).then_some(found)
    }

    /// How many cells are wrong.
    fn wrong(&self) -> usize {
        self.cells.iter().filter(|(.., right)| !right).count()
    }
}

/// Whether a cell is the value, or shows it to its last decimal digit, of two at least.
fn agrees(own: &Point, value: &Point, decimal: bool) -> bool {
    let rounded = |a: &Rational, b: &Rational| {
        let unit = last_digit(a).filter(|unit| *unit <= rational(1, 100));
        decimal && unit.is_some_and(|unit| (a - b).abs() * integer(2) <= unit)
    };
    own.len() == value.len() && own.iter().zip(value).all(|(a, b)| a == b || rounded(a, b))
}

impl Checker {
    /// Judges a table cell by cell, if its section names the scheme and gives what the scheme needs.
    /// Its formulas that are not judged are reported as such.
    pub(in crate::judge) fn triangle(
        &mut self,
        readings: &[Triangle],
        formulas: &[Side],
        statement: &Statement,
    ) {
        let mut findings = self.cells(readings, statement);
        let judged = |side: &&Side| !findings.iter().any(|finding| finding.span == side.expr.span);
        let rest: Vec<Finding> = formulas.iter().filter(judged).map(without_statement).collect();
        findings.extend(rest);
        findings.sort_by_key(|finding| finding.span.start);
        self.findings.extend(findings);
    }

    fn cells(&self, readings: &[Triangle], statement: &Statement) -> Vec<Finding> {
        let mut best: Option<(&Triangle, Rule, Comparison)> = None;
        for triangle in readings {
            let columns = triangle.columns.iter().map(|column| points(column));
            let Some(columns) = columns.collect::<Option<Vec<_>>>() else { continue };
            for rule in self.rules(triangle, statement) {
                let Some(found) = Comparison::of(&rule, &columns, &triangle.columns) else { continue };
                let better = |(_, known, other): &(&Triangle, Rule, Comparison)| {
                    (rule.is_between(), other.wrong()) > (known.is_between(), found.wrong())
                };
                if best.as_ref().is_none_or(better) {
                    best = Some((triangle, rule, found));
                }
            }
        }
        let Some((triangle, rule, comparison)) = best else { return Vec::new() };
        let fractions = triangle.columns.iter().flatten().any(|side| side.latex.contains('\\'));
        let mut findings = Vec::with_capacity(comparison.cells.len());
        for (level, i, value, right) in comparison.cells {
            let side = &triangle.columns[level][i];
            let mut finding = of_side(side, Verdict::Proved, 1);
            finding.reason = Some(rule.name());
            if !right {
                let value = expr(&value);
                let (upper, lower) = (&triangle.columns[level - 1][i], &triangle.columns[level - 1][i + 1]);
                let witness = format!(
                    "the cells beside it, {} and {}, give {}",
                    write::text(&upper.expr),
                    write::text(&lower.expr),
                    write::text(&value)
                );
                finding = Finding {
                    verdict: Verdict::Refuted,
                    reason: Some(format!("it differs from {}", rule.name())),
                    witness: Some(witness),
                    suggestion: Some(if fractions { write::latex(&value) } else { write::text(&value) }),
                    evidence: vec![Evidence::Names],
                    ..finding
                };
            }
            findings.push(finding);
        }
        findings
    }

    /// The schemes that the section speaks of, the more special ones first.
    fn rules(&self, triangle: &Triangle, statement: &Statement) -> Vec<Rule> {
        let topics = &statement.topics;
        let nodes = || -> Option<Vec<Rational>> {
            let nodes = points(triangle.nodes.as_ref()?)?;
            nodes.into_iter().map(|mut node| node.pop().filter(|_| node.is_empty())).collect()
        };
        let parameters: Vec<Rational> =
            self.parameters_of_scheme(&statement.place).into_iter().map(|(_, t)| t).collect();
        let mut rules = Vec::new();
        if topics.has(Topic::Neville)
            && let Some(nodes) = nodes()
        {
            rules.extend(parameters.iter().map(|x| Rule::Neville(x.clone(), nodes.clone())));
        }
        if topics.has(Topic::DividedDifference)
            && let Some(nodes) = nodes()
        {
            rules.push(Rule::Divided(nodes));
        }
        if topics.has(Topic::Casteljau) && !topics.has(Topic::Rational) {
            rules.extend(parameters.into_iter().map(Rule::Casteljau));
        }
        if topics.has(Topic::Difference) {
            rules.push(Rule::Difference);
        }
        rules
    }
}

fn points(column: &[Side]) -> Option<Vec<Point>> {
    column.iter().map(|side| point(&side.expr)).collect()
}

fn point(expr: &Expr) -> Option<Point> {
    let value = evaluator::machine().eval(expr).ok()?;
    match value.as_rational() {
        Some(q) => Some(vec![q]),
        None => value.coordinates()?.iter().map(|part| part.as_rational()).collect(),
    }
}

fn expr(point: &Point) -> Expr {
    match point.as_slice() {
        [q] => Expr::number(q),
        _ => Expr::new(Kind::Tuple(point.iter().map(Expr::number).collect()), Span::default()),
    }
}
