/**
 * A figure as an SVG file for printing, with the same constants, stacks, envelopes and letters as
 * on the screen.
 */
import { mark, number, powerOfTen, timeUnit } from "../format";
import { type Arranged, sentences, type Stack } from "./arrange";
import { curve, largestSoFar } from "./curve";
import { type Box, type Mark, svgText, textWidth, through, wrapped } from "./drawing";
import { labels, type Marked, marksOf } from "./events";
import type { Figure } from "./lines";
import { type Band, STRENGTH } from "./phases";
import { decades, extent, logRange, padded, ticks } from "./scale";

const WIDTH = 640;
const FRAME = { left: 76, right: 16, alone: 262, stacked: 150 };
const INNER = WIDTH - FRAME.left - FRAME.right;
const LINE = 18;
/** Font size of notes, px. */
const SMALL = 11.5;

/** Makes the file of a figure from `from` to `to`, s, the zoomed interval. */
export function svgOf(
  figure: Figure,
  { constants, stacks }: Arranged,
  times: Float64Array,
  from: number,
  to: number,
  events: readonly Marked[] = [],
  bands: readonly Band[] = [],
): string {
  const marks: Mark[] = [];
  const unit = timeUnit(Math.max(Math.abs(from), Math.abs(to)));
  let top = 26 - LINE;
  const write = (text: string, size?: number, ink?: string): void => {
    for (const row of wrapped(text, INNER, size)) {
      top += LINE;
      marks.push({ kind: "text", at: [FRAME.left, top], text: row, ...(size ? { size } : {}), ...(ink ? { ink } : {}) });
    }
  };
  write(figure.title, 15);
  for (const text of [...sentences(constants, figure), ...(figure.note ? [figure.note] : [])]) write(text);
  const named = events.map(({ letter, name, times }) => ({ letter, name, times: times.filter((t) => t >= from && t <= to) }));
  const seen = named.filter(({ times }) => times.length > 0);
  const x = (t: number): number => FRAME.left + ((t - from) / (to - from || 1)) * INNER;
  const first = Math.max(times.findIndex((t) => t >= from) - 1, 0);
  const after = times.findIndex((t) => t > to);
  const range: [number, number] = [first, after < 0 ? times.length - 1 : after];
  stacks.forEach((stack, k) => {
    top += LINE + 8;
    top = key(marks, stack, top);
    const curves = curvesOf(figure, stack, times, range, x, stacks.length === 1 ? FRAME.alone : FRAME.stacked);
    if (curves.said) write(curves.said, SMALL, "quiet");
    const lettered = k === 0 && seen.length > 0;
    top += lettered ? 26 : 10;
    const box = { left: FRAME.left, top, width: INNER, height: curves.height };
    for (const { from: begin, to: end, ink } of bands) {
      const [a, b] = [x(Math.max(begin, from)), x(Math.min(end, to))];
      const corners: [number, number][] = [[a, top], [b, top], [b, top + box.height], [a, top + box.height]];
      if (b > a) marks.push({ kind: "path", d: `${through(corners)}Z`, fill: ink, opacity: STRENGTH });
    }
    const isLast = k === stacks.length - 1;
    for (const value of ticks(from / unit.seconds, to / unit.seconds, 7).values) {
      const at = x(value * unit.seconds);
      marks.push({ kind: "path", d: through([[at, top], [at, top + box.height]]), ink: "grid" });
    }
    curves.draw(marks, box);
    const all = marksOf(seen);
    const places = all.map(({ time }) => x(time));
    const texts = labels(places, all.map(({ letter }) => letter), 11);
    places.forEach((at, j) => {
      marks.push({ kind: "path", d: through([[at, top], [at, top + box.height]]), ink: "quiet", dash: [2, 3] });
      if (lettered && texts[j]) marks.push({ kind: "text", at: [at, top - 5], text: texts[j], anchor: "middle", size: 11.5 });
    });
    const frame: [number, number][] = [[box.left, top], [box.left + INNER, top], [box.left + INNER, top + box.height], [box.left, top + box.height]];
    marks.push({ kind: "path", d: `${through(frame)}Z`, ink: "ink" });
    top += box.height;
    if (!isLast) return;
    const { values, step } = ticks(from / unit.seconds, to / unit.seconds, 7);
    for (const value of values) {
      marks.push({ kind: "text", at: [x(value * unit.seconds), top + 18], text: mark(value, step), anchor: "middle" });
    }
    top += 38;
    marks.push({ kind: "text", at: [FRAME.left + INNER / 2, top], text: `time t (${unit.name})`, anchor: "middle" });
  });
  for (const { letter, name, times } of seen) {
    const at = `${number(times[0] / unit.seconds, 4)} ${unit.name}`;
    const when = times.length > 1 ? `${times.length} ×, first at ${at}` : `at ${at}`;
    write(`${letter}  ${name}, ${when}`, SMALL);
  }
  return svgText(marks, WIDTH, top + 14);
}

/**
 * Draws swatches with the lines' names and the subtracted offset, in as many rows as necessary;
 * returns the height of the last row.
 */
function key(marks: Mark[], stack: Stack, y: number): number {
  let left = FRAME.left;
  const place = (wide: number): number => {
    if (left > FRAME.left && left + wide > FRAME.left + INNER) [left, y] = [FRAME.left, y + LINE];
    left += wide + 22;
    return left - wide - 22;
  };
  for (const { label, ink, dash } of stack.lines) {
    const rows = wrapped(label, INNER - 30);
    rows.forEach((text, k) => {
      const x = place(30 + textWidth(text, 12.5));
      if (k === 0) marks.push({ kind: "path", d: through([[x, y - 4], [x + 24, y - 4]]), ink, width: 2, dash });
      marks.push({ kind: "text", at: [x + 30, y], text });
    });
  }
  if (stack.less !== "") {
    const x = place(textWidth(stack.less, 12.5));
    marks.push({ kind: "text", at: [x, y], text: stack.less });
  }
  return y;
}

/** Draws the lines in a frame of this height, and returns which of them are envelopes. */
function curvesOf(
  { log, unit, telling }: Figure,
  stack: Stack,
  times: Float64Array,
  [first, last]: [number, number],
  x: (t: number) => number,
  height: number,
): { said: string; height: number; draw: (marks: Mark[], box: Box) => void } {
  const values = stack.lines.map((line) => line.values);
  // Include the largest value before the visible interval.
  const seen = extent(values, log ? 0 : first, Math.min(last, telling - 1));
  const full = stack.range ?? [0, 1];
  const [low, high] = log ? logRange(stack.lines, seen?.[1] || 1) : padded(seen, 1e-3 * (full[1] - full[0]));
  const level = log ? Math.log10 : (v: number): number => v;
  // Height above the lower edge of the frame, px.
  const y = (v: number): number => -((level(v) - level(low)) / (level(high) - level(low))) * height;
  const curves = stack.lines.map(({ values, ink, dash, starts, symbol }) => {
    const along = times.subarray(first, last + 1).map(x);
    const up = values.subarray(first, last + 1).map((v) => (log && v <= 0 ? Number.NaN : y(v)));
    const before = log && first > 0 ? extent([values], 0, first - 1)?.[1] : 0;
    const made = log ? largestSoFar(along, up, before ? y(before) : Infinity) : curve(along, up, starts?.subarray(first, last + 1));
    return { made, ink, dash, symbol };
  });
  const of = (resolved: boolean): string =>
    curves.filter(({ made }) => made.bands.length > 0 && made.resolved === resolved).map(({ symbol }) => symbol).join(", ");
  const [envelopes, ranges] = [of(true), of(false)];
  const said = [...(envelopes ? [`${envelopes}: envelope`] : []), ...(ranges ? [`${ranges}: not resolved by the samples, their range`] : [])].join("; ");
  const draw = (marks: Mark[], box: Box): void => {
    const bottom = box.top + box.height;
    const marksUp = ticks(low, high, box.height / 42, unit === "°" && stack.unit.size === 1);
    for (const value of log ? decades(low, high, 7) : marksUp.values) {
      marks.push({ kind: "path", d: through([[box.left, bottom + y(value)], [box.left + box.width, bottom + y(value)]]), ink: "grid" });
      const text = log ? powerOfTen(value) : mark(value, marksUp.step);
      marks.push({ kind: "text", at: [box.left - 8, bottom + y(value) + 4], text, anchor: "end" });
    }
    marks.push({ kind: "text", at: [16, box.top + box.height / 2], text: stack.title, anchor: "middle", upright: true });
    const placed = (points: [number, number][]): [number, number][] => points.map(([px, py]) => [px, bottom + py]);
    for (const { made, ink, dash } of curves) {
      for (const points of made.bands) marks.push({ kind: "path", d: `${through(placed(points))}Z`, fill: ink, opacity: 0.19, box });
      const dots = placed(made.dots).map(([px, py]) => `M${px.toFixed(1)} ${py.toFixed(1)}h1v1h-1z`).join("");
      if (dots) marks.push({ kind: "path", d: dots, fill: ink, opacity: 0.3, box });
      marks.push({ kind: "path", d: made.strokes.map((points) => through(placed(points))).join(""), ink, width: 1.6, dash, box });
    }
  };
  return { said, height, draw };
}
