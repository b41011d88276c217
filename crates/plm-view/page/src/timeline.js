// The time line: where the run is, its events, its fault.

import { fitCanvas, setText } from "./dom.js";
import { SPEEDS } from "./player.js";
import { shortNumber, timeText } from "./text.js";

/** @import {App} from "./app.js" */

/** Half the width of the slider's thumb, as in the style. */
const THUMB = 8;

export class Timeline {
  /**
   * @param {App} app
   * @param {{slider: HTMLInputElement, marks: HTMLCanvasElement, now: HTMLElement, end: HTMLElement, speed: HTMLSelectElement}} parts
   */
  constructor(app, parts) {
    this.app = app;
    this.parts = parts;
    this.drawn = "";
    for (const speed of SPEEDS) parts.speed.add(new Option(`${shortNumber(speed)}×`, String(speed)));
    parts.speed.addEventListener("change", () => {
      app.player.speed = Number(parts.speed.value);
      app.touch();
    });
    parts.slider.addEventListener("input", () => {
      const { player } = app;
      player.stop();
      player.seek(player.start + Number(parts.slider.value) * player.duration);
      app.touch();
    });
  }

  update() {
    const { slider, now, end, speed } = this.parts;
    const { player } = this.app;
    const share = player.duration > 0 ? (player.time - player.start) / player.duration : 0;
    if (Number(slider.value) !== share) slider.value = String(share);
    slider.disabled = this.app.run === null;
    const text = timeText(player.time, player.duration);
    setText(now, text);
    setText(end, timeText(player.end, player.duration));
    if (slider.getAttribute("aria-valuetext") !== text) slider.setAttribute("aria-valuetext", text);
    if (Number(speed.value) !== player.speed) this.showSpeed();
    this.drawMarks();
  }

  showSpeed() {
    const { speed } = this.parts;
    const value = String(this.app.player.speed);
    // A speed from an address may be none of the list.
    if (![...speed.options].some((option) => option.value === value)) {
      speed.add(new Option(`${shortNumber(Number(value))}×`, value));
    }
    speed.value = value;
  }

  /** Events as ticks under the slider; the fault as a thick one. */
  drawMarks() {
    const { marks } = this.parts;
    const { app } = this;
    const { clientWidth: width, clientHeight: height } = marks;
    const { player, palette, run } = app;
    const drawn = [app.revision, width, height, player.start, player.end, palette.name, run?.events.length].join(" ");
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    const context = fitCanvas(marks, width, height);
    context.clearRect(0, 0, width, height);
    if (run === null || player.duration === 0) return;
    const place = (/** @type {number} */ time) =>
      THUMB + ((time - player.start) / player.duration) * (width - 2 * THUMB);
    context.fillStyle = palette.faint;
    for (const { time } of run.events) context.fillRect(place(time) - 0.75, 0, 1.5, height);
    context.fillStyle = palette.fault;
    if (run.fault !== null) context.fillRect(place(run.fault.time) - 2, 0, 4, height);
  }
}
