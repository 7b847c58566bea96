// What keys mean on the plan: the steps of a walker, and the steps of a piece.
import { add, directionOf, scale } from './frame.js';

/** Metres a second. */
const [WALK, RUN] = [1.5, 3.2];
/** Metres. */
const [STEP, SMALL_STEP] = [0.05, 0.01];

/** Metres a second of a walker who looks along `heading`; `forward` and `right` are between -1 and 1. */
export function velocityOf({ forward, right, isRunning }, heading) {
  const length = Math.max(1, Math.hypot(forward, right));
  const speed = (isRunning ? RUN : WALK) / length;
  return add(scale(directionOf(heading), forward * speed), scale(directionOf(heading - Math.PI / 2), right * speed));
}

const ARROWS = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };

/** Where an arrow key moves a piece: along the axis of the plan that points nearest to that way on the screen. Null for other keys. */
export function stepOf(key, isSmall, heading) {
  if (!(key in ARROWS)) return null;
  const quarter = Math.round((heading - Math.PI / 2) / (Math.PI / 2)) * Math.PI / 2;
  const [cosine, sine] = [Math.round(Math.cos(quarter)), Math.round(Math.sin(quarter))];
  const [x, y] = ARROWS[key];
  return scale([x * cosine - y * sine, x * sine + y * cosine], isSmall ? SMALL_STEP : STEP);
}
