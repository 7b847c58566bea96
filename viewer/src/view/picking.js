// What lies below a point of the screen.
import { Raycaster, Vector2 } from 'three';
import { isCutOff } from '../plan/section.js';
import { intoFrame, meetsBox, meetsTriangles } from '../plan/pick.js';

const raycaster = new Raycaster();

/** The ray through a point of the canvas (pixels from its corner): {origin, direction}. */
export function rayThrough(stage, [x, y]) {
  const [width, height] = stage.size;
  stage.camera.updateMatrixWorld();
  raycaster.setFromCamera(new Vector2(x / width * 2 - 1, 1 - y / height * 2), stage.camera);
  return { origin: raycaster.ray.origin.toArray(), direction: raycaster.ray.direction.toArray() };
}

/** The first thing that a ray meets: {room, piece} with `piece` null for walls and floors, or null for nothing. What a section cuts off is not there. */
export function pick({ origin, direction }, rooms, section) {
  let nearest = null;
  for (const { content, handles } of rooms.shown.values()) {
    const boxed = new Set(content.pieces.filter((piece) => meetsPiece(origin, direction, piece)).map(({ id }) => id));
    for (const handle of handles) {
      if (handle.piece ? !boxed.has(handle.piece) : handle.role === 'ceiling' && !rooms.hasCeilings) continue;
      const distance = meetsHandle(origin, direction, handle, rooms.batches, section);
      if (distance === null || nearest && nearest.distance <= distance) continue;
      nearest = { room: content.id, piece: handle.piece, distance };
    }
  }
  return nearest;
}

function meetsPiece(origin, direction, { matrix, size: [width, depth, height] }) {
  // Leaves of plants and the like reach a little beyond the box.
  const slack = 0.05;
  return meetsBox(...intoFrame(origin, direction, matrix),
    [-width / 2 - slack, -slack, -depth / 2 - slack], [width / 2 + slack, height + slack, depth / 2 + slack]) !== null;
}

/** Metres behind a surface that is cut off from which the ray goes on. */
const BEHIND = 0.001;

function meetsHandle(origin, direction, handle, batches, section) {
  const { positions, indices, range, isTwoSided } = batches.trianglesOf(handle);
  for (let gone = 0; ;) {
    const from = along(origin, direction, gone);
    const distance = meetsTriangles(...intoFrame(from, direction, handle.elements), positions, indices, range, isTwoSided);
    if (distance === null) return null;
    if (!handle.isShell || !isCutOff(section, along(from, direction, distance))) return gone + distance;
    gone += distance + BEHIND;
  }
}

const along = (origin, direction, distance) => origin.map((value, axis) => value + direction[axis] * distance);

/** Where a ray meets the horizontal plane at a height, as a point of the plan, or null. */
export function onPlane({ origin, direction }, height) {
  const distance = (height - origin[1]) / direction[1];
  if (!Number.isFinite(distance) || distance <= 0) return null;
  return [origin[0] + direction[0] * distance, -(origin[2] + direction[2] * distance)];
}
