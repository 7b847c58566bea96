// The rooms of a level in plain colours from its map alone: there at once, until the furnished room comes and takes its place.
import { BatchedMesh, BufferGeometry, DoubleSide, Float32BufferAttribute, FrontSide, Matrix4, MeshStandardMaterial, Path, Shape, ShapeGeometry } from 'three';
import { toScene } from '../plan/frame.js';
import { wallPanels } from '../plan/shell.js';
import { facesOf } from '../plan/walls.js';

const COLOURS = { floor: 0xa58a63, wall: 0xbdb4a4, ceiling: 0xe4e0d8 };

export class Shell {
  constructor(scene, section) {
    this.scene = scene;
    this.materials = Object.entries(COLOURS).map(([part, color]) => [part, new MeshStandardMaterial({ color, roughness: 1, side: part === 'wall' ? DoubleSide : FrontSide })]);
    for (const [part, material] of this.materials) if (part === 'wall') section.cut(material);
    /** One mesh for each part: {part, mesh, instances: Map(room → instance)}. */
    this.parts = [];
    this.hasCeilings = false;
  }

  /** Draws the rooms of a level. */
  build(map) {
    this.clear();
    const faces = facesOf(map);
    const geometries = map.rooms.map((room) => [room.id, geometriesOf(room, faces.filter((face) => face.room === room.id))]);
    this.parts = this.materials.map(([part, material]) => this.batched(part, material, geometries));
    this.showCeilings(this.hasCeilings);
  }

  batched(part, material, geometries) {
    const own = geometries.map(([room, parts]) => [room, parts[part]]);
    const count = (of) => own.reduce((sum, [, geometry]) => sum + of(geometry), 0);
    const mesh = new BatchedMesh(own.length, count(({ attributes }) => attributes.position.count), count(({ index }) => index.count), material);
    mesh.sortObjects = false;
    mesh.frustumCulled = false;
    const instances = new Map(own.map(([room, geometry]) => {
      const instance = mesh.addInstance(mesh.addGeometry(geometry));
      mesh.setMatrixAt(instance, new Matrix4());
      return [room, instance];
    }));
    this.scene.add(mesh);
    return { part, mesh, instances };
  }

  clear() {
    for (const { mesh } of this.parts) {
      this.scene.remove(mesh);
      mesh.dispose();
    }
    this.parts = [];
  }

  /** Shows the plain room, or hides it where the furnished one is drawn. */
  show(room, isVisible) {
    for (const { mesh, instances } of this.parts) {
      if (instances.has(room)) mesh.setVisibleAt(instances.get(room), isVisible);
    }
  }

  showCeilings(isVisible) {
    this.hasCeilings = isVisible;
    for (const { part, mesh } of this.parts) if (part === 'ceiling') mesh.visible = isVisible;
  }
}

function geometriesOf(room, faces) {
  return { floor: plate(room, 0, true), ceiling: plate(room, room.height, false), wall: walls(faces, room.height) };
}

/** The outline of a room as a plate that is seen from above or from below. */
function plate({ outline, holes }, height, isFromAbove) {
  const shape = new Shape(outline.map(([x, y]) => ({ x, y })));
  shape.holes = holes.map((hole) => new Path(hole.map(([x, y]) => ({ x, y }))));
  const geometry = new ShapeGeometry(shape);
  if (!isFromAbove) geometry.index.array.reverse();
  return geometry.rotateX(-Math.PI / 2).translate(0, height, 0);
}

function walls(faces, height) {
  const [positions, indices] = [[], []];
  for (const { from, to, bottom, top } of faces.flatMap((face) => wallPanels(face, height))) {
    const first = positions.length / 3;
    positions.push(...toScene(from, bottom), ...toScene(to, bottom), ...toScene(to, top), ...toScene(from, top));
    // The outline runs counter-clockwise: the room is on the left of each side.
    indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('uv', new Float32BufferAttribute(new Float32Array(positions.length / 3 * 2), 2));
  geometry.setIndex(indices);
  geometry.computeVertexNormals();
  return geometry;
}
