// The walls of a level: the outlines of rooms with their openings, and those that stop somebody who walks.
import { apronOf, isOnGround } from './aprons.js';
import { add, cross, dot, scale, subtract } from './frame.js';
import { isInRoom, sidesOf } from './polygon.js';

/** Farther from the middle of an opening, a side of a room is another wall (metres): the thickest walls of plans, and some. */
const FARTHEST_FACE = 0.9;
/** Sine of the angle up to which a side is parallel to an opening. */
const PARALLEL = 0.05;
/** An opening that begins higher is a window, one that ends lower a hatch (metres). */
const [HIGHEST_STEP, LOWEST_LINTEL] = [0.25, 1.7];

/** Whether people get through: also by doors, which open by themselves. */
export function isWay({ kind, bottom, top }) {
  return kind !== 'window' && bottom <= HIGHEST_STEP && top >= LOWEST_LINTEL;
}

/** The sides of all rooms with the openings in them: {room, segment, gaps: [{opening, from, to}]}, metres along the segment. */
export function facesOf({ rooms, openings }) {
  const faces = rooms.flatMap((room) => [room.outline, ...room.holes ?? []].flatMap(sidesOf)
    .map((segment) => ({ room: room.id, segment, gaps: [] })));
  for (const opening of openings) {
    for (const room of opening.rooms) {
      const found = nearestFace(opening, faces.filter((face) => face.room === room));
      found?.face.gaps.push({ opening, from: found.from, to: found.to });
    }
  }
  return faces;
}

/** What somebody who walks on a level meets: `walls`, segments; `ways`, the openings that let through; `aprons` before the house. */
export function groundOf(level) {
  const faces = facesOf(level);
  const aprons = new Map();
  for (const way of isOnGround(level) ? level.openings.filter((each) => isWay(each) && each.rooms.length === 1) : []) {
    const apron = apronBefore(way, faces, level.rooms);
    if (apron) aprons.set(way, apron);
  }
  const ways = level.openings.filter((opening) => isWay(opening) && (opening.rooms.length > 1 || aprons.has(opening)));
  const walls = [
    ...faces.flatMap((face) => remaining(face.segment, face.gaps.filter(({ opening }) => ways.includes(opening)))),
    ...ways.flatMap((way) => reveals(way, endsOf(way, faces), aprons.get(way))),
  ];
  return { walls, ways, aprons: [...aprons.values()] };
}

function apronBefore(way, faces, rooms) {
  const [ends] = endsOf(way, faces);
  const room = rooms.find(({ id }) => id === way.rooms[0]);
  if (!ends || !room) return null;
  const middle = scale(add(...ends), 0.5);
  // The foot lies straight before the middle of the doorway, also where a corner cuts the gap.
  const foot = add(middle, scale(way.along, dot(subtract(way.center, middle), way.along)));
  return apronOf(way, foot, room, rooms);
}

/** The ends of a doorway in the face of each of its rooms, in the order of its direction. */
function endsOf(way, faces) {
  return faces.flatMap(({ segment, gaps }) => gaps.filter(({ opening }) => opening === way)
    .map(({ from, to }) => [pointAlong(segment, from), pointAlong(segment, to)].sort((a, b) => dot(subtract(a, b), way.along))));
}

/** The sides of a doorway across the wall, and the edges of the apron before it. */
function reveals(way, ends, apron) {
  const outer = apron ? [...ends, apron.threshold] : ends;
  if (outer.length < 2) return [];
  const across = [0, 1].map((end) => [outer[0][end], outer[1][end]]);
  if (!apron) return across;
  const edge = [apron.threshold[0], ...apron.corners, apron.threshold[1]];
  return [...across, ...edge.slice(1).map((corner, index) => [edge[index], corner])];
}

function nearestFace(opening, faces) {
  const found = faces.map((face) => overlapOf(opening, face)).filter(Boolean);
  return found.sort((a, b) => a.distance - b.distance)[0] ?? null;
}

function overlapOf(opening, face) {
  const [a, b] = face.segment;
  const along = subtract(b, a);
  const length = Math.hypot(...along);
  if (length === 0) return null;
  const direction = scale(along, 1 / length);
  if (Math.abs(cross(direction, opening.along)) > PARALLEL) return null;
  const offset = subtract(opening.center, a);
  const distance = Math.abs(cross(direction, offset));
  const middle = dot(direction, offset);
  const [from, to] = [Math.max(0, middle - opening.width / 2), Math.min(length, middle + opening.width / 2)];
  return distance > FARTHEST_FACE || to - from < opening.width / 2 ? null : { face, distance, from, to };
}

function pointAlong([a, b], metres) {
  const along = subtract(b, a);
  return add(a, scale(along, metres / Math.hypot(...along)));
}

/** What is left of a segment between gaps. */
export function remaining(segment, gaps) {
  const length = Math.hypot(...subtract(segment[1], segment[0]));
  const pieces = [];
  let from = 0;
  for (const gap of [...gaps].sort((a, b) => a.from - b.from)) {
    if (gap.from > from) pieces.push([from, gap.from]);
    from = Math.max(from, gap.to);
  }
  if (length > from) pieces.push([from, length]);
  return pieces.map(([start, end]) => [pointAlong(segment, start), pointAlong(segment, end)]);
}

/** Metres from the middle of a door to somebody who came in by it. */
const INSIDE = 0.75;

/** Where somebody stands who came into a room by its first door, or null: furniture leaves the places before doors free. */
export function placeInsideDoor(room, openings) {
  const door = doorOf(room, openings);
  if (!door) return null;
  const normal = scale([-door.along[1], door.along[0]], INSIDE);
  return [add(door.center, normal), subtract(door.center, normal)].find((place) => isInRoom(place, room)) ?? null;
}

/** The first door of a room. */
export function doorOf(room, openings) {
  return openings.find(({ kind, rooms }) => kind !== 'window' && rooms.includes(room.id)) ?? null;
}
