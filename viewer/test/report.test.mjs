// Reports on tables and plans in the interactive page, compared with those of the command.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { emptyPage, launch, unnamed } from "./browser.mjs";
import { example, program } from "./live-server.mjs";
import { path as pageFile } from "./standalone.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

async function open() {
  const { page, problems, close } = await emptyPage(browser, { viewport: { width: 1280, height: 800 } });
  await page.goto(pathToFileURL(pageFile).href);
  await page.waitForFunction(() => window.polhodeLive?.isSettled);
  return { page, problems, close };
}

const drop = (page, ...files) =>
  page.locator("input[type=file]").first().setInputFiles(files.map((file) => (typeof file === "string" ? { name: file.split("/").at(-1), mimeType: "text/plain", buffer: readFileSync(example(file)) } : { mimeType: "text/plain", ...file, buffer: Buffer.from(file.text) })));

/** The report that is shown, when it is computed. */
async function reported(page, name) {
  await page.waitForFunction((name) => window.polhodeReport.document?.name === name && !window.polhodeReport.isComputing, name);
  return page.evaluate(() => window.polhodeReport.shown);
}

/** The error below the options, once it says `pattern`: the error of an earlier edit may still be shown. */
async function refused(page, pattern) {
  await page.waitForFunction(({ source, flags }) => {
    const error = document.querySelector(".report-error");
    return error !== null && !error.hidden && new RegExp(source, flags).test(error.innerText);
  }, { source: pattern.source, flags: pattern.flags });
}

/** The JSON that the command prints, run in the folder of an example. */
function printed(folder, ...words) {
  const run = spawnSync(program, [...words, "--json"], { cwd: example(folder), encoding: "utf8" });
  assert.ok(run.status <= 1, run.stderr);
  return JSON.parse(run.stdout);
}

/** Asserts that two results are alike: the bits of numbers depend on fused multiply-add. */
function assertAlike(found, expected, tolerance, at = "") {
  if (typeof expected === "number") {
    assert.ok(Math.abs(found - expected) <= tolerance * Math.max(Math.abs(expected), 1e-6), `${at}: ${found}, not ${expected}`);
  } else if (expected !== null && typeof expected === "object") {
    assert.deepEqual(Object.keys(found), Object.keys(expected), at);
    for (const key of Object.keys(expected)) assertAlike(found[key], expected[key], tolerance, `${at}.${key}`);
  } else if (typeof expected === "string" && /\d/.test(expected)) {
    assert.equal(found.replace(/\d/g, "").slice(0, 20), expected.replace(/\d/g, "").slice(0, 20), at);
  } else assert.equal(found, expected, at);
}

/** Sets an option of the command. */
async function option(page, key, value) {
  await page.evaluate(() => document.querySelector(".options").setAttribute("open", ""));
  const field = page.locator(`#option-${key}`);
  await field.fill(value);
  await field.press("Tab");
}

test("a parts list: its report is the command's, with figures, and is saved; a computation is cancelled", async () => {
  const { page, problems, close } = await open();
  await drop(page, "budget/cubesat.csv");
  await page.waitForFunction(() => window.polhodeReport.isComputing);
  await page.click("text=Cancel");
  await page.waitForSelector(".report-status:text('Cancelled.')");
  assert.equal(await page.locator("text=Save JSON").isDisabled(), true);
  await option(page, "draws", "100");
  const report = await reported(page, "cubesat.csv");
  const expected = printed("budget", "budget", "cubesat.csv", "--draws", "100");
  assertAlike(JSON.parse(report.json).configurations[0].estimate, expected.configurations[0].estimate, 1e-9);
  assert.equal(await page.locator("#title").innerText(), "A 3U CubeSat");
  assert.ok((await page.locator(".report-page figure svg").count()) > 0);
  assert.ok((await page.locator(".report-page table").count()) > 3);
  assert.match(await page.locator(".report-page .answer").innerText(), /kg/);
  assert.deepEqual(await unnamed(page), []);
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("text=Save JSON")]);
  assert.equal(saved.suggestedFilename(), "cubesat-report.json");
  assert.deepEqual(JSON.parse(readFileSync(await saved.path(), "utf8")), JSON.parse(report.json));
  const [page2] = await Promise.all([page.waitForEvent("download"), page.click("text=Save report (HTML)")]);
  assert.equal(readFileSync(await page2.path(), "utf8"), report.html);
  // Back to the motion, whose documents a new worker knows.
  await page.selectOption("#documents", { label: "t-handle.toml" });
  await page.waitForFunction(() => window.polhodeReport.document === null);
  assert.equal(await page.locator("#stage").isVisible(), true);
  assert.deepEqual(problems, []);
  await close();
});

test("a plan with its log: numbers of the command; an edit is computed, an error is marked, and undo restores the text", async () => {
  const { page, problems, close } = await open();
  await drop(page, "identify/racket-like.toml", "identify/racket-like.csv");
  const report = await reported(page, "racket-like.toml");
  assertAlike(JSON.parse(report.json).principal, printed("identify", "identify", "racket-like.toml").principal, 1e-6);
  assert.match(await page.locator(".report-page .answer").innerText(), /0\.0906/);
  const editor = page.locator('[aria-label="The plan as TOML"]');
  await editor.click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("speed = 3\n");
  await refused(page, /speed[\s\S]*racket-like\.toml:9[\s\S]*hint/);
  assert.ok((await page.locator(".report-editor .cm-lintRange-error").count()) > 0);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => window.polhodeReport.shown !== null);
  assert.equal(await page.locator(".report-error").isVisible(), false);
  assert.deepEqual(problems, []);
  await close();
});

test("a log is judged by the scenario that was dropped with it, by the one that is open, or by moments", async () => {
  const { page, problems, close } = await open();
  await drop(page, "judge/tumbling.toml", "judge/mujoco-rk4.csv");
  const report = await reported(page, "mujoco-rk4.csv");
  const expected = printed("judge", "judge", "mujoco-rk4.csv");
  const [run] = JSON.parse(report.json).runs;
  for (const key of ["run", "engine", "step_s", "rows", "reading"]) assertAlike(run[key], expected.runs[0][key], 1e-6, key);
  assert.ok(report.has_failed === false && (await page.locator(".report-page figure svg").count()) > 0);
  const rows = readFileSync(example("judge/mujoco-rk4.csv"), "utf8").split("\n").filter((line) => !line.startsWith("#")).join("\n");
  await drop(page, { name: "run.csv", text: rows });
  await page.waitForSelector(".table-kind");
  assert.equal(await page.locator(".report-status").innerText(), "Choose what the file is.");
  await page.check("input[value=judge]");
  await reported(page, "run.csv");
  assert.equal(await page.locator("[aria-label='Scenario of the run']").inputValue(), "open");
  assert.match(await page.locator(".report-page .answer").innerText(), /run\.csv|error|correct/i);
  assert.equal((await reported(page, "run.csv")).has_failed, false);
  // A rotation about y at 3 rad/s needs no scenario.
  const turned = Array.from({ length: 101 }, (_, k) => `${k / 100},${Math.cos(0.015 * k)},0,${Math.sin(0.015 * k)},0\n`);
  await drop(page, { name: "turn.csv", text: `time,qw,qx,qy,qz\n${turned.join("")}` });
  await page.waitForSelector("legend:text('What is turn.csv?')");
  await page.check("input[value=judge]");
  await option(page, "start-omega", "0, 3, 0");
  await option(page, "moments", "3, 2");
  await refused(page, /moments is "3, 2": expected 3 numbers/);
  await option(page, "moments", "3, 2, 1.4");
  await page.waitForFunction(() => window.polhodeReport.shown !== null);
  assert.equal((await reported(page, "turn.csv")).has_failed, false);
  assert.deepEqual(problems, []);
  await close();
});

test("a damaged table shows its line, the rule and a fix; a Parquet file is refused with advice", async () => {
  const { page, problems, close } = await open();
  await drop(page, { name: "parts.csv", text: "name,mass [g],x [mm]\nbattery,270 ± 5,12\nradio,94 mm,-20\n" });
  await refused(page, /"mm" is a length where a mass belongs[\s\S]*parts\.csv:3:7[\s\S]*radio,94 mm,-20[\s\S]*hint: write a mass/);
  await drop(page, { name: "run.parquet", text: "PAR1\0PAR1" });
  await page.waitForFunction(() => /Parquet[\s\S]*CSV/.test(document.getElementById("notice").innerText));
  assert.deepEqual(problems, []);
  await close();
});

test("a table that may be particles is asked about, and turns as a body", async () => {
  const { page, problems, close } = await open();
  await drop(page, { name: "parts.csv", text: "name,mass_kg,x_m,y_m,z_m\nA,1.5,0.1,-0.2,3\nB,2,0,0.4,-0.7\nC,0.7,0.3,0.1,0.2\n" });
  await page.check("input[value=particles]");
  await page.waitForFunction(() => window.polhodeReport.document === null && window.polhodeLive.text.includes("particles"));
  await page.waitForFunction(() => window.polhodeLive.isSettled);
  assert.ok(Math.abs((await page.evaluate(() => window.polhode.app.page.body.mass)) - 4.2) < 1e-12);
  assert.deepEqual(problems, []);
  await close();
});
