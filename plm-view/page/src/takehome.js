// What is typed, to take home: a file, a Rust crate, a link.

import { element, saveBlob } from "./dom.js";
import { showDialog } from "./dialogs.js";
import { zipFile } from "./write.js";

/** The mechanism of a declaration, by the name that follows `pub`. @param {string} text */
export function nameOf(text) {
  const code = text.replaceAll(/\/\/.*$/gm, "").replaceAll(/\/\*[^]*?\*\//g, "");
  return /^\s*(?:pub\s+)?([A-Za-z_]\w*)\s*\{/.exec(code)?.[1] ?? null;
}

/** `FourBar` as the name of a crate: `four_bar`. @param {string} name */
const crateName = (name) => name.replaceAll(/(?<=[a-z0-9])(?=[A-Z])/g, "_").toLowerCase();

/** @param {string} name @param {string} text */
function crateOf(name, text) {
  const declaration = text.trim().split("\n").map((line) => (line === "" ? "" : `    ${line}`)).join("\n");
  const main =
    `plm::mechanism! {\n${declaration}\n}\n\n` +
    `fn main() -> Result<(), plm::Fault> {\n    let mut sim = ${name}::new().start()?;\n    for _ in 0..100 {\n        sim.step(0.01)?;\n` +
    `    }\n    println!("{:?}", sim.stats());\n    Ok(())\n}\n`;
  const manifest =
    `[package]\nname = "${crateName(name)}"\nversion = "0.1.0"\nedition = "2024"\n\n[dependencies]\n` +
    `plm = { package = "plm-planar", version = "0.1" }\n`;
  return { manifest, main };
}

/** @param {string} text */
export function saveText(text) {
  saveBlob(new Blob([text], { type: "text/plain" }), `${crateName(nameOf(text) ?? "mechanism")}.plm`);
}

/** @param {string} text */
async function saveCrate(text) {
  const name = nameOf(text) ?? "Mechanism";
  const { manifest, main } = crateOf(name, text);
  const [folder, encode] = [crateName(name), (/** @type {string} */ of) => new TextEncoder().encode(of)];
  const bytes = await zipFile([[`${folder}/Cargo.toml`, encode(manifest)], [`${folder}/src/main.rs`, encode(main)]]);
  saveBlob(new Blob([bytes], { type: "application/zip" }), `${folder}.zip`);
}

/** What can be done with a text elsewhere. @param {string} text */
export function openTakeHome(text) {
  const file = `${crateName(nameOf(text) ?? "mechanism")}.plm`;
  const button = (/** @type {string} */ id, /** @type {string} */ label, /** @type {() => void} */ onclick) => element("button", { type: "button", id, onclick }, label);
  const command = (/** @type {string} */ line, /** @type {string} */ what) =>
    element("tr", {}, element("td", {}, element("code", {}, line)), element("td", {}, what));
  showDialog("Take it home", [
    element(
      "div",
      { class: "row" },
      button("home-text", "Declaration (.plm)", () => saveText(text)),
      button("home-crate", "Rust crate (.zip)", () => void saveCrate(text)),
    ),
    element("p", {}, "The crate is the same mechanism in Rust, compiled by rustc: the same numbers, to the bit."),
    element("h3", {}, "On the command line"),
    element(
      "table",
      {},
      element(
        "tbody",
        {},
        command(`plm run ${file} --until 5 --csv outputs.csv`, "its outputs as a table"),
        command(`plm check ${file}`, "what is wrong with it"),
        command(`plm expand ${file}`, "the Rust code that the macro makes of it"),
      ),
    ),
    element("p", {}, "From Rust it becomes C, an FMU, a Python wheel: the book says how, under \"From C\", \"As an FMU\", \"From Python\"."),
  ]);
}
