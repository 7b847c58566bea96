// A way for somebody who walks by keys: around furniture, through doors.
import { isFree } from '../../viewer/src/plan/collision.js';

/** Metres between the places that are tried. */
const MESH = 0.25;
/** Metres that a walker needs more than the page asks for: keys are no precise way to walk. */
const SLACK = 0.06;
const NEIGHBOURS = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1]];

/** Places to walk to one after the other, the last one as near to `wanted` as furniture allows; throws where there is no way. A*, by P. Hart, N. Nilsson and B. Raphael, 1968. */
export function routeTo(from, wanted, ground) {
  const near = nearby(ground);
  const to = freeNear(wanted, near);
  const free = new Map();
  const placeOf = ([column, row]) => [from[0] + column * MESH, from[1] + row * MESH];
  const isOpen = (cell) => {
    const key = cell.join();
    if (!free.has(key)) free.set(key, around(placeOf(cell)).every((place) => isFree(place, near(place))));
    return free.get(key);
  };
  const far = (cell) => Math.hypot(...placeOf(cell).map((value, axis) => value - to[axis]));
  const reached = new Map([['0,0', { cell: [0, 0], length: 0, before: null }]]);
  const open = [{ key: '0,0', cost: 0 }];
  while (open.length > 0) {
    const { key } = open.pop();
    const here = reached.get(key);
    if (far(here.cell) < MESH) return [...straightened([from, ...placesTo(here, placeOf)], near).slice(1), to];
    for (const step of NEIGHBOURS) {
      const cell = here.cell.map((value, axis) => value + step[axis]);
      const length = here.length + Math.hypot(...step) * MESH;
      if ((reached.get(cell.join())?.length ?? Infinity) <= length + 1e-9 || !isOpen(cell)) continue;
      reached.set(cell.join(), { cell, length, before: here });
      insert(open, { key: cell.join(), cost: length + far(cell) });
    }
    if (reached.size > 40_000) break;
  }
  throw new Error(`no way from ${from} to ${to}`);
}

/** Metres: whatever stands in a doorway or before it is not larger. */
const FARTHEST = 1;

function freeNear(wanted, near) {
  const steps = Math.round(FARTHEST / MESH);
  const offsets = Array.from({ length: 2 * steps + 1 }, (_, index) => (index - steps) * MESH);
  const places = offsets.flatMap((x) => offsets.map((y) => [x, y])).sort((a, b) => Math.hypot(...a) - Math.hypot(...b))
    .map(([x, y]) => [wanted[0] + x, wanted[1] + y]);
  return places.find((place) => around(place).every((each) => isFree(each, near(each)))) ?? wanted;
}

/** Keeps the list sorted, the cheapest last. */
function insert(open, entry) {
  let [low, high] = [0, open.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (open[middle].cost > entry.cost) low = middle + 1;
    else high = middle;
  }
  open.splice(low, 0, entry);
}

/** Metres of a square of the plan whose obstacles are looked up together, and from it to an obstacle that matters there. */
const [SQUARE, REACH] = [2, 0.5];

/** The obstacles near a place: without this, each place would be tested against the whole level. */
function nearby({ segments, boxes }) {
  const squares = new Map();
  return (place) => {
    const corner = place.map((value) => Math.floor(value / SQUARE) * SQUARE);
    const key = corner.join();
    if (!squares.has(key)) {
      const touches = (low, high) => [0, 1].every((axis) => low[axis] < corner[axis] + SQUARE + REACH && high[axis] > corner[axis] - REACH);
      squares.set(key, {
        segments: segments.filter(([a, b]) => touches(a.map((value, axis) => Math.min(value, b[axis])), a.map((value, axis) => Math.max(value, b[axis])))),
        boxes: boxes.filter(({ center, half }) => touches(center.map((value) => value - Math.hypot(...half)), center.map((value) => value + Math.hypot(...half)))),
      });
    }
    return squares.get(key);
  };
}

const around = ([x, y]) => [[x, y], ...[[1, 0], [-1, 0], [0, 1], [0, -1]].map(([east, north]) => [x + east * SLACK, y + north * SLACK])];

function placesTo(last, placeOf) {
  const places = [];
  for (let each = last; each.before; each = each.before) places.unshift(placeOf(each.cell));
  return places;
}

/** Leaves out places that one passes on a straight way. */
function straightened(places, near) {
  const kept = [];
  for (let index = 0; index < places.length;) {
    let next = index;
    while (next + 1 < places.length && isStraight(kept.at(-1) ?? places[0], places[next + 1], near)) next += 1;
    kept.push(places[next]);
    index = next + 1;
  }
  return kept;
}

function isStraight(from, to, near) {
  const count = Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / 0.1);
  return Array.from({ length: count + 1 }, (_, index) => from.map((value, axis) => value + (to[axis] - value) * index / Math.max(1, count)))
    .every((place) => around(place).every((each) => isFree(each, near(each))));
}
