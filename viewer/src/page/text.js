// Words for what the files and the server name by ids.

/** "wide_tv_stand" as people write it. */
export function words(id) {
  const text = String(id).replaceAll('_', ' ');
  return text.charAt(0).toUpperCase() + text.slice(1);
}

export const metres = (value, digits = 2) => `${value.toFixed(digits)} m`;

export function sizeText([width, depth, height]) {
  return `${width.toFixed(2)} × ${depth.toFixed(2)} × ${height.toFixed(2)} m`;
}

const SIDES = {
  front: 'at the front of', back: 'at the back of', left: 'at the left of', right: 'at the right of', above: 'on', below: 'below',
};

/** Where a piece stands: "at the front of dining_table.1", "at wall.2", "on the floor". */
export function standsText({ parent, side }) {
  if (parent === 'floor') return 'on the floor';
  if (parent === 'ceiling') return 'on the ceiling';
  if (/^(wall|column|window|door)[.:]/.test(parent)) return `at ${parent}`;
  return `${SIDES[side] ?? 'at'} ${parent}`;
}
