// The WebAssembly module gives the bits of a native build without fused multiply–add: POLHODE_ANSWERS names that program
// (crates/polhode-web/examples/answers.rs), POLHODE_MODULE the module.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { emptyPage, launch } from "./browser.mjs";
import { engine, path } from "../engine.mjs";
import { readFileSync } from "node:fs";

const FREE = 10_000;
const FORCED = 1_000;

/** Random numbers in [0, 1) from a seed (mulberry32). */
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A scenario with a box of random sides and a random start; `torque` is its table. */
function scenario(next, duration, torque) {
  const between = (low, high) => low + (high - low) * next();
  const vector = (low, high) => `[${[0, 0, 0].map(() => between(low, high)).join(", ")}]`;
  return `[[body.part]]
shape = "box"
size = ${vector(0.05, 0.7)}
mass = ${between(0.2, 9)}
rotate = { axis = ${vector(0.1, 1)}, angle = ${between(-3, 3)} }
[start]
attitude = { axis = ${vector(-1, -0.1)}, angle = ${between(-3, 3)} }
spin = { body = ${vector(-6, 6)} }
${torque(vector, between)}
[run]
duration = ${duration}
samples = 5
`;
}

const LAWS = [
  (vector) => `[[torque]]\nmodel = "constant"\naxes = "body"\ntorque = ${vector(-0.1, 0.1)}`,
  (vector) => `[[torque]]\nmodel = "drag"\nlaw = "linear"\ncoefficient = ${vector(0.001, 0.01)}`,
];

function messages() {
  const next = random(20261130);
  const free = Array.from({ length: FREE }, () => scenario(next, 20, () => ""));
  const forced = Array.from({ length: FORCED }, (_, k) => scenario(next, 5, LAWS[k % LAWS.length]));
  const motion = (text) => ({ motion: { document: 0, text, edits: [], error: false, working: false, body: null } });
  return ["open_example", ...[...free, ...forced].map(motion)].map((message) => JSON.stringify(message));
}

/** The numbers of an answer, after the length of its JSON and the JSON. */
const rows = (bytes) => (bytes[0] === 0x7b ? bytes.subarray(bytes.length) : bytes.subarray(8 + Number(bytes.readBigUInt64LE(0))));

/** FNV-1a, 64 bits. */
function hash(bytes) {
  let value = 0xcbf29ce484222325n;
  for (const byte of bytes) value = BigInt.asUintN(64, (value ^ BigInt(byte)) * 0x100000001b3n);
  return value.toString(16).padStart(16, "0");
}

const asked = messages();
const native = () => {
  const { stdout, stderr, status } = spawnSync(process.env.POLHODE_ANSWERS, { input: asked.join("\n"), encoding: "utf8", maxBuffer: 1 << 26 });
  assert.equal(status, 0, stderr);
  return stdout.trim().split("\n");
};

test("11,000 random motions have the bits of the native engine, in Node", () => {
  const expected = native();
  const { answer, ask } = engine();
  const found = asked.map((message) => hash(rows(answer(message))));
  const wrong = found.flatMap((one, k) => (one === expected[k] ? [] : [k]));
  assert.deepEqual(wrong.slice(0, 3).map((k) => [k, asked[k]]), []);
  // Each is a motion, not the same refusal on both sides.
  for (const message of [asked[1], asked[FREE + 1], asked[FREE + 2]]) assert.deepEqual(ask(message).errors, []);
  assert.equal(new Set(expected.slice(1)).size, expected.length - 1);
});

test("11,000 random motions have the bits of the native engine, in Chromium", async () => {
  const expected = native();
  const browser = await launch();
  const { page } = await emptyPage(browser, { viewport: { width: 200, height: 200 } });
  const found = await page.evaluate(
    async ({ module, asked }) => {
      let exported;
      const imports = { page: { now: () => performance.now(), panicked: () => undefined } };
      const { instance } = await WebAssembly.instantiate(Uint8Array.from(atob(module), (c) => c.charCodeAt(0)), imports);
      exported = instance.exports;
      const [low, high] = [new Uint32Array(1), new Uint32Array(1)];
      return asked.map((message) => {
        const bytes = new TextEncoder().encode(message);
        const to = exported.input(bytes.length) >>> 0;
        new Uint8Array(exported.memory.buffer, to, bytes.length).set(bytes);
        const at = exported.answer() >>> 0;
        [high[0], low[0]] = [0xcbf29ce4, 0x84222325];
        const view = new DataView(exported.memory.buffer, at, exported.answer_length());
        // Without rows, the JSON begins at once.
        const rows = view.getUint8(0) === 0x7b ? view.byteLength : 8 + Number(view.getBigUint64(0, true));
        for (const byte of new Uint8Array(exported.memory.buffer, at + rows, view.byteLength - rows)) {
          low[0] ^= byte;
          // (high 2³² + low) · (2⁴⁰ + 0x1b3) modulo 2⁶⁴
          const product = low[0] * 0x1b3;
          const carry = Math.floor(product / 4294967296);
          high[0] = Math.imul(high[0], 0x1b3) + carry + (low[0] << 8);
          low[0] = product % 4294967296;
        }
        return [high[0], low[0]].map((half) => half.toString(16).padStart(8, "0")).join("");
      });
    },
    { module: readFileSync(path).toString("base64"), asked },
  );
  await browser.close();
  assert.deepEqual(found.flatMap((one, k) => (one === expected[k] ? [] : [k])).slice(0, 3), []);
});
