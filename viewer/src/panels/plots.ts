/**
 * The plots beside the 3-D view. All show the same time: a line marks it, the pointer reads values, a click sets it. Dragging zooms all
 * plots, a double click shows everything again.
 */
import uPlot from "uplot";
import type { Clock } from "../clock";
import { element } from "../dom";
import { fileName, savePng, saveSvg, svgOf } from "../export";
import { decades, type Figure, figuresOf, HALF_TURN, isZero, type Line, rangeOf, ticks } from "../figures";
import { mark, number, powerOfTen, timeUnit } from "../format";
import type { Motion } from "../motion";

const HEIGHT = 150;

export class Plots {
  readonly #clock: Clock;
  readonly #plots: { plot: uPlot; figure: Figure; line: HTMLElement; marks: HTMLElement[]; values: HTMLElement[] }[] = [];
  readonly #events: readonly { time: number; name: string }[];
  readonly #unit: { name: string; seconds: number };
  readonly #hoverTime: HTMLElement;
  /** The sample under the pointer. */
  #hovered: number | null = null;
  #width = 0;
  #zooming = false;

  constructor(host: HTMLElement, motion: Motion, clock: Clock, title: string) {
    this.#clock = clock;
    this.#events = motion.events;
    this.#unit = timeUnit(Math.max(Math.abs(clock.end), Math.abs(clock.start)));
    this.#hoverTime = element("span", { class: "reading-time" });
    host.append(
      element("p", { class: "hint" }, "Point to read values, click to go there, drag to zoom, double-click to see all. ", this.#hoverTime),
    );
    for (const figure of figuresOf(motion)) this.#add(host, figure, motion.times, fileName(title));
    clock.subscribe(() => this.#follow());
    const ruler = element("div");
    host.append(ruler);
    new ResizeObserver(() => this.#resize(ruler.clientWidth)).observe(ruler);
    this.#resize(ruler.clientWidth);
    this.#follow();
  }

  redraw(): void {
    for (const { plot } of this.#plots) plot.redraw(false);
  }

  #add(host: HTMLElement, figure: Figure, times: Float64Array, name: string): void {
    const values = figure.lines.map(() => element("output", { class: "reading" }));
    const key = element("div", { class: "key" });
    figure.lines.forEach((line, k) => {
      key.append(element("span", { class: "key-entry" }, swatch(line), element("span", {}, line.label), values[k]));
    });
    const span = (): [number, number] => {
      const { min, max } = plot.scales.x;
      return [min ?? times[0], max ?? times[times.length - 1]];
    };
    const svg = (): string => svgOf(figure, times, ...span(), this.#events);
    const file = `${name}-${figure.id}`;
    const heading = element(
      "div",
      { class: "plot-heading" },
      element("h3", {}, figure.title, element("span", { class: "unit" }, figure.unit)),
      element("button", { class: "small", type: "button", title: "Save as SVG", click: () => saveSvg(file, svg()) }, "SVG"),
      element("button", { class: "small", type: "button", title: "Save as PNG", click: () => void savePng(file, svg()) }, "PNG"),
    );
    const box = element("div", { class: "plot-box" });
    host.append(element("section", { class: "plot", id: `plot-${figure.id}` }, heading, key, box));
    const plot = new uPlot(this.#options(figure), [times, ...figure.lines.map((l) => l.values)] as uPlot.AlignedData, box);
    const line = element("div", { class: "now" });
    // Names stand in the first plot; elsewhere the pointer tells them.
    const named = this.#plots.length === 0;
    const marks = this.#events.map(({ name }) => {
      const mark = element("div", { class: "event", title: name });
      if (named) mark.append(element("span", {}, name));
      return mark;
    });
    plot.over.append(...marks, line);
    this.#listen(plot);
    this.#plots.push({ plot, figure, line, marks, values });
  }

  #options(figure: Figure): uPlot.Options {
    const ink = (name: string) => (): string =>
      getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    const axis: uPlot.Axis = {
      stroke: ink("quiet"),
      grid: { stroke: ink("grid"), width: 1 },
      ticks: { show: false },
      font: "11px system-ui, sans-serif",
      gap: 4,
    };
    const spaced = (pixels: number) => (u: uPlot, index: number, low: number, high: number): number[] => {
      const scale = index === 0 ? this.#unit.seconds : 1;
      const room = (index === 0 ? u.bbox.width : u.bbox.height) / devicePixelRatio;
      if (index > 0 && isZero(figure)) return [0];
      return ticks(low / scale, high / scale, room / pixels, index > 0 && figure.wraps).values.map((v) => v * scale);
    };
    const marks = (scale: number) => (_: uPlot, values: number[]): string[] => {
      const step = values.length > 1 ? (values[1] - values[0]) / scale : 1;
      return values.map((v) => mark(v / scale, step));
    };
    return {
      width: 300,
      height: HEIGHT,
      padding: [6, 12, 0, 0],
      legend: { show: false },
      cursor: {
        sync: { key: "polhode" },
        drag: { x: true, y: false, setScale: true, dist: 6 },
        points: { size: 6 },
        y: false,
      },
      scales: {
        x: { time: false },
        y: { distr: figure.log ? 3 : 1, range: (): [number, number] => rangeOf(figure) },
      },
      axes: [
        { ...axis, splits: spaced(70), values: marks(this.#unit.seconds), size: 24 },
        {
          ...axis,
          size: 58,
          ...(figure.log
            ? {
                splits: (_: uPlot, __: number, low: number, high: number) => decades(low, high, 5),
                filter: (_: uPlot, v: number[]) => v,
                values: (_: uPlot, v: number[]) => v.map(powerOfTen),
              }
            : { splits: spaced(28), values: marks(1) }),
        },
      ],
      series: [
        {},
        ...figure.lines.map((line): uPlot.Series => ({
          stroke: ink(line.ink),
          width: 1.6,
          points: { show: false },
          ...(line.dash ? { dash: line.dash } : {}),
          ...(figure.wraps ? { paths: broken } : {}),
        })),
      ],
    };
  }

  #listen(plot: uPlot): void {
    plot.over.addEventListener("click", () => {
      const left = plot.cursor.left ?? -1;
      if (left >= 0) this.#clock.set(plot.posToVal(left, "x"));
    });
    (plot.hooks.setCursor ??= []).push((u) => {
      this.#hovered = u.cursor.idx ?? null;
      this.#read();
    });
    (plot.hooks.setScale ??= []).push((u, scale) => {
      if (scale !== "x" || this.#zooming) return;
      const { min, max } = u.scales.x;
      if (min === undefined || min === null || max === undefined || max === null) return;
      this.#zooming = true;
      for (const other of this.#plots) if (other.plot !== u) other.plot.setScale("x", { min, max });
      this.#zooming = false;
      this.#mark();
      this.#follow();
    });
  }

  #mark(): void {
    for (const { plot, marks } of this.#plots) {
      let free = 0;
      marks.forEach((mark, k) => {
        const left = place(plot, mark, this.#events[k].time);
        // A name has room to the left of its line, or is left out.
        const hasRoom = left - 14 > free;
        mark.classList.toggle("crowded", !hasRoom);
        if (hasRoom) free = left;
      });
    }
  }

  #follow(): void {
    for (const { plot, line } of this.#plots) place(plot, line, this.#clock.time);
    if (this.#hovered === null) this.#read();
  }

  // Values at the pointer, else at the time of the 3-D view.
  #read(): void {
    const i = this.#hovered ?? this.#clock.index();
    for (const { figure, values } of this.#plots) {
      figure.lines.forEach((line, k) => {
        values[k].textContent = figure.log ? number(line.values[i], 2) : number(line.values[i]);
      });
    }
    const time = this.#clock.times[i] / this.#unit.seconds;
    this.#hoverTime.textContent = `Values at t = ${number(time, 6)} ${this.#unit.name}`;
  }

  #resize(width: number): void {
    if (width < 50 || width === this.#width) return;
    this.#width = width;
    for (const { plot } of this.#plots) plot.setSize({ width, height: HEIGHT });
    this.#mark();
    this.#follow();
  }
}

/** Puts a line at a time; gives its distance from the left, px. */
function place(plot: uPlot, line: HTMLElement, time: number): number {
  const left = plot.valToPos(time, "x");
  line.style.transform = `translateX(${left.toFixed(1)}px)`;
  line.hidden = !(left >= 0 && left <= plot.over.clientWidth);
  return left;
}

function swatch(line: Line): HTMLElement {
  const made = element("span", { class: line.dash ? "swatch dashed" : "swatch" });
  made.style.color = `var(--${line.ink})`;
  return made;
}

// Where an angle leaps over ±180°, and where there is none, the line is broken.
const broken: uPlot.Series.PathBuilder = (u, series, first, last) => {
  const stroke = new Path2D();
  const values = u.data[series];
  const times = u.data[0];
  for (let i = Math.max(first - 1, 0); i <= Math.min(last + 1, times.length - 1); i += 1) {
    const value = values[i] ?? Number.NaN;
    if (!Number.isFinite(value)) continue;
    // Half a turn is that of φ and ψ past an end of θ. A comparison with what is no number is false.
    const goesOn = Math.abs(value - (values[i - 1] ?? Number.NaN)) < HALF_TURN;
    const at: [number, number] = [u.valToPos(times[i], "x", true), u.valToPos(value, "y", true)];
    if (!goesOn || i < first) stroke.moveTo(...at);
    else stroke.lineTo(...at);
  }
  return { stroke };
};
