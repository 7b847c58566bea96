#!/usr/bin/env node
// Shows a floor in browser clients, each at its default settings: render_in_viewers.mjs FLOOR.glb OUT [options]
//
//   --clients LIST    three,babylon,model_viewer,cesium (default: all)
//   --room ID         a view from inside this room (default: the largest)
//   --eye X,Y,Z --target X,Y,Z    another view from inside, glTF metres
//   --fitted          no view from inside: each client chooses its own
//   --fov DEGREES     vertical angle of the view (default: 60)
//   --size WxH        pixels (default: 800x500)
//   --name NAME       pictures are OUT/NAME-CLIENT.png (default: the file's name)
//   --environment none    three.js without RoomEnvironment, Babylon.js with the light of its documentation's example
//
// Prints one JSON line a client. Exit 0: all clients show the floor. 1: some do not. 2: nothing could start.
import { mkdirSync } from 'node:fs';
import { basename, dirname, extname, join, relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { launch } from './browser.mjs';
import { findChromium } from './find_chromium.mjs';
import { readFloor, viewOf } from './floor.mjs';
import { serve } from './serve.mjs';
import { CLIENTS, show } from './show.mjs';

const OPTIONS = {
  clients: { type: 'string', default: CLIENTS.join() },
  room: { type: 'string' }, eye: { type: 'string' }, target: { type: 'string' }, fitted: { type: 'boolean' },
  fov: { type: 'string', default: '60' }, size: { type: 'string', default: '800x500' },
  name: { type: 'string' }, environment: { type: 'string' },
};

function readOptions() {
  const { values, positionals } = parseArgs({ allowPositionals: true, options: OPTIONS });
  const clients = values.clients.split(',');
  const unknown = clients.filter((client) => !CLIENTS.includes(client));
  if (positionals.length !== 2) throw new Error('usage: render_in_viewers.mjs FLOOR.glb OUT [options], see the head of the file');
  if (unknown.length) throw new Error(`unknown client: ${unknown.join(', ')}; there are ${CLIENTS.join(', ')}`);
  if (!values.eye !== !values.target) throw new Error('--eye and --target belong together');
  return { ...values, file: resolve(positionals[0]), out: positionals[1], clients };
}

/** What the pages are asked for: the address's query but for the file. */
function queryOf(options) {
  const { eye, target, room, fov, environment } = options;
  const view = eye ? { eye, target } : viewOf(readFloor(options.file), room);
  return { fov, ...(options.fitted ? {} : view), ...(environment && { environment }) };
}

async function main() {
  const options = readOptions();
  const query = queryOf(options);
  const chromium = findChromium();
  if (chromium === null) throw new Error('no chromium or google-chrome on the path; ROOMWRIGHT_CHROMIUM names another');
  mkdirSync(options.out, { recursive: true });
  // A floor may refer to what lies beside its building's folder.
  const root = dirname(dirname(options.file));
  const server = await serve(root);
  const browser = await launch(chromium);
  const source = `${server.url}/files/${relative(root, options.file)}`;
  const name = options.name ?? basename(options.file, extname(options.file));
  const size = options.size.split('x').map(Number);
  let status = 0;
  for (const client of options.clients) {
    const picture = join(options.out, `${name}-${client}.png`);
    const report = await show(browser, server.url, client, { query: { source, ...query }, picture, size });
    if (!report.is_loaded || report.errors.length) status = 1;
    console.log(JSON.stringify(report));
  }
  await browser.close();
  server.close();
  return status;
}

try {
  process.exitCode = await main();
} catch (error) {
  console.error(error.message);
  process.exitCode = 2;
}
