/** A piece of a surface with lines on it, transparent and visible from both sides. */
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, type Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { lineMaterial, segments } from "./lines";
import type { Palette } from "./palette";

/** Number of pieces of a side, so that a round one looks round. */
const FINE = 72;

export interface Patch {
  at: (u: number, v: number) => Vector3;
  u: [number, number];
  v: [number, number];
  /** Places of the lines of constant u, and of constant v. */
  alongV: number[];
  alongU: number[];
}

export function patch({ at, u, v, alongU, alongV }: Patch, palette: Palette): Group {
  const group = new Group();
  const look = { transparent: true, opacity: 0.1, side: DoubleSide, depthWrite: false };
  const material = palette.shared("ground", "ink", () => new MeshBasicMaterial(look));
  group.add(new Mesh(sheet(at, u, v), material));
  const ends: number[] = [];
  const line = (point: (part: number) => Vector3): void => {
    for (let k = 0; k < FINE; k += 1) for (const part of [k / FINE, (k + 1) / FINE]) ends.push(...point(part).toArray());
  };
  const mixed = ([from, to]: [number, number], part: number): number => from + part * (to - from);
  for (const a of alongV) line((part) => at(a, mixed(v, part)));
  for (const b of alongU) line((part) => at(mixed(u, part), b));
  const lines = new LineSegments2(segments(ends), lineMaterial({ ink: "faint", width: 1, opacity: 0.6 }, palette));
  lines.renderOrder = 1;
  group.add(lines);
  return group;
}

function sheet(at: Patch["at"], u: [number, number], v: [number, number]): BufferGeometry {
  const n = FINE + 1;
  const points = new Float32Array(3 * n * n);
  const triangles: number[] = [];
  for (let i = 0; i < n; i += 1) {
    for (let j = 0; j < n; j += 1) {
      at(u[0] + (i / FINE) * (u[1] - u[0]), v[0] + (j / FINE) * (v[1] - v[0])).toArray(points, 3 * (n * i + j));
      if (i === FINE || j === FINE) continue;
      const k = n * i + j;
      triangles.push(k, k + n, k + 1, k + 1, k + n, k + n + 1);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  return geometry;
}
