// Before a door to the open air lies an apron: so far, somebody who walks gets out of the house.
import { add, distance, scale } from './frame.js';
import { boundsOf, distanceToWalls, isInRoom } from './polygon.js';

/** Metres to each side of the doorway, and metres outwards: the largest that fits between the wings of the house. */
const SIZES = [[1.5, 3], [1, 2.5], [0.5, 2], [0.2, 1.2]];
/** Metres between an apron and the inner faces of other walls, which are thick. */
const CLEARANCE = 0.35;
/** Points along each side of an apron that are tested. */
const SAMPLES = 8;
/** Metres between ground and floor: doors of higher storeys lead to balconies, which plans do not have. */
const HIGHEST_FLOOR = 1;

/** Whether a level has the ground before its doors. */
export const isOnGround = ({ elevation = 0 }) => Math.abs(elevation) <= HIGHEST_FLOOR;

/**
 * The apron of a door whose room has its inner face at `foot`: `corners` from its left end at the wall, outwards and back to the
 * wall, seen along the wall; `threshold`: the ends of the doorway at the outer face. Null where none fits.
 */
export function apronOf(way, foot, room, rooms) {
  const normal = outwards(way, room);
  const half = distance(way.center, foot);
  const point = (along, outward) => add(way.center, add(scale(way.along, along), scale(normal, half + outward)));
  for (const [aside, depth] of SIZES) {
    const reach = way.width / 2 + aside;
    if (!isFree(point, reach, depth, rooms)) continue;
    return {
      corners: [point(-reach, 0), point(-reach, depth), point(reach, depth), point(reach, 0)],
      threshold: [point(-way.width / 2, 0), point(way.width / 2, 0)],
    };
  }
  return null;
}

function outwards({ center, along }, room) {
  const normal = [-along[1], along[0]];
  return isInRoom(add(center, scale(normal, CLEARANCE)), room) ? scale(normal, -1) : normal;
}

function isFree(point, reach, depth, rooms) {
  const share = (index) => index / (SAMPLES - 1);
  const samples = Array.from({ length: SAMPLES * SAMPLES }, (_, index) => point(
    (2 * share(index % SAMPLES) - 1) * reach, CLEARANCE + share(Math.floor(index / SAMPLES)) * (depth - CLEARANCE),
  ));
  const [low, high] = boundsOf(samples);
  const near = rooms.filter(({ outline }) => {
    const [least, most] = boundsOf(outline);
    return [0, 1].every((axis) => least[axis] < high[axis] + CLEARANCE && most[axis] > low[axis] - CLEARANCE);
  });
  return samples.every((sample) => near.every((room) => !isInRoom(sample, room) && distanceToWalls(sample, room) >= CLEARANCE));
}
