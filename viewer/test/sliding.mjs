// A ball that slides, and then rolls, on a level plane: in closed form, so that the viewer is tested without polhode.
import { rotate, samples } from "./sample.mjs";

const base64 = (numbers) => Buffer.from(Float64Array.from(numbers).buffer).toString("base64");

export const BALL = { mass: 0.4, radius: 0.05, friction: 0.2, speed: 1.1, along: 0.7, duration: 1.4, count: 401 };
/** Its attitude at the start. */
export const FIRST = [0.5, 0.1, -0.7, 0.5];
const G = 9.8;

/** s: then v = a ω. */
export const grips = (2 * BALL.speed) / (7 * BALL.friction * G);

/** How far it has come along its way, its speed, how far it has turned, and ω. */
export function ball(t) {
  const { radius, friction, speed } = BALL;
  const s = Math.min(t, grips);
  const [v, w] = [speed - friction * G * s, (2.5 * friction * G * s) / radius];
  const rest = t - s;
  return { way: speed * s - 0.5 * friction * G * s * s + v * rest, v, angle: 0.5 * w * s + w * rest, w };
}

/** `ground` takes the place of the plane's fields. */
export function sliding(ground = {}) {
  const { mass, radius, friction, along, duration, count } = BALL;
  const data = samples.free();
  const times = Array.from({ length: count }, (_, i) => (i * duration) / (count - 1));
  const rows = times.map(ball);
  const [c, s] = [Math.cos(along), Math.sin(along)];
  // About the axis to the left of its way.
  const axis = [-s, c, 0];
  const product = ([a, b, x, d], [e, f, g, h]) => [a * e - b * f - x * g - d * h, a * f + b * e + x * h - d * g, a * g - b * h + x * e + d * f, a * h + b * g - x * f + d * e];
  const attitude = rows.map(({ angle }) => product([Math.cos(angle / 2), ...axis.map((x) => x * Math.sin(angle / 2))], FIRST));
  const omega = rows.map(({ w }, i) => rotate([attitude[i][0], ...attitude[i].slice(1).map((x) => -x)], axis.map((x) => x * w)));
  const inertia = 0.4 * mass * radius * radius;
  const slip = rows.map(({ v, w }) => Math.max(v - radius * w, 0));
  const pushes = times.map((t) => (t < grips ? friction * mass * G : 0));
  const kinetic = rows.map(({ v, w }) => 0.5 * mass * v * v + 0.5 * inertia * w * w);
  const place = (z) => base64(rows.flatMap(({ way }) => [c * way, s * way, z]));
  const constant = (x) => base64(times.map(() => x));
  const contact = {
    ground: { form: "plane", radius: 0, inside: false, axis: [0, 0, 1], rate: 0, ...ground },
    up: [0, 0, 1],
    surface: null,
    center: place(radius),
    point: place(0),
    normalForce: constant(mass * G),
    friction: base64(pushes),
    slip: base64(slip),
    frictionWork: base64(kinetic.map((t) => t - kinetic[0])),
    groundWork: constant(0),
    phases: [{ name: "sliding", from: 0, to: grips }, { name: "rolling", from: grips, to: duration }],
  };
  const shape = { kind: "ellipsoid", half: [radius, radius, radius], name: "ball", position: [0, 0, 0], quaternion: [1, 0, 0, 0] };
  return {
    ...data,
    title: "A ball slides, and then rolls",
    free: null,
    body: { ...data.body, mass, shapes: [shape] },
    scene: { ...data.scene, captions: { body: "It slides, and then rolls.", poinsot: null, cones: null, sphere: null } },
    motion: {
      ...data.motion,
      count,
      times: base64(times),
      attitude: base64(attitude.flat()),
      omega: base64(omega.flat()),
      momentum: base64(rows.flatMap(({ w }) => axis.map((x) => x * w * inertia))),
      torque: base64(omega.flatMap((w, i) => (pushes[i] > 0 ? w.map((x) => (x / (rows[i].w || 1)) * pushes[i] * radius) : [0, 0, 0]))),
      kinetic: base64(kinetic),
      potential: constant(mass * G * radius),
      drift: [],
      events: [{ time: grips, name: "grips" }],
      eventCount: 1,
      contact,
    },
  };
}
