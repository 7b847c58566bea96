// Questions about rooms as polygons: an outline and holes, each a ring of points.
import { add, distance, dot, scale, subtract } from './frame.js';

/** The sides of a ring, the last from its last corner to its first. */
export function sidesOf(ring) {
  return ring.map((corner, index) => [corner, ring[(index + 1) % ring.length]]);
}

export function isInside(point, ring) {
  let inside = false;
  for (const [a, b] of sidesOf(ring)) {
    if ((a[1] > point[1]) === (b[1] > point[1])) continue;
    const x = a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    if (point[0] < x) inside = !inside;
  }
  return inside;
}

export function isInRoom(point, { outline, holes = [] }) {
  return isInside(point, outline) && !holes.some((hole) => isInside(point, hole));
}

/** The room that holds a point, or null. */
export function roomAt(rooms, point) {
  return rooms.find((room) => isInRoom(point, room)) ?? null;
}

export function nearestOnSegment(point, [a, b]) {
  const along = subtract(b, a);
  const square = dot(along, along);
  if (square === 0) return a;
  const share = Math.min(1, Math.max(0, dot(subtract(point, a), along) / square));
  return add(a, scale(along, share));
}

/** Metres from a point to the walls of a room. */
export function distanceToWalls(point, { outline, holes = [] }) {
  const sides = [outline, ...holes].flatMap(sidesOf);
  return Math.min(...sides.map((side) => distance(point, nearestOnSegment(point, side))));
}

export function boundsOf(points) {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return [[Math.min(...xs), Math.min(...ys)], [Math.max(...xs), Math.max(...ys)]];
}

/** The point of a lattice over the room that is farthest from its walls: the middle, also of a room shaped like an L. */
export function middleOf(room, steps = 12) {
  let [best, most] = [room.outline[0], -1];
  for (const point of latticeOf(room, steps)) {
    if (!isInRoom(point, room)) continue;
    const clearance = distanceToWalls(point, room);
    if (clearance > most + 1e-9) [best, most] = [point, clearance];
  }
  return best;
}

/** Points of a lattice over the bounds of a room, some of them outside it. */
export function latticeOf({ outline }, steps) {
  const [low, high] = boundsOf(outline);
  const points = [];
  for (let row = 0; row < steps; row += 1) {
    for (let column = 0; column < steps; column += 1) {
      points.push([
        low[0] + (column + 0.5) / steps * (high[0] - low[0]),
        low[1] + (row + 0.5) / steps * (high[1] - low[1]),
      ]);
    }
  }
  return points;
}

/** The point itself if it is in the room, else the middle of the room: where one gets out of a lift that moved aside. */
export function clampedInto(point, room, clearance) {
  if (isInRoom(point, room) && distanceToWalls(point, room) >= clearance) return point;
  return middleOf(room);
}
