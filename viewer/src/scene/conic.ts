/** Curve of an orbit, r = p/(1 + e · r̂), in a sphere of radius 1. */
import { Vector3 } from "three";
import type { OrbitData } from "../data";

const COUNT = 256;
/** Apoapsis that is shown, relative to the part that the motion sees. */
const LONG = 8;

export class Conic {
  readonly points: Vector3[];
  /** Radius of the sphere, m, and its centre relative to the central body. */
  readonly unit: number;
  readonly #middle: Vector3;
  readonly #e: Vector3;
  readonly #parameter: number;

  /** `outs`: unit vectors from the centre to the body, which a part of the curve must contain. */
  constructor({ parameter, eccentricity, normal }: OrbitData, outs: Vector3[]) {
    this.#e = new Vector3(...eccentricity);
    this.#parameter = parameter;
    const e = this.#e.length();
    const n = new Vector3(...normal);
    // Any direction in the plane of a circle.
    const across = new Vector3(Math.abs(n.x) < 0.6 ? 1 : 0, Math.abs(n.x) < 0.6 ? 0 : 1, 0);
    const x = e > 0 ? this.#e.clone().divideScalar(e) : across.addScaledVector(n, -across.dot(n)).normalize();
    const y = n.cross(x);
    const spot = (u: number, v: number): Vector3 => x.clone().multiplyScalar(u).addScaledVector(y, v);
    const turn = Array.from({ length: COUNT + 1 }, (_, k) => (2 * k) / COUNT - 1);
    let places: Vector3[];
    // What the motion sees of the curve, m; the rest of a very long one is left out.
    const far = 1.2 * Math.max(2 * parameter, ...outs.map((out) => this.distance(out)));
    if (parameter / (1 - e) < LONG * far && e < 1) {
      // By the eccentric anomaly: no part of an ellipse is coarse.
      const a = parameter / (1 - e * e);
      const b = a * Math.sqrt(1 - e * e);
      this.unit = a;
      this.#middle = spot(-a * e, 0);
      places = turn.map((t) => spot(a * (Math.cos(Math.PI * t) - e), b * Math.sin(Math.PI * t)));
    } else {
      const widest = Math.acos((parameter / far - 1) / e);
      places = turn.map((t) => spot(Math.cos(widest * t), Math.sin(widest * t))).map((out) => out.multiplyScalar(this.distance(out)));
      const ends = [places[0], places[COUNT], places[COUNT / 2]];
      this.#middle = ends.reduce((sum, p) => sum.addScaledVector(p, 1 / 3), new Vector3());
      this.unit = Math.max(this.#middle.length(), ...places.map((p) => p.distanceTo(this.#middle)));
    }
    this.points = places.map((p) => this.at(p));
  }

  /** Returns r in the direction of a unit vector, m. */
  distance(out: Vector3): number {
    return this.#parameter / (1 + this.#e.dot(out));
  }

  /** Returns the place in the sphere of a place relative to the central body, m. */
  at(place: Vector3): Vector3 {
    return place.clone().sub(this.#middle).divideScalar(this.unit);
  }
}
