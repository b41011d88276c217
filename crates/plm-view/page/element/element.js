// `<plm-mechanism>`, an element for pages of others: the mechanism moves whose declaration stands in it.

import { App } from "../src/app.js";
import { Dials } from "../src/dials.js";
import { element, setText } from "../src/dom.js";
import { dragTool } from "../src/drag.js";
import { Exchange } from "../src/exchange.js";
import { runFrames } from "../src/frames.js";
import { listenToPointers } from "../src/pointer.js";
import { Stage } from "../src/stage.js";
import { startWorker } from "../src/startworker.js";
import { declarationIn, lengthOf, quantityOf } from "./words.js";
import style from "./element.css";

/** @import {Live} from "../src/live.js" */

/** Changes of the text that come together are one, ms. */
const REST = 50;

/** The compiler, which all elements of a page share. @type {Promise<WebAssembly.Module> | null} */
let compiler = null;

/** It is fetched where the first mechanism comes into sight; after a failure it is asked for anew. */
function theCompiler() {
  compiler ??= fetched("./plm.wasm", import.meta.url)
    .then((response) => response.arrayBuffer())
    .then((bytes) => WebAssembly.compile(bytes));
  compiler.catch(() => (compiler = null));
  return compiler;
}

/** What an address has, or an error that names it. @param {string} address @param {string} base */
async function fetched(address, base) {
  const whole = new URL(address, base).href;
  let why = "";
  try {
    const response = await fetch(whole);
    if (response.ok) return response;
    why = `${response.status} ${response.statusText}`.trim();
  } catch (error) {
    why = error instanceof Error ? error.message : String(error);
  }
  throw new Error(`${whole} cannot be read: ${why}`);
}

export class PlmMechanism extends HTMLElement {
  static observedAttributes = ["src", "controls", "height", "theme", "speed"];

  #app = new App();
  /** @type {Exchange | null} */
  #exchange = null;
  /** The mechanism that the sliders are of. @type {Live | null} */
  #shown = null;
  /** @type {Dials | null} */
  #dials = null;
  #isInSight = false;
  /** Whether it goes on when it comes into sight again. */
  #goesOn = false;
  /** Whether another text came while nobody saw it. */
  #isStale = true;
  /** How often a text was asked for. */
  #asked = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #waiting = undefined;

  #stage = element("div", { id: "stage" });
  #canvas = element("canvas", { id: "picture", tabindex: 0, role: "img" });
  #problems = element("pre", { id: "problems", role: "alert", hidden: true });
  #go = element("button", { type: "button", id: "go", onclick: () => this.#toggle() }, "Play");
  #sliders = element("details", { id: "sliders" }, element("summary", {}, "Settings"));
  #bar = element(
    "div",
    { id: "bar", role: "toolbar", "aria-label": "Time", hidden: true },
    this.#go,
    element("button", { type: "button", id: "restart", onclick: () => this.restart() }, "Restart"),
    element("button", { type: "button", id: "fit", onclick: () => this.#app.zoomToExtents() }, "Fit"),
    this.#sliders,
  );
  #root = element("div", { id: "root" }, this.#stage, this.#problems, this.#bar);

  #sight = new IntersectionObserver(
    (entries) => this.#see(entries.at(-1)?.isIntersecting ?? false),
    { rootMargin: "100px" },
  );
  #size = new ResizeObserver(() => this.#app.touch());
  #text = new MutationObserver(() => this.#again());

  constructor() {
    super();
    const app = this.#app;
    const parts = {
      stage: this.#stage,
      canvas: this.#canvas,
      messages: element("div", { id: "messages" }),
      empty: element("p", { id: "empty" }, "Loading …"),
      spoken: element("p", { id: "spoken", role: "status" }),
    };
    this.#stage.append(parts.canvas, parts.empty, parts.messages, parts.spoken);
    this.attachShadow({ mode: "open" }).append(element("style", {}, style), this.#root);
    app.grip = dragTool(app);
    const stage = new Stage(app, parts);
    listenToPointers(app, this.#canvas, true);
    this.#canvas.addEventListener("keydown", (event) => {
      if (event.key !== " ") return;
      event.preventDefault();
      this.#toggle();
    });
    const dark = matchMedia("(prefers-color-scheme: dark)");
    app.prefersDark = dark.matches;
    dark.addEventListener("change", () => {
      app.prefersDark = dark.matches;
      app.change();
    });
    runFrames(app, () => {
      this.#root.dataset["theme"] = app.isDark ? "dark" : "light";
      app.live?.update();
      stage.update();
      this.#updateBar();
    });
  }

  connectedCallback() {
    this.#sight.observe(this);
    this.#size.observe(this.#stage);
    this.#text.observe(this, { childList: true, characterData: true, subtree: true });
  }

  disconnectedCallback() {
    for (const observer of [this.#sight, this.#size, this.#text]) observer.disconnect();
    clearTimeout(this.#waiting);
    this.#asked += 1;
    this.#isInSight = false;
    this.#isStale = true;
    this.#exchange?.end();
    this.#exchange = null;
  }

  /** @param {string} name @param {string | null} before @param {string | null} now */
  attributeChangedCallback(name, before, now) {
    const app = this.#app;
    if (name === "src" && before !== now) this.#again();
    else if (name === "controls") this.#bar.hidden = now === null;
    else if (name === "height") this.#stage.style.height = lengthOf(now);
    else if (name === "theme") app.theme = now === "light" || now === "dark" ? now : "auto";
    else if (name === "speed") app.player.speed = Number(now) > 0 ? Number(now) : 1;
    app.change();
  }

  /** The declaration in the element; a text that is set is shown in the place of what was. */
  get declaration() {
    return declarationIn(this);
  }

  set declaration(text) {
    this.removeAttribute("src");
    this.textContent = text;
  }

  /** The time of the run, s. */
  get time() {
    return this.#app.live?.run.end ?? 0;
  }

  get isPlaying() {
    return this.#app.live?.isRunning ?? false;
  }

  play() {
    this.#app.live?.start();
  }

  pause() {
    this.#app.live?.pause();
  }

  /** Begins again with the parameters as they are. */
  restart() {
    this.#app.live?.restart();
  }

  /**
   * Sets a parameter or an input, in its declared unit.
   * @param {string} name
   * @param {number} value
   */
  set(name, value) {
    const { live } = this.#app;
    const found = live === null ? null : quantityOf(live, name);
    if (live === null || found === null) throw new RangeError(`there is no parameter or input ${name}`);
    if (!Number.isFinite(value)) throw new RangeError(`${name} is a number, not ${value}`);
    live.set(found.kind, found.index, value * found.factor);
  }

  /**
   * A parameter or an input in its declared unit, or what is recorded, in the unit of its curve: outputs, and `crank.angle` of a body.
   * @param {string} name
   */
  value(name) {
    const { live } = this.#app;
    const found = live === null ? null : quantityOf(live, name);
    if (live !== null && found !== null) return (live.settings[found.kind][found.index] ?? NaN) / found.factor;
    const quantity = live?.run.quantities().find((each) => each.name === name);
    if (live === null || quantity === undefined) throw new RangeError(`there is no quantity ${name}`);
    return live.run.rows === 0 ? NaN : quantity.read(live.run.rows - 1);
  }

  #toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  /** What nobody sees does not run. @param {boolean} isInSight */
  #see(isInSight) {
    if (isInSight === this.#isInSight) return;
    this.#isInSight = isInSight;
    const { live } = this.#app;
    if (isInSight && this.#isStale) void this.#declare();
    else if (isInSight && this.#goesOn) live?.start();
    else if (!isInSight) {
      this.#goesOn = live?.isRunning ?? false;
      live?.pause();
    }
  }

  /** Another text may be there. */
  #again() {
    clearTimeout(this.#waiting);
    this.#isStale = true;
    this.#waiting = setTimeout(() => this.#isInSight && void this.#declare(), REST);
  }

  async #declare() {
    this.#asked += 1;
    this.#isStale = false;
    const asked = this.#asked;
    try {
      const source = this.getAttribute("src");
      const [module, text] = await Promise.all([
        theCompiler(),
        source === null ? this.declaration : fetched(source, document.baseURI).then((response) => response.text()),
      ]);
      if (asked !== this.#asked) return;
      if (text.trim() === "") throw new Error("There is no declaration: it stands in the element, or `src` names its file.");
      this.#exchange ??= this.#newExchange(module);
      const isShown = await this.#exchange.declare(text);
      if (asked !== this.#asked || isShown === null) return;
      if (!isShown) throw new Error(this.#exchange.why.trim() || "the compiler has stopped");
      this.#tell("");
    } catch (error) {
      if (asked !== this.#asked) return;
      this.#tell(error instanceof Error ? error.message : String(error));
      // A file may be there the next time.
      this.#isStale = this.#exchange === null;
    }
  }

  /** @param {WebAssembly.Module} module */
  #newExchange(module) {
    const app = this.#app;
    const exchange = new Exchange(app, module, startWorker);
    exchange.keepsSpare = false;
    const { begins } = exchange;
    exchange.begins = () => !this.hasAttribute("paused") && begins();
    return exchange;
  }

  /** Shows what is wrong; nothing where it is empty. @param {string} message */
  #tell(message) {
    const app = this.#app;
    this.#problems.hidden = message === "";
    this.#stage.hidden = message !== "" && app.live === null;
    setText(this.#problems, message);
    app.mode = app.live?.usualMode ?? "pan";
    app.touch();
    const detail = message === "" ? { name: app.live?.mechanism.name ?? "" } : { message };
    this.dispatchEvent(new CustomEvent(message === "" ? "plm-ready" : "plm-error", { detail, bubbles: true }));
  }

  #updateBar() {
    const { live } = this.#app;
    setText(this.#go, this.isPlaying ? "Pause" : "Play");
    if (live !== this.#shown) {
      this.#shown = live;
      this.#dials = live === null ? null : new Dials(live);
      const all = this.#dials?.elements ?? [];
      this.#sliders.replaceChildren(element("summary", {}, "Settings"), ...all);
      this.#sliders.hidden = all.length === 0;
    }
    this.#dials?.update();
  }
}

if (customElements.get("plm-mechanism") === undefined) customElements.define("plm-mechanism", PlmMechanism);
