//! Half-open intervals where conditions stand: `t in [0, 1)`, `on (0, 1]`. Elsewhere such brackets are a slip.

use crate::formula::source::{Pieces, SourceFile, Span};
use crate::formula::{Expr, Rel, applied};
use crate::session::Session;

/// Words and signs before an interval to which something belongs.
const IN: &[&str] = &[" in", "∈", " aus", " dans"];

impl Session {
    /// An interval, or that a name runs through one; `None` if the brackets are no interval.
    pub(in crate::session) fn half_open(&self, file: &SourceFile, span: Span) -> Option<Expr> {
        let text = file.slice(span);
        let inner = text.trim_end();
        let closed = inner.strip_suffix([')', ']', '['])?;
        let open = closed.rfind(['[', '(', ']'].as_slice())?;
        let (before, body) = (inner.piece(..open), inner.piece(open + 1..inner.len() - 1));
        let comma = body.find([',', ';'])?;
        let part =
            |from: usize, to: usize| self.read(file, Span::new(span.start + from, span.start + to)).ok();
        let start = open + 1;
        let bounds = vec![part(start, start + comma)?, part(start + comma + 1, start + body.len())?];
        let name = match (inner.piece(open..).chars().next()?, inner.chars().next_back()?) {
            ('[', ')' | '[') => "rightopen",
            ('(' | ']', ']') => "leftopen",
            _ => return None,
        };
        let interval = applied(Expr { span, ..Expr::name(name) }, bounds, span);
        if before.trim().is_empty() {
            return Some(interval);
        }
        let name = IN.iter().find_map(|sign| before.trim_end().strip_suffix(sign.trim_end()))?;
        let left = part(0, name.len())?;
        Some(Expr { span, ..Expr::relation(left, Rel::In, interval) })
    }
}
