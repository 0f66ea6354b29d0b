//! The commands for lecture notes: streams, exit status, output files, watching.

use std::fs;

use crate::common::folder::Folder;
use crate::common::run;

#[test]
fn what_cannot_be_read_does_not_spoil_the_rest() {
    let folder = Folder::new("unread");
    let good = folder.write("good.md", "Words only.\n");
    let missing = folder.path("missing.md");
    fs::create_dir(folder.path("empty")).expect("it can be made");
    let ran = run(&["notes", "check", &good, &missing, &folder.path("empty")]);
    assert_eq!(ran.status, Some(2), "{}", ran.err);
    assert!(ran.out.contains("good.md") && ran.out.contains("total"), "{}", ran.out);
    assert!(ran.err.contains("missing.md"), "{}", ran.err);
    assert!(ran.err.contains("is a directory without notes"), "{}", ran.err);
    assert_eq!(run(&["notes", "list", &missing]).status, Some(2));
    assert_eq!(run(&["notes", "check", &good]).status, Some(0));
    assert_eq!(run(&["notes", "list", &good]).status, Some(0));

    let ran = run(&["notes", "check", &good, &missing, "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&ran.out).expect("it is JSON");
    assert_eq!(json["files"][1]["problems"][0]["code"], "E501");
    assert_eq!(json["summary"]["refuted"], 0);
}

#[test]
fn reports_go_where_they_are_wanted() {
    let folder = Folder::new("output");
    let notes = folder.write("notes.md", "Words only.\n");
    for (name, start) in [("a.html", "<!DOCTYPE html>"), ("a.json", "{"), ("a.sarif", "{"), ("a.txt", &notes)]
    {
        let target = folder.path(name);
        let ran = run(&["notes", "check", &notes, "-o", &target]);
        assert_eq!(ran.status, Some(0), "{}", ran.err);
        assert!(ran.out.ends_with(&format!("written to {target}\n")), "{}", ran.out);
        let text = fs::read_to_string(&target).expect("it was written");
        assert!(text.starts_with(start), "{text}");
    }
    let sarif = fs::read_to_string(folder.path("a.sarif")).expect("it was written");
    assert!(sarif.contains("\"version\": \"2.1.0\""));
    let ran = run(&["notes", "check", &notes, "--report", "html"]);
    assert!(ran.out.starts_with("<!DOCTYPE html>") && ran.err.is_empty());
}

#[test]
fn bad_usage_is_refused() {
    let folder = Folder::new("usage");
    let notes = folder.write("notes.md", "Words only.\n");
    let unreachable = folder.path("none/a.html");
    let none = folder.path("none.txt");
    for arguments in [
        &["notes"][..],
        &["notes", "check"],
        &["notes", "check", &notes, "-o", &notes],
        &["notes", "check", &notes, "-o", &unreachable],
        &["notes", "check", &notes, "--context", &none],
        &["notes", "check", &notes, "--format", "sympy"],
        &["notes", "list", &notes, "--format", "sympy"],
        &["notes", "check", &notes, "--jobs", "0"],
        &["notes", "check", &notes, "--report", "pdf"],
    ] {
        let ran = run(arguments);
        assert_eq!(ran.status, Some(2), "{arguments:?}: {}", ran.out);
        assert!(ran.out.is_empty() && !ran.err.is_empty(), "{arguments:?}");
    }
    assert_eq!(fs::read_to_string(&notes).expect("it is still there"), "Words only.\n");
}

#[cfg(unix)]
#[test]
fn watching_sees_replaced_files_until_it_is_interrupted() {
    use std::io::{BufRead, BufReader};
    use std::process::{Command, Stdio};

    let folder = Folder::new("watch");
    let notes = folder.write("notes.md", "Words only.\n");
    let mut child = crate::common::command(&["notes", "check", &notes, "--watch"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let errors = BufReader::new(child.stderr.take().expect("it is piped"));
    let mut lines = errors.lines().map(|line| line.expect("messages are UTF-8"));
    let mut until = |part: &str| assert!(lines.any(|line| line.contains(part)), "no message with {part:?}");
    until("watching 1 file");
    for _ in 0..2 {
        let new = folder.write("notes.md.new", "Other words.\n");
        fs::rename(new, &notes).expect("it can be renamed");
        until("notes.md changed");
        until("watching 1 file");
    }
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(interrupt.is_ok_and(|status| status.success()));
    let ran = child.wait_with_output().expect("the program ends");
    assert_eq!(ran.status.code(), Some(0));
    let reports = String::from_utf8(ran.stdout).expect("results are UTF-8");
    assert_eq!(reports.matches("nothing to judge").count(), 3, "{reports}");
}
