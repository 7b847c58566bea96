// The maps of levels, each asked for once, and the ways that stairs and lifts make between levels.
import { readLevel } from './contract.js';

export class Levels {
  constructor(server) {
    this.server = server;
    this.known = new Map();
  }

  /** The plan changed: all maps are asked for again. */
  forget() {
    this.known.clear();
  }

  /** The answer of api/level, completed. */
  map({ building, level }) {
    const key = JSON.stringify([building, level]);
    if (!this.known.has(key)) {
      const asked = this.server.level({ building, level }).then(readLevel);
      asked.catch(() => this.known.delete(key));
      this.known.set(key, asked);
    }
    return this.known.get(key);
  }

  /** All stops of the stairs or the lift in a room, the lowest first, this one too: [{level, room}]. */
  async stopsOf(building, stop) {
    const below = await this.beyond(building, stop, 'below');
    return [...below.reverse(), stop, ...await this.beyond(building, stop, 'above')];
  }

  async beyond(building, from, direction) {
    const stops = [];
    let next = from;
    for (;;) {
      const map = await this.map({ building, level: next.level });
      next = stopBeyond(map.rooms.find(({ id }) => id === next.room), direction);
      // A plan may lead in a circle.
      if (next === null || stops.some(({ level }) => level === next.level)) return stops;
      stops.push(next);
    }
  }
}

/** The stop that one gets to from a room: {level, room}, or null. */
export function stopBeyond(room, direction) {
  const [level, beyond] = [room?.[`${direction}_level`], room?.[direction]];
  return level && beyond ? { level, room: beyond } : null;
}
