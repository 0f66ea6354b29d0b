//! Names of commands, groups in braces, arguments.

use crate::formula::source::Pieces;
use std::ops::Range;

/// How far a group may reach; and once one was found without end, which keeps the time linear.
pub(super) const MAX_GROUP: usize = 1 << 17;
pub(super) const MAX_GROUP_AFTER_FAILURE: usize = 1 << 11;

/// The name of the command at `at`, where a backslash stands: letters, or one other character.
pub(super) fn command_name(text: &str, at: usize) -> &str {
    let rest = text.piece(at + 1..);
    let letters = rest.bytes().take_while(|byte| byte.is_ascii_alphabetic() || *byte == b'@').count();
    match letters {
        0 => rest.piece(..rest.chars().next().map_or(0, char::len_utf8)),
        _ => rest.piece(..letters),
    }
}

/// How an argument is written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Argument {
    Mandatory,
    /// In brackets, with what it is if it is missing.
    Optional(String),
    /// A star, which stands for nothing.
    Star,
    /// Up to these signs.
    Until(String),
    /// These signs, which stand for nothing.
    Sign(String),
}

/// An argument of a call.
pub(super) enum Given {
    At(Range<usize>),
    Default(String),
}

/// The arguments of a call and the byte after it.
pub(super) fn call(
    text: &str,
    after: usize,
    arguments: &[Argument],
    reach: usize,
) -> Option<(Vec<Given>, usize)> {
    let mut reader = Reader { text, at: after, reach };
    let mut given = Vec::new();
    for argument in arguments {
        match argument {
            Argument::Mandatory => given.push(Given::At(reader.argument()?)),
            Argument::Optional(default) => {
                let found = reader.bracket();
                given.push(found.map_or_else(|| Given::Default(default.clone()), Given::At));
            }
            Argument::Star => {
                reader.star();
                given.push(Given::Default(String::new()));
            }
            Argument::Until(sign) => given.push(Given::At(reader.until(sign)?)),
            Argument::Sign(sign) => {
                reader.spaces();
                reader.sign(sign).then_some(())?;
            }
        }
    }
    Some((given, reader.at))
}

/// The arguments `m`, `o`, `O{…}`, `s` of \NewDocumentCommand.
pub(super) fn specification(text: &str) -> Option<Vec<Argument>> {
    let mut reader = Reader { text, at: 0, reach: MAX_GROUP };
    let mut arguments = Vec::new();
    loop {
        reader.spaces();
        let Some(kind) = text.piece(reader.at..).chars().next() else { return Some(arguments) };
        reader.at += kind.len_utf8();
        arguments.push(match kind {
            'm' => Argument::Mandatory,
            'o' => Argument::Optional(String::new()),
            'O' => Argument::Optional(reader.group()?),
            's' => Argument::Star,
            _ => return None,
        });
    }
}

/// Walks over names, groups and arguments.
pub(super) struct Reader<'a> {
    pub(super) text: &'a str,
    pub(super) at: usize,
    /// How far a group may reach.
    pub(super) reach: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        self.text.piece(self.at..)
    }

    pub(super) fn spaces(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    pub(super) fn sign(&mut self, sign: &str) -> bool {
        let found = self.rest().starts_with(sign);
        self.at += if found { sign.len() } else { 0 };
        found
    }

    pub(super) fn star(&mut self) {
        self.spaces();
        self.sign("*");
    }

    /// The name of a command, perhaps in braces.
    pub(super) fn name(&mut self) -> Option<String> {
        self.spaces();
        let braced = self.sign("{");
        self.spaces();
        if !self.rest().starts_with('\\') {
            return None;
        }
        let name = command_name(self.text, self.at).to_owned();
        self.at += 1 + name.len();
        if braced {
            self.spaces();
            self.sign("}").then_some(())?;
        }
        (!name.is_empty()).then_some(name)
    }

    /// What stands in braces.
    pub(super) fn group(&mut self) -> Option<String> {
        self.spaces();
        self.rest().starts_with('{').then_some(())?;
        let range = self.enclosed('}')?;
        Some(self.text.piece(range).to_owned())
    }

    /// What stands in brackets, if they are the next thing.
    pub(super) fn bracket(&mut self) -> Option<Range<usize>> {
        let start = self.at;
        self.spaces();
        if !self.rest().starts_with('[') {
            self.at = start;
            return None;
        }
        let found = self.enclosed(']');
        if found.is_none() {
            self.at = start;
        }
        found
    }

    /// What stands from the sign here to its partner, outside of inner braces.
    fn enclosed(&mut self, close: char) -> Option<Range<usize>> {
        let start = self.at + 1;
        let end = start + find_outside(self.text.piece(start..), &close.to_string(), self.reach)?;
        self.at = end + 1;
        Some(start..end)
    }

    /// Up to the signs, which are passed.
    pub(super) fn until(&mut self, sign: &str) -> Option<Range<usize>> {
        let start = self.at;
        let end = start + find_outside(self.text.piece(start..), sign, self.reach)?;
        self.at = end + sign.len();
        Some(start..end)
    }

    /// A group without its braces, or a token.
    pub(super) fn argument(&mut self) -> Option<Range<usize>> {
        self.spaces();
        if self.rest().starts_with('{') { self.enclosed('}') } else { self.token() }
    }

    /// A command or a character.
    pub(super) fn token(&mut self) -> Option<Range<usize>> {
        let start = self.at;
        let first = self.rest().chars().next().filter(|&c| c != '}')?;
        self.at += match first {
            '\\' => 1 + command_name(self.text, start).len(),
            _ => first.len_utf8(),
        };
        Some(start..self.at)
    }

    /// The parameters of \def: `#1#2`, or with signs between them.
    pub(super) fn pattern(&mut self) -> Option<Vec<Argument>> {
        let end = self.at + self.rest().bytes().take(200).position(|byte| byte == b'{')?;
        let text = self.text.piece(self.at..end);
        self.at = end;
        let mut parts = text.split('#');
        let mut arguments = Vec::new();
        let first = parts.next().unwrap_or("").trim();
        if !first.is_empty() {
            arguments.push(Argument::Sign(first.to_owned()));
        }
        for (i, part) in parts.enumerate() {
            let sign = part.strip_prefix(char::from_digit(i as u32 + 1, 10)?)?.trim();
            let argument =
                if sign.is_empty() { Argument::Mandatory } else { Argument::Until(sign.to_owned()) };
            arguments.push(argument);
        }
        Some(arguments)
    }
}

/// Where the sign stands outside of braces.
fn find_outside(text: &str, sign: &str, reach: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut at = 0;
    while at < text.len().min(reach) {
        let byte = text.as_bytes()[at];
        if depth == 0 && text.is_char_boundary(at) && text.piece(at..).starts_with(sign) {
            return Some(at);
        }
        match byte {
            b'\\' => at += 1,
            b'{' => depth += 1,
            b'}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        at += 1;
    }
    None
}
