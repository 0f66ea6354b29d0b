use super::{BUILTINS, Builtin, Need, Parameter, builtin};
use crate::language::lexicon::phrases::names_of_functions;
use crate::language::value::Language;
use crate::math::blossom::Method;
use std::collections::{BTreeMap, BTreeSet};

/// Every list of parameters, with the function it belongs to.
fn lists(each: &mut dyn FnMut(&Builtin, &[Parameter])) {
    for builtin in BUILTINS {
        for function in std::iter::once(*builtin).chain(builtin.subjects) {
            each(function, function.parameters);
            each(function, function.common);
            for (_, variant) in function.other_forms() {
                each(function, variant.parameters);
            }
        }
    }
}

fn is_line(text: &str) -> bool {
    let sentence = text.ends_with('.') && !text.ends_with("...");
    !sentence && !text.is_empty() && text.len() < 90
}

#[test]
fn the_table_is_complete() {
    for (i, function) in BUILTINS.iter().enumerate() {
        let name = function.name;
        assert!(function.signature().starts_with(&format!("{name}(")), "{name}");
        assert!(function.example.contains(name), "{name}");
        assert!(is_line(function.summary), "{name}");
        assert!(BUILTINS[..i].iter().all(|other| other.name != name), "{name}");
        assert_eq!(builtin(name).map(|found| found.name), Some(name));
        for subject in function.subjects {
            assert!(subject.signature().starts_with(&format!("{name}({}", subject.name)), "{subject:?}");
            assert!(is_line(subject.summary) && subject.example.contains(subject.name), "{subject:?}");
        }
    }
}

#[test]
fn parameters_are_complete() {
    lists(&mut |function, list| {
        for (i, parameter) in list.iter().enumerate() {
            let name = parameter.name;
            assert!(is_line(parameter.doc) && parameter.default() != Some(""), "{function:?}: {name}");
            assert!(list[..i].iter().all(|other| other.name != name), "{function:?}: {name} is there twice");
            if parameter.has_name() {
                let letters = |c: char| c.is_alphanumeric() || c == '_';
                assert!(name.chars().all(letters), "{function:?}: {name} is not a name");
            }
        }
    });
}

#[test]
fn what_has_to_be_given_comes_first() {
    let rank = |need: Need| match need {
        Need::Required => 0,
        Need::Optional(_) => 1,
        Need::Many(..) => 2,
        Need::Named(_) | Need::Free => 3,
    };
    lists(&mut |function, list| {
        assert!(list.is_sorted_by_key(|parameter| rank(parameter.need)), "{function:?}");
    });
}

#[test]
fn forms_show_all_but_what_a_group_shares() {
    let form = |name: &str| builtin(name).map(Builtin::signature).unwrap_or_default();
    assert_eq!(form("polar"), "polar(F, degree=n, variable=t)");
    assert_eq!(form("bezier"), "bezier([b_0, ..., b_n], a, b, weights=[w_0, ..., w_n], homogeneous=1)");
    assert_eq!(form("subs"), "subs(F, t, value)");
    assert_eq!(form("max"), "max(a, b, ...)");
    assert_eq!(form("derive"), "derive(what, ..., lang=en)");
    let derive = builtin("derive").expect("a function");
    assert_eq!(derive.subjects[1].signature(), "derive(sum, F, G)");
    let elevate = builtin("elevate").expect("a function");
    let others: Vec<String> = elevate.other_forms().map(|(form, _)| form).collect();
    assert_eq!(others, ["elevate(c, k)", "elevate(s, k, l)"]);
}

#[test]
fn words_are_those_that_are_read() {
    let derive = builtin("derive").expect("a function");
    let words = |name: &str| {
        let all = derive.subjects.iter().flat_map(|subject| subject.parameters.iter().chain(subject.common));
        all.filter(|parameter| parameter.name == name).map(|p| p.kind.words()).next().unwrap_or_default()
    };
    assert_eq!(words("lang"), Language::ALL.map(Language::code));
    assert_eq!(words("method"), Method::ALL.map(Method::name));
    // A word of the table is one even if it is defined; other names are words if they are not.
    let continuity = builtin("continuity").expect("a function");
    assert!(continuity.takes_word_under("across", "u", true));
    assert!(!continuity.takes_word_under("across", "t", true));
    assert!(continuity.takes_word_under("across", "t", false));
    assert!(!continuity.takes_word_under("at", "u", false));
    assert!(continuity.takes_word_under("unheard_of", "u", false));
    assert!(derive.takes_word_at(0, "sum", true) && derive.takes_word_at(0, "sun", false));
    assert!(!derive.takes_word_at(1, "sum", true));
    let spline = builtin("cubic_spline").expect("a function");
    assert!(spline.takes_word_at(2, "natural", true) && !spline.takes_word_at(2, "naturl", false));
}

#[test]
fn every_function_has_a_name_in_each_language() {
    const LANGUAGES: usize = 6;
    let listed: BTreeMap<&str, &str> = names_of_functions().collect();
    let functions: BTreeSet<&str> = BUILTINS.iter().map(|builtin| builtin.name).collect();
    assert_eq!(listed.keys().copied().collect::<BTreeSet<_>>(), functions);
    for (function, names) in listed {
        let reason = names.strip_prefix("- ").is_some_and(|reason| reason.split(' ').count() > 2);
        let languages = names.split(';');
        let full = languages.clone().all(|own| own.split('|').all(|name| !name.trim().is_empty()));
        assert!(reason || full && languages.count() == LANGUAGES, "{function}: {names}");
    }
}
