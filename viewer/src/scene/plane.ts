/** A round piece of a plane perpendicular to z, with rings and radii. */
import { CircleGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { curve } from "./lines";
import type { Palette } from "./palette";

export function plane(reach: number, palette: Palette): Group {
  const group = new Group();
  const look = { transparent: true, opacity: 0.1, side: DoubleSide, depthWrite: false };
  const material = palette.shared("plane", "ink", () => new MeshBasicMaterial(look));
  group.add(new Mesh(new CircleGeometry(reach, 96), material));
  for (const part of [0.25, 0.5, 0.75, 1]) {
    const ring = Array.from({ length: 97 }, (_, i) => {
      const a = (i / 96) * 2 * Math.PI;
      return [Math.cos(a), Math.sin(a), 0];
    }).flat();
    group.add(curve(ring, part * reach, { ink: "faint", width: 1, opacity: part === 1 ? 0.9 : 0.5 }, palette));
  }
  for (const a of [0, 1, 2, 3, 4, 5].map((k) => (k * Math.PI) / 6)) {
    const [c, s] = [Math.cos(a) * reach, Math.sin(a) * reach];
    group.add(curve([-c, -s, 0, c, s, 0], 1, { ink: "faint", width: 1, opacity: 0.35 }, palette));
  }
  return group;
}

/** Returns points around its edge. */
export function rim(reach: number): Vector3[] {
  return Array.from({ length: 24 }, (_, k) => {
    const a = (k / 24) * 2 * Math.PI;
    return new Vector3(Math.cos(a), Math.sin(a), 0).multiplyScalar(reach);
  });
}
