// The canvas: a renderer, a scene, and frames that are drawn only when something changed.
import { ACESFilmicToneMapping, Color, Scene, WebGLRenderer } from 'three';

/** Finer pixels cost more than they show. */
const FINEST_PIXELS = 2;
/** A frame after a pause would otherwise move everything by the whole pause (seconds). */
const LONGEST_STEP = 0.25;
/** Rooms that come in are drawn when this many times the cost of a frame has passed: a slow card else draws each time all the others. */
const PATIENCE = 4;

export class Stage {
  /** Throws where the browser has no WebGL. */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, FINEST_PIXELS));
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.scene = new Scene();
    this.scene.background = new Color();
    this.camera = null;
    this.frameTime = 0;
    this.isDirty = true;
    this.isPending = false;
    canvas.addEventListener('webglcontextlost', () => this.lost?.());
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  /** Draws the next frame. */
  invalidate() {
    this.isDirty = true;
  }

  /** Draws soon: as soon as the card keeps up. */
  invalidateLater() {
    this.isPending = true;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    this.size = [width, height];
    this.renderer.setSize(width, height);
    this.resized?.(width / Math.max(1, height));
    this.invalidate();
  }

  /** Calls `step(seconds)` before each frame of the screen; it answers whether there is something new to see. */
  run(step) {
    let last = performance.now();
    let [drawnAt, cost, isMeasuring] = [last, 0, false];
    this.renderer.setAnimationLoop((time) => {
      const seconds = Math.min(LONGEST_STEP, Math.max(0, (time - last) / 1000));
      last = time;
      // The callback after a drawn frame comes when the card is ready for the next one.
      if (isMeasuring) cost = time - drawnAt;
      isMeasuring = false;
      const isChanged = step(seconds);
      if (this.isPending && time - drawnAt > PATIENCE * cost) this.isDirty = true;
      if (!isChanged && !this.isDirty) return;
      this.draw();
      [drawnAt, isMeasuring] = [time, true];
    });
  }

  draw() {
    this.isDirty = false;
    this.isPending = false;
    const started = performance.now();
    this.renderer.render(this.scene, this.camera);
    this.frameTime = performance.now() - started;
    this.drawn?.();
  }
}
