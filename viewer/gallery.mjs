// node gallery.mjs [NAME …]: the pictures of book/gallery.md, all or those that are named, as WebP, from the pages that polhode writes.
// POLHODE names the command, as CHROMIUM does the browser; else `polhode` on PATH.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { folder, launch } from "./test/browser.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const target = join(root, "book/gallery");
const polhode = process.env.POLHODE ?? "polhode";
const WIDTH = 480;
const HEIGHT = 360;
const QUALITY = 0.82;
const LARGEST = 40_000;

/** Which moment of which example is shown: `at`, of the run, from 0 to 1; `view`, of the page; `trail`, of what;
 * `zoom`, how near; or `plot`, a figure. */
const SHOWN = {
  "air-brake": { plot: "omega" },
  "bicycle-wheel": { at: 0.52 },
  "ball-in-bowl": { at: 0.4 },
  "ball-on-turntable": { at: 0.42 },
  bracket: { at: 0.3, trail: "omega", zoom: 1.15 },
  cubesat: { plot: "pointing" },
  "curtis-tube": { at: 0.16 },
  drag: { at: 0.22, zoom: 1.2 },
  "dual-spin": { at: 0.25 },
  "earth-wobble": { plot: "omega" },
  "eulers-disk": { at: 0.2 },
  events: { at: 0.97, zoom: 1.2 },
  "flat-spin": { at: 0.3 },
  formula: { at: 0.05, zoom: 1.3 },
  "gravity-gradient": { plot: "pointing" },
  gyrostat: { at: 0.45 },
  "heavy-top": { at: 0.45 },
  hyperion: { at: 0.6 },
  magnet: { at: 0.055, zoom: 1.2 },
  moon: { plot: "pointing" },
  "notes/11-04-pendulum": { at: 0.12, zoom: 1.1 },
  "prescribed-table": { at: 0.6, zoom: 1.1 },
  rattleback: { at: 0.3 },
  shaft: { at: 0.4 },
  "sleeping-top": { at: 0.95 },
  slew: { at: 0.65, zoom: 1.2 },
  "symmetric-top": { at: 0.1, view: "cones" },
  "t-handle": { at: 0.19 },
  "tennis-racket": { at: 0.03, zoom: 1.25 },
  "thousand-seconds": { at: 0.01, view: "sphere" },
  thruster: { at: 0.35, zoom: 1.15 },
  "tippe-top": { at: 0.5 },
  "top-cusps": { at: 0.55 },
  "top-loops": { at: 0.7 },
  "torsion-pendulum": { at: 0.1, zoom: 1.2 },
  toutatis: { at: 0.75 },
  water: { at: 0.3, view: "poinsot" },
};

const file = (name) => join(target, `${name.split("/").pop()}.webp`);

async function photograph(page, results, { at, view, trail, zoom }) {
  await page.goto(pathToFileURL(join(results, "report.html")).href);
  await page.waitForFunction(() => window.polhode !== undefined);
  await page.evaluate(() => Promise.all([window.polhode.ready, document.fonts.ready]));
  return page.evaluate(
    ([at, view, trail, zoom, width, height, quality]) => {
      const shown = window.polhode.view;
      const clock = window.polhode.clock;
      if (view) shown.show(view);
      if (trail) shown.trailed = trail;
      shown.resize(width, height);
      shown.orbit.dolly(zoom);
      clock.set(clock.start + at * (clock.end - clock.start));
      // Labels are placed beside where they were.
      shown.render();
      const out = document.createElement("canvas");
      out.width = width;
      out.height = height;
      out.getContext("2d").drawImage(shown.photograph(), 0, 0, width, height);
      return out.toDataURL("image/webp", quality);
    },
    [at, view ?? null, trail ?? null, zoom ?? 1, WIDTH, HEIGHT, QUALITY],
  );
}

async function draw(page, figure) {
  await page.setContent("");
  return page.evaluate(
    async ([svg, width, quality]) => {
      const image = new Image();
      image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
      await image.decode();
      const out = document.createElement("canvas");
      out.width = width;
      out.height = Math.round((width * image.naturalHeight) / image.naturalWidth);
      const pen = out.getContext("2d");
      pen.fillStyle = "#fff";
      pen.fillRect(0, 0, out.width, out.height);
      pen.drawImage(image, 0, 0, out.width, out.height);
      return out.toDataURL("image/webp", quality);
    },
    [readFileSync(figure, "utf8"), WIDTH, QUALITY],
  );
}

const wanted = process.argv.slice(2);
const names = Object.keys(SHOWN).filter((name) => wanted.length === 0 || wanted.includes(name));
if (names.length === 0) throw new Error(`there is no ${wanted.join(", ")}`);
mkdirSync(target, { recursive: true });
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, colorScheme: "light", reducedMotion: "reduce" });
let total = 0;
for (const name of names) {
  const shown = SHOWN[name];
  const results = join(folder, name.replace("/", "-"));
  const figure = join(folder, "figure.svg");
  const plot = shown.plot ? ["--no-page", "--plot", `${shown.plot}=${figure}`] : [];
  const command = ["simulate", `examples/${name}.toml`, "-o", results, "--force", ...plot];
  execFileSync(polhode, command, { cwd: root, stdio: ["ignore", "ignore", "inherit"] });
  const url = shown.plot ? await draw(page, figure) : await photograph(page, results, shown);
  const bytes = Buffer.from(url.split(",")[1], "base64");
  if (bytes.length > LARGEST) throw new Error(`${name}: ${bytes.length} bytes`);
  writeFileSync(file(name), bytes);
  total += bytes.length;
}
console.log(`${names.length} pictures, ${Math.round(total / 1000)} kB`);
await browser.close();
