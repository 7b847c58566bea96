// The server under test, as a user starts it.
import { spawn } from 'node:child_process';

/** Milliseconds until the program has said where it listens; a debug build is slow. */
const LONGEST_START = 60_000;

/** Starts `roomwright view` on any free port. Gives {url, stop}. */
export async function startView(program, path) {
  const child = spawn(program, ['view', path, '--no-open', '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  const url = await new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`no address after ${LONGEST_START} ms: ${said}`)), LONGEST_START);
    const listen = (data) => {
      said += data;
      const found = /http:\/\/[^\s]+\//.exec(said);
      if (!found) return;
      clearTimeout(timer);
      resolve(found[0]);
    };
    child.stdout.on('data', listen);
    child.stderr.on('data', listen);
    child.on('error', reject);
    child.on('exit', (code) => reject(new Error(`the program ended with ${code}: ${said}`)));
  });
  return { url, stop: () => stopped(child) };
}

function stopped(child) {
  return new Promise((resolve) => {
    if (child.exitCode !== null || child.signalCode !== null) return resolve();
    child.on('exit', resolve);
    child.kill();
    return undefined;
  });
}
