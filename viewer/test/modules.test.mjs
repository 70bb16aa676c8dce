// What needs no browser: the clock, attitudes, numbers, figures.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Quaternion, Vector3 } from "three";
import { load } from "./load.mjs";
import { integrate, rotate, samples, tensor } from "./sample.mjs";

const { Clock, watchable, indexAt } = await load("clock.ts");
const { between, euler313, slerp, rotate: turned } = await load("attitude.ts");
const { grouped, number, mark, powerOfTen, timeUnit, words } = await load("format.ts");
const { figuresOf } = await load("figures.ts");
const { decades, logRange, padded, ticks, unitFor } = await load("plot/scale.ts");
const { arrange, quantity, sentences, split } = await load("plot/arrange.ts");
const { envelopes, extrema } = await load("plot/envelope.ts");
const { curve, largestSoFar } = await load("plot/curve.ts");
const { labels, marked, marksOf } = await load("plot/events.ts");
const { Motion } = await load("motion.ts");
const { directions, Farthest } = await load("scene/framing.ts");
const { Conic } = await load("scene/conic.ts");
const { inksOf, PARTS } = await load("scene/body.ts");
const { enclosing } = await load("scene/inside.ts");
const { Shadow } = await load("scene/shadow.ts");
const { svgOf } = await load("plot/figure-svg.ts");
const { f64, indices, readPage } = await load("decode.ts");
const { motionAnswer } = await load("live/motion-answer.ts");

const numbersOf = (text) => new Float64Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
const base64 = (numbers) => Buffer.from(numbers.buffer, numbers.byteOffset, numbers.byteLength).toString("base64");

test("the clock plays, loops and stops", () => {
  const clock = new Clock(Float64Array.from([1, 1.5, 3, 5]), 2);
  let told = 0;
  clock.subscribe(() => (told += 1));
  clock.advance(1);
  assert.equal(clock.time, 1, "it stands until it plays");
  clock.play();
  clock.advance(0.75);
  assert.equal(clock.time, 2.5);
  clock.advance(1.5);
  assert.equal(clock.time, 1.5, "around the end");
  clock.setLoop(false);
  clock.advance(100);
  assert.deepEqual([clock.time, clock.playing], [5, false]);
  clock.play();
  assert.equal(clock.time, 1, "from the start again");
  clock.set(99);
  assert.equal(clock.time, 5);
  clock.set(Number.NaN);
  assert.equal(clock.time, 5);
  assert.ok(told > 5);
});

test("the clock steps from sample to sample", () => {
  const clock = new Clock(Float64Array.from([1, 1.5, 3, 5]));
  clock.set(2);
  clock.step(1);
  assert.equal(clock.time, 3);
  clock.set(2);
  clock.step(-1);
  assert.equal(clock.time, 1.5);
  clock.step(-1);
  clock.step(-1);
  assert.equal(clock.time, 1);
  assert.equal(indexAt(clock.times, 4.9), 2);
  const twice = new Clock(Float64Array.from([0, 1, 1, 2]));
  twice.set(2);
  const back = [-1, -1, 1, 1].map((direction) => (twice.step(direction), twice.time));
  assert.deepEqual(back, [1, 0, 1, 2], "two samples at one time are one step");
});

test("speeds are 1, 2, 5 times powers of ten", () => {
  const clock = new Clock(Float64Array.from([0, 1]));
  const up = Array.from({ length: 5 }, () => (clock.changeSpeed(1), clock.speed));
  assert.deepEqual(up, [2, 5, 10, 20, 50]);
  const down = Array.from({ length: 7 }, () => (clock.changeSpeed(-1), clock.speed));
  assert.deepEqual(down, [20, 10, 5, 2, 1, 0.5, 0.2]);
  for (const [speed, direction, next] of [[0.3, 1, 0.5], [3, -1, 2], [3e-7, -1, 2e-7], [3, 1, 5], [1000, -1, 500], [1e-3, 1, 2e-3]]) {
    clock.speed = speed;
    clock.changeSpeed(direction);
    assert.equal(clock.speed, next);
  }
});

test("what a motion shows takes 5 to 10 s; without a period the speed is the real one where the eye can follow it", () => {
  assert.equal(watchable(11, 20, null), 1);
  assert.ok(Math.abs(watchable(1e12, 1e-10, null) * 1e12 - 6) < 2.1);
  assert.ok(60 / watchable(0.01, 60, null) >= 5, "a slow body's run does not flash by");
  assert.ok(0.01 / watchable(3, 0.01, null) >= 5, "a short run does not flash by");
  assert.ok(watchable(0, 20, null) > 0);
  for (let k = 0; k < 200; k += 1) {
    const period = 1e-12 * 1.37 ** k;
    const seconds = period / watchable(3 / period, 40 * period, period);
    assert.ok(seconds > 4.99 && seconds < 10.01, `${period} s in ${seconds} s`);
  }
  // The heavy top of the examples: 1.93 s a precession, 241 rad/s.
  assert.equal(watchable(241, 2, 1.9314), 0.3);
  // What would be a blur is slower, and a run that is shorter than the period is seen as long.
  assert.ok(watchable(1e4, 60, 2) * 1e4 < 120);
  assert.ok(0.1 / watchable(3, 0.1, 50) > 4.99);
});

test("a motion of one sample stands", () => {
  const clock = new Clock(Float64Array.from([3]));
  clock.play();
  assert.equal(clock.playing, false);
});

test("Euler angles are three turns: Rz(φ) Rx(θ) Rz(ψ)", () => {
  const [phi, theta, psi] = [2.1, 0.7, -1.4];
  const half = (phi + psi) / 2;
  const other = (phi - psi) / 2;
  const [c, s] = [Math.cos(theta / 2), Math.sin(theta / 2)];
  const q = [c * Math.cos(half), s * Math.cos(other), s * Math.sin(other), c * Math.sin(half)];
  euler313(q).forEach((angle, k) => assert.ok(Math.abs(angle - [phi, theta, psi][k]) < 1e-14));
  // The body's z axis leans by θ, toward the direction φ − 90°.
  const z = rotate(q, [0, 0, 1]);
  const want = [Math.sin(theta) * Math.sin(phi), -Math.sin(theta) * Math.cos(phi), Math.cos(theta)];
  z.forEach((x, k) => assert.ok(Math.abs(x - want[k]) < 1e-14));
  turned(q, [0.3, -2, 0.7]).forEach((x, k) => assert.ok(Math.abs(x - rotate(q, [0.3, -2, 0.7])[k]) < 1e-14));
});

test("attitudes between samples are those of the motion, to the fourth order", () => {
  const body = tensor([0.7, 1.3, 1.9], [0.5, 0.5, -0.5, 0.5]);
  const fine = integrate(body, [0.8, 0.36, -0.48, 0], [0.4, 1.1, -0.6], 8, 1601);
  // Twice the sine of half the angle between two attitudes.
  const apart = (p, q) => Math.min(Math.hypot(...p.map((x, k) => x - q[k])), Math.hypot(...p.map((x, k) => x + q[k])));
  const error = (every, way) => {
    let worst = 0;
    for (let i = 0; i + every < fine.length; i += every) {
      const [a, b] = [fine[i], fine[i + every]];
      // −q is the same attitude.
      const minus = b.q.map((x) => -x);
      for (const part of [0.25, 0.5, 0.75]) {
        const q = way === "slerp" ? slerp(a.q, minus, part) : between(a.q, a.omega, minus, b.omega, b.t - a.t, part);
        worst = Math.max(worst, apart(q, fine[i + part * every].q));
      }
    }
    return worst;
  };
  const [half, whole] = [error(40), error(80)];
  assert.ok(whole < 1e-3 && whole / half > 12 && whole / half < 20, `${whole} ${half}`);
  assert.ok(error(8, "slerp") < 3e-4 && error(80, "slerp") > 10 * whole);
  // At samples it is the sample, and a large turn is steady.
  assert.ok(apart(between(fine[0].q, fine[0].omega, fine[80].q, fine[80].omega, 0.4, 1), fine[80].q) < 1e-14);
  assert.ok(apart(between(fine[0].q, fine[0].omega, fine[80].q, fine[80].omega, 9, 0.3), slerp(fine[0].q, fine[80].q, 0.3)) < 1e-14);
});

test("numbers have the figures that they need, and their digits stay together", () => {
  assert.equal(number(0.0027978123), "0.0027978");
  assert.equal(number(-11.23456), "−11.235");
  assert.equal(number(5.0803e-4), "5.0803×10⁻⁴");
  assert.equal(number(Number.NaN), "–");
  assert.equal(mark(-0.5, 0.1), "−0.5");
  assert.equal(mark(2.5e-7, 5e-8), "2.5×10⁻⁷");
  assert.equal(powerOfTen(1e-13), "10⁻¹³");
  assert.deepEqual([3e-12, 0.02, 20, 9e4, 5e6].map((t) => timeUnit(t).name), ["ps", "ms", "s", "h", "d"]);
  assert.deepEqual([9e3, 10_800, 216e3, 259_200].map((t) => timeUnit(t).name), ["s", "h", "h", "d"], "hours from 3 h, days from 3 d");
  const plain = (text) => text.replaceAll("\u00a0", "_");
  assert.deepEqual([7, 8473, 34_061, 12_345_678].map(grouped), ["7", "8,473", "34,061", "12,345,678"]);
  const kept = words("gravity, g = (0, 0, −9.80665) m/s² in space axes, 3.25 rad/s (186.4 deg/s)");
  assert.deepEqual(kept.map(({ text }) => plain(text)), [
    "gravity,", "g_=_(0,", "0,", "−9.80665)_m/s²", "in", "space", "axes,", "3.25_rad/s", "(186.4_deg/s)",
  ]);
  assert.deepEqual(words("30 … 32.897 ×10⁻⁴ kg·m²").map(({ text }) => plain(text)), ["30_…_32.897_×10⁻⁴_kg·m²"]);
  assert.equal(words("x".repeat(80))[0].whole, false, "what is too long for a line may be broken");
});

test("units are of a size that people say", () => {
  const units = [["J", 2.3e-3], ["J", 159.9], ["J", 4.2e-7], ["N·m", 0.047], ["N·m", 2.6e-7], ["rad/s", 1.1e-3], ["rad/s", 8e12], ["kg·m²/s", 3.5e-4], ["kg·m²/s", 7.2], ["J", 6.2e-22], ["J", 0], ["°", 1e-3]];
  assert.deepEqual(units.map(([unit, size]) => unitFor(unit, size).name), [
    "mJ", "J", "µJ", "mN·m", "µN·m", "mrad/s", "10¹² rad/s", "10⁻⁶ kg·m²/s", "kg·m²/s", "10⁻²⁴ J", "J", "°",
  ]);
  for (const [unit, size] of units.filter(([unit, size]) => size > 0 && unit !== "°")) {
    const shown = size / unitFor(unit, size).size;
    assert.ok(shown >= 0.1 && shown < 1e4, `${size} ${unit}`);
  }
  assert.equal(quantity(7.7908e-4, "kg·m²/s", 6), "7.79080×10⁻⁴\u00a0kg·m²/s");
  assert.equal(quantity(0.00233725, "J", 6), "2.33725\u00a0mJ");
  assert.equal(quantity(31.25, "°", 4), "31.25°");
});

test("ticks lie in the range", () => {
  for (const [low, high] of [[-3.1, 7.7], [1e-9, 4e-9], [-180, 180], [2e5, 2.1e5]]) {
    const { values, step } = ticks(low, high, 6);
    assert.ok(values.length >= 2 && values.length <= 13);
    assert.ok(values.every((v) => v >= low - 1e-6 * step && v <= high + 1e-6 * step));
  }
  assert.deepEqual(decades(1e-17, 1e-14, 5), [1e-17, 1e-16, 1e-15, 1e-14].map((v) => 10 ** Math.round(Math.log10(v))));
  assert.deepEqual(ticks(-20, 400, 4, true).values, [0, 180, 360]);
  const [low, high] = padded([3.1, 3.1 + 1e-15], 1e-3);
  assert.ok(low < 3.1 - 4e-4 && high > 3.1 + 4e-4, "rounding does not fill a plot");
  assert.deepEqual(logRange([{ values: Float64Array.from([0, 3e-16, 2e-15]) }, { values: Float64Array.from([1e-21, 4e-15]) }], 4e-15), [10 ** -17, 10 ** -14]);
});

const line = (symbol, value, count = 400) => ({ symbol, label: symbol, ink: "ink", values: Float64Array.from({ length: count }, (_, i) => value(i / count)) });
const figure = (lines, rest = {}) => ({ id: "f", title: "F", quantity: "ω", unit: "rad/s", log: false, telling: Infinity, nothing: 1e-12, lines, ...rest });

test("constants are lines of text with their drift, those in fact", () => {
  const lines = [
    line("ωx", () => 0),
    line("ωy", (s) => 3e-14 * Math.sin(9 * s)),
    line("ωz", (s) => 240.855 * (1 + 2e-9 * Math.sin(7 * s))),
    line("|ω|", (s) => 1.7 * (1 + 1e-5 * Math.sin(7 * s))),
    { ...line("T + U", () => -3.73784), drift: 6.8e-17 },
    line("c", () => 0.3),
  ];
  const { constants, stacks } = arrange(figure(lines));
  assert.deepEqual(stacks.map((stack) => stack.lines.map(({ symbol }) => symbol)), [["|ω|"]], "10⁻⁵ of itself is a change");
  const said = sentences(constants, figure([])).map((text) => text.replaceAll("\u00a0", " "));
  assert.match(said[0], /^ωx = ωy = 0 to 3\.0×10⁻¹⁴ rad\/s$/);
  assert.match(said[1], /^ωz = 240\.855 rad\/s, constant to 4\.0×10⁻⁹$/);
  assert.equal(said[2], "T + U = −3.73784 rad/s, constant to 6.8×10⁻¹⁷");
  assert.equal(said[3], "c = 0.300000 rad/s, constant to the last bit");
  // A line that is not there all the time is not constant; a drift only if it is zero.
  const gap = line("φ", (s) => (s > 0.5 ? Number.NaN : 1));
  assert.equal(arrange(figure([gap])).constants.length, 0);
  const drift = arrange(figure([line("T", () => 0), line("L", () => 2e-16)], { log: true, unit: "relative" }));
  assert.deepEqual(sentences(drift.constants, { log: true, unit: "relative", quantity: "drift" }), ["drift of T: 0 in every sample"]);
  assert.deepEqual(drift.stacks[0].lines.map(({ symbol }) => symbol), ["L"]);
});

test("what samples may miss, or one sample says, is not said to be constant", () => {
  const plainly = (words) => words.map((text) => text.replaceAll("\u00a0", " "));
  // A symmetric top turns by 4π rad from a sample to the next, and its ω₁ = 0.3 cos(2π t) by a whole period.
  const moments = [1, 1, 1.5];
  const q = [0.8, 0.36, -0.48, 0];
  const omega = [0.3, 0, 4 * Math.PI];
  const rows = integrate(tensor(moments, [1, 0, 0, 0]), q, omega, 11, 12, undefined, 4000);
  const made = samples.free();
  const put = (numbers) => base64(Float64Array.from(numbers));
  const data = (rows) => ({
    ...made.motion,
    count: rows.length,
    times: put(rows.map(({ t }) => t)),
    attitude: put(rows.flatMap(({ q }) => q)),
    omega: put(rows.flatMap(({ omega }) => omega)),
    momentum: put(rows.flatMap(({ q, omega }) => rotate(q, omega.map((w, k) => moments[k] * w)))),
    kinetic: put(rows.map(({ omega }) => 0.5 * omega.reduce((sum, w, k) => sum + moments[k] * w * w, 0))),
    drift: [],
  });
  const said = (rows) => {
    const motion = new Motion(data(rows));
    const found = figuresOf(motion, { moments, quaternion: [1, 0, 0, 0] }).find(({ id }) => id === "omega");
    return plainly(sentences(arrange(found).constants, found));
  };
  const all = said(rows);
  assert.ok(all.length > 0 && all.some((text) => text.startsWith("ωx = 0.300000 rad/s, the same at all samples to ")), all.join("; "));
  assert.ok(all.every((text) => !text.includes("constant")), all.join("; "));
  assert.deepEqual(said(rows.slice(0, 1)).slice(0, 2), ["ωy = 0", "ωx = 0.300000 rad/s"]);
  // About a principal axis nothing oscillates, however far it turns.
  const steady = rows.map(({ t }) => ({ t, q: [Math.cos(5 * t), 0, 0, Math.sin(5 * t)], omega: [0, 0, 10] }));
  assert.ok(said(steady).includes("ωz = 10.0000 rad/s, constant to the last bit"), said(steady).join("; "));
});

test("no line is squashed: lines of other sizes have plots of their own", () => {
  const small = line("ωx", (s) => 3.2 * Math.sin(31 * s));
  const other = line("ωy", (s) => 2.9 * Math.cos(31 * s));
  const large = line("ωz", (s) => -240 + 11 * s);
  const far = line("|ω|", (s) => 251 + 0.3 * Math.sin(5 * s));
  const names = (groups) => groups.map((group) => group.map(({ symbol }) => symbol));
  assert.deepEqual(names(split([small, large, other, far])), [["ωx", "ωy"], ["ωz"], ["|ω|"]]);
  assert.deepEqual(names(split([small, other])), [["ωx", "ωy"]]);
  // At most three plots: what is left goes where it is seen best.
  const tiny = line("tiny", (s) => 251 + 0.002 * Math.sin(4 * s));
  assert.deepEqual(names(split([small, large, far, tiny])), [["ωx"], ["ωz"], ["|ω|", "tiny"]]);
  assert.deepEqual(names(split([{ ...small, alone: true }, other])), [["ωx"], ["ωy"]]);
  // The axis has the unit that fits, and a round number taken out where all digits are the same.
  const { stacks } = arrange(figure([line("E", (s) => 0.0471234 + 2e-7 * Math.sin(6 * s))], { unit: "J", quantity: "energy" }));
  assert.deepEqual([stacks[0].title, stacks[0].less], ["E − c (µJ)", "c = 47.123\u00a0mJ"]);
  const below = arrange(figure([line("U", (s) => -2.94312 + 2e-6 * Math.sin(6 * s))], { unit: "J" })).stacks[0];
  assert.deepEqual([below.title, below.less], ["U − c (µJ)", "c = −2.94313\u00a0J"]);
  const back = (stacks[0].lines[0].values[57] + stacks[0].offset) * stacks[0].unit.size;
  assert.ok(Math.abs(back - (0.0471234 + 2e-7 * Math.sin((6 * 57) / 400))) < 1e-12);
  assert.equal(arrange(figure([line("ψ", (s) => 27000 * s)], { unit: "°" })).stacks[0].title, "ψ (turns)");
});

const near = (a, b, by, what) => assert.ok(Math.abs(a - b) <= by, `${what}: ${a}, not ${b}`);

/** The height of an edge at x. */
function level(edge, x) {
  const k = Math.max(edge.findIndex(([at]) => at > x), 1);
  const [[x0, y0], [x1, y1]] = [edge[k - 1], edge[k]];
  return x1 > x0 ? y0 + ((y1 - y0) * (x - x0)) / (x1 - x0) : y1;
}

test("stripes are drawn as an envelope, and zooming in brings the line back", () => {
  const count = 4000;
  // An oscillation whose size swells: 160 turns.
  const size = (s) => 20 + 14 * Math.sin(7 * s);
  const value = (i) => 100 + size(i / count) * Math.sin((320 * Math.PI * i) / count);
  const places = (width, from = 0) => Float64Array.from({ length: count }, (_, i) => ((i - from) / count) * width);
  const y = Float64Array.from({ length: count }, (_, i) => value(i));
  const spans = envelopes(places(400), y);
  assert.equal(spans.length, 1);
  const [{ first, last, low, high, resolved }] = spans;
  assert.deepEqual([first, last, resolved], [0, count - 1, true]);
  for (const [edge, sense] of [[low, -1], [high, 1]]) {
    assert.ok(edge.length > 20 && edge[0][0] === 0 && edge.at(-1)[0] > 399);
    for (const [x, y] of edge.slice(1, -1)) assert.ok(Math.abs(sense * (y - 100) - size(x / 400)) < 0.2, `${x} ${y}`);
    // Between its points, too: it has an extremum in each half turn.
    for (let k = 4; k < 156; k += 1) near(sense * (level(edge, 2.5 * k) - 100), size(k / 160), 0.7, `at ${2.5 * k}`);
  }
  assert.deepEqual(envelopes(places(4000), y), [], "with room it is the line");
  const drawn = curve(places(400), y);
  assert.deepEqual([drawn.bands.length, drawn.strokes.length], [1, 2]);
  assert.equal(curve(places(4000), y).strokes[0].length, count);
  // Sampled about twice in an oscillation, no width makes it a line.
  const coarse = Float64Array.from({ length: count }, (_, i) => 100 + 30 * Math.sin(2.7 * i));
  const missed = envelopes(places(40000), coarse);
  assert.deepEqual([missed.length, missed[0].resolved], [1, false]);
  const [{ low: bottom, high: top }] = envelopes(places(400), coarse);
  for (let x = 5; x < 395; x += 1) [bottom, top].forEach((edge, k) => near(level(edge, x), k === 0 ? 70 : 130, 0.5, `at ${x}`));
  // Of two frequencies the edges are those of the sum, without teeth, and nothing is beyond them.
  const beat = Float64Array.from({ length: count }, (_, i) => 100 + 20 * Math.sin(0.5 * i) + 9 * Math.sin(0.19 * i + 1));
  const [{ low: lower, high: upper }] = envelopes(places(400), beat);
  for (const [edge, sense] of [[lower, -1], [upper, 1]]) {
    places(400).forEach((x, i) => assert.ok(sense * (level(edge, x) - beat[i]) > -0.02, `sample ${i}`));
    for (let x = 20; x < 380; x += 1) near(sense * (level(edge, x) - 100), 29, 0.6, `at ${x}`);
  }
  // One part may be dense, the other not; a break belongs to neither.
  const chirp = Float64Array.from({ length: count }, (_, i) => 100 + 30 * Math.sin(3e-5 * (i - count) ** 2));
  const parts = curve(places(400), chirp);
  assert.equal(parts.bands.length, 1);
  assert.ok(parts.strokes.at(-1).length > 300, "the rest is the line itself");
  const starts = new Uint8Array(count);
  starts[2000] = 1;
  assert.deepEqual(envelopes(places(400), y, starts).map(({ first, last }) => [first, last]), [[0, 1999], [2000, count - 1]]);
  assert.deepEqual(extrema([0, 3, 1, 1.5, 0.9, 5, 5.2, 2], 0, 7, 1), [0, 1, 4, 6]);
});

test("a line of a tenth of another's range has an axis of its own, and readings have units", () => {
  const [camera, panel] = [line("camera", (s) => 8 + 8 * Math.sin(5 * s)), line("panel", (s) => 90 + 80 * Math.sin(4 * s))];
  const { stacks } = arrange(figure([camera, panel], { unit: "°" }));
  assert.deepEqual(stacks.map(({ title, readingUnit }) => [title, readingUnit]), [["camera (°)", "°"], ["panel (°)", "°"]]);
  const momentum = arrange(figure([line("L", (s) => 3e-4 * Math.sin(6 * s))], { unit: "kg·m²/s" }));
  assert.equal(momentum.stacks[0].readingUnit, "×10⁻⁶ kg·m²/s");
  assert.equal(arrange(figure([line("F", (s) => 0.02 + 0.01 * Math.sin(6 * s))], { unit: "N" })).stacks[0].readingUnit, "mN");
  assert.equal(arrange(figure([line("T", (s) => 1e-15 * s)], { log: true, unit: "relative" })).stacks[0].readingUnit, "");
});

test("parts of one name have one colour, each with contrast to the page, in both themes", () => {
  const inks = inksOf(["bus", "panel, left", "panel, right", "tank 1", "tank 2", "boom"].map((name) => ({ name })));
  assert.deepEqual(inks, ["part-1", "part-2", "part-2", "part-3", "part-3", "part-4"]);
  const css = readFileSync(new URL("../src/theme.css", import.meta.url), "utf8");
  const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  for (const theme of [0, 1]) {
    const rgb = (name) => new RegExp(`--${name}: light-dark\\(#([0-9a-f]{6}), #([0-9a-f]{6})\\);`).exec(css)[1 + theme].match(/../g).map((c) => parseInt(c, 16));
    const luminance = (name) => rgb(name).reduce((sum, c, k) => sum + [0.2126, 0.7152, 0.0722][k] * linear(c / 255), 0);
    const parts = PARTS.map((part) => ({ part, rgb: rgb(part) }));
    for (const { part, rgb: a } of parts) {
      const [low, high] = [luminance(part), luminance("paper")].sort((p, q) => p - q);
      assert.ok((high + 0.05) / (low + 0.05) > 2, `${part} on paper`);
      for (const other of parts) if (other.part > part) assert.ok(Math.hypot(...a.map((c, k) => c - other.rgb[k])) > 25, `${part} and ${other.part}`);
    }
  }
});

test("each colour of the themes is stated once", () => {
  const css = readFileSync(new URL("../src/theme.css", import.meta.url), "utf8");
  const names = [...css.matchAll(/^ *(--[a-z0-9-]+):/gm)].map(([, name]) => name);
  assert.ok(names.length > 20 && new Set(names).size === names.length, names.join());
  assert.ok(!css.includes("prefers-color-scheme"));
});

test("a solid with a part inside is transparent", () => {
  const unit = [Math.cos(0.3), 0, Math.sin(0.3), 0];
  const cube = (position, size) => ({ kind: "box", name: "", position, quaternion: unit, size: [size, size, size] });
  // Corners of a cube that stands upright.
  const corners = ([x, y, z], size) => Float64Array.from({ length: 24 }, (_, k) => [x, y, z][k % 3] + ((Math.floor(k / 3) >> (k % 3)) & 1 ? 0.5 : -0.5) * size);
  const shapes = [cube([1, 2, 3], 2), cube([1.1, 2.1, 3], 0.5), cube([2, 2, 3], 0.5)];
  const inside = (third) => enclosing(shapes, [corners([1, 2, 3], 2), corners([1.1, 2.1, 3], 0.5), third]);
  assert.deepEqual(inside(corners([2, 2, 3], 0.5)), [true, false, false]);
  assert.deepEqual(enclosing(shapes.slice(1), [corners([1.1, 2.1, 3], 0.5), corners([2, 2, 3], 0.5)]), [false, false], "neither is in the other");
});

test("the shadow lies on the floor below the body, along its outline", () => {
  const bound = { shared: (_, __, make) => make() };
  const normal = new Vector3(0.2, -0.1, 1).normalize();
  // A rod of length 2 and thickness 0.2, inclined, its middle at (0.4, 0.3, 0.9).
  const outline = Array.from({ length: 200 }, (_, k) => new Vector3(-1 + k / 99.5, 0.1 * Math.cos(k), 0.1 * Math.sin(k)));
  const turn = new Quaternion().setFromAxisAngle(new Vector3(0.3, -0.4, 0.86).normalize(), 0.8);
  const middle = new Vector3(0.4, 0.3, 0.9);
  const shadow = new Shadow(normal, outline, bound);
  shadow.pose((p) => p.clone().applyQuaternion(turn).add(middle));
  const [a, b, n] = [new Vector3(), new Vector3(), new Vector3()];
  shadow.object.matrix.extractBasis(a, b, n);
  const center = new Vector3().setFromMatrixPosition(shadow.object.matrix);
  near(center.dot(normal), 0.003, 1e-9, "on the floor");
  const below = middle.clone().addScaledVector(normal, -middle.dot(normal));
  assert.ok(center.distanceTo(below) < 0.03, "below the middle");
  const along = new Vector3(1, 0, 0).applyQuaternion(turn);
  const flat = along.clone().addScaledVector(normal, -along.dot(normal));
  const long = a.length() > b.length() ? a : b;
  near(Math.abs(long.clone().normalize().dot(flat.clone().normalize())), 1, 1e-3, "along the rod");
  assert.ok(a.length() + b.length() > 1.2 * flat.length() && Math.min(a.length(), b.length()) < 0.3);
  assert.ok(n.distanceTo(normal) < 1e-12);
});

test("the largest so far rises in steps over the dots", () => {
  const { strokes, dots } = largestSoFar([0, 1, 2, 3, 4], [50, Number.NaN, 60, 30, 40]);
  assert.deepEqual(strokes, [[[0, 50], [3, 50], [3, 30], [4, 30]]]);
  assert.deepEqual(dots, [[0, 50], [2, 60], [3, 30], [4, 40]]);
});

test("events have letters that do not overprint each other", () => {
  const all = marked([{ time: 2, name: "off" }, { time: 3, name: "on" }, { time: 7, name: "off" }]);
  assert.deepEqual(all, [{ letter: "A", name: "off", times: [2, 7] }, { letter: "B", name: "on", times: [3] }]);
  assert.deepEqual(marksOf(all).map(({ letter, time }) => letter + time), ["A2", "B3", "A7"]);
  assert.deepEqual(labels([10, 40, 44, 200], ["A", "A", "B", "A"], 11), ["A", "AB", "", "A"]);
  assert.deepEqual(labels([10, 11, 12, 13, 14], ["A", "A", "B", "C", "D"], 11), ["AB…", "", "", "", ""]);
});

const principal = (page) => page.body.principal;

test("no figure has an empty range, and files hold the same as the screen", () => {
  for (const make of [samples.free, samples.heavy, samples.tilted, samples.wheeled]) {
    const made = make();
    const motion = new Motion(made.motion);
    for (const figure of figuresOf(motion, principal(made))) {
      const arranged = arrange(figure);
      assert.equal(arranged.constants.length + arranged.stacks.flatMap(({ lines }) => lines).length, figure.lines.length, figure.id);
      const svg = svgOf(figure, arranged, motion.times, motion.times[0], motion.times[motion.count - 1], marked(motion.events));
      assert.ok(!svg.includes("NaN") && !svg.includes("Infinity"), figure.id);
      for (const { title, range, less } of arranged.stacks) {
        assert.ok(svg.includes(`>${title}</text>`) && svg.includes(less), title);
        assert.ok(Number.isFinite(range[1] - range[0]) && range[1] > range[0], `${title}: ${range}`);
      }
      if (arranged.stacks.length > 0) assert.ok(svg.includes(">time t (s)</text>"));
    }
  }
});

test("a free body's T and |L| are constants, its parts along the axes are drawn", () => {
  const made = samples.free();
  const motion = new Motion(made.motion);
  const [energy, momentum] = ["energy", "momentum"].map((id) => figuresOf(motion, principal(made)).find((f) => f.id === id));
  for (const [figure, symbol] of [[energy, "T"], [momentum, "|L|"]]) {
    const { constants, stacks } = arrange(figure);
    assert.deepEqual(constants.map((c) => c.symbol), [symbol]);
    const drift = numbersOf(made.motion.drift.find(({ name }) => name === symbol).values);
    assert.equal(constants[0].drift, Math.max(...drift.map(Math.abs)), "its balance says how far it fails");
    assert.equal(stacks.flatMap(({ lines }) => lines).length, 3);
  }
  // The parts add up, at any sample.
  const at = (figure, i) => figure.lines.slice(0, 3).map(({ values }) => values[i]);
  for (const i of [77, 1234]) {
    assert.ok(Math.abs(at(energy, i).reduce((a, b) => a + b) / motion.kinetic[i] - 1) < 1e-12);
    assert.ok(Math.abs(Math.hypot(...at(momentum, i)) / Math.hypot(...motion.momentum.subarray(3 * i, 3 * i + 3)) - 1) < 1e-12);
  }
});

test("vectors are drawn along the body axes, or along one other set with marks of its own", () => {
  const i = 611;
  const quaternion = [0.8, 0.36, -0.48, 0];
  for (const make of [samples.free, samples.heavy]) {
    const made = make();
    const motion = new Motion(made.motion);
    const attitude = motion.attitudeOf(i);
    const lines = (set, id) => figuresOf(motion, { ...principal(made), quaternion }, set).find((f) => f.id === id).lines.slice(0, 3);
    const at = (set, id) => lines(set, id).map(({ values }) => values[i]);
    const same = (a, b) => a.forEach((x, k) => near(x, b[k], 1e-12 * Math.hypot(...b), "component"));
    const omega = [...motion.omega.subarray(3 * i, 3 * i + 3)];
    const momentum = [...motion.momentum.subarray(3 * i, 3 * i + 3)];
    same(at("body", "omega"), omega);
    same(rotate(quaternion, at("principal", "omega")), omega);
    same(at("space", "omega"), rotate(attitude, omega));
    same(rotate(attitude, at("body", "momentum")), momentum);
    same(rotate(attitude, rotate(quaternion, at("principal", "momentum"))), momentum);
    const styles = ["body", "principal", "space"].map((set) => lines(set, "omega").map(({ symbol, ink, dash }) => [symbol, ink, String(dash)]));
    assert.deepEqual(styles[0].map(([symbol]) => symbol), ["ωx", "ωy", "ωz"]);
    assert.equal(new Set(styles.map(([[, , dash]]) => dash)).size, 3, "a dash of its own for each set");
  }
  const made = samples.free();
  const motion = new Motion(made.motion);
  const symbols = (set, body = principal(made)) => figuresOf(motion, body, set).find(({ id }) => id === "energy").lines.map(({ symbol }) => symbol);
  assert.deepEqual(symbols("body"), ["½Ixωx²", "½Iyωy²", "½Izωz²", "T"], "the principal axes are the body axes in another order");
  assert.deepEqual(symbols("body", { ...principal(made), quaternion }), ["T"]);
  assert.deepEqual(symbols("principal"), ["½i₁ω₁²", "½i₂ω₂²", "½i₃ω₃²", "T"]);
});

test("what is rounding is nothing, and where angles do not exist their sum is drawn", () => {
  const made = samples.wheeled();
  const motion = new Motion(made.motion);
  const figures = figuresOf(motion, principal(made));
  assert.deepEqual(figures.map(({ id }) => id), ["omega", "pointing", "energy", "momentum", "wheels", "wheel-speeds", "angles", "drift"]);
  const [momentum, angles, pointing] = ["momentum", "angles", "pointing"].map((id) => figures.find((f) => f.id === id));
  assert.deepEqual(sentences(arrange(momentum).constants, momentum), ["Lx = Ly = Lz = |L| = 0"]);
  const omega = figures[0];
  assert.deepEqual(omega.lines.map(({ label }) => label), ["ωx", "ωy", "ωz"], "|ω| is that of ωz");
  const svg = svgOf(omega, arrange(omega), motion.times, 0, 60, marked(motion.events));
  assert.ok(svg.includes("A  &lt;b&gt;motor on&lt;/b&gt;, at 5.000 s") && svg.includes("C  just after") && svg.includes(">BC</text>"));
  assert.deepEqual(pointing.lines.map(({ label, values }) => [label, values[100]]), [
    ["camera", ((0.7 + 0.2 * Math.sin(3)) * 180) / Math.PI],
    ["panel", ((1.4 + 0.1 * Math.cos(2)) * 180) / Math.PI],
  ]);
  // The body turns about z alone: θ = 0.
  assert.deepEqual(angles.lines.map(({ label }) => label), ["θ nutation", "φ + ψ"]);
  const [, sum] = angles.lines;
  assert.ok(Math.abs(sum.values[250] - (-0.015 / 3.1) * 200 * (180 / Math.PI)) < 1e-9);
});

test("angles go on beyond a turn, and are left out where samples do not follow them", () => {
  const made = samples.heavy();
  const { lines } = figuresOf(new Motion(made.motion), principal(made)).find((f) => f.id === "angles");
  const spin = lines.find(({ symbol }) => symbol === "ψ").values;
  for (let i = 1; i < spin.length; i += 1) assert.ok(Math.abs(spin[i] - spin[i - 1]) < 40);
  assert.ok(spin.at(-1) > 100 * 360);
  // Every eighth sample: the body turns by 1.9 rad.
  const every = (text, width, step) => {
    const all = numbersOf(text);
    return base64(Float64Array.from({ length: Math.floor(all.length / width / step) * width }, (_, k) => all[Math.floor(k / width) * step * width + (k % width)]));
  };
  const thin = { ...made.motion, count: 375, potential: null, drift: [] };
  for (const [key, width] of [["times", 1], ["attitude", 4], ["omega", 3], ["momentum", 3], ["torque", 3], ["kinetic", 1]]) thin[key] = every(made.motion[key], width, 8);
  const angles = figuresOf(new Motion(thin), principal(made)).find((f) => f.id === "angles");
  assert.deepEqual(angles.lines.map(({ symbol }) => symbol), ["θ"]);
  assert.match(angles.note, /left out/);
});

test("data that break the contract are refused, with what and how", () => {
  const eight = (numbers) => Buffer.from(Float64Array.from(numbers).buffer).toString("base64");
  assert.throws(() => f64(eight([1, 2]), "times", 3), /times: 2 numbers instead of 3/);
  assert.throws(() => f64(eight([1, Number.NaN]), "omega"), /omega: a number is not finite/);
  assert.throws(() => f64("AAAA", "omega"), /not a multiple of 8/);
  assert.throws(() => f64("%%%", "omega"), /not base64/);
  assert.throws(() => indices(Buffer.from(Uint32Array.from([0, 7]).buffer).toString("base64"), "mesh", 7), /beyond 6/);
  const motion = { ...samples.free().motion, count: 3 };
  assert.throws(() => new Motion(motion), /times: 2001 numbers instead of 3/);
  const page = (text) => ({ getElementById: () => ({ textContent: text }) });
  assert.throws(() => readPage(page('{"version":2}')), /version 2/);
  assert.throws(() => readPage({ getElementById: () => null }), /no motion/);
});

test("the numbers of a live motion stand behind its JSON and are read where they are", () => {
  const numbers = Float64Array.of(0.25, -1.5, 5e-324, Number.MAX_VALUE, 1 / 3);
  const motion = { count: 2, times: { f64: [0, 2] }, torque: null, drift: [{ name: "T", values: { f64: [3, 2] } }] };
  const free = { period: 1.5, polhode: { f64: [2, 1] }, family: [{ f64: [1, 2] }, { f64: [5, 0] }] };
  const packed = (answer) => {
    const head = new TextEncoder().encode(JSON.stringify(answer));
    const length = 8 * Math.ceil(head.length / 8);
    const bytes = new Uint8Array(8 + length + numbers.byteLength).fill(32);
    new DataView(bytes.buffer).setBigUint64(0, BigInt(length), true);
    bytes.set(head, 8);
    bytes.set(new Uint8Array(numbers.buffer), 8 + length);
    return bytes.buffer;
  };
  const bytes = packed({ text: "ω", motion: { page: { title: "ψ", motion, free }, body: "7" }, took: 1 });
  const { text, motion: found } = motionAnswer(bytes);
  assert.deepEqual([text, found.page.title, found.body], ["ω", "ψ", "7"]);
  assert.deepEqual(found.page.motion, { count: 2, times: numbers.slice(0, 2), torque: null, drift: [{ name: "T", values: numbers.slice(3, 5) }] });
  assert.deepEqual(found.page.free, { period: 1.5, polhode: numbers.slice(2, 3), family: [numbers.slice(1, 3), new Float64Array(0)] });
  assert.equal(found.page.motion.times.buffer, bytes, "nothing is copied");
  assert.equal(motionAnswer(packed({ motion: { page: { motion, free: null } } })).motion.page.free, null);
  assert.equal(motionAnswer(packed({ motion: null })).motion, null);
});

test("of many points those that are farthest in each direction are found, in any order and from any distance", () => {
  let state = 1;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647 - 0.5;
  const [point] = directions(1);
  const at = (x, y, z) => point.clone().set(x, y, z);
  for (const spread of [(v) => v, (v) => v.normalize(), (v) => at(v.x + 3, 0.1 * v.y, -v.z), (v) => at(v.x, 0, 0)]) {
    const points = Array.from({ length: 700 }, () => spread(at(random(), random(), random())));
    const farthest = new Farthest(300);
    for (const p of points) farthest.add(p);
    // In each of the directions, in the order that it has them, one is as far as any.
    const reach = (some, d) => Math.max(...some.map((p) => p.dot(d)));
    for (const d of directions(300)) assert.ok(Math.abs(reach(farthest.points, d) - reach(points, d)) <= 1e-15, `${d.toArray()}`);
    // What was found of some is where it goes on with the others; those that went before stay as they were.
    const some = new Farthest(300);
    for (const p of points.slice(0, 400)) some.add(p);
    const found = some.points.map((p) => p.clone());
    const both = new Farthest(300, some.points);
    for (const p of points.slice(400)) both.add(p);
    assert.deepEqual(both.points, farthest.points);
    assert.deepEqual(some.points, found);
  }
});

test("the curve of an orbit is its conic, whole or as far as the motion goes, in the unit sphere", () => {
  const n = new Vector3(0.36, -0.8, 0.48);
  const toward = new Vector3(0.8, 0, -0.6);
  const ahead = n.clone().cross(toward);
  const parameter = 1.1e7;
  const out = (nu) => toward.clone().multiplyScalar(Math.cos(nu)).addScaledVector(ahead, Math.sin(nu));
  for (const [e, nus, isWhole] of [[0, [-1.7, 0.4], true], [0.3, [-1.7, 0.4], true], [0.98, [2.9, 3.1], true], [0.98, [-1.7, 0.4], false], [1, [-1.7, 0.4], false], [2.1, [-1.7, 0.4], false]]) {
    const outs = nus.map(out);
    const data = { parameter, eccentricity: toward.clone().multiplyScalar(e).toArray(), normal: n.toArray(), central: null };
    const conic = new Conic(data, outs);
    const middle = conic.at(new Vector3());
    const places = conic.points.map((p) => p.clone().sub(middle).multiplyScalar(conic.unit));
    for (const p of places) {
      const [r, x] = [p.length(), p.dot(toward)];
      assert.ok(Math.abs(r + e * x - parameter) < 1e-9 * (r + parameter) && Math.abs(p.dot(n)) < 1e-9 * r, `e = ${e}: ${p.toArray()}`);
    }
    const far = Math.max(...conic.points.map((p) => p.length()));
    assert.ok(far < 1 + 1e-12 && far > 0.7, `e = ${e}: ${far}`);
    // No bend of it has few points: each is short of a 20th of the picture from the next.
    const steps = conic.points.slice(1).map((p, k) => p.distanceTo(conic.points[k]));
    assert.ok(Math.max(...steps) < 0.1, `e = ${e}: ${Math.max(...steps)}`);
    assert.equal(conic.points[0].distanceTo(conic.points.at(-1)) < 1e-9, isWhole, `e = ${e}`);
    // The body at both ends of the motion is on the curve.
    for (const one of outs) {
      const place = conic.at(one.clone().multiplyScalar(conic.distance(one)));
      assert.ok(Math.min(...conic.points.map((p) => p.distanceTo(place))) < 0.05, `e = ${e}`);
    }
  }
});

test("base 32768 gives back every length of bytes, and its text has no meaning in HTML", async () => {
  const { bytesOf32768, text32768 } = await load("live/base32768.ts");
  for (const length of [...Array(32).keys(), 1023]) {
    const bytes = Uint8Array.from({ length }, (_, k) => (k * 151 + 255) % 256);
    const text = text32768(bytes);
    assert.match(text, /^[\u4000-\ubfff]*$/);
    assert.equal(text.length, Math.ceil((8 * length) / 15));
    assert.deepEqual(bytesOf32768(text, length), bytes);
  }
  // The first digit has the first 15 bits; the last one ends in zeros.
  assert.equal(text32768(Uint8Array.of(0x80, 0x03, 0xff)), String.fromCharCode(0x4000 + 0x4001, 0x4000 + 0x7fc0));
  assert.throws(() => bytesOf32768("\u4000\u4000", 9), /2 characters are not 9 bytes/);
});

test("an answer of the engine is JSON, or JSON and rows", async () => {
  const { jsonAndRows } = await load("live/rows.ts");
  const plain = new TextEncoder().encode('{"took": 2}').buffer;
  assert.deepEqual(jsonAndRows(plain).json, { took: 2 });
  const json = '{"row": {"f64": [1, 2]}}';
  const bytes = new Uint8Array(8 + json.length + 24);
  new DataView(bytes.buffer).setBigUint64(0, BigInt(json.length), true);
  bytes.set(new TextEncoder().encode(json), 8);
  bytes.set(new Uint8Array(Float64Array.of(7, 8.5, -9).buffer), 8 + json.length);
  const { json: read, withRows } = jsonAndRows(bytes.buffer);
  assert.deepEqual(withRows(read), { row: Float64Array.of(8.5, -9) });
});
