/** Path of a top's axis in space: θ from the vertical, φ around it. */
import { rotate, type Vector } from "../attitude";
import { indexAt } from "../clock";
import type { TopData } from "../data";
import { at, type Motion } from "../motion";
import { extrema } from "./envelope";
import { extent } from "./scale";

/** Angle between points of the path, rad. */
const FINE = 0.03;

/** Largest angle of the axis between samples that can be interpolated, rad. */
const FOLLOWED = Math.PI / 2;

/**
 * Largest excess of the interpolated path over the range of samples and closed form, relative to
 * the range of θ.
 */
const BEYOND = 0.02;

/** Excess that is invisible in any case, rad. */
const ROUNDED = 1e-4;

/** Difference between the greatest and the least θ that counts as rounding, rad. */
const NOTHING = 1e-9;

export interface AxisPath {
  /** Times of the points, s. */
  times: number[];
  points: Vector[];
  /** Angles, rad; φ is continuous beyond a turn. */
  theta: number[];
  phi: number[];
  /** Least and greatest θ: those of the closed form, else those of the path. */
  bounds: [number, number];
}

type Path = AxisPath | { turn: number } | { beyond: number };

/** Cache, because the 3-D view and the plots need the same path. */
const known = new WeakMap<TopData, { motion: Motion; path: Path }>();

/**
 * Computes the path, with additional points between samples. If samples do not determine the axis
 * between them, the result is instead its largest angle between samples, or the excess of θ over
 * its bounds, rad.
 */
export function axisPath(motion: Motion, top: TopData): Path {
  const last = known.get(top);
  if (last?.motion === motion) return last.path;
  const path = find(motion, top);
  known.set(top, { motion, path });
  return path;
}

function find(motion: Motion, top: TopData): Path {
  const path: AxisPath = { times: [], points: [], theta: [], phi: [], bounds: [0, 0] };
  const put = (time: number, point: Vector): void => {
    const { theta, phi } = anglesOf(point, top);
    const before = path.phi.at(-1);
    path.times.push(time);
    path.points.push(point);
    path.theta.push(theta);
    path.phi.push(before === undefined ? phi : phi + 2 * Math.PI * Math.round((before - phi) / (2 * Math.PI)));
  };
  const tips = Array.from({ length: motion.count }, (_, i) => tip(motion, top, i));
  const step = (i: number): number => motion.times[i] - motion.times[i - 1];
  const turns = tips.map(({ rate }, i) => (i > 0 ? step(i) * Math.max(Math.hypot(...tips[i - 1].rate), Math.hypot(...rate)) : 0));
  const turn = turns.reduce((a, b) => Math.max(a, b));
  if (!(turn <= FOLLOWED)) return { turn };
  put(motion.times[0], tips[0].e);
  for (let i = 1; i < motion.count; i += 1) {
    const parts = Math.max(Math.ceil(turns[i] / FINE), 1);
    for (let k = 1; k <= parts; k += 1) put(motion.times[i - 1] + (step(i) * k) / parts, between(tips[i - 1], tips[i], step(i), k / parts));
  }
  const reached = extent([path.theta]) ?? [0, 0];
  path.bounds = top.bounds ?? reached;
  const [least, most] = extent([path.bounds, tips.map(({ e }) => anglesOf(e, top).theta)]) ?? reached;
  const beyond = Math.max(least - reached[0], reached[1] - most);
  return beyond > BEYOND * (most - least) + ROUNDED ? { beyond } : path;
}

/** Returns φ of the path, continuous beyond a turn. */
export function azimuthAt({ times, phi }: AxisPath, time: number): number {
  const i = indexAt(times, time);
  const j = Math.min(i + 1, times.length - 1);
  const part = times[j] > times[i] ? (time - times[i]) / (times[j] - times[i]) : 0;
  return phi[i] + part * (phi[j] - phi[i]);
}

export function anglesOf(point: Vector, { up, across }: TopData): { theta: number; phi: number } {
  const [x, y, z] = [dot(point, across[0]), dot(point, across[1]), dot(point, up)];
  return { theta: Math.atan2(Math.hypot(x, y), z), phi: Math.atan2(y, x) };
}

export function directionOf(theta: number, phi: number, { up, across }: TopData): Vector {
  const [s, c] = [Math.sin(theta), Math.cos(theta)];
  return [0, 1, 2].map((k) => s * (Math.cos(phi) * across[0][k] + Math.sin(phi) * across[1][k]) + c * up[k]) as Vector;
}

/**
 * Divides the path into pieces of `nutations` nutations each, by the indices of their ends. More
 * could not be distinguished.
 */
export function pieces({ theta, bounds }: AxisPath, nutations: number): [number, number][] {
  const end = theta.length - 1;
  if (bounds[1] - bounds[0] <= NOTHING) return [[0, end]];
  const turns = extrema(theta, 0, end, 0.02 * (bounds[1] - bounds[0]));
  const out: [number, number][] = [];
  let from = 0;
  for (let k = 2 * nutations; k < turns.length; k += 2 * nutations) {
    out.push([from, turns[k]]);
    from = turns[k];
  }
  // The remainder is shown together with the nutations before it.
  if (out.length > 0 && from < end) out.push([Math.min(from, turns.at(-1 - 2 * nutations) ?? from), end]);
  return out.length > 0 ? out : [[0, end]];
}

interface Tip {
  e: Vector;
  /** Rate ω × e, 1/s. */
  rate: Vector;
}

function tip(motion: Motion, { axis }: TopData, i: number): Tip {
  const q = motion.attitudeOf(i);
  const e = rotate(q, axis);
  const w = rotate(q, at(motion.omega, i));
  return { e, rate: [w[1] * e[2] - w[2] * e[1], w[2] * e[0] - w[0] * e[2], w[0] * e[1] - w[1] * e[0]] };
}

/** Interpolates by Hermite's cubic through both points with their velocities, on the sphere. */
function between(a: Tip, b: Tip, h: number, s: number): Vector {
  const u = 1 - s;
  const p = [0, 1, 2].map((k) => {
    const ends = u * u * (1 + 2 * s) * a.e[k] + s * s * (3 - 2 * s) * b.e[k];
    return ends + h * s * u * (u * a.rate[k] - s * b.rate[k]);
  });
  const length = Math.hypot(...p);
  return [p[0] / length, p[1] / length, p[2] / length];
}

export function axisAt(motion: Motion, top: TopData, time: number): Vector {
  return rotate(motion.at(time).attitude, top.axis);
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
