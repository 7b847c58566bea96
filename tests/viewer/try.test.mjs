// The page of docs/try: what goes into the program and comes out of it, and the page in Chromium where ROOMWRIGHT_TRY names the
// folder that web/build.sh wrote.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Program, refusals } from '../../docs/try/program.js';
import { WorkerTransport } from '../../docs/try/transport.js';
import { Page } from './page.mjs';
import { chromium, driver, skipBrowser } from './requirements.mjs';
import { serveFolder } from './static_host.mjs';

/** Exports that note the texts that they get, and answer with `answer`; the memory moves with each allocation, as a real one may. */
function exportsThatAnswer(status, answer) {
  const texts = [];
  const held = new Map();
  let [buffer, end] = [new ArrayBuffer(16), 8];
  const read = (at, length) => {
    assert.ok(held.has(at) && length <= held.get(at));
    return new TextDecoder().decode(new Uint8Array(buffer, at, length));
  };
  const allocate = (bytes) => {
    const at = end;
    end += bytes;
    const grown = new ArrayBuffer(end);
    new Uint8Array(grown).set(new Uint8Array(buffer, 0, Math.min(buffer.byteLength, at)));
    buffer = grown;
    held.set(at, bytes);
    return at;
  };
  const run = (...values) => {
    texts.push(...values.slice(0, 4).map((at, index) => index % 2 === 0 ? read(at, values[index + 1]) : null).filter((text) => text !== null));
    texts.push(...values.slice(4));
    return status;
  };
  const bytes = new TextEncoder().encode(answer);
  return {
    texts, held,
    memory: { get buffer() { return buffer; } },
    roomwright_allocate: allocate,
    roomwright_free(at, count) { assert.equal(held.get(at), count); held.delete(at); },
    roomwright_open: run, roomwright_ask: run, roomwright_level: run,
    roomwright_answer() { const at = allocate(bytes.length); held.delete(at); new Uint8Array(buffer, at).set(bytes); return at; },
    roomwright_answer_length: () => bytes.length,
  };
}

const textOf = (bytes) => new TextDecoder().decode(bytes);

test('texts go in and come out whole, and what is allocated is freed', () => {
  const exports = exportsThatAnswer(422, 'plan.yaml:3: Straße?');
  const { status, bytes } = new Program(exports).open('plän.yaml', 'version: 1 # 床', 7);
  assert.deepEqual([status, textOf(bytes)], [422, 'plan.yaml:3: Straße?']);
  assert.deepEqual(exports.texts, ['plän.yaml', 'version: 1 # 床', 7]);
  assert.equal(exports.held.size, 0);
});

test('no seed and no body are said as the program expects', () => {
  const exports = exportsThatAnswer(200, '');
  const program = new Program(exports);
  program.open('a', 'b');
  assert.ok(Number.isNaN(exports.texts[2]));
  assert.equal(program.ask('api/site').bytes.byteLength, 0);
  assert.deepEqual(exports.texts.slice(3), ['api/site', '']);
});

test('an import that the program calls throws, and says which', () => {
  const { env } = refusals([{ module: 'env', name: 'clock' }, { module: 'env', name: 'now' }]);
  assert.throws(() => env.clock(), /env\.clock/);
});

test('answers of the worker come to their questions, in any order, and shared files are asked for once', async () => {
  const asked = [];
  const worker = { addEventListener: (_, hear) => { worker.hear = hear; }, postMessage: (question) => asked.push(question) };
  const transport = new WorkerTransport(worker);
  const [first, second] = [transport.ask('api/site'), transport.level({ building: 'house', level: 'upper' })];
  assert.deepEqual(asked.map(({ method, values }) => [method, values[0]]), [['ask', 'api/site'], ['level', 'house']]);
  worker.hear({ data: { number: asked[1].number, status: 200, bytes: new ArrayBuffer(2) } });
  worker.hear({ data: { number: asked[0].number, status: 404, bytes: new ArrayBuffer(1) } });
  assert.deepEqual([(await first).status, (await second).bytes.byteLength], [404, 2]);
  const [once, again] = [transport.locate('a.png'), transport.locate('a.png')];
  worker.hear({ data: { number: asked[2].number, status: 200, bytes: new ArrayBuffer(3) } });
  assert.equal(asked.length, 3);
  assert.match(await once, /^blob:/);
  assert.equal(await once, await again);
  URL.revokeObjectURL(await once);
});

test('the policy of the page allows its import map', async () => {
  const page = await readFile(fileURLToPath(new URL('../../docs/try/index.html', import.meta.url)), 'utf8');
  const [, map] = /<script type="importmap">(.*?)<\/script>/.exec(page);
  assert.ok(page.includes(`'sha256-${createHash('sha256').update(map).digest('base64')}'`));
});

const folder = process.env.ROOMWRIGHT_TRY;

describe('the page that furnishes by itself', { skip: !folder && 'ROOMWRIGHT_TRY names no folder' || skipBrowser }, () => {
  let host, page;

  before(async () => {
    host = await serveFolder(folder);
    page = await Page.open(driver.chromium, chromium, host.url);
  });
  after(async () => {
    await page?.close();
    await host?.stop();
  });

  test('faults of a plan are shown', async () => {
    await page.fill('#plan', 'version: 1\nlevels: 7\n');
    await page.activate('#furnish');
    await page.waitForText('#told', /plan\.yaml:2/);
  });

  test('the sample is furnished and shown', async () => {
    await page.activate('#sample');
    const { rooms, level } = await page.settled();
    assert.deepEqual([rooms, level], [7, 'ground']);
    assert.equal(await page.isVisible('#piece-buttons'), false);
  });

  test('another seed furnishes otherwise', async () => {
    const before = JSON.stringify(await page.piecesOf('kitchen'));
    await page.fill('#seed', '5');
    await page.press('Enter');
    await page.until(async () => JSON.stringify(await page.piecesOf('kitchen')) !== before);
    await page.settled();
  });

  test('the level is saved as a file', async () => {
    const download = page.page.waitForEvent('download');
    await page.activate('#save');
    const file = await download;
    assert.equal(file.suggestedFilename(), 'house-ground.glb');
    assert.equal((await readFile(await file.path())).subarray(0, 4).toString(), 'glTF');
  });

  test('another plan takes its place', async () => {
    await page.activate('#another');
    await page.fill('#plan', 'version: 1\nid: house\nlevels:\n  - id: ground\n    rooms:\n      - {id: living, type: study, rectangle: [0, 0, 4, 3]}\n');
    await page.activate('#furnish');
    await page.until(async () => (await page.stats()).rooms === 1);
    await page.settled();
  });

  test('there was no error, no failed request and no request to another host', () => {
    assert.deepEqual(page.faults, []);
  });
});
