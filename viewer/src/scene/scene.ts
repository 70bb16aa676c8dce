/**
 * The 3-D view: the canvas with its camera, light and labels, and the scene of a motion, which can
 * be replaced. A frame is drawn only after a change.
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
import type { Orbit } from "./orbit";
import { Palette } from "./palette";
import { TrailCurves, type Trailed } from "./trails";

/** Layers shown before the motion. */
const BARE = ["body", "ellipsoid", "pivot", "space-axes", "body-axes"];

export class View {
  readonly orbit: OrbitCamera;
  readonly labels: Labels;
  picture: Picture = "body";
  /** Axes that the camera keeps: those of space, or those of the body. */
  rides: "space" | "body" = "space";
  trailed: Trailed;
  /** Attitude shown instead of the motion's: that of a body in the hand. */
  held: Attitude | null = null;
  /** True while an arrow is dragged: arrows then keep their scale. */
  isHeld = false;
  /** Callbacks for each drawn frame. */
  readonly drawn: (() => void)[] = [];

  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #palette = new Palette();
  readonly #light = new Light();
  readonly #trails: TrailCurves;
  #shown: MotionScene;
  /**
   * Scenes kept until the next frame is drawn, so that programs of materials are not compiled
   * again.
   */
  #gone: MotionScene[] = [];
  #time: number;
  #size = { width: 1, height: 1 };
  #waiting = false;
  /** Ids of the layers that may be visible; null for no restriction. */
  #allowed: readonly string[] | null = null;

  /** Throws if the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement, overlay: HTMLElement, page: PageData, motion: Motion) {
    this.#canvas = canvas;
    this.#time = motion.times[0];
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    // Checking for errors would wait for the compiler, which takes a large part of the time to the
    // first frame.
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

  /**
   * Arrow of ω in the space of the picture: its origin, its tip relative to it, and the length of
   * 1 rad/s. Null if it is not shown.
   */
  get omega(): { foot: Vector3; tip: Vector3; scale: number } | null {
    const isOn = this.layers.find(({ id }) => id === "omega")?.on[this.picture] === true;
    const { middle, omega, scales } = this.#shown;
    return this.picture === "body" && isOn ? { foot: middle, tip: omega.tip, scale: scales.omega } : null;
  }

  /** The orbit, if it is shown. */
  get orbitShown(): Orbit | null {
    return this.#shown.orbit;
  }

  /** Attitude (w, x, y, z) of the displayed body. */
  get attitude(): Attitude {
    const q = this.#shown.body.quaternion;
    return [q.w, q.x, q.y, q.z];
  }

  /** Returns the place of a point on the canvas, px. */
  project(point: Vector3): [number, number] {
    const v = point.clone().project(this.orbit.camera);
    return [(0.5 + v.x / 2) * this.#size.width, (0.5 - v.y / 2) * this.#size.height];
  }

  /**
   * Returns the point under a place of the canvas, px, in the plane through `through` that faces
   * the camera.
   */
  unproject(x: number, y: number, through: Vector3): Vector3 {
    const { camera } = this.orbit;
    const ray = new Vector3((2 * x) / this.#size.width - 1, 1 - (2 * y) / this.#size.height, 0.5).unproject(camera).sub(camera.position);
    const forward = camera.getWorldDirection(new Vector3());
    const reach = through.clone().sub(camera.position).dot(forward) / ray.dot(forward);
    return ray.multiplyScalar(reach).add(camera.position);
  }

  /** Numbers of objects on the graphics card. */
  get memory(): { geometries: number; textures: number; programs: number } {
    const { memory, programs } = this.#renderer.info;
    return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
  }

  /** Shows another motion with the present camera, or, with `anew`, as a first one. */
  replace(page: PageData, motion: Motion, anew: boolean): void {
    const before = this.#shown;
    this.#shown = new MotionScene(page, motion, this.#trails.object, this.#palette, anew ? null : before, this.isHeld);
    before.space.removeFromParent();
    before.body.removeFromParent();
    this.#scene.add(this.#shown.space, this.#shown.body);
    this.#gone.push(before);
    // An invisible window draws no frames.
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

  /** Shows only the body and its axes, without its motion. */
  set isBare(isBare: boolean) {
    if (isBare === (this.#allowed !== null)) return;
    this.#allowed = isBare ? BARE : null;
    if (isBare) this.show("body");
    this.#apply();
    this.invalidate();
  }

  // Sets the home position of the camera.
  #frame(): void {
    const { orbit } = this;
    orbit.homeHeight = { body: 0.36, poinsot: 0.5, cones: 0.45, sphere: 0.4 }[this.picture];
    orbit.homeAzimuth = 0.62;
    const middle = this.#shown.sphere?.middle;
    if (this.picture === "sphere" && middle) {
      // The curve of this motion is in front.
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
   * Draws a frame of `time` with the given size in pixels of the page: on the screen, or for a file
   * with its own renderer and labels. `held` replaces the attitude of the motion while the body is
   * in the hand.
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
    shown.orbit?.draw(renderer, camera, width, height);
    const names = shown.labels(picture, time, camera.position, this.#allowed);
    labels.draw(names, shown.outline(picture, camera.position), shown.middle, camera, width, height, shown.orbit?.corner(width, height) ?? null);
  }

  /** Returns the attitude (w, x, y, z) of the body in the scene at `time`. */
  attitudeAt(time: number): Attitude {
    this.#pose(time, null);
    this.#shown.body.updateMatrixWorld(true);
    const q = this.#shown.body.getWorldQuaternion(new Quaternion());
    this.#pose(this.#time, this.held);
    return [q.w, q.x, q.y, q.z];
  }

  /** Returns the frame as on the screen, with labels. */
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
