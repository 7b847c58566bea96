// What a plain bake says of its pieces, read without any client: where the triangles of each are, and what its extras name it.
import { readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';

const READERS = {
  5121: (view, at) => view.getUint8(at), 5123: (view, at) => view.getUint16(at, true),
  5125: (view, at) => view.getUint32(at, true), 5126: (view, at) => view.getFloat32(at, true),
};
const WIDTHS = { 5121: 1, 5123: 2, 5125: 4, 5126: 4 };
const PARTS = { SCALAR: 1, VEC3: 3 };

/** The pieces of all levels of a building's folder: a map from `keyOf` to {triangles, low, high}, in the frame of the site, z up. */
export function readPieces(folder) {
  const pieces = new Map();
  const names = readdirSync(folder).filter((name) => name.endsWith('.glb'));
  for (const name of names) new Level(join(folder, name), pieces);
  // The walls of a room are one mesh, and the nodes of the single ones have none: where they are, the mesh is.
  for (const [key, whole] of pieces) if (!pieces.get(key).triangles.length) pieces.set(key, pieces.get(whole.drawnBy) ?? whole);
  return pieces;
}

/** One text for what the table of a tile and the extras of a bake both name. */
export const keyOf = ({ building, level, room, class: kind, id }) => [building, level, room, kind, id].join(' | ');

/** Reads the nodes of a file: each belongs to the nearest node above it, itself included, that is a piece. */
class Level {
  constructor(path, pieces) {
    const bytes = readFileSync(path);
    const length = bytes.readUInt32LE(12);
    this.json = JSON.parse(bytes.subarray(20, 20 + length).toString());
    const start = 20 + length + 8;
    this.view = new DataView(bytes.buffer, bytes.byteOffset + start, bytes.length - start);
    this.pieces = pieces;
    this.positions = new Map();
    const level = this.json.nodes.find((node) => node.extras?.kind === 'level')?.extras;
    if (!level) throw new Error(`${basename(path)}: no node of a level`);
    const facts = { building: level.building, level: level.level, room: '', opening: false };
    const rise = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, level.elevation, 0, 1];
    for (const root of this.json.scenes[this.json.scene ?? 0].nodes) this.walk(root, rise, facts, null);
  }

  walk(index, above, facts, piece) {
    const node = this.json.nodes[index];
    const matrix = product(above, matrixOf(node));
    const { extras = {} } = node;
    if (extras.kind === 'room') facts = { ...facts, room: extras.room };
    if (extras.kind === 'opening') {
      piece = keyOf({ ...facts, room: extras.rooms.join(' '), class: extras.closure, id: `${extras.opening}:${extras.id}` });
      facts = { ...facts, opening: true };
    }
    if (extras.kind === 'furniture') piece = keyOf({ ...facts, class: extras.class, id: extras.id });
    if (extras.kind === 'part' && !facts.opening) piece = keyOf({ ...facts, class: extras.part, id: extras.id });
    if (piece !== null) this.find(piece).drawnBy = keyOf({ ...facts, class: 'walls', id: 'walls' });
    if (node.mesh !== undefined && piece !== null) this.add(piece, node.mesh, matrix);
    for (const child of node.children ?? []) this.walk(child, matrix, facts, piece);
  }

  find(key) {
    if (!this.pieces.has(key)) this.pieces.set(key, { triangles: [], low: Array(3).fill(Infinity), high: Array(3).fill(-Infinity) });
    return this.pieces.get(key);
  }

  add(key, mesh, matrix) {
    const piece = this.find(key);
    for (const primitive of this.json.meshes[mesh].primitives) {
      const places = this.rows(primitive.attributes.POSITION).map((row) => placed(matrix, row));
      const corners = primitive.indices === undefined ? places.keys() : this.rows(primitive.indices).map(([index]) => index);
      const list = [...corners];
      for (let at = 0; at < list.length; at += 3) piece.triangles.push([places[list[at]], places[list[at + 1]], places[list[at + 2]]]);
      for (const place of places) {
        piece.low = piece.low.map((value, axis) => Math.min(value, place[axis]));
        piece.high = piece.high.map((value, axis) => Math.max(value, place[axis]));
      }
    }
  }

  rows(index) {
    const { bufferView, byteOffset = 0, componentType, count, type } = this.json.accessors[index];
    const { byteOffset: offset = 0, byteStride } = this.json.bufferViews[bufferView];
    const [width, parts, read] = [WIDTHS[componentType], PARTS[type], READERS[componentType]];
    const stride = byteStride ?? width * parts;
    const row = (at) => Array.from({ length: parts }, (_, part) => read(this.view, at + part * width));
    return Array.from({ length: count }, (_, number) => row(offset + byteOffset + number * stride));
  }
}

/** Column by column, as glTF has matrices. */
function matrixOf({ matrix, translation = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return matrix;
  const turn = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  return [...turn.flatMap((column, axis) => [...column.map((value) => value * scale[axis]), 0]), ...translation, 1];
}

function product(one, other) {
  return Array.from({ length: 16 }, (_, at) => {
    const [column, row] = [at >> 2, at & 3];
    return [0, 1, 2, 3].reduce((sum, step) => sum + one[step * 4 + row] * other[column * 4 + step], 0);
  });
}

/** A place of a file (y up) in the frame of the site (z up). */
function placed(matrix, [x, y, z]) {
  const at = (row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
  return [at(0), -at(2), at(1)];
}

/** Metres from a point to the surface of a piece. */
export function distanceTo({ triangles }, point) {
  return Math.sqrt(triangles.reduce((least, triangle) => Math.min(least, squaredDistance(point, triangle)), Infinity));
}

/** Metres from a point to the box of a piece; 0 inside of it. */
export function distanceToBox({ low, high }, point) {
  return Math.hypot(...point.map((value, axis) => Math.max(low[axis] - value, 0, value - high[axis])));
}

const minus = (one, other) => one.map((value, axis) => value - other[axis]);
const dot = (one, other) => one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
const along = (from, step, share) => from.map((value, axis) => value + step[axis] * share);
const clamped = (share) => Math.min(1, Math.max(0, share));

/** To the nearest point of a triangle: above its inside if the point is there, else on one of its sides. */
function squaredDistance(point, [a, b, c]) {
  const [ab, ac, ap] = [minus(b, a), minus(c, a), minus(point, a)];
  const [bb, bc, cc, pb, pc] = [dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ap, ab), dot(ap, ac)];
  const area = bb * cc - bc * bc;
  if (area > 0) {
    const [u, v] = [(cc * pb - bc * pc) / area, (bb * pc - bc * pb) / area];
    if (u >= 0 && v >= 0 && u + v <= 1) return squared(minus(ap, along(along([0, 0, 0], ab, u), ac, v)));
  }
  return Math.min(...[[a, b], [b, c], [c, a]].map(([from, to]) => {
    const step = minus(to, from);
    const length = dot(step, step);
    const share = length > 0 ? clamped(dot(minus(point, from), step) / length) : 0;
    return squared(minus(point, along(from, step, share)));
  }));
}

const squared = (step) => dot(step, step);

/** Numbers from 0 to 1, the same in every run: a linear congruential generator (Knuth's constants of MMIX, the upper bits). */
export function randomNumbers(seed) {
  let state = BigInt(seed);
  return () => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return Number(state >> 40n) / 2 ** 24;
  };
}
