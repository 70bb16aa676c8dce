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
  /** Distance of a place from the middle, 1 at the edge: towards it the patch fades. */
  fade?: (u: number, v: number) => number;
}

/** Opacity of the lines, and where a fading patch is fainter. */
const LINES = 0.6;
const BANDS: [from: number, to: number, opacity: number][] = [
  [0, 0.6, LINES],
  [0.6, 0.7, 0.75 * LINES],
  [0.7, 0.8, 0.5 * LINES],
  [0.8, 0.88, 0.25 * LINES],
  [0.88, 0.95, 0.1 * LINES],
];

export function patch({ at, u, v, alongU, alongV, fade }: Patch, palette: Palette): Group {
  const group = new Group();
  const look = { transparent: true, opacity: 0.1, side: DoubleSide, depthWrite: false, vertexColors: fade !== undefined };
  const material = palette.shared(fade ? "fading ground" : "ground", "ink", () => new MeshBasicMaterial(look));
  group.add(new Mesh(sheet(at, u, v, fade), material));
  const mixed = ([from, to]: [number, number], part: number): number => from + part * (to - from);
  const bands = fade ? BANDS : [[0, Infinity, LINES] as const];
  const ends = bands.map((): number[] => []);
  const line = (place: (part: number) => [number, number]): void => {
    for (let k = 0; k < FINE; k += 1) {
      const far = fade?.(...place((k + 0.5) / FINE)) ?? 0;
      const band = bands.findIndex(([from, to]) => far >= from && far < to);
      if (band >= 0) for (const part of [k / FINE, (k + 1) / FINE]) ends[band].push(...at(...place(part)).toArray());
    }
  };
  for (const a of alongV) line((part) => [a, mixed(v, part)]);
  for (const b of alongU) line((part) => [mixed(u, part), b]);
  bands.forEach(([, , opacity], k) => {
    if (ends[k].length === 0) return;
    const lines = new LineSegments2(segments(ends[k]), lineMaterial({ ink: "faint", width: 1, opacity }, palette));
    lines.renderOrder = 1;
    group.add(lines);
  });
  return group;
}

function sheet(at: Patch["at"], u: [number, number], v: [number, number], fade: Patch["fade"]): BufferGeometry {
  const n = FINE + 1;
  const colors = new Float32Array(4 * n * n).fill(1);
  const points = new Float32Array(3 * n * n);
  const triangles: number[] = [];
  for (let i = 0; i < n; i += 1) {
    for (let j = 0; j < n; j += 1) {
      const place: [number, number] = [u[0] + (i / FINE) * (u[1] - u[0]), v[0] + (j / FINE) * (v[1] - v[0])];
      at(...place).toArray(points, 3 * (n * i + j));
      if (fade) colors[4 * (n * i + j) + 3] = Math.min(Math.max((1 - fade(...place)) / 0.5, 0), 1);
      if (i === FINE || j === FINE) continue;
      const k = n * i + j;
      triangles.push(k, k + n, k + 1, k + 1, k + n, k + n + 1);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  if (fade) geometry.setAttribute("color", new BufferAttribute(colors, 4));
  geometry.setIndex(triangles);
  return geometry;
}
