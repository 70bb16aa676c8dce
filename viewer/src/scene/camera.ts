/**
 * Orbit of the camera: azimuth and height around the visible content, all of which is in the frame
 * from every side. The camera keeps fixed axes, or rotates with the body. One finger or the mouse
 * rotates it; two fingers or the wheel zoom.
 */
import { PerspectiveCamera, Quaternion, Vector3 } from "three";
import { fit } from "./framing";

const VIEW = 28;
/** Margins of the picture for labels, px. */
const MARGIN = { beside: 21, above: 26 };

export class OrbitCamera {
  readonly camera = new PerspectiveCamera(VIEW, 1, 0.05, 200);
  /** Angles, rad. */
  azimuth = 0;
  height = 0;
  /** Points that must be visible, in `frame`. */
  content: Vector3[] = [];
  zoom = 1;
  /** Angles of the home position, rad. */
  homeAzimuth = 0.62;
  homeHeight = 0.36;
  /** Target of the camera in space, and distance from it. */
  distance = 1;
  readonly target = new Vector3();
  /** Rotation from the frame in which azimuth and height are measured, with z up, to space. */
  readonly frame = new Quaternion();

  /** Origin of the content, in space. */
  readonly origin = new Vector3();

  readonly #pointers = new Map<number, { x: number; y: number }>();
  readonly #changed: () => void;
  readonly #homed: () => void;

  /** `homed` is called when the camera returns home, and its content must be determined again. */
  constructor(surface: HTMLElement, changed: () => void, homed: () => void) {
    this.#changed = changed;
    this.#homed = homed;
    this.azimuth = this.homeAzimuth;
    this.height = this.homeHeight;
    surface.addEventListener("pointerdown", (event) => {
      surface.setPointerCapture(event.pointerId);
      this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    surface.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"] as const) {
      surface.addEventListener(end, (event) => this.#pointers.delete(event.pointerId));
    }
    surface.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.dolly(Math.exp(-0.0012 * event.deltaY));
      },
      { passive: false },
    );
    surface.addEventListener("dblclick", () => this.home());
  }

  home(): void {
    this.azimuth = this.homeAzimuth;
    this.height = this.homeHeight;
    this.zoom = 1;
    this.#homed();
    this.#changed();
  }

  turn(azimuth: number, height: number): void {
    this.azimuth += azimuth;
    this.height = Math.min(Math.max(this.height + height, -1.5), 1.5);
    this.#changed();
  }

  dolly(factor: number): void {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.3), 8);
    this.#changed();
  }

  /** Places the camera for a picture of this width and height. */
  place(width: number, height: number): void {
    const aspect = width / height;
    const half = Math.tan((VIEW / 2) * (Math.PI / 180));
    const inside = (margin: number, size: number): number => 1 - 2 * Math.min(margin / size, 0.1);
    const flat = Math.cos(this.height);
    const back = new Vector3(flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.height));
    const { target, distance } = fit(this.content, back, half * aspect * inside(MARGIN.beside, width), half * inside(MARGIN.above, height));
    this.target.copy(target).applyQuaternion(this.frame).add(this.origin);
    this.distance = distance / this.zoom;
    this.camera.aspect = aspect;
    this.camera.near = this.distance / 50;
    this.camera.far = this.distance * 20;
    this.camera.position.copy(back).multiplyScalar(this.distance).applyQuaternion(this.frame).add(this.target);
    this.camera.up.copy(new Vector3(0, 0, 1).applyQuaternion(this.frame));
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  #move(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    if (!before) return;
    const now = { x: event.clientX, y: event.clientY };
    const others = [...this.#pointers].filter(([id]) => id !== event.pointerId);
    const other = others[0]?.[1];
    if (other) {
      const was = Math.hypot(before.x - other.x, before.y - other.y);
      const is = Math.hypot(now.x - other.x, now.y - other.y);
      if (was > 0) this.dolly(is / was);
    } else {
      this.turn(-0.008 * (now.x - before.x), 0.008 * (now.y - before.y));
    }
    this.#pointers.set(event.pointerId, now);
  }
}
