// A walker is a circle that walls, columns and furniture push out.
import { add, cross, directionOf, distance, lengthOf, scale, subtract, turned } from './frame.js';
import { isInRoom, latticeOf, middleOf, nearestOnSegment, sidesOf } from './polygon.js';

/** Half of the width that a walker takes (metres): passes the narrowest doors with some slack. */
export const WALKER_RADIUS = 0.2;
/** A step longer than this could cross a wall between two tests (metres). */
const LONGEST_STEP = 0.1;
/** In a corner, one wall pushes against the next; more rounds than this change nothing that is seen. */
const ROUNDS = 4;
/** One steps over what is lower, and walks below what hangs higher (metres). */
const [LOWEST_OBSTACLE, HIGHEST_OBSTACLE] = [0.05, 1.9];

/** Whether a piece is in the way: {size: [width, depth, height], bottom}. */
export function isObstacle({ size, bottom }) {
  return bottom < HIGHEST_OBSTACLE && bottom + size[2] >= LOWEST_OBSTACLE;
}

/** The box of a piece on the floor: {center, half, angle}. */
export function footprintOf({ at, angle, size }) {
  return { center: at, half: [size[0] / 2, size[1] / 2], angle };
}

/** What `move` and `findFree` ask for: walls of a level, outlines of columns and boxes of furniture. */
export function obstaclesOf(walls, columns, boxes) {
  return { segments: [...walls, ...columns.flatMap(sidesOf)], boxes };
}

/** Where a walker gets to who wants to go from `position` by `step`. */
export function move(position, step, obstacles) {
  const count = Math.max(1, Math.ceil(lengthOf(step) / LONGEST_STEP));
  const part = scale(step, 1 / count);
  const near = nearby(position, lengthOf(step) + 1, obstacles);
  let reached = position;
  for (let index = 0; index < count; index += 1) reached = pushedOut(add(reached, part), near);
  return reached;
}

/** Only what a step can touch is tested part by part. */
function nearby(position, reach, { segments, boxes }) {
  return {
    segments: segments.filter((segment) => distance(position, nearestOnSegment(position, segment)) < reach),
    boxes: boxes.filter(({ center, half }) => distance(position, center) < reach + lengthOf(half)),
  };
}

function pushedOut(position, { segments, boxes }) {
  let free = position;
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const segment of segments) free = pushedBySegment(free, segment);
    for (const box of boxes) free = pushedByBox(free, box);
  }
  // Two obstacles that are closer than the walker is wide push in turn for ever: then the walker stays where they meet.
  return free;
}

function pushedBySegment(position, segment) {
  const nearest = nearestOnSegment(position, segment);
  const away = subtract(position, nearest);
  const gap = lengthOf(away);
  if (gap >= WALKER_RADIUS || gap === 0) return position;
  return add(nearest, scale(away, WALKER_RADIUS / gap));
}

function pushedByBox(position, { center, half, angle }) {
  const local = turned(subtract(position, center), -angle);
  const nearest = local.map((value, axis) => Math.min(half[axis], Math.max(-half[axis], value)));
  const away = subtract(local, nearest);
  const gap = lengthOf(away);
  if (gap >= WALKER_RADIUS) return position;
  const free = gap > 0 ? add(nearest, scale(away, WALKER_RADIUS / gap)) : leftBy(local, half);
  return add(center, turned(free, angle));
}

/** A walker inside a box leaves it by its nearest side. */
function leftBy(local, half) {
  const depths = [0, 1].map((axis) => half[axis] - Math.abs(local[axis]));
  const axis = depths[0] < depths[1] ? 0 : 1;
  const free = [...local];
  free[axis] = Math.sign(local[axis] || 1) * (half[axis] + WALKER_RADIUS);
  return free;
}

/** Whether a walker stands there without touching anything. */
export function isFree(position, { segments, boxes }) {
  const tolerance = 1e-6;
  return segments.every((segment) => distance(position, nearestOnSegment(position, segment)) > WALKER_RADIUS - tolerance)
    && boxes.every((box) => distance(position, pushedByBox(position, box)) < tolerance);
}

/** The free place of a room that is nearest to a point; the middle of the room if furniture leaves none. */
export function findFree(room, wanted, obstacles) {
  if (isInRoom(wanted, room) && isFree(wanted, obstacles)) return wanted;
  const places = latticeOf(room, 24).filter((point) => isInRoom(point, room) && isFree(point, obstacles));
  places.sort((a, b) => distance(a, wanted) - distance(b, wanted));
  return places[0] ?? middleOf(room);
}

/** The direction (radians) in which somebody sees farthest before a wall, of a few. */
export function openestHeading(position, { segments }) {
  const headings = Array.from({ length: 16 }, (_, index) => index * Math.PI / 8);
  const farthest = headings.map((heading) => Math.min(...segments.map((segment) => distanceAlong(position, directionOf(heading), segment))));
  return headings[farthest.indexOf(Math.max(...farthest))];
}

/** Metres until a ray meets a segment, Infinity if it does not. */
function distanceAlong(origin, direction, [a, b]) {
  const along = subtract(b, a);
  const denominator = cross(direction, along);
  if (denominator === 0) return Infinity;
  const offset = subtract(a, origin);
  const [far, share] = [cross(offset, along) / denominator, cross(offset, direction) / denominator];
  return far >= 0 && share >= 0 && share <= 1 ? far : Infinity;
}
