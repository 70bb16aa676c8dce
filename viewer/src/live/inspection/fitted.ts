/**
 * Scaling of an object of any size and place: its centre at the origin, and 1 from there to its
 * farthest point.
 */
import { Box3, Group, type Object3D, Sphere, Vector3 } from "three";
import { Farthest } from "../../scene/framing";

const DIRECTIONS = 300;

export class Fitted {
  readonly group = new Group();
  /** Outermost points in coordinates of the picture. */
  readonly points: Vector3[];
  readonly #middle: Vector3;
  readonly #size: number;

  /** `points`: all visible points of the object. */
  constructor(object: Object3D, points: Vector3[]) {
    const { center, radius } = new Box3().setFromPoints(points.length > 0 ? points : [new Vector3()]).getBoundingSphere(new Sphere());
    this.#middle = center;
    this.#size = radius || 1;
    this.group.add(object);
    this.group.scale.setScalar(1 / this.#size);
    this.group.position.copy(center).divideScalar(-this.#size);
    this.points = outermost(this.toPicture(points));
  }

  toPicture(points: Vector3[]): Vector3[] {
    return points.map((p) => p.clone().sub(this.#middle).divideScalar(this.#size));
  }
}

/** Returns points whose convex hull is nearly that of all points. */
export function outermost(points: Vector3[]): Vector3[] {
  const farthest = new Farthest(DIRECTIONS);
  for (const p of points) farthest.add(p);
  return points.length > 0 ? farthest.points : [];
}

/** Returns the corners of a box around some points, whose half diagonal is at least `least`. */
export function box(points: Vector3[], least: number): Vector3[] {
  const around = new Box3().setFromPoints(points);
  const middle = around.getCenter(new Vector3());
  const half = around.getSize(new Vector3()).multiplyScalar(0.5);
  const size = Math.max(half.length(), least) / Math.sqrt(3);
  half.max(new Vector3(size, size, size));
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => half.clone().multiply(new Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)).add(middle));
}
