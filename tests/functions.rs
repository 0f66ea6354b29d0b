//! The function table is what happens: every parameter it tells is accepted at its place and by its
//! name, every other one is refused with the form of the function, and a value of another kind is an
//! error at the argument.

use polarform::diagnostic::{Code, Diagnostic};
use polarform::expr::{Expr, Kind};
use polarform::functions::{BUILTINS, Builtin, Need, Parameter, Takes};
use polarform::session::Session;
use polarform::syntax::parse;
use polarform::value::Value;

/// The example of a function as a call: what stands before it and after it, and its arguments.
struct Call {
    before: String,
    arguments: Vec<String>,
    after: String,
}

impl Call {
    /// None for what has a notation of its own, as `compose(F, G)` is F ∘ G.
    fn of(function: &Builtin) -> Option<Call> {
        let text = function.example;
        let tree = parse(text).unwrap_or_else(|error| panic!("{text}: {}", error.message));
        let head = function.subject_of.unwrap_or(function.name);
        let (whole, groups) = find(&tree, head)?;
        let own: Vec<&Expr> =
            groups.iter().flatten().skip(usize::from(function.subject_of.is_some())).collect();
        let start = own.first().map_or(whole.span.end - 1, |first| first.span.start);
        Some(Call {
            before: text[..start].to_owned(),
            arguments: own.iter().map(|expr| text[expr.span.range()].to_owned()).collect(),
            after: text[whole.span.end - 1..].to_owned(),
        })
    }

    /// The text with these arguments, and where the one at `at` stands.
    fn with(&self, arguments: &[String], at: usize) -> (String, usize) {
        let mut text = self.before.clone();
        let mut place = 0;
        for (i, argument) in arguments.iter().enumerate() {
            if i > 0 {
                text.push_str(", ");
            }
            if i == at {
                place = text.len();
            }
            text.push_str(argument);
        }
        text.push_str(&self.after);
        (text, place)
    }

    fn with_more(&self, more: String) -> (String, usize) {
        let mut arguments = self.arguments.clone();
        arguments.push(more);
        self.with(&arguments, arguments.len() - 1)
    }
}

fn find<'a>(expr: &'a Expr, name: &str) -> Option<(&'a Expr, &'a [Vec<Expr>])> {
    if let Kind::Apply(callee, groups) = &expr.kind
        && matches!(&callee.kind, Kind::Name(other) if other == name)
    {
        return Some((expr, groups));
    }
    let mut found = None;
    expr.for_each_child(&mut |child| found = found.or_else(|| find(child, name)));
    found
}

/// Functions and what they can derive, each with its example.
fn all() -> impl Iterator<Item = (&'static Builtin, Call)> {
    let all = BUILTINS.iter().flat_map(|function| std::iter::once(*function).chain(function.subjects));
    all.filter_map(|function| Some((function, Call::of(function)?)))
}

/// Those whose arguments are all their own.
fn plain() -> impl Iterator<Item = (&'static Builtin, Call)> {
    all().filter(|(function, _)| function.subjects.is_empty() && !is_free(function))
}

#[test]
fn few_functions_have_a_notation_of_their_own() {
    let skipped: Vec<&str> =
        BUILTINS.iter().filter(|function| Call::of(function).is_none()).map(|f| f.name).collect();
    assert_eq!(skipped, ["compose", "transpose", "binomial"]);
}

fn value(text: &str) -> Result<Value, Diagnostic> {
    Session::default().run(text).map(|answer| answer.outcome.value).map_err(|failure| failure.problem)
}

fn has_place(parameter: &Parameter) -> bool {
    !matches!(parameter.need, Need::Named(_) | Need::Free)
}

fn has_name(parameter: &Parameter) -> bool {
    !matches!(parameter.need, Need::Many(..) | Need::Free)
}

fn named(function: &Builtin) -> Vec<&'static Parameter> {
    let own = function.parameters.iter().chain(function.common);
    own.filter(|parameter| matches!(parameter.need, Need::Named(_))).collect()
}

/// What any names may be given to.
fn is_free(function: &Builtin) -> bool {
    function.parameters.iter().any(|parameter| parameter.need == Need::Free)
}

/// The parameters of the arguments in the example of a function that have a place.
fn places(function: &Builtin, call: &Call) -> Vec<(usize, &'static Parameter)> {
    let by_place: Vec<&'static Parameter> = function.parameters.iter().filter(|p| has_place(p)).collect();
    let positional = call.arguments.iter().enumerate().filter(|(_, text)| !is_named(text, function));
    positional
        .filter_map(|(i, _)| by_place.get(i).or(by_place.last()).map(|parameter| (i, *parameter)))
        .collect()
}

fn is_named(text: &str, function: &Builtin) -> bool {
    let own = || function.parameters.iter().chain(function.common);
    text.split_once('=').is_some_and(|(name, _)| own().any(|parameter| parameter.name == name.trim()))
}

#[test]
fn examples_of_what_can_be_derived_run() {
    for subject in BUILTINS.iter().flat_map(|function| function.subjects) {
        assert!(matches!(value(subject.example), Ok(Value::Derivation(_))), "{}", subject.example);
    }
}

#[test]
fn what_has_a_place_can_be_given_by_its_name() {
    let mut count = 0;
    for (function, call) in plain() {
        for (i, parameter) in places(function, &call) {
            // Arguments after a named one would move forward.
            if !has_name(parameter) || i + 1 < places(function, &call).len() {
                continue;
            }
            let mut arguments = call.arguments.clone();
            arguments[i] = format!("{}={}", parameter.name, arguments[i]);
            let text = call.with(&arguments, i).0;
            match value(&text) {
                Ok(found) => assert_eq!(Ok(found), value(function.example), "{text}"),
                Err(error) => panic!("{text}: {} {:?}", error.message, error.hints),
            }
            count += 1;
        }
        let all: Vec<String> = (places(function, &call).iter())
            .map(|(i, parameter)| format!("{}={}", parameter.name, call.arguments[*i]))
            .chain(call.arguments.iter().filter(|text| is_named(text, function)).cloned())
            .rev()
            .collect();
        if places(function, &call).iter().all(|(_, parameter)| has_name(parameter)) {
            let text = call.with(&all, 0).0;
            match value(&text) {
                Ok(found) => assert_eq!(Ok(found), value(function.example), "{text}"),
                Err(error) => panic!("{text}: {} {:?}", error.message, error.hints),
            }
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn a_name_is_given_once() {
    for (function, call) in plain() {
        for (i, parameter) in places(function, &call).into_iter().filter(|(_, p)| has_name(p)) {
            let (text, _) = call.with_more(format!("{}={}", parameter.name, call.arguments[i]));
            let error = value(&text).expect_err(&text);
            assert_eq!(error.code, Code::Arity, "{text}");
            assert_eq!(error.message, format!("the argument '{}' is given twice", parameter.name), "{text}");
        }
    }
}

#[test]
fn all_names_of_the_table_are_accepted() {
    for (function, call) in all() {
        for parameter in named(function) {
            let sample = match parameter.kind {
                Takes::Word(words) => words[0].to_owned(),
                Takes::Text => "\"words\"".to_owned(),
                _ => "1".to_owned(),
            };
            let (text, _) = call.with_more(format!("{}={sample}", parameter.name));
            if let Err(error) = value(&text) {
                assert!(!error.message.starts_with("there is no argument"), "{text}: {}", error.message);
            }
        }
    }
}

#[test]
fn other_names_are_refused_with_the_form() {
    let mut guessed = 0;
    for (function, call) in plain() {
        let (text, place) = call.with_more("unheard_of=1".to_owned());
        let error = value(&text).expect_err(&text);
        assert_eq!(
            (error.code, error.message.as_str()),
            (Code::Arity, "there is no argument 'unheard_of'"),
            "{text}"
        );
        assert_eq!(error.span.map(|span| span.start), Some(place), "{text}");
        let variants = function.other_forms().map(|(form, _)| form).chain([function.signature()]);
        let known: Vec<String> = variants.map(|form| format!("the form is {form}")).collect();
        assert!(error.reason.is_some_and(|reason| known.contains(&reason)), "{text}");
        // A slip of the pen in a name.
        for parameter in named(function).into_iter().filter(|parameter| parameter.name.len() >= 4) {
            let (text, _) = call.with_more(format!("{}s=1", parameter.name));
            let error = value(&text).expect_err(&text);
            let hint = format!("did you mean '{}'?", parameter.name);
            if error.message == format!("there is no argument '{}s'", parameter.name) {
                assert!(error.hints.contains(&hint), "{text}: {:?}", error.hints);
                guessed += 1;
            }
        }
    }
    assert!(guessed > 40, "{guessed}");
}

#[test]
fn a_wrong_number_of_arguments_shows_the_form() {
    for (function, call) in all().filter(|(function, _)| function.subjects.is_empty()) {
        let count = |least: bool| -> usize {
            let one = |parameter: &Parameter| match parameter.need {
                Need::Required => 1,
                Need::Optional(_) => usize::from(!least),
                Need::Many(few, many) => {
                    if least {
                        few
                    } else {
                        many
                    }
                }
                Need::Named(_) | Need::Free => 0,
            };
            function.parameters.iter().map(one).fold(0, usize::saturating_add)
        };
        let head = function
            .subject_of
            .map_or(function.name.to_owned(), |parent| format!("{parent}({}", function.name));
        let mut wrong =
            vec![if function.subject_of.is_some() { format!("{head})") } else { format!("{head}()") }];
        if count(true) == 0 {
            wrong.clear();
        }
        if count(false) < 20 {
            let first = call.arguments.first().cloned().unwrap_or_default();
            // Lists alone may be points one by one.
            let mut many = vec![first; count(false) + 10];
            many.push("0".to_owned());
            wrong.push(call.with(&many, 0).0);
        }
        for text in wrong {
            let error = value(&text).expect_err(&text);
            assert_eq!(error.code, Code::Arity, "{text}: {}", error.message);
            let forms = function.other_forms().map(|(form, _)| form).chain([function.signature()]);
            let known: Vec<String> = forms.map(|form| format!("the form is {form}")).collect();
            assert!(error.hints.iter().any(|hint| known.contains(hint)), "{text}: {:?}", error.hints);
        }
    }
}

/// What the examples make no use of: the letter where a parameter is given, the interval of a curve
/// without knots, the polygon of a surface without points.
const UNUSED: &[(&str, &str)] = &[
    ("neville", "variable"),
    ("aitken", "variable"),
    ("figure_pyramid", "span"),
    ("figure_triangle", "polygon"),
];

/// A value that is nothing of the kind.
fn another_kind(kind: Takes) -> Option<&'static str> {
    match kind {
        Takes::Any => None,
        Takes::Text => Some("7"),
        _ => Some("\"nothing of the kind\""),
    }
}

#[test]
fn another_kind_is_an_error_at_the_argument() {
    let (mut count, mut wrong) = (0, Vec::new());
    for (function, call) in plain() {
        let mut cases = Vec::new();
        for (i, parameter) in places(function, &call) {
            let Some(other) = another_kind(parameter.kind) else { continue };
            let mut arguments = call.arguments.clone();
            arguments[i] = other.to_owned();
            cases.push(call.with(&arguments, i));
        }
        let given = |parameter: &Parameter| {
            UNUSED.contains(&(function.name, parameter.name))
                || places(function, &call).iter().any(|(_, other)| other.name == parameter.name)
                || call.arguments.iter().any(|text| text.split('=').next() == Some(parameter.name))
        };
        for parameter in
            function.parameters.iter().chain(function.common).filter(|p| has_name(p) && !given(p))
        {
            let Some(other) = another_kind(parameter.kind) else { continue };
            let (text, place) = call.with_more(format!("{}={other}", parameter.name));
            cases.push((text, place + parameter.name.len() + 1));
        }
        for (text, place) in cases {
            count += 1;
            match value(&text) {
                Ok(_) => wrong.push(format!("{text} has a value")),
                Err(error) => {
                    let start = error.span.map(|span| span.start);
                    if !matches!(error.code, Code::Type | Code::Domain) || start != Some(place) {
                        wrong.push(format!("{text}: {:?} at {start:?}: {}", error.code, error.message));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 200, "{count}");
}

/// Values of all kinds, for any place of any function.
const SAMPLES: &[&str] = &[
    "0",
    "2",
    "-1/2",
    "t^2 - 2",
    "u v + 1",
    "1/(t + 1)",
    "a",
    "hat(1)",
    "root_of(t^2 - 2, 1, 2)",
    "polar(t^3)",
    "polar_tensor(u v, u, v)",
    "polar_total(u v, [u, v])",
    "(x -> x^2)",
    "[]",
    "[0, 1, 3]",
    "[a, b, c]",
    "[t, t^2]",
    "[[0, 0], [1, 2], [2, 0]]",
    "[[0, 0, 0], [1, 2, 1], [2, 0, 1]]",
    "[1, 2; 3, 4]",
    "transpose([1, 2, 3])",
    "bezier([0, 1, 4])",
    "bezier([[0, 0], [1, 2], [2, 0]], weights=[1, 2, 1])",
    "bspline(2, [0, 0, 0, 1, 2, 2, 2], [[0, 0], [1, 2], [3, 2], [4, 0]])",
    "bspline(1, [0, 0, 1, 1], [1, 3], weights=[1, 2])",
    "bspline_basis(1, [0, 1, 2], 0)",
    "cubic_spline([0, 1, 2], [[0, 0], [1, 1], [2, 0]])",
    "patch([[0, 1], [2, 5]])",
    "sphere_octant([0, 0, 0], 1)",
    "triangle_patch([[0, 0, 0], [1, 0, 1], [0, 1, 2]])",
    "sphere_octant([0, 0, 0], 1, form=triangle)",
    "spline_surface(1, [0, 0, 1, 1], 1, [0, 0, 1, 1], [[0, 1], [2, 5]])",
    "[bezier([0, 1]), bezier([1, 3], 1, 2)]",
    "divided_differences([0, 1], [1, 3])",
    "(t = 2)",
    "\"words\"",
];

/// What comes of any value in any place is what the table says, or an error that is no defect.
#[test]
fn any_value_in_any_place_is_taken_or_refused() {
    let mut defects = Vec::new();
    let mut taken = 0;
    for (function, call) in all() {
        for i in 0..call.arguments.len() {
            for sample in SAMPLES {
                let mut arguments = call.arguments.clone();
                arguments[i] = match arguments[i].split_once('=') {
                    Some((name, _)) if is_named(&arguments[i], function) => format!("{name}={sample}"),
                    _ => (*sample).to_owned(),
                };
                let text = call.with(&arguments, i).0;
                match value(&text) {
                    Err(error) if error.code == Code::Internal => defects.push(text),
                    Err(_) => {}
                    Ok(_) => taken += 1,
                }
            }
        }
    }
    assert!(defects.is_empty(), "{}", defects.join("\n"));
    assert!(taken > 2000, "{taken}");
}

#[test]
fn places_and_names_mix() {
    let same = |left: &str, right: &str| assert_eq!(value(left), value(right), "{left}");
    same("elevate(polar(t^2), k=2)", "elevate(polar(t^2), 2)");
    same("bezier([0, 1, 4], b=3)", "bezier([0, 1, 4], 0, 3)");
    same("integrate(t^2, a=0, b=1)", "integrate(t^2, t, 0, 1)");
    same("diff(bezier([0, 1, 4]), k=2)", "derivative(bezier([0, 1, 4]), 2)");
    same("diff(bezier([0, 1, 4]), t, 2)", "derivative(bezier([0, 1, 4]), 2)");
    same("uniform_knots(2, 4, h=2)", "uniform_knots(2, 4, 0, 2)");
    same("convert(bezier([0, 1, 4]), to=power)", "convert(bezier([0, 1, 4]), power)");
    same("polar(degree=3, F=t^2)", "polar(t^2, degree=3)");
    same("polar(F=[t, t^2])", "polar([t, t^2])");
    same("subs(t^2 + c_0, t=3)", "9 + c_0");
    same("subdivide(patch([[0, 1], [2, 5]]), v=1/2, u=1/3)", "subdivide(patch([[0, 1], [2, 5]]), 1/3, 1/2)");
    same("elevate(patch([[0, 1], [2, 5]]), l=2)", "elevate(patch([[0, 1], [2, 5]]), 1, 2)");
    let error = value("part(bezier([0, 1, 4]), s=1, t=2)").expect_err("t is unknown");
    assert_eq!(error.message, "there is no argument 't'");
    let error = value("over(bezier([0, 1, 4]), b=1)").expect_err("a is missing");
    assert_eq!(error.message, "3 arguments needed, 2 given");
    let error = value("figure_triangle(labels=none, corners=[r, s, t])").expect_err("a degree is missing");
    assert_eq!(error.message, "the argument 'points' is missing");
}
