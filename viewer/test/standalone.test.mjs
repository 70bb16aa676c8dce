// The interactive page as a file: it starts without a server, computes by itself, and asks nothing of any network.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { emptyPage, folder, launch } from "./browser.mjs";
import { example } from "./live-server.mjs";
import { load } from "./load.mjs";
import * as standalone from "./standalone.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

/** The page from disk; `problems` are its errors and its requests. */
async function open(options = {}, fragment = "") {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 }, ...options });
  const address = pathToFileURL(standalone.path).href;
  const watch = (request) => {
    if (request.url().split("#")[0] !== address && !/^(blob|data):/.test(request.url())) problems.push(`request: ${request.url()}`);
  };
  page.on("request", watch);
  await page.goto(address + fragment);
  await page.waitForSelector("body.live:not(.waiting)");
  await page.waitForFunction(() => window.polhodeLive.isSettled);
  return {
    page,
    problems,
    close: () => {
      page.off("request", watch);
      return close();
    },
  };
}

const text = (page) => page.evaluate(() => window.polhodeLive.text);
const set = (page, edit) =>
  page.evaluate(async (edit) => {
    window.polhodeLive.edit(edit);
    while (!window.polhodeLive.isSettled) await new Promise((done) => setTimeout(done, 5));
  }, edit);
const drop = (page, files) => page.locator("input[type=file]").first().setInputFiles(files.map(({ name, text }) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) })));

test("the page from disk shows the example, and a knob changes its motion, without any request", async () => {
  const { page, problems, close } = await open();
  assert.match(await text(page), /T-handle|crossbar/i);
  const before = await page.evaluate(() => [...window.polhode.app.motion.omega.slice(-3)]);
  await set(page, { set: "body.part[0].radius", value: '"7 mm"' });
  const after = await page.evaluate(() => [...window.polhode.app.motion.omega.slice(-3)]);
  assert.notDeepEqual(after, before);
  assert.match(await text(page), /"7 mm"/);
  assert.deepEqual(problems, []);
  await close();
});

test("a host that states another encoding serves the same page", async () => {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 } });
  const address = "http://page.test/polhode.html";
  await page.route(address, (route) => route.fulfill({ body: standalone.bytesOf(standalone.read()), contentType: "text/html; charset=utf-8" }));
  await page.goto(address);
  await page.waitForSelector("body.live:not(.waiting)");
  await page.waitForFunction(() => window.polhodeLive.isSettled);
  assert.equal(await page.evaluate(() => document.characterSet), "UTF-16LE");
  assert.match(await text(page), /ω|°|T-handle/);
  assert.deepEqual(problems, []);
  await page.unroute(address);
  await close();
});

/** Opens the page with a worker that never answers. */
async function openWithoutEngine(fragment) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.addInitScript(() => {
    window.Worker = class extends EventTarget {
      postMessage() {}
      terminate() {}
    };
  });
  await page.goto(pathToFileURL(standalone.path).href + fragment);
  await page.waitForSelector("body.live.waiting");
  return page;
}

test("until the engine answers, the page shows the motion of its example, as the engine computes it", async () => {
  const early = await openWithoutEngine("");
  assert.ok(await early.locator("#canvas").isVisible());
  assert.ok(await early.locator("#knobs").isHidden());
  await early.locator("#play").click();
  await early.waitForFunction(() => window.polhode.clock.time > 0.05);
  const shown = (page) => page.evaluate(() => [window.polhode.app.page.facts, [...window.polhode.app.motion.attitude]]);
  const [facts, attitude] = await shown(early);
  await early.close();

  const { page, problems, close } = await open();
  const [computedFacts, computed] = await shown(page);
  assert.deepEqual(facts.slice(0, 2), computedFacts.slice(0, 2)); // body and inertia
  const step = (computed.length / 4 - 1) / (attitude.length / 4 - 1);
  assert.ok(Number.isInteger(step) && step > 1, `${computed.length}, ${attitude.length}`);
  attitude.forEach((component, k) => {
    const full = computed[4 * step * Math.floor(k / 4) + (k % 4)];
    assert.ok(Math.abs(component - full) < 1e-7, `${k}: ${component}, ${full}`);
  });
  assert.deepEqual(problems, []);
  await close();
});

test("a link to a motion does not show that of the example before", async () => {
  const page = await openWithoutEngine("#state=AAAA");
  assert.ok(await page.locator("#canvas").isHidden());
  await page.close();
});

test("dropped files are shown: a scenario with its mesh, a robot with a finding, a torn mesh", async () => {
  const { page, problems, close } = await open();
  const corner = "solid s\n" + [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]].map((f) => facet(f)).join("") + "endsolid s\n";
  await drop(page, [
    { name: "corner.toml", text: '[[body.part]]\nshape = "mesh"\nfile = "corner.stl"\nunit = "m"\ndensity = "1000 kg/m^3"\n[start]\nspin = { body = ["0.1 rad/s", "2 rad/s", "0.3 rad/s"] }\n[run]\nduration = "5 s"\n' },
    { name: "corner.stl", text: corner },
  ]);
  await page.waitForFunction(() => window.polhodeLive.text.includes("corner.stl") && window.polhodeLive.isSettled);
  // The tetrahedron with legs of 1 m, 2 m and 3 m has 1 m³.
  const mass = await page.evaluate(() => window.polhode.app.page.body.mass);
  assert.ok(Math.abs(mass - 1000) < 1e-9, `mass ${mass}`);
  await drop(page, [{ name: "bad-arm.urdf", text: readFileSync(example("robots/bad-arm.urdf"), "utf8") }]);
  await page.waitForFunction(() => window.polhodeInspection.document?.name === "bad-arm.urdf");
  await drop(page, [{ name: "torn.stl", text: corner.replace(facet([1, 3, 2]), "") }]);
  await page.waitForFunction(() => window.polhodeInspection.document?.name === "torn.stl");
  assert.deepEqual(problems, []);
  await close();
});

/** A triangle of the tetrahedron with legs of 1, 2 and 3. */
const facet = (corners) => {
  const points = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]];
  const [a, b, c] = [corners[0], corners[2], corners[1]].map((k) => `vertex ${points[k].join(" ")}\n`);
  return `facet normal 0 0 0\nouter loop\n${a}${b}${c}endloop\nendfacet\n`;
};

test("a link restores the scenario of another page", async () => {
  const first = await open();
  await set(first.page, { set: "run.duration", value: '"3.25 s"' });
  const fragment = await first.page.evaluate(async () => {
    const { document, text } = window.polhodeLive;
    const packed = new Blob([JSON.stringify({ name: `other-${document.name}`, text })]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
    return `#state=${btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
  });
  await first.close();
  const { page, problems, close } = await open({}, fragment);
  assert.match(await text(page), /3\.25 s/);
  assert.equal(await page.evaluate(() => window.polhodeLive.document.name), "other-t-handle.toml");
  assert.deepEqual(problems, []);
  await close();
});

test("a damaged link is reported beside the example", async () => {
  const { page, problems, close } = await open({}, "#state=AAAA");
  await page.waitForFunction(() => document.body.innerText.includes("The link is damaged"));
  assert.match(await text(page), /T-handle|crossbar/i);
  assert.deepEqual(problems, []);
  await close();
});

test("a computation that nobody waits for is ended, and the next worker knows the documents", async () => {
  const { page, problems, close } = await open();
  const long = (await text(page)).replace(/duration = .*/, 'duration = "4000000 s"');
  const short = await text(page);
  const took = await page.evaluate(
    async ([long, short]) => {
      window.polhodeLive.replace(long, "test");
      await new Promise((done) => setTimeout(done, 300));
      const since = performance.now();
      window.polhodeLive.replace(short, "test");
      while (!window.polhodeLive.isSettled) await new Promise((done) => setTimeout(done, 5));
      return performance.now() - since;
    },
    [long, short],
  );
  assert.ok(took < 5000, `${took} ms`);
  assert.equal(await text(page), short);
  assert.equal(await page.evaluate(() => window.polhodeLive.trouble), null);
  assert.deepEqual(problems, []);
  await close();
});

test("files in the page are opened", async () => {
  const scenario = '[[body.part]]\nshape = "sphere"\nradius = "0.3 m"\nmass = "2 kg"\n[start]\nspin = { body = ["0.1 rad/s", "2 rad/s", "0.3 rad/s"] }\n[run]\nduration = "5 s"\n';
  const json = JSON.stringify({ open: ["ball.toml"], lesson: null, files: [{ path: "ball.toml", length: scenario.length }] });
  const padded = json.padEnd(Math.ceil(json.length / 8) * 8);
  const head = Buffer.alloc(8);
  head.writeBigUInt64LE(BigInt(padded.length));
  const { deflateSync } = await import("node:zlib");
  const { text32768 } = await load("live/base32768.ts");
  const pack = deflateSync(Buffer.concat([head, Buffer.from(padded + scenario)]));
  const script = `<script type="application/octet-stream" id="polhode-files" data-length="${pack.length}">${text32768(pack)}</script>`;
  const file = join(folder, "ball.html");
  writeFileSync(file, standalone.bytesOf(standalone.read().replace("<!--polhode-files-->", script)));
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 } });
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("body.live:not(.waiting)");
  assert.equal(await page.evaluate(() => window.polhodeLive.text), scenario);
  assert.deepEqual(problems, []);
  await close();
});
