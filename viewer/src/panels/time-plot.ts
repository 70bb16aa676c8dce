/**
 * A plot over time: the lines of a stack, its legend with readings, its axes, the time of the view,
 * and the events.
 */
import uPlot from "uplot";
import type { Phase } from "../contact";
import { element } from "../dom";
import { mark, number, powerOfTen } from "../format";
import type { Stack } from "../plot/arrange";
import { curve, largestSoFar } from "../plot/curve";
import { envelopes } from "../plot/envelope";
import { labels, type Mark, type Marked } from "../plot/events";
import type { Figure, Line } from "../plot/lines";
import { type Band, STRENGTH } from "../plot/phases";
import { decades, extent, logRange, padded, ticks } from "../plot/scale";
import { ink } from "../theme";

/** Data that all figures of a motion share. */
export interface Shared {
  times: Float64Array;
  unit: { name: string; seconds: number };
  marked: readonly Marked[];
  /** Phases of a body on the ground. */
  phases: readonly Phase[];
  /** Size of the type, relative to that of the page. */
  size: number;
  /** Name of saved files. */
  file: string;
}

/** Heights of the frame and of the areas around it, px. */
const FRAME = { alone: 126, stacked: 104 };
const ABOVE = { plain: 6, lettered: 17 };
const BELOW = { numbers: 20, title: 17, bare: 5 };
const LEFT = 66;
const LETTER = 11;

/** Distance below which points of a line are merged, px. */
const NEAR = 0.6;

export interface Place {
  /** True if the plot shows the letters of the events. */
  isFirst: boolean;
  /** True if the plot shows the numbers of the time axis. */
  isLast: boolean;
}

export class TimePlot {
  readonly plot: uPlot;
  readonly host: HTMLElement;
  readonly #place: Place;
  readonly #unit: { name: string; seconds: number };
  /** Size of the type, relative to that of the page. */
  readonly #size: number;
  readonly #title = element("div", { class: "axis-title y" });
  readonly #less = element("span", { class: "less" });
  readonly #readingUnit = element("span", { class: "unit" });
  #figure: Figure;
  #stack: Stack;
  #marks: readonly Mark[];
  #bands: readonly Band[];
  readonly #now = element("div", { class: "now" });
  readonly #events: HTMLElement[];
  readonly #readings: HTMLElement[];
  readonly #tag = element("span", { class: "tag", hidden: true });
  /** For each line: true if it is drawn as an envelope, and if its samples resolve it. */
  readonly #drawn: { enveloped: boolean; resolved: boolean }[];

  constructor(figure: Figure, stack: Stack, { times, unit, size }: Pick<Shared, "times" | "unit" | "size">, marks: readonly Mark[], bands: readonly Band[], place: Place) {
    this.#figure = figure;
    this.#stack = stack;
    this.#place = place;
    this.#unit = unit;
    this.#size = size;
    this.#marks = marks;
    this.#bands = bands;
    this.#drawn = stack.lines.map(() => ({ enveloped: false, resolved: true }));
    this.#readings = stack.lines.map(() => element("span", { class: "reading" }));
    const key = element("div", { class: "key" });
    stack.lines.forEach((line, k) => {
      key.append(element("span", { class: "key-entry" }, swatch(line), element("span", {}, line.label), this.#readings[k]));
    });
    // All readings of a plot have its unit, after the last one.
    key.lastElementChild?.append(this.#readingUnit);
    key.append(this.#less, this.#tag);
    const box = element("div", { class: "plot-box" });
    box.style.height = `${this.#height}px`;
    this.host = element("div", { class: "stack" }, key, box);
    this.plot = new uPlot(this.#options(), this.#data(times), box);
    this.plot.ctx.canvas.setAttribute("role", "img");
    this.plot.ctx.canvas.setAttribute("aria-label", `${figure.title}: ${stack.lines.map(({ symbol }) => symbol).join(", ")} over time`);
    this.#title.style.top = `${this.#above}px`;
    this.#title.style.height = `${this.#frame}px`;
    this.#name();
    box.append(this.#title);
    if (place.isLast) {
      const below = element("div", { class: "axis-title x" }, `time t (${unit.name})`);
      below.style.left = `${LEFT * size}px`;
      box.append(below);
    }
    this.#events = marks.map(() => element("div", { class: "event" }));
    this.plot.over.append(...this.#events, this.#now);
  }

  /** Returns true if a stack of another motion can be shown in the same plot. */
  fits(figure: Figure, stack: Stack, unit: { name: string }, marks: readonly Mark[]): boolean {
    const { lines } = this.#stack;
    const like = (a: Line, b: Line): boolean => a.label === b.label && a.ink === b.ink && String(a.dash) === String(b.dash);
    return (
      figure.log === this.#figure.log &&
      figure.unit === this.#figure.unit &&
      unit.name === this.#unit.name &&
      stack.lines.length === lines.length &&
      stack.lines.every((line, k) => like(line, lines[k])) &&
      marks.length === this.#marks.length
    );
  }

  /** Shows a stack that fits. The zoom stays. */
  update(figure: Figure, stack: Stack, times: Float64Array, marks: readonly Mark[], bands: readonly Band[]): void {
    const before = this.plot.data[0];
    const { min, max } = this.plot.scales.x;
    const zoomed = min !== undefined && min !== null && max !== undefined && max !== null && (min > before[0] || max < before[before.length - 1]);
    this.#figure = figure;
    this.#stack = stack;
    this.#marks = marks;
    this.#bands = bands;
    this.#name();
    const [first, last] = [times[0], times[times.length - 1]];
    const kept = zoomed && max > first && min < last;
    this.plot.batch((u: uPlot) => {
      u.setData(this.#data(times), false);
      u.setScale("x", kept ? { min: Math.max(min, first), max: Math.min(max, last) } : { min: first, max: last });
    });
  }

  #name(): void {
    const { title, less, readingUnit } = this.#stack;
    this.#readingUnit.textContent = readingUnit;
    if (this.#title.textContent !== title) this.#title.textContent = title;
    this.#less.textContent = less;
    this.#less.hidden = less === "";
  }

  #data(times: Float64Array): uPlot.AlignedData {
    const rows = this.#stack.lines.map(({ values }) => (this.#figure.log ? values.map((v) => (v > 0 ? v : Number.NaN)) : values));
    return [times, ...rows] as uPlot.AlignedData;
  }

  resize(width: number): void {
    this.plot.setSize({ width, height: this.#height });
    this.mark();
  }

  /** Moves the events to their times. */
  mark(): void {
    const places = this.#marks.map(({ time }, k) => put(this.plot, this.#events[k], time));
    if (!this.#place.isFirst) return;
    const seen = [...places.keys()].filter((k) => !this.#events[k].hidden);
    const texts = labels(seen.map((k) => places[k]), seen.map((k) => this.#marks[k].letter), LETTER);
    seen.forEach((k, j) => this.#events[k].replaceChildren(...(texts[j] ? [element("span", {}, texts[j])] : [])));
  }

  follow(time: number): void {
    put(this.plot, this.#now, time);
  }

  /** Shows the values of a sample. */
  read(i: number): void {
    const { lines, offset, figures, unit } = this.#stack;
    const nothing = this.#figure.log ? 0 : this.#figure.nothing / unit.size;
    lines.forEach(({ values }, k) => {
      const value = values[i] + offset;
      this.#readings[k].textContent = number(Math.abs(value) <= nothing ? 0 : value, figures);
    });
  }

  get #frame(): number {
    return this.#size * (this.#place.isFirst && this.#place.isLast ? FRAME.alone : FRAME.stacked);
  }

  get #above(): number {
    return this.#size * (this.#place.isFirst && this.#marks.length > 0 ? ABOVE.lettered : ABOVE.plain);
  }

  get #height(): number {
    return this.#above + this.#frame + this.#size * (this.#place.isLast ? BELOW.numbers + BELOW.title : BELOW.bare);
  }

  #options(): uPlot.Options {
    const { log, unit } = this.#figure;
    const axis: uPlot.Axis = {
      stroke: () => ink("quiet"),
      grid: { stroke: () => ink("grid"), width: 1 },
      ticks: { show: false },
      font: `${11 * this.#size}px system-ui, sans-serif`,
      gap: 4,
    };
    const degrees = unit === "°" && this.#stack.unit.size === 1;
    const up = (low: number, high: number): { values: number[]; step: number } => ticks(low, high, this.#frame / (28 * this.#size), degrees);
    const across = (u: uPlot, low: number, high: number): { values: number[]; step: number } => {
      return ticks(low / this.#unit.seconds, high / this.#unit.seconds, u.bbox.width / devicePixelRatio / (62 * this.#size));
    };
    const time: uPlot.Axis = {
      ...axis,
      size: this.#place.isLast ? BELOW.numbers * this.#size : 0,
      splits: (u, _, low, high) => across(u, low, high).values.map((v) => v * this.#unit.seconds),
      values: (u, values) => {
        if (!this.#place.isLast) return values.map(() => "");
        const { step } = across(u, u.scales.x.min ?? 0, u.scales.x.max ?? 1);
        return values.map((v) => mark(v / this.#unit.seconds, step));
      },
    };
    const value: uPlot.Axis = log
      ? {
          ...axis,
          splits: (_, __, low, high) => decades(low, high, 4),
          filter: (_, v) => v,
          values: (_, v) => v.map(powerOfTen),
        }
      : {
          ...axis,
          splits: (_, __, low, high) => up(low, high).values,
          values: (u, v) => v.map((one) => mark(one, up(u.scales.y.min ?? 0, u.scales.y.max ?? 1).step)),
        };
    return {
      width: 300,
      height: this.#height,
      padding: [this.#above, 18, this.#size * (this.#place.isLast ? BELOW.title : BELOW.bare), 0],
      legend: { show: false },
      cursor: {
        sync: { key: "polhode" },
        drag: { x: true, y: false, setScale: true, dist: 6 },
        points: { size: 6 },
        y: false,
      },
      scales: {
        x: { time: false },
        y: { distr: log ? 3 : 1, range: (u, low, high): [number, number] => this.#range(u, low, high) },
      },
      axes: [time, { ...value, size: LEFT * this.#size }],
      series: [
        {},
        ...this.#stack.lines.map((line, k): uPlot.Series => ({
          stroke: () => ink(line.ink),
          fill: () => `${ink(line.ink)}30`,
          width: 1.6 * this.#size,
          points: { show: false },
          ...(line.dash ? { dash: line.dash } : {}),
          paths: (u, series, first, last) => this.#paths(u, series, first, last, this.#stack.lines[k], k),
        })),
      ],
      hooks: { drawClear: [(u): void => this.#tint(u)], draw: [(): void => this.#say()] },
    };
  }

  // Draws bands behind everything else.
  #tint(u: uPlot): void {
    const { left, top, width, height } = u.bbox;
    const place = (time: number): number => Math.min(Math.max(u.valToPos(time, "x", true), left), left + width);
    u.ctx.save();
    u.ctx.globalAlpha = STRENGTH;
    for (const { from, to, ink: name } of this.#bands) {
      u.ctx.fillStyle = ink(name);
      u.ctx.fillRect(place(from), top, place(to) - place(from), height);
    }
    u.ctx.restore();
  }

  /**
   * Returns the range of the values between the ends of the time axis. The end of a diverging
   * motion is outside.
   */
  #range(u: uPlot, low: number | null, high: number | null): [number, number] {
    const { lines, range } = this.#stack;
    // Include the largest value before the visible interval.
    if (this.#figure.log) return logRange(lines, extent(lines.map(({ values }) => values), 0, u.series[0].idxs?.[1])?.[1] || (high ?? 1));
    if (range === null || low === null || high === null) return padded(range);
    const [from, to] = [Math.max(low, range[0]), Math.min(high, range[1])];
    return padded(from <= to ? [from, to] : range, 1e-3 * (range[1] - range[0]));
  }

  #paths(u: uPlot, series: number, first: number, last: number, line: Line, k: number): uPlot.Series.Paths {
    const [from, to] = [Math.max(first - 1, 0), Math.min(last + 1, u.data[0].length - 1)];
    const [across, up] = [placeOn(u, "x", false), placeOn(u, "y", this.#figure.log)];
    const x = placed(u.data[0], from, to, across);
    const y = placed(u.data[series], from, to, up);
    const before = this.#figure.log && from > 0 ? extent([line.values], 0, from - 1)?.[1] : 0;
    const level = before ? up(before) : Infinity;
    const starts = line.starts?.subarray(from, to + 1);
    const [stroke, fill] = [new Path2D(), new Path2D()];
    // Reading this from the window costs more than drawing a point.
    const ratio = devicePixelRatio;
    const spans = this.#figure.log ? [] : envelopes(x, y, starts);
    if (!this.#figure.log && spans.length === 0) {
      this.#drawn[k] = { enveloped: false, resolved: true };
      trace(stroke, x, y, starts, ratio);
      return { stroke, fill };
    }
    const made = this.#figure.log ? largestSoFar(x, y, level) : curve(x, y, starts, spans);
    this.#drawn[k] = { enveloped: made.bands.length > 0, resolved: made.resolved };
    const through = (path: Path2D, points: [number, number][]): void => {
      trace(path, points.map(([px]) => px), points.map(([, py]) => py), undefined, ratio);
    };
    for (const points of made.strokes) through(stroke, points);
    for (const points of made.bands) through(fill, points);
    for (const [px, py] of made.dots) fill.rect((px - 0.7) * ratio, (py - 0.7) * ratio, 1.4 * ratio, 1.4 * ratio);
    return { stroke, fill };
  }

  /** Shows which lines are envelopes, and which the samples do not resolve. */
  #say(): void {
    const { lines } = this.#stack;
    const of = (wanted: (drawn: { enveloped: boolean; resolved: boolean }) => boolean): string =>
      lines.filter((_, k) => wanted(this.#drawn[k])).map(({ symbol }) => symbol).join(", ");
    const envelopes = of(({ enveloped, resolved }) => enveloped && resolved);
    const ranges = of(({ resolved }) => !resolved);
    const said = [
      ...(envelopes ? [`${envelopes}: envelope, zoom in for the curve`] : []),
      ...(ranges ? [`${ranges}: the samples do not resolve the oscillation; the band is their range`] : []),
    ];
    this.#tag.textContent = said.join("; ");
    this.#tag.hidden = said.length === 0;
  }
}

/** Returns the conversion from a value to a place on the canvas, px of the page. */
function placeOn(u: uPlot, scale: "x" | "y", log: boolean): (value: number) => number {
  const { min, max } = u.scales[scale];
  const [low, high] = [min ?? 0, max ?? 1];
  const from = u.valToPos(low, scale, true) / devicePixelRatio;
  const to = u.valToPos(high, scale, true) / devicePixelRatio;
  if (log) {
    const [a, b] = [Math.log10(low), Math.log10(high)];
    return (value) => from + ((Math.log10(value) - a) / (b - a)) * (to - from);
  }
  const factor = (to - from) / (high - low);
  return (value) => from + (value - low) * factor;
}

/** Converts values of an interval to places; NaN where there is none. */
function placed(values: ArrayLike<number | null | undefined>, from: number, to: number, place: (value: number) => number): Float64Array {
  const out = new Float64Array(to - from + 1);
  for (let i = from; i <= to; i += 1) out[i - from] = place(values[i] ?? Number.NaN);
  return out;
}

/** Draws a line through points, without those that are indistinguishable from the previous one. */
function trace(path: Path2D, x: ArrayLike<number>, y: ArrayLike<number>, starts: ArrayLike<number> | undefined, ratio: number): void {
  const last = y.length - 1;
  let [px, py] = [Number.NaN, Number.NaN];
  for (let i = 0; i <= last; i += 1) {
    const begins = Number.isNaN(px) || starts?.[i] === 1;
    if (Number.isNaN(y[i])) {
      px = Number.NaN;
      continue;
    }
    const ends = i === last || Number.isNaN(y[i + 1]) || starts?.[i + 1] === 1;
    if (!begins && !ends && Math.abs(x[i] - px) + Math.abs(y[i] - py) < NEAR) continue;
    px = x[i];
    py = y[i];
    if (begins) path.moveTo(px * ratio, py * ratio);
    else path.lineTo(px * ratio, py * ratio);
  }
}

/** Moves a line to a time; returns its distance from the left, px. */
function put(plot: uPlot, line: HTMLElement, time: number): number {
  const left = plot.valToPos(time, "x");
  line.style.transform = `translateX(${left.toFixed(1)}px)`;
  line.hidden = !(left >= 0 && left <= plot.bbox.width / devicePixelRatio);
  return left;
}

function swatch(line: Line): HTMLElement {
  const made = element("span", { class: line.dash ? "swatch dashed" : "swatch" });
  made.style.color = `var(--${line.ink})`;
  return made;
}
