// A house as 3D Tiles in the clients that stream cities: ROOMWRIGHT_LONG=1 bash scripts/test.sh, or
//
//   ROOMWRIGHT_LONG=1 ROOMWRIGHT_PROGRAM=target/release/roomwright node --test tests/tiles/tiles.test.mjs
//
// Without the program or without Chromium, the tests are skipped.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch } from '../viewers/browser.mjs';
import { CLIENTS, open } from './client.mjs';
import { chromium, reasonToSkip, write } from './program.mjs';
import { serve } from './serve.mjs';
import { distanceTo, distanceToBox, keyOf, randomNumbers, readPieces } from './truth.mjs';

const PLAN = 'configs/plans/house.yaml';
const SIZE = [320, 180];

/** Pixels of which each view must name the piece. */
const PIXELS_OF_VIEW = { full: 50, reduced: 20, boxes: 20 };
/** Metres from the point that was hit to the piece that was named: in full tiles to its surface, in others to its box. */
const MOST = { full: 0.02, reduced: 0.05, boxes: 0.3 };
/** Metres up to which boxes, reduced and full furniture are shown, whatever the default is: the views are chosen for these. */
const NEAR = '100,35,12';
/** Where the camera is and what it looks at, in the frame of the site. Four views in full make 200 pixels. */
const VIEWS = [
  { detail: 'boxes', eye: [5, -60, 20], target: [5, 4, 3] },
  { detail: 'reduced', eye: [-12, -18, 8], target: [5, 4, 3] },
  { detail: 'full', eye: [5, -7, 4], target: [5, 4, 2] },
  { detail: 'full', eye: [6.6, 0.5, 1.6], target: [2.5, 3.8, 1.0] },
  { detail: 'full', eye: [9, 3.5, 1.6], target: [9, 0, 1.0] },
  { detail: 'full', eye: [2, 2.5, 4.5], target: [5, 3, 3.8] },
];

// Minutes where nothing but the processor draws.
const skip = reasonToSkip() || !process.env.ROOMWRIGHT_LONG && 'ROOMWRIGHT_LONG is not set: 240 pixels in two clients take minutes';

describe('a house', { skip }, () => {
  let browser, folder, server, pieces;

  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'roomwright-tiles-'));
    write('tiles', PLAN, join(folder, 'tiles'), '--near', NEAR);
    write('bake', PLAN, join(folder, 'bake'));
    pieces = readPieces(join(folder, 'bake', 'house'));
    server = await serve(join(folder, 'tiles'));
    browser = await launch(chromium);
  });
  after(async () => {
    await browser?.close();
    server?.close();
    rmSync(folder, { recursive: true, force: true });
  });

  for (const client of CLIENTS) {
    test(`${client} loads every detail without a fault, and each pixel names its piece`, async (context) => {
      server.sent.length = 0;
      const page = await open(browser, server.url, client, { size: SIZE });
      const random = randomNumbers(1);
      const farthest = { full: 0, reduced: 0, boxes: 0 };
      const named = { full: 0, reduced: 0, boxes: 0 };
      const wrong = [];
      for (const { detail, eye, target } of VIEWS) {
        await page.call('look', eye, target);
        const state = await page.call('settle');
        assert.ok(state.shown.length > 0 && state.shown.every((path) => path.endsWith(`.${detail}.glb`)), `${detail}: ${state.shown}`);
        for (let tried = 0, count = 0; count < PIXELS_OF_VIEW[detail]; tried += 1) {
          assert.ok(tried < 2000, `too few pixels show the house from ${eye}`);
          const found = await page.call('pick', Math.floor(random() * SIZE[0]), Math.floor(random() * SIZE[1]));
          if (found === null) continue;
          count += 1;
          named[detail] += 1;
          const piece = pieces.get(keyOf(found));
          const distance = piece && found.point && (detail === 'full' ? distanceTo : distanceToBox)(piece, found.point);
          if (!(distance <= MOST[detail])) wrong.push(`${detail} ${JSON.stringify(found)}: ${piece ? `${distance} m away` : 'no such piece'}`);
          else farthest[detail] = Math.max(farthest[detail], distance);
        }
      }
      context.diagnostic(JSON.stringify({ client, version: page.version, named, farthest, wrong: wrong.length }));
      assert.deepEqual(wrong, []);
      assert.deepEqual(page.said.errors, []);
      assert.deepEqual(page.said.outside, []);
      assert.deepEqual(server.sent.filter(({ status }) => status !== 200), []);
      await page.close();
    });
  }
});
