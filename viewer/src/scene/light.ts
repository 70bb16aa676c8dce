/**
 * Light of a scene: from the sky, and from a side of the camera, so that no visible side is dark.
 */
import { DirectionalLight, HemisphereLight } from "three";
import type { OrbitCamera } from "./camera";

export class Light {
  readonly #lamp = new DirectionalLight(0xffffff, 2.1);
  readonly objects = [new HemisphereLight(0xffffff, 0x8a8f98, 1.5), this.#lamp];

  follow({ camera, distance }: OrbitCamera): void {
    this.#lamp.position.copy(camera.position).addScaledVector(camera.up, 0.25 * distance);
  }
}
