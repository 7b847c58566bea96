// The WebAssembly writes the bytes of the native program: ROOMWRIGHT_WASM names the module, ROOMWRIGHT_PROGRAM the command.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const plans = join(import.meta.dirname, '..', 'configs', 'plans');
const { ROOMWRIGHT_WASM: wasm, ROOMWRIGHT_PROGRAM: program } = process.env;

// Functions of a browser that the module could ask for stay unbound: it must work without them.
async function open(name, text, seed) {
  const module = await WebAssembly.compile(readFileSync(wasm));
  const imports = {};
  for (const { module: from, name: wanted } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[wanted] = () => { throw new Error(`${wanted} was called`); };
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  const held = (text) => {
    const bytes = new TextEncoder().encode(text);
    const place = exports.roomwright_allocate(bytes.length);
    new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
    return [place, bytes.length];
  };
  const call = (ask, texts, ...numbers) => {
    const places = texts.map(held);
    const status = ask(...places.flat(), ...numbers);
    places.forEach(([place, length]) => exports.roomwright_free(place, length));
    const answer = new Uint8Array(exports.memory.buffer, exports.roomwright_answer(), exports.roomwright_answer_length());
    return { status, answer: Buffer.from(answer) };
  };
  const opened = call(exports.roomwright_open, [name, text], seed);
  return {
    opened,
    ask: (address, body = '') => call(exports.roomwright_ask, [address, body]),
    level: (building, level) => call(exports.roomwright_level, [building, level]),
  };
}

for (const [plan, seed] of [['house', 7], ['hotel', 3], ['office', 1]]) {
  test(`${plan}: every level has the bytes of a bake`, async () => {
    const file = join(plans, `${plan}.yaml`);
    const folder = mkdtempSync(join(tmpdir(), 'roomwright-web-'));
    try {
      execFileSync(program, ['bake', file, '--seed', String(seed), '--out', folder, '--quiet']);
      const page = await open(`${plan}.yaml`, readFileSync(file, 'utf8'), seed);
      assert.equal(page.opened.status, 200, page.opened.answer.toString());
      const site = JSON.parse(page.ask('api/site').answer);
      const [building] = site.buildings;
      assert.ok(building.levels.length > 0);
      for (const { id } of building.levels) {
        const { status, answer } = page.level(building.id, id);
        assert.equal(status, 200);
        const baked = readFileSync(join(folder, building.id, `${id}.glb`));
        assert.ok(answer.equals(baked), `${building.id}/${id}: ${answer.length} bytes, a bake has ${baked.length}`);
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}

test('faults of a plan are told in words', async () => {
  const page = await open('mine.yaml', 'version: 1\nlevels: 7\n', NaN);
  assert.equal(page.opened.status, 422);
  assert.match(page.opened.answer.toString(), /mine\.yaml:2/);
  assert.equal(page.ask('api/site').status, 404);
});
