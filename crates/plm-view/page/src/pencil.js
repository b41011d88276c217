// The pencil: the compiler's module in the page's own thread, which answers what a gesture is in the text.
//
// It reads the syntax tree and compiles nothing, so that it answers within a frame. This script knows no grammar.

import { instanceOf, writeText } from "./machine.js";

/** @import {Edit} from "./language.js" */

/**
 * @typedef {{owner: string, port: string}} PortName a port of a body, or of `ground`
 * A port in the picture, in absolute axes, m and rad; a guess where assembly may move its body.
 * @typedef {PortName & {at: number[], angle: number, guessed?: boolean, locks?: string[]}} PlacedPort
 * @typedef {{name: string, kind: string, pin: boolean, ports: PortName[]}} SketchPart
 * The text as it is drawn before it is a mechanism.
 * @typedef {{places: PlacedPort[], parts: SketchPart[]}} SketchSheet
 * @typedef {{kind: string, [more: string]: any}} Gesture
 * What a gesture is, or why it is nothing.
 * @typedef {{why?: string, edits?: Edit[], values?: number[], to?: number[] | null, also?: PortName[], open?: string[], told?: string[], made?: string[]}} Drawn
 */

export class Pencil {
  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.module = module;
    /** @type {any} */
    this.exports = null;
  }

  /**
   * Asks about a gesture on a text whose ports stand at these places.
   * @param {string} text
   * @param {Gesture} gesture
   * @param {PlacedPort[]} [places]
   * @returns {any}
   */
  ask(text, gesture, places = []) {
    const params = { textDocument: { uri: "plm:drawing.plm" }, text, gesture, places };
    try {
      this.exports ??= instanceOf(this.module);
      const { exports } = this;
      writeText(exports, JSON.stringify({ jsonrpc: "2.0", id: 1, method: "plm/draw", params }));
      const [place, length] = [exports.plm_answer(), exports.plm_text_length()];
      const [{ result, error }] = JSON.parse(new TextDecoder().decode(new Uint8Array(exports.memory.buffer, place, length)));
      return result ?? { why: error?.message ?? "the compiler has given no answer" };
    } catch (error) {
      // An instance that has stopped answers no more.
      this.exports = null;
      return { why: error instanceof Error ? error.message : String(error) };
    }
  }

  /** @param {string} text @returns {SketchSheet} */
  sheet(text) {
    const { places = [], parts = [] } = this.ask(text, { kind: "sketch" });
    return { places, parts };
  }
}
