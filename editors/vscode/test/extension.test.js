// The extension in an editor made of paper, with the real server: node --test editors/vscode/test
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const Module = require("node:module");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");

const root = path.join(__dirname, "..", "..", "..");
const program = process.env.POLARFORM || path.join(root, "target", "debug", "polarform");
const { findProgram, Reader } = require("../server.js");

class Position {
  constructor(line, character) {
    Object.assign(this, { line, character });
  }
}

class Range {
  constructor(a, b, c, d) {
    this.start = new Position(a, b);
    this.end = new Position(c, d);
  }
}

class Uri {
  constructor(text) {
    this.text = text;
    [this.scheme] = text.split(":");
    this.path = text.slice(this.scheme.length + 1).replace(/^\/\//, "");
    this.fsPath = this.path;
  }
  toString() {
    return this.text;
  }
  static parse(text) {
    return new Uri(text);
  }
  static joinPath(uri, up) {
    assert.equal(up, "..");
    return new Uri(uri.text.replace(/\/[^/]*$/, ""));
  }
}

class Document {
  constructor(uri, languageId, text) {
    Object.assign(this, { uri: new Uri(uri), languageId, text, version: 1 });
  }
  getText() {
    return this.text;
  }
  at(place) {
    return this.text.split("\n").slice(0, place.line).reduce((sum, line) => sum + line.length + 1, 0) + place.character;
  }
  put({ range, newText }) {
    this.text = this.text.slice(0, this.at(range.start)) + newText + this.text.slice(this.at(range.end));
    this.version += 1;
  }
}

/** What of VS Code the extension uses, and what it did with it. */
function editor(document) {
  const done = { messages: [], found: new Map(), panels: [] };
  const events = {};
  const listen = (name) => (listener) => {
    events[name] = listener;
    return { dispose() {} };
  };
  const provide = (name) => (pages, provider) => {
    done[name] = provider;
    return { dispose() {} };
  };
  const plain = class {
    constructor(...values) {
      this.values = values;
    }
  };
  const vscode = {
    Position,
    Range,
    Uri,
    Diagnostic: class {
      constructor(range, message, severity) {
        Object.assign(this, { range, message, severity });
      }
    },
    MarkdownString: plain,
    Hover: plain,
    CodeAction: class {
      constructor(title, kind) {
        Object.assign(this, { title, kind });
      }
    },
    CodeActionKind: { Empty: { append: (value) => ({ value }) } },
    CompletionItem: class {
      constructor(label, kind) {
        Object.assign(this, { label, kind });
      }
    },
    InlayHint: class {
      constructor(position, label) {
        Object.assign(this, { position, label });
      }
    },
    EventEmitter: class {
      constructor() {
        this.event = () => ({ dispose() {} });
      }
      fire() {}
      dispose() {}
    },
    WorkspaceEdit: class {
      constructor() {
        this.edits = [];
      }
      replace(uri, range, newText) {
        this.edits.push({ range, newText });
      }
    },
    ViewColumn: { Beside: -2 },
    languages: {
      createDiagnosticCollection: () => ({
        set: (uri, found) => done.found.set(uri.toString(), found),
        delete: (uri) => done.found.delete(uri.toString()),
        clear: () => done.found.clear(),
        dispose() {},
      }),
      registerHoverProvider: provide("hover"),
      registerCodeActionsProvider: provide("actions"),
      registerCompletionItemProvider: provide("completions"),
      registerInlayHintsProvider: provide("marks"),
    },
    commands: {
      all: {},
      registerCommand: (name, run) => {
        vscode.commands.all[name] = run;
        return { dispose() {} };
      },
      executeCommand: (name) => vscode.commands.all[name]?.(),
    },
    window: {
      activeTextEditor: { document },
      createOutputChannel: () => ({ append() {}, appendLine() {}, dispose() {} }),
      // As in the editor, nothing comes back until somebody answers.
      showWarningMessage: (text) => (done.messages.push(text), new Promise(() => {})),
      showErrorMessage: async (text) => void done.messages.push(text),
      createWebviewPanel: (type, title) => {
        const panel = { title, webview: { html: "" }, reveal() {}, onDidDispose() {} };
        done.panels.push(panel);
        return panel;
      },
    },
    workspace: {
      textDocuments: [document],
      getConfiguration: () => ({ get: (key) => ({ path: program, marks: true })[key] }),
      applyEdit: async (edit) => {
        edit.edits.forEach((one) => document.put(one));
        return true;
      },
      onDidOpenTextDocument: listen("open"),
      onDidChangeTextDocument: listen("change"),
      onDidCloseTextDocument: listen("close"),
      onDidSaveTextDocument: listen("save"),
      onDidChangeConfiguration: listen("settings"),
    },
  };
  return { vscode, done, events };
}

function loaded(vscode) {
  const load = Module._load;
  Module._load = (request, ...rest) => (request === "vscode" ? vscode : load(request, ...rest));
  try {
    delete require.cache[require.resolve("../extension.js")];
    return require("../extension.js");
  } finally {
    Module._load = load;
  }
}

async function until(condition) {
  for (let turn = 0; turn < 2000; turn++) {
    const value = condition();
    if (value) return value;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  throw new Error(`it never came: ${condition}`);
}

test("messages come in pieces", () => {
  const taken = [];
  const reader = new Reader((message) => taken.push(message));
  const body = Buffer.from(JSON.stringify({ a: "设 𝒇" }));
  const bytes = Buffer.concat([Buffer.from(`Content-Type: x\r\nContent-Length: ${body.length}\r\n\r\n`), body]);
  const both = Buffer.concat([bytes, bytes]);
  for (let at = 0; at < both.length; at += 7) reader.add(both.subarray(at, at + 7));
  assert.deepEqual(taken, [{ a: "设 𝒇" }, { a: "设 𝒇" }]);
});

test("the program is found", () => {
  const there = (...files) => (file) => files.includes(file);
  const home = path.join("/home", "a", ".cargo", "bin", "polarform");
  assert.equal(findProgram("/x/polarform", {}, there("/x/polarform")), "/x/polarform");
  assert.equal(findProgram("/x/polarform", { PATH: "/bin" }, there("/bin/polarform")), undefined);
  assert.equal(findProgram("", { PATH: "/bin:/opt" }, there("/opt/polarform")), "/opt/polarform");
  assert.equal(findProgram("", { PATH: "/bin", HOME: "/home/a" }, there(home)), home);
  assert.equal(findProgram("", {}, there()), undefined);
});

test("a page is marked, explained, repaired, filled in and reported", { skip: !fs.existsSync(program) && `there is no ${program}` }, async () => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "polarform-"));
  const text = "Now $2 + 2 = 5$ and $1 + 1 = 2$, so {{ 1 + 2 }}.\n";
  const document = new Document(`file://${folder}/a.md`, "markdown", text);
  const { vscode, done, events } = editor(document);
  const extension = loaded(vscode);
  await extension.activate({ subscriptions: [] });
  const key = document.uri.toString();
  const [wrong] = await until(() => done.found.get(key)?.length && done.found.get(key));
  assert.deepEqual([wrong.code, wrong.severity, document.at(wrong.range.start)], ["refuted", 0, text.indexOf("2 + 2")]);
  const hover = await done.hover.provideHover(document, wrong.range.start);
  assert.match(hover.values[0].values[0], /refuted/);
  const whole = new Range(0, 0, 9, 0);
  const marks = await done.marks.provideInlayHints(document, whole);
  assert.deepEqual(marks.map((mark) => mark.label), ["✗", "✓"]);
  const place = new Position(0, text.indexOf("{{") + 3);
  const names = await done.completions.provideCompletionItems(document, place);
  assert.ok(names.some((one) => one.label === "polar" && one.range.start.character === place.character));

  await vscode.commands.all["polarform.report"]();
  assert.match(done.panels[0].webview.html, /<html[^]*2 \+ 2 = 4/);

  const actions = await done.actions.provideCodeActions(document, wrong.range, {});
  assert.deepEqual(actions.map((one) => one.kind.value), ["quickfix", "source.fixAll", "source.polarform.weave"]);
  await vscode.workspace.applyEdit(actions[0].edit);
  assert.match(document.text, /2 \+ 2 = 4/);
  events.change({ document, contentChanges: [{}] });
  await until(() => done.found.get(key)?.length === 0);
  await vscode.commands.all["polarform.fill"]();
  await until(() => document.text.includes("$3$<!-- {{ 1 + 2 }} -->"));
  await vscode.commands.all["polarform.restart"]();
  assert.deepEqual(done.messages, []);
  events.close({ ...document, uri: document.uri });
  await extension.deactivate();
  fs.rmSync(folder, { recursive: true });
});

test("without a program it says so, and a server that ends is told", async () => {
  const document = new Document("untitled:a", "markdown", "");
  const { vscode, done } = editor(document);
  vscode.workspace.getConfiguration = () => ({ get: () => "/nowhere/polarform" });
  await loaded(vscode).activate({ subscriptions: [] });
  assert.match(done.messages[0], /not installed/);
});
