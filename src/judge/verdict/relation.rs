//! From the instances of a relation to its verdict.

use std::collections::BTreeSet;

use crate::budget::{self, Limits};
use crate::formula::{Accent, Expr, Kind, Rel};
use crate::judge::instances::conditions::CANNOT_HOLD;
use crate::judge::instances::hypotheses;
use crate::judge::instances::setting::Setting;
use crate::judge::instances::tally::{Failure, Outcomes, Tally};
use crate::judge::known::checker::Checker;
use crate::judge::page::finding::{Evidence, Finding, Verdict, blank};
use crate::judge::page::object::{Sort, UNNAMED};
use crate::judge::page::statement::{Chain, Place, Role, Side, Statement};
use crate::judge::page::topic::Topic;
use crate::judge::prove::prove;
use crate::judge::reasons::certainty::Suspect;
use crate::judge::reasons::counterexample;
use crate::judge::reasons::doubts;
use crate::judge::reasons::refute;
use crate::judge::repair::{self, Repair};
use crate::judge::verdict::attempt::{Attempt, beyond_degree, restricted};
use crate::judge::written::names::{Head, bases, calls, is_standard, walk};
use crate::judge::written::{bare, commuting};
use crate::language::diagnostic::Code;
use crate::language::lexicon::roles::is_variable;
use crate::math::poly::Symbol;

const UNFOUNDED: &str = "it fails as it is read, and so does all that is near it: it may mean something else";

impl Checker {
    pub(in crate::judge) fn verdict(
        &self,
        tally: &Tally,
        attempt: &Attempt,
        setting: &Setting,
        at: usize,
        statement: &Statement,
        head: Option<&Head>,
    ) -> Judged {
        let chain = setting.chain;
        let mut finding = blank(chain, at);
        let outcomes = &attempt.outcomes;
        let earlier = &outcomes.tallies[..at + outcomes.tallies.len() - chain.relations.len()];
        finding.notes = self.notes(tally);
        let repair = || {
            let held = |(_, tally): &(usize, &Tally)| tally.holds > 0 && tally.fails.is_empty();
            let before = (at - earlier.len()..at).zip(earlier).filter(held);
            let held: Vec<usize> = before.map(|(number, _)| number).collect();
            repair::find(self, setting, at, attempt.choices, tally, statement, &held)
        };
        if let Some(reason) = self.doubt([at, at + 1], chain, &statement.place) {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason);
            return Judged::Verdict(Box::new(finding));
        }
        let ranged = !outcomes.integers.is_empty() && !outcomes.fixed || outcomes.degrees;
        let range = || {
            let mut names = outcomes.integers.join(", ");
            if names.is_empty() {
                names = "the degree".to_owned();
            }
            let largest = if outcomes.integers.is_empty() { 4 } else { outcomes.largest };
            format!("{names} from 0 to {largest}")
        };
        if tally.fails.is_empty()
            // Where the count fits it says what the degree is.
            && tally.holds == 0
            && let Some((integers, message)) = tally.mismatches.first()
            // f(t_{i+1}, …, t_{i+p}) of a form of degree 2 has as many as it takes for p = 2.
            && tally.errors.iter().all(|error| error.code == Code::Arity)
        {
            let values: Vec<String> =
                integers.iter().map(|(name, value)| format!("{name} = {value}")).collect();
            finding.verdict = Verdict::Refuted;
            finding.reason = Some(message.clone());
            finding.witness = Some(values.join(", "));
            return Judged::Verdict(Box::new(finding));
        }
        if tally.fails.is_empty()
            && tally.holds > 0
            && let Some(reason) = self.of_no_numbers(chain, at, statement)
        {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(reason);
            return Judged::Verdict(Box::new(finding));
        }
        if bare::only_commutes(&chain.sides[at].expr, &chain.sides[at + 1].expr) {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some("it says that letters commute: they may be no numbers".to_owned());
            return Judged::Verdict(Box::new(finding));
        }
        let inequality = matches!(chain.relations[at].0, Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge);
        // Contradictory conditions confirm nothing.
        let contradictory = tally.unclear.iter().any(|why| why == CANNOT_HOLD);
        if tally.fails.is_empty()
            && tally.holds > 0
            && !contradictory
            && (!inequality || tally.unclear.is_empty())
        {
            finding.verdict = if ranged || tally.sampled { Verdict::Sampled } else { Verdict::Proved };
            if tally.sampled && !ranged {
                finding.instances = Some("for numbers in the place of the nodes".to_owned());
            }
            if ranged {
                finding.instances = Some(format!("{} instances: {}", tally.holds, range()));
            }
            if let Some(reason) = untested(tally, outcomes, chain, at, ranged) {
                finding.verdict = Verdict::Undecided;
                finding.reason = Some(reason);
            }
            if let Some(number) = tally.condition {
                finding.notes.push(format!("uses an earlier condition (number {number})"));
            }
            if finding.verdict == Verdict::Sampled
                && let Some(reason) = self.proof(chain, at, &statement.place, attempt)
            {
                finding.verdict = Verdict::Proved;
                finding.reason = Some(reason);
            }
            return Judged::Verdict(Box::new(finding));
        }
        let beyond = || beyond_degree(tally, outcomes, &chain.sides[at].expr, &chain.sides[at + 1].expr);
        if let (Some(reason), None) = (restricted(tally, outcomes, chain).or_else(beyond), &tally.gap) {
            finding.verdict = Verdict::Sampled;
            finding.reason = Some(reason.to_owned());
            finding.instances = Some(format!("{} instances: {}", tally.holds, range()));
            if let Some(reason) = self.proof(chain, at, &statement.place, attempt) {
                finding.verdict = Verdict::Proved;
                finding.reason = Some(reason);
            }
            return Judged::Verdict(Box::new(finding));
        }
        finding.verdict = Verdict::Undecided;
        if tally.fails.is_empty() {
            let reason = tally
                .unclear
                .first()
                .cloned()
                .or_else(|| tally.errors.first().map(|error| error.message.clone()));
            if tally.record.mixed && tally.holds == 0 {
                finding.warning = tally.errors.first().map(|error| error.message.clone());
            }
            if outcomes.integers.len() > 8 {
                finding.reason = Some("too many integers without values".to_owned());
            } else {
                finding.reason = reason.or_else(|| Some("no instance makes sense".to_owned()));
            }
            // A new name whose formula cannot be computed is defined all the same.
            if let Some(head) = head
                && !chain.sides[1].is_unread()
                && !refute::is_standard(Some(head))
                && !calls(&chain.sides[1].expr, &head.base)
            {
                return Judged::Redefinition(finding.warning);
            }
            return Judged::Verdict(Box::new(finding));
        }
        // Names that stand on one side only: the equation says what they are.
        let introduces = matches!(chain.relations[at].0, Rel::Eq | Rel::Define)
            && tally.determined == 0
            && tally.holds_inner == 0
            && tally.fails.iter().take(3).all(|failure| {
                let open = |symbol: &Symbol| {
                    let claimed = statement.role == Some(Role::Claimed);
                    self.is_open(symbol, &attempt.curve)
                        && !(claimed && self.is_point_of_an_object(symbol, &statement.place))
                };
                // The r_k of p(t) q(t) = Σ r_k B_k^{m+n}(t) are no arguments.
                let sides = [&chain.sides[at].expr, &chain.sides[at + 1].expr];
                let called = |part: &Expr| matches!(part.kind, Kind::Apply(..)) && is_standard(part);
                let expansion = sides.iter().any(|side| side.has(&called));
                let argument = |symbol: &Symbol| {
                    is_variable(symbol.base())
                        && (!expansion
                            || symbol.is_plain()
                            || self.context.letters.is_argument(symbol.base()))
                };
                hypotheses::introduces(&failure.left, &failure.right, &open, &argument)
            });
        if introduces {
            finding.verdict = Verdict::Definition;
            finding.reason = Some("a condition on new names".to_owned());
            return Judged::Verdict(Box::new(finding));
        }
        let wrong = |finding: &Finding, failure: &Failure, reasons: String| Finding {
            verdict: Verdict::Refuted,
            determined: tally.determined > 0,
            reason: Some(reasons),
            witness: counterexample::counterexample(failure),
            instances: ranged.then(|| {
                let (fails, all) = (tally.fails.len(), tally.fails.len() + tally.holds);
                format!("fails in {fails} of {all} instances: {}", range())
            }),
            ..finding.clone()
        };
        let related = tally.related > 0 && tally.related == tally.fails.len() && self.concludes(statement);
        if let (true, Some(failure), None) =
            (related, tally.fails.first(), doubts::of_meaning(self, tally, chain, at, statement))
        {
            finding.evidence = vec![Evidence::Facts];
            let reason = "it does not follow from what is said of these functions".to_owned();
            return Judged::Verdict(Box::new(wrong(&finding, failure, reason)));
        }
        let mut unfounded = None;
        let refutation = refute::decide(self, tally, outcomes, chain, at, statement, head);
        let refutation = match refutation {
            refute::Decision::Refuted { failure, reasons } => {
                let suspect =
                    Suspect { checker: self, tally, earlier, chain, at, statement, failure: &failure };
                let doubt = suspect.doubt().or_else(|| {
                    let repair = repair();
                    finding.suggestion = repair.as_ref().and_then(Repair::latex);
                    finding.evidence = suspect.evidence(repair.as_ref());
                    finding.evidence.is_empty().then(|| {
                        let mut found = wrong(&finding, &failure, reasons.clone());
                        let near = repair.as_ref().is_some_and(|repair| repair.near);
                        let confirmed = suspect.can_be_confirmed() || near && suspect.is_claim_beside_truth();
                        found.evidence.extend(confirmed.then_some(Evidence::Names));
                        unfounded = Some(found);
                        UNFOUNDED.to_owned()
                    })
                });
                match doubt {
                    // F(t) = … F' … defines no F.
                    Some(reason) => {
                        let new = head.filter(|head| !bases(&chain.sides[at + 1].expr).contains(&head.base));
                        refute::missing_or_redefinition(new, at == 0, &reason)
                    }
                    None => refute::Decision::Refuted { failure, reasons },
                }
            }
            refute::Decision::Far(failure, reason) => {
                let suspect =
                    Suspect { checker: self, tally, earlier, chain, at, statement, failure: &failure };
                if suspect.doubt().is_none() && suspect.can_be_confirmed() {
                    let mut found = wrong(&finding, &failure, counterexample::reasons(&failure, tally));
                    found.evidence.push(Evidence::Names);
                    unfounded = Some(found);
                }
                refute::Decision::Open(reason)
            }
            refute::Decision::Condition(_) | refute::Decision::Redefinition(_) => {
                let failure = counterexample::best_failure(tally, outcomes, chain);
                let slip = failure.filter(|failure| {
                    let suspect = Suspect { checker: self, tally, earlier, chain, at, statement, failure };
                    suspect.is_slip(|| {
                        let repair = repair()?;
                        finding.suggestion = repair.latex();
                        Some(repair)
                    })
                });
                match slip {
                    Some(failure) => {
                        finding.evidence = vec![Evidence::Near];
                        let reasons = counterexample::reasons(&failure, tally);
                        refute::Decision::Refuted { failure: Box::new(failure), reasons }
                    }
                    None => match refutation {
                        refute::Decision::Condition(reason) => refute::Decision::Open(reason),
                        other => other,
                    },
                }
            }
            other => other,
        };
        match refutation {
            refute::Decision::Refuted { failure, reasons } => {
                return Judged::Verdict(Box::new(wrong(&finding, &failure, reasons)));
            }
            refute::Decision::Redefinition(warning) => return Judged::Redefinition(warning),
            refute::Decision::Recursion(head) => return Judged::Recursion(head),
            refute::Decision::Open(reason)
            | refute::Decision::Condition(reason)
            | refute::Decision::Far(_, reason) => {
                finding.suggestion = None;
                finding.reason = Some(reason);
                if let Some(wrong) = unfounded {
                    return Judged::Unfounded(Box::new(finding), Box::new(wrong));
                }
            }
            refute::Decision::Loose(reason) => {
                finding.reason = Some("it fails as it stands".to_owned());
                finding.warning = Some(reason);
            }
        }
        Judged::Verdict(Box::new(finding))
    }

    /// Why what holds for numbers says nothing here: matrices, operators and elements of groups need not commute, and vectors
    /// have other products.
    fn of_no_numbers(&self, chain: &Chain, at: usize, statement: &Statement) -> Option<String> {
        let topics = statement.topics;
        let [left, right] = [0, 1].map(|side| &chain.sides[at + side].expr);
        let place = &statement.place;
        let given = |name: &str| self.context.visible(name, place).next().is_some();
        let groups = topics.has(Topic::Modular);
        if groups || topics.has(Topic::Operators) {
            let ordered = commuting::letters_in_order(left, right);
            let letter = |text: &String| {
                let base: String = text.chars().take_while(|c| c.is_alphanumeric()).collect();
                let plain = text.rsplit(' ').next().unwrap_or(text);
                let capital = plain.trim_start_matches(['{', '\\']).starts_with(char::is_uppercase);
                (groups || capital) && !is_variable(&base) && !given(&base)
            };
            if let Some(letter) = ordered.iter().find(|text| letter(text)) {
                let letter = letter.split(['_', '\u{207b}']).next().unwrap_or(letter);
                return Some(format!("{letter} may be no number: then the order of factors counts"));
            }
        }
        let vector = |part: &Expr| match &part.kind {
            Kind::Accent(Accent::Vec, _) => true,
            Kind::Name(name) => {
                topics.has(Topic::Vectors)
                    && self
                        .context
                        .object_called(name, place)
                        .is_some_and(|told| told.object.sort == Sort::Vectors)
            }
            _ => false,
        };
        let mut crossed = false;
        for side in [left, right] {
            walk(side, &mut |part| match &part.kind {
                Kind::Cross(factors) => {
                    let one = |factor: &Expr| matches!(factor.kind, Kind::Group(_)) || vector(factor);
                    crossed |= factors.iter().any(vector) && factors.iter().all(one);
                }
                Kind::Mul(factors) => {
                    let vectors = factors.iter().filter(|factor| factor.has(&|part| vector(part))).count();
                    let inside: usize = factors.iter().map(|factor| count(factor, &vector)).sum();
                    crossed |= vectors > 1 && inside > 2;
                }
                _ => {}
            });
        }
        crossed.then(|| "vectors have several products: which one is meant?".to_owned())
    }

    /// A proof for all integers, if one is found.
    fn proof(&self, chain: &Chain, at: usize, place: &Place, attempt: &Attempt) -> Option<String> {
        let choices = attempt.choices;
        let equal = matches!(chain.relations[at].0, Rel::Eq | Rel::Equiv | Rel::Define);
        let tally = &attempt.outcomes.tallies[at - (chain.relations.len() - attempt.outcomes.tallies.len())];
        let plain =
            tally.record.unknown.is_empty() && tally.record.paired.is_empty() && tally.condition.is_none();
        if !equal || !plain || choices.total_above || choices.powers || tally.record.infinite {
            return None;
        }
        let lookup = |expr: &Expr| self.unfolded(expr, place, choices);
        let limits = Limits {
            steps: Some(crate::judge::instances::setting::share(&self.limits, 16)),
            ..self.limits.clone()
        };
        let (left, right) = (&chain.sides[at].expr, &chain.sides[at + 1].expr);
        let proof = budget::run(&limits, || prove(left, right, &lookup)).ok()??;
        Some(proof.reason)
    }

    fn notes(&self, tally: &Tally) -> Vec<String> {
        let record = &tally.record;
        let named = |note: &&String| !note.starts_with(UNNAMED);
        let mut notes: Vec<String> = record.standard.union(&record.generic).filter(named).cloned().collect();
        for (number, _) in &tally.record.definitions {
            let definition = &self.context.definitions[*number];
            notes.push(format!("{} as defined in line {}", definition.head.base, definition.line));
        }
        for name in tally.record.unknown.iter().filter(|name| !name.starts_with(UNNAMED)) {
            notes.push(format!("{name} is any polynomial"));
        }
        notes
    }
}

/// How many parts of a product are such.
fn count(expr: &Expr, own: &dyn Fn(&Expr) -> bool) -> usize {
    if own(expr) {
        return 1;
    }
    let mut found = 0;
    if matches!(expr.kind, Kind::Mul(_) | Kind::Group(_)) {
        expr.for_each_child(&mut |child| found += count(child, own));
    }
    found
}

/// Why a relation that holds in all instances is not confirmed by them.
fn untested(tally: &Tally, outcomes: &Outcomes, chain: &Chain, at: usize, ranged: bool) -> Option<String> {
    let few = tally.holds_inner == 0 && tally.holds < 6 && !outcomes.integers.is_empty();
    if ranged && (tally.holds < 2 || few) {
        return Some("too few instances make sense".to_owned());
    }
    // x'(0) = 8(b_1 - b_0), where b_1 = b_0; but h(-1, 1) = p(2) may well be 0.
    let data = |side: &Side| {
        let mut called = BTreeSet::new();
        walk(&side.expr, &mut |part| {
            if let Kind::Apply(callee, _) = &part.kind {
                called.extend(bases(callee));
            }
        });
        bases(&side.expr).iter().any(|name| !called.contains(name) && !is_variable(name))
    };
    let given = tally.condition.is_some() || !tally.record.definitions.is_empty();
    let special = ranged || given && chain.sides[at..=at + 1].iter().any(data);
    if special && tally.nonzero == 0 && !says_zero(chain) {
        return Some("both sides are 0 in every instance, so nothing was tested".to_owned());
    }
    let gap = tally.gap.as_ref().filter(|_| ranged)?;
    Some(format!("not all instances could be computed: {gap}"))
}

/// Whether a side is the number 0: then vanishing is what is claimed.
fn says_zero(chain: &Chain) -> bool {
    let zero = |side: &Side| matches!(&side.expr.kind, Kind::Number(q) if num_traits::Zero::is_zero(q));
    chain.sides.iter().any(zero)
}

/// What comes of one relation.
pub(in crate::judge) enum Judged {
    Verdict(Box<Finding>),
    /// It fails, and nothing in it shows that it is wrong: how it stays open, and what it is if others show that its
    /// names are understood.
    Unfounded(Box<Finding>, Box<Finding>),
    /// It says how the members of a family follow from those that are known.
    Recursion(Box<Head>),
    /// It defines its name anew.
    Redefinition(Option<String>),
}
