//! The record of a function, and everything that is derived from it: the check of its arguments,
//! its form in messages, hints and help.

use crate::language::eval::{Arguments, Evaluated, Machine};
use crate::language::ops::polar::levelled;

use super::by_pieces::Merge;
use super::conversions::with_letters;
use super::gives::Gives;
use super::parameter::{DEGREE, Need, Parameter};
use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic, nearest};
use crate::language::ops::takes::word_of;
use crate::language::value::{PolarKind, Value};

type Result<T> = std::result::Result<T, Diagnostic>;

/// A function of the program.
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// What it can be told.
    pub parameters: &'static [Parameter],
    /// What all functions of its group can be told besides, always by name; its form does not show it.
    pub common: &'static [Parameter],
    /// What it does, in one line.
    pub summary: &'static str,
    /// What it gives.
    pub gives: Gives,
    /// An example that runs.
    pub example: &'static str,
    /// The chapter of the reference it belongs to.
    pub topic: &'static str,
    /// Whether it works coordinate by coordinate when its first argument is a list.
    pub each: bool,
    /// What it does when its first argument is a curve or piecewise polynomial, if that differs.
    pub on_curve: Option<Variant>,
    /// What it does when its first argument is a surface, if that differs.
    pub on_surface: Option<Variant>,
    /// What it does when its first argument is the polar form of a surface, if that differs.
    pub on_form: Option<Variant>,
    /// What it does when its first argument is made of equations, if it takes some.
    pub on_equations: Option<Variant>,
    /// How what it gives for the pieces of a spline is put together, if it takes splines by their pieces.
    pub(super) by_pieces: Option<Merge>,
    /// The functions that the word at its first place names, as in `derive(sum, F, G)`. If it names
    /// none of them, `call` says so.
    pub subjects: &'static [Builtin],
    /// The function of which this is a subject.
    pub subject_of: Option<&'static str>,
    /// The function itself. Its arguments are checked, and each is at its place.
    pub call: fn(&mut Machine, &Arguments) -> Evaluated,
}

/// What a function does with another kind of first argument.
#[derive(Clone, Copy)]
pub struct Variant {
    /// What it can be told then.
    pub parameters: &'static [Parameter],
    /// What it gives then.
    pub gives: Gives,
    /// How it works then.
    pub call: Way,
}

/// How a function works on other arguments.
#[derive(Clone, Copy)]
pub enum Way {
    /// By its arguments alone.
    Plain(fn(&Arguments) -> Evaluated),
    /// With remarks on them.
    Noting(fn(&mut Machine, &Arguments) -> Evaluated),
}

impl Variant {
    pub(super) const fn new(
        parameters: &'static [Parameter],
        gives: Gives,
        call: fn(&Arguments) -> Evaluated,
    ) -> Option<Self> {
        Some(Variant { parameters, gives, call: Way::Plain(call) })
    }

    pub(super) const fn noting(
        parameters: &'static [Parameter],
        gives: Gives,
        call: fn(&mut Machine, &Arguments) -> Evaluated,
    ) -> Option<Self> {
        Some(Variant { parameters, gives, call: Way::Noting(call) })
    }
}

impl std::fmt::Debug for Builtin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.signature())
    }
}

impl Builtin {
    /// A function of a chapter that works in one way only; the entries of the table fill in the rest.
    pub(super) const fn about(topic: &'static str) -> Self {
        Builtin {
            name: "",
            parameters: &[],
            common: &[],
            summary: "",
            example: "",
            topic,
            each: false,
            gives: Gives::Any,
            on_curve: None,
            on_surface: None,
            on_form: None,
            on_equations: None,
            by_pieces: None,
            subjects: &[],
            subject_of: None,
            call: |_, _| Err(Diagnostic::error(Code::Internal, "a function of the program is missing")),
        }
    }

    /// How it is called.
    pub fn signature(&self) -> String {
        self.form(self.parameters)
    }

    /// How it is called with other kinds of first arguments.
    pub fn other_forms(&self) -> impl Iterator<Item = (String, &Variant)> {
        self.variants().map(|variant| (self.form(variant.parameters), variant))
    }

    /// All about it, for a terminal: its forms, what it does, its parameters and an example.
    pub fn help(&self) -> Vec<String> {
        let mut lines = vec![self.signature(), format!("  {}", self.summary)];
        if self.gives != Gives::Any {
            lines.push(format!("  gives {}", self.gives.description()));
        }
        let list = |parameter: &Parameter| format!("    {}: {}", parameter.called(), parameter.explanation());
        lines.extend(self.parameters.iter().chain(self.common).map(list));
        for (form, variant) in self.other_forms() {
            lines.push(format!("  {form}"));
            lines.extend(variant.parameters.iter().map(list));
        }
        for subject in self.subjects {
            lines.push(format!("  {}: {}", subject.signature(), subject.summary));
            lines.extend(subject.parameters.iter().map(list));
        }
        lines.push(format!("  example: {}", self.example));
        lines
    }

    /// The parameters of one of its forms.
    pub(super) fn parameters_of(&self, form: &str) -> &'static [Parameter] {
        self.variants()
            .map(|own| own.parameters)
            .find(|own| self.form(own) == form)
            .unwrap_or(self.parameters)
    }

    /// How it is called with these parameters.
    pub(super) fn form_with(&self, parameters: &[Parameter]) -> String {
        self.form(parameters)
    }

    fn form(&self, parameters: &[Parameter]) -> String {
        let shown = parameters.iter().filter(|parameter| parameter.need != Need::Free);
        let shown: Vec<&str> =
            self.subject_of.map(|_| self.name).into_iter().chain(shown.map(|p| p.form)).collect();
        format!("{}({})", self.subject_of.unwrap_or(self.name), shown.join(", "))
    }

    fn variants(&self) -> impl Iterator<Item = &Variant> {
        [&self.on_curve, &self.on_surface, &self.on_form, &self.on_equations].into_iter().flatten()
    }

    fn variant(&self, first: &Value) -> Option<&Variant> {
        match first {
            Value::Polar(polar) if !matches!(polar.kind, PolarKind::Univariate(_)) => self.on_form.as_ref(),
            Value::Geometry(geometry) if geometry.is_surface() => self.on_surface.as_ref(),
            Value::Geometry(_) | Value::Piecewise(_) => self.on_curve.as_ref(),
            Value::Claim(_) => self.on_equations.as_ref(),
            _ => None,
        }
    }

    /// The lists of parameters of all its ways to be called.
    pub(super) fn parameter_lists(&self) -> impl Iterator<Item = &'static [Parameter]> {
        [self.parameters, self.common].into_iter().chain(self.variants().map(|variant| variant.parameters))
    }

    /// Whether a bare name as the argument at a place is a word that is not evaluated; `defined` says
    /// whether the name has a value.
    pub(crate) fn takes_word_at(&self, place: usize, word: &str, defined: bool) -> bool {
        if !self.subjects.is_empty() && place == 0 {
            return !defined || self.subjects.iter().any(|subject| subject.name == word);
        }
        let at =
            |list: &'static [Parameter]| list.iter().filter(|parameter| parameter.has_place()).nth(place);
        self.parameter_lists().filter_map(at).any(|parameter| parameter.kind.has_word(word))
    }

    /// Whether a bare name as the argument under a name is a word that is not evaluated. Words that
    /// mean nothing are for the check of the arguments to complain of.
    pub(crate) fn takes_word_under(&self, name: &str, word: &str, defined: bool) -> bool {
        let subjects = self.subjects;
        let all = || {
            let lists = subjects.iter().flat_map(Builtin::parameter_lists);
            self.parameter_lists().chain(lists).flatten()
        };
        let mut own = all().filter(|parameter| parameter.name == name).peekable();
        if own.peek().is_none() {
            return all().all(|parameter| parameter.need != Need::Free);
        }
        own.any(|parameter| parameter.kind.has_word(word) || (!defined && !parameter.kind.words().is_empty()))
    }

    /// Checks the arguments and calls the function, as it works on its first argument.
    pub(crate) fn run(&self, machine: &mut Machine, args: Arguments) -> Evaluated {
        let args = self.converted(machine, args)?;
        if let Some(value) = self.by_its_pieces(machine, &args) {
            return value;
        }
        let first = args.values().next();
        if !self.subjects.is_empty() {
            let word = first.and_then(word_of);
            return match self.subjects.iter().find(|subject| Some(subject.name) == word) {
                Some(subject) => subject.run(machine, args.after_first()),
                None => (self.call)(machine, &args),
            };
        }
        if let Some(Value::List(items)) = first.filter(|_| self.each) {
            let each = items.iter().map(|item| self.run_once(machine, args.with_first(item.clone())));
            return each.collect::<Result<_>>().map(|list| Value::List(items.with(levelled(list))));
        }
        self.run_once(machine, args)
    }

    fn run_once(&self, machine: &mut Machine, args: Arguments) -> Evaluated {
        let variant = args.values().next().and_then(|first| self.variant(first));
        let (parameters, gives) =
            variant.map_or((self.parameters, self.gives), |variant| (variant.parameters, variant.gives));
        let args = self.checked(parameters, args)?;
        let value = match variant.map(|variant| variant.call) {
            Some(Way::Plain(call)) => call(&args),
            Some(Way::Noting(call)) => call(machine, &args),
            None => (self.call)(machine, &args),
        }?;
        debug_assert!(gives.includes(&value), "{self:?} gives {}, not {}", value.kind(), gives.description());
        Ok(value)
    }

    /// The arguments, each at the place of its parameter, if there are as many as needed and all
    /// names are known.
    fn checked(&self, parameters: &[Parameter], args: Arguments) -> Result<Arguments> {
        let mut args = with_letters(parameters, args);
        let by_place: Vec<&Parameter> = parameters.iter().filter(|p| p.has_place()).collect();
        let by_name = || self.by_name(parameters);
        let placeable = names_places(parameters);
        for (name, value, span) in args.take_all_named() {
            // degree=2 where the form says n
            let is_degree = |p: &&&Parameter| p.name == DEGREE.name && p.doc == DEGREE.doc;
            let name = match name == "degree" && !by_name().any(|p| p.name == name) {
                true => by_place.iter().find(is_degree).map_or(name, |p| p.name.to_owned()),
                false => name,
            };
            let place = by_place.iter().position(|p| placeable && p.has_name() && p.name == name);
            if placeable && place.is_none() && !by_name().any(|p| p.name == name) {
                let places = by_place.iter().copied().filter(|p| p.has_name());
                let place = args.span_of_name(&name).unwrap_or(span);
                return Err(self.unknown(parameters, &name, places.chain(by_name())).at(place));
            }
            let taken = match place {
                Some(place) => args.given(place),
                None => args.named(&name),
            };
            if taken.is_some() {
                return Err(Diagnostic::error(Code::Arity, format!("the argument '{name}' is given twice"))
                    .at(span)
                    .hint(format!("the form is {}", self.form(parameters))));
            }
            match place {
                Some(place) => args.put(place, value, span),
                None => args.push_named(name, value, span),
            }
        }
        self.check_count(parameters, &by_place, &args)?;
        self.check_kinds(parameters, &by_place, &args)?;
        for (place, parameter) in by_place.iter().enumerate() {
            if args.given(place).is_none()
                && let Some(value) = parameter.default_value()
            {
                args.put(place, value, Span::default());
            }
        }
        for parameter in by_name() {
            if args.named(parameter.name).is_none()
                && let Some(value) = parameter.default_value()
            {
                args.push_named(parameter.name.to_owned(), value, Span::default());
            }
        }
        Ok(args)
    }

    /// What can only be given by its name.
    fn by_name<'a>(&self, parameters: &'a [Parameter]) -> impl Iterator<Item = &'a Parameter> + use<'a> {
        parameters.iter().chain(self.common).filter(|own| matches!(own.need, Need::Named(_)))
    }

    /// Each argument has to be what its parameter says.
    fn check_kinds(&self, parameters: &[Parameter], by_place: &[&Parameter], args: &Arguments) -> Result<()> {
        let placed = (0..args.len()).filter_map(|place| {
            let several = |last: &&&Parameter| matches!(last.need, Need::Many(..));
            let parameter = by_place.get(place).or(by_place.last().filter(several))?;
            args.given(place).map(|(value, span)| (*parameter, value, span))
        });
        let named = self.by_name(parameters);
        let named = named
            .filter_map(|parameter| args.named(parameter.name).map(|(value, span)| (parameter, value, span)));
        for (parameter, value, span) in placed.chain(named) {
            let kind = parameter.kind;
            if !kind.accepts(value) {
                let error = kind.refuses(value).at(span);
                let (name, words) = (parameter.name, kind.words());
                let usual = parameter.default().filter(|word| words.contains(word));
                return Err(match (usual, words.last()) {
                    _ if !error.hints.is_empty() || !parameter.has_name() => error,
                    (Some(word), _) => error.hint(format!("{name}={word} is the usual one")),
                    (None, Some(word)) => error.hint(format!("for example {name}={word}")),
                    (None, None) => error,
                });
            }
        }
        Ok(())
    }

    fn unknown<'a>(
        &self,
        parameters: &[Parameter],
        name: &str,
        known: impl Iterator<Item = &'a Parameter>,
    ) -> Diagnostic {
        let error = Diagnostic::error(Code::Arity, format!("there is no argument '{name}'"))
            .reason(format!("the form is {}", self.form(parameters)));
        match nearest(name, known.map(|parameter| parameter.name)) {
            Some(best) => error.hint(format!("did you mean '{best}'?")),
            None => error,
        }
    }

    fn check_count(&self, parameters: &[Parameter], by_place: &[&Parameter], args: &Arguments) -> Result<()> {
        let (mut least, mut most) = (0_usize, 0_usize);
        for parameter in by_place {
            let (few, many) = match parameter.need {
                Need::Required => (1, 1),
                Need::Many(few, many) => (few, many),
                _ => (0, 1),
            };
            least += few;
            most = most.saturating_add(many);
        }
        if !names_places(parameters) && args.has_names() {
            (least, most) = (1, 1);
        }
        let count = args.values().count();
        let missing = by_place.iter().take(least).enumerate().find(|(i, _)| args.given(*i).is_none());
        let message = match (least, most) {
            _ if (least..=most).contains(&count) => match missing {
                None => return Ok(()),
                Some((_, parameter)) => format!("the argument '{}' is missing", parameter.name),
            },
            (1, 1) => format!("1 argument needed, {count} given"),
            (least, most) if least == most => format!("{least} arguments needed, {count} given"),
            (least, usize::MAX) => format!("at least {least} arguments needed, {count} given"),
            (least, most) => format!("{least} to {most} arguments needed, {count} given"),
        };
        let error =
            Diagnostic::error(Code::Arity, message).hint(format!("the form is {}", self.form(parameters)));
        Err(match args.given(most) {
            Some((_, span)) => error.at(span),
            None => error,
        })
    }
}

/// Whether an argument that has a place may be given by its name: not where any name is a variable.
pub(super) fn names_places(parameters: &[Parameter]) -> bool {
    parameters.iter().all(|parameter| parameter.need != Need::Free)
}
