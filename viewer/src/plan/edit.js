// A piece at another place: its matrix, those of what it carries, and the entry of the edits file that says so.
import { add, degrees } from './frame.js';
import { angleOf, inverseOf, multiplied, placed, positionOf } from '../model/matrix.js';

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
  const isCarried = (candidate) => candidate.id === piece.id || candidate.holder !== null && isCarried(pieces.find(({ id }) => id === candidate.holder));
  return pieces.filter(isCarried).map((each) => at(each, multiplied(change, each.matrix), each.id === piece.id ? each.holderMatrix : multiplied(change, each.holderMatrix)));
}

function at(piece, matrix, holderMatrix) {
  const [x, height, z] = positionOf(matrix);
  return { ...piece, matrix, holderMatrix, at: [x, -z], angle: angleOf(matrix), bottom: height };
}

/** The entry for a piece where it is now: in the frame of the level, or of the piece that carries it. */
export function entryOf({ matrix, holderMatrix }, { isLocked = false } = {}) {
  const local = multiplied(inverseOf(holderMatrix), matrix);
  const [x, , z] = positionOf(local);
  const entry = { at: [rounded(x, 3), rounded(-z, 3)], turn: rounded((degrees(angleOf(local)) + 360) % 360, 1) };
  return isLocked ? { ...entry, lock: true } : entry;
}
