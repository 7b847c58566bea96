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

/** The view of a whole level from the south-east above: bounds in plan coordinates, vertical field of view in radians. */
export function viewOfLevel([low, high], height, fov, aspect) {
  const [width, depth] = [high[0] - low[0], high[1] - low[1]];
  const radius = Math.max(1, Math.hypot(width, depth, height) / 2);
  // The narrower of the two angles of the picture decides.
  const half = Math.min(fov / 2, Math.atan(Math.tan(fov / 2) * aspect));
  const distance = radius / Math.sin(half) * 0.92;
  const target = [(low[0] + high[0]) / 2, 0, -(low[1] + high[1]) / 2];
  const direction = [0.42, 0.78, 0.62];
  const length = Math.hypot(...direction);
  return { target, position: target.map((value, axis) => value + direction[axis] / length * distance) };
}

/** The view of one place of a level, keeping the direction of the present view. */
export function viewOfPlace(target, { position, target: former }, distance = 5) {
  const direction = position.map((value, axis) => value - former[axis]);
  direction[1] = Math.max(direction[1], 0.9 * Math.hypot(direction[0], direction[2]));
  const length = Math.hypot(...direction) || 1;
  return { target, position: target.map((value, axis) => value + direction[axis] / length * distance) };
}
