//! polarform for hosts that can run WebAssembly: a page in a browser, and Typst.
//!
//! A host sends a request as JSON and gets an answer as JSON; see [`answer`]. All that is decided is decided by the
//! library. The module needs nothing of its host: no clock, no files, no network, no random numbers. Limits
//! count steps, and a passed one unwinds as in the program.

mod ask;
mod check;
#[cfg(target_family = "wasm")]
mod exports;
mod play;
#[cfg(any(target_family = "wasm", test))]
mod pool;
mod told;
mod typst;

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use polarform::session::{Session, completions};
use serde_json::{Map, Value, json};

#[cfg(target_family = "wasm")]
#[global_allocator]
static POOL: pool::Pool = pool::Pool::new();

/// Functions may call each other so deeply: each call takes a part of the stack, and that of a worker is small.
const DEPTH: usize = 150;

/// The fields of a request.
type Request = Map<String, Value>;

/// Why a request has no answer, in words.
type Refusal = String;

thread_local! {
    /// The session of requests that bring none.
    static SESSION: RefCell<Session> = RefCell::new(ask::session(DEPTH));
}

/// The answer to a request, both as JSON. A request says in `do` what it wants:
///
/// | `do` | further fields | answer |
/// | --- | --- | --- |
/// | `ask` | `input`; `session`: earlier inputs, in place of those asked before; `lang`, `notation`, `depth` | `answers`, `problem`, `names` |
/// | `check` | `text`, `as`: markdown, latex, rst, notebook, else it is guessed; `name`, `context`, `steps`, `depth`; `again`: the page of the last such request was edited | the report of `notes check` with places |
/// | `complete` | `before`: the line up to the caret | `from`, `candidates` |
/// | `incomplete` | `input` | `incomplete`: whether a bracket is open or a side is missing |
/// | `play` | `kind`: bezier or bspline; `points`, `t`, `ends` or `knots` and `degree` | every level, labelled |
/// | `reset` | | forgets the session |
///
/// What cannot be answered is `{"refused": words}`. Places count UTF-16 code units, as text in a browser does.
///
/// ```
/// let answer = polarform_web::answer(r#"{"do": "ask", "input": "polar(t^2)(0, 1)"}"#);
/// assert!(answer.contains(r#""text":"0""#), "{answer}");
/// assert!(polarform_web::answer("nonsense").contains("refused"));
/// ```
pub fn answer(request: &str) -> String {
    answer_telling(request, &mut |_| {})
}

/// The same; of a page that is checked again, what was found so far is told before: reports with `"partial": true`.
pub fn answer_telling(request: &str, tell: &mut dyn FnMut(&str)) -> String {
    let mut tell = |partial: Value| tell(&partial.to_string());
    let answered = catch_unwind(AssertUnwindSafe(|| answered(request, &mut tell)));
    let refused = |words: Refusal| json!({"refused": words});
    match answered {
        Ok(answer) => answer.unwrap_or_else(refused),
        Err(_) => {
            refused("polarform met a defect of its own; please report the input that led here".to_owned())
        }
    }
    .to_string()
}

fn answered(request: &str, tell: &mut dyn FnMut(Value)) -> Result<Value, Refusal> {
    let request: Value = serde_json::from_str(request).map_err(|error| format!("not a request: {error}"))?;
    let request = request.as_object().ok_or("a request is an object")?;
    match field(request, "do")? {
        "ask" => match ask::earlier(request)? {
            None => SESSION.with_borrow_mut(|session| ask::answer(session, request)),
            Some(mut session) => ask::answer(&mut session, request),
        },
        "check" => check::report(request, tell),
        "complete" => {
            let before = field(request, "before")?;
            let names = SESSION.with_borrow(Session::names);
            let (start, list) = completions(before, &names);
            let list: Vec<Value> = list
                .into_iter()
                .map(|candidate| json!({"shown": candidate.shown, "put": candidate.put}))
                .collect();
            Ok(json!({"from": told::units(before, start), "candidates": list}))
        }
        "incomplete" => {
            let input = field(request, "input")?;
            let latex = polarform::syntax::looks_like_latex(input);
            Ok(json!({"incomplete": !latex && polarform::syntax::is_incomplete(input)}))
        }
        "play" => play::scheme(request),
        "reset" => {
            SESSION.set(ask::session(DEPTH));
            Ok(json!({}))
        }
        other => Err(format!("there is nothing to do called {other}")),
    }
}

/// A text that a request must have.
fn field<'a>(request: &'a Request, name: &str) -> Result<&'a str, Refusal> {
    request.get(name).and_then(Value::as_str).ok_or_else(|| format!("the request has no text \"{name}\""))
}

/// A text that it may have.
fn optional<'a>(request: &'a Request, name: &str) -> Option<&'a str> {
    request.get(name).and_then(Value::as_str)
}

/// How deeply functions may call each other: a host with a smaller stack says so.
fn depth(request: &Request) -> usize {
    let asked = request.get("depth").and_then(Value::as_u64).and_then(|depth| usize::try_from(depth).ok());
    asked.unwrap_or(DEPTH).min(DEPTH)
}

/// A text of at most so many bytes.
fn bounded<'a>(text: &'a str, most: usize, what: &str) -> Result<&'a str, Refusal> {
    if text.len() > most {
        return Err(format!(
            "{what} has {} kB, and more than {} kB are not read",
            text.len() >> 10,
            most >> 10
        ));
    }
    Ok(text)
}
