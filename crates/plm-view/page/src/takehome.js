// What is typed, to take home: a file, a Rust crate, C source, an FMU with that.

import { element, saveBlob, setText } from "./dom.js";
import { showDialog } from "./dialogs.js";
import { zipFile } from "./write.js";

/** @import {Language} from "./language.js" */
/** @import {Run} from "./run.js" */

/** The mechanism of a declaration, by the name that follows `pub`. @param {string} text */
export function nameOf(text) {
  const code = text.replaceAll(/\/\/.*$/gm, "").replaceAll(/\/\*[^]*?\*\//g, "");
  return /^\s*(?:pub\s+)?([A-Za-z_]\w*)\s*\{/.exec(code)?.[1] ?? null;
}

/** `FourBar` as the name of a file: `four_bar`. @param {string} text */
const fileName = (text) => (nameOf(text) ?? "mechanism").replaceAll(/(?<=[a-z0-9])(?=[A-Z])/g, "_").toLowerCase();

/** @param {string} text */
export function saveText(text) {
  saveBlob(new Blob([text], { type: "text/plain" }), `${fileName(text)}.plm`);
}

/** Saves the package of the text as a zip; why there is none stands in `told`. @param {Language} language @param {HTMLElement} told */
async function savePackage(language, told) {
  const made = await language.package();
  if ("why" in made) {
    setText(told, `There is no crate: ${made.why}.`);
    return;
  }
  const bytes = await zipFile(Object.entries(made.files).map(([path, text]) => [`${made.name}/${path}`, new TextEncoder().encode(text)]));
  saveBlob(new Blob([bytes], { type: "application/zip" }), `${made.name}.zip`);
}

/** Saves C source of the text, or an FMU with it. @param {"c" | "fmi2" | "fmi3"} kind @param {Language} language @param {HTMLElement} told */
async function saveSource(kind, language, told) {
  const made = await language.source(kind);
  if ("why" in made) {
    setText(told, `There is none: ${made.why}`);
    return;
  }
  const isFmu = kind !== "c";
  const encoder = new TextEncoder();
  const bytes = await zipFile(Object.entries(made.files).map(([path, text]) => [isFmu ? path : `${made.name}/${path}`, encoder.encode(text)]));
  saveBlob(new Blob([bytes], { type: "application/zip" }), isFmu ? `${made.name}.fmu` : `${made.name}_c.zip`);
  setText(told, made.notices.length > 0 ? made.notices.join("; ") : "It has the steps of Rk4 as C99, with the same bits; no Rust is needed to compile it.");
}

/** Poses of a run at so many moments say which links meet. */
const MOST_MOMENTS = 360;

/** What a run has moved through: x, y and angle of each body in turn. @param {Run | null} run @returns {number[][]} */
export function movedThrough(run) {
  if (run === null) return [];
  const step = Math.max(1, Math.ceil(run.rows / MOST_MOMENTS));
  const rows = Array.from({ length: Math.floor((run.rows + step - 1) / step) }, (_, k) => k * step);
  return rows.map((row) => run.mechanism.bodies.flatMap((_, body) => [0, 1, 2].map((axis) => run.poses.at(row, 6 * body + axis))));
}

/** Saves the links of the text in true size. @param {"dxf" | "svg"} kind @param {Language} language @param {Run | null} run what moves, where it is the text @param {HTMLElement} told */
async function saveLinks(kind, language, run, told) {
  const made = await language.source(kind, movedThrough(run));
  if ("why" in made) {
    setText(told, `There are none: ${made.why}`);
    return;
  }
  const encoder = new TextEncoder();
  const bytes = await zipFile(Object.entries(made.files).map(([path, text]) => [`${made.name}/${path}`, encoder.encode(text)]));
  saveBlob(new Blob([bytes], { type: "application/zip" }), `${made.name}_${kind}.zip`);
  const words = "Each link and a sheet of all in millimetres, holes of 5 mm for pins, tables of lengths and pins; links that have met in the run have different layers.";
  setText(told, [words, ...made.notices].join(" "));
}

/** Commands for a file, and what they make of it. @param {string} name the file without its ending */
const homeCommands = (name) => [
  [`plm run ${name}.plm --until 5 --csv outputs.csv`, "its outputs as a table"],
  [`plm check ${name}.plm`, "what is wrong with it"],
  [`plm expand ${name}.plm`, "the Rust code that the macro makes of it"],
  [`plm export ${name}.plm --c ${name}`, "a package that makes a library for C and C++, and the command for it"],
  [`plm export ${name}.plm --fmu ${name}`, "a package that makes an FMU"],
  [`plm export ${name}.plm --c-source ${name}`, "C99 of it, without Rust"],
  [`plm export ${name}.plm --fmu-source ${name}.fmu`, "an FMU with that source"],
  [`plm export ${name}.plm --python ${name}`, "a package that makes a wheel for Python"],
  [`plm export ${name}.plm --dxf ${name} --until 1`, "its links in true size for a laser; `--hole`, `--width` and `--kerf` say how"],
  [`plm export ${name}.plm --mjcf ${name}.xml`, "a model of MuJoCo"],
  [`plm export ${name}.plm --urdf ${name}.urdf`, "a robot of ROS"],
];

/** What can be done with a text elsewhere. @param {string} text @param {Language} language @param {Run | null} [run] what moves, where it is the text */
export function openTakeHome(text, language, run = null) {
  const button = (/** @type {string} */ id, /** @type {string} */ label, /** @type {() => void} */ onclick) => element("button", { type: "button", id, onclick }, label);
  const told = element("p", { id: "home-told", role: "status" }, "The crate is the same mechanism in Rust, compiled by rustc: the same numbers, to the bit. It makes C, FMUs and wheels, too.");
  const rows = homeCommands(fileName(text)).map(([line, what]) =>
    element("tr", {}, element("td", {}, element("code", {}, line)), element("td", {}, what)),
  );
  showDialog("Take it home", [
    element(
      "div",
      { class: "row" },
      button("home-text", "Declaration (.plm)", () => saveText(text)),
      button("home-crate", "Rust crate (.zip)", () => void savePackage(language, told)),
      button("home-c", "C source (.zip)", () => void saveSource("c", language, told)),
      button("home-fmi3", "FMU with source, FMI 3.0", () => void saveSource("fmi3", language, told)),
      button("home-fmi2", "FMI 2.0", () => void saveSource("fmi2", language, told)),
      button("home-dxf", "Links as DXF (.zip)", () => void saveLinks("dxf", language, run, told)),
      button("home-svg", "Links as SVG (.zip)", () => void saveLinks("svg", language, run, told)),
    ),
    told,
    element("h3", {}, "On the command line"),
    element("table", {}, element("tbody", {}, ...rows)),
  ]);
}
