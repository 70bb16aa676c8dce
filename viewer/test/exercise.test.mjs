// Exercises on the interactive page, from disk.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { emptyPage, launch, shoot, unnamed } from "./browser.mjs";
import { path as pageFile } from "./standalone.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

/** The page with the exercise of a fragment, or with the list of topics. */
async function open(fragment = "", options = {}) {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  await page.goto(pathToFileURL(pageFile).href + fragment);
  await page.waitForSelector("body.live:not(.waiting)");
  if (fragment !== "") await page.waitForSelector(".exercise textarea");
  return { page, problems, close };
}

const press = (page, name) => page.click(`.exercise button:text-is("${name}")`);
const title = (page) => page.locator(".exercise h2").innerText();
const grade = async (page, text) => {
  await page.fill(".exercise textarea", text);
  await press(page, "Grade");
  await page.waitForFunction(() => document.querySelector(".exercise-grades").textContent !== "");
  const found = await page.locator(".exercise-grades").innerText();
  await page.evaluate(() => document.querySelector(".exercise-grades").replaceChildren());
  return found;
};

/** Answer to box-about-corner with seed 7; the products of inertia have this sign. */
const tensor = (sign) => {
  const [xy, xz, yz] = [0.1195, 0.0755, 0.0388].map((product) => `"${sign}${product} kg m^2"`);
  return `I = [["0.1144 kg m^2", ${xy}, ${xz}], [${xy}, "0.343 kg m^2", ${yz}], [${xz}, ${yz}, "0.392 kg m^2"]]`;
};

test("from the list: a wrong answer with its reason, the right one, the solution, the next exercise", async () => {
  const { page, problems, close } = await open();
  await page.click("#tab-lesson");
  await page.waitForSelector(".exercise li");
  assert.ok((await page.locator(".exercise li").count()) >= 25);
  await page.click(".exercise >> text=Inertia tensor of a box about its corner");
  await page.waitForSelector(".exercise textarea");
  assert.match(page.url(), /#exercise=box-about-corner,1$/);
  assert.equal(await page.locator(".lessons").count(), 1, "the list of lessons, which is hidden");
  assert.equal(await page.locator(".lessons").isVisible(), false);
  for (const seed of [2, 3, 4, 5, 6, 7]) {
    await press(page, "Next");
    await page.waitForFunction((seed) => document.querySelector(".exercise h2").innerText.includes(`seed ${seed})`), seed);
  }
  assert.match(page.url(), /#exercise=box-about-corner,7$/);
  assert.match(await page.locator(".exercise textarea").inputValue(), /^I = \[\n {2}\["\? kg m\^2"/);
  assert.match(await grade(page, await page.locator(".exercise textarea").inputValue()), /^0 of 1 right\s+I: missing$/);
  assert.match(await grade(page, tensor("")), /^0 of 1 right\s+I: wrong, the sign of the products of inertia is reversed/);
  assert.match(await grade(page, tensor("-")), /^1 of 1 right\s+I: right$/);
  assert.equal(await page.locator(".exercise .formula").count(), 0, "no solution yet");
  await press(page, "Solution");
  await page.waitForSelector(".exercise .formula math");
  assert.match(await page.locator(".exercise").innerText(), /If you found/);
  await press(page, "Next");
  await page.waitForFunction(() => document.querySelector(".exercise h2").innerText.includes("seed 8"));
  assert.equal(await page.locator(".exercise .formula").count(), 0);
  await press(page, "All exercises");
  await page.waitForSelector(".exercise li");
  assert.equal(await page.evaluate(() => location.hash), "");
  assert.equal(await page.locator(".lessons").isVisible(), true);
  assert.deepEqual(problems, []);
  await close();
});

test("the address restores an exercise; another one follows its change; edited answers are kept", async () => {
  const { page, problems, close } = await open("#exercise=two-mass-pendulum,3");
  assert.match(await title(page), /two-mass-pendulum, seed 3\)$/);
  await page.fill(".exercise textarea", "omega_0 = 4");
  await page.check(".exercise input[type=checkbox]");
  await page.waitForFunction(() => document.querySelector(".exercise h2").innerText.includes("in symbols"));
  assert.match(page.url(), /#exercise=two-mass-pendulum,3,symbols$/);
  assert.equal(await page.locator('.exercise button:text-is("Next")').isVisible(), false);
  assert.match(await grade(page, 'omega_0_squared = "2*g*(2*m_1 + m_2)/(b*(4*m_1 + m_2))"'), /^1 of 1 right/);
  await page.uncheck(".exercise input[type=checkbox]");
  await page.waitForFunction(() => document.querySelector(".exercise h2").innerText.includes("seed 3"));
  assert.equal(await page.locator(".exercise textarea").inputValue(), "omega_0 = 4");
  await page.evaluate(() => (location.hash = "#exercise=principal-moments,12"));
  await page.waitForFunction(() => document.querySelector(".exercise h2").innerText.includes("principal-moments, seed 12"));
  assert.equal(await page.locator(".exercise input[type=checkbox]").count(), 0, "no problem in symbols");
  for (const [fragment, words] of [["#exercise=principal-moments,-1", /link is damaged/], ["#exercise=no-such", /unknown topic "no-such"/]]) {
    await page.evaluate((fragment) => (location.hash = fragment), fragment);
    await page.waitForSelector("#notice:not([hidden])");
    assert.match(await page.locator("#notice").innerText(), words);
    await page.click("#notice button");
  }
  assert.deepEqual(problems, []);
  await close();
});

test("an error in the answers is stated with its line, and selected", async () => {
  const { page, problems, close } = await open("#exercise=two-mass-pendulum,3,symbols");
  assert.match(await grade(page, '# mine\nomega_0_squared = "G/b"'), /^Line 2, column 20: unknown symbol `G`/);
  const selected = await page.evaluate(() => {
    const { activeElement: field } = document;
    return field.value.slice(field.selectionStart, field.selectionEnd);
  });
  assert.match(selected, /^G/);
  assert.deepEqual(await unnamed(page), []);
  assert.deepEqual(problems, []);
  await close();
});

for (const colorScheme of ["light", "dark"]) {
  for (const width of [1280, 390]) {
    test(`${colorScheme}, ${width} px: nothing is cut off`, async () => {
      const { page, problems, close } = await open("#exercise=box-about-corner,7", { viewport: { width, height: 844 }, colorScheme });
      await shoot(page, `exercise-${colorScheme}-${width}`);
      await grade(page, tensor(""));
      await press(page, "Grade");
      await page.waitForSelector(".exercise-grades li");
      await press(page, "Solution");
      await page.waitForSelector(".exercise .formula math");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
      const cut = await page.evaluate(() => [...document.querySelectorAll(".exercise > *")].filter((e) => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0).map((e) => e.outerHTML.slice(0, 80)));
      assert.deepEqual(cut, []);
      await page.locator(".exercise textarea").scrollIntoViewIfNeeded();
      await shoot(page, `exercise-${colorScheme}-${width}-graded`);
      await page.locator(".exercise .formula").first().scrollIntoViewIfNeeded();
      await shoot(page, `exercise-${colorScheme}-${width}-solved`);
      await press(page, "All exercises");
      await page.waitForSelector(".exercise li");
      const beyond = await page.evaluate(() => [...document.querySelectorAll(".exercise button")].filter((e) => e.getBoundingClientRect().right > innerWidth).map((e) => e.textContent));
      assert.deepEqual(beyond, []);
      assert.deepEqual(problems, []);
      await close();
    });
  }
}
