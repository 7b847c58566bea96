// The storeys below and above the level that is shown, as plain bodies: they say how high one stands, and what stands over a yard.
import { ExtrudeGeometry, Mesh, MeshStandardMaterial, Path, Shape } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

/** Storeys on each side that are drawn; beyond them, only a roofer would miss one. */
const MOST_STOREYS = 30;
/** Metres by which a body ends below the floor of the storey above, so that the two do not flicker. */
const GAP = 0.05;

export class Storeys {
  constructor(scene) {
    this.scene = scene;
    this.material = new MeshStandardMaterial({ color: 0xcfcac1, roughness: 1 });
    this.meshes = [];
    this.above = null;
    this.hasAbove = false;
  }

  clear() {
    for (const mesh of this.meshes) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
    }
    this.meshes = [];
    this.above = null;
  }

  /** `maps`: the answers of api/level for the other storeys, the lowest first. */
  show({ elevation, height }, maps) {
    this.clear();
    const bodies = (storeys) => storeys.map((map) => bodyOf(map, map.elevation - elevation));
    this.added(bodies(maps.filter((map) => map.elevation < elevation).slice(-MOST_STOREYS)));
    this.above = this.added(bodies(maps.filter((map) => map.elevation >= elevation + height / 2).slice(0, MOST_STOREYS)));
    this.showAbove(this.hasAbove);
  }

  /** All bodies as one mesh: one draw call. */
  added(bodies) {
    if (bodies.length === 0) return null;
    const mesh = new Mesh(mergeGeometries(bodies), this.material);
    for (const body of bodies) body.dispose();
    this.scene.add(mesh);
    this.meshes.push(mesh);
    return mesh;
  }

  /** What stands above hides the level from above, and stands over somebody who walks out. */
  showAbove(isVisible) {
    this.hasAbove = isVisible;
    if (this.above) this.above.visible = isVisible;
  }
}

function bodyOf({ rooms, height }, elevation) {
  const geometry = new ExtrudeGeometry(rooms.map(shapeOf), { depth: height - GAP, bevelEnabled: false });
  // A shape lies in x and y; turned back about x, its y points north and its depth up. No body reaches into the level that is shown.
  return geometry.rotateX(-Math.PI / 2).translate(0, elevation - (elevation < 0 ? GAP : 0), 0);
}

function shapeOf({ outline, holes }) {
  const shape = new Shape(outline.map(([x, y]) => ({ x, y })));
  shape.holes = holes.map((hole) => new Path(hole.map(([x, y]) => ({ x, y }))));
  return shape;
}
