/** A figure as an SVG file: the same constants, stacks, envelopes and letters as on the screen, for paper. */
import { mark, number, powerOfTen, timeUnit } from "../format";
import { type Arranged, sentences, type Stack } from "./arrange";
import { curve, largestSoFar } from "./curve";
import { type Box, type Mark, svgText, through } from "./drawing";
import { labels, type Marked, marksOf } from "./events";
import type { Figure } from "./lines";
import { decades, extent, logRange, padded, ticks } from "./scale";

const WIDTH = 640;
const FRAME = { left: 76, right: 16, alone: 262, stacked: 150 };
const LINE = 18;

/** From `from` to `to`, s: what is zoomed to. */
export function svgOf(
  figure: Figure,
  { constants, stacks }: Arranged,
  times: Float64Array,
  from: number,
  to: number,
  events: readonly Marked[] = [],
): string {
  const marks: Mark[] = [];
  const unit = timeUnit(Math.max(Math.abs(from), Math.abs(to)));
  let top = 26;
  marks.push({ kind: "text", at: [FRAME.left, top], text: figure.title, size: 15 });
  for (const text of [...sentences(constants, figure), ...(figure.note ? [figure.note] : [])]) {
    top += LINE;
    marks.push({ kind: "text", at: [FRAME.left, top], text });
  }
  const named = events.map(({ letter, name, times }) => ({ letter, name, times: times.filter((t) => t >= from && t <= to) }));
  const seen = named.filter(({ times }) => times.length > 0);
  const width = WIDTH - FRAME.left - FRAME.right;
  const x = (t: number): number => FRAME.left + ((t - from) / (to - from || 1)) * width;
  const first = Math.max(times.findIndex((t) => t >= from) - 1, 0);
  const after = times.findIndex((t) => t > to);
  const range: [number, number] = [first, after < 0 ? times.length - 1 : after];
  stacks.forEach((stack, k) => {
    top += LINE + 8;
    const tag = key(marks, stack, top);
    const lettered = k === 0 && seen.length > 0;
    top += lettered ? 26 : 10;
    const box = { left: FRAME.left, top, width, height: stacks.length === 1 ? FRAME.alone : FRAME.stacked };
    const isLast = k === stacks.length - 1;
    for (const value of ticks(from / unit.seconds, to / unit.seconds, 7).values) {
      const at = x(value * unit.seconds);
      marks.push({ kind: "path", d: through([[at, top], [at, top + box.height]]), ink: "grid" });
    }
    const said = lines(marks, figure, stack, times, range, x, box);
    if (said) marks.push({ kind: "text", at: [tag, top - (lettered ? 26 : 10)], text: said, ink: "quiet", size: 11.5 });
    const all = marksOf(seen);
    const places = all.map(({ time }) => x(time));
    const texts = labels(places, all.map(({ letter }) => letter), 11);
    places.forEach((at, j) => {
      marks.push({ kind: "path", d: through([[at, top], [at, top + box.height]]), ink: "quiet", dash: [2, 3] });
      if (lettered && texts[j]) marks.push({ kind: "text", at: [at, top - 5], text: texts[j], anchor: "middle", size: 11.5 });
    });
    const frame: [number, number][] = [[box.left, top], [box.left + width, top], [box.left + width, top + box.height], [box.left, top + box.height]];
    marks.push({ kind: "path", d: `${through(frame)}Z`, ink: "ink" });
    top += box.height;
    if (!isLast) return;
    const { values, step } = ticks(from / unit.seconds, to / unit.seconds, 7);
    for (const value of values) {
      marks.push({ kind: "text", at: [x(value * unit.seconds), top + 18], text: mark(value, step), anchor: "middle" });
    }
    top += 38;
    marks.push({ kind: "text", at: [FRAME.left + width / 2, top], text: `time t (${unit.name})`, anchor: "middle" });
  });
  for (const { letter, name, times } of seen) {
    top += LINE;
    const at = `${number(times[0] / unit.seconds, 4)} ${unit.name}`;
    const when = times.length > 1 ? `${times.length} ×, first at ${at}` : `at ${at}`;
    marks.push({ kind: "text", at: [FRAME.left, top], text: `${letter}  ${name}, ${when}`, size: 11.5 });
  }
  return svgText(marks, WIDTH, top + 14);
}

/** Swatches with the lines' names; gives where it ends. */
function key(marks: Mark[], stack: Stack, y: number): number {
  let left = FRAME.left;
  for (const { label, ink, dash } of stack.lines) {
    marks.push({ kind: "path", d: through([[left, y - 4], [left + 24, y - 4]]), ink, width: 2, dash });
    marks.push({ kind: "text", at: [left + 30, y], text: label });
    left += 52 + 7.2 * label.length;
  }
  return left;
}

/** The vertical axis and the lines; says what is an envelope. */
function lines(
  marks: Mark[],
  { log, unit, telling }: Figure,
  stack: Stack,
  times: Float64Array,
  [first, last]: [number, number],
  x: (t: number) => number,
  box: Box,
): string {
  const values = stack.lines.map((line) => line.values);
  const seen = extent(values, first, Math.min(last, telling - 1));
  const full = stack.range ?? [0, 1];
  const [low, high] = log ? logRange(stack.lines, seen?.[1] ?? 1) : padded(seen, 1e-3 * (full[1] - full[0]));
  const level = log ? Math.log10 : (v: number): number => v;
  const bottom = box.top + box.height;
  const y = (v: number): number => bottom - ((level(v) - level(low)) / (level(high) - level(low))) * box.height;
  const marksUp = ticks(low, high, box.height / 42, unit === "°" && stack.unit.size === 1);
  for (const value of log ? decades(low, high, 7) : marksUp.values) {
    marks.push({ kind: "path", d: through([[box.left, y(value)], [box.left + box.width, y(value)]]), ink: "grid" });
    const text = log ? powerOfTen(value) : mark(value, marksUp.step);
    marks.push({ kind: "text", at: [box.left - 8, y(value) + 4], text, anchor: "end" });
  }
  marks.push({ kind: "text", at: [16, box.top + box.height / 2], text: stack.title, anchor: "middle", upright: true });
  const said: { symbol: string; resolved: boolean }[] = [];
  for (const { values, ink, dash, starts, symbol } of stack.lines) {
    const along = times.subarray(first, last + 1).map(x);
    const up = values.subarray(first, last + 1).map((v) => (log && v <= 0 ? Number.NaN : y(v)));
    const made = log ? largestSoFar(along, up) : curve(along, up, starts?.subarray(first, last + 1));
    if (made.bands.length > 0) said.push({ symbol, resolved: made.resolved });
    for (const points of made.bands) marks.push({ kind: "path", d: `${through(points)}Z`, fill: ink, opacity: 0.19, box });
    const dots = made.dots.map(([px, py]) => `M${px.toFixed(1)} ${py.toFixed(1)}h1v1h-1z`).join("");
    if (dots) marks.push({ kind: "path", d: dots, fill: ink, opacity: 0.3, box });
    marks.push({ kind: "path", d: made.strokes.map(through).join(""), ink, width: 1.6, dash, box });
  }
  const of = (resolved: boolean): string => said.filter((one) => one.resolved === resolved).map(({ symbol }) => symbol).join(", ");
  const [envelopes, ranges] = [of(true), of(false)];
  return [...(envelopes ? [`${envelopes}: envelope`] : []), ...(ranges ? [`${ranges}: not resolved by the samples, their range`] : [])].join("; ");
}
