/**
 * The part of the ground near the body: a plane with squares, a turntable, a bowl, a hill, or a
 * trough.
 */
import { Group, Quaternion, Vector3 } from "three";
import type { Contact } from "../contact";
import type { GroundData } from "../data";
import type { Motion } from "../motion";
import { quantity } from "../plot/arrange";
import { curve } from "./lines";
import type { Palette } from "./palette";
import { patch } from "./patch";

/** Margin beyond the path, relative to the body's radius. */
const MARGIN = 1.4;
/** Part of a fading floor that the camera sees. */
const SEEN = 0.82;
/** Number of squares along the longer side. */
const SQUARES = 12;
const Z = new Vector3(0, 0, 1);

export class Ground {
  readonly object = new Group();
  /** Label, such as "Floor, squares of 50 mm". */
  readonly label: string;
  /** Points of its edge. */
  readonly rim: readonly Vector3[];
  readonly #rate: number;
  readonly #start: number;
  readonly #axis: Vector3;

  /** `unit`: metres of length 1. */
  constructor(contact: Contact, motion: Motion, unit: number, palette: Palette) {
    const { ground } = contact;
    const [count, start] = [motion.telling, motion.times[0]];
    this.#rate = ground.rate;
    this.#start = start;
    this.#axis = new Vector3(...ground.axis);
    const points = Array.from({ length: 2 * count }, (_, k) => {
      return new Vector3().fromArray(k < count ? contact.point : contact.center, 3 * (k % count)).divideScalar(unit);
    });
    const touched = points.slice(0, count).filter((_, i) => i === 0 || motion.times[i] <= contact.touchesUntil);
    const made = ground.form === "plane" ? plane(ground, points, unit, palette) : round(contact, touched, unit, palette);
    this.object.add(made.group);
    this.rim = made.rim;
    this.label = made.label;
  }

  /** Rotates the ground to its position at a time. */
  pose(time: number): void {
    this.object.quaternion.setFromAxisAngle(this.#axis, this.#rate * (time - this.#start));
  }
}

interface Made {
  group: Group;
  rim: Vector3[];
  label: string;
}

function plane(ground: GroundData, points: Vector3[], unit: number, palette: Palette): Made {
  const turn = new Quaternion().setFromUnitVectors(Z, new Vector3(...ground.axis));
  const flat = points.map((p) => p.clone().applyQuaternion(turn.clone().invert()));
  const at = (x: number, y: number): Vector3 => new Vector3(x, y, 0).applyQuaternion(turn);
  if (ground.rate !== 0) return turntable(flat, at, unit, palette);
  const [xs, ys] = [flat.map(({ x }) => x), flat.map(({ y }) => y)].map(range);
  const step = nice((Math.max(xs[1] - xs[0], ys[1] - ys[0]) * unit) / SQUARES) / unit;
  const [x, y] = [xs, ys].map(([from, to]): [number, number] => [Math.floor(from / step) * step, Math.ceil(to / step) * step]);
  const [middle, half] = [[x, y].map(([from, to]) => (from + to) / 2), [x, y].map(([from, to]) => (to - from) / 2)];
  // 0 in the middle, 1 on a rounded rectangle in that of the patch.
  const fade = (u: number, v: number): number => Math.hypot(((u - middle[0]) / half[0]) ** 2, ((v - middle[1]) / half[1]) ** 2) ** 0.5;
  const group = patch({ at, u: x, v: y, alongV: steps(x, step), alongU: steps(y, step), fade }, palette);
  const rim = spokes(48).map((angle) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const far = SEEN / Math.hypot(c ** 2, s ** 2) ** 0.5;
    return at(middle[0] + far * c * half[0], middle[1] + far * s * half[1]);
  });
  return { group, rim, label: `Floor, squares of ${metres(step * unit)}` };
}

function turntable(flat: Vector3[], at: (x: number, y: number) => Vector3, unit: number, palette: Palette): Made {
  const reach = Math.max(...flat.map(({ x, y }) => Math.hypot(x, y))) + MARGIN;
  const step = nice((2 * reach * unit) / SQUARES) / unit;
  const polar = (r: number, a: number): Vector3 => at(r * Math.cos(a), r * Math.sin(a));
  const rings = [...steps([step, reach], step), reach];
  const group = patch({ at: polar, u: [0, reach], v: [0, 2 * Math.PI], alongV: rings, alongU: spokes(12) }, palette);
  // One of its radii, which makes rotation visible.
  group.add(curve([...polar(0, 0).toArray(), ...polar(reach, 0).toArray()], 1, { ink: "quiet", width: 2.5 }, palette));
  return { group, rim: spokes(48).map((angle) => polar(reach, angle)), label: `Turntable, rings ${metres(step * unit)} apart` };
}

/** Makes a sphere around its lowest or highest point, or a cylinder along its axis. */
function round({ ground, up }: Contact, points: Vector3[], unit: number, palette: Palette): Made {
  const axis = new Vector3(...ground.axis);
  const radius = ground.radius / unit;
  const margin = Math.min(MARGIN / radius, 0.5);
  const isSphere = ground.form === "sphere";
  const mean = points.reduce((sum, p) => sum.add(p), new Vector3());
  const down = up ? new Vector3(...up).multiplyScalar(ground.inside ? -1 : 1) : mean;
  if (isSphere) {
    let pole = down.clone().normalize();
    // A rotating sphere looks the same only from its axis.
    if (ground.rate !== 0) pole = axis.clone().multiplyScalar(axis.dot(mean) < 0 ? -1 : 1);
    const turn = new Quaternion().setFromUnitVectors(Z, pole);
    const angle = Math.min(Math.max(...points.map((p) => p.angleTo(pole))) + margin, Math.PI);
    const at = (theta: number, phi: number): Vector3 => spherical(theta, phi).multiplyScalar(radius).applyQuaternion(turn);
    const circles = [1, 2, 3, 4, 5].map((k) => (k * angle) / 5);
    const group = patch({ at, u: [0, angle], v: [0, 2 * Math.PI], alongV: circles, alongU: spokes(16) }, palette);
    return { group, rim: spokes(48).map((phi) => at(angle, phi)), label: ground.inside ? "Bowl" : "Hill" };
  }
  const across = down.clone().addScaledVector(axis, -down.dot(axis));
  const first = (across.length() > 1e-9 ? across : mean.clone().addScaledVector(axis, -mean.dot(axis))).normalize();
  const second = axis.clone().cross(first);
  const angles = points.map((p) => Math.abs(Math.atan2(p.dot(second), p.dot(first))));
  const most = ground.rate === 0 ? Math.min(Math.max(...angles) + margin, Math.PI) : Math.PI;
  const along = range(points.map((p) => p.dot(axis)));
  const at = (phi: number, z: number): Vector3 => {
    return first.clone().multiplyScalar(radius * Math.cos(phi)).addScaledVector(second, radius * Math.sin(phi)).addScaledVector(axis, z);
  };
  const parts = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => k / 8);
  const lines = { alongV: parts.map((k) => (2 * k - 1) * most), alongU: parts.map((k) => along[0] + k * (along[1] - along[0])) };
  const rim = along.flatMap((z) => parts.map((k) => at((2 * k - 1) * most, z)));
  return { group: patch({ at, u: [-most, most], v: along, ...lines }, palette), rim, label: ground.inside ? "Trough" : "Ridge" };
}

function spherical(theta: number, phi: number): Vector3 {
  return new Vector3(Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta));
}

/** Returns the range of values with a margin. */
function range(values: number[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [low - MARGIN, high + MARGIN];
}

function steps([from, to]: [number, number], step: number): number[] {
  return Array.from({ length: Math.round((to - from) / step) + 1 }, (_, k) => from + k * step).filter((x) => x <= to + 1e-9 * step);
}

function spokes(count: number): number[] {
  return Array.from({ length: count }, (_, k) => (k / count) * 2 * Math.PI);
}

function metres(size: number): string {
  return size >= 1e-3 && size < 1 ? `${Math.round(1000 * size)} mm` : quantity(size, "m", 1);
}

/** Returns 1, 2 or 5 times a power of ten, not below a size. */
function nice(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  return power * ([1, 2, 5].find((k) => k * power >= size * (1 - 1e-9)) ?? 10);
}
