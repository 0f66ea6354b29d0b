//! One type for everything that can go wrong: what, where, why, and a hint.

mod code;
mod render;
mod suggest;

pub use code::Code;
pub use render::{harmless, render, render_json};
#[cfg(feature = "notes")]
pub(crate) use render::{shortened, with_column};
pub use suggest::nearest;

use crate::formula::source::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The query has no answer.
    Error,
    /// There is an answer, but something is suspicious.
    Warning,
    /// Worth knowing.
    Note,
}

/// A further place with a remark.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The remark.
    pub message: String,
}

/// A problem, with its place in the source it was found in.
///
/// ```
/// use polarform::diagnostic::{Code, Diagnostic, render};
/// use polarform::source::{SourceFile, Span};
/// let file = SourceFile::new("<query>", "t + ");
/// let problem = Diagnostic::error(Code::UnexpectedEnd, "the formula ends after '+'")
///     .at(Span::new(2, 3))
///     .hint("write a term after '+', or remove it");
/// let text = render(&problem, &file, false);
/// assert!(text.contains("<query>:1:3"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// The stable code; `polarform explain CODE` tells more.
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in a short sentence without a full stop.
    pub message: String,
    /// The place, once it is known.
    pub span: Option<Span>,
    /// Why, shown under the caret.
    pub reason: Option<String>,
    /// Further places.
    pub labels: Vec<Label>,
    /// What to do about it.
    pub hints: Vec<String>,
}

impl Diagnostic {
    /// An error without a place.
    pub fn error(code: Code, message: impl Into<String>) -> Self {
        Diagnostic {
            code,
            severity: Severity::Error,
            message: message.into(),
            span: None,
            reason: None,
            labels: Vec::new(),
            hints: Vec::new(),
        }
    }

    /// A warning without a place.
    pub fn warning(code: Code, message: impl Into<String>) -> Self {
        Diagnostic { severity: Severity::Warning, ..Diagnostic::error(code, message) }
    }

    /// A note without a place.
    pub fn note(code: Code, message: impl Into<String>) -> Self {
        Diagnostic { severity: Severity::Note, ..Diagnostic::error(code, message) }
    }

    /// Gives the problem a place unless it already has one (the innermost place wins).
    pub fn at(mut self, span: Span) -> Self {
        self.span.get_or_insert(span);
        self
    }

    /// The same problem of a text that starts at `start`.
    pub(crate) fn shifted(mut self, start: usize) -> Self {
        self.span = self.span.map(|place| place.shifted(start));
        self.labels.iter_mut().for_each(|label| label.span = label.span.shifted(start));
        self
    }

    /// Adds the text shown under the caret.
    pub fn reason(mut self, reason: impl Into<String>) -> Self {
        self.reason = Some(reason.into());
        self
    }

    /// Adds a remark at another place.
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: message.into() });
        self
    }

    /// Adds advice.
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }
}

/// Gives a span to the error of a span-free computation.
pub trait At<T> {
    /// The result, its error placed at `span` unless it has a place.
    fn at(self, span: Span) -> Result<T, Diagnostic>;
}

impl<T, E: Into<Diagnostic>> At<T> for Result<T, E> {
    fn at(self, span: Span) -> Result<T, Diagnostic> {
        self.map_err(|error| error.into().at(span))
    }
}

/// What is said of a request and found no place in it: a value, a word, a list.
pub(crate) const NO_PLACE: &str = "nothing here takes this";

/// The same of a degree.
pub(crate) const NO_DEGREE: &str = "this degree does not fit";

/// Whether something said found no place; any other refusal of a request is meant.
pub(crate) fn is_left_over(problem: &Diagnostic) -> bool {
    problem.code == Code::Usage && [NO_PLACE, NO_DEGREE].contains(&problem.message.as_str())
}

/// Whether a problem may be that of words which were read as a formula.
pub(crate) fn may_be_of_words(problem: &Diagnostic) -> bool {
    matches!(
        problem.code,
        Code::UnknownName
            | Code::UnknownFunction
            | Code::UnexpectedCharacter
            | Code::UnexpectedToken
            | Code::UnexpectedEnd
            | Code::BadNumber
    )
}
