/** What a camera has to see, and the nearest place from which all of it is in the frame. */
import { type Quaternion, Vector3 } from "three";
import type { Moment, Motion } from "../motion";

/** Of a motion, and of the points that stand for all: some directions are 0.2 rad apart, where a sphere is 0.5 % beyond them. */
const TIMES = 200;
/** At so many times of one the whole of what turns is looked at, at the others what goes farthest, as arrows do. */
const WHOLE = 3;
const DIRECTIONS = 300;
/** Another motion is seen in the frame of the one before unless it is smaller than this part of it. */
const LIKE = 0.62;
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

/** Directions near to each other, which a point that is not far enough for any of them passes by together. */
interface Bundle {
  middle: Vector3;
  /** Of the angle α from there to the farthest of them. */
  cos: number;
  sin: number;
  /** The first of them, and the one behind the last. */
  from: number;
  to: number;
}

/** x y z of so many directions, in bundles of about sixteen. */
function bundled(count: number): { directions: Float64Array; bundles: Bundle[] } {
  const middles = directions(Math.ceil(count / 16));
  const all = directions(count);
  const own = middles.map((): Vector3[] => []);
  for (const d of all) own[middles.reduce((best, m, k) => (m.dot(d) > middles[best].dot(d) ? k : best), 0)].push(d);
  let from = 0;
  const bundles = own.map((some, k): Bundle => {
    const cos = Math.min(...some.map((d) => d.dot(middles[k])), 1);
    const bundle = { middle: middles[k], cos, sin: Math.sqrt(1 - cos * cos), from, to: from + some.length };
    from += some.length;
    return bundle;
  });
  return { directions: Float64Array.from(own.flat().flatMap((d) => d.toArray())), bundles: bundles.filter((bundle) => bundle.from < bundle.to) };
}

const BUNDLED = new Map<number, ReturnType<typeof bundled>>();

/** The points that are farthest in each of many directions: their hull is nearly that of all. */
export class Farthest {
  readonly points: Vector3[];
  /** x y z of each. */
  readonly #directions: Float64Array;
  readonly #bundles: Bundle[];
  readonly #far: Float64Array;
  /** Of each bundle the least of them. */
  readonly #least: Float64Array;
  /** What is nearer to the origin is inside of what there is. */
  least = -Infinity;

  /** `before`: points that were found of so many directions. */
  constructor(count: number, before: readonly Vector3[] | null = null) {
    const made = BUNDLED.get(count) ?? bundled(count);
    BUNDLED.set(count, made);
    this.#directions = made.directions;
    this.#bundles = made.bundles;
    this.#far = new Float64Array(count).fill(-Infinity);
    this.#least = new Float64Array(made.bundles.length).fill(-Infinity);
    this.points = Array.from({ length: count }, (_, k) => before?.[k].clone() ?? new Vector3());
    if (before) this.#begin();
  }

  // With a point for each direction.
  #begin(): void {
    const d = this.#directions;
    this.points.forEach(({ x, y, z }, k) => {
      this.#far[k] = d[3 * k] * x + d[3 * k + 1] * y + d[3 * k + 2] * z;
    });
    this.#bundles.forEach(({ from, to }, b) => {
      this.#least[b] = Math.min(...this.#far.subarray(from, to));
    });
    this.least = Math.min(...this.#least);
  }

  add({ x, y, z }: Vector3): void {
    const d = this.#directions;
    const far = this.#far;
    const square = x * x + y * y + z * z;
    const size = Math.sqrt(square);
    if (size < this.least) return;
    let isFarther = false;
    for (let b = 0; b < this.#bundles.length; b += 1) {
      const { middle, cos, sin, from, to } = this.#bundles[b];
      // With p at an angle θ from the middle, p·d ≤ |p| cos(θ − α) for all of them; or |p| if θ < α.
      const along = middle.x * x + middle.y * y + middle.z * z;
      const most = along >= size * cos ? size : along * cos + Math.sqrt(Math.max(square - along * along, 0)) * sin;
      if (most < this.#least[b]) continue;
      let least = Infinity;
      for (let k = from; k < to; k += 1) {
        const reach = d[3 * k] * x + d[3 * k + 1] * y + d[3 * k + 2] * z;
        if (reach > far[k]) {
          far[k] = reach;
          this.points[k].set(x, y, z);
        }
        if (far[k] < least) least = far[k];
      }
      isFarther ||= least > this.#least[b];
      this.#least[b] = least;
    }
    if (isFarther) this.least = Math.min(...this.#least);
  }
}

/** What is to be seen. */
export interface Seen {
  /** At a time, in the frame of the camera: the whole of it, or what goes farthest. Without `rigid`. */
  at: (now: Moment, time: number, isWhole: boolean) => Vector3[];
  /** What only turns. */
  rigid: readonly Vector3[];
  /** How that is turned at the time of which `at` was asked last. */
  turn: () => Quaternion;
}

/**
 * All that is in a picture, at every time of the motion. `before`: of the motion until now. The frame stays as it was, and is only made
 * wider by what goes beyond it, as long as this motion's size is like it; or, if `isHeld`, whatever its size is.
 */
export class Contents {
  readonly #found = new Map<string, Vector3[]>();
  readonly #before: Map<string, Vector3[]>;
  readonly #isHeld: boolean;

  constructor(before: Contents | null, isHeld: boolean) {
    this.#before = new Map(before ? [...before.#before, ...before.#found] : []);
    this.#isHeld = isHeld;
  }

  /** From here on the frames are this motion's own. */
  refit(): void {
    if (this.#before.size === 0) return;
    this.#found.clear();
    this.#before.clear();
  }

  /** The outermost of `seen`, which is named by `key`. */
  of(key: string, motion: Motion, seen: () => Seen): Vector3[] {
    const before = this.#before.get(key);
    let found = this.#found.get(key) ?? (this.#isHeld ? before : undefined);
    if (!found) {
      const { at, rigid, turn } = seen();
      const { points, turns } = sampled(motion, at, turn);
      const isLike = before && Math.max(size(points), size(rigid)) > LIKE * size(before);
      // Then most of the others are inside and change nothing.
      const farthest = new Farthest(DIRECTIONS, isLike ? before : null);
      for (const p of points) farthest.add(p);
      addTurned(farthest, rigid, turns);
      found = farthest.points;
    }
    this.#found.set(key, found);
    return found;
  }
}

/** What is seen at many times, and how what only turns is turned at those at which the whole is looked at. */
function sampled(motion: Motion, at: Seen["at"], turn: Seen["turn"]): { points: Vector3[]; turns: Quaternion[] } {
  const count = Math.min(motion.telling, TIMES);
  const [points, turns]: [Vector3[], Quaternion[]] = [[], []];
  for (let k = 0; k < count; k += 1) {
    // Spread by the golden ratio: no oscillation is in step with it.
    const i = count < TIMES ? k : Math.floor(((k * GOLDEN) % 1) * motion.telling);
    const isWhole = count < TIMES || k % WHOLE === 0;
    points.push(...at(motion.sample(i), motion.times[i], isWhole));
    if (isWhole) turns.push(turn());
  }
  return { points, turns };
}

/** However they are turned, points are as far out as they were: most need not be turned at all. */
function addTurned(farthest: Farthest, points: readonly Vector3[], turns: readonly Quaternion[]): void {
  const turned = new Vector3();
  for (const p of points) {
    const far = p.length();
    for (const turn of turns) {
      if (far < farthest.least) break;
      farthest.add(turned.copy(p).applyQuaternion(turn));
    }
  }
}

function size(points: readonly Vector3[]): number {
  return points.reduce((most, p) => Math.max(most, p.length()), 0);
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
