// The npm package as it is packed, unpacked into an empty folder and served as static files: pages of others with `<plm-mechanism>`.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { shot, skip as withoutBrowser, theBrowser } from "./support/browser.js";

const file = process.env["PLM_ELEMENT"] ?? "";
const skip = withoutBrowser || (existsSync(file) ? false : "skipped: there is no package; `bash examples/playground/npm.sh --check` makes and tries it");

/** A crank that is turned: its angle at a time is known. */
const CRANK = `pub Crank {
    param speed: rad/s = 2 rad/s;
    ground { port o: (0, 0) mm; }
    body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-50, 0) mm; }
    revolute pin(ground.o, crank.o);
    constraint motor: crank.angle = speed*t;
    output turned = crank.angle;
}
`;
/** With a sign that HTML takes for the beginning of a tag. */
const LESS = CRANK.replace("output turned", "param limit: s = 100 s;\n    output early = if t<limit then 1 else 0;\n    output turned");
const WRONG = CRANK.replace("revolute", "revolut");

const folder = mkdtempSync(join(tmpdir(), "plm-element-"));
const KINDS = { ".html": "text/html", ".js": "text/javascript", ".plm": "text/plain" };
let address = "";
const server = createServer((request, response) => {
  const path = join(folder, new URL(request.url ?? "", "http://host").pathname);
  if (!path.startsWith(folder) || !existsSync(path) || !statSync(path).isFile()) response.writeHead(404).end();
  // Of a module of WebAssembly many servers do not know the kind.
  else response.writeHead(200, { "Content-Type": KINDS[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
});

before(async () => {
  if (skip) return;
  execFileSync("tar", ["-xzf", file, "-C", folder]);
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(null)));
  address = `http://127.0.0.1:${server.address().port}`;
});
after(() => server.close());

const SCRIPT = '<script type="module" src="package/plm-mechanism.js"></script>';
let pages = 0;

/** A page of others, with what was asked for and what went wrong. */
async function pageWith(body, { width = 800, head = "", theme = "light", still = false, touch = false, script = SCRIPT } = {}) {
  pages += 1;
  writeFileSync(join(folder, `page${pages}.html`), `<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width"><link rel="icon" href="data:,">${head}${script}<body>${body}`);
  const page = await (await theBrowser()).newPage({ viewport: { width, height: 700 }, hasTouch: touch, colorScheme: theme, reducedMotion: still ? "reduce" : "no-preference" });
  const [requests, errors] = [[], []];
  page.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => errors.push(String(error.stack ?? error)));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await page.goto(`${address}/page${pages}.html`);
  return { page, requests, errors };
}

const ofElement = (page, read, at = 0) => page.evaluate(`((mechanism) => ${read})(document.querySelectorAll("plm-mechanism")[${at}])`);
/** Until something holds; before there is a mechanism nothing holds of its values. */
const holds = (page, what, at = 0) =>
  page.waitForFunction(`((mechanism) => { try { return ${what}; } catch { return false; } })(document.querySelectorAll("plm-mechanism")[${at}])`);
const moves = async (page, at = 0) => {
  await holds(page, "mechanism.time > 0", at);
  const time = await ofElement(page, "mechanism.time", at);
  await holds(page, `mechanism.time > ${time + 0.1}`, at);
};
const inside = (id) => `mechanism.shadowRoot.querySelector("#${id}")`;

test("the package has its files, and is below 2 MB", { skip }, () => {
  const { size } = statSync(file);
  console.log(`package of ${size} bytes`);
  assert.ok(size < 2_000_000, `${size} bytes`);
  const names = execFileSync("tar", ["-tzf", file], { encoding: "utf8" }).trim().split("\n").sort();
  const expected = ["LICENSE-APACHE", "LICENSE-MIT", "README.md", "package.json", "plm-mechanism.d.ts", "plm-mechanism.js", "plm.wasm"];
  assert.deepEqual(names, expected.map((name) => `package/${name}`).sort());
});

test("its types are those of a program in TypeScript", { skip }, () => {
  const use = `import type { PlmMechanism } from "./package/plm-mechanism.js";
const found = document.querySelector("plm-mechanism");
if (found !== null) {
  const same: PlmMechanism = found;
  same.set("speed", 2);
  const angle: number = same.value("crank.angle");
  found.addEventListener("plm-error", ({ detail }) => console.log(detail.message.length, angle));
  // @ts-expect-error there is no such method
  found.fly();
}
`;
  writeFileSync(join(folder, "use.ts"), use);
  const tsc = fileURLToPath(new URL("../node_modules/.bin/tsc", import.meta.url));
  execFileSync(tsc, ["--noEmit", "--strict", "--target", "es2022", "--module", "es2022", "--moduleResolution", "bundler", "use.ts"], { cwd: folder, stdio: "inherit" });
});

test("a declaration in the element moves as it says", { skip }, async () => {
  const { page, requests, errors } = await pageWith(`<p>Text</p><plm-mechanism height="240">${CRANK}</plm-mechanism>`);
  await moves(page);
  await ofElement(page, "mechanism.pause()");
  await holds(page, "!mechanism.isPlaying");
  const [time, turned] = await ofElement(page, '[mechanism.time, mechanism.value("turned")]');
  assert.ok(time > 0.1 && Math.abs(turned - 2 * time) < 1e-9, `${turned} rad after ${time} s`);
  assert.equal(await ofElement(page, `${inside("stage")}.clientHeight`), 240);
  // The crank is drawn, in the colour of the first body.
  const blue = await ofElement(page, `(() => {
    const canvas = ${inside("picture")};
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let at = 0; at < data.length; at += 4) if (Math.abs(data[at] - 108) + Math.abs(data[at + 1] - 158) + Math.abs(data[at + 2] - 224) < 24) count++;
    return count;
  })()`);
  assert.ok(blue > 500, `${blue} pixels`);
  assert.deepEqual(requests.filter((each) => !each.startsWith(address) && !each.startsWith("blob:")), []);
  assert.deepEqual(errors, []);
  await shot(page, "element");
  await page.close();
});

test("the page of the readme and of the book moves as it stands there", { skip }, async () => {
  const pageOf = (text) => /```html\n([^]*?)```/.exec(text)[1];
  const example = pageOf(readFileSync(join(folder, "package/README.md"), "utf8"));
  assert.equal(pageOf(readFileSync(new URL("../../../../docs/src/running/element.md", import.meta.url), "utf8")), example);
  const { page, errors } = await pageWith(example, { script: "" });
  await moves(page);
  assert.equal(await ofElement(page, 'mechanism.value("length")'), 1);
  assert.deepEqual(errors, []);
  await page.close();
});

test("controls turn parameters, and two elements are two machines", { skip }, async () => {
  const { page, requests, errors } = await pageWith(`<plm-mechanism controls>${CRANK}</plm-mechanism><plm-mechanism paused>${CRANK}</plm-mechanism>`);
  await moves(page);
  await holds(page, 'mechanism.value("turned") === 0', 1);
  assert.equal(await ofElement(page, "mechanism.isPlaying || mechanism.time > 0", 1), false);
  await page.locator("plm-mechanism #sliders summary").first().click();
  await page.locator("plm-mechanism #parameter-0").first().fill("3");
  await page.keyboard.press("Enter");
  await holds(page, 'mechanism.value("speed") === 3');
  assert.equal(await ofElement(page, 'mechanism.value("speed")', 1), 2);
  await shot(page, "element-controls");
  await page.locator("plm-mechanism #go").first().click();
  await holds(page, "!mechanism.isPlaying");
  await page.locator("plm-mechanism #restart").first().click();
  await holds(page, "mechanism.time === 0");
  await ofElement(page, 'mechanism.set("speed", -1)');
  await holds(page, 'mechanism.value("speed") === -1');
  await assert.rejects(ofElement(page, 'mechanism.set("sped", 1)'), /there is no parameter or input sped/);
  await assert.rejects(ofElement(page, 'mechanism.value("sped")'), /there is no quantity sped/);
  // The compiler is fetched once.
  assert.equal(requests.filter((each) => each.endsWith("plm.wasm")).length, 1);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a mistake has its diagnostics in the place of the picture, and is mended by another text", { skip }, async () => {
  const { page, errors } = await pageWith(`<script>addEventListener("plm-error", ({ detail }) => (window.heard = detail.message));</script><plm-mechanism>${WRONG}</plm-mechanism>`);
  await holds(page, `!${inside("problems")}.hidden`);
  const told = await ofElement(page, `${inside("problems")}.textContent`);
  assert.match(told, /error\[E0\d{3}\].*revolut/);
  assert.match(told, /:5:5/);
  assert.equal(await ofElement(page, `${inside("stage")}.hidden`), true);
  assert.equal(await page.evaluate(() => window.heard), told);
  await shot(page, "element-error");
  await ofElement(page, `mechanism.declaration = ${JSON.stringify(CRANK)}`);
  await moves(page);
  assert.deepEqual(await ofElement(page, `[${inside("problems")}.hidden, ${inside("stage")}.hidden]`), [true, false]);
  // The last good one stays over a later mistake.
  await ofElement(page, `mechanism.textContent = ${JSON.stringify(WRONG)}`);
  await holds(page, `!${inside("problems")}.hidden`);
  assert.equal(await ofElement(page, `${inside("stage")}.hidden`), false);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a file is named, a script holds every character, and what is missing is told", { skip }, async () => {
  writeFileSync(join(folder, "crank.plm"), CRANK);
  const { page } = await pageWith(
    `<plm-mechanism height="100" src="crank.plm"></plm-mechanism><plm-mechanism height="100"><script type="text/plm">${LESS}</script></plm-mechanism>` +
      '<plm-mechanism height="100" src="none.plm"></plm-mechanism><plm-mechanism height="100"></plm-mechanism>',
  );
  await moves(page, 0);
  await moves(page, 1);
  await holds(page, `${inside("problems")}.textContent.includes("none.plm cannot be read: 404")`, 2);
  await holds(page, `${inside("problems")}.textContent.startsWith("There is no declaration")`, 3);
  await page.close();
});

test("what is out of sight stands, and ends with the element", { skip }, async () => {
  const { page, errors } = await pageWith(`<plm-mechanism>${CRANK}</plm-mechanism><div style="height: 4000px"></div><plm-mechanism>${CRANK}</plm-mechanism>`);
  await moves(page);
  assert.equal(page.workers().length, 1);
  await page.evaluate(() => scrollTo(0, 4500));
  await moves(page, 1);
  assert.equal(await ofElement(page, "mechanism.isPlaying"), false);
  await page.evaluate(() => scrollTo(0, 0));
  await moves(page);
  // A text that came meanwhile is there when it is seen.
  await ofElement(page, `mechanism.declaration = ${JSON.stringify(CRANK.replace("= 2 rad/s", "= 5 rad/s"))}`, 1);
  await page.waitForTimeout(300);
  assert.equal(await ofElement(page, 'mechanism.value("speed")', 1), 2);
  await page.evaluate(() => scrollTo(0, 4500));
  await holds(page, 'mechanism.value("speed") === 5', 1);
  await page.evaluate(() => document.querySelectorAll("plm-mechanism").forEach((each) => each.remove()));
  await page.waitForFunction(() => document.querySelector("plm-mechanism") === null);
  for (let left = 100; page.workers().length > 0 && left > 0; left--) await page.waitForTimeout(50);
  assert.equal(page.workers().length, 0);
  assert.deepEqual(errors, []);
  await page.close();
});

/** A pendulum that hangs at rest. */
const HANGING = `pub Hanging {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 0 deg, locked; }
    revolute hinge(ground.o, bob.pivot);
}
`;

test("wheel and fingers scroll the page over it, and a finger on a body pulls that", { skip }, async () => {
  const { page, errors } = await pageWith(`<plm-mechanism>${HANGING}</plm-mechanism><div style="height: 3000px"></div>`, { width: 390, touch: true });
  await moves(page);
  assert.equal(await ofElement(page, 'mechanism.value("bob.angle")'), 0);
  const { x, y, width, height } = await page.locator("plm-mechanism #picture").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => scrollY > 60);
  await page.evaluate(() => scrollTo(0, 0));
  const session = await page.context().newCDPSession(page);
  const drag = async (from, to) => {
    const touch = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await touch("touchStart", [from]);
    for (let k = 1; k <= 10; k++) {
      await touch("touchMove", [{ x: from.x + ((to.x - from.x) * k) / 10, y: from.y + ((to.y - from.y) * k) / 10 }]);
      await page.waitForTimeout(20);
    }
    await page.waitForTimeout(200);
    await touch("touchEnd", []);
  };
  const middle = { x: x + width / 2, y: y + height / 2 };
  await drag(middle, { x: middle.x + 80, y: middle.y - 60 });
  await holds(page, 'Math.abs(mechanism.value("bob.angle")) > 0.02');
  assert.equal(await page.evaluate(() => scrollY), 0);
  // Beside the body the finger is the page's.
  await drag({ x: x + 20, y: y + height - 20 }, { x: x + 20, y: y + 20 });
  await page.waitForFunction(() => scrollY > 60);
  assert.deepEqual(errors, []);
  await page.close();
});

for (const [width, theme] of [[1200, "dark"], [390, "light"]]) {
  test(`it fits a page of ${width} px, ${theme}; who asks for less motion starts it`, { skip }, async () => {
    const { page } = await pageWith(`<plm-mechanism controls>${CRANK}</plm-mechanism>`, { width, theme, still: true, head: "<style>body { margin: 8px }</style>" });
    await holds(page, 'mechanism.value("turned") === 0');
    assert.equal(await ofElement(page, "mechanism.isPlaying"), false);
    await page.locator("plm-mechanism #sliders summary").click();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.equal(await ofElement(page, `${inside("root")}.dataset.theme`), theme);
    await shot(page, `element-${width}-${theme}`);
    await page.locator("plm-mechanism #picture").press(" ");
    await moves(page);
    await page.close();
  });
}
