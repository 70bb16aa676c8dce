// The page in a real browser, from disk.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { folder, launch, open, shoot, withoutPixels } from "./browser.mjs";
import { integrate, ORBIT, rotate, samples, tensor, WHEEL } from "./sample.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser.close();
  console.log(`pages and screenshots: ${folder}`);
});

const numbers = (text) => new Float64Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
const time = (page) => page.evaluate(() => window.polhode.clock.time);
/** The part of the picture's pixels that are not paper. */
const inked = (page) =>
  page.evaluate(() => {
    const canvas = window.polhode.picture();
    const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 4; i < pixels.length; i += 4) {
      const differs = [0, 1, 2].some((k) => Math.abs(pixels[i + k] - pixels[k]) > 12);
      if (differs) count += 1;
    }
    return count / (pixels.length / 4);
  });

test("it loads from disk without errors or requests, and every picture and tab opens", async () => {
  const { page, problems, close } = await open(browser, "free", samples.free(), { smooth: true });
  const stage = async () => JSON.stringify(await page.locator("#stage").boundingBox());
  const place = await stage();
  for (const picture of ["body", "poinsot", "cones", "sphere"]) {
    await page.click(`[data-picture=${picture}]`);
    assert.ok((await inked(page)) > 0.02, `${picture} is not blank`);
    assert.equal(await stage(), place, "nothing jumps");
    await shoot(page, `free-${picture}`);
  }
  for (const tab of ["numbers", "working", "scenario", "about", "plots"]) {
    await page.click(`#tab-${tab}`);
    assert.ok((await page.locator(`#panel-${tab}`).innerText()).length > 40, tab);
    assert.equal(await stage(), place, "nothing jumps");
    await shoot(page, `tab-${tab}`);
  }
  assert.equal(await page.locator("#panel-working math mfrac").count(), 2);
  assert.deepEqual(problems, []);
  await close();
});

test("play moves the body; keys, buttons and the scrubber set the time", async () => {
  const { page, problems, close } = await open(browser, "play", samples.free());
  assert.equal(await page.evaluate(() => window.polhode.clock.playing), false, "reduced motion starts at rest");
  const shown = () => page.evaluate(() => window.polhode.attitudeAt(window.polhode.clock.time));
  const rest = await shown();
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.polhode.clock.time > 0.2);
  assert.notDeepEqual(await shown(), rest);
  await page.keyboard.press("Space");
  await page.keyboard.press("Home");
  assert.equal(await time(page), 0);
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await time(page)) - 0.01) < 1e-12, "one sample on");
  await page.keyboard.press("End");
  assert.equal(await time(page), 20);
  await page.keyboard.press("+");
  assert.equal(await page.textContent("#speed"), "×2");
  await page.click("#slower");
  assert.equal(await page.textContent("#speed"), "×1");
  const box = await page.locator("#scrub").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.ok(Math.abs((await time(page)) - 10) < 0.2);
  assert.equal(Number(await page.textContent("#time")).toFixed(1), (await time(page)).toFixed(1));
  await page.keyboard.press("?");
  assert.ok(await page.locator("#help").isVisible());
  await page.keyboard.press("Escape");
  await page.keyboard.press("2");
  assert.equal(await page.getAttribute("[data-picture=poinsot]", "aria-pressed"), "true");
  const azimuth = () => page.evaluate(() => window.polhode.view.orbit.azimuth);
  const before = await azimuth();
  await page.keyboard.press("Shift+ArrowRight");
  assert.notEqual(await azimuth(), before);
  const stage = await page.locator("#canvas").boundingBox();
  await page.mouse.move(stage.x + 200, stage.y + 200);
  await page.mouse.down();
  await page.mouse.move(stage.x + 300, stage.y + 200);
  await page.mouse.up();
  assert.ok(Math.abs((await azimuth()) - before) > 0.3, "dragging turns the camera");
  assert.deepEqual(problems, []);
  await close();
});

test("without a wish for reduced motion it plays at once", async () => {
  const { page, close } = await open(browser, "moving", samples.symmetric(), { reducedMotion: "no-preference" });
  await page.waitForFunction(() => window.polhode.clock.time > 0.05);
  await close();
});

test("the attitude that is shown is the table's", async () => {
  for (const name of ["free", "heavy"]) {
    const data = samples[name]();
    const { page, close } = await open(browser, name, data);
    const times = numbers(data.motion.times);
    const table = numbers(data.motion.attitude);
    for (const i of [0, 1, 137, 700, 1503, times.length - 1]) {
      const q = await page.evaluate((t) => window.polhode.attitudeAt(t), times[i]);
      const want = [...table.subarray(4 * i, 4 * i + 4)];
      const sign = Math.sign(q.reduce((sum, x, k) => sum + x * want[k], 0));
      q.forEach((x, k) => assert.ok(Math.abs(sign * x - want[k]) < 1e-6, `${name} ${i}: ${q} ${want}`));
    }
    // To the screen: the tip of each body axis is where the camera sees R e.
    const i = 700;
    const tips = await page.evaluate((t) => {
      const { clock, view } = window.polhode;
      clock.set(t);
      view.render();
      const { position, up } = view.orbit.camera;
      const placed = view.labels.placed.map(({ text, tipX, tipY }) => ({ text, tipX, tipY }));
      const stage = document.querySelector("#stage");
      return { placed, eye: position.toArray(), up: up.toArray(), target: view.orbit.target.toArray(), w: stage.clientWidth, h: stage.clientHeight, fov: view.orbit.camera.fov };
    }, times[i]);
    const minus = (a, b) => a.map((x, k) => x - b[k]);
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
    const unit = (a) => a.map((x) => x / Math.hypot(...a));
    const ahead = unit(minus(tips.target, tips.eye));
    const right = unit(cross(ahead, tips.up));
    const above = cross(right, ahead);
    const focal = tips.h / 2 / Math.tan((tips.fov * Math.PI) / 360);
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, k) => {
      const p = minus(rotate([...table.subarray(4 * i, 4 * i + 4)], axis.map((x) => 1.3 * x)), tips.eye);
      const x = tips.w / 2 + (focal * dot(p, right)) / dot(p, ahead);
      const y = tips.h / 2 - (focal * dot(p, above)) / dot(p, ahead);
      const label = tips.placed.find(({ text }) => text === ["𝑥", "𝑦", "𝑧"][k]);
      assert.ok(Math.hypot(label.tipX - x, label.tipY - y) < 0.05, `${name}: axis ${k} at ${x}, ${y}, not ${label.tipX}, ${label.tipY}`);
    });
    await close();
  }
});

test("torques, wheels and events have their places among the plots", async () => {
  const heavy = await open(browser, "torque", samples.heavy());
  assert.equal(await heavy.page.locator("#plot-torque .key-entry").count(), 3);
  assert.deepEqual(await heavy.page.locator("#plot-torque .constants p").allTextContents(), ["Nz = 0"]);
  assert.equal(await heavy.page.locator(".event").count(), 0);
  assert.deepEqual(heavy.problems, []);
  await heavy.page.locator("#plot-torque").scrollIntoViewIfNeeded();
  await shoot(heavy.page, "torque");
  await heavy.close();

  const { page, problems, close } = await open(browser, "wheels", samples.wheeled());
  for (const id of ["wheels", "wheel-speeds", "pointing"]) assert.equal(await page.locator(`#plot-${id}`).count(), 1);
  for (const id of ["torque", "axis"]) assert.equal(await page.locator(`#plot-${id}`).count(), 0);
  const marks = page.locator("#plot-omega .event");
  assert.equal(await marks.count(), 3);
  const over = await page.locator("#plot-omega .u-over").boundingBox();
  const box = await marks.first().boundingBox();
  assert.ok(Math.abs(box.x - over.x - (5 / 60) * over.width) < 2, "it stands at its time");
  assert.deepEqual(await marks.allTextContents(), ["A", "BC", ""]);
  assert.match(await page.textContent(".events"), /A<b>motor on<\/b>, at t\s=\s5\.000\ss.*C.*The first 3 of 5 events\./);
  await page.click(".event-entry >> nth=1");
  assert.equal(await time(page), 25, "its entry in the key goes to its time");
  await shoot(page, "events");
  assert.deepEqual(problems, []);
  await close();
});

/** Boxes of elements with the text in them. */
const boxes = (page, selector) =>
  page.locator(selector).evaluateAll((all) =>
    all.map((e) => ({ text: e.textContent, ...e.getBoundingClientRect().toJSON() })).filter(({ width, text }) => width > 0 && text !== ""),
  );
const overlap = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5;

test("axes have titles with units, constants are text, and no text overprints another or a curve", async () => {
  for (const [name, data] of Object.entries({ free: samples.free(), heavy: samples.heavy(), wheeled: samples.wheeled() })) {
    const { page, problems, close } = await open(browser, `titles-${name}`, data);
    const titles = await page.locator(".axis-title").allTextContents();
    assert.ok(titles.every((title) => /^\S.* \(\S.*\)$/.test(title)), `${titles}`);
    for (const figure of await page.locator(".plot:has(.stack)").all()) {
      const below = await figure.locator(".axis-title.x").allTextContents();
      assert.deepEqual(below, ["time t (s)"], "one time axis for all plots of a figure");
      assert.equal(await figure.locator(".axis-title.y").count(), await figure.locator(".stack").count());
    }
    const texts = [".axis-title", ".event span", ".key-entry", ".constants p", ".plot h3", ".tag:not([hidden])", ".event-entry"];
    const all = (await Promise.all(texts.map((selector) => boxes(page, selector)))).flat();
    const frames = await page.locator(".u-over").evaluateAll((all) => all.map((e) => e.getBoundingClientRect().toJSON()));
    all.forEach((a, k) => {
      for (const b of all.slice(k + 1)) assert.ok(!overlap(a, b), `${name}: ${a.text} over ${b.text}`);
      for (const frame of frames) assert.ok(!overlap(a, frame), `${name}: ${a.text} over a curve`);
    });
    if (name === "free") {
      assert.match(await page.textContent("#plot-energy .constants"), /^T = 2\.797\d{2}\u00a0mJ, constant to \d/);
      assert.equal(await page.locator("#plot-energy .stack").count(), 1);
    }
    if (name === "wheeled") assert.equal(await page.locator("#plot-momentum .stack").count(), 0, "nothing but zeros is no plot");
    assert.deepEqual(problems, []);
    await close();
  }
});

test("a fast spin is drawn as its envelope, small components beside large ones, until it is zoomed", async () => {
  const { page, problems, close } = await open(browser, "envelope", samples.heavy());
  assert.match(await page.textContent("#plot-omega .constants"), /^ωz = 120\.000\u00a0rad\/s, constant/);
  const tag = page.locator("#plot-torque .tag >> nth=0");
  assert.equal(await tag.textContent(), "Nx, Ny: envelope, zoom in for the curve");
  await page.locator("#plot-torque").scrollIntoViewIfNeeded();
  const box = await page.locator("#plot-torque .u-over >> nth=0").boundingBox();
  await page.mouse.move(box.x + 0.2 * box.width, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.26 * box.width, box.y + 30, { steps: 4 });
  await page.mouse.up();
  assert.equal(await tag.isVisible(), false, "the curve itself");
  await shoot(page, "zoomed");
  await page.locator("#plot-torque .u-over >> nth=0").dblclick();
  assert.equal(await tag.isVisible(), true);
  assert.deepEqual(problems, []);
  await close();
});

test("of a top that takes another's place the plots stay, the path of its axis is its own, and goes with the top", async () => {
  const { page, problems, close } = await open(browser, "tops", samples.heavy());
  await page.locator("#plot-axis").scrollIntoViewIfNeeded();
  const bounds = () => page.textContent("#plot-axis .key-entry >> nth=3");
  const before = await bounds();
  await page.evaluate(() => {
    window.kept = document.querySelector("#plot-omega canvas");
    const { app } = window.polhode;
    const [least, most] = app.page.top.bounds;
    app.show({ ...app.page, top: { ...app.page.top, bounds: [least - 0.01, most + 0.01] } });
  });
  await page.waitForFunction((before) => document.querySelectorAll("#plot-axis .key-entry")[3].textContent !== before, before);
  const degrees = (text) => text.match(/[\d.]+/g).map(Number);
  degrees(await bounds()).forEach((x, k) => assert.ok(Math.abs(x - degrees(before)[k] - [-1, 1][k] * 0.573) < 2e-3));
  assert.equal(await page.evaluate(() => window.kept === document.querySelector("#plot-omega canvas")), true);
  assert.equal(await page.locator("#plot-axis").count(), 1);
  await page.evaluate(() => window.polhode.app.show({ ...window.polhode.app.page, top: null }));
  assert.equal(await page.locator("#plot-axis").count(), 0);
  assert.deepEqual(problems, []);
  await close();
});

test("the path of a top's axis is on the page, with the axis of the view on it", async () => {
  const data = samples.heavy();
  const { page, problems, close } = await open(browser, "axis", data);
  const plot = page.locator("#plot-axis");
  await plot.scrollIntoViewIfNeeded();
  assert.match(await plot.textContent(), /34\.377° to 44\.3\d*° from the vertical/);
  assert.ok((await plot.locator("svg text").allTextContents()).includes("angle from the vertical (°)"));
  const dots = () => plot.locator("circle.axis-now").evaluateAll((all) => all.map((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]));
  const before = await dots();
  await page.evaluate(() => window.polhode.clock.set(0.61));
  const after = await dots();
  before.forEach(([x, y], k) => assert.ok(Math.hypot(x - after[k][0], y - after[k][1]) > 4, "it moves"));
  assert.match(await plot.textContent(), /t = 0 … 2\.1\d* s/);
  await page.evaluate(() => window.polhode.clock.set(3));
  assert.match(await plot.textContent(), /t = 2\.1\d* … 4\.2\d* s/, "the nutations around the time of the view");
  await shoot(page, "axis");
  assert.deepEqual(problems, []);
  await close();
});

test("numbers do not break across lines, and nothing is cut off at a small laptop's or a phone's size", async () => {
  for (const [width, height] of [[1024, 768], [390, 844]]) {
    for (const [name, data] of Object.entries({ heavy: samples.heavy(), wheeled: samples.wheeled() })) {
      data.facts.push({
        title: "Long",
        rows: [
          { label: "last bit of the inputs", value: "(3.14749×10⁻⁵, −0.001103086, 1.167607×10⁻⁴)", unit: "rad/s", note: "of 3.253193 rad/s (186.394 deg/s)" },
          { label: "torque", value: "µ = 3.986004×10¹⁴ m³/s², periapsis = 6.878137×10⁶ m, period = 5676.978 s", unit: "", note: "" },
        ],
      });
      const { page, problems, close } = await open(browser, `size-${name}-${width}`, data, { viewport: { width, height } });
      for (const tab of ["plots", "numbers", "scenario", "about"]) {
        await page.click(`#tab-${tab}`);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `${tab} at ${width}`);
        const wide = await page.evaluate(
          (id) => {
            const panel = document.querySelector(`#panel-${id}`);
            const right = panel.getBoundingClientRect().right;
            return [...panel.querySelectorAll("*")].filter((e) => !e.closest("pre") && e.getBoundingClientRect().right > right + 0.5).map((e) => e.className);
          },
          tab,
        );
        assert.deepEqual(wide, [], `${tab} at ${width}`);
      }
      await page.click("#tab-numbers");
      const lines = await page.locator(".facts .nowrap").evaluateAll((all) => all.map((e) => [e.textContent, e.getBoundingClientRect().height]));
      assert.ok(lines.length > 20);
      for (const [text, tall] of lines) assert.ok(tall < 26, `${text} is broken`);
      assert.ok(lines.some(([text]) => text === "1.167607×10⁻⁴)\u00a0rad/s"), "a number stays with its unit");
      await page.click("#tab-plots");
      const buttons = await page.locator("button:visible").evaluateAll((all) => all.map((e) => e.getBoundingClientRect().toJSON()));
      assert.ok(buttons.every(({ left, right }) => left >= 0 && right <= width), "controls are in the window");
      await shoot(page, `size-${name}-${width}`);
      assert.deepEqual(problems, []);
      await close();
    }
  }
});

test("the plots read values, set the time and follow it", async () => {
  const data = samples.free();
  const { page, problems, close } = await open(browser, "plots", data);
  const over = page.locator("#plot-omega .u-over");
  const box = await over.boundingBox();
  const [x, y] = [box.x + 0.3 * box.width, box.y + 40];
  await page.mouse.move(x - 5, y);
  await page.mouse.move(x, y);
  const reading = async () => (await page.locator("#plot-omega .reading").first().textContent()).replace("−", "-");
  const omega = numbers(data.motion.omega);
  const i = Math.round(0.3 * 2000);
  const near = Array.from({ length: 9 }, (_, k) => omega[3 * (i + k - 4)]);
  const read = Number(await reading());
  assert.equal(await page.locator("#plot-omega .key .unit").first().textContent(), "rad/s");
  assert.ok(read > Math.min(...near) - 0.01 && read < Math.max(...near) + 0.01, `${read} of ${near}`);
  assert.equal(await time(page), 0, "pointing does not move the time");
  await page.mouse.click(x, y);
  assert.ok(Math.abs((await time(page)) - 6) < 0.1, "a click does");
  const left = (id) => page.locator(`#plot-${id} .now >> nth=0`).evaluate((e) => e.getBoundingClientRect().left);
  assert.ok(Math.abs((await left("omega")) - x) < 3);
  assert.ok(Math.abs((await left("angles")) - (await left("omega"))) < 1, "all plots show one time");
  await page.mouse.move(10, 10);
  await page.evaluate(() => window.polhode.clock.set(12));
  assert.equal(await reading(), (await page.evaluate((v) => v.toPrecision(5), omega[3 * 1200])).toString(), "values at the time of the view");
  await page.mouse.move(box.x + 0.2 * box.width, y);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.4 * box.width, y, { steps: 4 });
  await page.mouse.up();
  await page.evaluate(() => window.polhode.clock.set(6));
  assert.ok(Math.abs((await left("drift")) - (box.x + 0.5 * box.width)) < 12, "zoomed to 4 … 8 s, all plots alike");
  assert.deepEqual(problems, []);
  await close();
});

test("plots have one set of axes, chosen above them; principal axes in the view are dashed", async () => {
  const { page, problems, close } = await open(browser, "axis-sets", samples.free());
  const titles = () => page.locator("#panel-plots h3").allInnerTexts();
  const along = (set) => [`Angular velocity, ${set}`, set === "space axes" ? "Energy" : `Kinetic energy, ${set}`, `Angular momentum, ${set}`];
  assert.deepEqual((await titles()).slice(0, 3), along("body axes"));
  for (const [value, set] of [["principal", "principal axes"], ["space", "space axes"], ["body", "body axes"]]) {
    await page.selectOption("#axis-set", value);
    await page.waitForFunction((title) => document.querySelector("#plot-omega h3").textContent === title, along(set)[0]);
    await page.locator("#plot-momentum").scrollIntoViewIfNeeded();
    await page.waitForFunction((title) => document.querySelector("#plot-momentum h3").textContent === title, along(set)[2]);
    assert.deepEqual((await titles()).slice(0, 3), along(set));
  }
  const shafts = await page.evaluate(() =>
    ["body-axes", "principal-axes"].map((id) => {
      const kinds = new Set();
      window.polhode.view.layers.find((layer) => layer.id === id).objects[0].traverse(({ geometry }) => geometry && kinds.add(geometry.type));
      return [...kinds].sort().join();
    }),
  );
  assert.deepEqual(shafts, ["ConeGeometry,CylinderGeometry", "ConeGeometry,LatheGeometry"]);
  assert.deepEqual(problems, []);
  await close();
});

test("each plot saves as SVG and PNG, and the frame as PNG", async () => {
  const { page, problems, close } = await open(browser, "save", samples.heavy());
  const save = async (click) => {
    const [download] = await Promise.all([page.waitForEvent("download"), click()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  for (const id of ["omega", "axis", "energy", "momentum", "angles", "drift"]) {
    const svg = await save(() => page.locator(`#plot-${id} button`, { hasText: "SVG" }).click());
    assert.equal(svg.name, `a-heavy-top-released-at-rest-${id}.svg`);
    const root = await page.evaluate(
      (text) => new DOMParser().parseFromString(text, "image/svg+xml").documentElement.nodeName,
      svg.bytes.toString("utf8"),
    );
    assert.equal(root, "svg");
  }
  for (const click of [() => page.locator("#plot-drift button", { hasText: "PNG" }).click(), () => page.click("#photograph")]) {
    const png = await save(click);
    assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
    assert.ok(png.bytes.length > 5000, png.name);
  }
  assert.deepEqual(problems, []);
  await close();
});

test("hostile text is text", async () => {
  const evil = `</script><script>alert(1)</script>"'<img src=x onerror=alert(1)><!--`;
  const data = samples.free();
  Object.assign(data, { title: evil, source: evil, scenario: evil });
  data.body.shapes.forEach((shape) => (shape.name = evil));
  data.motion.method = evil;
  data.motion.drift.forEach((line) => (line.name = evil));
  data.facts = [{ title: evil, rows: [{ label: evil, value: evil, unit: evil, note: evil }] }];
  data.findings = [{ severity: "warning", message: evil }];
  data.explanation = [
    { kind: "heading", level: 1, text: evil },
    { kind: "text", text: evil },
    { kind: "lines", lines: [evil] },
    { kind: "table", header: [evil], rows: [[evil]] },
    { kind: "picture", svg: '<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"><script>alert(1)</script></svg>', text: evil },
    ...[
      "<math><mi>x</mi><script>alert(1)</script></math>",
      '<math><mi onclick="alert(1)">x</mi></math>',
      '<math href="javascript:alert(1)"><mi>x</mi></math>',
      "<math><mtext><img src=x onerror=alert(1)></mtext></math>",
      "<img src=x onerror=alert(1)>",
      "<math><annotation-xml encoding='text/html'><p>x</p></annotation-xml></math>",
    ].map((mathml) => ({ kind: "formula", mathml, text: `plain ${evil}` })),
  ];
  const { page, problems, close } = await open(browser, "hostile", data);
  for (const tab of ["numbers", "working", "scenario", "about"]) await page.click(`#tab-${tab}`);
  assert.equal(await page.textContent("#title"), evil);
  assert.equal(await page.textContent(".scenario"), evil);
  assert.equal(await page.locator("img").count(), 1);
  assert.equal(await page.locator("#panel-working img").evaluate((img) => img.decode().then(() => img.naturalWidth)), 10);
  assert.equal(await page.locator("math").count(), 0, "a formula that is not plain MathML is its text");
  assert.equal(await page.locator(".formula code").count(), 6);
  assert.equal(await page.locator("script").count(), 2, "the data and the page's own");
  const svg = page.waitForEvent("download");
  await page.click("#tab-plots");
  await page.locator("#plot-drift button", { hasText: "SVG" }).click();
  const text = readFileSync(await (await svg).path(), "utf8");
  assert.ok(!text.includes("<script") && !text.includes("<img"));
  assert.deepEqual(problems, []);
  await close();
});

test("a phone shows it without scrolling sideways; dark colours are dark", async () => {
  const { page, problems, close } = await open(browser, "phone", samples.free(), {
    viewport: { width: 390, height: 844 },
    isMobile: true,
    hasTouch: true,
    colorScheme: "dark",
  });
  for (const tab of ["numbers", "working", "scenario", "about", "plots"]) {
    await page.click(`#tab-${tab}`);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, tab);
  }
  await shoot(page, "phone-dark");
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await paper();
  assert.ok(dark.match(/\d+/g).every((c) => Number(c) < 60), dark);
  await page.click("#theme");
  assert.equal(await paper(), "rgb(255, 255, 255)");
  await shoot(page, "phone-light");
  assert.deepEqual(problems, []);
  await close();
});

test("colours are those of the system, or of the button, on the page, in plots and in the view", async () => {
  const { page, problems, close } = await open(browser, "theme", samples.free(), { colorScheme: "light" });
  const [light, dark] = [["rgb(255, 255, 255)", "a8418f", "#a8418f"], ["rgb(15, 20, 24)", "e08fc8", "#e08fc8"]];
  const seen = () =>
    page.evaluate(async () => {
      const { view } = window.polhode;
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const [shaft] = view.layers.find(({ id }) => id === "omega").objects[0].children;
      const label = getComputedStyle([...document.querySelectorAll(".label")].find((e) => e.textContent === "𝛚")).color;
      const hex = `#${label.match(/\d+/g).map((c) => Number(c).toString(16).padStart(2, "0")).join("")}`;
      return [getComputedStyle(document.body).backgroundColor, shaft.material.color.getHexString(), hex];
    });
  assert.deepEqual(await seen(), light);
  await page.emulateMedia({ colorScheme: "dark" });
  assert.deepEqual(await seen(), dark, "the system's, at once");
  await page.click("#theme");
  assert.deepEqual(await seen(), light, "the button wins");
  await page.emulateMedia({ colorScheme: "light" });
  await page.click("#theme");
  assert.deepEqual(await seen(), dark);
  // A curve of a plot is drawn on a canvas, in a colour that this must understand.
  const curve = await page.evaluate(() => {
    const canvas = document.querySelector("#panel-plots canvas");
    const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) if (pixels[i] === 0xff && pixels[i + 1] === 0x8a && pixels[i + 2] === 0x3c) count += 1;
    return count;
  });
  assert.ok(curve > 50, `${curve} pixels of the y axis's colour`);
  assert.deepEqual(problems, []);
  await close();
});

test("labels keep off the body", async () => {
  const { page, close } = await open(browser, "labels", samples.balls());
  for (const t of [0, 1.7, 5.3, 9.1, 14.4]) {
    const boxes = await page.evaluate((t) => {
      window.polhode.clock.set(t);
      window.polhode.view.render();
      const stage = document.querySelector("#stage").getBoundingClientRect();
      return [...document.querySelectorAll(".label:not([hidden])")].map((e) => {
        const r = e.getBoundingClientRect();
        return { text: e.textContent, x: r.x - stage.x, y: r.y - stage.y, w: r.width, h: r.height };
      });
    }, t);
    assert.equal(boxes.length, 8);
    // Again with nothing but the body.
    const others = page.locator('#legend button[aria-pressed="true"]:not(#layer-body)');
    const ids = await others.evaluateAll((all) => all.map((b) => b.id));
    const press = () => page.evaluate((ids) => ids.forEach((id) => document.getElementById(id).click()), ids);
    await press();
    const touched = await page.evaluate((boxes) => {
      const canvas = window.polhode.picture();
      const pen = canvas.getContext("2d", { willReadFrequently: true });
      pen.resetTransform();
      const paper = pen.getImageData(0, 0, 1, 1).data;
      return boxes.filter(({ x, y, w, h }) => {
        const { data } = pen.getImageData(Math.max(x, 0), Math.max(y, 0), w, h);
        for (let i = 0; i < data.length; i += 4) if (Math.abs(data[i] - paper[0]) > 40) return true;
        return false;
      });
    }, boxes);
    assert.deepEqual(touched, [], `t = ${t}`);
    await press();
  }
  await close();
});

const SIZES = [[1440, 900], [1024, 768], [390, 844]];
const PICTURES = ["body", "poinsot", "cones", "sphere"];

test("names do not cover each other, whatever the picture, the time and the size", async () => {
  for (const name of ["free", "symmetric", "heavy", "wheeled"]) {
    for (const [width, height] of SIZES.slice(1)) {
      const { page, close } = await open(browser, `names-${name}`, samples[name](), { viewport: { width, height } });
      await withoutPixels(page);
      const end = await page.evaluate(() => window.polhode.clock.end);
      for (const picture of PICTURES) {
        if ((await page.locator(`[data-picture=${picture}]`).count()) === 0) continue;
        if (await page.locator(`[data-picture=${picture}]`).isVisible()) await page.click(`[data-picture=${picture}]`);
        const parts = [0, 0.117, 0.37, 0.583, 0.761, 0.94];
        const frames = await page.evaluate(
          (times) =>
            times.map((t) => {
              window.polhode.clock.set(t);
              window.polhode.view.render();
              const box = (e) => (({ x, y, width, height }) => ({ text: e.textContent, x, y, width, height }))(e.getBoundingClientRect());
              return { boxes: [...document.querySelectorAll(".label:not([hidden])")].map(box), stage: box(document.querySelector("#stage")) };
            }),
          parts.map((part) => part * end),
        );
        for (const [n, { boxes, stage }] of frames.entries()) {
          const where = `${name} ${picture} at ${parts[n]} of the run, ${width} × ${height}`;
          assert.ok(boxes.length >= 2, where);
          boxes.forEach((a, k) => {
            assert.ok(a.x >= stage.x && a.x + a.width <= stage.x + stage.width, `${a.text} is in the frame: ${where}`);
            assert.ok(a.y >= stage.y && a.y + a.height <= stage.y + stage.height, `${a.text} is in the frame: ${where}`);
            for (const b of boxes.slice(k + 1)) {
              const apart = Math.max(a.x - b.x - b.width, b.x - a.x - a.width, a.y - b.y - b.height, b.y - a.y - a.height);
              assert.ok(apart > -0.5, `${a.text} and ${b.text}: ${where}`);
            }
          });
        }
      }
      await close();
    }
  }
});

test("each picture has its line and its names, and nothing that one can press is cut off", async () => {
  const names = { poinsot: ["invariable plane", "polhode", "herpolhode"], cones: ["body cone", "space cone"], sphere: ["separatrix", "𝐋"] };
  for (const [width, height] of SIZES) {
    const data = samples.free();
    const { page, close } = await open(browser, "cut", data, { viewport: { width, height } });
    await withoutPixels(page);
    for (const picture of PICTURES) {
      await page.click(`[data-picture=${picture}]`);
      await page.evaluate(() => window.polhode.view.render());
      assert.equal(await page.textContent("#caption"), data.scene.captions[picture]);
      const shown = await page.locator(".label:not([hidden])").allTextContents();
      for (const name of names[picture] ?? []) assert.ok(shown.includes(name), `${name} in ${picture} of ${shown}`);
      const cut = await page.evaluate(() => {
        const page = document.documentElement;
        const view = document.querySelector(".view").getBoundingClientRect();
        const all = [...document.querySelectorAll(".view button, .view select, .view input, #caption, .time")];
        return all.flatMap((e) => {
          const r = e.getBoundingClientRect();
          const host = e.closest("#legend, #caption, .transport, .bar").getBoundingClientRect();
          const out = [view, host].some((o) => r.left < o.left - 1 || r.right > o.right + 1 || r.top < o.top - 1 || r.bottom > o.bottom + 1);
          const small = e.scrollHeight > e.clientHeight + 2 && e.id === "caption";
          return r.width > 0 && (out || small || r.right > page.clientWidth || r.bottom > window.innerHeight) ? [e.id || e.textContent] : [];
        });
      });
      assert.deepEqual(cut, [], `${picture}, ${width} × ${height}`);
    }
    await close();
  }
});

test("the momentum sphere is round, arrows begin on it, and its separatrix is named on its line", async () => {
  const { page, problems, close } = await open(browser, "round", samples.free());
  await page.click("[data-picture=sphere]");
  const found = await page.evaluate(() => {
    const { view } = window.polhode;
    view.render();
    const label = view.labels.placed.find(({ text }) => text === "separatrix");
    const distance = Math.min(...label.along.map((p) => Math.hypot(...view.project(p).map((c, k) => c - [label.x, label.y][k]))));
    for (const id of ["principal-axes", "momentum", "mark"]) view.toggle(view.layers.find((one) => one.id === id));
    view.render();
    // Where rays from the middle of the sphere leave the ink.
    const drawn = document.querySelector("#canvas");
    const picture = document.createElement("canvas");
    [picture.width, picture.height] = [drawn.width, drawn.height];
    picture.getContext("2d").drawImage(drawn, 0, 0);
    const { width, height } = picture;
    const { data } = picture.getContext("2d").getImageData(0, 0, width, height);
    const ratio = width / document.querySelector("#canvas").clientWidth;
    const [x, y] = view.project(view.orbit.target.clone().set(0, 0, 0)).map((c) => c * ratio);
    const isPaper = (px, py) => data[4 * (Math.round(py) * width + Math.round(px)) + 3] < 8;
    const radii = Array.from({ length: 360 }, (_, k) => {
      const [c, s] = [Math.cos((k * Math.PI) / 180), Math.sin((k * Math.PI) / 180)];
      let r = 50;
      while (!isPaper(x + r * c, y + r * s)) r += 0.5;
      return r;
    });
    return { distance, radii };
  });
  assert.ok(found.distance < 1, `${found.distance} px from its line`);
  // Seen in perspective off its axis, the sphere is an ellipse: neighbouring radii tell bumps.
  found.radii.forEach((r, k) => {
    const mean = (found.radii[(k + 355) % 360] + found.radii[(k + 5) % 360]) / 2;
    assert.ok(Math.abs(r - mean) < 2, `${r} px at ${k}°, beside ${mean}`);
  });
  const feet = await page.evaluate(() => {
    const { view } = window.polhode;
    const foot = (id) => {
      const feet = [];
      view.layers.find((one) => one.id === id).objects[0].traverse(({ geometry, position }) => /Lathe|Cylinder/.test(geometry?.type) && feet.push(position.y));
      return Math.min(...feet);
    };
    return [foot("momentum"), foot("principal-axes")];
  });
  assert.deepEqual(feet, [1, 1]);
  assert.deepEqual(problems, []);
  await close();
});

test("the mark on the momentum sphere is at L/|L|, and L points to it", async () => {
  const data = samples.free();
  const { page, close } = await open(browser, "mark", data);
  await page.click("[data-picture=sphere]");
  const momentum = numbers(data.motion.momentum);
  for (const i of [0, 411, 1333]) {
    const { mark, tip } = await page.evaluate((t) => {
      const { clock, view } = window.polhode;
      clock.set(t);
      view.render();
      const [object] = view.layers.find((layer) => layer.id === "mark").objects;
      const tip = view.labels.placed.find(({ text }) => text === "𝐋").tip;
      return { mark: object.getWorldPosition(object.position.clone()).toArray(), tip: tip.toArray() };
    }, i * 0.01);
    const l = [...momentum.subarray(3 * i, 3 * i + 3)];
    const size = Math.hypot(...l);
    l.forEach((x, k) => {
      assert.ok(Math.abs(mark[k] - (1.002 * x) / size) < 1e-6, `${i}: ${mark}`);
      assert.ok(Math.abs(tip[k] - (1.25 * x) / size) < 1e-6, `${i}: ${tip}`);
    });
  }
  await close();
});

/** The ends of the pieces of a curve of some pixels' width. */
const curvePoints = (id) => {
  const points = [];
  window.polhode.view.layers.find((layer) => layer.id === id).objects[0].traverse((line) => {
    if (!line.isLine2) return;
    const ends = line.geometry.attributes.instanceStart.data.array;
    for (let k = 0; k < ends.length; k += 6) points.push([ends[k], ends[k + 1], ends[k + 2]]);
  });
  return points;
};

test("a heavy top has its circles, the path of its axis, a floor, and gravity at its centre of mass", async () => {
  for (const name of ["heavy", "tilted"]) {
    const data = samples[name]();
    const { up } = data.top;
    const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
    const { page, problems, close } = await open(browser, `top-${name}`, data);
    const seconds = data.scene.period / (await page.evaluate(() => window.polhode.clock.speed));
    assert.ok(seconds >= 5 && seconds <= 10, `a precession in ${seconds} s`);
    const bounds = data.top.bounds;
    const angle = (p) => Math.acos(dot(p, up) / Math.hypot(...p));
    const circles = await page.evaluate(curvePoints, "bounds");
    const found = [...new Set(circles.map((p) => angle(p).toFixed(5)))];
    assert.deepEqual(found, bounds.map((theta) => theta.toFixed(5)));
    const path = await page.evaluate(curvePoints, "path");
    const attitude = numbers(data.motion.attitude);
    for (const i of [0, 7, 1234]) {
      const want = rotate([...attitude.subarray(4 * i, 4 * i + 4)], [0, 0, 1]);
      const nearest = Math.min(...path.map((p) => Math.hypot(...p.map((x, k) => x / 1.3 - want[k]))));
      assert.ok(nearest < 1e-6, `sample ${i} is on the path: ${nearest}`);
    }
    assert.ok(path.every((p) => angle(p) > bounds[0] - 1e-4 && angle(p) < bounds[1] + 1e-4));
    const { at, tip, unit, floor } = await page.evaluate((t) => {
      const { clock, view } = window.polhode;
      clock.set(t);
      view.render();
      const object = (id) => view.layers.find((layer) => layer.id === id).objects[0];
      const tip = view.labels.placed.find(({ text }) => text === "𝐠").tip.toArray();
      return { at: object("gravity").position.toArray(), tip, unit: view.model.radius, floor: object("floor").position.toArray() };
    }, 2.468);
    const i = 1234;
    const middle = rotate([...attitude.subarray(4 * i, 4 * i + 4)], data.body.lever).map((x) => x / unit);
    middle.forEach((x, k) => assert.ok(Math.abs(at[k] - x) < 1e-6));
    assert.deepEqual(floor, [0, 0, 0]);
    const arrow = tip.map((x, k) => x - at[k]);
    up.forEach((x, k) => assert.ok(Math.abs(arrow[k] + x * Math.hypot(...arrow)) < 1e-9, "it points down"));
    await shoot(page, `top-${name}`);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("a satellite has the directions of its orbit and the cones of its pointings, and fills the picture", async () => {
  const data = samples.orbiting();
  for (const [colorScheme, viewport] of [["light", { width: 1440, height: 900 }], ["dark", { width: 390, height: 844 }]]) {
    const { page, problems, close } = await open(browser, `sky-${colorScheme}`, data, { colorScheme, viewport });
    const legend = await page.locator("#legend button").allInnerTexts();
    for (const name of ["Nadir", "Velocity", "Target of panel", "camera, cone of 43°", "panel"]) assert.ok(legend.includes(name), `${name} of ${legend}`);
    const phase = 0.05 * 20;
    const at = (angle) => [Math.cos(angle), 0.6 * Math.sin(angle), 0.8 * Math.sin(angle)].map((c) => 1.5 * c);
    const found = await page.evaluate(() => {
      const { clock, view } = window.polhode;
      const seen = (t) => {
        clock.set(t);
        view.render();
        const cone = view.layers.find(({ id }) => id === "pointing-0").objects[0].children[1];
        return { color: cone.material.color.getHexString(), tips: Object.fromEntries(view.labels.placed.map(({ text, tip }) => [text, tip.toArray()])) };
      };
      const { clientWidth, clientHeight } = document.querySelector("#canvas");
      const inside = seen(0);
      const outside = seen(5);
      const late = seen(20);
      const spots = view.model.outline.map((p) => view.project(p.clone().applyQuaternion(view.layers.find(({ id }) => id === "body").objects[0].parent.quaternion)));
      const [xs, ys] = [0, 1].map((k) => spots.map((spot) => spot[k]));
      const size = Math.max((Math.max(...xs) - Math.min(...xs)) / clientWidth, (Math.max(...ys) - Math.min(...ys)) / clientHeight);
      return { inside, outside, late, size };
    });
    // At t = 0 the camera is 0.7 rad off, at 5 s 0.9 rad; its limit is 0.75.
    assert.notEqual(found.inside.color, found.outside.color, "the cone that the target has left is marked");
    for (const [name, wanted] of [["nadir", at(phase + Math.PI).map((c) => (1.7 / 1.5) * c)], ["velocity", at(phase + Math.PI / 2)], ["target of panel", [0.9, 0.96, -0.72]]]) {
      wanted.forEach((c, k) => assert.ok(Math.abs(found.late.tips[name][k] - c) < 1e-5, `${name}: ${found.late.tips[name]}, not ${wanted}`));
    }
    assert.ok(found.size > 0.3, `the body takes ${found.size} of the picture, whatever its tape`);
    await shoot(page, `sky-${colorScheme}`);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("a satellite has its orbit in a corner, with its place there, and no label on it; and the Sun if there is one", async () => {
  const data = samples.orbiting();
  data.motion.directions[2].name = "sun";
  for (const [colorScheme, viewport] of [["light", { width: 1024, height: 768 }], ["dark", { width: 390, height: 844 }]]) {
    const { page, problems, close } = await open(browser, `orbit-${colorScheme}`, data, { colorScheme, viewport });
    const found = await page.evaluate(() => {
      const { clock, view } = window.polhode;
      const { clientWidth, clientHeight } = document.querySelector("#canvas");
      const corner = view.orbitShown.corner(clientWidth, clientHeight);
      const inCorner = () => {
        const canvas = window.polhode.picture();
        const scale = canvas.width / clientWidth;
        const pixels = canvas.getContext("2d").getImageData(scale * corner.x, scale * corner.y, scale * corner.size, scale * corner.size).data;
        let count = 0;
        for (let i = 4; i < pixels.length; i += 4) if ([0, 1, 2].some((k) => Math.abs(pixels[i + k] - pixels[k]) > 12)) count += 1;
        return count / (pixels.length / 4);
      };
      const places = [7, 24].map((t) => {
        clock.set(t);
        view.render();
        const { points, place } = view.orbitShown;
        const names = view.labels.placed.map(({ text, x, y }) => ({ text, x, y }));
        return { place: place.toArray(), points: points.map((p) => p.toArray()), names };
      });
      clock.set(0);
      view.render();
      const on = inCorner();
      const sun = view.layers.find(({ label }) => label === "Sun").objects[0].children.map(({ type }) => type);
      const layer = view.layers.find(({ id }) => id === "orbit");
      view.toggle(layer);
      view.render();
      const off = { ink: inCorner(), corner: view.orbitShown };
      view.toggle(layer);
      return { corner, places, on, off, sun, height: clientHeight };
    });
    const { corner } = found;
    assert.ok(corner.x >= 0 && corner.y + corner.size <= found.height && corner.size >= 80);
    assert.ok(found.on > 0.1 && found.off.ink < 0.02 && found.off.corner === null, JSON.stringify([found.on, found.off]));
    const a = ORBIT.parameter / (1 - 0.09);
    for (const [k, t] of [7, 24].entries()) {
      const { place, points, names } = found.places[k];
      // The direction from the centre turns by 0.05 rad/s; the centre of the ellipse is the origin.
      const out = [Math.cos(0.05 * t), 0.6 * Math.sin(0.05 * t), 0.8 * Math.sin(0.05 * t)];
      const r = ORBIT.parameter / (1 + out.reduce((sum, x, c) => sum + x * ORBIT.eccentricity[c], 0));
      place.forEach((x, c) => assert.ok(Math.abs(x - (r * out[c]) / a - ORBIT.eccentricity[c]) < 1e-6, `${place}`));
      assert.ok(Math.min(...points.map((p) => Math.hypot(...p.map((x, c) => x - place[c])))) < 0.03);
      assert.ok(names.length > 5 && names.every(({ x, y }) => x > corner.x + corner.size || y < corner.y), JSON.stringify(names));
    }
    assert.deepEqual(found.sun, ["Group", "Mesh"], "an arrow and a ball");
    await shoot(page, `orbit-${colorScheme}`);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("a wheel has its axis, h, and says when its motor runs", async () => {
  const data = samples.wheeled();
  const { page, problems, close } = await open(browser, "wheel", data);
  const shown = (t) =>
    page.evaluate((t) => {
      const { clock, view } = window.polhode;
      clock.set(t);
      view.render();
      const frame = view.layers.find((layer) => layer.id === "wheels").objects[0];
      const h = view.labels.placed.find(({ text }) => text === "𝐡")?.tip.clone();
      // Back to the body's axes.
      const body = h?.applyQuaternion(frame.getWorldQuaternion(view.orbit.camera.quaternion.clone()).invert()).toArray();
      return { h: body ?? null, names: [...document.querySelectorAll(".label:not([hidden])")].map((e) => e.textContent) };
    }, t);
  const before = await shown(2);
  assert.equal(before.h, null, "at rest it has none");
  assert.ok(before.names.includes("wheel"));
  const middle = await shown(15);
  assert.ok(middle.names.includes("wheel, motor on"));
  const after = await shown(50);
  assert.ok(after.names.includes("wheel"));
  const [half, whole] = [middle.h, after.h].map((h) => Math.hypot(...h));
  assert.ok(Math.abs(half / whole - 0.5) < 1e-6, "its length goes as h");
  after.h.forEach((x, k) => assert.ok(Math.abs(x / whole - WHEEL[k]) < 1e-6, `${after.h}`));
  await shoot(page, "wheel");
  assert.deepEqual(problems, []);
  await close();
});

test("formulas and letters of the view are set in the font of the page", async () => {
  const { page, problems, close } = await open(browser, "font", samples.free());
  await page.click("#tab-working");
  await page.evaluate(() => document.fonts.ready);
  assert.deepEqual(await page.evaluate(() => [...document.fonts].map((f) => [f.family.replaceAll('"', ""), f.status])), [["Polhode Math", "loaded"]]);
  // Before DevTools come: they load the page's style sheet once more, which is a complaint on the console.
  assert.deepEqual(problems, []);
  const client = await page.context().newCDPSession(page);
  await client.send("DOM.enable");
  await client.send("CSS.enable");
  const { root } = await client.send("DOM.getDocument");
  for (const [selector, least] of [["#panel-working mi, #panel-working mn", 5], [".label.symbol", 5]]) {
    const { nodeIds } = await client.send("DOM.querySelectorAll", { nodeId: root.nodeId, selector });
    const used = [];
    for (const nodeId of nodeIds) used.push(...(await client.send("CSS.getPlatformFontsForNode", { nodeId })).fonts);
    assert.ok(nodeIds.length >= 1 && used.reduce((sum, { glyphCount }) => sum + glyphCount, 0) >= least, selector);
    for (const { familyName, isCustomFont } of used) assert.ok(isCustomFont && familyName === "STIX Two Math", `${selector}: ${familyName}`);
  }
  await client.detach();
  await close();
});

test("the dot of a derivative stands above its letter", async () => {
  const accent = (letter) => `<math><mover accent="true"><mi>${letter}</mi><mi>˙</mi></mover></math>`;
  const letters = [..."ω𝛚ηT"];
  const explanation = letters.map((text) => ({ kind: "formula", mathml: accent(text), text }));
  const { page, problems, close } = await open(browser, "dots", { ...samples.free(), explanation });
  await page.click("#tab-working");
  await page.evaluate(() => document.fonts.ready);
  await page.addStyleTag({ content: ".formula { font-size: 60px; padding: 20px }" });
  for (const [k, letter] of letters.entries()) {
    const box = await page.locator("mover").nth(k).boundingBox();
    const clip = { x: box.x, y: box.y - 10, width: box.width, height: box.height + 20 };
    const picture = (await page.screenshot({ clip })).toString("base64");
    // Rows of pixels with ink: the dot, a gap, the letter.
    const runs = await page.evaluate(async (picture) => {
      const image = new Image();
      image.src = `data:image/png;base64,${picture}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext("2d");
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, image.width, image.height);
      const dark = (y) => Array.from({ length: image.width }, (_, x) => data[4 * (y * image.width + x)]).some((red) => red < 128);
      const rows = Array.from({ length: image.height }, (_, y) => dark(y));
      return rows.filter((inked, y) => inked && !rows[y - 1]).length;
    }, picture);
    assert.equal(runs, 2, letter);
  }
  assert.deepEqual(problems, []);
  await close();
});

test("a presentation has large type, and reveals the answer and the sections of the panel step by step", async () => {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }]) {
    const { page, problems, close } = await open(browser, "present", samples.free(), { viewport });
    const seen = () =>
      page.evaluate(() => ({
        caption: document.querySelector("#caption").checkVisibility({ visibilityProperty: true }),
        plots: [...document.querySelectorAll(".plot")].filter((plot) => plot.checkVisibility({ visibilityProperty: true })).length,
        full: document.fullscreenElement !== null,
        size: Number.parseFloat(getComputedStyle(document.querySelector("#caption")).fontSize),
      }));
    const all = (await seen()).plots;
    await page.keyboard.press("p");
    await page.waitForFunction(() => document.fullscreenElement !== null);
    const first = await seen();
    assert.deepEqual([first.caption, first.plots, first.full], [false, 0, true], "the body alone");
    assert.ok(first.size >= 24, `${first.size} px`);
    await page.keyboard.press("PageDown");
    assert.deepEqual([(await seen()).caption, (await seen()).plots], [true, 0], "the answer");
    for (const plots of [1, 2]) {
      await page.keyboard.press("PageDown");
      assert.equal((await seen()).plots, plots);
    }
    // Plots are read where they are.
    const box = await page.locator("#plot-energy .u-over").boundingBox();
    await page.mouse.click(box.x + 0.4 * box.width, box.y + box.height / 2);
    assert.ok(Math.abs((await time(page)) - 8) < 0.15, `${await time(page)} s`);
    const bar = await page.locator(".transport > *").evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect().right));
    const { right } = await page.locator(".view").evaluate((view) => view.getBoundingClientRect().toJSON());
    assert.ok(bar.every((end) => end <= right + 1), `${bar} in ${right}`);
    await shoot(page, `present-${viewport.width}`);
    await page.keyboard.press("PageUp");
    assert.equal((await seen()).plots, 1);
    await page.keyboard.press("p");
    await page.waitForFunction(() => document.fullscreenElement === null && !document.body.classList.contains("presenting"));
    assert.deepEqual([(await seen()).caption, (await seen()).plots], [true, all]);
    await page.keyboard.press("?");
    assert.match(await page.locator("#help").innerText(), /presentation: full screen, large type/);
    await page.keyboard.press("Escape");
    assert.deepEqual(problems, []);
    await close();
  }
});

test("every kind of body is drawn, and each page says what it leaves out", async () => {
  for (const name of ["mesh", "balls", "box", "symmetric", "heavy"]) {
    const { page, problems, close } = await open(browser, name, samples[name]());
    assert.ok((await inked(page)) > 0.02, name);
    assert.equal(await page.locator("[data-picture]").count(), name === "heavy" ? 1 : 4);
    if (name === "mesh") assert.match(await page.textContent("#view-note"), /200,704 of 800,000 triangles/);
    await shoot(page, name);
    assert.deepEqual(problems, [], name);
    await close();
  }
});

test("the inertia ellipsoid touches the invariable plane at the tip of ω", async () => {
  const data = samples.free();
  const { page, close } = await open(browser, "contact", data);
  await page.click("[data-picture=poinsot]");
  const omega = numbers(data.motion.omega);
  const attitude = numbers(data.motion.attitude);
  // At samples, and between two of them.
  for (const [i, part, near] of [[0, 0, 1e-6], [400, 0, 1e-6], [1111, 0, 1e-6], [700, 0.5, 1e-3]]) {
    const { contact, plane } = await page.evaluate((t) => {
      window.polhode.clock.set(t);
      window.polhode.view.render();
      const [plane, contact] = ["plane", "contact"].map((id) => window.polhode.view.layers.find((l) => l.id === id).objects[0]);
      return { plane: plane.position.toArray(), contact: contact.position.toArray() };
    }, (i + part) * 0.01);
    const distance = Math.hypot(...plane);
    const height = plane.reduce((sum, x, k) => sum + (x * contact[k]) / distance, 0);
    assert.ok(Math.abs(height / distance - 1) < near, `${i}: ${height} of ${distance}`);
    if (part > 0) continue;
    // The picture's scale: the plane is at 2T/|L|.
    const scale = distance / ((2 * data.free.energy) / data.free.momentum);
    const w = rotate([...attitude.subarray(4 * i, 4 * i + 4)], [...omega.subarray(3 * i, 3 * i + 3)]);
    w.forEach((x, k) => assert.ok(Math.abs(x * scale - contact[k]) < 1e-6));
  }
  await close();
});

test("the equivalent box is off until it is asked for, and stands about the centre of mass", async () => {
  for (const name of ["free", "heavy"]) {
    const data = samples[name]();
    const { page, problems, close } = await open(browser, `box-${name}`, data);
    const seen = () =>
      page.evaluate(() => {
        const { model, layers } = window.polhode.view;
        const [object] = layers.find((layer) => layer.id === "box").objects;
        const { width, height, depth } = object.children[0].geometry.parameters;
        const size = [width, height, depth].map((edge) => edge * model.radius);
        const [x, y, z, w] = object.quaternion.toArray();
        return { visible: object.visible, size, quaternion: [w, x, y, z], at: object.position.toArray().map((c) => c * model.radius) };
      });
    const near = (a, b) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) < 1e-9, `${a} ${b}`));
    const before = await inked(page);
    assert.equal((await seen()).visible, false);
    await page.click("#layer-box");
    const { visible, size, quaternion, at } = await seen();
    assert.equal(visible, true);
    near(size, data.body.box.size);
    near(quaternion, data.body.box.quaternion);
    near(at, data.body.lever);
    assert.ok((await inked(page)) > before, "it is seen");
    await shoot(page, `box-${name}`);
    assert.deepEqual(problems, []);
    await close();
  }
  const { page, close } = await open(browser, "no-box", { ...samples.free(), body: { ...samples.free().body, mass: null, box: null } });
  assert.equal(await page.locator("#layer-box").count(), 0);
  await close();
});

test("the edges: one sample, a rod, a permanent rotation, nothing that turns", async () => {
  const eight = (list) => Buffer.from(Float64Array.from(list).buffer).toString("base64");
  const one = (omega, momentum, moments) => {
    const data = samples.box();
    data.body.principal.moments = moments;
    data.body.ellipsoid.half = [1, 0, 0];
    const motion = { ...data.motion, count: 1, times: eight([0]), attitude: eight([0.6, 0, 0.8, 0]), kinetic: eight([1]) };
    Object.assign(motion, { omega: eight(omega), momentum: eight(momentum), drift: [] });
    const free = { ...data.free, period: null, polhode: eight(omega), herpolhode: eight(omega), separatrix: [], family: [], trace: eight([0, 0, 1]) };
    return { ...data, motion, free: { ...free, energy: 0.5, momentum: Math.hypot(...momentum) }, facts: [], findings: [] };
  };
  const cases = {
    rod: one([0, 0, 1], [-0.96, 0, -0.28], [0, 1, 1]),
    rest: one([0, 0, 0], [0, 0, 0], [1, 2, 2.5]),
  };
  for (const [name, data] of Object.entries(cases)) {
    const { page, problems, close } = await open(browser, name, data);
    const pictures = page.locator("[data-picture]");
    assert.equal(await pictures.count(), name === "rest" ? 1 : 4);
    for (let k = 1; k < (await pictures.count()); k += 1) {
      await pictures.nth(k).click();
      assert.ok((await inked(page)) > 0.002, `${name} ${k}`);
    }
    await page.keyboard.press("Space");
    assert.equal(await time(page), 0);
    assert.deepEqual(problems, [], name);
    await close();
  }
});

test("data that cannot be shown are named on the page", async () => {
  const data = samples.free();
  data.motion.times = data.motion.times.slice(0, 800);
  const file = await browser.newContext();
  const page = await file.newPage();
  const { pageOf } = await import("./page.mjs");
  await page.setContent(pageOf(data));
  assert.match(await page.textContent("#problem"), /times: 75 numbers instead of 2001/);
  await file.close();
});

test("the sample is a motion: energy and momentum keep", () => {
  const body = tensor([0.7, 1.3, 1.9], [0.5, 0.5, -0.5, 0.5]);
  const rows = integrate(body, [1, 0, 0, 0], [0.4, 1.1, -0.6], 10, 101);
  const energy = ({ omega }) => omega.reduce((sum, w, i) => sum + w * body.inertia[i].reduce((s, x, k) => s + x * omega[k], 0), 0);
  rows.forEach((row) => assert.ok(Math.abs(energy(row) / energy(rows[0]) - 1) < 1e-9));
});
