// A piece at another place: its matrix, those of what it carries, and the entry of the edits file that says so.
import { add, degrees } from './frame.js';
import { IDENTITY, angleOf, inverseOf, multiplied, placed, positionOf } from '../model/matrix.js';

/** The file holds millimetres and tenths of degrees; finer steps are noise. */
const rounded = (value, digits) => Number(value.toFixed(digits)) || 0;

/** The matrix of a piece moved by `step` on the plan and turned by `angle` about its own middle. */
export function movedMatrix(piece, step, angle) {
  const [x, y] = add(piece.at, step);
  return placed([x, piece.bottom, -y], piece.angle + angle);
}

/** The piece at a new matrix, and all that it carries: a list of copies. */
export function carried(piece, matrix, pieces) {
  const change = multiplied(matrix, inverseOf(piece.matrix));
  const holderOf = ({ holder }) => pieces.find(({ id }) => id === holder);
  const isCarried = (candidate) => candidate.id === piece.id || candidate.holder !== null && isCarried(holderOf(candidate));
  return pieces.filter(isCarried).map((each) => movedTo(each, multiplied(change, each.matrix)));
}

function movedTo(piece, matrix) {
  const [x, height, z] = positionOf(matrix);
  return { ...piece, matrix, at: [x, -z], angle: angleOf(matrix), bottom: height };
}

/**
 * The entry for a piece where it is now. The frame is that of its parent if this is an object, also one that it stands beside;
 * else that of the level.
 */
export function entryOf({ matrix, parent }, pieces) {
  const frame = pieces.find(({ id }) => id === parent)?.matrix ?? IDENTITY;
  const local = multiplied(inverseOf(frame), matrix);
  const [x, , z] = positionOf(local);
  return { at: [rounded(x, 3), rounded(-z, 3)], turn: rounded((degrees(angleOf(local)) + 360) % 360, 1) };
}
