// The way to the server of `roomwright view`. Every address is relative to the page's own.
import { ServerFault } from './server.js';

const ANSWERS_NOT = 'the server does not answer. Start `roomwright view` again and open the address that it prints';
/** Below it lie the files that several rooms share. */
const SHARED_FOLDER = 'shared/';

export class Http {
  async ask(address, body) {
    try {
      const response = await fetch(address, body === undefined ? undefined : orderOf(body));
      return { status: response.status, bytes: await response.arrayBuffer() };
    } catch {
      throw new ServerFault(ANSWERS_NOT, 0);
    }
  }

  async locate(path) {
    return new URL(SHARED_FOLDER + path, document.baseURI).href;
  }

  listen(hear, opened) {
    const events = new EventSource('api/events');
    events.addEventListener('message', ({ data }) => hear(data));
    events.addEventListener('open', opened);
  }
}

/** The header cannot be sent by pages of other origins without the server's consent. */
function orderOf(body) {
  return { method: 'POST', headers: { 'Content-Type': 'application/json', 'X-Roomwright': '1' }, body };
}
