// A recorded flight from 2 km to a room of a tower and away again, in both clients. It takes minutes where nothing but the processor
// draws: ROOMWRIGHT_LONG=1 bash scripts/test.sh, or
//
//   ROOMWRIGHT_LONG=1 ROOMWRIGHT_PROGRAM=target/release/roomwright node --test tests/tiles/flight.test.mjs
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch } from '../viewers/browser.mjs';
import { CLIENTS } from './client.mjs';
import { fly } from './flight.mjs';
import { chromium, reasonToSkip, write } from './program.mjs';
import { serve } from './serve.mjs';

const PLAN = 'configs/plans/hotel-tower.yaml';
/** Megabytes from 2 km into a room and a corridor, from a host that does not compress. */
const MOST_LOADED = 25;
/** Draw calls before the façade. */
const MOST_COMMANDS = 300;
/** Metres beyond which nothing but the tileset may load. */
const FARTHEST = 110;

const skip = reasonToSkip() || !process.env.ROOMWRIGHT_LONG && 'ROOMWRIGHT_LONG is not set: the flight takes minutes';

describe('a flight to a tower', { skip }, () => {
  let browser, folder, server;

  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'roomwright-flight-'));
    write('tiles', PLAN, folder);
    server = await serve(folder);
    browser = await launch(chromium);
  });
  after(async () => {
    await browser?.close();
    server?.close();
    rmSync(folder, { recursive: true, force: true });
  });

  for (const client of CLIENTS) {
    test(`${client} loads near what it shows, and lets go of it behind`, async (context) => {
      const { rows, said, version } = await fly(browser, server, client, { told: (row) => context.diagnostic(JSON.stringify(row)) });
      context.diagnostic(JSON.stringify({ client, version }));
      assert.deepEqual(said.errors, []);
      assert.deepEqual(server.sent.filter(({ status }) => status !== 200), []);
      const row = (stop) => rows.find((one) => one.stop === stop);
      assert.equal(row(`${FARTHEST} m`).requests, 1, 'tiles load from afar');
      assert.ok(row('room').full > 0, 'the room is not there in full');
      assert.ok(rows.at(-1).plain_mb <= MOST_LOADED, `${rows.at(-1).plain_mb} MB were sent`);
      const before = rows.slice(0, rows.findIndex(({ stop }) => stop === 'room'));
      for (const { stop, commands } of before) assert.ok(commands <= MOST_COMMANDS, `${commands} draw calls at ${stop}`);
      assert.equal(rows.at(-1).commands, 0);
      assert.ok(rows.at(-1).held < Math.max(...rows.map(({ held }) => held)), 'tiles are kept that nobody sees');
    });
  }
});
