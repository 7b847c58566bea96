// Markers of findings over the picture, each at its piece or in the middle of its room.
import { Vector3 } from 'three';
import { toScene } from '../plan/frame.js';
import { middleOf } from '../plan/polygon.js';
import { byId, element } from './elements.js';
import { findingText, findingsOf } from './findings.js';
import { badge } from './panel.js';

/** Metres: markers farther from a walker, or behind walls, would only be in the way. */
const WALK_REACH = 8;

const point = new Vector3();

export class Markers {
  constructor(app, panel) {
    Object.assign(this, { app, panel });
    this.markers = [];
  }

  /** Makes the markers anew, one for each piece or room with findings. */
  update() {
    const groups = new Map();
    for (const finding of findingsOf(this.app.rooms.contents())) {
      const key = `${finding.room}/${finding.objects[0] ?? ''}`;
      groups.set(key, [...groups.get(key) ?? [], finding]);
    }
    const key = JSON.stringify([...groups.values()]);
    const isSame = key === this.key;
    this.key = key;
    if (!isSame) this.make([...groups.values()]);
    for (const marker of this.markers) marker.at = this.placeOf(marker.finding);
  }

  make(groups) {
    this.markers = groups.map((findings) => {
      const [finding] = findings;
      const lines = findings.map((each) => findingText(each, this.app.site.meanings));
      const button = element('button', { type: 'button', title: lines.join('\n'), children: [badge(finding)] });
      button.setAttribute('aria-label', `${finding.room}: ${lines.join('. ')}`);
      button.addEventListener('click', () => this.panel.choose(finding.room, finding.objects[0] ?? null));
      return { finding, button };
    });
    byId('markers').replaceChildren(...this.markers.map(({ button }) => button));
  }

  placeOf({ room, objects }) {
    const piece = objects.length > 0 ? this.app.rooms.pieceOf(room, objects[0]) : null;
    if (piece) return toScene(piece.at, piece.bottom + piece.size[2] + 0.2);
    const outline = this.app.map.rooms.find(({ id }) => id === room);
    return outline ? toScene(middleOf(outline), 1.2) : null;
  }

  /** Puts the markers where their places are on the screen. */
  place() {
    const { stage } = this.app;
    const [width, height] = stage.size;
    for (const { at, finding, button } of this.markers) {
      button.hidden = at === null || this.isOutOfReach(finding, at);
      if (button.hidden) continue;
      point.fromArray(at).project(stage.camera);
      button.hidden = point.z > 1 || Math.abs(point.x) > 1 || Math.abs(point.y) > 1;
      button.style.transform = `translate(${(point.x + 1) / 2 * width}px, ${(1 - point.y) / 2 * height}px)`;
    }
  }

  isOutOfReach({ room }, [x, y, z]) {
    if (this.app.mode !== 'walk') return false;
    const { position, room: own } = this.app.views.walk;
    return own?.id !== room || Math.hypot(x - position[0], -z - position[1]) > WALK_REACH;
  }
}
