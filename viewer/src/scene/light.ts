/**
 * Light of a scene: soft light from everywhere, stronger from above, and a lamp to the upper left
 * of the camera, so that faces differ and no visible one is dark.
 */
import { DirectionalLight, HemisphereLight, Vector3 } from "three";
import type { OrbitCamera } from "./camera";

export class Light {
  readonly #lamp = new DirectionalLight(0xffffff, 1.7);
  // The sky is that of space, z up.
  readonly objects = [new HemisphereLight(0xffffff, 0xa0a4ab, 1.9), this.#lamp];

  constructor() {
    this.objects[0].position.set(0, 0, 1);
  }

  follow({ camera, distance }: OrbitCamera): void {
    const aside = new Vector3(-0.5, 0.55, 0).applyQuaternion(camera.quaternion);
    this.#lamp.position.copy(camera.position).addScaledVector(aside, distance);
  }
}
