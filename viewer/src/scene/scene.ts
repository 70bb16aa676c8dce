/**
 * The 3-D view. Space axes are three's own, with z up; the group `bodyFrame` has the body's attitude, and everything that turns with the
 * body is in it. A frame is drawn only if something changed.
 */
import {
  DirectionalLight,
  Group,
  HemisphereLight,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { inverse, rotate, type Quaternion as Attitude, type Vector } from "../attitude";
import type { PageData } from "../data";
import { length, lengths, type Moment, type Motion } from "../motion";
import { compose } from "../save/frame";
import { Arrow } from "./arrows";
import { Axes } from "./axes";
import { BodyModel } from "./body";
import { OrbitCamera } from "./camera";
import { Cones } from "./cones";
import { Contents, directions } from "./framing";
import { type Label, Labels } from "./labels";
import { apply, type Layer, type Picture } from "./layers";
import { Marker } from "./marker";
import { Palette } from "./palette";
import { Poinsot } from "./poinsot";
import { MomentumSphere } from "./sphere";
import { HeavyBody } from "./top";
import { axis, Trail, type Trailed } from "./trails";
import { Wheels } from "./wheels";

/** The longest arrow of the body's picture, where the body's radius is 1. */
const LONGEST = 1.5;
const AXES = 1.3;
const THICK = 0.019;

export class View {
  readonly layers: Layer[] = [];
  readonly orbit: OrbitCamera;
  readonly labels: Labels;
  readonly model: BodyModel;
  readonly pictures: Picture[];
  picture: Picture = "body";
  /** Whose axes the camera keeps: those of space, or the body's. */
  rides: "space" | "body" = "space";
  trailed: Trailed;

  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #bodyFrame = new Group();
  readonly #palette = new Palette();
  readonly #lamp = new DirectionalLight(0xffffff, 2.1);
  readonly #motion: Motion;
  readonly #poinsot: Poinsot | null;
  readonly #cones: Cones | null;
  readonly #sphere: MomentumSphere | null;
  readonly #omega: Arrow;
  readonly #momentum: Arrow;
  readonly #torque: Arrow;
  readonly #axes: Axes;
  readonly #heavy: HeavyBody | null;
  readonly #wheels: Wheels | null;
  readonly #trails = new Map<Trailed, Trail>();
  readonly #trailGroup = new Group();
  readonly #scales: { omega: number; momentum: number; torque: number };
  readonly #principal: Quaternion;
  /** A place in the body, where it is in space. */
  readonly #turned = (p: Vector3): Vector3 => p.clone().applyQuaternion(this.#bodyFrame.quaternion);
  readonly #contents = new Contents();
  /** Pictures with the layers that are on in them at first. */
  readonly #first: Set<string>;
  #time: number;
  #size = { width: 1, height: 1 };
  #waiting = false;

  /** Throws if the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement, overlay: HTMLElement, page: PageData, motion: Motion) {
    this.#canvas = canvas;
    this.#motion = motion;
    this.#time = motion.times[0];
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    // Asking for errors waits for the compiler, a large part of the time to the first frame.
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.orbit = new OrbitCamera(canvas, () => this.invalidate());
    this.labels = new Labels(overlay);
    this.model = new BodyModel(page.body, this.#palette);
    const [w, x, y, z] = page.body.principal.quaternion;
    this.#principal = new Quaternion(x, y, z, w).normalize();
    this.#scales = {
      omega: scale(motion.telling, lengths(motion.omega)),
      momentum: scale(motion.telling, lengths(motion.momentum), ...motion.wheels.map(({ momentum }) => momentum)),
      torque: motion.torque === null ? 0 : scale(motion.telling, lengths(motion.torque)),
    };
    this.trailed = telling(page, motion);

    const free = page.free !== null && page.free.energy > 0 && page.free.momentum > 0 ? page.free : null;
    this.#poinsot = free && new Poinsot(free, page.body, motion, this.#palette);
    this.#cones = free && new Cones(free, motion, this.#palette);
    this.#sphere = free && new MomentumSphere(free, page.body, this.#palette);
    this.#axes = new Axes(this.#principal, AXES, 0.92 * LONGEST, this.#palette);
    this.#heavy = HeavyBody.of(page, motion, this.model.radius, AXES, this.#palette);
    this.#wheels = motion.wheels.length > 0 ? new Wheels(motion, this.#scales.momentum, this.#palette) : null;
    this.pictures = free ? ["body", "poinsot", "cones", "sphere"] : ["body"];

    this.#omega = new Arrow("omega", THICK, this.#palette);
    this.#momentum = new Arrow("ink", THICK, this.#palette);
    this.#torque = new Arrow("torque", THICK, this.#palette);
    this.#build(page, motion);
    this.#first = new Set(this.layers.flatMap(({ id, on }) => this.pictures.filter((p) => on[p]).map((p) => `${p} ${id}`)));
    this.show("body");
  }

  /** Draws `time` in the next frame. */
  set time(time: number) {
    this.#time = time;
    this.invalidate();
  }

  show(picture: Picture): void {
    this.picture = picture;
    this.rides = picture === "sphere" ? "body" : "space";
    apply(this.layers, picture);
    const orbit = this.orbit;
    orbit.homeHeight = { body: 0.36, poinsot: 0.5, cones: 0.45, sphere: 0.4 }[picture];
    orbit.homeAzimuth = 0.62;
    const middle = this.#sphere?.middle;
    if (picture === "sphere" && middle) {
      // This motion's curve is in front.
      orbit.homeHeight = middle.z > 0.3 ? 0.6 : middle.z < -0.3 ? -0.6 : 0.4;
      if (Math.hypot(middle.x, middle.y) > 0.3) orbit.homeAzimuth = Math.atan2(middle.y, middle.x) + 0.5;
    }
    orbit.home();
  }

  toggle(layer: Layer): void {
    layer.on[this.picture] = !layer.on[this.picture];
    apply(this.layers, this.picture);
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
    this.draw(this.#renderer, this.labels, this.#time, this.#size.width, this.#size.height);
  }

  /** A frame of `time`, of so many pixels of the page: on the screen, or for a file with a renderer and names of its own. */
  draw(renderer: WebGLRenderer, labels: Labels, time: number, width: number, height: number): void {
    this.orbit.content = this.#content();
    this.#pose(time);
    this.#aim();
    this.orbit.place(width, height);
    this.#lamp.position.copy(this.orbit.camera.position).addScaledVector(this.orbit.camera.up, 0.25 * this.orbit.distance);
    renderer.render(this.#scene, this.orbit.camera);
    labels.draw(this.#names(this.#isOn, time), this.#outline(this.#isOn), this.orbit.camera, width, height);
  }

  /** (w, x, y, z) of the body as the scene has it at `time`. */
  attitudeAt(time: number): Attitude {
    this.#pose(time);
    this.#bodyFrame.updateMatrixWorld(true);
    const q = this.#bodyFrame.getWorldQuaternion(new Quaternion());
    this.#pose(this.#time);
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

  #build(page: PageData, motion: Motion): void {
    const palette = this.#palette;
    this.#scene.add(this.#bodyFrame, new HemisphereLight(0xffffff, 0x8a8f98, 1.5), this.#lamp);
    this.#bodyFrame.add(this.model.shapes, this.model.ellipsoid);
    const hasShapes = this.model.hasShapes;
    this.layers.push({
      id: "body",
      label: hasShapes ? "Body" : "Equimomental ellipsoid",
      ink: null,
      look: "area",
      on: { body: true, poinsot: false, cones: false },
      objects: [hasShapes ? this.model.shapes : this.model.ellipsoid],
    });
    if (hasShapes) {
      this.layers.push({
        id: "ellipsoid",
        label: "Equimomental ellipsoid",
        ink: null,
        look: "area",
        on: { body: false },
        objects: [this.model.ellipsoid],
      });
    }
    this.#scene.add(this.#omega.object, this.#momentum.object, this.#torque.object);
    const all = { body: true, poinsot: true, cones: true };
    this.layers.push(
      { id: "omega", label: "ω", ink: "omega", look: "arrow", on: { ...all }, objects: [this.#omega.object] },
      { id: "momentum", label: "L", ink: "ink", look: "arrow", on: { ...all, sphere: true }, objects: [this.#momentum.object] },
    );
    if (motion.torque) {
      this.layers.push({ id: "torque", label: "Torque N", ink: "torque", look: "arrow", on: { body: true }, objects: [this.#torque.object] });
    } else {
      this.#torque.object.visible = false;
    }
    this.#scene.add(this.#axes.space, this.#trailGroup);
    this.#bodyFrame.add(this.#axes.body, this.#axes.principal);
    this.layers.push(...this.#axes.layers);
    this.layers.push({ id: "trail", label: "Trail", ink: null, look: "line", on: { body: true }, objects: [this.#trailGroup] });
    if (page.body.about === "pivot") {
      const { object } = new Marker("ink", 0.03, false, palette);
      this.#scene.add(object);
      this.layers.push({ id: "pivot", label: "Pivot", ink: "ink", look: "area", on: { body: true }, objects: [object] });
    }
    if (this.#heavy) {
      this.#scene.add(...this.#heavy.objects);
      this.layers.push(...this.#heavy.layers);
    }
    if (this.#wheels) {
      this.#bodyFrame.add(this.#wheels.rings, this.#wheels.arrows);
      this.layers.push(...this.#wheels.layers);
      this.model.seeThrough();
    }
    this.#buildFree();
  }

  #buildFree(): void {
    if (!this.#poinsot || !this.#cones || !this.#sphere) return;
    const [p, c, s] = [this.#poinsot, this.#cones, this.#sphere];
    this.#bodyFrame.add(p.ellipsoid, p.polhode, c.body, s.object);
    this.#scene.add(p.plane, p.herpolhode, c.space, p.contact);
    this.layers.push(
      { id: "inertia", label: "Inertia ellipsoid", ink: null, look: "area", on: { poinsot: true }, objects: [p.ellipsoid] },
      { id: "plane", label: "Invariable plane", ink: "faint", look: "area", on: { poinsot: true }, objects: [p.plane] },
      { id: "contact", label: "Point of contact", ink: "omega", look: "area", on: { poinsot: true }, objects: [p.contact] },
      { id: "polhode", label: "Polhode", ink: "omega", look: "line", on: { poinsot: true }, objects: [p.polhode] },
      { id: "herpolhode", label: "Herpolhode", ink: "torque", look: "line", on: { poinsot: true }, objects: [p.herpolhode] },
      { id: "body-cone", label: "Body cone", ink: "axis-1", look: "area", on: { cones: true }, objects: [c.body] },
      { id: "space-cone", label: "Space cone", ink: "torque", look: "area", on: { cones: true }, objects: [c.space] },
      { id: "sphere", label: "Momentum sphere", ink: null, look: "area", on: { sphere: true }, objects: [s.object] },
      { id: "family", label: "Other motions", ink: "contour", look: "line", on: { sphere: true }, objects: [s.family] },
      // A symmetric body has none.
      { id: "separatrix", label: "Separatrix", ink: "ink", look: "line", on: s.separatrix.children.length > 0 ? { sphere: true } : {}, objects: [s.separatrix] },
      { id: "trace", label: "This motion", ink: "omega", look: "line", on: { sphere: true }, objects: [s.trace] },
      { id: "mark", label: "L now", ink: "ink", look: "area", on: { sphere: true }, objects: [s.mark] },
    );
  }

  #pose(time: number): void {
    const now = this.#motion.at(time);
    this.#turn(now, time);
    if (this.picture === "body") this.#drawTrail(now, time);
    if (this.picture === "cones") this.#cones?.draw(time);
    if (this.picture === "sphere") this.#sphere?.draw(rotate(inverse(now.attitude), now.momentum));
  }

  // The body and the arrows.
  #turn(now: Moment, time: number): void {
    const [w, x, y, z] = now.attitude;
    this.#bodyFrame.quaternion.set(x, y, z, w);
    const rolling = this.picture === "poinsot" ? this.#poinsot : this.picture === "cones" ? this.#cones : null;
    const omegaScale = rolling?.scale ?? this.#scales.omega;
    const omega = rotate(now.attitude, now.omega).map((c) => c * omegaScale) as Vector;
    this.#omega.point(...omega);
    this.#poinsot?.contact.position.set(...omega);
    // Beside the body's picture only the direction of L has a meaning.
    const shown = this.picture === "poinsot" ? (this.#poinsot?.arrow ?? 1) : 1.25;
    const long = this.picture === "body" ? this.#scales.momentum : shown / length(now.momentum);
    this.#momentum.point(...(now.momentum.map((c) => c * long) as Vector));
    if (now.torque) this.#torque.point(...(now.torque.map((c) => c * this.#scales.torque) as Vector));
    this.#heavy?.pose(now.attitude);
    this.#wheels?.pose(time);
  }

  #drawTrail(now: Moment, time: number): void {
    let trail = this.#trails.get(this.trailed);
    if (!trail) {
      trail = new Trail(this.#motion, this.trailed, this.#scales.omega, AXES, this.#palette);
      this.#trails.set(this.trailed, trail);
      this.#trailGroup.add(trail.object);
    }
    for (const [what, other] of this.#trails) other.object.visible = what === this.trailed;
    const [v, long] = this.trailed === "omega" ? [now.omega, this.#scales.omega] : [axis(this.trailed), AXES];
    trail.draw(time, rotate(now.attitude, v).map((c) => c * long) as Vector);
  }

  // In Poinsot's picture and the cones' the invariable plane is level: up is L.
  #aim(): void {
    const frame = this.orbit.frame.identity();
    const level = this.picture === "poinsot" || this.picture === "cones";
    if (this.rides === "body") {
      frame.copy(this.#bodyFrame.quaternion);
      if (this.picture !== "body") frame.multiply(this.#principal);
    } else if (level && this.#poinsot) {
      frame.setFromUnitVectors(new Vector3(0, 0, 1), this.#poinsot.up);
    }
  }

  // Of what is on or was at first: switching off does not move the camera.
  #content(): Vector3[] {
    const seen = (id: string): boolean => this.#isOn(id) || this.#first.has(`${this.picture} ${id}`);
    const shown = this.layers.filter(({ id }) => seen(id)).map(({ id }) => id);
    return this.#contents.of([this.picture, this.rides, ...shown].join(), this.#motion, (now, time) => {
      this.#turn(now, time);
      this.#aim();
      const named = this.#names(seen, time).flatMap(({ tip, along }) => along ?? [tip]);
      const outline = this.picture === "sphere" ? directions(100) : this.#outline(seen);
      const back = this.orbit.frame.clone().invert();
      return [...named, ...outline, ...(this.#heavy?.floor(seen) ?? [])].map((p) => p.clone().applyQuaternion(back));
    });
  }

  readonly #isOn = (id: string): boolean => this.layers.find((layer) => layer.id === id)?.on[this.picture] === true;

  #names(on: (id: string) => boolean, time: number): Label[] {
    const turned = this.#turned;
    const labels: Label[] = [];
    if (on("omega") && this.#omega.drawn) labels.push({ text: "𝛚", ink: "omega", tip: this.#omega.tip });
    if (on("momentum") && this.#momentum.drawn) labels.push({ text: "𝐋", ink: "ink", tip: this.#momentum.tip });
    if (on("torque") && this.#torque.drawn) labels.push({ text: "𝐍", ink: "torque", tip: this.#torque.tip });
    labels.push(...this.#axes.labels(on, turned));
    if (this.picture === "body") {
      labels.push(...(this.#wheels?.labels(on, time, turned) ?? []), ...(this.#heavy?.labels(on) ?? []));
    }
    if (this.picture === "poinsot") labels.push(...(this.#poinsot?.labels(on, turned) ?? []));
    if (this.picture === "cones") labels.push(...(this.#cones?.labels(on, turned) ?? []));
    if (this.picture === "sphere") labels.push(...(this.#sphere?.labels(on, turned, this.orbit.camera.position) ?? []));
    // Arrows first: other names go where there is room.
    return [...labels.filter(({ along }) => !along), ...labels.filter(({ along }) => along)];
  }

  #outline(on: (id: string) => boolean): Vector3[] {
    const turned = (points: Vector3[]): Vector3[] => points.map(this.#turned);
    if (this.picture === "poinsot" && this.#poinsot) return turned(this.#poinsot.outline);
    if (this.picture === "cones" && this.#cones) return turned(this.#cones.outline);
    if (this.picture === "sphere") return round(this.orbit.camera.position);
    return turned(on("ellipsoid") ? [...this.model.outline, ...this.model.ellipsoidOutline] : this.model.outline);
  }
}

/** Of the first `telling` samples the longest arrow is LONGEST. */
function scale(telling: number, ...rows: Float64Array[]): number {
  const most = Math.max(...rows.map((values) => values.subarray(0, telling).reduce((a, b) => Math.max(a, Math.abs(b)), 0)));
  return most > 0 ? LONGEST / most : 0;
}

/** The body axis whose trail tells most: the lever's, the symmetry axis, else the one that is nearest to ω at the start. */
function telling(page: PageData, motion: Motion): Trailed {
  const { lever, principal } = page.body;
  const [i1, i2, i3] = principal.moments;
  const like = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6 * i3;
  let v: Vector = [motion.omega[0], motion.omega[1], motion.omega[2]];
  if (length(lever) > 0) v = lever;
  else if (like(i1, i2) && !like(i2, i3)) v = rotate(principal.quaternion, [0, 0, 1]);
  else if (like(i2, i3) && !like(i1, i2)) v = rotate(principal.quaternion, [1, 0, 0]);
  const sizes = v.map(Math.abs);
  return (["axis-1", "axis-2", "axis-3"] as const)[sizes.indexOf(Math.max(...sizes))] ?? "axis-1";
}

// The rim of the unit sphere as a camera sees it.
function round(eye: Vector3): Vector3[] {
  const n = eye.clone().normalize();
  const a = new Vector3(-n.y, n.x, 0).normalize();
  const b = n.clone().cross(a);
  const k = 1.04;
  return Array.from({ length: 32 }, (_, i) => {
    const t = (i / 32) * 2 * Math.PI;
    return a.clone().multiplyScalar(k * Math.cos(t)).addScaledVector(b, k * Math.sin(t));
  });
}
