//! The worked examples of the lecture notes, from the command line, in every format.
//!
//! The snapshots show everything a reader sees; beside them the tests compute the values
//! that matter a second time, by the plainest formula, so that no wrong snapshot can be
//! accepted by mistake.

use crate::common::{in_every_format, run, transcript, transcripts};
use insta::assert_snapshot;
use polarform::session::Session;
use polarform::value::{Claim, Value, Verdict};

const CUBIC: &str = "t^3 + 3t^2 + 5t + 1";
const F: &str = "t^2 + 2t";
const G: &str = "t^3 + 1";
const GENERIC: [&str; 4] = ["c_0", "c_0 + c_1 t", "c_0 + c_1 t + c_2 t^2", "c_0 + c_1 t + c_2 t^2 + c_3 t^3"];
const METHODS: [&str; 6] = ["elementary", "probability", "taylor", "parts", "laguerre", "bezier"];
const NOTATIONS: [&str; 4] = ["grouped", "expanded", "sigma", "ellipsis"];

/// The claim that the last statement makes.
fn claim(statements: &[&str]) -> Claim {
    let mut session = Session::default();
    let mut last = None;
    for statement in statements {
        let answer = session.run(statement);
        last = Some(answer.unwrap_or_else(|failure| panic!("{statement}: {:?}", failure.problem)));
    }
    match last.expect("there is a statement").outcome.value {
        Value::Claim(claim) => claim.as_ref().clone(),
        other => panic!("{statements:?} is {}", other.kind()),
    }
}

fn assert_true(statements: &[&str]) {
    assert_eq!(claim(statements).verdict(), Verdict::Proved, "{statements:?}");
}

/// The coefficients (as text) of a result in JSON.
fn coefficients(arguments: &[&str]) -> Vec<String> {
    let ran = run(&[arguments, &["--format", "json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&ran.out).expect("one JSON value");
    let list = json["coefficients"].as_array().expect("a list of coefficients");
    list.iter().map(|c| c.as_str().expect("coefficients are strings").to_owned()).collect()
}

#[test]
fn polar_form_of_a_cubic() {
    assert_snapshot!(in_every_format(&["polar", CUBIC]));
    assert_eq!(coefficients(&["polar", CUBIC]), ["1", "5", "3", "1"]);
    // The diagonal and one value computed by hand: f(1, 2, 3) = 6 + 11 + 10 + 1.
    assert_true(&[&format!("f := polar({CUBIC})"), "f(t, t, t) = t^3 + 3t^2 + 5t + 1"]);
    assert_true(&[&format!("f := polar({CUBIC})"), "f(1, 2, 3) = 28"]);
}

#[test]
fn generic_polynomials() {
    let sessions = (0..4).map(|n| in_every_format(&["polar", GENERIC[n], "--variable", "t"]));
    assert_snapshot!(sessions.collect::<Vec<_>>().join("\n"));
    assert_true(&[
        &format!("f := polar({})", GENERIC[3]),
        "f(t1, t2, t3) = c_0 + c_1/3 (t1 + t2 + t3) + c_2/3 (t1 t2 + t1 t3 + t2 t3) + c_3 t1 t2 t3",
    ]);
}

#[test]
fn derivative_by_differences_of_the_polar_form() {
    let (f, polar) = (format!("F(t) := {}", GENERIC[3]), "f := polar(F)");
    let right = "F'(t) = 3 [f(t, t, 1) - f(t, t, 0)] = 3 f(t, t, hat(1)) = 3c_3 t^2 + 2c_2 t + c_1";
    let wrong = "F'(t) = 2 (f(t, t, 1) - f(t, t, 0))";
    assert_snapshot!(transcripts([
        vec!["check", right, "--given", &f, "--given", polar],
        vec!["check", wrong, "--given", &f, "--given", polar],
        vec!["eval", &f, polar, "diff(F(t), t)", "3[f(t, t, 1) - f(t, t, 0)]"],
    ]));
}

#[test]
fn pasted_latex() {
    assert_snapshot!(transcripts([
        vec!["polar", r"F(t) = t^3 + 3t^2 + 5t + 1"],
        vec!["polar", r"$\frac{1}{2} t^2 + c_{0}$"],
        vec!["product", r"t^{2} + 2\,t", r"\left(t^3 + 1\right)"],
        vec![
            "check",
            r"f(t_1,t_2,t_3) = t_1t_2t_3 + (t_1t_2+t_1t_3+t_2t_3) + \frac{5}{3}(t_1+t_2+t_3) + 1",
            "--given",
            r"f := polar(t^3 + 3t^2 + 5t + 1)",
        ],
        vec!["check", r"f(t,t,\hat{1}) = \frac{1}{3} F'(t)", "--given", "F(t) := t^3 + t; f := polar(F)"],
        vec!["polar", "t^2 + 2t", "--degree", "3", "--at", r"0, \frac{1}{2}, \hat{1}", "--format", "latex"],
    ]));
}

#[test]
fn sum() {
    assert_snapshot!(in_every_format(&["sum", F, G]));
    assert_eq!(coefficients(&["sum", F, G]), ["1", "2", "1", "1"]);
}

#[test]
fn product() {
    assert_snapshot!(in_every_format(&["product", F, G]));
    // (t^2 + 2t)(t^3 + 1) = t^5 + 2t^4 + t^2 + 2t; divided by C(5, i): 0, 2/5, 1/10, 0, 2/5, 1.
    assert_eq!(coefficients(&["product", F, G]), ["0", "2", "1", "0", "2", "1"]);
    assert_true(&[
        "h := polar_product(t^2 + 2t, t^3 + 1)",
        "h(t1, t2, t3, t4, t5) = esym(5, t1, t2, t3, t4, t5) + 2/5 esym(4, t1, t2, t3, t4, t5) \
         + 0 esym(3, t1, t2, t3, t4, t5) + 1/10 esym(2, t1, t2, t3, t4, t5) + 2/5 esym(1, t1, t2, t3, t4, t5)",
    ]);
}

#[test]
fn composition() {
    assert_snapshot!(in_every_format(&["compose", F, G]));
    // (t^3 + 1)^2 + 2 (t^3 + 1) = t^6 + 4t^3 + 3, and 4/C(6, 3) = 1/5.
    assert_eq!(coefficients(&["compose", F, G]), ["3", "0", "0", "4", "0", "0", "1"]);
    assert_true(&[
        "h := polar_compose(t^2 + 2t, t^3 + 1)",
        "h(t1, t2, t3, t4, t5, t6) = t1 t2 t3 t4 t5 t6 + 1/5 esym(3, t1, t2, t3, t4, t5, t6) + 3",
    ]);
}

#[test]
fn steps_of_sum_product_and_composition() {
    assert_snapshot!(transcripts([
        vec!["sum", F, G, "--steps"],
        vec!["product", F, G, "--steps"],
        vec!["compose", F, G, "--steps"],
    ]));
}

const CLAIMED_COMPOSITION: &str = "h(t1, t2, t3, t4, t5, t6) = t1 t2 t3 t4 t5 t6 \
    + 1/5 esym(3, t1, t2, t3, t4, t5, t6) + 1";
const CLAIMED_SUBSTITUTION: &str =
    "f(g(t1, t2, t3), g(t4, t5, t6)) = t1 t2 t3 t4 t5 t6 + t1 t2 t3 + t4 t5 t6 + 1";

#[test]
fn wrong_claims_of_the_notes_are_refuted() {
    let (f, g, h) = ("f := polar(t^2 + 2t)", "g := polar(t^3 + 1)", "h := polar_compose(f, g)");
    let given = ["--given", f, "--given", g, "--given", h];
    let session = |claim| [&["check", claim], &given[..]].concat();
    assert_snapshot!(transcripts([session(CLAIMED_COMPOSITION), session(CLAIMED_SUBSTITUTION)]));

    let wrong = claim(&[f, g, h, CLAIMED_COMPOSITION]).judgements.remove(0);
    assert_eq!(wrong.verdict, Verdict::Refuted);
    assert_eq!(wrong.difference.and_then(|d| d.as_int()), Some(2), "the constant is 3, not 1");
    let wrong = claim(&[f, g, CLAIMED_SUBSTITUTION]).judgements.remove(0);
    assert_eq!(wrong.verdict, Verdict::Refuted);
    // f(x, y) = xy + x + y at x = t1 t2 t3 + 1, y = t4 t5 t6 + 1.
    assert_true(&[f, g, "f(g(t1, t2, t3), g(t4, t5, t6)) = t1 t2 t3 t4 t5 t6 + 2 t1 t2 t3 + 2 t4 t5 t6 + 3"]);
}

#[test]
fn matrices() {
    let mut sessions = Vec::new();
    for n in ["2", "3"] {
        sessions.push(in_every_format(&["matrix", "--degree", n]));
        sessions.push(in_every_format(&["matrix", "--degree", n, "--inverse"]));
    }
    sessions.push(in_every_format(&["matrix", "--degree", "2", "--raise-to", "3"]));
    assert_snapshot!(sessions.join("\n"));
    for claim in [
        "bernstein_to_power(2) = [1, 0, 0; -2, 2, 0; 1, -2, 1]",
        "bernstein_to_power(3) = [1, 0, 0, 0; -3, 3, 0, 0; 3, -6, 3, 0; -1, 3, -3, 1]",
        "power_to_bernstein(3) bernstein_to_power(3) = identity(4)",
        "power_to_bernstein(2) = bernstein_to_power(2)^-1",
        // A_3^-1 times A_2 with a row of zeros below.
        "raising(2, 3) = power_to_bernstein(3) [1, 0, 0; -2, 2, 0; 1, -2, 1; 0, 0, 0]",
    ] {
        assert_eq!(run(&["check", claim]).status, Some(0), "{claim}");
    }
}

#[test]
fn control_points_of_a_cubic() {
    let f = format!("f := polar({})", GENERIC[3]);
    let points = "[f(0, 0, 0), f(0, 0, 1), f(0, 1, 1), f(1, 1, 1)]";
    assert_snapshot!(in_every_format(&["eval", &f, points]));
    assert_true(&[
        &f,
        &format!(
            "{points} = [c_0, c_0 + 1/3 c_1, c_0 + 2/3 c_1 + 1/3 c_2, c_0 + c_1 + c_2 + c_3] \
             = bezier_points(f)"
        ),
    ]);
}

#[test]
fn labels_of_de_casteljau() {
    let rows = ["[f(0, 0, t), f(0, t, 1), f(t, 1, 1)]", "[f(0, t, t), f(t, t, 1)]", "f(t, t, t)"];
    let f = "f := from_bezier([b_0, b_1, b_2, b_3])";
    let mut arguments = vec!["eval", f, "[f(0, 0, 0), f(0, 0, 1), f(0, 1, 1), f(1, 1, 1)]"];
    arguments.extend(rows);
    assert_snapshot!(in_every_format(&arguments));
    // Each label is the affine combination (1 - t) left + t right of the row above.
    for claim in [
        "f(0, 0, t) = (1 - t) f(0, 0, 0) + t f(0, 0, 1) = (1 - t) b_0 + t b_1",
        "f(0, t, 1) = (1 - t) f(0, 0, 1) + t f(0, 1, 1) = (1 - t) b_1 + t b_2",
        "f(t, 1, 1) = (1 - t) f(0, 1, 1) + t f(1, 1, 1) = (1 - t) b_2 + t b_3",
        "f(0, t, t) = (1 - t) f(0, 0, t) + t f(0, t, 1)",
        "f(t, t, 1) = (1 - t) f(0, t, 1) + t f(t, 1, 1)",
        "f(t, t, t) = (1 - t) f(0, t, t) + t f(t, t, 1)",
        "f(t, t, t) = (1 - t)^3 b_0 + 3 t (1 - t)^2 b_1 + 3 t^2 (1 - t) b_2 + t^3 b_3",
    ] {
        assert_true(&[f, claim]);
    }
}

#[test]
fn total_degree_against_tensor_product() {
    let total = "f := polar_total(u v, [u, v], degree=2)";
    let tensor = "g := polar_tensor(u v, u, v, 2, 2)";
    let half = "1/2 (u1 v2 + u2 v1)";
    let quarter = "1/4 (u1 v1 + u1 v2 + u2 v1 + u2 v2)";
    let (f, g) = ("f([u1, v1], [u2, v2])", "g(u1, u2; v1, v2)");
    let claims: Vec<String> = [(f, half), (f, quarter), (g, quarter), (g, half)]
        .iter()
        .map(|(left, right)| format!("{left} = {right}"))
        .collect();
    let mut sessions = vec![in_every_format(&["eval", total]), in_every_format(&["eval", tensor])];
    sessions.extend(claims.iter().map(|c| transcript(&["check", c, "--given", total, "--given", tensor])));
    assert_snapshot!(sessions.join("\n"));
    let status =
        claims.iter().map(|c| run(&["check", c, "--given", total, "--given", tensor]).status.unwrap_or(-1));
    assert_eq!(status.collect::<Vec<_>>(), [0, 1, 0, 1]);
}

#[test]
fn every_method_with_its_steps() {
    for method in METHODS {
        let mut session = transcript(&["polar", CUBIC, "--method", method, "--steps"]);
        session.push('\n');
        session += &transcript(&["polar", GENERIC[2], "--method", method, "--steps", "--format", "latex"]);
        assert_snapshot!(format!("method_{method}"), session);
    }
    for polynomial in [CUBIC, GENERIC[3], F, G, "7", "0"] {
        let last = |method| {
            let ran = run(&["polar", polynomial, "--variable", "t", "--method", method, "--steps"]);
            let line = ran.out.lines().last().unwrap_or_default().to_owned();
            line.split("    [").next().unwrap_or_default().to_owned()
        };
        for method in METHODS {
            assert_eq!(last(method), last("elementary"), "{method} for {polynomial}");
        }
    }
}

#[test]
fn every_notation() {
    for notation in NOTATIONS {
        let options = ["--notation", notation];
        let mut session = in_every_format(&[&["polar", CUBIC], &options[..]].concat());
        session.push('\n');
        session += &in_every_format(&[&["compose", F, G], &options[..]].concat());
        assert_snapshot!(format!("notation_{notation}"), session);
    }
}
