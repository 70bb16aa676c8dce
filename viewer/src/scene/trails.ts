/** Trail of a point in space: of a body axis, or of the tip of ω. */
import { Group } from "three";
import { rotate, type Vector, writeRotated } from "../attitude";
import { indexAt } from "../clock";
import type { PageData } from "../data";
import { length, type Motion } from "../motion";
import { MovingCurve } from "./lines";
import type { Palette } from "./palette";

/** Number of points between samples, so that few samples also give a smooth curve. */
const FINE = 6;
/** Length of a trail in the picture, relative to the body's radius. */
const LENGTH = 22;
const PARTS = 8;
const LONGEST = 12_000;

export type Trailed = "axis-1" | "axis-2" | "axis-3" | "omega";

/** Curves of the current trail, from the oldest part, which is faint, to the newest. */
export class TrailCurves {
  readonly object = new Group();
  readonly #parts: MovingCurve[];
  #ink: Trailed = "axis-1";

  constructor(palette: Palette) {
    const most = Math.ceil((LONGEST + 1) / PARTS) + 2;
    this.#parts = Array.from({ length: PARTS }, (_, k) => new MovingCurve(most, pen("axis-1", k), palette));
    this.object.add(...this.#parts.map((part) => part.object));
  }

  /** Draws a trail up to `time`; it ends at `tip`. */
  draw(trail: Trail, time: number, tip: Vector): void {
    if (trail.what !== this.#ink) {
      this.#ink = trail.what;
      this.#parts.forEach((part, k) => part.recolor(pen(trail.what, k)));
    }
    const [first, last] = trail.span(time);
    const points = trail.points(first, last);
    const count = last - first + 2;
    this.#parts.forEach((part, p) => {
      const from = Math.floor((p * (count - 1)) / PARTS);
      const to = Math.floor(((p + 1) * (count - 1)) / PARTS);
      part.draw(to - from + 1, (k, out) => {
        if (from + k === count - 1) {
          out.set(tip);
          return;
        }
        const at = 3 * (first + from + k);
        out[0] = points[at];
        out[1] = points[at + 1];
        out[2] = points[at + 2];
      });
    });
  }
}

function pen(ink: Trailed, part: number): { ink: Trailed; width: number; strength: number } {
  return { ink, width: 2, strength: (part + 1.6) / (PARTS + 0.6) };
}

/**
 * Points of a trail. They are computed on demand, because a motion that changes with a knob shows
 * only a few of them.
 */
export class Trail {
  readonly what: Trailed;
  readonly #motion: Motion;
  readonly #fine: number;
  readonly #count: number;
  readonly #size: number;
  readonly #unit: number;
  /** Time span of the trail, s: some turns, however slow the point is. */
  readonly #seconds: number;
  readonly #points: Float32Array;
  readonly #known: Uint8Array;
  readonly #times: Float64Array;

  /**
   * `scale` is the length of 1 rad/s in the picture, of `unit` metres; axes have the length
   * `reach`.
   */
  constructor(motion: Motion, what: Trailed, scale: number, reach: number, unit: number) {
    this.#unit = unit;
    this.what = what;
    this.#motion = motion;
    this.#size = what === "omega" ? scale : reach;
    this.#fine = Math.max(1, Math.min(FINE, Math.floor(LONGEST / motion.count)));
    this.#count = (motion.count - 1) * this.#fine + 1;
    this.#points = new Float32Array(3 * this.#count);
    this.#known = new Uint8Array(this.#count);
    this.#times = new Float64Array(this.#count);
    for (let k = 0; k < this.#count; k += 1) this.#times[k] = this.#timeOf(k);
    const path = this.#path();
    const duration = motion.times[motion.telling - 1] - motion.times[0];
    this.#seconds = path > LENGTH ? (duration * LENGTH) / path : duration;
  }

  /** Returns the first and the last of the points that are shown at a time. */
  span(time: number): [number, number] {
    const last = indexAt(this.#times, time);
    return [Math.max(indexAt(this.#times, time - this.#seconds), last - LONGEST + 1), last];
  }

  /** Returns x y z of all points; those between the two indices are computed. */
  points(first: number, last: number): Float32Array {
    for (let k = first; k <= last; k += 1) {
      if (this.#known[k] === 0) this.#find(k);
    }
    return this.#points;
  }

  #timeOf(k: number): number {
    const { times, count } = this.#motion;
    const i = Math.floor(k / this.#fine);
    return times[i] + ((k % this.#fine) / this.#fine) * (times[Math.min(i + 1, count - 1)] - times[i]);
  }

  #find(k: number): void {
    this.#known[k] = 1;
    const i = Math.floor(k / this.#fine);
    const { attitude } = this.#motion;
    if (this.what === "omega") {
      const now = this.#motion.at(this.#times[k]);
      writeRotated(now.attitude, 0, now.omega, 0, this.#points, 3 * k, this.#size);
    } else if (k % this.#fine === 0) {
      writeRotated(attitude, 4 * i, axis(this.what), 0, this.#points, 3 * k, this.#size);
    } else {
      writeRotated(this.#motion.attitudeAt(this.#times[k]), 0, axis(this.what), 0, this.#points, 3 * k, this.#size);
    }
    if (!this.#motion.contact) return;
    const { center } = this.#motion.at(this.#times[k]);
    for (let c = 0; c < 3; c += 1) this.#points[3 * k + c] += center[c] / this.#unit;
  }

  // Returns the length of the path: the length through the samples, or for an axis the arc from its
  // speed |ω × e|.
  #path(): number {
    const { attitude, omega, times, telling } = this.#motion;
    let path = 0;
    if (this.what === "omega") {
      const [a, b] = [new Float64Array(3), new Float64Array(3)];
      for (let i = 0; i < telling; i += 1) {
        b.set(a);
        writeRotated(attitude, 4 * i, omega, 3 * i, a, 0, this.#size);
        if (i > 0) path += Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      }
      return path;
    }
    const k = axis(this.what).indexOf(1);
    for (let i = 1; i < telling; i += 1) {
      const across = Math.hypot(omega[3 * i + ((k + 1) % 3)], omega[3 * i + ((k + 2) % 3)]);
      path += across * (times[i] - times[i - 1]) * this.#size;
    }
    return path;
  }
}

export function axis(which: Exclude<Trailed, "omega">): Vector {
  return which === "axis-1" ? AXES[0] : which === "axis-2" ? AXES[1] : AXES[2];
}

const AXES: [Vector, Vector, Vector] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/**
 * Returns the body axis with the most informative trail: that of the lever, the symmetry axis, else
 * the axis nearest to ω at the start.
 */
export function telling(page: PageData, motion: Motion): Trailed {
  const { lever, principal } = page.body;
  const [i1, i2, i3] = principal.moments;
  const like = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6 * i3;
  let v: Vector = [motion.omega[0], motion.omega[1], motion.omega[2]];
  if (length(lever) > 0) v = lever;
  else if (like(i1, i2) && !like(i2, i3)) v = rotate(principal.quaternion, [0, 0, 1]);
  else if (like(i2, i3) && !like(i1, i2)) v = rotate(principal.quaternion, [1, 0, 0]);
  const sizes = v.map(Math.abs);
  return (["axis-1", "axis-2", "axis-3"] as const)[sizes.indexOf(Math.max(...sizes))] ?? "axis-1";
}
