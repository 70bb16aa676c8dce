/** The uniform box of the body's mass and tensor: as glass, with its edges, so that the body is seen in it. */
import { BoxGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial } from "three";
import type { BodyData } from "../data";
import type { Layer } from "./layers";
import type { Palette } from "./palette";

/** A layer that is off at first; none if the mass is not known. `radius` is length 1 of the picture, m. */
export function equivalentBox(data: BodyData, radius: number, palette: Palette): Layer[] {
  if (!data.box) return [];
  const largest = Math.max(...data.box.size, Number.MIN_VALUE);
  // A plate's box has no thickness; what has none cannot be lit.
  const geometry = new BoxGeometry(...data.box.size.map((edge) => Math.max(edge, 0.002 * largest) / radius));
  const glass = palette.shared("glass", "axis-1", () => new MeshStandardMaterial({ transparent: true, opacity: 0.18, depthWrite: false }));
  const edge = palette.shared("glass edge", "axis-1", () => new LineBasicMaterial());
  const object = new Group();
  object.add(new Mesh(geometry, glass), new LineSegments(new EdgesGeometry(geometry), edge));
  const [w, x, y, z] = data.box.quaternion;
  object.quaternion.set(x, y, z, w).normalize();
  object.position.set(...data.lever).divideScalar(radius);
  return [{ id: "box", label: "Equivalent box", ink: "axis-1", look: "area", on: { body: false }, objects: [object] }];
}
