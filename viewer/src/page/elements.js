// Elements of the page by their ids, and the few ways in which the page fills them.

export const byId = (id) => document.getElementById(id);

export function element(tag, { text, className, children = [], ...properties } = {}) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  Object.assign(made, properties);
  made.append(...children);
  return made;
}

/** Fills a select with [value, text] and chooses one. Equal lists are left alone: an open list would close. */
export function fillSelect(select, options, chosen) {
  const key = JSON.stringify(options);
  if (select.dataset.options !== key) {
    select.dataset.options = key;
    select.replaceChildren(...options.map(([value, text]) => element('option', { value, text })));
  }
  select.value = chosen ?? '';
}

/** Fills a list of facts with [name, value]; those without a value are left out. */
export function fillFacts(list, facts) {
  const known = facts.filter(([, value]) => value !== null && value !== undefined && value !== '');
  list.replaceChildren(...known.flatMap(([name, value]) => [element('dt', { text: name }), element('dd', { text: String(value) })]));
}

/** Keys typed into a field are meant for that field. */
export const isTyping = ({ target }) => target instanceof HTMLElement && target.matches('input, select, textarea, dialog *');
