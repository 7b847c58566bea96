// Chromium without a window, drawing with SwiftShader: the same pictures with and without a graphics card.
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from 'playwright-core';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

const SWITCHES = [
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--hide-scrollbars',
  // No client asks a server; what Chromium itself would ask for is switched off.
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run',
  '--disable-dev-shm-usage',
];

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

/** Chromium refuses its sandbox to root, as whom containers run. */
export function launch(executablePath) {
  const isRoot = process.getuid?.() === 0;
  return chromium.launch({ executablePath, headless: true, args: isRoot ? [...SWITCHES, '--no-sandbox'] : SWITCHES });
}
