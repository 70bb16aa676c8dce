/**
 * Attitudes between samples, and Euler angles. A quaternion is (w, x, y, z) and takes components in
 * body axes to components in space axes, as everywhere in polhode.
 */
export type Quaternion = [number, number, number, number];
export type Vector = [number, number, number];

/**
 * Makes successive quaternions continuous: q and −q are the same attitude. Changes `rows` in place.
 */
export function makeContinuous(rows: Float64Array): void {
  for (let i = 4; i + 3 < rows.length; i += 4) {
    const dot =
      rows[i] * rows[i - 4] + rows[i + 1] * rows[i - 3] + rows[i + 2] * rows[i - 2] + rows[i + 3] * rows[i - 1];
    if (dot < 0) for (let k = i; k < i + 4; k += 1) rows[k] = -rows[k];
  }
}

/**
 * Returns the uniform rotation from a to b at the fraction `part`: sin((1 − s)θ)/sin θ
 * a + sin(sθ)/sin θ b.
 */
export function slerp(a: Quaternion, b: Quaternion, part: number): Quaternion {
  let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = dot < 0 ? -1 : 1;
  dot = Math.min(Math.abs(dot), 1);
  const angle = Math.acos(dot);
  const sine = Math.sin(angle);
  const p = sine < 1e-9 ? 1 - part : Math.sin((1 - part) * angle) / sine;
  const q = sign * (sine < 1e-9 ? part : Math.sin(part * angle) / sine);
  return unit([p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2], p * a[3] + q * b[3]]);
}

/** Rotation between samples, rad, above which the rates say little about the motion in between. */
const LARGE = 2;

/**
 * Rotation from a to b in h seconds with the angular velocities u and v (body axes) at its ends.
 *
 * In the chart θ of rotation vectors from a, θ' = h J⁻¹(θ) ω with J⁻¹(θ) ω = ω + ½ θ × ω + k
 * θ × (θ × ω), k = 1/θ² − (1 + cos θ)/(2 θ sin θ). Hermite's cubic through both ends then has an
 * error of order h⁴. Large rotations are uniform instead.
 */
export function between(a: Quaternion, u: Vector, b: Quaternion, v: Vector, h: number, part: number): Quaternion {
  if (h * Math.max(Math.hypot(...u), Math.hypot(...v)) > LARGE) return slerp(a, b, part);
  const turn = vectorOf(product(inverse(a), b));
  const angle = Math.hypot(...turn);
  const k = angle < 1e-3 ? 1 / 12 : 1 / angle ** 2 - (1 + Math.cos(angle)) / (2 * angle * Math.sin(angle));
  const across = cross(turn, v);
  const twice = cross(turn, across);
  const s = part;
  const vector = turn.map((end, c) => {
    const out = h * u[c];
    const into = h * (v[c] + across[c] / 2 + k * twice[c]);
    return s * s * (3 - 2 * s) * end + s * (1 - s) * ((1 - s) * out - s * into);
  }) as Vector;
  return unit(product(a, quaternionOf(vector)));
}

/** Returns the space components q v q⁻¹ of a vector with body components v. */
export function rotate(q: Quaternion, v: Vector): Vector {
  const [w, x, y, z] = q;
  // t = 2 u × v, result = v + w t + u × t
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

type Numbers = Float32Array | Float64Array | number[];

/**
 * Rotates between arrays, without allocating a vector: q at `i`, v at `j`; `size` times the result
 * goes to `k`.
 */
export function writeRotated(qs: ArrayLike<number>, i: number, vs: ArrayLike<number>, j: number, out: Numbers, k: number, size = 1): void {
  const w = qs[i];
  const x = qs[i + 1];
  const y = qs[i + 2];
  const z = qs[i + 3];
  const a = vs[j];
  const b = vs[j + 1];
  const c = vs[j + 2];
  const tx = 2 * (y * c - z * b);
  const ty = 2 * (z * a - x * c);
  const tz = 2 * (x * b - y * a);
  out[k] = size * (a + w * tx + y * tz - z * ty);
  out[k + 1] = size * (b + w * ty + z * tx - x * tz);
  out[k + 2] = size * (c + w * tz + x * ty - y * tx);
}

export function inverse([w, x, y, z]: Quaternion): Quaternion {
  return [w, -x, -y, -z];
}

/**
 * Returns precession φ, nutation θ and spin ψ of R = Rz(φ) Rx(θ) Rz(ψ), rad; ψ is 0 where only φ ±
 * ψ is determined.
 */
export function euler313([w, x, y, z]: Quaternion): Vector {
  const theta = 2 * Math.atan2(Math.hypot(x, y), Math.hypot(w, z));
  const halfSum = Math.atan2(z, w);
  const halfDifference = Math.atan2(y, x);
  if (x === 0 && y === 0) return [wrap(2 * halfSum), theta, 0];
  if (w === 0 && z === 0) return [wrap(2 * halfDifference), theta, 0];
  return [wrap(halfSum + halfDifference), theta, wrap(halfSum - halfDifference)];
}

function wrap(angle: number): number {
  const turn = 2 * Math.PI;
  return angle - turn * Math.round(angle / turn);
}

function product(a: Quaternion, b: Quaternion): Quaternion {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Returns the rotation vector of the shorter rotation. */
function vectorOf([w, x, y, z]: Quaternion): Vector {
  const sign = w < 0 ? -1 : 1;
  const sine = Math.hypot(x, y, z);
  const factor = sine < 1e-12 ? 2 * sign : (sign * 2 * Math.atan2(sine, Math.abs(w))) / sine;
  return [factor * x, factor * y, factor * z];
}

function quaternionOf(v: Vector): Quaternion {
  const angle = Math.hypot(...v);
  const factor = angle < 1e-9 ? 0.5 : Math.sin(angle / 2) / angle;
  return [Math.cos(angle / 2), factor * v[0], factor * v[1], factor * v[2]];
}

function unit(q: Quaternion): Quaternion {
  const norm = Math.hypot(...q);
  return [q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm];
}
