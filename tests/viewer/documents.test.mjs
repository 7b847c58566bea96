// How the page reads files and answers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { extract } from '../../viewer/src/model/extract.js';
import { readGlb, writeGlb } from '../../viewer/src/model/glb.js';
import { matrixOf, multiplied, inverseOf, placed } from '../../viewer/src/model/matrix.js';
import { readTree, textureKeys } from '../../viewer/src/model/tree.js';
import { findingsOf, findingText, severityOf } from '../../viewer/src/page/findings.js';
import { missingOf, reasonOf } from '../../viewer/src/page/explanation.js';
import { standsText, words } from '../../viewer/src/page/text.js';
import { pauseBeforeLook, planOf, readEvent, readPlace, readSite, writePlace } from '../../viewer/src/server/contract.js';
import { Levels, stopBeyond } from '../../viewer/src/server/levels.js';
import { Server, address } from '../../viewer/src/server/server.js';
import { editText, removedOf } from '../../viewer/src/edits.js';

/** A level with a room, a table with a lamp on it, and a door. The table lies in a shared file. */
function level() {
  const primitive = (position) => ({ attributes: { POSITION: position, TANGENT: 0 }, indices: 2, material: 0 });
  const piece = (kind, parent, size) => ({ kind: 'furniture', class: kind, id: `${kind}.1`, parent, side: 'above', size });
  return {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: [
      { name: 'house/ground', extras: { kind: 'level' }, children: [1, 5] },
      { name: 'room:study', extras: { kind: 'room', room: 'study', findings: [] }, children: [2, 7] },
      { name: 'table.1@study', mesh: 0, translation: [2, 0, -1], children: [3], extras: piece('table', 'floor', [1, 1, 0.7]) },
      { name: 'lamp.1@study', mesh: 0, translation: [0, 0.7, 0], children: [4], extras: piece('lamp', 'table.1', [0.2, 0.2, 0.4]) },
      { name: 'light.lamp.1@study', translation: [0, 0.4, 0], extras: { kind: 'light', lumens: 800, kelvin: 2700 } },
      { name: 'door:d', translation: [4, 0, -1], children: [6],
        extras: { kind: 'opening', opening: 'door', closure: 'door', id: 'd', rooms: ['study', 'hall'], leaves: [] } },
      { name: 'leaf@door:d', mesh: 1, translation: [-0.5, 0, 0], extras: { kind: 'part', part: 'leaf' } },
      { name: 'floor@study', mesh: 1, extras: { kind: 'part', part: 'floor' } },
    ],
    meshes: [{ primitives: [primitive(0)] }, { primitives: [primitive(1)] }],
    materials: [{ name: 'oak', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }], images: [{ bufferView: 1, mimeType: 'image/png' }],
    accessors: [
      { bufferView: 2, componentType: 5126, type: 'VEC3', count: 3, min: [0, 0, 0], max: [1, 2, 0] },
      { bufferView: 0, componentType: 5126, type: 'VEC3', count: 3, min: [0, 0, 0], max: [1, 2, 0] },
      { bufferView: 2, byteOffset: 36, componentType: 5121, type: 'SCALAR', count: 3 },
    ],
    bufferViews: [{ buffer: 0, byteLength: 36 }, { buffer: 0, byteOffset: 36, byteLength: 4 }, { buffer: 1, byteLength: 40 }],
    buffers: [{ byteLength: 40 }, { byteLength: 40, uri: 'shared-geometry/table.1.abc.bin' }],
  };
}

const document = () => ({ json: level(), binary: new Uint8Array(40) });

test('a file is read as it was written', () => {
  const { json, binary } = readGlb(writeGlb({ json: { asset: { version: '2.0' }, name: 'Straße' }, binary: new Uint8Array([1, 2, 3]) }));
  assert.equal(json.name, 'Straße');
  assert.deepEqual([...binary.subarray(0, 3)], [1, 2, 3]);
});

test('files that are none, or cut off, are refused in words', () => {
  assert.throws(() => readGlb(new TextEncoder().encode('<html>not found</html>').buffer), /no \.glb file/);
  assert.throws(() => readGlb(writeGlb(document()).slice(0, 200)), /cut off/);
});

test('a level is taken apart into rooms, pieces, lamps and openings', () => {
  const { rooms: [room], openings: [door] } = readTree(document(), 'here');
  assert.deepEqual(room.pieces.map(({ id, holder, at, bottom }) => ({ id, holder, at, bottom })), [
    { id: 'table.1', holder: null, at: [2, 1], bottom: 0 }, { id: 'lamp.1', holder: 'table.1', at: [2, 1], bottom: 0.7 },
  ]);
  assert.deepEqual(room.lamps, [{ position: [2, 1.1, -1], lumens: 800, kelvin: 2700 }]);
  assert.deepEqual(room.primitives.map(({ role, piece }) => [role, piece]), [['furniture', 'table.1'], ['furniture', 'lamp.1'], ['floor', null]]);
  assert.deepEqual([door.center, door.leaves[0].hinge, door.leaves[0].extent], [[4, 1], [3.5, 1], { from: 0, to: 1 }]);
});

test('furniture in shared files has one key in all documents, everything else one for each document', () => {
  const [here, there] = ['here', 'there'].map((key) => readTree(document(), key).rooms[0].primitives);
  assert.equal(here[0].key, there[1].key);
  assert.notEqual(here[2].key, there[2].key);
  assert.equal(here[2].material, there[2].material);
});

test('images inside documents are told by their bytes', () => {
  const other = document();
  other.binary[37] = 9;
  assert.notDeepEqual(textureKeys(document()), textureKeys(other));
});

test('only what is unknown is extracted, without tangents, and without images where the material is known', async () => {
  const { json } = readGlb(await extract(document(), [{ source: [1, 0], isPlain: true }], async (path) => path));
  assert.equal(json.nodes.length, 1);
  const [primitive] = json.meshes[json.nodes[0].mesh].primitives;
  assert.deepEqual(Object.keys(primitive.attributes), ['POSITION']);
  assert.deepEqual(json.materials[primitive.material], { name: 'known' });
});

test('files beside a document are located where they are needed', async () => {
  const located = [];
  const locate = async (path) => { located.push(path); return `blob:${path}`; };
  const { json } = readGlb(await extract(document(), [{ source: [0, 0], isPlain: true }], locate));
  assert.deepEqual(located, ['shared-geometry/table.1.abc.bin']);
  assert.equal(json.buffers[1].uri, 'blob:shared-geometry/table.1.abc.bin');
});

test('matrices turn about Y as glTF says, and back', () => {
  const matrix = placed([1, 2, 3], 0.7);
  const same = matrixOf({ translation: [1, 2, 3], rotation: [0, Math.sin(0.35), 0, Math.cos(0.35)] });
  matrix.forEach((value, index) => assert.ok(Math.abs(value - same[index]) < 1e-9));
  multiplied(inverseOf(matrix), matrix).forEach((value, index) => assert.ok(Math.abs(value - (index % 5 === 0 ? 1 : 0)) < 1e-9));
});

test('answers of the server are completed, and a foreign one is refused', () => {
  const site = readSite({ kind: 'plan', buildings: [{ id: 'house', levels: [{ id: 'ground' }] }, { id: 'empty', levels: [] }] });
  assert.deepEqual(site.buildings.map(({ id, position, turn }) => [id, position, turn]), [['house', [0, 0], 0]]);
  assert.equal(site.is_editable, false);
  assert.throws(() => readSite({}), /another version/);
  assert.throws(() => readSite({ buildings: [] }), /no building/);
});

test('events that are unknown or broken are ignored', () => {
  assert.deepEqual(readEvent('{"kind":"changed","revision":2}'), { kind: 'changed', revision: 2, rooms: null });
  assert.deepEqual(readEvent('{"kind":"faults","faults":["a.yaml:1: bad"]}').faults, ['a.yaml:1: bad']);
  assert.equal(readEvent('{"kind":"later"}'), null);
  assert.equal(readEvent('{'), null);
});

test('an answer says what to fetch, newest versions only, and what to drop', () => {
  const room = (id, version, at = 'ground') => ({ building: 'house', level: at, room: id, version, is_visible: true });
  const answer = { rooms: [room('hall', 'b'), room('study', 'a'), room('attic', 'a', 'upper')], waiting: 0 };
  const plan = planOf(answer, { building: 'house', level: 'ground' }, new Map([['hall', 'a'], ['study', 'a'], ['wc', 'a']]));
  assert.deepEqual([plan.fetch, plan.drop], [[{ room: 'hall', version: 'b' }], ['wc']]);
});

test('the server is asked soon while rooms are on their way, often in motion, else seldom', () => {
  assert.deepEqual([{ waiting: 2 }, { waiting: 0, isMoving: true }, { waiting: 0, isMoving: false }].map(pauseBeforeLook), [50, 150, 1000]);
});

test('addresses and places keep unusual ids', () => {
  assert.equal(address('api/room', { room: 'a b&c' }), 'api/room?room=a+b%26c');
  const place = { building: 'a/b', level: 'été', mode: 'walk' };
  assert.deepEqual(readPlace(writePlace(place)), place);
  assert.deepEqual(readPlace(''), { building: null, level: null, mode: 'orbit' });
});

test('findings are sorted by severity and told apart by letters', () => {
  const rooms = [{ id: 'study', extras: { findings: [
    { code: 'crowded_half', severity: 'minor', objects: [], measured: 0.9, threshold: 0.85 },
    { code: 'collision', severity: 'failed', objects: ['desk.1'] }] } }, { id: 'hall', extras: {} }];
  const findings = findingsOf(rooms);
  assert.deepEqual(findings.map(({ code }) => code), ['collision', 'crowded_half']);
  assert.notEqual(severityOf(findings[0]).letter, severityOf(findings[1]).letter);
  assert.equal(findingText(findings[1], { crowded_half: 'Nearly all of it in one `half`.' }),
    'Crowded half: nearly all of it in one half. Measured 0.90, threshold 0.85');
  assert.equal(findingText(findings[0], {}), 'Collision (desk.1)');
});

test('a reason says which wishes are met and what was refused', () => {
  const explanation = { objects: [{ id: 'desk.1',
    wishes: [{ about: 'away from', target: 'window', is_met: false, decided_by: 'window:w1', distance: 1.2, weight: 3, points: 0 }],
    search: { places: 9, refused: [{ reason: 'collision', places: 4, obstacles: [{ name: 'bed.1', places: 4 }] }] } }],
  missing: [{ class: 'floor_lamp', reason: 'no place', required: false }] };
  const lines = reasonOf(explanation, 'desk.1').flatMap((section) => section.lines);
  assert.deepEqual(lines, [
    'Not met: away from window (window:w1), 1.20 m; 0.0 of 3.0 points', '9 places tried, 4 refused', '4 × collision: bed.1 4',
  ]);
  assert.deepEqual(reasonOf(explanation, 'bed.1'), []);
  assert.deepEqual(missingOf(explanation), ['Floor lamp: no place']);
});

test('places of pieces are said in words', () => {
  assert.equal(standsText({ parent: 'floor', side: 'above' }), 'on the floor');
  assert.equal(standsText({ parent: 'desk.1', side: 'above' }), 'on desk.1');
  assert.equal(standsText({ parent: 'wall.2', side: 'front' }), 'at wall.2');
  assert.equal(words('wide_tv_stand'), 'Wide tv stand');
});

test('a lift is followed from level to level, also where its room has another id or a level has no stop', async () => {
  const room = (id, above, below) => ({ id, outline: [], above: above?.[1] ?? null, above_level: above?.[0] ?? null, below: below?.[1] ?? null, below_level: below?.[0] ?? null });
  const maps = {
    cellar: [room('lift', ['second', 'lift-b'], null)], first: [room('hall', null, null)],
    second: [room('lift-b', ['third', 'lift'], ['cellar', 'lift'])], third: [room('lift', null, ['second', 'lift-b'])],
  };
  const asked = [];
  const levels = new Levels({ level: async ({ level }) => { asked.push(level); return { rooms: maps[level], openings: [] }; } });
  const stops = await levels.stopsOf('tower', { level: 'second', room: 'lift-b' });
  assert.deepEqual(stops, [{ level: 'cellar', room: 'lift' }, { level: 'second', room: 'lift-b' }, { level: 'third', room: 'lift' }]);
  assert.equal(asked.length, new Set(asked).size);
  assert.equal(stopBeyond(maps.first[0], 'above'), null);
});

test('edits are said in words, and removed pieces are listed', () => {
  assert.equal(editText({ lock: true, at: [1, 2], turn: 90 }), 'locked, moved');
  assert.equal(editText({ turn: 90 }), 'turned');
  assert.equal(editText(null), null);
  assert.deepEqual(removedOf({ 'chair.1': { remove: true }, 'desk.1': { at: [1, 2] } }), ['chair.1']);
});

test('a refusal is said in the words of the program', async () => {
  const bytes = (text) => new TextEncoder().encode(text).buffer;
  const server = (status, text) => new Server({ ask: async () => ({ status, bytes: bytes(text) }) });
  assert.deepEqual(await server(200, '{"buildings":[]}').site(), { buildings: [] });
  await assert.rejects(server(404, '{"error":"there is no room attic"}').room({}), { message: 'there is no room attic', status: 404 });
  await assert.rejects(server(500, '').edit({}), { message: 'the server answers 500' });
});
