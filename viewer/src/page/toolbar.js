// The toolbar, the settings and the help.
import { clear, say } from './messages.js';
import { byId, fillSelect } from './elements.js';

const NO_STYLE = '';

export class Toolbar {
  constructor(app, editor) {
    Object.assign(this, { app, editor });
    byId('building').addEventListener('change', ({ target }) => this.open(target.value, null));
    byId('level').addEventListener('change', ({ target }) => this.open(app.building.id, target.value));
    for (const button of document.querySelectorAll('[data-mode]')) button.addEventListener('click', () => app.setMode(button.dataset.mode));
    byId('lamps').addEventListener('click', () => this.toggleLamps());
    byId('go-up').addEventListener('click', () => this.changeFloor('above'));
    byId('go-down').addEventListener('click', () => this.changeFloor('below'));
    byId('open-help').addEventListener('click', () => byId('help').showModal());
    byId('toggle-panel').addEventListener('click', () => this.togglePanel());
    byId('settings-form').addEventListener('submit', (event) => {
      event.preventDefault();
      editor.furnishAnew(Number(byId('seed').value), byId('style').value || null);
    });
  }

  open(building, level) {
    this.attempt(this.app.openLevel(building, level));
  }

  changeFloor(direction) {
    this.attempt(this.app.changeFloor(direction));
  }

  /** The next level of the list, up or down. */
  stepLevel(direction) {
    const { building, level } = this.app;
    const next = building.levels[building.levels.indexOf(level) + direction];
    if (next) this.open(building.id, next.id);
  }

  attempt(change) {
    change.then(() => clear('level')).catch((error) => say('level', `The level cannot be shown: ${error.message}`));
  }

  toggleLamps() {
    this.app.setLight(this.app.light.mode === 'day' ? 'lamp' : 'day');
  }

  togglePanel() {
    const panel = byId('panel');
    panel.hidden = !panel.hidden;
    byId('toggle-panel').setAttribute('aria-expanded', String(!panel.hidden));
  }

  update() {
    const { app } = this;
    const { site, building, level } = app;
    const title = ({ id, name }) => name && name !== id ? name : id;
    fillSelect(byId('building'), site.buildings.map((each) => [each.id, title(each)]), building?.id);
    byId('building').parentElement.hidden = site.buildings.length < 2;
    fillSelect(byId('level'), (building?.levels ?? []).map((each) => [each.id, title(each)]), level?.id);
    for (const button of document.querySelectorAll('[data-mode]')) button.setAttribute('aria-pressed', String(button.dataset.mode === app.mode));
    byId('lamps').setAttribute('aria-pressed', String(app.light.mode === 'lamp'));
    byId('walking').hidden = app.mode !== 'walk';
    for (const control of document.querySelectorAll('.editing')) control.hidden = !site.is_editable;
    byId('settings').hidden = site.kind !== 'plan';
    this.updateStairs();
  }

  updateStairs() {
    byId('go-up').hidden = this.app.stopBeyond('above') === null;
    byId('go-down').hidden = this.app.stopBeyond('below') === null;
  }

  updateSettings() {
    const { site } = this.app;
    byId('seed').value = site.seed;
    fillSelect(byId('style'), [[NO_STYLE, 'as planned'], ...site.styles.map((style) => [style, style])], site.style ?? NO_STYLE);
    byId('edits-note').textContent = site.edits ? `Edits are written to ${site.edits}.` : '';
  }
}
