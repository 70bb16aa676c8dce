/**
 * Path of a top's axis: on the unit sphere, viewed a little from above, and next to it unrolled, θ
 * against φ. Near the vertical, where φ is poorly defined, it is viewed from above instead, with θ
 * as the distance from the centre.
 */
import type { Vector } from "../attitude";
import type { TopData } from "../data";
import { mark } from "../format";
import { type AxisPath, anglesOf, azimuthAt, directionOf, dot } from "./axis-path";
import { type Box, type Mark, ring, textWidth, through } from "./drawing";
import { extent, padded, ticks } from "./scale";

type Point = [number, number];

/** Inclination below which a path is not unrolled, rad. */
const UPRIGHT = 0.09;

/** Minimum length of the θ axis, °. For a steady precession the range would be rounding errors. */
const LEAST = 0.01;

/** Length of the vertical line, in radii of the sphere. */
const REACH = 1.2;

const BOUND = { ink: "axis-1", width: 1.1, dash: [4, 3] };
const TRACE = { ink: "ink", width: 1.7 };

/** A drawing, and the function for the place of the axis in it at a time: null outside. */
export interface View {
  marks: Mark[];
  place: (point: Vector, time: number) => Point | null;
}

export function isUpright({ bounds: [least, most] }: AxisPath): boolean {
  return !(least > UPRIGHT && most < Math.PI - UPRIGHT);
}

/** Draws the sphere with the path on it; parts behind the sphere are faint. */
export function onSphere(path: AxisPath, top: TopData, box: Box): View {
  const [least, most] = path.bounds;
  const hangs = least + most > Math.PI;
  const sense = hangs ? -1 : 1;
  // A path close to the vertical is viewed from higher up.
  const height = sense * (most < 0.35 || least > Math.PI - 0.35 ? 0.9 : 0.4);
  const sum = path.points.reduce((a, e) => [a[0] + e[0], a[1] + e[1], a[2] + e[2]] as Vector, [0, 0, 0] as Vector);
  const level = Math.hypot(dot(sum, top.across[0]), dot(sum, top.across[1]));
  // The view is from the beginning of a path that goes all round, else from its side.
  const from = level > 0.2 * path.points.length ? sum : path.points[0];
  const toward = directionOf(Math.PI / 2 - height, anglesOf(from, top).phi, top);
  const right = unit(cross(top.up, toward));
  const above = cross(toward, right);
  const radius = Math.min(0.5 * box.width, box.height / (1 + REACH)) - 3;
  const center: Point = [box.left + box.width / 2, hangs ? box.top + radius + 3 : box.top + box.height - radius - 3];
  const at = (v: Vector, reach = 1): Point => [center[0] + radius * reach * dot(v, right), center[1] - radius * reach * dot(v, above)];
  const circle = (theta: number): Vector[] => Array.from({ length: 181 }, (_, k) => directionOf(theta, (k * Math.PI) / 90, top));
  const curves = [
    { look: { ink: "quiet", width: 1, dash: [2, 2.5] }, points: circle(Math.PI / 2) },
    ...path.bounds.map((theta) => ({ look: BOUND, points: circle(theta) })),
    { look: TRACE, points: path.points },
  ];
  const marks: Mark[] = [{ kind: "path", d: ring(center, radius), ink: "quiet", width: 1, fill: "paper" }];
  for (const near of [false, true]) {
    for (const { look, points } of curves) {
      const d = parts(points, (v) => dot(v, toward) >= 0 === near).map((part) => through(part.map((v) => at(v)))).join("");
      if (d) marks.push({ kind: "path", d, ...look, ...(near ? {} : { opacity: 0.25 }) });
    }
    const end = top.up.map((x) => sense * x) as Vector;
    if (near) marks.push({ kind: "path", d: through([at(end), at(end, REACH)]), ink: "quiet", width: 2 });
  }
  marks.push(start(at(path.points[0])));
  return { marks, place: (point) => at(point) };
}

/** Draws θ against φ, with up upward, from one point of the path to another. */
export function unrolled(path: AxisPath, top: TopData, [first, last]: [number, number], box: Box): View {
  const degrees = (angle: number): number => (angle * 180) / Math.PI;
  const phi = path.phi.slice(first, last + 1).map(degrees);
  const theta = path.theta.slice(first, last + 1).map(degrees);
  const [from, to] = padded(extent([phi]), 1);
  const bounds = path.bounds.map(degrees);
  const [low, high] = padded([Math.min(...bounds), Math.max(...bounds)], LEAST);
  const height = box.height - 48;
  const along = ticks(low, high, height / 32, true);
  // The title stands to the left of the longest number.
  const wide = Math.max(...along.values.map((value) => textWidth(mark(value, along.step), 11)), 28) + 24;
  const frame = { left: box.left + wide, top: box.top + 8, width: box.width - wide - 12, height };
  const x = (angle: number): number => frame.left + ((angle - from) / (to - from)) * frame.width;
  const y = (angle: number): number => frame.top + ((angle - low) / (high - low)) * frame.height;
  const marks: Mark[] = [];
  const bottom = frame.top + frame.height;
  const right = frame.left + frame.width;
  const across = ticks(from, to, frame.width / 56, true);
  for (const value of across.values) {
    marks.push({ kind: "path", d: through([[x(value), frame.top], [x(value), bottom]]), ink: "grid" });
    marks.push({ kind: "text", at: [x(value), bottom + 15], text: mark(value, across.step), anchor: "middle", ink: "quiet", size: 11 });
  }
  for (const value of along.values) {
    marks.push({ kind: "path", d: through([[frame.left, y(value)], [right, y(value)]]), ink: "grid" });
    marks.push({ kind: "text", at: [frame.left - 5, y(value) + 4], text: mark(value, along.step), anchor: "end", ink: "quiet", size: 11 });
  }
  for (const bound of bounds) marks.push({ kind: "path", d: through([[frame.left, y(bound)], [right, y(bound)]]), ...BOUND });
  const points = phi.map((angle, k): Point => [x(angle), y(theta[k])]);
  marks.push({ kind: "path", d: through(points), ...TRACE });
  if (first === 0) marks.push(start(points[0]));
  marks.push({ kind: "text", at: [frame.left + frame.width / 2, bottom + 34], text: "azimuth of the axis (°)", anchor: "middle", ink: "quiet", size: 11.5 });
  marks.push({ kind: "text", at: [box.left + 11, frame.top + frame.height / 2], text: "angle from the vertical (°)", anchor: "middle", ink: "quiet", size: 11.5, upright: true });
  // φ is continuous beyond a turn: whole turns are those of the path at the same time.
  const place = (point: Vector, time: number): Point | null => {
    if (time < path.times[first] || time > path.times[last]) return null;
    const here = anglesOf(point, top);
    const turns = Math.round((azimuthAt(path, time) - here.phi) / (2 * Math.PI));
    return [x(degrees(here.phi + 2 * Math.PI * turns)), y(degrees(here.theta))];
  };
  return { marks, place };
}

/** Draws θ as the distance from the centre, with φ around it; from below for a hanging body. */
export function fromAbove(path: AxisPath, top: TopData, box: Box): View {
  const [least, most] = path.bounds;
  const hangs = least + most > Math.PI;
  const away = (theta: number): number => (hangs ? Math.PI - theta : theta);
  const farthest = (1.04 * 180 * Math.max(away(least), away(most), 1e-6)) / Math.PI;
  const radius = Math.min(0.5 * box.width, 0.5 * (box.height - 24)) - 4;
  const center: Point = [box.left + box.width / 2, box.top + radius + 4];
  const scale = radius / farthest;
  const at = (theta: number, phi: number): Point => {
    const r = (scale * away(theta) * 180) / Math.PI;
    return [center[0] + r * Math.cos(phi), center[1] - (hangs ? -1 : 1) * r * Math.sin(phi)];
  };
  const rings = ticks(0, farthest, 4);
  const marks: Mark[] = [];
  for (const value of rings.values) if (value > 0) marks.push({ kind: "path", d: ring(center, scale * value), ink: "line" });
  const [cx, cy] = center;
  marks.push({ kind: "path", d: `${through([[cx - radius, cy], [cx + radius, cy]])}${through([[cx, cy - radius], [cx, cy + radius]])}`, ink: "line" });
  for (const bound of path.bounds) if (away(bound) > 1e-9) marks.push({ kind: "path", d: ring(center, (scale * away(bound) * 180) / Math.PI), ...BOUND });
  const points = path.theta.map((theta, k) => at(theta, path.phi[k]));
  marks.push({ kind: "path", d: through(points), ...TRACE }, start(points[0]));
  // The numbers are along a line between the grid lines. If they are too close together, inner ones
  // are omitted.
  let free = Infinity;
  for (const value of rings.values.filter((v) => v > 0).reverse()) {
    const r = scale * value;
    if (r > free || r < 12) continue;
    free = r - 24;
    marks.push({ kind: "text", at: [cx + 0.8 * r, cy - 0.6 * r + 4], text: mark(value, rings.step), anchor: "middle", ink: "quiet", size: 11, halo: true });
  }
  const words = hangs ? "from below, 180° − angle from the vertical (°)" : "from above, angle from the vertical (°)";
  marks.push({ kind: "text", at: [cx, cy + radius + 18], text: words, anchor: "middle", ink: "quiet", size: 11.5 });
  const place = (point: Vector): Point => {
    const { theta, phi } = anglesOf(point, top);
    return at(theta, phi);
  };
  return { marks, place };
}

function start(at: Point): Mark {
  return { kind: "path", d: ring(at, 3), fill: "axis-2" };
}

/** Returns the runs of points that fulfil a condition. */
function parts(points: Vector[], wanted: (v: Vector) => boolean): Vector[][] {
  const out: Vector[][] = [];
  points.forEach((point, k) => {
    if (!wanted(point)) return;
    if (k > 0 && wanted(points[k - 1]) && out.length > 0) out[out.length - 1].push(point);
    else out.push([point]);
  });
  return out.filter((part) => part.length > 1);
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(v: Vector): Vector {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}
