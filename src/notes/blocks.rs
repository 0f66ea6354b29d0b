//! The examples, proofs and cases of a page, as labelled paragraphs and as environments, and the examples that words go
//! back to.

use std::collections::{BTreeSet, HashMap};

use super::speech::{self, Block};
use crate::document::{Document, Enclosure, Item};
use crate::formula::{Expr, Kind, Rel};
use crate::judge::page::statement::{Chain, Layout, Place, Role, Said, Statement};
use crate::judge::written::names::{Head, bases};
use crate::language::lexicon::roles::is_variable;
use crate::language::{latex, write};
use num_traits::Zero;

/// What is open at a place of the page.
#[derive(Default)]
pub(super) struct Blocks {
    /// The labelled paragraphs that are open, each with what it is.
    labelled: Vec<(Block, u32)>,
    /// The environments that are open, each with how many enclosures it stands in.
    inside: Vec<(usize, Block, u32)>,
    /// The environments that define: what they say goes on after them.
    passing: Vec<u32>,
    /// The environments that prove, each with the one before that it proves.
    proving: Vec<(u32, Option<u32>)>,
    /// The environment that has just ended: a solution goes on from its exercise, a proof from its theorem.
    left: Option<(Block, u32)>,
    /// The number of the first statement of an example without a label.
    running: Option<usize>,
    /// The examples so far.
    examples: Vec<Example>,
    /// The example that the paragraph goes back to.
    pub(super) recalled: Option<Place>,
}

/// An example that later words may go back to.
struct Example {
    block: u32,
    /// "2", or a label.
    name: Option<String>,
    /// Where its last formula stands.
    place: Place,
}

impl Blocks {
    /// The numbers of the examples and cases that are open, outermost first.
    pub(super) fn open(&self) -> Vec<u32> {
        self.numbers(|block| !matches!(block, Block::Proof | Block::Open))
    }

    /// The numbers of the proofs that are open, outermost first.
    pub(super) fn proofs(&self) -> Vec<u32> {
        self.numbers(|block| block == Block::Proof)
    }

    fn numbers(&self, are: impl Fn(Block) -> bool) -> Vec<u32> {
        let labelled = self.labelled.iter().map(|(block, own)| (*block, *own));
        let all = labelled.chain(self.inside.iter().map(|(_, block, own)| (*block, *own)));
        all.filter(|(block, _)| are(*block)).map(|(_, own)| own).collect()
    }

    /// The environment to which what is said in an environment belongs: a proof to what it proves. Nothing if it goes on
    /// after it.
    pub(super) fn scope_of(&self, environment: u32) -> Option<u32> {
        match self.proving.iter().find(|(own, _)| *own == environment) {
            Some((_, proved)) => *proved,
            None => Some(environment).filter(|own| !self.passing.contains(own)),
        }
    }

    /// A heading ends what labels began.
    pub(super) fn heading(&mut self) {
        self.labelled.clear();
        self.running = None;
        self.left = None;
    }

    /// "Take for example n = 3. … In general …": what stands between is said in the example, which gets this number.
    /// Words after which no sentence leads back leave everything as it is.
    pub(super) fn runs(&mut self, words: &str, begins: bool, own: u32, statements: &mut [Statement]) {
        if let Some(first) = self.running.take_if(|_| speech::generalises(words, begins)) {
            for statement in statements.iter_mut().skip(first) {
                statement.place.blocks.push(own);
            }
        }
        if speech::gives_example(words) {
            self.running = Some(statements.len());
        }
    }

    /// Words after an environment: before a proof they may lead to it.
    pub(super) fn goes_on(&mut self) {
        self.left.take_if(|(block, _)| *block != Block::Open);
    }

    /// A labelled paragraph begins; a proof goes on from what it proves, a case is within its proof.
    pub(super) fn label(&mut self, block: Block, own: u32, name: Option<String>, place: &Place) {
        self.running = None;
        self.labelled.retain(|(open, _)| open.holds(block));
        if !matches!(block, Block::Open | Block::Definition) {
            self.labelled.push((block, own));
        }
        self.begin(block, own, name, place);
    }

    /// An environment begins.
    pub(super) fn enter(
        &mut self,
        kind: Option<Block>,
        own: u32,
        depth: usize,
        name: Option<String>,
        place: &Place,
    ) {
        let before = self.left.take();
        match kind {
            None => {}
            Some(Block::Open) => self.inside.push((depth, Block::Open, own)),
            Some(Block::Definition) => self.passing.push(own),
            Some(block) => {
                if block == Block::Proof {
                    self.proving.push((own, before.map(|(_, scope)| scope)));
                }
                if let Some((before, scope)) = before.filter(|(before, _)| before.holds(block)) {
                    self.inside.push((depth, before, scope));
                }
                self.inside.push((depth, block, own));
                self.begin(block, own, name, place);
            }
        }
    }

    /// An environment in so many enclosures ends.
    pub(super) fn leave(&mut self, at: usize) {
        while let Some((_, block, scope)) = self.inside.pop_if(|(depth, ..)| *depth > at) {
            self.left = Some((block, scope));
        }
    }

    fn begin(&mut self, block: Block, own: u32, name: Option<String>, place: &Place) {
        if block == Block::Closed {
            let place = Place::from(Layout { blocks: self.open(), ..Layout::clone(place) });
            self.examples.push(Example { block: own, name, place });
        }
    }

    /// A formula stands at a place.
    pub(super) fn said(&mut self, place: &Place) {
        self.left = None;
        if let Some(example) = self.examples.last_mut()
            && place.blocks.contains(&example.block)
        {
            example.place = place.clone();
        }
    }

    /// Goes back to an example: the one with this name, or the last one.
    pub(super) fn recall(&mut self, name: &str) {
        let open = self.open();
        let named = |example: &&Example| name.is_empty() || example.name.as_deref() == Some(name);
        let found = self.examples.iter().rev().filter(|example| !open.contains(&example.block)).find(named);
        self.recalled = found.map(|example| example.place.clone());
    }
}

/// How often the data of a page may have changed.
#[derive(Default)]
pub(super) struct Changes {
    pub(super) so_far: u32,
    /// The letters of which words say for certain that something else stands in their place.
    pub(super) replaced: Vec<String>,
    /// The last formula, which is read only where words replace it, and whether they replace the next one.
    last: Option<String>,
    replaces: bool,
    /// Whether data of the sentence are its own: "for integer knots t_i = i we get".
    passing: bool,
    /// Whether the last words put something in the place of what the next formula is.
    replacing: bool,
    /// Whether words that are not understood may change data in each paragraph.
    foreign: bool,
    /// A list of numbers that the page gave.
    listed: Option<String>,
}

impl Changes {
    /// Those of a page with these words.
    pub(super) fn of(words: &str) -> Self {
        Changes { foreign: !speech::is_understood(words), ..Changes::default() }
    }

    /// Words that put other data in the place of those before, or end a sentence that has data of its own.
    pub(super) fn words(&mut self, words: &str) {
        let ends = self.passing && speech::ends_a_sentence(words);
        let changed = speech::changes_data(words, self.foreign);
        self.so_far += u32::from(ends || changed);
        let [before, after] = speech::replaces_data(words);
        self.replaced.extend(self.last.take_if(|_| before).and_then(|text| letter(&text)));
        self.replaces = after;
        self.passing &= !ends;
        self.replacing = changed && !ends && speech::replaces_next(words);
    }

    /// A formula after some words.
    pub(super) fn formula(&mut self, before: &str, text: &str) {
        // "We replace t^2 by (s t + …)/3": powers of the variable are no data.
        let replacing = std::mem::take(&mut self.replacing);
        let power = replacing && is_power_of_a_variable(text);
        if power || has_no_value(text) && speech::ends_with_a_change(before) {
            self.so_far -= 1;
        }
        self.last = Some(text.to_owned());
        if std::mem::take(&mut self.replaces) {
            self.replaced.extend(letter(text));
        }
        // "At the parameter t = 1/4" gives a place.
        let datum = text.split_once('=').is_some_and(|(name, _)| !is_variable(name.trim()));
        self.passing |= datum && speech::is_for_some_data(before);
        // "With the ordinates 1, -1, 1 … With 1, -2, 1 …"
        let number = |c: char| c.is_ascii_digit() || "-,;. \\frac{}()tbl/".contains(c);
        if text.contains([',', ';'])
            && text.chars().all(number)
            && text.contains(|c: char| c.is_ascii_digit())
        {
            let other = self.listed.as_ref().is_some_and(|known| known != text);
            self.so_far += u32::from(other && speech::is_with_some_data(before));
            self.listed = Some(text.to_owned());
        }
    }

    /// A paragraph begins.
    pub(super) fn paragraph(&mut self) {
        self.so_far += u32::from(std::mem::take(&mut self.passing) || self.foreign);
    }
}

/// The letter of b_1, or of b_1 = 4.
fn letter(text: &str) -> Option<String> {
    let expr = latex::read(text).ok()?;
    match expr.kind {
        Kind::Chain(left, _) => Head::of(&left),
        _ => Head::of(&expr).filter(|head| head.arguments.is_none()),
    }
    .filter(|head| head.upper.is_empty())
    .map(|head| head.base)
}

/// t^3, x^k: a name and an exponent.
fn is_power_of_a_variable(text: &str) -> bool {
    text.split_once('^').is_some_and(|(name, _)| is_variable(name.trim()))
}

/// 0/0, for which a table of divided differences takes the derivative.
fn has_no_value(text: &str) -> bool {
    let zero = |expr: &Expr| matches!(&expr.kind, Kind::Number(q) if q.is_zero());
    latex::read(text).is_ok_and(|expr| matches!(&expr.kind, Kind::Div(_, below, _) if zero(below)))
}

/// "For c = (1, -1, 1) … For c = (1, 0, 1) …", "For f(x) = e^x … For f(x) = 1/(1-x) …": what comes after a name gets
/// another value is said of other data.
///
/// Cost: linear in the statements.
pub(super) fn count_new_values(statements: &mut [Statement]) {
    let mut values: HashMap<String, (Vec<u32>, String)> = HashMap::new();
    let mut more = 0;
    for statement in statements {
        statement.place.changes += more;
        if statement.role == Some(Role::Claimed) {
            continue;
        }
        let Said::Chain(Chain { sides, relations, .. }) = &statement.said else { continue };
        let ([name, value], [(Rel::Eq | Rel::Define, _)]) = (sides.as_slice(), relations.as_slice()) else {
            continue;
        };
        // t = 0, t = 1: places, no data
        let named = Head::of(&name.expr).is_some_and(|head| {
            // b_0^1 at another t
            head.arguments.is_none()
                && head.upper.is_empty()
                && !(head.lower.is_empty() && is_variable(&head.base))
        });
        let function =
            Head::of(&name.expr).is_some_and(|head| head.arguments.is_some() && head.lower.is_empty());
        let case = function && speech::opens_data(&statement.gap);
        if !case && (!named || !bases(&value.expr).is_empty()) {
            continue;
        }
        let now = (statement.place.scope.clone(), write::text(&value.expr));
        let before = values.insert(write::text(&name.expr), now.clone());
        more += u32::from(before.is_some_and(|before| before.0 == now.0 && before.1 != now.1));
    }
}

/// So many words an item of a list may have that does no more than to give data.
const WORDS_OF_DATA: usize = 8;

/// The items of lists, by their numbers among all items of the document, that say in no sentence what they are about:
/// "- weights $w_0 = 1$, $w_1 = 2$".
pub(super) fn items_of_data(document: &Document) -> BTreeSet<usize> {
    let mut open: Vec<(usize, String)> = Vec::new();
    let mut found = BTreeSet::new();
    for (at, item) in document.items.iter().enumerate() {
        match item {
            Item::Enter(Enclosure::Item) => open.push((at, String::new())),
            Item::Words(span) => {
                open.iter_mut().for_each(|(_, words)| words.push_str(&document.words(*span)));
            }
            Item::Leave(Enclosure::Item) => {
                let Some((at, words)) = open.pop() else { continue };
                let words = words.trim().trim_end_matches(['.', ';', ',']);
                let few = words.split_whitespace().count() <= WORDS_OF_DATA && words.chars().count() < 60;
                if few && !words.contains(['.', '。', '!', '?', '？', ':', '：']) {
                    found.insert(at);
                }
            }
            _ => {}
        }
    }
    found
}

/// The number of the last part that words begin: 'b' of "Solution. a) …; b) …". A part has the same number wherever it
/// is told of, in an exercise and in its solution. "By (a)" begins none.
pub(super) fn lettered_part(words: &str, first: bool) -> Option<u32> {
    let mut found = None;
    let mut begins = first;
    for word in words.split(' ') {
        let plain = word.trim_start_matches(['*', '_', '(', '（', '\n']);
        let mut letters = plain.chars();
        if let (Some(letter @ 'a'..='z'), Some(')' | '）')) = (letters.next(), letters.next())
            && (begins || word.starts_with('\n'))
        {
            found = Some(u32::MAX - u32::from(letter));
        }
        let ended = word.trim_end_matches(['*', '_']);
        begins =
            begins && ended.is_empty() || ended.ends_with(['.', ',', ';', ':', '。', '，', '；', '：', '\n']);
    }
    found
}
