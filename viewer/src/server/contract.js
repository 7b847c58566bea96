// What the answers of the server must hold, checked once, so that later code never asks.

/** The answer of api/site. */
export function readSite(site) {
  if (!Array.isArray(site?.buildings)) throw new Error('the server sends no list of buildings: it is of another version than this page');
  const buildings = site.buildings.filter(({ levels }) => levels?.length > 0).map((building) => ({ position: [0, 0], turn: 0, ...building }));
  if (buildings.length === 0) throw new Error('there is no building with a level to show');
  return { styles: [], style: null, seed: 1, edits: null, is_editable: false, meanings: {}, ...site, buildings };
}

/** The answer of api/level. */
export function readLevel(level) {
  const rooms = (level.rooms ?? []).map((room) => ({ holes: [], obstacles: [], above: null, below: null, ...room }));
  const openings = (level.openings ?? []).map((opening) => ({ leaves: [], bottom: 0, rooms: [], ...opening }));
  return { ...level, rooms, openings };
}

/** A message of api/events: {kind: 'changed', rooms} or {kind: 'faults', faults}; null for one that this page does not know. */
export function readEvent(text) {
  let event;
  try {
    event = JSON.parse(text);
  } catch {
    return null;
  }
  if (event?.kind === 'changed') return { ...event, rooms: event.rooms ?? null };
  if (event?.kind === 'faults') return { kind: 'faults', faults: (event.faults ?? []).map(String) };
  return null;
}

/** Milliseconds until the server is asked again what is worth drawing. */
export function pauseBeforeLook({ waiting, isMoving }) {
  if (waiting > 0) return 50;
  return isMoving ? 150 : 1000;
}

/** What is to do after an answer of api/look: rooms of this level to fetch, first ones first, and rooms to drop. */
export function planOf(answer, { building, level }, versions) {
  const here = answer.rooms.filter((room) => room.building === building && room.level === level);
  const wanted = new Map(here.map(({ room, version }) => [room, version]));
  return {
    fetch: [...wanted].filter(([room, version]) => versions.get(room) !== version).map(([room, version]) => ({ room, version })),
    drop: [...versions.keys()].filter((room) => !wanted.has(room)),
    wanted,
  };
}

/** Where somebody looks, kept in the address of the page: #building/level/mode. */
export function readPlace(hash) {
  const [building, level, mode] = hash.replace(/^#/, '').split('/').map((part) => decodeURIComponent(part));
  return { building: building || null, level: level || null, mode: ['orbit', 'plan', 'walk'].includes(mode) ? mode : 'orbit' };
}

export const writePlace = ({ building, level, mode }) => `#${[building, level, mode].map(encodeURIComponent).join('/')}`;
