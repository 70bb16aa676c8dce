/** Axes of space, axes of the body, and its principal axes, as arrows with letters. */
import { Group, type Quaternion, Vector3 } from "three";
import { Arrow } from "./arrows";
import type { Label } from "./labels";
import type { Layer } from "./layers";
import type { Palette } from "./palette";
import { axis } from "./trails";

const INKS = ["axis-1", "axis-2", "axis-3"] as const;

interface Kind {
  layer: string;
  label: string;
  names: string[];
  reach: number;
  width: number;
  on: Layer["on"];
}

export class Axes {
  readonly space = new Group();
  /** Groups that rotate with the body. */
  readonly body = new Group();
  readonly principal = new Group();
  readonly layers: Layer[] = [];
  readonly #principal: Arrow[] = [];
  readonly #drawn: { layer: string; text: string; tip: Vector3; turns: boolean; ink: Label["ink"] }[] = [];

  /** Arrows of space have the length `far`, and those of the body `reach`. */
  constructor(principal: Quaternion, reach: number, far: number, palette: Palette) {
    const off = { poinsot: false, cones: false };
    const kinds: [Group, Kind][] = [
      [
        this.space,
        { layer: "space-axes", label: "Space axes X Y Z", names: ["𝑋", "𝑌", "𝑍"], reach: far, width: 0.006, on: { body: true, ...off } },
      ],
      [
        this.body,
        { layer: "body-axes", label: "Body axes x y z", names: ["𝑥", "𝑦", "𝑧"], reach, width: 0.011, on: { body: true, ...off, sphere: false } },
      ],
      [
        this.principal,
        {
          layer: "principal-axes",
          label: "Principal axes 1 2 3",
          names: ["1", "2", "3"],
          reach: 1.06 * reach,
          width: 0.011,
          on: { body: false, ...off, sphere: true },
        },
      ],
    ];
    for (const [group, { layer, label, names, reach, width, on }] of kinds) {
      const fixed = group === this.space;
      names.forEach((text, k) => {
        const tip = new Vector3(...axis(INKS[k])).multiplyScalar(reach);
        if (group === this.principal) tip.applyQuaternion(principal);
        // Principal axes have the colours of the body axes, but dashes.
        const arrow = new Arrow(fixed ? "faint" : INKS[k], width, palette, group === this.principal);
        arrow.point(tip.x, tip.y, tip.z);
        if (group === this.principal) this.#principal.push(arrow);
        group.add(arrow.object);
        this.#drawn.push({ layer, text, tip, turns: !fixed, ink: fixed ? "quiet" : INKS[k] });
      });
      this.layers.push({ id: layer, label, ink: fixed ? "faint" : "axis-1", look: "arrow", on, objects: [group] });
    }
  }

  /** Lets the principal axes begin at a distance from the origin. */
  begin(foot: number): void {
    for (const arrow of this.#principal) arrow.point(arrow.tip.x, arrow.tip.y, arrow.tip.z, foot);
  }

  labels(on: (id: string) => boolean, turned: (p: Vector3) => Vector3): Label[] {
    const shown = this.#drawn.filter(({ layer }) => on(layer));
    return shown.map(({ text, ink, tip, turns }) => ({ text, ink, tip: turns ? turned(tip) : tip }));
  }
}
