// Puts the parts of the page together, and says in words what is missing if it cannot.
import { App } from './app.js';
import { Editor } from './editor.js';
import { byId } from './page/elements.js';
import { Input } from './page/input.js';
import { Lift } from './page/lift.js';
import { Markers } from './page/markers.js';
import { say } from './page/messages.js';
import { Panel } from './page/panel.js';
import { Toolbar } from './page/toolbar.js';
import { Stage } from './view/stage.js';

/** Shows what a server offers in the elements of `index.html`. Gives the app, or null where the browser cannot draw. */
export function openViewer(server) {
  const stage = openStage();
  if (!stage) return null;
  const isReduced = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  const app = new App(stage, server, isReduced);
  const editor = new Editor(app, server);
  const toolbar = new Toolbar(app, editor);
  const panel = new Panel(app, editor);
  const markers = new Markers(app, panel);
  const lift = new Lift(app);
  new Input(app, editor, { panel, toolbar, lift });
  connect(app, { toolbar, panel, markers, lift });
  stage.lost = () => say('graphics', 'The graphics card gave up the picture. Reload this page; if that happens again, close other pages that draw.');
  stage.resize();
  window.roomwright = {
    stats: () => statsOf(app),
    pieces: (room) => (app.rooms.shown.get(room)?.content.pieces ?? []).map(({ id, at, angle }) => ({ id, at, angle })),
    stairs: (direction) => app.map.rooms.find((room) => room[direction])?.id ?? null,
    shown: () => [...app.rooms.shown.keys()],
    viewpoint: () => ({ ...app.place, ...app.viewpoint() }),
    obstacles: () => app.walkable().obstacles,
    openness: (opening) => app.rooms.openings.opennessOf(opening),
  };
  app.start().then(() => stage.run((seconds) => {
    const isChanged = app.update(seconds);
    byId('status').textContent = statusOf(app);
    return isChanged;
  })).catch((error) => say('start', `Nothing can be shown: ${error.message}`));
  return app;
}

function openStage() {
  try {
    return new Stage(byId('canvas'));
  } catch {
    say('start', 'This browser shows no WebGL 2, which the view needs. Switch on hardware acceleration in its settings, or try another browser.');
    return null;
  }
}

/** Who is told of which change. */
function connect(app, { toolbar, panel, markers, lift }) {
  // Many rooms change in one frame; the panel is written once.
  let isDue = false;
  const refresh = () => {
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      panel.update();
      markers.update();
      markers.place();
    });
  };
  const lifted = () => lift.update().catch((error) => say('level', `Nobody knows where the lift goes: ${error.message}`));
  app.hooks = {
    siteChanged: () => toolbar.updateSettings(),
    levelOpened: () => { toolbar.update(); refresh(); lifted(); },
    modeChanged: () => { toolbar.update(); refresh(); lifted(); },
    // The panel follows a walker from room to room.
    walkedRoomChanged: () => { toolbar.updateStairs(); refresh(); lifted(); },
    roomsChanged: refresh,
    selectionChanged: refresh,
  };
  app.stage.drawn = () => {
    markers.place();
    noteFirstFrames(app);
  };
}

/** Milliseconds from navigation to the first pictures with walls and with a furnished room. */
const firstFrames = { walls: null, room: null };

function noteFirstFrames({ shell, rooms }) {
  const parts = { walls: shell.parts.length > 0, room: rooms.size > 0 };
  const due = Object.keys(parts).filter((part) => parts[part] && firstFrames[part] === null);
  // The next frame is due when this one has been handed to the screen.
  if (due.length > 0) requestAnimationFrame(() => due.forEach((part) => { firstFrames[part] ??= Math.round(performance.now()); }));
}

function statusOf({ feed }) {
  return feed.waiting > 0 ? `${feed.waiting} ${feed.waiting === 1 ? 'room' : 'rooms'} on the way` : '';
}

/** The state of the page in figures, for tests and for whoever measures. */
function statsOf(app) {
  const { render, memory } = app.stage.renderer.info;
  const { walk } = app.views;
  return {
    rooms: app.rooms.size, calls: render.calls, triangles: render.triangles, frame_ms: app.stage.frameTime, mode: app.mode, light: app.light.mode,
    building: app.building?.id, level: app.level?.id, room: app.mode === 'walk' ? walk.room?.id ?? null : app.selected?.room ?? null,
    position: app.mode === 'walk' ? walk.position : null, heading: walk.heading, selected: app.selected, place: app.piece()?.at ?? null,
    first_frames_ms: firstFrames, is_drawn: !app.stage.isDirty && !app.stage.isPending, waiting: app.feed.waiting, textures: memory.textures, geometries: memory.geometries,
  };
}
