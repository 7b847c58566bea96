// The walls that stop somebody who walks: the outlines of rooms without the openings that one can walk through.
import { add, cross, dot, scale, subtract } from './frame.js';
import { isInRoom, sidesOf } from './polygon.js';

/** Farther from the middle of an opening, a side of a room is another wall (metres): the thickest walls of plans, and some. */
const FARTHEST_FACE = 0.9;
/** Sine of the angle up to which a side is parallel to an opening. */
const PARALLEL = 0.05;
/** An opening that begins higher is a window, one that ends lower a hatch (metres). */
const [HIGHEST_STEP, LOWEST_LINTEL] = [0.25, 1.7];

/** Whether people walk through: also doors, which open by themselves. Doors to the open air stay shut, for nothing is shown there. */
export function isWay({ kind, bottom, top, rooms }) {
  return kind !== 'window' && rooms.length > 1 && bottom <= HIGHEST_STEP && top >= LOWEST_LINTEL;
}

/** Segments of all walls of a level, cut where ways lead through, with the reveals of these ways. */
export function wallsOf({ rooms, openings }) {
  const sides = rooms.flatMap((room) => [room.outline, ...room.holes ?? []].flatMap(sidesOf)
    .map((segment) => ({ room: room.id, segment, gaps: [] })));
  const reveals = openings.filter(isWay).flatMap((way) => cutOut(way, sides));
  return [...sides.flatMap(remaining), ...reveals];
}

/** Notes the gap in the face of each room, and gives the two segments across the wall. */
function cutOut(way, sides) {
  const faces = way.rooms.map((room) => nearestFace(way, sides.filter((side) => side.room === room))).filter(Boolean);
  const ends = faces.map(({ side, from, to }) => {
    side.gaps.push([from, to]);
    return [pointAlong(side.segment, from), pointAlong(side.segment, to)]
      .sort((a, b) => dot(subtract(a, b), way.along));
  });
  if (ends.length < 2) return [];
  return [0, 1].map((end) => [ends[0][end], ends[1][end]]);
}

function nearestFace(way, sides) {
  const faces = sides.map((side) => faceOf(way, side)).filter(Boolean);
  return faces.sort((a, b) => a.distance - b.distance)[0] ?? null;
}

function faceOf(way, side) {
  const [a, b] = side.segment;
  const along = subtract(b, a);
  const length = Math.hypot(...along);
  if (length === 0) return null;
  const direction = scale(along, 1 / length);
  if (Math.abs(cross(direction, way.along)) > PARALLEL) return null;
  const offset = subtract(way.center, a);
  const distance = Math.abs(cross(direction, offset));
  const middle = dot(direction, offset);
  const [from, to] = [Math.max(0, middle - way.width / 2), Math.min(length, middle + way.width / 2)];
  return distance > FARTHEST_FACE || to - from < way.width / 2 ? null : { side, distance, from, to };
}

function pointAlong([a, b], metres) {
  const along = subtract(b, a);
  return add(a, scale(along, metres / Math.hypot(...along)));
}

/** What is left of a side between its gaps. */
function remaining({ segment, gaps }) {
  const length = Math.hypot(...subtract(segment[1], segment[0]));
  const pieces = [];
  let from = 0;
  for (const [start, end] of [...gaps].sort((a, b) => a[0] - b[0])) {
    if (start > from) pieces.push([from, start]);
    from = Math.max(from, end);
  }
  if (length > from) pieces.push([from, length]);
  return pieces.map(([start, end]) => [pointAlong(segment, start), pointAlong(segment, end)]);
}

/** Metres from the middle of a door to somebody who came in by it. */
const INSIDE = 0.75;

/** Where somebody stands who came into a room by its first door, or null: furniture leaves the places before doors free. */
export function placeInsideDoor(room, openings) {
  const door = openings.find(({ kind, rooms }) => kind !== 'window' && rooms.includes(room.id));
  if (!door) return null;
  const normal = scale([-door.along[1], door.along[0]], INSIDE);
  return [add(door.center, normal), subtract(door.center, normal)].find((place) => isInRoom(place, room)) ?? null;
}
