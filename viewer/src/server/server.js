// What the page asks of the server, one method for each address. Every address is relative to the page's own.

/** A refusal or a failure, in words for people. `status` 0: no answer at all. */
export class ServerFault extends Error {
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

const ANSWERS_NOT = 'the server does not answer. Start `roomwright view` again and open the address that it prints';

export class Server {
  site() { return this.get('api/site'); }

  level(place) { return this.get('api/level', place); }

  explain(place) { return this.get('api/explain', place); }

  look(viewpoint) { return this.post('api/look', viewpoint); }

  edit(edit) { return this.post('api/edit', edit); }

  reroll(place) { return this.post('api/reroll', place); }

  settings(settings) { return this.post('api/settings', settings); }

  async room(place) { return (await this.fetch(address('api/room', place))).arrayBuffer(); }

  async levelFile(place) { return (await this.fetch(address('api/levelfile', place))).arrayBuffer(); }

  async get(path, query) {
    return (await this.fetch(address(path, query))).json();
  }

  async post(path, body) {
    // The header cannot be sent by pages of other origins without the server's consent.
    const headers = { 'Content-Type': 'application/json', 'X-Roomwright': '1' };
    return (await this.fetch(path, { method: 'POST', headers, body: JSON.stringify(body) })).json();
  }

  async fetch(path, options) {
    const response = await fetch(path, options).catch(() => { throw new ServerFault(ANSWERS_NOT, 0); });
    if (response.ok && response.status !== 204) return response;
    throw new ServerFault(await messageOf(response), response.status);
  }
}

export function address(path, query = {}) {
  const text = new URLSearchParams(query).toString();
  return text ? `${path}?${text}` : path;
}

async function messageOf(response) {
  const text = await response.text().catch(() => '');
  try {
    const { error } = JSON.parse(text);
    if (typeof error === 'string') return error;
  } catch {
    // An answer without JSON is shown as it is.
  }
  return text.slice(0, 300) || `the server answers ${response.status}`;
}
