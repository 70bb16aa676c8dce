/** Arrows from the origin. Parts inside the body shine through it faintly. */
import { ConeGeometry, CylinderGeometry, GreaterDepth, Group, LatheGeometry, Mesh, MeshBasicMaterial, Vector2, Vector3 } from "three";
import { kept } from "./dispose";
import type { Ink, Palette } from "./palette";

const Y = new Vector3(0, 1, 0);

/** Maximum length. A longer arrow of a diverging motion would end behind the camera. */
const MOST = 3;

const SHAFT = kept(new CylinderGeometry(1, 1, 1, 16).translate(0, 0.5, 0));
/** Shaft of nine dashes; between them its radius is zero. */
const DASHES = 9;
const DASHED = kept(
  new LatheGeometry(
    Array.from({ length: 4 * DASHES }, (_, k) => new Vector2(k % 4 === 1 || k % 4 === 2 ? 1 : 0, (Math.floor(k / 4) + (k % 4 > 1 ? 0.62 : 0)) / (DASHES - 0.38))),
    16,
  ),
);
const HEAD = kept(new ConeGeometry(1, 1, 24).translate(0, -0.5, 0));

export class Arrow {
  readonly object = new Group();
  readonly tip = new Vector3();
  /** False if the arrow is too short to have a direction. */
  drawn = false;
  readonly #shafts: Mesh[] = [];
  readonly #heads: Mesh[] = [];
  readonly #width: number;

  constructor(ink: Ink, width: number, palette: Palette, isDashed = false) {
    this.#width = width;
    for (const hidden of [false, true]) {
      const look = hidden ? { transparent: true, opacity: 0.22, depthFunc: GreaterDepth, depthWrite: false } : {};
      const material = palette.shared(hidden ? "arrow behind" : "arrow", ink, () => new MeshBasicMaterial(look));
      const shaft = new Mesh(isDashed ? DASHED : SHAFT, material);
      const head = new Mesh(HEAD, material);
      for (const part of [shaft, head]) part.renderOrder = hidden ? 5 : 0;
      this.#shafts.push(shaft);
      this.#heads.push(head);
      this.object.add(shaft, head);
    }
  }

  /** Points the arrow; its shaft begins at the distance `foot` from the origin. */
  point(x: number, y: number, z: number, foot = 0): void {
    this.tip.set(x, y, z).clampLength(0, MOST);
    const long = this.tip.length();
    this.drawn = long > 1e-6;
    for (const part of [...this.#shafts, ...this.#heads]) part.visible = this.drawn;
    if (!this.drawn) return;
    this.object.quaternion.setFromUnitVectors(Y, this.tip.clone().divideScalar(long));
    const from = Math.min(foot, long);
    const head = Math.min(7 * this.#width, 0.5 * (long - from));
    for (const shaft of this.#shafts) {
      shaft.position.set(0, from, 0);
      shaft.scale.set(this.#width, long - head - from, this.#width);
    }
    for (const cone of this.#heads) {
      cone.position.set(0, long, 0);
      cone.scale.set(Math.min(2.6 * this.#width, head), head, Math.min(2.6 * this.#width, head));
    }
  }
}
