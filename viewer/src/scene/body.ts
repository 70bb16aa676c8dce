/**
 * Shape of the body, in body axes. Each part has a colour, parts of one name the same. Round shapes
 * have marks, quarters in two shades, that make rotation visible. In the picture, the distance from the centre of rotation to the body's farthest
 * part is 1.
 */
import {
  Color,
  CylinderGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import type { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { grouped } from "../format";
import type { BodyData, Indices, Shape } from "../data";
import { BadData, f32 } from "../decode";
import { ELLIPSOID, formOf, type Solid } from "./form";
import { directions, Farthest } from "./framing";
import { enclosing } from "./inside";
import { endsOf, lineMaterial } from "./lines";
import type { Ink, Palette } from "./palette";

/** Relative size of a part below which it is small compared with its distance. */
const SMALL = 0.1;
/** Colours of parts, in their order. */
export const PARTS = ["part-1", "part-2", "part-3", "part-4", "part-5", "part-6"] as const;
/** Stride between points that are examined one after the other. */
const LEAP = 101;

export class BodyModel {
  /** The shapes, or the ellipsoid if there are none. */
  readonly shapes: Group;
  /** The ellipsoid of the same mass and tensor. */
  readonly ellipsoid: Group;
  /**
   * Length 1 of the picture, m: radius of the body without small distant parts, such as a tip mass
   * on a boom.
   */
  readonly radius: number;
  /** Points on the outside of the shapes, and of the ellipsoid, in coordinates of the picture. */
  readonly outline: Vector3[];
  readonly ellipsoidOutline: Vector3[];
  /** Text such as "20,000 of 200,000 triangles", if a mesh was made coarser. */
  readonly coarser: string | null;
  readonly hasShapes: boolean;
  readonly #solids: Solids;

  /**
   * `before` is the previous body. Its shapes are reused if they are the same, and its scale if
   * this body has a similar size. The body is transparent if `isOpen`.
   */
  constructor(data: BodyData, isOpen: boolean, palette: Palette, before: BodyModel | null) {
    this.hasShapes = data.shapes.length > 0;
    this.ellipsoid = equimomental(data, paint(palette, "part-1", isOpen));
    const same = before !== null && before.#solids.of === data.shapes && before.#solids.isOpen === isOpen;
    this.#solids = same ? before.#solids : new Solids(data.shapes, isOpen, palette);
    this.shapes = this.#solids.group;
    this.coarser = this.#solids.coarser;
    const ellipsoid = farthestOf(data);
    const all = this.hasShapes ? this.#solids.farthest : ellipsoid;
    // The camera does not go back for small distant parts, such as a tip mass.
    const shapes = this.hasShapes && this.#solids.main.length > 0 ? this.#solids.main : all;
    const farthest = Math.max(...all.map((p) => p.length())) || 1;
    const own = this.hasShapes ? Math.min(this.#solids.bulk, farthest) : farthest;
    const isLike = before !== null && own > 0.55 * before.radius && own < 1.35 * before.radius;
    this.radius = isLike ? before.radius : own;
    for (const group of [this.shapes, this.ellipsoid]) group.scale.setScalar(1 / this.radius);
    const scaled = (points: Vector3[]): Vector3[] => points.map((p) => p.clone().divideScalar(this.radius));
    this.outline = scaled(shapes);
    this.ellipsoidOutline = this.hasShapes ? scaled(ellipsoid) : this.outline;
  }
}

/** The shapes as solids, m. */
export class Solids {
  readonly group = new Group();
  readonly farthest: Vector3[];
  /** The same without parts that are small compared with their distance. */
  readonly main: Vector3[];
  /** Distance of the farthest part that is not small compared with its distance. */
  readonly bulk: number;
  readonly coarser: string | null;

  constructor(
    readonly of: Shape[],
    readonly isOpen: boolean,
    palette: Palette,
  ) {
    const inks = inksOf(of);
    of.forEach((shape, k) => this.group.add(place(shape, paint(palette, inks[k], isOpen))));
    const counts = of.flatMap((s) => (s.kind === "mesh" ? [{ here: count(s.triangles), of: s.of }] : []));
    const here = Math.floor(counts.reduce((sum, c) => sum + c.here, 0));
    const all = counts.reduce((sum, c) => sum + c.of, 0);
    this.coarser = counts.some((c) => c.of > c.here + 1) ? `shown with ${grouped(here)} of ${grouped(all)} triangles` : null;
    const parts = this.group.children.map((part) => outlineOf(part as Group));
    enclosing(of, parts.map(({ points }) => points)).forEach((encloses, k) => {
      if (encloses && !isOpen) repaint(this.group.children[k], paint(palette, inks[k], true));
    });
    this.farthest = extremes(parts);
    this.bulk = bulk(parts);
    const main = parts.filter((part) => !isSmall(part));
    this.main = main.length === parts.length ? this.farthest : extremes(main);
  }
}

/**
 * Returns the colour of each part. Names that differ only by a number, or after a comma, such as
 * "panel, left" and "panel, right", are those of like parts.
 */
export function inksOf(parts: readonly { name: string }[]): Ink[] {
  const kinds = parts.map(({ name }) => name.replace(/,.*|[\s_-]*\d+$/, ""));
  const distinct = [...new Set(kinds)];
  return kinds.map((kind) => PARTS[distinct.indexOf(kind) % PARTS.length]);
}

/** Returns the number of triangles: 12 bytes each, with possible padding of base64. */
function count(triangles: Indices): number {
  return triangles.length / (typeof triangles === "string" ? 16 : 3);
}

/** Points of a part, and the corners of its bounding box, body axes, m. */
interface Outline {
  points: Float64Array;
  min: Vector3;
  max: Vector3;
}

function outlineOf(part: Group): Outline {
  const rows: Float64Array[] = [];
  part.updateMatrixWorld(true);
  part.traverse((object) => {
    if (!(object instanceof Mesh) || object instanceof LineSegments2) return;
    const p = (object.userData.hull ?? object.geometry.attributes.position.array) as ArrayLike<number>;
    const count = p.length / 3;
    const m = object.matrixWorld.elements;
    const every = Math.max(1, Math.floor(count / 20_000));
    const out = new Float64Array(3 * Math.ceil(count / every));
    for (let i = 0, k = 0; i < count; i += every, k += 3) {
      const [x, y, z] = [p[3 * i], p[3 * i + 1], p[3 * i + 2]];
      for (let c = 0; c < 3; c += 1) out[k + c] = m[c] * x + m[4 + c] * y + m[8 + c] * z + m[12 + c];
    }
    rows.push(out);
  });
  const points = new Float64Array(rows.reduce((sum, { length }) => sum + length, 0));
  rows.reduce((at, row) => {
    points.set(row, at);
    return at + row.length;
  }, 0);
  const [min, max] = [new Vector3().setScalar(Infinity), new Vector3().setScalar(-Infinity)];
  const point = new Vector3();
  for (let k = 0; k < points.length; k += 3) {
    point.fromArray(points, k);
    min.min(point);
    max.max(point);
  }
  return { points, min, max };
}

/**
 * Returns the distance of the farthest part that is not small compared with its distance; infinite
 * if all are small.
 */
function bulk(parts: Outline[]): number {
  const large = parts.filter((part) => !isSmall(part)).map(reachOf);
  return large.length > 0 ? Math.max(...large) : Infinity;
}

/** Returns true for a part that is small compared with its distance. */
function isSmall(part: Outline): boolean {
  return part.max.distanceTo(part.min) < SMALL * reachOf(part);
}

function reachOf(part: Outline): number {
  return Math.max(...corners(part).map((p) => p.length()));
}

function corners({ min, max }: Outline): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(k & 1 ? min.x : max.x, k & 2 ? min.y : max.y, k & 4 ? min.z : max.z));
}

interface Paint {
  solid: MeshStandardMaterial;
  marked: MeshStandardMaterial;
  edge: LineMaterial;
}

/** Returns materials shared by all shapes of a colour; they are transparent if `isOpen`. */
function paint(palette: Palette, ink: Ink, isOpen: boolean): Paint {
  const look = { roughness: 0.7, metalness: 0, ...(isOpen ? { transparent: true, opacity: 0.4, depthWrite: false } : {}) };
  return {
    solid: palette.shared(`solid ${isOpen}`, ink, () => new MeshStandardMaterial(look)),
    marked: palette.shared(`marked ${isOpen}`, ink, () => new MeshStandardMaterial({ ...look, vertexColors: true })),
    // Opaque, because crossings of transparent lines would be darker.
    edge: lineMaterial({ ink: "edge", width: 1, strength: 0.85 }, palette),
  };
}

function place(shape: Shape, paint: Paint): Group {
  const group = shape.kind === "balls" ? balls(shape) : solid(shape, paint);
  group.name = shape.name;
  group.position.set(...shape.position);
  const [w, x, y, z] = shape.quaternion;
  group.quaternion.set(x, y, z, w).normalize();
  return group;
}

function solid(shape: Solid, paint: Paint): Group {
  const group = new Group();
  const { geometry, edges, scale } = formOf(shape);
  const isRound = shape.kind !== "box" && shape.kind !== "mesh";
  const mesh = new Mesh(geometry, isRound ? paint.marked : paint.solid);
  // A cylinder does not extend beyond its rims.
  if (edges && (shape.kind === "cylinder" || (shape.kind === "cone" && shape.top > 0))) mesh.userData.hull = endsOf(edges);
  group.add(mesh);
  if (edges) {
    const lines = new LineSegments2(edges, paint.edge);
    lines.renderOrder = 1;
    group.add(lines);
  }
  for (const part of group.children) part.scale.set(...scale);
  return group;
}

function repaint(part: Object3D, paint: Paint): void {
  part.traverse((object) => {
    if (!(object instanceof Mesh) || object instanceof LineSegments2) return;
    object.material = (object.material as MeshStandardMaterial).vertexColors ? paint.marked : paint.solid;
  });
}

function balls(shape: Extract<Shape, { kind: "balls" }>): Group {
  const group = new Group();
  const centers = f32(shape.centers, `${shape.name}: centres`);
  const radii = f32(shape.radii, `${shape.name}: radii`);
  if (centers.length !== 3 * radii.length) throw new BadData(`${shape.name}: not one centre for each ball`);
  const middle = (i: number): Vector3 => new Vector3(centers[3 * i], centers[3 * i + 1], centers[3 * i + 2]);
  const fine = radii.length > 300 ? 12 : 32;
  const sphere = new SphereGeometry(1, fine, fine / 2);
  const materials = new Map<string, MeshStandardMaterial>();
  const paint = (color: string): MeshStandardMaterial => {
    const safe = /^#[0-9a-fA-F]{6}$/.test(color) ? color : "#999999";
    const known = materials.get(safe) ?? new MeshStandardMaterial({ roughness: 0.45, color: new Color(safe) });
    materials.set(safe, known);
    return known;
  };
  radii.forEach((radius, i) => {
    const ball = new Mesh(sphere, paint(shape.colors[i] ?? ""));
    ball.position.copy(middle(i));
    ball.scale.setScalar(radius);
    group.add(ball);
  });
  const smallest = radii.length > 0 ? Math.min(...radii) : 1;
  const stick = new CylinderGeometry(1, 1, 1, 16, 1, true);
  for (const [a, b] of shape.sticks) {
    if (!(a < radii.length && b < radii.length)) throw new BadData(`${shape.name}: a stick joins a ball that is not there`);
    const along = middle(b).sub(middle(a));
    const rod = new Mesh(stick, paint("#9aa0a6"));
    rod.position.copy(middle(a)).addScaledVector(along, 0.5);
    rod.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize());
    rod.scale.set(0.35 * smallest, along.length(), 0.35 * smallest);
    group.add(rod);
  }
  return group;
}

function equimomental(data: BodyData, paint: Paint): Group {
  const group = new Group();
  const largest = Math.max(...data.ellipsoid.half, Number.MIN_VALUE);
  // The ellipsoid of a flat body has no thickness, but a shaded one needs some.
  const half = data.ellipsoid.half.map((a) => Math.max(a, 0.004 * largest)) as [number, number, number];
  const mesh = new Mesh(ELLIPSOID, paint.marked);
  mesh.scale.set(...half);
  group.add(mesh);
  const [w, x, y, z] = data.ellipsoid.quaternion;
  group.quaternion.set(x, y, z, w).normalize();
  group.position.set(...data.lever);
  return group;
}

/**
 * Returns the points of the ellipsoid that are farthest in each of many directions d: A²d/|A d|,
 * A = diag(half axes).
 */
function farthestOf({ ellipsoid, lever }: BodyData): Vector3[] {
  const [w, x, y, z] = ellipsoid.quaternion;
  const turn = new Quaternion(x, y, z, w).normalize();
  const half = new Vector3(...ellipsoid.half);
  const middle = new Vector3(...lever);
  return DIRECTIONS.map((direction) => {
    const p = direction.clone().multiply(half);
    const size = p.length();
    if (size > 0) p.multiply(half).divideScalar(size);
    return p.applyQuaternion(turn).add(middle);
  });
}

/**
 * Returns the points that are farthest in each of many directions. Their hull is nearly that of the
 * whole.
 */
function extremes(parts: Outline[]): Vector3[] {
  const farthest = new Farthest(DIRECTIONS.length);
  const point = new Vector3();
  // The points are visited in strides. The first points, taken from everywhere, exclude most others
  // quickly.
  for (const { points } of parts) {
    for (let from = 0; from < 3 * LEAP; from += 3) {
      for (let k = from; k < points.length; k += 3 * LEAP) farthest.add(point.fromArray(points, k));
    }
  }
  return farthest.points;
}

const DIRECTIONS = directions(160);
