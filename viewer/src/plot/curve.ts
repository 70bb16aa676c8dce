/** Drawn form of a line, in pixels: the same on the canvas and in files. */
import { envelopes, type Span } from "./envelope";

export type Point = [number, number];

export interface Curve {
  strokes: Point[][];
  /**
   * Bands that are filled faintly: along the lower edge of an envelope and back along the upper
   * one.
   */
  bands: Point[][];
  /** Single samples. */
  dots: Point[];
  /** False if the samples do not resolve the oscillation. */
  resolved: boolean;
}

/** Makes a line through points, or its envelope where the line would fill the plot with stripes. */
export function curve(x: ArrayLike<number>, y: ArrayLike<number>, starts?: ArrayLike<number>, spans: Span[] = envelopes(x, y, starts)): Curve {
  const made: Curve = { strokes: [], bands: [], dots: [], resolved: true };
  let stroke: Point[] = [];
  const end = (): void => {
    if (stroke.length > 1) made.strokes.push(stroke);
    stroke = [];
  };
  for (let i = 0, k = 0; i < y.length; i += 1) {
    if (!Number.isFinite(y[i]) || starts?.[i]) end();
    if (!Number.isFinite(y[i])) continue;
    stroke.push([x[i], y[i]]);
    if (i !== spans[k]?.first) continue;
    end();
    const { low, high, last, resolved } = spans[k];
    made.strokes.push(low, high);
    made.bands.push([...low, ...[...high].reverse()]);
    made.resolved &&= resolved;
    if (last < y.length - 1 && !starts?.[last + 1]) stroke.push([x[last], y[last]]);
    i = last;
    k += 1;
  }
  end();
  return made;
}

/**
 * Makes dots, and a line for the largest value so far, including `before` the first point. In
 * pixels, y decreases as the value grows.
 */
export function largestSoFar(x: ArrayLike<number>, y: ArrayLike<number>, before = Infinity): Curve {
  const stroke: Point[] = [];
  const dots: Point[] = [];
  let best = before;
  if (best < Infinity) stroke.push([x[0], best]);
  for (let i = 0; i < y.length; i += 1) {
    if (Number.isFinite(y[i])) dots.push([x[i], y[i]]);
    if (y[i] < best) {
      if (best < Infinity) stroke.push([x[i], best]);
      best = y[i];
      stroke.push([x[i], best]);
    }
  }
  if (best < Infinity) stroke.push([x[x.length - 1], best]);
  return { strokes: [stroke], bands: [], dots, resolved: true };
}
