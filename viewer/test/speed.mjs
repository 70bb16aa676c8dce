// How long the page takes to show another motion: ms of JavaScript from its data to the frame that shows it, of the thread's own time, so that
// other programs do not count; and how long a frame of it takes while it plays. node test/speed.mjs [DATA.json …]; without data, a sample's.
// Calls of the GPU are made and draw nothing: without one the browser would be busy with pixels. Not a test.
import { readFileSync } from "node:fs";
import { launch, open } from "./browser.mjs";
import { samples } from "./sample.mjs";

const ROUNDS = 40;
const files = process.argv.slice(2);
const pages = files.length > 0 ? files.map((file) => JSON.parse(readFileSync(file, "utf8"))) : [samples.free()];
const browser = await launch();
const { page, problems, close } = await open(browser, "speed", pages[0], { smooth: true });
await page.evaluate(() => {
  for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) WebGL2RenderingContext.prototype[call] = () => undefined;
});
const cdp = await page.context().newCDPSession(page);
await cdp.send("Performance.enable", { timeDomain: "threadTicks" });
const spent = async () => (await cdp.send("Performance.getMetrics")).metrics.find(({ name }) => name === "ScriptDuration").value;
/** Shows the motions one after the other, each in a frame of its own; the body's shapes are the same unless `reshape`. */
const run = (rounds, what) =>
  page.evaluate(
    async ([pages, rounds, what]) => {
      const { app, view, clock } = window.polhode;
      clock.set(clock.start + 0.5 * (clock.end - clock.start));
      for (let k = 0; k < rounds; k += 1) {
        const data = structuredClone(pages[k % pages.length]);
        if (what !== "reshape") data.body.shapes = app.page.body.shapes;
        if (what !== "nothing") app.show(data);
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
      const { geometries, textures, programs } = view.memory;
      return { geometries, textures, programs };
    },
    [pages, rounds, what],
  );
for (const picture of ["body", "poinsot", "cones", "sphere"]) {
  await page.click(`[data-picture=${picture}]`);
  const taken = {};
  let memory;
  for (const what of ["nothing", "motion", "reshape"]) {
    await run(20, what);
    const before = await spent();
    memory = await run(ROUNDS, what);
    taken[what] = (1000 * ((await spent()) - before)) / ROUNDS;
  }
  const over = (what) => (taken[what] - taken.nothing).toFixed(1);
  const before = await spent();
  const frames = await page.evaluate(async () => {
    const { clock, view } = window.polhode;
    let drawn = 0;
    view.drawn.push(() => (drawn += 1));
    clock.setLoop(true);
    clock.toggle();
    await new Promise((resolve) => setTimeout(resolve, 4000));
    clock.toggle();
    view.drawn.pop();
    return drawn;
  });
  const playing = ((1000 * ((await spent()) - before)) / frames).toFixed(1);
  console.log(`${picture}: playing ${playing} ms a frame (${frames} frames); another motion ${over("motion")} ms, with other shapes ${over("reshape")} ms; ${JSON.stringify(memory)}`);
}
if (problems.length > 0) console.log(problems);
await close();
await browser.close();
