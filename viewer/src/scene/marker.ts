/** A point that is seen wherever it is: a dot with a rim of paper, over everything. What is behind a solid is fainter. */
import { GreaterDepth, Group, Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import type { Ink, Palette } from "./palette";

export class Marker {
  readonly object = new Group();

  /** `solid`: it may be behind something that hides it. */
  constructor(ink: Ink, radius: number, solid: boolean, palette: Palette) {
    const sphere = new SphereGeometry(1, 24, 16);
    const layers: { ink: Ink; size: number; hidden: boolean }[] = [
      { ink: "paper", size: 1.45, hidden: false },
      { ink, size: 1, hidden: false },
    ];
    if (solid) layers.push({ ink, size: 1, hidden: true });
    layers.forEach(({ ink, size, hidden }, k) => {
      const look = hidden
        ? { transparent: true, opacity: 0.4, depthFunc: GreaterDepth, depthWrite: false }
        : { transparent: true, depthTest: solid, depthWrite: false };
      const material = new MeshBasicMaterial(look);
      palette.bind(material.color, ink);
      const mesh = new Mesh(sphere, material);
      mesh.scale.setScalar(size * radius);
      mesh.renderOrder = 20 + k;
      this.object.add(mesh);
    });
  }
}
