/** Conversion between principal moments and points of a triangle. Pure functions. */

export type Three = [number, number, number];
export type Place = [x: number, y: number];

/**
 * Corners of the triangle of moments. A point represents the fractions of the sum,
 * p₁ + p₂ + p₃ = 1. No moment is larger than the sum of the other two, so each fraction is at most
 * ½. The corners are (0, ½, ½), (½, 0, ½), (½, ½, 0).
 */
export const CORNERS: [Place, Place, Place] = [
  [0, 0],
  [1, 0],
  [0.5, Math.sqrt(3) / 2],
];

/** Returns the point of moments: p = ½ (1 − weights of the corners). */
export function placeOf(moments: Three): Place {
  const sum = moments[0] + moments[1] + moments[2];
  const weights = moments.map((moment) => 1 - (2 * moment) / sum);
  return [0, 1].map((c) => CORNERS.reduce((all, corner, k) => all + weights[k] * corner[c], 0)) as Place;
}

/**
 * Returns the moments with this sum at the point, or at the nearest valid one. It stays 1e-3 away
 * from the corners, because a rod has no moment about itself.
 */
export function momentsAt([x, y]: Place, sum: number): Three {
  const w3 = y / CORNERS[2][1];
  const w2 = x - 0.5 * w3;
  let weights = [1 - w2 - w3, w2, w3].map((weight) => Math.max(weight, 0));
  let all = weights[0] + weights[1] + weights[2];
  weights = weights.map((weight) => Math.min(weight / all, 0.998));
  all = weights[0] + weights[1] + weights[2];
  return weights.map((weight) => Number((0.5 * sum * (1 - weight / all)).toPrecision(6))) as Three;
}

/** Describes a body with these moments. */
export function kindOf(moments: Three): string {
  const [a, b, c] = [...moments].sort((p, q) => p - q);
  const near = (p: number, q: number): boolean => Math.abs(p - q) <= 0.01 * c;
  if (near(a, c)) return "like a sphere";
  if (near(a, 0) && near(b, c)) return "like a rod";
  const flat = near(a + b, c) ? ", flat" : "";
  if (near(a, b)) return `symmetric, like a disc${flat}`;
  if (near(b, c)) return "symmetric, like a spindle";
  return flat ? "a flat plate" : "asymmetric";
}
