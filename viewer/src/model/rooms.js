// The rooms of the level that are drawn now: swapped whole when a newer version is there, so that nothing flickers.
import { footprintOf, isObstacle } from '../plan/collision.js';
import { inverseOf, multiplied } from './matrix.js';
import { Openings } from './openings.js';

export class Rooms {
  constructor(batches) {
    this.batches = batches;
    this.openings = new Openings(batches);
    /** By id: {content, version, handles}. */
    this.shown = new Map();
    this.hasCeilings = false;
  }

  get size() {
    return this.shown.size;
  }

  versionOf(id) {
    return this.shown.get(id)?.version ?? null;
  }

  /** Draws a room whose primitives are known, in place of its older version. */
  put(content, openings, version) {
    const handles = content.primitives.map((primitive) => this.drawn(primitive));
    const former = this.shown.get(content.id);
    this.shown.set(content.id, { content, version, handles });
    this.showOverhead({ content, handles }, this.hasCeilings);
    if (former) this.erase(former);
    this.openings.remove(content.id);
    for (const opening of openings) this.openings.add(content.id, opening);
  }

  drawn({ key, matrix, role, piece, isShell }) {
    const handle = this.batches.place(key, matrix);
    return Object.assign(handle, { role, piece, isShell });
  }

  drop(id) {
    const room = this.shown.get(id);
    if (!room) return;
    this.shown.delete(id);
    this.erase(room);
    this.openings.remove(id);
  }

  erase({ handles }) {
    for (const handle of handles) this.batches.remove(handle);
  }

  clear() {
    for (const id of [...this.shown.keys()]) this.drop(id);
  }

  /** Ceilings, and what hangs on them, hide the room from above. */
  showCeilings(isVisible) {
    this.hasCeilings = isVisible;
    for (const room of this.shown.values()) this.showOverhead(room, isVisible);
  }

  showOverhead({ content, handles }, isVisible) {
    const hanging = new Set(content.pieces.filter(({ parent }) => parent === 'ceiling').map(({ id }) => id));
    for (const handle of handles) {
      if (handle.role === 'ceiling' || hanging.has(handle.piece)) this.batches.show(handle, isVisible);
    }
  }

  pieceOf(room, id) {
    return this.shown.get(room)?.content.pieces.find((piece) => piece.id === id) ?? null;
  }

  /** Puts pieces at other places, before the server furnishes the room again: copies with new matrices, as `carried` gives them. */
  movePieces(room, moved) {
    const { content, handles } = this.shown.get(room);
    for (const piece of moved) {
      const index = content.pieces.findIndex(({ id }) => id === piece.id);
      const change = multiplied(piece.matrix, inverseOf(content.pieces[index].matrix));
      content.pieces[index] = piece;
      for (const handle of handles.filter((each) => each.piece === piece.id)) this.batches.move(handle, multiplied(change, handle.elements));
    }
  }

  contents() {
    return [...this.shown.values()].map(({ content }) => content);
  }

  /** The boxes of furniture that stop a walker. */
  boxes() {
    return this.contents().flatMap(({ pieces }) => pieces.filter(isObstacle).map(footprintOf));
  }
}
