// How long a knob's change takes until it is seen, with `polhode live` itself: ms from the change to the frame that shows its motion; of that
// in the server, on the way, and in the page. POLHODE names the program (build it with --release); node test/knob-speed.mjs FILE.toml KEY …
// on the way, and in the page; and beside that how long the screen is waited for, which without a GPU draws in software: there the pixels of
// the 3-D view are left out, as its calls are made and draw nothing. Not a test.
import { launch } from "./browser.mjs";
import { serve } from "./live-server.mjs";

const ROUNDS = 40;
const [file, ...keys] = process.argv.slice(2);
const browser = await launch();
const server = await serve(file);
const page = await (await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce" })).newPage();
await page.addInitScript(() => {
  for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) WebGL2RenderingContext.prototype[call] = () => undefined;
});
await page.goto(server.address);
await page.waitForFunction(() => document.querySelectorAll(".knob").length > 0 && window.polhodeLive.isSettled);
if (keys.length === 0) console.log(await page.evaluate(() => [...document.querySelectorAll(".knob")].map((k) => k.dataset.key)));
for (const key of keys) {
  const measured = await page.evaluate(
    async ([key, rounds]) => {
      const session = window.polhodeLive;
      const slider = document.querySelector(`.knob[data-key="${key}"] input[type=range]`);
      if (!slider) throw new Error(`no knob ${key}`);
      const [low, high] = [Number(slider.min), Number(slider.max)];
      const middle = Number(slider.value);
      const { app, view } = window.polhode;
      // What the page itself does, without its waiting for the screen.
      let spent = 0;
      const timed = (of, name) => {
        const call = of[name].bind(of);
        of[name] = (...given) => {
          const begun = performance.now();
          call(...given);
          spent += performance.now() - begun;
        };
      };
      timed(app, "show");
      timed(view, "render");
      let moved = null;
      session.listen({ moved: () => moved?.() });
      const rows = [];
      for (let k = 0; k < rounds; k += 1) {
        const shown = new Promise((done) => {
          moved = () => {
            moved = null;
            // After the frame's own work.
            requestAnimationFrame(() => done(performance.now()));
          };
        });
        const begun = performance.now();
        spent = 0;
        slider.value = String(middle + (high - low) * (k % 2 === 0 ? 0.03 : 0.01));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        const seen = await shown;
        const { there, all } = session.took;
        rows.push({ all: all + spent, server: there, way: all - there, page: spent, screen: seen - begun - all - spent });
        // What is asked for when all is settled is not in the way of the next.
        await new Promise((done) => setTimeout(done, 600));
      }
      return rows;
    },
    [key, ROUNDS],
  );
  const sorted = (what) => measured.slice(5).map((row) => row[what]).sort((a, b) => a - b);
  const at = (what, part) => sorted(what)[Math.floor(part * (sorted(what).length - 1))].toFixed(1);
  const line = ["all", "server", "way", "page", "screen"].map((what) => `${what} ${at(what, 0.5)} (90 %: ${at(what, 0.9)})`);
  const { count } = await page.evaluate(() => window.polhode.app.motion);
  console.log(`${key}, ${count} samples, ms: ${line.join(", ")}`);
}
await browser.close();
server.close();
