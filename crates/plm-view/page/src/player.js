// Time: plays, steps, jumps.

import { clamp, niceNear } from "./numbers.js";

/** A frame moves the time on by no more than this (s): a machine that is busy plays slower and skips nothing. */
export const LONGEST_FRAME = 0.05;

/** So far behind a live source the picture is, s of the clock. */
const BEHIND = 0.03;

/** Speeds that can be chosen: seconds of the run in a second. */
export const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

export class Player {
  constructor() {
    this.time = 0;
    this.start = 0;
    this.end = 0;
    this.isPlaying = false;
    this.isLooping = false;
    /** The end moves while a live source runs, and the time with it. */
    this.isFollowing = false;
    /** How fast a live source moves the end, s in a second; null while it rests. @type {number | null} */
    this.pace = null;
    this.speed = 1;
    /** The manual's fast-forward step (s); null: a hundredth of the run. */
    this.chosenStep = /** @type {number | null} */ (null);
    /** When the last frame was, ms. */
    this.lastFrame = /** @type {number | null} */ (null);
  }

  /**
   * What the time can be.
   * @param {number} start
   * @param {number} end
   */
  setBounds(start, end) {
    this.start = start;
    this.end = Math.max(start, end);
    const isAtEnd = this.isFollowing && this.pace === null;
    this.time = isAtEnd ? this.end : clamp(this.time, this.start, this.end);
  }

  get duration() {
    return this.end - this.start;
  }

  get step() {
    return this.chosenStep ?? (this.duration > 0 ? niceNear(this.duration / 100) : 0.01);
  }

  /** @param {number} time */
  seek(time) {
    this.time = clamp(time, this.start, this.end);
    this.isFollowing = false;
    this.lastFrame = null;
  }

  play() {
    if (this.time >= this.end) this.time = this.start;
    this.isPlaying = this.duration > 0;
    this.lastFrame = null;
  }

  stop() {
    this.isPlaying = false;
  }

  /**
   * Stops, and moves by steps.
   * @param {number} steps
   */
  stepBy(steps) {
    this.stop();
    this.seek(this.time + steps * this.step);
  }

  /** @param {number} steps along the list of speeds */
  changeSpeed(steps) {
    const nearest = SPEEDS.reduce((best, speed) =>
      Math.abs(Math.log(speed / this.speed)) < Math.abs(Math.log(best / this.speed)) ? speed : best,
    );
    this.speed = SPEEDS[clamp(SPEEDS.indexOf(nearest) + steps, 0, SPEEDS.length - 1)];
  }

  /**
   * Moves on to a frame; whether anything moved.
   * @param {number} now ms
   */
  tick(now) {
    if (!this.isPlaying && !(this.isFollowing && this.pace !== null)) return false;
    const passed = this.lastFrame === null ? 0 : clamp((now - this.lastFrame) / 1000, 0, LONGEST_FRAME);
    this.lastFrame = now;
    if (!this.isPlaying) return this.follow(passed);
    this.time += passed * this.speed;
    if (this.time >= this.end) {
      if (this.isLooping && this.duration > 0) {
        this.time = this.start + ((this.time - this.start) % this.duration);
      } else {
        this.time = this.end;
        this.stop();
      }
    }
    return true;
  }

  /**
   * Runs along shortly behind the end, which moves by jerks.
   * @param {number} passed s
   */
  follow(passed) {
    const pace = this.pace ?? 0;
    const wanted = this.end - BEHIND * pace;
    const moved = this.time + passed * pace;
    const near = Math.abs(wanted - moved) < 10 * BEHIND * pace ? moved + 0.1 * (wanted - moved) : wanted;
    this.time = clamp(near, this.start, this.end);
    return true;
  }
}
