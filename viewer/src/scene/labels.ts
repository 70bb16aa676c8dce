/**
 * Names at the arrows' tips, as text over the picture. A label never lies on the body: it stands outside the body's silhouette, along
 * the line from the middle through the tip, and moves around it until no other label is in its way. A thin line leads to the tip.
 */
import { type Camera, Vector3 } from "three";
import type { Ink } from "./palette";

export interface Label {
  text: string;
  ink: Ink;
  /** In the picture's space. */
  tip: Vector3;
}

export interface PlacedLabel extends Label {
  /** Of its middle, px. */
  x: number;
  y: number;
  /** Of the tip, px. */
  tipX: number;
  tipY: number;
  led: boolean;
}

const GAP = 8;

export class Labels {
  placed: PlacedLabel[] = [];
  readonly #host: HTMLElement;
  readonly #lines: SVGSVGElement;
  readonly #made = new Map<string, { span: HTMLSpanElement; line: SVGLineElement; w: number; h: number }>();

  constructor(host: HTMLElement) {
    this.#host = host;
    this.#lines = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.#lines.setAttribute("class", "leaders");
    host.append(this.#lines);
  }

  /** `outline`: points of the body's hull, in the picture's space. */
  draw(labels: Label[], outline: Vector3[], camera: Camera, width: number, height: number): void {
    const project = (p: Vector3): [number, number] => {
      const v = p.clone().project(camera);
      return [(0.5 + v.x / 2) * width, (0.5 - v.y / 2) * height];
    };
    const [cx, cy] = project(new Vector3());
    const hull = outline.map(project);
    // The outer halves of the arrows, which no other label covers.
    const arrows = labels.map(({ tip }) => [0.5, 0.6, 0.7, 0.8, 0.9, 1].map((part) => project(tip.clone().multiplyScalar(part))));
    this.placed = [];
    for (const [k, label] of labels.entries()) {
      const others = arrows.filter((_, other) => other !== k).flat();
      const made = this.#element(label);
      const [tipX, tipY] = project(label.tip);
      const spot = this.#spot(tipX - cx, tipY - cy, cx, cy, hull, others, made, width, height);
      const led = Math.hypot(spot.x - tipX, spot.y - tipY) > 26;
      this.placed.push({ ...label, ...spot, tipX, tipY, led });
      made.span.style.transform = `translate(${(spot.x - made.w / 2).toFixed(1)}px, ${(spot.y - made.h / 2).toFixed(1)}px)`;
      made.line.style.display = led ? "" : "none";
      const short = 1 - 11 / Math.max(Math.hypot(spot.x - tipX, spot.y - tipY), 12);
      made.line.setAttribute("x1", tipX.toFixed(1));
      made.line.setAttribute("y1", tipY.toFixed(1));
      made.line.setAttribute("x2", (tipX + short * (spot.x - tipX)).toFixed(1));
      made.line.setAttribute("y2", (tipY + short * (spot.y - tipY)).toFixed(1));
    }
    const shown = new Set(labels.map((label) => label.text));
    for (const [text, { span, line }] of this.#made) {
      span.hidden = !shown.has(text);
      if (span.hidden) line.style.display = "none";
    }
  }

  #spot(
    dx: number,
    dy: number,
    cx: number,
    cy: number,
    hull: [number, number][],
    others: [number, number][],
    size: { w: number; h: number },
    width: number,
    height: number,
  ): { x: number; y: number } {
    const long = Math.hypot(dx, dy);
    const angle = long > 1 ? Math.atan2(dy, dx) : -Math.PI / 2;
    let best = { x: cx, y: cy };
    for (let turn = 0; turn < 36; turn += 1) {
      const a = angle + (turn % 2 === 0 ? 1 : -1) * Math.ceil(turn / 2) * 0.12;
      const [ux, uy] = [Math.cos(a), Math.sin(a)];
      // Beyond the hull's farthest point in this direction, all of the label is outside.
      const support = hull.reduce((far, [x, y]) => Math.max(far, (x - cx) * ux + (y - cy) * uy), 0);
      const half = (Math.abs(ux) * size.w + Math.abs(uy) * size.h) / 2;
      const reach = Math.max(support + half + GAP, turn === 0 ? long + half + GAP / 2 : long * 0.9);
      const x = Math.min(Math.max(cx + reach * ux, size.w / 2 + 4), width - size.w / 2 - 4);
      const y = Math.min(Math.max(cy + reach * uy, size.h / 2 + 4), height - size.h / 2 - 4);
      if (turn === 0) best = { x, y };
      const near = (px: number, py: number, w: number, h: number): boolean =>
        Math.abs(px - x) < (w + size.w) / 2 + 2 && Math.abs(py - y) < (h + size.h) / 2;
      const taken = this.placed.some((other) => {
        const o = this.#made.get(other.text);
        return o !== undefined && near(other.x, other.y, o.w, o.h);
      });
      if (!taken && !others.some(([px, py]) => near(px, py, 6, 6))) return { x, y };
    }
    return best;
  }

  #element(label: Label): { span: HTMLSpanElement; line: SVGLineElement; w: number; h: number } {
    const known = this.#made.get(label.text);
    if (known) {
      known.span.hidden = false;
      return known;
    }
    const span = document.createElement("span");
    span.className = "label";
    span.textContent = label.text;
    span.style.color = `var(--${label.ink})`;
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    line.style.stroke = `var(--${label.ink})`;
    this.#host.append(span);
    this.#lines.append(line);
    const made = { span, line, w: span.offsetWidth, h: span.offsetHeight };
    this.#made.set(label.text, made);
    return made;
  }
}
