// A room in its plainest form, from the map alone: its walls as upright rectangles with holes for openings.
import { remaining } from './walls.js';
import { add, scale, subtract } from './frame.js';

/** Rectangles {from, to, bottom, top} of the walls that a face {segment, gaps} shows, seen from its room, up to a height. */
export function wallPanels({ segment, gaps }, height) {
  const beside = remaining(segment, gaps).map(([from, to]) => ({ from, to, bottom: 0, top: height }));
  const around = gaps.flatMap(({ opening: { bottom, top }, from, to }) => {
    const [start, end] = [from, to].map((metres) => along(segment, metres));
    return [{ from: start, to: end, bottom: 0, top: bottom }, { from: start, to: end, bottom: top, top: height }];
  });
  return [...beside, ...around].filter(({ bottom, top }) => top > bottom);
}

function along([a, b], metres) {
  const vector = subtract(b, a);
  return add(a, scale(vector, metres / Math.hypot(...vector)));
}
