// Sample pages: motions integrated here in a few lines, so that the viewer is tested without polhode.
// node test/sample.mjs free|symmetric|heavy|tilted|mesh|balls prints the data of a page as JSON.
import { pathToFileURL } from "node:url";

const b64 = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");
const f64 = (numbers) => b64(Float64Array.from(numbers));
const f32 = (numbers) => b64(Float32Array.from(numbers));
const u32 = (numbers) => b64(Uint32Array.from(numbers));

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const times = (m, v) => m.map((row) => dot(row, v));
const product = ([a, b, c, d], [e, f, g, h]) => [
  a * e - b * f - c * g - d * h,
  a * f + b * e + c * h - d * g,
  a * g - b * h + c * e + d * f,
  a * h + b * g - c * f + d * e,
];
export const rotate = (q, v) => product(product(q, [0, ...v]), [q[0], -q[1], -q[2], -q[3]]).slice(1);
const matrixOf = (q) => {
  const columns = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((e) => rotate(q, e));
  return [0, 1, 2].map((i) => columns.map((c) => c[i]));
};
const transpose = (m) => [0, 1, 2].map((i) => m.map((row) => row[i]));
const multiply = (a, b) => a.map((row) => transpose(b).map((column) => dot(row, column)));

/** Body axes are turned from the principal axes by a generic rotation, so that none can be taken for the other. */
export function tensor(moments, quaternion) {
  const r = matrixOf(quaternion);
  const diagonal = moments.map((m, i) => [0, 1, 2].map((k) => (i === k ? m : 0)));
  const inverse = moments.map((m, i) => [0, 1, 2].map((k) => (i === k ? 1 / m : 0)));
  return { inertia: multiply(multiply(r, diagonal), transpose(r)), inverse: multiply(multiply(r, inverse), transpose(r)) };
}

/** Euler's equations by Runge and Kutta's method: rows of { t, q, omega }. `torque(q)` in body axes. */
export function integrate({ inertia, inverse }, q, omega, duration, count, torque = () => [0, 0, 0], fine = 20) {
  const rate = (y) => {
    const [q, w] = [y.slice(0, 4), y.slice(4)];
    const n = torque(q);
    const gyroscopic = cross(w, times(inertia, w));
    return [...product(q, [0, ...w]).map((x) => x / 2), ...times(inverse, n.map((x, i) => x - gyroscopic[i]))];
  };
  const add = (y, k, h) => y.map((x, i) => x + h * k[i]);
  let y = [...q, ...omega];
  const rows = [];
  const h = duration / (count - 1) / fine;
  for (let i = 0; i < count; i += 1) {
    rows.push({ t: (i * duration) / (count - 1), q: y.slice(0, 4), omega: y.slice(4) });
    for (let s = 0; s < fine; s += 1) {
      const a = rate(y);
      const b = rate(add(y, a, h / 2));
      const c = rate(add(y, b, h / 2));
      const d = rate(add(y, c, h));
      y = y.map((x, k) => x + (h / 6) * (a[k] + 2 * b[k] + 2 * c[k] + d[k]));
      const n = Math.hypot(...y.slice(0, 4));
      for (let k = 0; k < 4; k += 1) y[k] /= n;
    }
  }
  return rows;
}

function motionData(rows, inertia, torque, potential, method) {
  const momenta = rows.map(({ q, omega }) => rotate(q, times(inertia, omega)));
  const kinetic = rows.map(({ omega }) => 0.5 * dot(omega, times(inertia, omega)));
  const total = kinetic.map((t, i) => t + (potential ? potential(rows[i].q) : 0));
  const first = norm(momenta[0]);
  return {
    count: rows.length,
    method,
    times: f64(rows.map((r) => r.t)),
    attitude: f64(rows.flatMap((r) => r.q)),
    omega: f64(rows.flatMap((r) => r.omega)),
    momentum: f64(momenta.flat()),
    torque: torque ? f64(rows.flatMap((r) => torque(r.q))) : null,
    kinetic: f64(kinetic),
    potential: potential ? f64(rows.map((r) => potential(r.q))) : null,
    drift: [
      { name: potential ? "T + U" : "T", values: f64(total.map((e) => (e - total[0]) / total[0])) },
      ...(torque
        ? []
        : [
            { name: "|L|", values: f64(momenta.map((m) => (norm(m) - first) / first)) },
            { name: "L in space", values: f64(momenta.map((m) => norm(m.map((x, k) => x - momenta[0][k])) / first)) },
          ]),
    ],
    work: null,
    wheels: [],
    pointings: [],
    directions: [],
    events: [],
    eventCount: 0,
    contact: null,
    complete: true,
  };
}

/** The curves of a free motion, from a fine integration. */
function freeData(body, rows, regime) {
  const { inertia } = body;
  const axes = transpose(matrixOf(body.quaternion));
  const momentum = (r) => times(inertia, r.omega);
  const energy = 0.5 * dot(rows[0].omega, momentum(rows[0]));
  const size = norm(momentum(rows[0]));
  const steps = 2400;
  const span = rows[rows.length - 1].t;
  const fine = integrate(body, rows[0].q, rows[0].omega, span, steps, undefined, 8);
  // The period: ω is back, in place and direction, after it was away.
  const start = fine[0].omega;
  const speed = norm(fine[1].omega.map((x, k) => x - start[k]));
  let end = fine.findIndex((r, i) => i > 4 && norm(r.omega.map((x, k) => x - start[k])) < 0.75 * speed);
  if (end < 0) end = steps - 1;
  const loop = [...fine.slice(0, end), fine[0]];
  const [i1, i2, i3] = body.moments;
  const onSphere = (l) => axes.map((a) => dot(a, l) / size);
  const family = [];
  // Contours of Σ l²/i: L turns about axis 1 or 3 on every body.
  const contour = (l) => {
    const rates = tensor(body.moments, [1, 0, 0, 0]);
    const w = l.map((x, k) => (x / body.moments[k]) * size);
    const rows = integrate(rates, [1, 0, 0, 0], w, span, 1600, undefined, 4);
    const points = rows.map((r) => r.omega.map((x, k) => (x * body.moments[k]) / size));
    const step = norm(points[1].map((x, k) => x - points[0][k]));
    const stop = points.findIndex((p, i) => i > 4 && norm(p.map((x, k) => x - points[0][k])) < 0.75 * step);
    return [...points.slice(0, stop < 0 ? points.length : stop), ...(stop < 0 ? [] : [points[0]])];
  };
  if (i2 - i1 > 1e-9 && i3 - i2 > 1e-9) {
    for (const angle of [0.25, 0.5, 0.75, 1]) {
      for (const sign of [1, -1]) {
        family.push(contour([sign * Math.cos(angle * 0.55), Math.sin(angle * 0.55), 0]));
        family.push(contour([0, Math.sin(angle * 0.9), sign * Math.cos(angle * 0.9)]));
      }
    }
  }
  // Separatrix: the planes x² (1/i1 − 1/i2) = z² (1/i2 − 1/i3).
  const separatrix = [];
  if (i2 - i1 > 1e-9 && i3 - i2 > 1e-9) {
    for (const sign of [1, -1]) {
      const tilt = Math.atan2(Math.sqrt(1 / i1 - 1 / i2), sign * Math.sqrt(1 / i2 - 1 / i3));
      const ring = Array.from({ length: 181 }, (_, k) => {
        const a = (k * Math.PI) / 90;
        return [Math.sin(a) * Math.cos(tilt), Math.cos(a), Math.sin(a) * Math.sin(tilt)];
      });
      separatrix.push(f64(ring.flat()));
    }
  }
  return {
    regime,
    period: fine[end].t,
    momentum: size,
    energy,
    polhode: f64(loop.flatMap((r) => r.omega)),
    herpolhode: f64(fine.slice(0, Math.min(8 * end, steps)).flatMap((r) => rotate(r.q, r.omega))),
    separatrix,
    family: family.map((c) => f64(c.flat())),
    trace: f64(loop.flatMap((r) => onSphere(momentum(r)))),
    cones: conesOf(body, axes, loop, momentum),
  };
}

/** Angles of ω from the axis of least or greatest moment that it is nearer to, and from L. */
function conesOf({ moments }, axes, loop, momentum) {
  const axis = Math.abs(dot(axes[2], momentum(loop[0]))) > Math.abs(dot(axes[0], momentum(loop[0]))) ? axes[2] : axes[0];
  const angle = (a, b) => Math.acos(Math.abs(dot(a, b)) / norm(a) / norm(b));
  const range = (angles) => [Math.min(...angles), Math.max(...angles)];
  const precession = moments[0] === moments[1] ? "retrograde" : moments[1] === moments[2] ? "prograde" : null;
  return {
    body: range(loop.map(({ omega }) => angle(omega, axis))),
    space: range(loop.map((r) => angle(r.omega, momentum(r)))),
    precession,
  };
}

const FACTS = [
  {
    title: "Mass properties",
    rows: [
      { label: "mass", value: "0.23619", unit: "kg", note: "" },
      { label: "principal moments", value: "1.71e-5  4.61e-5  5.83e-5", unit: "kg·m²", note: "ascending, about the centre of mass" },
      { label: "symmetry", value: "asymmetric", unit: "", note: "" },
    ],
  },
  {
    title: "Motion",
    rows: [
      { label: "regime", value: "short-axis mode", unit: "", note: "L circles axis 3, the axis of greatest moment" },
      { label: "period of ω", value: "3.874", unit: "s", note: "" },
      { label: "flips every", value: "1.937", unit: "s", note: "" },
    ],
  },
  {
    title: "Evidence",
    rows: [
      { label: "energy, largest drift", value: "1.2e-15", unit: "relative", note: "" },
      { label: "|L|, largest drift", value: "8e-16", unit: "relative", note: "" },
    ],
  },
];
const MATH =
  "<math><mrow><mi>T</mi><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mi>ω</mi><mo>·</mo><mi>I</mi><mi>ω</mi><mo>=</mo>" +
  "<msqrt><mfrac><msup><mi>L</mi><mn>2</mn></msup><msub><mi>i</mi><mn>2</mn></msub></mfrac></msqrt></mrow></math>";
const EXPLANATION = [
  { kind: "heading", level: 1, text: "A free asymmetric top" },
  { kind: "text", text: "Without torque the momentum keeps still in space, and the kinetic energy keeps its value." },
  { kind: "formula", mathml: MATH, text: "T = ½ ω·Iω" },
  { kind: "lines", lines: ["D = L²/2T = 5.021e-5 kg·m²", "i2 = 4.610e-5 < D: short-axis mode"] },
  { kind: "table", header: ["axis", "moment / kg·m²", "ω / rad/s"], rows: [["1", "1.71e-5", "0.31"], ["2", "4.61e-5", "11.0"], ["3", "5.83e-5", "0.52"]] },
];

const SCENARIO = '# T-handle in free fall\nname = "T-handle in free fall"\n\n[body]\nmaterial = "steel"\n\n[motion]\nomega = "0.3 11 0.5 rad/s"\nduration = "20 s"\n';

const CAPTIONS = { body: "The body turns.", poinsot: null, cones: null, sphere: null };
const FREE_CAPTIONS = {
  body: "No torque: L is fixed in space.",
  poinsot: "The inertia ellipsoid rolls without slipping on the invariable plane; the point of contact traces polhode and herpolhode.",
  cones: "The body cone (ω to axis 3: 53.9° … 89.9°) rolls on the space cone (ω to L: 0.02° … 34.3°); neither is circular.",
  sphere: "The tip of L in the body circles axis 3; the separatrices pass through axis 2.",
};

function page({ title, body, mass, shapes, ellipsoid, motion, free, about = "centre of mass", lever = [0, 0, 0], top = null, scene = {} }) {
  return {
    version: 1,
    title,
    source: "polhode 0.1.0 simulate examples/sample.toml",
    scenario: SCENARIO,
    body: { mass, inertia: body.inertia, about, lever, principal: { moments: body.moments, quaternion: body.quaternion }, ellipsoid: { half: ellipsoid, quaternion: body.quaternion }, box: boxOf(body, mass, about, lever), shapes },
    motion,
    free,
    scene: { period: null, gravity: null, orbit: null, captions: free ? FREE_CAPTIONS : CAPTIONS, ...scene },
    top,
    facts: FACTS,
    findings: [{ severity: "warning", message: "The spin is 0.8° from the unstable intermediate axis: it flips." }],
    explanation: EXPLANATION,
  };
}

const makeBody = (moments, quaternion) => ({ moments, quaternion, ...tensor(moments, quaternion) });
/** a_k² = 5/2 (i_l + i_m − i_k)/M */
const ellipsoidOf = ([a, b, c], mass) => [b + c - a, a + c - b, a + b - c].map((x) => Math.sqrt((2.5 * Math.max(x, 0)) / mass));
/** a_k² = 6 (i_l + i_m − i_k)/M, of the moments about the centre of mass; a lever is along axis 1. */
function boxOf({ moments, quaternion }, mass, about, lever) {
  if (!mass) return null;
  const far = about === "pivot" ? mass * dot(lever, lever) : 0;
  const [a, b, c] = [moments[0], moments[1] - far, moments[2] - far];
  return { size: [b + c - a, a + c - b, a + b - c].map((x) => Math.sqrt((6 * Math.max(x, 0)) / mass)), quaternion };
}
const PART = { name: "part", position: [0, 0, 0], quaternion: [1, 0, 0, 0] };
const TURN_X = [Math.SQRT1_2, Math.SQRT1_2, 0, 0];

function free(count = 2001, fine = 20) {
  // T-handle: a stem along body x and a bar along body y; the principal axes 1 2 3 are y x z.
  const moments = [1.71e-5, 4.61e-5, 5.83e-5];
  const quaternion = unit([0, Math.SQRT1_2, Math.SQRT1_2, 0]);
  const body = makeBody(moments, quaternion);
  const q = unit([0.9, 0.3, -0.2, 0.25]);
  const rows = integrate(body, q, [11, 0.31, 0.52], 20, count, undefined, fine);
  const shapes = [
    { ...PART, name: "bar", kind: "cylinder", radius: 0.0055, inner: 0, height: 0.074, position: [-0.009, 0, 0], quaternion: TURN_X },
    { ...PART, name: "stem", kind: "cylinder", radius: 0.0065, inner: 0.003, height: 0.036, position: [0.0145, 0, 0], quaternion: [Math.SQRT1_2, 0, Math.SQRT1_2, 0] },
  ];
  return page({
    title: "T-handle in free fall",
    body,
    mass: 0.09,
    shapes,
    ellipsoid: ellipsoidOf(moments, 0.09),
    motion: motionData(rows, body.inertia, null, null, "rk4"),
    free: freeData(body, rows, "short-axis mode"),
  });
}

function symmetric() {
  const moments = [0.7, 0.7, 1.15];
  const body = makeBody(moments, unit([1, 0, 0, 0]));
  const rows = integrate(body, unit([0.95, 0.25, 0.1, 0.05]), [1.1, 0.4, 2.6], 12, 1201);
  return page({
    title: "A coin thrown with a wobble",
    body,
    mass: 1.3,
    shapes: [{ ...PART, kind: "cylinder", radius: 1.2, inner: 0, height: 0.25 }],
    ellipsoid: ellipsoidOf(moments, 1.3),
    motion: motionData(rows, body.inertia, null, null, "exact"),
    free: freeData(body, rows, "short-axis mode"),
  });
}

/** `turn` takes gravity, and the whole motion with it, to another direction. */
function heavy(turn = [1, 0, 0, 0]) {
  const moments = [0.002, 0.011, 0.011];
  // The symmetry axis, 1, lies along body z.
  const quaternion = unit([Math.SQRT1_2, 0, -Math.SQRT1_2, 0]);
  const body = makeBody(moments, quaternion);
  const [weight, lever] = [0.5 * 9.81, [0, 0, 0.12]];
  const conjugate = (q) => [q[0], -q[1], -q[2], -q[3]];
  const [up, ...across] = [[0, 0, 1], [1, 0, 0], [0, 1, 0]].map((e) => rotate(turn, e));
  const torque = (q) => cross(lever, rotate(conjugate(q), up.map((x) => -weight * x)));
  const potential = (q) => weight * dot(rotate(q, lever), up);
  const rows = integrate(body, product(turn, unit([Math.cos(0.3), Math.sin(0.3), 0, 0])), [0, 0, 120], 6, 3001, torque, 30);
  return page({
    title: "A heavy top, released at rest",
    body,
    mass: 0.5,
    about: "pivot",
    lever,
    top: { axis: [0, 0, 1], up, across, bounds: nods(rows, up) },
    shapes: [
      { ...PART, name: "tip", kind: "cone", bottom: 0.004, top: 0.008, height: 0.09, position: [0, 0, 0.045] },
      { ...PART, name: "disc", kind: "torus", radius: 0.07, tube: 0.014, position: [0, 0, 0.12] },
      { ...PART, name: "hub", kind: "ellipsoid", half: [0.06, 0.06, 0.012], position: [0, 0, 0.12] },
      { ...PART, name: "stem", kind: "capsule", radius: 0.008, height: 0.06, position: [0, 0, 0.16] },
    ],
    ellipsoid: ellipsoidOf([0.002, 0.0038, 0.0038], 0.5),
    motion: motionData(rows, body.inertia, torque, potential, "rk4"),
    free: null,
    scene: { period: 1.54, gravity: up.map((x) => -9.81 * x) },
  });
}

/** Gravity along none of the space axes. */
const tilted = () => heavy(unit([0.8, 0.36, -0.48, 0.1]));

/** The least and the greatest angle of the body's z axis from the vertical. */
function nods(rows, up) {
  const angles = rows.map(({ q }) => Math.acos(dot(rotate(q, [0, 0, 1]), up)));
  return [Math.min(...angles), Math.max(...angles)];
}

/** The wheel's axis: not quite the z axis, so that it is not taken for that. */
export const WHEEL = unit([0.1, -0.2, 1]);

/** A body at rest that its wheel turns, so that L is what rounding leaves; and what happens on the way. */
function wheeled() {
  const made = samples.free();
  const count = 601;
  const body = makeBody([1.9, 2.6, 3.1], unit([1, 0, 0, 0]));
  const h = (t) => 0.015 * Math.min(Math.max(t - 5, 0), 20);
  const turned = (t) => (-0.015 / 3.1) * (t < 5 ? 0 : t < 25 ? (t - 5) ** 2 / 2 : 200 + 20 * (t - 25));
  const rows = Array.from({ length: count }, (_, i) => {
    const t = 0.1 * i;
    return { t, q: [Math.cos(turned(t) / 2), 0, 0, Math.sin(turned(t) / 2)], omega: [0, 0, -h(t) / 3.1] };
  });
  made.title = "A satellite turned by its wheel";
  made.body = { ...made.body, inertia: body.inertia, shapes: [] };
  made.free = null;
  made.scene = { ...made.scene, captions: CAPTIONS };
  made.motion = {
    ...motionData(rows, body.inertia, null, null, "taylor"),
    drift: [{ name: "T − work", values: f64(rows.map((_, i) => 1e-16 * (i % 5))) }],
    momentum: f64(rows.flatMap((_, i) => [1e-17 * Math.sin(7 * i), 3e-18, -2e-17 * Math.cos(3 * i)])),
    wheels: [{ name: "wheel", axis: WHEEL, motor: f64(rows.map(({ t }) => (t >= 5 && t < 25 ? 0.015 : 0))), momentum: f64(rows.map(({ t }) => h(t))), speed: f64(rows.map(({ t }) => h(t) / 0.012 + h(t) / 3.1)) }],
    events: [
      { time: 5, name: "<b>motor on</b>" },
      { time: 25, name: "motor off" },
      { time: 25.2, name: "just after" },
    ],
    eventCount: 5,
    work: { name: "work of the motors", values: f64(rows.map(({ omega }) => 1.55 * omega[2] ** 2)) },
    pointings: [
      { name: "camera", body: [0, 0, 1], target: 0, limit: null, values: f64(rows.map(({ t }) => 0.7 + 0.2 * Math.sin(0.3 * t))) },
      { name: "panel", body: [-0.6, 0, 0.8], target: 0, limit: null, values: f64(rows.map(({ t }) => 1.4 + 0.1 * Math.cos(0.2 * t))) },
    ],
  };
  return made;
}

/** The orbit of `orbiting`: its plane, and its periapsis 1 rad after the start. */
export const ORBIT = { parameter: 1.1e7, eccentricity: [Math.cos(1), 0.6 * Math.sin(1), 0.8 * Math.sin(1)].map((x) => 0.3 * x), normal: [0, -0.8, 0.6], central: 6.378e6 };

/** The same on an orbit, with a camera whose limit is sometimes exceeded, panels, and a tip mass on a long tape. */
function orbiting() {
  const made = wheeled();
  const { motion, body } = made;
  const times = new Float64Array(Uint8Array.from(Buffer.from(motion.times, "base64")).buffer);
  const along = (phase) => f32([...times].flatMap((t) => [Math.cos(0.05 * t + phase), 0.6 * Math.sin(0.05 * t + phase), 0.8 * Math.sin(0.05 * t + phase)]));
  const box = (name, position, size) => ({ ...PART, kind: "box", name, position, size });
  made.title = "A satellite on an orbit";
  made.scene = { ...made.scene, orbit: ORBIT };
  made.body = {
    ...body,
    shapes: [
      box("bus", [0.01, -0.02, 0.03], [0.5, 0.4, 0.9]),
      box("panel, left", [0, 0.7, 0.1], [0.02, 0.9, 0.4]),
      box("panel, right", [0, -0.7, 0.1], [0.02, 0.9, 0.4]),
      { ...PART, kind: "ellipsoid", name: "tip mass", position: [0, 0, 5], half: [0.04, 0.04, 0.04] },
    ],
  };
  made.motion = {
    ...motion,
    wheels: [],
    directions: [
      { name: "nadir", fixed: null, values: along(Math.PI) },
      { name: "velocity", fixed: null, values: along(Math.PI / 2) },
      { name: "target of panel", fixed: [0.6, 0.64, -0.48], values: null },
    ],
    pointings: motion.pointings.map((line, k) => ({ ...line, target: 2 * k, limit: k === 0 ? 0.75 : null })),
  };
  return made;
}

/** A lumpy body of about `count` triangles. */
function mesh(count = 200_000) {
  const made = samples.free();
  const n = Math.round(Math.sqrt(count / 4));
  const vertices = [];
  const triangles = [];
  for (let i = 0; i <= n; i += 1) {
    for (let k = 0; k < 2 * n; k += 1) {
      const [t, p] = [(i / n) * Math.PI, (k / n) * Math.PI];
      const r = 0.03 * (1 + 0.22 * Math.sin(3 * p) * Math.sin(t) ** 2 + 0.12 * Math.cos(5 * t + p) * Math.sin(t));
      vertices.push(r * Math.sin(t) * Math.cos(p) * 0.8, 1.5 * r * Math.sin(t) * Math.sin(p), 0.6 * r * Math.cos(t));
      if (i === n) continue;
      const next = (k + 1) % (2 * n);
      const [a, b, c, d] = [i * 2 * n + k, (i + 1) * 2 * n + k, (i + 1) * 2 * n + next, i * 2 * n + next];
      triangles.push(a, b, c, a, c, d);
    }
  }
  made.title = "A tumbling rock";
  made.body.shapes = [{ ...PART, name: "rock", kind: "mesh", vertices: f32(vertices), triangles: u32(triangles), of: 4 * count }];
  return made;
}

function balls() {
  const made = samples.free();
  made.title = "Water, turning";
  made.body.shapes = [
    {
      ...PART,
      name: "water",
      kind: "balls",
      centers: f32([0, 0.0066, 0, 0.0757, -0.052, 0, -0.0757, -0.052, 0]),
      radii: f32([0.03, 0.02, 0.02]),
      colors: ["#d55e00", "#dddddd", "#dddddd"],
      labels: ["O", "H", "H"],
      sticks: [[0, 1], [0, 2]],
    },
  ];
  return made;
}

function box() {
  const made = samples.free();
  made.title = "No shape, only moments";
  made.body.shapes = [];
  made.scenario = null;
  made.explanation = [];
  return made;
}

/** Each is computed once, and whoever asks has a copy to change. */
const once = (make) => {
  let made;
  return () => structuredClone((made ??= make()));
};

export const samples = {
  free: once(free),
  many: once(() => free(10_001, 4)),
  symmetric: once(symmetric),
  heavy: once(heavy),
  tilted: once(tilted),
  wheeled: once(wheeled),
  orbiting: once(orbiting),
  mesh: once(mesh),
  balls: once(balls),
  box: once(box),
};

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  process.stdout.write(JSON.stringify((samples[process.argv[2]] ?? free)()));
}
