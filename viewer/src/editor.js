// Edits of the chosen piece and of rooms: shown at once, sent to the server, and shown as the server furnishes the room then.
import { radians } from './plan/frame.js';
import { carried, entryOf, movedMatrix } from './plan/edit.js';
import { clear, say } from './page/messages.js';

/** Milliseconds after the last step of a piece until its place is sent: keys repeat faster. */
const PAUSE = 350;
export const TURN_STEP = 15;

export class Editor {
  constructor(app, server) {
    Object.assign(this, { app, server });
    /** Locks of this session, by the full name of the piece. */
    this.locked = new Set();
    this.timer = null;
  }

  get isEditable() {
    return this.app.site?.is_editable === true && this.app.piece() !== null;
  }

  nameOf({ room, piece }) {
    return [this.app.building.id, this.app.level.id, room, piece].join('/');
  }

  isLocked() {
    return this.app.selected?.piece ? this.locked.has(this.nameOf(this.app.selected)) : false;
  }

  /** Moves the chosen piece on the plan and turns it by degrees, with all that it carries. */
  nudge(step, turn = 0) {
    if (!this.isEditable) return;
    const { app } = this;
    const { room } = app.selected;
    const piece = app.piece();
    const { pieces } = app.rooms.shown.get(room).content;
    app.rooms.movePieces(room, carried(piece, movedMatrix(piece, step, radians(turn)), pieces));
    app.roomChanged(room);
    this.sendSoon();
  }

  /** What the edits file is to say about the chosen piece as it is now. */
  entryNow() {
    const { pieces } = this.app.rooms.shown.get(this.app.selected.room).content;
    return entryOf(this.app.piece(), pieces, { isLocked: this.isLocked() });
  }

  sendSoon() {
    const target = { ...this.app.place, ...this.app.selected };
    const entry = this.entryNow();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.send(target, entry), PAUSE);
  }

  toggleLock() {
    if (!this.isEditable) return;
    const name = this.nameOf(this.app.selected);
    if (!this.locked.delete(name)) this.locked.add(name);
    this.sendNow(this.entryNow());
    this.app.hooks.selectionChanged();
  }

  remove() {
    this.sendNow({ remove: true });
  }

  forget() {
    if (this.isEditable) this.locked.delete(this.nameOf(this.app.selected));
    this.sendNow(null);
  }

  sendNow(entry) {
    if (!this.isEditable) return;
    clearTimeout(this.timer);
    this.send({ ...this.app.place, ...this.app.selected }, entry);
  }

  send({ building, level, room, piece }, entry) {
    return this.attempt(() => this.server.edit({ building, level, room, object: piece, entry }));
  }

  reroll(room) {
    return this.attempt(() => this.server.reroll({ ...this.app.place, room }));
  }

  furnishAnew(seed, style) {
    return this.attempt(async () => {
      await this.server.settings({ seed, style });
      Object.assign(this.app.site, { seed, style });
    });
  }

  async attempt(request) {
    try {
      await request();
      clear('edit');
    } catch (error) {
      say('edit', `The change was not made: ${error.message}`);
    }
    this.app.feed.lookNow();
  }
}
