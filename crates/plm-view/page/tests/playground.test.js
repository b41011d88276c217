// What is typed in the playground, without a browser: the language server's client, links, names.

import assert from "node:assert/strict";
import { mock, test } from "node:test";
import { Language, languageWorker, LONGEST_ANSWER } from "../src/language.js";
import { packText, unpackText } from "../src/packedtext.js";
import { nameOf } from "../src/takehome.js";

/** A client whose workers note what they are sent. */
function client() {
  const [workers, shown, texts] = [[], [], []];
  const start = () => {
    const worker = { sent: [], isOver: false, onmessage: null, postMessage: ({ text }) => worker.sent.push(JSON.parse(text)), terminate: () => (worker.isOver = true) };
    workers.push(worker);
    return worker;
  };
  const language = new Language(start, (problems, text) => (shown.push(problems), texts.push(text)));
  const answer = (...messages) => workers.at(-1).onmessage({ data: { kind: "heard", messages } });
  return { language, workers, shown, texts, answer };
}

const published = (message) => ({ method: "textDocument/publishDiagnostics", params: { diagnostics: [{ message }] } });
const textOf = ({ params }) => params.textDocument.text;

test("of texts that come while one is compiled the last alone is compiled", () => {
  const { language, workers, shown, answer } = client();
  for (const text of ["a", "ab", "abc"]) language.change(text);
  assert.deepEqual(workers[0].sent.map(textOf), ["a"]);
  answer(published("of a"));
  assert.deepEqual(workers[0].sent.map(textOf), ["a", "abc"]);
  answer(published("of abc"));
  assert.deepEqual(shown.map(([problem]) => problem.message), ["of a", "of abc"]);
  assert.equal(workers[0].sent.length, 2);
});

test("a question is of the text as it is", async () => {
  const { language, workers, answer } = client();
  language.change("a");
  language.change("a.");
  const found = language.complete({ line: 0, character: 2 });
  const [, , question] = workers[0].sent;
  const methods = ["didOpen", "didOpen", "completion"].map((name) => `textDocument/${name}`);
  assert.deepEqual(workers[0].sent.map(({ method }) => method), methods);
  assert.equal(textOf(workers[0].sent[1]), "a.");
  answer({ id: question.id, result: [{ label: "angle" }] });
  assert.deepEqual(await found, [{ label: "angle" }]);
  // Nothing is known of what is no name.
  const nothing = language.hover({ line: 0, character: 0 });
  answer({ id: question.id + 1, result: null });
  assert.equal(await nothing, null);
});

test("what is wrong comes with the text that it is wrong with", () => {
  const { language, workers, texts, answer } = client();
  language.change("a");
  language.change("ab");
  // A question sends the text that has not been sent yet.
  void language.hover({ line: 0, character: 0 });
  answer(published("of a"));
  answer(published("of ab"));
  assert.deepEqual(texts, ["a", "ab"]);
  answer({ id: 1, result: null });
  language.change("abc");
  language.change("abcd");
  language.giveUp("too long");
  assert.deepEqual(texts, ["a", "ab", "abc"]);
  // What was typed meanwhile is sent to the next worker.
  assert.deepEqual(workers.at(-1).sent.map(textOf), ["abcd"]);
});

test("the package of a text is that of the command", async () => {
  const { language, workers, answer } = client();
  language.change("pub A { }");
  const made = language.package();
  const question = workers[0].sent.at(-1);
  assert.equal(question.method, "plm/package");
  answer({ id: question.id, result: { name: "a", files: { "Cargo.toml": "" } } });
  assert.deepEqual(await made, { name: "a", files: { "Cargo.toml": "" } });
});

test("a text that takes too long, or that stops the compiler, is given up", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { language, workers, shown, answer } = client();
  language.change("endless");
  const asked = language.complete({ line: 0, character: 0 });
  mock.timers.tick(LONGEST_ANSWER);
  assert.ok(workers[0].isOver && workers.length === 2);
  assert.deepEqual(await asked, []);
  assert.match(shown[0][0].message, /given up after 5 s/);
  language.change("good");
  answer(published("of good"));
  mock.timers.tick(LONGEST_ANSWER);
  assert.equal(workers.length, 2);
  workers[1].onmessage({ data: { kind: "broken", text: "unreachable" } });
  assert.ok(workers[1].isOver && workers.length === 3);
  assert.match(shown.at(-1)[0].message, /unreachable/);
  mock.timers.reset();
});

test("the worker hands messages to the module, and tells when it stops", async () => {
  const said = [];
  const scope = { onmessage: null, postMessage: (message) => said.push(message) };
  languageWorker(scope);
  await scope.onmessage({ data: { kind: "module", module: new Uint8Array([1, 2, 3]) } });
  await scope.onmessage({ data: { kind: "message", text: "{}" } });
  assert.equal(said[0].kind, "broken");
});

test("a text comes back from its link, to the letter", async () => {
  for (const text of ["pub A { }", "// Größe: 1 m², ∑ 🙂\n".repeat(500)]) {
    const packed = await packText(text);
    assert.match(packed, /^[\w-]*$/);
    assert.equal(await unpackText(packed), text);
  }
  for (const damaged of ["", "§§", "____", "x".repeat(2 << 20)]) assert.equal(await unpackText(damaged), null);
});

test("the name of a declaration", () => {
  assert.equal(nameOf("/// A crane.\npub Crane { }"), "Crane");
  assert.equal(nameOf("/* pub No { */ Crane {"), "Crane");
  assert.equal(nameOf("part p() {}"), null);
});
