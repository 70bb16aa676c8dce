/**
 * Geometry of a solid and its edges. Simple solids share one scaled geometry, so that a change of
 * size creates no new one. Round solids have marks, quarters in two shades.
 */
import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  EdgesGeometry,
  LatheGeometry,
  SphereGeometry,
  TorusGeometry,
  Vector2,
} from "three";
import type { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Shape } from "../data";
import { BadData, f32, indices } from "../decode";
import { kept } from "./dispose";
import { segments } from "./lines";
import { creased } from "./normals";

const ROUND = 64;
/**
 * Maximum number of triangles of a mesh with edges. Edges of a larger one would cover it with ink,
 * and take long to compute.
 */
const EDGES_UP_TO = 20_000;

export type Solid = Exclude<Shape, { kind: "balls" }>;

/** Geometry of a solid and its scaling. */
export interface Form {
  geometry: BufferGeometry;
  edges: LineSegmentsGeometry | null;
  scale: [number, number, number];
}

const UNIT: [number, number, number] = [1, 1, 1];

export function formOf(shape: Solid): Form {
  switch (shape.kind) {
    case "box":
      return { ...simple("box", () => ({ geometry: new BoxGeometry(1, 1, 1), edges: sharp(new BoxGeometry(1, 1, 1)) })), scale: shape.size };
    case "ellipsoid":
      return { geometry: ELLIPSOID, edges: null, scale: shape.half };
    case "cylinder": {
      const { radius, inner, height } = shape;
      if (inner === 0) {
        const make = (): Simple => ({ geometry: marked(upright(new CylinderGeometry(1, 1, 1, ROUND)), quadrants), edges: rings([1, 0.5], [1, -0.5]) });
        return { ...simple("cylinder", make), scale: [radius, radius, height] };
      }
      const h = height / 2;
      const edges = rings([radius, h], [radius, -h], [inner, h], [inner, -h]);
      return { geometry: marked(upright(tube(inner, radius, height)), quadrants), edges, scale: UNIT };
    }
    case "cone": {
      const { bottom, top, height } = shape;
      if (top === 0) {
        const make = (): Simple => ({ geometry: marked(upright(new ConeGeometry(1, 1, ROUND)), quadrants), edges: rings([1, -0.5]) });
        return { ...simple("cone", make), scale: [bottom, bottom, height] };
      }
      const geometry = marked(upright(new CylinderGeometry(top, bottom, height, ROUND)), quadrants);
      return { geometry, edges: rings([top, height / 2], [bottom, -height / 2]), scale: UNIT };
    }
    case "capsule":
      return { geometry: marked(upright(new CapsuleGeometry(shape.radius, shape.height, 16, ROUND)), quadrants), edges: null, scale: UNIT };
    case "torus":
      return { geometry: marked(new TorusGeometry(shape.radius, shape.tube, 32, 2 * ROUND), quadrants), edges: null, scale: UNIT };
    case "mesh": {
      const vertices = f32(shape.vertices, `${shape.name}: vertices`);
      if (vertices.length % 3 !== 0) throw new BadData(`${shape.name}: vertices are not points`);
      const triangles = indices(shape.triangles, `${shape.name}: triangles`, vertices.length / 3);
      const geometry = creased(vertices, triangles.subarray(0, triangles.length - (triangles.length % 3)));
      return { geometry, edges: triangles.length / 3 <= EDGES_UP_TO ? sharp(geometry) : null, scale: UNIT };
    }
  }
}

type Simple = Pick<Form, "geometry" | "edges">;
const made = new Map<string, Simple>();

function simple(kind: string, make: () => Simple): Simple {
  const known = made.get(kind);
  if (known) return known;
  const { geometry, edges } = make();
  const form = { geometry: kept(geometry), edges: edges && kept(edges) };
  made.set(kind, form);
  return form;
}

// Makes circles about z, with these radii at these heights.
function rings(...all: [radius: number, height: number][]): LineSegmentsGeometry {
  const ends = new Float32Array(6 * ROUND * all.length);
  all.forEach(([radius, height], ring) => {
    for (let k = 0; k < 2 * ROUND; k += 1) {
      const a = (Math.ceil(k / 2) / ROUND) * 2 * Math.PI;
      ends.set([radius * Math.cos(a), radius * Math.sin(a), height], 3 * (2 * ROUND * ring + k));
    }
  });
  return segments(ends);
}

// Makes edges where faces meet at more than 35°.
function sharp(geometry: BufferGeometry): LineSegmentsGeometry {
  return segments(new EdgesGeometry(geometry, 35).attributes.position.array);
}

// The round solids of three.js are along y.
function upright(geometry: BufferGeometry): BufferGeometry {
  return geometry.rotateX(Math.PI / 2);
}

// Makes a profile with sharp corners: each of its sides has its own points.
function tube(inner: number, outer: number, height: number): BufferGeometry {
  const h = height / 2;
  const corners = [
    [inner, h],
    [inner, -h],
    [outer, -h],
    [outer, h],
    [inner, h],
  ].map(([x, y]) => new Vector2(x, y));
  const sides = corners.slice(1).map((end, k) => new LatheGeometry([corners[k], end], ROUND).toNonIndexed());
  const joined = sides[0];
  for (const name of ["position", "normal", "uv"] as const) {
    const size = name === "uv" ? 2 : 3;
    const all = sides.flatMap((side) => [...(side.attributes[name].array as Float32Array)]);
    joined.setAttribute(name, new BufferAttribute(new Float32Array(all), size));
  }
  return joined;
}

function octants(x: number, y: number, z: number): boolean {
  return x * y * z > 0;
}

function quadrants(x: number, y: number): boolean {
  return x * y > 0;
}

// Marks faces with a darker shade if their centres fulfil the rule.
function marked(geometry: BufferGeometry, rule: (x: number, y: number, z: number) => boolean): BufferGeometry {
  const plain = geometry.index ? geometry.toNonIndexed() : geometry;
  const p = plain.attributes.position.array;
  const colors = new Float32Array(p.length).fill(1);
  for (let i = 0; i < p.length; i += 9) {
    if (rule(p[i] + p[i + 3] + p[i + 6], p[i + 1] + p[i + 4] + p[i + 7], p[i + 2] + p[i + 5] + p[i + 8])) colors.fill(0.6, i, i + 9);
  }
  plain.setAttribute("color", new BufferAttribute(colors, 3));
  return plain;
}

/** A ball of radius 1. */
export const ELLIPSOID = kept(marked(upright(new SphereGeometry(1, ROUND, ROUND / 2)), octants));
