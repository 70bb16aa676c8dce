/** Curves with a width in pixels. */
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { GreaterDepth, type InterleavedBufferAttribute } from "three";
import type { Ink, Palette } from "./palette";

export interface Pen {
  ink: Ink;
  /** Width, px. */
  width: number;
  opacity?: number;
  /** Below 1, the ink is mixed with the colour of the paper. */
  strength?: number;
  /** True if drawn over everything. */
  onTop?: boolean;
  /** True if drawn only where something hides it. */
  behind?: boolean;
}

/** Makes a constant curve; `points` are x y z of each, multiplied by `scale`. */
export function curve(points: ArrayLike<number>, scale: number, pen: Pen, palette: Palette): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(Float32Array.from(points, (x) => x * scale));
  return line(geometry, pen, palette);
}

/** Makes straight lines; `ends` are x y z of both ends of each. */
export function segments(ends: ArrayLike<number>): LineSegmentsGeometry {
  return new LineSegmentsGeometry().setPositions(Float32Array.from(ends));
}

/** Returns x y z of both ends of each line. */
export function endsOf(lines: LineSegmentsGeometry): ArrayLike<number> {
  return (lines.attributes.instanceStart as InterleavedBufferAttribute).data.array;
}

/** A curve of at most `capacity` points that changes in every frame. */
export class MovingCurve {
  readonly object: Line2;
  readonly #ends: InterleavedBufferAttribute;
  readonly #capacity: number;
  readonly #here = new Float32Array(3);
  readonly #palette: Palette;

  constructor(capacity: number, pen: Pen, palette: Palette) {
    this.#capacity = capacity;
    this.#palette = palette;
    const geometry = new LineGeometry();
    geometry.setPositions(new Float32Array(3 * capacity));
    this.object = line(geometry, pen, palette);
    this.object.frustumCulled = false;
    this.#ends = geometry.attributes.instanceStart as InterleavedBufferAttribute;
  }

  recolor(pen: Pen): void {
    this.object.material = lineMaterial(pen, this.#palette);
  }

  /** Draws `count` points; `point(k, out)` writes the k-th. */
  draw(count: number, point: (k: number, out: Float32Array) => void): void {
    const n = Math.min(count, this.#capacity);
    this.object.visible = n > 1;
    if (n < 2) return;
    // Each segment stores both of its ends.
    const ends = this.#ends.data.array as Float32Array;
    const here = this.#here;
    for (let k = 0; k < n; k += 1) {
      point(k, here);
      const x = here[0];
      const y = here[1];
      const z = here[2];
      const at = 6 * k;
      if (k < n - 1) {
        ends[at] = x;
        ends[at + 1] = y;
        ends[at + 2] = z;
      }
      if (k > 0) {
        ends[at - 3] = x;
        ends[at - 2] = y;
        ends[at - 1] = z;
      }
    }
    this.#ends.data.clearUpdateRanges();
    this.#ends.data.addUpdateRange(0, 6 * (n - 1));
    this.#ends.data.needsUpdate = true;
    this.object.geometry.instanceCount = n - 1;
  }
}

function line(geometry: LineGeometry, pen: Pen, palette: Palette): Line2 {
  const made = new Line2(geometry, lineMaterial(pen, palette));
  made.renderOrder = pen.onTop === true ? 10 : 2;
  return made;
}

export function lineMaterial({ ink, width, opacity = 1, strength = 1, onTop = false, behind = false }: Pen, palette: Palette): LineMaterial {
  const hidden = behind ? { depthFunc: GreaterDepth } : {};
  const look = { linewidth: width, transparent: opacity < 1 || onTop, opacity, depthTest: !onTop, depthWrite: false, ...hidden };
  return palette.shared(`line ${width} ${opacity} ${onTop} ${behind}`, ink, () => new LineMaterial(look), strength);
}
