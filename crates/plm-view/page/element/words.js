// What the words of an element mean: its text, its lengths, names of quantities.

/** @import {Live} from "../src/live.js" */

/** The declaration in an element: its script of type `text/plm`, in which every character stands for itself, or its text. @param {Element} of */
export function declarationIn(of) {
  const script = of.querySelector("script[type='text/plm']");
  return (script ?? of).textContent ?? "";
}

/** A length of CSS; a number alone has pixels, and nothing the usual height. @param {string | null} text */
export function lengthOf(text) {
  const words = (text ?? "").trim();
  return /^\d+(\.\d+)?$/.test(words) ? `${words}px` : words;
}

/**
 * A parameter or an input by its name.
 * @param {Live} live
 * @param {string} name
 * @returns {{kind: "parameter" | "input", index: number, factor: number} | null}
 */
export function quantityOf({ mechanism }, name) {
  for (const kind of /** @type {const} */ (["parameter", "input"])) {
    const list = kind === "parameter" ? mechanism.parameters : mechanism.inputs;
    const index = list.findIndex((each) => each.name === name);
    if (index >= 0) return { kind, index, factor: list[index].factor };
  }
  return null;
}
