//! The language server, asked by a client over pipes. The protocol is spoken here by hand: headers, JSON, places in
//! UTF-16.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::common::command;
use crate::common::folder::Folder;

/// Nothing takes so long; a server that hangs fails the test.
const PATIENCE: Duration = Duration::from_secs(300);

/// An editor.
struct Client {
    child: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    /// Notifications that came while an answer was awaited.
    told: Vec<Value>,
    last: i64,
}

impl Client {
    fn start() -> Self {
        let mut child = command(&["lsp", "--stdio"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut output = BufReader::new(child.stdout.take().expect("it is piped"));
        let (sender, messages) = channel();
        thread::spawn(move || {
            loop {
                let mut header = String::new();
                if output.read_line(&mut header).expect("headers are text") == 0 {
                    return;
                }
                let length = header.strip_prefix("Content-Length: ").expect("the header has the length");
                let mut body = vec![0; length.trim_end().parse().expect("it is a number")];
                header.clear();
                output.read_line(&mut header).expect("headers are text");
                assert_eq!(header, "\r\n");
                output.read_exact(&mut body).expect("the message is as long as it says");
                if sender.send(serde_json::from_slice(&body).expect("it is JSON")).is_err() {
                    return;
                }
            }
        });
        let input = child.stdin.take();
        Client { child, input, messages, told: Vec::new(), last: 0 }
    }

    /// A client that has shaken hands.
    fn ready(capabilities: Value) -> Self {
        let mut client = Client::start();
        let answer = client
            .ask("initialize", json!({"processId": null, "rootUri": null, "capabilities": capabilities}));
        let can = &answer["result"]["capabilities"];
        assert_eq!((&can["textDocumentSync"]["change"], &can["hoverProvider"]), (&json!(1), &json!(true)));
        assert_eq!(answer["result"]["serverInfo"]["name"], "polarform");
        client.tell("initialized", json!({}));
        client
    }

    fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("it is open");
        input.write_all(bytes).and_then(|()| input.flush()).expect("the server reads");
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last += 1;
        let id = self.last;
        self.send(&json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}));
        loop {
            let message = self.messages.recv_timeout(PATIENCE).expect("the server answers");
            if message["id"] == id {
                return message;
            }
            self.told.push(message);
        }
    }

    /// The next notification of this kind.
    fn told(&mut self, method: &str) -> Value {
        if let Some(at) = self.told.iter().position(|message| message["method"] == method) {
            return self.told.remove(at)["params"].take();
        }
        loop {
            let mut message = self.messages.recv_timeout(PATIENCE).expect("the server tells");
            if message["method"] == method {
                return message["params"].take();
            }
            self.told.push(message);
        }
    }

    /// Opens a page; its diagnostics.
    fn open(&mut self, uri: &str, language: &str, text: &str) -> Value {
        let page = json!({"uri": uri, "languageId": language, "version": 1, "text": text});
        self.tell("textDocument/didOpen", json!({"textDocument": page}));
        self.diagnostics(uri, 1)
    }

    fn change(&mut self, uri: &str, version: i64, text: &str) {
        let page = json!({"uri": uri, "version": version});
        self.tell(
            "textDocument/didChange",
            json!({"textDocument": page, "contentChanges": [{"text": text}]}),
        );
    }

    fn diagnostics(&mut self, uri: &str, version: i64) -> Value {
        let mut told = self.told("textDocument/publishDiagnostics");
        assert_eq!((&told["uri"], &told["version"]), (&json!(uri), &json!(version)), "{told}");
        told["diagnostics"].take()
    }

    fn hover(&mut self, uri: &str, position: &Value) -> Value {
        let params = json!({"textDocument": {"uri": uri}, "position": position});
        self.ask("textDocument/hover", params)["result"].take()
    }

    fn actions(&mut self, uri: &str, range: &Value, context: Value) -> Vec<Value> {
        let params = json!({"textDocument": {"uri": uri}, "range": range, "context": context});
        let mut answer = self.ask("textDocument/codeAction", params);
        serde_json::from_value(answer["result"].take()).expect("a list")
    }

    /// Ends the server; its exit status.
    fn leave(mut self) -> Option<i32> {
        assert_eq!(self.ask("shutdown", Value::Null)["result"], Value::Null);
        assert_eq!(self.ask("textDocument/hover", json!({}))["error"]["code"], -32600);
        self.tell("exit", Value::Null);
        self.child.wait().expect("it ends").code()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The place of a byte, in UTF-16.
fn position(text: &str, byte: usize) -> Value {
    let line = text[..byte].matches('\n').count();
    let start = text[..byte].rfind('\n').map_or(0, |at| at + 1);
    json!({"line": line, "character": text[start..byte].encode_utf16().count()})
}

fn range(text: &str, part: &str) -> Value {
    let at = text.find(part).unwrap_or_else(|| panic!("{part:?} is not in the text"));
    json!({"start": position(text, at), "end": position(text, at + part.len())})
}

/// The byte of a place.
fn byte(text: &str, position: &Value) -> usize {
    let number = |name: &str| position[name].as_u64().expect("a number") as usize;
    let start: usize = text.split_inclusive('\n').take(number("line")).map(str::len).sum();
    let mut units = 0;
    for (at, c) in text[start..].char_indices() {
        if units == number("character") {
            return start + at;
        }
        units += c.len_utf16();
    }
    text.len()
}

/// The text with edits in it.
fn edited(text: &str, edits: &Value) -> String {
    let mut all: Vec<(usize, usize, &str)> = edits
        .as_array()
        .expect("a list")
        .iter()
        .map(|edit| {
            let place = |end: &str| byte(text, &edit["range"][end]);
            (place("start"), place("end"), edit["newText"].as_str().expect("a text"))
        })
        .collect();
    all.sort_unstable();
    let mut new = text.to_owned();
    for (start, end, put) in all.into_iter().rev() {
        new.replace_range(start..end, put);
    }
    new
}

/// Signs of two code units stand before the formulas; one is wrong, with a suggestion, one cannot be decided.
const PAGE: &str = "# 𝒇 und 设\n\nMit 𝒇 und 设 ist $F(t) = t^2 + 2t$, also 𝒇𝒇 $f(t_1, t_2) = t_1 t_2 + 2 t_1 + t_2$.\n\n\
                    Auch 😀 $2 + 2 = 5$ und $q(3) = 7$.\n";

#[test]
fn wrong_formulas_are_marked_explained_and_repaired() {
    let folder = Folder::new("lsp");
    let uri = format!("file://{}", folder.path("seite%20eins.md"));
    for versioned in [false, true] {
        let mut client = Client::ready(json!({
            "textDocument": {"hover": {"contentFormat": ["markdown", "plaintext"]}},
            "workspace": {"workspaceEdit": {"documentChanges": versioned}},
        }));
        let found = client.open(&uri, "markdown", PAGE);
        let marks = found.as_array().expect("a list");
        assert_eq!(marks.len(), 2, "{found}");
        let wrong = range(PAGE, "f(t_1, t_2) = t_1 t_2 + 2 t_1 + t_2");
        assert_eq!(marks[0]["range"], wrong);
        assert_eq!(marks[1]["range"], range(PAGE, "2 + 2 = 5"));
        for mark in marks {
            assert_eq!(
                (&mark["severity"], &mark["code"], &mark["source"]),
                (&json!(1), &json!("refuted"), &json!("polarform"))
            );
            assert!(mark["message"].as_str().is_some_and(|text| text.contains("suggestion: ")), "{mark}");
        }

        let hover = client.hover(&uri, &wrong["start"]);
        assert_eq!((&hover["range"], &hover["contents"]["kind"]), (&wrong, &json!("markdown")));
        let words = hover["contents"]["value"].as_str().expect("a text");
        for part in ["**refuted**", "counterexample", "suggestion", "assumed", "```latex\n"] {
            assert!(words.contains(part), "{part}: {words}");
        }
        let open = client.hover(&uri, &range(PAGE, "q(3) = 7")["end"]);
        assert!(!open["contents"]["value"].as_str().expect("a text").contains("refuted"), "{open}");
        assert_eq!(client.hover(&uri, &json!({"line": 0, "character": 0})), Value::Null);
        assert_eq!(client.hover(&uri, &json!({"line": 77, "character": 4_000_000_000_u32})), Value::Null);

        let actions = client.actions(&uri, &marks[1]["range"], json!({"diagnostics": [marks[1]]}));
        assert_eq!(actions.len(), 2, "{actions:?}");
        assert_eq!(
            (&actions[0]["kind"], &actions[0]["title"]),
            (&json!("quickfix"), &json!("Replace by 2 + 2 = 4"))
        );
        assert_eq!(actions[0]["diagnostics"][0], marks[1]);
        let edits = |action: &Value| match versioned {
            true => {
                let change = &action["edit"]["documentChanges"][0];
                assert_eq!(change["textDocument"], json!({"uri": uri, "version": 1}));
                change["edits"].clone()
            }
            false => action["edit"]["changes"][&uri].clone(),
        };
        assert_eq!(edited(PAGE, &edits(&actions[0])), PAGE.replace("2 + 2 = 5", "2 + 2 = 4"));
        let only = |kind: &str| json!({"diagnostics": [], "only": [kind]});
        assert_eq!(client.actions(&uri, &wrong, only("refactor")).len(), 0);
        let all = client.actions(&uri, &wrong, only("source"));
        assert_eq!(all.len(), 1, "{all:?}");
        assert_eq!(client.actions(&uri, &range(PAGE, "# 𝒇"), json!({"diagnostics": []})).len(), 0);

        // With all suggestions in it nothing is wrong any more.
        let repaired = edited(PAGE, &edits(&all[0]));
        assert!(repaired.contains("2 + 2 = 4") && !repaired.contains("2 t_1"), "{repaired}");
        client.change(&uri, 2, &repaired);
        assert_eq!(client.diagnostics(&uri, 2), json!([]));
        let hover = client.hover(&uri, &range(&repaired, "2 + 2 = 4")["start"]);
        assert!(
            hover["contents"]["value"].as_str().is_some_and(|text| text.starts_with("**proved**")),
            "{hover}"
        );
        // What is closed has no marks.
        client.tell("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
        assert_eq!(client.told("textDocument/publishDiagnostics")["diagnostics"], json!([]));
        assert_eq!(client.hover(&uri, &wrong["start"]), Value::Null);
        assert_eq!(client.leave(), Some(0));
    }
}

#[test]
fn marks_completions_and_results() {
    let folder = Folder::new("lsp-weave");
    let uri = format!("file://{}", folder.path("a.md"));
    let page = "# 𝒇\n\n```polarform\nf := polar(t^2 + 2t)\nfigure_basis(2)\n```\n\n\
                So $f(0,1) = {{ f(0, 1) }}$, $2 + 2 = 4$, 𝒇 $2 + 2 = 5$ and $\\sum_{i=0}^n \\binom{n}{i} = 2^n$.\n";
    for versioned in [false, true] {
        let mut client = Client::ready(json!({
            "workspace": {"workspaceEdit": {"documentChanges": versioned}, "inlayHint": {"refreshSupport": true}},
        }));
        client.open(&uri, "markdown", page);
        // A request of the server, which it need not be answered.
        assert_eq!(client.told("workspace/inlayHint/refresh"), Value::Null);
        let whole = json!({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}});
        let params = json!({"textDocument": {"uri": uri}, "range": whole});
        let hints = client.ask("textDocument/inlayHint", params)["result"].take();
        let labels: Vec<&str> =
            hints.as_array().expect("a list").iter().map(|hint| hint["label"].as_str().unwrap()).collect();
        assert_eq!(labels, ["✓", "✓", "✗", "✓"], "{hints}");
        assert_eq!(hints[2]["position"], range(page, "2 + 2 = 5")["end"]);
        assert!(
            hints[2]["tooltip"]["value"].as_str().is_some_and(|told| told.starts_with("refuted")),
            "{hints}"
        );
        let line = json!({"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 0}});
        let params = json!({"textDocument": {"uri": uri}, "range": line});
        assert_eq!(client.ask("textDocument/inlayHint", params)["result"], json!([]));

        let place = range(page, "f(0, 1) }}")["start"].clone();
        let params = json!({"textDocument": {"uri": uri}, "position": place});
        let found = client.ask("textDocument/completion", params)["result"].take();
        let names: Vec<&str> =
            found.as_array().expect("a list").iter().map(|item| item["label"].as_str().unwrap()).collect();
        assert!(names[0] == "f" && names.contains(&"polar"), "{names:?}");
        assert_eq!(found[0]["textEdit"]["range"]["start"], place);
        let params = json!({"textDocument": {"uri": uri}, "position": {"line": 0, "character": 1}});
        assert_eq!(client.ask("textDocument/completion", params)["result"], json!([]));

        let only = json!({"diagnostics": [], "only": ["source.polarform.weave"]});
        let actions = client.actions(&uri, &line, only);
        assert_eq!(actions.len(), 1, "{actions:?}");
        let command = &actions[0]["command"];
        let params = json!({"command": command["command"], "arguments": command["arguments"]});
        assert_eq!(client.ask("workspace/executeCommand", params)["result"], Value::Null);
        let edit = client.told("workspace/applyEdit")["edit"].take();
        let edits = match versioned {
            true => edit["documentChanges"][0]["edits"].clone(),
            false => edit["changes"][&uri].clone(),
        };
        // The program itself is the other way to the same page.
        let file = folder.write("a.md", page);
        crate::common::run(&["weave", "--quiet", &file]);
        let woven = folder.read("a.md");
        assert!(woven.contains("$f(0,1) = 1$<!--") && woven.contains("a-figure-1.svg"), "{woven}");
        assert_eq!(edited(page, &edits), woven);
        assert!(folder.read("a-figure-1.svg").starts_with("<svg"));

        client.change(&uri, 2, "{{ 1/0 }} and {{ 1 + 1 }}");
        let params = json!({"command": "polarform.weave", "arguments": [uri]});
        client.ask("workspace/executeCommand", params);
        let edit = client.told("workspace/applyEdit");
        assert!(edit.to_string().contains("$2$<!--"), "{edit}");
        let said = client.told("window/showMessage");
        assert!(
            said["message"].as_str().is_some_and(|text| text.contains("line 1: division by zero")),
            "{said}"
        );
        for arguments in [json!([]), json!(["untitled:none"]), json!([3])] {
            client.ask(
                "workspace/executeCommand",
                json!({"command": "polarform.weave", "arguments": arguments}),
            );
            client.told("window/logMessage");
        }
        assert_eq!(client.leave(), Some(0));
    }
}

#[test]
fn results_of_notebooks_and_latex() {
    let folder = Folder::new("lsp-weave-others");
    let notebook = r#"{"cells": [{"cell_type": "markdown", "source": ["so $1 + 1 = {{ 1 + 1 }}$\n"]}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}"#;
    let latex = "\\documentclass{article}\\usepackage{polarform}\n\\begin{document}\n$1 + 2 = \\polarform{1 + 2}$\n\\end{document}\n";
    let whole = json!({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}});
    let mut client = Client::ready(json!({}));
    let fill = |client: &mut Client, uri: &str, language: &str, page: &str| {
        client.open(uri, language, page);
        let only = json!({"diagnostics": [], "only": ["source.polarform.weave"]});
        let offered = client.actions(uri, &whole, only).len();
        client.ask("workspace/executeCommand", json!({"command": "polarform.weave", "arguments": [uri]}));
        offered
    };
    let file = |name: &str| format!("file://{}", folder.path(name));
    assert_eq!(fill(&mut client, &file("a.ipynb"), "json", notebook), 1);
    let edit = client.told("workspace/applyEdit")["edit"].take();
    assert!(edit.to_string().contains("$<!-- $1 + 1 = {{ 1 + 1 }}$ -->"), "{edit}");
    // Its results stand beside it, as those of the program do, also before it is saved.
    assert_eq!(fill(&mut client, &file("b.tex"), "latex", latex), 1);
    // A document that is nowhere has no place for them, and a page without a query no action.
    assert_eq!(fill(&mut client, "untitled:c", "latex", latex), 1);
    let said = client.told("window/showMessage");
    assert!(said["message"].as_str().is_some_and(|text| text.contains("save the document first")), "{said}");
    let by_program = Folder::new("lsp-weave-program");
    let other = by_program.write("b.tex", latex);
    crate::common::run(&["weave", "--quiet", &other]);
    let wait = std::time::Instant::now();
    while !std::path::Path::new(&folder.path("b.polarform.tex")).exists()
        && wait.elapsed() < Duration::from_secs(20)
    {
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(folder.read("b.polarform.tex"), by_program.read("b.polarform.tex"));
    assert!(folder.read("b.polarform.tex").contains("{1 + 2}{3}"));
    assert_eq!(fill(&mut client, &file("e.tex"), "latex", "$1 + 1 = 2$"), 0);
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn an_edit_is_answered_before_the_page_is_judged_anew() {
    let mut client = Client::ready(json!({}));
    let uri = "untitled:long";
    let claim = |k: usize| {
        format!(
            "Then $\\sum_{{i=0}}^n \\binom{{n}}{{i}} B_i^n(t) = \\sum_{{j=0}}^n \\binom{{n}}{{j}} B_j^n(t) + {k} - {k}$.\n\n"
        )
    };
    let page = |typed: &str| {
        (0..40).map(claim).collect::<String>() + typed + "\n\n" + &(40..80).map(claim).collect::<String>()
    };
    client.open(uri, "markdown", &page("Now $2 + 2 = 4$."));
    client.change(uri, 2, &page("Now $2 + 2 = 5$."));
    // Perhaps the verdicts from before are told once more meanwhile.
    let found = client.diagnostics(uri, 2);
    let found = if found == json!([]) { client.diagnostics(uri, 2) } else { found };
    assert_eq!(found.as_array().map(Vec::len), Some(1), "{found}");
    // It was told with the verdicts of the last check on all that follows.
    let place = json!({"line": 120, "character": 8});
    let hover = client.hover(uri, &place);
    assert!(hover["contents"]["value"].as_str().is_some_and(|told| !told.starts_with("refuted")), "{hover}");
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn pages_of_all_kinds() {
    let folder = Folder::new("lsp-kinds");
    folder.write("macros.tex", "\\newcommand{\\twice}[1]{2 \\cdot #1}\n");
    folder.write("part.tex", "\\newcommand{\\thrice}[1]{3 \\cdot #1}\n");
    folder.write("polarform.toml", "[notes]\nmacros = \"macros.tex\"\nignore = [\"suspicious\"]\n");
    let mut client = Client::ready(json!({}));
    let tex = "\\input{part}\n\\begin{document}\n% $2 + 2 = 3$\n\\[ \\twice{2} = 5, \\quad \\thrice{1} = 3 \\]\n\\end{document}\n";
    let rst = "Title\n=====\n\n:math:`2 + 2 = 5` and\n\n.. math::\n\n   1 + 1 = 2\n";
    let notebook = json!({"cells": [{"cell_type": "markdown", "metadata": {}, "source": ["$2 + 2 = 5$"]}],
        "metadata": {}, "nbformat": 4, "nbformat_minor": 5});
    for (name, language, text, wrong) in [
        ("a.tex", "latex", tex, "\\twice{2} = 5"),
        ("a.txt", "plaintext", "We know that 2 + 2 = 5 and 1 + 1 = 2.\r\n", "2 + 2 = 5"),
        ("a.rst", "restructuredtext", rst, "2 + 2 = 5"),
        ("a.ipynb", "json", notebook.to_string().as_str(), "2 + 2 = 5"),
        ("a", "latex", "\\(2 + 2 = 5\\)", "2 + 2 = 5"),
    ] {
        let uri = format!("file://{}", folder.path(name));
        let found = client.open(&uri, language, text);
        assert_eq!(found.as_array().map(Vec::len), Some(1), "{name}: {found}");
        assert_eq!(found[0]["range"], range(text, wrong), "{name}: {found}");
    }
    // Pages that are no files.
    let found = client.open("untitled:Untitled-1", "latex", "\\[ 2 + 2 = 5 \\] % $2 + 2 = 6$");
    assert_eq!(found.as_array().map(Vec::len), Some(1), "{found}");
    // Files of other kinds say so once.
    let found = client.open(&format!("file://{}", folder.path("a.docx")), "docx", "$1 = 2$");
    assert_eq!((&found[0]["code"], found.as_array().map(Vec::len)), (&json!("E609"), Some(1)), "{found}");
    // Without formats that it knows, a client gets plain text.
    let hover = client.hover("untitled:Untitled-1", &json!({"line": 0, "character": 3}));
    assert_eq!(hover["contents"]["kind"], "plaintext");
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.starts_with("refuted: ")), "{hover}");
    // Settings that are wrong are told, and the page is checked without them; saving them checks all pages anew.
    folder.write("polarform.toml", "[notes]\nmacro = 3\n");
    client.tell("textDocument/didSave", json!({"textDocument": {"uri": "file:///polarform.toml"}}));
    let said = client.told("window/logMessage");
    assert!(said["message"].as_str().is_some_and(|text| text.contains("no setting 'macro'")), "{said}");
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn an_edit_ends_the_check_before_it() {
    let mut client = Client::ready(json!({}));
    let uri = "untitled:a";
    // To check this takes far longer than anybody waits.
    let line = "Then $\\sum_{i=0}^{n} \\binom{n}{i} B_i^n(t) B_{n-i}^n(s) = \\sum_{j=0}^n B_j^n(s) \\binom{n}{j} B_{n-j}^n(t)$.\n\n";
    let long = line.repeat(1_000);
    let page = json!({"uri": uri, "languageId": "markdown", "version": 1, "text": long});
    client.tell("textDocument/didOpen", json!({"textDocument": page}));
    // While it is checked, questions are answered.
    thread::sleep(Duration::from_millis(1000));
    assert_eq!(client.hover(uri, &json!({"line": 0, "character": 8})), Value::Null);
    for version in 2..5 {
        client.change(uri, version, &format!("{long}$2 + 2 = 1{version}$"));
    }
    client.change(uri, 5, "$2 + 2 = 5$");
    let found = client.diagnostics(uri, 5);
    assert_eq!(found.as_array().map(Vec::len), Some(1), "{found}");
    // Nothing comes of the texts before, also later.
    let more = client.messages.recv_timeout(Duration::from_millis(500));
    assert_eq!(more, Err(RecvTimeoutError::Timeout));
    // And the server ends while it is at work.
    client.change(uri, 6, &long);
    thread::sleep(Duration::from_millis(300));
    assert_eq!(client.leave(), Some(0));
}

#[test]
fn nonsense_does_no_harm() {
    let mut client = Client::start();
    assert_eq!(client.ask("textDocument/hover", json!({}))["error"]["code"], -32002);
    client.tell("textDocument/didOpen", json!({}));
    drop(client);

    let mut client = Client::ready(json!({}));
    client.raw(b"Content-Length: 5\r\n\r\n{\"a\":garbage\r\n\r\n");
    assert!(
        client.told("window/logMessage")["message"].as_str().is_some_and(|text| text.contains("no message"))
    );
    client.raw("Content-Length: 99999999999999999999999\r\n\r\n".as_bytes());
    let deep = "[".repeat(100_000);
    client.raw(format!("Content-Length: {}\r\n\r\n{deep}", deep.len()).as_bytes());
    client.told("window/logMessage");
    for params in
        [json!(null), json!([]), json!({"textDocument": 3}), json!({"textDocument": {"uri": "no address"}})]
    {
        for method in [
            "textDocument/didOpen",
            "textDocument/didChange",
            "textDocument/didClose",
            "textDocument/didSave",
        ] {
            client.tell(method, params.clone());
            assert!(
                client.told("window/logMessage")["message"]
                    .as_str()
                    .is_some_and(|text| text.contains(method))
            );
        }
        for method in ["textDocument/hover", "textDocument/codeAction"] {
            assert_eq!(client.ask(method, params.clone())["error"]["code"], -32602);
        }
    }
    client.tell("$/setTrace", json!({"value": "off"}));
    client.tell(
        "textDocument/didChange",
        json!({"textDocument": {"uri": "untitled:none", "version": 1}, "contentChanges": []}),
    );
    assert_eq!(client.ask("textDocument/rename", json!({}))["error"]["code"], -32601);
    assert_eq!(client.ask("initialize", json!({"capabilities": {}}))["error"]["code"], -32600);
    // A page that is too long is not read; one line may be long.
    let found = client.open("untitled:long", "markdown", &"$1 = 2$ ".repeat(400_000));
    assert_eq!((found.as_array().map(Vec::len), &found[0]["severity"]), (Some(1), &json!(3)));
    let wide = "𝒇 words ".repeat(20_000) + "$2 + 2 = 5$";
    let found = client.open("untitled:wide", "markdown", &wide);
    assert_eq!(found[0]["range"], range(&wide, "2 + 2 = 5"));
    let strange = "$\\frac{$ \u{0} \u{feff} $$ \\begin{align} & \\\\ \\end $1 = 2$ `$` \r \u{2028}";
    client.open("untitled:strange", "markdown", strange);
    let found = client.open("untitled:mark", "markdown", "\u{feff}$2 + 2 = 5$");
    assert_eq!(found.as_array().map(Vec::len), Some(1), "{found}");
    assert_ne!(client.hover("untitled:mark", &json!({"line": 0, "character": 8})), Value::Null);
    assert_eq!(client.leave(), Some(0));

    // Without a farewell it ends with the input, and says that something is wrong.
    let mut client = Client::ready(json!({}));
    drop(client.input.take());
    assert_eq!(client.child.wait().expect("it ends").code(), Some(1));
    let mut client = Client::ready(json!({}));
    client.tell("exit", Value::Null);
    assert_eq!(client.child.wait().expect("it ends").code(), Some(1));
}

#[test]
fn marks_wait_for_the_verdicts() {
    let uri = "untitled:a.md";
    let mut client = Client::ready(json!({"workspace": {"inlayHint": {"refreshSupport": true}}}));
    let whole = json!({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}});
    let params = json!({"textDocument": {"uri": uri}, "range": whole});
    let marks = |client: &mut Client| -> Vec<String> {
        let hints = client.ask("textDocument/inlayHint", params.clone())["result"].take();
        let label = |hint: &Value| hint["label"].as_str().expect("a mark").to_owned();
        hints.as_array().expect("a list").iter().map(label).collect()
    };
    assert_eq!(marks(&mut client), [""; 0]);
    // Editors ask at once, and draw what they get for a text once.
    let page =
        json!({"uri": uri, "languageId": "markdown", "version": 1, "text": "$2 + 2 = 5$, $1 + 1 = 2$\n"});
    client.tell("textDocument/didOpen", json!({"textDocument": page}));
    assert_eq!(marks(&mut client), ["✗", "✓"]);
    client.change(uri, 2, "$2 + 2 = 4$, $1 + 1 = 2$, $1 + 1 = 3$\n");
    assert_eq!(marks(&mut client), ["✓", "✓", "✗"]);
    // Who asks for a text that is edited or closed meanwhile gets an answer, too.
    client.change(uri, 3, "$1 + 1 = 3$\n");
    client
        .send(&json!({"jsonrpc": "2.0", "id": "late", "method": "textDocument/inlayHint", "params": params}));
    client.tell("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
    assert_eq!(marks(&mut client), [""; 0]);
    assert!(client.told.iter().any(|message| message["id"] == "late" && message["result"].is_array()));
    assert_eq!(client.leave(), Some(0));
}
