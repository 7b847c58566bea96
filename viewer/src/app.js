// What is shown now, and the ways to change that: building, level, way of looking, chosen piece. The controls call it; it calls `hooks`.
import { Batches } from './model/batches.js';
import { Library } from './model/library.js';
import { Rooms } from './model/rooms.js';
import { obstaclesOf, openestHeading } from './plan/collision.js';
import { add, directionOf, distance, headingOf, scale, subtract, toPlan, toScene } from './plan/frame.js';
import { boundsOf, clampedInto, middleOf, roomAt, sidesOf } from './plan/polygon.js';
import { placeInsideDoor, wallsOf } from './plan/walls.js';
import { readEvent, readLevel, readPlace, readSite, writePlace } from './server/contract.js';
import { Feed } from './server/feed.js';
import { clear, say } from './page/messages.js';
import { Light } from './view/light.js';
import { OrbitView, PlanView } from './view/orbit.js';
import { Neighbours, Outline } from './view/outline.js';
import { Storeys } from './view/storeys.js';
import { WalkView } from './view/walk.js';

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
    this.light = new Light(stage);
    this.outline = new Outline(stage.scene);
    this.neighbours = new Neighbours(stage.scene);
    this.storeys = new Storeys(stage.scene);
    const anisotropy = Math.min(8, stage.renderer.capabilities.getMaxAnisotropy());
    this.feed = new Feed(server, new Library(this.batches, anisotropy), this.rooms, {
      viewpoint: () => this.view.viewpoint(),
      changed: (room) => this.roomChanged(room),
      failed: (error) => say('feed', `The view is not up to date: ${error.message}.`),
      recovered: () => clear('feed'),
      broken: (error, room) => say('broken', `Room ${room} cannot be shown: ${error.message}. ${AFTER_BREAKAGE}`),
      mended: () => clear('broken'),
    });
    this.views = {
      orbit: new OrbitView(stage, isReduced), plan: new PlanView(stage, isReduced), walk: new WalkView(stage, () => this.ground()),
    };
    this.mode = 'orbit';
    this.map = { rooms: [], openings: [] };
    this.selected = null;
    this.hooks = { levelOpened() {}, modeChanged() {}, roomsChanged() {}, selectionChanged() {}, siteChanged() {} };
    stage.resized = (aspect) => Object.values(this.views).forEach((view) => view.resize(aspect));
  }

  get view() {
    return this.views[this.mode];
  }

  get place() {
    return { building: this.building.id, level: this.level.id };
  }

  async start() {
    this.site = readSite(await this.server.site());
    const wanted = readPlace(window.location.hash);
    const building = this.site.buildings.find(({ id }) => id === wanted.building) ?? this.site.buildings[0];
    this.hooks.siteChanged();
    await this.openLevel(building.id, wanted.level);
    this.setMode(wanted.mode);
    if (this.site.kind === 'plan') this.listen();
  }

  /** Shows a level; the first one of the building if it has none of that id. */
  async openLevel(buildingId, levelId) {
    const building = this.site.buildings.find(({ id }) => id === buildingId);
    const level = building.levels.find(({ id }) => id === levelId) ?? building.levels[0];
    const isOther = building !== this.building;
    const map = readLevel(await this.server.level({ building: building.id, level: level.id }));
    this.rooms.clear();
    this.batches.tidy();
    Object.assign(this, { building, level });
    this.setMap(map);
    this.select(null);
    this.light.lowerGround(level.elevation);
    this.neighbours.show(building, level, this.site.buildings);
    if (isOther || this.mode !== 'walk') this.fit();
    if (isOther) this.enterSomewhere();
    this.feed.open(this.place, this.site.kind === 'bake');
    this.keepPlace();
    this.hooks.levelOpened();
    this.stage.invalidate();
    await this.showStoreysBelow();
  }

  async showStoreysBelow() {
    const { building, level } = this;
    this.storeys.clear();
    const below = building.levels.filter(({ elevation }) => elevation < level.elevation);
    const maps = await Promise.all(below.map(({ id }) => this.server.level({ building: building.id, level: id })));
    if (level !== this.level) return;
    this.storeys.show(level.elevation, maps.map(readLevel));
    this.stage.invalidate();
  }

  setMap(map) {
    this.map = map;
    this.walls = wallsOf(map);
    this.obstacles = null;
  }

  /** Rooms and obstacles of the level as a walker asks for them. */
  ground() {
    this.obstacles ??= obstaclesOf(this.walls, this.rooms.bodies());
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
    const target = this.roomBeyond(direction);
    const index = this.building.levels.indexOf(this.level) + (direction === 'above' ? 1 : -1);
    if (!target || !this.building.levels[index]) return;
    const { position } = this.views.walk;
    await this.openLevel(this.building.id, this.building.levels[index].id);
    const room = this.map.rooms.find(({ id }) => id === target);
    if (room) this.views.walk.enter(room, clampedInto(position, room, 0.3));
  }

  /** The room above or below the walker, to which stairs or a lift lead, or null. */
  roomBeyond(direction) {
    const { room } = this.views.walk;
    return this.map.rooms.find(({ id }) => id === room?.id)?.[direction] ?? null;
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

  /** Keeps up with the files of the plan. */
  listen() {
    const events = new EventSource('api/events');
    events.addEventListener('message', ({ data }) => {
      const event = readEvent(data);
      if (event?.kind === 'faults') say('faults', `The plan as it is now cannot be read; the last good state stays.\n${event.faults.join('\n')}`);
      if (event?.kind === 'changed') this.followChange(event).catch((error) => say('feed', error.message));
    });
    // A stream that broke off begins again by itself; changes meanwhile are seen at the next look. Feed says if nobody answers.
    events.addEventListener('open', () => this.feed.lookNow());
  }

  async followChange({ rooms }) {
    clear('faults');
    this.feed.lookNow();
    // Without a list of rooms, walls and doors may have changed, too.
    if (rooms !== null) return;
    const { place } = this;
    const [site, map] = await Promise.all([this.server.site(), this.server.level(place)]);
    this.site = readSite(site);
    const building = this.site.buildings.find(({ id }) => id === place.building);
    const level = building?.levels.find(({ id }) => id === place.level);
    if (!level) return this.openLevel((building ?? this.site.buildings[0]).id, null);
    Object.assign(this, { building, level });
    this.setMap(readLevel(map));
    this.hooks.siteChanged();
    this.hooks.levelOpened();
    return undefined;
  }

  /** Moves everything on by a frame; gives whether there is something new to see. */
  update(seconds) {
    const isMoved = this.view.update(seconds);
    const walker = this.mode === 'walk' ? this.views.walk.position : null;
    const isSwinging = this.rooms.openings.update(walker, seconds, this.isReduced);
    const eye = this.mode === 'walk' ? this.views.walk.camera.position.toArray() : this.view.view().target;
    if (this.light.mode === 'lamp') this.light.follow(eye, this.rooms.contents().flatMap(({ lamps }) => lamps));
    return isMoved || isSwinging;
  }
}
