// The aprons before doors to the open air, as plates that reach down to the ground.
import { ExtrudeGeometry, Mesh, MeshStandardMaterial, Shape } from 'three';

/** Metres below the floor, so that a threshold shows. */
const STEP = 0.02;

export class Aprons {
  constructor(scene) {
    this.scene = scene;
    this.mesh = null;
    this.material = new MeshStandardMaterial({ color: 0xb5b0a6, roughness: 1 });
  }

  /** `ground`: metres from the floor down to the ground. */
  show(aprons, ground) {
    if (this.mesh) {
      this.scene.remove(this.mesh);
      this.mesh.geometry.dispose();
    }
    this.mesh = null;
    if (aprons.length === 0 || ground <= STEP) return;
    const shapes = aprons.map(({ corners }) => new Shape(corners.map(([x, y]) => ({ x, y }))));
    this.mesh = new Mesh(new ExtrudeGeometry(shapes, { depth: ground - STEP, bevelEnabled: false }), this.material);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.position.y = -ground;
    this.scene.add(this.mesh);
  }
}
