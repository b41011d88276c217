// A run: what plm.json says of it, and its arrays. Rows may be appended while it is shown.

import { hermite, lastNotAbove } from "./numbers.js";
import { scaleOf } from "./units.js";

/** @import {Mechanism, Role, RunHead} from "./format.js" */

/**
 * What can be drawn as a curve, or as marks; `role` left out: a motion.
 * @typedef {{name: string, unit: string, role?: Role | undefined, read: (row: number) => number}} Quantity
 */
/** @typedef {{row: number, share: number}} Moment a place between a row (share 0) and the next */

/** Rows of `width` numbers, which may become more. */
export class Table {
  /**
   * @param {number} width
   * @param {Float64Array | Float32Array} [data]
   * @param {number} [rows] where the width is 0, or less is used than there is
   */
  constructor(width, data = new Float64Array(0), rows = width === 0 ? 0 : Math.floor(data.length / width)) {
    this.width = width;
    this.data = data;
    this.rows = rows;
  }

  /**
   * NaN where the file had no such row.
   * @param {number} row
   * @param {number} column
   */
  at(row, column) {
    return this.data[row * this.width + column] ?? NaN;
  }

  /** @param {ArrayLike<number>} numbers */
  append(numbers) {
    const used = this.rows * this.width;
    if (used + this.width > this.data.length) {
      const larger = new Float64Array(Math.max(2 * this.data.length, 256 * this.width));
      larger.set(this.data.subarray(0, used));
      this.data = larger;
    }
    this.data.set(numbers, used);
    this.rows += 1;
  }

  clear() {
    this.rows = 0;
  }

  /** Leaves out the first rows. @param {number} count */
  dropFirst(count) {
    this.data.copyWithin(0, count * this.width, this.rows * this.width);
    this.rows -= Math.min(count, this.rows);
  }

  /** A copy of the rows from one on. @param {number} row */
  from(row) {
    return new Table(this.width, this.data.slice(row * this.width, this.rows * this.width), Math.max(0, this.rows - row));
  }
}

export class Run {
  /**
   * @param {RunHead} head
   * @param {{time: Table, poses: Table, values: Table, ground: Table | null}} tables
   */
  constructor(head, tables) {
    this.head = head;
    this.name = head.name;
    /** @type {Mechanism} */
    this.mechanism = head.mechanism;
    this.columns = head.columns;
    this.events = head.events;
    this.fault = head.fault;
    /** What the user should know although the run went on. @type {string[]} */
    this.notices = head.notices ?? [];
    this.time = tables.time;
    this.poses = tables.poses;
    this.values = tables.values;
    this.ground = tables.ground;
    /** Whether rows may still come. */
    this.isLive = false;
    /** What is measured in the picture. @type {Quantity[]} */
    this.measures = [];
    /** Rises with every change of its rows. */
    this.version = 0;
  }

  /** Puts the ground where it is declared: a start that cannot be assembled gives no place. */
  declareGround() {
    this.ground?.clear();
    this.ground?.append(this.mechanism.ground.flatMap(({ x, y, angle }) => [x, y, angle]));
  }

  /** A run without rows, for a source that appends them. @param {RunHead} head */
  static empty(head) {
    const ground = head.mechanism.ground.length;
    return new Run(head, {
      time: new Table(1),
      poses: new Table(6 * head.mechanism.bodies.length),
      values: new Table(head.columns.length),
      ground: ground > 0 ? new Table(3 * ground) : null,
    });
  }

  get rows() {
    return this.time.rows;
  }

  get start() {
    return this.rows > 0 ? this.time.data[0] : 0;
  }

  get end() {
    return this.rows > 0 ? this.time.data[this.rows - 1] : 0;
  }

  /**
   * @param {number} time s
   * @param {ArrayLike<number>} poses x y θ and their rates, for each body
   * @param {ArrayLike<number>} values
   * @param {ArrayLike<number>} [ground] x y θ of each port, where they move
   */
  append(time, poses, values, ground) {
    this.version += 1;
    this.time.append([time]);
    this.poses.append(poses);
    this.values.append(values);
    if (ground !== undefined) this.ground?.append(ground);
  }

  clear() {
    this.version += 1;
    for (const table of this.tables()) table?.clear();
    this.events.length = 0;
    this.fault = null;
  }

  tables() {
    return [this.time, this.poses, this.values, this.ground];
  }

  /** Leaves out what was after a time. @param {number} time */
  dropAfter(time) {
    this.version += 1;
    const count = lastNotAbove(this.time.data, this.rows, time) + 1;
    for (const table of this.tables()) if (table !== null) table.rows = Math.min(table.rows, count);
    while (this.events.length > 0 && this.events[this.events.length - 1].time > time) this.events.pop();
  }

  /** Leaves out what was before a time. @param {number} time */
  dropBefore(time) {
    this.version += 1;
    const count = Math.max(0, lastNotAbove(this.time.data, this.rows, time));
    for (const table of this.tables()) table?.dropFirst(count);
    this.events.splice(0, this.events.filter((event) => event.time < this.start).length);
  }

  /**
   * A copy of what was from a time on, which stays as it is.
   * @param {number} time
   * @param {string} name
   */
  since(time, name) {
    const row = Math.max(0, lastNotAbove(this.time.data, this.rows, time));
    const events = this.events.filter((event) => event.time >= time);
    const head = { ...structuredClone({ ...this.head, mechanism: this.mechanism, events, fault: this.fault }), name };
    const [values, poses] = [this.values.from(row), this.poses.from(row)];
    return new Run(head, { time: this.time.from(row), poses, values, ground: this.ground?.from(row) ?? null });
  }

  /**
   * Where a time lies. At a time that two rows have, it is the second: what holds after the event.
   * @param {number} time
   * @returns {Moment}
   */
  momentAt(time) {
    const row = Math.max(0, lastNotAbove(this.time.data, this.rows, time));
    if (row + 1 >= this.rows) return { row, share: 0 };
    const [from, to] = [this.time.data[row], this.time.data[row + 1]];
    return { row, share: to > from ? Math.max(0, (time - from) / (to - from)) : 0 };
  }

  /**
   * The poses of all bodies, by Hermite's cubic between rows.
   * @param {Moment} moment
   * @param {Float64Array} out x y θ for each body
   */
  posesAt({ row, share }, out) {
    const { poses, time } = this;
    const next = share > 0 ? row + 1 : row;
    const width = time.data[next] - time.data[row];
    for (let body = 0; body < this.mechanism.bodies.length; body++) {
      for (let axis = 0; axis < 3; axis++) {
        const [value, rate] = [6 * body + axis, 6 * body + axis + 3];
        const [a, rateA, rateB] = [poses.at(row, value), poses.at(row, rate), poses.at(next, rate)];
        let b = poses.at(next, value);
        // An angle may have lost whole turns between the rows; its rates tell how many.
        if (axis === 2) b += turnsLost(a + 0.5 * width * (rateA + rateB) - b);
        out[3 * body + axis] = hermite(share, width, a, rateA, b, rateB);
      }
    }
  }

  /**
   * The ports of the ground.
   * @param {Moment} moment
   * @param {Float64Array} out x y θ for each port
   */
  groundAt({ row, share }, out) {
    const { ground } = this;
    this.mechanism.ground.forEach((port, index) => {
      [port.x, port.y, port.angle].forEach((fixed, axis) => {
        const at = 3 * index + axis;
        if (ground === null || ground.rows <= row) {
          out[at] = fixed;
        } else {
          const next = Math.min(row + 1, ground.rows - 1);
          out[at] = share === 0 ? ground.at(row, at) : (1 - share) * ground.at(row, at) + share * ground.at(next, at);
        }
      });
    });
  }

  /**
   * A quantity between rows; NaN beside a gap.
   * @param {Quantity} quantity
   * @param {Moment} moment
   */
  valueAt(quantity, { row, share }) {
    if (this.rows === 0) return NaN;
    const value = quantity.read(row);
    return share === 0 ? value : (1 - share) * value + share * quantity.read(row + 1);
  }

  /**
   * All that can be drawn as a curve: the columns, then poses that no column has, then what is measured.
   * @returns {Quantity[]}
   */
  quantities() {
    const { poses, values } = this;
    /** @type {Quantity[]} */
    const list = this.columns.map(({ name, unit, role }, column) => ({
      name,
      unit,
      role,
      read: (/** @type {number} */ row) => values.at(row, column),
    }));
    const known = new Set(list.map(({ name }) => name));
    this.mechanism.bodies.forEach((body, index) => {
      POSE_MEMBERS.forEach(([member, unit], axis) => {
        const name = `${body.name}.${member}`;
        if (known.has(name)) return;
        const scale = scaleOf(this, name, unit);
        list.push({ name, unit: scale.unit, read: (row) => poses.at(row, 6 * index + axis) / scale.factor });
      });
    });
    return [...list, ...this.measures];
  }
}

/** Is a quantity drawn as marks, one for each number? @param {Quantity} quantity */
export function isMarked({ role }) {
  return role === "reading" || role === "residual";
}

/** Members of a body in the order of the poses. */
export const POSE_MEMBERS = /** @type {const} */ ([
  ["x", "m"],
  ["y", "m"],
  ["angle", "rad"],
  ["velocity.x", "m/s"],
  ["velocity.y", "m/s"],
  ["omega", "rad/s"],
]);

/** @param {number} difference rad */
function turnsLost(difference) {
  const turns = Math.round(difference / (2 * Math.PI));
  return Number.isFinite(turns) ? 2 * Math.PI * turns : 0;
}
