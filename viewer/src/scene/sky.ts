/**
 * Directions of space at a satellite, such as nadir with the Earth, the Sun, velocity and the
 * magnetic field, as thin arrows; and the directions of the body that a pointing is about, as cones
 * of the limit or as lines. A cone that its target has left has the colour of warnings.
 */
import { type Color, ConeGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, SphereGeometry, Vector3 } from "three";
import { indexAt } from "../clock";
import { look } from "../figures";
import type { Motion } from "../motion";
import { Arrow } from "./arrows";
import { kept } from "./dispose";
import type { Label } from "./labels";
import type { Layer } from "./layers";
import type { Ink, Palette } from "./palette";

const REACH = 1.5;
/** Radii of the Earth and of the Sun at the tips of their arrows. */
const BALLS: Record<string, number> = { nadir: 0.1, sun: 0.07 };
/** Length of the side of a cone, and the largest half-angle that is drawn as one, rad. */
const SIDE = 1.35;
const WIDEST = 1.4;
const WIDTH = 0.008;
const BALL = kept(new SphereGeometry(1, 32, 24));
const INKS: Record<string, Ink> = { nadir: "earth", velocity: "quiet", B: "wheel", sun: "torque" };

interface Seen {
  layer: string;
  name: string;
  ink: Ink;
  arrow: Arrow;
}

/** Arrow with a celestial body at its tip, or null. */
interface Target extends Seen {
  ball: Mesh | null;
}

interface Sensor extends Seen {
  /** Colour of its cone; null for a line. */
  color: Color | null;
  isOut: boolean;
}

export class Sky {
  readonly layers: Layer[] = [];
  /** Arrows of directions, and what rotates with the body. */
  readonly space = new Group();
  readonly body = new Group();
  readonly #motion: Motion;
  readonly #palette: Palette;
  readonly #seen: Target[];
  readonly #sensors: Sensor[];

  constructor(motion: Motion, palette: Palette) {
    this.#motion = motion;
    this.#palette = palette;
    this.#seen = motion.directions.map(({ name }, k) => {
      const ink = INKS[name] ?? "warn";
      const arrow = new Arrow(ink, WIDTH, palette);
      const group = new Group();
      group.add(arrow.object);
      const ball = name in BALLS ? new Mesh(BALL, palette.shared("ball", ink, () => new MeshStandardMaterial({ roughness: 0.8 }))) : null;
      if (ball) group.add(ball);
      ball?.scale.setScalar(BALLS[name]);
      this.space.add(group);
      const label = name.charAt(0).toUpperCase() + name.slice(1);
      return { layer: this.#put(`direction-${k}`, label, ink, true, group), name, ink, arrow, ball };
    });
    // A line along an axis of the body would cover that.
    this.#sensors = motion.pointings.map(({ name, body, limit }, k) => {
      const ink = look(k).ink as Ink;
      const along = new Vector3(...body);
      const arrow = new Arrow(ink, WIDTH, palette, true);
      arrow.point(...along.clone().multiplyScalar(SIDE).toArray());
      const group = new Group();
      group.add(arrow.object);
      const made = limit !== null && limit < WIDEST ? cone(along, limit, ink, palette) : null;
      if (made) group.add(made);
      this.body.add(group);
      const degrees = limit === null ? "" : `, cone of ${Number(((limit * 180) / Math.PI).toPrecision(3))}°`;
      return { layer: this.#put(`pointing-${k}`, `${name}${degrees}`, ink, made !== null || Math.max(...body) < 1 - 1e-9, group), name, ink, arrow, color: made?.material.color ?? null, isOut: false };
    });
  }

  /** Returns null for a motion without directions. */
  static of(motion: Motion, palette: Palette): Sky | null {
    return motion.directions.length > 0 ? new Sky(motion, palette) : null;
  }

  pose(time: number): void {
    this.#seen.forEach(({ arrow, ball, name }, k) => {
      const [x, y, z] = this.#motion.directionAt(k, time).map((c) => c * REACH);
      arrow.point(x, y, z);
      ball?.position.set(x, y, z).multiplyScalar(1 + BALLS[name] / REACH);
    });
    const i = indexAt(this.#motion.times, time);
    this.#sensors.forEach((sensor, k) => {
      const { values, limit } = this.#motion.pointings[k];
      const isOut = limit !== null && values[i] > limit;
      if (sensor.color === null || isOut === sensor.isOut) return;
      sensor.isOut = isOut;
      this.#palette.bind(sensor.color, isOut ? "danger" : sensor.ink);
    });
  }

  labels(on: (id: string) => boolean, turned: (p: Vector3) => Vector3): Label[] {
    const seen = this.#seen.filter(({ layer, arrow }) => on(layer) && arrow.drawn);
    const sensors = this.#sensors.filter(({ layer }) => on(layer));
    return [
      ...seen.map(({ name, ink, arrow }): Label => ({ text: name, ink, tip: arrow.tip.clone().multiplyScalar(1 + (2 * (BALLS[name] ?? 0)) / REACH) })),
      ...sensors.map(({ name, ink, arrow }): Label => ({ text: name, ink, tip: turned(arrow.tip) })),
    ];
  }

  #put(id: string, label: string, ink: Ink, isOn: boolean, object: Group): string {
    this.layers.push({ id, label, ink, look: "arrow", on: { body: isOn }, objects: [object] });
    return id;
  }
}

/** Makes a cone from the origin with its axis along a direction. Its material is its own. */
function cone(along: Vector3, half: number, ink: Ink, palette: Palette): Mesh<ConeGeometry, MeshBasicMaterial> {
  const height = SIDE * Math.cos(half);
  const geometry = new ConeGeometry(SIDE * Math.sin(half), height, 48, 1, true).translate(0, -height / 2, 0);
  const material = new MeshBasicMaterial({ transparent: true, opacity: 0.22, side: DoubleSide, depthWrite: false });
  palette.bind(material.color, ink);
  const mesh = new Mesh(geometry, material);
  mesh.quaternion.setFromUnitVectors(new Vector3(0, -1, 0), along.clone().normalize());
  return mesh;
}
