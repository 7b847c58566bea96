// The panel: the room and the piece that are chosen, why the piece is where it is, and the findings of the level.
import { byId, element, fillFacts, fillSelect } from './elements.js';
import { missingOf, reasonOf } from './explanation.js';
import { findingText, findingsOf, severityOf } from './findings.js';
import { editText, removedOf } from '../edits.js';
import { sizeText, standsText, words } from './text.js';

export class Panel {
  constructor(app, editor) {
    Object.assign(this, { app, editor });
    this.explanations = new Map();
    byId('room').addEventListener('change', ({ target }) => this.choose(target.value, null));
    byId('piece').addEventListener('change', ({ target }) => this.choose(this.room(), target.value || null));
    byId('visit').addEventListener('click', () => app.visit(this.room(), app.selected?.piece));
    byId('reroll').addEventListener('click', () => editor.reroll(this.room()));
    byId('lock').addEventListener('click', () => editor.toggleLock());
    byId('turn-left').addEventListener('click', () => editor.nudge([0, 0], 15));
    byId('turn-right').addEventListener('click', () => editor.nudge([0, 0], -15));
    byId('remove').addEventListener('click', () => editor.remove());
    byId('forget').addEventListener('click', () => editor.forget());
  }

  /** The room that the panel is about: that of the chosen piece, where the walker is, or the chosen one. */
  room() {
    const { selected, mode, views, map } = this.app;
    const walked = mode === 'walk' ? views.walk.room?.id : null;
    return (selected?.piece ? selected.room : null) ?? walked ?? selected?.room ?? map.rooms[0]?.id ?? null;
  }

  choose(room, piece) {
    this.app.select({ room, piece });
    this.app.visit(room, piece);
  }

  /** The next piece of the room, or the one before, wherever the list stands. */
  step(direction) {
    const pieces = this.app.rooms.shown.get(this.room())?.content.pieces ?? [];
    if (pieces.length === 0) return;
    const index = pieces.findIndex(({ id }) => id === this.app.selected?.piece);
    const next = index < 0 ? (direction > 0 ? 0 : pieces.length - 1) : (index + direction + pieces.length) % pieces.length;
    this.app.select({ room: this.room(), piece: pieces[next].id });
  }

  update() {
    const { app } = this;
    const id = this.room();
    fillSelect(byId('room'), app.map.rooms.map((room) => [room.id, room.name && room.name !== room.id ? `${room.name} (${room.id})` : room.id]), id);
    const shown = app.rooms.shown.get(id);
    this.showRoom(app.map.rooms.find((room) => room.id === id), shown);
    this.showPiece(shown?.content.pieces ?? []);
    this.explain(id, shown?.version ?? null);
    this.showFindings();
  }

  showRoom(room, shown) {
    const { extras = {} } = shown?.content ?? {};
    fillFacts(byId('room-facts'), room ? [
      ['Type', words(extras.type ?? room.type ?? '')],
      ['Style', extras.style],
      ['Pieces', extras.requested === undefined ? null : `${extras.placed} of ${extras.requested}`],
      ['Grade', extras.grade && `${extras.grade}${typeof extras.score === 'number' ? `, score ${extras.score.toFixed(2)}` : ''}`],
      ['Missing', (extras.removed ?? []).map((piece) => `${words(piece.class)} (${piece.reason}${piece.required ? ', required' : ''})`).join(', ')],
      ['State', shown ? null : 'on its way'],
    ] : []);
  }

  showPiece(pieces) {
    const piece = this.app.piece();
    const entries = this.entries();
    const options = pieces.map(({ id }) => [id, entries[id] ? `${id} (${editText(entries[id])})` : id]);
    const removed = this.removed(pieces).map((id) => [id, `${id} (removed)`]);
    fillSelect(byId('piece'), [['', 'none'], ...options, ...removed], this.app.selected?.piece ?? '');
    fillFacts(byId('piece-facts'), piece ? [
      ['Class', words(piece.kind)],
      ['Stands', standsText(piece)],
      ['Size', sizeText(piece.size)],
      ['Place', `${piece.at[0].toFixed(2)}, ${piece.at[1].toFixed(2)}; ${piece.bottom.toFixed(2)} m above the floor`],
      ['Turned', `${Math.round((piece.angle * 180 / Math.PI + 360) % 360)}°`],
      ['Variant', piece.variant],
      ['Edit', editText(this.editor.entry)],
    ] : this.absentFacts());
    for (const button of byId('piece-buttons').querySelectorAll('button')) button.disabled = !this.editor.isEditable;
    byId('forget').disabled = !this.editor.isForgettable;
    byId('forget').textContent = this.editor.entry?.remove ? 'Bring back' : 'Forget edit';
    byId('lock').setAttribute('aria-pressed', String(this.editor.isLocked()));
  }

  /** The edits of the room that the panel is about. */
  entries() {
    const { app } = this;
    return app.building ? app.edits.inRoom({ ...app.place, room: this.room() }) : {};
  }

  /** The pieces that edits took out of the room. */
  removed(pieces) {
    return removedOf(this.entries()).filter((id) => !pieces.some((piece) => piece.id === id));
  }

  absentFacts() {
    const id = this.app.selected?.piece;
    if (!id) return [];
    return [['Piece', this.editor.entry?.remove ? `${id} was removed by an edit` : `${id} is not in the room now`]];
  }

  /** Asks for the reason of the room's pieces once for each version of the room. */
  explain(room, version) {
    if (!room || !version || this.app.site.kind !== 'plan' || !this.app.selected) return this.showReason(null);
    const key = [this.app.building.id, this.app.level.id, room, version].join('/');
    if (this.explanations.has(key)) return this.showReason(this.explanations.get(key));
    this.showReason(null);
    this.explanations.clear();
    this.explanations.set(key, null);
    this.app.server.explain({ ...this.app.place, room }).then((explanation) => {
      if (!this.explanations.has(key)) return;
      this.explanations.set(key, explanation);
      this.update();
    }).catch(() => {
      // Without its reason, the piece is still described.
      this.explanations.set(key, null);
    });
    return undefined;
  }

  showReason(explanation) {
    const piece = this.app.piece();
    const own = piece && explanation ? reasonOf(explanation, piece.id) : [];
    const missing = !piece && explanation ? missingOf(explanation) : [];
    const sections = [...own, ...missing.length > 0 ? [{ title: 'Missing', lines: missing }] : []];
    const isAbout = ({ room, objects }) => room === piece?.room && objects.includes(piece.id);
    const findings = findingsOf(this.app.rooms.contents()).filter(isAbout);
    if (findings.length > 0) sections.unshift({ title: 'Findings', lines: findings.map((finding) => this.textOf(finding)) });
    byId('reason').replaceChildren(...sections.flatMap(({ title, lines }) => [
      element('h3', { text: title }), element('ul', { children: lines.map((text) => element('li', { text })) }),
    ]));
  }

  textOf(finding) {
    return findingText(finding, this.app.site.meanings);
  }

  showFindings() {
    const findings = findingsOf(this.app.rooms.contents());
    const key = JSON.stringify(findings);
    if (key === this.findingsKey) return;
    this.findingsKey = key;
    const items = findings.map((finding) => {
      const text = element('span', { text: `${finding.room}: ${this.textOf(finding)}` });
      const button = element('button', { type: 'button', children: [badge(finding), text] });
      button.addEventListener('click', () => this.choose(finding.room, finding.objects[0] ?? null));
      return element('li', { children: [button] });
    });
    byId('findings').replaceChildren(...items.length > 0 ? items : [element('li', { className: 'note', text: 'None in the rooms that are shown.' })]);
  }
}

/** A letter in a shape: how severe a finding is. */
export function badge(finding) {
  const { severity, letter, name } = severityOf(finding);
  const made = element('span', { className: `badge ${severity}`, text: letter });
  made.setAttribute('role', 'img');
  made.setAttribute('aria-label', name);
  return made;
}
