//! `polarform lsp`: a language server for pages of notes.
//!
//! Editors send the text of each open page; a thread checks it ([`checker`]) and sends diagnostics. Questions about
//! it are answered from the last check, as long as the page is still the same: an answer never speaks of a text that
//! has changed.
//!
//! Reference: Language Server Protocol 3.17. Places are in UTF-16 code units, which every client knows.

mod answers;
mod checker;
mod completion;
mod places;
mod transport;
mod weaving;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;

use lsp_server::{Connection, ErrorCode, ExtractError, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, DidSaveTextDocument, Exit, LogMessage,
    Notification as _, PublishDiagnostics, ShowMessage,
};
use lsp_types::request::{
    ApplyWorkspaceEdit, CodeActionRequest, Completion, ExecuteCommand, HoverRequest, Initialize,
    InlayHintRefreshRequest, InlayHintRequest, Request as _, Shutdown,
};
use lsp_types::{
    ApplyWorkspaceEditParams, CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams,
    CompletionOptions, CompletionParams, CompletionResponse, ExecuteCommandOptions, ExecuteCommandParams,
    HoverParams, HoverProviderCapability, InitializeParams, InitializeResult, InlayHint, InlayHintParams,
    LogMessageParams, MarkupKind, MessageType, OneOf, PublishDiagnosticsParams, SaveOptions,
    ServerCapabilities, ServerInfo, ShowMessageParams, TextDocumentSyncCapability, TextDocumentSyncKind,
    TextDocumentSyncOptions, Uri,
};

use super::Status;
use super::arguments::Global;
use super::commands::{Ran, Stop};
use super::output::Trouble;
use crate::budget::Limits;
use crate::document::Container;
use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic};
use answers::workspace_edit;
use checker::{Checked, Job};
use places::Places;

/// A page that an editor has open.
struct Page {
    version: i32,
    text: String,
    path: Option<PathBuf>,
    kind: Option<Container>,
    /// Ends the check of the text before.
    outdated: Arc<AtomicBool>,
    /// What was found last; of the text before, as long as this one is checked.
    checked: Option<Checked>,
    /// The diagnostics that the client has.
    told: Option<(i32, Vec<lsp_types::Diagnostic>)>,
    /// Marks that the client asked for and has not got.
    asked: Vec<(RequestId, lsp_types::Range)>,
}

impl Page {
    /// What was found in the text that the editor has.
    fn current(&self) -> Option<&Checked> {
        self.checked.as_ref().filter(|checked| checked.version == self.version)
    }

    /// Answers to all who asked for marks, once the whole of the text is judged. Before, there would be none, and editors
    /// draw those of a version once: Neovim passes over others that come for it later.
    fn marks_due(&mut self, markdown: bool) -> Vec<Message> {
        let Some(checked) =
            self.checked.as_ref().filter(|found| found.whole && found.version == self.version)
        else {
            return Vec::new();
        };
        let answer = |(id, range): (RequestId, lsp_types::Range)| {
            let between = Span::new(checked.byte(range.start), checked.byte(range.end));
            Response::new_ok(id, checked.hints(between, markdown)).into()
        };
        self.asked.drain(..).map(answer).collect()
    }

    /// How it is written.
    fn written(&self) -> Container {
        let kind = self.kind.or_else(|| Container::of(self.path.as_deref()?).ok());
        kind.unwrap_or(Container::Markdown)
    }
}

type Pages = Arc<Mutex<BTreeMap<String, Page>>>;

/// A defect in one thread does not end the other.
fn locked(pages: &Pages) -> MutexGuard<'_, BTreeMap<String, Page>> {
    pages.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the client can do.
#[derive(Default)]
struct Client {
    initialized: bool,
    markdown: Arc<AtomicBool>,
    versioned: bool,
    leaving: bool,
    /// Whether it asks again for marks when it is told to.
    refreshes: Arc<AtomicBool>,
}

struct Server {
    pages: Pages,
    jobs: Sender<Job>,
    client: Client,
    out: Connection,
    limits: Limits,
}

/// Serves an editor on standard input and output until it says that it leaves.
pub(super) fn run(global: &Global, seconds: f64) -> Ran {
    let (connection, writer) = transport::stdio();
    let pages = Pages::default();
    let client = Client::default();
    let (checked, sender) = (pages.clone(), connection.sender.clone());
    let (refreshes, markdown) = (client.refreshes.clone(), client.markdown.clone());
    let done = move |found: Checked| {
        let mut pages = locked(&checked);
        // A page may have been closed, or edited since the last look.
        let Some(page) = pages.get_mut(&found.uri).filter(|page| page.version == found.version) else {
            return;
        };
        let said = found.remark.as_ref().map(|remark| log(remark));
        let new = Some((found.version, found.diagnostics()));
        let changed = (page.told != new).then(|| found.uri.parse().ok()).flatten().zip(new.clone());
        let marks = changed.map(|(uri, (version, found))| marks(uri, found, Some(version)));
        page.told = new;
        let again = (found.whole && refreshes.load(Ordering::Relaxed)).then(|| {
            Request::new("marks".to_owned().into(), InlayHintRefreshRequest::METHOD.to_owned(), ()).into()
        });
        page.checked = Some(found);
        let due = page.marks_due(markdown.load(Ordering::Relaxed));
        for message in said.into_iter().chain(marks).chain(due).chain(again) {
            // When the client is gone the server ends.
            let _ = sender.send(message);
        }
    };
    let limits = global.limits_or(seconds);
    let jobs = checker::start(limits.clone(), done).map_err(|error| {
        let message = format!("cannot start a thread: {error}");
        Stop::Trouble(Trouble::Problem(Box::new(Diagnostic::error(Code::Internal, message))))
    })?;
    let mut server = Server { pages, jobs, client, out: connection, limits };
    let status = server.serve();
    server.stop_all();
    drop(server);
    // The checker holds a sender, too, until its last check has noticed that it is not wanted.
    let _ = writer.join();
    Ok(status)
}

impl Server {
    /// Answers until the end; without a farewell the status is a failure.
    fn serve(&mut self) -> Status {
        while let Ok(message) = self.out.receiver.recv() {
            match message {
                Message::Request(request) => {
                    if let Some(response) = self.request(request) {
                        self.send(response.into());
                    }
                }
                Message::Notification(notification) if notification.method == Exit::METHOD => break,
                Message::Notification(notification) => self.notification(notification),
                Message::Response(_) => {}
            }
        }
        if self.client.leaving { Status::Fine } else { Status::Refuted }
    }

    fn send(&self, message: Message) {
        // When the client is gone the next reading ends the server.
        let _ = self.out.sender.send(message);
    }

    /// The answer to a request, if it can be given now.
    fn request(&mut self, request: Request) -> Option<Response> {
        let id = request.id.clone();
        let refused = |code: ErrorCode, why: &str| Response::new_err(id.clone(), code as i32, why.to_owned());
        Some(match request.method.as_str() {
            Initialize::METHOD if self.client.initialized => {
                refused(ErrorCode::InvalidRequest, "the server is initialized already")
            }
            Initialize::METHOD => answered::<Initialize>(request, |params| self.initialize(&params)),
            _ if !self.client.initialized => {
                refused(ErrorCode::ServerNotInitialized, "initialize comes first")
            }
            _ if self.client.leaving => refused(ErrorCode::InvalidRequest, "the server is shutting down"),
            Shutdown::METHOD => {
                self.client.leaving = true;
                Response::new_ok(request.id, ())
            }
            HoverRequest::METHOD => answered::<HoverRequest>(request, |params| self.hover(&params)),
            CodeActionRequest::METHOD => {
                answered::<CodeActionRequest>(request, |params| Some(self.actions(&params)))
            }
            InlayHintRequest::METHOD => return self.hints(request),
            Completion::METHOD => answered::<Completion>(request, |params| self.completions(&params)),
            ExecuteCommand::METHOD => answered::<ExecuteCommand>(request, |params| {
                self.execute(&params);
                None
            }),
            method => refused(ErrorCode::MethodNotFound, &format!("{method} is not supported")),
        })
    }

    fn notification(&mut self, notification: Notification) {
        let method = notification.method.clone();
        let result = match method.as_str() {
            _ if !self.client.initialized => return,
            transport::MALFORMED => {
                let why = notification.params.as_str().unwrap_or_default().to_owned();
                return self.send(log(&format!("something that is no message was passed over: {why}")));
            }
            DidOpenTextDocument::METHOD => taken::<DidOpenTextDocument>(notification).map(|params| {
                let page = params.text_document;
                let path = path_of(&page.uri);
                let kind = kind_of(&page.language_id);
                // Its name tells more than the editor, which may know one kind of Markdown only.
                let named = path
                    .as_ref()
                    .is_some_and(|path| path.extension().is_some() && Container::of(path).is_ok());
                let kind = if named { None } else { kind };
                let uri = page.uri.as_str().to_owned();
                let mut page = Page {
                    version: page.version,
                    text: page.text,
                    path,
                    kind,
                    outdated: Arc::default(),
                    checked: None,
                    told: None,
                    asked: Vec::new(),
                };
                let mut pages = locked(&self.pages);
                if let Some(old) = pages.remove(&uri) {
                    old.outdated.store(true, Ordering::Relaxed);
                    page.asked = old.asked;
                }
                pages.insert(uri.clone(), page);
                self.check(&uri, &mut pages);
            }),
            DidChangeTextDocument::METHOD => {
                taken::<DidChangeTextDocument>(notification).map(|mut params| {
                    let uri = params.text_document.uri.as_str();
                    let mut pages = locked(&self.pages);
                    // The whole text is asked for; of several the last one counts.
                    if let (Some(page), Some(change)) = (pages.get_mut(uri), params.content_changes.pop()) {
                        page.text = change.text;
                        page.version = params.text_document.version;
                        self.check(uri, &mut pages);
                    }
                })
            }
            // Other pages may use what was saved: declarations, macros, settings.
            DidSaveTextDocument::METHOD => taken::<DidSaveTextDocument>(notification).map(|_| {
                let mut pages = locked(&self.pages);
                let all: Vec<String> = pages.keys().cloned().collect();
                for uri in all {
                    self.check(&uri, &mut pages);
                }
            }),
            DidCloseTextDocument::METHOD => taken::<DidCloseTextDocument>(notification).map(|params| {
                let uri = params.text_document.uri;
                if let Some(page) = locked(&self.pages).remove(uri.as_str()) {
                    page.outdated.store(true, Ordering::Relaxed);
                    self.send(marks(uri, Vec::new(), None));
                    for (id, _) in page.asked {
                        self.send(Response::new_ok(id, Vec::<InlayHint>::new()).into());
                    }
                }
            }),
            _ => return,
        };
        if let Err(why) = result {
            self.send(log(&format!("{method} was passed over: {why}")));
        }
    }

    /// Ends the check of a page that is going on, and asks for another.
    fn check(&self, uri: &str, pages: &mut BTreeMap<String, Page>) {
        let Some(page) = pages.get_mut(uri) else { return };
        page.outdated.store(true, Ordering::Relaxed);
        page.outdated = Arc::default();
        let job = Job {
            uri: uri.to_owned(),
            version: page.version,
            text: page.text.clone(),
            path: page.path.clone(),
            kind: page.kind,
            outdated: page.outdated.clone(),
        };
        // The thread lives as long as the server.
        let _ = self.jobs.send(job);
    }

    fn stop_all(&self) {
        for page in locked(&self.pages).values() {
            page.outdated.store(true, Ordering::Relaxed);
        }
    }

    fn initialize(&mut self, params: &InitializeParams) -> InitializeResult {
        let document = params.capabilities.text_document.as_ref();
        let formats = document.and_then(|can| can.hover.as_ref()?.content_format.as_ref());
        let edits = params.capabilities.workspace.as_ref().and_then(|can| can.workspace_edit.as_ref());
        let hints = params.capabilities.workspace.as_ref().and_then(|can| can.inlay_hint.as_ref());
        let refreshes = hints.and_then(|can| can.refresh_support).unwrap_or(false);
        self.client.refreshes.store(refreshes, Ordering::Relaxed);
        self.client.initialized = true;
        let markdown = formats.is_some_and(|formats| formats.contains(&MarkupKind::Markdown));
        self.client.markdown.store(markdown, Ordering::Relaxed);
        self.client.versioned = edits.and_then(|can| can.document_changes).unwrap_or(false);
        let sync = TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::FULL),
            save: Some(SaveOptions { include_text: Some(false) }.into()),
            ..TextDocumentSyncOptions::default()
        };
        let actions = CodeActionOptions {
            code_action_kinds: Some(vec![
                CodeActionKind::QUICKFIX,
                CodeActionKind::SOURCE_FIX_ALL,
                weaving::kind(),
            ]),
            ..CodeActionOptions::default()
        };
        InitializeResult {
            capabilities: ServerCapabilities {
                text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
                hover_provider: Some(HoverProviderCapability::Simple(true)),
                code_action_provider: Some(actions.into()),
                inlay_hint_provider: Some(OneOf::Left(true)),
                completion_provider: Some(CompletionOptions {
                    trigger_characters: Some(completion::TRIGGERS.map(str::to_owned).to_vec()),
                    ..CompletionOptions::default()
                }),
                execute_command_provider: Some(ExecuteCommandOptions {
                    commands: vec![weaving::COMMAND.to_owned()],
                    ..ExecuteCommandOptions::default()
                }),
                ..ServerCapabilities::default()
            },
            server_info: Some(ServerInfo {
                name: "polarform".to_owned(),
                version: Some(env!("CARGO_PKG_VERSION").to_owned()),
            }),
        }
    }

    fn hover(&self, params: &HoverParams) -> Option<lsp_types::Hover> {
        let place = &params.text_document_position_params;
        let pages = locked(&self.pages);
        let checked = pages.get(place.text_document.uri.as_str())?.current()?;
        checked.hover(checked.byte(place.position), self.client.markdown.load(Ordering::Relaxed))
    }

    fn actions(&self, params: &CodeActionParams) -> Vec<CodeActionOrCommand> {
        let uri = &params.text_document.uri;
        let pages = locked(&self.pages);
        let Some(page) = pages.get(uri.as_str()) else { return Vec::new() };
        let mut actions = match page.current() {
            Some(checked) => {
                let between = Span::new(checked.byte(params.range.start), checked.byte(params.range.end));
                checked.actions(uri, between, self.client.versioned)
            }
            None => Vec::new(),
        };
        if weaving::has_queries(&page.text, page.written()) {
            actions.push(CodeActionOrCommand::CodeAction(weaving::action(uri.as_str())));
        }
        if let Some(only) = &params.context.only {
            // A kind stands for those below it, too: source for source.fixAll.
            let wanted = |kind: &CodeActionKind| {
                only.iter().any(|only| {
                    let rest = kind.as_str().strip_prefix(only.as_str());
                    rest.is_some_and(|rest| {
                        rest.is_empty() || rest.starts_with('.') || only.as_str().is_empty()
                    })
                })
            };
            actions.retain(|action| match action {
                CodeActionOrCommand::CodeAction(action) => action.kind.as_ref().is_some_and(wanted),
                CodeActionOrCommand::Command(_) => false,
            });
        }
        actions
    }

    /// The marks of a page; while it is checked, its end answers.
    fn hints(&self, request: Request) -> Option<Response> {
        let id = request.id.clone();
        let params: InlayHintParams = match request.extract(InlayHintRequest::METHOD) {
            Ok((_, params)) => params,
            Err(error) => return Some(Response::new_err(id, ErrorCode::InvalidParams as i32, why(&error))),
        };
        let mut pages = locked(&self.pages);
        let Some(page) = pages.get_mut(params.text_document.uri.as_str()) else {
            return Some(Response::new_ok(id, Vec::<InlayHint>::new()));
        };
        page.asked.push((id, params.range));
        for message in page.marks_due(self.client.markdown.load(Ordering::Relaxed)) {
            self.send(message);
        }
        None
    }

    fn completions(&self, params: &CompletionParams) -> Option<CompletionResponse> {
        let place = &params.text_document_position;
        let pages = locked(&self.pages);
        let text = &pages.get(place.text_document.uri.as_str())?.text;
        let places = Places::new(text);
        let byte = places.byte(text, place.position);
        Some(CompletionResponse::Array(completion::completions(text, &places, byte)))
    }

    /// Fills results into a page, in a thread of its own, and hands the edit to the client.
    fn execute(&self, params: &ExecuteCommandParams) {
        let uri =
            params.arguments.first().and_then(|uri| uri.as_str()).and_then(|uri| uri.parse::<Uri>().ok());
        let Some(uri) = uri.filter(|_| params.command == weaving::COMMAND) else {
            return self.send(log(&format!("there is no command {} for that", params.command)));
        };
        let pages = locked(&self.pages);
        let Some(page) = pages.get(uri.as_str()) else {
            return self.send(log("results are put into open pages"));
        };
        let (text, path, version) = (page.text.clone(), page.path.clone(), page.version);
        let kind = page.written();
        let limits = Limits { interrupt: page.outdated.clone(), ..self.limits.clone() };
        let (sender, versioned) = (self.out.sender.clone(), self.client.versioned);
        let work = move || {
            let woven = catch_unwind(AssertUnwindSafe(|| {
                weaving::woven(&text, kind, path.as_ref(), &Places::new(&text), &limits)
            }));
            let (edit, problems) =
                woven.unwrap_or_else(|_| (None, vec!["polarform met a defect of its own".to_owned()]));
            let edit = edit.filter(|_| !limits.interrupt.load(Ordering::Relaxed)).map(|edit| {
                let edit = workspace_edit(&uri, vec![edit], versioned.then_some(version));
                let params = ApplyWorkspaceEditParams { label: Some("polarform weave".to_owned()), edit };
                Request::new("weave".to_owned().into(), ApplyWorkspaceEdit::METHOD.to_owned(), params).into()
            });
            let told = (!problems.is_empty()).then(|| {
                let message = format!("polarform: {}", problems.join("\n"));
                let params = ShowMessageParams { typ: MessageType::WARNING, message };
                Notification::new(ShowMessage::METHOD.to_owned(), params).into()
            });
            for message in edit.into_iter().chain(told) {
                // When the client is gone nobody waits for it.
                let _ = sender.send(message);
            }
        };
        let started = thread::Builder::new().stack_size(checker::STACK).spawn(work);
        if let Err(error) = started {
            self.send(log(&format!("cannot start a thread: {error}")));
        }
    }
}

/// The answer to a request whose parameters are as they should be.
fn answered<R: lsp_types::request::Request>(
    request: Request,
    answer: impl FnOnce(R::Params) -> R::Result,
) -> Response {
    let id = request.id.clone();
    match request.extract(R::METHOD) {
        Ok((id, params)) => Response::new_ok(id, answer(params)),
        Err(error) => Response::new_err(id, ErrorCode::InvalidParams as i32, why(&error)),
    }
}

/// The parameters of a notification.
fn taken<N: lsp_types::notification::Notification>(notification: Notification) -> Result<N::Params, String> {
    notification.extract(N::METHOD).map_err(|error| why(&error))
}

fn why<T>(error: &ExtractError<T>) -> String {
    match error {
        ExtractError::JsonError { error, .. } => error.to_string(),
        ExtractError::MethodMismatch(_) => "it is called otherwise".to_owned(),
    }
}

fn marks(uri: Uri, diagnostics: Vec<lsp_types::Diagnostic>, version: Option<i32>) -> Message {
    let params = PublishDiagnosticsParams { uri, diagnostics, version };
    Notification::new(PublishDiagnostics::METHOD.to_owned(), params).into()
}

fn log(message: &str) -> Message {
    let params = LogMessageParams { typ: MessageType::WARNING, message: format!("polarform: {message}") };
    Notification::new(LogMessage::METHOD.to_owned(), params).into()
}

/// The file that an address names.
fn path_of(uri: &Uri) -> Option<PathBuf> {
    let is_file = uri.scheme().is_some_and(|scheme| scheme.as_str().eq_ignore_ascii_case("file"));
    let path = uri.path().as_estr().decode().into_string().ok().filter(|_| is_file)?;
    // On Windows the drive stands behind a stroke: /C:/notes.md.
    let is_drive = path.as_bytes().get(2) == Some(&b':') && path.starts_with('/');
    Some(PathBuf::from(if cfg!(windows) && is_drive { &path[1..] } else { &path[..] }))
}

/// How a page is written, by the name that editors have for that.
fn kind_of(language: &str) -> Option<Container> {
    Some(match language {
        "markdown" | "plaintext" | "text" | "quarto" | "rmd" | "rmarkdown" | "mdx" | "myst" | "pandoc" => {
            Container::Markdown
        }
        "latex" | "tex" | "context" | "plaintex" => Container::Latex,
        "restructuredtext" | "rst" => Container::Rst,
        "ipynb" | "jupyter" => Container::Notebook,
        _ => return None,
    })
}
