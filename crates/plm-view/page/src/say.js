// What is said for a moment, over the picture and to screen readers.

/** @import {App, Message} from "./app.js" */

/** So long, ms, it is shown. */
const SAID_FOR = 3000;

/** It takes the place of what was said before. @param {App} app @param {string} text */
export function say(app, text) {
  /** @type {Message} */
  const said = { kind: "note", text, isBrief: true };
  app.messages = [...app.messages.filter(({ isBrief }) => isBrief !== true), said];
  app.change();
  setTimeout(() => {
    app.messages = app.messages.filter((message) => message !== said);
    app.change();
  }, SAID_FOR);
}
