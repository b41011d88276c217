// The mechanism in the program that serves this page: a live one that begins, pauses and ends there.

import { Live } from "./live.js";

/** @import {App} from "./app.js" */
/** @import {RunHead} from "./format.js" */
/** @import {FromProgram, Hello, Program} from "./program.js" */
/** @import {FromWorker} from "./worker.js" */

const LOST = "The program has ended, or cannot be reached. What it has shown stays; where it starts anew at this address, it is shown again.";
const OTHER = "Another mechanism is served now. Load the page anew to see it.";

export class ServedLive extends Live {
  /**
   * @param {App} app
   * @param {RunHead} head of a run with all observed quantities
   * @param {Program} program
   * @param {boolean} pulls whether the program pulls bodies
   */
  constructor(app, head, program, pulls) {
    super(app, head, new Uint8Array(0), program);
    this.run.head.method = head.method;
    this.program = program;
    this.isInPage = false;
    this.modes = pulls ? ["pull"] : [];
    this.known = kindOf(head);
    /** By which start of the program its rows are. */
    this.origin = "";
    /** The program goes on where it was when it was lost. */
    this.isResumed = false;
  }

  /** What a program does is not for a page to end that looks at something else. */
  unseen() {}

  /** A program cannot be asked what it will do. */
  lookAhead() {}

  /** Whether it runs is known once the program says so: until then its rows come in. */
  ask() {}

  /** @param {FromWorker | FromProgram} message */
  hear(message) {
    if (message.kind === "hello") this.meet(message);
    else if (message.kind === "lost") this.lose(LOST);
    else if (message.kind === "running") {
      this.isRunning = message.isRunning;
      this.speed = message.speed;
      this.app.player.speed = message.speed;
      this.app.change();
    } else if (message.kind === "began" && this.isResumed && message.numbers[0] >= this.run.end) {
      this.isResumed = false;
    } else super.hear(message);
  }

  /** @param {Hello} hello */
  meet({ run, about }) {
    if (kindOf(about) !== this.known) {
      this.program.close();
      this.lose(OTHER);
      return;
    }
    this.isResumed = run === this.origin && this.run.rows > 0;
    this.origin = run;
    this.say("");
  }

  /** @param {string} why */
  lose(why) {
    this.isRunning = false;
    this.say(why);
  }

  /** Over the picture and in the panel. @param {string} why */
  say(why) {
    const { app, gone } = this;
    this.gone = why;
    app.messages = app.messages.filter(({ text }) => text !== gone);
    if (why !== "") app.tell("warning", why);
    app.change();
  }
}

/** What has to be the same for rows to be of the same mechanism. @param {RunHead} head */
function kindOf({ mechanism, columns }) {
  const { name, bodies, ground, parts, parameters, inputs } = mechanism;
  const names = (/** @type {{name: string}[]} */ list) => list.map((each) => each.name);
  return JSON.stringify([name, ...[bodies, ground, parts, parameters, inputs, columns].map(names)]);
}
