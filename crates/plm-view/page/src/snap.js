// Where a hand goes: onto a pin, onto a line through one, onto the grid. Pure functions.

/** @import {PlacedPort, PortName} from "./pencil.js" */
/** @import {Projection} from "./view.js" */

/**
 * A place and why: a port that stands there, or lines through others.
 * @typedef {{at: number[], onto: PlacedPort | null, along: number[][]}} Snapped
 */

/** Steps of a drawing, m. */
const SKETCH_STEPS = Array.from({ length: 21 }, (_, k) => Number(`${[1, 2, 5][k % 3]}e${Math.floor(k / 3) - 6}`));
/** As near as that, in pixels, a port or a line through one holds the hand. */
export const PIN_REACH = 12;
const LINE_REACH = 5;
/** Ports that are no farther apart on the screen are at one place, in pixels. */
const SAME = 0.5;
/** Directions of lines that are drawn freely, rad. */
const TURN_STEP = Math.PI / 12;

/** The step of a picture: no finer than a pixel. @param {number} scale pixels for a metre @param {number} [pixels] */
export function sketchStep(scale, pixels = 1) {
  return SKETCH_STEPS.find((step) => step * scale >= pixels) ?? 10;
}

/** The name of a port as people write it. @param {PortName} port */
export const portKey = ({ owner, port }) => `${owner}.${port}`;

/**
 * The port that is nearest to a place of the screen; of several there one of a body, because parts join bodies.
 * @param {PlacedPort[]} places
 * @param {Projection} projection
 * @param {number} px
 * @param {number} py
 * @param {{reach?: number | undefined, except?: Set<string> | undefined}} [how]
 */
export function nearestPort(places, projection, px, py, { reach = PIN_REACH, except = new Set() } = {}) {
  let [best, least] = [/** @type {PlacedPort | null} */ (null), reach];
  for (const place of places) {
    if (except.has(portKey(place))) continue;
    const [x, y] = projection.point(place.at[0], place.at[1], 0);
    const away = Math.hypot(x - px, y - py);
    const isBody = best?.owner === "ground" && place.owner !== "ground" && away < Math.min(least + SAME, reach);
    if (isBody || away < least - (place.owner === "ground" ? SAME : 0)) [best, least] = [place, away];
  }
  return best;
}

/**
 * The body of which a line between two ports is nearest to a place of the screen; null where none is near.
 * @param {PlacedPort[]} places
 * @param {Projection} projection
 * @param {number} px
 * @param {number} py
 * @param {Set<string>} [except] bodies that are none of them
 */
export function nearestBody(places, projection, px, py, except = new Set()) {
  let [best, least] = [/** @type {string | null} */ (null), PIN_REACH];
  const own = places.filter(({ owner }) => owner !== "ground" && !except.has(owner));
  const seen = own.map(({ owner, at }) => ({ owner, at: projection.point(at[0], at[1], 0) }));
  seen.forEach((one, k) => {
    for (const other of seen.slice(k)) {
      if (other.owner !== one.owner) continue;
      const [dx, dy] = [other.at[0] - one.at[0], other.at[1] - one.at[1]];
      const [tx, ty] = [px - one.at[0], py - one.at[1]];
      const square = dx * dx + dy * dy;
      const share = square > 0 ? Math.min(1, Math.max(0, (tx * dx + ty * dy) / square)) : 0;
      const away = Math.hypot(tx - share * dx, ty - share * dy);
      if (away < least) [best, least] = [one.owner, away];
    }
  });
  return best;
}

/**
 * Where a hand at a place of the screen goes; null where the plane is seen from its edge.
 * @param {PlacedPort[]} places
 * @param {Projection} projection
 * @param {number} px
 * @param {number} py
 * @param {{reach?: number, except?: Set<string>, moving?: Set<string>, from?: number[] | null}} [how] `except`: ports onto which nothing
 *   can go; `moving`: those that go with the hand; `from`: the point from which a line is drawn
 * @returns {Snapped | null}
 */
export function snapped(places, projection, px, py, { reach, except, moving, from = null } = {}) {
  const onto = nearestPort(places, projection, px, py, { reach, except });
  if (onto !== null) return { at: onto.at, onto, along: [] };
  const target = projection.onPlane(px, py, 0);
  if (target === null) return null;
  const step = sketchStep(projection.scale);
  const at = target.map((part) => toStep(part, step));
  /** @type {number[][]} */
  const along = [];
  const lines = places.filter((place) => moving?.has(portKey(place)) !== true).map((place) => place.at);
  if (from !== null) lines.unshift(from);
  for (const axis of [0, 1]) {
    let least = LINE_REACH / projection.scale;
    for (const line of lines) {
      const away = Math.abs(line[axis] - target[axis]);
      if (away >= least) continue;
      least = away;
      at[axis] = line[axis];
      along[axis] = line;
    }
  }
  return { at, onto: null, along: along.filter((line) => line !== undefined) };
}

/** The point on the nearest direction of a line from a point, in steps of 15 degrees. @param {number[]} from @param {number[]} to */
export function alongStep([x, y], to) {
  const [dx, dy] = [to[0] - x, to[1] - y];
  const length = Math.hypot(dx, dy);
  const turn = Math.round(Math.atan2(dy, dx) / TURN_STEP) * TURN_STEP;
  return [x + length * Math.cos(turn), y + length * Math.sin(turn)];
}

/** A multiple of a step, without the error of the multiplication. @param {number} value @param {number} step */
function toStep(value, step) {
  return Number((Math.round(value / step) * step).toPrecision(12)) + 0;
}

/** All ports that parts hold at one place with a port, itself among them. @param {import("./pencil.js").SketchPart[]} parts @param {PortName} port */
export function pinOf(parts, port) {
  const pin = new Set([portKey(port)]);
  const pairs = parts.filter((part) => part.pin).map(({ ports }) => ports.map(portKey));
  for (let before = 0; before < pin.size; ) {
    before = pin.size;
    for (const pair of pairs) if (pair.some((name) => pin.has(name))) for (const name of pair) pin.add(name);
  }
  return pin;
}

/**
 * Ports with which a pin cannot be joined: its own, and those of pins that a body of it is on already.
 * @param {PlacedPort[]} places
 * @param {import("./pencil.js").SketchPart[]} parts
 * @param {Set<string>} pin
 */
export function besidePin(places, parts, pin) {
  const ownerOf = (/** @type {string} */ name) => name.slice(0, name.lastIndexOf("."));
  const owners = new Set([...pin].map(ownerOf));
  const keys = places.map(portKey);
  return new Set([...pin, ...keys.filter((_, at) => [...pinOf(parts, places[at])].some((name) => owners.has(ownerOf(name))))]);
}

/** A length and the direction of a line, for reading. @param {number[]} from @param {number[]} to */
export function lineText(from, to) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  return `${millimetres(Math.hypot(dx, dy))} mm, ${Number(((Math.atan2(dy, dx) * 180) / Math.PI).toFixed(1))}°`;
}

/** A length in millimetres, for reading. @param {number} length m */
export function millimetres(length) {
  return String(Number((1000 * length).toPrecision(5)) + 0);
}
