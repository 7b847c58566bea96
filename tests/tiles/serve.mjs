// A static host on the loopback address, as tiles are put on one: it compresses models and JSON, and counts what it sends.
import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const HERE = fileURLToPath(new URL('.', import.meta.url));

const TYPES = {
  '.css': 'text/css', '.glb': 'model/gltf-binary', '.html': 'text/html; charset=utf-8', '.jpg': 'image/jpeg',
  '.js': 'text/javascript', '.json': 'application/json', '.mjs': 'text/javascript', '.png': 'image/png',
  '.svg': 'image/svg+xml', '.wasm': 'application/wasm', '.xml': 'application/xml',
};
/** What a host compresses; PNG and JPEG are compressed already. */
const COMPRESSED = new Set(['.glb', '.js', '.json', '.svg', '.xml']);

/**
 * Serves /pages, /node_modules and, from `folder`, /tiles. Gives {url, sent, close}: `sent` lists what was asked for below /tiles,
 * as {path, status, bytes, compressed}.
 */
export async function serve(folder) {
  const roots = {
    tiles: folder, pages: join(HERE, 'pages'), node_modules: fileURLToPath(new URL('../viewers/node_modules', import.meta.url)),
  };
  const sent = [];
  const known = new Map();
  const server = createServer((request, response) => answer(roots, sent, known, request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}`,
    sent,
    close: () => { server.closeAllConnections(); server.close(); },
  };
}

function answer(roots, sent, known, request, response) {
  const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
  if (path === '/favicon.ico') return response.writeHead(204).end();
  const file = fileOf(roots, path);
  const isTile = path.startsWith('/tiles/');
  if (file === null) {
    if (isTile) sent.push({ path: path.slice('/tiles/'.length), status: 404, bytes: 0, compressed: 0 });
    return response.writeHead(404).end();
  }
  const { whole, small } = contentOf(file, known);
  if (isTile) sent.push({ path: path.slice('/tiles/'.length), status: 200, bytes: whole.length, compressed: (small ?? whole).length });
  const takesGzip = /\bgzip\b/.test(request.headers['accept-encoding'] ?? '') && small !== null;
  response.writeHead(200, {
    'content-type': TYPES[extname(file)] ?? 'application/octet-stream',
    ...(takesGzip && { 'content-encoding': 'gzip' }),
    'cache-control': isTile ? 'max-age=3600' : 'no-store',
  });
  return response.end(takesGzip ? small : whole);
}

/** The bytes of a file, plain and compressed, kept: a test asks for a file in several clients. */
function contentOf(file, known) {
  if (!known.has(file)) {
    const whole = readFileSync(file);
    known.set(file, { whole, small: COMPRESSED.has(extname(file)) ? gzipSync(whole) : null });
  }
  return known.get(file);
}

/** The file of a path, null if there is none below the roots. */
function fileOf(roots, path) {
  const [, name, ...rest] = normalize(path).split(sep);
  if (!Object.hasOwn(roots, name)) return null;
  const file = join(roots[name], ...rest);
  return statSync(file, { throwIfNoEntry: false })?.isFile() ? file : null;
}
