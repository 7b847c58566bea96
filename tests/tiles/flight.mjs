// A flight to a tower, into a room and away again, in one client: what loads on the way, and what is let go.
import { open } from './client.mjs';

/** In the frame of the site. The tower is 80 m long, its southern façade stands along y = 0, and its fifth level begins at 12 m. */
const MIDDLE = 40;
const STOREY = 13.5;
const ROOM = [42, 3, 13.6];
const FACADE = -0.3;

const before = (metres, height = STOREY) => ({ eye: [MIDDLE, FACADE - metres, height], target: [MIDDLE, 7.6, STOREY] });

/** Where the flight stops until nothing more loads. */
export const STOPS = [
  ...[2000, 1000, 500, 250, 150, 120, 110].map((metres) => ({ name: `${metres} m`, ...before(metres) })),
  ...[90, 70, 60, 30, 15, 6].map((metres) => ({ name: `${metres} m`, ...before(metres) })),
  { name: 'room', eye: ROOM, target: [42, -3, 13] },
  { name: 'corridor', eye: [41, 7.6, 13.6], target: [60, 7.6, 13.2] },
  { name: '30 m, back', ...before(30) },
  { name: '2000 m, back', ...before(2000) },
];

/** Megabytes beyond which a client lets go of what it does not show: less than the flight loads, so that one sees whether it does. */
const CACHE = 16;

/** A row for each stop: what the server has sent so far, and the state of the client. `told` gets each row at once. */
export async function fly(browser, server, client, { stops = STOPS, told = () => {}, picture = null } = {}) {
  server.sent.length = 0;
  const page = await open(browser, server.url, client, { size: [320, 180] });
  await page.call('limit', CACHE);
  const rows = [];
  for (const { name, eye, target } of stops) {
    const started = Date.now();
    await page.call('look', eye, target);
    const state = await page.call('settle');
    const row = { stop: name, ...summary(server.sent), ...details(state), seconds: Math.round((Date.now() - started) / 1000) };
    rows.push(row);
    told(row);
    if (picture) await page.picture(picture(name));
  }
  const { said, version } = page;
  await page.close();
  return { rows, said, version };
}

function summary(sent) {
  const megabytes = (key) => Number((sent.reduce((sum, one) => sum + one[key], 0) / 1e6).toFixed(2));
  return { requests: sent.length, plain_mb: megabytes('bytes'), gzip_mb: megabytes('compressed') };
}

function details({ commands, shown, held, megabytes }) {
  const count = (detail) => shown.filter((path) => path.endsWith(`.${detail}.glb`)).length;
  return { commands, boxes: count('boxes'), reduced: count('reduced'), full: count('full'), held, memory_mb: Math.round(megabytes) };
}
