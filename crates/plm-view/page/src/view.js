// The camera: a parallel projection onto the screen.

import { clamp } from "./numbers.js";

/** @typedef {{azimuth: number, elevation: number}} Direction degrees */
/** @typedef {{low: number[], high: number[]}} Box in absolute axes */
/** @typedef {{x: number, y: number, width: number, height: number}} Area in pixels of the screen */

/** Directions of view by name. */
export const PRESETS = /** @type {const} */ ({
  front: { azimuth: 0, elevation: 0 },
  back: { azimuth: 180, elevation: 0 },
  left: { azimuth: 90, elevation: 0 },
  right: { azimuth: -90, elevation: 0 },
  top: { azimuth: 0, elevation: 90 },
  bottom: { azimuth: 0, elevation: -90 },
  isometric: { azimuth: -45, elevation: (Math.atan(Math.SQRT1_2) * 180) / Math.PI },
});

/** @typedef {keyof typeof PRESETS} PresetName */

/** The height of the tools of drawing over a picture, in pixels. */
export const DRAWING_TOOLS = 52;

export class View {
  constructor() {
    this.azimuth = 0;
    this.elevation = 0;
    /** Pixels for a metre. */
    this.scale = 100;
    /** The point in the middle of the screen. */
    this.target = [0, 0, 0];
  }

  /** @param {View} other */
  copy(other) {
    this.azimuth = other.azimuth;
    this.elevation = other.elevation;
    this.scale = other.scale;
    this.target = [...other.target];
  }

  /**
   * The directions of the screen in absolute axes: to the right, up, and to the viewer.
   * @returns {[number[], number[], number[]]}
   */
  axes() {
    const radian = Math.PI / 180;
    const [ca, sa] = [exactCos(this.azimuth), exactCos(this.azimuth - 90)];
    const [ce, se] = [exactCos(this.elevation), Math.sin(this.elevation * radian)];
    return [
      [ca, 0, sa],
      [sa * se, ce, -ca * se],
      [-sa * ce, se, ca * ce],
    ];
  }

  /**
   * The projection onto an area of the screen.
   * @param {Area} area
   */
  projection(area) {
    return new Projection(this, area);
  }

  /** @param {PresetName} name */
  lookFrom(name) {
    this.azimuth = PRESETS[name].azimuth;
    this.elevation = PRESETS[name].elevation;
  }

  /**
   * Turns the scene by pixels of dragging.
   * @param {number} dx
   * @param {number} dy
   */
  orbit(dx, dy) {
    this.azimuth = ((((this.azimuth + 0.5 * dx + 180) % 360) + 360) % 360) - 180;
    this.elevation = clamp(this.elevation + 0.5 * dy, -90, 90);
  }

  /**
   * Moves the scene by pixels.
   * @param {number} dx
   * @param {number} dy
   */
  pan(dx, dy) {
    const [right, up] = this.axes();
    this.target = this.target.map((value, axis) => value - (dx * right[axis] - dy * up[axis]) / this.scale);
  }

  /**
   * Enlarges the scene, and the point that is `dx`, `dy` pixels from the middle stays where it is.
   * @param {number} factor
   * @param {number} [dx]
   * @param {number} [dy]
   */
  zoom(factor, dx = 0, dy = 0) {
    const scale = clamp(this.scale * factor, 1e-6, 1e9);
    const share = scale / this.scale;
    this.pan(-dx, -dy);
    this.scale = scale;
    this.pan(dx, dy);
    return share;
  }

  /**
   * Shows the whole of a box.
   * @param {Box} box
   * @param {Area} area
   * @param {number} [above] pixels at its top that are to stay free
   */
  fit(box, area, above = 0) {
    const middle = box.low.map((low, axis) => 0.5 * (low + box.high[axis]));
    const half = box.low.map((low, axis) => 0.5 * (box.high[axis] - low));
    const [right, up] = this.axes();
    const reach = (/** @type {number[]} */ axis) =>
      axis.reduce((sum, part, at) => sum + Math.abs(part) * half[at], 0);
    const margin = Math.min(48, 0.08 * Math.min(area.width, area.height));
    const wide = (area.width - 2 * margin) / Math.max(2 * reach(right), 1e-9);
    const tall = (area.height - above - 2 * margin) / Math.max(2 * reach(up), 1e-9);
    this.target = middle;
    this.scale = clamp(Math.min(wide, tall), 1e-6, 1e9);
    if (above > 0) this.pan(0, 0.5 * above);
  }

  /**
   * Shows what stands in a window of the area, as large as it can be.
   * @param {Area} window
   * @param {Area} area
   */
  zoomTo(window, area) {
    const dx = window.x + 0.5 * window.width - (area.x + 0.5 * area.width);
    const dy = window.y + 0.5 * window.height - (area.y + 0.5 * area.height);
    this.pan(-dx, -dy);
    const factor = Math.min(area.width / Math.max(window.width, 1), area.height / Math.max(window.height, 1));
    this.zoom(factor);
  }
}

/**
 * A cosine that is exactly 0 and 1 at multiples of 90 degrees, so that walls seen from the side vanish.
 * @param {number} degrees
 */
function exactCos(degrees) {
  const turned = (((degrees % 360) + 360) % 360) / 90;
  return Number.isInteger(turned) ? [1, 0, -1, 0][turned] : Math.cos((degrees * Math.PI) / 180);
}

/** From absolute axes to pixels of an area, as three linear forms. */
export class Projection {
  /**
   * @param {View} view
   * @param {Area} area
   */
  constructor(view, area) {
    const [right, up, toViewer] = view.axes();
    const { scale, target } = view;
    this.area = area;
    this.scale = scale;
    this.toViewer = toViewer;
    this.right = right;
    this.up = up;
    this.xx = scale * right[0];
    this.xy = scale * right[1];
    this.xz = scale * right[2];
    this.yx = -scale * up[0];
    this.yy = -scale * up[1];
    this.yz = -scale * up[2];
    this.x0 = area.x + 0.5 * area.width - (this.xx * target[0] + this.xy * target[1] + this.xz * target[2]);
    this.y0 = area.y + 0.5 * area.height - (this.yx * target[0] + this.yy * target[1] + this.yz * target[2]);
  }

  /**
   * A point on the screen.
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  point(x, y, z) {
    return [this.x0 + this.xx * x + this.xy * y + this.xz * z, this.y0 + this.yx * x + this.yy * y + this.yz * z];
  }

  /**
   * The point of a plane of equal z that is seen at a place of the screen; null where the plane is seen from its edge.
   * @param {number} px
   * @param {number} py
   * @param {number} z
   */
  onPlane(px, py, z) {
    const determinant = this.xx * this.yy - this.xy * this.yx;
    if (Math.abs(determinant) < 1e-3 * this.scale * this.scale) return null;
    const [dx, dy] = [px - this.x0 - this.xz * z, py - this.y0 - this.yz * z];
    return [(this.yy * dx - this.xy * dy) / determinant, (this.xx * dy - this.yx * dx) / determinant];
  }

  /**
   * Points of a plane of equal z on the screen.
   * @param {ArrayLike<number>} line x0 y0 x1 y1 …
   * @param {number} z
   * @returns {number[]}
   */
  line(line, z) {
    const out = new Array(line.length);
    const [x0, y0] = [this.x0 + this.xz * z, this.y0 + this.yz * z];
    for (let at = 0; at < line.length; at += 2) {
      out[at] = x0 + this.xx * line[at] + this.xy * line[at + 1];
      out[at + 1] = y0 + this.yx * line[at] + this.yy * line[at + 1];
    }
    return out;
  }
}
