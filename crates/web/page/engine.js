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
    const stream = new window["xz-decompress"].XzReadableStream(new Blob([packed]).stream());
    // What is unpacked is compiled while the rest is unpacked.
    return WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
  })();
  return compiled;
}

class Engine {
  /** `session` gives the requests that bring a new worker to where the old one was. */
  constructor(session = () => []) {
    this.session = session;
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
    for (const request of this.session()) this.send(request).catch(() => {});
  }

  received({ id, answer, trap }) {
    const waiting = this.waiting.get(id);
    if (trap !== undefined) {
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
    for (const { reject } of lost) reject(reason);
  }

  stop() {
    this.renew(new Lost("stopped", "stopped"));
  }

  send(request) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      if (!this.worker) return reject(new Lost("stopped", "stopped"));
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, request });
    });
  }

  async call(request) {
    if (!this.worker) await this.start();
    return this.send(request);
  }
}
