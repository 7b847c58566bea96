// Shows a floor in one client and tells how it went.
import { measure } from './picture.mjs';

export const CLIENTS = ['three', 'babylon', 'model_viewer', 'cesium'];

/** Milliseconds. Large floors take a client seconds a frame where nothing but the processor draws. */
const TIME_LIMIT = 120_000;
const [MOST_MESSAGES, LONGEST_MESSAGE] = [8, 300];

/**
 * Opens a client's page in a browser. `view`: {size: [width, height], query: see pages/page.js, picture: file or undefined}.
 * Gives the page's report with what the console said (`errors`, `warnings`), requests that left the machine (`outside`) and what the
 * picture is like. Faults of the client are in the report.
 */
export async function show(browser, url, client, view) {
  const [width, height] = view.size;
  const context = await browser.newContext({ viewport: { width, height } });
  context.setDefaultTimeout(TIME_LIMIT);
  const page = await context.newPage();
  const said = listen(page);
  try {
    await page.goto(`${url}/pages/${client}.html?${new URLSearchParams(view.query)}`);
    await page.waitForFunction(() => window.report);
    const report = await page.evaluate(() => window.report);
    const picture = await page.screenshot({ path: view.picture });
    return { client, ...rounded(report), ...said, picture: view.picture, ...await measure(page, picture) };
  } catch (error) {
    return { client, is_loaded: false, error: error.message, ...said };
  } finally {
    await context.close();
  }
}

/** The first messages of a kind, each once and shortened: a client may say the same for each material, shader included. */
class Messages extends Array {
  add(text) {
    const short = text.slice(0, LONGEST_MESSAGE);
    if (this.length < MOST_MESSAGES && !this.includes(short)) this.push(short);
  }
}

/** Errors and warnings of the console, uncaught errors, and requests that failed or left the machine. */
function listen(page) {
  const said = { errors: new Messages(), warnings: new Messages(), outside: new Messages() };
  page.on('console', (message) => {
    if (message.type() === 'error') said.errors.add(message.text());
    if (message.type() === 'warning' && !isDriverNote(message.text())) said.warnings.add(message.text());
  });
  page.on('pageerror', (error) => said.errors.add(error.message));
  page.on('requestfailed', (request) => isAborted(request) || said.errors.add(`${request.url()}: ${request.failure()?.errorText}`));
  page.on('request', (request) => {
    if (/^https?:/.test(request.url()) && new URL(request.url()).hostname !== '127.0.0.1') said.outside.add(request.url());
  });
  return said;
}

/** A client may give up a request itself. */
function isAborted(request) {
  return request.failure()?.errorText === 'net::ERR_ABORTED';
}

/** Chromium's notes on how fast the graphics driver is say nothing about the file. */
function isDriverNote(text) {
  return /GL Driver Message|GPU stall|swiftshader/i.test(text);
}

function rounded(report) {
  const shorter = (value) => (typeof value === 'number' ? Number(value.toFixed(1)) : value);
  return Object.fromEntries(Object.entries(report).map(([key, value]) => [key, shorter(value)]));
}
