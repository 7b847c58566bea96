// Doors and windows as they are shown. An opening comes with each of its rooms, and is drawn once. Leaves swing and slide.
import { closingTurn, eased, isNear, slidesOf, swung } from '../plan/doors.js';
import { multiplied, placed } from './matrix.js';

export class Openings {
  constructor(batches) {
    this.batches = batches;
    /** By name: {contents: Map(room → content), owner, handles, leaves, openness}. */
    this.shown = new Map();
    /** The ids of openings that let people through; all others stay shut. */
    this.ways = new Set();
  }

  add(room, content) {
    const known = this.shown.get(content.name);
    const opening = known ?? { contents: new Map(), owner: null, openness: 0 };
    this.shown.set(content.name, opening);
    opening.contents.set(room, content);
    // The newest version is the one that is shown: the other room may be of an older plan.
    if (known) this.undraw(opening);
    this.draw(opening, room);
  }

  remove(room) {
    for (const [name, opening] of this.shown) {
      if (!opening.contents.delete(room) || opening.owner !== room) continue;
      this.undraw(opening);
      const [next] = opening.contents.keys();
      if (next === undefined) this.shown.delete(name);
      else this.draw(opening, next);
    }
  }

  draw(opening, room) {
    const content = opening.contents.get(room);
    const place = ({ key, matrix }) => this.batches.place(key, matrix);
    const slides = content.extras.closure === 'sliding' ? slidesOf(content.leaves.map(({ extent }) => extent)) : [];
    opening.owner = room;
    opening.handles = content.primitives.map(place);
    opening.leaves = content.leaves.map((leaf, index) => ({
      matrix: leaf.matrix, handles: leaf.primitives.map(place),
      turn: closingTurn(leaf.hinge, content.extras.leaves), slide: slides[index] ?? 0,
    }));
    this.pose(opening);
  }

  undraw({ handles, leaves }) {
    for (const handle of [...handles, ...leaves.flatMap((leaf) => leaf.handles)]) this.batches.remove(handle);
  }

  /** Moves leaves as time passes; `walker` is a place in the plan, or null. Gives whether something moved. */
  update(walker, seconds, isInstant) {
    let isMoving = false;
    for (const opening of this.shown.values()) {
      if (opening.leaves.length === 0) continue;
      const { center, extras } = opening.contents.get(opening.owner);
      const isWanted = this.ways.has(extras.id) && isNear(walker, center);
      const openness = swung(opening.openness, isWanted, seconds, isInstant);
      if (openness === opening.openness) continue;
      opening.openness = openness;
      this.pose(opening);
      isMoving = true;
    }
    return isMoving;
  }

  /** How far the opening of an id is open, 0 to 1; null where it is not drawn. */
  opennessOf(id) {
    const found = [...this.shown.values()].find(({ contents, owner }) => contents.get(owner).extras.id === id);
    return found?.openness ?? null;
  }

  pose({ leaves, openness }) {
    const open = eased(openness);
    for (const { matrix, handles, turn, slide } of leaves) {
      const pose = multiplied(matrix, placed([slide * open, 0, 0], turn * (1 - open)));
      for (const handle of handles) this.batches.move(handle, pose);
    }
  }
}
