/**
 * Colours of the 3-D view, from the same style sheet as the page. A material that is bound to a name follows the theme. Axes have the
 * colours of Okabe and Ito, which colour-blind people can tell apart.
 */
import { Color } from "three";

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
] as const;

export type Ink = (typeof INKS)[number];

export class Palette {
  readonly #bound: { color: Color; ink: Ink; strength: number }[] = [];

  /** Gives the colour its value, now and whenever the theme changes; below strength 1 it is mixed with the paper's. */
  bind(color: Color, ink: Ink, strength = 1): void {
    this.#bound.push({ color, ink, strength });
    this.#set(color, ink, strength);
  }

  refresh(): void {
    for (const { color, ink, strength } of this.#bound) this.#set(color, ink, strength);
  }

  #set(color: Color, ink: Ink, strength: number): void {
    color.set(this.value(ink));
    if (strength < 1) color.lerp(new Color(this.value("paper")), 1 - strength);
  }

  value(ink: Ink): string {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${ink}`).trim();
  }
}
