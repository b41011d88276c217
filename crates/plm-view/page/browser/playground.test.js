// The playground: what is typed moves, and what is wrong is told where it is wrong.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { test } from "node:test";
import { unpackText } from "../src/packedtext.js";
import { readZip } from "../src/zip.js";
import { open, openedIn, shot, state, until } from "./support/browser.js";
import { PENDULUM, address, file, playground, problems, skip, type, typed } from "./support/playground.js";

const nameShown = (page) => state(page, "app.live.mechanism.name");
const shows = (page, name) => page.waitForFunction((to) => window.plmPage.app.live.mechanism.name === to && window.plmPage.app.live.run.rows > 3, name);

test("it is one file, asks nothing of a network, and moves in a second", { skip }, async () => {
  const { size } = statSync(file);
  console.log(`playground of ${size} bytes`);
  assert.ok(size < 1_400_000, `${size} bytes`);
  assert.ok(!readFileSync(file, "utf8").includes("https://cdn"));
  assert.ok((await openedIn(address)) < 1000);
  const { page, requests, errors } = await playground();
  assert.deepEqual(requests.filter((each) => !each.startsWith(address) && !each.startsWith("blob:")), []);
  assert.equal(await nameShown(page), "FourBar");
  const time = await state(page, "app.live.run.end");
  await until(page, async () => (await state(page, "app.live.run.end")) > time + 0.2, "it moves");
  await page.waitForFunction(() => document.querySelector("#editor-state").textContent === "Nothing is wrong.");
  assert.deepEqual(errors, []);
  await shot(page, "playground");
});

test("what is typed moves, and another parameter too", { skip }, async () => {
  const { page, errors } = await playground(PENDULUM);
  assert.deepEqual([await nameShown(page), await typed(page)], ["Pendulum", PENDULUM]);
  const end = PENDULUM.indexOf("1 m;");
  await page.evaluate((at) => window.plmPlay.pane.editor.view.dispatch({ selection: { anchor: at, head: at + 1 } }), end);
  await page.locator(".cm-content").focus();
  await page.keyboard.type("2");
  assert.match(await typed(page), /length: m = 2 m/);
  await page.waitForFunction(() => window.plmPage.app.live.mechanism.parameters[0].default === 2);
  await until(page, async () => (await state(page, "app.live.run.rows")) > 3, "it goes on");
  // Undone, as everything that is typed.
  await page.keyboard.press("Control+Z");
  await page.waitForFunction(() => window.plmPage.app.live.mechanism.parameters[0].default === 1);
  assert.deepEqual(errors, []);
});

test("a mistake is told where it is, with what mends it, and the last good text goes on", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  await type(page, PENDULUM.replace("revolute", "revolut"));
  await until(page, async () => (await problems(page)).length > 0, "it is told");
  const [told] = await problems(page);
  assert.equal(await page.locator("#problems li a").count(), 0);
  assert.match(told, /^6: .*revolut.*E0\d{3}/);
  assert.equal(await page.locator(".cm-lintRange-error").count() > 0, true);
  assert.match(await page.locator("#editor-state").textContent(), /1 error: the last text without an error moves/);
  const time = await state(page, "app.live.run.end");
  await until(page, async () => (await state(page, "app.live.run.end")) > time + 0.1, "it goes on");
  await shot(page, "playground-error");
  const fix = page.locator("#problems li button:not(.plain)").first();
  await fix.waitFor();
  await fix.click();
  assert.equal(await typed(page), PENDULUM);
  await page.waitForFunction(() => document.querySelector("#editor-state").textContent === "Nothing is wrong.");
});

test("beside a book, codes lead to their pages", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  await page.evaluate(() => document.body.insertAdjacentHTML("beforeend", '<script type="text/plain" id="book">./</script>'));
  await type(page, PENDULUM.replace("revolute", "revolut"));
  const link = page.locator("#problems li a");
  await link.waitFor();
  assert.match(await link.getAttribute("href"), /^\.\/diagnostics\/E0\d{3}\.html$/);
});

test("what is typed is taken home as a package, and the commands are told", { skip }, async () => {
  const { page, errors } = await playground(PENDULUM);
  await page.click("#editor-home");
  const commands = await page.locator("dialog code").allTextContents();
  for (const option of ["--c", "--fmu", "--python"]) assert.ok(commands.includes(`plm export pendulum.plm ${option} pendulum`), commands.join("\n"));
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#home-crate")]);
  assert.equal(download.suggestedFilename(), "pendulum.zip");
  const { entries } = await readZip(new Uint8Array(readFileSync(await download.path())));
  const files = new Map(entries.map(({ name, bytes }) => [name, bytes]));
  const main = new TextDecoder().decode(files.get("pendulum/src/main.rs"));
  assert.ok(main.includes(PENDULUM.trim().replaceAll(/^/gm, "    ")) && main.includes("Program::new(Pendulum::new())"), main);
  assert.ok(files.has("pendulum/Cargo.toml"));
  for (const [button, file, entry] of [
    ["#home-c", "pendulum_c.zip", "pendulum/pendulum.h"],
    ["#home-fmi3", "pendulum.fmu", "sources/buildDescription.xml"],
    ["#home-fmi2", "pendulum.fmu", "modelDescription.xml"],
    ["#home-dxf", "Pendulum_links_dxf.zip", "Pendulum_links/sheet.dxf"],
    ["#home-svg", "Pendulum_links_svg.zip", "Pendulum_links/sheet.svg"],
  ]) {
    const [source] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    assert.equal(source.suggestedFilename(), file);
    const names = (await readZip(new Uint8Array(readFileSync(await source.path())))).entries.map(({ name }) => name);
    assert.ok(names.includes(entry), names.join(" "));
  }
  assert.deepEqual(errors, []);
});

test("words are completed, values are shown, and the layout is one", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  const at = PENDULUM.indexOf("hinge.force") + "hinge.".length;
  await page.evaluate((to) => window.plmPlay.pane.editor.view.dispatch({ changes: { from: to, to: to + 5 }, selection: { anchor: to } }), at);
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+Space");
  const offers = page.locator(".cm-tooltip-autocomplete li");
  await offers.first().waitFor();
  assert.ok((await offers.allTextContents()).some((text) => text.startsWith("force")));
  await page.keyboard.type("forc");
  await page.waitForFunction(() => document.querySelectorAll(".cm-tooltip-autocomplete li").length < 4);
  await page.waitForTimeout(100);
  await page.keyboard.press("Enter");
  assert.equal(await typed(page), PENDULUM);
  await page.locator(".cm-line", { hasText: "param length" }).locator("span", { hasText: "length" }).first().hover();
  await page.locator(".editor-hover").waitFor();
  assert.match(await page.locator(".editor-hover").textContent(), /1 m/);
  await page.mouse.move(5, 5);
  await type(page, PENDULUM.replaceAll("    ", "  "));
  await page.click("#editor-format");
  await until(page, async () => (await typed(page)) === PENDULUM || (await typed(page)).includes("    param"), "it has its layout");
});

test("a link holds the text, and what is turned stays turned", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  await page.evaluate(() => window.plmPage.app.live.set("parameter", 0, 1.5));
  const other = PENDULUM.replace("0.01 kg*m^2", "0.02 kg*m^2");
  await type(page, other);
  await page.waitForFunction(() => window.plmPage.app.live.mechanism.bodies[0].inertia === 0.02);
  assert.equal(await state(page, "app.live.settings.parameter[0]"), 1.5);
  const hash = () => page.evaluate(() => location.hash);
  const linked = async () => unpackText(new URLSearchParams((await hash()).slice(1)).get("text") ?? "");
  await until(page, async () => (await linked()) === other, "the address has the text");
  const link = await hash();
  const again = await open(address, { plays: true, hash: link });
  assert.match(await typed(again.page), /0\.02 kg\*m\^2/);
  await shows(again.page, "Pendulum");
});

test("every machine to begin with is one", { skip }, async () => {
  const { page, errors } = await playground();
  const count = await page.locator("#gallery option").count();
  assert.ok(count > 8);
  for (let index = 0; index < count - 1; index++) {
    const shown = await page.evaluate(() => window.plmPlay.exchange.count);
    await page.selectOption("#gallery", String(index));
    await page.waitForFunction((before) => window.plmPlay.exchange.count > before && window.plmPage.app.live.run.rows > 3, shown);
    assert.equal(await page.locator("#problems li.error").count(), 0);
  }
  assert.deepEqual(errors, []);
});

test("a text that is large, deep or wrong in every line never stops the page", { skip }, async () => {
  const { page } = await playground(PENDULUM);
  const deep = `pub Deep { param a: 1 = ${"(".repeat(20_000)}1${")".repeat(20_000)}; }`;
  const large = `pub Large { ground { port o: (0, 0) m; } repeat k in 0..100000 { body b[k] { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; } revolute r[k](ground.o, b[k].o); } }`;
  const wrong = "revolut a(b, c);\n".repeat(20_000);
  for (const text of [deep, large, wrong]) {
    await type(page, text);
    const time = await state(page, "app.live.run.end");
    // It goes on to move, and answers to keys.
    await until(page, async () => (await state(page, "app.live.run.end")) > time + 0.2, "it goes on");
    await until(page, async () => (await problems(page)).length > 0, "something is told");
  }
  await type(page, PENDULUM.replace("Pendulum", "Other"));
  await shows(page, "Other");
});

test("diagnostics and the motion follow each key", { skip }, async () => {
  const { page } = await playground();
  const times = await page.evaluate(async () => {
    const { pane, exchange } = window.plmPlay;
    const text = pane.editor.text();
    const [told, moved] = [[], []];
    for (let at = 0; at < 20; at++) {
      const began = performance.now();
      const answered = new Promise((resolve) => {
        const show = pane.language.show;
        pane.language.show = (...found) => ((pane.language.show = show), show(...found), resolve());
      });
      const { count } = exchange;
      pane.editor.replace(text.replace("1 kg", `${1 + at / 100} kg`));
      await answered;
      told.push(performance.now() - began);
      while (exchange.count === count) await new Promise((resolve) => setTimeout(resolve, 2));
      moved.push(performance.now() - began);
    }
    const high = (list) => list.sort((a, b) => a - b)[Math.floor(0.95 * (list.length - 1))];
    return [high(told), high(moved)];
  });
  console.log(`p95: diagnostics after ${times[0].toFixed(0)} ms, another motion after ${times[1].toFixed(0)} ms`);
  // Other programs may keep the machine busy: what has become several times slower is told all the same.
  assert.ok(times[0] < 200 && times[1] < 800, String(times));
});

test("wide, narrow and on a phone, light and dark", { skip }, async () => {
  for (const [width, height] of [[1440, 900], [800, 1000], [390, 844]]) {
    for (const theme of /** @type {const} */ (["light", "dark"])) {
      const { page, errors } = await playground(PENDULUM, { width, height, theme });
      const boxes = await page.evaluate(() => ["#editor", "#stage", "#panel"].map((id) => document.querySelector(id).getBoundingClientRect().toJSON()));
      for (const box of boxes) assert.ok(box.width > 200 && box.height > 80 && box.right <= width + 1 && box.bottom <= height + 1, JSON.stringify({ width, box }));
      assert.deepEqual(errors, []);
      await shot(page, `playground-${width}-${theme}`);
    }
  }
});
