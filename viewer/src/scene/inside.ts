/** Parts inside others: a solid with a part inside is drawn transparent, so that both are seen. */
import { Quaternion, Vector3 } from "three";
import type { Shape } from "../data";

/** Number of points of a part that are examined. */
const POINTS = 60;

/** Returns true for each shape that has another one inside. `points`: points of each, body axes, m. */
export function enclosing(shapes: readonly Shape[], points: readonly Float64Array[]): boolean[] {
  return shapes.map((shape, k) => {
    const contains = insideOf(shape);
    return contains !== null && points.some((other, j) => j !== k && other.length > 0 && isInside(other, contains));
  });
}

function isInside(points: Float64Array, contains: (p: Vector3) => boolean): boolean {
  const stride = 3 * Math.max(Math.floor(points.length / (3 * POINTS)), 1);
  const point = new Vector3();
  for (let i = 0; i < points.length; i += stride) if (!contains(point.fromArray(points, i))) return false;
  return true;
}

/** Returns the test whether a point is in a simple shape; null for the others. */
function insideOf(shape: Shape): ((p: Vector3) => boolean) | null {
  const [w, x, y, z] = shape.quaternion;
  const back = new Quaternion(x, y, z, w).normalize().invert();
  const place = new Vector3(...shape.position);
  const test = (within: (p: Vector3) => boolean) => (p: Vector3) => within(p.sub(place).applyQuaternion(back));
  switch (shape.kind) {
    case "box":
      return test((p) => p.toArray().every((c, k) => Math.abs(c) < 0.5 * shape.size[k]));
    case "ellipsoid":
      return test((p) => p.toArray().reduce((sum, c, k) => sum + (c / shape.half[k]) ** 2, 0) < 1);
    case "cylinder":
      return test((p) => Math.hypot(p.x, p.y) < shape.radius && Math.abs(p.z) < 0.5 * shape.height);
    case "capsule":
      return test((p) => p.setZ(Math.max(Math.abs(p.z) - 0.5 * shape.height, 0)).length() < shape.radius);
    default:
      return null;
  }
}
