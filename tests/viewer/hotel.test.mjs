// A walk through a hotel of 1,000 rooms in Chromium: from the lobby by lift to the top floor, into a room, back, and out of the
// house. It takes some five minutes where no graphics card draws: ROOMWRIGHT_LONG=1 runs it, where viewer.test.mjs runs.
import assert from 'node:assert/strict';
import { mkdtemp, rm, copyFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Page } from './page.mjs';
import { startView } from './program.mjs';
import { chromium, driver, program, skip as skipPage } from './requirements.mjs';

const HOTEL = fileURLToPath(new URL('../../configs/plans/grand-hotel.yaml', import.meta.url));
/** A picture so small is drawn in software as fast as somebody walks. */
const SIZE = { width: 240, height: 180 };
/** Calls that a weak card draws in a sixtieth of a second. */
const MOST_CALLS = 300;
const skip = skipPage || !process.env.ROOMWRIGHT_LONG && 'it takes minutes: ROOMWRIGHT_LONG=1 runs it';

describe('a walk through a hotel', { skip }, () => {
  let folder, view, page;

  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'roomwright-hotel-'));
    await copyFile(HOTEL, join(folder, 'grand-hotel.yaml'));
    view = await startView(program, join(folder, 'grand-hotel.yaml'));
    page = await Page.open(driver.chromium, chromium, `${view.url}#grand-hotel/lobby/walk`, SIZE);
  });
  after(async () => {
    await page?.close();
    await view?.stop();
    if (folder) await rm(folder, { recursive: true, force: true });
  });

  /** Every room in view is drawn, soon, with few calls. */
  async function everythingInView() {
    let seen;
    await page.until(async () => {
      seen = await page.inView();
      return seen.visible.length > 0 && seen.visible.every((room) => seen.shown.includes(room));
    });
    const { calls } = await page.stats();
    assert.ok(calls <= MOST_CALLS, `${calls} draw calls`);
  }

  async function goInto(room, place) {
    await page.goTo(place);
    assert.equal((await page.stats()).room, room);
    await everythingInView();
  }

  test('from the lobby, one gets into the lift', async () => {
    await page.settled();
    await page.focusPicture();
    await goInto('lobby', [40, 5.6]);
    await goInto('landing-west', [-3, 7.6]);
    await page.goTo([-3, 7.1]);
    assert.ok(await page.openness('s15') > 0.5, 'the door of the lift is shut');
    await goInto('lift-west', [-3, 5.5]);
  });

  test('the lift offers all 26 levels, and goes to the top floor', async () => {
    assert.equal(await page.page.locator('#lift button').count(), 26);
    await page.ride('25');
    assert.equal((await page.stats()).room, 'lift-west');
    await everythingInView();
  });

  test('on the top floor, one walks along the corridor into a room', async () => {
    await page.settled();
    await goInto('landing-west', [-3, 7.6]);
    await goInto('corridor', [11, 7.6]);
    await goInto('2505', [11.2, 9.3]);
    assert.ok((await page.piecesOf('2505')).length > 3);
    assert.equal(await page.isVisible('#lift'), false);
  });

  test('back in the lift, one level down and to the lobby', async () => {
    await goInto('corridor', [11, 7.6]);
    await goInto('lift-west', [-3, 5.5]);
    await page.press('q');
    await page.until(async () => (await page.stats()).level === '24');
    await page.ride('lobby');
    await page.settled();
    await goInto('lobby', [40, 5.6]);
  });

  test('the entrance opens, and lets one out as far as its apron', async () => {
    await page.goTo([40, -1.6]);
    assert.ok(await page.openness('entrance') > 0);
    await page.walkTowards(Math.PI, 4000);
    const { position } = await page.stats();
    assert.ok(position[0] > 36 && position[1] < 0, `at ${position}`);
    await page.goTo([40, 2]);
    assert.equal((await page.stats()).room, 'lobby');
  });

  test('there was no error, no failed request and no request to another host', () => {
    assert.deepEqual(page.faults, []);
  });
});
