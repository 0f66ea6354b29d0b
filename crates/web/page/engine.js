// Workers that answer requests, stopped and started anew.

/** Why a request has no answer. */
class Lost extends Error {
  constructor(kind, message) {
    super(message);
    /** "stopped" or "trapped" */
    this.kind = kind;
  }
}

/** The compiled module, unpacked from the page once. */
let compiled = null;

function unpacked() {
  compiled ??= (async () => {
    const raw = atob(document.getElementById("module").textContent);
    const packed = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; i++) packed[i] = raw.charCodeAt(i);
    const stream = new window["xz-decompress"].XzReadableStream(new Blob([packed]).stream()).pipeThrough(assembled());
    // What is unpacked is compiled while the rest is unpacked.
    return WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
  })();
  return compiled;
}

class Engine {
  /**
   * `session` gives the requests that bring a new worker to where the old one was; `forget` is called with the place of one that
   * broke the new worker, too: it and what follows are not asked again.
   */
  constructor(session = () => [], forget = () => {}) {
    this.session = session;
    this.forget = forget;
    /** Requests that are repeated, by their numbers. */
    this.repeated = new Map();
    this.waiting = new Map();
    this.next = 0;
    this.worker = null;
  }

  get busy() {
    return this.waiting.size > 0;
  }

  async start() {
    const module = await unpacked();
    if (this.worker) return;
    const source = document.getElementById("worker").textContent;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.onmessage = ({ data }) => this.worker === worker && this.received(data);
    worker.onerror = (event) => {
      event.preventDefault();
      if (this.worker === worker) this.renew(new Lost("trapped", event.message));
    };
    worker.postMessage({ module });
    this.worker = worker;
    this.session().forEach((request, place) => {
      const id = this.next;
      this.repeated.set(id, place);
      this.send(request).then(() => this.repeated.delete(id), () => {});
    });
  }

  received({ id, answer, trap, partial }) {
    const waiting = this.waiting.get(id);
    if (partial !== undefined) {
      waiting?.partly(partial);
    } else if (trap !== undefined) {
      if (this.repeated.has(id)) this.forget(this.repeated.get(id));
      this.renew(new Lost("trapped", trap));
    } else if (waiting) {
      this.waiting.delete(id);
      waiting.resolve(answer);
    }
  }

  /** Ends the worker; what waits is lost. The next request starts another. */
  renew(reason) {
    this.worker?.terminate();
    this.worker = null;
    const lost = [...this.waiting.values()];
    this.waiting.clear();
    this.repeated.clear();
    for (const { reject } of lost) reject(reason);
  }

  stop() {
    this.renew(new Lost("stopped", "stopped"));
  }

  send(request, partly = () => {}) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      if (!this.worker) return reject(new Lost("stopped", "stopped"));
      this.waiting.set(id, { resolve, reject, partly });
      this.worker.postMessage({ id, request });
    });
  }

  /** The answer to a request; `partly` gets what is found before it. */
  async call(request, partly) {
    if (!this.worker) await this.start();
    return this.send(request, partly);
  }
}
