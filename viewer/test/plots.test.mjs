// Plots, and what they are drawn from: needs no browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";
import { rotate, samples } from "./sample.mjs";

const { watchable } = await load("clock.ts");
const { rotate: turned } = await load("attitude.ts");
const { figuresOf } = await load("figures.ts");
const { arrange, sentences } = await load("plot/arrange.ts");
const { envelopes, extrema } = await load("plot/envelope.ts");
const { largestSoFar } = await load("plot/curve.ts");
const { textWidth, wrapped } = await load("plot/drawing.ts");
const { axisPath, directionOf, pieces } = await load("plot/axis-path.ts");
const { unrolled } = await load("plot/axis-drawing.ts");
const { Motion } = await load("motion.ts");
const { svgOf } = await load("plot/figure-svg.ts");

const numbersOf = (text) => new Float64Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
const base64 = (numbers) => Buffer.from(Float64Array.from(numbers).buffer).toString("base64");
const principal = (page) => page.body.principal;
const figureOf = (page, id, motion = page.motion) => figuresOf(new Motion(motion), principal(page)).find((figure) => figure.id === id);

/** A top whose axis goes round Z steadily, at `theta` from it, with the body at rest about its axis but for that. */
function steady(theta, rate, duration, count) {
  const times = Array.from({ length: count }, (_, i) => (i * duration) / (count - 1));
  // Rz(φ) Rx(θ): the axis z at azimuth φ − 90°.
  const q = times.map((t) => [Math.cos(theta / 2) * Math.cos((rate * t) / 2), Math.sin(theta / 2) * Math.cos((rate * t) / 2), Math.sin(theta / 2) * Math.sin((rate * t) / 2), Math.cos(theta / 2) * Math.sin((rate * t) / 2)]);
  const omega = q.map((one) => rotate([one[0], -one[1], -one[2], -one[3]], [0, 0, rate]));
  const made = samples.heavy().motion;
  const fields = { count, times: base64(times), attitude: base64(q.flat()), omega: base64(omega.flat()), momentum: base64(omega.flat()), torque: null, potential: null, drift: [], kinetic: base64(times.map(() => 1)) };
  return { motion: new Motion({ ...made, ...fields }), top: { axis: [0, 0, 1], up: [0, 0, 1], across: [[1, 0, 0], [0, 1, 0]], bounds: [theta, theta] } };
}

test("now is where the axis is on the unrolled path, in whatever turn", () => {
  const [theta, rate, duration] = [0.7, 2, 20];
  const { motion, top } = steady(theta, rate, duration, 401);
  const path = axisPath(motion, top);
  const box = { left: 0, top: 0, width: 400, height: 230 };
  const { place, marks } = unrolled(path, top, [0, path.times.length - 1], box);
  const at = (t) => place(turned(motion.at(t).attitude, top.axis), t);
  const [from, to] = [at(0), at(duration)];
  assert.ok(to[0] - from[0] > 0.85 * 336, "the run fills the frame");
  for (const t of [1.31, 7.777, 10, 13.4, 19.2]) {
    const want = from[0] + (t / duration) * (to[0] - from[0]);
    assert.ok(Math.abs(at(t)[0] - want) < 0.05, `${at(t)} at ${t} s, not ${want}`);
  }
  // A piece has only its own times.
  const half = path.times.findIndex((t) => t > 10);
  const first = unrolled(path, top, [0, half], box);
  assert.equal(first.place(turned(motion.at(15).attitude, top.axis), 15), null);
  // θ stands still: its axis has numbers that one can read, and both axes have names of their own.
  const texts = marks.filter(({ kind }) => kind === "text").map(({ text }) => text);
  assert.ok(texts.every((text) => text.length < 8 || text.includes("(°)")), `${texts}`);
  assert.ok(texts.includes("azimuth of the axis (°)") && texts.includes("angle from the vertical (°)"));
});

test("a nutation that samples do not resolve is refused", () => {
  const made = samples.heavy();
  const { bounds } = axisPath(new Motion(made.motion), made.top);
  assert.ok(bounds, "the samples resolve it");
  // Rates that lead out of the bounds between samples which lie in them.
  const { motion, top } = steady(0.7, 2, 20, 401);
  const omega = motion.omega.slice();
  // About the line of nodes, at right angles to the axis: e moves by ω × e.
  for (let i = 0; i < 401; i += 1) omega[3 * i] += 6 * (i % 2 === 0 ? 1 : -1);
  const wild = Object.assign(Object.create(Object.getPrototypeOf(motion)), motion, { omega });
  const refused = axisPath(wild, { ...top, bounds: [0.69, 0.71] });
  assert.ok(refused.beyond > 0.01 && refused.beyond < 0.2, JSON.stringify(refused.bounds ?? refused));
});

test("the end of a run-away says nothing about speed, zero, or what is constant", () => {
  const page = samples.heavy();
  const omega = numbersOf(page.motion.omega);
  const count = omega.length / 3;
  for (let k = 0; k < 3; k += 1) omega[3 * (count - 3 + k) + 1] = 10 ** (6 + 3 * k);
  const data = { ...page.motion, omega: base64(omega), complete: false };
  const motion = new Motion(data);
  assert.equal(motion.telling, count - 3);
  assert.equal(new Motion(page.motion).telling, count);
  const [rate, usual] = [motion.meanRate(), new Motion(page.motion).meanRate()];
  assert.ok(Math.abs(rate / usual - 1) < 1e-3, `${rate}`);
  assert.equal(watchable(rate, 6, 1.54), watchable(usual, 6, 1.54));
  const figure = figureOf(page, "omega", data);
  assert.ok(figure.nothing < 1e-9, `${figure.nothing}`);
  const { constants } = arrange(figure);
  assert.deepEqual(constants.map(({ symbol }) => symbol), ["ωz"]);
  assert.match(figure.note, /the last 3 samples/);
  omega[3 * count - 1] = 1e12;
  const spun = arrange(figureOf(page, "omega", { ...data, omega: base64(omega) })).constants;
  assert.deepEqual(spun.map(({ symbol }) => symbol), ["ωz"]);
});

test("a torque keeps its size between samples, in space or in the body", () => {
  // One sample to the next the body turns by 1.9 rad about a generic axis.
  const axis = [0.48, -0.6, 0.64];
  const q = (angle) => [Math.cos(angle / 2), ...axis.map((x) => Math.sin(angle / 2) * x)];
  const inverse = ([w, x, y, z]) => [w, -x, -y, -z];
  const made = samples.heavy().motion;
  const angles = [0.3, 2.2];
  const moment = (torque) => {
    const rows = { count: 2, times: base64([0, 1]), attitude: base64(angles.flatMap(q)), omega: base64(angles.flatMap(() => axis.map((x) => 1.9 * x))), momentum: base64([1, 0, 0, 1, 0, 0]), kinetic: base64([1, 1]), potential: null, drift: [] };
    return new Motion({ ...made, ...rows, torque: base64(angles.flatMap(torque)) }).at(0.5).torque;
  };
  const n = [0.2, 0.9, -0.4];
  moment((angle) => rotate(inverse(q(angle)), n)).forEach((x, k) => assert.ok(Math.abs(x - n[k]) < 1e-12, "that stands in space"));
  const want = rotate(q(1.25), n);
  moment(() => n).forEach((x, k) => assert.ok(Math.abs(x - want[k]) < 1e-9, "that turns with the body"));
});

test("the largest so far is that of the run, wherever a zoom begins", () => {
  const { strokes } = largestSoFar([0, 1, 2], [50, 60, 20], 30);
  assert.deepEqual(strokes, [[[0, 30], [2, 30], [2, 20], [2, 20]]]);
  // A peak of 10⁻¹⁰ before 3 s: the axis of a zoom to 4 … 5 s reaches it.
  const page = samples.heavy();
  const values = numbersOf(page.motion.drift[0].values).map((_, i) => (i === 1000 ? 1e-10 : 2e-14 * (1 + (i % 7))));
  const motion = { ...page.motion, drift: [{ name: "T + U", values: base64(values) }] };
  const figure = figureOf(page, "drift", motion);
  const svg = svgOf(figure, arrange(figure), new Motion(motion).times, 4, 5);
  assert.ok(svg.includes(">10⁻¹⁰</text>"), "the axis has it");
  const stroke = [...svg.matchAll(/ d="([^"]*)"[^>]*stroke-width="1.6"/g)].at(-1)[1];
  const heights = stroke.split(/[ML]/).slice(1).map((point) => Number(point.split(" ")[1]));
  assert.ok(heights.length >= 2 && heights.every((y) => y === heights[0]), `the line stays at the peak: ${stroke}`);
});

test("an envelope shows no modulation that is not there, and holds the last swing too", () => {
  const count = 3000;
  const x = Float64Array.from({ length: count }, (_, i) => i * 0.1);
  for (const period of [5.1, 7.1, 12.5]) {
    const y = Float64Array.from({ length: count }, (_, i) => 100 + 50 * Math.sin((2 * Math.PI * i) / period + 0.3));
    const [{ low, high, resolved }] = envelopes(x, y);
    assert.equal(resolved, true);
    for (const [edge, middle] of [[low, 50], [high, 150]]) for (const [, v] of edge.slice(2, -2)) assert.ok(Math.abs(v - middle) < 1.5, `${period}: ${v}`);
  }
  // Swings that grow: the last is farther than all before, and has not turned back.
  const end = 2002;
  const grows = Float64Array.from({ length: end }, (_, i) => 100 - 0.02 * i * Math.cos((2 * Math.PI * i) / 20));
  for (const last of [end, end - 3, end - 9]) {
    const piece = grows.subarray(0, last);
    const [{ low, high }] = envelopes(x.subarray(0, last), piece);
    const [least, most] = [Math.min(...piece), Math.max(...piece)];
    assert.ok(Math.min(...low.map(([, v]) => v)) <= least && Math.max(...high.map(([, v]) => v)) >= most, `${last} samples: ${least} … ${most}`);
  }
});

test("drifts say what they are of, and the error of the attitude is no drift", () => {
  const page = samples.free();
  const zero = page.motion.drift.map(({ name }) => ({ name, values: base64(new Float64Array(2001)) }));
  const error = Float64Array.from({ length: 2001 }, (_, i) => 1e-12 * i);
  const motion = { ...page.motion, drift: [...zero, { name: "attitude error, rad (estimate)", values: base64(error) }] };
  const drift = figureOf(page, "drift", motion);
  assert.deepEqual(sentences(arrange(drift).constants, drift), ["T", "|L|", "L in space"].map((name) => `drift of ${name}: 0 in every sample`));
  const own = figureOf(page, "attitude-error", motion);
  assert.equal(own.title, "Estimated error of the attitude");
  const [stack] = arrange(own).stacks;
  assert.deepEqual([stack.title, stack.lines[0].values[1000]], ["error (rad)", error[1000]]);
  assert.equal(figureOf(page, "attitude-error"), undefined);
});

test("twelve wheels have looks that differ", () => {
  const page = samples.wheeled();
  const [wheel] = page.motion.wheels;
  const wheels = Array.from({ length: 12 }, (_, k) => ({ ...wheel, name: `wheel ${k}` }));
  const { lines } = figureOf(page, "wheels", { ...page.motion, wheels });
  assert.equal(new Set(lines.map(({ ink, dash }) => `${ink} ${dash}`)).size, 12);
});

test("nothing in a file is wider than the file", () => {
  assert.deepEqual(wrapped("one two three", textWidth("one two", 10) + 0.1, 10), ["one two", "three"]);
  assert.deepEqual(wrapped("abcdefgh ij", textWidth("abcde", 10) + 0.1, 10), ["abcde", "fgh", "ij"]);
  const page = samples.wheeled();
  const pointings = ["camera toward the sun's direction", "panel", "the long name of an antenna toward the ground station", "x".repeat(150)].map((name, k) => ({
    name,
    body: [0, 0, 1],
    target: 0,
    limit: null,
    values: base64(Float64Array.from({ length: 601 }, (_, i) => 0.5 + 0.1 * k + 0.05 * Math.sin(i))),
  }));
  const motion = { ...page.motion, pointings };
  const figure = { ...figureOf(page, "pointing", motion), note: "A note that goes on and on. ".repeat(8) };
  const events = [{ letter: "A", name: "an event of many words ".repeat(9), times: [3] }];
  const svg = svgOf(figure, arrange(figure), new Motion(motion).times, 0, 60, events);
  const texts = [...svg.matchAll(/<text x="([\d.]+)" y="[\d.]+" text-anchor="start"[^>]*font-size="([\d.]+)"[^>]*>([^<]*)</g)];
  assert.ok(texts.length > 12);
  for (const [, left, size, text] of texts) assert.ok(Number(left) + 0.55 * size * text.length < 640, text);
  const all = texts.map(([, , , text]) => text).join(" ");
  for (const word of ["antenna toward the ground station", "goes on and on", "of many words"]) assert.ok(all.includes(word), word);
});

test("the path of a top's axis lies on the sphere, between its bounds, in pieces of some nutations", () => {
  for (const made of [samples.heavy(), samples.tilted()]) checkPath(made);
});

function checkPath(made) {
  const motion = new Motion(made.motion);
  const path = axisPath(motion, made.top);
  const { points, theta, phi, bounds, times } = path;
  for (const k of [0, 313, 2222, points.length - 1]) {
    const back = directionOf(theta[k], phi[k], made.top);
    back.forEach((x, j) => assert.ok(Math.abs(x - points[k][j]) < 1e-12));
  }
  // The axis is z: at samples it is R e.
  const q = [...numbersOf(made.motion.attitude).subarray(4 * 1111, 4 * 1112)];
  const k = times.findIndex((t) => Math.abs(t - motion.times[1111]) < 1e-12);
  rotate(q, [0, 0, 1]).forEach((x, j) => assert.ok(Math.abs(x - points[k][j]) < 1e-12));
  assert.ok(Math.abs(bounds[0] - 0.6) < 1e-4 && bounds[1] > bounds[0] + 1e-3, "it starts at rest, at the highest");
  assert.ok(phi.every((angle, j) => j === 0 || Math.abs(angle - phi[j - 1]) < 0.5));
  const parts = pieces(path, 6);
  assert.ok(parts.length > 2 && parts[0][0] === 0 && parts.at(-1)[1] === theta.length - 1);
  const nutations = extrema(theta.slice(...parts[1]), 0, parts[1][1] - parts[1][0] - 1, 1e-4).length;
  assert.ok(nutations >= 11 && nutations <= 13, `${nutations}`);
  assert.deepEqual(axisPath(motion, { ...made.top, bounds: [0.59, 0.7] }).bounds, [0.59, 0.7]);
  const wild = numbersOf(made.motion.omega);
  // The largest turn is named, not the first that is too large.
  [wild[3 * 50], wild[3 * 1700]] = [1e4, 5e4];
  assert.ok(axisPath(new Motion({ ...made.motion, omega: base64(wild) }), made.top).turn > 90);
}

test("the end of a run-away does not say how large the rest is", () => {
  const page = samples.heavy();
  const made = page.motion;
  const omega = numbersOf(made.omega);
  omega[omega.length - 1] = 1e12;
  const data = { ...made, omega: base64(omega), complete: false };
  const all = (data) => arrange(figuresOf(new Motion(data), principal(page))[0]).stacks.map(({ range, unit, offset }) => (range[1] + offset) * unit.size);
  assert.ok(Math.max(...all(data)) < 200);
  assert.ok(Math.max(...all({ ...data, complete: true })) > 0.9e12);
  assert.match(figuresOf(new Motion(data), principal(page))[0].note, /runs away: ranges and constants are without the last sample\.$/);
  const torque = figuresOf(new Motion(made), principal(page)).find((f) => f.id === "torque");
  const given = numbersOf(made.torque);
  [0, 1, 2].forEach((k) => assert.equal(torque.lines[k].values[77], given[3 * 77 + k]));
});

