/** Visible points of a scene, and the nearest place of a camera with all of them in the frame. */
import { type Quaternion, Vector3 } from "three";
import type { Moment, Motion } from "../motion";

/**
 * Numbers of sampled times, and of representative directions. Directions are about 0.2 rad apart,
 * where a sphere extends 0.5 % beyond the points.
 */
const TIMES = 200;
/**
 * At one in this many times, the whole of the rotating parts is examined; at the others, only the
 * farthest parts, such as arrows.
 */
const WHOLE = 3;
const DIRECTIONS = 300;
/** Relative size above which another motion keeps the frame of the previous one. */
const LIKE = 0.62;
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/** Returns evenly distributed directions (Fibonacci spiral). */
export function directions(count: number): Vector3[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count;
    const flat = Math.sqrt(1 - z * z);
    return new Vector3(flat * Math.cos(k * golden), flat * Math.sin(k * golden), z);
  });
}

/**
 * A bundle of neighbouring directions. A point that is not far enough for any of them is skipped
 * for all.
 */
interface Bundle {
  middle: Vector3;
  /** Cosine and sine of the angle α from the centre to the farthest direction. */
  cos: number;
  sin: number;
  /** Index of the first direction, and the one after the last. */
  from: number;
  to: number;
}

/** Returns x y z of `count` directions, in bundles of about sixteen. */
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

/** The points that are farthest in each of many directions. Their hull is nearly that of all. */
export class Farthest {
  readonly points: Vector3[];
  /** Directions, x y z of each. */
  readonly #directions: Float64Array;
  readonly #bundles: Bundle[];
  readonly #far: Float64Array;
  /** Least of the farthest distances of each bundle. */
  readonly #least: Float64Array;
  /** Distance from the origin below which a point cannot change the result. */
  least = -Infinity;

  /** `before`: previous points for the same number of directions. */
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

  // Initialises with a point for each direction.
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
      // For p at an angle θ from the centre, p·d ≤ |p| cos(θ − α) for all directions of the bundle;
      // or |p| if θ < α.
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

/** Visible points of a picture. */
export interface Seen {
  /**
   * Returns the points at a time, in the frame of the camera: all, or only the farthest; without
   * `rigid`.
   */
  at: (now: Moment, time: number, isWhole: boolean) => Vector3[];
  /** Points that only rotate. */
  rigid: readonly Vector3[];
  /** Returns the rotation of the rigid points at the time of the last call of `at`. */
  turn: () => Quaternion;
}

/**
 * Visible points of a picture over the whole motion. `before` is the content of the previous
 * motion. The frame stays, and is only extended by points beyond it, while this motion has a
 * similar size, or always if `isHeld`.
 */
export class Contents {
  readonly #found = new Map<string, Vector3[]>();
  readonly #before: Map<string, Vector3[]>;
  readonly #isHeld: boolean;

  constructor(before: Contents | null, isHeld: boolean) {
    this.#before = new Map(before ? [...before.#before, ...before.#found] : []);
    this.#isHeld = isHeld;
  }

  /** Makes the following frames independent of the previous motion. */
  refit(): void {
    if (this.#before.size === 0) return;
    this.#found.clear();
    this.#before.clear();
  }

  /** Returns the outermost points of `seen`, cached under `key`. */
  of(key: string, motion: Motion, seen: () => Seen): Vector3[] {
    const before = this.#before.get(key);
    let found = this.#found.get(key) ?? (this.#isHeld ? before : undefined);
    if (!found) {
      const { at, rigid, turn } = seen();
      const { points, turns } = sampled(motion, at, turn);
      const isLike = before && Math.max(size(points), size(rigid)) > LIKE * size(before);
      // Most other points are then inside and change nothing.
      const farthest = new Farthest(DIRECTIONS, isLike ? before : null);
      for (const p of points) farthest.add(p);
      addTurned(farthest, rigid, turns);
      found = farthest.points;
    }
    this.#found.set(key, found);
    return found;
  }
}

/**
 * Returns the visible points at many times, and the rotations of the rigid points at the times at
 * which the whole is examined.
 */
function sampled(motion: Motion, at: Seen["at"], turn: Seen["turn"]): { points: Vector3[]; turns: Quaternion[] } {
  const count = Math.min(motion.telling, TIMES);
  const [points, turns]: [Vector3[], Quaternion[]] = [[], []];
  for (let k = 0; k < count; k += 1) {
    // The times are spread by the golden ratio, so that no oscillation is in phase with them.
    const i = count < TIMES ? k : Math.floor(((k * GOLDEN) % 1) * motion.telling);
    const isWhole = count < TIMES || k % WHOLE === 0;
    points.push(...at(motion.sample(i), motion.times[i], isWhole));
    if (isWhole) turns.push(turn());
  }
  return { points, turns };
}

/**
 * Adds rotated points. Rotation does not change their distance, so that most need not be rotated at
 * all.
 */
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
 * Finds the target and the distance of a camera that looks against `back` with z upwards, so that
 * all points are in its frame, which ends at the slopes `wide` and `high` from its axis. Each side
 * of the frame is a plane that is moved until it touches the points; two opposite planes meet at
 * the camera.
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
