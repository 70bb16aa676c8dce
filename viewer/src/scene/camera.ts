/**
 * The camera's orbit: azimuth and height around what has to be seen, all of which is in the frame from every side. It looks along fixed
 * axes, or rides with the body. One finger or the mouse turns it, two fingers or the wheel bring it nearer.
 */
import { PerspectiveCamera, Quaternion, Vector3 } from "three";
import { fit } from "./framing";

const VIEW = 28;
/** At the edges of the picture, px: names stand there. */
const MARGIN = { beside: 21, above: 26 };

export class OrbitCamera {
  readonly camera = new PerspectiveCamera(VIEW, 1, 0.05, 200);
  /** rad */
  azimuth = 0;
  height = 0;
  /** What has to be seen, in `frame`. */
  content: Vector3[] = [];
  zoom = 1;
  /** Where `home` is. */
  homeAzimuth = 0.62;
  homeHeight = 0.36;
  /** What the camera looks at, in space, and from how far. */
  distance = 1;
  readonly target = new Vector3();
  /** Takes the frame in which azimuth and height are measured, with z up, to space. */
  readonly frame = new Quaternion();

  /** From where, in space, content is measured. */
  readonly origin = new Vector3();

  readonly #pointers = new Map<number, { x: number; y: number }>();
  readonly #changed: () => void;
  readonly #homed: () => void;

  /** `homed`: it goes home, and what it has to see is to be found anew. */
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

  /** Places the camera for a picture of this width by this height. */
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
