// The page of `roomwright view` in Chromium, on a copy of the demo's house: bash scripts/test.sh, or
//
//   ROOMWRIGHT_PROGRAM=target/release/roomwright node --test tests/viewer/viewer.test.mjs
//
// Without ROOMWRIGHT_PROGRAM, Chromium or the packages of package.json, the test is skipped and says why.
import assert from 'node:assert/strict';
import { access, copyFile, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Page } from './page.mjs';
import { startView } from './program.mjs';
import { chromium, driver, program, skip } from './requirements.mjs';

const HOUSE = fileURLToPath(new URL('../../configs/plans/house.yaml', import.meta.url));

describe('roomwright view', { skip }, () => {
  let folder, view, page;

  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'roomwright-view-'));
    await copyFile(HOUSE, join(folder, 'house.yaml'));
    view = await startView(program, join(folder, 'house.yaml'));
    page = await Page.open(driver.chromium, chromium, view.url);
  });
  after(async () => {
    await page?.close();
    await view?.stop();
    if (folder) await rm(folder, { recursive: true, force: true });
  });

  test('all rooms of a level come, in few draw calls', async () => {
    const stats = await page.settled();
    assert.equal(stats.building, 'house');
    assert.equal(stats.level, 'ground');
    assert.equal(stats.rooms, 7);
    assert.ok(stats.triangles > 10000, `${stats.triangles} triangles`);
    assert.ok(stats.calls <= 150, `${stats.calls} draw calls`);
  });

  test('by keyboard, somebody walks through three doors', async () => {
    await page.focusPicture();
    await page.press('3');
    await page.chooseRoom('hall');
    // Each door of the house with a place before it: the study and back, then the store.
    for (const [x, y, room] of [[4.6, 6, 'hall'], [3, 6, 'study'], [4.6, 6, 'hall'], [8.3, 5.7, 'hall'], [8.3, 7.2, 'store']]) {
      await page.walkTo([x, y]);
      assert.equal((await page.stats()).room, room);
    }
  });

  test('walls and furniture stop a walker', async () => {
    await page.walkTowards(Math.PI / 2, 3000);
    const { room, position } = await page.stats();
    assert.equal(room, 'store');
    assert.ok(position[1] < 9, `at ${position}`);
  });

  test('a clicked piece is chosen and explained, moved by keys, written to the edits file, and there after a reload', async () => {
    await page.press('1');
    await page.chooseRoom('living');
    await page.choosePiece('coffee_table.1');
    await page.press('Escape');
    await page.clickMiddle();
    const { selected } = await page.stats();
    assert.equal(selected?.room, 'living');
    assert.ok(selected.piece, 'no piece in the middle of the picture');
    await page.waitForText('#reason', /places? tried/);

    const [x, y] = (await page.stats()).place;
    for (const key of ['ArrowUp', 'ArrowUp', 'Shift+ArrowUp']) await page.press(key);
    const moved = (await page.stats()).place;
    assert.ok(Math.abs(Math.hypot(moved[0] - x, moved[1] - y) - 0.11) < 0.001, `moved from ${[x, y]} to ${moved}`);
    await page.waitForFile(join(folder, 'house.edits.yaml'), new RegExp(selected.piece.replace('.', '\\.')));

    await page.reload();
    await page.settled();
    await page.choosePiece(selected.piece, selected.room);
    const { place } = await page.stats();
    assert.ok(Math.hypot(place[0] - moved[0], place[1] - moved[1]) < 0.002, `${place} after the reload, ${moved} before`);
  });

  test('the edit is forgotten on request', async () => {
    const { selected } = await page.stats();
    await page.activate('#forget');
    await page.until(async () => !(await readFile(join(folder, 'house.edits.yaml'), 'utf8').catch(() => '')).includes(selected.piece));
  });

  test('after a restart, locked and removed pieces are said to be so, and a removed one is brought back', async () => {
    await page.choosePiece('coffee_table.1', 'living');
    await page.activate('#lock');
    await page.waitForText('#piece-facts', /locked/);
    const [{ id }] = await page.piecesOf('store');
    await page.choosePiece(id, 'store');
    await page.activate('#remove');
    await page.waitForText('#piece-facts', /removed by an edit/);

    await page.leave();
    await view.stop();
    view = await startView(program, join(folder, 'house.yaml'));
    await page.visit(view.url);
    await page.settled();
    await page.choosePiece('coffee_table.1', 'living');
    await page.waitForText('#piece-facts', /locked/);
    assert.equal(await page.isPressed('#lock'), true);
    await page.activate('#forget');
    await page.choosePiece(id, 'store');
    assert.equal((await page.piecesOf('store')).some((piece) => piece.id === id), false);
    await page.activate('#forget');
    await page.until(async () => (await page.piecesOf('store')).some((piece) => piece.id === id));
  });

  test('a room is rerolled, the house furnished by another seed', async () => {
    const before = await page.piecesOf('study');
    await page.chooseRoom('study');
    await page.activate('#reroll');
    await page.until(async () => JSON.stringify(await page.piecesOf('study')) !== JSON.stringify(before));
    await access(join(folder, 'house.edits.yaml'));
    const kitchen = await page.piecesOf('kitchen');
    await page.fill('#seed', '5');
    await page.press('Enter');
    await page.until(async () => JSON.stringify(await page.piecesOf('kitchen')) !== JSON.stringify(kitchen));
  });

  test('every control is reached by Tab and works by keyboard', async () => {
    const reached = await page.tabThrough();
    for (const id of await page.visibleControls()) assert.ok(reached.has(id), `${id} is not reached by Tab`);
    await page.activate('[data-mode="plan"]');
    assert.equal((await page.stats()).mode, 'plan');
    await page.activate('#lamps');
    assert.equal((await page.stats()).light, 'lamp');
    await page.activate('#lamps');
    await page.activate('#open-help');
    assert.ok(await page.isVisible('#help'));
    await page.press('Escape');
    await page.focusPicture();
    await page.press('PageUp');
    await page.until(async () => (await page.stats()).level === 'upper');
    assert.ok((await page.settled()).rooms > 0);
  });

  test('the stairs lead to the level below', async () => {
    await page.press('3');
    await page.chooseRoom('landing').catch(() => undefined);
    const stairs = await page.stairs();
    assert.ok(stairs, 'no room of the upper level leads down');
    await page.chooseRoom(stairs);
    await page.press('q');
    await page.until(async () => (await page.stats()).level === 'ground');
    await page.settled();
  });

  test('there was no error, no failed request and no request to another host', () => {
    assert.deepEqual(page.faults, []);
  });
});
