// The storeys below the level that is shown, as plain bodies: they say how high one stands.
import { ExtrudeGeometry, Group, Mesh, MeshStandardMaterial, Path, Shape } from 'three';

/** Storeys are drawn so far down; below them, only a roofer would miss one. */
const MOST_STOREYS = 30;
/** Metres by which a body ends below the floor of the storey above, so that the two do not flicker. */
const GAP = 0.05;

export class Storeys {
  constructor(scene) {
    this.group = new Group();
    this.material = new MeshStandardMaterial({ color: 0xcfcac1, roughness: 1 });
    scene.add(this.group);
  }

  clear() {
    for (const { geometry } of this.group.children) geometry.dispose();
    this.group.clear();
  }

  /** `maps`: the answers of api/level for storeys below the one at `elevation`. */
  show(elevation, maps) {
    this.clear();
    for (const map of maps.slice(-MOST_STOREYS)) {
      const geometry = new ExtrudeGeometry(map.rooms.map(shapeOf), { depth: map.height - GAP, bevelEnabled: false });
      const body = new Mesh(geometry, this.material);
      // A shape lies in x and y; turned back about x, its y points north and its depth up.
      body.rotation.x = -Math.PI / 2;
      body.position.y = map.elevation - elevation - GAP;
      this.group.add(body);
    }
  }
}

function shapeOf({ outline, holes }) {
  const shape = new Shape(outline.map(([x, y]) => ({ x, y })));
  shape.holes = holes.map((hole) => new Path(hole.map(([x, y]) => ({ x, y }))));
  return shape;
}
