// The page names all its modules at its head: a browser fetches them at once, instead of finding one after the other.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const read = (path) => readFileSync(fileURLToPath(new URL(`../../viewer/${path}`, import.meta.url)), 'utf8');
const page = read('index.html');
const { imports } = JSON.parse(/<script type="importmap">(.*?)<\/script>/.exec(page)[1]);

/** The file of a module that another one names. */
function resolved(name, from) {
  if (name.startsWith('.')) return posix.join(posix.dirname(from), name);
  const [known] = Object.keys(imports).filter((key) => name === key || key.endsWith('/') && name.startsWith(key));
  return (imports[known] + name.slice(known.length)).replace('./page/', '');
}

function modulesFrom(path, found = new Set()) {
  if (found.has(path)) return found;
  found.add(path);
  const named = read(path).matchAll(/^(?:import|export)\b[^;'"]*?(?:from\s+)?['"]([^'"]+)['"];/gm);
  for (const [, name] of named) modulesFrom(resolved(name, path), found);
  return found;
}

test('all modules are preloaded, and nothing else', () => {
  const named = [...page.matchAll(/<link rel="modulepreload" href="page\/([^"]+)">/g)].map(([, path]) => path);
  assert.deepEqual(named.sort(), [...modulesFrom('src/main.js')].sort());
});
