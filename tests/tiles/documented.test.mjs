// The pages that docs/viewers.md prints, as they are printed: they load a house, and a click names a piece.
//
//   ROOMWRIGHT_PROGRAM=target/release/roomwright node --test tests/tiles/documented.test.mjs
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch } from '../viewers/browser.mjs';
import { chromium, reasonToSkip, write } from './program.mjs';
import { serve } from './serve.mjs';

const DOCUMENT = new URL('../../docs/viewers.md', import.meta.url);
const PLAN = 'configs/plans/house.yaml';
const SIZE = { width: 320, height: 200 };
const TIME_LIMIT = 120_000;

/** The indented blocks of the document that are whole pages. */
const PAGES = readFileSync(DOCUMENT, 'utf8').split(/\n(?=\S)/)
  .map((part) => part.split('\n').filter((line) => line === '' || line.startsWith('    ')).map((line) => line.slice(4)).join('\n').trim())
  .filter((text) => text.startsWith('<!doctype html>'));

test('the document prints a page for each client', () => {
  assert.deepEqual(PAGES.map((page) => /new (Cesium\.Viewer|TilesRenderer)/.exec(page)?.[1]), ['Cesium.Viewer', 'TilesRenderer']);
});

describe('a documented page', { skip: reasonToSkip() }, () => {
  let browser, folder, server;

  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'roomwright-documented-'));
    // The screen is small: on a large one, tiles are shown from as far with the default.
    write('tiles', PLAN, folder, '--near', '100,35,12');
    server = await serve(folder);
    browser = await launch(chromium);
  });
  after(async () => {
    await browser?.close();
    server?.close();
    rmSync(folder, { recursive: true, force: true });
  });

  for (const [number, name] of ['CesiumJS', '3d-tiles-renderer'].entries()) {
    test(`${name} loads the tileset, and a click names a piece`, async (context) => {
      const page = await browser.newPage({ viewport: SIZE });
      page.setDefaultTimeout(TIME_LIMIT);
      const [said, errors] = [[], []];
      page.on('console', (message) => (message.type() === 'error' ? errors : said).push(message.text()));
      page.on('pageerror', (error) => errors.push(error.message));
      await page.route(`${server.url}/page.html`, (route) => route.fulfill({ contentType: 'text/html', body: PAGES[number] }));
      await page.goto(`${server.url}/page.html`);
      await page.waitForFunction(() => window.isLoaded?.());
      await page.mouse.click(SIZE.width / 2, SIZE.height / 2);
      const named = () => said.find((text) => /\b(walls?|window|door|floor|wall\.\d+)\b|\.\d+$/.test(text) && !text.includes('limited support'));
      for (let waited = 0; !named() && waited < TIME_LIMIT; waited += 100) await new Promise((resolve) => { setTimeout(resolve, 100); });
      context.diagnostic(`${name}: ${named()}`);
      assert.deepEqual(errors, []);
      assert.ok(named(), `no piece is named: ${said}`);
      await page.close();
    });
  }
});
