// The page's answers about the plan: walls, walking, doors, picking, edits.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { carried, entryOf, movedMatrix } from '../../viewer/src/plan/edit.js';
import { findFree, isFree, isObstacle, move, obstaclesOf, openestHeading, WALKER_RADIUS } from '../../viewer/src/plan/collision.js';
import { closingTurn, isNear, slidesOf, swung } from '../../viewer/src/plan/doors.js';
import { viewDuring, viewOfLevel } from '../../viewer/src/plan/camera_path.js';
import { distanceToWalls, isInRoom, middleOf, roomAt } from '../../viewer/src/plan/polygon.js';
import { intoFrame, meetsBox, meetsTriangles } from '../../viewer/src/plan/pick.js';
import { wallPanels } from '../../viewer/src/plan/shell.js';
import { facesOf, groundOf, isWay, placeInsideDoor } from '../../viewer/src/plan/walls.js';
import { isCutOff, sectionOf } from '../../viewer/src/plan/section.js';
import { stepOf, velocityOf } from '../../viewer/src/plan/steps.js';
import { multiplied, placed } from '../../viewer/src/model/matrix.js';

/** Two rooms of 4 by 3 metres beside each other, a wall of 0.1 between them, a door of 0.9 in its middle. */
const WEST = { id: 'west', outline: [[0, 0], [4, 0], [4, 3], [0, 3]] };
const EAST = { id: 'east', outline: [[4.1, 0], [8.1, 0], [8.1, 3], [4.1, 3]] };
const DOOR = { id: 'd', kind: 'door', center: [4.05, 1.5], along: [0, 1], width: 0.9, bottom: 0, top: 2, rooms: ['west', 'east'], leaves: [] };
const LEVEL = { rooms: [WEST, EAST], openings: [DOOR] };
const wallsOf = (level) => groundOf(level).walls;

const near = (actual, expected, tolerance = 1e-6) => actual.forEach((value, axis) => assert.ok(
  Math.abs(value - expected[axis]) < tolerance, `${actual} is not ${expected}`));

test('a walker goes through a doorway and not through the wall beside it', () => {
  const ground = obstaclesOf(wallsOf(LEVEL), [], []);
  near(move([2, 1.5], [4, 0], ground), [6, 1.5]);
  near(move([2, 0.5], [4, 0], ground), [4 - WALKER_RADIUS, 0.5]);
});

test('a walker who pushes against the side of a doorway slides out of it, never into the wall', () => {
  const ground = obstaclesOf(wallsOf(LEVEL), [], []);
  const place = move([4.05, 1.5], [0, 1], ground);
  assert.ok(isFree(place, ground) && (isInRoom(place, WEST) || isInRoom(place, EAST)));
});

test('windows and hatches are no ways', () => {
  assert.ok(isWay(DOOR));
  assert.ok(!isWay({ ...DOOR, kind: 'window' }));
  assert.ok(!isWay({ ...DOOR, bottom: 0.9 }));
});

/** A door in the outer wall of the west room, 0.3 thick. */
const FRONT_DOOR = { ...DOOR, id: 'front', center: [-0.15, 1.5], rooms: ['west'] };

test('by a door to the open air, a walker gets onto the apron, not off it and not through the outer wall', () => {
  const ground = obstaclesOf(wallsOf({ rooms: [WEST, EAST], openings: [DOOR, FRONT_DOOR] }), [], []);
  const outside = move([1, 1.5], [-2.5, 0], ground);
  near(outside, [-1.5, 1.5]);
  near(move(outside, [-9, 0], ground), [-0.3 - 3 + WALKER_RADIUS, 1.5]);
  const aside = move(outside, [0, -9], ground);
  assert.ok(aside[1] > -1, `at ${aside}`);
  near([move(aside, [9, 0], ground)[0]], [-0.3 - WALKER_RADIUS]);
});

test('between wings, an apron is smaller; without space for it, and above the ground, a door to the open air is no way', () => {
  const wing = (x, y) => ({ id: 'wing', outline: [[x, y], [x + 3, y], [x + 3, y + 3], [x, y + 3]] });
  const aprons = (rooms, elevation = 0) => groundOf({ rooms, openings: [FRONT_DOOR], elevation }).aprons;
  const depth = ([{ corners: [[from], [to]] }]) => from - to;
  near([depth(aprons([WEST]))], [3]);
  assert.ok(depth(aprons([WEST, wing(-5.4, 0)])) < 3);
  assert.deepEqual(aprons([WEST, wing(-3.6, 0)]), []);
  assert.deepEqual(aprons([WEST], 2.9), []);
});

test('a column stops a walker', () => {
  const column = [[2, 1], [2.4, 1], [2.4, 2], [2, 2]];
  near(move([1, 1.5], [3, 0], obstaclesOf(wallsOf(LEVEL), [column], [])), [2 - WALKER_RADIUS, 1.5]);
});

test('the plain walls of a room leave out its openings', () => {
  const window = { ...DOOR, id: 'w', kind: 'window', center: [2, -0.1], along: [1, 0], width: 2, bottom: 0.9, top: 2, rooms: ['west'] };
  const faces = facesOf({ rooms: [WEST], openings: [window] });
  const panels = wallPanels(faces[0], 2.5);
  assert.deepEqual(panels.map(({ from, to, bottom, top }) => [from[0], to[0], bottom, top]),
    [[0, 1, 0, 2.5], [3, 4, 0, 2.5], [1, 3, 0, 0.9], [1, 3, 2, 2.5]]);
});

test('who comes into a room stands inside its door', () => {
  near(placeInsideDoor(EAST, [DOOR]), [4.8, 1.5]);
  near(placeInsideDoor(WEST, [DOOR]), [3.3, 1.5]);
  assert.equal(placeInsideDoor(WEST, [{ ...DOOR, kind: 'window' }]), null);
});

test('a turned box of furniture pushes a walker out, and a long step does not jump over it', () => {
  const box = { center: [2, 1.5], half: [0.5, 0.2], angle: Math.PI / 2 };
  const ground = obstaclesOf(wallsOf(LEVEL), [], [box]);
  near(move([1, 1.5], [2, 0], ground), [2 - 0.2 - WALKER_RADIUS, 1.5]);
});

test('rugs and lamps below the ceiling are not in the way', () => {
  assert.ok(!isObstacle({ size: [2, 3, 0.012], bottom: 0 }));
  assert.ok(!isObstacle({ size: [0.4, 0.4, 0.3], bottom: 2.2 }));
  assert.ok(isObstacle({ size: [0.6, 0.4, 0.7], bottom: 1.4 }));
});

test('a walker who enters a room stands where nothing stands', () => {
  const ground = obstaclesOf(wallsOf(LEVEL), [], [{ center: [2, 1.5], half: [0.6, 0.6], angle: 0.4 }]);
  const place = findFree(WEST, [2, 1.5], ground);
  assert.ok(isFree(place, ground) && isInRoom(place, WEST));
});

test('somebody who enters looks along the longest free way', () => {
  near([Math.cos(openestHeading([1, 1.2], obstaclesOf(wallsOf(LEVEL), [], [])))], [1]);
});

test('the middle of an L-shaped room lies in it, and a hole is not in its room', () => {
  const room = { outline: [[0, 0], [6, 0], [6, 1], [1, 1], [1, 6], [0, 6]], holes: [] };
  assert.ok(isInRoom(middleOf(room), room) && distanceToWalls(middleOf(room), room) > 0.3);
  const pierced = { outline: WEST.outline, holes: [[[1, 1], [2, 1], [2, 2], [1, 2]]] };
  assert.ok(!isInRoom([1.5, 1.5], pierced));
  assert.equal(roomAt([WEST, EAST], [5, 1]).id, 'east');
});

test('a leaf turns from open to shut the short way, about its own hinge', () => {
  const leaves = [{ hinge: [4.3, 9], closed: [5.3, 9], open: [4.3, 8] }];
  near([closingTurn([4.3, 9], leaves)], [Math.PI / 2]);
  assert.equal(closingTurn([1, 1], leaves), 0);
});

test('leaves of a sliding door leave the whole doorway free', () => {
  near(slidesOf([{ from: -1.3, to: 0 }, { from: 0, to: 1.3 }]), [-1.3, 1.3]);
  near(slidesOf([{ from: -0.5, to: 0.5 }]), [-1]);
});

test('a door opens for who is near, in time or at once', () => {
  assert.ok(isNear([0, 1], [0, 0]) && !isNear([0, 2], [0, 0]) && !isNear(null, [0, 0]));
  assert.ok(swung(0, true, 0.1) > 0 && swung(0, true, 0.1) < 1);
  assert.equal(swung(0, true, 0.01, true), 1);
  assert.equal(swung(0.1, false, 1), 0);
});

test('rays meet boxes and the fronts of triangles', () => {
  assert.equal(meetsBox([0, 0, 5], [0, 0, -1], [-1, -1, -1], [1, 1, 1]), 4);
  assert.equal(meetsBox([3, 0, 5], [0, 0, -1], [-1, -1, -1], [1, 1, 1]), null);
  const [positions, indices] = [[-1, -1, 0, 1, -1, 0, 0, 1, 0], [0, 1, 2]];
  assert.equal(meetsTriangles([0, 0, 2], [0, 0, -1], positions, indices, { start: 0, count: 3 }), 2);
  assert.equal(meetsTriangles([0, 0, -2], [0, 0, 1], positions, indices, { start: 0, count: 3 }), null);
  assert.equal(meetsTriangles([0, 0, -2], [0, 0, 1], positions, indices, { start: 0, count: 3 }, true), 2);
  const [origin, direction] = intoFrame([1, 0, 0], [0, 0, -1], placed([1, 0, 2], Math.PI / 2));
  near(origin, [2, 0, 0]);
  near(direction, [1, 0, 0]);
});

test('walking is as fast sideways and aslant as ahead', () => {
  near(velocityOf({ forward: 1, right: 0, isRunning: false }, Math.PI / 2), [0, 1.5]);
  near(velocityOf({ forward: 0, right: 1, isRunning: false }, Math.PI / 2), [1.5, 0]);
  near([Math.hypot(...velocityOf({ forward: 1, right: 1, isRunning: false }, 0.3))], [1.5]);
});

test('arrow keys move a piece by 5 cm, with Shift by 1 cm, as one sees it', () => {
  near(stepOf('ArrowUp', false, Math.PI / 2), [0, 0.05]);
  near(stepOf('ArrowUp', true, 0.2), [0.01, 0]);
  near(stepOf('ArrowRight', false, Math.PI), [0, 0.05]);
  assert.equal(stepOf('a', false, 0), null);
});

/** A table at (2, 1) with a lamp on it and a chair before it. */
function tableAndChair() {
  const piece = (id, parent, holder, matrix) => ({ id, parent, holder, matrix, at: [matrix[12], -matrix[14]], angle: 0, bottom: matrix[13] });
  const matrix = placed([2, 0, -1], 0);
  return [
    piece('table.1', 'floor', null, matrix),
    piece('lamp.1', 'table.1', 'table.1', multiplied(matrix, placed([0.3, 0.7, 0.1], 0))),
    piece('chair.1', 'table.1', null, multiplied(matrix, placed([0, 0, 0.6], 0))),
  ];
}

test('a moved and turned piece takes along what it carries, and nothing else', () => {
  const pieces = tableAndChair();
  const moved = carried(pieces[0], movedMatrix(pieces[0], [1, 0], Math.PI / 2), pieces);
  assert.deepEqual(moved.map(({ id }) => id), ['table.1', 'lamp.1']);
  near(moved[0].at, [3, 1]);
  near(moved[1].at, [3.1, 1.3]);
  assert.deepEqual(entryOf(moved[0], pieces), { at: [3, 1], turn: 90 });
});

test('the entry of a piece whose parent is an object is in the frame of that one, whether it stands on it or beside it', () => {
  const pieces = tableAndChair();
  const [lamp] = carried(pieces[1], movedMatrix(pieces[1], [0, 0.05], 0), pieces);
  assert.deepEqual(entryOf(lamp, pieces), { at: [0.3, -0.05], turn: 0 });
  assert.deepEqual(entryOf(pieces[2], pieces), { at: [0, -0.6], turn: 0 });
});

test('a flight begins where one is and ends where one goes', () => {
  const [from, to] = [{ position: [0, 1, 0], target: [0, 0, 0] }, { position: [4, 1, 0], target: [4, 0, 0] }];
  near(viewDuring(from, to, 0).position, from.position);
  assert.ok(viewDuring(from, to, 10).hasArrived);
  assert.ok(viewDuring(from, to, 0, true).hasArrived);
});

test('the view of a level holds all its corners', () => {
  const bounds = [[0, 0], [60, 12]];
  const fov = Math.PI / 4;
  const { position, target } = viewOfLevel(bounds, 3, fov, 0.5);
  const length = Math.hypot(...position.map((value, axis) => value - target[axis]));
  const forward = position.map((value, axis) => (target[axis] - value) / length);
  for (const corner of [[0, 0, 0], [60, 0, 0], [0, 3, -12], [60, 3, -12]]) {
    const offset = corner.map((value, axis) => value - position[axis]);
    const depth = offset.reduce((sum, value, axis) => sum + value * forward[axis], 0);
    const aside = Math.hypot(...offset.map((value, axis) => value - forward[axis] * depth));
    // Half the diagonal of the picture.
    assert.ok(aside / depth < Math.tan(fov / 2) * Math.hypot(1, 0.5));
  }
});

test('for a low view, walls before the place that is looked at are cut off, and those behind it stay', () => {
  const section = sectionOf({ position: [0, 3, 10], target: [0, 0, 0] }, 3);
  assert.ok(isCutOff(section, [0, 2, 4]));
  assert.ok(!isCutOff(section, [0, 2, -4]));
  assert.ok(!isCutOff(section, [0, 0.1, 4]));
  const higher = sectionOf({ position: [0, 8, 10], target: [0, 0, 0] }, 3);
  assert.ok(higher.height > section.height && higher.height < 3);
  assert.equal(sectionOf({ position: [0, 10, 2], target: [0, 0, 0] }, 3), null);
  assert.ok(!isCutOff(null, [0, 2, 4]));
});
