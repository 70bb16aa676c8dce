// What a screen reader hears, how the page uses its window, and what a motion that runs away looks like: in a real browser, from disk.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, open, shoot } from "./browser.mjs";
import { rotate, samples } from "./sample.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test("nothing that changes with time is read aloud, and each button and plot has a name of its own", async () => {
  const { page, problems, close } = await open(browser, "heard", samples.heavy());
  const live = await page.locator("output, [role=status], [role=alert]:visible, [aria-live]").evaluateAll((all) => all.map((e) => e.id || e.className));
  assert.deepEqual(live, ["caption"]);
  const buttons = await page.locator("#panel-plots .plot-heading button").evaluateAll((all) => all.map((e) => e.getAttribute("aria-label")));
  assert.ok(buttons.length >= 12 && new Set(buttons).size === buttons.length, `${buttons}`);
  assert.ok(buttons.includes("Torque, body axes: save as SVG") && buttons.includes("Path of the axis in space: save as PNG"), `${buttons}`);
  const plots = await page.locator("#panel-plots canvas").evaluateAll((all) => all.map((e) => `${e.getAttribute("role")} ${e.getAttribute("aria-label")}`));
  assert.ok(plots.length > 6 && new Set(plots).size === plots.length, `${plots}`);
  assert.ok(plots.includes("img Torque, body axes: Nx, Ny, |N| over time"), `${plots}`);
  assert.deepEqual(problems, []);
  await close();
});

test("a motion that runs away at its end has the arrows and the speed of the rest", async () => {
  const eight = (list) => Buffer.from(Float64Array.from(list).buffer).toString("base64");
  const numbers = (text) => new Float64Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
  const seen = async (name, data) => {
    const { page, problems, close } = await open(browser, name, data);
    const state = await page.evaluate(() => {
      const { clock, view } = window.polhode;
      clock.set(1.234);
      view.render();
      const tips = ["𝛚", "𝐋", "𝐍"].map((text) => view.labels.placed.find((label) => label.text === text)?.tip.toArray() ?? null);
      return { speed: clock.speed, tips };
    });
    await shoot(page, name);
    const last = await page.evaluate(() => {
      const { clock, view } = window.polhode;
      clock.set(clock.end);
      view.render();
      const tip = view.labels.placed.find(({ text }) => text === "𝛚").tip;
      return { tip: tip.toArray(), attitude: view.attitudeAt(clock.end) };
    });
    const q = last.attitude;
    const omega = rotate(q, [...numbers(data.motion.omega).slice(-3)]);
    const long = Math.hypot(...last.tip);
    // It leaves the picture in its direction, and does not end behind the camera.
    assert.ok(long <= 3.0001, `${long}`);
    omega.forEach((x, k) => assert.ok(Math.abs(last.tip[k] / long - x / Math.hypot(...omega)) < 1e-5, `${last.tip}`));
    await shoot(page, `${name}-end`);
    assert.deepEqual(problems, []);
    await close();
    return state;
  };
  const data = samples.heavy();
  const usual = await seen("runs", data);
  for (const key of ["omega", "momentum", "torque"]) {
    const values = numbers(data.motion[key]);
    for (let k = 1; k <= 6; k += 1) values[values.length - k] *= 10 ** (12 - k);
    data.motion[key] = eight(values);
  }
  data.motion.complete = false;
  const away = await seen("runs-away", data);
  assert.equal(away.speed, usual.speed);
  // The largest of all may be among the last two samples: a size may differ by a little.
  usual.tips.forEach((tip, k) => tip.forEach((x, c) => assert.ok(Math.abs(away.tips[k][c] - x) < 0.02, `${away.tips[k]}, not ${tip}`)));
});

/** A free motion, a top and a spacecraft, opened once for both of the following. */
const windows = new Map();
const windowOf = async (name, colorScheme) => {
  if (!windows.has(name)) windows.set(name, await open(browser, `window-${name}`, samples[name](), { viewport: { width: 1440, height: 600 }, colorScheme }));
  return windows.get(name);
};
const WINDOWS = [["free", "light"], ["tilted", "dark"], ["wheeled", "light"]];

test("a window that is made narrow and wide again never scrolls sideways", async () => {
  for (const [name, colorScheme] of WINDOWS) {
    const { page, problems } = await windowOf(name, colorScheme);
    await page.evaluate(() => {
      window.beyond = [];
      const look = () => {
        if (window.beyond === null) return;
        const { scrollWidth, clientWidth } = document.documentElement;
        window.beyond.push(scrollWidth - clientWidth);
        requestAnimationFrame(look);
      };
      look();
    });
    for (const width of [390, 1440, 390]) {
      const before = await page.evaluate(() => window.beyond.length);
      await page.setViewportSize({ width, height: width < 800 ? 844 : 600 });
      await page.waitForFunction((width) => {
        const plot = document.querySelector("#plot-omega canvas").getBoundingClientRect().width;
        const panel = document.querySelector("#panel-plots").clientWidth;
        return innerWidth === width && plot > 0.8 * panel && plot <= panel;
      }, width);
      await page.waitForFunction((frames) => window.beyond.length >= frames, before + 4);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `${name}, ${colorScheme}, ${width}`);
    }
    const beyond = await page.evaluate(() => {
      const all = window.beyond;
      window.beyond = null;
      return all;
    });
    assert.ok(beyond.every((x) => x === 0), `${name}, ${colorScheme}: ${beyond.filter((x) => x !== 0)} px in ${beyond.length} frames`);
    assert.deepEqual(problems, []);
  }
});

test("a picture fills its frame, and nothing is cut off at any time, from wherever it is seen", async () => {
  for (const [name, colorScheme] of WINDOWS) {
    const { page, problems, close } = await windowOf(name, colorScheme);
    const all = await page.evaluate(() => {
      const { clock, view } = window.polhode;
      // Where in the frame, from −1 to 1, the body and what has a name are: with a renderer that draws nothing.
      const spans = (width, height) => {
        const span = [1, 1, -1, -1];
        const names = {
          draw: (labels, outline, _, camera) => {
            for (const p of [...outline, ...labels.flatMap(({ tip, along }) => along ?? [tip])]) {
              const { x, y } = p.clone().project(camera);
              [x, y].forEach((at, k) => {
                span[k] = Math.min(span[k], at);
                span[k + 2] = Math.max(span[k + 2], at);
              });
            }
          },
        };
        const count = 61;
        for (let k = 0; k < count; k += 1) view.draw({ render: () => undefined }, names, clock.start + (k / (count - 1)) * (clock.end - clock.start), width, height);
        return span;
      };
      const found = [];
      for (const picture of view.pictures) {
        for (const rides of ["space", "body"]) {
          for (const [turn, rise] of [[0, 0], [2.1, -0.9]]) {
            view.show(picture);
            view.rides = rides;
            view.orbit.turn(turn, rise);
            for (const [width, height] of [[827, 659], [390, 390]]) found.push({ picture, rides, turn, width, height, span: spans(width, height) });
          }
        }
      }
      return found;
    });
    assert.ok(all.length >= 8);
    for (const { width, height, span, ...how } of all) {
      const where = `${name}, ${width} × ${height}, ${JSON.stringify(how)}: ${span.map((x) => x.toFixed(3))}`;
      assert.ok(span.every((x) => Math.abs(x) < 0.99), `cut off: ${where}`);
      const [across, down] = [(span[2] - span[0]) / 2, (span[3] - span[1]) / 2];
      assert.ok(Math.max(across, down) > 0.8, `empty: ${where}`);
    }
    assert.deepEqual(problems, []);
    await close();
  }
});
