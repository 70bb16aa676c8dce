/**
 * Handle at the tip of ω, dragged in the plane that faces the eye, or moved with the arrow keys.
 * The motion begins at the time at which it is taken.
 */
import { Quaternion, Vector3 } from "three";
import type { App } from "../app";
import { inverse, rotate, type Vector } from "../attitude";
import { byId, element } from "../dom";
import { number } from "../format";
import type { View } from "../scene/scene";
import type { Session } from "./session";

/** Length below which the tip means no rotation, in the picture. */
const ZERO = 0.04;
/** Step for a key, in the picture. */
const STEP = 0.04;
/** Length of 1 rad/s for a body at rest, in the picture. */
const AT_REST = 0.4;

const UNITS: Record<string, number> = {
  "rad/s": 1,
  "mrad/s": 1e-3,
  "deg/s": Math.PI / 180,
  "°/s": Math.PI / 180,
  rpm: Math.PI / 30,
  "1/s": 2 * Math.PI,
  Hz: 2 * Math.PI,
};

export class TipHandle {
  readonly #app: App;
  readonly #view: View;
  readonly #session: Session;
  readonly #handle = element("div", { class: "tip", tabindex: "0", role: "slider", "aria-label": "Angular velocity ω; arrow keys move its tip, + and − its length" });
  readonly #reading = element("output", { class: "tip-reading", hidden: true, "aria-live": "off" });
  /** Position of the pointer during a drag. */
  #tip: Vector3 | null = null;
  #isDragged = false;

  constructor(app: App, view: View, session: Session) {
    this.#app = app;
    this.#view = view;
    this.#session = session;
    byId("stage").append(this.#handle, this.#reading);
    view.drawn.push(() => this.#place());
    session.listen({
      changed: () => {
        if (session.trouble && !this.#isDragged) view.held = null;
      },
      moved: () => {
        if (this.#isDragged) return;
        this.#view.held = null;
        this.#tip = null;
      },
    });
    this.#listen();
  }

  #place(): void {
    const { omega } = this.#view;
    this.#handle.hidden = omega === null || this.#session.document === null;
    if (!omega) return;
    const [x, y] = this.#view.project((this.#tip ?? omega.tip).clone().add(omega.foot));
    this.#handle.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    this.#reading.style.transform = `translate(${(x + 16).toFixed(1)}px, ${(y - 26).toFixed(1)}px)`;
    // The text is updated only while it is relevant.
    if (document.activeElement === this.#handle || this.#isDragged) this.#say();
  }

  #say(): void {
    const { name, size } = this.#unit();
    const omega = this.#omega();
    const words = `|ω| = ${number(Math.hypot(...omega) / size, 4)} ${name}`;
    this.#reading.textContent = words;
    this.#handle.setAttribute("aria-valuetext", `${words}; body axes ${omega.map((w) => number(w / size, 3)).join(", ")}`);
    this.#handle.setAttribute("aria-valuenow", String(Number((Math.hypot(...omega) / size).toPrecision(4))));
  }

  get #scale(): number {
    return this.#view.omega?.scale || AT_REST;
  }

  // Angular velocity in body axes, rad/s.
  #omega(): Vector {
    const tip = this.#tip ?? this.#view.omega?.tip ?? new Vector3();
    return rotate(inverse(this.#view.attitude), [tip.x, tip.y, tip.z].map((c) => c / this.#scale) as Vector);
  }

  // Unit of ω in the scenario.
  #unit(): { name: string; size: number } {
    const { unit } = this.#session.knobs.find(({ group, unit }) => group === "start" && unit in UNITS) ?? { unit: "rad/s" };
    return { name: unit, size: UNITS[unit] ?? 1 };
  }

  // Makes the motion begin at the current time.
  #take(): void {
    const { clock } = this.#app;
    clock.pause();
    if (clock.time > clock.start) {
      this.#view.held = this.#view.attitude;
      clock.set(clock.start);
    }
    this.#view.isHeld = true;
  }

  #put(tip: Vector3): void {
    this.#tip = tip.length() < ZERO ? new Vector3() : tip;
    const omega = this.#omega();
    this.#session.edit(this.#view.held ? { attitude: this.#view.held, omega } : { omega });
    this.#view.invalidate();
  }

  #listen(): void {
    const handle = this.#handle;
    let grip = new Vector3();
    const at = (event: PointerEvent, through: Vector3): Vector3 => {
      const box = byId("canvas").getBoundingClientRect();
      const foot = this.#view.omega?.foot ?? new Vector3();
      return this.#view.unproject(event.clientX - box.left, event.clientY - box.top, through.clone().add(foot)).sub(foot);
    };
    handle.addEventListener("pointerdown", (event) => {
      const tip = this.#view.omega?.tip;
      if (!tip) return;
      event.preventDefault();
      handle.focus();
      handle.setPointerCapture(event.pointerId);
      this.#take();
      this.#isDragged = true;
      this.#reading.hidden = false;
      this.#session.hold();
      this.#tip = tip.clone();
      grip = tip.clone().sub(at(event, tip));
    });
    handle.addEventListener("pointermove", (event) => {
      if (!this.#isDragged || !this.#tip) return;
      const next = at(event, this.#tip).add(grip);
      const along = this.#tip.clone().normalize();
      this.#put(event.shiftKey && along.length() > 0 ? along.multiplyScalar(Math.max(next.dot(along), 0)) : next);
    });
    for (const end of ["pointerup", "pointercancel"]) {
      handle.addEventListener(end, () => {
        if (!this.#isDragged) return;
        this.#isDragged = false;
        this.#reading.hidden = document.activeElement !== handle;
        this.#view.isHeld = false;
        this.#session.release();
      });
    }
    handle.addEventListener("focus", () => {
      this.#reading.hidden = false;
      this.#say();
    });
    handle.addEventListener("blur", () => {
      this.#reading.hidden = !this.#isDragged;
    });
    handle.addEventListener("keydown", (event) => this.#key(event));
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [dx, dy] = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    const factor = event.key === "+" || event.key === "=" ? 1.04 : event.key === "-" || event.key === "−" ? 1 / 1.04 : 1;
    if (dx === 0 && dy === 0 && factor === 1) return;
    event.preventDefault();
    event.stopPropagation();
    const tip = (this.#tip ?? this.#view.omega?.tip)?.clone();
    if (!tip) return;
    this.#take();
    const camera = this.#view.orbit.camera.quaternion;
    const turn = new Quaternion(camera.x, camera.y, camera.z, camera.w);
    this.#put(tip.multiplyScalar(factor).add(new Vector3(STEP * dx, STEP * dy, 0).applyQuaternion(turn)));
    this.#view.isHeld = false;
    this.#say();
  }
}
