// Colours of declarations: in the highlighter of the built book, and by the grammars that editors take.

import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import test from "node:test";
import vm from "node:vm";

const require = createRequire(import.meta.url);
const root = path.join(import.meta.dirname, "../..");
const book = process.env.PLM_BOOK ?? path.join(root, "target/book");
const read = file => fs.readFileSync(path.join(root, file), "utf8");

const declaration = `/// A swing.
pub Swing {
  gravity: 9.81 m/s^2;
  body bob { mass: 1 kg; port pivot: (0, 1.5e-1) m; start angle: 30 deg, locked; }
  revolute hinge(ground.o, bob.pivot) { damping: 0.1 N*m/(rad/s); }
  output sin(bob.angle), hinge.force; // all of it
}`;

/** What has which colour: a text, its class in the book and its scope in editors. */
const coloured = [
  ["gravity", "keyword", "keyword.other.plm"],
  ["body", "keyword", "keyword.other.plm"],
  ["locked", "keyword", "keyword.other.plm"],
  ["output", "keyword", "keyword.other.plm"],
  ["revolute", "title", "entity.name.type.part.plm"],
  ["sin", "built_in", "support.function.plm"],
  ["1.5e-1", "number", "constant.numeric.plm"],
  ["deg", "string", "keyword.other.unit.plm"],
  ["Swing", "title", "entity.name.type.plm"],
];

/** The highlighter of the built book with our languages, and no page. */
function highlighter() {
  const context = vm.createContext({ document: { querySelectorAll: () => [] } });
  const file = fs.readdirSync(book).find(name => /^highlight.*\.js$/.test(name));
  const scripts = [fs.readFileSync(path.join(book, file), "utf8")];
  scripts.push(read("docs/theme/words.js"), read("docs/theme/declarations.js"));
  for (const script of scripts) {
    vm.runInContext(script, context);
  }
  return (language, text) => vm.runInContext("hljs", context).highlight(language, text).value;
}

test("the book colours declarations, alone and within Rust", () => {
  const highlight = highlighter();
  const rust = `fn main() { let gravity = 1; }\nplm::mechanism! {\n${declaration}\n}\nlet body = 2;`;
  for (const html of [highlight("plm", declaration), highlight("rust", rust)]) {
    for (const [text, name] of coloured) {
      assert.ok(html.includes(`<span class="hljs-${name}">${text}</span>`), `${text}: ${html}`);
    }
    assert.ok(html.includes("hljs-comment"));
    assert.ok(!/hljs-[a-z_]+">(angle|pivot|o)</.test(html), "a member or a name has a colour");
  }
  // Outside of the macro the words are names of Rust.
  const html = highlight("rust", rust);
  assert.ok(html.includes("let</span> gravity") && html.endsWith('let</span> body = <span class="hljs-number">2</span>;'), html);
});

/** Scopes of the tokens of a text by the grammars for editors. Of Rust nothing is known but its name. */
async function scopes(scope, text) {
  const { loadWASM, OnigScanner, OnigString } = require("vscode-oniguruma");
  const { INITIAL, Registry, parseRawGrammar } = require("vscode-textmate");
  await loadWASM(fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")));
  const { contributes } = JSON.parse(read("editors/vscode/package.json"));
  const files = new Map(contributes.grammars.map(of => [of.scopeName, path.join("editors/vscode", of.path)]));
  const injections = contributes.grammars.filter(of => of.injectTo).map(of => of.scopeName);
  const rust = '{ "scopeName": "source.rust", "patterns": [{ "match": "\\\\b(fn|let)\\\\b", "name": "keyword.rust" }] }';
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: patterns => new OnigScanner(patterns),
      createOnigString: line => new OnigString(line),
    }),
    loadGrammar: async name => parseRawGrammar(name === "source.rust" ? rust : read(files.get(name)), "a.json"),
    getInjections: name => (name === "source.rust" ? injections : undefined),
  });
  const grammar = await registry.loadGrammar(scope);
  const found = [];
  let state = INITIAL;
  for (const line of text.split("\n")) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    found.push(...tokens.map(of => [line.slice(of.startIndex, of.endIndex), of.scopes.at(-1)]));
    state = ruleStack;
  }
  return found;
}

test("editors colour declarations, alone and within Rust", async () => {
  const rust = `fn main() {}\nplm::mechanism! {\n${declaration}\n}\nlet body = 2;`;
  for (const found of [await scopes("source.plm", declaration), await scopes("source.rust", rust)]) {
    for (const [text, , scope] of coloured) {
      assert.ok(found.some(([token, of]) => token === text && of === scope), `${text}: ${JSON.stringify(found)}`);
    }
    assert.ok(found.some(([, of]) => of === "comment.line.documentation.plm"));
    assert.ok(found.some(([token, of]) => token === ".pivot" && of === "variable.other.member.plm"));
  }
  // The macro ends at its bracket.
  const last = (await scopes("source.rust", rust)).at(-1);
  assert.deepEqual(last, [" body = 2;", "source.rust"]);
});
