/**
 * Colours of the 3-D view, from the same style sheet as the page. A material that is bound to a name follows the theme. Axes have the
 * colours of Okabe and Ito, which colour-blind people can tell apart.
 */
import type { Color } from "three";

export type Ink =
  | "paper"
  | "ink"
  | "faint"
  | "quiet"
  | "solid"
  | "contour"
  | "edge"
  | "axis-1"
  | "axis-2"
  | "axis-3"
  | "omega"
  | "torque";

export class Palette {
  readonly #bound: { color: Color; ink: Ink }[] = [];

  /** Gives the colour its value, now and whenever the theme changes. */
  bind(color: Color, ink: Ink): void {
    color.set(this.value(ink));
    this.#bound.push({ color, ink });
  }

  refresh(): void {
    for (const { color, ink } of this.#bound) color.set(this.value(ink));
  }

  value(ink: Ink): string {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${ink}`).trim();
  }
}
