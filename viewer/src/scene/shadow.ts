/**
 * Shadow of the body on a plane below it: a soft ellipse of the extent of the body's outline,
 * wider the higher the body is.
 */
import { BufferAttribute, type BufferGeometry, Matrix4, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import { kept } from "./dispose";
import type { Palette } from "./palette";

/** Extent relative to that of the outline. */
const SPREAD = 1.2;
/** Growth of the extent with the height. */
const FADE = 0.5;
/** Distance above the plane. */
const ABOVE = 0.003;

const DISC = kept(soft(new RingGeometry(0, 1, 48, 10)));

export class Shadow {
  readonly object: Mesh<BufferGeometry, MeshBasicMaterial>;
  readonly #normal: Vector3;
  readonly #across: [Vector3, Vector3];
  readonly #outline: readonly Vector3[];

  /** `normal`: unit vector of a plane through the origin; `outline`: points of the body, body axes. */
  constructor(normal: Vector3, outline: readonly Vector3[], palette: Palette) {
    this.#normal = normal;
    const first = new Vector3(1, 0, 0).cross(normal);
    if (first.lengthSq() < 0.1) first.set(0, 1, 0).cross(normal);
    first.normalize();
    this.#across = [first, normal.clone().cross(first)];
    this.#outline = outline;
    const look = { vertexColors: true, transparent: true, depthWrite: false };
    this.object = new Mesh(DISC, palette.shared("shadow", "edge", () => new MeshBasicMaterial(look)));
    this.object.matrixAutoUpdate = false;
  }

  /** Moves the shadow below the body; `turned` converts a place in the body to space. */
  pose(turned: (p: Vector3) => Vector3): void {
    const [u, v] = this.#across;
    const places = this.#outline.map(turned);
    const flat = places.map((p): [number, number] => [p.dot(u), p.dot(v)]);
    const height = Math.max(Math.min(...places.map((p) => p.dot(this.#normal))), 0);
    const count = flat.length || 1;
    const [mx, my] = [0, 1].map((k) => flat.reduce((sum, p) => sum + p[k], 0) / count);
    let [xx, xy, yy] = [0, 0, 0];
    for (const [x, y] of flat) {
      xx += (x - mx) ** 2;
      xy += (x - mx) * (y - my);
      yy += (y - my) ** 2;
    }
    const angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const axes = [u.clone().multiplyScalar(c).addScaledVector(v, s), v.clone().multiplyScalar(c).addScaledVector(u, -s)];
    const wide = SPREAD * (1 + FADE * height);
    const middle = this.#normal.clone().multiplyScalar(ABOVE);
    const scaled = axes.map((axis) => {
      const along = places.map((p) => p.dot(axis));
      const [low, high] = [Math.min(...along), Math.max(...along)];
      middle.addScaledVector(axis, (low + high) / 2);
      return axis.clone().multiplyScalar(Math.max((wide * (high - low)) / 2, 1e-3));
    });
    this.object.matrix.copy(new Matrix4().makeBasis(scaled[0], scaled[1], this.#normal).setPosition(middle));
    this.object.visible = height < 6;
  }
}

/** Adds opacities that fall from the centre to the edge. */
function soft(geometry: BufferGeometry): BufferGeometry {
  const p = geometry.attributes.position.array;
  const colors = new Float32Array((4 * p.length) / 3).fill(1);
  for (let k = 0; k < colors.length / 4; k += 1) colors[4 * k + 3] = 0.55 * (1 - Math.min(p[3 * k] ** 2 + p[3 * k + 1] ** 2, 1)) ** 1.5;
  geometry.setAttribute("color", new BufferAttribute(colors, 4));
  return geometry;
}
