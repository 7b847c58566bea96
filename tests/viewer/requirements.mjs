// What the tests in a browser need; without it they are skipped, and say why.
import { findChromium } from '../viewers/find_chromium.mjs';

export const chromium = findChromium();
export const program = process.env.ROOMWRIGHT_PROGRAM;
export const driver = await import('playwright-core').catch(() => null);

/** Why no browser can be driven, or false. */
export const skipBrowser = chromium === null && 'no chromium or google-chrome on the path; ROOMWRIGHT_CHROMIUM names another'
  || driver === null && 'tests/viewer/node_modules/ has no playwright-core: source scripts/set_up.sh && set_up_viewer';

export const skip = !program && 'ROOMWRIGHT_PROGRAM names no program' || skipBrowser;
