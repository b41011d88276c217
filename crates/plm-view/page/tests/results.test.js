import assert from "node:assert/strict";
import { test } from "node:test";
import { readContents } from "../src/format.js";
import { readNpy } from "../src/npy.js";
import { readResults } from "../src/results.js";
import { givenText } from "../src/text.js";
import { packText, unpackText } from "../src/packedtext.js";
import { deflated } from "../src/write.js";
import { checkSum, inflated, readZip } from "../src/zip.js";
import { makeNpy, makeNpz, makeZip, resultsFiles } from "./support/npz.js";
import { doublePendulum, workshop } from "./support/scenes.js";

const bytesOf = (buffer) => new Uint8Array(buffer);

test("the check sum is that of the standard", () => {
  // The check value of CRC-32/ISO-HDLC in the catalogue of G. Cook.
  assert.equal(checkSum(new TextEncoder().encode("123456789")), 0xcbf43926);
});

test("what unpacks to more than there may be is refused", async () => {
  const packed = await deflated(new Uint8Array(1 << 20));
  assert.ok(packed.length < 4096);
  assert.equal((await inflated(packed, 1 << 20)).length, 1 << 20);
  await assert.rejects(inflated(packed, (1 << 20) - 1), /more than 1 GB/);
  assert.equal(await unpackText(await packText("a".repeat(1 << 23))), null);
  assert.equal(await unpackText(await packText("pub A { }")), "pub A { }");
});

test("stored, deflated, streamed and large archives are read alike", async () => {
  const files = [["a", Buffer.from("aaaaaaaaaaaaaaaaaaaaaaaa")], ["b", Buffer.from([1, 2, 3])]];
  for (const options of [{}, { how: "deflated" }, { large: true }, { how: "deflated", streamed: true }]) {
    const { entries, warnings } = await readZip(bytesOf(makeZip(files, options)));
    assert.deepEqual(warnings, []);
    assert.deepEqual(entries.map(({ name, bytes, whole }) => [name, Buffer.from(bytes), whole]), [
      ["a", files[0][1], true],
      ["b", files[1][1], true],
    ]);
  }
});

test("an archive without its table of contents is read entry by entry", async () => {
  const files = [["a", Buffer.alloc(500, 7)], ["b", Buffer.alloc(300, 9)]];
  for (const options of [{}, { how: "deflated" }, { large: true }, { how: "deflated", streamed: true }]) {
    const whole = makeZip(files, options);
    const { entries, warnings } = await readZip(bytesOf(whole.subarray(0, whole.length - 40)));
    assert.match(warnings[0], /truncated/);
    assert.deepEqual(entries.map(({ name, whole: isWhole }) => [name, isWhole]), [["a", true], ["b", true]]);
    assert.deepEqual(Buffer.from(entries[1].bytes), files[1][1]);
  }
});

test("arrays keep their numbers to the bit", () => {
  const numbers = [0.1, -0, NaN, Infinity, 5e-324, 1 / 3];
  const { shape, data, whole } = readNpy(bytesOf(makeNpy([3, 2], numbers)), "x");
  assert.deepEqual([shape, whole], [[3, 2], true]);
  numbers.forEach((number, at) => assert.ok(Object.is(data[at], number)));
  assert.deepEqual([...readNpy(bytesOf(makeNpy([2], [0.5, 3], "<f4")), "x").data], [0.5, 3]);
});

test("foreign arrays say what they are", () => {
  const array = makeNpy([2], [1, 2]);
  const change = (from, to) => bytesOf(Buffer.from(array.toString("latin1").replace(from, to), "latin1"));
  assert.throws(() => readNpy(change("<f8", "<i8"), "x.npy"), /x\.npy holds numbers of type "<i8"/);
  assert.throws(() => readNpy(change("False", "True "), "x.npy"), /C order/);
  assert.throws(() => readNpy(bytesOf(Buffer.from("hello, I am a text")), "x.npy"), /does not begin/);
  const { shape, whole } = readNpy(bytesOf(makeNpy([3, 2], [1, 2, 3, 4, 5, 6])).subarray(0, 128 + 40), "x");
  assert.deepEqual([shape, whole], [[2, 2], false]);
});

test("a results file becomes its runs", async () => {
  for (const options of [{}, { how: "deflated" }, { type: "<f4" }]) {
    const made = [doublePendulum({ name: "one", end: 1 }), doublePendulum({ name: "two", end: 2 })];
    const { runs, madeBy, warnings } = await readResults(bytesOf(makeNpz(made, options)));
    assert.deepEqual(warnings, []);
    assert.equal(madeBy, "plm test");
    assert.deepEqual(runs.map(({ name, rows, end }) => [name, rows, end]), [["one", 201, 1], ["two", 401, 2]]);
    const tolerance = options.type === "<f4" ? 1e-4 : 0;
    assert.ok(Math.abs(runs[0].values.at(100, 0) - made[0].values[400]) <= tolerance);
  }
});

test("of a truncated file the whole rows are given", async () => {
  const whole = makeNpz([workshop()]);
  const poses = resultsFiles([workshop()])[2][1].length;
  const cut = whole.subarray(0, whole.length - 25000);
  const { runs, warnings } = await readResults(bytesOf(cut));
  assert.ok(runs[0].rows > 0 && runs[0].rows <= 401, `${runs[0].rows} rows`);
  assert.ok(warnings.some((text) => text.includes("truncated")), warnings.join());
  assert.ok(warnings.some((text) => /rows are whole|is missing|cut off/.test(text)), warnings.join());
  assert.ok(poses > 25000 / 2, "the cut goes through an array");
});

test("a file cut in its first half still moves as far as it goes", async () => {
  const files = resultsFiles([workshop()]);
  const head = makeZip(files.slice(0, 2)).length;
  const cut = makeNpz([workshop()]).subarray(0, head + 50 * 6 * 6 * 8);
  const { runs, warnings } = await readResults(bytesOf(cut));
  assert.ok(runs[0].rows >= 45 && runs[0].rows <= 50, `${runs[0].rows} rows`);
  assert.ok(warnings.length > 0);
  assert.ok(Number.isNaN(runs[0].valueAt(runs[0].quantities()[0], { row: 3, share: 0 })), "missing values are gaps");
});

test("foreign files are refused in words", async () => {
  const json = (text) => makeZip([["plm.json", Buffer.from(text)]]);
  const good = JSON.parse(resultsFiles([doublePendulum({ end: 0.1 })])[0][1].toString());
  const changed = (change) => {
    const copy = structuredClone(good);
    change(copy);
    return json(JSON.stringify(copy));
  };
  for (const [bytes, expected] of [
    [Buffer.from("%PDF-1.7"), /not a results file/],
    [Buffer.alloc(0), /not a results file/],
    [makeZip([["word/document.xml", Buffer.from("x")]]), /holds no plm\.json .*word\/document\.xml/],
    [makeZip([]), /holds nothing/],
    [json("{"), /plm\.json cannot be read/],
    [json("{}"), /does not say "format"/],
    [changed((copy) => (copy.version = 2)), /version 2/],
    [changed((copy) => delete copy.runs[0].mechanism.bodies[0].mass), /runs\[0\]\.mechanism\.bodies\[0\]\.mass is missing/],
    [changed((copy) => (copy.runs[0].columns = 3)), /runs\[0\]\.columns is 3; a list/],
    [changed((copy) => (copy.runs[0].mechanism.parts[1].frames[0].body = 7)), /"elbow" joins body 7/],
    [changed((copy) => (copy.runs[0].mechanism.parts[1].frames[0].port = 9)), /port 9 of "arm"/],
  ]) {
    await assert.rejects(readResults(bytesOf(bytes)), (error) => {
      assert.match(error.message, expected);
      return true;
    });
  }
});

test("a body may have no mass", async () => {
  const copy = JSON.parse(resultsFiles([doublePendulum({ end: 0.1 })])[0][1].toString());
  const [body] = copy.runs[0].mechanism.bodies;
  // As serde writes NaN.
  [body.mass, body.inertia] = [null, null];
  const contents = readContents(Buffer.from(JSON.stringify(copy)));
  assert.ok(Number.isNaN(contents.runs[0].mechanism.bodies[0].mass));
  assert.equal(givenText(contents.runs[0].mechanism.bodies[0].inertia, "kg*m^2"), "not given");
  assert.equal(givenText(2, "kg"), "2 kg");
});

test("a damaged array is told", async () => {
  const bytes = makeNpz([doublePendulum({ end: 0.5 })]);
  const at = bytes.indexOf("0/values.npy") + 400;
  bytes[at] ^= 255;
  const { warnings, runs } = await readResults(bytesOf(bytes));
  assert.deepEqual(warnings, ["0/values.npy is damaged or cut off."]);
  assert.equal(runs[0].rows, 101);
});
