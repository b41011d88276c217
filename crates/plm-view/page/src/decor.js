// What stands around the mechanism: axes in the corner, a scale, names, marks on what is selected, the fault.

import { drawArrow } from "./arrows.js";
import { niceNear } from "./numbers.js";
import { circleOutline } from "./outline.js";
import { framePose } from "./solid.js";
import { quantityText } from "./text.js";

/** @import {Drag} from "./app.js" */
/** @import {Palette} from "./palette.js" */
/** @import {Pen} from "./pen.js" */
/** @import {Scene} from "./scene.js" */
/** @import {Item, Places} from "./solid.js" */
/** @import {Projection} from "./view.js" */

/**
 * The absolute axes, turned as the view is.
 * @param {Pen} pen
 * @param {Projection} projection
 * @param {Palette} palette
 */
export function drawAxes(pen, projection, palette) {
  const { area, right, up, toViewer } = projection;
  // On a phone the corner is small.
  const share = area.width < 500 ? 0.65 : 1;
  const [x, y, length] = [area.x + 46 * share, area.y + area.height - 46 * share, 26 * share];
  // From the farthest; axes that are equally far keep their order in spite of rounding.
  const nearness = toViewer.map((share) => Math.round(1e6 * share));
  const order = [0, 1, 2].sort((a, b) => nearness[a] - nearness[b]);
  for (const axis of order) {
    const [dx, dy] = [right[axis], -up[axis]];
    if (Math.hypot(dx, dy) < 0.05) {
      pen.polygon(circleOutline(x, y, 3.5), { fill: palette.faint });
      pen.text(x - 13, y + 9, "xyz"[axis], { colour: palette.ink, size: 12, align: "middle", halo: palette.background });
      continue;
    }
    drawArrow(pen, [x, y], [x + length * dx, y + length * dy], palette.faint);
    const [tx, ty] = [x + (length + 10) * dx, y + (length + 10) * dy];
    pen.text(tx, ty, "xyz"[axis], { colour: palette.ink, size: 12, align: "middle", halo: palette.background });
  }
}

/**
 * How long a length is on the screen.
 * @param {Pen} pen
 * @param {Projection} projection
 * @param {Palette} palette
 */
export function drawScaleBar(pen, projection, palette) {
  const { area, scale } = projection;
  const metres = niceNear(80 / scale);
  const length = metres * scale;
  const [right, y] = [area.x + area.width - 16, area.y + area.height - 16];
  pen.line([right - length, y - 4, right - length, y, right, y, right, y - 4], { stroke: palette.faint, width: 1.2 });
  const [value, unit] = metres >= 1000 ? [metres / 1000, "km"] : metres >= 1 ? [metres, "m"] : [metres * 1000, "mm"];
  pen.text(right - 0.5 * length, y - 10, quantityText(value, unit), { colour: palette.faint, size: 11, align: "middle", halo: palette.background });
}

/**
 * Centre of gravity, axes and ports of a body that is selected.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {Item} item
 * @param {Places} places
 * @param {Projection} projection
 * @param {Palette} palette
 */
export function drawSelection(pen, scene, item, places, projection, palette) {
  if (item.kind === "port") {
    const [x, y] = framePose(scene.mechanism, { argument: "", body: null, port: item.index }, places);
    const [px, py] = projection.point(x, y, scene.mechanism.ground[item.index].depth);
    pen.polygon(circleOutline(px, py, 7), { stroke: palette.select, width: 2 });
    drawName(pen, px, py, scene.mechanism.ground[item.index].name, palette);
    return;
  }
  if (item.kind !== "body") return;
  const body = scene.mechanism.bodies[item.index];
  const z = scene.slabOf({ argument: "", body: item.index, port: null })[1];
  const [x, y, angle] = framePose(scene.mechanism, { argument: "", body: item.index, port: null }, places);
  if (!Number.isFinite(x + y + angle)) return;
  const reach = 4 * scene.radius;
  const from = projection.point(x, y, z);
  for (const turn of [0, Math.PI / 2]) {
    const to = projection.point(x + reach * Math.cos(angle + turn), y + reach * Math.sin(angle + turn), z);
    drawArrow(pen, from, to, palette.select);
  }
  drawName(pen, from[0], from[1], "G", palette);
  body.ports.forEach((port, index) => {
    const [u, v] = framePose(scene.mechanism, { argument: "", body: item.index, port: index }, places);
    const [px, py] = projection.point(u, v, z);
    pen.polygon(circleOutline(px, py, 3), { fill: palette.select });
    if (Math.hypot(px - from[0], py - from[1]) > 12) drawName(pen, px, py, port.name, palette);
  });
}

/**
 * @param {Pen} pen
 * @param {number} x
 * @param {number} y
 * @param {string} name
 * @param {Palette} palette
 */
function drawName(pen, x, y, name, palette) {
  const width = 7 * name.length + 6;
  const [left, top] = [x + 8, y - 20];
  const box = [left, top, left + width, top, left + width, top + 16, left, top + 16];
  pen.polygon(box, { fill: palette.background, opacity: 0.85 });
  pen.text(left + 3, top + 8, name, { colour: palette.ink, size: 12 });
}

/**
 * A name beside the mouse, inside of the picture.
 * @param {Pen} pen
 * @param {number} x
 * @param {number} y
 * @param {string} text
 * @param {import("./view.js").Area} area
 * @param {Palette} palette
 */
export function drawLabel(pen, x, y, text, area, palette) {
  const width = 7.5 * text.length + 16;
  const left = Math.max(area.x, Math.min(x + 14, area.x + area.width - width - 4));
  const top = Math.max(area.y + 4, y - 34);
  pen.polygon([left, top, left + width, top, left + width, top + 24, left, top + 24], { fill: palette.background, stroke: palette.faint });
  pen.text(left + 0.5 * width, top + 12, text, { colour: palette.ink, size: 13, align: "middle" });
}

/**
 * The line from the point that is held to where it is to go.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {Drag} drag
 * @param {Places} places
 * @param {Projection} projection
 * @param {Palette} palette
 */
export function drawDrag(pen, scene, { kind, body, point: [u, v], target, reach }, places, projection, palette) {
  const [x, y, angle] = places.poses.subarray(3 * body, 3 * body + 3);
  const z = scene.levels.bodies[body];
  const [px, py] = [x + Math.cos(angle) * u - Math.sin(angle) * v, y + Math.sin(angle) * u + Math.cos(angle) * v];
  const from = projection.point(px, py, z);
  const to = reach === null ? projection.point(target[0], target[1], z) : projection.point(px + reach[0], py + reach[1], z);
  if (kind === "pull") drawArrow(pen, from, to, palette.force);
  else pen.line([...from, ...to], { stroke: palette.select, width: 2, dash: [5, 4] });
  pen.polygon(circleOutline(from[0], from[1], 4), { fill: kind === "pull" ? palette.force : palette.select });
}

/**
 * A ring around the part that ended the run, and its name.
 * @param {Pen} pen
 * @param {Scene} scene
 * @param {string} name of the part
 * @param {Places} places
 * @param {Projection} projection
 * @param {Palette} palette
 */
export function drawFault(pen, scene, name, places, projection, palette) {
  const part = scene.mechanism.parts.find((candidate) => candidate.name === name);
  if (part === undefined || part.frames.length === 0) return;
  const frame = part.frames[0];
  const [x, y] = framePose(scene.mechanism, frame, places);
  if (!Number.isFinite(x + y)) return;
  const [px, py] = projection.point(x, y, scene.slabOf(frame)[1]);
  const radius = Math.max(14, 2.2 * scene.radius * projection.scale);
  pen.polygon(circleOutline(px, py, radius), { stroke: palette.fault, width: 3, dash: [6, 5] });
  drawName(pen, px + 0.7 * radius, py - 0.7 * radius, name, palette);
}
