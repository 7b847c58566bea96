// The demo in browser clients at their default settings: bash scripts/test.sh, or
//
//   ROOMWRIGHT_BAKED=out node --test tests/viewers/viewers.test.mjs
//
// ROOMWRIGHT_BAKED names a folder that `roomwright bake` wrote the demo into. Without it, or without Chromium, the tests are skipped.
import assert from 'node:assert/strict';
import { dirname, basename, join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch } from './browser.mjs';
import { findChromium } from './find_chromium.mjs';
import { countNodes, readFloor, viewOf } from './floor.mjs';
import { serve } from './serve.mjs';
import { CLIENTS, show } from './show.mjs';

/** A small floor with lamps of every kind, and the floor with the most nodes and lamps. */
const FLOORS = ['house/ground.glb', 'hotel/1.glb'];
const SIZE = [320, 200];
/** Luminance as displayed. A room that is lit well is between; the clients' pictures of the demo are between 0.39 and 0.88. */
const [DARKEST_MEAN, BRIGHTEST_MEAN] = [0.25, 0.9];
/** Shares of all pixels. White walls under the lamps of three.js' environment are a fifth of a picture. */
const [MOST_BLACK, MOST_WHITE] = [0.2, 0.45];
/** Between the darkest and the brightest twentieth: less is a wall, or nothing. */
const LEAST_CONTRAST = 0.1;

const chromium = findChromium();
const folder = process.env.ROOMWRIGHT_BAKED;
const skip = !folder && 'ROOMWRIGHT_BAKED names no folder of baked floors'
  || chromium === null && 'no chromium or google-chrome on the path; ROOMWRIGHT_CHROMIUM names another';

for (const name of FLOORS) {
  describe(name, { skip }, () => {
    let browser, server, floor, source;

    before(async () => {
      const path = join(folder, name);
      floor = readFloor(path);
      // The floor's own folder and nothing beside it: a file that is sent alone must be complete.
      server = await serve(dirname(path));
      source = `${server.url}/files/${basename(path)}`;
      browser = await launch(chromium);
    });
    after(async () => {
      await browser?.close();
      server?.close();
    });

    for (const client of CLIENTS) {
      test(`${client} shows every object, without errors, neither black nor white`, async (context) => {
        const query = { source, frames: 0, ...viewOf(floor) };
        const report = await show(browser, server.url, client, { query, size: SIZE });
        context.diagnostic(JSON.stringify(report));
        isComplete(report, floor);
        isWellLit(report);
      });
    }
  });
}

function isComplete(report, floor) {
  assert.ok(report.is_loaded, report.error);
  assert.deepEqual([...report.errors], []);
  assert.deepEqual([...report.outside], []);
  const { nodes, mesh_nodes } = report;
  assert.deepEqual({ nodes, mesh_nodes }, countNodes(floor));
}

function isWellLit({ mean, dark, bright, black, white }) {
  assert.ok(mean > DARKEST_MEAN && mean < BRIGHTEST_MEAN, `mean luminance ${mean}`);
  assert.ok(black < MOST_BLACK, `${black} of all pixels are black`);
  assert.ok(white < MOST_WHITE, `${white} of all pixels are white`);
  assert.ok(bright - dark > LEAST_CONTRAST, `luminances only from ${dark} to ${bright}`);
}
