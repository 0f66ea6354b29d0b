// The language server as a process: messages with a header that has their length, over pipes. Nothing of VS Code is used here.
"use strict";
const { spawn } = require("child_process");
const fs = require("fs");
const path = require("path");

/** The program: as configured, or on the PATH, or where `cargo install` puts it; `undefined` if it is nowhere. */
function findProgram(configured, environment = process.env, exists = isProgram) {
  if (configured) {
    return exists(configured) ? configured : undefined;
  }
  const name = process.platform === "win32" ? "polarform.exe" : "polarform";
  const home = environment.HOME || environment.USERPROFILE;
  const folders = (environment.PATH || environment.Path || "").split(path.delimiter).filter(Boolean);
  folders.push(...[environment.CARGO_HOME, home && path.join(home, ".cargo")].filter(Boolean).map((folder) => path.join(folder, "bin")));
  return folders.map((folder) => path.join(folder, name)).find(exists);
}

function isProgram(file) {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return fs.statSync(file).isFile();
  } catch {
    return false;
  }
}

/** Takes messages out of what comes in pieces. */
class Reader {
  constructor(take) {
    this.take = take;
    this.bytes = Buffer.alloc(0);
  }

  add(piece) {
    this.bytes = Buffer.concat([this.bytes, piece]);
    for (;;) {
      const end = this.bytes.indexOf("\r\n\r\n");
      if (end < 0) return;
      const length = /content-length: *(\d+)/i.exec(this.bytes.toString("ascii", 0, end));
      const start = end + 4;
      if (!length) {
        this.bytes = this.bytes.subarray(start);
        continue;
      }
      const stop = start + Number(length[1]);
      if (this.bytes.length < stop) return;
      const text = this.bytes.toString("utf8", start, stop);
      this.bytes = this.bytes.subarray(stop);
      this.take(JSON.parse(text));
    }
  }
}

/** A server that runs. `on` has functions by method, for what the server says and asks. */
class Server {
  constructor(program, on, ended) {
    this.on = on;
    this.waiting = new Map();
    this.last = 0;
    this.child = spawn(program, ["lsp"], { stdio: ["pipe", "pipe", "pipe"] });
    this.child.stdin.on("error", () => {});
    const reader = new Reader((message) => this.taken(message));
    this.child.stdout.on("data", (piece) => reader.add(piece));
    this.child.stderr.on("data", (piece) => on.log?.(piece.toString()));
    const over = (why) => {
      if (!this.over) {
        this.over = true;
        for (const { reject } of this.waiting.values()) reject(new Error("the server has ended"));
        this.waiting.clear();
        ended(this.leaving ? undefined : why);
      }
    };
    this.child.on("error", (error) => over(error.message));
    this.child.on("exit", (code, signal) => over(`it ended with ${signal ?? code}`));
  }

  write(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.child.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.child.stdin.write(body);
  }

  tell(method, params) {
    if (!this.over) this.write({ method, params });
  }

  ask(method, params) {
    if (this.over) return Promise.reject(new Error("the server has ended"));
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.write({ id, method, params });
    });
  }

  async taken(message) {
    if (message.method) {
      let result = null;
      try {
        result = (await this.on[message.method]?.(message.params)) ?? null;
      } catch (error) {
        this.on.log?.(`${message.method}: ${error.message}`);
      }
      if (message.id !== undefined) this.write({ id: message.id, result });
      return;
    }
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) waiting?.reject(new Error(message.error.message));
    else waiting?.resolve(message.result);
  }

  async initialize() {
    const capabilities = {
      textDocument: { hover: { contentFormat: ["markdown", "plaintext"] } },
      workspace: { workspaceEdit: { documentChanges: true }, inlayHint: { refreshSupport: true }, applyEdit: true },
    };
    await this.ask("initialize", { processId: process.pid, rootUri: null, capabilities });
    this.tell("initialized", {});
  }

  async stop() {
    if (this.over) return;
    this.leaving = true;
    await this.ask("shutdown", null).catch(() => {});
    this.tell("exit", null);
    const child = this.child;
    setTimeout(() => child.exitCode === null && child.kill(), 2000).unref();
  }
}

module.exports = { findProgram, Reader, Server };
