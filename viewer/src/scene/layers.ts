/** Layers of the 3-D view, and the pictures to which they belong. */
import type { Object3D } from "three";
import type { Ink } from "./palette";

export type Picture = "body" | "poinsot" | "cones" | "sphere";

export interface Layer {
  id: string;
  label: string;
  /** Colour in the legend; null for a layer without its own colour. */
  ink: Ink | null;
  look: "arrow" | "line" | "area";
  /** Pictures that contain the layer, and whether it is on there. */
  on: Partial<Record<Picture, boolean>>;
  objects: Object3D[];
}

/**
 * Shows the layers that are on in a picture, restricted to `ids` if given, and hides all others.
 */
export function apply(layers: Layer[], picture: Picture, ids: readonly string[] | null): void {
  for (const layer of layers) {
    const isAllowed = ids === null || ids.includes(layer.id);
    for (const object of layer.objects) object.visible = isAllowed && layer.on[picture] === true;
  }
}
