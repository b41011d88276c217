// The pane of the declaration: the editor, what is wrong, and what can be done with the text.

import { element, setText } from "./dom.js";
import { faultWords } from "./fault.js";
import { Language, languageWorkerOf } from "./language.js";
import { packText } from "./packedtext.js";
import { openTakeHome, saveText } from "./takehome.js";

/** @import {App} from "./app.js" */
/** @import {Exchange} from "./exchange.js" */
/** @import {Problem} from "./language.js" */

/** @typedef {{name: string, text: string}} Example */

/** Larger files are no declarations. */
const LARGEST_TEXT = 1 << 20;

/** The code of a mechanism without a body. */
const NO_BODY = "E0504";

/** The editor, which stands in the page as a script of its own. @returns {typeof import("../editor/editor.js")} */
const codeEditor = () => /** @type {any} */ (globalThis).plmEditor;

/** A code, which leads to its page where the book is known. @param {string} code */
function pageOf(code) {
  const book = document.getElementById("book")?.textContent ?? "";
  if (code === "" || book === "") return element("span", {}, code);
  return element("a", { href: `${book}diagnostics/${code}.html`, target: "_blank", rel: "noopener" }, code);
}

export class EditorPane {
  /**
   * @param {App} app
   * @param {Exchange} exchange
   * @param {Example[]} gallery
   * @param {string} text
   */
  constructor(app, exchange, gallery, text) {
    this.app = app;
    this.exchange = exchange;
    this.usual = gallery[0].text;
    /** The text that becomes a mechanism once nothing is wrong with it. @type {string | null} */
    this.waiting = null;
    /** What the compiler says of the text. */
    this.found = "";
    /** The name of the step of the text that is made. */
    this.stepName = "";
    /** How many changes there were. */
    this.changes = 0;
    /** @type {HTMLButtonElement | undefined} */
    this.link = undefined;
    this.state = element("p", { id: "editor-state", role: "status" });
    this.problems = element("ul", { id: "problems", "aria-label": "What is wrong" });
    const code = element("div", { id: "code" });
    this.root = element("section", { id: "editor", "aria-label": "Declaration" }, this.head(gallery), code, this.state, this.problems);
    document.querySelector("main")?.prepend(this.root);
    this.language = new Language(languageWorkerOf(exchange.module), (problems, of) => this.show(problems, of));
    const { history } = app;
    const steps = { stepped: () => history.add({ kind: "text", name: this.stepName || "text" }), undo: () => history.undo(), redo: () => history.redo() };
    this.editor = codeEditor().makeEditor(code, text, this.language, (now) => this.changed(now), steps);
    history.text = this.editor;
    this.language.change(text);
    this.follow(text);
    this.listenToFiles();
    app.heardFault = (words) => this.tellFault(words);
  }

  /** @param {Example[]} gallery */
  head(gallery) {
    const button = (/** @type {string} */ id, /** @type {string} */ label, /** @type {() => void} */ onclick, title = label) =>
      element("button", { type: "button", id, title, onclick }, label);
    const choose = element(
      "select",
      { id: "gallery", "aria-label": "Begin with", onchange: () => this.begin(gallery[Number(choose.value)], choose) },
      element("option", { value: "" }, "Begin with …"),
      ...gallery.map(({ name }, index) => element("option", { value: index }, name)),
    );
    this.link = button("editor-link", "Copy link", () => void this.copyLink(), "A link to this text and this view");
    return element(
      "div",
      { class: "row" },
      choose,
      button("editor-new", "New", () => this.app.sketch?.begin(), "An empty sheet, on which you draw"),
      button("editor-format", "Format", () => void this.format(), "One layout, comments are kept"),
      button("editor-open", "Open…", () => this.open(), "A file from this computer; nothing leaves it"),
      button("editor-save", "Save", () => saveText(this.editor.text()), "The declaration as a file"),
      this.link,
      button("editor-home", "Take it home…", () => this.takeHome()),
    );
  }

  takeHome() {
    const text = this.editor.text();
    openTakeHome(text, this.language, this.exchange.text === text ? (this.app.live?.run ?? null) : null);
  }

  /** Another text, which can be undone. @param {Example | undefined} example @param {HTMLSelectElement} choose */
  begin(example, choose) {
    if (example !== undefined) this.editor.replace(example.text);
    choose.value = "";
  }

  /** A step of the text under a name. @param {string} name @param {(editor: EditorPane["editor"]) => void} act */
  step(name, act) {
    this.stepName = name;
    act(this.editor);
    this.stepName = "";
  }

  /** @param {string} text */
  changed(text) {
    this.language.change(text);
    this.waiting = text;
    this.follow(text);
  }

  /** The address follows the text. @param {string} text */
  async follow(text) {
    this.changes += 1;
    const change = this.changes;
    const packed = text === this.usual ? "" : await packText(text);
    if (change !== this.changes) return;
    this.app.packedText = packed;
    this.app.touch();
  }

  /** What is wrong with a text, which moves if nothing is. @param {Problem[]} problems @param {string} text */
  show(problems, text) {
    // A sheet on which nothing is, or nothing that moves, is no mistake.
    const isBare = text.trim() === "" || problems.some(({ code }) => code === NO_BODY);
    if (isBare) {
      this.showBare(text);
      return;
    }
    const errors = problems.filter(({ severity }) => severity === 1).length;
    this.editor.mark(problems);
    const warnings = problems.length - errors;
    const counted = (/** @type {number} */ count, /** @type {string} */ what) => (count === 0 ? [] : [`${count} ${what}${count === 1 ? "" : "s"}`]);
    const found = [...counted(errors, "error"), ...counted(warnings, "warning")].join(", ");
    this.found = found === "" ? "Nothing is wrong." : errors > 0 ? `${found}: the last text without an error moves.` : found;
    setText(this.state, this.found);
    this.root.dataset["state"] = errors > 0 ? "errors" : "good";
    if (errors === 0) this.tellFault(faultWords(this.app));
    this.problems.replaceChildren(
      ...problems.map((problem) => {
        const { range, severity, code, message } = problem;
        const go = () => this.editor.goTo(range.start);
        const words = `${range.start.line + 1}: ${message.split("\n")[0]}`;
        const button = element("button", { type: "button", class: "plain", onclick: go }, words);
        const item = element("li", { class: severity === 1 ? "error" : "warning" }, button, pageOf(code ?? ""));
        if (severity === 1) void this.offer(problem, item);
        return item;
      }),
    );
    if (text !== this.waiting) return;
    this.waiting = null;
    // What was told is drawn first.
    if (errors === 0) setTimeout(() => void this.declare(text));
  }

  /** Nothing moves yet. @param {string} text */
  showBare(text) {
    this.editor.mark([]);
    this.problems.replaceChildren();
    this.found = text.trim() === "" ? "An empty sheet." : "Nothing moves yet: there is no body.";
    this.root.dataset["state"] = "good";
    setText(this.state, this.found);
    if (text !== this.waiting) return;
    this.waiting = null;
    this.exchange.clear();
  }

  /** Makes a mechanism of a text without errors; why it is none, or does not start, stands beside it. @param {string} text */
  async declare(text) {
    const isShown = await this.exchange.declare(text);
    if (isShown === false) this.tellRefusal(this.exchange.why);
  }

  /** @param {string} why */
  tellRefusal(why) {
    setText(this.state, `This text is not what moves: ${why.split("\n")[0] || "the compiler has stopped"}.`);
    this.root.dataset["state"] = "errors";
  }

  /** Why the mechanism stands still stands beside its text too. @param {string} words empty where it does not */
  tellFault(words) {
    if (this.root.dataset["state"] === "errors") return;
    const neverBegan = words !== "" && this.app.live?.isAssembled === false;
    this.root.dataset["state"] = neverBegan ? "fault" : "good";
    setText(this.state, neverBegan ? words : this.found);
  }

  /** What mends it, as buttons. @param {Problem} problem @param {HTMLElement} item */
  async offer({ range }, item) {
    const change = this.changes;
    for (const { title, edits } of await this.language.fixes(range)) {
      const mend = () => {
        // Places of another text are no places of this one.
        if (change === this.changes) this.editor.edit(edits);
      };
      item.append(element("button", { type: "button", onclick: mend }, title));
    }
  }

  async format() {
    this.editor.edit(await this.language.layout());
  }

  open() {
    const input = element("input", { type: "file", accept: ".plm,.txt" });
    input.addEventListener("change", () => void this.take(input.files?.[0]));
    input.click();
  }

  /** @param {File | undefined} file */
  async take(file) {
    if (file === undefined) return;
    if (file.size > LARGEST_TEXT) this.app.tell("error", `${file.name} is too large to be a declaration.`);
    else this.editor.replace(await file.text());
  }

  /** Declarations that are dropped anywhere; other files are results. */
  listenToFiles() {
    document.addEventListener(
      "drop",
      (event) => {
        const file = event.dataTransfer?.files[0];
        if (file === undefined || !/\.(plm|txt)$/.test(file.name)) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        document.body.classList.remove("dropping");
        void this.take(file);
      },
      { capture: true },
    );
  }

  async copyLink() {
    await navigator.clipboard.writeText(location.href);
    if (this.link !== undefined) setText(this.link, "Copied");
    setTimeout(() => this.link !== undefined && setText(this.link, "Copy link"), 1500);
  }
}
