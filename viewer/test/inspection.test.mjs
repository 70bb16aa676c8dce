// What the live page shows of files that are no scenarios: meshes that bound no solid, and robots; with the program itself.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { emptyPage, launch, shoot, unnamed } from "./browser.mjs";
import { example, serve } from "./live-server.mjs";
import { load } from "./load.mjs";

const folder = mkdtempSync(join(tmpdir(), "polhode-inspection-"));
const torn = join(folder, "torn.off");
let browser;
let server;
before(async () => {
  // The bracket without its last triangle.
  const lines = readFileSync(example("meshes/bracket.off"), "utf8").trimEnd().split("\n");
  lines[2] = lines[2].replace("216", "215");
  writeFileSync(torn, `${lines.slice(0, -1).join("\n")}\n`);
  [browser, server] = await Promise.all([launch(), serve(example("t-handle.toml"), torn, example("robots/bad-arm.urdf"), example("robots/arm.sdf"))]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function open(options = {}) {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 }, ...options });
  await page.goto(server.address);
  await page.waitForFunction(() => document.querySelectorAll(".knob").length > 3);
  return { page, problems, close };
}

const choose = async (page, label) => {
  await page.selectOption("#documents", { label });
  await page.waitForFunction((label) => window.polhodeInspection.document?.name === label, label);
};
const chosen = (page) => page.evaluate(() => window.polhodeInspection.chosen);
/** How many pixels of the picture are nearer to this colour than to grey. */
const coloured = (page, [r, g, b]) =>
  page.evaluate(([r, g, b]) => {
    const canvas = window.polhodeInspection.view.photograph();
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let k = 0; k < data.length; k += 4) if (Math.hypot(data[k] - r, data[k + 1] - g, data[k + 2] - b) < 60) count += 1;
    return count;
  }, [r, g, b]);
const DANGER = [0xb3, 0x26, 0x1e];

test("a mesh that bounds no solid: its open edges are red, numbered as they are listed, and seen from near", async () => {
  const { page, problems, close } = await open();
  await choose(page, "torn.off");
  assert.equal(await page.locator("#title").innerText(), "torn.off");
  assert.equal(await page.locator("#stage").isVisible(), false, "the motion makes room");
  assert.equal(await page.locator("#knobs").isVisible(), false);
  const first = page.locator(".inspection-panel li").first();
  assert.match(await first.innerText(), /^1\s*Error the mesh is open.* 3 edges/s);
  assert.match(await first.locator(".hint").innerText(), /\w+ \w+/);
  assert.match(await page.locator(".inspection-panel").innerText(), /215 triangles/);
  const far = await coloured(page, DANGER);
  assert.ok(far > 20, `${far} red pixels`);
  const distance = () => page.evaluate(() => window.polhodeInspection.view.orbit.distance);
  const before = await distance();
  await first.locator("button").click();
  assert.equal(await first.locator("button").getAttribute("aria-pressed"), "true");
  const near = await coloured(page, DANGER);
  assert.ok(near > 2 * far, `${near} red pixels, ${far} from afar`);
  assert.ok((await distance()) < before / 2, "the camera goes there");
  await shoot(page, "inspection-mesh");
  await page.keyboard.press("Escape");
  assert.equal(await chosen(page), null);
  await page.click(".inspection [aria-label='Camera home']");
  await page.evaluate(() => window.polhodeInspection.view.photograph());
  assert.ok(Math.abs((await distance()) / before - 1) < 1e-9, "and back");
  assert.deepEqual(problems, []);
  await close();
});

test("a robot stands there: every link with its inertia, suspects in their colours; one is chosen in the list, in the picture or by keys", async () => {
  const { page, problems, close } = await open();
  await choose(page, "bad-arm.urdf");
  const panel = page.locator(".inspection-panel");
  assert.match(await panel.innerText(), /6 links: 3 impossible, 2 suspect, 1 without an inertial/);
  const links = await panel.locator(".entry b").allInnerTexts();
  assert.deepEqual(links.slice(0, 5), ["upper_arm", "forearm", "camera", "base", "hand"], "the worst first");
  assert.ok((await coloured(page, DANGER)) > 100, "the impossible are red");
  const entry = panel.locator("li", { hasText: "forearm" });
  await entry.locator("button").focus();
  await page.keyboard.press("Enter");
  assert.match(await entry.locator(".entry-more").innerText(), /line 24: .*Mass\s+0\.9\s*kg/s);
  assert.equal(await page.evaluate(() => document.activeElement.closest("li")?.querySelector("b").textContent), "forearm", "the focus stays");
  await shoot(page, "inspection-robot");
  await page.keyboard.press("Escape");
  // A click in the middle of a link's centre of mass, as the picture has it.
  const canvas = page.locator(".still canvas");
  const box = await canvas.boundingBox();
  await page.mouse.click(box.x + 3, box.y + 3);
  assert.equal(await chosen(page), null, "there is nothing in the corner");
  const found = new Set();
  for (let k = 1; k < 12 && found.size < 2; k += 1) {
    await page.mouse.click(box.x + box.width / 2, box.y + (box.height * k) / 12);
    const link = await chosen(page);
    if (link !== null) found.add(link);
    await page.keyboard.press("Escape");
  }
  assert.ok(found.size > 0, "a click finds a link");
  // The camera turns by keys.
  await canvas.focus();
  const azimuth = () => page.evaluate(() => window.polhodeInspection.view.orbit.azimuth);
  const was = await azimuth();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await azimuth(), was);
  assert.deepEqual(problems, []);
  await close();
});

test("the repair is seen before it is saved, and changes those lines and no others", async () => {
  const { page, problems, close } = await open();
  await choose(page, "bad-arm.urdf");
  const file = readFileSync(example("robots/bad-arm.urdf"), "utf8");
  const rows = await page.locator(".diff tr").evaluateAll((all) => all.map((row) => [Number(row.cells[0].textContent), row.cells[1].ariaLabel, row.cells[2].textContent]));
  const lines = file.split("\n");
  for (const [line, when, text] of rows) if (when === "before") assert.equal(lines[line - 1], text);
  for (const [line, when, text] of rows) if (when === "after") lines[line - 1] = text;
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("text=Save the repaired file")]);
  assert.equal(saved.suggestedFilename(), "bad-arm-fixed.urdf");
  const repaired = readFileSync(await saved.path(), "utf8");
  assert.equal(repaired, lines.join("\n"));
  assert.notEqual(repaired, file);
  assert.equal(readFileSync(example("robots/bad-arm.urdf"), "utf8"), file, "the file itself is as it was");
  assert.match(await page.locator(".repair [role=status]").innerText(), /bad-arm-fixed\.urdf is among your downloads/);
  assert.deepEqual(problems, []);
  await close();
});

test("a sound robot has no repair; parts of the picture can be hidden", async () => {
  const { page, problems, close } = await open();
  await choose(page, "arm.sdf");
  assert.equal(await page.locator(".repair").count(), 0);
  const picture = () => page.evaluate(() => window.polhodeInspection.view.photograph().toDataURL());
  const pictures = [await picture()];
  for (const name of ["Equivalent boxes", "Shapes"]) {
    await page.click(`.inspection .bar >> text=${name}`);
    assert.equal(await page.locator(`.inspection .bar >> text=${name}`).getAttribute("aria-pressed"), "false");
    pictures.push(await picture());
  }
  assert.equal(new Set(pictures).size, 3, "each of them was there");
  assert.deepEqual(problems, []);
  await close();
});

test("back at the motion all is as it was left, and a file that changes on the disk is looked at again", async () => {
  const { page, problems, close } = await open();
  const field = page.locator('.knob[data-key="start.spin.body[2]"] .knob-value');
  await field.fill("3.5 rad/s");
  await field.press("Enter");
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhodeLive.text.includes("3.5 rad/s"));
  const text = await page.evaluate(() => window.polhodeLive.text);
  await choose(page, "torn.off");
  // Keys of the motion do nothing to what is not seen.
  const time = await page.evaluate(() => window.polhode.clock.time);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("s");
  assert.equal(await page.evaluate(() => window.polhode.clock.time), time);
  assert.equal(await page.locator("dialog[open]").count(), 0);
  const file = readFileSync(torn, "utf8");
  try {
    const lines = file.trimEnd().split("\n");
    lines[2] = lines[2].replace("215", "214");
    writeFileSync(torn, `${lines.slice(0, -1).join("\n")}\n`);
    await page.waitForFunction(() => document.querySelector(".inspection-panel").textContent.includes("214 triangles"));
  } finally {
    writeFileSync(torn, file);
  }
  await page.waitForFunction(() => document.querySelector(".inspection-panel").textContent.includes("215 triangles"));
  const memory = () =>
    page.evaluate(() => {
      window.polhodeInspection.view.photograph();
      return window.polhodeInspection.view.memory;
    });
  const before = await memory();
  for (let k = 0; k < 10; k += 1) for (const name of ["bad-arm.urdf", "torn.off"]) await choose(page, name);
  const after = await memory();
  assert.ok(after.geometries <= before.geometries + 8 && after.textures === before.textures, `nothing piles up: ${JSON.stringify([before, after])}`);
  await page.selectOption("#documents", { label: "t-handle.toml" });
  await page.waitForFunction(() => !document.body.classList.contains("inspecting"));
  assert.equal(await page.evaluate(() => window.polhodeLive.text), text);
  assert.equal(await page.locator("#title").innerText(), await page.evaluate(() => window.polhode.app.page.title));
  assert.equal(await page.locator("#stage").isVisible(), true);
  assert.deepEqual(problems, []);
  await close();
});

test("a robot's folder that is dropped opens its models with their meshes; what is nothing to the page stays where it is", async () => {
  const { page, problems, close } = await open();
  const robot = join(folder, "robot");
  for (const path of ["meshes", "urdf", ".git"]) mkdirSync(join(robot, path), { recursive: true });
  writeFileSync(join(robot, "meshes/part.off"), readFileSync(example("meshes/bracket.off")));
  const inertial = '<inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial>';
  const visual = '<visual><geometry><mesh filename="package://robot/meshes/part.off" scale="0.001 0.001 0.001"/></geometry></visual>';
  writeFileSync(join(robot, "urdf/two.urdf"), `<robot name="two"><link name="only">${inertial}${visual}</link></robot>`);
  writeFileSync(join(robot, "package.xml"), "<package><name>robot</name></package>");
  writeFileSync(join(robot, ".git/HEAD"), "ref");
  writeFileSync(join(robot, "README.md"), "words");
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    window.sent = [];
    Worker.prototype.postMessage = function (message, ...rest) {
      if ("path" in message) window.sent.push(message.path);
      return postMessage.call(this, message, ...rest);
    };
  });
  await page.setInputFiles("input[webkitdirectory]", robot);
  await page.waitForFunction(() => window.polhodeInspection.document?.name === "two.urdf");
  const sent = await page.evaluate(() => window.sent.sort());
  assert.deepEqual(sent, ["dropped/1/robot/meshes/part.off", "dropped/1/robot/urdf/two.urdf"]);
  const panel = await page.locator(".inspection-panel").innerText();
  assert.match(panel, /1 link: 1 impossible/);
  assert.ok(!panel.includes("page.mesh"), "the mesh was found");
  assert.match(panel, /No fix is written/);
  assert.deepEqual(problems, []);
  await close();
});

test("a mesh that goes through itself turns, and shows where: from the motion and back", async () => {
  const { page, problems, close } = await open();
  // One corner of the wall's upper edge comes down through the plate.
  const bracket = readFileSync(example("meshes/bracket.off"), "utf8");
  const crossed = bracket.replace("\n5.0 0.0 35.0\n", "\n20.0 3.0 -12.0\n");
  assert.notEqual(crossed, bracket);
  const path = join(folder, "crossing.off");
  writeFileSync(path, crossed);
  await page.setInputFiles("input[type=file]:not([webkitdirectory])", [path]);
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhodeLive.text.includes("crossing.off"));
  await page.click("#other >> text=Mesh");
  await page.waitForFunction(() => window.polhodeInspection.document?.name === "crossing.off");
  const panel = page.locator(".inspection-panel");
  assert.match(await panel.innerText(), /It bounds a solid/);
  const crossing = panel.locator("li", { hasText: "mesh.overlap" });
  await crossing.locator("button").click();
  assert.ok((await coloured(page, [0x9a, 0x4a, 0x00])) > 50, "where it crosses is seen");
  await shoot(page, "inspection-crossing");
  await page.click("#other >> text=Motion");
  await page.waitForFunction(() => !document.body.classList.contains("inspecting"));
  assert.deepEqual(problems, []);
  await close();
});

test("of several files those that name others are opened; of a folder, models among other XML are found", async () => {
  const { sorted } = await load("live/dropped.ts");
  const file = (path, text = "") => ({ path, file: new File([text], path) });
  const names = (some) => some.map(({ path }) => path);
  const folder = [file("a/b.stl"), file("a/x.urdf"), file("a/package.xml", "<package/>"), file("a/m.xml", "<?xml?>\n<mujoco>"), file("a/.hidden/y.urdf"), file("a/notes.md")];
  const { sent, opened } = await sorted(folder);
  assert.deepEqual(names(opened), ["a/x.urdf", "a/m.xml"]);
  assert.deepEqual(names(sent), ["a/x.urdf", "a/m.xml", "a/b.stl"]);
  // One by one nothing is left out: the server says what it does not know.
  assert.deepEqual(names((await sorted([file("b.stl"), file("notes.md"), file("a.ply")])).opened), ["a.ply", "b.stl", "notes.md"]);
  assert.deepEqual(await sorted([file("a/notes.md")]), { sent: [], opened: [] });
  // A mesh in parts is one, beside others; a robot's meshes are its own, whatever their format.
  assert.deepEqual(names((await sorted([file("a.gltf"), file("a.bin"), file("b.stl")])).opened), ["a.gltf", "b.stl"]);
  assert.deepEqual(names((await sorted([file("a/x.urdf"), file("a/m.gltf"), file("a/m.bin")])).opened), ["a/x.urdf"]);
  const tomls = [file("a/pyproject.toml", "[project]\nname = 'a'"), file("a/top.toml", "title = 'top'\n\n[[body.part]]")];
  assert.deepEqual(names((await sorted(tomls)).opened), ["a/top.toml"]);
});

for (const [name, width, height, scheme] of [["projector", 1024, 768, "light"], ["phone", 390, 844, "dark"]]) {
  test(`${name}: picture and list have room, and every control a name`, async () => {
    const { page, problems, close } = await open({ viewport: { width, height }, colorScheme: scheme });
    await choose(page, "bad-arm.urdf");
    const stage = await page.locator(".still").boundingBox();
    assert.ok(stage.height >= 0.36 * height, `the picture is ${stage.height} high`);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, "nothing is cut off at the right");
    assert.deepEqual(await unnamed(page), []);
    await shoot(page, `inspection-${name}`);
    assert.deepEqual(problems, []);
    await close();
  });
}
