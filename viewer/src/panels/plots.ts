/**
 * The plots beside the 3-D view. All show the same time: a line marks it, the pointer reads values, a click sets it. Dragging zooms all
 * plots, a double click shows everything again.
 */
import type uPlot from "uplot";
import type { Clock } from "../clock";
import type { BodyData, TopData } from "../data";
import { element } from "../dom";
import { fileName } from "../save/files";
import { figuresOf } from "../figures";
import { number, timeUnit } from "../format";
import type { Motion } from "../motion";
import { arrange, sentences } from "../plot/arrange";
import { type Marked, marked, marksOf } from "../plot/events";
import { svgOf } from "../plot/figure-svg";
import type { Figure } from "../plot/lines";
import { AxisPicture } from "./axis-picture";
import { eventKey } from "./events";
import { saveButtons } from "../save/plot-buttons";
import { TimePlot } from "./time-plot";

export class Plots {
  readonly #clock: Clock;
  readonly #plots: TimePlot[] = [];
  readonly #marked: Marked[];
  readonly #unit: { name: string; seconds: number };
  readonly #readingTime: HTMLElement;
  readonly #file: string;
  readonly #axis: AxisPicture | null;
  /** The sample under the pointer. */
  #hovered: number | null = null;
  #width = 0;
  #zooming = false;

  constructor(host: HTMLElement, motion: Motion, body: BodyData, top: TopData | null, clock: Clock, title: string) {
    this.#clock = clock;
    this.#marked = marked(motion.events);
    this.#unit = timeUnit(Math.max(Math.abs(clock.end), Math.abs(clock.start)));
    this.#readingTime = element("span", { class: "reading-time" });
    this.#file = fileName(title);
    host.append(
      element("p", { class: "hint" }, "Point to read values, click to go there, drag to zoom, double-click to see all. ", this.#readingTime),
    );
    if (this.#marked.length > 0) host.append(eventKey(this.#marked, motion.eventCount, clock, this.#unit));
    const figures = figuresOf(motion, body.principal);
    this.#axis = top ? new AxisPicture(motion, top, this.#unit, this.#file) : null;
    figures.forEach((figure) => {
      this.#add(host, figure, motion.times);
      if (figure.id === "omega" && this.#axis) host.append(this.#axis.host);
    });
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

  #add(host: HTMLElement, figure: Figure, times: Float64Array): void {
    const arranged = arrange(figure);
    const { constants, stacks } = arranged;
    const heading = element("div", { class: "plot-heading" }, element("h3", {}, figure.title));
    const section = element("section", { class: "plot", id: `plot-${figure.id}` }, heading);
    const said = sentences(constants, figure);
    if (said.length > 0) section.append(element("div", { class: "constants" }, ...said.map((words) => element("p", {}, ...spans(words)))));
    if (figure.note) section.append(element("p", { class: "hint" }, figure.note));
    const marks = marksOf(this.#marked);
    const made = stacks.map((stack, k) => {
      return new TimePlot(figure, stack, times, this.#unit, marks, { isFirst: k === 0, isLast: k === stacks.length - 1 });
    });
    for (const { host } of made) section.append(host);
    host.append(section);
    for (const one of made) this.#listen(one.plot);
    this.#plots.push(...made);
    if (made.length === 0) return;
    const svg = (): string => {
      const { min, max } = made[0].plot.scales.x;
      return svgOf(figure, arranged, times, min ?? times[0], max ?? times[times.length - 1], this.#marked);
    };
    const file = `${this.#file}-${figure.id}`;
    heading.append(...saveButtons(figure.title, file, svg));
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
      for (const { plot: other } of this.#plots) if (other !== u) other.setScale("x", { min, max });
      this.#zooming = false;
      for (const one of this.#plots) one.mark();
      this.#follow();
    });
  }

  #follow(): void {
    for (const one of this.#plots) one.follow(this.#clock.time);
    this.#axis?.follow(this.#clock.time);
    if (this.#hovered === null) this.#read();
  }

  // Values at the pointer, else at the time of the 3-D view.
  #read(): void {
    const i = this.#hovered ?? this.#clock.index();
    for (const one of this.#plots) one.read(i);
    const time = this.#clock.times[i] / this.#unit.seconds;
    this.#readingTime.textContent = `Values at t = ${number(time, 6)} ${this.#unit.name}`;
  }

  #resize(width: number): void {
    if (width < 50 || width === this.#width) return;
    this.#width = width;
    for (const one of this.#plots) one.resize(width);
    this.#axis?.resize(width);
    this.#follow();
  }
}

/** Breaks a sentence before its commas' second halves only: numbers stay with their units. */
function spans(words: string): (Node | string)[] {
  const [first, ...rest] = words.split(", ");
  const whole = (text: string): HTMLElement => element("span", { class: "nowrap" }, text);
  return [whole(rest.length > 0 ? `${first},` : first), ...rest.flatMap((text) => [" ", whole(text)])];
}
