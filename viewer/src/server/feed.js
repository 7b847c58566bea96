// Rooms on their way from the server into the picture: several are fetched at a time, one is parsed at a time, when nothing else is to do.
import { readGlb } from '../model/glb.js';
import { readTree } from '../model/tree.js';
import { pauseBeforeLook, planOf } from './contract.js';

/** Browsers open six connections to a host; two stay free for models and images. */
const MOST_FETCHES = 4;
/** Files of rooms that left the picture are kept for coming back, up to so many. */
const MOST_KEPT = 48;
/** Milliseconds that a parse waits at most for an idle moment. */
const LONGEST_IDLE = 100;
/** Milliseconds before a room is asked for again that failed to come. */
const PAUSE_AFTER_FAULT = 2000;

export class Feed {
  /** `hooks`: viewpoint() for api/look, changed(roomId), failed(error), recovered(), broken(error, roomId), mended(). */
  constructor(server, library, rooms, hooks) {
    Object.assign(this, { server, library, rooms, hooks });
    this.place = null;
    /** Grows with each change of level: answers to older questions are thrown away. */
    this.generation = 0;
    this.kept = new Map();
    /** Grows with each plan, which counts its versions anew. */
    this.planNumber = 0;
    /** Rooms whose file cannot be shown, with its version: the same file would fail again. */
    this.broken = new Map();
    this.waiting = 0;
  }

  /** Another plan follows: none of its rooms is known. */
  forget() {
    this.planNumber += 1;
    this.kept.clear();
  }

  /** What is in no other file: the plan, the level, and the room in one version. */
  keyOf(...names) {
    return [this.planNumber, this.place.building, this.place.level, ...names].join('/');
  }

  /** Begins with another level, whose rooms come by api/look or, where the server shows a finished bake, in one file. */
  open(place, isBake) {
    this.generation += 1;
    this.place = place;
    this.queue = [];
    this.wanted = new Map();
    this.pending = new Set();
    this.waiting = 1;
    this.serverWaiting = 0;
    this.broken.clear();
    this.hooks.mended();
    clearTimeout(this.timer);
    this.isLooking = !isBake;
    if (isBake) this.readLevelFile(this.generation).catch((error) => this.hooks.failed(error));
    else this.look();
  }

  /** Whether all rooms that the server has are shown. */
  get isCalm() {
    return this.rooms.size > 0 && this.queue.length === 0 && this.pending.size === 0;
  }

  /** Asks at once what is worth drawing. */
  lookNow() {
    if (!this.isLooking || this.isAsking) return;
    clearTimeout(this.timer);
    this.look();
  }

  look() {
    const { generation } = this;
    this.isAsking = true;
    const { isMoving, ...viewpoint } = this.hooks.viewpoint();
    this.server.look({ ...this.place, ...viewpoint }).then((answer) => {
      this.hooks.recovered();
      if (generation === this.generation) this.follow(answer);
      return pauseBeforeLook({ waiting: answer.waiting, isMoving });
    }).catch((error) => {
      this.hooks.failed(error);
      return PAUSE_AFTER_FAULT;
    }).then((pause) => {
      // A level that was opened meanwhile asks for itself.
      if (generation !== this.generation) return;
      this.isAsking = false;
      this.timer = setTimeout(() => this.look(), pause);
    });
  }

  follow(answer) {
    const versions = new Map([...this.rooms.shown].map(([id, { version }]) => [id, version]));
    const plan = planOf(answer, this.place, versions);
    this.wanted = plan.wanted;
    this.serverWaiting = answer.waiting;
    for (const room of plan.drop) {
      this.rooms.drop(room);
      this.hooks.changed(room);
    }
    if (plan.drop.length > 0) this.library.batches.tidy();
    this.queue = plan.fetch.filter(({ version, room }) => !this.pending.has(`${room} ${version}`) && this.broken.get(room) !== version);
    this.count();
    this.fetchMore();
  }

  count() {
    this.waiting = this.queue.length + this.pending.size + this.serverWaiting;
  }

  fetchMore() {
    while (this.queue.length > 0 && this.pending.size < MOST_FETCHES) {
      const { room, version } = this.queue.shift();
      this.fetch(room, version, this.generation);
    }
  }

  fetch(room, version, generation) {
    const name = `${room} ${version}`;
    this.pending.add(name);
    this.fileOf(room, version).then((file) => {
      if (generation !== this.generation) return undefined;
      return this.inTurn(() => this.show(room, version, file, generation));
    }).catch((error) => this.failed(error, room, version, generation)).then(() => {
      if (generation !== this.generation) return;
      this.pending.delete(name);
      this.count();
      this.fetchMore();
    });
  }

  failed(error, room, version, generation) {
    if (generation !== this.generation) return;
    if (error.status === 0) return this.hooks.failed(error);
    this.broken.set(room, version);
    this.hooks.broken(error, room);
  }

  async fileOf(room, version) {
    const name = this.keyOf(room, version);
    const file = this.kept.get(name) ?? await this.server.room({ ...this.place, room, version });
    this.kept.delete(name);
    this.kept.set(name, file);
    for (const oldest of [...this.kept.keys()].slice(0, Math.max(0, this.kept.size - MOST_KEPT))) this.kept.delete(oldest);
    return file;
  }

  /** Runs one task after the other, each in a moment in which the page has nothing else to do. */
  inTurn(task) {
    const turn = (this.last ?? Promise.resolve()).then(idle).then(task);
    this.last = turn.catch(() => undefined);
    return turn;
  }

  async show(room, version, file, generation) {
    if (this.wanted.get(room) !== version) return;
    const document = readGlb(file);
    const tree = readTree(document, this.keyOf(room, version));
    const content = tree.rooms.find(({ id }) => id === room);
    if (!content) throw new Error(`the file of room ${room} holds no such room`);
    await this.library.load(document, primitivesOf(content, tree.openings));
    // The walk may have gone on while the images came.
    if (generation !== this.generation || this.wanted.get(room) !== version) return;
    this.rooms.put(content, tree.openings, version);
    if (this.broken.delete(room) && this.broken.size === 0) this.hooks.mended();
    this.library.batches.tidy();
    this.hooks.changed(room);
  }

  async readLevelFile(generation) {
    const document = readGlb(await this.server.levelFile(this.place));
    const tree = readTree(document, this.keyOf());
    this.waiting = tree.rooms.length;
    for (const content of tree.rooms) {
      const openings = tree.openings.filter(({ extras }) => extras.rooms.includes(content.id));
      await this.inTurn(async () => {
        if (generation !== this.generation) return;
        await this.library.load(document, primitivesOf(content, openings));
        if (generation !== this.generation) return;
        this.rooms.put(content, openings, 'baked');
        this.waiting -= 1;
        this.hooks.changed(content.id);
      });
    }
  }
}

function primitivesOf(content, openings) {
  return [...content.primitives, ...openings.flatMap(({ primitives, leaves }) => [...primitives, ...leaves.flatMap((leaf) => leaf.primitives)])];
}

function idle() {
  return new Promise((resolve) => {
    if (window.requestIdleCallback) window.requestIdleCallback(resolve, { timeout: LONGEST_IDLE });
    else setTimeout(resolve, 0);
  });
}
