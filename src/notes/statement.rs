//! From the formulas of a document to statements: chains of relations with what is said of them.
//!
//! A display may hold several chains, a chain may run over several rows, displays or pieces in a
//! line, and conditions follow the formula they belong to: in it, after a comma, or after words
//! such as "where".

use std::collections::BTreeSet;

use super::blocks::{Blocks, Changes, count_new_values, items_of_data, lettered_part};
use super::brackets;
use super::cases::read_conditions;
use super::conditions::{announces_condition, attach, is_condition, is_condition_word, is_smoothness};
use super::items::{ordered_members, regrouped, with_alternatives, with_doubtful_numbers};
use super::objects;
use super::primes;
use super::sentence;
use super::spare;
use super::speech::{self, Block};
use super::superscripts;
use super::triangles::{self, Table};
use crate::document::{Document, Enclosure, Formula, Item, Style};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Rel, interval, spread};
use crate::judge::page::statement::{Chain, Layout, Place, Said, Side, Statement};
use crate::judge::page::topic::{Topic, Topics};
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::diagnostic::Diagnostic;
use crate::language::lexicon::roles::is_variable;
use crate::language::{latex, syntax};

/// So many letters before a formula say what its sentence speaks of.
const LAST_WORDS: usize = 400;

/// The statements of a document in order.
pub fn statements(document: &Document) -> Vec<Statement> {
    let words = document.items.iter().filter_map(|item| match item {
        Item::Words(span) => Some(document.words(*span)),
        _ => None,
    });
    let words: String = words.flat_map(|words| [words, " ".into()]).collect();
    let mut reader = Reader {
        document,
        statements: Vec::new(),
        sections: Vec::new(),
        enclosures: Vec::new(),
        next_scope: 0,
        blocks: Blocks::default(),
        group: 0,
        ended: false,
        begun: false,
        topics: Topics::default(),
        last: String::new(),
        gap: String::new(),
        trailing: None,
        formula: 0,
        changes: Changes::of(&words),
        apart: None,
        part: None,
        table: Table::default(),
        of_data: BTreeSet::new(),
    };
    let of_data = items_of_data(document);
    for (at, item) in document.items.iter().enumerate() {
        reader.item(item);
        if of_data.contains(&at) {
            reader.of_data.insert(reader.next_scope);
        }
    }
    reader.end_table();
    let mut statements = reader.statements;
    primes::as_marks(&mut statements);
    brackets::as_arguments(&document.file, &mut statements);
    let sentences = sentence::sentences(document);
    sentence::assign(&sentences, &mut statements);
    count_new_values(&mut statements);
    attach(&mut statements);
    objects::insert(&sentences, &mut statements);
    superscripts::as_calls(&mut statements);
    spare::mark(&sentences, &mut statements);
    statements
}

struct Reader<'a> {
    document: &'a Document,
    statements: Vec<Statement>,
    /// The open sections, outermost first.
    sections: Vec<Section>,
    enclosures: Vec<(Enclosure, u32)>,
    next_scope: u32,
    /// The examples, proofs and cases.
    blocks: Blocks,
    group: u32,
    /// A paragraph has ended: the next words begin a new one. A display belongs to the words before.
    ended: bool,
    /// Whether the paragraph has words already.
    begun: bool,
    topics: Topics,
    /// The last words, for what the sentence speaks of.
    last: String,
    gap: String,
    /// The relation after which the last formula ends.
    trailing: Option<(Rel, Span)>,
    formula: usize,
    changes: Changes,
    /// The paragraph with a title of its own.
    apart: Option<u32>,
    /// The part of a paragraph: "a) …, b) …".
    part: Option<u32>,
    table: Table,
    /// The items of lists that do no more than to give data, which hold for all after them.
    of_data: BTreeSet<u32>,
}

/// An open section.
struct Section {
    level: u8,
    /// Its number.
    scope: u32,
    /// What its title and those of the sections around it speak of.
    topics: Topics,
}

impl Reader<'_> {
    fn item(&mut self, item: &Item) {
        match item {
            Item::Heading { level, span } => {
                self.end_table();
                self.sections.retain(|section| section.level < *level);
                self.next_scope += 1;
                self.blocks.heading();
                self.apart = None;
                self.new_group();
                let title = &self.document.words(*span);
                self.begun = true;
                // A section is about what the titles of those around it say.
                self.topics = self.sections.last().map_or_else(Topics::default, |around| around.topics);
                self.last.clear();
                self.speak(title);
                let topics = self.topics.of_title();
                self.sections.push(Section { level: *level, scope: self.next_scope, topics });
            }
            Item::Words(span) => {
                let read = self.document.words(*span);
                let words = read.as_ref();
                if self.table.is_inside() {
                    self.table.words(self.document, *span);
                } else if !words.trim().is_empty() {
                    self.end_table();
                }
                if self.ended && !words.trim().is_empty() {
                    match speech::goes_on_from_before(words) {
                        true => self.ended = false,
                        false => self.new_group(),
                    }
                }
                if !words.trim().is_empty() {
                    self.blocks.goes_on();
                }
                let label = speech::block(words).filter(|_| !self.begun);
                if let Some(block) = label {
                    self.next_scope += 1;
                    let place = self.place();
                    self.blocks.label(block, self.next_scope, speech::number_of_block(words), &place);
                } else if let Some(name) = speech::recalled(words) {
                    self.blocks.recall(&name);
                }
                self.next_scope += 1;
                // A proof speaks of what it proves.
                if !self.begun && label != Some(Block::Proof) && speech::sets_apart(words) {
                    self.apart = Some(self.next_scope);
                }
                self.part = lettered_part(words, !self.begun).or(self.part);
                self.blocks.runs(words, !self.begun, self.next_scope, &mut self.statements);
                self.changes.words(words);
                self.begun |= !words.trim().is_empty();
                self.gap.push_str(words);
                self.speak(words);
            }
            Item::Break => {
                self.ended = true;
            }
            Item::Enter(enclosure) => {
                if *enclosure == Enclosure::Row {
                    self.table.begin_row(self.statements.len());
                }
                self.next_scope += 1;
                self.enclosures.push((*enclosure, self.next_scope));
                self.new_group();
            }
            Item::Leave(enclosure) => {
                if *enclosure == Enclosure::Row {
                    self.table.end_row();
                }
                if let Some(at) = self.enclosures.iter().rposition(|(known, _)| known == enclosure) {
                    self.enclosures.truncate(at);
                    self.blocks.leave(at);
                }
                if matches!(enclosure, Enclosure::Quotation | Enclosure::Environment) {
                    self.new_group();
                }
            }
            Item::Title { kind, label } => {
                let own = self.enclosures.last().map_or(self.next_scope, |(_, scope)| *scope);
                let place = self.place();
                self.blocks.enter(
                    speech::kind_of_block(kind),
                    own,
                    self.enclosures.len(),
                    label.clone(),
                    &place,
                );
            }
            Item::Declaration { text, span, block } => {
                let make = if *block { Said::Queries } else { Said::Declaration };
                let said = make(text.clone(), *span);
                self.push(said);
            }
            Item::Formula(formula) => {
                self.formula += 1;
                self.changes.formula(&self.gap, &formula.text);
                let first = self.statements.len();
                if !is_end_of_proof(&formula.text) {
                    self.formula(formula);
                }
                self.in_table(first);
                self.gap.clear();
            }
        }
    }

    /// The statements from `first` on stand in a cell of a table, or are a table themselves.
    fn in_table(&mut self, first: usize) {
        let only = match self.statements.get(first..) {
            Some([Statement { said: Said::Bare(side, _), .. }]) => Some(side),
            _ => None,
        };
        if self.table.is_inside() {
            let side = only.cloned();
            self.statements[first..].iter_mut().for_each(as_label);
            return self.table.formula(side.as_ref());
        }
        let latex = |span: Span| clean(&self.document.source(span));
        let found = only.map(|side| triangles::in_matrix(&side.expr, &latex)).unwrap_or_default();
        self.end_table();
        if !found.is_empty() {
            self.push(Said::Triangles(found, Vec::new()));
        }
    }

    /// A table ends; the formulas in the cells of a triangle are judged with it.
    fn end_table(&mut self) {
        let found = self.table.finish();
        if found.is_empty() {
            return;
        }
        let cells =
            || found.iter().flat_map(|triangle| triangle.columns.iter().chain(&triangle.nodes).flatten());
        let mut formulas = Vec::new();
        let own = self.statements.split_off(self.table.first.min(self.statements.len()));
        for statement in own {
            match statement.said {
                Said::Bare(side, _) if cells().any(|cell| cell.expr.span == side.expr.span) => {
                    formulas.push(side);
                }
                _ => self.statements.push(statement),
            }
        }
        self.push(Said::Triangles(found, formulas));
    }

    /// Notes what words speak of.
    fn speak(&mut self, words: &str) {
        speech::topics(words, &mut self.topics);
        self.last.push_str(words);
        if let Some((from, _)) = self.last.char_indices().rev().nth(LAST_WORDS) {
            self.last.drain(..from);
        }
    }

    /// The topics of the last words.
    fn near(&self) -> Topics {
        let mut near = Topics::default();
        // Nothing else is asked of the last words.
        let curve = self.topics.has(Topic::BezierCurve) && self.topics.has(Topic::PolarForm);
        if curve || self.topics.has(Topic::Subdivision) || self.topics.has(Topic::ControlPoints) {
            speech::topics(&self.last, &mut near);
            near.keep_side(speech::last_side(&self.last));
        }
        near
    }

    /// What the sentence speaks of before its formula, with whatever formulas between: degrees, lengths.
    fn sentence(&self) -> Topics {
        let mut own = Topics::default();
        // What the gap names, the section names.
        if self.topics.degrees().next().is_none() && !self.topics.has(Topic::Uneven) {
            return own;
        }
        let last = self.last.rsplit(['.', '。']).next().unwrap_or_default();
        speech::topics(last, &mut own);
        own
    }

    fn new_group(&mut self) {
        self.group += 1;
        self.changes.paragraph();
        self.ended = false;
        self.begun = false;
        self.part = None;
        // No sentence goes on.
        self.last.push('.');
        self.blocks.recalled = None;
    }

    /// The numbers of the items of lists that are open, of a paragraph with a title, and of a part of a paragraph.
    fn items(&self) -> Vec<u32> {
        let items = self
            .enclosures
            .iter()
            .filter(|(own, scope)| *own == Enclosure::Item && !self.of_data.contains(scope));
        self.apart.into_iter().chain(items.map(|(_, scope)| *scope)).chain(self.part).collect()
    }

    fn place(&self) -> Place {
        let enclosing = self
            .enclosures
            .iter()
            .filter(|(enclosure, _)| matches!(enclosure, Enclosure::Quotation | Enclosure::Environment))
            .filter_map(|(_, scope)| self.blocks.scope_of(*scope));
        let sections = self.sections.iter().map(|section| section.scope);
        let scope: Vec<u32> = sections.chain(enclosing).collect();
        Place::from(Layout {
            group: self.group,
            formula: self.formula,
            // "In Example 1", right after another one
            blocks: match &self.blocks.recalled {
                Some(example) if example.scope == scope => example.blocks.clone(),
                _ => self.blocks.open(),
            },
            scope,
            proofs: self.blocks.proofs(),
            recalled: self.blocks.recalled.clone(),
            items: self.items(),
            changes: self.changes.so_far,
            replaced: self.changes.replaced.clone(),
            spare: 0,
            arbitrary: Vec::new(),
        })
    }

    fn push(&mut self, said: Said) {
        let place = self.place();
        self.blocks.said(&place);
        let statement = Statement {
            topics: self.topics,
            near: self.near(),
            sentence: self.sentence(),
            gap: self.gap.clone(),
            denied: speech::denies(&self.gap),
            ..Statement::new(said, self.place())
        };
        self.statements.push(statement);
    }

    fn formula(&mut self, formula: &Formula) {
        let rows = match formula.style {
            Style::Plain => match syntax::parse(&formula.text) {
                Ok(expr) => vec![latex::Row {
                    span: Span::new(0, formula.text.len()),
                    leading: None,
                    trailing: None,
                    expr,
                    problems: Vec::new(),
                }],
                Err(_) => Vec::new(),
            },
            _ => latex::read_rows(&formula.text),
        };
        let first = self.statements.len();
        let mut words = false;
        // Where a row goes on that begins with a sign: not with a formula in the reason of the row before.
        let mut main = None;
        let before = self.trailing.take().filter(|_| self.gap.trim().is_empty());
        self.trailing =
            rows.last().and_then(|row| row.trailing).map(|(rel, sign)| (rel, formula.in_file(sign)));
        for (number, row) in rows.into_iter().enumerate() {
            let leading = row.leading.map(|(rel, sign)| (rel, formula.in_file(sign)));
            let leading = leading.or(before.filter(|_| number == 0));
            let (mut said, mut reason) = (false, false);
            let mut expr = row.expr;
            read_conditions(&mut expr);
            ordered_members(&mut expr);
            expr.map_spans(&|span| formula.in_file(span));
            let latex = |span: Span| -> String {
                // Derived spans lead back into the text only where it stands in the file.
                self.document.source(span).into_owned()
            };
            let items = match expr.kind {
                Kind::Sequence(items) => spread(items),
                Kind::ForAll(mut items, body) => {
                    items.extend(body.map(|body| *body));
                    items
                }
                _ => vec![expr],
            };
            let glued = |gap: Span| !latex(gap).contains(char::is_whitespace);
            let items = with_doubtful_numbers(with_alternatives(regrouped(items)), glued);
            for (at, item) in items.into_iter().enumerate() {
                let side = Side { latex: clean(&latex(item.span)), expr: item };
                let text = matches!(side.expr.kind, Kind::Text(_));
                reason |= said && text;
                said |= !text;
                match (&side.expr.kind, at, leading) {
                    (Kind::Text(text), ..) => words = is_condition_word(text),
                    (_, 0, Some((rel, sign))) => {
                        if !self.go_on(main, rel, sign, side.clone(), &row.problems) {
                            self.push(Said::Bare(side, row.problems.clone()));
                        }
                    }
                    _ if side.expr.alternatives().is_some() => self.push(Said::Condition(side)),
                    _ if is_condition(&side.expr, words || at > 0 || announces_condition(&self.gap)) => {
                        self.push(Said::Condition(side));
                    }
                    (Kind::Chain(..), ..) => {
                        let mut chain = with_bar(chain(side, &latex, &row.problems));
                        chain.given = words;
                        self.push(Said::Chain(chain));
                    }
                    _ => {
                        self.lies_in(&side);
                        if is_smoothness(&side.expr) {
                            self.topics.add(Topic::Join);
                        }
                        self.push(Said::Bare(side, row.problems.clone()));
                    }
                }
                let continues = at == 0 && leading.is_some() && main.is_some();
                if !text && !reason && !continues {
                    main = self.statements.len().checked_sub(1).filter(|&last| last >= first);
                }
            }
        }
        // What is given comes before what it is given for, and so does what a name used before is.
        let mut all = self.statements.split_off(first);
        for at in 1..all.len() {
            let explains = match &all[at].said {
                Said::Chain(chain) => explains(chain, &all[..at]),
                _ => false,
            };
            if let (true, Said::Chain(chain)) = (explains, &mut all[at].said) {
                chain.given = true;
            }
        }
        let (given, rest): (Vec<_>, Vec<_>) =
            all.into_iter().partition(|s| matches!(&s.said, Said::Chain(chain) if chain.given));
        self.statements.extend(given);
        self.statements.extend(rest);
    }

    /// "If $u$ lies in $[a, b)$": the name before is said to be in an interval.
    fn lies_in(&mut self, set: &Side) {
        let formula = self.formula;
        let words = speech::says_in(&self.gap) && interval(&set.expr).is_some();
        if let Some(last) = self.statements.last_mut().filter(|_| words)
            && last.place.formula + 1 == formula
            && let Said::Bare(Side { expr, latex }, _) = &last.said
            && matches!(&expr.kind, Kind::Name(name) if is_variable(name))
        {
            let (span, latex) = (expr.span, format!("{latex} \\in {}", set.latex));
            let expr = Expr::relation(expr.clone(), Rel::In, set.expr.clone());
            let expr = Expr { span, ..expr };
            last.said = Said::Condition(Side { expr, latex });
        }
    }

    /// Adds a side to the chain before, or that of number `main`, if there is one.
    fn go_on(
        &mut self,
        main: Option<usize>,
        rel: Rel,
        sign: Span,
        side: Side,
        problems: &[Diagnostic],
    ) -> bool {
        let place = self.place();
        let near = self.gap.trim().is_empty();
        let last = main.or(self.statements.len().checked_sub(1));
        let Some(last) = last.and_then(|at| self.statements.get_mut(at)) else { return false };
        let same = last.place.formula == place.formula || (near && last.place.group == place.group);
        if !same {
            return false;
        }
        let mut more = match &side.expr.kind {
            Kind::Chain(first, links) => {
                let mut sides = vec![part(first, &side.latex, self.document)];
                sides.extend(links.iter().map(|link| part(&link.expr, "", self.document)));
                (sides, links.iter().map(|link| (link.rel, link.span)).collect::<Vec<_>>())
            }
            _ => (vec![side], Vec::new()),
        };
        match &mut last.said {
            Said::Chain(chain) => {
                chain.relations.push((rel, sign));
                chain.relations.append(&mut more.1);
                chain.sides.append(&mut more.0);
                chain.problems.extend_from_slice(problems);
                true
            }
            Said::Bare(first, known) => {
                let mut sides = vec![first.clone()];
                sides.append(&mut more.0);
                let mut relations = vec![(rel, sign)];
                relations.append(&mut more.1);
                let mut all = std::mem::take(known);
                all.extend_from_slice(problems);
                last.said = Said::Chain(Chain { problems: all, ..Chain::new(sides, relations) });
                true
            }
            _ => false,
        }
    }
}

/// Whether a formula is nothing but the sign at the end of a proof.
fn is_end_of_proof(text: &str) -> bool {
    let sign = text.trim().trim_end_matches(['.', '\u{20}']);
    matches!(
        sign,
        "\\square"
            | "\\Box"
            | "\\blacksquare"
            | "\\qed"
            | "\\qedsymbol"
            | "\\qedhere"
            | "\\diamond"
            | "\\checkmark"
    )
}

/// Whether a chain says what a family is that the formulas before it use: … R_i(t) …, R_i(t) = ….
fn explains(chain: &Chain, before: &[Statement]) -> bool {
    let uses = |expr: &Expr, base: &str| bases(expr).contains(base);
    let Some(head) = Head::of(&chain.sides[0].expr) else { return false };
    let equation = matches!(chain.relations.as_slice(), [(Rel::Eq | Rel::Define, _)]);
    let family = !head.lower.is_empty() && head.lower.iter().all(|index| matches!(index.kind, Kind::Name(_)));
    if !equation || !family || uses(&chain.sides[1].expr, &head.base) {
        return false;
    }
    before.iter().any(|statement| match &statement.said {
        Said::Chain(other) => {
            let own = Head::of(&other.sides[0].expr).map(|head| head.base);
            own.is_none_or(|own| own != head.base && !uses(&chain.sides[1].expr, &own))
                && other.sides.iter().any(|side| uses(&side.expr, &head.base))
        }
        _ => false,
    })
}

/// `F |_t = 1 = …`, where the value at the bar slipped out of the index.
fn with_bar(mut chain: Chain) -> Chain {
    if let [first, second, _, ..] = chain.sides.as_slice()
        && let Kind::At { body, lower, upper: None } = &first.expr.kind
        && let [name] = lower.as_slice()
        && matches!(name.kind, Kind::Name(_))
        && matches!(second.expr.kind, Kind::Number(_))
        && chain.relations[0].0 == Rel::Eq
    {
        let at = Expr::relation(name.clone(), Rel::Eq, second.expr.clone());
        let kind = Kind::At { body: body.clone(), lower: vec![at], upper: None };
        let expr = Expr::new(kind, first.expr.span.to(second.expr.span));
        let latex = format!("{} = {}", first.latex, second.latex);
        chain.sides.splice(..2, [Side { expr, latex }]);
        chain.relations.remove(0);
    }
    chain
}

fn part(expr: &Expr, latex: &str, document: &Document) -> Side {
    let text = document.source(expr.span);
    Side { expr: expr.clone(), latex: clean(if text.is_empty() { latex } else { &text }) }
}

fn chain(side: Side, latex: &dyn Fn(Span) -> String, problems: &[Diagnostic]) -> Chain {
    let Kind::Chain(first, links) = side.expr.kind else {
        return Chain::new(vec![side], Vec::new());
    };
    let one = |expr: &Expr| Side { latex: clean(&latex(expr.span)), expr: expr.clone() };
    let sides = std::iter::once(one(&first)).chain(links.iter().map(|link| one(&link.expr))).collect();
    let relations = links.iter().map(|link| (link.rel, link.span)).collect();
    Chain { problems: problems.to_vec(), ..Chain::new(sides, relations) }
}

/// The text of a formula without marks of quotations and alignment at its ends.
fn clean(latex: &str) -> String {
    let lines: Vec<&str> = latex.lines().map(|line| line.trim_start_matches(['>', ' ']).trim_end()).collect();
    let text = lines.join("\n");
    text.trim().trim_start_matches('&').trim_end_matches('&').trim_end_matches("\\\\").trim().to_owned()
}

/// "i = 0" at the head of a row of a table gives no i.
fn as_label(statement: &mut Statement) {
    let Said::Chain(chain) = &statement.said else { return };
    let ([name, number], [(Rel::Eq, _)]) = (chain.sides.as_slice(), chain.relations.as_slice()) else {
        return;
    };
    let index = matches!(&name.expr.kind, Kind::Name(letter) if is_index_letter(letter));
    if index && number.expr.as_int().is_some() {
        let latex = format!("{} = {}", name.latex, number.latex);
        statement.said = Said::Bare(Side { expr: chain.whole(), latex }, Vec::new());
    }
}
