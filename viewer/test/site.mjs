// The built site in a real browser, from disk and from a server: node test/site.mjs FOLDER, which is target/book after `cargo xtask book`.
import assert from "node:assert/strict";
import { createReadStream, existsSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize, resolve } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { emptyPage, launch, unnamed } from "./browser.mjs";

const site = resolve(process.argv[2] ?? "../target/book");
const disk = `${pathToFileURL(site).href}/`;
const SIZES = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];
const SEARCHED = [
  ["gyroscope", /gyroscope/i],
  ["parallel axis", /parallel.axis/i],
  ["dzhanibekov", /dzhanibekov/i],
  ["--density", /--density/],
];
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".webp": "image/webp", ".png": "image/png", ".svg": "image/svg+xml" };
/** Folder of the server under which the site is. */
const BELOW = "/polhode/";

let browser;
let server;
let served;
before(async () => {
  server = createServer((request, answer) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    const file = join(site, normalize(path.slice(BELOW.length - 1)), path.endsWith("/") ? "index.html" : "");
    const isThere = path.startsWith(BELOW) && file.startsWith(site) && existsSync(file);
    answer.writeHead(isThere ? 200 : 404, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
    if (isThere) createReadStream(file).pipe(answer);
    else answer.end();
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  served = `http://127.0.0.1:${server.address().port}${BELOW}`;
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** Opens a page of the site; `problems` are errors, and requests for anything outside the site. */
async function open(root, path, options = {}) {
  const { page, problems, close } = await emptyPage(browser, { viewport: SIZES[0], ...options });
  page.setDefaultTimeout(60_000);
  const watch = (request) => {
    if (!request.url().startsWith(root) && !/^(blob|data):/.test(request.url())) problems.push(`request: ${request.url()}`);
  };
  const missing = (response) => {
    if (response.status() >= 400) problems.push(`${response.status()}: ${response.url()}`);
  };
  page.on("request", watch);
  page.on("response", missing);
  await page.goto(root + path);
  return {
    page,
    problems,
    close: async () => {
      page.off("request", watch);
      page.off("response", missing);
      await close();
    },
  };
}

/** The interactive page in the front page, when its first motion is there. */
async function motionOf(page) {
  const frame = await (await page.waitForSelector("iframe")).contentFrame();
  await frame.waitForSelector("body.live.framed:not(.waiting)");
  await frame.waitForFunction(() => window.polhodeLive.isSettled && document.querySelectorAll(".knob").length > 1);
  return frame;
}

/** Share of the pixels of the scene that are not background. */
const drawn = (frame) =>
  frame.evaluate(() => {
    const { width, height } = window.polhode.picture();
    const copy = new OffscreenCanvas(width, height).getContext("2d");
    copy.drawImage(window.polhode.picture(), 0, 0);
    const pixels = new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer);
    return pixels.filter((pixel) => pixel !== pixels[0]).length / pixels.length;
  });

const isDark = (place) => place.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).every((channel) => channel < 128));
const omegaAtStart = (frame) => frame.evaluate(() => [...window.polhode.app.motion.omega.slice(0, 3)]);

for (const viewport of SIZES) {
  for (const colorScheme of ["light", "dark"]) {
    test(`the front page from disk, ${viewport.width} × ${viewport.height}, ${colorScheme}: the motion is drawn and plays, and a knob changes it`, async () => {
      const { page, problems, close } = await open(disk, "index.html", { viewport, colorScheme });
      const frame = await motionOf(page);
      await frame.waitForFunction(() => window.polhode.clock.playing && window.polhode.clock.time > 0);
      assert.ok((await drawn(frame)) > 0.01, "the scene is not empty");
      for (const place of [page, frame]) {
        assert.equal(await isDark(place), colorScheme === "dark");
        assert.deepEqual(await unnamed(place), []);
        assert.ok(await place.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "no horizontal scroll bar");
      }
      assert.equal(await page.evaluate(() => scrollY), 0, "the start of the motion scrolls nothing");
      assert.ok(await frame.evaluate(() => document.documentElement.scrollHeight <= innerHeight), "the frame has no scroll bar");
      const [before, caption] = [await omegaAtStart(frame), await frame.locator("#caption").textContent()];
      await frame.locator(".knob input[type=range]").first().press("End");
      await frame.waitForFunction(([x]) => window.polhodeLive.isSettled && window.polhode.app.motion.omega[0] > x + 1, before);
      assert.notEqual(await frame.locator("#caption").textContent(), caption, "the answer follows");
      assert.deepEqual(problems, []);
      await close();
    });
  }
}

test("in the frame a drag turns the camera, and the wheel scrolls the front page", async () => {
  const { page, problems, close } = await open(served, "", { reducedMotion: "reduce" });
  const frame = await motionOf(page);
  const camera = () => frame.evaluate(() => [window.polhode.view.orbit.azimuth, window.polhode.view.orbit.zoom]);
  assert.equal(await frame.evaluate(() => window.polhode.clock.playing), false, "who prefers no motion starts it");
  const [azimuth, zoom] = await camera();
  const { x, y, width, height } = await frame.locator("#canvas").boundingBox();
  await page.mouse.move(x + width / 4, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 4 + 60, y + height / 2, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await camera())[0] - azimuth) > 0.2);
  await page.mouse.wheel(0, 200);
  await page.waitForFunction(() => scrollY > 100);
  assert.equal((await camera())[1], zoom);
  assert.deepEqual(problems, []);
  await close();
});

test("the theme chosen in the book is that of the front page and of its frame", async () => {
  const { page, problems, close } = await open(disk, "book/README.html", { colorScheme: "light" });
  await page.evaluate(() => localStorage.setItem("theme", "dark"));
  await page.goto(`${disk}index.html`);
  const frame = await motionOf(page);
  for (const place of [page, frame]) assert.ok(await isDark(place));
  await page.evaluate(() => localStorage.removeItem("theme"));
  assert.deepEqual(problems, []);
  await close();
});

test("by keys: the first stop passes the motion by, then come the site's pages and the search", async () => {
  const { page, problems, close } = await open(disk, "index.html");
  const stops = [];
  for (let k = 0; k < 8; k += 1) {
    await page.keyboard.press("Tab");
    stops.push(await page.evaluate(() => document.activeElement.ariaLabel ?? document.activeElement.textContent));
  }
  assert.deepEqual(stops, ["Skip the motion", "polhode", "Book", "Gallery", "Python", "Rust", "Get it", "Search the book"]);
  assert.deepEqual(problems, []);
  await close();
});

for (const [where, root] of [["from disk", () => disk], ["from a server, below a folder", () => served]]) {
  for (const path of ["index.html", "book/README.html"]) {
    test(`search ${where}, on ${path}: the first result leads to a page with the words`, async () => {
      const { page, problems, close } = await open(root(), path);
      for (const [query, words] of SEARCHED) {
        await page.goto(root() + path);
        await page.locator("input.sidebar-search").fill(query);
        await page.waitForSelector("#found a[aria-selected=true]");
        await page.keyboard.press("Enter");
        await page.waitForURL((url) => !url.pathname.endsWith(path));
        assert.match(await page.locator("article").textContent(), words);
      }
      assert.deepEqual(problems, []);
      await close();
    });
  }
  test(`search ${where}, without the list of results: the page of results`, async () => {
    const { page, problems, close } = await open(root(), "search.html?q=gyroscope");
    await page.waitForSelector("#search-results li a");
    assert.deepEqual(problems, []);
    await close();
  });
}
