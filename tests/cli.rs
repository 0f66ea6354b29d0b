//! The contract of the command line: exit status, streams, scripts, limits.

use std::fs;
use std::io::Read;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

use crate::common::{command, run, run_with};

/// A file that is removed at the end of the test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str, content: &[u8]) -> Self {
        let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{name}", std::process::id()));
        fs::write(&path, content).expect("the test directory is writable");
        Scratch(path)
    }

    fn path(&self) -> &str {
        self.0.to_str().expect("the path is UTF-8")
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

#[test]
fn exit_status_tells_how_it_went() {
    for (arguments, status) in [
        (&["polar", "t^2"][..], 0),
        (&["check", "1 + 1 = 2"], 0),
        (&["check", "1 + 1 = 2 = 4 - 2"], 0),
        (&["check", "1 + 1 = 3"], 1),
        (&["check", "1 + 1 = 2 = 3"], 1),
        (&["eval", "1 = 2"], 1),
        (&["check", "x > 0"], 2),
        (&["check", "a = b", "--given", "a - b = 0"], 0),
        (&["check", "a F(1) = b", "--given", "a = b; F(t) := t", "--given", "a - b = 0"], 0),
        (&["check", "x y = 0", "--given", "x^2 + y^2 < 1/100"], 2),
        (&["check", "t >= 0", "--given", "0 <= t"], 0),
        (&["check", "2t + 1 > 0", "--given", "0 <= t"], 0),
        (&["check", "u v <= 1", "--given", "0 <= u; u <= 1; 0 <= v; v <= 1"], 0),
        (&["check", "u v < 1", "--given", "0 < u; u < 1; 0 < v; v < 1"], 0),
        (&["check", "u v <= 1/2", "--given", "0 <= u; u <= 1; 0 <= v; v <= 1"], 1),
        (&["check", "u^2 - u v + v^2 >= 0", "--given", "-1 <= u; u <= 1; 0 <= v; v <= 1"], 0),
        (&["check", "t > 0", "--given", "0 <= t"], 1),
        (&["check", "t u > 0", "--given", "0 < t"], 1),
        (&["check", "x + y = 3", "--given", "x = 1 and y = 2"], 0),
        (&["check", "x = 1", "--given", "x < 5"], 1),
        (&["check", "x = 1", "--given", "x^2 = 1"], 2),
        (
            &[
                "bspline", "--degree", "1", "--knots", "a,b,c,d", "--points", "1,2", "--at", "t", "--span",
                "1",
            ],
            0,
        ),
        (&["bspline", "--degree", "1", "--knots", "a,b,c,d", "--points", "1,2", "--span", "1"], 2),
        (&["eval", "-2^2"], 0),
        (&["polar", "-t^2 + t"], 0),
        (&["check", "t + 1"], 2),
        (&["check", "1 +"], 2),
        (&["polar", "1/t"], 2),
        (&["eval", "1/0"], 2),
        (&["nonsense"], 2),
        (&["polar"], 2),
        (&["polar", "t", "--format", "pdf"], 2),
        (&["polar", "t", "--method", "magic"], 2),
        (&["polar", "t", "--degree", "-1"], 2),
        (&["--help"], 0),
        (&["--version"], 0),
        (&["polar", "--help"], 0),
        (&["explain"], 0),
        (&["explain", "E304"], 0),
        (&["explain", "E000"], 2),
        (&["functions"], 0),
        (&["functions", "polar"], 0),
        (&["functions", "polra"], 2),
    ] {
        assert_eq!(run(arguments).status, Some(status), "{arguments:?}");
    }
}

#[test]
fn the_worst_statement_decides_the_status() {
    for (statements, status) in
        [(&["1 = 1", "1 = 2", "1 = 1"][..], 1), (&["1 = 2", "1/0"], 2), (&["1/0", "1 = 2"], 2)]
    {
        assert_eq!(run(&[&["eval"], statements].concat()).status, Some(status), "{statements:?}");
    }
}

#[test]
fn results_on_one_stream_and_messages_on_the_other() {
    let good = run(&["polar", "t^2"]);
    assert_eq!((good.out.as_str(), good.err.as_str()), ("f(t1, t2) = t1 t2\n", ""));
    let bad = run(&["polar", "t^2 +"]);
    assert_eq!(bad.out, "");
    assert!(bad.err.contains("error[E103]"), "{}", bad.err);
    // A verdict is a result, not a message.
    let refuted = run(&["check", "1 = 2"]);
    assert!(refuted.out.starts_with("refuted\n") && refuted.err.is_empty());
    let mixed = run(&["eval", "1 + 1; 1/0"]);
    assert_eq!(mixed.out, "2\n");
    assert!(mixed.err.contains("error[E303]"), "{}", mixed.err);
    let usage = run(&["polar"]);
    assert!(usage.out.is_empty() && usage.err.contains("Usage"), "{}", usage.err);
}

#[test]
fn what_is_to_be_proved_and_fails_has_the_status_of_a_refuted_claim() {
    for (claim, status) in [
        ("prove t^2 - 2 >= 0 on [0, 1]", 1),
        ("prove t^2 - 2 >= 0 on [2, 3]", 0),
        ("is t^3 convex on [-1, 1]?", 1),
        ("prove (t^2 - 2)^2 > 0 on [0, 2]", 1),
        ("prove (t^2 - 2)^2 > 0 on [0, 1]", 0),
        // The zero may be excluded.
        ("(t^2 - 2)^2 > 0 where 0 <= t <= 2 and t^2 > 3", 2),
        // What a function tells is no claim.
        ("positivity(t^2 - 2, 0, 1)", 0),
    ] {
        assert_eq!(run(&["eval", claim]).status, Some(status), "{claim}");
    }
}

#[test]
fn messages_as_data() {
    let bad = run(&["polar", "1/t", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&bad.err).expect("one JSON value");
    assert_eq!(json["code"], "E304");
    assert_eq!(bad.status, Some(2));
    let refuted = run(&["check", "2t = 3t", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&refuted.out).expect("one JSON value");
    assert!(json.to_string().contains("refuted"), "{json}");
    assert_eq!(refuted.status, Some(1));
}

#[test]
fn definitions_are_given_in_order() {
    let ran = run(&["check", "f(0, 1) = 1/2", "--given", "F(t) := t^2 + t", "--given", "f := polar(F)"]);
    assert_eq!((ran.status, ran.out.as_str()), (Some(0), "proved\n"));
    // Several in one option.
    let ran = run(&["check", "f(0, 1) = 1/2", "--given", "F(t) := t^2 + t; f := polar(F)"]);
    assert_eq!(ran.status, Some(0), "{}", ran.err);
    // What is wrong with a definition is shown in the definition.
    let ran = run(&["check", "f(0, 1) = 1/2", "--given", "a := 1", "--given", "f := polar(1/t)"]);
    assert_eq!(ran.status, Some(2));
    assert!(ran.err.contains("<given 2>:1:"), "{}", ran.err);
    // Out of order, the first one misses the second.
    let ran = run(&["check", "a = 1", "--given", "a := later(1)", "--given", "later(x) := x"]);
    assert_eq!(ran.status, Some(2));
}

#[test]
fn operands_may_be_equations() {
    let plain = run(&["polar", "t^2 + 2t"]).out;
    assert_eq!(run(&["polar", "F(t) = t^2 + 2t"]).out, plain);
    assert_eq!(run(&["polar", "F(t) := t^2 + 2t"]).out, plain);
}

#[test]
fn values_at_arguments() {
    // f = t1 t2 + t1 + t2, elevated: e_2/3 + 2 e_1/3 at (0, 1/2, 1^): (0 + 0 + 1/2)/3 + 2/3.
    let ran = run(&["polar", "t^2 + 2t", "--degree", "3", "--at", "0, 1/2, hat(1)"]);
    assert_eq!(ran.out, "f(0, 1/2, hat(1)) = 5/6\n");
    let ran = run(&["polar", "t^2 + 2t", "--at", "-1,-1"]);
    assert_eq!(ran.out, "f(-1, -1) = -1\n");
    let ran = run(&["polar", "t^2", "--at", "1"]);
    assert_eq!(ran.status, Some(2));
    assert!(ran.err.contains("error[E301]"), "{}", ran.err);
}

const SCRIPT: &str = "# a parabola\nF(t) := t^2 + 2t\nf := polar(F); f(0, 1)\n\nf(t, t) = F(t)\n";
const SCRIPT_RESULT: &str = "F(t) := t^2 + 2 t\nf(t1, t2) = t1 t2 + (t1 + t2)\n1\nproved\n";

#[test]
fn a_piped_script_runs() {
    for arguments in [&[][..], &["run", "-"]] {
        let ran = run_with(arguments, SCRIPT.as_bytes());
        assert_eq!(ran.out, SCRIPT_RESULT);
        assert_eq!((ran.status, ran.err.as_str()), (Some(0), ""));
    }
    assert_eq!(run_with(&[], b"").status, Some(0));
    assert_eq!(run_with(&[], b"# nothing but a remark\n").status, Some(0));
    let endings = SCRIPT.replace('\n', "\r\n");
    assert_eq!(run_with(&[], endings.as_bytes()).out, SCRIPT_RESULT);
}

#[test]
fn a_script_goes_on_after_an_error_unless_told_to_stop() {
    let script = b"1 + 1\n(2\n2 + 2\n";
    let ran = run_with(&["run", "-"], script);
    assert_eq!((ran.status, ran.out.as_str()), (Some(2), "2\n4\n"));
    assert!(ran.err.contains("<stdin>:2:"), "{}", ran.err);
    let ran = run_with(&["run", "-", "--stop"], script);
    assert_eq!((ran.status, ran.out.as_str()), (Some(2), "2\n"));
}

#[test]
fn files_that_can_be_run_and_files_that_cannot() {
    let good = Scratch::new("good.pf", SCRIPT.as_bytes());
    assert_eq!(run(&["run", good.path()]).out, SCRIPT_RESULT);
    let windows = Scratch::new("windows.pf", SCRIPT.replace('\n', "\r\n").as_bytes());
    assert_eq!(run(&["run", windows.path()]).out, SCRIPT_RESULT);
    let marked = Scratch::new("marked.pf", format!("\u{feff}{SCRIPT}").as_bytes());
    assert_eq!(run(&["run", marked.path()]).out, SCRIPT_RESULT);
    let empty = Scratch::new("empty.pf", b"");
    assert_eq!(run(&["run", empty.path()]).status, Some(0));

    let binary = Scratch::new("binary.pf", b"1 + 1\n\xff\xfe\n");
    let directory = env!("CARGO_TARGET_TMPDIR");
    for (path, code, words) in [
        ("no/such/file.pf", "E501", "no/such/file.pf"),
        (directory, "E501", "directory"),
        (binary.path(), "E606", "UTF-8"),
    ] {
        let ran = run(&["run", path]);
        assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""), "{path}");
        assert!(ran.err.starts_with(&format!("error[{code}]")) && ran.err.contains(words), "{}", ran.err);
    }
}

#[test]
fn places_count_from_the_start_of_the_script() {
    let ran = run_with(&[], "a := 1\nb := 2; ü := 3\nc := a + b + whoknows\n".as_bytes());
    assert!(ran.err.contains("<stdin>:3:14"), "{}", ran.err);
}

/// Starts the program, reads some of its output, and hangs up.
fn hang_up_after(arguments: &[&str], bytes: usize) -> (Option<i32>, String) {
    let mut child = command(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdout = child.stdout.take().expect("standard output is piped");
    let mut buffer = vec![0; bytes];
    stdout.read_exact(&mut buffer).expect("there is that much output");
    drop(stdout);
    let output = child.wait_with_output().expect("the program ends");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_closed_pipe_ends_it_quietly() {
    let long = ["polar", "t^14 + 1", "--degree", "14", "--notation", "expanded"];
    for arguments in [&long[..], &["functions"], &["eval", "0..100000"]] {
        let (status, messages) = hang_up_after(arguments, 1);
        assert_eq!((status, messages.as_str()), (Some(0), ""), "{arguments:?}");
    }
}

#[test]
fn the_limit_on_terms_is_honoured() {
    for arguments in [
        &["eval", "(t1 + t2 + t3)^20"][..],
        &["eval", "0..1000"],
        &["eval", "identity(40)"],
        &["polar", "(t + 1)^12", "--notation", "expanded"],
        &["polar", "t^12 + t^6"],
        &["matrix", "--degree", "40"],
    ] {
        let small = run(&[arguments, &["--max-terms", "100"]].concat());
        assert_eq!(small.status, Some(2), "{arguments:?}: {}", small.out);
        assert!(small.err.contains("error[E402]"), "{arguments:?}: {}", small.err);
        assert!(small.err.contains("--max-terms"), "the hint names the option: {}", small.err);
        let large = run(&[arguments, &["--max-terms", "10000"]].concat());
        assert_eq!(large.status, Some(0), "{arguments:?}: {}", large.err);
    }
}

#[test]
fn the_limit_on_time_is_honoured() {
    let sums = "sum(i=1..100000, (t + i)^20)";
    for heavy in [
        "symmetrize((t1 + t2 + t3 + t4 + t5 + t6)^14, [t1, t2, t3, t4, t5, t6])",
        "(t1 + t2 + t3 + t4 + t5 + 1)^24",
        "polar((t + 1/3)^100000)",
        sums,
    ] {
        let ran = run(&["eval", heavy, "--timeout", "0.2", "--max-terms", "1000000000"]);
        assert_eq!(ran.status, Some(2), "{heavy}: {}", &ran.out[..ran.out.len().min(200)]);
        assert!(ran.err.contains("error[E401]"), "{heavy}: {}", ran.err);
        assert!(ran.err.contains("--timeout"), "the hint names the option: {}", ran.err);
        assert!(ran.time < Duration::from_secs(3), "{heavy}: stopped after {:?}", ran.time);
    }
    // Each statement has its own time, and no limit is no limit.
    for timeout in ["0", "60"] {
        let ran = run(&["eval", "1 + 1; 2 + 2", "--timeout", timeout]);
        assert_eq!(ran.out, "2\n4\n");
    }
}

#[test]
fn color_when_asked_for() {
    let escape = '\u{1b}';
    let colored = run(&["eval", "1/0", "--color", "always"]);
    assert!(colored.err.contains(escape));
    for arguments in [&["eval", "1/0", "--color", "never"][..], &["eval", "1/0"]] {
        assert!(!run(arguments).err.contains(escape));
    }
    // Results stay plain: they go into files.
    assert!(!run(&["polar", "t^2", "--color", "always"]).out.contains(escape));
    assert_eq!(run(&["eval", "1/0", "--color", "sometimes"]).status, Some(2));
}

#[test]
fn every_code_and_function_is_explained() {
    for line in run(&["explain"]).out.lines() {
        let code = line.split_whitespace().next().expect("a code");
        let ran = run(&["explain", code]);
        assert_eq!(ran.status, Some(0), "{code}");
        assert!(ran.out.lines().count() > 2, "{code}: {}", ran.out);
    }
}

// Arguments: each is read by itself and becomes a part of the query.

#[test]
fn latex_in_any_argument() {
    for (arguments, result) in [
        (&["bezier", "0, 1, 4", "--at", r"\frac12"][..], "3/2\n"),
        (&["bezier", "0, 1, 4", "--at", r"$\frac{1}{2}$"], "3/2\n"),
        (&["bezier", r"\frac12, 1", "--interval", r"0, \frac12", "--at", "1/4"], "3/4\n"),
        (&["bezier", r"0, \frac12, 1", "--weights", r"1, \frac12, 1", "--at", r"\frac12"], "1/2\n"),
        (
            &["bezier", "0, 2", "--subdivide", r"\frac12"],
            "[bezier([0, 1], 0, 1/2), bezier([1, 2], 1/2, 1)]\n",
        ),
        (
            &[
                "bspline",
                "-n",
                "1",
                "--knots",
                r"0, 0, \frac12, 1, 1",
                "--points",
                r"0, \frac12, 2",
                "--at",
                r"\frac12",
            ],
            "1/2\n",
        ),
        (&["bspline", "-n", "1", "--knots", "0,1,2", "--basis", "0", "--at", r"\frac12"], "1/2\n"),
        (&["polar", r"\frac12 t^2", "--at", r"\hat{1}, \frac12"], "f(hat(1), 1/2) = 1/4\n"),
        (&["polar", "a t^2", "--variable", r"\mathbf{t}"], "f(t1, t2) = a t1 t2\n"),
        (&["sum", "t^2", r"\frac12 t"], "h(t1, t2) = t1 t2 + 1/4 (t1 + t2)\n"),
        (&["matrix", "-n", "1", "--interval", r"0, \frac12"], "[1, 0; -2, 2]\n"),
        (&["matrix", "-n", "1", "--from", r"[lagrange, 0, \frac12]"], "[1, 0; -2, 2]\n"),
        (
            &["interpolate", "--nodes", r"0, \frac12", "--values", r"0, \frac14", "--at", r"\frac12"],
            "p(1/2) = 1/4\n",
        ),
        (&["check", r"\frac12 = 0.5"], "proved\n"),
    ] {
        let ran = run(arguments);
        assert_eq!((ran.out.as_str(), ran.status), (result, Some(0)), "{arguments:?}: {}", ran.err);
    }
    let plain = run(&["figure", "bezier", "0, 1, 4", "--at", "1/2", "--format", "json"]);
    let latex = run(&["figure", "bezier", "0, 1, 4", "--at", r"\frac12", "--format", "json"]);
    assert_eq!((latex.out, latex.status), (plain.out, Some(0)), "{}", latex.err);
}

/// The place that a message shows, and the line with the caret.
fn place(ran: &crate::common::Run) -> (String, String) {
    let line = |start: &str| ran.err.lines().find(|line| line.trim_start().starts_with(start));
    let caret = ran.err.lines().find(|line| line.contains('^')).unwrap_or_default();
    (line("--> ").unwrap_or_default().trim().to_owned(), caret.trim_start_matches([' ', '|']).to_owned())
}

#[test]
fn a_problem_is_shown_in_its_argument() {
    let curve = &["bezier", "0, 1, 4"][..];
    let spline = &["bspline", "-n", "2", "--knots", "0,0,0,1,2,2,2", "--points", "1,3,2,4"][..];
    for (start, more, at) in [
        (curve, &["--at", "1/2) + (100"][..], "<at>:1:4"),
        (curve, &["--at", "1/2, 1/3"], "<at>:1:1"),
        (curve, &["--at", "1/whoknows"], "<at>:1:3"),
        (curve, &["--at", r"1 + \farc{1}{2}"], "<at>:1:5"),
        (curve, &["--weights", "1, 1"], "<weights>:1:1"),
        (curve, &["--weights", "1], [2"], "<weights>:1:2"),
        (curve, &["--interval", "0, 1/0"], "<interval>:1:6"),
        (curve, &["--scheme", "1/2), (1"], "<scheme>:1:4"),
        (spline, &["--remove", "1"], "<remove>:1:1"),
        (spline, &["--insert", "7"], "<insert>:1:1"),
        (&["polar", "t^2"], &["--at", "0, 1/0"], "<at>:1:6"),
        (&["polar", "t^2"], &["--at", "1, degree = 2"], "<at>:1:4"),
        (&["polar", "t^2"], &["--at", "0, 1, 2"], "<at>:1:1"),
        (&["product", "t^2"], &["1/t"], "<G>:1:1"),
        (&["matrix", "-n", "2"], &["--from", "[bernstein, whoknows, 1]"], "<from>:1:13"),
        (&["interpolate", "--nodes", "0, 1"], &["--values", "1, 1/0"], "<values>:1:6"),
        (&["figure", "bezier", "0, 1, 4"], &["--at", "1/2, whoknows"], "<at>:1:6"),
        (&["figure", "basis", "3"], &["--hull"], "<hull>:1:1"),
    ] {
        let ran = run(&[start, more].concat());
        assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""), "{more:?}");
        assert_eq!(place(&ran).0, format!("--> {at}"), "{more:?}: {}", ran.err);
        assert!(place(&ran).1.starts_with('^'), "{more:?}: {}", ran.err);
    }
}

#[test]
fn lists_need_no_commas_where_nothing_is_in_doubt() {
    let polar = |at: &str| run(&["polar", "t^3 + t", "--at", at]).out;
    let value = polar("0, 0, 1");
    assert_eq!(value, "f(0, 0, 1) = 1/3\n");
    assert_eq!(polar("(0,0,1)"), value);
    assert_eq!(polar("0 0 1"), value);
    assert_eq!(polar("-1 0 1/2"), polar("-1, 0, 1/2"));
    assert_eq!(polar("0..2"), polar("0, 1, 2"));

    let knots =
        |knots: &str, points: &str| run(&["bspline", "-n", "2", "--knots", knots, "--points", points]).out;
    let spline = knots("0,0,0,1,1,1", "1,2,3");
    assert_eq!(spline, "bspline(2, [0, 0, 0, 1, 1, 1], [1, 2, 3])\n");
    for (list, points) in [("0 0 0 1 1 1", "1 2 3"), ("[0,0,0,1,1,1]", "1..3"), ("(0,0,0,1,1,1)", "1, 2, 3")]
    {
        assert_eq!(knots(list, points), spline, "{list}");
    }
    assert_eq!(knots("0..5", "1,2,3"), knots("0,1,2,3,4,5", "1,2,3"));
    assert_eq!(knots("0 0 0..2 2 2", "1,2,3,4"), knots("0,0,0,1,2,2,2", "1,2,3,4"));
    assert_eq!(knots("0,0,0,1,1,1", "[0,0] [1,2] [2,0]"), knots("0,0,0,1,1,1", "[0,0], [1,2], [2,0]"));
    assert_eq!(run(&["bezier", "(0,0) (1,2) (2,0)", "--at", "1/2"]).out, "(1, 1)\n");
    // One pair of brackets is a point, not a list of control points.
    assert_eq!(run(&["bezier", "[1, 2]"]).out, "bezier([(1, 2)])\n");

    // A sign might belong to an item.
    for at in ["1 -1", "0 1 -1"] {
        let ran = run(&["polar", "t^2", "--at", at]);
        assert_eq!(ran.status, Some(2));
        assert!(ran.err.contains("1, -1"), "the hint shows the commas: {}", ran.err);
        assert!(ran.err.contains("<at>:1:"), "{}", ran.err);
    }
    // A difference is one.
    assert_eq!(run(&["bezier", "0, 2", "--at", "3/2 - 1"]).out, "1\n");
}

#[test]
fn names_of_arguments_are_those_of_the_user() {
    // None of them means something that the program made.
    assert_eq!(run(&["polar", "t^2", "--at", "a, F"]).out, "f(a, F) = F a\n");
    assert_eq!(
        run(&["interpolate", "--nodes", "0,1", "--values", "0,1", "--at", "u + p"]).out,
        "p(u + p) = u + p\n"
    );
}

#[test]
fn depth_has_an_end() {
    let ran = run(&["eval", "1 + 1", "--max-depth=1000000"]);
    assert!(ran.err.contains("--max-depth") && ran.err.contains("20000"), "{}", ran.err);
    assert_eq!(run(&["eval", "1 + 1", "--max-depth=20000"]).out, "2\n");
    // What a call takes depends on its formula: the memory is bounded, too.
    let body = (0..60).fold("f(n-1)".to_owned(), |inner, _| format!("abs(1+{inner})"));
    let ran = run(&[
        "eval",
        &format!("f(n) := cases(0 if n <= 0, {body} otherwise); f(10^6)"),
        "--max-depth=20000",
    ]);
    assert_eq!((ran.status, ran.err.contains("too much memory")), (Some(2), true), "{}", ran.err);
}

/// Only what is printed of a row of binomials is made.
#[test]
fn polar_forms_of_huge_degree_are_printed_or_stopped() {
    let ran = run(&["eval", "polar(t^20000)"]);
    assert!(ran.out.starts_with("f(t1, t2,") && ran.out.ends_with(" t19999 t20000\n"));
    // The call on the left is not written as a formula, but like one.
    for query in ["polar(t^9 + t)", "g := polar(x_1^7)", "f_1 := polar(omega^8 - 1)"] {
        for format in ["text", "unicode", "latex"] {
            let call = |notation: &str| {
                let ran = run(&["eval", query, "--format", format, "--notation", notation, "--width", "0"]);
                ran.out.split_once(" = ").unwrap_or_else(|| panic!("{}{}", ran.out, ran.err)).0.to_owned()
            };
            assert_eq!(call("grouped"), call("sigma"), "{query} {format}");
        }
    }
    let ran = run(&["eval", "polar(t^100000 + t^50000)"]);
    assert!(ran.err.contains("terms, more than the limit of 4000000"), "{}", ran.err);
    let ran = run(&["eval", "polar(t^200000 + t^100000)", "--notation=ellipsis", "--timeout=0.2"]);
    assert!(ran.err.contains("time limit of 0.2 s"), "{}", ran.err);
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_printed_is_a_failure() {
    for argument in ["--help", "--version"] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let status = crate::common::command(&[argument]).stdout(full).status().unwrap();
        assert!(!status.success(), "{argument}");
    }
}

/// Whatever is read has an end, wherever its name is given.
#[cfg(target_os = "linux")]
#[test]
fn files_without_an_end_are_refused() {
    let folder = crate::common::folder::Folder::new("endless");
    let (page, zero) = (folder.write("a.md", "$1 + 1 = 2$\n"), "/dev/zero");
    let settings = ["context", "macros", "baseline"]
        .map(|key| folder.write(&format!("{key}.toml"), format!("[notes]\n{key} = '{zero}'\n")));
    let mut cases = vec![
        vec!["run", zero],
        vec!["weave", "/dev/zero"],
        vec!["notes", "check", &page, "--context", zero],
        vec!["notes", "check", &page, "--macros", zero],
        vec!["notes", "check", &page, "--config", zero],
        vec!["notes", "check", "--as", "markdown", zero],
    ];
    cases.extend(settings.iter().map(|path| vec!["notes", "check", &page, "--config", path]));
    for arguments in cases {
        let ran = run(&arguments);
        assert_eq!(ran.status, Some(2), "{arguments:?}: {}", ran.out);
        assert!(ran.err.contains("longer than 64 MiB"), "{arguments:?}: {}", ran.err);
    }
    for arguments in
        [vec!["run", "-"], vec!["weave", "-"], vec!["weave", "--mdbook"], vec!["notes", "check", "-"]]
    {
        let endless = std::fs::File::open(zero).unwrap();
        let output = crate::common::command(&arguments).stdin(endless).output().unwrap();
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(told.contains("longer than 64 MiB"), "{arguments:?}: {told}");
    }
}

/// A name with characters that a terminal obeys is shown without them.
#[cfg(unix)]
#[test]
fn names_of_files_are_shown_harmlessly() {
    let folder = crate::common::folder::Folder::new("names");
    let page = folder.write("a\u{1b}[31m\n.md", "{{ 1 + 1 }} and $1 + 1 = 2$\n");
    let missing = folder.path("b\u{1b}[31m.md");
    let report = folder.path("c\u{1b}[31m.json");
    for arguments in [
        vec!["weave", page.as_str()],
        vec!["weave", &missing],
        vec!["run", &missing],
        vec!["notes", "check", &page],
        vec!["notes", "check", &missing],
        vec!["notes", "check", &page, "--report", "json", "-o", &report],
        vec!["notes", "list", &page],
    ] {
        let ran = run(&arguments);
        assert!(
            !ran.out.contains('\u{1b}') && !ran.err.contains('\u{1b}'),
            "{arguments:?}: {}{}",
            ran.out,
            ran.err
        );
    }
}

#[test]
fn a_time_limit_is_a_number_of_seconds() {
    for wrong in ["--timeout=-1", "--timeout=nan", "--timeout=inf", "--timeout=-inf", "--timeout=soon"] {
        let ran = run(&["eval", "1 + 1", wrong]);
        assert_eq!((ran.status, ran.out.as_str()), (Some(2), ""), "{wrong}");
        assert!(ran.err.contains("--timeout") && ran.err.contains("seconds"), "{wrong}: {}", ran.err);
    }
    assert_eq!(run(&["eval", "1 + 1", "--timeout", "1e9"]).out, "2\n");
}

/// `--arrange`, the setting of the prompt and the option of a block choose how formulas are arranged.
#[test]
fn answers_are_arranged() {
    for (arrangement, answer) in [
        ("usual", "t^2 - 1"),
        ("collect", "t^2 - 1"),
        ("expand", "t^2 - 1"),
        ("factor", "(t - 1) (t + 1)"),
        ("in_powers", "t^2 - 1"),
        ("in_bernstein", "-B_0^2(t) - B_1^2(t)"),
    ] {
        assert_eq!(run(&["eval", "--arrange", arrangement, "(t - 1)(t + 1)"]).out.trim_end(), answer);
        let script = format!(":arrange {arrangement}\nt^2 - 1\n3 t\n:arrange usual\nt^2 - 1\n");
        let lines = run_with(&[], script.as_bytes()).out;
        assert_eq!((lines.lines().next(), lines.lines().last()), (Some(answer), Some("t^2 - 1")));
        let page = format!("{{{{ t }}}}\n\n```polarform arrange={arrangement}\nt^2 - 1\n```\n");
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("page.md");
        std::fs::write(&file, page).unwrap();
        let woven = run(&["weave", file.to_str().unwrap(), "-o", "-"]);
        assert!(woven.out.contains(&format!("$$\n{answer}\n$$")), "{}{}", woven.out, woven.err);
    }
    // What asks for its own arrangement keeps it; what has none is said.
    assert_eq!(run(&["eval", "--arrange", "expand", "factor(t^2 - 1)"]).out, "(t - 1) (t + 1)\n");
    let several = run(&["eval", "--arrange", "in_powers", "a b + a c"]);
    assert!(several.out == "a b + a c\n" && several.err.contains("arranged as usual"), "{}", several.err);
    assert_eq!(run(&["eval", "--arrange", "sorted", "t"]).status, Some(2));
}
