// What the page asks, one method for each address, over whatever brings questions to the program: `http.js`, or a worker with the
// program inside.
//
// A transport is {ask(address, body?) → {status, bytes: ArrayBuffer}, locate(path) → address that the browser can read, of a file that
// rooms share, listen(hear, opened)}. `ask` throws a ServerFault of status 0 where nobody answers.

/** A refusal or a failure, in words for people. `status` 0: no answer at all. */
export class ServerFault extends Error {
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

export class Server {
  constructor(transport) {
    this.transport = transport;
  }

  site() { return this.question('api/site'); }

  level(place) { return this.question('api/level', place); }

  explain(place) { return this.question('api/explain', place); }

  edits(building) { return this.question('api/edits', building); }

  look(viewpoint) { return this.order('api/look', viewpoint); }

  edit(edit) { return this.order('api/edit', edit); }

  reroll(place) { return this.order('api/reroll', place); }

  settings(settings) { return this.order('api/settings', settings); }

  room(place) { return this.bytes(address('api/room', place)); }

  levelFile(place) { return this.bytes(address('api/levelfile', place)); }

  /** The address of a file that rooms share. */
  locate(path) { return this.transport.locate(path); }

  /** Calls `hear(text)` with each message of the program, `opened()` whenever the line to it is there. */
  listen(hear, opened) { this.transport.listen(hear, opened); }

  async question(path, query) {
    return jsonOf(await this.bytes(address(path, query)));
  }

  async order(path, body) {
    return jsonOf(await this.bytes(path, JSON.stringify(body)));
  }

  async bytes(path, body) {
    const { status, bytes } = await this.transport.ask(path, body);
    if (status === 200) return bytes;
    throw new ServerFault(messageOf(status, bytes), status);
  }
}

export function address(path, query = {}) {
  const text = new URLSearchParams(query).toString();
  return text ? `${path}?${text}` : path;
}

const textOf = (bytes) => new TextDecoder().decode(bytes);

const jsonOf = (bytes) => JSON.parse(textOf(bytes));

function messageOf(status, bytes) {
  const text = textOf(bytes);
  try {
    const { error } = JSON.parse(text);
    if (typeof error === 'string') return error;
  } catch {
    // An answer without JSON is shown as it is.
  }
  return text.slice(0, 300) || `the server answers ${status}`;
}
