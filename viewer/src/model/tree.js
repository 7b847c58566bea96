// A document taken apart: which rooms and openings it holds, and of each the primitives to draw and where, the pieces of furniture
// and the lamps. Nothing here looks at triangles.
//
// A primitive is {key, source: [mesh, primitive], material, matrix, role, piece, isShell}; the shell is walls, doors, windows and what
// hangs on them. Equal keys are equal triangles with equal material,
// in all documents: furniture lies in files of its own, whose names hold a hash of their bytes, and images inside a document are told
// by their bytes. Everything else is keyed by its document.
import { toPlan } from '../plan/frame.js';
import { IDENTITY, angleOf, matrixOf, multiplied, positionOf } from './matrix.js';

/** {rooms, openings} of a glTF document; `documentKey` tells its own buffers from those of other documents. */
export function readTree(document, documentKey) {
  const { json } = document;
  const reader = new Reader(document, documentKey);
  const scene = json.scenes?.[json.scene ?? 0];
  for (const node of scene?.nodes ?? []) reader.visit(node, IDENTITY, {});
  return { rooms: reader.rooms, openings: reader.openings };
}

class Reader {
  constructor(document, documentKey) {
    const { json } = document;
    this.json = json;
    this.documentKey = documentKey;
    this.rooms = [];
    this.openings = [];
    const textures = textureKeys(document);
    this.materialKeys = (json.materials ?? []).map((material) => materialKey(material, textures));
  }

  /** `within`: the room, opening, piece and leaf that the node lies in. */
  visit(index, parentMatrix, within) {
    const node = this.json.nodes[index];
    const matrix = multiplied(parentMatrix, matrixOf(node));
    const place = this.entered(node, matrix, within);
    this.readPrimitives(node, matrix, place);
    for (const child of node.children ?? []) this.visit(child, matrix, place);
  }

  entered(node, matrix, within) {
    const extras = node.extras ?? {};
    if (extras.kind === 'room') return { room: this.addRoom(extras) };
    if (extras.kind === 'opening') return { opening: this.addOpening(node, matrix) };
    if (extras.kind === 'furniture' && within.room) return { ...within, piece: addPiece(node, matrix, within) };
    if (extras.kind === 'light' && within.room) {
      within.room.lamps.push({ position: positionOf(matrix), lumens: extras.lumens, kelvin: extras.kelvin });
    }
    if (extras.kind === 'part') return this.enteredPart(node, extras, matrix, within);
    return within;
  }

  enteredPart(node, extras, matrix, within) {
    if (extras.part === 'leaf' && within.opening) return { ...within, part: 'leaf', leaf: this.addLeaf(node, matrix, within.opening) };
    return { ...within, part: extras.part };
  }

  addRoom(extras) {
    const room = { id: extras.room, extras, primitives: [], pieces: [], lamps: [] };
    this.rooms.push(room);
    return room;
  }

  addOpening(node, matrix) {
    const opening = { name: node.name, extras: node.extras, center: toPlan(positionOf(matrix)), primitives: [], leaves: [] };
    this.openings.push(opening);
    return opening;
  }

  addLeaf(node, matrix, opening) {
    const leaf = { matrix, hinge: toPlan(positionOf(matrix)), extent: this.extentOf(node), primitives: [] };
    opening.leaves.push(leaf);
    return leaf;
  }

  /** Where a leaf begins and ends along its wall, in the frame of its node. */
  extentOf({ mesh }) {
    const boxes = (this.json.meshes?.[mesh]?.primitives ?? []).map(({ attributes }) => this.json.accessors[attributes.POSITION]);
    if (boxes.length === 0) return { from: 0, to: 0 };
    return { from: Math.min(...boxes.map(({ min }) => min[0])), to: Math.max(...boxes.map(({ max }) => max[0])) };
  }

  readPrimitives({ mesh }, matrix, { room, opening, piece, part, leaf }) {
    const owner = leaf ?? opening ?? room;
    if (mesh === undefined || !owner) return;
    const isShell = piece ? hangs(piece) : part !== 'floor';
    // The shell has materials of its own: it is cut where it hides the room.
    const kind = isShell ? 'shell' : 'furniture';
    this.json.meshes[mesh].primitives.forEach((primitive, index) => {
      owner.primitives.push({
        key: `${kind} ${this.keyOf(mesh, index, primitive)}`,
        source: [mesh, index],
        material: `${kind} ${this.materialKeys[primitive.material] ?? 'none'}`,
        isShell,
        matrix,
        role: piece ? 'furniture' : part ?? 'part',
        piece: piece?.id ?? null,
      });
    });
  }

  keyOf(mesh, index, { attributes, indices, material }) {
    const accessors = [attributes.POSITION, indices].filter((accessor) => accessor !== undefined).map((accessor) => this.json.accessors[accessor]);
    const places = accessors.map(({ bufferView, byteOffset = 0 }) => {
      const view = this.json.bufferViews[bufferView];
      const uri = this.json.buffers[view.buffer].uri;
      return uri && `${uri}@${(view.byteOffset ?? 0) + byteOffset}`;
    });
    const triangles = places.every(Boolean) ? places.join('+') : `${this.documentKey}:${mesh}.${index}`;
    return `${triangles} ${this.materialKeys[material] ?? 'none'}`;
  }
}

/** Metres above the floor: a piece at a wall that begins higher hangs there, as pictures and curtain rails do. */
const HANGING = 0.4;

function hangs({ parent, bottom }) {
  return /^(wall|window|door)[.:]/.test(parent) && bottom > HANGING;
}

function addPiece(node, matrix, { room, piece: holder }) {
  const { class: kind, id, parent, side, size, variant } = node.extras;
  const [x, y] = toPlan(positionOf(matrix));
  const piece = {
    id, kind, parent, side, size, variant, room: room.id,
    // The piece that carries this one; its parent may only stand beside it.
    holder: holder?.id ?? null,
    matrix, at: [x, y], angle: angleOf(matrix), bottom: matrix[13],
  };
  room.pieces.push(piece);
  return piece;
}

/** Equal keys are equal materials, also of different documents. */
function materialKey(material, textures) {
  return JSON.stringify(material, (name, value) => {
    if (!name.endsWith('Texture') || typeof value?.index !== 'number') return value;
    return { ...value, index: textures[value.index] };
  });
}

/** A key for each texture of a document, the same for equal pictures of all documents. */
export function textureKeys({ json, binary }) {
  const images = (json.images ?? []).map((image) => image.uri ?? bytesKey(binary, json.bufferViews[image.bufferView]));
  return (json.textures ?? []).map(({ source, sampler }) => `${images[source]} ${JSON.stringify(json.samplers?.[sampler] ?? null)}`);
}

/** The length and a hash of the bytes of a view: FNV-1a by G. Fowler, L. C. Noll and P. Vo. Images inside documents are small. */
function bytesKey(binary, { byteOffset = 0, byteLength }) {
  let hash = 0x811c9dc5;
  for (const byte of binary.subarray(byteOffset, byteOffset + byteLength)) hash = Math.imul(hash ^ byte, 0x01000193);
  return `${byteLength}:${hash >>> 0}`;
}
