/**
 * Labels as text over the picture, without overlap. The label of an arrow is at its tip, outside
 * the silhouette of the body, on the line from the centre through the tip; it moves around until
 * its place is free. The label of a curve or a surface is next to one of its points. A thin line
 * leads from a label to its object.
 */
import { type Camera, Vector3 } from "three";
import { svgElement } from "../dom";
import { Density } from "./density";
import type { Corner } from "./orbit";
import type { Ink } from "./palette";

export interface Label {
  text: string;
  /** Identifier, if the text changes. */
  key?: string;
  ink: Ink;
  /** Tip, in the space of the picture. */
  tip: Vector3;
  /** For objects other than arrows: points next to which the label may be placed. */
  along?: Vector3[];
  /** True if the label stands on one of the points, with a halo. */
  isOn?: boolean;
}

export interface PlacedLabel extends Label {
  /** Centre of the label, px. */
  x: number;
  y: number;
  /** Tip, px. */
  tipX: number;
  tipY: number;
  /** End of the line from the tip, and whether it is drawn. */
  endX: number;
  endY: number;
  led: boolean;
}

type Point = [number, number];

interface Made {
  span: HTMLSpanElement;
  line: SVGLineElement;
  w: number;
  h: number;
  text: string;
  /** Last place of the label, px. It stays near this place. */
  last: Point | null;
}

/** Areas of a picture for labels, px. */
interface Field {
  width: number;
  height: number;
  middle: Point;
  hull: Point[];
  /** Density along the arrows. */
  arrows: Density;
  /** Density along curves that have labels. */
  curves: Density;
}

const GAP = 8;
/** Distance between two labels, px. */
const APART = 3;

export class Labels {
  placed: PlacedLabel[] = [];
  readonly #host: HTMLElement;
  readonly #lines: SVGSVGElement;
  readonly #made = new Map<string, Made>();
  #corner: Corner | null = null;

  constructor(host: HTMLElement) {
    this.#host = host;
    this.#lines = svgElement("svg", { class: "leaders" });
    host.append(this.#lines);
    // Labels measured before the font was loaded are measured again.
    void document.fonts.ready.then(() => this.remeasure());
  }

  /** Measures the labels again, after a change of their type. */
  remeasure(): void {
    for (const made of this.#made.values()) measure(made);
  }

  /**
   * Draws labels. `outline`: points of the body's hull, in the space of the picture. `from`: origin
   * of its arrows. Arrows come before labels of other objects. No label is in `corner`.
   */
  draw(labels: Label[], outline: Vector3[], from: Vector3, camera: Camera, width: number, height: number, corner: Corner | null = null): void {
    this.#corner = corner;
    const project = (p: Vector3): Point => {
      const v = p.clone().project(camera);
      return [(0.5 + v.x / 2) * width, (0.5 - v.y / 2) * height];
    };
    const middle = project(from);
    const hull = outline.map(project);
    // Outer halves of the arrows, which no other label covers.
    const shafts = labels.map(({ tip, along }) => (along ? [] : dense([0.5, 1].map((part) => project(tip.clone().sub(from).multiplyScalar(part).add(from))))));
    const lines = labels.map(({ along }) => (along ?? []).map(project));
    const arrows = new Density(shafts.flat(), width, height);
    const curves = new Density(lines.flatMap(dense), width, height);
    const field = { width, height, middle, hull, arrows, curves };
    this.placed = [];
    const shown = new Set<string>();
    for (const [k, label] of labels.entries()) {
      const made = this.#element(label);
      const beside = (): { at: Point; tip: Point } | null => (label.isOn ? this.#upon(lines[k], made, field) : null) ?? this.#beside(lines[k], made, field);
      made.span.classList.toggle("on-line", label.isOn === true);
      const spot = label.along ? beside() : this.#outside(project(label.tip), shafts[k], made, field);
      if (!spot) continue;
      shown.add(label.key ?? label.text);
      this.#put(label, made, spot);
    }
    for (const [key, made] of this.#made) {
      made.span.hidden = !shown.has(key);
      if (!made.span.hidden) continue;
      made.line.style.display = "none";
      made.last = null;
    }
  }

  #put(label: Label, made: Made, { at: [x, y], tip: [tipX, tipY] }: { at: Point; tip: Point }): void {
    // Line from the edge of the text to the tip.
    const [dx, dy] = [tipX - x, tipY - y];
    const inside = Math.min(made.w / 2 / Math.max(Math.abs(dx), 1e-9), (made.h / 2 - 2) / Math.max(Math.abs(dy), 1e-9), 1);
    const gap = (1 - inside) * Math.hypot(dx, dy);
    const led = gap > (label.along ? 5 : 17);
    made.last = [x - tipX, y - tipY];
    const [endX, endY] = [x + inside * dx, y + inside * dy];
    this.placed.push({ ...label, x, y, tipX, tipY, endX, endY, led });
    made.span.style.transform = `translate(${(x - made.w / 2).toFixed(1)}px, ${(y - made.h / 2).toFixed(1)}px)`;
    made.span.style.color = `var(--${label.ink})`;
    made.line.style.stroke = `var(--${label.ink})`;
    made.line.style.display = led ? "" : "none";
    const ends = { x1: tipX, y1: tipY, x2: endX, y2: endY };
    for (const [name, value] of Object.entries(ends)) made.line.setAttribute(name, value.toFixed(1));
  }

  /** Finds a place at the tip of an arrow; null if there is no room. */
  #outside([tipX, tipY]: Point, own: Point[], made: Made, field: Field): { at: Point; tip: Point } | null {
    const { middle, hull, width, height, arrows, curves } = field;
    const [dx, dy] = [tipX - middle[0], tipY - middle[1]];
    const long = Math.hypot(dx, dy);
    const angle = long > 1 ? Math.atan2(dy, dx) : -Math.PI / 2;
    let second: Point | null = null;
    for (let ring = 0; ring < 4; ring += 1) {
      for (let turn = 0; turn < 52; turn += 1) {
        const a = angle + (turn % 2 === 0 ? 1 : -1) * Math.ceil(turn / 2) * 0.12;
        const [ux, uy] = [Math.cos(a), Math.sin(a)];
        // Beyond the hull's farthest point in this direction, the whole label is outside.
        const support = hull.reduce((far, [x, y]) => Math.max(far, (x - middle[0]) * ux + (y - middle[1]) * uy), 0);
        const half = (Math.abs(ux) * made.w + Math.abs(uy) * made.h) / 2;
        const reach = Math.max(support + half + GAP, turn === 0 ? long + half + GAP / 2 : long * 0.9) + 18 * ring;
        const x = Math.min(Math.max(middle[0] + reach * ux, made.w / 2 + 4), width - made.w / 2 - 4);
        const y = Math.min(Math.max(middle[1] + reach * uy, made.h / 2 + 4), height - made.h / 2 - 4);
        if (this.#isTaken(x, y, made)) continue;
        second ??= [x, y];
        // Its own arrow may be under it.
        const mine = own.filter(([px, py]) => near(px - x, py - y, made, 10, 10)).length;
        const crossed = arrows.count(x, y, made.w, made.h) > mine || curves.count(x, y, made.w, made.h) > 0;
        if (!crossed) return { at: [x, y], tip: [tipX, tipY] };
      }
    }
    return second && { at: second, tip: [tipX, tipY] };
  }

  /**
   * Finds the place next to one of some points with the least overlap; null if there is no room.
   */
  #beside(points: Point[], made: Made, field: Field): { at: Point; tip: Point } | null {
    const { width, height, hull, arrows, curves, middle } = field;
    let best: { at: Point; tip: Point } | null = null;
    let least = Infinity;
    const every = Math.max(1, Math.ceil(points.length / 24));
    for (let k = 0; k < points.length; k += every) {
      const tip = points[k];
      // Only points in the frame.
      if (tip[0] < 4 || tip[1] < 4 || tip[0] > width - 4 || tip[1] > height - 4) continue;
      for (const far of [14, 30, 52, 80, 115]) {
        for (let turn = 0; turn < 16; turn += 1) {
          const a = (turn / 16) * 2 * Math.PI;
          const [ux, uy] = [Math.cos(a), Math.sin(a)];
          const x = tip[0] + far * ux + (made.w / 2) * Math.sign(Math.round(2 * ux) / 2) * Math.min(1, 2 * Math.abs(ux));
          const y = tip[1] + far * uy + (made.h / 2) * Math.min(1, 2 * Math.abs(uy)) * Math.sign(uy);
          if (x - made.w / 2 < 4 || x + made.w / 2 > width - 4 || y - made.h / 2 < 4 || y + made.h / 2 > height - 4) continue;
          const crossed = arrows.count(x, y, made.w, made.h);
          const onCurve = Math.min(curves.count(x, y, made.w, made.h), 12);
          const moved = made.last ? Math.min(Math.hypot(x - tip[0] - made.last[0], y - tip[1] - made.last[1]), 60) : 0;
          let cost = far + 60 * crossed + 8 * onCurve + 0.4 * moved;
          if (cost >= least || this.#isTaken(x, y, made)) continue;
          if (isInside(hull, middle, x, y)) cost += 70;
          if (cost < least) [least, best] = [cost, { at: [x, y], tip }];
        }
      }
    }
    return best;
  }

  /**
   * Finds the point of a curve on which a label covers least, near its last place or the centre;
   * null if there is none.
   */
  #upon(points: Point[], made: Made, { width, height, arrows, curves, middle }: Field): { at: Point; tip: Point } | null {
    let best: Point | null = null;
    let least = Infinity;
    for (const [x, y] of points) {
      if (x - made.w / 2 < 4 || x + made.w / 2 > width - 4 || y - made.h / 2 < 4 || y + made.h / 2 > height - 4) continue;
      const covered = 60 * arrows.count(x, y, made.w, made.h) + 8 * curves.count(x, y, made.w, made.h);
      const cost = covered + 0.3 * Math.hypot(x - middle[0], y - middle[1]);
      if (cost >= least || this.#isTaken(x, y, made)) continue;
      [least, best] = [cost, [x, y]];
    }
    return best && { at: best, tip: best };
  }

  #isTaken(x: number, y: number, made: Made): boolean {
    const corner = this.#corner;
    if (corner && near(corner.x + corner.size / 2 - x, corner.y + corner.size / 2 - y, made, corner.size, corner.size)) return true;
    return this.placed.some((other) => {
      const o = this.#made.get(other.key ?? other.text);
      return o !== undefined && near(other.x - x, other.y - y, made, o.w + 2 * APART, o.h);
    });
  }

  #element(label: Label): Made {
    const key = label.key ?? label.text;
    let made = this.#made.get(key);
    if (!made) {
      const span = document.createElement("span");
      // Letters are typeset like formulas.
      span.className = [...label.text].length <= 2 ? "label symbol" : "label";
      const line = svgElement("line");
      this.#host.append(span);
      this.#lines.append(line);
      made = { span, line, w: 0, h: 0, text: "", last: null };
      this.#made.set(key, made);
    }
    made.span.hidden = false;
    if (made.text !== label.text) {
      made.text = label.text;
      made.span.textContent = label.text;
      measure(made);
    }
    return made;
  }
}

// Returns points of a line, some pixels apart.
function dense(points: Point[]): Point[] {
  const all: Point[] = [];
  points.forEach(([x, y], k) => {
    const [u, v] = points[k + 1] ?? [x, y];
    const count = Math.min(Math.ceil(Math.hypot(u - x, v - y) / 8), 24) || 1;
    for (let i = 0; i < count; i += 1) all.push([x + (i / count) * (u - x), y + (i / count) * (v - y)]);
  });
  return all;
}

function measure(made: Made): void {
  const hidden = made.span.hidden;
  made.span.hidden = false;
  made.w = made.span.offsetWidth;
  made.h = made.span.offsetHeight;
  made.span.hidden = hidden;
}

// Returns true if a box of w × h overlaps a label whose centre is at (dx, dy) from its own.
function near(dx: number, dy: number, made: Made, w: number, h: number): boolean {
  return Math.abs(dx) < (made.w + w) / 2 && Math.abs(dy) < (made.h + h) / 2;
}

// Returns true if a place is nearer to the centre than the hull in the same direction.
function isInside(hull: Point[], middle: Point, x: number, y: number): boolean {
  const [dx, dy] = [x - middle[0], y - middle[1]];
  const long = Math.hypot(dx, dy) || 1;
  return hull.some(([px, py]) => ((px - middle[0]) * dx + (py - middle[1]) * dy) / long > long);
}
