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
    /** Locks set since the page was opened, by the full name of the piece. */
    this.locked = new Set();
    /** The move that is not sent yet: {name, timer, send}. */
    this.due = null;
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
    app.stage.invalidate();
    this.sendSoon();
  }

  /** Where the chosen piece is now, as the edits file says it; the server keeps what else its entry holds, such as a lock. */
  entryNow() {
    const { pieces } = this.app.rooms.shown.get(this.app.selected.room).content;
    return entryOf(this.app.piece(), pieces);
  }

  sendSoon() {
    const target = { ...this.app.place, ...this.app.selected };
    const name = this.nameOf(target);
    const entry = this.entryNow();
    if (this.due?.name !== name) this.due?.send();
    clearTimeout(this.due?.timer);
    const send = () => {
      clearTimeout(this.due.timer);
      this.due = null;
      this.send(target, entry);
    };
    this.due = { name, send, timer: setTimeout(send, PAUSE) };
  }

  toggleLock() {
    if (!this.isEditable) return;
    const name = this.nameOf(this.app.selected);
    if (!this.locked.delete(name)) this.locked.add(name);
    this.sendNow({ ...this.entryNow(), lock: this.locked.has(name) });
    this.app.hooks.selectionChanged();
  }

  /** Takes the piece out of the room. An entry says either where a piece is or that it is gone: the former edit is forgotten. */
  remove() {
    this.sendNow(null, { remove: true });
  }

  /** Whether the chosen piece, also one that an edit removed, can get back its own place. */
  get isForgettable() {
    return this.app.site?.is_editable === true && Boolean(this.app.selected?.piece);
  }

  forget() {
    if (!this.isForgettable) return;
    this.locked.delete(this.nameOf(this.app.selected));
    this.sendNow(null);
  }

  sendNow(...entries) {
    if (!this.isForgettable) return;
    // What is sent now holds the place of the piece, too, or takes it back.
    clearTimeout(this.due?.timer);
    this.due = null;
    this.send({ ...this.app.place, ...this.app.selected }, ...entries);
  }

  /** Sends one entry after the other. */
  send({ building, level, room, piece }, ...entries) {
    return this.attempt(async () => {
      for (const entry of entries) await this.server.edit({ building, level, room, object: piece, entry });
    });
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
