// Mouse, fingers and keys over the picture.
import { scale, subtract } from '../plan/frame.js';
import { stepOf } from '../plan/steps.js';
import { TURN_STEP } from '../editor.js';
import { onPlane, pick, rayThrough } from '../view/picking.js';
import { byId, isTyping } from './elements.js';

/** Pixels and milliseconds up to which a press is a click and no drag. */
const [CLICK_PIXELS, CLICK_TIME] = [6, 600];

export class Input {
  constructor(app, editor, { panel, toolbar, lift }) {
    Object.assign(this, { app, editor, panel, toolbar, lift });
    const { canvas } = app.stage;
    this.press = null;
    // In the capture phase, before the controls of the orbit hear of it: a drag of a piece is not theirs.
    canvas.addEventListener('pointerdown', (event) => this.pointerDown(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.pointerMove(event), { capture: true });
    canvas.addEventListener('pointerup', (event) => this.pointerUp(event), { capture: true });
    canvas.addEventListener('pointercancel', () => this.endPress(), { capture: true });
    document.addEventListener('keydown', (event) => this.keyDown(event));
    document.addEventListener('keyup', (event) => app.views.walk.keyUp(event));
    window.addEventListener('blur', () => app.views.walk.release());
    this.watchStick();
  }

  pointOf({ clientX, clientY }) {
    const { left, top } = this.app.stage.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  pointerDown(event) {
    if (event.button !== 0 || !event.isPrimary) return;
    this.app.stage.canvas.focus({ preventScroll: true });
    const at = this.pointOf(event);
    this.press = { start: at, last: at, time: event.timeStamp, isDrag: false, held: this.heldPiece(at) };
    if (this.press.held && this.app.mode !== 'walk') this.app.view.controls.enabled = false;
    if (this.app.mode === 'walk' && !document.pointerLockElement) this.app.stage.canvas.setPointerCapture(event.pointerId);
  }

  /** The chosen piece if the press is on it and it may be moved: {height, at}. */
  heldPiece(at) {
    if (!this.editor.isEditable) return null;
    const ray = rayThrough(this.app.stage, at);
    const found = pick(ray, this.app.rooms, this.app.section.current);
    const piece = this.app.piece();
    if (found?.piece !== piece.id || found.room !== this.app.selected.room) return null;
    const place = onPlane(ray, piece.bottom);
    return place && { height: piece.bottom, at: place };
  }

  pointerMove(event) {
    if (document.pointerLockElement) return this.app.views.walk.look(event.movementX, event.movementY);
    if (!this.press || !event.isPrimary) return undefined;
    const at = this.pointOf(event);
    const [right, down] = subtract(at, this.press.last);
    this.press.isDrag ||= Math.hypot(...subtract(at, this.press.start)) > CLICK_PIXELS;
    this.press.last = at;
    if (!this.press.isDrag) return undefined;
    if (this.press.held) return this.dragPiece(at);
    // The finger holds the room and moves it: the view turns the other way.
    if (this.app.mode === 'walk') this.app.views.walk.look(-right, -down);
    return undefined;
  }

  dragPiece(at) {
    const { held } = this.press;
    const place = onPlane(rayThrough(this.app.stage, at), held.height);
    if (!place) return;
    this.editor.nudge(subtract(place, held.at));
    held.at = place;
  }

  pointerUp(event) {
    const { press } = this;
    if (!press || !event.isPrimary) return;
    this.endPress();
    if (press.isDrag || event.timeStamp - press.time > CLICK_TIME) return;
    const found = pick(rayThrough(this.app.stage, press.last), this.app.rooms, this.app.section.current);
    this.app.select(found && { room: found.room, piece: found.piece });
  }

  endPress() {
    this.press = null;
    if (this.app.mode !== 'walk') this.app.view.controls.enabled = true;
  }

  keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) return;
    const isOnPicture = event.target === document.body || byId('view').contains(event.target);
    if (this.general(event) || isOnPicture && (this.editing(event) || this.moving(event))) event.preventDefault();
  }

  general({ key, shiftKey }) {
    const { app, toolbar } = this;
    const actions = {
      1: () => app.setMode('orbit'), 2: () => app.setMode('plan'), 3: () => app.setMode('walk'),
      '?': () => byId('help').showModal(),
      l: () => toolbar.toggleLamps(),
      n: () => this.panel.step(shiftKey ? -1 : 1),
      PageUp: () => toolbar.stepLevel(1), PageDown: () => toolbar.stepLevel(-1),
      Home: () => app.fit(),
      m: () => this.catchMouse(),
      Escape: () => { app.select(app.selected && { ...app.selected, piece: null }); app.stage.canvas.focus(); },
    };
    return run(actions, key);
  }

  editing(event) {
    if (!this.editor.isEditable) return false;
    const heading = this.app.mode === 'walk' ? this.app.views.walk.heading : this.app.view.heading();
    const step = stepOf(event.key, event.shiftKey, heading);
    if (step) {
      this.editor.nudge(step);
      return true;
    }
    return run({
      r: () => this.editor.nudge([0, 0], event.shiftKey ? -TURN_STEP : TURN_STEP),
      k: () => this.editor.toggleLock(),
      Delete: () => this.editor.remove(),
    }, event.key);
  }

  moving(event) {
    if (this.app.mode !== 'walk') return this.app.view.press(event);
    if (this.app.views.walk.keyDown(event)) return true;
    if (event.key === 'Enter') return this.lift.focus();
    return run({ e: () => this.toolbar.changeFloor('above'), q: () => this.toolbar.changeFloor('below') }, event.key);
  }

  catchMouse() {
    if (this.app.mode !== 'walk') return;
    // Browsers refuse right after Escape; then dragging still works.
    Promise.resolve(this.app.stage.canvas.requestPointerLock?.()).catch(() => undefined);
  }

  watchStick() {
    const [stick, knob] = [byId('stick'), byId('knob')];
    const reach = 36;
    const set = (offset) => {
      const length = Math.max(1, Math.hypot(...offset) / reach);
      const [right, down] = scale(offset, 1 / length / reach);
      this.app.views.walk.stick = { forward: -down, right };
      knob.style.transform = `translate(${right * reach}px, ${down * reach}px)`;
    };
    const follow = (event) => {
      const { left, top, width, height } = stick.getBoundingClientRect();
      set([event.clientX - left - width / 2, event.clientY - top - height / 2]);
    };
    stick.addEventListener('pointerdown', (event) => { stick.setPointerCapture(event.pointerId); follow(event); });
    stick.addEventListener('pointermove', (event) => { if (stick.hasPointerCapture(event.pointerId)) follow(event); });
    for (const name of ['pointerup', 'pointercancel']) stick.addEventListener(name, () => set([0, 0]));
  }
}

function run(actions, key) {
  const action = actions[key.length === 1 ? key.toLowerCase() : key];
  if (!action) return false;
  action();
  return true;
}
