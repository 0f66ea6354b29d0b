//! The formulas and lists between the words of a request.

use super::super::foreign::as_list;
use super::super::given::each_equal;
use super::super::{Failure, defines, guarded, items_in, read_in};
use super::{Reader, lists};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, Link, Rel};

impl Reader<'_> {
    /// The formula of F(t) = t^2, where it is asked about: the polar form of F(t) = t^2.
    fn of_definition(&self, item: Expr) -> Expr {
        let Kind::Chain(left, links) = &item.kind else { return item };
        let letter = |expr: &Expr| matches!(expr.kind, Kind::Name(_));
        let coordinate =
            |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if matches!(name.as_str(), "x" | "y" | "z"));
        let head = match &left.kind {
            Kind::Apply(callee, groups) => {
                letter(callee)
                    && !coordinate(callee)
                    && !matches!(&callee.kind, Kind::Name(name) if defines(&self.session.env, name))
                    && matches!(groups.as_slice(), [one] if one.iter().all(letter))
            }
            _ => false,
        };
        match links.as_slice() {
            [Link { rel: Rel::Eq | Rel::Define, expr, .. }] if head => expr.clone(),
            _ => item,
        }
    }

    pub(super) fn one(&self, span: Span) -> Result<Expr, Box<Failure>> {
        let session = self.session;
        guarded(&session.limits, || read_in(&session.env, self.file, Some(span.shifted(self.start))))
            .map_err(|problem| Box::new(Failure { problem, file: self.file.clone() }))
    }

    pub(super) fn items(&self, span: Span) -> Result<Vec<Expr>, Box<Failure>> {
        let span = span.shifted(self.start);
        let session = self.session;
        // x: 0 1 3
        let text = self.file.slice(span);
        let spaced = |list: &&str| {
            let numbers = |c: char| c.is_ascii_digit() || matches!(c, ' ' | '/' | '.' | '-');
            list.trim().contains(' ') && list.chars().all(numbers) && !list.contains("- ")
        };
        if let Some((name, list)) =
            text.split_once(": ").or_else(|| text.split_once('=').filter(|(_, list)| spaced(list)))
            && name.trim_end().chars().count() == 1
            && name.starts_with(char::is_alphabetic)
        {
            let start = span.end - list.len();
            let items =
                guarded(&session.limits, || items_in(&session.env, self.file, Span::new(start, span.end)))
                    .map_err(|problem| Box::new(Failure { problem, file: self.file.clone() }))?;
            let letter = Expr {
                span: Span::new(span.start, span.start + name.trim_end().len()),
                ..Expr::name(name.trim_end())
            };
            let list = Expr::new(Kind::List(items), Span::new(start, span.end));
            return Ok(vec![Expr { span, ..Expr::relation(letter, Rel::Eq, list) }]);
        }
        // b200=1 b020=3
        let members = lists::members(text);
        if !members.is_empty() {
            let read = |(start, end): (usize, usize)| {
                let place = Span::new(span.start + start, span.start + end);
                guarded(&session.limits, || read_in(&session.env, self.file, Some(place)))
                    .map_err(|problem| self.fail(problem))
            };
            return members.into_iter().map(read).collect();
        }
        // 10,20 40,80 80,80
        let pairs = lists::pairs(text);
        if !pairs.is_empty() {
            let read = |(start, end): (usize, usize)| {
                let place = Span::new(span.start + start, span.start + end);
                if let Some((x, y)) = self.file.slice(place).split_once("->") {
                    let ends = [
                        Span::new(place.start, place.start + x.len()),
                        Span::new(place.end - y.len(), place.end),
                    ];
                    let read = |part: Span| {
                        guarded(&session.limits, || read_in(&session.env, self.file, Some(part)))
                            .map_err(|problem| self.fail(problem))
                    };
                    return Ok(Expr::new(Kind::Tuple(vec![read(ends[0])?, read(ends[1])?]), place));
                }
                let read = guarded(&session.limits, || items_in(&session.env, self.file, place));
                read.map(|items| Expr::new(Kind::Tuple(items), place)).map_err(|problem| self.fail(problem))
            };
            return pairs.into_iter().map(read).collect();
        }
        // (0,0) (1,2), 0 0 1 1; a name with its value may have a list: knots = 0, 1, 2
        let read = |span| guarded(&session.limits, || read_in(&session.env, self.file, Some(span)));
        let named = self.file.slice(span).contains(char::is_alphabetic);
        guarded(&session.limits, || items_in(&session.env, self.file, span))
            .or_else(|problem| if named { read(span).map(|one| vec![one]) } else { Err(problem) })
            .map(|items| {
                // u = v = 1/2
                let items = items.into_iter().flat_map(each_equal);
                items.map(|item| as_list(self.of_definition(item))).collect()
            })
            .map_err(|problem| Box::new(Failure { problem, file: self.file.clone() }))
    }
}
