// The page as a whole: it opens, tells what is wrong with a file, fits its window, can be used without a mouse.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { makeNpz } from "../tests/support/npz.js";
import { doublePendulum, headOf, workshop } from "../tests/support/scenes.js";
import { BODIES, drawn, middleOf, open, openedIn, settle, shot, skip, state, until, writePage, writeRuns } from "./support/browser.js";
import { press } from "./support/commands.js";

const fault = { time: 2, part: "rocker_pin", text: "the mechanism cannot be assembled: the loop of coupler and rocker stays open by 3.2 mm" };

const addresses = skip ? {} : {
  pendulum: writePage("pendulum", makeNpz([doublePendulum()], { type: "<f4" }), "<Double> & pendulum"),
  workshop: writeRuns("everything", [workshop()]),
  fault: writeRuns("fault", [workshop({ end: 2, gap: true, fault })]),
  batch: writeRuns("masses", [5, 10, 20].map((mass) => doublePendulum({ name: `mass = ${mass} kg`, mass, end: 2 }))),
  empty: writePage("empty", Buffer.alloc(0)),
};

/** Drops bytes on the page as a file. */
async function drop(page, bytes, name = "dropped.npz") {
  const transfer = await page.evaluateHandle(
    ([data, title]) => {
      const held = new DataTransfer();
      held.items.add(new File([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], title));
      return held;
    },
    [Buffer.from(bytes).toString("base64"), name],
  );
  await page.dispatchEvent("#stage", "dragover", { dataTransfer: transfer });
  await page.dispatchEvent("#stage", "drop", { dataTransfer: transfer });
}

test("it opens with one request and no error, and draws, in under a second", { skip }, async () => {
  for (const name of ["pendulum", "workshop", "fault", "batch"]) {
    const { page, requests, errors } = await open(addresses[name]);
    assert.deepEqual([requests, errors], [[addresses[name]], []], name);
    const { bodies, ink } = await drawn(page, "#picture", { bodies: BODIES });
    assert.ok(bodies > 1500 && ink > 3000, `${name}: ${ink}`);
    const ready = await openedIn(addresses[name]);
    assert.ok(ready < 1000, `${name} is drawn after ${ready} ms`);
  }
});

test("the pages are small", { skip }, () => {
  const size = readFileSync(fileURLToPath(addresses.pendulum)).length;
  assert.ok(size < 250_000, `${size} bytes for 4 s at 200 Hz`);
});

test("names are shown as they are", { skip }, async () => {
  const { page } = await open(addresses.pendulum);
  assert.equal(await page.title(), "<Double> & pendulum");
  assert.equal(await page.textContent("h1"), "<Double> & pendulum");
  const nasty = "<img src=x onerror=alert(1)>";
  const head = headOf({ name: nasty, doc: nasty, bodies: [{ name: nasty, mass: 1, inertia: 1, depth: 0, ports: [], contour: null }] }, { name: nasty });
  await drop(page, makeNpz([{ head, time: [0, 1], poses: [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0], values: [] }]));
  await page.waitForFunction((name) => window.plmPage.app.run?.name === name, nasty);
  for (const tab of ["objects", "runs", "model", "curves"]) {
    await page.click(`#tab-${tab}`);
    await settle(page);
    assert.equal(await page.locator("img").count(), 0, tab);
  }
});

test("a page without results waits for a file, and shows one that is dropped", { skip }, async () => {
  const { page, errors } = await open(addresses.empty);
  assert.ok(await page.isVisible("#empty"));
  assert.equal((await drawn(page)).ink, 0);
  await drop(page, makeNpz([workshop()], { how: "deflated" }));
  await page.waitForFunction(() => window.plmPage.app.run !== null);
  await settle(page);
  assert.ok((await drawn(page)).ink > 5000);
  assert.ok(!(await page.isVisible("#empty")));
  assert.equal(await page.title(), "dropped.npz");
  assert.deepEqual(errors, []);
});

test("a foreign file is refused in words, and what was shown stays", { skip }, async () => {
  const { page, errors } = await open(addresses.workshop);
  const before = await drawn(page);
  await drop(page, Buffer.from("%PDF-1.7 nothing of ours"), "paper.pdf");
  await page.waitForSelector("[role=alert]");
  assert.match(await page.textContent("[role=alert]"), /not a results file/);
  await settle(page);
  assert.equal((await drawn(page)).hash, before.hash);
  await page.click("[role=alert] button");
  await settle(page);
  assert.equal(await page.locator("[role=alert]").count(), 0);
  assert.deepEqual(errors, []);
});

test("of a truncated file what is whole is shown", { skip }, async () => {
  const { page } = await open(addresses.empty);
  const whole = makeNpz([workshop()]);
  await drop(page, whole.subarray(0, Math.round(0.6 * whole.length)));
  await page.waitForFunction(() => window.plmPage.app.run !== null);
  await settle(page);
  assert.match(await page.textContent("#messages"), /truncated/);
  const rows = await state(page, "app.run.rows");
  assert.ok(rows > 50 && rows < 401, `${rows} rows`);
  assert.ok((await drawn(page)).ink > 5000);
});

test("a run that faulted shows everything up to the fault, and the fault", { skip }, async () => {
  const { page } = await open(addresses.fault);
  assert.match(await page.textContent("#messages"), /ended at 2\.000 s: rocker_pin: the mechanism cannot be assembled/);
  const RED = [198, 40, 40];
  const before = await drawn(page, "#picture", { fault: RED });
  await page.keyboard.press("End");
  await settle(page);
  const after = await drawn(page, "#picture", { fault: RED });
  assert.ok(after.fault > before.fault + 30, `a ring around the part: ${before.fault}, ${after.fault}`);
  assert.ok((await drawn(page, "#marks", { fault: RED })).fault > 10, "a mark on the time line");
  await page.keyboard.press("Home");
  await page.click("#tab-runs");
  await page.click("text=Go there");
  assert.equal(await state(page, "app.player.time"), 2);
});

test("the time line is dragged, and moved by keys", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  const box = await page.locator("#time").boundingBox();
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
  await settle(page);
  const time = await state(page, "app.player.time");
  assert.ok(Math.abs(time - 1) < 0.05, `${time}`);
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await state(page, "app.player.time")) - time - 0.05) < 1e-9);
  assert.match(await page.getAttribute("#time", "aria-valuetext"), /s$/);
});

test("paths of points", { skip }, async () => {
  const PURPLE = [123, 31, 162];
  const { page: usual } = await open(addresses.pendulum, { hash: "#t=2" });
  assert.deepEqual(await state(usual, "app.traces"), ["forearm.tip"], "one is drawn");
  assert.ok((await drawn(usual, "#picture", { path: PURPLE })).path > 100);
  const { page } = await open(addresses.pendulum, { hash: "#select=body:1&tab=objects&t=2&paths=" });
  assert.equal((await drawn(page, "#picture", { path: PURPLE })).path, 0);
  await page.check("[aria-label='Path of forearm.tip']");
  await settle(page);
  assert.ok((await drawn(page, "#picture", { path: PURPLE })).path > 100);
});

test("the address keeps what is shown, and a link shows it", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  await press(page, "isometric");
  await page.keyboard.press("ArrowRight");
  await press(page, "forces");
  await page.waitForFunction(() => location.hash.includes("forces=1") && location.hash.includes("t=0.05"));
  const hash = await page.evaluate(() => location.hash);
  const before = await drawn(page);
  const { page: again } = await open(addresses.workshop, { hash });
  const after = await drawn(again);
  // The address has seven digits of the view: edges may be smoothed a little differently.
  assert.ok(Math.abs(after.ink - before.ink) < 0.005 * before.ink, `${before.ink} ${after.ink}`);
  assert.equal(await state(again, "app.view.azimuth"), -45);
});

test("narrow and wide, light and dark, everything has its place", { skip }, async () => {
  const views = { front: "", isometric: "&view=-45,35.26439,230,0.8,0.3,0" };
  for (const [name, hash] of [["pendulum", "#t=0.4"], ["workshop", "#t=0.6&forces=1"], ["batch", "#t=1&layout=overlay&tab=runs"], ["fault", "#t=2&select=body:2&tab=objects"]]) {
    for (const [width, height] of [[1200, 800], [800, 600], [400, 800]]) {
      for (const theme of ["light", "dark"]) {
        const { page, errors } = await open(addresses[name], { width, height, theme, hash });
        const where = `${name} ${width} ${theme}`;
        const { ink, back } = await drawn(page);
        assert.ok(ink > 1500, `${where}: ${ink}`);
        assert.equal(back[0] < 60, theme === "dark", where);
        const outside = await page.evaluate(() => {
          const limit = document.documentElement.clientWidth;
          const wrong = [...document.querySelectorAll("button, select, input, h1, h2, td, th, canvas, p, li")]
            .filter((each) => each.checkVisibility() && each.className !== "spoken")
            .filter((each) => each.getBoundingClientRect().right > limit + 0.5 || each.getBoundingClientRect().left < -0.5);
          return [...wrong.map((each) => each.outerHTML.slice(0, 80)), ...(document.documentElement.scrollWidth > limit ? ["the page scrolls sideways"] : [])];
        });
        assert.deepEqual(outside, [], where);
        const [stage, footer] = await page.evaluate(() => ["#stage", "footer"].map((name) => document.querySelector(name).clientHeight));
        assert.ok(stage > 0.3 * height && footer < 90, `${where}: picture ${stage}, foot ${footer}`);
        assert.deepEqual(errors, [], where);
        await shot(page, `${name}-${width}-${theme}`);
      }
    }
  }
  const { page } = await open(addresses.workshop, { hash: `#t=0.6${views.isometric}` });
  await shot(page, "workshop-isometric");
});

test("it follows its window", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  for (const [width, height] of [[700, 500], [1500, 900]]) {
    await page.setViewportSize({ width, height });
    await settle(page);
    const { canvas, stage } = await page.evaluate(() => ({
      canvas: document.querySelector("#picture").width,
      stage: document.querySelector("#stage").clientWidth,
    }));
    assert.equal(canvas, stage);
    await page.keyboard.press("x");
    await settle(page);
    const { x, y, count } = await middleOf(page, BODIES);
    assert.ok(count > 500 && x > 0 && x < stage && y > 0 && y < height, `${width}: ${x} ${y}`);
  }
});

test("a tab is shown as its key is pressed, before the next frame", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  const shown = await page.evaluate(() => {
    const key = new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true });
    document.querySelector("#tab-curves").dispatchEvent(key);
    const focused = document.activeElement;
    return { focused: focused.id, tabIndex: focused.tabIndex, sheets: [...document.querySelectorAll("[role=tabpanel]")].filter((each) => !each.hidden).map(({ id }) => id) };
  });
  assert.deepEqual(shown, { focused: "tab-objects", tabIndex: 0, sheets: ["sheet-objects"] });
});

test("everything has a role and a name, and Tab reaches it", { skip }, async () => {
  const { page } = await open(addresses.workshop, { hash: "#select=body:1&tab=objects" });
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, canvas, [role]")]
      .filter((each) => each.checkVisibility() && each.getAttribute("aria-hidden") !== "true")
      .filter((each) => !["status", "tablist", "tabpanel"].includes(each.getAttribute("role")))
      .filter((each) => !(each.getAttribute("aria-label") || each.labels?.length || each.textContent.trim()))
      .map((each) => each.outerHTML.slice(0, 100)),
  );
  assert.deepEqual(nameless, []);
  for (const [role, name] of [["button", "Play"], ["toolbar", "Time"], ["toolbar", "Tools"], ["button", "Forces"], ["slider", "Time"], ["tab", "Objects"], ["listbox", "Objects"], ["img", "Picture of Workshop, run run"], ["combobox", "Speed"]]) {
    assert.ok((await page.getByRole(role, { name, exact: true }).count()) > 0, `${role} ${name}`);
  }
  const reached = new Set();
  let before = 0;
  for (let stop = 1; stop < 60; stop++) {
    await page.keyboard.press("Tab");
    const id = await page.evaluate(() => document.activeElement.id);
    if (id === "picture" && !reached.has(id)) before = stop;
    reached.add(id);
  }
  assert.equal(before, 2, "one stop before the picture");
  for (const id of ["do-forces", "picture", "tab-objects", "do-start", "time", "speed", "arrows"]) {
    assert.ok(reached.has(id), `${id} is not reached by Tab`);
  }
  // The other buttons of a toolbar are reached by arrow keys, and what is in the menu too.
  await page.focus("#do-forces");
  const along = [];
  for (let press = 0; press < 6; press++) {
    along.push(await page.evaluate(() => document.activeElement.id));
    await page.keyboard.press("ArrowRight");
  }
  assert.deepEqual(along, ["do-forces", "do-velocities", "do-extents", "do-png", "do-panel", "do-menu"]);
  await page.keyboard.press("End");
  await page.keyboard.press("Enter");
  const items = await page.evaluate(() => document.querySelectorAll("#menu [role^=menuitem]").length);
  const chosen = new Set();
  for (let press = 0; press < items; press++) {
    chosen.add(await page.evaluate(() => document.activeElement.id));
    await page.keyboard.press("ArrowDown");
  }
  assert.ok(chosen.size === items && chosen.has("do-isometric"), `${chosen.size} of ${items}`);
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => document.activeElement.id), "do-menu");
  // The objects are chosen in their list by keys.
  await page.getByRole("listbox", { name: "Objects" }).focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await settle(page);
  assert.match(await page.textContent("#spoken"), /rocker/);
  await page.getByRole("tab", { name: "Objects" }).focus();
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.ok(await page.isVisible("#sheet-runs"));
});

test("letters in a field are text", { skip }, async () => {
  const { page } = await open(addresses.workshop);
  await page.click(".picker summary");
  await page.click("input[type=search]");
  await page.keyboard.type("reno");
  await settle(page);
  assert.equal(await page.inputValue("input[type=search]"), "reno");
  assert.ok(await state(page, "app.run !== null && !app.player.isPlaying && app.player.time === 0"));
});

test("a live run grows on the page", { skip }, async () => {
  const { page, errors } = await open(addresses.pendulum);
  await page.evaluate(() => {
    const { app } = window.plmPage;
    const recorded = app.run;
    const Run = recorded.constructor;
    const live = Run.empty({ ...recorded.head, name: "live", events: [], fault: null });
    live.isLive = true;
    app.showRuns([live]);
    app.player.isFollowing = true;
    window.feed = (from, to) => {
      for (let row = from; row < to; row++) {
        live.append(recorded.time.data[row], recorded.poses.data.slice(12 * row, 12 * row + 12), recorded.values.data.slice(4 * row, 4 * row + 4));
      }
      app.rowsAppended(live);
    };
    window.feed(0, 50);
    app.zoomToExtents();
  });
  await settle(page);
  const before = await drawn(page);
  await page.evaluate(() => window.feed(50, 401));
  await until(page, async () => (await state(page, "app.player.time")) > 1.99, "the picture follows");
  await settle(page);
  const after = await drawn(page);
  assert.ok(before.ink > 500 && after.ink > 500 && before.hash !== after.hash);
  assert.ok(Math.abs((await state(page, "app.player.time")) - 2) < 1e-6);
  await until(page, async () => (await drawn(page, "figure > canvas")).ink > 500, "its curves are drawn");
  assert.deepEqual(errors, []);
});
