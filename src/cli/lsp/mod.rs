//! `polarform lsp`: a language server for pages of notes.
//!
//! Editors send the text of each open page; a thread checks it ([`checker`]) and sends diagnostics. Questions about
//! it are answered from the last check, as long as the page is still the same: an answer never speaks of a text that
//! has changed.
//!
//! Reference: Language Server Protocol 3.17. Places are in UTF-16 code units, which every client knows.

mod answers;
mod checker;
mod places;
mod transport;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use lsp_server::{Connection, ErrorCode, ExtractError, Message, Notification, Request, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, DidSaveTextDocument, Exit, LogMessage,
    Notification as _, PublishDiagnostics,
};
use lsp_types::request::{CodeActionRequest, HoverRequest, Initialize, Request as _, Shutdown};
use lsp_types::{
    CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams, HoverParams,
    HoverProviderCapability, InitializeParams, InitializeResult, LogMessageParams, MarkupKind, MessageType,
    PublishDiagnosticsParams, SaveOptions, ServerCapabilities, ServerInfo, TextDocumentSyncCapability,
    TextDocumentSyncKind, TextDocumentSyncOptions, Uri,
};

use super::Status;
use super::arguments::Global;
use super::commands::{Ran, Stop};
use super::output::Trouble;
use crate::document::Container;
use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic};
use checker::{Checked, Job};

/// A page that an editor has open.
struct Page {
    version: i32,
    text: String,
    path: Option<PathBuf>,
    kind: Option<Container>,
    /// Ends the check of the text before.
    outdated: Arc<AtomicBool>,
    checked: Option<Checked>,
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
    markdown: bool,
    versioned: bool,
    leaving: bool,
}

struct Server {
    pages: Pages,
    jobs: Sender<Job>,
    client: Client,
    out: Connection,
}

/// Serves an editor on standard input and output until it says that it leaves.
pub(super) fn run(global: &Global, seconds: f64) -> Ran {
    let (connection, writer) = transport::stdio();
    let pages = Pages::default();
    let (checked, sender) = (pages.clone(), connection.sender.clone());
    let done = move |found: Checked| {
        let mut pages = locked(&checked);
        // A page may have been closed, or edited since the last look.
        let Some(page) = pages.get_mut(&found.uri).filter(|page| page.version == found.version) else {
            return;
        };
        let told = found.remark.as_ref().map(|remark| log(remark));
        let marks = found.uri.parse().map(|uri| marks(uri, found.diagnostics(), Some(found.version)));
        page.checked = Some(found);
        for message in told.into_iter().chain(marks.ok()) {
            // When the client is gone the server ends.
            let _ = sender.send(message);
        }
    };
    let jobs = checker::start(global.limits_or(seconds), done).map_err(|error| {
        let message = format!("cannot start a thread: {error}");
        Stop::Trouble(Trouble::Problem(Box::new(Diagnostic::error(Code::Internal, message))))
    })?;
    let mut server = Server { pages, jobs, client: Client::default(), out: connection };
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
                    let response = self.request(request);
                    self.send(response.into());
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

    fn request(&mut self, request: Request) -> Response {
        let id = request.id.clone();
        let refused = |code: ErrorCode, why: &str| Response::new_err(id.clone(), code as i32, why.to_owned());
        match request.method.as_str() {
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
            method => refused(ErrorCode::MethodNotFound, &format!("{method} is not supported")),
        }
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
                let page = Page {
                    version: page.version,
                    text: page.text,
                    path,
                    kind,
                    outdated: Arc::default(),
                    checked: None,
                };
                let mut pages = locked(&self.pages);
                if let Some(old) = pages.insert(uri.clone(), page) {
                    old.outdated.store(true, Ordering::Relaxed);
                }
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
                        page.checked = None;
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
        self.client = Client {
            initialized: true,
            markdown: formats.is_some_and(|formats| formats.contains(&MarkupKind::Markdown)),
            versioned: edits.and_then(|can| can.document_changes).unwrap_or(false),
            leaving: false,
        };
        let sync = TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::FULL),
            save: Some(SaveOptions { include_text: Some(false) }.into()),
            ..TextDocumentSyncOptions::default()
        };
        let actions = CodeActionOptions {
            code_action_kinds: Some(vec![CodeActionKind::QUICKFIX, CodeActionKind::SOURCE_FIX_ALL]),
            ..CodeActionOptions::default()
        };
        InitializeResult {
            capabilities: ServerCapabilities {
                text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
                hover_provider: Some(HoverProviderCapability::Simple(true)),
                code_action_provider: Some(actions.into()),
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
        let checked = pages.get(place.text_document.uri.as_str())?.checked.as_ref()?;
        checked.hover(checked.byte(place.position), self.client.markdown)
    }

    fn actions(&self, params: &CodeActionParams) -> Vec<CodeActionOrCommand> {
        let uri = &params.text_document.uri;
        let pages = locked(&self.pages);
        let Some(checked) = pages.get(uri.as_str()).and_then(|page| page.checked.as_ref()) else {
            return Vec::new();
        };
        let between = Span::new(checked.byte(params.range.start), checked.byte(params.range.end));
        let mut actions = checked.actions(uri, between, self.client.versioned);
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
