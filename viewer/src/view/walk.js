// The view of somebody who walks through the level, by keys, mouse, finger and an on-screen stick.
import { PerspectiveCamera } from 'three';
import { findFree, move } from '../plan/collision.js';
import { distance, directionOf, scale, subtract, toScene } from '../plan/frame.js';
import { roomAt } from '../plan/polygon.js';
import { velocityOf } from '../plan/steps.js';

/** Metres. */
export const EYE = 1.6;
const FIELD_OF_VIEW = 70;
/** Radians for each pixel of a drag, and radians a second for a key. */
const [DRAG_TURN, KEY_TURN] = [0.0045, 1.9];
const [STEEPEST, LOWERED] = [1.3, -0.12];
const KEYS = {
  KeyW: 'forward', ArrowUp: 'forward', KeyS: 'back', ArrowDown: 'back', KeyA: 'left', KeyD: 'right',
  ArrowLeft: 'turnLeft', ArrowRight: 'turnRight', ShiftLeft: 'run', ShiftRight: 'run',
};

export class WalkView {
  /** `level()` gives {rooms, obstacles} as they are now. */
  constructor(stage, level) {
    Object.assign(this, { stage, level });
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 600);
    this.camera.rotation.order = 'YXZ';
    this.position = [0, 0];
    this.heading = Math.PI / 2;
    this.pitch = 0;
    this.velocity = [0, 0];
    this.pressed = new Set();
    this.stick = { forward: 0, right: 0 };
    this.isActive = false;
  }

  activate(isActive) {
    this.isActive = isActive;
    this.release();
    if (isActive) this.stage.camera = this.camera;
    else if (document.pointerLockElement) document.exitPointerLock();
  }

  resize(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Puts the walker into a room, as near to a point as furniture allows. */
  enter(room, wanted) {
    this.position = findFree(room, wanted, this.level().obstacles);
    this.room = room;
    this.isChanged = true;
  }

  look(right, down) {
    this.heading -= right * DRAG_TURN;
    this.pitch = Math.min(STEEPEST, Math.max(-STEEPEST, this.pitch - down * DRAG_TURN));
    this.isChanged = true;
  }

  /** Looks along a heading, a little down, as people do. */
  face(heading) {
    this.heading = heading;
    this.pitch = LOWERED;
    this.isChanged = true;
  }

  /** Gives whether the key means something to a walker. */
  keyDown({ code }) {
    if (!(code in KEYS)) return false;
    this.pressed.add(KEYS[code]);
    return true;
  }

  keyUp({ code }) {
    this.pressed.delete(KEYS[code]);
  }

  /** Keys whose release goes to another window would stay pressed. */
  release() {
    this.pressed.clear();
    this.stick = { forward: 0, right: 0 };
  }

  wish() {
    const held = (name) => this.pressed.has(name) ? 1 : 0;
    return {
      forward: held('forward') - held('back') + this.stick.forward,
      right: held('right') - held('left') + this.stick.right,
      turn: held('turnLeft') - held('turnRight'),
      isRunning: held('run') === 1,
    };
  }

  update(seconds) {
    const wish = this.wish();
    this.heading += wish.turn * KEY_TURN * seconds;
    const before = this.position;
    if (wish.forward !== 0 || wish.right !== 0) {
      this.position = move(before, scale(velocityOf(wish, this.heading), seconds), this.level().obstacles);
      this.room = roomAt(this.level().rooms, this.position) ?? this.room;
    }
    this.velocity = seconds > 0 ? scale(subtract(this.position, before), 1 / seconds) : [0, 0];
    const isMoving = wish.turn !== 0 || distance(before, this.position) > 1e-5;
    const isChanged = isMoving || this.isChanged;
    this.isChanged = false;
    if (isChanged) this.pose();
    return isChanged;
  }

  pose() {
    this.camera.position.fromArray(toScene(this.position, EYE));
    this.camera.rotation.set(this.pitch, this.heading - Math.PI / 2, 0);
  }

  viewpoint() {
    const { velocity } = this;
    return {
      position: this.position, direction: directionOf(this.heading), velocity, fov: FIELD_OF_VIEW, mode: 'walk',
      isMoving: Math.hypot(...velocity) > 0.05,
    };
  }
}
