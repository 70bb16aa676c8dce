/**
 * Arrangement of a figure's lines: constants as text, and the others in plots one below the other,
 * so that no line is squashed by a larger one.
 */
import { number } from "../format";
import type { Figure, Line } from "./lines";
import { extent, type Unit, unitFor } from "./scale";

/** Largest relative variation of a constant line. */
const CONSTANT = 1e-6;

/** Fraction of a plot's height below which a line counts as squashed. */
const SQUASHED = 1 / 20;

/** Fraction of the largest value on an axis below which a line counts as small. */
const SMALL = 1 / 8;

/** Maximum number of plots of a figure. */
const MOST_STACKS = 3;

/** Relative variation below which a round number is subtracted from the values. */
const OFFSET = 2e-5;

/** Range above which angles are shown in turns, °. */
const IN_TURNS = 1440;

export interface Constant {
  symbol: string;
  /** Value in the figure's unit. */
  value: number;
  /** Variation, relative; absolute for a value of zero. */
  drift: number;
  /** True if there is only one sample, which cannot show that the value is constant. */
  single: boolean;
}

/** Lines that share an axis. */
export interface Stack {
  /** Lines with values of the axis: (value − offset) / unit. */
  lines: Line[];
  unit: Unit;
  /** Offset, in `unit`. */
  offset: number;
  /** The offset as text: "c = −2.9431 J"; empty without one. */
  less: string;
  /** Unit after the readings; empty for numbers without one. */
  readingUnit: string;
  /** Title of the vertical axis: "ωx, ωy (rad/s)", "E − c (µJ)". */
  title: string;
  /** Digits of a reading, enough to resolve a hundredth of the axis. */
  figures: number;
  /** Range of the values over the whole run. */
  range: [number, number] | null;
}

export interface Arranged {
  constants: Constant[];
  stacks: Stack[];
}

export function arrange(figure: Figure): Arranged {
  const constants: Constant[] = [];
  const drawn: Line[] = [];
  for (const line of figure.lines) {
    const constant = constantOf(line, figure);
    if (constant) constants.push(constant);
    else drawn.push(line);
  }
  const groups = figure.log ? (drawn.length > 0 ? [drawn] : []) : split(drawn, figure.telling);
  return { constants, stacks: groups.map((lines) => stackOf(lines, figure)) };
}

/** Returns the constant of a line; null for a line that varies. */
export function constantOf({ symbol, values, drift }: Line, figure: Pick<Figure, "log" | "nothing" | "telling">): Constant | null {
  const range = extent([values], 0, figure.telling - 1);
  // A line with gaps is not constant.
  if (range === null || !areFinite(values)) return null;
  const single = values.length === 1;
  const size = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  if (size <= (figure.log ? 0 : figure.nothing)) return { symbol, value: 0, drift: size, single };
  const spread = (range[1] - range[0]) / size;
  if (figure.log || !(spread < CONSTANT)) return null;
  return { symbol, value: values[0], drift: drift ?? spread, single };
}

function areFinite(values: Float64Array): boolean {
  for (let i = 0; i < values.length; i += 1) if (!Number.isFinite(values[i])) return false;
  return true;
}

/**
 * Returns sentences such as "ωx = ωy = 0" or "T + U = 3.73784 J, constant to 6.8×10⁻¹⁷": one for
 * each constant, and one for all zeros. If samples may miss an oscillation, the sentences only
 * state the samples.
 */
export function sentences(constants: readonly Constant[], { log, unit, aliased, quantity: name }: Pick<Figure, "log" | "unit" | "aliased" | "quantity">): string[] {
  const zeros = constants.filter(({ value }) => value === 0);
  if (log) return zeros.map(({ symbol }) => `${name} of ${symbol}: 0 in every sample`);
  const words: string[] = [];
  if (zeros.length > 0) {
    const largest = Math.max(...zeros.map(({ drift }) => drift));
    words.push(`${zeros.map(({ symbol }) => symbol).join(" = ")} = 0${largest > 0 ? ` to ${quantity(largest, unit, 2)}` : ""}${aliased ? " at all samples" : ""}`);
  }
  for (const { symbol, value, drift, single } of constants) {
    if (value === 0) continue;
    const stays = `, ${aliased ? "the same at all samples" : "constant"} to ${drift > 0 ? number(drift, 2) : "the last bit"}`;
    words.push(`${symbol} = ${quantity(value, unit, 6)}${single ? "" : stays}`);
  }
  return words;
}

/** Formats a quantity without line breaks: "3.73784 mJ", "7.79080×10⁻⁴ kg·m²/s", "30°". */
export function quantity(value: number, unit: string, figures: number): string {
  const fit = unitFor(unit, Math.abs(value));
  // A power of ten belongs to the number here.
  const { name, size } = fit.name.startsWith("10") ? { name: unit, size: 1 } : fit;
  return `${number(value / size, figures)}${name === "°" ? "" : "\u00a0"}${name}`;
}

/**
 * Distributes lines over axes, in order. A line joins the first axis whose lines have a
 * similar size and are not squashed by it, nor it by them.
 */
export function split(lines: readonly Line[], telling = Infinity): Line[][] {
  const ranges = new Map(lines.map((line) => [line, extent([line.values], 0, telling - 1)]));
  const span = (all: readonly Line[]): number => {
    let [low, high] = [Infinity, -Infinity];
    for (const line of all) {
      const range = ranges.get(line);
      if (range) [low, high] = [Math.min(low, range[0]), Math.max(high, range[1])];
    }
    return low <= high ? high - low : 0;
  };
  // Returns the fraction of the common range that the flattest line takes.
  const flattest = (all: readonly Line[]): number => {
    const common = span(all);
    return common > 0 ? Math.min(...all.map((line) => span([line]) / common)) : 1;
  };
  // Returns the ratio of the largest values of the smallest and the largest line.
  const smallest = (all: readonly Line[]): number => {
    const sizes = all.map((line) => Math.max(...(ranges.get(line) ?? [0]).map(Math.abs)));
    return Math.min(...sizes) / Math.max(...sizes);
  };
  const fit = (all: readonly Line[]): boolean => flattest(all) >= SQUASHED && smallest(all) >= SMALL;
  const groups: Line[][] = [];
  for (const line of lines) {
    const fits = groups.find((group) => !line.alone && !group[0].alone && fit([...group, line]));
    if (fits) fits.push(line);
    else if (groups.length < MOST_STACKS) groups.push([line]);
    else {
      const best = groups.map((group) => (group[0].alone ? -1 : flattest([...group, line])));
      groups[best.indexOf(Math.max(...best))].push(line);
    }
  }
  return groups;
}

/** Returns the number of digits of a number in steps of `round`. */
function digits(value: number, round: number): number {
  return Math.max(Math.floor(Math.log10(Math.abs(value))) - Math.round(Math.log10(round)) + 1, 1);
}

function stackOf(lines: Line[], figure: Figure): Stack {
  const range = extent(lines.map(({ values }) => values), 0, figure.telling - 1) ?? [0, 0];
  const size = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  const spread = range[1] - range[0];
  const symbols = lines.map(({ symbol }) => symbol);
  const name = lines.length === 1 && !figure.log ? symbols[0] : figure.quantity;
  if (figure.log) {
    const unit = { name: figure.unit, size: 1 };
    return { lines, unit, offset: 0, less: "", title: `${name} (${unit.name})`, readingUnit: unit.name === "relative" ? "" : unit.name, figures: 2, range };
  }
  const shifted = spread > 0 && spread < OFFSET * size;
  const turns = figure.unit === "°" && spread > IN_TURNS;
  const unit = turns ? { name: "turns", size: 360 } : unitFor(figure.unit, shifted ? spread : size);
  // Round to the next digit above the spread.
  const round = 10 ** Math.ceil(Math.log10(spread / unit.size));
  const offset = shifted ? Math.floor(range[0] / unit.size / round) * round : 0;
  const less = offset === 0 ? "" : `c = ${quantity(offset * unit.size, figure.unit, digits(offset, round))}`;
  const asItIs = unit.size === 1 && offset === 0;
  return {
    lines: asItIs ? lines : lines.map((line) => ({ ...line, values: line.values.map((v) => v / unit.size - offset) })),
    unit,
    offset,
    less,
    title: `${name}${less === "" ? "" : " − c"} (${unit.name})`,
    readingUnit: unit.name.replace(/^10/, "×10"),
    figures: Math.min(Math.max(Math.ceil(Math.log10(size / spread)) + 3, 5), 12),
    range: [range[0] / unit.size - offset, range[1] / unit.size - offset],
  };
}
