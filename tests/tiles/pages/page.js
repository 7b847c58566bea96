// What both pages share. A page gives `window.client`, which the test drives:
//
//   look(eye, target)   metres in the frame of the site, z up
//   settle()            draws until nothing more loads; gives state()
//   state()             {commands, shown, held, megabytes}: draw calls of the last frame, addresses of the tiles in it, how many
//                       tiles are in memory, and how much of it they say they take
//   pick(x, y)          the piece at a pixel, null for none: its table row, `point` in the frame of the site, `tile`
//   limit(megabytes)    the memory beyond which tiles that are not shown are let go

const query = new URLSearchParams(location.search);

/**
 * `source`: address of the tileset. `lines`: height in pixels of the screen that tiles are chosen for, whatever the size of the canvas.
 * `across`: degrees of the view from left to right.
 */
export const settings = {
  source: query.get('source'),
  lines: Number(query.get('lines') ?? 1080),
  across: Number(query.get('across') ?? 60),
};

/** The pixels of error at which both clients load finer tiles if nobody tells them otherwise. */
export const USUAL_ERROR = 16;

/** Milliseconds for which nothing may be on its way before a view counts as loaded: clients put off what is at the rim of a view. */
const QUIET = 500;
const LONGEST = 240_000;
/** Frames that a view gets however long each takes: CesiumJS asks for nothing in the first two after the camera has moved. */
const LEAST_FRAMES = 4;

/** Draws frames until `isIdle` has been true for a while. */
export async function settle(draw, isIdle) {
  const started = performance.now();
  let quietSince = started;
  for (let frames = 0; frames < LEAST_FRAMES || performance.now() - quietSince < QUIET; frames += 1) {
    draw();
    await new Promise((resolve) => setTimeout(resolve, 10));
    if (!isIdle()) quietSince = performance.now();
    if (performance.now() - started > LONGEST) throw new Error('tiles are still on their way');
  }
  draw();
}

/** The path of a tile, of its address. */
export const pathOf = (address) => new URL(address, location.href).pathname.replace(/^\/tiles\//, '');

/** Runs a page: `start` gives the client. Errors are told. */
export async function run(start) {
  try {
    window.client = await start();
    window.report = { is_ready: true, version: window.client.version };
  } catch (error) {
    window.report = { is_ready: false, error: String(error?.stack ?? error) };
  }
}
