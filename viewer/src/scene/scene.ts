/**
 * The 3-D view: the canvas with its camera, light and names, and on it the scene of a motion, which may give place to that of another. A
 * frame is drawn only if something changed.
 */
import { Quaternion, Scene, Vector3, WebGLRenderer } from "three";
import type { Quaternion as Attitude } from "../attitude";
import type { PageData } from "../data";
import type { Motion } from "../motion";
import type { BodyModel } from "./body";
import { OrbitCamera } from "./camera";
import { compose } from "./compose";
import { Labels } from "./labels";
import { apply, type Layer, type Picture } from "./layers";
import { Light } from "./light";
import { MotionScene } from "./motion-scene";
import { Palette } from "./palette";
import { TrailCurves, type Trailed } from "./trails";

/** What is shown of a body before it moves. */
const BARE = ["body", "ellipsoid", "pivot", "space-axes", "body-axes"];

export class View {
  readonly orbit: OrbitCamera;
  readonly labels: Labels;
  picture: Picture = "body";
  /** Whose axes the camera keeps: those of space, or the body's. */
  rides: "space" | "body" = "space";
  trailed: Trailed;
  /** An attitude to show instead of the motion's: a body in the hand. */
  held: Attitude | null = null;
  /** Arrows keep their scale whatever comes: one of them is in the hand. */
  isHeld = false;
  /** What else is to be done when a frame is drawn. */
  readonly drawn: (() => void)[] = [];

  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #palette = new Palette();
  readonly #light = new Light();
  readonly #trails: TrailCurves;
  #shown: MotionScene;
  /** Until the next frame is drawn, so that programs of materials are not compiled again. */
  #gone: MotionScene[] = [];
  #time: number;
  #size = { width: 1, height: 1 };
  #waiting = false;
  /** The layers that may be seen; null for all that are on. */
  #allowed: readonly string[] | null = null;

  /** Throws if the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement, overlay: HTMLElement, page: PageData, motion: Motion) {
    this.#canvas = canvas;
    this.#time = motion.times[0];
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    // Asking for errors waits for the compiler, a large part of the time to the first frame.
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.orbit = new OrbitCamera(canvas, () => this.invalidate(), () => this.#shown.refit());
    this.labels = new Labels(overlay);
    this.#trails = new TrailCurves(this.#palette);
    this.#scene.add(...this.#light.objects, this.#trails.object);
    this.#shown = new MotionScene(page, motion, this.#trails.object, this.#palette, null);
    this.#scene.add(this.#shown.space, this.#shown.body);
    this.trailed = this.#shown.telling;
    this.show("body");
  }

  get layers(): Layer[] {
    return this.#shown.layers;
  }

  get model(): BodyModel {
    return this.#shown.model;
  }

  get pictures(): Picture[] {
    return this.#shown.pictures;
  }

  /** Of the arrow of ω, in the picture's space: where it begins, its tip from there, and how long 1 rad/s is. Null if it is not shown. */
  get omega(): { foot: Vector3; tip: Vector3; scale: number } | null {
    const isOn = this.layers.find(({ id }) => id === "omega")?.on[this.picture] === true;
    const { middle, omega, scales } = this.#shown;
    return this.picture === "body" && isOn ? { foot: middle, tip: omega.tip, scale: scales.omega } : null;
  }

  /** (w, x, y, z) of the body as it is shown now. */
  get attitude(): Attitude {
    const q = this.#shown.body.quaternion;
    return [q.w, q.x, q.y, q.z];
  }

  /** Where a point of the picture's space is on the canvas, px. */
  project(point: Vector3): [number, number] {
    const v = point.clone().project(this.orbit.camera);
    return [(0.5 + v.x / 2) * this.#size.width, (0.5 - v.y / 2) * this.#size.height];
  }

  /** The point under a place of the canvas, px, in the plane through `through` that faces the camera. */
  unproject(x: number, y: number, through: Vector3): Vector3 {
    const { camera } = this.orbit;
    const ray = new Vector3((2 * x) / this.#size.width - 1, 1 - (2 * y) / this.#size.height, 0.5).unproject(camera).sub(camera.position);
    const forward = camera.getWorldDirection(new Vector3());
    const reach = through.clone().sub(camera.position).dot(forward) / ray.dot(forward);
    return ray.multiplyScalar(reach).add(camera.position);
  }

  /** Objects on the graphics card. */
  get memory(): { geometries: number; textures: number; programs: number } {
    const { memory, programs } = this.#renderer.info;
    return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
  }

  /** Shows another motion from where the person looks; `anew`: as the first one was shown. */
  replace(page: PageData, motion: Motion, anew: boolean): void {
    const before = this.#shown;
    this.#shown = new MotionScene(page, motion, this.#trails.object, this.#palette, anew ? null : before, this.isHeld);
    before.space.removeFromParent();
    before.body.removeFromParent();
    this.#scene.add(this.#shown.space, this.#shown.body);
    this.#gone.push(before);
    // A window that is not seen draws no frame.
    if (this.#gone.length > 2) this.#gone.shift()?.dispose();
    if (anew) this.trailed = this.#shown.telling;
    if (anew || !this.pictures.includes(this.picture)) this.show("body");
    else {
      this.#shown.open(this.picture);
      this.#apply();
      this.#frame();
    }
    this.invalidate();
  }

  /** Draws `time` in the next frame. */
  set time(time: number) {
    this.#time = time;
    this.invalidate();
  }

  show(asked: Picture): void {
    const picture = this.#allowed ? "body" : asked;
    this.picture = picture;
    this.rides = picture === "sphere" ? "body" : "space";
    this.#shown.open(picture);
    this.#apply();
    this.#frame();
    this.orbit.home();
  }

  #apply(): void {
    apply(this.layers, this.picture, this.#allowed);
  }

  /** Whether only the body and its axes are shown, and nothing of its motion. */
  set isBare(isBare: boolean) {
    if (isBare === (this.#allowed !== null)) return;
    this.#allowed = isBare ? BARE : null;
    if (isBare) this.show("body");
    this.#apply();
    this.invalidate();
  }

  // Where the camera's home is.
  #frame(): void {
    const { orbit } = this;
    orbit.homeHeight = { body: 0.36, poinsot: 0.5, cones: 0.45, sphere: 0.4 }[this.picture];
    orbit.homeAzimuth = 0.62;
    const middle = this.#shown.sphere?.middle;
    if (this.picture === "sphere" && middle) {
      // This motion's curve is in front.
      orbit.homeHeight = middle.z > 0.3 ? 0.6 : middle.z < -0.3 ? -0.6 : 0.4;
      if (Math.hypot(middle.x, middle.y) > 0.3) orbit.homeAzimuth = Math.atan2(middle.y, middle.x) + 0.5;
    }
  }

  toggle(layer: Layer): void {
    layer.on[this.picture] = !layer.on[this.picture];
    this.#apply();
    this.invalidate();
  }

  resize(width: number, height: number): void {
    const isSame = width === this.#size.width && height === this.#size.height;
    if (width < 1 || height < 1 || isSame) return;
    this.#size = { width, height };
    this.#renderer.setSize(width, height, false);
    this.render();
  }

  recolor(): void {
    this.#palette.refresh();
    this.invalidate();
  }

  invalidate(): void {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => {
      if (this.#waiting) this.render();
    });
  }

  render(): void {
    this.#waiting = false;
    const { width, height } = this.#size;
    this.draw(this.#renderer, this.labels, this.#time, width, height, this.held);
    for (const gone of this.#gone.splice(0)) gone.dispose();
    for (const then of this.drawn) then();
  }

  /**
   * A frame of `time`, of so many pixels of the page: on the screen, or for a file with a renderer and names of its own. With an attitude
   * that is not the motion's if the body is in the hand.
   */
  draw(renderer: WebGLRenderer, labels: Labels, time: number, width: number, height: number, held: Attitude | null = null): void {
    const { picture, orbit } = this;
    const shown = this.#shown;
    orbit.content = shown.content(picture, this.rides);
    this.#pose(time, held);
    shown.aim(picture, this.rides, orbit.frame);
    if (this.rides === "body") orbit.origin.copy(shown.middle);
    else orbit.origin.set(0, 0, 0);
    orbit.place(width, height);
    const { camera } = orbit;
    this.#light.follow(orbit);
    renderer.render(this.#scene, camera);
    const names = shown.labels(picture, time, camera.position, this.#allowed);
    labels.draw(names, shown.outline(picture, camera.position), shown.middle, camera, width, height);
  }

  /** (w, x, y, z) of the body as the scene has it at `time`. */
  attitudeAt(time: number): Attitude {
    this.#pose(time, null);
    this.#shown.body.updateMatrixWorld(true);
    const q = this.#shown.body.getWorldQuaternion(new Quaternion());
    this.#pose(this.#time, this.held);
    return [q.w, q.x, q.y, q.z];
  }

  /** The frame as it is on the screen, labels too. */
  photograph(): HTMLCanvasElement {
    this.render();
    const out = document.createElement("canvas");
    out.width = this.#canvas.width;
    out.height = this.#canvas.height;
    const pen = out.getContext("2d");
    if (pen) compose(pen, this.#canvas, this.labels.placed, out.width / this.#size.width, true);
    return out;
  }

  #pose(time: number, held: Attitude | null): void {
    this.#shown.pose(time, this.picture, this.trailed, this.#trails, held);
  }
}
