// Opens a tileset in a client, and tells what the console said and which requests went wrong.
const TIME_LIMIT = 300_000;

export const CLIENTS = ['cesium', 'three'];

/**
 * Opens a page of `pages/`. Gives {call, said, picture, close}: `call(name, ...values)` calls a function of the page's client, see
 * pages/page.js. Throws an error if the client does not start.
 */
export async function open(browser, url, client, { size = [640, 360], query = {} } = {}) {
  const [width, height] = size;
  const context = await browser.newContext({ viewport: { width, height } });
  context.setDefaultTimeout(TIME_LIMIT);
  const page = await context.newPage();
  const said = listen(page);
  await page.goto(`${url}/pages/${client}.html?${new URLSearchParams({ source: `${url}/tiles/tileset.json`, ...query })}`);
  await page.waitForFunction(() => window.report);
  const report = await page.evaluate(() => window.report);
  if (!report.is_ready) {
    await context.close();
    throw new Error(`${client}: ${report.error}; ${said.errors.join('; ')}`);
  }
  return {
    version: report.version,
    said,
    call: (name, ...values) => page.evaluate(([name, values]) => window.client[name](...values), [name, values]),
    picture: (path) => page.screenshot({ path, timeout: 0 }),
    close: () => context.close(),
  };
}

/** Errors of the console, uncaught ones, requests that failed or that left the machine. */
function listen(page) {
  const said = { errors: [], warnings: [], outside: [] };
  page.on('console', (message) => {
    if (message.type() === 'error') said.errors.push(message.text().slice(0, 300));
    if (message.type() === 'warning' && !/GL Driver Message|GPU stall|swiftshader/i.test(message.text())) said.warnings.push(message.text().slice(0, 300));
  });
  page.on('pageerror', (error) => said.errors.push(error.message));
  page.on('requestfailed', (request) => {
    if (request.failure()?.errorText !== 'net::ERR_ABORTED') said.errors.push(`${request.url()}: ${request.failure()?.errorText}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) said.errors.push(`${response.url()}: status ${response.status()}`);
  });
  page.on('request', (request) => {
    if (/^https?:/.test(request.url()) && new URL(request.url()).hostname !== '127.0.0.1') said.outside.push(request.url());
  });
  return said;
}
