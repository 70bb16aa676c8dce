/** Units, ranges and ticks of an axis. */
import { superscript } from "../format";

/** A unit, and its size in the figure's own unit. */
export interface Unit {
  name: string;
  size: number;
}

/** SI prefixes in use with a unit, with the size of their unit. */
const PREFIXES: Record<string, [prefix: string, size: number][]> = {
  J: [["p", 1e-12], ["n", 1e-9], ["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3], ["M", 1e6]],
  "N·m": [["p", 1e-12], ["n", 1e-9], ["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3], ["M", 1e6]],
  N: [["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3]],
  m: [["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3]],
  "rad/s": [["µ", 1e-6], ["m", 1e-3], ["", 1]],
};

/**
 * Returns the unit in which a value of this size is a number from 0.1 to 10⁴: with an SI prefix in
 * use, or with a power of ten.
 */
export function unitFor(name: string, size: number): Unit {
  if (name === "°" || (size >= 0.1 && size < 1e4) || !(size > 0) || !Number.isFinite(size)) return { name, size: 1 };
  const prefixes = PREFIXES[name];
  const fit = prefixes?.filter(([, prefix]) => size >= 0.1 * prefix).at(-1);
  if (fit && size < 1e5 * fit[1]) return { name: fit[0] + name, size: fit[1] };
  if (size >= 0.1 && size < 1e5) return { name, size: 1 };
  const exponent = 3 * Math.floor(Math.log10(size) / 3 + 1e-12);
  return exponent === 0 ? { name, size: 1 } : { name: `10${superscript(exponent)} ${name}`, size: 10 ** exponent };
}

/**
 * Returns the least and the greatest of the finite values in an interval; null if there are none.
 */
export function extent(rows: ArrayLike<number>[], first = 0, last = Infinity): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const values of rows) {
    for (let i = Math.max(first, 0); i <= Math.min(last, values.length - 1); i += 1) {
      if (!Number.isFinite(values[i])) continue;
      low = Math.min(low, values[i]);
      high = Math.max(high, values[i]);
    }
  }
  return low <= high ? [low, high] : null;
}

/**
 * Adds space at both ends. The range is at least `least`, because otherwise rounding errors would
 * fill the plot.
 */
export function padded(range: [number, number] | null, least = 0): [number, number] {
  if (range === null) return [0, 1];
  const [low, high] = range;
  const size = Math.max(Math.abs(low), Math.abs(high));
  const span = Math.max(high - low, least, 1e-9 * size);
  if (span === 0) return [-1, 1];
  const middle = (low + high) / 2;
  return [middle - 0.56 * span, middle + 0.56 * span];
}

/** Returns powers of ten around the largest value so far of each line, up to `high`. */
export function logRange(lines: readonly { values: Float64Array }[], high: number): [number, number] {
  const firsts = lines.map(({ values }) => values.find((v) => v > 0) ?? Infinity);
  // Values below the rounding error of a number have no meaning.
  const from = Math.floor(Math.log10(Math.min(Math.max(Math.min(...firsts), 1e-17), high)));
  return [10 ** from, 10 ** Math.max(Math.ceil(Math.log10(high)), from + 1)];
}

/** Returns about `count` powers of ten between two of them. */
export function decades(low: number, high: number, count: number): number[] {
  const [from, to] = [Math.round(Math.log10(low)), Math.round(Math.log10(high))];
  const every = Math.max(Math.ceil((to - from) / Math.max(count, 1)), 1);
  const out: number[] = [];
  for (let k = from; k <= to; k += every) out.push(10 ** k);
  return out;
}

/**
 * Returns about `count` ticks in steps of 1, 2 or 5 times a power of ten; for angles over a wide
 * range, in steps of 15°, 30°, ….
 */
export function ticks(low: number, high: number, count: number, degrees = false): { values: number[]; step: number } {
  const rough = (high - low) / Math.max(count, 1);
  const decade = 10 ** Math.floor(Math.log10(rough));
  const mantissa = rough / decade;
  // Choose the nearest step by ratio: the border between two steps is their geometric mean.
  let step = decade * (mantissa ** 2 < 2 ? 1 : mantissa ** 2 < 10 ? 2 : mantissa ** 2 < 50 ? 5 : 10);
  if (degrees && rough > 10) step = [15, 30, 45, 90, 180].find((d) => d >= rough) ?? 360 * Math.ceil(rough / 360);
  const values: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) values.push(k * step + 0);
  return { values, step };
}
