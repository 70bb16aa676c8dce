/**
 * The 3-D view: the canvas with its camera, light and names, and on it the scene of a motion, which may give place to that of another. A
 * frame is drawn only if something changed.
 */
import { DirectionalLight, HemisphereLight, Quaternion, Scene, Vector3, WebGLRenderer } from "three";
import type { Quaternion as Attitude } from "../attitude";
import type { PageData } from "../data";
import type { Motion } from "../motion";
import type { BodyModel } from "./body";
import { OrbitCamera } from "./camera";
import { Labels } from "./labels";
import { apply, type Layer, type Picture } from "./layers";
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
  readonly #lamp = new DirectionalLight(0xffffff, 2.1);
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
    this.orbit = new OrbitCamera(canvas, () => this.invalidate());
    this.labels = new Labels(overlay);
    this.#trails = new TrailCurves(this.#palette);
    this.#scene.add(new HemisphereLight(0xffffff, 0x8a8f98, 1.5), this.#lamp, this.#trails.object);
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

  /** Of the arrow of ω, in the picture's space: where its tip is, and how long 1 rad/s is. Null if it is not shown. */
  get omega(): { tip: Vector3; scale: number } | null {
    const isOn = this.layers.find(({ id }) => id === "omega")?.on[this.picture] === true;
    const { omega, scales } = this.#shown;
    return this.picture === "body" && isOn ? { tip: omega.tip, scale: scales.omega } : null;
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

  // What the camera has to see, and where its home is.
  #frame(): void {
    const { poinsot, cones, sphere, model } = this.#shown;
    const orbit = this.orbit;
    orbit.radius = {
      body: Math.max(1.58, 1.04 * model.extent),
      poinsot: 1.08 * (poinsot?.radius ?? 1),
      cones: 1.14 * (cones?.radius ?? 1),
      sphere: 1.5,
    }[this.picture];
    orbit.homeHeight = { body: 0.36, poinsot: 0.5, cones: 0.45, sphere: 0.4 }[this.picture];
    orbit.homeAzimuth = 0.62;
    const middle = sphere?.middle;
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
    if (width < 1 || height < 1) return;
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
    this.#pose(this.#time, this.held);
    const { width, height } = this.#size;
    this.#aim();
    this.orbit.place(width, height);
    this.#lamp.position.copy(this.orbit.camera.position).add(this.orbit.camera.up.clone().multiplyScalar(this.orbit.radius));
    this.#renderer.render(this.#scene, this.orbit.camera);
    const { picture, orbit } = this;
    this.labels.draw(this.#shown.labels(picture, this.#time, orbit.camera, this.#allowed), this.#shown.outline(picture, orbit.camera), orbit.camera, width, height);
    for (const gone of this.#gone.splice(0)) gone.dispose();
    for (const then of this.drawn) then();
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
    if (!pen) return out;
    pen.fillStyle = this.#palette.value("paper");
    pen.fillRect(0, 0, out.width, out.height);
    pen.drawImage(this.#canvas, 0, 0);
    pen.scale(out.width / this.#size.width, out.height / this.#size.height);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (const label of this.labels.placed) {
      pen.font = [...label.text].length <= 2 ? '19px "Polhode Math"' : "600 13px system-ui, sans-serif";
      pen.fillStyle = this.#palette.value(label.ink);
      pen.strokeStyle = this.#palette.value(label.ink);
      if (label.led) {
        pen.globalAlpha = 0.6;
        pen.beginPath();
        pen.moveTo(label.tipX, label.tipY);
        pen.lineTo(label.endX, label.endY);
        pen.stroke();
        pen.globalAlpha = 1;
      }
      pen.fillText(label.text, label.x, label.y);
    }
    return out;
  }

  #pose(time: number, held: Attitude | null): void {
    this.#shown.pose(time, this.picture, this.trailed, this.#trails, held);
  }

  // In Poinsot's picture and the cones' the invariable plane is level: up is L.
  #aim(): void {
    const { poinsot, cones, body, principal, middle } = this.#shown;
    const frame = this.orbit.frame.identity();
    this.orbit.target.set(0, 0, 0);
    if (this.picture === "body") this.orbit.target.copy(middle);
    const level = this.picture === "poinsot" || this.picture === "cones";
    if (this.rides === "body") {
      this.orbit.target.set(0, 0, 0);
      frame.copy(body.quaternion);
      if (this.picture !== "body") frame.multiply(principal);
    } else if (level) {
      const shown = this.picture === "poinsot" ? poinsot : cones;
      if (!shown) return;
      frame.setFromUnitVectors(new Vector3(0, 0, 1), shown.up);
      this.orbit.target.copy(shown.middle);
    }
  }
}
