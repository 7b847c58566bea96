// What a baked floor says of itself: its JSON, how much is in it, and where one can stand in a room.
import { readFileSync } from 'node:fs';

const [MAGIC, JSON_CHUNK] = [0x46546c67, 0x4e4f534a];
/** Metres above the floor: the eyes of a standing person, and what she looks at. */
const [EYE_HEIGHT, TARGET_HEIGHT] = [1.6, 1.1];

/** The JSON of a .glb or .gltf. Throws an error that names the file if it is neither. */
export function readFloor(path) {
  const bytes = readFileSync(path);
  if (bytes.readUInt32LE(0) !== MAGIC) return JSON.parse(bytes.toString());
  if (bytes.readUInt32LE(16) !== JSON_CHUNK) throw new Error(`${path}: no JSON chunk`);
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
}

/** Nodes, and nodes with a mesh, of all that the scene shows. */
export function countNodes({ nodes }) {
  return { nodes: nodes.length, mesh_nodes: nodes.filter((node) => node.mesh !== undefined).length };
}

/** A view across a room, the largest if none is named: from its middle, which is free of shelves and wardrobes, into a corner. */
export function viewOf(floor, name) {
  const rooms = floor.nodes.map((node) => node.extras).filter((extras) => extras?.kind === 'room');
  const sorted = rooms.sort((one, other) => extent(other.outline).area - extent(one.outline).area);
  const room = name === undefined ? sorted[0] : sorted.find((one) => one.room === name);
  if (room === undefined) throw new Error(`no room ${name ?? ''}; there are ${sorted.map((one) => one.room).join(', ')}`);
  const { middle } = extent(room.outline);
  const at = ([east, north], height) => [east, height, -north].map((value) => value.toFixed(2)).join();
  return { eye: at(middle, EYE_HEIGHT), target: at(room.outline[0], TARGET_HEIGHT) };
}

/** Middle and area of the box around an outline. */
function extent(outline) {
  const sides = [0, 1].map((axis) => outline.map((corner) => corner[axis]));
  const [width, depth] = sides.map((side) => Math.max(...side) - Math.min(...side));
  return { area: width * depth, middle: sides.map((side) => (Math.max(...side) + Math.min(...side)) / 2) };
}
