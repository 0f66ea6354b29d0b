// polarform in VS Code: the language server for open pages, and the report page beside them.
"use strict";
const vscode = require("vscode");
const { execFile } = require("child_process");
const { findProgram, Server } = require("./server.js");

const LANGUAGES = ["markdown", "latex", "tex", "restructuredtext", "quarto"];
const INSTALL = "polarform is not installed: cargo install --path . in its folder, or set polarform.path";

let server;
let diagnostics;
let output;
let marksChanged;
/** @type {Map<string, vscode.WebviewPanel>} */
const reports = new Map();

const settings = () => vscode.workspace.getConfiguration("polarform");
const reads = (document) => LANGUAGES.includes(document.languageId) && ["file", "untitled"].includes(document.uri.scheme);
const toRange = (range) => new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
const toPlace = (place) => ({ line: place.line, character: place.character });
const name = (document) => ({ uri: document.uri.toString() });

function toEdit(edit) {
  const made = new vscode.WorkspaceEdit();
  const put = (uri, edits) => edits.forEach((one) => made.replace(vscode.Uri.parse(uri), toRange(one.range), one.newText));
  for (const [uri, edits] of Object.entries(edit.changes ?? {})) put(uri, edits);
  for (const change of edit.documentChanges ?? []) put(change.textDocument.uri, change.edits);
  return made;
}

/** Whether the pages that an edit changes are still those for which it was made. */
function isCurrent(edit) {
  return (edit.documentChanges ?? []).every(({ textDocument }) => {
    const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === textDocument.uri);
    return !open || textDocument.version == null || open.version === textDocument.version;
  });
}

function published({ uri, version, diagnostics: found }) {
  const open = vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri);
  if (open && version != null && open.version !== version) return;
  const made = found.map((one) => {
    const mark = new vscode.Diagnostic(toRange(one.range), one.message, one.severity - 1);
    mark.source = one.source;
    mark.code = one.code;
    return mark;
  });
  diagnostics.set(vscode.Uri.parse(uri), made);
  marksChanged.fire();
}

async function start() {
  const program = findProgram(settings().get("path"));
  if (!program) {
    // Not waited for: the editor would say that it activates until somebody answers.
    vscode.window.showWarningMessage(INSTALL, "Open the setting").then((answer) => {
      if (answer) vscode.commands.executeCommand("workbench.action.openSettings", "polarform.path");
    });
    return;
  }
  const on = {
    log: (text) => output.append(text),
    "textDocument/publishDiagnostics": published,
    "window/logMessage": ({ message }) => output.appendLine(message),
    "window/showMessage": ({ message }) => void vscode.window.showWarningMessage(message),
    "workspace/inlayHint/refresh": () => marksChanged.fire(),
    "workspace/applyEdit": async ({ edit }) => ({ applied: isCurrent(edit) && (await vscode.workspace.applyEdit(toEdit(edit))) }),
  };
  const started = new Server(program, on, (why) => {
    if (server === started) server = undefined;
    diagnostics.clear();
    if (why) vscode.window.showErrorMessage(`polarform: the language server has ended: ${why}`);
  });
  server = started;
  await started.initialize();
  vscode.workspace.textDocuments.filter(reads).forEach(opened);
}

function opened(document) {
  if (!reads(document)) return;
  const page = { ...name(document), languageId: document.languageId, version: document.version, text: document.getText() };
  server?.tell("textDocument/didOpen", { textDocument: page });
}

function changed({ document, contentChanges }) {
  if (!reads(document) || contentChanges.length === 0) return;
  const textDocument = { ...name(document), version: document.version };
  server?.tell("textDocument/didChange", { textDocument, contentChanges: [{ text: document.getText() }] });
}

async function hover(document, position) {
  const found = await server?.ask("textDocument/hover", { textDocument: name(document), position: toPlace(position) });
  if (!found) return undefined;
  // Text of a page is no command of the editor: nothing of it is trusted.
  return new vscode.Hover(new vscode.MarkdownString(found.contents.value), found.range && toRange(found.range));
}

async function codeActions(document, range, context) {
  const only = context.only ? [context.only.value] : undefined;
  const found = await server?.ask("textDocument/codeAction", {
    textDocument: name(document),
    range: { start: toPlace(range.start), end: toPlace(range.end) },
    context: { diagnostics: [], only },
  });
  return (found ?? []).map((one) => {
    const made = new vscode.CodeAction(one.title, vscode.CodeActionKind.Empty.append(one.kind));
    if (one.edit) made.edit = toEdit(one.edit);
    if (one.command) made.command = { title: one.title, command: "polarform.fill" };
    made.isPreferred = one.isPreferred;
    return made;
  });
}

async function completions(document, position) {
  const params = { textDocument: name(document), position: toPlace(position) };
  const found = await server?.ask("textDocument/completion", params);
  return (found ?? []).map((one) => {
    const made = new vscode.CompletionItem(one.label, one.kind - 1);
    made.detail = one.detail;
    made.documentation = one.documentation && new vscode.MarkdownString(one.documentation.value);
    made.insertText = one.textEdit.newText;
    made.range = toRange(one.textEdit.range);
    return made;
  });
}

async function marks(document, range) {
  if (!settings().get("marks")) return [];
  const found = await server?.ask("textDocument/inlayHint", {
    textDocument: name(document),
    range: { start: toPlace(range.start), end: toPlace(range.end) },
  });
  return (found ?? []).map((one) => {
    const made = new vscode.InlayHint(new vscode.Position(one.position.line, one.position.character), one.label);
    made.paddingLeft = one.paddingLeft;
    made.tooltip = one.tooltip && new vscode.MarkdownString(one.tooltip.value);
    return made;
  });
}

function fill() {
  const document = vscode.window.activeTextEditor?.document;
  if (!document || !reads(document)) return undefined;
  return server?.ask("workspace/executeCommand", { command: "polarform.weave", arguments: [document.uri.toString()] });
}

/** The report of a page as HTML, made by the program from the text as it is in the editor. */
function render(document) {
  const program = findProgram(settings().get("path"));
  if (!program) return Promise.reject(new Error(INSTALL));
  const kind = { latex: "latex", tex: "latex", restructuredtext: "rst" }[document.languageId] ?? "markdown";
  return new Promise((resolve, reject) => {
    const words = ["notes", "check", "-", "--as", kind, "--report", "html"];
    const folder = document.uri.scheme === "file" ? vscode.Uri.joinPath(document.uri, "..").fsPath : undefined;
    const child = execFile(program, words, { cwd: folder, maxBuffer: 64 << 20 }, (error, out, err) => {
      // A refuted formula is no failure here.
      if (out.includes("<html")) resolve(out);
      else reject(new Error(err.trim() || error?.message || "there is no report"));
    });
    child.stdin.on("error", () => {});
    child.stdin.end(document.getText());
  });
}

async function show(document, panel) {
  try {
    panel.webview.html = await render(document);
  } catch (error) {
    const text = error.message.replace(/[&<>]/g, (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;" })[sign]);
    panel.webview.html = `<!doctype html><title>polarform</title><pre>${text}</pre>`;
  }
}

async function report() {
  const document = vscode.window.activeTextEditor?.document;
  if (!document || !reads(document)) return;
  const key = document.uri.toString();
  let panel = reports.get(key);
  if (panel) {
    panel.reveal(undefined, true);
  } else {
    const title = `polarform: ${document.uri.path.split("/").pop()}`;
    const where = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    panel = vscode.window.createWebviewPanel("polarform.report", title, where, { enableScripts: true, localResourceRoots: [] });
    reports.set(key, panel);
    panel.onDidDispose(() => reports.delete(key));
  }
  await show(document, panel);
}

function activate(context) {
  output = vscode.window.createOutputChannel("polarform");
  diagnostics = vscode.languages.createDiagnosticCollection("polarform");
  marksChanged = new vscode.EventEmitter();
  const keep = (...things) => context.subscriptions.push(...things);
  keep(output, diagnostics, marksChanged);
  const pages = LANGUAGES.map((language) => ({ language }));
  keep(
    vscode.workspace.onDidOpenTextDocument(opened),
    vscode.workspace.onDidChangeTextDocument(changed),
    vscode.workspace.onDidCloseTextDocument((document) => {
      if (reads(document)) server?.tell("textDocument/didClose", { textDocument: name(document) });
      diagnostics.delete(document.uri);
    }),
    vscode.workspace.onDidSaveTextDocument((document) => {
      server?.tell("textDocument/didSave", { textDocument: name(document) });
      const panel = reports.get(document.uri.toString());
      if (panel) show(document, panel);
    }),
    vscode.languages.registerHoverProvider(pages, { provideHover: hover }),
    vscode.languages.registerCodeActionsProvider(pages, { provideCodeActions: codeActions }),
    vscode.languages.registerCompletionItemProvider(pages, { provideCompletionItems: completions }, "{", "\\"),
    vscode.languages.registerInlayHintsProvider(pages, { onDidChangeInlayHints: marksChanged.event, provideInlayHints: marks }),
    vscode.commands.registerCommand("polarform.report", report),
    vscode.commands.registerCommand("polarform.fill", fill),
    vscode.commands.registerCommand("polarform.restart", async () => {
      await server?.stop();
      server = undefined;
      await start();
    }),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("polarform.path")) vscode.commands.executeCommand("polarform.restart");
      if (change.affectsConfiguration("polarform.marks")) marksChanged.fire();
    }),
  );
  return start();
}

async function deactivate() {
  await server?.stop();
}

module.exports = { activate, deactivate };
