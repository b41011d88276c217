// Strokes: what the tools of drawing make of one place or of two.

import { pickAt } from "./picture.js";
import { alongStep, nearestBody, nearestPort, pinOf, sketchStep, snapped } from "./snap.js";

/** @import {Drawn, PlacedPort} from "./pencil.js" */
/** @import {Press, Sketch} from "./sketch.js" */
/** @import {Snapped} from "./snap.js" */
/** @import {Projection} from "./view.js" */

/**
 * What a second place ends: its first one, and the body that it is about.
 * @typedef {{at: number[], port: PlacedPort | null, isGround: boolean, body: string | null}} Begun
 */

const portNameOf = (/** @type {PlacedPort} */ { owner, port }) => ({ owner, port });

/** The first of two places. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y @param {Press} how */
export function beginStroke(sketch, projection, x, y, how) {
  const places = sketch.places();
  const port = nearestPort(places, projection, x, y, how);
  const place = snapped(places, projection, x, y, how);
  if (sketch.tool === "point") {
    const body = bodyAt(sketch, projection, x, y);
    if (body === null) sketch.tell("a bar is wanted here");
    else if (place !== null) sketch.from = { at: place.at, port: null, isGround: false, body };
  } else if (port !== null) sketch.from = { at: port.at, port, isGround: false, body: null };
  else if (sketch.tool !== "bar") sketch.tell("a pin is wanted here: the end of a bar");
  else if (place !== null) sketch.from = { at: place.at, port: null, isGround: how.isShift === true, body: null };
  sketch.changed();
}

/** Where the second of two places is. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y @param {Press} [how] @returns {Snapped | null} */
export function strokeEnd(sketch, projection, x, y, how = {}) {
  const { from } = sketch;
  const place = snapped(sketch.places(), projection, x, y, { ...how, from: from?.at ?? null });
  if (place === null || from === null || sketch.tool !== "slide" || place.onto !== null) return place;
  return { ...place, at: alongStep(from.at, place.at) };
}

/** The bar along which what slides is guided, if the second place is on one. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y */
export function guideAt(sketch, projection, x, y) {
  const { from, tool } = sketch;
  if (tool !== "slide" || from === null || from.port === null) return null;
  const own = [...pinOf(sketch.sheet.parts, from.port)].map((name) => name.slice(0, name.lastIndexOf(".")));
  // Where the pin itself stands there is no direction, and no bar that is meant.
  const [px, py] = projection.point(from.at[0], from.at[1], 0);
  return Math.hypot(x - px, y - py) < 12 ? null : nearestBody(sketch.places(), projection, x, y, new Set(own));
}

/** Ends what was begun at a place. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y @param {Press} how */
export function endStroke(sketch, projection, x, y, how) {
  const { from, tool } = sketch;
  const place = strokeEnd(sketch, projection, x, y, how);
  if (from === null || place === null) return;
  const { at, onto } = place;
  const grid = sketchStep(projection.scale);
  const second = onto === null ? { at, ground: how.isShift === true } : portNameOf(onto);
  /** @type {Drawn | null} */
  let drawn = null;
  if (tool === "bar") {
    const first = from.port === null ? { at: from.at, ground: from.isGround } : portNameOf(from.port);
    drawn = sketch.make("draw a bar", { kind: "bar", ends: [first, second], grid });
  } else if (tool === "point") drawn = sketch.make(`draw a pin of ${from.body}`, { kind: "port", body: from.body, end: second, grid });
  else if (from.port !== null && tool === "slide") {
    const body = guideAt(sketch, projection, x, y);
    const gesture = body === null ? { kind: "slide", toward: at } : { kind: "groove", body };
    drawn = sketch.make("draw a slider", { ...gesture, port: portNameOf(from.port), grid });
  } else if (from.port !== null && onto !== null) {
    drawn = sketch.make(`draw a ${tool}`, { kind: "join", tool, ports: [portNameOf(from.port), portNameOf(onto)], grid });
  } else {
    sketch.tell("a second pin is wanted here");
    return;
  }
  if (drawn !== null) sketch.from = null;
  sketch.changed();
}

/** A pin becomes one of the ground; where none is, the ground gets a place. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y @param {Press} how */
export function groundAt(sketch, projection, x, y, how) {
  const port = nearestPort(sketch.places(), projection, x, y, how);
  const place = snapped(sketch.places(), projection, x, y, how);
  if (port === null && place !== null) sketch.make("a place of the ground", { kind: "ground", at: place.at, grid: sketchStep(projection.scale) });
  else if (port !== null) sketch.make("pin to the ground", { kind: "ground", port: portNameOf(port), grid: sketchStep(projection.scale) });
}

/** The bar at a place turns: that on the ground where two meet. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y @param {Press} how */
export function motorAt(sketch, projection, x, y, how) {
  const port = nearestPort(sketch.places(), projection, x, y, how);
  const pin = port === null ? [] : [...pinOf(sketch.sheet.parts, port)].map((name) => name.split(".")[0]);
  const body = pin.find((owner) => owner !== "ground") ?? bodyAt(sketch, projection, x, y);
  if (body === null) sketch.tell("a bar is wanted here, or its pin");
  else sketch.make(`motor of ${body}`, { kind: "motor", body });
}

/** The body at a place: what is seen there, else the nearest line between two pins. @param {Sketch} sketch @param {Projection} projection @param {number} x @param {number} y */
function bodyAt(sketch, projection, x, y) {
  const near = nearestBody(sketch.places(), projection, x, y);
  if (near !== null || !sketch.isCurrent) return near;
  const picked = pickAt(sketch.app, x, y, { kind: "body" }).item;
  return picked === null ? null : (sketch.app.run?.mechanism.bodies[picked.index].name ?? null);
}
