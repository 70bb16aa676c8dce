/**
 * Colours of the 3-D view, from the same style sheet as the page, and the materials that have them. A material that is bound to a name
 * follows the theme. Axes have the colours of Okabe and Ito, which colour-blind people can tell apart.
 */
import { Color, type Material } from "three";
import { ink as colour } from "../theme";

export const INKS = [
  "paper",
  "ink",
  "faint",
  "quiet",
  "solid",
  "contour",
  "edge",
  "axis-1",
  "axis-2",
  "axis-3",
  "omega",
  "torque",
  "wheel",
  "warn",
  "danger",
] as const;

export type Ink = (typeof INKS)[number];

export class Palette {
  readonly #bound = new Map<Color, { ink: Ink; strength: number }>();
  readonly #shared = new Map<string, Material>();
  readonly #owned = new Set<Material>();

  /** Gives the colour its value, now and whenever the theme changes; below strength 1 it is mixed with the paper's. */
  bind(color: Color, ink: Ink, strength = 1): void {
    this.#bound.set(color, { ink, strength });
    this.#set(color, ink, strength);
  }

  /** A material that all who ask for the same share; it outlives what is drawn with it, so that its program is compiled once. */
  shared<M extends Material & { color: Color }>(kind: string, ink: Ink, make: () => M, strength = 1): M {
    const key = `${kind} ${ink} ${strength}`;
    const known = this.#shared.get(key);
    if (known) return known as M;
    const made = make();
    this.bind(made.color, ink, strength);
    this.#shared.set(key, made);
    this.#owned.add(made);
    return made;
  }

  /** Whether all share it. */
  owns(material: Material): boolean {
    return this.#owned.has(material);
  }

  /** A material is no more. */
  forget(material: Material): void {
    if ("color" in material && material.color instanceof Color) this.#bound.delete(material.color);
  }

  refresh(): void {
    for (const [color, { ink, strength }] of this.#bound) this.#set(color, ink, strength);
  }

  #set(color: Color, ink: Ink, strength: number): void {
    color.set(this.value(ink));
    if (strength < 1) color.lerp(new Color(this.value("paper")), 1 - strength);
  }

  value(ink: Ink): string {
    return colour(ink);
  }
}
