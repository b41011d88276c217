// Frames of the screen.

/** @import {App} from "./app.js" */

/**
 * Draws when something has changed, at most as often as the refresh rate allows; tells how far it is.
 * @param {App} app
 * @param {() => void} draw
 */
export function runFrames(app, draw) {
  const frames = { isAsked: false, drawn: 0 };
  let drawnAt = -Infinity;
  const frame = (/** @type {number} */ now) => {
    frames.isAsked = false;
    // Half a millisecond, because frames of the screen do not come exactly in time.
    if (now - drawnAt < 1000 / app.refreshRate - 2) {
      ask();
      return;
    }
    drawnAt = now;
    app.player.tick(now);
    draw();
    frames.drawn += 1;
    if (frames.drawn === 1) performance.mark("first frame");
    if (app.isPlaying) ask();
  };
  const ask = () => {
    if (frames.isAsked) return;
    frames.isAsked = true;
    requestAnimationFrame(frame);
  };
  app.onTouch = ask;
  ask();
  return frames;
}
