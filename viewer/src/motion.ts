/**
 * The motion at any time, interpolated between samples. Attitudes follow the rates at both samples.
 * ω is a cubic through its neighbours. Momentum is linear in space, and torque is linear in space
 * or in the body, wherever it changes less.
 */
import type { MotionData, Row } from "./data";
import { between, makeContinuous, type Quaternion, rotate, type Vector, writeRotated } from "./attitude";
import { indexAt } from "./clock";
import { Contact } from "./contact";
import { BadData, f32, f64 } from "./decode";

export interface Moment {
  attitude: Quaternion;
  /** Angular velocity, body axes, rad/s. */
  omega: Vector;
  /** Angular momentum, space axes, kg·m²/s. */
  momentum: Vector;
  /** Torque, space axes, N·m; null without torque. */
  torque: Vector | null;
  /** Position of the centre of mass, space axes, m; the origin for a body that turns in place. */
  center: Vector;
  /** Contact point, space axes, m; null without ground. */
  point: Vector | null;
}

/** Rotation between samples above which a body may oscillate unnoticed, rad. */
const FAR = Math.PI / 2;

/** Smallest angle between ω and L that counts as nutation, rad. */
const PARALLEL = 1e-6;

/** Relative size below which a sum counts as zero. */
const ZERO = 1e-12;

export class Motion {
  readonly count: number;
  readonly times: Float64Array;
  readonly attitude: Float64Array;
  readonly omega: Float64Array;
  readonly momentum: Float64Array;
  readonly torque: Float64Array | null;
  readonly kinetic: Float64Array;
  readonly potential: Float64Array | null;
  readonly work: { name: string; values: Float64Array } | null;
  readonly drift: { name: string; values: Float64Array }[];
  readonly wheels: { name: string; axis: Vector; momentum: Float64Array; speed: Float64Array | null; motor: Float64Array | null }[];
  readonly pointings: { name: string; body: Vector; limit: number | null; values: Float64Array }[];
  /** Directions of space: unit vectors at the samples, or one that is fixed. */
  readonly directions: { name: string; values: ArrayLike<number> }[];
  readonly events: { time: number; name: string }[];
  /** Number of all events; greater than the length of `events` if these are thinned. */
  readonly eventCount: number;
  /** Data of a body on the ground. */
  readonly contact: Contact | null;
  readonly complete: boolean;
  /**
   * Number of samples that determine size and speed of the motion. The last samples of a diverging
   * motion are far beyond the others.
   */
  readonly telling: number;
  /** Largest rotation between samples, rad. If it is not small, the interpolation is unreliable. */
  readonly largestTurn: number;
  /** True if the samples may miss oscillations: the body turns far between samples, and nutates. */
  readonly aliased: boolean;

  constructor(data: MotionData) {
    const n = data.count;
    if (!Number.isInteger(n) || n < 1) throw new BadData("the motion has no samples");
    this.count = n;
    this.times = f64(data.times, "times", n);
    this.attitude = f64(data.attitude, "attitude", 4 * n);
    this.omega = f64(data.omega, "omega", 3 * n);
    this.momentum = f64(data.momentum, "momentum", 3 * n);
    this.torque = data.torque === null ? null : f64(data.torque, "torque", 3 * n);
    this.kinetic = f64(data.kinetic, "kinetic energy", n);
    this.potential = data.potential === null ? null : f64(data.potential, "potential energy", n);
    const named = ({ name, values }: { name: string; values: Row }): { name: string; values: Float64Array } => {
      return { name, values: f64(values, name, n) };
    };
    this.work = data.work === null ? null : named(data.work);
    this.drift = data.drift.map(named);
    this.pointings = data.pointings.map(({ body, limit, ...line }) => ({ ...named(line), body, limit }));
    this.directions = data.directions.map(({ name, fixed, values }) => {
      const row = fixed ?? f32(values ?? "", name);
      if (row.length !== 3 && row.length !== 3 * n) throw new BadData(`${name}: ${row.length} numbers, not ${3 * n}`);
      return { name, values: row };
    });
    this.wheels = data.wheels.map(({ name, axis, momentum, speed, motor }) => ({
      name,
      axis,
      momentum: f64(momentum, `momentum of ${name}`, n),
      speed: speed === null ? null : f64(speed, `speed of ${name}`, n),
      motor: motor === null ? null : f64(motor, `motor of ${name}`, n),
    }));
    this.events = data.events;
    this.eventCount = data.eventCount;
    if (!this.events.every(({ time }) => Number.isFinite(time))) throw new BadData("events: a time is not finite");
    this.contact = data.contact === null ? null : new Contact(data.contact, n);
    this.complete = data.complete;
    for (let i = 1; i < n; i += 1) {
      if (this.times[i] < this.times[i - 1]) throw new BadData(`times: sample ${i} is earlier than the one before`);
    }
    this.#settle();
    makeContinuous(this.attitude);
    this.largestTurn = largestTurn(this.times, this.omega);
    this.aliased = this.largestTurn > FAR && this.#nutates();
    this.telling = this.complete ? n : this.#telling();
  }

  // L may be zero while the body turns, if its wheels turn the other way. Then its rounding error
  // is set to zero. The carrier's L is at least 2 T/|ω|.
  #settle(): void {
    let size = Math.max(...this.wheels.map(({ momentum }) => largest(momentum)), 0);
    for (let i = 0; i < this.count; i += 1) {
      const rate = lengthAt(this.omega, i);
      if (rate > 0) size = Math.max(size, (2 * this.kinetic[i]) / rate);
    }
    if (largest(this.momentum) <= ZERO * size) this.momentum.fill(0);
  }

  #nutates(): boolean {
    const omega = new Float64Array(3);
    for (let i = 0; i < this.count; i += 1) {
      writeRotated(this.attitude, 4 * i, this.omega, 3 * i, omega, 0);
      const size = lengthAt(omega, 0) * lengthAt(this.momentum, i);
      let along = 0;
      for (let k = 0; k < 3; k += 1) along += omega[k] * this.momentum[3 * i + k];
      // Uses cos α = 1 − α²/2.
      if (size > 0 && 1 - Math.abs(along / size) > 0.5 * PARALLEL * PARALLEL + 4 * Number.EPSILON) return true;
    }
    return false;
  }

  at(time: number): Moment {
    const { i, j, part } = this.#place(time);
    const attitude = this.attitudeAt(time);
    const { contact } = this;
    return {
      attitude,
      center: contact ? this.#cubic(contact.center, i, j, part) : [0, 0, 0],
      point: contact && this.#cubic(contact.point, i, j, part),
      omega: this.#cubic(this.omega, i, j, part),
      momentum: linear(this.momentum, i, j, part),
      torque: this.torque === null ? null : this.#torqueAt(this.torque, i, j, part, attitude),
    };
  }

  /** Returns the moment at the i-th of its times. */
  sample(i: number): Moment {
    const attitude = this.attitudeOf(i);
    const torque = this.torque === null ? null : rotate(attitude, at(this.torque, i));
    const { contact } = this;
    const [center, point] = contact ? [at(contact.center, i), at(contact.point, i)] : [[0, 0, 0] as Vector, null];
    return { attitude, omega: at(this.omega, i), momentum: at(this.momentum, i), torque, center, point };
  }

  attitudeAt(time: number): Quaternion {
    const { i, j, part } = this.#place(time);
    const step = this.times[j] - this.times[i];
    return between(this.attitudeOf(i), at(this.omega, i), this.attitudeOf(j), at(this.omega, j), step, part);
  }

  /** Returns the k-th of the directions at a time, a unit vector. */
  directionAt(k: number, time: number): Vector {
    const { values } = this.directions[k];
    const { i, j, part } = this.#place(time);
    if (values.length === 3) return [values[0], values[1], values[2]];
    const v = [0, 1, 2].map((c) => (1 - part) * values[3 * i + c] + part * values[3 * j + c]) as Vector;
    const size = length(v) || 1;
    return [v[0] / size, v[1] / size, v[2] / size];
  }

  // Returns the samples on both sides of a time, and the fraction between them.
  #place(time: number): { i: number; j: number; part: number } {
    const i = Math.min(indexAt(this.times, time), Math.max(this.count - 2, 0));
    const j = Math.min(i + 1, this.count - 1);
    const step = this.times[j] - this.times[i];
    return { i, j, part: step > 0 ? Math.min(Math.max((time - this.times[i]) / step, 0), 1) : 0 };
  }

  attitudeOf(i: number): Quaternion {
    const q = this.attitude;
    return [q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]];
  }

  /** Returns the mean of |ω|, rad/s. */
  meanRate(): number {
    let sum = 0;
    for (let i = 0; i < this.telling; i += 1) sum += lengthAt(this.omega, i);
    return sum / this.telling;
  }

  // Least number of representative samples over all quantities that are plotted or drawn to scale.
  #telling(): number {
    const vectors = [this.omega, this.momentum, ...(this.torque ? [this.torque] : [])];
    const numbers = [this.kinetic, this.potential, this.work?.values, ...this.wheels.flatMap(({ momentum, speed }) => [momentum, speed])];
    const rows = [...vectors.map(lengths), ...numbers.filter((row) => row !== null && row !== undefined)];
    return Math.min(...rows.map(beforeRunAway));
  }

  // The torque of a thruster is constant in the body, and that of gravity nearly constant in space.
  // The result is in space axes, interpolated in the axes in which the torque changes less.
  #torqueAt(torque: Float64Array, i: number, j: number, part: number, attitude: Quaternion): Vector {
    const [a, b] = [at(torque, i), at(torque, j)];
    const [inSpaceA, inSpaceB] = [rotate(this.attitudeOf(i), a), rotate(this.attitudeOf(j), b)];
    return apart(inSpaceA, inSpaceB) <= apart(a, b) ? mixed(inSpaceA, inSpaceB, part) : rotate(attitude, mixed(a, b, part));
  }

  // Catmull–Rom cubic for unevenly spaced samples.
  #cubic(rows: Float64Array, i: number, j: number, s: number): Vector {
    const slope = (k: number, c: number): number => {
      const before = Math.max(k - 1, 0);
      const after = Math.min(k + 1, this.count - 1);
      const step = this.times[after] - this.times[before];
      return step > 0 ? (rows[3 * after + c] - rows[3 * before + c]) / step : 0;
    };
    const h = this.times[j] - this.times[i];
    const component = (c: number): number => {
      const a = rows[3 * i + c];
      const b = rows[3 * j + c];
      const u = 1 - s;
      return (
        u * u * (1 + 2 * s) * a + s * s * (3 - 2 * s) * b + h * s * u * (u * slope(i, c) - s * slope(j, c))
      );
    };
    return [component(0), component(1), component(2)];
  }
}

function largest(values: Float64Array): number {
  let size = 0;
  for (const value of values) size = Math.max(size, Math.abs(value));
  return size;
}

/** Returns the i-th of rows of three. */
export function at(rows: Float64Array, i: number): Vector {
  return [rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]];
}

export function length(v: Vector): number {
  return Math.hypot(v[0], v[1], v[2]);
}

function lengthAt(rows: Float64Array, i: number): number {
  return Math.hypot(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
}

/** Returns the lengths of rows of three. */
export function lengths(rows: Float64Array): Float64Array {
  const out = new Float64Array(rows.length / 3);
  for (let i = 0; i < out.length; i += 1) out[i] = lengthAt(rows, i);
  return out;
}

function linear(rows: Float64Array, i: number, j: number, s: number): Vector {
  return mixed(at(rows, i), at(rows, j), s);
}

function mixed(a: Vector, b: Vector, s: number): Vector {
  return [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])];
}

function apart(a: Vector, b: Vector): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/**
 * Returns the number of values before a final divergence, in which each value is far beyond all
 * before it.
 */
function beforeRunAway(values: Float64Array): number {
  const soFar = new Float64Array(values.length);
  values.forEach((value, i) => {
    soFar[i] = Math.max(i > 0 ? soFar[i - 1] : 0, Math.abs(value));
  });
  let last = values.length;
  while (last > Math.ceil(values.length / 2) && last > 1 && soFar[last - 1] > 4 * soFar[last - 2]) last -= 1;
  return last;
}

function largestTurn(times: Float64Array, omega: Float64Array): number {
  let largest = 0;
  let before = lengthAt(omega, 0);
  for (let i = 1; i < times.length; i += 1) {
    const rate = lengthAt(omega, i);
    largest = Math.max(largest, (times[i] - times[i - 1]) * Math.max(before, rate));
    before = rate;
  }
  return largest;
}
