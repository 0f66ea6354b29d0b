//! Conditions of formulas: which formulas are conditions, and which claims they belong to.

use super::speech;
use crate::formula::{BigOp, Expr, Kind, Link, Rel, interval};
use crate::judge::page::statement::{Chain, Role, Said, Side, Statement, links};
use crate::judge::written::names::{Head, bases, contains, is_index_letter, is_range, walk};
use crate::language::lexicon::roles::{is_control_point, is_variable};

/// Words after which conditions follow.
const CONDITION_WORDS: &[&str] = &[
    "where",
    "with",
    "for",
    "for all",
    "if",
    "when",
    "provided",
    "such that",
    "s.t.",
    "given",
    "and",
    "wo",
    "mit",
    "für",
    "où",
    "avec",
    "pour",
    "其中",
    "且",
    "当",
    "若",
    "对",
    "对任意",
    "对于",
    "满足",
];

pub(super) fn is_condition_word(text: &str) -> bool {
    let text = text.trim().trim_matches([',', '，', '(', ':', '：']).trim().to_lowercase();
    CONDITION_WORDS.contains(&text.as_str())
}

/// Whether the words before a formula say that it is a condition of what stands before them.
pub(super) fn announces_condition(gap: &str) -> bool {
    let gap = gap.trim().trim_start_matches([',', '，', '.', '。', ';', '(', '（']).trim().to_lowercase();
    let chinese = ["其中", "且", "当", "若", "对任意", "对于", "满足", "这里"];
    chinese.iter().any(|word| gap.starts_with(word) && gap.chars().count() <= 8)
        || CONDITION_WORDS.iter().any(|word| gap == *word)
        || ["for all", "where", "with", "for every", "for each", "such that", "provided that"]
            .iter()
            .any(|word| gap.starts_with(word) && gap.len() < 24)
}

/// Conditions in one formula belong to the relations before them in it, and conditions after words
/// such as "where" to the formula before.
pub(super) fn attach(statements: &mut [Statement]) {
    give_first(statements);
    give_intervals(statements);
    give_what_exists(statements);
    give_cases_in_words(statements);
    for at in 0..statements.len() {
        let unread = match &statements[at].said {
            Said::Bare(side, _) | Said::Condition(side) => side.is_unread(),
            _ => false,
        };
        let condition = match &statements[at].said {
            Said::Bare(side, _) if unread => side.expr.clone(),
            Said::Condition(side) if !statements[at].is_case() || unread => side.expr.clone(),
            _ => continue,
        };
        let range = is_range(&condition);
        let (formula, group) = (statements[at].place.formula, statements[at].place.group);
        let words = announces_condition(&statements[at].gap);
        let gap_is_short = statements[at].gap.trim().chars().count() <= 3;
        let mut reach = formula;
        let (mut attached, mut passed) = (false, false);
        let end = (at..statements.len()).take_while(|&i| statements[i].place.formula == formula).last();
        let follows = statements[..at]
            .iter()
            .rev()
            .take_while(|other| other.place.formula == formula)
            .any(|other| matches!(other.said, Said::Chain(_)));
        for before in (0..=end.unwrap_or(at)).rev() {
            let other = &mut statements[before];
            let same = other.place.formula == formula;
            let earlier = before < at
                && other.place.formula < formula
                && (words || (gap_is_short && other.place.group == group))
                && (reach == formula || other.place.formula == reach);
            // f(x) = x^2, 0 ≤ x ≤ 1, f(x) = 2 - x, 1 ≤ x ≤ 2: each line has its own.
            let own = passed && before < at && matches!(other.said, Said::Condition(_));
            if !same && !earlier || own {
                break;
            }
            if before > at && follows {
                continue;
            }
            if let Said::Chain(chain) = &mut other.said {
                passed |= before < at;
                if !same {
                    reach = other.place.formula;
                }
                attached = true;
                match unread {
                    true => chain.blocked = true,
                    false => chain.conditions.extend(links(&condition)),
                }
            }
        }
        // Whatever is claimed right before a condition that cannot be read may hold under it only.
        if unread {
            let near = |other: &Statement| {
                other.place.group == group
                    && (formula.saturating_sub(2)..=formula).contains(&other.place.formula)
            };
            for other in statements.iter_mut().filter(|other| near(other)) {
                if let Said::Chain(chain) = &mut other.said {
                    chain.blocked = true;
                }
            }
        }
        // The range of one formula is not that of the next.
        if attached && range && !unread {
            statements[at].role = Some(Role::Case);
        }
    }
}

/// "f(b) - f(a) = f'(c)(b - a) for some c in (a, b)", "there is a c with …".
fn give_what_exists(statements: &mut [Statement]) {
    for at in 0..statements.len() {
        if statements[at].role != Some(Role::Exists) {
            continue;
        }
        let names = match &statements[at].said {
            Said::Bare(side, _) => bases(&side.expr),
            Said::Condition(side) => match &side.expr.kind {
                Kind::Chain(left, _) => bases(left),
                _ => continue,
            },
            _ => continue,
        };
        let (group, formula) = (statements[at].place.group, statements[at].place.formula);
        let reach = formula.saturating_sub(2)..=formula + 3;
        for other in statements.iter_mut() {
            if let Said::Chain(chain) = &mut other.said
                && other.place.group == group
                && reach.contains(&other.place.formula)
            {
                chain.exists.extend(names.iter().cloned());
            }
        }
    }
}

/// "f(x) = 0 if $x$ is not rational": it is not said of every x.
fn give_cases_in_words(statements: &mut [Statement]) {
    const IF: &[&str] = &[
        "if", "when", "whenever", "unless", "wenn", "falls", "sofern", "si", "lorsque", "cuando", "若", "当",
    ];
    for at in 1..statements.len() {
        let Said::Bare(side, _) = &statements[at].said else { continue };
        let gap = statements[at].gap.trim().trim_start_matches([',', '，']).trim().to_lowercase();
        if !IF.contains(&gap.as_str()) || !matches!(side.expr.kind, Kind::Name(_)) {
            continue;
        }
        let (name, group, formula) =
            (side.expr.clone(), statements[at].place.group, statements[at].place.formula);
        let before = &mut statements[at - 1];
        if let Said::Chain(chain) = &mut before.said
            && before.place.group == group
            && before.place.formula + 1 == formula
            && chain.relations.len() == 1
            && Head::of(&chain.sides[0].expr)
                .is_some_and(|head| head.flat().iter().any(|argument| argument.same_as(&name)))
        {
            // Nothing is known of the numbers of which words say that.
            let said = Expr::from(Kind::Text(gap));
            chain.conditions.push(Expr::relation(name, Rel::In, said));
        }
    }
}

/// "f(x) = x^2 on [0, 1]", "on [0, 1] we have f(x) = x^2": x lies there.
fn give_intervals(statements: &mut [Statement]) {
    let ends = |gap: &str| gap.contains(['。', ';', '；']) || gap.contains(". ") || gap.contains(".\n");
    for at in 0..statements.len() {
        let own = &statements[at];
        let expr = match &own.said {
            Said::Bare(Side { expr, .. }, _) => expr,
            // On [1, 2) = [t_3, t_4)
            Said::Chain(chain) if chain.sides.iter().all(|side| interval(&side.expr).is_some()) => {
                &chain.sides[0].expr
            }
            _ => continue,
        };
        let last = without_mark(own.gap.rsplit(['.', '。']).next().unwrap_or_default());
        let Some(joined) = speech::says_on(last).filter(|_| interval(expr).is_some()) else { continue };
        let opens =
            joined || last.len() < own.gap.len() || own.gap.trim_start().starts_with(char::is_uppercase);
        let (expr, group, formula) = (expr.clone(), own.place.group, own.place.formula);
        let place = |chain: &mut Chain, elsewhere: &[Expr]| {
            let bound = |variable: &Expr| elsewhere.iter().any(|condition| contains(condition, variable));
            if let Some(variable) = variable_of(chain).filter(|variable| !bound(variable)) {
                chain.conditions.push(Expr::relation(variable, Rel::In, expr.clone()));
            }
        };
        if !opens && let Some(before) = at.checked_sub(1).map(|before| &mut statements[before]) {
            let near = before.place.group == group && before.place.formula + 1 == formula;
            if let (true, Said::Chain(chain)) = (near, &mut before.said) {
                give_parameter(chain, &expr);
                place(chain, &[]);
            }
            continue;
        }
        // "On [2, 3] they sum to one, and for 1 ≤ t ≤ 4 we have …": t lies in the second.
        let mut elsewhere: Vec<Expr> = Vec::new();
        for later in statements[at + 1..].iter_mut() {
            let another = matches!(&later.said, Said::Bare(side, _) if interval(&side.expr).is_some())
                && speech::says_on(&later.gap).is_some();
            if later.place.group != group || ends(&later.gap) || another {
                break;
            }
            match &mut later.said {
                Said::Condition(side) => elsewhere.push(side.expr.clone()),
                Said::Chain(chain) => place(chain, &elsewhere),
                _ => {}
            }
        }
    }
}

/// Words without the mark of a part before them: "(a) On".
fn without_mark(words: &str) -> &str {
    let words = words.trim_start_matches(['*', '_', '}', ' ', '\n']);
    match words.strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        Some((mark, rest)) if mark.chars().count() < 4 => rest,
        _ => words,
    }
}

/// "N_{i,0} = 1 on [t_i, t_{i+1})": a function without its parameter, N_{i,0}(x).
fn give_parameter(chain: &mut Chain, interval: &Expr) {
    let used = bases(interval);
    let Some(letter) = ["t", "x", "u", "s"].into_iter().find(|letter| !used.contains(*letter)) else {
        return;
    };
    if let [left, right] = chain.sides.as_mut_slice()
        && bases(&right.expr).is_empty()
        && let Some(head) = Head::of(&left.expr).filter(|head| head.arguments.is_none())
        && head.lower.iter().chain(&head.upper).any(|index| !bases(index).is_disjoint(&used))
    {
        let callee = Box::new(left.expr.clone());
        left.expr = Expr::new(Kind::Apply(callee, vec![vec![Expr::name(letter)]]), left.expr.span);
    }
}

/// The variable of which a chain speaks: the one in the calls of its left side, or else of all its sides.
fn variable_of(chain: &Chain) -> Option<Expr> {
    let left = &chain.sides[0].expr;
    let called = Head::of(left).and_then(|head| match head.flat().as_slice() {
        [variable @ Expr { kind: Kind::Name(_), .. }] => Some((*variable).clone()),
        _ => None,
    });
    called.or_else(|| {
        let mut found: Vec<Expr> = Vec::new();
        for side in &chain.sides {
            walk(&side.expr, &mut |part| {
                let Kind::Apply(_, groups) = &part.kind else { return };
                if let [variable @ Expr { kind: Kind::Name(name), .. }] = groups.concat().as_slice()
                    && is_variable(name)
                    && !found.iter().any(|known| known.same_as(variable))
                {
                    found.push(variable.clone());
                }
            });
        }
        <[Expr; 1]>::try_from(found).ok().map(|[only]| only)
    })
}

/// Whether what follows explains the formula before: "where", but not "for". "With" does so within a sentence; at its start it
/// begins a case.
fn looks_back(gap: &str) -> bool {
    let sentence = gap.contains(['.', '。', '!', '?']);
    let gap = gap.trim().trim_start_matches([',', '，', '.', '。', ';', '(', '（']).trim();
    let begins = sentence || gap.starts_with(char::is_uppercase);
    let gap = gap.to_lowercase();
    let chinese = ["其中", "这里"].iter().any(|word| gap.starts_with(word) && gap.chars().count() <= 8);
    chinese
        || ["where", "wo", "wobei", "où"].contains(&gap.as_str())
        || !begins && ["with", "mit", "avec"].contains(&gap.as_str())
}

/// "where v_i = p_i − q_i" after a formula is known in it: such definitions go before it.
fn give_first(statements: &mut [Statement]) {
    let mut at = 1;
    while at < statements.len() {
        let formula = statements[at].place.formula;
        let defines = match &statements[at].said {
            Said::Chain(chain) => {
                looks_back(&statements[at].gap)
                    && chain.relations.first().is_some_and(|(rel, _)| matches!(rel, Rel::Eq | Rel::Define))
                    && Head::of(&chain.sides[0].expr).is_some()
            }
            _ => false,
        };
        // "With ⟨f, g⟩ = …" at the start of another section explains nothing before it.
        let near = statements[at - 1].place.scope == statements[at].place.scope;
        if defines && near && statements[at - 1].place.formula + 1 == formula {
            let start = (0..at).rev().take_while(|&i| statements[i].place.formula + 1 == formula).last();
            let end = (at..statements.len()).take_while(|&i| statements[i].place.formula == formula).last();
            if let (Some(start), Some(end)) = (start, end) {
                if let Said::Chain(chain) = &mut statements[at].said {
                    chain.given = true;
                }
                statements[start..=end].rotate_left(at - start);
                at = end;
            }
        }
        at += 1;
    }
}

/// Whether a relation restricts names instead of stating something.
pub(super) fn is_condition(expr: &Expr, follows: bool) -> bool {
    let Kind::Chain(left, links) = &expr.kind else { return false };
    let bare = |expr: &Expr| match &expr.kind {
        Kind::Name(_) => true,
        Kind::Subscript(base, _) => matches!(base.kind, Kind::Name(_)),
        _ => false,
    };
    let size = |expr: &Expr| matches!(expr.kind, Kind::Number(_) | Kind::Name(_) | Kind::Add(_));
    let sides: Vec<&Expr> =
        std::iter::once(left.as_ref()).chain(links.iter().map(|link| &link.expr)).collect();
    let ordered = |link: &Link| matches!(link.rel, Rel::Le | Rel::Lt | Rel::Ge | Rel::Gt);
    match links.as_slice() {
        [Link { rel: Rel::In | Rel::NotIn | Rel::Subset, .. }] => true,
        [Link { rel: Rel::Eq, expr, .. }] if matches!(expr.kind, Kind::Range(..)) => bare(left),
        // a ≤ i ≤ b
        [one, two] if ordered(one) && ordered(two) => bare(sides[1]),
        [one] if ordered(one) && follows => bare(sides[0]) || bare(sides[1]),
        [one] if ordered(one) => bare(sides[0]) && size(sides[1]) || size(sides[0]) && bare(sides[1]),
        many if many.len() > 1 && many.iter().all(ordered) => {
            sides.iter().all(|side| bare(side) || size(side))
        }
        [Link { rel: Rel::Ne, .. }] => bare(left),
        // i + j + k = n, α + β + γ = 1
        [Link { rel: Rel::Eq, expr, .. }] => {
            let names = matches!(&left.kind, Kind::Add(terms) if terms.iter().all(|term| bare(&term.expr)));
            let weights = matches!(&left.kind, Kind::Big { op: BigOp::Sum, lower, body, .. }
                if matches!(body.kind, Kind::Subscript(..)) && bare(body)
                    || lower.is_empty() && matches!(body.kind, Kind::Name(_)));
            let one = matches!(&expr.kind, Kind::Number(_));
            // "where k = n + 1"
            let index = |name: &String| is_index_letter(name);
            let sizes = follows
                && matches!(&left.kind, Kind::Name(name) if is_index_letter(name))
                && matches!(&expr.kind, Kind::Add(_))
                && bases(expr).iter().all(index)
                && !bases(expr).is_empty();
            // "a term with t_j = t_{j+k-1}"; where d_{n+i} = d_i, a curve is closed.
            let index = |part: &Expr| {
                Head::of(part).filter(|head| head.arguments.is_none() && head.index().is_some())
            };
            let coincide = follows
                && matches!((index(left), index(expr)), (Some(one), Some(other))
                    if one.base == other.base && !is_control_point(&one.base) && bases(left).iter().any(|name| is_index_letter(name)));
            (names && (one || follows && bare(expr))) || (weights && one) || sizes || coincide
        }
        _ => false,
    }
}

/// C^1, G^2: how smoothly curves meet.
pub(super) fn is_smoothness(expr: &Expr) -> bool {
    let Kind::Pow(base, order) = &expr.kind else { return false };
    matches!(&base.kind, Kind::Name(name) if name == "C" || name == "G")
        && order.as_int().is_some_and(|order| (1..=4).contains(&order))
}
