// Follow camera: keeps a live mechanism in view, as long as nobody has chosen another view.

import { outlineAt } from "./solid.js";
import { View } from "./view.js";

/** @import {App} from "./app.js" */

/** So often, ms, it is looked at. */
const LOOK_EVERY = 250;
/** After the last of several starts, ms, it is looked ahead: a slider that is moved begins anew again and again. */
const REST = 300;

export class FollowCamera {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** The view as it was chosen here. @type {View | null} */
    this.chosen = null;
    this.lookedAt = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.waiting = undefined;
  }

  /** At a start the view is chosen anew, but not while a body is placed. */
  begin() {
    if (this.chosen === null || !this.isOwn() || this.app.mode === "place") return;
    this.choose();
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.app.live?.lookAhead(), REST);
  }

  isOwn() {
    return JSON.stringify(this.app.view) === JSON.stringify(this.chosen);
  }

  /** Shows everything, and goes on to do so. */
  choose() {
    // Who draws keeps the sheet where it is.
    if (this.app.mode === "draw") return;
    this.app.zoomToExtents();
    this.chosen = new View();
    this.chosen.copy(this.app.view);
  }

  update() {
    const now = performance.now();
    if (this.chosen === null || now - this.lookedAt < LOOK_EVERY) return;
    this.lookedAt = now;
    if (!this.isOwn()) this.chosen = null;
    else if (this.app.drag === null && this.isOutside()) this.choose();
  }

  /** Whether something of the last moment is cut off. */
  isOutside() {
    const { app } = this;
    const { scene, area } = app;
    // What cannot be assembled says nothing of what is to be seen.
    if (scene === null || !scene.run.isLive || scene.run.rows === 0 || scene.run.fault !== null) return false;
    const projection = app.view.projection(area);
    const places = scene.at(scene.run.end);
    return scene.pieces.some((piece) => {
      const outline = outlineAt(piece, places);
      const points = outline === null ? [] : projection.line(outline, piece.z1);
      return points.some((at, index) => {
        const [low, length] = index % 2 === 0 ? [area.x, area.width] : [area.y, area.height];
        return at < low || at > low + length;
      });
    });
  }
}
