/** Release of GPU memory when a part of the scene is removed. Shared resources stay. */
import type { BufferGeometry, Material, Object3D } from "three";
import type { Palette } from "./palette";

/** Marks a geometry that is made once and used by many objects. */
export function kept<G extends BufferGeometry>(geometry: G): G {
  geometry.userData.kept = true;
  return geometry;
}

export function dispose(root: Object3D, palette: Palette): void {
  root.traverse((object) => {
    const { geometry, material } = object as { geometry?: BufferGeometry; material?: Material | Material[] };
    if (geometry && geometry.userData.kept !== true) geometry.dispose();
    for (const one of material ? [material].flat() : []) {
      if (palette.owns(one)) continue;
      palette.forget(one);
      one.dispose();
    }
  });
  root.removeFromParent();
}
