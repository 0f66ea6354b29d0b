//! The functions of the table as the evaluator calls them.

use std::collections::{BTreeSet, HashMap};
use std::sync::LazyLock;

use super::gives::Gives;
use super::parameter::{Need, Parameter};
use super::record::Builtin;
use super::table::{BUILTINS, builtin};
use crate::language::eval::{Arguments, Callable, Evaluated, Machine, Slot};
use crate::language::ops::takes::Takes;

/// The function of that name, for the evaluator.
pub(crate) fn callable(name: &str) -> Option<&'static dyn Callable> {
    builtin(name).map(|builtin| builtin as &dyn Callable)
}

/// The names of all functions.
pub(crate) fn names() -> Vec<&'static str> {
    BUILTINS.iter().map(|builtin| builtin.name).collect()
}

/// Whether a word names an argument of a function, or is one, as both do in `method=taylor`.
pub(crate) fn is_argument_word(word: &str) -> bool {
    static WORDS: LazyLock<BTreeSet<&str>> = LazyLock::new(|| {
        let all = BUILTINS.iter().flat_map(|builtin| [*builtin].into_iter().chain(builtin.subjects));
        let parameters = |builtin: &'static Builtin| builtin.parameter_lists().flatten();
        let words = all
            .clone()
            .flat_map(parameters)
            .flat_map(|parameter| parameter.kind.words().into_iter().chain([parameter.name]));
        words.chain(all.map(|builtin| builtin.name)).collect()
    });
    WORDS.contains(word)
}

/// Other names for functions, which are called like these.
const ALIASES: &[(&str, &str)] = &[
    ("de_casteljau", "casteljau"),
    ("de_boor", "deboor"),
    ("blossom", "polar"),
    ("polarform", "polar"),
    ("polar_form", "polar"),
    ("to_bernstein", "in_bernstein"),
    ("bernstein_form", "in_bernstein"),
    ("to_powers", "in_powers"),
    ("power_form", "in_powers"),
    ("expanded", "expand"),
    ("polarize", "polar"),
    ("decasteljau", "casteljau"),
    ("bezier_triangle", "triangle_patch"),
    ("triangular_patch", "triangle_patch"),
    ("bezier_patch", "patch"),
    ("bezier_surface", "patch"),
    ("lagrange_polynomial", "lagrange"),
    ("newton_polynomial", "newton"),
    ("elevate_degree", "elevate"),
    ("raise_degree", "elevate"),
    ("split", "subdivide"),
    ("boehm", "insert_knots"),
    ("insert_knot", "insert_knots"),
    ("knot_insertion", "insert_knots"),
    ("periodic_bspline", "periodic_spline"),
    ("tensor_patch", "patch"),
    ("triangle_surface", "triangle_patch"),
    ("bspline_surface", "spline_surface"),
    ("interpolate", "lagrange"),
    ("surface_of_revolution", "revolve"),
    ("degree_elevation", "elevate"),
    ("degree_reduction", "reduce"),
    ("continuity_conditions", "joining_conditions"),
    ("nCr", "binomial"),
    ("choose", "binomial"),
    ("comb", "binomial"),
    ("inv", "inverse"),
    ("determinant", "det"),
    ("differentiate", "diff"),
    ("coeff", "coefficient"),
    ("coeffs", "coefficients"),
    ("substitute", "subs"),
    ("deg", "degree"),
    ("rem", "remainder"),
    ("quo", "quotient"),
    ("len", "length"),
    ("bspline_curve", "bspline"),
    ("bezier_curve", "bezier"),
    ("nullspace", "null_space"),
    ("eye", "identity"),
    ("gram_matrix", "gram"),
    ("mass_matrix", "gram"),
    ("charpoly", "characteristic_polynomial"),
    ("eigenvals", "eigenvalues"),
    ("spline_interpolation", "interpolating_spline"),
    ("de_boor_fix", "deboor_fix"),
    ("integral", "integrate"),
    ("int", "integrate"),
    ("tr", "trace"),
    ("Tr", "trace"),
    ("rref", "row_echelon"),
    ("greville_abscissae", "greville"),
    ("divided_difference", "divided_differences"),
    ("natural_spline", "cubic_spline"),
    ("bezier_pieces", "pieces"),
    ("primitive", "antiderivative"),
    ("nchoosek", "binomial"),
    ("b_spline_basis", "bspline_basis"),
    ("symmetric_polynomial", "esym"),
    ("polyfit", "least_squares"),
    ("combin", "binomial"),
    ("fact", "factorial"),
    ("ggT", "gcd"),
    ("ggt", "gcd"),
    ("pgcd", "gcd"),
    ("kgV", "lcm"),
    ("kgv", "lcm"),
    ("ppcm", "lcm"),
    ("polynomial_degree", "degree"),
    ("polynomial_gcd", "gcd"),
    ("polynomial_lcm", "lcm"),
    ("polynomial_quotient", "quotient"),
    ("polynomial_remainder", "remainder"),
    ("coefficient_list", "coefficients"),
    ("interpolating_polynomial", "lagrange"),
    ("bernstein_basis", "bernstein"),
    ("matrix_rank", "rank"),
    ("row_reduce", "row_echelon"),
    ("together", "simplify"),
    ("full_simplify", "simplify"),
    ("eig", "eigenvalues"),
    ("null", "null_space"),
    ("fliplr", "reverse"),
    ("numel", "length"),
    ("real_roots", "roots"),
    ("realroot", "roots"),
    ("ifactor", "factor"),
    ("factor_integer", "factor"),
    ("factorint", "factor"),
    ("factor_list", "factor"),
    ("cross_product", "cross"),
    ("dot_product", "dot"),
    ("ratsimp", "simplify"),
    ("multiply_out", "expand"),
    ("reduced_row_echelon_form", "row_echelon"),
    ("invert", "inverse"),
    ("maximum_value", "maximum"),
    ("minimum_value", "minimum"),
];

/// Functions that somebody may mean by other names.
const SYNONYMS: &[(&str, &str)] = &[
    ("cox_de_boor", "bspline_basis"),
    ("cancel", "simplify"),
    ("is_polar", "laws"),
    ("is_symmetric", "laws"),
    ("triangle", "triangle_patch"),
    ("rational", "bezier"),
    ("basis_matrix", "change_of_basis"),
    ("bernstein_matrix", "bernstein_to_power"),
    ("points", "control_points"),
    ("value", "subs"),
    ("tangent", "derivative"),
    ("homogenize", "homogeneous"),
    ("fit", "least_squares"),
    ("regression", "least_squares"),
    ("evaluate", "extended"),
    ("curve", "bezier"),
    ("rational_bezier", "bezier"),
    ("nurbs", "bspline"),
    ("spline", "bspline"),
    ("hull", "convex_hull"),
    ("insert", "insert_knots"),
    ("oslo", "refine"),
    ("basis", "bspline_basis"),
    ("marsden", "spline_of"),
    ("surface", "patch"),
    ("revolution", "revolve"),
    ("delta", "differences"),
    ("stiffness_matrix", "gram"),
    ("dual_bernstein", "dual_basis"),
    ("subdivision", "subdivide_polygon"),
    ("chaikin", "subdivide_polygon"),
    ("corner_cutting", "subdivide_polygon"),
    ("catmull_clark", "vertex_matrix"),
];

/// Other functions that the word for one may mean, where what is said fits them: divide t^3 + 1 by t + 1, reduce a fraction.
const SENSES: &[(&str, &[&str])] = &[
    ("subdivide", &["quotient", "factor"]),
    ("reduce", &["simplify"]),
    ("bernstein", &["in_bernstein"]),
    ("in_bernstein", &["bezier_points"]),
    ("control_points", &["bezier_points"]),
    ("normal", &["normal_at"]),
    ("polar", &["polar_total"]),
    ("figure_bezier", &["figure_functions", "figure_bspline"]),
    ("arc_length", &["polygon_length", "length"]),
    ("integrate", &["area"]),
    ("intersections", &["solve"]),
];

/// What else the word for a function may mean.
pub(crate) fn senses(name: &str) -> &'static [&'static str] {
    SENSES.iter().find(|(own, _)| *own == name).map_or(&[], |(_, others)| others)
}

type Names = HashMap<&'static str, &'static str>;

/// The first meaning of each name.
fn by_name(names: &'static [(&str, &str)]) -> Names {
    names.iter().rev().copied().collect()
}

static BY_ALIAS: LazyLock<Names> = LazyLock::new(|| by_name(ALIASES));

static BY_SYNONYM: LazyLock<Names> = LazyLock::new(|| by_name(SYNONYMS));

/// The function that somebody means by another name.
pub(crate) fn synonym(name: &str) -> Option<&'static str> {
    BY_ALIAS.get(name).or_else(|| BY_SYNONYM.get(name)).copied()
}

/// The name of the function that is called so, by its own name or another one for it.
pub(crate) fn function_called(name: &str) -> Option<&'static str> {
    let own = builtin(name).map(|builtin| builtin.name);
    own.or_else(|| BY_ALIAS.get(name).copied())
}

/// Nouns that say nothing more behind the name of a function: the aitken scheme.
const NOUNS: &[&str] =
    &["scheme", "algorithm", "matrix", "tableau", "table", "method", "identity", "polynomial", "polynomials"];

/// Words that mean something else in sentences.
const OF_SENTENCES: &[&str] = &[
    "value",
    "evaluate",
    "points",
    "curve",
    "rational",
    "basis",
    "triangle",
    "tangent",
    "spline",
    "subdivision",
    "delta",
];

/// The function that words name, with `_` between them: also in the singular or plural, and by other names for it.
pub(crate) fn function_in_words(name: &str) -> Option<&'static str> {
    const SHORTEST: usize = 4;
    // from Bézier to powers
    if name.starts_with("from_") {
        return None;
    }
    function_called(name).or_else(|| {
        let singular = name.strip_suffix('s').filter(|one| one.len() >= SHORTEST);
        let plural = format!("{name}s");
        // A difference of two things is none of a list.
        let plural = Some(plural.as_str()).filter(|_| name.len() >= SHORTEST && name != "difference");
        let other = || BY_SYNONYM.get(name).filter(|_| !OF_SENTENCES.contains(&name)).copied();
        singular
            .and_then(function_called)
            .or_else(|| plural.and_then(function_called))
            .or_else(other)
            .or_else(|| {
                let (inner, noun) = name.rsplit_once('_')?;
                (NOUNS.contains(&noun) && inner.len() >= SHORTEST).then(|| function_called(inner))?
            })
    })
}

/// The same, also written as other systems do.
pub(crate) fn function_meant(name: &str) -> Option<&'static str> {
    function_called(name).or_else(|| function_in_capitals(name))
}

/// `Expand`, `GCD`, `ControlPoints`
fn function_in_capitals(name: &str) -> Option<&'static str> {
    if name.len() < 3 || !name.starts_with(char::is_uppercase) {
        return None;
    }
    let mut small = String::new();
    for (at, letter) in name.char_indices() {
        let start = letter.is_uppercase() && name.chars().any(char::is_lowercase);
        if start && at > 0 && !small.ends_with('_') {
            small.push('_');
        }
        small.extend(letter.to_lowercase());
    }
    function_called(&small)
}

/// The function with another name that is called like this one.
pub(crate) fn alias(name: &str) -> Option<&'static dyn Callable> {
    function_meant(name).and_then(callable)
}

/// What to write for an argument that a function does not take: its derivation may.
fn elsewhere(builtin: &Builtin, parameters: &[Parameter], argument: &str) -> String {
    let takes = |subject: &Builtin| {
        subject.name == builtin.name
            && subject.parameter_lists().flatten().any(|parameter| parameter.name == argument)
    };
    // degree=n: n is what the form calls the value
    let meant = |parameter: &&Parameter| parameter.form == format!("{}={argument}", parameter.name);
    if let Some(parameter) = builtin.parameter_lists().flatten().find(meant) {
        return format!("write {}=...", parameter.name);
    }
    match BUILTINS.iter().find(|parent| parent.subjects.iter().any(takes)) {
        Some(parent) => format!("write {}({}, ..., {argument}=...) for its steps", parent.name, builtin.name),
        None => {
            let names = parameters.iter().filter(|parameter| parameter.has_name());
            let names: Vec<&str> = names.map(|parameter| parameter.name).collect();
            match names.is_empty() {
                true => format!("leave it out: the form is {}", builtin.form_with(parameters)),
                false => format!("the names of its arguments are {}", names.join(", ")),
            }
        }
    }
}

impl Callable for Builtin {
    fn name(&self) -> &'static str {
        self.name
    }

    fn form(&self) -> String {
        self.signature()
    }

    fn takes_word(&self, slot: Slot, word: &str, defined: bool) -> bool {
        match slot {
            Slot::Place(place) => self.takes_word_at(place, word, defined),
            Slot::Name(name) => self.takes_word_under(name, word, defined),
        }
    }

    fn takes_polynomial(&self, place: usize) -> bool {
        let parameter = self.parameters.iter().filter(|parameter| parameter.has_place()).nth(place);
        parameter.is_some_and(|parameter| matches!(parameter.kind, Takes::Polynomial | Takes::Function))
    }

    fn takes_unknowns(&self, slot: Slot) -> bool {
        match slot {
            Slot::Name(name) => name == "unknowns",
            Slot::Place(place) => self.parameter_lists().any(|list| {
                let parameter = list.iter().filter(|parameter| parameter.has_place()).nth(place);
                parameter.is_some_and(|parameter| parameter.name == "unknowns")
            }),
        }
    }

    fn takes_coordinates(&self, place: usize) -> bool {
        if !self.subjects.is_empty() {
            return place > 0;
        }
        let parameter = self.parameters.iter().filter(|parameter| parameter.has_place()).nth(place);
        match parameter.map(|parameter| parameter.kind) {
            None => place == 0,
            Some(kind) => {
                kind.is_of_curves()
                    || place == 0 && !matches!(kind, Takes::Any | Takes::Mapping | Takes::OneOf(_))
            }
        }
    }

    fn takes_name(&self, name: &str) -> bool {
        self.parameter_lists().flatten().any(|parameter| parameter.has_name() && parameter.name == name)
    }

    fn takes_values(&self) -> bool {
        self.parameter_lists().flatten().any(|parameter| parameter.need == Need::Free)
    }

    fn takes_equations(&self) -> bool {
        self.on_equations.is_some()
    }

    fn gives_function(&self) -> bool {
        self.gives == Gives::Function
    }

    fn run(&self, machine: &mut Machine, arguments: Arguments) -> Evaluated {
        Builtin::run(self, machine, arguments).map_err(|error| {
            let unknown =
                error.message.strip_prefix("there is no argument '").map(|rest| rest.trim_end_matches('\''));
            let form = error.reason.as_deref().and_then(|reason| reason.strip_prefix("the form is "));
            // The form that was meant, by what the first argument is.
            let parameters = form.map_or(self.parameters, |form| self.parameters_of(form));
            match unknown
                .filter(|_| error.hints.is_empty())
                .map(|argument| elsewhere(self, parameters, argument))
            {
                Some(advice) => error.hint(advice),
                None => error,
            }
        })
    }
}
