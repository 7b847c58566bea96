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
    /** The move that is not sent yet: {name, timer, send}. */
    this.due = null;
  }

  get isEditable() {
    return this.app.site?.is_editable === true && this.app.piece() !== null;
  }

  nameOf({ room, piece }) {
    return [this.app.building.id, this.app.level.id, room, piece].join('/');
  }

  /** The edit of the chosen piece that is in force, or null. */
  get entry() {
    const { selected, place, edits } = this.app;
    return selected?.piece ? edits.of({ ...place, room: selected.room }, selected.piece) : null;
  }

  isLocked() {
    return this.entry?.lock === true;
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
    this.sendNow({ ...this.entryNow(), lock: !this.isLocked() });
  }

  /** Takes the piece out of the room. */
  remove() {
    if (this.isEditable) this.sendNow({ remove: true });
  }

  /** Whether the chosen piece, also one that an edit removed, can get back its own place. */
  get isForgettable() {
    return this.app.site?.is_editable === true && (this.entry !== null || this.due !== null);
  }

  forget() {
    if (this.isForgettable) this.sendNow(null);
  }

  /** Sends what holds the place of the chosen piece, too, or takes it back. */
  sendNow(entry) {
    clearTimeout(this.due?.timer);
    this.due = null;
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
