/**
 * Plots next to the 3-D view. All show the same time: a line marks it, the pointer reads values, a
 * click sets it. Dragging zooms all plots, and a double click shows everything again. When a motion
 * replaces another, visible plots are drawn immediately, and the others when they become visible or
 * the page is idle.
 */
import type uPlot from "uplot";
import type { Clock } from "../clock";
import { AXIS_SETS, type AxisSet } from "../components";
import type { PageData, TopData } from "../data";
import { element } from "../dom";
import { fileName } from "../save/files";
import { type FigureMaker, makersOf } from "../figures";
import { number, timeUnit } from "../format";
import type { Motion } from "../motion";
import { marked } from "../plot/events";
import type { Figure } from "../plot/lines";
import { AxisPicture } from "./axis-picture";
import { eventKey, phaseKey } from "./events";
import { FigurePanel } from "./figure-panel";
import type { Shared, TimePlot } from "./time-plot";

/** Delay after the last change until invisible plots are drawn, ms. */
const QUIET = 300;

export class Plots {
  readonly #clock: Clock;
  readonly #events = element("div");
  readonly #figures = element("div");
  readonly #readingTime = element("span", { class: "reading-time" });
  readonly #seen = new Set<Element>();
  readonly #watch: IntersectionObserver;
  #panels = new Map<string, FigurePanel>();
  /** Figures that are not drawn yet, and data of the path of the axis if it is not drawn yet. */
  readonly #waiting = new Map<FigurePanel, FigureMaker>();
  #axisWaits: { top: TopData; motion: Motion } | null = null;
  #shared: Shared;
  #page: PageData;
  #motion: Motion;
  /** Axes along which vectors are drawn. */
  #set: AxisSet = "body";
  #axis: AxisPicture | null = null;
  /** Size of the type, relative to that of the page. */
  #size = 1;
  /** Index of the sample under the pointer. */
  #hovered: number | null = null;
  #width = 0;
  #zooming = false;
  #next = 0;
  #later = 0;

  constructor(host: HTMLElement, page: PageData, motion: Motion, clock: Clock) {
    this.#clock = clock;
    this.#shared = sharedBy(page, motion, this.#size);
    [this.#page, this.#motion] = [page, motion];
    const hint = "Point to read values, click to go there, drag to zoom, double-click to see all. ";
    const ruler = element("div");
    const reading = element("div", { class: "reading-line" }, this.#readingTime, this.#choice());
    host.append(element("p", { class: "hint" }, hint), reading, this.#events, this.#figures, ruler);
    this.#watch = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting) this.#seen.add(target);
        else this.#seen.delete(target);
      }
      this.#drawSeen();
    });
    this.#build(page, motion);
    clock.subscribe(() => this.#follow());
    new ResizeObserver(() => this.#resize(ruler.clientWidth)).observe(ruler);
    this.#resize(ruler.clientWidth);
    this.#follow();
  }

  /** Shows another motion. */
  update(page: PageData, motion: Motion): void {
    const before = this.#shared;
    this.#shared = sharedBy(page, motion, this.#size);
    this.#hovered = null;
    [this.#page, this.#motion] = [page, motion];
    const makers = makersOf(motion, page.body.principal, this.#set);
    if ((page.top === null) !== (this.#axis === null) || before.unit.name !== this.#shared.unit.name) {
      this.#build(page, motion);
      this.#resize(this.#width, true);
    } else {
      const isListed = [before, this.#shared].some(({ marked, phases }) => marked.length > 0 || phases.length > 0);
      if (isListed) this.#listEvents(motion);
      for (const maker of makers) {
        const panel = this.#panels.get(maker.id);
        if (panel) this.#waiting.set(panel, maker);
      }
      this.#axisWaits = page.top && { top: page.top, motion };
      // Runs after the frame of the 3-D view, which must not wait for the plots.
      cancelAnimationFrame(this.#next);
      this.#next = requestAnimationFrame(() => {
        this.#next = requestAnimationFrame(() => {
          this.#arrange(makers);
          this.#drawSeen();
        });
      });
      clearTimeout(this.#later);
      this.#later = window.setTimeout(() => this.#drawRest(), QUIET);
    }
    this.#follow();
  }

  /** Draws all plots again, with type of another size. */
  magnify(size: number): void {
    this.#size = size;
    this.#shared = sharedBy(this.#page, this.#motion, size);
    this.#build(this.#page, this.#motion);
    this.#resize(this.#width, true);
    this.#follow();
  }

  redraw(): void {
    for (const { plot } of this.#plots()) plot.redraw(false);
  }

  // Makes the choice of the axes. Plots have one set at a time.
  #choice(): HTMLElement {
    const choice = element("select", { id: "axis-set", class: "small" });
    for (const [value, { choice: text }] of Object.entries(AXIS_SETS)) choice.append(element("option", { value }, text));
    choice.addEventListener("change", () => {
      this.#set = choice.value as AxisSet;
      this.update(this.#page, this.#motion);
    });
    return element("label", {}, "Vectors along ", choice);
  }

  // Builds everything again.
  #build(page: PageData, motion: Motion): void {
    this.#arrange([]);
    this.#seen.clear();
    if (this.#axis) {
      this.#watch.unobserve(this.#axis.host);
      this.#axis.host.remove();
    }
    this.#axisWaits = null;
    this.#axis = page.top ? new AxisPicture(motion, page.top, this.#shared.unit, this.#shared.file) : null;
    this.#listEvents(motion);
    this.#arrange(makersOf(motion, page.body.principal, this.#set));
    if (!this.#axis) return;
    this.#panels.get("omega")?.host.after(this.#axis.host);
    this.#watch.observe(this.#axis.host);
  }

  // Provides a panel for each of these figures, in their order. Existing panels stay.
  #arrange(makers: FigureMaker[]): void {
    const before = this.#panels;
    this.#panels = new Map();
    for (const { id, make } of makers) {
      const panel = before.get(id) ?? this.#add(make());
      before.delete(id);
      this.#panels.set(id, panel);
    }
    for (const panel of before.values()) {
      this.#watch.unobserve(panel.host);
      this.#seen.delete(panel.host);
      this.#waiting.delete(panel);
      for (const { plot } of panel.plots) plot.destroy();
      panel.host.remove();
    }
  }

  // Adds a panel after the existing ones.
  #add(figure: Figure): FigurePanel {
    const panel = new FigurePanel(figure, this.#shared, (plot) => this.#listen(plot));
    const last = [...this.#panels.values()].at(-1)?.host;
    if (last) (last.nextElementSibling === this.#axis?.host ? this.#axis.host : last).after(panel.host);
    else this.#figures.prepend(panel.host);
    for (const plot of panel.plots) if (this.#width > 0) plot.resize(this.#width);
    this.#watch.observe(panel.host);
    return panel;
  }

  #listEvents(motion: Motion): void {
    const { marked, unit } = this.#shared;
    const events = marked.length > 0 ? [eventKey(marked, motion.eventCount, this.#clock, unit)] : [];
    this.#events.replaceChildren(...events, ...(motion.contact ? [phaseKey(motion.contact.phases, unit)] : []));
  }

  #drawSeen(): void {
    for (const panel of this.#waiting.keys()) if (this.#seen.has(panel.host)) this.#draw(panel);
    if (this.#axis && this.#seen.has(this.#axis.host)) this.#drawAxis(this.#axis);
  }

  // Draws the remaining figures one by one, so that nothing waits for them. While the tab is closed
  // they are not drawn.
  #drawRest(): void {
    const [panel] = this.#waiting.keys();
    if (this.#figures.offsetParent === null) return;
    if (panel) this.#draw(panel);
    else if (this.#axis && this.#axisWaits) this.#drawAxis(this.#axis);
    else return;
    this.#later = window.setTimeout(() => this.#drawRest(), 0);
  }

  #draw(panel: FigurePanel): void {
    const maker = this.#waiting.get(panel);
    this.#waiting.delete(panel);
    if (!maker) return;
    this.#zooming = true;
    const fits = panel.update(maker.make(), this.#shared);
    this.#zooming = false;
    if (!fits) for (const plot of panel.plots) plot.resize(this.#width);
    for (const plot of panel.plots) {
      plot.mark();
      plot.follow(this.#clock.time);
      plot.read(this.#clock.index());
    }
  }

  // Replaces the path of the axis by that of another motion.
  #drawAxis(before: AxisPicture): void {
    if (!this.#axisWaits) return;
    const { top, motion } = this.#axisWaits;
    this.#axisWaits = null;
    const { unit, file } = this.#shared;
    this.#axis = new AxisPicture(motion, top, unit, file);
    this.#watch.unobserve(before.host);
    this.#seen.delete(before.host);
    before.host.replaceWith(this.#axis.host);
    this.#watch.observe(this.#axis.host);
    this.#axis.resize(this.#width);
    this.#axis.follow(this.#clock.time);
  }

  #plots(): TimePlot[] {
    return [...this.#panels.values()].flatMap(({ plots }) => plots);
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
      for (const { plot: other } of this.#plots()) if (other !== u) other.setScale("x", { min, max });
      this.#zooming = false;
      for (const one of this.#plots()) one.mark();
      this.#follow();
    });
  }

  #follow(): void {
    for (const one of this.#plots()) one.follow(this.#clock.time);
    this.#axis?.follow(this.#clock.time);
    if (this.#hovered === null) this.#read();
  }

  // Shows values at the pointer, else at the time of the 3-D view.
  #read(): void {
    const i = this.#hovered ?? this.#clock.index();
    for (const one of this.#plots()) one.read(i);
    const { times, unit } = this.#shared;
    this.#readingTime.textContent = `Values at t = ${number(times[Math.min(i, times.length - 1)] / unit.seconds, 6)} ${unit.name}`;
  }

  #resize(width: number, always = false): void {
    if (width < 50 || (width === this.#width && !always)) return;
    this.#width = width;
    for (const one of this.#plots()) one.resize(width);
    this.#axis?.resize(width);
    this.#follow();
  }
}

function sharedBy(page: PageData, motion: Motion, size: number): Shared {
  const { times } = motion;
  const unit = timeUnit(Math.max(Math.abs(times[times.length - 1]), Math.abs(times[0])));
  return { times, unit, marked: marked(motion.events), phases: motion.contact?.phases ?? [], size, file: fileName(page.title) };
}
