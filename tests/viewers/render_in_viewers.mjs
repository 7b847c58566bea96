#!/usr/bin/env node
// Shows a floor in browser clients, each at its default settings: render_in_viewers.mjs FLOOR.glb OUT [options]
//
//   --clients LIST    three,babylon,babylon_viewer,model_viewer,cesium (default: all)
//   --eye X,Y,Z --target X,Y,Z    a view from inside a room, glTF metres; without them each client chooses its own
//   --fov DEGREES     vertical angle of that view (default: 60)
//   --size WxH        pixels (default: 800x500)
//   --name NAME       pictures are OUT/NAME-CLIENT.png (default: the file's name)
//   --root DIR        folder that is served, for files that refer to others (default: the file's folder's parent)
//
// Prints one JSON line a client. Exit 0: all clients show the floor. 1: some do not. 2: nothing could start.
import { mkdirSync, statSync } from 'node:fs';
import { basename, dirname, extname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { findChromium, launch } from './browser.mjs';
import { measure } from './picture.mjs';
import { serve } from './serve.mjs';

export const CLIENTS = ['three', 'babylon', 'babylon_viewer', 'model_viewer', 'cesium'];
const TIME_LIMIT = 180_000;
const [MOST_MESSAGES, LONGEST_MESSAGE] = [8, 300];

/** Opens a page in a client; gives its report with what the console said and what the picture is like. */
export async function show(browser, url, client, view) {
  const [width, height] = view.size;
  const context = await browser.newContext({ viewport: { width, height } });
  const page = await context.newPage();
  const said = listen(page);
  try {
    await page.goto(`${url}/pages/${client}.html?${new URLSearchParams(view.query)}`);
    await page.waitForFunction(() => window.report, null, { timeout: TIME_LIMIT });
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

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      clients: { type: 'string', default: CLIENTS.join() }, eye: { type: 'string' }, target: { type: 'string' },
      fov: { type: 'string', default: '60' }, size: { type: 'string', default: '800x500' },
      name: { type: 'string' }, root: { type: 'string' }, environment: { type: 'string' },
    },
  });
  const [file, out] = positionals;
  const clients = values.clients.split(',');
  const unknown = clients.filter((client) => !CLIENTS.includes(client));
  if (positionals.length !== 2 || unknown.length || !values.eye !== !values.target) throw new Error(`usage: render_in_viewers.mjs FLOOR.glb OUT [options] ${unknown}`);
  if (!statSync(file, { throwIfNoEntry: false })?.isFile()) throw new Error(`no such file: ${file}`);
  return { ...values, file: resolve(file), out, clients };
}

async function main() {
  const options = readOptions();
  const chromium = findChromium();
  if (chromium === null) throw new Error('no Chromium: install it or name one by ROOMWRIGHT_CHROMIUM');
  mkdirSync(options.out, { recursive: true });
  const root = resolve(options.root ?? dirname(dirname(options.file)));
  const server = await serve(root);
  const browser = await launch(chromium);
  const source = `${server.url}/files/${relative(root, options.file)}`;
  const { eye, target, fov, environment } = options;
  const query = { source, fov, ...(eye && { eye, target }), ...(environment && { environment }) };
  const name = options.name ?? basename(options.file, extname(options.file));
  let status = 0;
  for (const client of options.clients) {
    const picture = join(options.out, `${name}-${client}.png`);
    const report = await show(browser, server.url, client, { query, picture, size: options.size.split('x').map(Number) });
    if (!report.is_loaded || report.errors.length) status = 1;
    console.log(JSON.stringify(report));
  }
  await browser.close();
  server.close();
  return status;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    process.exitCode = await main();
  } catch (error) {
    console.error(error.message);
    process.exitCode = 2;
  }
}
