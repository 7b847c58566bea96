// The crossing of axes: plans have x east and y north, the scene has Y up, and a plan's (x, y) lies at (x, height, -y).
// A heading is in radians counter-clockwise from east; the turn of a piece is counter-clockwise from facing south.

export const toScene = ([x, y], height = 0) => [x, height, -y];

export const toPlan = ([x, , z]) => [x, -z];

export const directionOf = (heading) => [Math.cos(heading), Math.sin(heading)];

export const headingOf = ([x, y]) => Math.atan2(y, x);

export const degrees = (radians) => radians * 180 / Math.PI;

export const radians = (angle) => angle * Math.PI / 180;

/** The same angle between -π and π. */
export function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

export const subtract = ([ax, ay], [bx, by]) => [ax - bx, ay - by];

export const add = ([ax, ay], [bx, by]) => [ax + bx, ay + by];

export const scale = ([x, y], factor) => [x * factor, y * factor];

export const dot = ([ax, ay], [bx, by]) => ax * bx + ay * by;

export const cross = ([ax, ay], [bx, by]) => ax * by - ay * bx;

export const lengthOf = ([x, y]) => Math.hypot(x, y);

export const distance = (a, b) => lengthOf(subtract(a, b));

/** A point turned about the origin. */
export function turned([x, y], angle) {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return [x * cosine - y * sine, x * sine + y * cosine];
}
