// What all pages share: settings from the address, a report for the script that opened the page.

const query = new URLSearchParams(location.search);
const vector = (name) => query.has(name) ? query.get(name).split(',').map(Number) : null;

/** `source`: address of the floor. `eye`, `target`: glTF metres, null for the client's own view. `fov`: vertical degrees. `frames`: timed. */
export const settings = {
  source: query.get('source'),
  eye: vector('eye'),
  target: vector('target'),
  fov: Number(query.get('fov') ?? 60),
  frames: Number(query.get('frames') ?? 3),
};

/** Runs a page: `show` gives what the script is told about the floor. Errors are told, too. */
export async function run(show) {
  try {
    window.report = { is_loaded: true, ...await show() };
  } catch (error) {
    window.report = { is_loaded: false, error: String(error?.message ?? error) };
  }
}

/** Milliseconds of `load`, with what it gives. */
export async function timed(load) {
  const started = performance.now();
  const value = await load();
  return [value, performance.now() - started];
}

/** Milliseconds of one frame, the mean of a few after the first; null if none is timed. `draw` must return when the picture is there. */
export async function frameTime(draw) {
  await draw();
  if (settings.frames === 0) return null;
  const [, total] = await timed(async () => {
    for (let frame = 0; frame < settings.frames; frame += 1) await draw();
  });
  return total / settings.frames;
}

/** Waits until the graphics side has drawn: reading one pixel cannot be answered sooner. */
export function finish(context) {
  context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
}
