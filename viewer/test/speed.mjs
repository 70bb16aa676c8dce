// How long the page takes to show another motion, ms of JavaScript: node test/speed.mjs [DATA.json …]; without data, a sample's. Not a test.
import { readFileSync } from "node:fs";
import { launch, open } from "./browser.mjs";
import { samples } from "./sample.mjs";

const files = process.argv.slice(2);
const pages = files.length > 0 ? files.map((file) => JSON.parse(readFileSync(file, "utf8"))) : [samples.free()];
const browser = await launch();
const { page, problems, close } = await open(browser, "speed", pages[0]);
for (const picture of ["body", "poinsot", "cones", "sphere"]) {
  await page.click(`[data-picture=${picture}]`);
  const taken = await page.evaluate(async (pages) => {
    const { app, view, clock } = window.polhode;
    clock.set(clock.start + 0.5 * (clock.end - clock.start));
    const all = [];
    for (let k = 0; k < 60; k += 1) {
      const data = structuredClone(pages[k % pages.length]);
      data.body.shapes = k % 2 ? app.page.body.shapes : data.body.shapes;
      const now = performance.now();
      app.show(data);
      const shown = performance.now();
      view.render();
      all.push([shown - now, performance.now() - shown]);
      await new Promise((resolve) => requestAnimationFrame(resolve));
    }
    const { geometries, textures, programs } = view.memory;
    const median = (list) => list.sort((a, b) => a - b)[Math.floor(list.length / 2)].toFixed(2);
    const late = all.slice(20);
    return { show: median(late.map(([a]) => a)), render: median(late.map(([, b]) => b)), all: median(late.map(([a, b]) => a + b)), geometries, textures, programs };
  }, pages);
  console.log(picture, JSON.stringify(taken));
}
console.log(problems);
await close();
await browser.close();
