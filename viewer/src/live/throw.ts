/**
 * Body in the hand: while this mode is on, a drag rotates the body about its centre of rotation. On
 * release, it continues with the rate of the hand.
 */
import { Vector3 } from "three";
import type { App } from "../app";
import { type Quaternion, rotate, type Vector } from "../attitude";
import { byId, element, svgElement } from "../dom";
import type { View } from "../scene/scene";
import { between, type Held, onBall, product, rateOf, unit } from "./rotation";
import type { Session } from "./session";

/** Rotation for an arrow key, rad. */
const TURN = 0.06;
/** Radius of the ball that the pointer rotates, relative to the body's radius. */
const BALL = 1.2;
/** Path of the button's icon. */
const ARC =
  "M6.5 13a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM8.2 9.6C9.8 5.8 13 3.6 17 3.3V.8l5 3.9-5 3.9V5.5c-3.2.3-5.6 2-6.9 4.9zM12.6 14.3c.7-2 2.2-3.2 4.2-3.6l.4 2c-1.3.3-2.2 1-2.7 2.3z";
/** Length of the recorded path, s. */
const MEMORY = 0.5;

export class Throw {
  readonly button = element("button", { type: "button", id: "throw", "aria-pressed": "false", title: "Take the body and throw it (g)" }, ball(), "Throw");
  readonly #app: App;
  readonly #view: View;
  readonly #session: Session;
  #isOn = false;
  #pointer: number | null = null;
  #last: Vector = [0, 0, 1];
  #path: Held[] = [];

  constructor(app: App, view: View, session: Session) {
    this.#app = app;
    this.#view = view;
    this.#session = session;
    this.button.addEventListener("click", () => this.toggle());
    // Registered to run before the camera's listeners.
    const stage = byId("stage");
    stage.addEventListener("pointerdown", (event) => this.#take(event), { capture: true });
    stage.addEventListener("pointermove", (event) => this.#move(event), { capture: true });
    for (const end of ["pointerup", "pointercancel"] as const) stage.addEventListener(end, (event) => this.#release(event), { capture: true });
    byId("canvas").addEventListener("keydown", (event) => this.#key(event));
    session.listen({
      changed: () => {
        if (session.trouble && this.#pointer === null) view.held = null;
      },
      moved: () => {
        if (this.#pointer === null && this.#path.length > 0) {
          this.#path = [];
          this.#view.held = null;
        }
      },
    });
  }

  toggle(): void {
    this.#isOn = !this.#isOn;
    this.button.setAttribute("aria-pressed", String(this.#isOn));
    byId("stage").classList.toggle("throwing", this.#isOn);
    if (this.#isOn && this.#view.picture !== "body") document.querySelector<HTMLElement>('[data-picture="body"]')?.click();
  }

  #take(event: PointerEvent): void {
    if (!this.#isOn || this.#pointer !== null || event.target !== byId("canvas")) return;
    event.stopPropagation();
    event.preventDefault();
    byId("canvas").focus();
    byId("canvas").setPointerCapture(event.pointerId);
    this.#pointer = event.pointerId;
    this.#app.clock.pause();
    this.#last = this.#onBall(event);
    this.#path = [{ time: event.timeStamp / 1000, attitude: this.#view.attitude }];
  }

  #move(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    event.stopPropagation();
    const next = this.#onBall(event);
    const attitude = unit(product(this.#inSpace(between(this.#last, next)), this.#view.held ?? this.#view.attitude));
    this.#last = next;
    const time = event.timeStamp / 1000;
    this.#path = [...this.#path.filter((held) => held.time > time - MEMORY), { time, attitude }];
    this.#view.held = attitude;
    this.#view.invalidate();
  }

  #release(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    event.stopPropagation();
    this.#pointer = null;
    const attitude = this.#path.at(-1)?.attitude;
    if (!attitude || this.#path.length < 2) return;
    // The rate is divided by the clock speed, so that the body continues as it was seen to turn.
    const rate = rateOf(this.#path, event.timeStamp / 1000).map((w) => w / this.#app.clock.speed) as Vector;
    this.#session.edit({ attitude, omega: rate });
    const { clock } = this.#app;
    clock.set(clock.start);
    clock.play();
  }

  // The arrow keys rotate the body, and ω is kept.
  #key(event: KeyboardEvent): void {
    if (!this.#isOn || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
    const axis = { ArrowRight: [0, 1, 0], ArrowLeft: [0, -1, 0], ArrowUp: [-1, 0, 0], ArrowDown: [1, 0, 0] }[event.key];
    if (!axis) return;
    event.preventDefault();
    event.stopPropagation();
    const { clock } = this.#app;
    const { omega } = this.#app.motion.at(clock.time);
    const before = this.#view.held ?? this.#view.attitude;
    clock.pause();
    clock.set(clock.start);
    const turn: Quaternion = [Math.cos(TURN / 2), ...(axis.map((c) => c * Math.sin(TURN / 2)) as Vector)];
    const attitude = unit(product(this.#inSpace(turn), before));
    this.#view.held = attitude;
    this.#path = [{ time: 0, attitude }];
    this.#session.edit({ attitude, omega });
    this.#view.invalidate();
  }

  // Converts a rotation in axes of the eye to space axes.
  #inSpace(turn: Quaternion): Quaternion {
    const q = this.#view.orbit.camera.quaternion;
    const eye: Quaternion = [q.w, q.x, q.y, q.z];
    const [x, y, z] = rotate(eye, [turn[1], turn[2], turn[3]]);
    return [turn[0], x, y, z];
  }

  #onBall(event: PointerEvent): Vector {
    const box = byId("canvas").getBoundingClientRect();
    const middle = new Vector3();
    const [cx, cy] = this.#view.project(middle);
    const side = new Vector3(1, 0, 0).applyQuaternion(this.#view.orbit.camera.quaternion).multiplyScalar(BALL);
    const radius = Math.abs(this.#view.project(side)[0] - cx) || 1;
    return onBall((event.clientX - box.left - cx) / radius, -(event.clientY - box.top - cy) / radius);
  }
}

/** Creates the icon of the button: a ball that is thrown in an arc. */
function ball(): SVGSVGElement {
  const svg = svgElement("svg", { class: "icon", viewBox: "0 0 24 24", "aria-hidden": "true" });
  svg.append(svgElement("path", { d: ARC }));
  return svg;
}
