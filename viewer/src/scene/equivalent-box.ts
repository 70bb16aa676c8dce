/**
 * The uniform box with the body's mass and tensor, as glass with edges, so that the body is visible
 * inside.
 */
import { BoxGeometry, EdgesGeometry, Group, Mesh, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import type { BodyData } from "../data";
import type { Layer } from "./layers";
import { lineMaterial, segments } from "./lines";
import type { Palette } from "./palette";

/**
 * Makes a layer that is off at first; none if the mass is not known. `radius` is length 1 of the
 * picture, m.
 */
export function equivalentBox(data: BodyData, radius: number, palette: Palette): Layer[] {
  if (!data.box) return [];
  const largest = Math.max(...data.box.size, Number.MIN_VALUE);
  // The box of a plate has no thickness, but a shaded box needs some.
  const geometry = new BoxGeometry(...data.box.size.map((edge) => Math.max(edge, 0.002 * largest) / radius));
  const glass = palette.shared("glass", "axis-1", () => new MeshStandardMaterial({ transparent: true, opacity: 0.18, depthWrite: false }));
  const edges = segments(new EdgesGeometry(geometry).attributes.position.array);
  const object = new Group();
  object.add(new Mesh(geometry, glass), new LineSegments2(edges, lineMaterial({ ink: "axis-1", width: 1 }, palette)));
  const [w, x, y, z] = data.box.quaternion;
  object.quaternion.set(x, y, z, w).normalize();
  object.position.set(...data.lever).divideScalar(radius);
  return [{ id: "box", label: "Equivalent box", ink: "axis-1", look: "area", on: { body: false }, objects: [object] }];
}

/** Returns the corners of the box, in the picture. */
export function corners({ box, lever }: BodyData, radius: number): Vector3[] {
  if (!box) return [];
  const [w, x, y, z] = box.quaternion;
  const turn = new Quaternion(x, y, z, w).normalize();
  const half = new Vector3(...box.size).multiplyScalar(0.5);
  const middle = new Vector3(...lever);
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => {
    const corner = half.clone().multiply(new Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    return corner.applyQuaternion(turn).add(middle).divideScalar(radius);
  });
}
