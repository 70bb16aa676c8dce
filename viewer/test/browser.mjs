// The browser of the tests, and pages in it. CHROMIUM names the executable; else the first on PATH of three names.
import { accessSync, constants, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { pageOf } from "./page.mjs";
import * as standalone from "./standalone.mjs";

/** Pages and screenshots of this run. */
export const folder = mkdtempSync(join(tmpdir(), "polhode-viewer-"));

export function executable() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    for (const place of (process.env.PATH ?? "").split(delimiter)) {
      const path = join(place, name);
      try {
        accessSync(path, constants.X_OK);
        return path;
      } catch {
        // not here
      }
    }
  }
  throw new Error("no Chromium: name one in CHROMIUM");
}

/** WebGL in software, and by it no more than WebGL: the rest of a page is drawn faster without. As root in a container, too. */
const SOFTWARE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing", "--disable-gpu-rasterization"];
export const ARGUMENTS = [...SOFTWARE, "--no-sandbox"];

export const launch = () => chromium.launch({ executablePath: executable(), args: ARGUMENTS });

/** Pages that are not in use, by the options that a page cannot change: a new one costs a window and a process. */
const idle = new Map();

/** An empty page of this browser, `smooth` or with rough edges; `problems` are its errors, and `close` leaves it to the next. */
export async function emptyPage(browser, { viewport, colorScheme = "light", reducedMotion = null, ...fixed }) {
  const key = JSON.stringify(fixed);
  if (!idle.has(key)) idle.set(key, []);
  const one = idle.get(key).pop() ?? (await newPage(browser, fixed));
  one.problems = [];
  await one.page.setViewportSize(viewport);
  await one.page.emulateMedia({ colorScheme, reducedMotion });
  const close = async () => {
    await one.page.mouse.move(0, 0);
    await one.page.goto("about:blank");
    idle.get(key).push(one);
  };
  return { page: one.page, problems: one.problems, close };
}

/** The page of `polhode live`: its token is the path. */
const SERVED = /^http:\/\/127\.0\.0\.1:\d+\/[^/]+\/$/;

/** Answers with the page in POLHODE_PAGE, which may be newer than that in the command, as the command would serve it. */
async function serveFresh(route) {
  const page = standalone.read();
  const text = page.replace("connect-src 'none'", "connect-src 'self'").replace("<!--polhode-files-->", '<meta name="polhode-files" content="files">');
  await route.fulfill({ body: standalone.bytesOf(text), contentType: "text/html" });
}

async function newPage(browser, { smooth = false, ...options }) {
  const context = await browser.newContext({ acceptDownloads: true, ...options });
  if (!smooth) await context.addInitScript(withRoughEdges);
  if (process.env.POLHODE_PAGE) await context.route(SERVED, serveFresh);
  const page = await context.newPage();
  // Beside a compilation the software renderer is slow.
  page.setDefaultTimeout(180_000);
  const one = { page, problems: [] };
  // The software renderer's own complaint about reading pixels is not the page's.
  page.on("console", (m) => {
    if (["error", "warning"].includes(m.type()) && !m.text().includes("GPU stall")) one.problems.push(`${m.type()}: ${m.text()}`);
  });
  page.on("pageerror", (error) => one.problems.push(`exception: ${error.message}`));
  page.on("dialog", (dialog) => {
    one.problems.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  return one;
}

/** Opens a page with these data from disk; `problems` are its errors and requests. */
export async function open(browser, name, data, options = {}) {
  const file = join(folder, `${name}.html`);
  writeFileSync(file, pageOf(data));
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 720 }, reducedMotion: "reduce", ...options });
  const address = pathToFileURL(file).href;
  const watch = (request) => {
    if (request.url() !== address && !/^(blob|data):/.test(request.url())) problems.push(`request: ${request.url()}`);
  };
  page.on("request", watch);
  await page.goto(address);
  await page.waitForFunction(() => window.polhode !== undefined);
  await page.evaluate(() => window.polhode.ready);
  return {
    page,
    problems,
    close: () => {
      page.off("request", watch);
      return close();
    },
  };
}

/** From here on frames have everything but their pixels, most of a frame's time, until what this gives is called. */
export async function withoutPixels(page) {
  const calls = ["clear", "drawArrays", "drawArraysInstanced", "drawElements", "drawElementsInstanced"];
  const context = await page.evaluateHandle(() => document.querySelector("#canvas").getContext("webgl2"));
  await context.evaluate((gl, calls) => calls.forEach((call) => (gl[call] = () => {})), calls);
  return () => context.evaluate((gl, calls) => calls.forEach((call) => delete gl[call]), calls);
}

/** Without the four samples of each pixel that smooth edges, which take the software renderer a fifth of all time. */
function withRoughEdges() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, kind === "webgl2" ? { ...options, antialias: false } : options);
  };
}

export const shoot = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });

/** The controls that are seen and have no name for a screen reader. */
export const unnamed = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, [tabindex='0']")]
      .filter((e) => e.checkVisibility() && !(e.ariaLabel || e.getAttribute("aria-labelledby") || e.textContent.trim() || e.labels?.length > 0))
      .map((e) => e.outerHTML),
  );
