/**
 * Pad for dragging the principal moments in a triangle. Points outside are not physical, edges are
 * plates, and corners are rods.
 */
import type { PageData } from "../data";
import { element, svgElement } from "../dom";
import { number } from "../format";
import { ask } from "./ask";
import { CORNERS, kindOf, momentsAt, type Place, placeOf, type Three } from "./moments";
import type { Session } from "./session";

const SIZE = 170;
const EDGE = 22;
const STEP = 0.02;

export class MomentsPad {
  readonly host: HTMLElement;
  readonly #session: Session;
  readonly #svg = svgElement("svg", { viewBox: `0 0 ${SIZE + 2 * EDGE} ${SIZE * 0.866 + 2 * EDGE}`, tabindex: "0", role: "slider", class: "pad" });
  readonly #dot = svgElement("circle", { r: "7", class: "pad-dot" });
  readonly #said = element("p", { class: "hint" });
  #moments: Three = [1, 1, 1];
  /** Axis of the pad for the least moment, and so on, so that the dot stays under the pointer. */
  #order = [0, 1, 2];
  #isAllowed = false;
  #isDragged = false;

  constructor(session: Session) {
    this.#session = session;
    this.#draw();
    const panel = element("div", { class: "pad-panel", id: "pad-panel", hidden: true });
    const title = element("p", {}, element("b", {}, "Moments"), " I₁ ≤ I₂ ≤ I₃");
    panel.append(title, this.#svg, this.#said);
    const toggle = element("button", { type: "button", class: "quiet", "aria-expanded": "false", "aria-controls": "pad-panel" }, "Moments");
    toggle.addEventListener("click", () => {
      panel.hidden = !panel.hidden;
      toggle.setAttribute("aria-expanded", String(!panel.hidden));
      if (!panel.hidden) this.#svg.focus();
    });
    panel.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      toggle.click();
      toggle.focus();
    });
    this.host = element("div", { class: "pad-host" }, toggle, panel);
    this.#listen();
    session.listen({
      moved: (page) => this.#follow(page),
      changed: () => {
        if (isTensor(session.text)) this.#isAllowed = false;
      },
    });
  }

  #follow(page: PageData): void {
    this.#moments = [...page.body.principal.moments];
    if (!this.#isDragged) this.#order = [0, 1, 2];
    this.#show();
  }

  // Moments in the order of the pad's axes.
  get #placed(): Three {
    const out: Three = [0, 0, 0];
    this.#order.forEach((axis, k) => {
      out[axis] = this.#moments[k];
    });
    return out;
  }

  #show(): void {
    const [x, y] = onPad(placeOf(this.#placed));
    this.#dot.setAttribute("cx", x.toFixed(1));
    this.#dot.setAttribute("cy", y.toFixed(1));
    const words = `${this.#moments.map((moment) => number(moment, 4)).join(", ")} kg·m²: ${kindOf(this.#moments)}`;
    this.#said.textContent = words;
    this.#svg.setAttribute("aria-valuetext", words);
    this.#svg.setAttribute("aria-valuenow", String(Math.round((100 * this.#moments[0]) / this.#moments[2])));
  }

  async #go(place: Place): Promise<void> {
    if (!(await this.#mayReplace())) return;
    const [a, b, c] = this.#moments;
    const found = momentsAt(place, a + b + c);
    this.#order = [0, 1, 2].sort((p, q) => found[p] - found[q]);
    this.#moments = this.#order.map((axis) => found[axis]) as Three;
    this.#show();
    this.#session.edit({ moments: this.#moments });
  }

  // Asks once before the parts of a body are replaced.
  async #mayReplace(): Promise<boolean> {
    if (this.#isAllowed || isTensor(this.#session.text)) return true;
    this.#isDragged = false;
    const parts = partsOf(this.#session.text);
    const what = parts === 1 ? "its one part" : parts > 1 ? `its ${parts} parts` : "its shape";
    const words = `A body of other moments is another body: this replaces ${what} by mass and moments. Undo brings it back.`;
    this.#isAllowed = await ask(words, "Replace");
    return this.#isAllowed;
  }

  #listen(): void {
    const pad = this.#svg;
    const place = (event: PointerEvent): Place => {
      const box = pad.getBoundingClientRect();
      const unit = box.width / (SIZE + 2 * EDGE);
      const x = (event.clientX - box.left) / unit - EDGE;
      const y = SIZE * CORNERS[2][1] - ((event.clientY - box.top) / unit - EDGE);
      return [x / SIZE, y / SIZE];
    };
    pad.addEventListener("pointerdown", (event) => {
      pad.setPointerCapture(event.pointerId);
      this.#isDragged = true;
      this.#session.hold();
      void this.#go(place(event));
    });
    pad.addEventListener("pointermove", (event) => {
      if (this.#isDragged) void this.#go(place(event));
    });
    for (const end of ["pointerup", "pointercancel"]) {
      pad.addEventListener(end, () => {
        this.#isDragged = false;
        this.#session.release();
      });
    }
    pad.addEventListener("keydown", (event) => {
      const [dx, dy] = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
      if ((dx === 0 && dy === 0) || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const [x, y] = placeOf(this.#placed);
      void this.#go([x + STEP * dx, y + STEP * dy]);
    });
  }

  #draw(): void {
    const points = CORNERS.map((corner) => onPad(corner).map((c) => c.toFixed(1)).join(",")).join(" ");
    const [middleX, middleY] = onPad([0.5, Math.sqrt(3) / 6]);
    this.#svg.append(svgElement("polygon", { points, class: "pad-field" }));
    CORNERS.forEach((corner) => {
      const [x, y] = onPad(corner);
      this.#svg.append(svgElement("line", { x1: String(x), y1: String(y), x2: String(2 * middleX - x + (x - middleX) / 2), y2: String(2 * middleY - y + (y - middleY) / 2), class: "pad-line" }));
    });
    const text = (words: string, [x, y]: Place, anchor: string, dy: number): void => {
      const [px, py] = onPad([x, y]);
      const made = svgElement("text", { x: String(px), y: String(py + dy), "text-anchor": anchor });
      made.textContent = words;
      this.#svg.append(made);
    };
    text("rod", CORNERS[0], "start", 15);
    text("rod", CORNERS[1], "end", 15);
    text("rod", CORNERS[2], "middle", -7);
    text("plates", [0.5, 0], "middle", 15);
    text("sphere", [0.5, Math.sqrt(3) / 6], "middle", -6);
    this.#svg.append(svgElement("circle", { cx: String(middleX), cy: String(middleY), r: "2", class: "pad-middle" }), this.#dot);
    this.#svg.setAttribute("aria-label", "Triangle of the principal moments; arrow keys move in it");
    this.#svg.setAttribute("aria-valuemin", "0");
    this.#svg.setAttribute("aria-valuemax", "100");
  }
}

function partsOf(text: string): number {
  return text.match(/^\s*\[\[body\.part\]\]/gm)?.length ?? 0;
}

function isTensor(text: string): boolean {
  return partsOf(text) <= 1 && /^\s*shape\s*=\s*"tensor"/m.test(text);
}

function onPad([x, y]: Place): Place {
  return [EDGE + SIZE * x, EDGE + SIZE * (CORNERS[2][1] - y)];
}
