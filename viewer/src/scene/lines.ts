/** Curves of some pixels' width. */
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { InterleavedBufferAttribute } from "three";
import type { Ink, Palette } from "./palette";

export interface Pen {
  ink: Ink;
  /** px */
  width: number;
  opacity?: number;
  /** Below 1 the ink is mixed with the paper's colour. */
  strength?: number;
  /** Drawn over everything. */
  onTop?: boolean;
}

/** A curve that stays as it is; `points` are x y z of each, `scale` is multiplied to all. */
export function curve(points: ArrayLike<number>, scale: number, pen: Pen, palette: Palette): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(Float32Array.from(points, (x) => x * scale));
  return line(geometry, pen, palette);
}

/** Straight lines; `ends` are x y z of both ends of each. */
export function segments(ends: ArrayLike<number>, material: LineMaterial): LineSegments2 {
  return new LineSegments2(new LineSegmentsGeometry().setPositions(Float32Array.from(ends)), material);
}

/** A curve of at most `capacity` points that changes in every picture. */
export class MovingCurve {
  readonly object: Line2;
  readonly #ends: InterleavedBufferAttribute;
  readonly #capacity: number;

  constructor(capacity: number, pen: Pen, palette: Palette) {
    this.#capacity = capacity;
    const geometry = new LineGeometry();
    geometry.setPositions(new Float32Array(3 * capacity));
    this.object = line(geometry, pen, palette);
    this.object.frustumCulled = false;
    this.#ends = geometry.attributes.instanceStart as InterleavedBufferAttribute;
  }

  /** `point(k, out)` writes the k-th of `count` points. */
  draw(count: number, point: (k: number, out: Float32Array) => void): void {
    const n = Math.min(count, this.#capacity);
    this.object.visible = n > 1;
    if (n < 2) return;
    // Each segment holds both of its ends.
    const ends = this.#ends.data.array as Float32Array;
    const here = new Float32Array(3);
    for (let k = 0; k < n; k += 1) {
      point(k, here);
      if (k < n - 1) ends.set(here, 6 * k);
      if (k > 0) ends.set(here, 6 * k - 3);
    }
    this.#ends.data.needsUpdate = true;
    this.object.geometry.instanceCount = n - 1;
  }
}

export function lineMaterial(pen: Pen, palette: Palette): LineMaterial {
  const material = new LineMaterial({
    linewidth: pen.width,
    transparent: (pen.opacity ?? 1) < 1 || pen.onTop === true,
    opacity: pen.opacity ?? 1,
    depthTest: pen.onTop !== true,
    depthWrite: false,
  });
  palette.bind(material.color, pen.ink, pen.strength);
  return material;
}

function line(geometry: LineGeometry, pen: Pen, palette: Palette): Line2 {
  const made = new Line2(geometry, lineMaterial(pen, palette));
  made.renderOrder = pen.onTop === true ? 10 : 2;
  return made;
}
