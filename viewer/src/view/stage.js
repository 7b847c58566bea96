// The canvas: a renderer, a scene, and frames that are drawn only when something changed.
import { ACESFilmicToneMapping, Color, Scene, WebGLRenderer } from 'three';

/** Finer pixels cost more than they show. */
const FINEST_PIXELS = 2;
/** A frame after a pause would otherwise move everything by the whole pause (seconds). */
const LONGEST_STEP = 0.25;

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
    canvas.addEventListener('webglcontextlost', () => this.lost?.());
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  /** Draws the next frame. */
  invalidate() {
    this.isDirty = true;
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
    this.renderer.setAnimationLoop((time) => {
      const seconds = Math.min(LONGEST_STEP, Math.max(0, (time - last) / 1000));
      last = time;
      const started = performance.now();
      const isChanged = step(seconds);
      if (!isChanged && !this.isDirty) return;
      this.isDirty = false;
      this.renderer.render(this.scene, this.camera);
      this.frameTime = performance.now() - started;
      this.drawn?.();
    });
  }
}
