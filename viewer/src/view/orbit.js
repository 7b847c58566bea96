// The two views from outside: orbit in perspective, and the plan from straight above.
import { MOUSE, MathUtils, OrthographicCamera, PerspectiveCamera, TOUCH } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { viewDuring, viewOfLevel, viewOfPlace } from '../plan/camera_path.js';
import { toPlan } from '../plan/frame.js';

const FIELD_OF_VIEW = 45;
/** Metres above the floor from which a plan is drawn: above everything. */
const PLAN_HEIGHT = 200;
/** Share of the picture that a level fills in the plan. */
const FILLED = 0.9;
/** Radians, shares of the distance, and shares of the picture for each press of a key. */
const [TURN, ZOOM, PAN] = [Math.PI / 24, 0.88, 0.06];

class Outside {
  constructor(stage, camera, isReduced) {
    Object.assign(this, { stage, camera, isReduced });
    this.controls = new OrbitControls(camera, stage.canvas);
    this.controls.enabled = false;
    this.controls.addEventListener('change', () => { this.isChanged = true; });
    this.flight = null;
  }

  activate(isActive) {
    this.controls.enabled = isActive;
    if (isActive) this.stage.camera = this.camera;
  }

  view() {
    return { position: this.camera.position.toArray(), target: this.controls.target.toArray() };
  }

  set({ position, target }) {
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.controls.update();
    this.isChanged = true;
  }

  flyTo(view) {
    this.flight = { from: this.view(), to: view, seconds: 0 };
  }

  /** Gives whether the camera moved. */
  update(seconds) {
    if (this.flight) {
      this.flight.seconds += seconds;
      const view = viewDuring(this.flight.from, this.flight.to, this.flight.seconds, this.isReduced);
      this.set(view);
      if (view.hasArrived) this.flight = null;
    } else if (this.controls.enableDamping) {
      this.controls.update();
    }
    const { isChanged } = this;
    this.isChanged = false;
    return isChanged;
  }

  /** Where the viewer looks from and to on the plan, for the question what is worth drawing. */
  viewpoint() {
    const { position, target } = this.view();
    const [from, to] = [toPlan(position), toPlan(target)];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const direction = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    return {
      // Straight from above, up on the screen is north.
      position: to, direction: Math.hypot(...direction) < 0.5 ? [0, 1] : direction, velocity: [0, 0], fov: FIELD_OF_VIEW,
      mode: 'orbit', isMoving: this.flight !== null,
    };
  }

  /** The direction on the plan that is up on the screen (radians). */
  heading() {
    const { direction } = this.viewpoint();
    return Math.atan2(direction[1], direction[0]);
  }

  pan(right, up) {
    const { position, target } = this.view();
    const reach = this.span() * PAN;
    const heading = this.heading();
    const x = (Math.cos(heading) * up + Math.sin(heading) * right) * reach;
    const y = (Math.sin(heading) * up - Math.cos(heading) * right) * reach;
    this.set({ position: [position[0] + x, position[1], position[2] - y], target: [target[0] + x, target[1], target[2] - y] });
  }

  /** Moves by a key; gives whether the key means something. */
  press({ key, shiftKey }) {
    const arrow = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] }[key];
    if (arrow && shiftKey) this.turn(...arrow);
    else if (arrow) this.pan(...arrow);
    else if (key === '+' || key === '=') this.zoom(ZOOM);
    else if (key === '-') this.zoom(1 / ZOOM);
    else return false;
    return true;
  }
}

export class OrbitView extends Outside {
  constructor(stage, isReduced) {
    super(stage, new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 4000), isReduced);
    this.controls.enableDamping = !isReduced;
    this.controls.maxPolarAngle = Math.PI * 0.49;
    this.controls.minDistance = 1;
    this.controls.maxDistance = 1500;
    this.controls.screenSpacePanning = false;
  }

  resize(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  fit(bounds, height) {
    this.set(viewOfLevel(bounds, height, MathUtils.degToRad(FIELD_OF_VIEW), this.camera.aspect));
  }

  goTo(target, distance, front) {
    this.flyTo(viewOfPlace(target, this.view(), distance, front));
  }

  span() {
    return this.camera.position.distanceTo(this.controls.target);
  }

  turn(right, up) {
    const { position, target } = this.view();
    const [x, y, z] = position.map((value, axis) => value - target[axis]);
    const distance = Math.hypot(x, y, z);
    const angle = Math.atan2(x, z) - right * TURN;
    const lift = Math.min(1.5, Math.max(0.1, Math.asin(y / distance) + up * TURN));
    const flat = Math.cos(lift) * distance;
    this.set({ target, position: [target[0] + Math.sin(angle) * flat, target[1] + Math.sin(lift) * distance, target[2] + Math.cos(angle) * flat] });
  }

  zoom(factor) {
    const { position, target } = this.view();
    this.set({ target, position: position.map((value, axis) => target[axis] + (value - target[axis]) * factor) });
  }
}

export class PlanView extends Outside {
  constructor(stage, isReduced) {
    const camera = new OrthographicCamera(-1, 1, 1, -1, 1, PLAN_HEIGHT + 300);
    // North is up; set before the controls read it.
    camera.up.set(0, 0, -1);
    super(stage, camera, isReduced);
    this.controls.enableRotate = false;
    this.controls.minZoom = 0.2;
    this.controls.maxZoom = 60;
    this.aspect = 1;
    // One finger or the left button move the plan, for there is nothing to turn.
    this.controls.mouseButtons.LEFT = MOUSE.PAN;
    this.controls.touches.ONE = TOUCH.PAN;
  }

  resize(aspect) {
    this.aspect = aspect;
    const { camera } = this;
    const half = this.half ?? 10;
    Object.assign(camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    camera.updateProjectionMatrix();
  }

  fit([low, high]) {
    const [width, depth] = [high[0] - low[0], high[1] - low[1]];
    this.half = Math.max(depth, width / this.aspect, 1) / 2 / FILLED;
    this.camera.zoom = 1;
    this.resize(this.aspect);
    const [x, z] = [(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2];
    this.set({ position: [x, PLAN_HEIGHT, z], target: [x, 0, z] });
  }

  goTo([x, , z]) {
    this.flyTo({ position: [x, PLAN_HEIGHT, z], target: [x, 0, z] });
  }

  heading() {
    return Math.PI / 2;
  }

  span() {
    return 2 * (this.half ?? 10) / this.camera.zoom;
  }

  turn(right, up) {
    this.pan(right, up);
  }

  zoom(factor) {
    this.camera.zoom = Math.min(60, Math.max(0.2, this.camera.zoom / factor));
    this.camera.updateProjectionMatrix();
    this.isChanged = true;
  }
}
