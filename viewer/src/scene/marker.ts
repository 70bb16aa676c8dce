/**
 * A point that is always visible: a dot with a rim of paper, over everything, and fainter behind a
 * solid.
 */
import { GreaterDepth, Group, Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import { kept } from "./dispose";
import type { Ink, Palette } from "./palette";

const SPHERE = kept(new SphereGeometry(1, 24, 16));

export class Marker {
  readonly object = new Group();

  /** `solid`: the point may be behind an object that hides it. */
  constructor(ink: Ink, radius: number, solid: boolean, palette: Palette) {
    const layers: { ink: Ink; size: number; hidden: boolean }[] = [
      { ink: "paper", size: 1.45, hidden: false },
      { ink, size: 1, hidden: false },
    ];
    if (solid) layers.push({ ink, size: 1, hidden: true });
    layers.forEach(({ ink, size, hidden }, k) => {
      const look = hidden
        ? { transparent: true, opacity: 0.4, depthFunc: GreaterDepth, depthWrite: false }
        : { transparent: true, depthTest: solid, depthWrite: false };
      const material = palette.shared(hidden ? "marker behind" : `marker ${solid}`, ink, () => new MeshBasicMaterial(look));
      const mesh = new Mesh(SPHERE, material);
      mesh.scale.setScalar(size * radius);
      mesh.renderOrder = 20 + k;
      this.object.add(mesh);
    });
  }
}
