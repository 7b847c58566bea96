// Matrices of nodes: arrays of 16, column by column, as glTF writes them.

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The matrix of a glTF node. */
export function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return matrix;
  const [x, y, z, w] = rotation;
  const columns = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  return [...columns.flatMap((column, axis) => [...column.map((value) => value * scale[axis]), 0]), ...translation, 1];
}

/** First `b`, then `a`. */
export function multiplied(a, b) {
  const product = new Array(16);
  for (let column = 0; column < 4; column += 1) {
    for (let row = 0; row < 4; row += 1) {
      let sum = 0;
      for (let index = 0; index < 4; index += 1) sum += a[index * 4 + row] * b[column * 4 + index];
      product[column * 4 + row] = sum;
    }
  }
  return product;
}

/** A turn about Y (radians), then a move. */
export function placed([x, y, z], angle) {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return [cosine, 0, -sine, 0, 0, 1, 0, 0, sine, 0, cosine, 0, x, y, z, 1];
}

/** The way back through a matrix without scale. */
export function inverseOf(matrix) {
  const turn = [0, 1, 2].flatMap((column) => [...[0, 1, 2].map((row) => matrix[row * 4 + column]), 0]);
  const move = [0, 1, 2].map((row) => -[0, 1, 2].reduce((sum, axis) => sum + turn[axis * 4 + row] * matrix[12 + axis], 0));
  return [...turn, ...move, 1];
}

/** Radians about Y of a matrix that turns about nothing else. */
export const angleOf = (matrix) => Math.atan2(matrix[8], matrix[0]);

export const positionOf = (matrix) => [matrix[12], matrix[13], matrix[14]];
