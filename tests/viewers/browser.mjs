// Chromium without a window, drawing with SwiftShader: the same pictures with and without a graphics card.
import { chromium } from 'playwright-core';

const SWITCHES = [
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--hide-scrollbars',
  // No client asks a server; what Chromium itself would ask for is switched off.
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run',
  '--disable-dev-shm-usage',
];

/** Chromium refuses its sandbox to root, as whom containers run. */
export function launch(executablePath) {
  const isRoot = process.getuid?.() === 0;
  return chromium.launch({ executablePath, headless: true, args: isRoot ? [...SWITCHES, '--no-sandbox'] : SWITCHES });
}
