// Mouse, pen and fingers on the picture.

import { FINGER_REACH } from "./pick.js";
import { pickAt } from "./picture.js";
import { measuring, pressMeasure } from "./toolpick.js";
import { choosePair } from "./tools.js";

/** @import {App, Mode} from "./app.js" */
/** @import {Area} from "./view.js" */

/** Below this many pixels a press is a click. */
const CLICK = 4;

/** @typedef {{x: number, y: number}} Spot */

/** What dragging a pointer does, from press to release. */
class Drag {
  /**
   * @param {Spot} from
   * @param {Mode} mode
   * @param {boolean} isFinger
   */
  constructor(from, mode, isFinger) {
    this.from = from;
    /** A finger is less exact than a mouse. */
    this.how = isFinger ? { reach: FINGER_REACH } : {};
    this.last = from;
    this.mode = mode;
    this.hasMoved = false;
  }
}

/**
 * @param {App} app
 * @param {HTMLCanvasElement} canvas
 * @param {boolean} [isInPage] whether a page around it is scrolled by wheel and fingers, too
 */
export function listenToPointers(app, canvas, isInPage = false) {
  /** @type {Map<number, Spot>} */
  const down = new Map();
  /** @type {Drag | null} */
  let drag = null;
  const spot = (/** @type {MouseEvent} */ event) => {
    const { left, top } = canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, spot(event));
    app.grip?.letGo();
    drag = down.size === 1 ? new Drag(spot(event), modeOf(app, event), event.pointerType === "touch") : null;
    if (drag === null) app.sketch?.cancel();
    else if (drag.mode === "draw") startDrawing(app, drag, event);
    else if (drag.mode === "pull" || drag.mode === "place") startHand(app, drag);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    // A finger that does not press is nowhere.
    app.pointer = before === undefined && event.pointerType !== "touch" ? spot(event) : null;
    if (before === undefined) {
      app.touch();
      return;
    }
    const at = spot(event);
    if (down.size === 2) pinch(app, down, event.pointerId, at);
    down.set(event.pointerId, at);
    if (drag !== null) moveDrag(app, drag, at, event.altKey);
    app.touch();
  });
  const release = (/** @type {PointerEvent} */ event) => {
    down.delete(event.pointerId);
    app.grip?.letGo();
    if (drag?.mode === "draw") endDrawing(app, drag, event, spot(event));
    else if (drag !== null && event.type === "pointerup") endDrag(app, drag, event.button);
    drag = null;
    app.touch();
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => {
    app.pointer = null;
    app.touch();
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => app.mode !== "draw" && app.zoomToExtents());
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (isInPage && !event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const { dx, dy } = fromMiddle(app, spot(event));
      app.view.zoom(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 16 : 1)), dx, dy);
      app.touch();
    },
    { passive: false },
  );
  // A finger that holds a body does not scroll the page.
  canvas.addEventListener("touchstart", (event) => isInPage && app.drag !== null && event.preventDefault(), { passive: false });
}

/**
 * The mode of the left button; the others orbit and pan whatever is chosen.
 * @param {App} app
 * @param {PointerEvent} event
 * @returns {Mode}
 */
function modeOf(app, event) {
  if (event.button === 2) return "orbit";
  if (event.button === 1) return "pan";
  return app.mode;
}

/**
 * @param {App} app
 * @param {Spot} at
 */
function fromMiddle(app, at) {
  const area = areaAt(app, at);
  return { dx: at.x - area.x - 0.5 * area.width, dy: at.y - area.y - 0.5 * area.height };
}

/** @param {App} app @param {Spot} at @returns {Area} of the run there */
function areaAt(app, { x, y }) {
  const holds = (/** @type {Area} */ area) =>
    x >= area.x && y >= area.y && x <= area.x + area.width && y <= area.y + area.height;
  return app.areas().find(holds) ?? app.area;
}

/** Takes hold of the body under the pointer; where there is none, dragging pans. @param {App} app @param {Drag} drag */
function startHand(app, drag) {
  const { x, y } = drag.from;
  const { index, item } = pickAt(app, x, y, { ...drag.how, kind: "body" });
  const isHeld = item?.kind === "body" && app.runViews[index].run.isLive;
  const kind = drag.mode === "place" ? "place" : "pull";
  if (!isHeld || !app.grip?.grab(kind, item.index, app.view.projection(areaAt(app, drag.from)), x, y)) drag.mode = "pan";
}

/** What a press means to who draws; where it means nothing, dragging pans. @param {App} app @param {Drag} drag @param {PointerEvent} event */
function startDrawing(app, drag, event) {
  const how = { ...drag.how, isShift: event.shiftKey, isAlt: event.altKey };
  const { x, y } = drag.from;
  if (app.sketch?.press(app.view.projection(app.area), x, y, how) !== true) drag.mode = "pan";
}

/** @param {App} app @param {Drag} drag @param {PointerEvent} event @param {Spot} at */
function endDrawing(app, drag, event, at) {
  const how = { ...drag.how, isShift: event.shiftKey, isAlt: event.altKey, hasMoved: drag.hasMoved };
  if (event.type === "pointerup") app.sketch?.release(app.view.projection(app.area), at.x, at.y, how);
  else app.sketch?.cancel();
}

/** @param {App} app @param {Drag} drag @param {Spot} at @param {boolean} isAlt */
function moveDrag(app, drag, at, isAlt) {
  const [dx, dy] = [at.x - drag.last.x, at.y - drag.last.y];
  drag.hasMoved ||= Math.hypot(at.x - drag.from.x, at.y - drag.from.y) > CLICK;
  if (!drag.hasMoved) return;
  drag.last = at;
  if (drag.mode === "draw") {
    app.sketch?.held?.move(app.view.projection(app.area), at.x, at.y, { ...drag.how, isAlt });
    return;
  }
  const { dx: fromX, dy: fromY } = fromMiddle(app, drag.from);
  if (drag.mode === "pull" || drag.mode === "place") {
    app.grip?.move(app.view.projection(areaAt(app, drag.from)), at.x, at.y);
    return;
  }
  if (drag.mode === "pan" || drag.mode === "info" || measuring(app) !== null) app.view.pan(dx, dy);
  else if (drag.mode === "orbit") app.view.orbit(dx, dy);
  // As in the manual: upwards enlarges.
  else if (drag.mode === "zoom") app.view.zoom(Math.exp(-0.01 * dy), fromX, fromY);
  else app.window = windowBetween(drag.from, at);
}

/** @param {App} app @param {Drag} drag @param {number} button */
function endDrag(app, drag, button) {
  if (!drag.hasMoved) {
    if (button !== 0) return;
    if (measuring(app) !== null) {
      pressMeasure(app, drag.from.x, drag.from.y, drag.how);
      return;
    }
    const before = app.selected?.kind === "body" ? app.selected.index : null;
    const { index, item } = pickAt(app, drag.from.x, drag.from.y, drag.how);
    if (index !== app.active) app.activate(index);
    app.select(item);
    choosePair(app, before);
    if (item !== null && app.mode === "info") {
      app.hasPanel = true;
      app.tab = "objects";
    }
  } else if (drag.mode === "window" && app.window !== null) {
    if (app.window.width > CLICK && app.window.height > CLICK) app.view.zoomTo(app.window, areaAt(app, drag.from));
    app.window = null;
  }
}

/** @param {Spot} a @param {Spot} b @returns {Area} */
function windowBetween(a, b) {
  return {
    x: Math.min(a.x, b.x),
    y: Math.min(a.y, b.y),
    width: Math.abs(a.x - b.x),
    height: Math.abs(a.y - b.y),
  };
}

/**
 * Two fingers move and enlarge at once.
 * @param {App} app
 * @param {Map<number, Spot>} down
 * @param {number} moving
 * @param {Spot} at
 */
function pinch(app, down, moving, at) {
  const other = [...down].find(([id]) => id !== moving)?.[1];
  const before = down.get(moving);
  if (other === undefined || before === undefined) return;
  const distance = (/** @type {Spot} */ spot) => Math.max(Math.hypot(spot.x - other.x, spot.y - other.y), 1);
  const { dx, dy } = fromMiddle(app, { x: 0.5 * (at.x + other.x), y: 0.5 * (at.y + other.y) });
  app.view.pan(0.5 * (at.x - before.x), 0.5 * (at.y - before.y));
  app.view.zoom(distance(at) / distance(before), dx, dy);
}
