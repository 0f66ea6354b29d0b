//! Which formulas of a sentence are claimed, and in which cases.
//!
//! **Definition.** A sentence ends at a point, a question mark, a heading, or a paragraph that does not
//! go on in small letters. A case ("if n = 2", "for t = 0") belongs to the claims of its sentence: to
//! those after it when the sentence begins with a case, else to the claim before it. A case without a
//! claim in its sentence says nothing that later claims need.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use super::cases::{self, parity};
use super::conditions::announces_condition;
use super::released::Released;
use super::speech::{self, Around};
use crate::document::{Document, Item, Style};
use crate::formula::source::{Pieces, Span};
use crate::formula::{Expr, Kind, Link, Rel};
use crate::judge::page::statement::{Chain, Role, Said, Side, Statement, links};
use crate::judge::written::names::{Head, bases, is_index_letter};
use crate::language::lexicon::roles::is_variable;

/// Gives every statement its role and every claim the cases of its sentence.
///
/// Cost: linear in the document, times the number of cues.
pub fn assign(sentences: &[Vec<Piece>], statements: &mut [Statement]) {
    let around = surroundings(sentences);
    let mut start = 0;
    let mut released = Released::new(&around);
    while start < statements.len() {
        let first = statements[start].place.formula;
        let mut end = start;
        // Formulas are numbered from 1; up to the next one that begins a sentence.
        while end < statements.len() && {
            let formula = statements[end].place.formula;
            formula == first || around.get(formula.wrapping_sub(1)).is_some_and(|words| !words.first)
        } {
            end += 1;
        }
        sentence(&around, &mut statements[start..end]);
        released.sentence(&mut statements[start..end]);
        start = end;
    }
}

/// Abbreviations whose point ends no sentence.
const ABBREVIATIONS: &[&str] = &[
    "i.e", "e.g", "d.h", "z.b", "s.t", "resp", "bzw", "cf", "vgl", "eq", "fig", "no", "p.ex", "w.l.o.g",
    "o.b.d.a",
];

/// The byte after the first end of a sentence in a text, if there is one.
fn sentence_end(text: &str) -> Option<usize> {
    for (at, c) in text.char_indices() {
        let end = at + c.len_utf8();
        match c {
            '。' | '！' | '？' => return Some(end),
            '.' | '!' | '?' => {
                let rest = text.piece(end..).trim_start_matches(['*', '_', ')', '"', '”', '\'']);
                let word = text.piece(..at).rsplit(char::is_whitespace).next().unwrap_or("");
                let word = word.trim_start_matches(['(', '*', '_']).to_lowercase();
                let number = !word.is_empty()
                    && word.chars().all(|c| c.is_ascii_digit())
                    && text.piece(..at).trim() == word;
                // "see 4. and 5."
                let goes_on = word.ends_with(|c: char| c.is_ascii_digit())
                    && rest.trim_start().starts_with(char::is_lowercase);
                let open = c == '.' && (ABBREVIATIONS.contains(&word.as_str()) || number || goes_on);
                if !open && (rest.is_empty() || rest.starts_with(char::is_whitespace)) {
                    return Some(text.len() - rest.len());
                }
            }
            _ => {}
        }
    }
    None
}

/// A part of a sentence.
#[derive(Clone, Debug)]
pub enum Piece {
    /// Words, with the signs between them.
    Words(String),
    /// The number of a formula, counted from 1.
    Formula(usize),
}

/// The sentences of a document.
pub fn sentences(document: &Document) -> Vec<Vec<Piece>> {
    let mut found: Vec<Vec<Piece>> = Vec::new();
    let mut current: Vec<Piece> = Vec::new();
    let (mut paused, mut displayed, mut number) = (false, false, 0);
    let mut end = |current: &mut Vec<Piece>| {
        if !current.is_empty() {
            found.push(std::mem::take(current));
        }
    };
    for item in &document.items {
        match item {
            Item::Words(span) => {
                let read = document.words(*span);
                let mut words = read.as_ref();
                let goes_on =
                    words.trim_start().starts_with(|c: char| c.is_lowercase() || matches!(c, ',' | '，'));
                // After a display a capital letter begins a sentence, with or without a full stop.
                let begins = words.trim_start().starts_with(char::is_uppercase);
                if std::mem::take(&mut paused) && !words.trim().is_empty() && !goes_on
                    || std::mem::take(&mut displayed) && begins
                {
                    end(&mut current);
                }
                while let Some(at) = sentence_end(words) {
                    current.push(Piece::Words(words.piece(..at).to_owned()));
                    end(&mut current);
                    words = words.piece(at..);
                }
                if !words.trim().is_empty() {
                    current.push(Piece::Words(words.to_owned()));
                }
            }
            Item::Formula(formula) => {
                number += 1;
                current.push(Piece::Formula(number));
                (paused, displayed) = (false, formula.style == Style::Display);
                if formula.text.trim_end().ends_with(['.', '。']) {
                    end(&mut current);
                }
            }
            Item::Break => paused = true,
            Item::Heading { span, .. } => {
                end(&mut current);
                paused = false;
                let title = document.words(*span);
                if speech::asks_what_is_true(&title) {
                    current.push(Piece::Words(title.into_owned()));
                    end(&mut current);
                }
            }
            Item::Enter(_) | Item::Leave(_) => {
                end(&mut current);
                paused = false;
            }
            Item::Declaration { .. } | Item::Title { .. } => {}
        }
    }
    end(&mut current);
    found
}

/// The words around each formula, in their order.
fn surroundings(sentences: &[Vec<Piece>]) -> Vec<Around> {
    let mut found: Vec<Around> = Vec::new();
    let mut before = 0;
    // "True or false? (a) … (b) …": what follows is put to the reader, up to the next words.
    let mut put = false;
    for sentence in sentences {
        let start = match sentence.first() {
            Some(Piece::Words(words)) => words.as_str(),
            _ => "",
        };
        put = put && is_label(start) || speech::asks_what_is_true(start);
        // "…. This is false"
        if let Some(Piece::Words(words)) = sentence.first()
            && speech::calls_that_wrong(words)
        {
            found[before..].iter_mut().for_each(|around| around.mistaken = true);
        }
        before = found.len();
        let (mut left, mut first) = (String::new(), true);
        let (mut ours, mut proves, mut mistaken) = (false, false, false);
        let asks = put || is_question(sentence);
        for piece in sentence {
            match piece {
                Piece::Words(words) => {
                    if let (false, Some(around)) = (first, found.last_mut()) {
                        around.right.push_str(words);
                    }
                    left.push_str(words);
                    left.push(' ');
                    ours |= speech::ours(words);
                    proves |= speech::proves(words);
                    mistaken |= speech::names_a_mistake(words);
                }
                Piece::Formula(_) => {
                    found.push(Around {
                        left: std::mem::take(&mut left),
                        right: String::new(),
                        first,
                        ours,
                        proves,
                        mistaken,
                        asks,
                    });
                    first = false;
                }
            }
        }
    }
    found
}

/// Whether words are nothing but the label of an item: "(a)", "2."
fn is_label(words: &str) -> bool {
    words.split_whitespace().all(|word| word.chars().filter(|c| c.is_alphanumeric()).count() <= 2)
        && words.split_whitespace().count() <= 1
}

/// Whether a sentence asks whether something is so, or what makes it so; "why" asks for the reason of what is so.
fn is_question(sentence: &[Piece]) -> bool {
    let words = |piece: Option<&Piece>| match piece {
        Some(Piece::Words(words)) => words.trim().to_owned(),
        _ => String::new(),
    };
    let last = words(sentence.last());
    let ends = last.trim_end_matches(['*', '_', ')', '"', '”', '\'']).ends_with(['?', '？']);
    ends && !speech::asks_why(&words(sentence.first()))
}

/// The statements of one sentence.
fn sentence(around: &[Around], statements: &mut [Statement]) {
    let mut formulas: Vec<usize> = statements.iter().map(|statement| statement.place.formula).collect();
    formulas.dedup();
    let words_of = |formula: usize| around.get(formula.wrapping_sub(1)).cloned().unwrap_or_default();
    let claims = |role: Option<Role>| matches!(role, Some(Role::Claimed | Role::Always));
    // "For f(0) = 1, f(1) = 3: f[0, 1] = 2"
    let after_colon = |words: &Around| words.left.trim_start().starts_with([':', '：']);
    // "For n = 1, m = 2 we have …"
    let claimed: Vec<bool> = formulas
        .iter()
        .map(|&formula| {
            let words = words_of(formula);
            claims(speech::role(&words, false)) || after_colon(&words)
        })
        .collect();
    let says_a_name = |formula: usize| {
        let own = statements.iter().filter(|statement| statement.place.formula == formula);
        own.into_iter().all(|statement| {
            matches!(&statement.said, Said::Bare(side, _) if matches!(side.expr.kind, Kind::Name(_)))
        })
    };
    let mut roles: Vec<(Option<Role>, bool)> = Vec::with_capacity(formulas.len());
    for (at, &formula) in formulas.iter().enumerate() {
        let words = words_of(formula);
        let claims_later = claimed[at + 1..].iter().any(|&claimed| claimed);
        // "For knots with the distance h and g(x) = x^2, …"
        let opened =
            at == 1 && speech::goes_on(&words.left) == Some(false) && !words.left.trim().is_empty() && {
                let start = words_of(formulas[0]);
                // "For the values b_0 = 0, b_1 = 2": the first says what it is, and so does the next.
                let data = statements.first().is_some_and(|first| match &first.said {
                    Said::Chain(chain) => gives_member(chain),
                    _ => false,
                });
                start.first && roles[0].0.is_none() && !data && speech::opens_case(&start.left)
            };
        if opened {
            roles.push((Some(Role::Case), false));
            continue;
        }
        // "and also" goes on, "also" alone claims.
        let joined = words.left.chars().any(char::is_alphanumeric) && speech::goes_on(&words.left).is_some();
        let left = if joined { String::new() } else { words.left.clone() };
        let mut role = speech::role(&speech::Around { left, ..words.clone() }, claims_later);
        let mut alternative = false;
        if role.is_none()
            && let Some((Some(before), _)) = at.checked_sub(1).map(|before| roles[before])
            && let Some(or) = speech::goes_on(&words.left)
        {
            let comma = words.left.trim().chars().all(|c| !c.is_alphanumeric());
            // "If a = 0, b = 1": after the comma comes what is claimed, unless a "then" comes.
            let consequent = comma && matches!(before, Role::Case | Role::All) && !claims_later;
            // "They vanish at $u$, and $a = b$": a name is no case that an equation goes on with.
            let of_name = matches!(before, Role::Case | Role::All)
                && says_a_name(formulas[at - 1])
                && !says_a_name(formula);
            // "Put i = j + 1: …" introduces i, and what comes of it follows.
            if !claims(Some(before)) && !consequent && !of_name && !after_colon(&words) {
                (role, alternative) = (Some(before), or);
            }
        }
        roles.push((role, alternative));
    }
    let role_of = |statement: &Statement| {
        let at = formulas.iter().position(|&formula| formula == statement.place.formula);
        at.map_or((None, false), |at| roles[at])
    };
    // "For all t": a bare name is no case.
    let quantified: BTreeSet<String> = statements
        .iter()
        .filter(|statement| role_of(statement).0 == Some(Role::All))
        .filter_map(|statement| match &statement.said {
            Said::Bare(side, _) => Some(bases(&side.expr)),
            _ => None,
        })
        .flatten()
        .collect();
    let members = statements.iter().filter(|statement| {
        role_of(statement).0 == Some(Role::Case)
            && matches!(&statement.said, Said::Chain(chain) if gives_member(chain))
    });
    let several = members.count() > 1;
    let first = formulas.first().map(|&formula| words_of(formula).left).unwrap_or_default();
    let alone = first.trim().is_empty() || speech::goes_on_from_before(&first);
    let claimed =
        formulas.iter().zip(&roles).find(|(_, (role, _))| claims(*role)).map(|(formula, _)| *formula);
    let concluded = LazyCell::new(|| {
        formulas.iter().copied().find(|&formula| speech::concludes(&words_of(formula).left))
    });
    for statement in statements.iter_mut() {
        let own = statement.place.formula;
        statement.concludes =
            alone || claimed.is_some_and(|first| first < own) || concluded.is_some_and(|first| first <= own);
        let (mut role, _) = role_of(statement);
        if let Said::Chain(chain) = &mut statement.said {
            // "It vanishes for all t, so w = 1": of w nothing is said for all values.
            let used: BTreeSet<String> = chain.sides.iter().flat_map(|side| bases(&side.expr)).collect();
            chain.quantified = used.intersection(&quantified).cloned().collect();
            chain.universal = !chain.quantified.is_empty() || role == Some(Role::Always);
        }
        // "Sie ist genau dann C^1 in u_1, wenn b_n = …"
        let exactly = || formulas.iter().any(|&at| at <= own && speech::says_exactly(&words_of(at).left));
        role = match role {
            Some(Role::Case) if speech::ends_with_when(&words_of(own).left) && exactly() => {
                Some(Role::Equivalent)
            }
            Some(Role::Always) => Some(Role::Claimed),
            Some(Role::All) => Some(Role::Case),
            role => role,
        };
        let states = matches!(statement.said, Said::Chain(_) | Said::Condition(_));
        let integer = |side: &Side| matches!(&side.expr.kind, Kind::Name(name) if is_index_letter(name));
        if let Said::Bare(side, _) = &statement.said
            && integer(side)
            && let Some(odd) = speech::parity_before(&words_of(own).left)
        {
            role = Some(if odd { Role::Odd } else { Role::Even });
        }
        let parity = matches!((role, &statement.said), (Some(Role::Odd | Role::Even), Said::Bare(side, _)) if integer(side));
        // Words such as "otherwise" speak of the formula beside them.
        statement.role = match role {
            Some(Role::Elsewhere) => {
                if let Said::Chain(chain) = &mut statement.said {
                    chain.partial = true;
                }
                None
            }
            Some(Role::Odd | Role::Even) if !parity => None,
            // "For f(x) = x^3 we have": an example names a function, a case a value.
            // In an example, "For the knots u_i = i" and "For b_0 = 1, b_1 = 2" are its data; elsewhere "for w_i = 1" is
            // a special case.
            Some(Role::Case)
                if matches!(&statement.said, Said::Chain(chain) if names_a_function(chain)
                    && (is_called(chain) || !statement.place.blocks.is_empty())
                    || several && gives_member(chain) && !statement.place.blocks.is_empty()) =>
            {
                Some(Role::Introduced)
            }
            // "What is the polar form of F(t) = t^2?" says what F is.
            None | Some(Role::Claimed)
                if words_of(own).asks
                    && matches!(&statement.said, Said::Chain(chain) if !names_a_function(chain)) =>
            {
                Some(Role::Asked)
            }
            role if states || parity => role,
            _ => None,
        };
    }
    rewritten(statements);
    examples(around, statements);
    equations(statements);
    attach_cases(statements, &|statement| role_of(statement).1);
    let last = formulas.last().copied().unwrap_or_default();
    cases::complete(statements, &|statements, at| {
        let Said::Chain(own) = &statements[at].said else { return None };
        let rest = &statements[at + 1..];
        let said = rest.iter().find_map(|statement| match &statement.said {
            Said::Chain(chain) if chain.partial && chain.sides[0].expr.same_as(&own.sides[0].expr) => {
                Some(chain.sides[1].expr.clone())
            }
            Said::Bare(side, _) if role_of(statement).0 == Some(Role::Elsewhere) => Some(side.expr.clone()),
            _ => None,
        });
        let in_words = || {
            let claim =
                |statement: &Statement| matches!(statement.said, Said::Chain(_)) && !statement.is_case();
            let zero = !rest.iter().any(claim) && speech::zero_elsewhere(&words_of(last).right);
            zero.then(|| Expr::int(0))
        };
        said.or_else(in_words)
    });
}

/// "We write p(t) = t^2 as Σ b_i B_i^2(t)": the two are equal.
fn rewritten(statements: &mut [Statement]) {
    let composed = |expr: &Expr| matches!(expr.kind, Kind::Add(_) | Kind::Big { .. });
    for at in 1..statements.len() {
        let (before, own) = statements.split_at_mut(at);
        let (Some(before), Some(own)) = (before.last(), own.first_mut()) else { continue };
        let first = match &before.said {
            Said::Chain(chain) if !chain.given => chain.sides.first(),
            Said::Bare(side, _) => Some(side),
            _ => None,
        };
        if let (Some(first), Said::Bare(sum, problems)) = (first, &own.said)
            && before.place.formula < own.place.formula
            && composed(&sum.expr)
            && !matches!(&first.expr.kind, Kind::Name(name) if bases(&sum.expr).contains(name))
            && speech::says_as(&own.gap, matches!(first.expr.kind, Kind::Apply(..)))
        {
            let sign = Span { start: first.expr.span.end, end: sum.expr.span.start };
            let equation = Chain::new(vec![first.clone(), sum.clone()], vec![(Rel::Eq, sign)]);
            own.said = Said::Chain(Chain { problems: problems.clone(), ..equation });
        }
    }
}

/// "From 2h/9 = 1/3 follows h = 3/2": an equation, and then what solves it.
fn equations(statements: &mut [Statement]) {
    let solution = |statement: &Statement| match &statement.said {
        Said::Chain(Chain { sides, relations, .. }) => match (&sides[0].expr.kind, relations.as_slice()) {
            (Kind::Name(name), [(Rel::Eq, _)]) if !bases(&sides[1].expr).contains(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    };
    for at in 1..statements.len() {
        let Some(name) = solution(&statements[at]) else { continue };
        // "x = T M b with M = …" says what M is.
        if announces_condition(&statements[at].gap) {
            continue;
        }
        if let Said::Chain(chain) = &statements[at - 1].said
            && chain.sides.iter().any(|side| bases(&side.expr).contains(&name))
            && solution(&statements[at - 1]).is_none()
        {
            statements[at - 1].solved = Some(name);
        }
    }
}

/// "We know it for f(x) = x and f(x) = x^2": formulas for one function in a row are examples of it.
fn examples(around: &[Around], statements: &mut [Statement]) {
    let called = |statement: &Statement| match &statement.said {
        Said::Chain(chain) if names_a_function(chain) => Some(chain.sides[0].expr.clone()),
        _ => None,
    };
    for at in 1..statements.len() {
        let (before, own) = (&statements[at - 1], &statements[at]);
        let words = around.get(own.place.formula.wrapping_sub(1)).map_or("", |words| &words.left);
        let same = matches!((called(before), called(own)), (Some(a), Some(b)) if a.same_as(&b));
        let joined = words.chars().any(char::is_alphabetic) && speech::goes_on(words).is_some();
        if same && joined && own.role != Some(Role::Claimed) {
            statements[at - 1].role = Some(Role::Introduced);
            statements[at].role = Some(Role::Introduced);
        }
    }
}

/// Whether a chain says what a function or a sequence is: f(x) = …, a_k = ….
fn names_a_function(chain: &Chain) -> bool {
    let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return false };
    let plain = |expr: &Expr| matches!(expr.kind, Kind::Name(_));
    Head::of(&chain.sides[0].expr).is_some_and(|head| {
        let inside = head.lower.iter().chain(head.flat());
        head.upper.is_empty()
            && (head.arguments.is_some() || !head.lower.is_empty())
            && inside.into_iter().all(plain)
    })
}

/// Whether the left side of a chain has arguments.
fn is_called(chain: &Chain) -> bool {
    Head::of(&chain.sides[0].expr).is_some_and(|head| head.arguments.is_some())
}

/// Whether a chain gives one member of a family its value: b_0 = 1.
fn gives_member(chain: &Chain) -> bool {
    let [(Rel::Eq | Rel::Define, _)] = chain.relations.as_slice() else { return false };
    let number = |expr: &Expr| matches!(expr.kind, Kind::Number(_));
    Head::of(&chain.sides[0].expr).is_some_and(|head| {
        head.upper.is_empty()
            && head.arguments.is_none()
            && !head.lower.is_empty()
            && head.lower.iter().all(number)
    })
}

/// Hands the cases of a sentence to its claims.
fn attach_cases(statements: &mut [Statement], is_alternative: &dyn Fn(&Statement) -> bool) {
    let is_claim = |statement: &Statement| {
        !statement.is_case()
            && matches!(&statement.said, Said::Chain(chain) if !chain.given)
            && !matches!(statement.role, Some(Role::Assumed | Role::Asked | Role::Sought | Role::Equivalent))
    };
    let Some(begins) = statements.iter().position(|statement| statement.is_case() || is_claim(statement))
    else {
        return;
    };
    let forward = statements[begins].is_case();
    let mut at = 0;
    while at < statements.len() {
        if !statements[at].is_case() {
            at += 1;
            continue;
        }
        let last = |i: usize| !statements[i].is_case() || i > at && !forward && turns(statements, i);
        let end = (at..statements.len()).find(|&i| last(i)).unwrap_or(statements.len());
        let conditions = conditions(&statements[at..end], is_alternative);
        let after: Vec<usize> = (end..statements.len())
            .take_while(|&i| !statements[i].is_case())
            .filter(|&i| is_claim(&statements[i]))
            .collect();
        let before: Vec<usize> = (0..at)
            .rev()
            .find(|&i| is_claim(&statements[i]))
            .map(|last| {
                let formula = statements[last].place.formula;
                (0..at)
                    .filter(|&i| is_claim(&statements[i]) && statements[i].place.formula == formula)
                    .collect()
            })
            .unwrap_or_default();
        // "The algorithm b_i^r = … for t = 1/4 gives b_0^1 = 2": the verb after the case is of what comes.
        let leads = statements.get(end).is_some_and(|next| {
            let words = next.gap.trim();
            let joined = words.starts_with(|c: char| !c.is_alphanumeric()) || speech::joins(words);
            next.role == Some(Role::Claimed) && !joined && words.split_whitespace().count() < 3
        });
        let leads = leads || turns(statements, at);
        let mut targets = match (forward || leads, after.is_empty(), before.is_empty()) {
            (true, false, _) | (false, false, true) => after,
            _ => before,
        };
        // "Evaluate x(t) = Σ b_i B_i^3(t) with b_0 = (0, 0), … at t = 1/4": what is given holds for all t.
        if let Some(variable) = only_place(&statements[at..end]) {
            targets.retain(|&target| target > at || !is_given_for_all(&statements[target], &variable));
        }
        if targets.is_empty() {
            for statement in &mut statements[at..end] {
                // A restriction of names, such as a sum of weights, goes on, and so does what the words of the
                // sentence rest on ("they agree if b_3 - b_2 = c_1 - c_0"), to the end of the paragraph; a value
                // said in passing ("maximal at t = i/n") does not.
                match &statement.said {
                    Said::Condition(_) => statement.role = None,
                    // "Let n be odd."
                    Said::Bare(side, _) if matches!(statement.role, Some(Role::Odd | Role::Even)) => {
                        let expr = parity(&side.expr, statement.role == Some(Role::Odd));
                        statement.said = Said::Condition(Side { expr, ..side.clone() });
                        statement.role = Some(Role::Introduced);
                    }
                    Said::Chain(chain)
                        if statement.role == Some(Role::Case)
                            && !matches!(chain.sides[0].expr.kind, Kind::Name(_)) =>
                    {
                        statement.role = Some(Role::Assumed);
                    }
                    _ => {}
                }
            }
        }
        for target in targets {
            if let Said::Chain(chain) = &mut statements[target].said {
                match &conditions {
                    Some(conditions) => chain.conditions.extend(conditions.iter().flat_map(links)),
                    None => chain.partial = true,
                }
            }
        }
        at = end;
    }
}

/// "a_i = b_i for i < r, and for i ≥ r, a_i = c_i": whether a case of a list leads to the formula right after it.
fn turns(statements: &[Statement], at: usize) -> bool {
    let case = |gap: &str| {
        let around = speech::Around { left: gap.to_owned(), ..speech::Around::default() };
        let own = matches!(speech::role(&around, false), Some(Role::Case | Role::All));
        let words = gap.trim_start_matches(|c: char| !c.is_alphanumeric());
        own && speech::joins(words) && gap.trim_start().starts_with([',', '，', ';'])
    };
    let next = statements.get(at + 1).is_some_and(|next| {
        matches!(next.said, Said::Chain(_)) && !next.is_case() && !next.gap.chars().any(char::is_alphanumeric)
    });
    next && statements[at].is_case() && case(&statements[at].gap)
}

/// The variable of t = 1/4, if a run of cases is one such place.
fn only_place(cases: &[Statement]) -> Option<String> {
    let [Statement { said: Said::Chain(chain), .. }] = cases else { return None };
    match (chain.sides.as_slice(), chain.relations.as_slice()) {
        ([name, value], [(Rel::Eq, _)]) if bases(&value.expr).is_empty() => match &name.expr.kind {
            Kind::Name(name) if is_variable(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// Whether it says what a function of a variable is, x(t) = t^2, or gives a point by numbers.
fn is_given_for_all(statement: &Statement, variable: &str) -> bool {
    let Said::Chain(chain) = &statement.said else { return false };
    let ([left, right], [(Rel::Eq | Rel::Define, _)]) = (chain.sides.as_slice(), chain.relations.as_slice())
    else {
        return false;
    };
    let Some(head) = Head::of(&left.expr) else { return false };
    let names = bases(&right.expr);
    let point = head.lower.len() == 1 && head.upper.is_empty() && head.arguments.is_none();
    let function = head.lower.is_empty()
        && matches!(head.flat().as_slice(), [Expr { kind: Kind::Name(own), .. }] if own == variable);
    statement.role != Some(Role::Claimed)
        && (point && names.is_empty() || function && names.contains(variable))
}

/// The conditions that a run of cases says; `None` if one of them cannot be said as a formula.
fn conditions(cases: &[Statement], is_alternative: &dyn Fn(&Statement) -> bool) -> Option<Vec<Expr>> {
    let mut found: Vec<Expr> = Vec::new();
    for case in cases {
        let expr = match (&case.said, case.role?) {
            (Said::Bare(side, _), role @ (Role::Odd | Role::Even)) => parity(&side.expr, role == Role::Odd),
            (Said::Condition(side), Role::Case) => side.expr.clone(),
            (Said::Chain(chain), Role::Case) => chain.whole(),
            (Said::Condition(side), Role::Except) => negated(&side.expr)?,
            (Said::Chain(chain), Role::Except) => negated(&chain.whole())?,
            _ => return None,
        };
        match found.pop_if(|_| is_alternative(case)) {
            Some(other) => found.push(Expr::any(vec![other, expr])),
            None => found.push(expr),
        }
    }
    Some(found)
}

/// The contrary of one relation.
fn negated(expr: &Expr) -> Option<Expr> {
    let Kind::Chain(left, links) = &expr.kind else { return None };
    let [link] = links.as_slice() else { return None };
    let rel = match link.rel {
        Rel::Eq => Rel::Ne,
        Rel::Ne => Rel::Eq,
        Rel::Lt => Rel::Ge,
        Rel::Ge => Rel::Lt,
        Rel::Gt => Rel::Le,
        Rel::Le => Rel::Gt,
        _ => return None,
    };
    let link = Link { rel, ..link.clone() };
    Some(Expr::new(Kind::Chain(left.clone(), vec![link]), expr.span))
}
