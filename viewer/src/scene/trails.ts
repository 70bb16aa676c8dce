/** The way that a point has come: a body axis, or the tip of ω, in space. */
import { Group } from "three";
import { rotate, type Vector } from "../attitude";
import { indexAt } from "../clock";
import type { Motion } from "../motion";
import { MovingCurve } from "./lines";
import type { Palette } from "./palette";

/** Points between two samples, so that few samples give a smooth curve too. */
const FINE = 6;
/** Of a trail in the picture, where the body's radius is 1. */
const LENGTH = 22;
const PARTS = 8;
const LONGEST = 12_000;

export type Trailed = "axis-1" | "axis-2" | "axis-3" | "omega";

export class Trail {
  readonly object = new Group();
  /** From the oldest, which is faint, to the newest. */
  readonly #parts: MovingCurve[];
  /** s of the motion: a trail of some turns, however slow the point is. */
  readonly #seconds: number;
  readonly #points: Float32Array;
  readonly #times: Float64Array;

  /** `scale` is the length of 1 rad/s in the picture; axes are `reach` long. */
  constructor(motion: Motion, what: Trailed, scale: number, reach: number, palette: Palette) {
    const fine = Math.max(1, Math.min(FINE, Math.floor(LONGEST / motion.count)));
    const count = (motion.count - 1) * fine + 1;
    this.#points = new Float32Array(3 * count);
    this.#times = new Float64Array(count);
    for (let k = 0; k < count; k += 1) {
      const i = Math.floor(k / fine);
      const from = motion.times[i];
      const to = motion.times[Math.min(i + 1, motion.count - 1)];
      const time = from + ((k % fine) / fine) * (to - from);
      this.#times[k] = time;
      const now = motion.at(time);
      const v: Vector = what === "omega" ? now.omega : axis(what);
      const s = what === "omega" ? scale : reach;
      this.#points.set(
        rotate(now.attitude, v).map((x) => x * s),
        3 * k,
      );
    }
    let path = 0;
    for (let k = 3; k < 3 * ((motion.telling - 1) * fine + 1); k += 3) {
      const [x, y, z] = [0, 1, 2].map((c) => this.#points[k + c] - this.#points[k + c - 3]);
      path += Math.hypot(x, y, z);
    }
    const duration = motion.times[motion.telling - 1] - motion.times[0];
    this.#seconds = path > LENGTH ? (duration * LENGTH) / path : duration;
    const most = Math.ceil(Math.min(count + 1, LONGEST + 1) / PARTS) + 2;
    this.#parts = Array.from({ length: PARTS }, (_, k) => {
      return new MovingCurve(most, { ink: what, width: 2, strength: (k + 1.6) / (PARTS + 0.6) }, palette);
    });
    this.object.add(...this.#parts.map((part) => part.object));
  }

  /** Up to `time`; it ends at `tip`. */
  draw(time: number, tip: Vector): void {
    const last = indexAt(this.#times, time);
    const first = Math.max(indexAt(this.#times, time - this.#seconds), last - LONGEST + 1);
    const count = last - first + 2;
    this.#parts.forEach((part, p) => {
      const from = Math.floor((p * (count - 1)) / PARTS);
      const to = Math.floor(((p + 1) * (count - 1)) / PARTS);
      part.draw(to - from + 1, (k, out) => {
        const at = first + from + k;
        if (from + k === count - 1) out.set(tip);
        else out.set(this.#points.subarray(3 * at, 3 * at + 3));
      });
    });
  }
}

export function axis(which: Exclude<Trailed, "omega">): Vector {
  return which === "axis-1" ? [1, 0, 0] : which === "axis-2" ? [0, 1, 0] : [0, 0, 1];
}
