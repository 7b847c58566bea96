// The edits in force of the building that is shown, by room and piece: what is locked, moved or removed.

export class Edits {
  constructor(server) {
    this.server = server;
    /** By the name of the room, then by piece: the entry of the edits file. */
    this.rooms = new Map();
  }

  /** Asks the server. The answer to an older question is thrown away. */
  async read(building) {
    const question = { building };
    this.question = question;
    const { rooms } = await this.server.edits(question);
    if (this.question === question) this.rooms = new Map(rooms.map((room) => [nameOf(room), room.objects ?? {}]));
  }

  /** The entry of a piece, or null. */
  of(place, piece) {
    return this.inRoom(place)[piece] ?? null;
  }

  inRoom(place) {
    return this.rooms.get(nameOf(place)) ?? {};
  }

}

const nameOf = ({ building, level, room }) => JSON.stringify([building, level, room]);

/** The ids of the pieces that entries take out of a room. */
export function removedOf(entries) {
  return Object.entries(entries).filter(([, { remove }]) => remove === true).map(([id]) => id);
}

/** What an entry says, in words: "locked, moved". */
export function editText(entry) {
  if (!entry) return null;
  const facts = [
    [entry.remove, 'removed'], [entry.lock, 'locked'], [entry.at !== undefined, 'moved'],
    [entry.turn !== undefined && entry.at === undefined, 'turned'],
  ];
  return facts.filter(([holds]) => holds).map(([, word]) => word).join(', ') || 'edited';
}
