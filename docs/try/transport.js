// The way from the viewer to the program in the worker: the transport of `viewer/src/server/server.js`, in place of HTTP.

const MEDIA_TYPES = { png: 'image/png', jpg: 'image/jpeg', jpeg: 'image/jpeg', webp: 'image/webp' };

export class WorkerTransport {
  constructor(worker) {
    this.worker = worker;
    this.number = 0;
    this.unanswered = new Map();
    /** Files that rooms share, by path: promises of addresses that the browser can read. */
    this.located = new Map();
    worker.addEventListener('message', ({ data: { number, ...answer } }) => {
      this.unanswered.get(number)(answer);
      this.unanswered.delete(number);
    });
  }

  /** Opens a plan in place of the former one. */
  async open(name, text, seed) {
    const answer = await this.question('open', name, text, seed);
    if (answer.status === 200) await this.forget();
    return answer;
  }

  ask(address, body) {
    return this.question('ask', address, body);
  }

  level({ building, level }) {
    return this.question('level', building, level);
  }

  locate(path) {
    if (!this.located.has(path)) this.located.set(path, this.blobOf(path));
    return this.located.get(path);
  }

  /** Nothing changes behind the page's back. */
  listen() {}

  question(method, ...values) {
    this.number += 1;
    const { number } = this;
    return new Promise((resolve) => {
      this.unanswered.set(number, resolve);
      this.worker.postMessage({ number, method, values });
    });
  }

  async blobOf(path) {
    const { status, bytes } = await this.ask(`shared/${path}`);
    if (status !== 200) throw new Error(`the program has no file ${path}`);
    return URL.createObjectURL(new Blob([bytes], { type: MEDIA_TYPES[path.split('.').at(-1)] ?? 'application/octet-stream' }));
  }

  async forget() {
    const addresses = await Promise.allSettled(this.located.values());
    this.located.clear();
    for (const { value } of addresses) if (value) URL.revokeObjectURL(value);
  }
}
