// The program as WebAssembly: its functions take the addresses of bytes, and leave a status and the bytes of an answer.

const encoder = new TextEncoder();

/** Compiles and starts the program. The host offers it nothing: what it imports throws when it is called. */
export async function loadProgram(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address} is not there: the host answers ${response.status}`);
  const module = await WebAssembly.compile(await response.arrayBuffer());
  const instance = await WebAssembly.instantiate(module, refusals(WebAssembly.Module.imports(module)));
  return new Program(instance.exports);
}

/** An object with a function that throws for each import. */
export function refusals(imports) {
  const refused = {};
  for (const { module, name } of imports) {
    refused[module] ??= {};
    refused[module][name] = () => { throw new Error(`the program asks for ${module}.${name}, which a page does not have`); };
  }
  return refused;
}

/** Each method gives {status, bytes}: a status of HTTP, and a copy of the answer. */
export class Program {
  constructor(exports) {
    this.exports = exports;
  }

  /** Reads a plan; without a seed, the plan's own holds. Status 422 comes with the faults of the plan in words. */
  open(name, text, seed = null) {
    return this.call(this.exports.roomwright_open, [name, text], seed ?? Number.NaN);
  }

  ask(address, body = '') {
    return this.call(this.exports.roomwright_ask, [address, body]);
  }

  /** The finished level as a .glb file. */
  level(building, level) {
    return this.call(this.exports.roomwright_level, [building, level]);
  }

  call(run, texts, ...more) {
    const places = texts.map((text) => this.put(text));
    const status = run(...places.flatMap(({ at, length }) => [at, length]), ...more);
    for (const { at, allocated } of places) this.exports.roomwright_free(at, allocated);
    return { status, bytes: this.answer() };
  }

  put(text) {
    const bytes = encoder.encode(text);
    // No program owes anybody an address of nothing.
    const allocated = Math.max(1, bytes.length);
    const at = this.exports.roomwright_allocate(allocated);
    this.view(at, bytes.length).set(bytes);
    return { at, length: bytes.length, allocated };
  }

  answer() {
    return this.view(this.exports.roomwright_answer(), this.exports.roomwright_answer_length()).slice().buffer;
  }

  /** The memory moves when it grows, so that views are made anew; addresses above 2 GB come as negative numbers. */
  view(at, length) {
    return new Uint8Array(this.exports.memory.buffer, at >>> 0, length >>> 0);
  }
}
