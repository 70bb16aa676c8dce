/**
 * What the body looks like, in body axes. Round shapes carry marks, quarters of two greys, so that one sees them turn. The size of
 * the picture is 1 from the point that the body turns about to its farthest part.
 */
import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  CapsuleGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  LatheGeometry,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector2,
  Vector3,
} from "three";
import type { BodyData, Shape } from "../data";
import { BadData, f32, indices } from "../decode";
import { kept } from "./dispose";
import { creased } from "./normals";
import type { Palette } from "./palette";

const ROUND = 64;
/** A part is small that is this part of its distance. */
const SMALL = 0.1;
/** Edges are not drawn on meshes with more triangles: they would be ink all over, and slow to find. */
const EDGES_UP_TO = 20_000;

export class BodyModel {
  /** The shapes, or the ellipsoid if there are none. */
  readonly shapes: Group;
  /** The ellipsoid of the same mass and tensor. */
  readonly ellipsoid: Group;
  /** m; length 1 of the picture: of the body without what is small and far out, as a tip mass on a boom */
  readonly radius: number;
  /** How far the farthest part is, in the picture. */
  readonly extent: number;
  /** Points on the outside of the shapes, and of the ellipsoid, as the picture has them. */
  readonly outline: Vector3[];
  readonly ellipsoidOutline: Vector3[];
  /** "20,000 of 200,000 triangles", if a mesh was made coarser. */
  readonly coarser: string | null;
  readonly hasShapes: boolean;
  readonly #solids: Solids;

  /**
   * `before`: the body until now. Its shapes are used again if they are the same, and its scale if this body's size is like it. One
   * sees through the body if `isOpen`.
   */
  constructor(data: BodyData, isOpen: boolean, palette: Palette, before: BodyModel | null) {
    this.hasShapes = data.shapes.length > 0;
    this.ellipsoid = equimomental(data, paint(palette, isOpen));
    const same = before !== null && before.#solids.of === data.shapes && before.#solids.isOpen === isOpen;
    this.#solids = same ? before.#solids : new Solids(data.shapes, isOpen, palette);
    this.shapes = this.#solids.group;
    this.coarser = this.#solids.coarser;
    const ellipsoid = farthestOf(data);
    const shapes = this.hasShapes ? this.#solids.farthest : ellipsoid;
    const farthest = Math.max(...shapes.map((p) => p.length())) || 1;
    const own = this.hasShapes ? Math.min(this.#solids.bulk, farthest) : farthest;
    const isLike = before !== null && own > 0.55 * before.radius && own < 1.35 * before.radius;
    this.radius = isLike ? before.radius : own;
    this.extent = farthest / this.radius;
    for (const group of [this.shapes, this.ellipsoid]) group.scale.setScalar(1 / this.radius);
    const scaled = (points: Vector3[]): Vector3[] => points.map((p) => p.clone().divideScalar(this.radius));
    this.outline = scaled(shapes);
    this.ellipsoidOutline = this.hasShapes ? scaled(ellipsoid) : this.outline;
  }
}

/** The shapes as solids, m. */
class Solids {
  readonly group = new Group();
  readonly farthest: Vector3[];
  /** How far the parts go that are not small for where they are. */
  readonly bulk: number;
  readonly coarser: string | null;

  constructor(
    readonly of: Shape[],
    readonly isOpen: boolean,
    palette: Palette,
  ) {
    const look = paint(palette, isOpen);
    for (const shape of of) this.group.add(place(shape, look));
    const counts = of.flatMap((s) => (s.kind === "mesh" ? [{ here: (s.triangles.length * 3) / 4 / 12, of: s.of }] : []));
    const here = Math.floor(counts.reduce((sum, c) => sum + c.here, 0));
    const all = counts.reduce((sum, c) => sum + c.of, 0);
    this.coarser = counts.some((c) => c.of > c.here + 1) ? `shown with ${grouped(here)} of ${grouped(all)} triangles` : null;
    this.farthest = extremes(this.group);
    this.bulk = bulk(this.group);
  }
}

/** Infinite if all are small. */
function bulk(shapes: Group): number {
  const parts = shapes.children.map((part) => {
    const box = new Box3().setFromObject(part, true);
    const far = Math.max(...corners(box).map((p) => p.length()));
    return { far, isSmall: box.getSize(new Vector3()).length() < SMALL * far };
  });
  const large = parts.filter(({ isSmall }) => !isSmall).map(({ far }) => far);
  return large.length > 0 ? Math.max(...large) : Infinity;
}

function corners({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(k & 1 ? min.x : max.x, k & 2 ? min.y : max.y, k & 4 ? min.z : max.z));
}

interface Paint {
  solid: MeshStandardMaterial;
  marked: MeshStandardMaterial;
  edge: LineBasicMaterial;
}

/** Materials, shared by all shapes; one sees what is inside if they are open. */
function paint(palette: Palette, isOpen: boolean): Paint {
  const look = { roughness: 0.55, metalness: 0.05, ...(isOpen ? { transparent: true, opacity: 0.4, depthWrite: false } : {}) };
  return {
    solid: palette.shared(`solid ${isOpen}`, "solid", () => new MeshStandardMaterial(look)),
    marked: palette.shared(`marked ${isOpen}`, "solid", () => new MeshStandardMaterial({ ...look, vertexColors: true })),
    edge: palette.shared("edge", "edge", () => new LineBasicMaterial({ transparent: true, opacity: 0.55 })),
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

type Solid = Exclude<Shape, { kind: "balls" }>;

function solid(shape: Solid, paint: Paint): Group {
  const group = new Group();
  const geometry = geometryOf(shape);
  const round = shape.kind !== "box" && shape.kind !== "mesh";
  const mark = shape.kind === "ellipsoid" ? octants : quadrants;
  group.add(new Mesh(round ? marked(geometry, mark) : geometry, round ? paint.marked : paint.solid));
  const triangles = (geometry.index?.count ?? geometry.attributes.position.count) / 3;
  if (shape.kind !== "ellipsoid" && shape.kind !== "torus" && triangles <= EDGES_UP_TO) {
    group.add(new LineSegments(new EdgesGeometry(geometry, 35), paint.edge));
  }
  return group;
}

function geometryOf(shape: Solid): BufferGeometry {
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(...shape.size);
    case "ellipsoid":
      return upright(new SphereGeometry(1, ROUND, ROUND / 2)).scale(...shape.half);
    case "cylinder":
      return upright(
        shape.inner > 0
          ? tube(shape.inner, shape.radius, shape.height)
          : new CylinderGeometry(shape.radius, shape.radius, shape.height, ROUND),
      );
    case "cone":
      return upright(
        shape.top > 0
          ? new CylinderGeometry(shape.top, shape.bottom, shape.height, ROUND)
          : new ConeGeometry(shape.bottom, shape.height, ROUND),
      );
    case "capsule":
      return upright(new CapsuleGeometry(shape.radius, shape.height, 16, ROUND));
    case "torus":
      return new TorusGeometry(shape.radius, shape.tube, 32, 2 * ROUND);
    case "mesh": {
      const vertices = f32(shape.vertices, `${shape.name}: vertices`);
      if (vertices.length % 3 !== 0) throw new BadData(`${shape.name}: vertices are not points`);
      const triangles = indices(shape.triangles, `${shape.name}: triangles`, vertices.length / 3);
      return creased(vertices, triangles.subarray(0, triangles.length - (triangles.length % 3)));
    }
  }
}

// three's round solids stand along y.
function upright(geometry: BufferGeometry): BufferGeometry {
  return geometry.rotateX(Math.PI / 2);
}

// A profile with sharp corners: each side of it has its own points.
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

const octants = (x: number, y: number, z: number): boolean => x * y * z > 0;
const quadrants = (x: number, y: number): boolean => x * y > 0;

// A darker grey on the faces whose middle the rule picks.
function marked(geometry: BufferGeometry, rule: (x: number, y: number, z: number) => boolean): BufferGeometry {
  const plain = geometry.index ? geometry.toNonIndexed() : geometry;
  const p = plain.attributes.position.array;
  const colors = new Float32Array(p.length).fill(1);
  for (let i = 0; i < p.length; i += 9) {
    const middle = [0, 1, 2].map((c) => p[i + c] + p[i + 3 + c] + p[i + 6 + c]);
    if (rule(middle[0], middle[1], middle[2])) colors.fill(0.56, i, i + 9);
  }
  plain.setAttribute("color", new BufferAttribute(colors, 3));
  return plain;
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
  const largest = Math.max(...data.ellipsoid, Number.MIN_VALUE);
  // A flat body's ellipsoid has no thickness; what has none cannot be lit.
  const half = data.ellipsoid.map((a) => Math.max(a, 0.004 * largest)) as [number, number, number];
  const mesh = new Mesh(ELLIPSOID, paint.marked);
  mesh.scale.set(...half);
  group.add(mesh);
  const [w, x, y, z] = data.principal.quaternion;
  group.quaternion.set(x, y, z, w).normalize();
  group.position.set(...data.lever);
  return group;
}

/** The ellipsoid's points that are farthest in each of many directions d: A²d/|A d|, A = diag(half axes). */
function farthestOf({ ellipsoid, principal, lever }: BodyData): Vector3[] {
  const [w, x, y, z] = principal.quaternion;
  const turn = new Quaternion(x, y, z, w).normalize();
  const half = new Vector3(...ellipsoid);
  const middle = new Vector3(...lever);
  return DIRECTIONS.map((direction) => {
    const p = direction.clone().multiply(half);
    const size = p.length();
    if (size > 0) p.multiply(half).divideScalar(size);
    return p.applyQuaternion(turn).add(middle);
  });
}

/** The points of a group that are farthest in each of many directions: their hull is nearly that of the whole. */
function extremes(group: Group): Vector3[] {
  const directions = DIRECTIONS;
  const best = directions.map(() => -Infinity);
  const found = directions.map(() => new Vector3());
  const point = new Vector3();
  group.updateMatrixWorld(true);
  group.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const positions = (object.geometry as BufferGeometry).attributes.position;
    const every = Math.max(1, Math.floor(positions.count / 20_000));
    for (let i = 0; i < positions.count; i += every) {
      point.fromBufferAttribute(positions, i).applyMatrix4(object.matrixWorld);
      for (let k = 0; k < directions.length; k += 1) {
        const d = directions[k];
        const along = d.x * point.x + d.y * point.y + d.z * point.z;
        if (along > best[k]) {
          best[k] = along;
          found[k].copy(point);
        }
      }
    }
  });
  return found;
}

/** Directions spread evenly (Fibonacci's spiral). */
function sphere(count: number): Vector3[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count;
    const flat = Math.sqrt(1 - z * z);
    return new Vector3(flat * Math.cos(k * golden), flat * Math.sin(k * golden), z);
  });
}

function grouped(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ",");
}

const DIRECTIONS = sphere(160);
const ELLIPSOID = kept(marked(upright(new SphereGeometry(1, ROUND, ROUND / 2)), octants));
