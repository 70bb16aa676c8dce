/** Components of vectors along one of three sets of axes, each with its own marks in plots. */
import { inverse, type Quaternion, rotate, type Vector, writeRotated } from "./attitude";
import type { Motion } from "./motion";

export type AxisSet = "body" | "principal" | "space";

/** Style of the components along a set of axes. Dashes distinguish the sets, as do the subscripts. */
interface Style {
  title: string;
  /** Choice in the list above the plots. */
  choice: string;
  subscripts: readonly [string, string, string];
  dash?: number[];
}

export const AXIS_SETS: Record<AxisSet, Style> = {
  body: { title: "body axes", choice: "body axes x y z", subscripts: ["x", "y", "z"] },
  principal: { title: "principal axes", choice: "principal axes 1 2 3", subscripts: ["₁", "₂", "₃"], dash: [11, 3, 2, 3] },
  space: { title: "space axes", choice: "space axes X Y Z", subscripts: ["X", "Y", "Z"], dash: [6, 3] },
};

/** Returns rows of vectors given along body or space axes as components along a set of axes. */
export function components(motion: Motion, rows: Float64Array, given: "body" | "space", wanted: AxisSet, principal: Quaternion): Float64Array {
  if (given === wanted) return rows;
  if (wanted === "space") return rotated(rows, motion.attitude);
  const body = given === "body" ? rows : rotated(rows, inverses(motion.attitude));
  return wanted === "body" ? body : rotated(body, inverse(principal));
}

/**
 * Returns the index of the principal axis along each body axis; null if the principal axes are not
 * along the body axes.
 */
export function alongBody(principal: Quaternion): Vector | null {
  const found = [-1, -1, -1];
  ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as Vector[]).forEach((axis, k) => {
    const index = rotate(principal, axis).findIndex((c) => Math.abs(c) > 1 - 1e-12);
    if (index >= 0) found[index] = k;
  });
  return found.includes(-1) ? null : (found as Vector);
}

/** Rotates rows of three, all by one rotation or each by its own. */
function rotated(rows: Float64Array, by: ArrayLike<number>): Float64Array {
  const out = new Float64Array(rows.length);
  const step = by.length === 4 ? 0 : 4;
  for (let i = 0; 3 * i < rows.length; i += 1) writeRotated(by, step * i, rows, 3 * i, out, 3 * i);
  return out;
}

function inverses(attitudes: Float64Array): Float64Array {
  return attitudes.map((c, i) => (i % 4 === 0 ? c : -c));
}
