// The flight of a camera from one view to another: {position, target}, scene coordinates.
import { eased } from './doors.js';

/** Seconds of a flight: long enough to see where it goes. */
export const FLIGHT = 0.8;

/** The view after `seconds` of a flight, and whether it has arrived. */
export function viewDuring(from, to, seconds, isInstant = false) {
  const share = isInstant ? 1 : Math.min(1, seconds / FLIGHT);
  const between = (a, b) => a.map((value, axis) => value + (b[axis] - value) * eased(share));
  return { position: between(from.position, to.position), target: between(from.target, to.target), hasArrived: share === 1 };
}

/** From the target towards the viewer of a whole level: from the south-east above. */
const TOWARDS_VIEWER = [0.3, 0.8, 0.52];
/** Share of the picture that stays free around a level. */
const MARGIN = 1.06;

/**
 * The view that shows a level just wholly: bounds in plan coordinates, metres of height, vertical field of view in radians.
 * Each corner of its box asks for a distance at which it lies within the edges of the picture; the greatest one holds.
 */
export function viewOfLevel([low, high], height, fov, aspect) {
  const target = [(low[0] + high[0]) / 2, height / 3, -(low[1] + high[1]) / 2];
  const [right, up] = basisOf(TOWARDS_VIEWER);
  const tangent = Math.tan(fov / 2) / MARGIN;
  const corners = [low[0], high[0]].flatMap((x) => [0, height].flatMap((y) => [low[1], high[1]].map((north) => [x, y, -north])));
  const distances = corners.map((corner) => {
    const offset = corner.map((value, axis) => value - target[axis]);
    const across = Math.max(Math.abs(product(offset, right)) / aspect, Math.abs(product(offset, up)));
    return across / tangent + product(offset, TOWARDS_VIEWER);
  });
  const distance = Math.max(2, ...distances);
  return { target, position: target.map((value, axis) => value + TOWARDS_VIEWER[axis] * distance) };
}

const product = (a, b) => a.reduce((sum, value, axis) => sum + value * b[axis], 0);

/** The directions on the screen that are right and up for a viewer who stands in direction `backward`. */
function basisOf([x, y, z]) {
  const flat = Math.hypot(x, z);
  const right = [z / flat, 0, -x / flat];
  return [right, [-x * y / flat, flat, -z * y / flat]];
}

/** Rise to run of the view of one place: steep enough to look over the walls of a room. */
const STEEPNESS = 1.7;

/** The view of one place of a level: from the side that `front` (a direction of the scene) faces, else from where the viewer is. */
export function viewOfPlace(target, { position, target: former }, distance, front = null) {
  const direction = front ? [...front] : position.map((value, axis) => value - former[axis]);
  direction[1] = Math.max(direction[1], STEEPNESS * Math.hypot(direction[0], direction[2]));
  const length = Math.hypot(...direction) || 1;
  return { target, position: target.map((value, axis) => value + direction[axis] / length * distance) };
}
