// Cuts the shell of rooms along a section: two planes, and what lies behind both is not drawn.
import { Plane } from 'three';
import { sectionOf } from '../plan/section.js';

/** Metres: a plane so high cuts nothing. */
const NOWHERE = 1e6;

export class Section {
  constructor(renderer) {
    // Set once for all: another number of planes would compile the materials anew.
    renderer.localClippingEnabled = true;
    this.planes = [new Plane(), new Plane()];
    this.planes[0].normal.set(0, -1, 0);
    this.show(null);
  }

  /** Follows a view; null for a view that is never cut. */
  follow(view, height) {
    this.show(view && sectionOf(view, height));
  }

  show(section) {
    this.current = section;
    this.planes[0].constant = section?.height ?? NOWHERE;
    if (!section) return;
    this.planes[1].normal.set(-section.normal[0], 0, -section.normal[1]);
    this.planes[1].constant = section.offset;
  }

  /** Makes a material one that is cut. */
  cut(material) {
    material.clippingPlanes = this.planes;
    material.clipIntersection = true;
    return material;
  }
}
