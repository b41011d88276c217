// What draws: on a canvas, or as the text of an SVG file. Both take pixels and give the same picture.

import { darkStyle, LIGHT } from "./palette.js";

/** @import {Area} from "./view.js" */

/** @typedef {{fill?: string | null, stroke?: string | null, width?: number, dash?: number[], opacity?: number}} Paint */
/**
 * `halo` is the colour of a rim, by which letters are read over anything.
 * @typedef {{colour: string, size: number, align?: "start" | "middle" | "end", bold?: boolean, turned?: boolean, halo?: string}} Lettering
 */
/**
 * @typedef {{polygon: (points: ArrayLike<number>, paint: Paint) => void,
 *   line: (points: ArrayLike<number>, paint: Paint) => void,
 *   text: (x: number, y: number, text: string, lettering: Lettering) => void,
 *   within: (area: Area, draw: () => void) => void}} Pen
 */

/** Width of a rim around letters, half of it outside. */
const HALO = 4;

export const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";

/** @implements {Pen} */
export class CanvasPen {
  /** @param {CanvasRenderingContext2D} context scaled so that 1 is a pixel of the page */
  constructor(context) {
    this.context = context;
    context.lineJoin = "round";
    context.lineCap = "round";
    context.textBaseline = "middle";
  }

  /** @param {ArrayLike<number>} points @param {Paint} paint */
  polygon(points, paint) {
    this.trace(points, true);
    this.apply(paint);
  }

  /** @param {ArrayLike<number>} points @param {Paint} paint */
  line(points, paint) {
    this.trace(points, false);
    this.apply(paint);
  }

  /** @param {ArrayLike<number>} points @param {boolean} isClosed */
  trace(points, isClosed) {
    const { context } = this;
    context.beginPath();
    context.moveTo(points[0], points[1]);
    for (let at = 2; at < points.length; at += 2) {
      // No numbers stand after the rings of a contour with holes.
      if (!Number.isNaN(points[at])) context.lineTo(points[at], points[at + 1]);
      else if (at + 2 < points.length) context.moveTo(points[at + 2], points[at + 3]);
    }
    if (isClosed) context.closePath();
  }

  /** @param {Paint} paint */
  apply({ fill, stroke, width = 1, dash, opacity = 1 }) {
    const { context } = this;
    context.globalAlpha = opacity;
    if (fill) {
      context.fillStyle = fill;
      context.fill();
    }
    if (stroke) {
      context.strokeStyle = stroke;
      context.lineWidth = width;
      if (dash) context.setLineDash(dash);
      context.stroke();
      if (dash) context.setLineDash([]);
    }
    context.globalAlpha = 1;
  }

  /** @param {number} x @param {number} y @param {string} text @param {Lettering} lettering */
  text(x, y, text, { colour, size, align = "start", bold = false, turned = false, halo }) {
    const { context } = this;
    context.save();
    context.translate(x, y);
    if (turned) context.rotate(-Math.PI / 2);
    context.font = `${bold ? "600 " : ""}${size}px ${FONT}`;
    context.textAlign = align === "middle" ? "center" : align;
    context.fillStyle = colour;
    if (halo !== undefined) {
      context.strokeStyle = halo;
      context.lineWidth = HALO;
      context.strokeText(text, 0, 0);
    }
    context.fillText(text, 0, 0);
    context.restore();
  }

  /** @param {Area} area @param {() => void} draw */
  within(area, draw) {
    const { context } = this;
    context.save();
    context.beginPath();
    context.rect(area.x, area.y, area.width, area.height);
    context.clip();
    draw();
    context.restore();
  }
}

/** @implements {Pen} */
export class SvgPen {
  constructor() {
    /** @type {string[]} */
    this.parts = [];
    this.clips = 0;
  }

  /** @param {ArrayLike<number>} points @param {Paint} paint */
  polygon(points, paint) {
    const rings = svgPoints(points).split(/ NaN,NaN ?/);
    const shape = rings.length === 1 ? `polygon points="${rings[0]}"` : `path d="${rings.map((ring) => ring && `M${ring}Z`).join("")}"`;
    this.parts.push(`<${shape} ${svgPaint(paint)}/>`);
  }

  /** @param {ArrayLike<number>} points @param {Paint} paint */
  line(points, paint) {
    this.parts.push(`<polyline points="${svgPoints(points)}" ${svgPaint({ ...paint, fill: null })}/>`);
  }

  /** @param {number} x @param {number} y @param {string} text @param {Lettering} lettering */
  text(x, y, text, { colour, size, align = "start", bold = false, turned = false, halo }) {
    const rim = halo === undefined ? "" : ` stroke="${halo}" stroke-width="${HALO}" paint-order="stroke"`;
    const turn = turned ? ` transform="rotate(-90 ${svgNumber(x)} ${svgNumber(y)})"` : "";
    this.parts.push(
      `<text x="${svgNumber(x)}" y="${svgNumber(y)}" dy="0.35em" font-size="${size}" text-anchor="${align}" ` +
        `font-weight="${bold ? 600 : 400}" fill="${colour}"${rim}${turn}>${escapeXml(text)}</text>`,
    );
  }

  /** @param {Area} area @param {() => void} draw */
  within(area, draw) {
    const id = `clip${(this.clips += 1)}`;
    const corners = `x="${area.x}" y="${area.y}" width="${area.width}" height="${area.height}"`;
    this.parts.push(`<clipPath id="${id}"><rect ${corners}/></clipPath><g clip-path="url(#${id})">`);
    draw();
    this.parts.push("</g>");
  }

  /** @param {number} width @param {number} height @param {string} background @param {string} title */
  finish(width, height, background, title) {
    const drawing = `<rect width="${width}" height="${height}" fill="${background}"/>\n${this.parts.join("\n")}`;
    const style = background === LIGHT.background ? `${darkStyle(drawing)}\n` : "";
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
      `font-family="${escapeXml(FONT)}" stroke-linejoin="round" stroke-linecap="round">\n<title>${escapeXml(title)}</title>\n` +
      `${style}${drawing}\n</svg>\n`
    );
  }
}

/** @param {number} value */
function svgNumber(value) {
  return String(Math.round(value * 100) / 100);
}

/** @param {ArrayLike<number>} points */
function svgPoints(points) {
  const out = [];
  for (let at = 0; at < points.length; at += 2) out.push(`${svgNumber(points[at])},${svgNumber(points[at + 1])}`);
  return out.join(" ");
}

/** @param {Paint} paint */
function svgPaint({ fill, stroke, width = 1, dash, opacity = 1 }) {
  const parts = [`fill="${fill ?? "none"}"`];
  if (stroke) parts.push(`stroke="${stroke}" stroke-width="${width}"`);
  if (stroke && dash) parts.push(`stroke-dasharray="${dash.join(" ")}"`);
  if (opacity !== 1) parts.push(`opacity="${opacity}"`);
  return parts.join(" ");
}

/** @param {string} text */
export function escapeXml(text) {
  return text.replace(/[&<>"']/g, (sign) => `&#${sign.charCodeAt(0)};`);
}
