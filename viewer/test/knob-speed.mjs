// How long a knob's change takes until it is seen, with `polhode live` itself: ms from the knob's event to the end of the calls that draw its
// motion; of that in the server, on the way, and in the page. POLHODE names the program (build it with --release); node test/knob-speed.mjs
// FILE.toml KEY … ; without keys it names them. The calls of the GPU are made and draw nothing, as without one the pixels are computed in
// software. Not a test.
import { bare } from "./bare.mjs";
import { serve } from "./live-server.mjs";

const ROUNDS = 100;
const [file, ...keys] = process.argv.slice(2);
const server = await serve(file);
const page = await bare(() => {
  for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) WebGL2RenderingContext.prototype[call] = () => undefined;
});
await page.goto(server.address, () => document.querySelectorAll(".knob").length > 0 && window.polhodeLive?.isSettled);
if (keys.length === 0) console.log(await page.evaluate(() => [...document.querySelectorAll(".knob")].map((k) => k.dataset.key)));
for (const key of keys) {
  const { rows, count } = await page.evaluate(
    async ({ key, rounds }) => {
      const session = window.polhodeLive;
      const { app, view } = window.polhode;
      const slider = document.querySelector(`.knob[data-key="${key}"] input[type=range]`);
      const [low, high, middle] = [slider.min, slider.max, slider.value].map(Number);
      let moved = null;
      session.listen({ moved: () => moved?.() });
      const rows = [];
      for (let k = 0; k < rounds; k += 1) {
        const begun = performance.now();
        const drawn = new Promise((done) => {
          moved = () => {
            moved = null;
            view.render();
            done(performance.now());
          };
        });
        slider.value = String(middle + (high - low) * (k % 2 === 0 ? 0.03 : 0.01));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        const all = (await drawn) - begun;
        const { there, all: answered } = session.took;
        rows.push({ all, server: there, way: answered - there, page: all - answered });
        // Frames are put together in software here, and what is asked for when all is settled is not in the way of the next.
        await new Promise((done) => setTimeout(done, 60));
      }
      return { rows: rows.slice(20), count: app.motion.count };
    },
    { key, rounds: ROUNDS },
  );
  const at = (what, part) => rows.map((row) => row[what]).sort((a, b) => a - b)[Math.floor(part * (rows.length - 1))].toFixed(1);
  const line = ["all", "server", "way", "page"].map((what) => `${what} ${at(what, 0.5)} (90 %: ${at(what, 0.9)})`);
  console.log(`${key}, ${count} samples, ms: ${line.join(", ")}`);
}
await page.close();
server.close();
