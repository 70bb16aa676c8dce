/**
 * Poinsot's picture of a free motion, in the space of ω. The energy ellipsoid ω·Iω = 2T is fixed in
 * the body. It rolls without slipping on the invariable plane ω·L = 2T, which is fixed in space,
 * and touches it at the tip of ω. The contact point traces the polhode on the ellipsoid and the
 * herpolhode on the plane.
 */
import {
  BackSide,
  FrontSide,
  Group,
  Mesh,
  MeshStandardMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import type { BodyData, FreeData } from "../data";
import { points } from "../decode";
import type { Motion } from "../motion";
import { at } from "../motion";
import { kept } from "./dispose";
import type { Label } from "./labels";
import { curve } from "./lines";
import { Marker } from "./marker";
import type { Palette } from "./palette";
import { plane, rim } from "./plane";

const SPHERE = kept(new SphereGeometry(1, 64, 48));

export class Poinsot {
  /** Groups that rotate with the body. */
  readonly ellipsoid = new Group();
  readonly polhode = new Group();
  /** Groups fixed in space. */
  readonly plane = new Group();
  readonly herpolhode = new Group();
  /** Mark at the tip of ω, where the ellipsoid touches the plane. */
  readonly contact: Group;
  /** Length of 1 rad/s in the picture. */
  readonly scale: number;
  /** Length of the arrow of L, through the plane. */
  readonly arrow: number;
  readonly outline: Vector3[];
  /** Direction of L in space. */
  readonly up: Vector3;

  constructor(free: FreeData, body: BodyData, motion: Motion, palette: Palette) {
    const polhode = points(free.polhode, "polhode");
    const herpolhode = points(free.herpolhode, "herpolhode");
    // Semi-axes a_k = √(2T/i_k). The ellipsoid of a rod is an infinite cylinder, of which a part is
    // drawn.
    const fastest = largest(polhode);
    const half = body.principal.moments.map((i) =>
      Math.min(i > 0 ? Math.sqrt((2 * free.energy) / i) : Infinity, 6 * fastest),
    ) as [number, number, number];
    this.scale = 1.1 / Math.max(...half, Number.MIN_VALUE);
    const [w, x, y, z] = body.principal.quaternion;
    const scaled = half.map((a) => a * this.scale) as [number, number, number];

    for (const side of [BackSide, FrontSide]) {
      const look = { roughness: 0.4, transparent: true, opacity: 0.3, side, depthWrite: false };
      const material = palette.shared(`inertia ellipsoid ${side}`, "solid", () => new MeshStandardMaterial(look));
      const mesh = new Mesh(SPHERE, material);
      mesh.scale.set(...scaled);
      mesh.renderOrder = side === BackSide ? 0 : 1;
      this.ellipsoid.add(mesh);
    }
    for (const k of [0, 1, 2]) {
      // The sections with the principal planes make the rotation visible.
      const circle = Array.from({ length: 129 }, (_, i) => {
        const a = (i / 128) * 2 * Math.PI;
        const v = [0, 0, 0];
        v[(k + 1) % 3] = Math.cos(a) * scaled[(k + 1) % 3] * 1.001;
        v[(k + 2) % 3] = Math.sin(a) * scaled[(k + 2) % 3] * 1.001;
        return v;
      }).flat();
      this.ellipsoid.add(curve(circle, 1, { ink: "edge", width: 1, opacity: 0.45 }, palette));
    }
    this.ellipsoid.quaternion.set(x, y, z, w).normalize();
    this.contact = new Marker("omega", 0.03, false, palette).object;

    if (polhode.length >= 6) {
      this.polhode.add(curve(polhode, this.scale, { ink: "omega", width: 3.2 }, palette));
    }
    if (herpolhode.length >= 6) {
      this.herpolhode.add(curve(herpolhode, this.scale, { ink: "torque", width: 2.2 }, palette));
    }

    // The plane is at the distance 2T/|L| along L.
    this.up = new Vector3(...at(motion.momentum, 0)).normalize();
    const distance = ((2 * free.energy) / free.momentum) * this.scale;
    const reach = Math.max(widest(herpolhode, this.up) * this.scale * 1.3, 0.85);
    this.plane.add(plane(reach, palette));
    this.plane.position.copy(this.up).multiplyScalar(distance);
    this.plane.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), this.up);

    this.arrow = distance + 0.35;
    const outline = new SphereGeometry(1, 16, 12).attributes.position;
    this.outline = Array.from({ length: outline.count }, (_, i) =>
      new Vector3()
        .fromBufferAttribute(outline, i)
        .multiply(new Vector3(...scaled))
        .applyQuaternion(this.ellipsoid.quaternion),
    );
    this.#rim = rim(reach).map((p) => p.applyQuaternion(this.plane.quaternion).add(this.plane.position));
    this.#polhode = spread(polhode, this.scale);
    this.#herpolhode = spread(herpolhode, this.scale);
  }

  readonly #rim: Vector3[];
  readonly #polhode: Vector3[];
  readonly #herpolhode: Vector3[];

  /** Returns labels; `turned` converts a place in the body to space. */
  labels(on: (id: string) => boolean, turned: (p: Vector3) => Vector3): Label[] {
    const labels: Label[] = [];
    const put = (layer: string, text: string, ink: Label["ink"], along: Vector3[]): void => {
      if (on(layer) && along.length > 1) labels.push({ text, ink, tip: along[0], along });
    };
    put("plane", "invariable plane", "quiet", this.#rim);
    put("herpolhode", "herpolhode", "torque", this.#herpolhode);
    put("polhode", "polhode", "omega", this.#polhode.map(turned));
    return labels;
  }
}

/** Returns some of the points of a curve. */
export function spread(rows: Float64Array, scale: number): Vector3[] {
  const every = Math.max(3, 3 * Math.ceil(rows.length / 72));
  const points: Vector3[] = [];
  for (let i = 0; i < rows.length; i += every) points.push(new Vector3(rows[i], rows[i + 1], rows[i + 2]).multiplyScalar(scale));
  return points;
}

function largest(rows: Float64Array): number {
  let best = 0;
  for (let i = 0; 3 * i < rows.length; i += 1) best = Math.max(best, Math.hypot(...at(rows, i)));
  return best;
}

// Returns the largest distance from the line along `up`.
function widest(rows: Float64Array, up: Vector3): number {
  let best = 0;
  for (let i = 0; 3 * i < rows.length; i += 1) {
    best = Math.max(best, new Vector3(...at(rows, i)).cross(up).length());
  }
  return best;
}
