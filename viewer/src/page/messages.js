// What went wrong, in words, at the top of the page: one banner for each cause, until the cause is gone or somebody closes it.
import { byId, element } from './elements.js';

const causes = new Map();

/** `cause` names what `clear` takes back. */
export function say(cause, text) {
  // Said again, the same text would take the focus from its button.
  if (causes.get(cause) === text) return;
  causes.set(cause, text);
  show();
}

export function clear(cause) {
  if (causes.delete(cause)) show();
}

function show() {
  const banner = byId('banner');
  const close = element('button', { type: 'button', text: 'Close' });
  close.addEventListener('click', () => { causes.clear(); show(); });
  banner.hidden = causes.size === 0;
  banner.replaceChildren(close, [...causes.values()].join('\n'));
}
