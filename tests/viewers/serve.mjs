// A static server on the loopback address: pages of the clients, their packages, and the folder of the file to show.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

const HERE = fileURLToPath(new URL('.', import.meta.url));

const TYPES = {
  '.css': 'text/css', '.glb': 'model/gltf-binary', '.gltf': 'model/gltf+json', '.html': 'text/html; charset=utf-8',
  '.jpg': 'image/jpeg', '.js': 'text/javascript', '.json': 'application/json', '.mjs': 'text/javascript',
  '.png': 'image/png', '.svg': 'image/svg+xml', '.wasm': 'application/wasm', '.xml': 'application/xml',
};

/** Serves /pages, /node_modules and, from `folder`, /files. Gives {url, close}; `close` waits for nobody. */
export async function serve(folder) {
  const roots = { files: folder, pages: join(HERE, 'pages'), node_modules: join(HERE, 'node_modules') };
  const server = createServer((request, response) => answer(roots, request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}`,
    close: () => { server.closeAllConnections(); server.close(); },
  };
}

function answer(roots, request, response) {
  const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
  if (path === '/favicon.ico') return response.writeHead(204).end();
  const file = fileOf(roots, path);
  if (file === null) return response.writeHead(404).end();
  response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream', 'cache-control': 'no-store' });
  return createReadStream(file).pipe(response);
}

/** The file of a path, null if there is none below the roots. */
function fileOf(roots, path) {
  const [, name, ...rest] = normalize(path).split(sep);
  if (!Object.hasOwn(roots, name)) return null;
  const file = join(roots[name], ...rest);
  return statSync(file, { throwIfNoEntry: false })?.isFile() ? file : null;
}
