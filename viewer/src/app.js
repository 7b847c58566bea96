// What is shown now, and the ways to change that: building, level, way of looking, chosen piece. The controls call it; it calls `hooks`.
import { Edits } from './edits.js';
import { Batches } from './model/batches.js';
import { Library } from './model/library.js';
import { Rooms } from './model/rooms.js';
import { WALKER_RADIUS, obstaclesOf, openestHeading } from './plan/collision.js';
import { add, directionOf, distance, headingOf, scale, subtract, toPlan, toScene } from './plan/frame.js';
import { boundsOf, clampedInto, middleOf, roomAt, sidesOf } from './plan/polygon.js';
import { doorOf, groundOf, placeInsideDoor } from './plan/walls.js';
import { readEvent, readPlace, readSite, writePlace } from './server/contract.js';
import { Feed } from './server/feed.js';
import { Levels, stopBeyond } from './server/levels.js';
import { clear, say } from './page/messages.js';
import { Aprons } from './view/aprons.js';
import { Light } from './view/light.js';
import { OrbitView, PlanView } from './view/orbit.js';
import { Neighbours, Outline } from './view/outline.js';
import { Section } from './view/section.js';
import { Shell } from './view/shell.js';
import { Storeys } from './view/storeys.js';
import { WalkView } from './view/walk.js';

/** Seconds without new rooms after which what takes a while disturbs nobody. */
const CALM = 0.5;
/** The room type of lifts. */
const LIFT = 'elevator';
const AFTER_BREAKAGE = 'Reload the page; if that does not help, start the server again.';
/** Metres between a viewer who is sent to a piece and that piece. */
const VISIT_DISTANCE = 1.8;
/** Metres: nearer to the middle of a room, one does not look towards it. */
const NEAR_MIDDLE = 0.4;

export class App {
  constructor(stage, server, isReduced) {
    Object.assign(this, { stage, server, isReduced });
    this.batches = new Batches(stage.scene);
    this.rooms = new Rooms(this.batches);
    this.section = new Section(stage.renderer);
    this.shell = new Shell(stage.scene, this.section);
    this.aprons = new Aprons(stage.scene);
    this.light = new Light(stage);
    this.outline = new Outline(stage.scene);
    this.neighbours = new Neighbours(stage.scene);
    this.storeys = new Storeys(stage.scene);
    this.levels = new Levels(server);
    this.edits = new Edits(server);
    const anisotropy = Math.min(8, stage.renderer.capabilities.getMaxAnisotropy());
    this.feed = new Feed(server, new Library(this.batches, this.section, anisotropy, (path) => server.locate(path)), this.rooms, {
      viewpoint: () => this.view.viewpoint(),
      changed: (room) => this.roomChanged(room),
      failed: (error) => say('feed', `The view is not up to date: ${error.message}.`),
      recovered: () => clear('feed'),
      broken: (error, room) => say('broken', `Room ${room} cannot be shown: ${error.message}. ${AFTER_BREAKAGE}`),
      mended: () => clear('broken'),
    });
    this.views = {
      orbit: new OrbitView(stage, isReduced), plan: new PlanView(stage, isReduced), walk: new WalkView(stage, () => this.walkable()),
    };
    this.mode = 'orbit';
    this.map = { rooms: [], openings: [] };
    this.selected = null;
    this.calm = 0;
    this.hooks = { levelOpened() {}, modeChanged() {}, roomsChanged() {}, selectionChanged() {}, siteChanged() {}, walkedRoomChanged() {} };
    stage.resized = (aspect) => Object.values(this.views).forEach((view) => view.resize(aspect));
  }

  get view() {
    return this.views[this.mode];
  }

  /** Where the viewer is, for the question what is worth drawing. */
  viewpoint() {
    const { isMoving, ...viewpoint } = this.view.viewpoint();
    return viewpoint;
  }

  get place() {
    return { building: this.building.id, level: this.level.id };
  }

  async start() {
    await this.open();
    if (this.site.kind === 'plan') this.listen();
  }

  /** Shows what the server has now, which may be another plan than before. */
  async open() {
    this.site = readSite(await this.server.site());
    this.feed.forget();
    this.levels.forget();
    const wanted = readPlace(window.location.hash);
    const building = this.site.buildings.find(({ id }) => id === wanted.building) ?? this.site.buildings[0];
    this.hooks.siteChanged();
    await this.openLevel(building.id, wanted.level);
    this.setMode(wanted.mode);
  }

  /** Shows a level; the first one of the building if it has none of that id. */
  async openLevel(buildingId, levelId) {
    const building = this.site.buildings.find(({ id }) => id === buildingId);
    const level = building.levels.find(({ id }) => id === levelId) ?? building.levels[0];
    const isOther = building !== this.building;
    const map = await this.levels.map({ building: building.id, level: level.id });
    this.rooms.clear();
    this.batches.tidy();
    Object.assign(this, { building, level });
    this.setMap(map);
    this.select(null);
    this.light.lowerGround(level);
    this.neighbours.show(building, level, this.site.buildings);
    if (isOther || this.mode !== 'walk') this.fit();
    if (isOther) {
      this.enterSomewhere();
      this.readEdits().catch((error) => say('edits', `Nobody knows which edits are in force: ${error.message}`));
    }
    this.feed.open(this.place, this.site.kind === 'bake');
    this.keepPlace();
    this.hooks.levelOpened();
    this.stage.invalidate();
    await this.showOtherStoreys();
  }

  async showOtherStoreys() {
    const { building, level } = this;
    this.storeys.clear();
    const others = building.levels.filter((each) => each !== level);
    const maps = await Promise.all(others.map(({ id }) => this.levels.map({ building: building.id, level: id })));
    if (level !== this.level) return;
    this.storeys.show(level, maps);
    this.stage.invalidate();
  }

  setMap(map) {
    this.map = map;
    this.ground = groundOf(map);
    this.obstacles = null;
    this.rooms.openings.ways = new Set(this.ground.ways.map(({ id }) => id));
    this.aprons.show(this.ground.aprons, this.light.heightAbove(this.level));
    this.shell.build(map);
    for (const room of this.rooms.shown.keys()) this.shell.show(room, false);
  }

  /** Rooms and obstacles of the level as a walker asks for them. */
  walkable() {
    const columns = this.map.rooms.flatMap(({ obstacles }) => obstacles);
    this.obstacles ??= obstaclesOf(this.ground.walls, columns, this.rooms.boxes());
    return { rooms: this.map.rooms, obstacles: this.obstacles };
  }

  fit() {
    const points = this.map.rooms.flatMap(({ outline }) => outline);
    const bounds = points.length > 0 ? boundsOf(points) : this.building.bounds;
    this.views.orbit.fit(bounds, this.level.height);
    this.views.plan.fit(bounds);
  }

  enterSomewhere() {
    const room = roomAt(this.map.rooms, toPlan(this.views.orbit.view().target)) ?? this.map.rooms[0];
    if (!room) return;
    this.walkTo(room, middleOf(room), null);
  }

  setMode(mode) {
    const former = this.view;
    this.mode = mode;
    former.activate(false);
    this.view.activate(true);
    // Somebody who looks from above ceilings sees nothing else.
    this.rooms.showCeilings(mode === 'walk');
    this.shell.showCeilings(mode === 'walk');
    this.storeys.showAbove(mode === 'walk');
    this.section.follow(mode === 'orbit' ? this.view.view() : null, this.level.height);
    this.feed.lookNow();
    this.keepPlace();
    this.hooks.modeChanged();
    this.stage.invalidate();
  }

  keepPlace() {
    window.history.replaceState(null, '', writePlace({ ...this.place, mode: this.mode }));
  }

  /** Takes the stairs or the lift of the room where the walker is. */
  async changeFloor(direction) {
    const stop = this.stopBeyond(direction);
    if (stop) await this.goToStop(stop);
  }

  /** Brings the walker to a stop of stairs or a lift, {level, room}, with the door before the eyes. */
  async goToStop(stop) {
    const { walk } = this.views;
    const { position } = walk;
    await this.openLevel(this.building.id, stop.level);
    const room = this.map.rooms.find(({ id }) => id === stop.room);
    if (!room) return;
    walk.enter(room, clampedInto(position, room, WALKER_RADIUS));
    const door = doorOf(room, this.map.openings);
    if (door) walk.face(headingOf(subtract(door.center, walk.position)));
  }

  /** The next stop above or below the walker, to which stairs or a lift lead, or null. */
  stopBeyond(direction) {
    return stopBeyond(this.walkedRoom(), direction);
  }

  /** All stops of the lift in which the walker stands; none elsewhere. */
  async liftStops() {
    const room = this.walkedRoom();
    if (this.mode !== 'walk' || room?.type !== LIFT) return [];
    return this.levels.stopsOf(this.building.id, { level: this.level.id, room: room.id });
  }

  /** The room of the walker, as the map has it now. */
  walkedRoom() {
    return this.map.rooms.find(({ id }) => id === this.views.walk.room?.id) ?? null;
  }

  select(selected) {
    this.selected = selected;
    this.outline.show(this.piece());
    this.hooks.selectionChanged();
    this.stage.invalidate();
  }

  /** The chosen piece as it is now, or null. */
  piece() {
    return this.selected?.piece ? this.rooms.pieceOf(this.selected.room, this.selected.piece) : null;
  }

  roomChanged(room) {
    this.obstacles = null;
    this.shell.show(room, this.rooms.versionOf(room) === null);
    if (this.selected?.room === room) this.outline.show(this.piece());
    this.hooks.roomsChanged(room);
    this.stage.invalidateLater();
  }

  /** Brings the viewer to a piece, or to a room. */
  visit(roomId, pieceId = null) {
    const room = this.map.rooms.find(({ id }) => id === roomId);
    if (!room) return;
    const piece = pieceId && this.rooms.pieceOf(roomId, pieceId);
    const target = piece ? piece.at : middleOf(room);
    const front = piece && directionOf(piece.angle - Math.PI / 2);
    if (this.mode === 'walk') this.walkTo(room, target, front);
    else this.view.goTo(toScene(target, piece?.bottom ?? 0), piece ? 5 : 9, front && toScene(front));
  }

  /** Puts the walker before a piece that faces `front`, or inside the door of a room. */
  walkTo(room, target, front) {
    const { walk } = this.views;
    const place = front ? add(target, scale(front, VISIT_DISTANCE)) : placeInsideDoor(room, this.map.openings);
    walk.enter(room, place ?? target);
    // In the middle of a room, there is no other way to look than the longest one.
    if (distance(walk.position, target) > NEAR_MIDDLE) walk.face(headingOf(subtract(target, walk.position)));
    else walk.face(openestHeading(walk.position, { segments: sidesOf(room.outline) }));
  }

  setLight(mode) {
    this.light.set(mode);
    this.hooks.modeChanged();
  }

  /** Asks which edits are in force; a finished bake has none to show. */
  async readEdits() {
    if (!this.site.is_editable) return;
    await this.edits.read(this.building.id);
    this.hooks.selectionChanged();
  }

  /** Keeps up with the files of the plan. */
  listen() {
    const hear = (text) => {
      const event = readEvent(text);
      if (event?.kind === 'faults') say('faults', `The plan as it is now cannot be read; the last good state stays.\n${event.faults.join('\n')}`);
      if (event?.kind === 'changed') this.followChange(event).catch((error) => say('feed', error.message));
    };
    // A stream that broke off begins again by itself; changes meanwhile are seen at the next look. Feed says if nobody answers.
    this.server.listen(hear, () => this.feed.lookNow());
  }

  async followChange({ rooms }) {
    clear('faults');
    this.feed.lookNow();
    await this.readEdits();
    // Without a list of rooms, walls and doors may have changed, too.
    if (rooms !== null) return;
    const { place } = this;
    this.levels.forget();
    const [site, map] = await Promise.all([this.server.site(), this.levels.map(place)]);
    this.site = readSite(site);
    const building = this.site.buildings.find(({ id }) => id === place.building);
    const level = building?.levels.find(({ id }) => id === place.level);
    if (!level) return this.openLevel((building ?? this.site.buildings[0]).id, null);
    Object.assign(this, { building, level });
    this.setMap(map);
    this.hooks.siteChanged();
    this.hooks.levelOpened();
    return undefined;
  }

  /** Moves everything on by a frame; gives whether there is something new to see. */
  update(seconds) {
    const isMoved = this.view.update(seconds);
    if (this.views.walk.room?.id !== this.walkedId) {
      this.walkedId = this.views.walk.room?.id;
      this.hooks.walkedRoomChanged();
    }
    if (isMoved) this.section.follow(this.mode === 'orbit' ? this.view.view() : null, this.level.height);
    this.calm = this.feed.isCalm ? this.calm + seconds : 0;
    if (this.calm > CALM) this.light.raiseSky();
    const walker = this.mode === 'walk' ? this.views.walk.position : null;
    const isSwinging = this.rooms.openings.update(walker, seconds, this.isReduced);
    const eye = this.mode === 'walk' ? this.views.walk.camera.position.toArray() : this.view.view().target;
    if (this.light.mode === 'lamp') this.light.follow(eye, this.rooms.contents().flatMap(({ lamps }) => lamps));
    return isMoved || isSwinging;
  }
}
