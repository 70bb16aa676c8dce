/**
 * Rotation of a body by hand: rotations from the path of the pointer, and the rate at release. Pure
 * functions.
 */
import { inverse, type Quaternion, type Vector } from "../attitude";

/** Time before the release that determines the rate of a throw, s. */
const THROW = 0.1;

/**
 * Projects a point onto a ball of radius 1 in front of the eye, and beyond its rim onto a
 * hyperbola, so that there is no edge.
 */
export function onBall(x: number, y: number): Vector {
  const square = x * x + y * y;
  const z = square <= 0.5 ? Math.sqrt(1 - square) : 0.5 / Math.sqrt(square);
  const size = Math.hypot(x, y, z);
  return [x / size, y / size, z / size];
}

/** Returns the rotation from one unit vector to another. */
export function between([ax, ay, az]: Vector, [bx, by, bz]: Vector): Quaternion {
  return unit([1 + ax * bx + ay * by + az * bz, ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]);
}

export function product(a: Quaternion, b: Quaternion): Quaternion {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

export function unit(q: Quaternion): Quaternion {
  const size = Math.hypot(...q);
  return [q[0] / size, q[1] / size, q[2] / size, q[3] / size];
}

/** An attitude in the hand at a time, s. */
export interface Held {
  time: number;
  attitude: Quaternion;
}

/**
 * Returns the mean rate of the last tenth of a second before `now`, body axes, rad/s; zero if the
 * hand did not move.
 */
export function rateOf(path: readonly Held[], now: number): Vector {
  const last = path.at(-1);
  if (!last || now - last.time >= THROW) return [0, 0, 0];
  // The attitude at the beginning of that interval: the last one recorded before it, else the first
  // of all.
  const from = [...path].reverse().find(({ time }) => time <= now - THROW) ?? path[0];
  const seconds = now - Math.max(from.time, now - THROW);
  if (!(seconds > 0)) return [0, 0, 0];
  const [w, x, y, z] = product(inverse(from.attitude), last.attitude);
  const sine = Math.hypot(x, y, z);
  if (sine === 0) return [0, 0, 0];
  const angle = 2 * Math.atan2(sine, Math.abs(w)) * Math.sign(w || 1);
  return [x, y, z].map((c) => (c / sine) * (angle / seconds)) as Vector;
}
