// The box about the selected piece, seen through everything else, and the plain buildings around.
import {
  BoxGeometry, EdgesGeometry, Group, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial,
} from 'three';
import { multiplied, placed } from '../model/matrix.js';

const COLOUR = 0xff7a1a;
/** Metres between a piece and its outline, so that the two do not flicker. */
const GAP = 0.015;
/** More buildings around are not drawn. */
const MOST_NEIGHBOURS = 400;

export class Outline {
  constructor(scene) {
    const box = new BoxGeometry(1, 1, 1);
    const lines = new LineSegments(new EdgesGeometry(box), new LineBasicMaterial({ color: COLOUR, depthTest: false, transparent: true }));
    const fill = new Mesh(box, new MeshBasicMaterial({ color: COLOUR, transparent: true, opacity: 0.16, depthWrite: false }));
    lines.renderOrder = 2;
    fill.renderOrder = 1;
    this.group = new Group();
    this.group.add(lines, fill);
    this.group.matrixAutoUpdate = false;
    this.group.visible = false;
    scene.add(this.group);
  }

  show(piece) {
    this.group.visible = piece !== null;
    if (!piece) return;
    const [width, depth, height] = piece.size;
    this.group.matrix.fromArray(piece.matrix)
      .multiply(new Matrix4().makeTranslation(0, height / 2, 0))
      .multiply(new Matrix4().makeScale(width + GAP, height + GAP, depth + GAP));
    this.group.matrixWorldNeedsUpdate = true;
  }
}

/** The other buildings of a site as boxes, seen from the building that is shown. */
export class Neighbours {
  constructor(scene) {
    this.scene = scene;
    this.mesh = null;
  }

  show(building, level, buildings) {
    if (this.mesh) {
      this.scene.remove(this.mesh);
      this.mesh.dispose();
    }
    this.mesh = null;
    const others = buildings.filter((other) => other !== building && stands(other)).slice(0, MOST_NEIGHBOURS);
    if (others.length === 0) return;
    this.mesh = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshStandardMaterial({ color: 0xc9c4ba, roughness: 1 }), others.length);
    others.forEach((other, index) => this.mesh.setMatrixAt(index, matrixFrom(building, level, other)));
    this.scene.add(this.mesh);
  }
}

const stands = ({ position }) => position.some((value) => value !== 0);

function matrixFrom(building, level, other) {
  const back = placed([0, 0, 0], -building.turn);
  const [x, y] = other.position.map((value, axis) => value - building.position[axis]);
  const frame = multiplied(back, placed([x, -level.elevation, -y], other.turn));
  const [low, high] = other.bounds;
  const top = Math.max(...other.levels.map(({ elevation, height }) => elevation + height));
  return new Matrix4().fromArray(frame)
    .multiply(new Matrix4().makeTranslation((low[0] + high[0]) / 2, top / 2, -(low[1] + high[1]) / 2))
    .multiply(new Matrix4().makeScale(high[0] - low[0], top, high[1] - low[1]));
}
