/**
 * The momentum sphere: the direction of L in the body, in principal axes. Free motions of this body
 * are contours of T on it. The separatrix divides those around the axis of least moment from those
 * around that of greatest.
 */
import { BackSide, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, SphereGeometry, Vector3 } from "three";
import type { BodyData, FreeData, Row } from "../data";
import { points } from "../decode";
import { kept } from "./dispose";
import type { Label } from "./labels";
import { curve } from "./lines";
import { Marker } from "./marker";
import type { Palette } from "./palette";
import { spread } from "./poinsot";

/** Radius of the lines on the sphere, and of a shell whose inside is its rim, beyond the lines. */
const ABOVE = 1.002;
const RIM = 1.014;

/** Distance between curves that are told apart. */
const APART = 0.12;

const SPHERE = kept(new SphereGeometry(1, 128, 96));

export class MomentumSphere {
  /** Group that rotates with the body. */
  readonly object = new Group();
  readonly family = new Group();
  readonly separatrix = new Group();
  readonly trace = new Group();
  /** Centre of the curve of this motion, principal axes. */
  readonly middle = new Vector3();
  /** Mark at the current L/|L|. */
  readonly mark: Group;
  /** Points of the separatrix that are apart from the curve of this motion, and all. */
  readonly #separatrices: [Vector3[], Vector3[]];

  constructor(free: FreeData, body: BodyData, palette: Palette) {
    const material = palette.shared("sphere", "solid", () => new MeshStandardMaterial({ roughness: 0.85, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4 }));
    const rim = new Mesh(SPHERE, palette.shared("rim", "faint", () => new MeshBasicMaterial({ side: BackSide })));
    rim.scale.setScalar(RIM);
    this.object.add(new Mesh(SPHERE, material), rim);
    const draw = (into: Group, rows: Row[], what: string, pen: Parameters<typeof curve>[2]): void => {
      for (const row of rows) {
        const line = points(row, what);
        if (line.length >= 6) into.add(curve(line, ABOVE, pen, palette));
      }
    };
    draw(this.family, free.family, "family", { ink: "contour", width: 1.2, opacity: 0.8 });
    draw(this.separatrix, free.separatrix, "separatrix", { ink: "ink", width: 2.6 });
    draw(this.trace, [free.trace], "trace", { ink: "omega", width: 4 });
    const trace = points(free.trace, "trace");
    for (let i = 0; i < trace.length; i += 3) this.middle.add(new Vector3().fromArray(trace, i));
    this.middle.normalize();
    const all = free.separatrix.flatMap((row) => spread(points(row, "separatrix"), ABOVE));
    const near = Array.from({ length: trace.length / 3 }, (_, i) => new Vector3().fromArray(trace, 3 * i));
    // Where this motion is close to it, the name could be that of the motion.
    const apart = all.filter((p) => near.every((q) => p.distanceTo(q) > APART));
    this.#separatrices = [apart, all];
    this.mark = new Marker("ink", 0.034, true, palette).object;
    this.object.add(this.family, this.separatrix, this.trace, this.mark);
    const [w, x, y, z] = body.principal.quaternion;
    this.object.quaternion.set(x, y, z, w).normalize();
  }

  /** Moves the mark to the direction of L, body axes. */
  draw(momentum: [number, number, number]): void {
    this.mark.position.set(...momentum).normalize().multiplyScalar(ABOVE);
    this.mark.position.applyQuaternion(this.object.quaternion.clone().invert());
  }

  /** Returns labels visible from `eye`; `turned` converts a place in the body to space. */
  labels(on: (id: string) => boolean, turned: (p: Vector3) => Vector3, eye: Vector3): Label[] {
    if (!on("separatrix")) return [];
    const seen = (points: Vector3[], least: number): Vector3[] => {
      const places = points.map((p) => turned(p.clone().applyQuaternion(this.object.quaternion)));
      return places.filter((p) => p.dot(eye) > least * eye.length());
    };
    const apart = seen(this.#separatrices[0], 0.15);
    const along = apart.length > 0 ? apart : seen(this.#separatrices[1], 0.35);
    return along.length > 0 ? [{ text: "separatrix", ink: "ink", tip: along[0], along, isOn: true }] : [];
  }
}

/** Returns the rim of the unit sphere as seen by a camera. */
export function rim(eye: Vector3): Vector3[] {
  const n = eye.clone().normalize();
  const a = new Vector3(-n.y, n.x, 0).normalize();
  const b = n.clone().cross(a);
  const k = 1.04;
  return Array.from({ length: 32 }, (_, i) => {
    const t = (i / 32) * 2 * Math.PI;
    return a.clone().multiplyScalar(k * Math.cos(t)).addScaledVector(b, k * Math.sin(t));
  });
}
