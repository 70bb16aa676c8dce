// A body on the ground, in a real browser, from disk.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, open, shoot, unnamed } from "./browser.mjs";
import { rotate } from "./sample.mjs";
import { BALL, ball, FIRST, grips, sliding } from "./sliding.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** At a time: where the body is, and the curves' last points and how many pieces they have; lengths in m. */
const seen = (page, time) =>
  page.evaluate((t) => {
    const { clock, view } = window.polhode;
    clock.set(t);
    view.render();
    const unit = view.model.radius;
    const layer = (id) => view.layers.find((one) => one.id === id);
    const object = (id) => layer(id).objects[0];
    const end = (id) => {
      const { geometry } = object(id).children[0];
      const ends = geometry.attributes.instanceStart.data.array;
      const at = 6 * (geometry.instanceCount - 1) + 3;
      return { count: geometry.instanceCount, point: [...ends.slice(at, at + 3)].map((x) => x * unit) };
    };
    const camera = view.orbit.camera;
    const mark = object("touch").position;
    const inFrame = mark.clone().project(camera);
    const ground = object("ground").parent.quaternion;
    return {
      touch: mark.toArray().map((x) => x * unit),
      path: end("ground-path"),
      body: end("body-path"),
      attitude: view.attitudeAt(t),
      frame: [inFrame.x, inFrame.y],
      ground: { visible: object("ground").visible, turn: [ground.w, ground.x, ground.y, ground.z] },
    };
  }, time);

test("the ball moves over the floor, and the point of contact draws on both", async () => {
  const { page, problems, close } = await open(browser, "sliding", sliding());
  const [c, s] = [Math.cos(BALL.along), Math.sin(BALL.along)];
  const near = (found, wanted, within) => assert.ok(Math.hypot(...found.map((x, k) => x - wanted[k])) < within, `${found} ${wanted}`);
  let before = { path: { count: 0 }, body: { count: 0 } };
  for (const t of [0.1, 0.4137, BALL.duration]) {
    const now = await seen(page, t);
    const { way, angle } = ball(t);
    near(now.touch, [c * way, s * way, 0], 1e-5);
    // Curves are a little above their surfaces.
    near(now.path.point, [c * way, s * way, 0], 0.02 * BALL.radius);
    // In the body the point goes round against the turn, in a great circle.
    const back = (v) => {
      const [a, b] = [Math.cos(-angle), Math.sin(-angle)];
      const [along, up] = [c * v[0] + s * v[1], v[2]];
      return [along * a + up * b, up * a - along * b];
    };
    const size = Math.hypot(...now.body.point);
    assert.ok(Math.abs(size - BALL.radius) < 0.02 * BALL.radius, `${size}`);
    const [along, up] = back([0, 0, -BALL.radius]);
    near(rotate(FIRST, now.body.point), [c * along, s * along, up], 0.02 * BALL.radius);
    assert.ok(now.path.count > before.path.count && now.body.count > before.body.count, "they grow");
    assert.ok(now.frame.every((x) => Math.abs(x) < 1), `${now.frame}: it stays in the frame`);
    assert.ok(now.ground.visible);
    before = now;
  }
  const earlier = await seen(page, 0.2);
  assert.ok(earlier.path.count < before.path.count, "and go back with the time");
  await shoot(page, "contact");
  await page.click("#layer-ground");
  assert.equal((await seen(page, 0.2)).ground.visible, false);
  assert.match(await page.textContent("#legend"), /Floor, squares of \d+ mm.*Path on the floor.*Path on the body/s);
  // With the body the camera goes along.
  await page.click("#ride");
  const ride = await page.evaluate(() => {
    const { view } = window.polhode;
    view.render();
    return [view.orbit.target.toArray(), view.layers.find(({ id }) => id === "touch").objects[0].position.toArray()];
  });
  assert.ok(Math.hypot(...ride[0].map((x, k) => x - ride[1][k])) < 2, `${ride}`);
  assert.deepEqual(await unnamed(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test("its forces, slip, energies and height are plotted, and bands say when it slides", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page, problems, close } = await open(browser, `contact-${colorScheme}`, sliding(), { colorScheme });
    const plain = async (id) => (await page.textContent(id)).replaceAll(/(\d)[\s\u202f\u2009\u00a0](?=\d)/g, "$1");
    const titles = await page.locator("#panel-plots h3").allTextContents();
    for (const title of ["Energy", "Force of the ground", "Slip of the point of contact", "Height of the centre of mass"]) assert.ok(titles.includes(title), `${titles}`);
    assert.match(await plain("#plot-contact-force"), /N\s=\s3\.92000\sN/);
    assert.match(await plain("#plot-height"), /h\s=\s(0\.0500000\sm|50\.0000\smm)/);
    assert.match(await page.textContent("#plot-energy"), /work of friction/);
    const said = (await page.textContent(".phases")).replaceAll("\u00a0", " ");
    assert.equal(said, `sliding from 0 s to ${grips.toFixed(4)} srolling from ${grips.toFixed(4)} s to 1.400 s`);
    assert.match(await page.textContent(".events"), /Agrips/);
    // The paper of a plot differs to the left and to the right of the change.
    const colours = await page.evaluate((at) => {
      const canvas = document.querySelector("#plot-slip canvas");
      const pen = canvas.getContext("2d");
      const { left, width } = document.querySelector("#plot-slip .u-over").getBoundingClientRect();
      const from = canvas.getBoundingClientRect().left;
      const ratio = canvas.width / canvas.getBoundingClientRect().width;
      const { data } = pen.getImageData(0, Math.round(canvas.height * 0.2), canvas.width, 6);
      // The least of the paper of a small field, beside its grid.
      const under = (part) => {
        const x = Math.round((left - from + part * width) * ratio);
        return Math.min(...[0, 1, 2, 3, 4, 5].flatMap((row) => [0, 1, 2, 3, 4, 5].map((k) => data[4 * (row * canvas.width + x + k) + 3])));
      };
      return [under(0.4 * at), under(0.5 + at / 2)];
    }, grips / BALL.duration);
    assert.ok(colours[0] > 15 && colours[1] === 0, `${colours}`);
    await shoot(page, `contact-plots-${colorScheme}`);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("a turntable turns under its path in space", async () => {
  const { page, problems, close } = await open(browser, "turntable", sliding({ rate: 3 }));
  const { ground } = await seen(page, 0.5);
  [Math.cos(0.75), 0, 0, Math.sin(0.75)].forEach((x, k) => assert.ok(Math.abs(ground.turn[k] - x) < 1e-12, `${ground.turn}`));
  assert.match(await page.textContent("#legend"), /Turntable, rings.*Path in space.*Path on the turntable/s);
  await page.click("#layer-ground-trace");
  await shoot(page, "turntable");
  assert.deepEqual(problems, []);
  await close();
});

test("the floor fades before the frame ends", async () => {
  const { page, problems, close } = await open(browser, "floor", sliding());
  for (const viewport of [{ width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    await page.setViewportSize(viewport);
    await page.waitForFunction(({ width }) => {
      const { camera } = window.polhode.view.orbit;
      const { clientWidth, clientHeight } = document.querySelector("#canvas");
      return innerWidth === width && Math.abs(camera.aspect - clientWidth / clientHeight) < 1e-9;
    }, viewport);
    const beyond = await page.evaluate(() => {
      const { view } = window.polhode;
      const { clientWidth, clientHeight } = document.querySelector("#canvas");
      const found = [];
      for (const [turn, rise] of [[0, 0], [1.3, 0.2], [2.2, -0.15]]) {
        view.orbit.turn(turn, rise);
        view.render();
        const [floor] = view.layers.find(({ id }) => id === "ground").objects;
        const { position, color } = floor.children[0].geometry.attributes;
        for (let k = 0; k < position.count; k += 1) {
          if (color.getW(k) < 0.37) continue;
          const [x, y] = view.project(view.orbit.target.clone().fromBufferAttribute(position, k));
          if (x < -1 || y < -1 || x > clientWidth + 1 || y > clientHeight + 1) found.push([x, y, color.getW(k)]);
        }
      }
      return found;
    });
    assert.deepEqual(beyond, [], "only its faint edge is beyond the frame");
  }
  assert.deepEqual(problems, []);
  await close();
});
