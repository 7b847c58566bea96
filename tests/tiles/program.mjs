// The program under test, and what the tests of tiles need besides.
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { findChromium } from '../viewers/find_chromium.mjs';

const TOP = fileURLToPath(new URL('../..', import.meta.url));
const program = process.env.ROOMWRIGHT_PROGRAM;

export const chromium = findChromium();

/** Why nothing can be tested, false if it can. */
export function reasonToSkip() {
  return !program && 'ROOMWRIGHT_PROGRAM names no program'
    || chromium === null && 'no chromium or google-chrome on the path; ROOMWRIGHT_CHROMIUM names another';
}

/** Runs `roomwright tiles` or `roomwright bake` for a plan of the project, with the seed 1. */
export function write(command, plan, out, ...options) {
  execFileSync(program, [command, plan, '--out', out, '--seed', '1', '--quiet', ...options], { cwd: TOP, stdio: 'inherit' });
}
