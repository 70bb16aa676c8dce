/** Path of a top's axis, with the axis of the 3-D view on it. */
import type { TopData } from "../data";
import { element, svgElement } from "../dom";
import { number } from "../format";
import type { Motion } from "../motion";
import { fromAbove, isUpright, onSphere, unrolled, type View } from "../plot/axis-drawing";
import { type AxisPath, axisAt, axisPath, pieces } from "../plot/axis-path";
import { type Mark, svgElements, svgText, wrapped } from "../plot/drawing";
import { saveButtons } from "../save/plot-buttons";

const TITLE = "Path of the axis in space";
const HEIGHT = 230;

/** Width below which the sphere is above the plane instead of next to it, px. */
const NARROW = 380;

/** Number of nutations unrolled together. */
const NUTATIONS = 6;

export class AxisPicture {
  readonly host: HTMLElement;
  readonly #motion: Motion;
  readonly #top: TopData;
  readonly #path: AxisPath | null;
  readonly #pieces: [number, number][];
  readonly #unit: { name: string; seconds: number };
  readonly #picture = svgElement("svg");
  readonly #times = element("p", { class: "hint" });
  #dots: SVGCircleElement[] = [];
  #views: View[] = [];
  #piece = 0;
  #width = 0;
  #time: number;

  constructor(motion: Motion, top: TopData, unit: { name: string; seconds: number }, file: string) {
    this.#motion = motion;
    this.#top = top;
    this.#unit = unit;
    this.#time = motion.times[0];
    const path = axisPath(motion, top);
    this.#path = "points" in path ? path : null;
    this.#pieces = this.#path ? pieces(this.#path, NUTATIONS) : [];
    const heading = element("div", { class: "plot-heading" }, element("h3", {}, TITLE));
    this.host = element("section", { class: "plot", id: "plot-axis" }, heading);
    if (!("points" in path)) {
      const why =
        "turn" in path
          ? `the axis moves by up to ${number(path.turn, 2)}\u00a0rad from a sample to the next, too far to follow`
          : `the samples do not resolve the nutation; between them the axis would leave its bounds by ${number(path.beyond, 2)}\u00a0rad`;
      this.host.append(element("p", { class: "hint" }, `Not drawn: ${why}. Sample a shorter time.`));
      return;
    }
    const svg = (): string => this.#paper();
    heading.append(...saveButtons(TITLE, `${file}-axis`, svg));
    const entry = (look: string, ink: string, words: string): HTMLElement => {
      const swatch = element("span", { class: `swatch ${look}` });
      swatch.style.color = `var(--${ink})`;
      return element("span", { class: "key-entry" }, swatch, words);
    };
    this.host.append(
      element("div", { class: "key" }, entry("", "ink", "the axis"), entry("dot", "axis-2", "its start"), entry("dot", "accent", "now"), entry("dashed", "axis-1", this.#bounds())),
    );
    this.#picture.setAttribute("role", "img");
    this.#picture.setAttribute("aria-label", "Path of the axis on a sphere and unrolled");
    this.host.append(this.#picture, this.#times);
  }

  resize(width: number): void {
    this.#width = width;
    this.#draw();
  }

  follow(time: number): void {
    this.#time = time;
    if (this.#pieceAt(time) !== this.#piece) this.#draw();
    else this.#move();
  }

  #pieceAt(time: number): number {
    const times = this.#path?.times ?? [];
    const found = this.#pieces.findIndex(([, last]) => time <= times[last]);
    return found < 0 ? Math.max(this.#pieces.length - 1, 0) : found;
  }

  #bounds(): string {
    const degrees = (angle: number): string => String(Number(((angle * 180) / Math.PI).toPrecision(5)));
    const [least, most] = (this.#path?.bounds ?? [0, 0]).map(degrees);
    return `${least === most ? `${least}°` : `${least}° to ${most}°`} from the vertical`;
  }

  #compose(width: number): { views: View[]; height: number } {
    const path = this.#path;
    if (!path) return { views: [], height: 0 };
    const stacked = width < NARROW;
    const half = stacked ? width : Math.min(0.42 * width, HEIGHT);
    const left = { left: 0, top: 0, width: half, height: HEIGHT };
    const right = stacked ? { left: 0, top: HEIGHT, width, height: HEIGHT } : { left: half, top: 0, width: width - half, height: HEIGHT };
    const beside = isUpright(path) ? fromAbove(path, this.#top, right) : unrolled(path, this.#top, this.#pieces[this.#piece], right);
    return { views: [onSphere(path, this.#top, left), beside], height: stacked ? 2 * HEIGHT : HEIGHT };
  }

  #draw(): void {
    if (!this.#path || this.#width === 0) return;
    this.#piece = this.#pieceAt(this.#time);
    const { views, height } = this.#compose(this.#width);
    this.#views = views;
    this.#picture.setAttribute("viewBox", `0 0 ${this.#width} ${height}`);
    this.#picture.setAttribute("width", String(this.#width));
    this.#picture.setAttribute("height", String(height));
    this.#dots = views.map(() => svgElement("circle", { r: "4", class: "axis-now" }));
    this.#picture.replaceChildren(...views.flatMap(({ marks }) => svgElements(marks)), ...this.#dots);
    this.#times.textContent = this.#said();
    this.#times.hidden = this.#times.textContent === "";
    this.#move();
  }

  /** Describes the unrolled part, if it is not the whole. */
  #said(): string {
    if (!this.#path || isUpright(this.#path) || this.#pieces.length < 2) return "";
    const [from, to] = this.#pieces[this.#piece].map((i) => number((this.#path?.times[i] ?? 0) / this.#unit.seconds, 4));
    return `Unrolled: t = ${from} … ${to} ${this.#unit.name}, the ${NUTATIONS} nutations around the time of the view.`;
  }

  #move(): void {
    const e = axisAt(this.#motion, this.#top, this.#time);
    this.#views.forEach(({ place }, k) => {
      const at = place(e, this.#time);
      this.#dots[k].style.display = at ? "" : "none";
      if (!at) return;
      this.#dots[k].setAttribute("cx", at[0].toFixed(1));
      this.#dots[k].setAttribute("cy", at[1].toFixed(1));
    });
  }

  #paper(): string {
    const { views, height } = this.#compose(640);
    const words = [`${TITLE}; dashed: ${this.#bounds()}`, this.#said()].flatMap((text) => wrapped(text, 616, 11.5));
    const below = words.map((text, k): Mark => ({ kind: "text", at: [12, height + 18 + 17 * k], text, size: 11.5 }));
    return svgText([...views.flatMap(({ marks }) => marks), ...below], 640, height + 12 + 17 * words.length);
  }
}
