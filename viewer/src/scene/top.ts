/**
 * Objects of a heavy body at a pivot: the path of its axis, the circles that bound its nutation,
 * the floor, and the arrow of gravity at the centre of mass.
 */
import { Group, Vector3 } from "three";
import { rotate, type Quaternion, type Vector } from "../attitude";
import type { PageData, TopData } from "../data";
import { length, type Motion } from "../motion";
import { axisPath, directionOf } from "../plot/axis-path";
import { Arrow } from "./arrows";
import type { BodyModel } from "./body";
import type { Label } from "./labels";
import type { Layer } from "./layers";
import { curve } from "./lines";
import type { Palette } from "./palette";
import { plane, rim } from "./plane";
import { Shadow } from "./shadow";

const FLOOR = 0.95;

export class HeavyBody {
  readonly layers: Layer[] = [];
  readonly objects: Group[] = [];
  /** Circles with their labels: points of each. */
  readonly #circles: { text: string; points: Vector3[] }[] = [];
  /** Points of the rim of the floor. */
  #floor: Vector3[] = [];
  readonly #arrow: Arrow;
  readonly #lever: Vector;
  readonly #down: Vector3;
  #shadow: Shadow | null = null;

  /**
   * Makes the objects; null without gravity. `reach`: length of the axis.
   */
  static of(page: PageData, motion: Motion, { radius, outline }: BodyModel, reach: number, palette: Palette): HeavyBody | null {
    const { gravity } = page.scene;
    return gravity && length(gravity) > 0 ? new HeavyBody(page, gravity, motion, radius, outline, reach, palette) : null;
  }

  private constructor(page: PageData, gravity: Vector, motion: Motion, unit: number, outline: readonly Vector3[], reach: number, palette: Palette) {
    this.#down = new Vector3(...gravity).normalize();
    this.#lever = page.body.lever.map((x) => x / unit) as Vector;
    this.#arrow = new Arrow("quiet", 0.014, palette);
    const arrow = this.#arrow.object;
    this.#put({ id: "gravity", label: "Gravity g", ink: "quiet", look: "arrow", on: { body: true }, objects: [arrow] }, arrow);
    if (page.top) this.#axis(page.top, motion, reach, palette);
    if (standsUpright(motion, page.body.lever, this.#down)) {
      const floor = plane(FLOOR, palette);
      floor.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), this.#down.clone().negate());
      this.#shadow = new Shadow(this.#down.clone().negate(), outline, palette);
      this.#floor = rim(FLOOR).map((p) => p.applyQuaternion(floor.quaternion));
      this.#put({ id: "floor", label: "Floor", ink: "faint", look: "area", on: { body: true }, objects: [floor, this.#shadow.object] }, floor);
      const below = new Group();
      below.add(this.#shadow.object);
      this.objects.push(below);
    }
  }

  #put(layer: Layer, object: Group): void {
    this.layers.push(layer);
    this.objects.push(object);
  }

  #axis(top: TopData, motion: Motion, reach: number, palette: Palette): void {
    const path = axisPath(motion, top);
    if ("points" in path && path.points.length > 1) {
      const drawn = new Group();
      drawn.add(curve(path.points.flat(), reach, { ink: "contour", width: 1.2, opacity: 0.55 }, palette));
      this.#put({ id: "path", label: "Path of the axis", ink: "contour", look: "line", on: { body: true }, objects: [drawn] }, drawn);
    }
    if (top.bounds === null) return;
    const circles = new Group();
    const bounds = top.bounds[1] - top.bounds[0] > 1e-6 ? top.bounds : [top.bounds[0]];
    bounds.forEach((angle, k) => {
      if (Math.sin(angle) < 1e-6) return;
      const points = Array.from({ length: 129 }, (_, i) => new Vector3(...directionOf(angle, (i / 64) * Math.PI, top)).multiplyScalar(reach));
      circles.add(curve(points.flatMap((p) => p.toArray()), 1, { ink: "axis-2", width: 1.6, opacity: 0.9 }, palette));
      this.#circles.push({ text: bounds.length > 1 ? (k === 0 ? "𝜃₁" : "𝜃₂") : "𝜃", points });
    });
    if (circles.children.length === 0) return;
    const label = bounds.length > 1 ? "Circles θ₁, θ₂" : "Circle θ";
    this.#put({ id: "bounds", label, ink: "axis-2", look: "line", on: { body: true }, objects: [circles] }, circles);
  }

  /** `turned` converts a place in the body to space. */
  pose(attitude: Quaternion, turned: (p: Vector3) => Vector3): void {
    this.#shadow?.pose(turned);
    const middle = new Vector3(...rotate(attitude, this.#lever));
    this.#arrow.object.position.copy(middle);
    this.#arrow.point(...(this.#down.clone().multiplyScalar(0.62).toArray() as Vector));
  }

  floor(on: (id: string) => boolean): Vector3[] {
    return on("floor") ? this.#floor : [];
  }

  /** Returns labels of visible layers. */
  labels(on: (id: string) => boolean): Label[] {
    const labels: Label[] = [];
    if (on("gravity")) {
      labels.push({ text: "𝐠", ink: "quiet", tip: this.#arrow.tip.clone().add(this.#arrow.object.position) });
    }
    if (!on("bounds")) return labels;
    for (const { text, points } of this.#circles) labels.push({ text, ink: "axis-2", tip: points[0], along: points });
    return labels;
  }
}

/**
 * Returns true if the centre of mass stays above the pivot, so that a floor would not be in its
 * way.
 */
function standsUpright(motion: Motion, lever: Vector, down: Vector3): boolean {
  for (let i = 0; i < motion.count; i += 1) {
    if (new Vector3(...rotate(motion.attitudeOf(i), lever)).dot(down) >= 0) return false;
  }
  return true;
}
