/**
 * Curves of the contact point up to the current time: in space, on a rotating ground, and on the
 * body.
 */
import { Group } from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { inverse, rotate, type Vector } from "../attitude";
import { indexAt } from "../clock";
import { type Contact, normalAt } from "../contact";
import type { Moment, Motion } from "../motion";
import { lineMaterial, MovingCurve } from "./lines";
import type { Ink, Palette } from "./palette";

/** Number of points between samples, so that few samples also give a smooth curve. */
const FINE = 6;
const LONGEST = 12_000;
/**
 * Height of a curve above its surface, relative to the body's radius, so that the curve is not
 * hidden in it.
 */
const ABOVE = 0.008;

export type Place = (now: Moment, time: number) => Vector;

export class ContactPath {
  readonly object = new Group();
  readonly #motion: Motion;
  readonly #place: Place;
  readonly #curve: MovingCurve;
  readonly #times: Float64Array;
  readonly #points: Float32Array;
  /**
   * Number of points computed so far. A motion that changes with a knob shows only a few of them.
   */
  #known = 0;

  constructor(motion: Motion, until: number, place: Place, ink: Ink, palette: Palette) {
    const fine = Math.max(1, Math.min(FINE, Math.floor(LONGEST / motion.count)));
    const { times, count } = motion;
    const last = times[count - 1];
    const all = Array.from({ length: (count - 1) * fine + 1 }, (_, k) => {
      const i = Math.floor(k / fine);
      return times[i] + ((k % fine) / fine) * ((times[i + 1] ?? last) - times[i]);
    });
    this.#times = Float64Array.from(all.filter((time) => time <= until));
    this.#motion = motion;
    this.#place = place;
    this.#points = new Float32Array(3 * this.#times.length);
    this.#curve = new MovingCurve(this.#times.length + 1, { ink, width: 1.8 }, palette);
    const { geometry } = this.#curve.object;
    // The body, which is on top of the curves, hides them only partly.
    const hidden = new Line2(geometry, lineMaterial({ ink, width: 1.8, opacity: 0.3, behind: true }, palette));
    hidden.frustumCulled = false;
    hidden.renderOrder = 4;
    this.object.add(this.#curve.object, hidden);
  }

  /** Draws the curve up to `time`, with the state `now`. */
  draw(now: Moment, time: number): void {
    const last = indexAt(this.#times, time);
    for (; this.#known <= last; this.#known += 1) {
      const t = this.#times[this.#known];
      this.#points.set(this.#place(this.#motion.at(t), t), 3 * this.#known);
    }
    const end = this.#times[this.#times.length - 1];
    const tip = time <= end ? this.#place(now, time) : Array.from(this.#points.subarray(3 * last, 3 * last + 3));
    this.#curve.draw(last + 2, (k, out) => {
      if (k > last) out.set(tip);
      else out.set(this.#points.subarray(3 * k, 3 * k + 3));
    });
  }
}

/** Returns the functions for the points of curves, in lengths of `unit` metres. */
export function places(contact: Contact, start: number, unit: number): Record<"ground" | "trace" | "body" | "center", Place> {
  const { ground } = contact;
  const raised = (point: Vector, by: number): Vector => {
    const n = normalAt(ground, point);
    return point.map((x, k) => x / unit + by * n[k]) as Vector;
  };
  const inSpace = ({ point, center }: Moment): Vector => raised(point ?? center, ABOVE);
  return {
    ground: inSpace,
    trace: (now, time) => {
      const half = -0.5 * ground.rate * (time - start);
      const [s, c] = [Math.sin(half), Math.cos(half)];
      return rotate([c, s * ground.axis[0], s * ground.axis[1], s * ground.axis[2]], inSpace(now));
    },
    body: ({ attitude, point, center }) => {
      const p = raised(point ?? center, -ABOVE);
      return rotate(inverse(attitude), p.map((x, k) => x - center[k] / unit) as Vector);
    },
    center: ({ center }) => center.map((x) => x / unit) as Vector,
  };
}
