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
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  SphereGeometry,
  TorusGeometry,
  Vector2,
  Vector3,
} from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import type { BodyData, Shape } from "../data";
import { BadData, f32, indices } from "../decode";
import { Farthest } from "./framing";
import { lineMaterial, segments } from "./lines";
import { creased } from "./normals";
import type { Palette } from "./palette";

const ROUND = 64;
/** A part is small that is this part of its distance. */
const SMALL = 0.1;
/** Edges are not drawn on meshes with more triangles: they would be ink all over, and slow to find. */
const EDGES_UP_TO = 20_000;

export class BodyModel {
  /** The shapes, or the ellipsoid if there are none. */
  readonly shapes = new Group();
  /** The ellipsoid of the same mass and tensor. */
  readonly ellipsoid = new Group();
  /** m; length 1 of the picture: of the body without what is small and far out, as a tip mass on a boom */
  readonly radius: number;
  /** Points on the outside of the shapes, and of the ellipsoid, as the picture has them. */
  readonly outline: Vector3[];
  readonly ellipsoidOutline: Vector3[];
  /** "20,000 of 200,000 triangles", if a mesh was made coarser. */
  readonly coarser: string | null;
  readonly hasShapes: boolean;
  readonly #paint: Paint;

  constructor(data: BodyData, palette: Palette) {
    this.hasShapes = data.shapes.length > 0;
    const paint = new Paint(palette);
    this.#paint = paint;
    this.ellipsoid.add(equimomental(data, paint));
    for (const shape of data.shapes) this.shapes.add(place(shape, paint));
    const counts = data.shapes.flatMap((s) =>
      s.kind === "mesh" ? [{ here: (s.triangles.length * 3) / 4 / 12, of: s.of }] : [],
    );
    const here = Math.floor(counts.reduce((sum, c) => sum + c.here, 0));
    const of = counts.reduce((sum, c) => sum + c.of, 0);
    this.coarser = counts.some((c) => c.of > c.here + 1) ? `shown with ${grouped(here)} of ${grouped(of)} triangles` : null;

    const ellipsoid = extremes(this.ellipsoid);
    const shapes = this.hasShapes ? extremes(this.shapes) : ellipsoid;
    const farthest = Math.max(...shapes.map((p) => p.length())) || 1;
    this.radius = this.hasShapes ? bulk(this.shapes, farthest) : farthest;
    for (const group of [this.shapes, this.ellipsoid]) group.scale.setScalar(1 / this.radius);
    this.outline = shapes.map((p) => p.divideScalar(this.radius));
    this.ellipsoidOutline = this.hasShapes ? ellipsoid.map((p) => p.divideScalar(this.radius)) : this.outline;
  }

  /** Shows what is inside. */
  seeThrough(): void {
    for (const material of [this.#paint.solid, this.#paint.marked]) {
      Object.assign(material, { transparent: true, opacity: 0.4, depthWrite: false });
    }
  }
}

/** How far the parts go that are not small for where they are. */
function bulk(shapes: Group, farthest: number): number {
  const parts = shapes.children.map((part) => {
    const box = solids(part).reduce((all, mesh) => all.expandByObject(mesh, true), new Box3());
    const far = Math.max(...corners(box).map((p) => p.length()));
    return { far, isSmall: box.getSize(new Vector3()).length() < SMALL * far };
  });
  const large = parts.filter(({ isSmall }) => !isSmall).map(({ far }) => far);
  return large.length > 0 ? Math.min(Math.max(...large), farthest) : farthest;
}

function corners({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(k & 1 ? min.x : max.x, k & 2 ? min.y : max.y, k & 4 ? min.z : max.z));
}

/** Materials, shared by all shapes. */
class Paint {
  readonly solid = new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 });
  readonly marked = new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05, vertexColors: true });
  readonly edge;

  constructor(palette: Palette) {
    palette.bind(this.solid.color, "solid");
    palette.bind(this.marked.color, "solid");
    // Opaque: where two meet, they would be darker.
    this.edge = lineMaterial({ ink: "edge", width: 1, strength: 0.85 }, palette);
  }
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
    const edges = segments(new EdgesGeometry(geometry, 35).attributes.position.array, paint.edge);
    edges.renderOrder = 1;
    group.add(edges);
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
  const sphere = upright(new SphereGeometry(1, ROUND, ROUND / 2)).scale(...half);
  group.add(new Mesh(marked(sphere, octants), paint.marked));
  const [w, x, y, z] = data.principal.quaternion;
  group.quaternion.set(x, y, z, w).normalize();
  group.position.set(...data.lever);
  return group;
}

/** What a group is made of, without its edges. */
function solids(group: Object3D): Mesh[] {
  const found: Mesh[] = [];
  group.updateMatrixWorld(true);
  group.traverse((object) => {
    if (object instanceof Mesh && !(object instanceof LineSegments2)) found.push(object);
  });
  return found;
}

/** Points whose hull is nearly that of a group. */
function extremes(group: Group): Vector3[] {
  const farthest = new Farthest(160);
  const point = new Vector3();
  for (const { geometry, matrixWorld } of solids(group)) {
    const positions = (geometry as BufferGeometry).attributes.position;
    const every = Math.max(1, Math.floor(positions.count / 20_000));
    for (let i = 0; i < positions.count; i += every) farthest.add(point.fromBufferAttribute(positions, i).applyMatrix4(matrixWorld));
  }
  return farthest.points;
}

function grouped(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ",");
}
