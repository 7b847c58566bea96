// A section through the level, as architects draw one: what stands between a low viewer and the place that is looked at is cut off.

/** Rise to run of a view below which the walls in front begin to sink, and at which they are as low as they get. */
const [STEEP, LOW] = [1, 0.55];
/** Metres above the floor that always stay: the wall is still there to see. */
const STUMP = 0.25;

/**
 * The section of a view {position, target} in a level of a height: `height` metres above the floor stay of what lies before the
 * place that is looked at, `normal` on the plan (x, z of the scene) points to the viewer, and `offset` is how far the plane through
 * the place lies along it. Null for views from above.
 */
export function sectionOf({ position, target }, height) {
  const [x, z] = [position[0] - target[0], position[2] - target[2]];
  const run = Math.hypot(x, z);
  const steepness = (position[1] - target[1]) / Math.max(run, 1e-6);
  if (steepness >= STEEP || run < 1e-6) return null;
  const share = Math.min(1, Math.max(0, (steepness - LOW) / (STEEP - LOW)));
  const normal = [x / run, z / run];
  return { height: STUMP + (height - STUMP) * share, normal, offset: normal[0] * target[0] + normal[1] * target[2] };
}

/** Whether a point of the scene is cut off. */
export function isCutOff(section, [x, y, z]) {
  return section !== null && y > section.height && section.normal[0] * x + section.normal[1] * z > section.offset;
}
