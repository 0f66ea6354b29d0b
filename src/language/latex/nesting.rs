//! Which bracket belongs to which.
//!
//! Braces, `\left … \right` and environments pair strictly. Ordinary brackets pair
//! within those, and either of `)`, `]` may close `(` or `[` (half-open intervals).
//! A bracket without partner becomes a [`Tok::Bad`], so the reader meets its
//! problem exactly where it stands. Braces that are no argument of a command are
//! invisible in print and are dropped here, as TeX shows `{a}{b}` and `ab` alike.

use super::commands::Role;
use super::token::{ALONE, Fence, Tok, Token};
use crate::formula::Rel;
use crate::language::diagnostic::{Code, Diagnostic};

/// How far back a closing bracket looks for an opening one of its kind.
const LOOK_BACK: usize = 8;

/// How many arguments an unknown command takes: all that follow.
const ANY_NUMBER: u32 = u32::MAX;

/// Fills in the partners, drops transparent braces, marks brackets that hold relations or infix commands.
pub(super) fn pair(tokens: &mut [Token], problems: &mut Vec<Diagnostic>) {
    pair_strict(tokens, problems);
    open_ended(tokens);
    drop_transparent(tokens);
    pair_ordinary(tokens, problems);
}

fn link(tokens: &mut [Token], a: usize, b: usize) {
    tokens[a].partner = b as u32;
    tokens[b].partner = a as u32;
}

fn spoil(tokens: &mut [Token], at: usize, problems: &mut Vec<Diagnostic>, message: &str, hint: &str) {
    let problem = Diagnostic::error(Code::Unbalanced, message).at(tokens[at].span()).hint(hint);
    tokens[at].kind = Tok::Bad(problems.len() as u32);
    tokens[at].partner = ALONE;
    problems.push(problem);
}

/// The three strict kinds.
fn strict_kind(kind: Tok) -> Option<(usize, bool)> {
    Some(match kind {
        Tok::OpenBrace => (0, true),
        Tok::CloseBrace => (0, false),
        Tok::Left(_) => (1, true),
        Tok::Right(_) => (1, false),
        Tok::Begin(_) => (2, true),
        Tok::End(_) => (2, false),
        _ => return None,
    })
}

const UNCLOSED: [(&str, &str); 3] = [
    ("'{' without '}'", "add the missing '}'"),
    ("\\left without \\right", "write \\right. for an invisible bracket"),
    ("\\begin without \\end", "add the missing \\end"),
];
const UNOPENED: [(&str, &str); 3] = [
    ("'}' without '{'", "remove it, or add the missing '{'"),
    ("\\right without \\left", "write \\left. for an invisible bracket"),
    ("\\end without \\begin", "add the missing \\begin"),
];

fn pair_strict(tokens: &mut [Token], problems: &mut Vec<Diagnostic>) {
    let mut open: Vec<(usize, usize)> = Vec::new();
    let mut counts = [0_usize; 3];
    for at in 0..tokens.len() {
        let Some((kind, opens)) = strict_kind(tokens[at].kind) else {
            if matches!(tokens[at].kind, Tok::Command(Role::Infix(_) | Role::Switch(_)))
                && let Some(&(group, _)) = open.last()
            {
                tokens[group].special = true;
            }
            continue;
        };
        if opens {
            open.push((at, kind));
            counts[kind] += 1;
            continue;
        }
        if counts[kind] == 0 {
            spoil(tokens, at, problems, UNOPENED[kind].0, UNOPENED[kind].1);
            continue;
        }
        while let Some((start, found)) = open.pop() {
            counts[found] -= 1;
            if found == kind {
                if let (Tok::Begin(a), Tok::End(b)) = (tokens[start].kind, tokens[at].kind)
                    && a != b
                {
                    let message = "\\begin and \\end name different environments";
                    spoil(tokens, start, problems, message, "use the same name in both");
                    tokens[at].kind = Tok::Skip;
                } else {
                    link(tokens, start, at);
                }
                break;
            }
            spoil(tokens, start, problems, UNCLOSED[found].0, UNCLOSED[found].1);
        }
    }
    for (start, kind) in open {
        spoil(tokens, start, problems, UNCLOSED[kind].0, UNCLOSED[kind].1);
    }
}

/// `\left( … \right. \\ \left. … \right)` is one pair of brackets broken over rows.
fn open_ended(tokens: &mut [Token]) {
    for at in 0..tokens.len() {
        let Tok::Left(opening) = tokens[at].kind else { continue };
        let close = tokens[at].partner as usize;
        let Some(Tok::Right(closing)) = tokens.get(close).map(|token| token.kind) else { continue };
        match (opening, closing) {
            (Fence::Paren | Fence::Square, Fence::Dot) => {
                tokens[at].kind = Tok::Open(opening);
                tokens[close].kind = Tok::Skip;
            }
            (Fence::Dot, Fence::Paren) => {
                tokens[at].kind = Tok::Skip;
                tokens[close].kind = Tok::Close(closing);
            }
            _ => continue,
        }
        for end in [at, close] {
            tokens[end].partner = ALONE;
            tokens[end].special = false;
        }
    }
}

/// Drops braces that are not arguments. Follows the tokens with the number of arguments that
/// are still expected at each level of braces.
fn drop_transparent(tokens: &mut [Token]) {
    let mut expected: Vec<u32> = vec![0];
    // after the `]` of `\sqrt[3]` an argument is expected
    let mut after_bracket: Vec<usize> = Vec::new();
    for at in 0..tokens.len() {
        let kind = tokens[at].kind;
        let Some(waiting) = expected.last_mut() else { return };
        if *waiting == ANY_NUMBER && kind != Tok::OpenBrace {
            *waiting = 0;
        }
        match kind {
            Tok::Bad(_) => *waiting = ANY_NUMBER,
            Tok::OpenBrace => {
                let is_argument = *waiting > 0;
                if *waiting != ANY_NUMBER {
                    *waiting = waiting.saturating_sub(1);
                }
                let special = tokens[at].special;
                expected.push(0);
                if !is_argument && !special {
                    let close = tokens[at].partner as usize;
                    tokens[at].kind = Tok::Skip;
                    tokens[close].kind = Tok::Skip;
                    tokens[at].partner = ALONE;
                    tokens[close].partner = ALONE;
                    // the level still has to end at the closing brace
                    tokens[close].special = true;
                }
            }
            Tok::CloseBrace => {
                expected.pop();
            }
            Tok::Skip if tokens[at].special => {
                expected.pop();
            }
            Tok::Skip => {}
            Tok::Sub | Tok::Sup => *waiting += 1,
            Tok::Command(role) => {
                *waiting = waiting.saturating_sub(1) + role.arguments();
                if role == Role::Root
                    && let Some(close) = root_bracket(tokens, at)
                    && let Some(waiting) = expected.last_mut()
                {
                    *waiting -= 1;
                    after_bracket.push(close);
                }
            }
            _ => *waiting = waiting.saturating_sub(1),
        }
        if after_bracket.last() == Some(&at) {
            after_bracket.pop();
            if let Some(waiting) = expected.last_mut() {
                *waiting = 1;
            }
        }
    }
}

/// The index of the `]` that ends the optional argument of the root at `at`.
fn root_bracket(tokens: &[Token], at: usize) -> Option<usize> {
    if tokens.get(at + 1)?.kind != Tok::Open(Fence::Square) {
        return None;
    }
    // an index of a root is short
    (at + 2..tokens.len().min(at + 32)).find(|&i| tokens[i].kind == Tok::Close(Fence::Square))
}

fn closes(opening: Fence, closing: Fence) -> bool {
    let round = |fence| matches!(fence, Fence::Paren | Fence::Square);
    opening == closing || round(opening) && round(closing)
}

fn pair_ordinary(tokens: &mut [Token], problems: &mut Vec<Diagnostic>) {
    // `None` is the start of a strict pair, which ordinary brackets do not cross
    let mut open: Vec<Option<usize>> = Vec::new();
    let mut holders: Vec<usize> = Vec::new();
    for at in 0..tokens.len() {
        match tokens[at].kind {
            Tok::OpenBrace | Tok::Left(_) | Tok::Begin(_) => {
                open.push(None);
                holders.push(at);
            }
            Tok::CloseBrace | Tok::Right(_) | Tok::End(_) => {
                while let Some(Some(start)) = open.pop() {
                    unclosed(tokens, start, problems);
                    holders.pop();
                }
                holders.pop();
            }
            Tok::Open(_) => {
                open.push(Some(at));
                holders.push(at);
            }
            Tok::Close(fence) => {
                let found = open.iter().rev().take(LOOK_BACK).map_while(|start| *start).position(
                    |start| matches!(tokens[start].kind, Tok::Open(opening) if closes(opening, fence)),
                );
                let Some(above) = found else {
                    let text = "closing bracket without an opening one";
                    spoil(tokens, at, problems, text, "remove it, or add the opening bracket");
                    continue;
                };
                for _ in 0..above {
                    if let Some(Some(start)) = open.pop() {
                        unclosed(tokens, start, problems);
                        holders.pop();
                    }
                }
                if let Some(Some(start)) = open.pop() {
                    link(tokens, start, at);
                    holders.pop();
                }
            }
            Tok::Rel(rel) if !matches!(rel, Rel::Colon | Rel::To | Rel::MapsTo) => {
                if let Some(&holder) = holders.last() {
                    tokens[holder].relation = true;
                }
            }
            _ => {}
        }
    }
    for start in open.into_iter().flatten() {
        unclosed(tokens, start, problems);
    }
}

fn unclosed(tokens: &mut [Token], start: usize, problems: &mut Vec<Diagnostic>) {
    spoil(tokens, start, problems, "opening bracket without a closing one", "add the closing bracket");
}
