// What a picture is like: how bright, and how much of it is as good as black or white.

/** Below and above these values of 0 to 1, as displayed, nothing can be told apart. */
const BLACK = 0.02;
const WHITE = 0.98;

/** Measures a PNG in a page, which can decode it: luminance as displayed, 0 to 1, and shares of all pixels. */
export async function measure(page, png) {
  const bins = await page.evaluate(histogram, png.toString('base64'));
  return summary(bins);
}

/** Counts of the luminances 0 to 255. Runs in the browser. */
async function histogram(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, image.width, image.height);
  const bins = new Array(256).fill(0);
  for (let at = 0; at < data.length; at += 4) {
    bins[Math.round(0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2])] += 1;
  }
  return bins;
}

/** Mean, three percentiles and the shares of black and white pixels of a histogram of 256 bins. */
export function summary(bins) {
  const total = bins.reduce((sum, count) => sum + count, 0);
  const share = (is) => bins.reduce((sum, count, value) => sum + (is(value / 255) ? count : 0), 0) / total;
  const percentile = (part) => {
    let seen = 0;
    return bins.findIndex((count) => (seen += count) >= part * total) / 255;
  };
  const mean = bins.reduce((sum, count, value) => sum + count * value, 0) / total / 255;
  const figures = {
    mean, dark: percentile(0.05), middle: percentile(0.5), bright: percentile(0.95),
    black: share((value) => value < BLACK), white: share((value) => value > WHITE),
  };
  return Object.fromEntries(Object.entries(figures).map(([name, value]) => [name, Number(value.toFixed(3))]));
}
