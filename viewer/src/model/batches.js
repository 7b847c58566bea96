// All that is drawn of rooms, one batch for each material: a batch is one draw call, however many models and copies it holds. With an
// instanced mesh for each primitive of each model, a hotel floor would need more than 400 calls; its materials are about 40.
import { BatchedMesh, BufferAttribute, Matrix4 } from 'three';

const FIRST_SIZE = { instances: 16, vertices: 2048, indices: 4096 };
/** Triangles that no room shows any more are kept for rooms that come back, up to so many primitives. */
const MOST_UNUSED = 400;

const matrix = new Matrix4();

export class Batches {
  constructor(scene) {
    this.scene = scene;
    this.batches = new Map();
    /** By primitive key, the least recently used first: {batch, geometry, uses}. */
    this.primitives = new Map();
  }

  has(key) {
    return this.primitives.has(key);
  }

  hasMaterial(materialKey) {
    return this.batches.has(materialKey);
  }

  /** `createMaterial` is called where the batch is new, and gives {material, release}. */
  addGeometry(key, materialKey, createMaterial, geometry) {
    if (this.primitives.has(key)) return;
    let batch = this.batches.get(materialKey);
    if (!batch) {
      batch = new Batch(materialKey, createMaterial());
      this.batches.set(materialKey, batch);
      this.scene.add(batch.mesh);
    }
    this.primitives.set(key, { batch, geometry: batch.add(geometry), uses: 0 });
  }

  /** Draws a primitive once more. Gives what `remove`, `move` and `show` ask for. */
  place(key, elements) {
    const primitive = this.primitives.get(key);
    primitive.uses += 1;
    this.primitives.delete(key);
    this.primitives.set(key, primitive);
    const { batch, geometry } = primitive;
    const instance = batch.addInstance(geometry);
    batch.mesh.setMatrixAt(instance, matrix.fromArray(elements));
    return { key, primitive, instance, elements };
  }

  move(handle, elements) {
    handle.elements = elements;
    handle.primitive.batch.mesh.setMatrixAt(handle.instance, matrix.fromArray(elements));
  }

  show(handle, isVisible) {
    handle.primitive.batch.mesh.setVisibleAt(handle.instance, isVisible);
  }

  remove({ primitive, instance }) {
    primitive.batch.mesh.deleteInstance(instance);
    primitive.uses -= 1;
  }

  /** Where the triangles of a handle are: {positions, indices, range, isTwoSided}. */
  trianglesOf({ primitive: { batch, geometry } }) {
    const { attributes, index } = batch.mesh.geometry;
    return {
      positions: attributes.position.array, indices: index.array,
      range: batch.mesh.getGeometryRangeAt(geometry), isTwoSided: batch.material.side !== 0,
    };
  }

  /** Frees triangles that are not drawn, and materials without triangles. */
  tidy(most = MOST_UNUSED) {
    const unused = [...this.primitives].filter(([, { uses }]) => uses === 0);
    for (const [key, { batch, geometry }] of unused.slice(0, Math.max(0, unused.length - most))) {
      this.primitives.delete(key);
      batch.remove(geometry);
      if (batch.count > 0) continue;
      this.batches.delete(batch.key);
      this.scene.remove(batch.mesh);
      batch.dispose();
    }
  }
}

class Batch {
  constructor(key, { material, release }) {
    this.key = key;
    this.material = material;
    this.release = release;
    this.count = 0;
    this.isWasted = false;
    this.mesh = new BatchedMesh(FIRST_SIZE.instances, FIRST_SIZE.vertices, FIRST_SIZE.indices, material);
    // The sphere about a batch is that of the whole level: its instances are tested one by one.
    this.mesh.frustumCulled = false;
    this.mesh.sortObjects = material.transparent;
  }

  add(geometry) {
    const uniform = uniformGeometry(geometry);
    this.reserve(uniform.attributes.position.count, uniform.index.count);
    this.count += 1;
    return this.mesh.addGeometry(uniform);
  }

  /** Closes the gaps of removed triangles before it grows, each time to the double. */
  reserve(vertices, indices) {
    const { mesh } = this;
    const fits = () => mesh.unusedVertexCount >= vertices && mesh.unusedIndexCount >= indices;
    if (fits()) return;
    if (this.isWasted) mesh.optimize();
    this.isWasted = false;
    if (fits()) return;
    const { position } = mesh.geometry.attributes;
    const [most, mostIndices] = position ? [position.count, mesh.geometry.index.count] : [FIRST_SIZE.vertices, FIRST_SIZE.indices];
    mesh.setGeometrySize(2 * most + vertices, 2 * mostIndices + indices);
  }

  addInstance(geometry) {
    if (this.mesh.instanceCount === this.mesh.maxInstanceCount) this.mesh.setInstanceCount(2 * this.mesh.maxInstanceCount);
    return this.mesh.addInstance(geometry);
  }

  remove(geometry) {
    this.mesh.deleteGeometry(geometry);
    this.count -= 1;
    this.isWasted = true;
  }

  dispose() {
    this.mesh.dispose();
    this.release();
  }
}

/** The same attributes for all primitives, as a batch demands. */
function uniformGeometry(geometry) {
  if (!geometry.attributes.normal) geometry.computeVertexNormals();
  const { count } = geometry.attributes.position;
  if (!geometry.attributes.uv) geometry.setAttribute('uv', new BufferAttribute(new Float32Array(2 * count), 2));
  for (const name of Object.keys(geometry.attributes)) {
    if (!['position', 'normal', 'uv'].includes(name)) geometry.deleteAttribute(name);
  }
  if (!geometry.index) geometry.setIndex(Array.from({ length: count }, (_, index) => index));
  return geometry;
}
