// The page of `polhode live` in a real browser, with the program itself.
import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { emptyPage, launch, shoot, unnamed, withoutPixels } from "./browser.mjs";
import { example, serve } from "./live-server.mjs";

let browser;
let server;
const folder = mkdtempSync(join(tmpdir(), "polhode-live-"));
const file = join(folder, "t-handle.toml");
before(async () => {
  copyFileSync(example("t-handle.toml"), file);
  [browser, server] = await Promise.all([launch(), serve(file, example("heavy-top.toml"))]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

const SPIN = "start.spin.body[2]";
const RADIUS = "body.part[0].radius";

/** The page, when the first motion is there; `problems` are its errors. */
async function open(options = {}, fragment = "") {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 }, ...options });
  await page.goto(server.address + fragment);
  await page.waitForSelector("body.live:not(.waiting)");
  await page.waitForFunction(() => document.querySelectorAll(".knob").length > 3);
  await still(page);
  return { page, problems, close };
}

/**
 * Waits until nothing moves: everything is answered, and picture and tip of ω stay at their places for three frames.
 * A pointer that is pressed earlier can miss what it aims at.
 */
const still = (page) =>
  page.evaluate(async () => {
    const frame = () => new Promise((done) => requestAnimationFrame(done));
    const places = () => JSON.stringify([...document.querySelectorAll("#canvas, .tip")].map((part) => part.getBoundingClientRect()));
    for (let equal = 0, last = ""; equal < 3; await frame()) {
      const now = places();
      equal = window.polhodeLive.isSettled && now === last ? equal + 1 : 0;
      last = now;
    }
  });

const knob = (page, key) => page.locator(`.knob[data-key="${key}"]`);
const text = (page) => page.evaluate(() => window.polhodeLive.text);
const omegaAtStart = (page) => page.evaluate(() => [...window.polhode.app.motion.omega.subarray(0, 3)]);
const attitude = (page) => page.evaluate(() => window.polhode.attitudeAt(window.polhode.clock.time));
/** Waits until the page's motion is that of a text with this in it. */
const shows = (page, part) => page.waitForFunction((part) => window.polhodeLive.isSettled && window.polhodeLive.text.includes(part), part);
/** Waits until all that was done so far is answered and drawn. */
async function shown(page) {
  await page.waitForFunction(() => window.polhodeLive.isSettled);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
const near = (a, b, by, what) => assert.ok(Math.abs(a - b) <= by, `${what}: ${a}, not ${b}`);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/** Turns a vector by (w, x, y, z). */
function rotate([w, x, y, z], v) {
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
}

test("a slider changes the scenario and the motion; undo, redo and reset bring texts back", async () => {
  const { page, problems, close } = await open();
  assert.equal(await page.evaluate(() => window.polhode.clock.playing), false, "nothing moves that nobody started");
  const first = await text(page);
  const slider = knob(page, SPIN).locator("input[type=range]");
  assert.equal(await slider.getAttribute("aria-valuetext"), "6 rad/s");
  await slider.focus();
  // Answers that come late take no step back: 12 of a hundred of the range from −9 to 9 rad/s.
  await page.route("**/motion", async (route) => {
    await new Promise((done) => setTimeout(done, 150));
    await route.continue().catch(() => undefined);
  });
  // At one time of the page's clock: however slow the machine is, the presses are less than a second apart.
  await page.evaluate(() => {
    const [real, now] = [Date.now, Date.now()];
    Date.now = () => now;
    window.goOn = () => (Date.now = real);
  });
  for (let k = 0; k < 12; k += 1) {
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(70);
  }
  await page.evaluate(() => void window.goOn());
  await page.unrouteAll({ behavior: "ignoreErrors" });
  await page.waitForFunction(() => window.polhode.app.motion.omega[2] > 8);
  const shown = Number((await knob(page, SPIN).locator(".knob-value").inputValue()).split(" ")[0]);
  near(shown, 6 + 12 * 0.18, 0.1, "every press counts");
  await shows(page, `"${shown} rad/s"`);
  near((await omegaAtStart(page))[2], shown, 1e-12, "ω at the start is what the knob says");
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => window.polhode.app.motion.omega[2] === 6);
  assert.equal(await text(page), first, "one step for all of it");
  await page.keyboard.press("Control+y");
  await shows(page, `"${shown} rad/s"`);
  await page.click("#actions >> text=Reset");
  await page.waitForFunction(() => window.polhode.app.motion.omega[2] === 6);
  assert.equal(await text(page), first);
  assert.deepEqual(problems, []);
  await close();
});

test("a slider by its other keys: a large step, the ends; every change is seen in its field", async () => {
  const { page, problems, close } = await open();
  const slider = knob(page, SPIN).locator("input[type=range]");
  await slider.focus();
  const shown = async (key) => {
    const before = await knob(page, SPIN).locator(".knob-value").inputValue();
    await page.keyboard.press(key);
    await page.waitForFunction(([key, before]) => document.querySelector(`.knob[data-key="${key}"] .knob-value`).value !== before, [SPIN, before]);
    return Number.parseFloat(await knob(page, SPIN).locator(".knob-value").inputValue());
  };
  // From −9 to 9 rad/s.
  near(await shown("PageUp"), 6 + 1.8, 0.1, "a tenth of the range");
  near(await shown("PageDown"), 6, 0.1, "and back");
  near(await shown("End"), 9, 0.01, "the end");
  near(await shown("Home"), -9, 0.01, "the beginning");
  await page.waitForFunction(() => Math.abs(window.polhode.app.motion.omega[2] + 9) < 0.01);
  assert.deepEqual(problems, []);
  await close();
});

test("a knob: Shift moves it ten times finer, and a double click opens its number without a change", async () => {
  const { page, problems, close } = await open();
  const one = knob(page, SPIN);
  const value = async () => Number.parseFloat(await one.locator(".knob-value").inputValue());
  assert.deepEqual(await one.locator(".knob-range span").allInnerTexts(), ["−9", "9"]);
  const box = await one.locator("input[type=range]").boundingBox();
  const y = box.y + box.height / 2;
  // The thumb, 16 px wide, goes from end to end of the track: from −9 to 9 rad/s.
  const unit = (box.width - 16) / 18;
  const x = box.x + 8 + 15 * unit;
  await page.mouse.move(x + 3, y);
  await page.mouse.down();
  near(await value(), 6, 1e-12, "a press on the thumb moves nothing");
  await page.keyboard.down("Shift");
  await page.mouse.move(x + 3 - 2 * unit, y, { steps: 5 });
  near(await value(), 5.8, 0.01, "with Shift");
  await page.keyboard.up("Shift");
  await page.mouse.move(x + 3 - 4 * unit, y, { steps: 5 });
  near(await value(), 3.8, 0.03, "without");
  await page.mouse.up();
  const [last] = [await value()];
  await page.mouse.dblclick(box.x + 8 + 4 * unit, y);
  assert.equal(await value(), last);
  assert.ok(await one.locator(".knob-value").evaluate((field) => field === document.activeElement));
  await page.keyboard.type("2.5");
  await page.keyboard.press("Enter");
  await shows(page, '"2.5 rad/s"');
  await page.click("#actions >> text=Reset");
  await shows(page, '"6 rad/s"');
  assert.deepEqual(problems, []);
  await close();
});

test("a drag shows motions on the way, and is one step", async () => {
  const { page, problems, close } = await open();
  const first = await text(page);
  await page.evaluate(() => {
    const { app } = window.polhode;
    window.seen = 0;
    const show = app.show.bind(app);
    app.show = (...all) => {
      window.seen += 1;
      show(...all);
    };
  });
  const box = await knob(page, RADIUS).locator("input[type=range]").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (let k = 0; k <= 20; k += 1) await page.mouse.move(box.x + box.width * (0.5 + 0.012 * k), box.y + box.height / 2);
  await page.mouse.up();
  const value = await knob(page, RADIUS).locator(".knob-value").inputValue();
  assert.notEqual(value, "6 mm");
  await shows(page, `radius = "${value}"`);
  assert.ok((await page.evaluate(() => window.seen)) >= 2, "more than the last of them was shown");
  await page.click("#actions >> text=Undo");
  await shows(page, 'radius = "6 mm"');
  assert.equal(await text(page), first);
  assert.deepEqual(problems, []);
  await close();
});

test("a typed value keeps its own unit, and one that is none is said at its knob while the last motion stays", async () => {
  const { page, problems, close } = await open();
  const field = knob(page, RADIUS).locator(".knob-value");
  await field.fill("0.2 in");
  await field.press("Enter");
  await shows(page, 'radius = "0.2 in"');
  const mass = await page.evaluate(() => window.polhode.app.page.body.mass);
  await field.fill("5 foo");
  await field.press("Enter");
  await page.waitForSelector(".troubled");
  assert.match(await page.locator("#trouble").innerText(), /foo/);
  assert.match(await knob(page, RADIUS).locator(".knob-said").innerText(), /foo/);
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  assert.equal(await page.evaluate(() => window.polhode.app.page.body.mass), mass, "the last good motion stays");
  await page.click("#tab-scenario");
  assert.equal(await page.locator(".cm-lintRange-error").innerText(), '"5 foo"', "underlined where it is");
  assert.match(await page.locator(".errors").innerText(), /^\d+:\d+\s/);
  await shoot(page, "live-error");
  await field.fill("7");
  await field.press("Enter");
  await page.waitForFunction(() => !document.body.classList.contains("troubled"));
  assert.deepEqual(problems, []);
  await close();
});

test("the editor: typing moves the motion, keys are completed, and its undoing is the session's", async () => {
  const { page, problems, close } = await open();
  await page.click("#tab-scenario");
  const line = page.locator(".cm-line", { hasText: "duration" });
  await line.click();
  await page.keyboard.press("End");
  for (let k = 0; k < 3; k += 1) await page.keyboard.press("ArrowLeft");
  await page.keyboard.type("5");
  await page.waitForFunction(() => window.polhode.clock.end === 205);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => window.polhode.clock.end === 20);
  assert.equal(await line.innerText(), 'duration = "20 s"');
  await page.keyboard.press("Control+End");
  await page.keyboard.type("\nmet");
  await page.keyboard.press("Control+Space");
  await page.waitForSelector(".cm-tooltip-autocomplete");
  assert.match(await page.locator(".cm-tooltip-autocomplete").innerText(), /method/);
  assert.deepEqual(problems, []);
  await close();
});

test("ω by its tip: dragged in the plane that faces the eye, and by keys", async () => {
  const { page, problems, close } = await open();
  const before = await omegaAtStart(page);
  const tip = page.locator(".tip");
  const box = await tip.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 8; k += 1) await page.mouse.move(x + 10 * k, y + 2 * k);
  await page.waitForFunction((w) => Math.abs(window.polhode.app.motion.omega[0] - w) > 0.3, before[0]);
  // While it is in the hand: when it is let go, the camera may step back to have all of the motion in its frame.
  await shown(page);
  const now = await tip.boundingBox();
  near(now.x + now.width / 2, x + 80, 4, "the arrow's tip is under the pointer");
  near(now.y + now.height / 2, y + 16, 4, "the arrow's tip is under the pointer");
  await page.mouse.up();
  const eye = await page.evaluate(() => {
    const { camera, target } = window.polhode.view.orbit;
    return camera.position.clone().sub(target).normalize().toArray();
  });
  const q = await attitude(page);
  const after = await omegaAtStart(page);
  const change = rotate(q, after.map((w, k) => w - before[k]));
  assert.ok(Math.abs(dot(change, eye)) < 0.03 * Math.hypot(...change), "no part of the change is along the line of sight");
  await tip.focus();
  const size = Math.hypot(...after);
  await page.keyboard.press("+");
  await page.waitForFunction((size) => Math.abs(Math.hypot(...window.polhode.app.motion.omega.subarray(0, 3)) / size - 1.04) < 1e-3, size);
  assert.match(await tip.getAttribute("aria-valuetext"), /^\|ω\| = [\d.]+ rad\/s; body axes/);
  assert.deepEqual(problems, []);
  await close();
});

test("the body is thrown: it goes on from where it is let go, as it was turned; held still it rests", async () => {
  const { page, problems, close } = await open();
  await page.keyboard.press("g");
  assert.equal(await page.getAttribute("#throw", "aria-pressed"), "true");
  const box = await page.locator("#canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2 - 60, box.y + box.height / 2];
  // With times of its own, ms: however slow the machine is, the hand is as fast as it says.
  const devtools = await page.context().newCDPSession(page);
  const drag = async (rest) => {
    const hand = { button: "left", buttons: 1, clickCount: 1, y };
    const start = Date.now();
    const does = (type, step, wait = 0) =>
      devtools.send("Input.dispatchMouseEvent", { ...hand, type, x: x + 8 * step, timestamp: (start + 16 * step + wait) / 1000 });
    await does("mousePressed", 0);
    for (let k = 1; k <= 12; k += 1) await does("mouseMoved", k);
    const held = await page.evaluate(() => window.polhode.view.attitude);
    await does("mouseReleased", 12, rest);
    await page.waitForFunction(() => window.polhode.view.held === null);
    return held;
  };
  const azimuth = await page.evaluate(() => window.polhode.view.orbit.azimuth);
  const held = await drag(0);
  assert.equal(await page.evaluate(() => window.polhode.view.orbit.azimuth), azimuth, "the camera stays");
  const start = await page.evaluate(() => window.polhode.attitudeAt(0));
  near(Math.abs(dot(held, start)), 1, 1e-4, "the motion begins where the body was let go");
  const omega = rotate(start, await omegaAtStart(page));
  assert.ok(Math.hypot(...omega) > 0.05, `it turns: ${omega}`);
  // To the right: about the axis that points up on the screen.
  const up = await page.evaluate(() => {
    const { camera } = window.polhode.view.orbit;
    return camera.up.clone().set(0, 1, 0).applyQuaternion(camera.quaternion).toArray();
  });
  assert.ok(dot(omega, up) > 0.9 * Math.hypot(...omega), `${omega} is along ${up}`);
  assert.ok(await page.evaluate(() => window.polhode.clock.playing));
  await drag(300);
  assert.deepEqual((await omegaAtStart(page)).map(Math.abs), [0, 0, 0], "held still, it rests");
  assert.deepEqual(problems, []);
  await close();
});

test("the triangle of moments asks before it replaces parts, then moves in what exists", async () => {
  const { page, problems, close } = await open();
  await page.click("text=Moments");
  await page.locator(".pad").focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForSelector("dialog.question");
  await page.click("dialog.question button:text-is('Replace')");
  await shows(page, '"tensor"');
  const moments = () => page.evaluate(() => window.polhode.app.page.body.principal.moments);
  const first = await moments();
  const box = await page.locator(".pad").boundingBox();
  // Far outside: the nearest that exists is a rod or a plate.
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.6);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 2);
  await page.mouse.up();
  await page.waitForFunction((first) => Math.abs(window.polhode.app.page.body.principal.moments[1] - first) > 1e-9, first[1]);
  await shown(page);
  const [a, b, c] = await moments();
  near(a + b, c, 1e-4 * c, "an edge is a plate");
  near(a + b + c, first[0] + first[1] + first[2], 1e-4 * c, "the sum stays");
  assert.deepEqual(problems, []);
  await close();
});

test("an edit that cannot be made is said, and changes nothing", async () => {
  const { page, problems, close } = await open();
  const before = await text(page);
  for (const [edit, said] of [
    [{ moments: [1, 1.5, 3] }, "the inertia tensor is impossible"],
    [{ set: "body.part[7].radius", value: "1" }, "body.part[7].radius"],
  ]) {
    await page.evaluate((edit) => window.polhodeLive.edit(edit), edit);
    await page.waitForFunction((said) => window.polhodeLive.trouble?.message.includes(said) && document.body.innerText.includes(said), said);
    assert.equal(await text(page), before);
  }
  await page.evaluate(() => window.polhodeLive.edit({ omega: [1, 2, 3.5] }));
  await shows(page, '"3.5 rad/s"');
  assert.deepEqual(problems, []);
  await close();
});

test("a torque that is added turns up in plots and switches, and can be switched off", async () => {
  const { page, problems, close } = await open();
  const kinds = await page.locator(".knob-foot select option").allInnerTexts();
  for (const kind of kinds.slice(1).filter((text) => !text.includes("needs"))) {
    await page.selectOption(".knob-foot select", { label: kind });
    await page.waitForSelector(".switch");
    assert.equal(await page.locator("#trouble").isVisible(), false, `${kind}: ${await page.locator("#trouble").innerText()}`);
    await page.locator(".switch").click();
    await page.waitForFunction(() => document.querySelector(".switch")?.getAttribute("aria-checked") === "false");
    await page.click("#actions >> text=Reset");
    await page.waitForFunction(() => document.querySelector(".switch") === null || document.querySelector(".switches").hidden);
  }
  assert.deepEqual(problems, []);
  await close();
});

test("dropped files become documents: a scenario with its mesh, each of several meshes; what has no motion is looked at", async () => {
  const { page, problems, close } = await open();
  const choose = (...files) => page.setInputFiles("input[type=file]", files);
  await choose(example("bracket.toml"), example("bracket.stl"));
  await shows(page, 'title = "Angle bracket, tumbling"');
  await page.waitForFunction(() => window.polhode.app.page.title === "Angle bracket, tumbling");
  assert.equal(await page.evaluate(() => window.polhode.app.page.body.shapes[0].of), 216);
  const listed = (name) => page.waitForFunction((name) => [...document.querySelectorAll("#documents option")].some((option) => option.textContent === name), name);
  await listed("bracket.toml");
  await choose(example("meshes/bracket.ply"), example("water.xyz"));
  await listed("bracket.ply");
  await listed("water.xyz");
  await shows(page, 'file = "bracket.ply"');
  assert.match(await text(page), /unit = "mm" +# the file has no unit/);
  // As the hand drops them, with one triangle left out.
  const torn = readFileSync(example("meshes/bracket.off"), "utf8").trimEnd().split("\n");
  torn[2] = torn[2].replace("216", "215");
  const said = (part) => page.waitForFunction((part) => document.body.innerText.includes(part), part);
  const drop = (name, contents) =>
    page.evaluate(
      ([name, contents]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([contents], name));
        document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
      },
      [name, contents],
    );
  await drop("torn.off", torn.slice(0, -1).join("\n"));
  await said("It bounds no solid");
  await drop("arm.urdf", readFileSync(example("robots/arm.urdf"), "utf8"));
  await said("6 links");
  await drop("notes.txt", "no body at all");
  await said("notes.txt");
  await page.selectOption("#documents", { label: "bracket.ply" });
  await shows(page, 'file = "bracket.ply"');
  assert.deepEqual(problems.filter((problem) => !problem.includes("422")), []);
  await close();
});

test("a link brings the state back, in another tab that goes its own way", async () => {
  const { page, problems, close } = await open();
  const field = knob(page, SPIN).locator(".knob-value");
  await field.fill("3.5 rad/s");
  await field.press("Enter");
  await shows(page, '"3.5 rad/s"');
  await page.click("#actions >> text=Link");
  await page.waitForFunction(() => location.hash.startsWith("#state="));
  const fragment = await page.evaluate(() => location.hash);
  const other = await open({}, fragment);
  await shows(other.page, '"3.5 rad/s"');
  await other.page.click("#actions >> text=Reset");
  await shows(other.page, '"6 rad/s"');
  assert.match(await text(page), /3\.5 rad\/s/);
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#actions >> text=Save TOML")]);
  assert.equal(readFileSync(await saved.path(), "utf8"), await text(page));
  assert.deepEqual([...problems, ...other.problems], []);
  await Promise.all([close(), other.close()]);
});

test("a scenario that is too long for a link is not cut: it is said, and the address stays", async () => {
  const { page, problems, close } = await open();
  const address = page.url();
  // Digits that do not pack.
  const noise = Array.from({ length: 12_000 }, (_, k) => Math.sin(k * k).toFixed(12).slice(3)).join("");
  await page.evaluate((noise) => window.polhodeLive.replace(`${window.polhodeLive.text}\n# ${noise}\n`, "test"), noise);
  await page.click("#actions >> text=Link");
  await page.waitForFunction(() => document.querySelector("#notice").textContent.includes("too long for a link"));
  assert.equal(page.url(), address);
  assert.deepEqual(problems, []);
  await close();
});

test("a file that changes on the disk is shown, or asked about if the person has changed it", async () => {
  const { page, problems, close } = await open();
  const original = readFileSync(file, "utf8");
  try {
    writeFileSync(file, original.replace('"6 rad/s"', '"5 rad/s"'));
    await shows(page, '"5 rad/s"');
    const field = knob(page, SPIN).locator(".knob-value");
    await field.fill("4.5 rad/s");
    await field.press("Enter");
    await shows(page, '"4.5 rad/s"');
    writeFileSync(file, original.replace('"6 rad/s"', '"7 rad/s"'));
    await page.waitForSelector("#notice:not([hidden])");
    assert.match(await page.locator("#notice").innerText(), /t-handle\.toml changed on disk/);
    assert.match(await text(page), /4\.5 rad\/s/);
    await page.click("text=Take it");
    await shows(page, '"7 rad/s"');
  } finally {
    writeFileSync(file, original);
  }
  assert.deepEqual(problems, []);
  await close();
});

test("what the person has set stays when the motion changes; nothing piles up", async () => {
  const { page, problems, close } = await open();
  await page.click("[data-picture=poinsot]");
  await page.click("#layer-plane");
  await page.keyboard.press("Shift+ArrowRight");
  await page.evaluate(() => window.polhode.clock.set(7.5));
  const state = () =>
    page.evaluate(() => {
      const { view, clock } = window.polhode;
      return { picture: view.picture, azimuth: view.orbit.azimuth, time: clock.time, plane: document.querySelector("#layer-plane").ariaPressed, ...view.memory };
    });
  const before = await state();
  const withPixels = await withoutPixels(page);
  const kept = await page.evaluate(async () => {
    const { app } = window.polhode;
    const counts = [];
    for (let k = 0; k < 500; k += 1) {
      app.show({ ...app.page });
      window.polhode.view.render();
      if (k === 20) counts.push(window.polhode.view.memory);
    }
    return [...counts, window.polhode.view.memory];
  });
  await withPixels();
  await page.evaluate(() => window.polhode.view.render());
  assert.deepEqual(kept[1], kept[0], "geometries, textures, programs after 500 more");
  assert.deepEqual(await state(), { ...before, ...kept[0] });
  assert.equal(before.plane, "false");
  assert.deepEqual(problems, []);
  await close();
});

for (const [name, width, height, scheme] of [["desk", 1440, 900, "dark"], ["projector", 1024, 768, "light"], ["phone", 390, 844, "dark"]]) {
  test(`${name}: all of it has room, and every control a name`, async () => {
    const { page, problems, close } = await open({ viewport: { width, height }, colorScheme: scheme });
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage.height >= 0.36 * height, `the scene is ${stage.height} high`);
    const knobs = await page.locator("#knobs > .knob-grid .knob").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().bottom));
    assert.ok(knobs.length >= 4 && knobs.length <= 7, `${knobs.length} knobs`);
    const transport = await page.locator(".transport").boundingBox();
    assert.ok(knobs.every((bottom) => bottom <= (width > 820 ? height : transport.y)), `on the first screen: ${knobs}`);
    const tracks = await page.locator("#knobs > .knob-grid input[type=range]").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().width));
    assert.ok(tracks.every((wide) => wide >= 160), `${tracks}`);
    const bar = await page.locator(width > 820 ? ".bar > :not(.space), #tabs button" : ".bar > :not(.space, .segments)").evaluateAll((all) => all.map((one) => one.getBoundingClientRect()));
    assert.ok(bar.every(({ right }) => right <= width), "tools and tabs fit");
    assert.ok(bar.slice(0, 5).every(({ top, bottom }) => Math.abs(top + bottom - bar[0].top - bar[0].bottom) < 4), "tools are in one row");
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, "nothing is cut off at the right");
    for (const id of ["photograph", "home", "throw"]) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x + box.width <= (width > 820 ? stage.width : width), id);
    }
    assert.deepEqual(await unnamed(page), []);
    await shoot(page, `live-${name}`);
    assert.deepEqual(problems, []);
    await close();
  });
}
