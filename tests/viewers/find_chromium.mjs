#!/usr/bin/env node
// Names the Chromium that the tests of the viewers use: find_chromium.mjs. Exit 1: there is none.
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

/** The program that ROOMWRIGHT_CHROMIUM names, else a known one of the path, else null. */
export function findChromium(environment = process.env) {
  if (environment.ROOMWRIGHT_CHROMIUM) return environment.ROOMWRIGHT_CHROMIUM;
  const folders = (environment.PATH ?? '').split(delimiter).filter(Boolean);
  return NAMES.flatMap((name) => folders.map((folder) => join(folder, name))).find(isProgram) ?? null;
}

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const found = findChromium();
  if (found === null) {
    console.error('no chromium or google-chrome on the path; ROOMWRIGHT_CHROMIUM names another');
    process.exitCode = 1;
  } else console.log(found);
}
