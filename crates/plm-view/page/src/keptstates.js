// States of a live mechanism that are kept, so that what was pulled, placed or begun again can be undone.

/** @import {Live} from "./live.js" */

export class KeptStates {
  /** @param {Live} live */
  constructor(live) {
    this.live = live;
    /** How often it has begun, and how often it had when a state was kept. */
    this.era = 0;
    /** @type {Map<number, number>} */
    this.eras = new Map();
  }

  /** The state now is kept under a number. @param {number} id */
  keep(id) {
    this.eras.set(id, this.era);
    this.live.send({ kind: "keep", id });
  }

  /** To a state that was kept; the one now is kept under another number. @param {number} id @param {number} now */
  comeBack(id, now) {
    const { live } = this;
    live.app.grip?.letGo();
    live.pause();
    live.show();
    this.keep(now);
    live.send({ kind: "return", id });
  }

  /** It has come back: rows after that moment were never computed. @param {Float64Array} numbers @param {number} id */
  arrive(numbers, id) {
    const { live } = this;
    const { run, app } = live;
    const [time] = numbers;
    if (this.eras.get(id) !== this.era || time < run.start || time > run.end) run.clear();
    else run.dropAfter(time);
    this.era = this.eras.get(id) ?? this.era;
    if (run.rows === 0 || run.end < time) live.append(numbers);
    app.player.isFollowing = app.run === run;
    app.rowsAppended(run);
    app.change();
  }
}
