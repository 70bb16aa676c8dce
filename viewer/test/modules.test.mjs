// What needs no browser: the clock, attitudes, numbers, figures.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";
import { integrate, rotate, samples, tensor } from "./sample.mjs";

const { Clock, watchable, indexAt } = await load("clock.ts");
const { between, euler313, slerp, rotate: turned } = await load("attitude.ts");
const { number, mark, powerOfTen, timeUnit } = await load("format.ts");
const { figuresOf, isZero, rangeOf, ticks, decades } = await load("figures.ts");
const { Motion } = await load("motion.ts");
const { svgOf } = await load("export.ts");
const { f64, indices, readPage } = await load("decode.ts");

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
});

test("speeds are 1, 2, 5 times powers of ten", () => {
  const clock = new Clock(Float64Array.from([0, 1]));
  const up = Array.from({ length: 5 }, () => (clock.changeSpeed(1), clock.speed));
  assert.deepEqual(up, [2, 5, 10, 20, 50]);
  const down = Array.from({ length: 7 }, () => (clock.changeSpeed(-1), clock.speed));
  assert.deepEqual(down, [20, 10, 5, 2, 1, 0.5, 0.2]);
  clock.speed = 0.3;
  clock.changeSpeed(1);
  assert.equal(clock.speed, 0.5);
});

test("what a motion shows takes 5 to 10 s; without a period the speed is the real one where the eye can follow it", () => {
  assert.equal(watchable(11, 20, null), 1);
  assert.ok(Math.abs(watchable(1e12, 1e-10, null) * 1e12 - 6) < 2.1);
  assert.ok(60 / watchable(0.01, 60, null) >= 5, "a slow body's run does not flash by");
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

test("numbers have the figures that they need", () => {
  assert.equal(number(0.0027978123), "0.0027978");
  assert.equal(number(-11.23456), "−11.235");
  assert.equal(number(5.0803e-4), "5.0803×10⁻⁴");
  assert.equal(number(Number.NaN), "–");
  assert.equal(mark(-0.5, 0.1), "−0.5");
  assert.equal(mark(2.5e-7, 5e-8), "2.5×10⁻⁷");
  assert.equal(powerOfTen(1e-13), "10⁻¹³");
  assert.deepEqual([3e-12, 0.02, 20, 9e4, 5e6].map((t) => timeUnit(t).name), ["ps", "ms", "s", "h", "d"]);
});

test("ticks lie in the range", () => {
  for (const [low, high] of [[-3.1, 7.7], [1e-9, 4e-9], [-180, 180], [2e5, 2.1e5]]) {
    const { values, step } = ticks(low, high, 6);
    assert.ok(values.length >= 2 && values.length <= 13);
    assert.ok(values.every((v) => v >= low - 1e-6 * step && v <= high + 1e-6 * step));
  }
  assert.deepEqual(decades(1e-17, 1e-14, 5), [1e-17, 1e-16, 1e-15, 1e-14].map((v) => 10 ** Math.round(Math.log10(v))));
});

test("what is constant is drawn as a constant, and no figure has an empty range", () => {
  for (const make of [samples.free, samples.heavy]) {
    const motion = new Motion(make().motion);
    for (const figure of figuresOf(motion)) {
      const [low, high] = rangeOf(figure);
      assert.ok(low < high, figure.id);
      const svg = svgOf(figure, motion.times, motion.times[0], motion.times[motion.count - 1]);
      assert.ok(!svg.includes("NaN") && !svg.includes("Infinity"), figure.id);
      assert.equal(svg.match(/<path /g).length, figure.lines.length);
    }
    const [low, high] = rangeOf(figuresOf(new Motion(samples.free().motion)).find((f) => f.id === "energy"));
    assert.ok(high - low > 1e-2 * high);
  }
});

test("what is rounding is nothing, and where angles do not exist their sum is drawn", () => {
  const motion = new Motion(samples.wheeled().motion);
  const figures = figuresOf(motion);
  assert.deepEqual(figures.map(({ id }) => id), ["omega", "energy", "momentum", "wheels", "wheel-speeds", "angles", "drift"]);
  const [momentum, angles] = ["momentum", "angles"].map((id) => figures.find((f) => f.id === id));
  assert.ok(isZero(momentum) && momentum.lines.length === 4);
  const svg = svgOf(momentum, motion.times, 0, 60, motion.events);
  assert.ok(svg.includes(">0</text>") && !svg.includes("0.5</text>"));
  assert.ok(svg.includes("&lt;b&gt;motor on") && svg.includes("motor off") && !svg.includes("just after"));
  // The body turns about z alone: θ = 0.
  assert.deepEqual(angles.lines.map(({ label }) => label), ["θ nutation", "φ + ψ"]);
  const [, sum] = angles.lines;
  assert.ok(Math.abs(sum.values[250] - (-0.015 / 3.1) * 200 * (180 / Math.PI)) < 1e-9);
  assert.ok(!isZero(figures[0]));
});

test("the end of a run-away does not say how large the rest is", () => {
  const made = samples.heavy().motion;
  const omega = numbersOf(made.omega);
  omega[omega.length - 1] = 1e12;
  const data = { ...made, omega: base64(omega), complete: false };
  const [low, high] = rangeOf(figuresOf(new Motion(data))[0]);
  assert.ok(low > -200 && high < 200);
  const whole = rangeOf(figuresOf(new Motion({ ...data, complete: true }))[0]);
  assert.ok(whole[1] > 1e12);
  const torque = figuresOf(new Motion(made)).find((f) => f.id === "torque");
  const given = numbersOf(made.torque);
  [0, 1, 2].forEach((k) => assert.equal(torque.lines[k].values[77], given[3 * 77 + k]));
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
