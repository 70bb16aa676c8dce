// What the page saves of the 3-D view: pictures of any size, GIF, WebM and pictures in a ZIP, decoded by others than those that made them.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { crc32 } from "node:zlib";
import { folder, launch, open, shoot } from "./browser.mjs";
import { load } from "./load.mjs";
import { samples } from "./sample.mjs";

let browser;
/** A page that decodes: that of the motion may load neither films nor pictures from elsewhere. */
let bench;
before(async () => {
  browser = await launch();
  bench = await browser.newPage();
  const file = join(folder, "bench.html");
  writeFileSync(file, "<!doctype html>");
  // Bytes as text are faster than as a list.
  await bench.addInitScript(() => {
    window.unpack = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    window.pack = (data) => btoa(Array.from(data, (x) => String.fromCharCode(x)).join(""));
  });
  await bench.goto(pathToFileURL(file).href);
});
after(() => browser.close());

const SIZE = { width: 120, height: 90 };
const NAME = "t-handle-in-free-fall";

/** Opens the dialog and orders what `how` says of each field. */
async function order(page, how) {
  if (!(await page.locator("#save-dialog").isVisible())) await page.keyboard.press("s");
  const { format, paper, ...fields } = { ...SIZE, ...how };
  await page.selectOption("#save-format", format);
  if (paper) await page.selectOption("#save-paper", paper);
  for (const [name, value] of Object.entries(fields)) await page.fill(`#save-${name}`, String(value));
}

async function saved(page, how) {
  await order(page, how);
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save-go")]);
  const bytes = readFileSync(await download.path());
  await page.waitForFunction(() => document.querySelector("#save-said").textContent.startsWith("Saved"));
  return { name: download.suggestedFilename(), bytes };
}

/** Files of a ZIP, as its directory has them; all that a reader checks is checked. */
function unzipped(bytes) {
  const end = bytes.length - 22;
  assert.equal(bytes.readUInt32LE(end), 0x06054b50, "it ends with the end of its directory");
  const count = bytes.readUInt16LE(end + 10);
  let at = bytes.readUInt32LE(end + 16);
  assert.equal(at + bytes.readUInt32LE(end + 12), end);
  return Array.from({ length: count }, () => {
    assert.equal(bytes.readUInt32LE(at), 0x02014b50);
    const [method, crc, size, long, offset] = [bytes.readUInt16LE(at + 10), bytes.readUInt32LE(at + 16), bytes.readUInt32LE(at + 24), bytes.readUInt16LE(at + 28), bytes.readUInt32LE(at + 42)];
    const name = bytes.subarray(at + 46, at + 46 + long).toString();
    assert.equal(bytes.readUInt32LE(offset), 0x04034b50);
    assert.equal(bytes.subarray(offset + 30, offset + 30 + long).toString(), name);
    const content = bytes.subarray(offset + 30 + long, offset + 30 + long + size);
    assert.deepEqual([method, crc32(content)], [0, crc], name);
    at += 46 + long;
    return { name, content };
  });
}

const unpacked = (frame) => ({ ...frame, pixels: Buffer.from(frame.pixels, "base64") });

/** Pictures as the browser decodes them: bytes r g b a. */
async function decoded(file, type) {
  const frames = await bench.evaluate(
    async ([text, type]) => {
      const decoder = new ImageDecoder({ data: unpack(text), type });
      await Promise.all([decoder.tracks.ready, decoder.completed]);
      const frames = [];
      for (let k = 0; k < decoder.tracks.selectedTrack.frameCount; k += 1) {
        const { image } = await decoder.decode({ frameIndex: k });
        const pen = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext("2d");
        pen.drawImage(image, 0, 0);
        const { width, height, data } = pen.getImageData(0, 0, image.displayWidth, image.displayHeight);
        frames.push({ width, height, seconds: image.duration / 1e6, pixels: pack(data) });
      }
      return frames;
    },
    [file.toString("base64"), type],
  );
  return frames.map(unpacked);
}

/** A film in a player: how long it is, what it shows at some times, and where it ends when it plays. */
async function played(file, times) {
  const seen = await bench.evaluate(
    async ([text, times]) => {
      const video = document.createElement("video");
      video.muted = true;
      document.body.replaceChildren(video);
      const happens = (name) => new Promise((done, fail) => {
        video.addEventListener(name, done, { once: true });
        video.addEventListener("error", () => fail(new Error(video.error?.message)), { once: true });
      });
      video.src = URL.createObjectURL(new Blob([unpack(text)], { type: "video/webm" }));
      await happens("loadeddata");
      const { duration, videoWidth: width, videoHeight: height } = video;
      const pen = new OffscreenCanvas(width, height).getContext("2d");
      const pictures = [];
      for (const time of times) {
        const shown = new Promise((done) => video.requestVideoFrameCallback((_, { mediaTime }) => done(mediaTime)));
        video.currentTime = time;
        await happens("seeked");
        const at = await shown;
        pen.drawImage(video, 0, 0);
        pictures.push({ at, pixels: pack(pen.getImageData(0, 0, width, height).data) });
      }
      video.currentTime = 0;
      await happens("seeked");
      await Promise.all([happens("ended"), video.play()]);
      return { duration, width, height, pictures, end: video.currentTime };
    },
    [file.toString("base64"), times],
  );
  return { ...seen, pictures: seen.pictures.map(unpacked) };
}

/** How far two pictures differ, of 255, on average. */
const apart = (a, b) => {
  assert.equal(a.pixels.length, b.pixels.length);
  return a.pixels.reduce((sum, x, i) => sum + Math.abs(x - b.pixels[i]), 0) / a.pixels.length;
};

test("what does not fit is refused by its rule, with what would", async () => {
  const { frameCount, frameTime, refusal } = await load("save/film.ts");
  const unit = { name: "min", seconds: 60 };
  const film = { format: "gif", from: 0, to: 120, speed: 10, rate: 25, width: 1000, height: 800, paper: true };
  const why = (change) => refusal({ ...film, ...change }, 0, 120, unit);
  assert.equal(frameCount(film), 300);
  assert.equal(frameTime(film, 10), 4);
  assert.equal(frameCount({ from: 0, to: 1, speed: 0.3, rate: 30 }), 100);
  assert.equal(frameCount({ from: 0, to: 1.0001, speed: 0.3, rate: 30 }), 101);
  assert.equal(why({}), null);
  assert.equal(
    why({ speed: 1 }),
    "A GIF has at most 400 million pixels in all, and 3,000 frames of 1000 × 800 px have 2,400 million pixels. Take a shorter time, a higher speed, " +
      "fewer frames per second or a smaller picture: 500 frames of this size fit, or all of 408 × 326 px.",
  );
  assert.match(why({ speed: 0.1, rate: 30, width: 64, height: 64 }), /^A GIF has at most 9999 frames, and these are 36,000\. Take .*: 9,999 frames of this size fit\.$/);
  assert.equal(why({ rate: 60 }), "Frames per second: 1 to 50 in a GIF.");
  assert.equal(why({ format: "webm", rate: 60 }), null);
  assert.equal(why({ to: 180 }), "To: a time of the motion, 0 min to 2.0000 min.");
  assert.match(why({ from: 60, to: 60 }), /^From 1\.0000 min to 1\.0000 min nothing passes/);
  assert.match(why({ speed: 0 }), /^Speed: /);
  assert.match(why({ from: Number.NaN }), /^From: /);
  for (const width of [10, 99.5, Number.NaN]) assert.equal(why({ width }), "Width: a whole number of pixels, 64 or more.");
  assert.equal(why({ format: "png", width: 16000, height: 12000, speed: 0 }), "16000 × 12000 px are 192 million pixels; a picture has at most 40 million pixels. Up to 7302 × 5477 px fit.");
});

test("films have the frames of their exact times, whatever the screen shows and however often", async () => {
  const { page, problems, close } = await open(browser, "film", samples.free(), { viewport: { width: 700, height: 520 } });
  const film = { from: 1, to: 3, speed: 2, rate: 6 };
  const zip = await saved(page, { ...film, format: "zip" });
  assert.equal(zip.name, `${NAME}-frames.zip`);
  const files = unzipped(zip.bytes);
  assert.deepEqual(files.map(({ name }) => name), [1, 2, 3, 4, 5, 6].map((k) => `frame-000${k}.png`));
  const frames = [];
  for (const { content } of files) frames.push(...(await decoded(content, "image/png")));
  for (const { width, height } of frames) assert.deepEqual({ width, height }, SIZE);
  const steps = frames.slice(1).map((frame, k) => apart(frame, frames[k]));
  const least = Math.min(...steps);
  assert.ok(least > 2, `it moves: ${steps}`);

  const gif = await saved(page, { ...film, format: "gif" });
  assert.equal(gif.name, `${NAME}-film.gif`);
  const shown = await decoded(gif.bytes, "image/gif");
  // 16.7 hundredths of a second.
  assert.deepEqual(shown.map(({ seconds }) => seconds), [0.17, 0.16, 0.17, 0.17, 0.16, 0.17]);
  shown.forEach((frame, k) => {
    assert.deepEqual({ width: frame.width, height: frame.height }, SIZE);
    assert.deepEqual(frame.pixels.subarray(0, 4), frames[k].pixels.subarray(0, 4), "paper is exact");
    assert.ok(apart(frame, frames[k]) < 0.1 * least, `frame ${k}: ${apart(frame, frames[k])} of ${steps}`);
  });

  const webm = await saved(page, { ...film, format: "webm" });
  assert.equal(webm.name, `${NAME}-film.webm`);
  const seen = await played(webm.bytes, [0, 1, 2, 3, 4, 5].map((k) => (k + 0.5) / 6));
  assert.ok(Math.abs(seen.duration - 1) < 1e-6 && Math.abs(seen.end - 1) < 0.01, `${seen.duration} s, ends at ${seen.end}`);
  assert.deepEqual({ width: seen.width, height: seen.height }, SIZE);
  assert.deepEqual(seen.pictures.map(({ at }) => at), [0, 0.167, 0.333, 0.5, 0.667, 0.833], "times of frames, in whole ms");
  seen.pictures.forEach((picture, k) => assert.ok(apart(picture, frames[k]) < 0.4 * least, `frame ${k}: ${apart(picture, frames[k])} of ${steps}`));

  // A picture of one of the times, and all again after it.
  await page.keyboard.press("Escape");
  await page.evaluate(() => window.polhode.clock.set(2));
  const picture = await saved(page, { format: "png" });
  assert.equal(picture.name, `${NAME}-120x90.png`);
  const [at] = await decoded(picture.bytes, "image/png");
  const far = frames.map((frame) => apart(at, frame));
  assert.ok(far[3] < 0.3 * least && far.every((x, k) => k === 3 || x > far[3]), `it is frame 3: ${far}`);
  const again = await saved(page, { ...film, format: "zip" });
  assert.ok(again.bytes.equals(zip.bytes), "the same film has the same bytes");
  assert.deepEqual(problems, []);
  await close();
});

test("a picture of four times the size is the same picture with more in it, on paper or on nothing", async () => {
  const { page, problems, close } = await open(browser, "print", samples.heavy(), {
    viewport: { width: 340, height: 500 },
    colorScheme: "dark",
    smooth: true,
  });
  const size = await page.locator("#stage").evaluate((e) => ({ width: e.clientWidth, height: e.clientHeight }));
  const small = await saved(page, { format: "png", ...size });
  await page.click("#save-dialog button >> text=4×");
  assert.equal(await page.locator("#save-width").inputValue(), String(4 * size.width));
  const large = await saved(page, { format: "png", width: 4 * size.width, height: 4 * size.height });
  assert.equal(large.name, `a-heavy-top-released-at-rest-${4 * size.width}x${4 * size.height}.png`);
  assert.deepEqual([large.bytes.readUInt32BE(16), large.bytes.readUInt32BE(20)], [4 * size.width, 4 * size.height]);
  const bare = await saved(page, { format: "png", paper: "none", ...size });
  // Made as small as the other: type and lines that had not grown would be missing.
  const reduced = await bench.evaluate(
    async ([files, { width, height }]) => {
      const pictures = [];
      for (const text of files) {
        const blob = new Blob([unpack(text)], { type: "image/png" });
        const pen = new OffscreenCanvas(width, height).getContext("2d");
        pen.drawImage(await createImageBitmap(blob, { resizeWidth: width, resizeHeight: height, resizeQuality: "high" }), 0, 0);
        pictures.push({ pixels: pack(pen.getImageData(0, 0, width, height).data) });
      }
      return pictures;
    },
    [[small, large, bare].map(({ bytes }) => bytes.toString("base64")), size],
  );
  const [a, b, none] = reduced.map(unpacked);
  const paper = [...a.pixels.subarray(0, 4)];
  assert.deepEqual(paper, [15, 20, 24, 255], "the theme's");
  const drawn = a.pixels.reduce((sum, x, i) => sum + Math.abs(x - paper[i % 4]), 0) / a.pixels.length;
  assert.ok(apart(a, b) < 0.2 * drawn, `${apart(a, b)} of ${drawn}`);
  assert.deepEqual([...none.pixels.subarray(0, 4)], [0, 0, 0, 0]);
  const opaque = none.pixels.filter((x, i) => i % 4 === 3 && x === 255).length;
  assert.ok(opaque > 1000, `the body covers what is behind it: ${opaque}`);

  await order(page, { format: "png", width: 12000, height: 100 });
  await page.click("#save-go");
  await page.locator("#save-said.problem").waitFor();
  assert.match(await page.textContent("#save-said"), /^The GPU draws pictures of at most \d+ × \d+ px, not of 12000 × 100\.$/);
  await page.keyboard.press("Escape");
  const [plot] = await Promise.all([page.waitForEvent("download"), page.locator("#plot-omega button", { hasText: "PNG" }).click()]);
  assert.ok(readFileSync(await plot.path()).readUInt32BE(16) >= 2 * 640, "plots are of the same kind");
  assert.deepEqual(problems, []);
  await close();
});

test("the dialog has names, keys and room on a phone, can be cancelled, and says what a browser cannot do", async () => {
  const { page, problems, close } = await open(browser, "dialog", samples.wheeled(), {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    colorScheme: "dark",
  });
  await page.evaluate(() => delete window.VideoEncoder);
  const downloads = [];
  page.on("download", (download) => downloads.push(download));
  await page.evaluate(() => window.polhode.clock.play());
  await page.focus("#save");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => window.polhode.clock.playing), false, "what is saved is what stands there");
  const names = page.locator("#save-dialog").getByLabel(/^(Format|from|to|× real time|frames per s|width|height|Background)$/);
  await page.selectOption("#save-format", "zip");
  assert.equal(await names.count(), 8, "each field has a name");
  assert.deepEqual(await page.getByRole("dialog").getAttribute("aria-labelledby"), "save-title");
  for (const group of ["Time (s)", "Speed", "Size (px)"]) assert.equal(await page.getByRole("group", { name: group, exact: true }).count(), 1, group);
  const where = await page.evaluate(() => {
    const all = [...document.querySelectorAll("#save-dialog *")].map((e) => e.getBoundingClientRect()).filter(({ width }) => width > 0);
    return { left: Math.min(...all.map((r) => r.left)), right: Math.max(...all.map((r) => r.right)), sideways: document.documentElement.scrollWidth };
  });
  assert.ok(where.left >= 0 && where.right <= 390 && where.sideways === 390, JSON.stringify(where));
  await shoot(page, "save-phone-dark");
  const time = await page.evaluate(() => window.polhode.clock.time);
  for (const key of ["End", "t", "2"]) await page.keyboard.press(key);
  assert.equal(await page.evaluate(() => window.polhode.clock.time), time, "keys are the dialog's");

  await order(page, { format: "zip", rate: 120, from: 0, to: 60, speed: 1 });
  await page.click("#save-go");
  await page.waitForFunction(() => document.querySelector("#save-progress").value > 1);
  assert.ok(await page.locator("#save-width").isDisabled());
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Cancel");
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.querySelector("#save-said").textContent.startsWith("Cancelled"));
  assert.ok(await page.locator("#save-dialog").isVisible() && !(await page.locator("#save-progress").isVisible()));
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#save-dialog").isVisible(), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), "save", "back where one was");
  assert.equal(downloads.length, 0);
  assert.equal(await page.locator("#save-format option[value=webm]").evaluate((option) => option.disabled), true);
  assert.match(await page.locator("#save-dialog .hint").textContent(), /^No WebM here: this browser has no video encoder/);
  assert.deepEqual(problems, []);
  await close();
});
