/**
 * Envelopes. Where a line oscillates so often that it would fill its plot with stripes, its
 * envelope is drawn: the local minima and maxima. Places are in pixels, so that zooming in restores
 * the line.
 */

import { indexAt } from "../clock";

/** Distance of neighbouring extrema below which a line counts as stripes, px. */
export const NEAREST = 4;

/** Smallest oscillation that counts, px. */
const LEAST_SWING = 3;

/** Least number of samples between extrema for a resolved line. */
const RESOLVED = 2.5;

/**
 * Length of the chords of an edge, px. Where extrema alternate, as with two frequencies, the edge
 * goes from one of the outer extrema to the next.
 */
const CHORD = 32;

/** Number of swings that make a span. Fewer are drawn as they are. */
const FEWEST = 8;

/** Envelope of a line between two of its points: the edges through its outer minima and maxima. */
export interface Span {
  first: number;
  last: number;
  low: [number, number][];
  high: [number, number][];
  /**
   * False if the samples do not resolve the oscillation. The edges then go through the outer
   * samples.
   */
  resolved: boolean;
}

/** Returns the extrema of y from `first` to `last`, each at least `swing` from the next. */
export function extrema(y: ArrayLike<number>, first: number, last: number, swing: number): number[] {
  const found: number[] = [];
  let [low, high] = [first, first];
  // Direction: 1 rising, −1 falling, 0 unknown yet.
  let sense = 0;
  for (let i = first + 1; i <= last; i += 1) {
    if (y[i] > y[high]) high = i;
    if (y[i] < y[low]) low = i;
    if (sense >= 0 && y[high] - y[i] >= swing) {
      found.push(high);
      [sense, low, high] = [-1, i, i];
    } else if (sense <= 0 && y[i] - y[low] >= swing) {
      found.push(low);
      [sense, low, high] = [1, i, i];
    }
  }
  return found;
}

/**
 * Returns the spans of a line that are drawn as envelopes. Points that are not finite, and those in
 * `starts`, interrupt it.
 */
export function envelopes(x: ArrayLike<number>, y: ArrayLike<number>, starts?: ArrayLike<number>): Span[] {
  const spans: Span[] = [];
  for (let first = 0; first < y.length; ) {
    if (!Number.isFinite(y[first])) {
      first += 1;
      continue;
    }
    let last = first;
    while (last + 1 < y.length && Number.isFinite(y[last + 1]) && !starts?.[last + 1]) last += 1;
    spans.push(...envelopesOfPiece(x, y, first, last));
    first = last + 1;
  }
  return spans;
}

function envelopesOfPiece(x: ArrayLike<number>, y: ArrayLike<number>, first: number, last: number): Span[] {
  const at = extrema(y, first, last, LEAST_SWING);
  const swings = at.length - 1;
  const mean = (k: number, of: (k: number) => number): number => {
    const [from, to] = [Math.max(k - 2, 0), Math.min(k + 2, swings - 1)];
    let sum = 0;
    for (let j = from; j <= to; j += 1) sum += of(j);
    return sum / (to - from + 1);
  };
  const width = (k: number): number => x[at[k + 1]] - x[at[k]];
  const samples = (k: number): number => at[k + 1] - at[k];
  const dense = (k: number): boolean => mean(k, width) < NEAREST || mean(k, samples) < RESOLVED;
  const spans: Span[] = [];
  for (let k = 0; k < swings; ) {
    let end = k;
    while (end < swings && dense(end)) end += 1;
    if (end - k >= FEWEST) {
      // Extend to the end of the line if that is within a swing.
      const from = k === 0 && x[at[0]] - x[first] < 2 * NEAREST ? first : at[k];
      const to = end === swings && x[last] - x[at[end]] < 2 * NEAREST ? last : at[end];
      spans.push(span(x, y, at, k, end, from, to));
    }
    k = end + 1;
  }
  return spans;
}

/**
 * Makes the span of the swings from `k` to `end`, through the extrema; if the samples miss these,
 * through the samples.
 */
function span(x: ArrayLike<number>, y: ArrayLike<number>, at: number[], k: number, end: number, first: number, last: number): Span {
  const made: Span = { first, last, low: [], high: [], resolved: samplesPerSwing(y, first, last) >= RESOLVED };
  if (!made.resolved) {
    const all = Array.from({ length: last - first + 1 }, (_, i): [number, number] => [x[first + i], y[first + i]]);
    return { ...made, low: outer(all, -1), high: outer(all, 1) };
  }
  const turns = at.slice(k, end + 1);
  const isHigh = (j: number): boolean => y[turns[j]] > y[turns[j === 0 ? 1 : j - 1]];
  for (const [side, sense] of [["low", -1], ["high", 1]] as const) {
    const own = turns.filter((_, j) => isHigh(j) === sense > 0);
    // The first point of a line may be between extrema. It is not an extremum then.
    if (own.length > 2 && own[0] === first) own.shift();
    // The line may go farther before the first extremum and after the last, because its last swing
    // has not reversed.
    const [head, tail] = [farthest(y, first, own[0], sense), farthest(y, own[own.length - 1], last, sense)];
    if (head !== own[0]) own.unshift(head);
    if (tail !== own[own.length - 1]) own.push(tail);
    const edge = own.map((i): [number, number] => [x[i], vertex(y, i, first, last, at, sense)]);
    edge.unshift([x[first], edge[0][1]]);
    edge.push([x[last], edge[edge.length - 1][1]]);
    made[side] = outer(edge, sense);
  }
  return made;
}

/**
 * Returns the points of an edge with none beyond it: from each, the next is the one within a chord
 * to which the edge is steepest outwards.
 */
function outer(points: readonly [number, number][], sense: 1 | -1): [number, number][] {
  const out = [points[0]];
  for (let i = 0; i < points.length - 1; ) {
    const [x, y] = points[i];
    const slope = (j: number): number => (sense * (points[j][1] - y)) / Math.max(points[j][0] - x, 1e-9);
    let next = i + 1;
    for (let j = i + 2; j < points.length && points[j][0] - x <= CHORD; j += 1) if (slope(j) >= slope(next)) next = j;
    out.push(points[next]);
    i = next;
  }
  return out;
}

/** Returns the index of the greatest y in an interval, or of the least for −1. */
function farthest(y: ArrayLike<number>, from: number, to: number, sense: 1 | -1): number {
  let found = from;
  for (let i = from; i <= to; i += 1) if (sense * y[i] > sense * y[found]) found = i;
  return found;
}

/**
 * Estimates the extremum near sample i, the farthest of three samples, from the sine y = m + A
 * cos(h k − d) through them:
 *
 * A sin d = (y₊ − y₋)/(2 sin h), A cos d = (2 y₀ − y₊ − y₋)/(2 (1 − cos h)). h is the mean of the
 * surrounding swings.
 */
function vertex(y: ArrayLike<number>, i: number, first: number, last: number, at: number[], sense: 1 | -1): number {
  const [before, after] = [sense * (y[i] - y[i - 1]), sense * (y[i] - y[i + 1])];
  if (i <= first || i >= last || before < 0 || after < 0) return y[i];
  const j = indexAt(at, i);
  const [from, to] = [Math.max(j - 3, 0), Math.min(j + 3, at.length - 1)];
  const h = (Math.PI * (to - from)) / (at[to] - at[from]);
  const sine = (before - after) / (2 * Math.sin(h));
  const cosine = (before + after) / (2 * (1 - Math.cos(h)));
  return y[i] + sense * (Math.hypot(sine, cosine) - cosine);
}

/**
 * Returns the number of samples per swing, for swings of at least a fiftieth of the range,
 * independent of the scale.
 */
function samplesPerSwing(y: ArrayLike<number>, first: number, last: number): number {
  let [low, high] = [Infinity, -Infinity];
  for (let i = first; i <= last; i += 1) {
    low = Math.min(low, y[i]);
    high = Math.max(high, y[i]);
  }
  return (last - first) / Math.max(extrema(y, first, last, 0.02 * (high - low)).length, 1);
}
