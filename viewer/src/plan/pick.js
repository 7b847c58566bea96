// What a ray meets: boxes of pieces, and triangles. Points and directions are scene coordinates, matrices column-major arrays of 16.

/** The distance at which a ray enters the box from `low` to `high`, or null. */
export function meetsBox(origin, direction, low, high) {
  let [enter, leave] = [0, Infinity];
  for (let axis = 0; axis < 3; axis += 1) {
    const ends = [low[axis], high[axis]].map((value) => (value - origin[axis]) / direction[axis]);
    // A ray along the face of a box gives 0 / 0: it does not enter by that axis.
    if (ends.some(Number.isNaN)) continue;
    enter = Math.max(enter, Math.min(...ends));
    leave = Math.min(leave, Math.max(...ends));
  }
  return enter <= leave ? enter : null;
}

/**
 * The distance to the first triangle whose front a ray meets, or null. T. Möller and B. Trumbore, "Fast, Minimum Storage
 * Ray/Triangle Intersection", Journal of Graphics Tools, 1997, section 2.
 */
export function meetsTriangles(origin, direction, positions, indices, { start, count }, isTwoSided = false) {
  let nearest = null;
  for (let index = start; index < start + count; index += 3) {
    const found = meetsTriangle(origin, direction, positions, indices[index] * 3, indices[index + 1] * 3, indices[index + 2] * 3, isTwoSided);
    if (found !== null && (nearest === null || found < nearest)) nearest = found;
  }
  return nearest;
}

function meetsTriangle([ox, oy, oz], [dx, dy, dz], positions, a, b, c, isTwoSided) {
  const [ax, ay, az] = [positions[a], positions[a + 1], positions[a + 2]];
  const [ux, uy, uz] = [positions[b] - ax, positions[b + 1] - ay, positions[b + 2] - az];
  const [vx, vy, vz] = [positions[c] - ax, positions[c + 1] - ay, positions[c + 2] - az];
  const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
  const determinant = ux * px + uy * py + uz * pz;
  if (isTwoSided ? determinant === 0 : determinant <= 0) return null;
  const [tx, ty, tz] = [ox - ax, oy - ay, oz - az];
  const u = (tx * px + ty * py + tz * pz) / determinant;
  if (u < 0 || u > 1) return null;
  const [qx, qy, qz] = [ty * uz - tz * uy, tz * ux - tx * uz, tx * uy - ty * ux];
  const v = (dx * qx + dy * qy + dz * qz) / determinant;
  if (v < 0 || u + v > 1) return null;
  const distance = (vx * qx + vy * qy + vz * qz) / determinant;
  return distance > 0 ? distance : null;
}

/** A ray in the frame of a node that is moved and turned, but not scaled. */
export function intoFrame(origin, direction, matrix) {
  const offset = [0, 1, 2].map((axis) => origin[axis] - matrix[12 + axis]);
  const project = (vector) => [0, 1, 2].map((column) => [0, 1, 2]
    .reduce((sum, row) => sum + vector[row] * matrix[column * 4 + row], 0));
  return [project(offset), project(direction)];
}
