// What a screen reader hears, and what a motion that runs away looks like: the page in a real browser, from disk.
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
