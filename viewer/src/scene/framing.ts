/** What a camera has to see, and the nearest place from which all of it is in the frame. */
import { Vector3 } from "three";
import type { Moment, Motion } from "../motion";

/** Of a motion, and of the points that stand for all: some directions are 0.2 rad apart, where a sphere is 0.5 % beyond them. */
const TIMES = 200;
const DIRECTIONS = 300;
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/** Directions spread evenly (Fibonacci's spiral). */
export function directions(count: number): Vector3[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count;
    const flat = Math.sqrt(1 - z * z);
    return new Vector3(flat * Math.cos(k * golden), flat * Math.sin(k * golden), z);
  });
}

/** The points that are farthest in each of many directions: their hull is nearly that of all. */
export class Farthest {
  readonly points: Vector3[];
  readonly #directions: Vector3[];
  readonly #far: number[];
  /** The least of them: what is nearer changes nothing. */
  #least = -Infinity;

  constructor(count: number) {
    this.#directions = directions(count);
    this.#far = this.#directions.map(() => -Infinity);
    this.points = this.#directions.map(() => new Vector3());
  }

  add({ x, y, z }: Vector3): void {
    if (x * x + y * y + z * z <= this.#least * Math.abs(this.#least)) return;
    this.#least = Infinity;
    for (let k = 0; k < this.#directions.length; k += 1) {
      const d = this.#directions[k];
      const along = d.x * x + d.y * y + d.z * z;
      if (along > this.#far[k]) {
        this.#far[k] = along;
        this.points[k].set(x, y, z);
      }
      this.#least = Math.min(this.#least, this.#far[k]);
    }
  }
}

/** All that is in a picture, at every time of the motion. */
export class Contents {
  readonly #found = new Map<string, Vector3[]>();

  /** `points` of a time; what they are of is named by `key`. */
  of(key: string, motion: Motion, points: (now: Moment, time: number) => Vector3[]): Vector3[] {
    let found = this.#found.get(key);
    if (!found) {
      const farthest = new Farthest(DIRECTIONS);
      const count = Math.min(motion.telling, TIMES);
      for (let k = 0; k < count; k += 1) {
        // Spread by the golden ratio: no oscillation is in step with it.
        const i = count < TIMES ? k : Math.floor(((k * GOLDEN) % 1) * motion.telling);
        const time = motion.times[i];
        for (const p of points(motion.at(time), time)) farthest.add(p);
      }
      found = farthest.points;
      this.#found.set(key, found);
    }
    return found;
  }
}

/**
 * For a camera that looks against `back` with z upwards: where it has to look, and from how far, so that all points are in its frame, which
 * ends at the slopes `wide` and `high` from its axis. Each side of the frame is a plane that is moved until it touches the points; two
 * opposite ones meet where the camera is.
 */
export function fit(points: readonly Vector3[], back: Vector3, wide: number, high: number): { target: Vector3; distance: number } {
  const right = new Vector3(-back.y, back.x, 0).normalize();
  const up = back.clone().cross(right);
  let [left, rightmost, low, top, near, far] = [Infinity, -Infinity, Infinity, -Infinity, -Infinity, Infinity];
  for (const p of points) {
    const [x, y, z] = [p.dot(right), p.dot(up), p.dot(back)];
    left = Math.min(left, x - z * wide);
    rightmost = Math.max(rightmost, x + z * wide);
    low = Math.min(low, y - z * high);
    top = Math.max(top, y + z * high);
    near = Math.max(near, z);
    far = Math.min(far, z);
  }
  if (points.length === 0) return { target: new Vector3(), distance: 1 };
  const eye = Math.max((rightmost - left) / (2 * wide), (top - low) / (2 * high));
  const depth = (near + far) / 2;
  const target = right.multiplyScalar((left + rightmost) / 2).addScaledVector(up, (low + top) / 2).addScaledVector(back, depth);
  return { target, distance: Math.max(eye - depth, 1e-6) };
}
