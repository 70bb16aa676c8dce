// The browser of the tests, and pages in it. CHROMIUM names the executable; else the first on PATH of three names.
import { accessSync, constants, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { pageOf } from "./page.mjs";

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

/** Opens a page with these data from disk; `problems` are its errors and requests. */
export async function open(browser, name, data, options = {}) {
  const file = join(folder, `${name}.html`);
  writeFileSync(file, pageOf(data));
  const context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    reducedMotion: "reduce",
    colorScheme: "light",
    acceptDownloads: true,
    ...options,
  });
  const page = await context.newPage();
  // Beside a compilation the software renderer is slow.
  page.setDefaultTimeout(180_000);
  const problems = [];
  // The software renderer's own complaint about reading pixels is not the page's.
  page.on("console", (m) => {
    if (["error", "warning"].includes(m.type()) && !m.text().includes("GPU stall")) problems.push(`${m.type()}: ${m.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
  page.on("dialog", (dialog) => {
    problems.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  const address = pathToFileURL(file).href;
  page.on("request", (request) => {
    if (request.url() !== address && !/^(blob|data):/.test(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.goto(address);
  await page.waitForFunction(() => window.polhode !== undefined);
  await page.evaluate(() => window.polhode.ready);
  return { page, problems, close: () => context.close() };
}

export const shoot = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });

/** The controls that are seen and have no name for a screen reader. */
export const unnamed = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, [tabindex='0']")]
      .filter((e) => e.checkVisibility() && !(e.ariaLabel || e.getAttribute("aria-labelledby") || e.textContent.trim() || e.labels?.length > 0))
      .map((e) => e.outerHTML),
  );
