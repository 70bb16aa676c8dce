/** What can be shown in the 3-D view, and in which of its pictures. */
import type { Object3D } from "three";
import type { Ink } from "./palette";

export type Picture = "body" | "poinsot" | "cones" | "sphere";

export interface Layer {
  id: string;
  label: string;
  /** The colour of its legend; null for what has none of its own. */
  ink: Ink | null;
  look: "arrow" | "line" | "area";
  /** The pictures that it belongs to, and whether it is on there. */
  on: Partial<Record<Picture, boolean>>;
  objects: Object3D[];
}

/** Shows in a picture what is on there, and nothing else; of that only what is among `ids`, if there are some. */
export function apply(layers: Layer[], picture: Picture, ids: readonly string[] | null): void {
  for (const layer of layers) {
    const isAllowed = ids === null || ids.includes(layer.id);
    for (const object of layer.objects) object.visible = isAllowed && layer.on[picture] === true;
  }
}
