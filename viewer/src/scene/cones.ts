/**
 * The body cone, swept by ω in the body, rolls on the space cone, swept by ω in space. They touch
 * along ω. The cones of a symmetric body are circular. For other bodies the space cone does not
 * close. The part drawn is around the current time, over a turn or a period of ω, whichever is
 * longer.
 */
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshStandardMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { rotate } from "../attitude";
import { indexAt } from "../clock";
import type { FreeData } from "../data";
import { points } from "../decode";
import { at, type Motion } from "../motion";
import type { Label } from "./labels";
import { curve, lineMaterial, MovingCurve, segments } from "./lines";
import type { Ink, Palette } from "./palette";
import { spread } from "./poinsot";

const MOST = 6000;

export class Cones {
  /** Group that rotates with the body. */
  readonly body = new Group();
  readonly space = new Group();
  /** Length of 1 rad/s in the picture. */
  readonly scale: number;
  readonly outline: Vector3[];
  /** Direction of L in space. */
  readonly up = new Vector3();

  readonly #edge: Float32Array;
  readonly #angles: Float64Array;
  readonly #rim: MovingCurve;
  readonly #surface: BufferGeometry;
  readonly #corners: Float32Array;

  constructor(free: FreeData, motion: Motion, palette: Palette) {
    const polhode = points(free.polhode, "polhode");
    let fastest = 0;
    for (let i = 0; 3 * i < polhode.length; i += 1) fastest = Math.max(fastest, Math.hypot(...at(polhode, i)));
    this.scale = 1.15 / (fastest || 1);
    this.outline = [new Vector3()];
    for (let i = 0; 3 * i < polhode.length; i += Math.ceil(polhode.length / 3 / 64)) {
      this.outline.push(new Vector3(...at(polhode, i)).multiplyScalar(this.scale));
    }
    if (polhode.length >= 6) {
      this.body.add(new Mesh(fan(polhode, this.scale), skin("axis-1", 0.3, palette)));
      this.body.add(curve(polhode, this.scale, { ink: "axis-1", width: 3, onTop: true }, palette));
      this.body.add(rulings(polhode, this.scale, palette));
    }

    const up = this.up.fromArray(motion.momentum).normalize();
    const fine = Math.max(1, Math.min(4, Math.floor(MOST / motion.count)));
    const count = (motion.count - 1) * fine + 1;
    this.#edge = new Float32Array(3 * count);
    this.#angles = new Float64Array(count);
    for (let k = 0; k < count; k += 1) {
      const i = Math.floor(k / fine);
      const next = motion.times[Math.min(i + 1, motion.count - 1)];
      const now = motion.at(motion.times[i] + ((k % fine) / fine) * (next - motion.times[i]));
      const omega = new Vector3(...rotate(now.attitude, now.omega)).multiplyScalar(this.scale);
      this.#edge.set([omega.x, omega.y, omega.z], 3 * k);
      if (k > 0) {
        const before = new Vector3().fromArray(this.#edge, 3 * (k - 1));
        this.#angles[k] = this.#angles[k - 1] + angleAround(up, before, omega);
      }
    }
    this.#span = isRound(this.#edge, up) ? 0 : (free.period ?? 0);
    this.#fine = fine;
    this.#times = motion.times;
    this.#rim = new MovingCurve(count, { ink: "torque", width: 3, onTop: true }, palette);
    this.#corners = new Float32Array(9 * count);
    this.#surface = new BufferGeometry();
    this.#surface.setAttribute("position", new BufferAttribute(this.#corners, 3));
    this.#surface.setAttribute("normal", new BufferAttribute(new Float32Array(9 * count), 3));
    const mesh = new Mesh(this.#surface, skin("torque", 0.42, palette));
    mesh.frustumCulled = false;
    this.space.add(mesh, this.#rim.object);
    this.#polhode = spread(polhode, this.scale);
  }

  readonly #polhode: Vector3[];
  /** Drawn part of the rim of the space cone: first index and count. */
  #drawn: [number, number] = [0, 0];

  readonly #fine: number;
  readonly #times: Float64Array;
  /** Minimum time that the space cone covers, s. */
  readonly #span: number;

  /** Draws the turn of the space cone around `time`. */
  draw(time: number): void {
    const here = Math.min(indexAt(this.#times, time) * this.#fine, this.#angles.length - 1);
    const turned = (k: number): number => Math.abs(this.#angles[k] - this.#angles[here]);
    let first = here;
    let last = here;
    while (first > 0 && turned(first) < Math.PI) first -= 1;
    while (last < this.#angles.length - 1 && turned(last) < Math.PI) last += 1;
    // At the ends of the motion, one side extends farther.
    while (first > 0 && turned(first) + turned(last) < 2 * Math.PI) first -= 1;
    while (last < this.#angles.length - 1 && turned(first) + turned(last) < 2 * Math.PI) last += 1;
    const sampleAt = (t: number): number => Math.min(indexAt(this.#times, t) * this.#fine, this.#angles.length - 1);
    first = Math.min(first, sampleAt(time - this.#span / 2));
    last = Math.max(last, sampleAt(time + this.#span / 2));
    const count = last - first + 1;
    this.#rim.draw(count, (k, out) => {
      out.set(this.#edge.subarray(3 * (first + k), 3 * (first + k) + 3));
    });
    this.#drawn = [first, count];
    const normals = this.#surface.attributes.normal as BufferAttribute;
    const n = normals.array as Float32Array;
    const [a, b] = [new Vector3(), new Vector3()];
    for (let k = 0; k < count - 1; k += 1) {
      a.fromArray(this.#edge, 3 * (first + k));
      b.fromArray(this.#edge, 3 * (first + k + 1));
      this.#corners.set([0, 0, 0, a.x, a.y, a.z, b.x, b.y, b.z], 9 * k);
      a.cross(b).normalize();
      for (const corner of [0, 3, 6]) n.set([a.x, a.y, a.z], 9 * k + corner);
    }
    this.#surface.setDrawRange(0, 3 * (count - 1));
    this.#surface.attributes.position.needsUpdate = true;
    normals.needsUpdate = true;
  }

  /** Returns labels; `turned` converts a place in the body to space. */
  labels(on: (id: string) => boolean, turned: (p: Vector3) => Vector3): Label[] {
    const labels: Label[] = [];
    const put = (layer: string, text: string, ink: Ink, along: Vector3[]): void => {
      if (on(layer) && along.length > 1) labels.push({ text, ink, tip: along[0], along });
    };
    const [first, count] = this.#drawn;
    put("body-cone", "body cone", "axis-1", this.#polhode.map(turned));
    put("space-cone", "space cone", "torque", spread(Float64Array.from(this.#edge.subarray(3 * first, 3 * (first + count))), 1));
    return labels;
  }
}

/** Returns true if the rim is a circle around `up`. */
function isRound(rim: Float32Array, up: Vector3): boolean {
  let [low, high] = [Infinity, 0];
  const p = new Vector3();
  for (let k = 0; k < rim.length; k += 3) {
    const far = p.fromArray(rim, k).cross(up).length();
    low = Math.min(low, far);
    high = Math.max(high, far);
  }
  return high - low < 1e-3;
}

function skin(ink: Ink, opacity: number, palette: Palette): MeshStandardMaterial {
  const look = { roughness: 0.7, transparent: true, opacity, side: DoubleSide, depthWrite: false };
  return palette.shared(`skin ${opacity}`, ink, () => new MeshStandardMaterial(look));
}

function fan(rim: Float64Array, scale: number): BufferGeometry {
  const corners: number[] = [];
  for (let i = 0; 3 * i + 3 < rim.length; i += 1) {
    corners.push(0, 0, 0, ...at(rim, i).map((x) => x * scale), ...at(rim, i + 1).map((x) => x * scale));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  geometry.computeVertexNormals();
  return geometry;
}

// Draws some of the generating lines of the cone.
function rulings(rim: Float64Array, scale: number, palette: Palette): LineSegments2 {
  const count = rim.length / 3;
  const corners: number[] = [];
  for (let k = 0; k < 36; k += 1) {
    const p = at(rim, Math.floor((k / 36) * count)).map((x) => x * scale);
    corners.push(0, 0, 0, ...p);
  }
  return new LineSegments2(segments(corners), lineMaterial({ ink: "axis-1", width: 1, opacity: 0.45 }, palette));
}

// Returns the angle from a to b around `up`, rad.
function angleAround(up: Vector3, a: Vector3, b: Vector3): number {
  const flatA = a.clone().addScaledVector(up, -a.dot(up));
  const flatB = b.clone().addScaledVector(up, -b.dot(up));
  return Math.atan2(flatA.clone().cross(flatB).dot(up), flatA.dot(flatB));
}
