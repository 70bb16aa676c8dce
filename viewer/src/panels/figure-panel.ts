/** Section of a figure: its title with buttons for saving, its constants as text, and its plots. */
import type uPlot from "uplot";
import { element } from "../dom";
import { type Arranged, arrange, sentences } from "../plot/arrange";
import { marksOf } from "../plot/events";
import { svgOf } from "../plot/figure-svg";
import type { Figure } from "../plot/lines";
import { bandsOf } from "../plot/phases";
import { saveButtons } from "../save/plot-buttons";
import { type Shared, TimePlot } from "./time-plot";

export class FigurePanel {
  readonly host: HTMLElement;
  plots: TimePlot[] = [];
  #figure: Figure;
  #arranged: Arranged;
  #shared: Shared;
  readonly #listen: (plot: uPlot) => void;

  /** `listen` is called with each new plot. */
  constructor(figure: Figure, shared: Shared, listen: (plot: uPlot) => void) {
    this.host = element("section", { class: "plot", id: `plot-${figure.id}` });
    this.#listen = listen;
    this.#figure = figure;
    this.#shared = shared;
    this.#arranged = arrange(figure);
    this.#make();
  }

  /**
   * Shows the figure of another motion in the same plots if it has the same lines. Returns true if
   * it does.
   */
  update(figure: Figure, shared: Shared): boolean {
    const arranged = arrange(figure);
    const marks = marksOf(shared.marked);
    const before = this.#figure;
    this.#figure = figure;
    this.#arranged = arranged;
    this.#shared = shared;
    const fits =
      before.title === figure.title &&
      this.plots.length === arranged.stacks.length &&
      this.plots.every((plot, k) => plot.fits(figure, arranged.stacks[k], shared.unit, marks));
    if (fits) {
      this.plots.forEach((plot, k) => plot.update(figure, arranged.stacks[k], shared.times, marks, bandsOf(shared.phases)));
      this.#say();
    } else this.#make();
    return fits;
  }

  #make(): void {
    for (const { plot } of this.plots) plot.destroy();
    const { figure, shared } = { figure: this.#figure, shared: this.#shared };
    const { stacks } = this.#arranged;
    const marks = marksOf(shared.marked);
    this.plots = stacks.map((stack, k) => {
      const place = { isFirst: k === 0, isLast: k === stacks.length - 1 };
      return new TimePlot(figure, stack, shared, marks, bandsOf(shared.phases), place);
    });
    const heading = element("div", { class: "plot-heading" }, element("h3", {}, figure.title));
    if (this.plots.length > 0) heading.append(...saveButtons(figure.title, `${shared.file}-${figure.id}`, () => this.#svg()));
    this.host.replaceChildren(heading, element("div", { class: "said" }), ...this.plots.map(({ host }) => host));
    this.#say();
    for (const { plot } of this.plots) this.#listen(plot);
  }

  // Shows the constants and the note of the figure.
  #say(): void {
    const said = sentences(this.#arranged.constants, this.#figure);
    const { note } = this.#figure;
    const words = said.length > 0 ? [element("div", { class: "constants" }, ...said.map((text) => element("p", {}, ...spans(text))))] : [];
    this.host.querySelector(".said")?.replaceChildren(...words, ...(note ? [element("p", { class: "hint" }, note)] : []));
  }

  #svg(): string {
    const { times, marked, phases } = this.#shared;
    const { min, max } = this.plots[0].plot.scales.x;
    return svgOf(this.#figure, this.#arranged, times, min ?? times[0], max ?? times[times.length - 1], marked, bandsOf(phases));
  }
}

/** Allows line breaks only after commas: numbers stay with their units. */
function spans(words: string): (Node | string)[] {
  const [first, ...rest] = words.split(", ");
  const whole = (text: string): HTMLElement => element("span", { class: "nowrap" }, text);
  return [whole(rest.length > 0 ? `${first},` : first), ...rest.flatMap((text) => [" ", whole(text)])];
}
