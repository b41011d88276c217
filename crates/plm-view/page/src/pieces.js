// What is drawn of a part: pins, rails, slots, jacks, springs.

import { depthOfFrame, linkKind } from "./levels.js";
import { shapePieces } from "./looks.js";
import { boxOutline, circleOutline, coilLine, movedOutline, roundedHull } from "./outline.js";
import { fixedPiece, framePose } from "./solid.js";

/** @import {Frame, Part} from "./format.js" */
/** @import {Levels} from "./levels.js" */
/** @import {Mechanism} from "./format.js" */
/** @import {Item, Piece, Places, Tone} from "./solid.js" */

/**
 * What parts need to know of the scene that they are in.
 * @typedef {{mechanism: Mechanism, radius: number, levels: Levels, slabOf: (frame: Frame) => [number, number]}} Surroundings
 */

/**
 * The pieces of a part, by its pair, or by its kind where it has none. Parts that nobody could see have no piece.
 * @param {Surroundings} scene
 * @param {number} index of the part
 * @returns {Piece[]}
 */
export function piecesOfPart(scene, index) {
  const part = scene.mechanism.parts[index];
  if (part.frames.length + part.shapes.length === 0) return [];
  const make = PART_PIECES[linkKind(part) ?? part.pair ?? part.kind];
  const draft = new PartDraft(scene, index);
  return [...(make === undefined ? [] : make(draft)), ...shapePieces(draft)];
}

/** A part while it becomes pieces. */
export class PartDraft {
  /**
   * @param {Surroundings} scene
   * @param {number} index
   */
  constructor(scene, index) {
    this.scene = scene;
    this.index = index;
    /** @type {Part} */
    this.part = scene.mechanism.parts[index];
    /** @type {Item} */
    this.item = { kind: "part", index };
    this.radius = scene.radius;
    this.thickness = scene.levels.thickness;
    /** Red is what stands on the ground, blue what joins two bodies. @type {Tone} */
    this.tone = [...this.part.frames, ...this.part.shapes].some((frame) => frame.body === null) ? "ground" : "joint";
    this.pin = 0.5 * (this.part.sizes["pin"] || 0.9 * this.radius);
  }

  /**
   * @param {Places} places
   * @param {number} frame
   */
  pose(places, frame) {
    return framePose(this.scene.mechanism, this.part.frames[frame], places);
  }

  /**
   * @param {Tone} tone
   * @param {[number, number]} slab
   * @param {(places: Places) => number[] | null} shape
   * @param {{isLine?: boolean, side?: number}} [options]
   * @returns {Piece}
   */
  moving(tone, slab, shape, { isLine = false, side = 0 } = {}) {
    return { item: this.item, tone, z0: slab[0], z1: slab[1], body: -1, outline: null, shape, isLine, side };
  }

  /**
   * A piece that stays where a frame is.
   * @param {Tone} tone
   * @param {[number, number]} slab
   * @param {number} frame
   * @param {number[]} outline in the axes of the frame
   * @param {number} [side]
   */
  at(tone, slab, frame, outline, side = 0) {
    const { body, port } = this.part.frames[frame];
    if (body === null) return this.moving(tone, slab, (places) => movedOutline(outline, this.pose(places, frame)), { side });
    const { x, y, angle } = port === null ? { x: 0, y: 0, angle: 0 } : this.scene.mechanism.bodies[body].ports[port];
    return fixedPiece(this.item, tone, slab, body, movedOutline(outline, [x, y, angle]), side);
  }

  /**
   * A pin through two slabs: what looks out on both sides, and what is between them.
   * @param {number} frame where it stands
   * @param {[number, number][]} slabs
   * @param {number} [radius]
   */
  pinPieces(frame, slabs, radius = this.pin) {
    const [lower, upper] = [...slabs].sort((a, b) => a[0] - b[0]);
    const outline = circleOutline(0, 0, radius);
    const [bottom, top] = [Math.min(lower[0], upper[0]), Math.max(lower[1], upper[1])];
    const head = 0.35 * this.thickness;
    const pieces = [
      this.at(this.tone, [bottom - head, bottom], frame, outline, -1),
      this.at(this.tone, [top, top + head], frame, outline, 1),
    ];
    if (upper[0] - lower[1] > 0.01 * this.thickness) {
      pieces.push(this.at(this.tone, [lower[1], upper[0]], frame, outline));
    }
    return pieces;
  }

  /**
   * A line on top of the bodies.
   * @param {(places: Places) => number[]} shape
   */
  stroke(shape) {
    const top = Math.max(...this.slabs().map((slab) => slab[1]));
    return this.moving(this.tone, [top, top + 0.1 * this.thickness], shape, { isLine: true });
  }

  slabs() {
    return this.part.frames.map((frame) => this.scene.slabOf(frame));
  }

  /** Bearings where the part stands on the ground. */
  mounts() {
    return this.part.frames.flatMap((frame, at) => {
      if (frame.body !== null) return [];
      const outline = MOUNT.map((value) => value * 0.8 * Math.max(this.radius, 1.2 * this.pin));
      const upright = (/** @type {Places} */ places) => movedOutline(outline, [...this.pose(places, at).slice(0, 2), 0]);
      return [this.moving("mount", this.scene.slabOf(frame), upright)];
    });
  }

  /**
   * How far frames have been seen along the x axis of another one, from the origin of that.
   * @param {Frame} axis
   * @param {number[]} frames
   * @returns {(places: Places) => {low: number, high: number}}
   */
  reach(axis = this.part.frames[0], frames = [1]) {
    const reach = { low: Infinity, high: -Infinity };
    return (places) => {
      const [x, y, angle] = framePose(this.scene.mechanism, axis, places);
      for (const frame of frames) {
        const [u, v] = this.pose(places, frame);
        const along = (u - x) * Math.cos(angle) + (v - y) * Math.sin(angle);
        if (!Number.isFinite(along)) continue;
        reach.low = Math.min(reach.low, along);
        reach.high = Math.max(reach.high, along);
      }
      return reach;
    };
  }
}

/** A bearing on a base plate, its hole at the origin; in half widths of a bar. */
const MOUNT = [-2.4, -3.4, 2.4, -3.4, 2.4, -2.7, 1.5, -2.7, 0.9, 0.4, 0.5, 0.85, -0.5, 0.85, -0.9, 0.4, -1.5, -2.7, -2.4, -2.7];

/** @type {{[kind: string]: (draft: PartDraft) => Piece[]}} */
const PART_PIECES = {
  revolute: (draft) => [...draft.mounts(), ...draft.pinPieces(0, draft.slabs())],
  weld: (draft) => {
    const half = 0.7 * draft.radius;
    const [a, b] = draft.slabs();
    const top = Math.max(a[1], b[1]);
    return [draft.at(draft.tone, [top, top + 0.3 * draft.thickness], 0, boxOutline(-half, half, -half, half))];
  },
  prismatic: prismaticPieces,
  pin_slot: slotPieces,
  jack: jackPieces,
  spring: springPieces,
  belt: beltPieces,
  elastic_belt: beltPieces,
  chain: beltPieces,
};

/**
 * A rail along the x axis of the first frame, a shoe on the second.
 * @param {PartDraft} draft
 */
function prismaticPieces(draft) {
  const { radius } = draft;
  const [a, b] = draft.slabs();
  const reach = draft.reach();
  const rail = draft.moving(draft.tone, a, (places) => {
    const { low, high } = reach(places);
    const outline = boxOutline(Math.min(low, 0) - 3.2 * radius, Math.max(high, 0) + 3.2 * radius, -0.45 * radius, 0.45 * radius);
    return movedOutline(outline, draft.pose(places, 0));
  });
  return [rail, draft.at("body", b, 1, boxOutline(-2 * radius, 2 * radius, -1.25 * radius, 1.25 * radius))];
}

/**
 * A slot along the x axis of the first frame, a pin at the second.
 * @param {PartDraft} draft
 */
function slotPieces(draft) {
  const [a, b] = draft.slabs();
  const reach = draft.reach();
  const rim = 0.12 * draft.thickness;
  const stadium = (/** @type {number} */ width) => (/** @type {Places} */ places) => {
    const { low, high } = reach(places);
    const slack = 1.5 * draft.pin;
    return movedOutline(roundedHull([[low - slack, 0], [high + slack, 0]], width), draft.pose(places, 0));
  };
  const groove = stadium(1.15 * draft.pin);
  return [
    draft.moving(draft.tone, [a[0] - rim, a[1] + rim], stadium(draft.pin + Math.max(0.9 * draft.pin, 0.5 * draft.radius))),
    draft.moving("groove", [a[1] + rim, a[1] + 1.2 * rim], groove, { side: 1 }),
    draft.moving("groove", [a[0] - 1.2 * rim, a[0] - rim], groove, { side: -1 }),
    ...draft.pinPieces(1, [a, b]),
  ];
}

/**
 * The slab of a jack or a spring, and pins at its ends.
 * @param {PartDraft} draft
 */
function linkSlab(draft) {
  const middle = draft.scene.levels.links.get(draft.index) ?? depthOfFrame(draft.scene.mechanism, draft.part.frames[0]);
  const half = 0.5 * draft.thickness;
  /** @type {[number, number]} */
  const slab = [middle - half, middle + half];
  const ends = draft.part.frames.slice(0, 2).flatMap((frame, at) => {
    const pins = draft.pinPieces(at, [slab, draft.scene.slabOf(frame)], 0.4 * draft.radius);
    /** @type {Tone} */
    const tone = frame.body === null ? "ground" : "joint";
    return pins.map((pin) => ({ ...pin, tone }));
  });
  return { slab, ends };
}

/**
 * x y and direction of the line from one frame to another, and its length.
 * @param {PartDraft} draft
 * @param {Places} places
 * @param {[number, number]} [ends]
 */
function linkLine(draft, places, [from, to] = [0, 1]) {
  const [[x, y], [u, v]] = [draft.pose(places, from), draft.pose(places, to)];
  return { pose: [x, y, Math.atan2(v - y, u - x)], length: Math.hypot(u - x, v - y) };
}

/**
 * The piston's diameter stands at the first frame, the rod's at the second. The wider one is the cylinder, in which the other
 * slides: in the manual's tables that is the rod's. With the rod all the way in the distance is the free length: so long is the
 * cylinder, but for the eye of the rod.
 * @param {PartDraft} draft
 */
function jackPieces(draft) {
  const { sizes } = draft.part;
  const { radius } = draft;
  const { slab, ends } = linkSlab(draft);
  const piston = 0.5 * (sizes["piston"] || 2.2 * radius);
  const rod = 0.5 * (sizes["rod"] || 0.9 * radius);
  const [wide, slim] = [Math.max(piston, rod), Math.min(piston, rod)];
  const line = (/** @type {Places} */ places) => linkLine(draft, places, rod > piston ? [1, 0] : [0, 1]);
  const eye = 0.9 * radius;
  let shortest = sizes["free_length"] || Infinity;
  const cylinderEnd = (/** @type {number} */ length) => {
    shortest = Math.min(shortest, length);
    return Math.max(0.5 * shortest, shortest - 2 * eye);
  };
  const rodSlab = /** @type {[number, number]} */ ([
    slab[0] + 0.15 * draft.thickness,
    slab[1] - 0.15 * draft.thickness,
  ]);
  return [
    draft.moving("rod", rodSlab, (places) => {
      const { pose, length } = line(places);
      return movedOutline(boxOutline(Math.min(0.9 * cylinderEnd(length), length), length, -slim, slim), pose);
    }),
    draft.moving("cylinder", slab, (places) => {
      const { pose, length } = line(places);
      return movedOutline(boxOutline(-0.6 * eye, cylinderEnd(length), -wide, wide), pose);
    }),
    ...draft.mounts(),
    ...ends,
  ];
}

/** @param {PartDraft} draft */
function springPieces(draft) {
  const { slab, ends } = linkSlab(draft);
  const coil = draft.moving("spring", slab, (places) => {
    const { pose, length } = linkLine(draft, places);
    return movedOutline(coilLine(length, 1.1 * draft.radius, 7), pose);
  }, { isLine: true });
  return [...(draft.part.shapes.length > 0 ? [] : [coil]), ...draft.mounts(), ...ends];
}

/**
 * The strands of what runs on two wheels, `a` and `b`.
 * @param {PartDraft} draft
 */
function beltPieces(draft) {
  const { frames, sizes } = draft.part;
  const wheels = ["a", "b"].map((name) => ({ frame: frames.findIndex(({ argument }) => argument === name), radius: sizes[`radius_${name}`] }));
  const [a, b] = wheels;
  if (a.radius === undefined || b.radius === undefined) return [];
  return [1, -1].map((sense) => draft.stroke((places) => {
    const { pose, length } = linkLine(draft, places, [a.frame, b.frame]);
    const normal = pose[2] + sense * (0.5 * Math.PI - Math.asin((a.radius - b.radius) / length));
    return wheels.flatMap(({ frame, radius }) => {
      const [x, y] = draft.pose(places, frame);
      return [x + radius * Math.cos(normal), y + radius * Math.sin(normal)];
    });
  }));
}
