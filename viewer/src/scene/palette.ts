/**
 * Colours of the 3-D view, from the style sheet of the page, and their materials. A material bound
 * to a name follows the theme. Axes have the colours of Okabe and Ito, which are distinguishable
 * for colour-blind people.
 */
import { Color, type Material } from "three";
import { ink as colour } from "../theme";

export const INKS = [
  "paper",
  "ink",
  "faint",
  "quiet",
  "solid",
  "part-1",
  "part-2",
  "part-3",
  "part-4",
  "part-5",
  "part-6",
  "earth",
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

  /**
   * Sets the colour, now and whenever the theme changes. Below strength 1 it is mixed with the
   * colour of the paper.
   */
  bind(color: Color, ink: Ink, strength = 1): void {
    this.#bound.set(color, { ink, strength });
    this.#set(color, ink, strength);
  }

  /**
   * Returns a shared material. It outlives the objects drawn with it, so that its program is
   * compiled once.
   */
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

  /** Returns true if the material is shared. */
  owns(material: Material): boolean {
    return this.#owned.has(material);
  }

  /** Removes a material that is no longer used. */
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
