// The language server in a worker of its own, spoken to by the Language Server Protocol.
//
// `languageWorker` goes into the worker as text, so that it uses nothing from outside of itself but what goes with it.

import { instanceOf, writeText } from "./machine.js";
import { workerOf } from "./startworker.js";

/** @import {Carrier} from "./exchange.js" */

/**
 * A place of the protocol: line and column from 0, in units of UTF-16.
 * @typedef {{line: number, character: number}} Place
 * @typedef {{start: Place, end: Place}} Range
 * @typedef {{range: Range, severity: number, code?: string, message: string}} Problem
 * @typedef {{range: Range, newText: string}} Edit
 * @typedef {{label: string, kind: number, detail: string, documentation: string}} Choice
 * @typedef {{name: string, files: Record<string, string>}} Package
 * @typedef {{coordinates: [string, string][], mathml: string[], notes: string[], latex: string}} Written equations of motion
 * @typedef {{id?: number, method?: string, params?: any, result?: any, error?: {message: string}}} Message
 */

/** A text that takes longer than this, ms, is given up. */
export const LONGEST_ANSWER = 5000;
/** The only text that is open. */
const DECLARATION_URI = "plm:declaration.plm";

export class Language {
  /**
   * @param {() => Carrier} start starts a worker that has the module
   * @param {(problems: Problem[], text: string) => void} show takes what is wrong with a text
   */
  constructor(start, show) {
    this.start = start;
    this.show = show;
    /** The text that is sent once something is heard of the one before. @type {string | null} */
    this.next = null;
    /** Texts that were sent, and of which nothing is heard yet. @type {string[]} */
    this.sent = [];
    this.asked = 0;
    /** Requests without an answer. @type {Map<number, (result: any) => void>} */
    this.waiting = new Map();
    /** Messages without anything heard after them. */
    this.silent = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.timer = undefined;
    this.begin();
  }

  begin() {
    this.carrier = this.start();
    this.carrier.onmessage = ({ data }) => this.hear(data);
    this.silent = 0;
  }

  /** Begins anew without the text that was too much. @param {string} why */
  giveUp(why) {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.carrier?.terminate();
    for (const answer of this.waiting.values()) answer(null);
    this.waiting.clear();
    const text = this.sent.pop() ?? "";
    this.sent = [];
    this.begin();
    this.show([{ range: { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } }, severity: 1, message: why }], text);
    // What was typed meanwhile.
    this.sendNext();
  }

  /** @param {{kind: "heard", messages: Message[]} | {kind: "broken", text: string}} data */
  hear(data) {
    if (data.kind === "broken") {
      this.giveUp(`the compiler has stopped at this text: ${data.text}`);
      return;
    }
    this.silent -= 1;
    clearTimeout(this.timer);
    this.timer = undefined;
    if (this.silent > 0) this.wait();
    for (const { id, method, params, result } of data.messages) {
      if (method === "textDocument/publishDiagnostics") this.show(params.diagnostics, this.sent.shift() ?? "");
      else if (id !== undefined) {
        this.waiting.get(id)?.(result ?? null);
        this.waiting.delete(id);
      }
    }
    if (this.silent === 0) this.sendNext();
  }

  wait() {
    this.timer ??= setTimeout(() => this.giveUp(`this text was given up after ${LONGEST_ANSWER / 1000} s`), LONGEST_ANSWER);
  }

  /** @param {Message} message */
  send(message) {
    this.silent += 1;
    this.wait();
    this.carrier?.postMessage({ kind: "message", text: JSON.stringify({ jsonrpc: "2.0", ...message }) });
  }

  /** Another text: what is wrong with it is shown. Of many that come while one is compiled the last alone counts. @param {string} text */
  change(text) {
    this.next = text;
    if (this.silent === 0) this.sendNext();
  }

  sendNext() {
    const { next: text } = this;
    if (text === null) return;
    this.next = null;
    this.sent.push(text);
    this.send({ method: "textDocument/didOpen", params: { textDocument: { uri: DECLARATION_URI, languageId: "plm", version: 1, text } } });
  }

  /** @param {string} method @param {object} [more] @returns {Promise<any>} null where nothing is known */
  ask(method, more = {}) {
    this.sendNext();
    this.asked += 1;
    const id = this.asked;
    return new Promise((resolve) => {
      this.waiting.set(id, resolve);
      this.send({ id, method, params: { textDocument: { uri: DECLARATION_URI }, ...more } });
    });
  }

  /** @param {Place} position @returns {Promise<Choice[]>} */
  async complete(position) {
    return (await this.ask("textDocument/completion", { position })) ?? [];
  }

  /** @param {Place} position @returns {Promise<{text: string, range: Range} | null>} */
  async hover(position) {
    const found = await this.ask("textDocument/hover", { position });
    return found === null ? null : { text: found.contents.value, range: found.range };
  }

  /** What mends what is wrong in a range. @param {Range} range @returns {Promise<{title: string, edits: Edit[]}[]>} */
  async fixes(range) {
    const found = (await this.ask("textDocument/codeAction", { range, context: { diagnostics: [] } })) ?? [];
    return found.map((/** @type {any} */ fix) => ({ title: fix.title, edits: fix.edit.changes[DECLARATION_URI] ?? [] }));
  }

  /** The package of cargo that the text is, as `plm export` writes it, or why it is none. @returns {Promise<Package | {why: string}>} */
  async package() {
    return (await this.ask("plm/package")) ?? { why: "the compiler has given no answer" };
  }

  /**
   * The C source of the text (`c`), the files of an FMU with sources (`fmi2`, `fmi3`), or its links in true size (`dxf`, `svg`), or why
   * there is none. Links that meet in a motion, x, y and angle of each body at moments of it, get different layers.
   * @param {"c" | "fmi2" | "fmi3" | "dxf" | "svg"} kind @param {number[][]} [motion] @returns {Promise<(Package & {notices: string[]}) | {why: string}>}
   */
  async source(kind, motion = []) {
    return (await this.ask("plm/source", { kind, motion })) ?? { why: "the compiler has given no answer" };
  }

  /** The equations of motion of a text, which need not be open, or why there are none. @param {string} text @returns {Promise<Written | {why: string}>} */
  async equations(text) {
    return (await this.ask("plm/equations", { text })) ?? { why: "the compiler has given no answer" };
  }

  /** The edits that give the text its layout. @returns {Promise<Edit[]>} */
  async layout() {
    return (await this.ask("textDocument/formatting", { options: { tabSize: 4, insertSpaces: true } })) ?? [];
  }
}

/**
 * Hands messages to the module, and back what follows from them.
 * @param {{onmessage: ((event: MessageEvent<any>) => void) | null, postMessage: (message: unknown) => void}} scope
 */
export function languageWorker(scope) {
  /** @type {any} */
  let exports = null;
  scope.onmessage = ({ data }) => {
    try {
      if (data.kind === "module") {
        exports = instanceOf(data.module);
        return;
      }
      writeText(exports, data.text);
      const [place, length] = [exports.plm_answer(), exports.plm_text_length()];
      const text = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, place, length));
      scope.postMessage({ kind: "heard", messages: JSON.parse(text) });
    } catch (error) {
      scope.postMessage({ kind: "broken", text: error instanceof Error ? error.message : String(error) });
    }
  };
}

/** What starts workers that answer by a module. @param {WebAssembly.Module} module @returns {() => Carrier} */
export function languageWorkerOf(module) {
  return () => {
    const worker = workerOf(`${writeText}\n${instanceOf}\n${languageWorker}\nlanguageWorker(self);\n`);
    worker.postMessage({ kind: "module", module });
    return worker;
  };
}
