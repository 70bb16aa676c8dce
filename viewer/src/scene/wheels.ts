/**
 * Momentum wheels: a ring about the axis of each, and its angular momentum h as an arrow. The place
 * of a wheel does not affect the motion and is not known. A single one is drawn at the point that
 * the body turns about, and several around it, along their axes.
 */
import { type Color, CylinderGeometry, GreaterDepth, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, TorusGeometry, Vector3 } from "three";
import type { Motion } from "../motion";
import { indexAt } from "../clock";
import { Arrow } from "./arrows";
import type { Label } from "./labels";
import type { Layer } from "./layers";
import type { Palette } from "./palette";

const RADIUS = 0.3;
const Z = new Vector3(0, 0, 1);

interface Drawn {
  name: string;
  axis: Vector3;
  center: Vector3;
  arrow: Arrow;
  materials: { color: Color }[];
  momentum: Float64Array;
  motor: Float64Array | null;
}

export class Wheels {
  /** Groups that rotate with the body. */
  readonly rings = new Group();
  readonly arrows = new Group();
  readonly layers: Layer[];
  readonly #drawn: Drawn[];
  readonly #motion: Motion;
  readonly #palette: Palette;
  /** Length of 1 kg·m²/s. */
  readonly #scale: number;

  constructor(motion: Motion, scale: number, palette: Palette) {
    this.#motion = motion;
    this.#palette = palette;
    this.#scale = scale;
    const several = motion.wheels.length > 1;
    this.#drawn = motion.wheels.map(({ name, axis, momentum, motor }) => {
      const along = new Vector3(...axis);
      const center = along.clone().multiplyScalar(several ? 0.42 : 0);
      const { group, materials } = ring(palette);
      group.quaternion.setFromUnitVectors(Z, along);
      group.position.copy(center);
      this.rings.add(group);
      const arrow = new Arrow("wheel", 0.019, palette);
      arrow.object.position.copy(center);
      this.arrows.add(arrow.object);
      return { name, axis: along, center, arrow, materials, momentum, motor };
    });
    const on = { body: true };
    this.layers = [
      { id: "wheels", label: several ? "Wheels" : "Wheel", ink: "wheel", look: "area", on: { ...on }, objects: [this.rings] },
      { id: "wheel-momentum", label: "h of the wheel", ink: "wheel", look: "arrow", on: { ...on }, objects: [this.arrows] },
    ];
  }

  pose(time: number): void {
    const { times } = this.#motion;
    const i = Math.min(indexAt(times, time), Math.max(times.length - 2, 0));
    const j = Math.min(i + 1, times.length - 1);
    const part = times[j] > times[i] ? Math.min(Math.max((time - times[i]) / (times[j] - times[i]), 0), 1) : 0;
    for (const { axis, arrow, materials, momentum, motor } of this.#drawn) {
      const h = momentum[i] + part * (momentum[j] - momentum[i]);
      const tip = axis.clone().multiplyScalar(h * this.#scale);
      arrow.point(tip.x, tip.y, tip.z);
      for (const { color } of materials) color.set(this.#palette.value(runs(motor, i) ? "torque" : "wheel"));
    }
  }

  /** Returns labels; `turned` converts a place in the body to space. */
  labels(on: (id: string) => boolean, time: number, turned: (p: Vector3) => Vector3): Label[] {
    const labels: Label[] = [];
    const i = indexAt(this.#motion.times, time);
    this.#drawn.forEach(({ name, axis, center, arrow, motor }, k) => {
      const number = this.#drawn.length > 1 ? "₁₂₃₄₅₆₇₈₉"[k] ?? "" : "";
      if (on("wheel-momentum") && arrow.drawn) {
        labels.push({ text: `𝐡${number}`, ink: "wheel", tip: turned(arrow.tip.clone().add(center)) });
      }
      if (!on("wheels")) return;
      const side = new Vector3(Math.abs(axis.z) < 0.9 ? 0 : 1, 0, Math.abs(axis.z) < 0.9 ? 1 : 0).cross(axis).normalize();
      const other = axis.clone().cross(side);
      const rim = Array.from({ length: 16 }, (_, n) => {
        const t = (n / 16) * 2 * Math.PI;
        const p = side.clone().multiplyScalar(RADIUS * Math.cos(t)).addScaledVector(other, RADIUS * Math.sin(t));
        return turned(p.add(center));
      });
      const ink = runs(motor, i) ? "torque" : "wheel";
      labels.push({ text: runs(motor, i) ? `${name}, motor on` : name, key: name, ink, tip: rim[0], along: rim });
    });
    return labels;
  }
}

const runs = (motor: Float64Array | null, i: number): boolean => motor !== null && motor[i] !== 0;

// Draws a rim, four spokes and a hub about z, also visible through the body.
function ring(palette: Palette): { group: Group; materials: { color: Color }[] } {
  const group = new Group();
  const materials: { color: Color }[] = [];
  for (const hidden of [false, true]) {
    const material = hidden
      ? new MeshBasicMaterial({ transparent: true, opacity: 0.45, depthFunc: GreaterDepth, depthWrite: false })
      : new MeshStandardMaterial({ roughness: 0.5 });
    palette.bind(material.color, "wheel");
    materials.push(material);
    const parts: Mesh[] = [new Mesh(new TorusGeometry(RADIUS, 0.035, 16, 64), material)];
    for (const turn of [0, Math.PI / 2]) {
      const spoke = new Mesh(new CylinderGeometry(0.016, 0.016, 2 * RADIUS, 12), material);
      spoke.rotation.z = turn;
      parts.push(spoke);
    }
    parts.push(new Mesh(new CylinderGeometry(0.055, 0.055, 0.12, 24).rotateX(Math.PI / 2), material));
    for (const part of parts) part.renderOrder = hidden ? 4 : 0;
    group.add(...parts);
  }
  return { group, materials };
}
