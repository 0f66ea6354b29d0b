//! What a line asks for without one of its clauses, which nobody reads.

use crate::formula::source::{SourceFile, Span};
use crate::formula::{Expr, Kind};
use crate::language::functions::function_in_words;
use crate::language::lexicon::asking;
use crate::language::syntax;
use crate::session::{Session, defines};

/// How many places of a line are looked at.
const PLACES: usize = 6;

impl Session {
    /// The query for what a line asks for without the clause in which a word is not read, and that clause.
    pub(super) fn without_clause(
        &self,
        text: &str,
        word: &str,
        tried: &dyn Fn(Expr) -> Option<String>,
    ) -> Option<(String, String)> {
        let known = |word: &str| defines(&self.env, word);
        let ends = |c: char| c.is_whitespace() || matches!(c, '?' | '？' | '.' | ',' | ';' | ':');
        asking::clauses(text).into_iter().take(PLACES).find_map(|(end, start)| {
            let (before, after) = (text.get(..end)?, text.get(start..)?);
            if is_inside_a_formula(before, text.get(end..start)?, after) {
                return None;
            }
            [(before, after), (after, before)].into_iter().enumerate().find_map(|(number, (core, left))| {
                // What is left out before it may be what is asked.
                if number == 1 && !syntax::is_title(left, &known, &function_in_words) {
                    return None;
                }
                let denies = left.split(|c: char| !c.is_alphabetic()).any(asking::denies);
                let unread = left.contains(word) && !core.contains(word);
                let core = Some(core.trim_matches(ends)).filter(|_| !denies && unread)?;
                let file = SourceFile::new("<proposed>", core);
                let formula = self.spoken(&file, Span::new(0, core.len())).ok()??;
                // An object alone answers nothing.
                let object = |name: &str| matches!(name, "bezier" | "bspline" | "patch" | "triangle_patch" | "curve_of");
                if matches!(&formula.kind, Kind::Apply(callee, _) if matches!(&callee.kind, Kind::Name(name) if object(name))) {
                    return None;
                }
                let left = text.get(end..start)?.trim_matches(ends).to_owned() + " " + left.trim_matches(ends);
                Some((tried(formula)?, left.trim().to_owned()))
            })
        })
    }
}

/// Whether a joint between clauses is a sign or a letter of a formula: the minus of t^4 - t^2, the y of x^2 + x y.
fn is_inside_a_formula(before: &str, joint: &str, after: &str) -> bool {
    let formula = |word: Option<&str>| {
        word.is_some_and(|word| {
            word.chars().count() == 1 || word.contains(|c: char| c.is_ascii_digit() || "^+*/=()".contains(c))
        })
    };
    let joint = joint.trim();
    let (letter, sign) = (joint.len() == 1 && joint.starts_with(char::is_alphabetic), joint == "-");
    formula(before.split_whitespace().next_back())
        && (letter || sign && formula(after.split_whitespace().next()))
}
