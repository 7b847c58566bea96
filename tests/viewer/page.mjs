// The page in a browser, used as people use it: by keys and clicks. What is wrong on the way is collected in `faults`.
import { readFile } from 'node:fs/promises';
import { routeTo } from './route.mjs';

/** Chromium draws in software here; small pictures are drawn sooner. */
const SIZE = { width: 760, height: 420 };
const SWITCHES = [
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-dev-shm-usage',
  // Nothing but the page asks a server.
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-quic', '--no-first-run',
];
/** Milliseconds. */
const [LONGEST_WAIT, GLANCE] = [60_000, 100];
/** Metres from a place at which a walker is there, radians of a heading that is right. */
const [THERE, STRAIGHT] = [0.3, 0.12];
/** Radians that the view turns for each pixel of a drag. */
const TURN_A_PIXEL = 0.0045;
/** Metres of a way that is worth running. */
const RUN = 3;
/** Metres: who gets on by less stands before something. */
const STUCK = 0.05;
/** Milliseconds of a walk across a hotel. */
const LONGEST_WALK = 300_000;

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

export class Page {
  static async open(chromium, executablePath, url, viewport = SIZE) {
    const isRoot = process.getuid?.() === 0;
    const browser = await chromium.launch({ executablePath, headless: true, args: isRoot ? [...SWITCHES, '--no-sandbox'] : SWITCHES });
    const page = new Page(browser, await browser.newPage({ viewport, reducedMotion: 'reduce' }));
    page.page.setDefaultTimeout(LONGEST_WAIT);
    page.watch();
    await page.visit(url);
    return page;
  }

  constructor(browser, page) {
    Object.assign(this, { browser, page, faults: [] });
  }

  /** Opens an address; only its host may be asked from now on. */
  async visit(url) {
    this.host = new URL(url).host;
    await this.page.goto(url);
  }

  watch() {
    const { page, faults } = this;
    page.on('console', (message) => {
      if (message.type() === 'error') faults.push(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
    page.on('response', (response) => { if (response.status() >= 400) faults.push(`${response.status()}: ${response.url()}`); });
    page.on('requestfailed', (request) => {
      // A reload breaks off what is on its way, and the stream of events never ends.
      if (request.failure()?.errorText !== 'net::ERR_ABORTED') faults.push(`failed: ${request.url()}`);
    });
    page.on('request', (request) => {
      const address = new URL(request.url());
      if (!['blob:', 'data:'].includes(address.protocol) && address.host !== this.host) faults.push(`another host: ${request.url()}`);
    });
  }

  /** Leaves the page, so that its server can be stopped. */
  leave() {
    return this.page.goto('about:blank');
  }

  close() {
    return this.browser.close();
  }

  reload() {
    return this.page.reload();
  }

  stats() {
    return this.page.evaluate(() => window.roomwright?.stats());
  }

  async until(holds, longest = LONGEST_WAIT) {
    const end = Date.now() + longest;
    while (!await holds()) {
      if (Date.now() > end) {
        throw new Error(`still not so after ${longest} ms: ${holds}; ${JSON.stringify(await this.stats())}`);
      }
      await this.page.waitForTimeout(GLANCE);
    }
  }

  /** Waits until no room is on its way, and all that came are drawn. */
  async settled() {
    await this.until(async () => {
      const stats = await this.stats();
      return stats && stats.rooms > 0 && stats.waiting === 0 && stats.is_drawn;
    });
    await this.page.waitForTimeout(3 * GLANCE);
    return this.stats();
  }

  async press(key) {
    await this.page.keyboard.press(key);
    await this.page.waitForTimeout(GLANCE);
  }

  focusPicture() {
    return this.page.focus('#canvas');
  }

  /** Presses a button by the keyboard. */
  async activate(selector) {
    await this.page.waitForSelector(`${selector}:enabled`);
    await this.page.focus(selector);
    await this.press('Enter');
  }

  fill(selector, text) {
    return this.page.fill(selector, text);
  }

  async chooseRoom(room) {
    await this.page.selectOption('#room', room);
    await this.press('Escape');
  }

  async choosePiece(piece, room = null) {
    if (room) await this.page.selectOption('#room', room);
    await this.until(() => this.page.evaluate((id) => [...document.querySelectorAll('#piece option')].some(({ value }) => value === id), piece));
    await this.page.selectOption('#piece', piece);
    await this.page.waitForTimeout(5 * GLANCE);
  }

  async clickMiddle() {
    const { x, y, width, height } = await this.page.locator('#canvas').boundingBox();
    await this.page.mouse.click(x + width / 2, y + height / 2);
    await this.page.waitForTimeout(3 * GLANCE);
  }

  async waitForText(selector, pattern) {
    await this.until(async () => pattern.test(await this.page.textContent(selector)));
  }

  async waitForFile(path, pattern) {
    await this.until(async () => pattern.test(await readFile(path, 'utf8').catch(() => '')));
  }

  async isPressed(selector) {
    return await this.page.getAttribute(selector, 'aria-pressed') === 'true';
  }

  isVisible(selector) {
    return this.page.isVisible(selector);
  }

  /** The ids of a room's pieces with their places, as the panel lists them. */
  async piecesOf(room) {
    return this.page.evaluate((id) => window.roomwright.pieces(id), room);
  }

  stairs() {
    return this.page.evaluate(() => window.roomwright.stairs('below'));
  }

  async hold(key, milliseconds) {
    await this.page.keyboard.down(key);
    await this.page.waitForTimeout(milliseconds);
    await this.page.keyboard.up(key);
    await this.page.waitForTimeout(GLANCE);
  }

  async turnTo(heading) {
    await this.until(async () => {
      const off = wrapped(heading - (await this.stats()).heading);
      if (Math.abs(off) < STRAIGHT) return true;
      await this.hold(off > 0 ? 'ArrowLeft' : 'ArrowRight', Math.max(20, Math.abs(off) * 300));
      return false;
    });
  }

  /** Turns by dragging the picture, which is as precise however seldom a picture is drawn. */
  async lookTo(heading) {
    const { x, y, width, height } = await this.page.locator('#canvas').boundingBox();
    // The buttons of a lift lie over the right half.
    const [left, middle] = [x + width * 0.02, y + height / 2];
    await this.until(async () => {
      const off = wrapped(heading - (await this.stats()).heading);
      if (Math.abs(off) < STRAIGHT) return true;
      const reach = Math.max(-width * 0.45, Math.min(width * 0.45, off / TURN_A_PIXEL));
      await this.page.mouse.move(left + Math.max(0, -reach), middle);
      await this.page.mouse.down();
      await this.page.mouse.move(left + Math.max(0, reach), middle);
      await this.page.mouse.up();
      return false;
    });
  }

  async walkTowards(heading, milliseconds) {
    await this.turnTo(heading);
    await this.hold('w', milliseconds);
  }

  /** Walks to a place around what stands in the way, by keys. */
  async goTo(place) {
    const routed = async () => routeTo((await this.stats()).position, place, await this.page.evaluate(() => window.roomwright.obstacles()));
    let route = await routed();
    await this.until(async () => {
      if (route.length === 0) return true;
      const before = (await this.stats()).position;
      if (await this.stepTo(route[0])) route.shift();
      // Rooms that came meanwhile have furniture of their own.
      else if (distance(before, (await this.stats()).position) < STUCK) route = await routed();
      return false;
    }, LONGEST_WALK);
  }

  /** The rooms that the program says are in view from here, and those that are drawn. */
  inView() {
    return this.page.evaluate(async () => {
      const headers = { 'Content-Type': 'application/json', 'X-Roomwright': '1' };
      const viewpoint = window.roomwright.viewpoint();
      const answer = await fetch('api/look', { method: 'POST', headers, body: JSON.stringify(viewpoint) });
      const { rooms } = await answer.json();
      const visible = rooms.filter(({ level, is_visible: isVisible }) => isVisible && level === viewpoint.level);
      return { visible: visible.map(({ room }) => room), shown: window.roomwright.shown() };
    });
  }

  openness(opening) {
    return this.page.evaluate((id) => window.roomwright.openness(id), opening);
  }

  /** Takes the lift to a level by the keyboard: opens the list, and goes to its button. */
  async ride(level) {
    await this.focusPicture();
    await this.page.waitForSelector('#lift:not([hidden])');
    await this.press('Enter');
    await this.until(async () => {
      const [at, buttons] = await this.page.evaluate(() => [document.activeElement.dataset.level,
        [...document.querySelectorAll('#lift button')].map(({ dataset }) => dataset.level)]);
      if (at === level) return true;
      await this.press(buttons.indexOf(at) > buttons.indexOf(level) ? 'ArrowUp' : 'ArrowDown');
      return false;
    });
    await this.press('Enter');
    await this.until(async () => (await this.stats()).level === level);
  }

  /** Walks straight to a place, by keys. */
  async walkTo(place) {
    await this.until(() => this.stepTo(place));
  }

  /** Goes some way to a place; gives whether one was there already. */
  async stepTo([x, y]) {
    const { position } = await this.stats();
    const far = distance([x, y], position);
    if (far < THERE) return true;
    await this.lookTo(Math.atan2(y - position[1], x - position[0]));
    if (far > RUN) await this.page.keyboard.down('Shift');
    await this.hold('w', Math.min(2000, Math.max(60, far * 300)));
    await this.page.keyboard.up('Shift');
    return false;
  }

  /** The ids of all that Tab reaches, from the beginning of the page to its end. */
  async tabThrough() {
    const reached = new Set();
    await this.page.evaluate(() => document.activeElement?.blur());
    for (let count = 0; count < 200; count += 1) {
      await this.page.keyboard.press('Tab');
      const id = await this.page.evaluate(() => document.activeElement?.id || document.activeElement?.dataset?.mode || '');
      if (id && reached.has(id)) break;
      if (id) reached.add(id);
    }
    return reached;
  }

  visibleControls() {
    return this.page.evaluate(() => [...document.querySelectorAll('header button, header select, #panel button, #panel select, #panel input, #canvas')]
      .filter((control) => control.offsetParent !== null && !control.disabled).map(({ id, dataset }) => id || dataset.mode).filter(Boolean));
  }
}
