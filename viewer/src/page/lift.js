// The buttons in a lift: one for each level that it reaches, the highest on top.
import { byId, element } from './elements.js';
import { clear, say } from './messages.js';

export class Lift {
  constructor(app) {
    this.app = app;
    this.list = byId('lift');
    this.list.addEventListener('keydown', (event) => this.keyDown(event));
  }

  /** Offers the levels of the lift in which the walker stands, or nothing. */
  async update() {
    const { app } = this;
    const stops = await app.liftStops();
    const names = new Map(app.building.levels.map(({ id, name }) => [id, name ?? id]));
    const hadFocus = this.list.contains(document.activeElement);
    this.list.replaceChildren(...stops.reverse().map((stop) => this.button(stop, names.get(stop.level) ?? stop.level)));
    this.list.hidden = stops.length < 2;
    this.list.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' });
    // Somebody who walks out by keys goes on by keys.
    if (hadFocus) app.stage.canvas.focus();
  }

  button(stop, text) {
    const made = element('button', { type: 'button', text });
    made.dataset.level = stop.level;
    if (stop.level === this.app.level.id) made.setAttribute('aria-current', 'true');
    else made.addEventListener('click', () => this.ride(stop));
    return made;
  }

  ride(stop) {
    this.app.goToStop(stop).then(() => clear('level')).catch((error) => say('level', `The level cannot be shown: ${error.message}`));
  }

  /** Puts the keys on the button of this level; gives whether there is one. */
  focus() {
    const here = this.list.hidden ? null : this.list.querySelector('[aria-current]');
    here?.focus();
    return here !== null;
  }

  /** Arrows go from button to button, and no walker follows them. */
  keyDown(event) {
    const buttons = [...this.list.querySelectorAll('button')];
    const index = buttons.indexOf(document.activeElement);
    const next = { ArrowUp: index - 1, ArrowDown: index + 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (next === undefined) {
      if (event.key === 'Enter' || event.key === ' ') event.stopPropagation();
      return;
    }
    buttons[Math.min(buttons.length - 1, Math.max(0, next))].focus();
    event.preventDefault();
    event.stopPropagation();
  }
}
