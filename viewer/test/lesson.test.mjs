// Lessons on the page of `polhode live`, with the program itself.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { emptyPage, launch, shoot, unnamed } from "./browser.mjs";
import { serve } from "./live-server.mjs";

let browser;
let server;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve("--lesson", "racket")]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function open(address = server.address, options = {}) {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  await page.goto(address);
  await page.waitForSelector("body.live:not(.waiting)");
  await page.waitForSelector(".lesson h3");
  return { page, problems, close };
}

const settled = (page) => page.waitForFunction(() => window.polhodeLive.isSettled);
const clock = (page) => page.evaluate(() => ({ time: window.polhode.clock.time, playing: window.polhode.clock.playing }));
const shownKnobs = (page) => page.evaluate(() => [...document.querySelectorAll("#knobs .knob")].filter((e) => e.checkVisibility({ visibilityProperty: true })).map((e) => e.dataset.key));
const shownLayers = (page) =>
  page.evaluate(() => {
    const { view } = window.polhode;
    return view.layers.filter(({ objects }) => objects.some((object) => object.visible)).map(({ id }) => id);
  });
const predict = async (page, k) => {
  await page.locator(".lesson-question input").nth(k).check();
  await page.click("text=This is my prediction");
};

test("a step asks first: nothing of the motion is seen, and nothing moves, until the answer", async () => {
  const { page, problems, close } = await open();
  await settled(page);
  assert.match(page.url(), /#lesson=racket$/);
  assert.equal(await page.locator(".lesson h2").innerText(), "Why the T-handle flips");
  assert.equal(await page.locator(".lesson h3").innerText(), "Step 1 of 4");
  assert.deepEqual((await shownLayers(page)).filter((id) => !["body", "space-axes", "body-axes"].includes(id)), []);
  assert.deepEqual(await shownKnobs(page), []);
  assert.equal(await page.locator(".lesson-working").isVisible(), false);
  assert.equal(await page.locator(".lesson-next").isDisabled(), true);
  await page.locator("#canvas").focus();
  await page.keyboard.press(" ");
  await page.keyboard.press("End");
  assert.deepEqual(await clock(page), { time: 0, playing: false });
  await page.keyboard.press("3");
  assert.equal(await page.evaluate(() => window.polhode.view.picture), "body", "no other picture shows it either");
  assert.deepEqual((await page.locator("#labels").innerText()).split(/\s+/).filter((name) => /[𝛚𝐋𝐍]/u.test(name)), []);
  await page.click("#tab-plots");
  assert.equal(await page.locator("#panel-plots").isVisible(), false);
  await page.click("#tab-lesson");
  await shoot(page, "lesson-asks");
  await predict(page, 0);
  assert.match(await page.locator(".lesson-why").innerText(), /^Not quite\. /);
  assert.match(await page.locator("label.right").innerText(), /The stem z.*✓ right/s);
  assert.equal(await page.evaluate(() => document.activeElement.className), "lesson-why");
  assert.ok((await shownLayers(page)).includes("omega"));
  assert.deepEqual((await shownKnobs(page)).sort(), ["start.spin.body[0]", "start.spin.body[1]", "start.spin.body[2]"]);
  await page.locator("#canvas").focus();
  await page.keyboard.press("End");
  assert.equal((await clock(page)).time, 20);
  await shoot(page, "lesson-answered");
  assert.deepEqual(problems, []);
  await close();
});

test("next and back; each step begins with its own scenario, whatever was turned before", async () => {
  const { page, problems, close } = await open();
  await predict(page, 1);
  assert.match(await page.locator(".lesson-why").innerText(), /^Right\. /);
  const slider = page.locator('.knob[data-key="start.spin.body[2]"] input[type=range]');
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhode.app.motion.omega[2] > 6);
  await page.click("text=Next");
  assert.equal(await page.locator(".lesson h3").innerText(), "Step 2 of 4");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Step 2 of 4");
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhode.app.motion.omega[0] === 0.001);
  assert.equal(await page.evaluate(() => window.polhode.app.motion.omega[2]), 6);
  assert.deepEqual(await clock(page), { time: 0, playing: false });
  await page.click("text=Back");
  assert.equal(await page.locator(".lesson-question input").nth(1).isChecked(), true, "the answer is kept");
  assert.equal(await page.locator(".lesson-question input").nth(1).isDisabled(), true);
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhode.app.motion.omega[0] === 0.01);
  assert.equal(await page.evaluate(() => document.body.classList.contains("asking")), false);
  assert.deepEqual(problems, []);
  await close();
});

test("the step of the worked solution stands beside, and follows the knobs", async () => {
  const { page, problems, close } = await open();
  await predict(page, 1);
  await page.locator(".lesson-working summary").click();
  await page.waitForSelector(".lesson-working .formula");
  assert.match(await page.locator(".lesson-working summary").innerText(), /^Working: 4\. Euler/);
  const before = await page.locator(".lesson-working").innerText();
  await page.locator('.knob[data-key="start.spin.body[2]"] input[type=range]').focus();
  await page.keyboard.press("PageUp");
  await page.waitForFunction((before) => document.querySelector(".lesson-working").innerText !== before, before);
  assert.equal(await page.locator(".lesson-working").evaluate((e) => e.open), true);
  assert.deepEqual(problems, []);
  await close();
});

test("the list leads to every lesson; another document ends the lesson and brings all knobs back", async () => {
  const { page, problems, close } = await open();
  await page.click("text=All lessons");
  await page.waitForSelector(".lessons li");
  assert.ok((await page.locator(".lessons li").count()) >= 12);
  assert.equal(await page.evaluate(() => location.hash), "");
  assert.ok((await shownKnobs(page)).length > 3);
  await page.click(".lessons >> text=Precession without spin?");
  await page.waitForSelector(".lesson h3");
  assert.match(page.url(), /#lesson=bicycle-wheel$/);
  await page.waitForFunction(() => window.polhodeLive.isSettled && window.polhodeLive.text.includes("rim and tyre"));
  // The two lessons are documents now.
  await page.waitForFunction(() => document.querySelectorAll("#documents option").length === 2);
  await page.selectOption("#documents", { index: 0 });
  await page.waitForSelector(".lessons li");
  assert.deepEqual(problems, []);
  await close();
});

test("by keyboard alone; every control has a name", async () => {
  const { page, problems, close } = await open();
  await page.locator(".lesson h3").focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press(" ");
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.locator(".lesson-question input").nth(1).isChecked(), true);
  await page.keyboard.press("Enter");
  assert.match(await page.locator(".lesson-why").innerText(), /^Right\. /);
  assert.equal(await page.locator(".lesson-why").getAttribute("role"), "status");
  assert.deepEqual(await unnamed(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test("a phone in the dark: nothing is cut off", async () => {
  const { page, problems, close } = await open(server.address, { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
  await page.locator(".lesson h3").scrollIntoViewIfNeeded();
  await shoot(page, "lesson-phone");
  await predict(page, 1);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
  await shoot(page, "lesson-phone-answered");
  assert.deepEqual(problems, []);
  await close();
});

test("a teacher's own lesson: text is text, and what is saved is shown", async () => {
  const folder = mkdtempSync(join(tmpdir(), "polhode-lesson-"));
  const path = join(folder, "my lesson.toml");
  const lesson = `title = "<b>Mine</b>"
summary = "A ball."
scenario_text = '''
[[body.part]]
shape = "sphere"
radius = "20 mm"
mass = "1 kg"
[start]
spin = { body = [0, 0, "3 rad/s"] }
'''

[[step]]
text = "Look <img src=x>."
knobs = ["start.spin.body[2]"]
`;
  writeFileSync(path, lesson);
  const own = await serve("--lesson", path);
  try {
    const { page, problems, close } = await open(own.address);
    assert.match(page.url(), /#lesson=my%20lesson\.toml$/);
    assert.equal(await page.locator(".lesson h2").innerText(), "<b>Mine</b>");
    assert.equal(await page.locator(".lesson img").count(), 0);
    assert.equal(await page.evaluate(() => document.body.classList.contains("asking")), false, "a step without a question covers nothing");
    writeFileSync(path, readFileSync(path, "utf8").replace("A ball.", "A ball that turns.").replace("Look", "Look again"));
    await page.waitForFunction(() => document.querySelector(".lesson").innerText.includes("Look again"));
    assert.deepEqual(problems, []);
    await close();
  } finally {
    own.close();
  }
});
