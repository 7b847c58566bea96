// Doors stand shut, and open before somebody who comes near.
import { distance, headingOf, subtract, wrapped } from './frame.js';

/** Metres from the middle of a doorway at which its leaves begin to swing. */
const NEAR = 1.5;
/** Seconds from shut to open. */
const SWING = 0.45;
/** A leaf belongs to the hinge that is this near to its node (metres); they differ by rounding. */
const SAME_HINGE = 0.05;

/** By how much a leaf turns from the file's open state until it is shut (radians), 0 for leaves without a hinge. */
export function closingTurn(hingeOfNode, leaves = []) {
  const leaf = leaves.find(({ hinge }) => distance(hinge, hingeOfNode) < SAME_HINGE);
  if (!leaf) return 0;
  return wrapped(headingOf(subtract(leaf.closed, leaf.hinge)) - headingOf(subtract(leaf.open, leaf.hinge)));
}

/** By how much each leaf {from, to} of a sliding door moves along the wall until it is open: into the wall at the nearer side. */
export function slidesOf(leaves) {
  const [low, high] = [Math.min(...leaves.map(({ from }) => from)), Math.max(...leaves.map(({ to }) => to))];
  return leaves.map(({ from, to }) => from + to > low + high ? high - from : low - to);
}

export const isNear = (walker, center) => walker !== null && distance(walker, center) < NEAR;

/** The next openness of a door, 0 shut to 1 open. */
export function swung(openness, isWanted, seconds, isInstant = false) {
  const target = isWanted ? 1 : 0;
  if (isInstant) return target;
  const step = seconds / SWING;
  return openness < target ? Math.min(target, openness + step) : Math.max(target, openness - step);
}

/** Begins and ends softly. */
export const eased = (share) => share * share * (3 - 2 * share);
