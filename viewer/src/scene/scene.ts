/**
 * The 3-D view. Space axes are three's own, with z up; the group `bodyFrame` has the body's attitude, and everything that turns with the
 * body is in it. A frame is drawn only if something changed.
 */
import {
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { rotate, type Quaternion as Attitude, type Vector } from "../attitude";
import type { PageData } from "../data";
import { length, lengths, type Moment, type Motion } from "../motion";
import { Arrow } from "./arrows";
import { BodyModel } from "./body";
import { OrbitCamera } from "./camera";
import { Cones } from "./cones";
import { type Label, Labels } from "./labels";
import { apply, type Layer, type Picture } from "./layers";
import { Palette } from "./palette";
import { Poinsot } from "./poinsot";
import { MomentumSphere } from "./sphere";
import { axis, Trail, type Trailed } from "./trails";

/** The longest arrow of the body's picture, where the body's radius is 1. */
const LONGEST = 1.5;
const AXES = 1.3;
const THIN = 0.011;
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
  readonly #axes: { layer: string; arrow: Arrow; text: string; tip: Vector3; turns: boolean; ink: Label["ink"] }[] = [];
  readonly #trails = new Map<Trailed, Trail>();
  /** Where the ellipsoid touches the plane. */
  readonly #contact = new Group();
  readonly #trailGroup = new Group();
  readonly #scales: { omega: number; momentum: number; torque: number };
  readonly #principal: Quaternion;
  /** What the body's picture is centred on: half way to where a held body's centre of mass is on the whole. */
  readonly #middle: Vector3;
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
      omega: scale(lengths(motion.omega)),
      momentum: scale(lengths(motion.momentum)),
      torque: motion.torque === null ? 0 : scale(lengths(motion.torque)),
    };
    this.trailed = telling(page, motion);
    this.#middle = meanPlace(page.body.lever, motion).multiplyScalar(0.5 / this.model.radius);

    const free = page.free !== null && page.free.energy > 0 && page.free.momentum > 0 ? page.free : null;
    this.#poinsot = free && new Poinsot(free, page.body, motion, this.#palette);
    this.#cones = free && new Cones(free, motion, this.#palette);
    this.#sphere = free && new MomentumSphere(free, page.body, this.#palette);
    this.pictures = free ? ["body", "poinsot", "cones", "sphere"] : ["body"];

    this.#omega = new Arrow("omega", THICK, this.#palette);
    this.#momentum = new Arrow("ink", THICK, this.#palette);
    this.#torque = new Arrow("torque", THICK, this.#palette);
    this.#build(page, motion);
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
    orbit.radius = {
      body: 1.62,
      poinsot: 1.08 * (this.#poinsot?.radius ?? 1),
      cones: 1.14 * (this.#cones?.radius ?? 1),
      sphere: 1.5,
    }[picture];
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
    this.#pose(this.#time);
    const { width, height } = this.#size;
    this.#aim();
    this.orbit.place(width, height);
    this.#lamp.position.copy(this.orbit.camera.position).add(this.orbit.camera.up.clone().multiplyScalar(this.orbit.radius));
    this.#renderer.render(this.#scene, this.orbit.camera);
    this.labels.draw(this.#visibleLabels(), this.#outline(), this.orbit.camera, width, height);
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
    if (!pen) return out;
    pen.fillStyle = this.#palette.value("paper");
    pen.fillRect(0, 0, out.width, out.height);
    pen.drawImage(this.#canvas, 0, 0);
    pen.scale(out.width / this.#size.width, out.height / this.#size.height);
    pen.font = "600 15px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (const label of this.labels.placed) {
      pen.fillStyle = this.#palette.value(label.ink);
      pen.strokeStyle = this.#palette.value(label.ink);
      if (label.led) {
        pen.globalAlpha = 0.6;
        pen.beginPath();
        pen.moveTo(label.tipX, label.tipY);
        const short = 1 - 11 / Math.hypot(label.x - label.tipX, label.y - label.tipY);
        pen.lineTo(label.tipX + short * (label.x - label.tipX), label.tipY + short * (label.y - label.tipY));
        pen.stroke();
        pen.globalAlpha = 1;
      }
      pen.fillText(label.text, label.x, label.y);
    }
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
      { id: "momentum", label: "L", ink: "ink", look: "arrow", on: { ...all }, objects: [this.#momentum.object] },
    );
    if (motion.torque) {
      this.layers.push({ id: "torque", label: "Torque N", ink: "torque", look: "arrow", on: { body: true }, objects: [this.#torque.object] });
    } else {
      this.#torque.object.visible = false;
    }
    this.#buildAxes();
    this.#scene.add(this.#trailGroup);
    this.layers.push({ id: "trail", label: "Trail", ink: null, look: "line", on: { body: true }, objects: [this.#trailGroup] });
    if (page.body.about === "pivot") {
      const pivot = new MeshStandardMaterial({ roughness: 0.5 });
      palette.bind(pivot.color, "ink");
      const ball = new Mesh(new SphereGeometry(0.03, 24, 16), pivot);
      this.#scene.add(ball);
      this.layers.push({ id: "pivot", label: "Pivot", ink: "ink", look: "area", on: { body: true }, objects: [ball] });
    }
    this.#buildFree();
  }

  #buildAxes(): void {
    const kinds = [
      { layer: "space-axes", label: "Space axes X Y Z", names: ["X", "Y", "Z"], reach: LONGEST * 0.92, width: 0.006 },
      { layer: "body-axes", label: "Body axes x y z", names: ["x", "y", "z"], reach: AXES, width: THIN },
      { layer: "principal-axes", label: "Principal axes 1 2 3", names: ["1", "2", "3"], reach: AXES * 1.06, width: THIN },
    ];
    for (const [kind, { layer, label, names, reach, width }] of kinds.entries()) {
      const group = new Group();
      names.forEach((text, k) => {
        const tip = new Vector3(...axis((["axis-1", "axis-2", "axis-3"] as const)[k])).multiplyScalar(reach);
        if (kind === 2) tip.applyQuaternion(this.#principal);
        const ink: Label["ink"] = kind === 0 ? "faint" : (["axis-1", "axis-2", "axis-3"] as const)[k];
        const arrow = new Arrow(ink, width, this.#palette);
        arrow.point(tip.x, tip.y, tip.z);
        group.add(arrow.object);
        this.#axes.push({ layer, arrow, text, tip, turns: kind > 0, ink: kind === 0 ? "quiet" : ink });
      });
      (kind === 0 ? this.#scene : this.#bodyFrame).add(group);
      const on: Layer["on"] =
        kind === 0
          ? { body: true, poinsot: false, cones: false }
          : kind === 1
            ? { body: true, poinsot: false, cones: false, sphere: false }
            : { body: false, poinsot: false, cones: false, sphere: true };
      this.layers.push({ id: layer, label, ink: kind === 0 ? "faint" : "axis-1", look: "arrow", on, objects: [group] });
    }
  }

  #buildFree(): void {
    if (!this.#poinsot || !this.#cones || !this.#sphere) return;
    const [p, c, s] = [this.#poinsot, this.#cones, this.#sphere];
    this.#bodyFrame.add(p.ellipsoid, p.polhode, c.body, s.object);
    const dot = new MeshStandardMaterial({ roughness: 0.4 });
    this.#palette.bind(dot.color, "omega");
    this.#contact.add(new Mesh(new SphereGeometry(0.032, 24, 16), dot));
    this.#scene.add(p.plane, p.herpolhode, c.space, this.#contact);
    this.layers.push(
      { id: "inertia", label: "Inertia ellipsoid", ink: null, look: "area", on: { poinsot: true }, objects: [p.ellipsoid] },
      { id: "plane", label: "Invariable plane", ink: "faint", look: "area", on: { poinsot: true }, objects: [p.plane, this.#contact] },
      { id: "polhode", label: "Polhode", ink: "omega", look: "line", on: { poinsot: true }, objects: [p.polhode] },
      { id: "herpolhode", label: "Herpolhode", ink: "torque", look: "line", on: { poinsot: true }, objects: [p.herpolhode] },
      { id: "body-cone", label: "Body cone", ink: "axis-1", look: "area", on: { cones: true }, objects: [c.body] },
      { id: "space-cone", label: "Space cone", ink: "torque", look: "area", on: { cones: true }, objects: [c.space] },
      { id: "sphere", label: "Momentum sphere", ink: null, look: "area", on: { sphere: true }, objects: [s.object] },
      { id: "family", label: "Other motions", ink: "contour", look: "line", on: { sphere: true }, objects: [s.family] },
      { id: "separatrix", label: "Separatrix", ink: "ink", look: "line", on: { sphere: true }, objects: [s.separatrix] },
      { id: "trace", label: "This motion", ink: "omega", look: "line", on: { sphere: true }, objects: [s.trace] },
    );
  }

  #pose(time: number): void {
    const now = this.#motion.at(time);
    const [w, x, y, z] = now.attitude;
    this.#bodyFrame.quaternion.set(x, y, z, w);
    const rolling = this.picture === "poinsot" ? this.#poinsot : this.picture === "cones" ? this.#cones : null;
    const omegaScale = rolling?.scale ?? this.#scales.omega;
    const omega = rotate(now.attitude, now.omega).map((c) => c * omegaScale) as Vector;
    this.#omega.point(...omega);
    this.#contact.position.set(...omega);
    // In the rolling pictures only the direction of L has a meaning.
    const shown = this.picture === "poinsot" ? (this.#poinsot?.arrow ?? 1) : 1.25;
    const long = rolling ? shown / length(now.momentum) : this.#scales.momentum;
    this.#momentum.point(...(now.momentum.map((c) => c * long) as Vector));
    if (now.torque) this.#torque.point(...(rotate(now.attitude, now.torque).map((c) => c * this.#scales.torque) as Vector));
    if (this.picture === "body") this.#drawTrail(now, omega);
    if (this.picture === "cones") this.#cones?.draw(time);
    if (this.picture === "sphere") this.#sphere?.draw(rotate(inverse(now.attitude), now.momentum));
  }

  #drawTrail(now: Moment, omega: Vector): void {
    let trail = this.#trails.get(this.trailed);
    if (!trail) {
      trail = new Trail(this.#motion, this.trailed, this.#scales.omega, AXES, this.#palette);
      this.#trails.set(this.trailed, trail);
      this.#trailGroup.add(trail.object);
    }
    for (const [what, other] of this.#trails) other.object.visible = what === this.trailed;
    const tip =
      this.trailed === "omega" ? omega : (rotate(now.attitude, axis(this.trailed)).map((c) => c * AXES) as Vector);
    trail.draw(this.#time, tip);
  }

  // In Poinsot's picture and the cones' the invariable plane is level: up is L.
  #aim(): void {
    const frame = this.orbit.frame.identity();
    this.orbit.target.set(0, 0, 0);
    if (this.picture === "body") this.orbit.target.copy(this.#middle);
    const level = this.picture === "poinsot" || this.picture === "cones";
    if (this.rides === "body") {
      this.orbit.target.set(0, 0, 0);
      frame.copy(this.#bodyFrame.quaternion);
      if (this.picture !== "body") frame.multiply(this.#principal);
    } else if (level && this.#poinsot) {
      frame.setFromUnitVectors(new Vector3(0, 0, 1), this.#poinsot.up);
      this.orbit.target.copy((this.picture === "poinsot" ? this.#poinsot : this.#cones)?.middle ?? new Vector3());
    }
  }

  #visibleLabels(): Label[] {
    const on = (id: string): boolean => this.layers.find((layer) => layer.id === id)?.on[this.picture] === true;
    const labels: Label[] = [];
    if (on("omega") && this.#omega.drawn) labels.push({ text: "ω", ink: "omega", tip: this.#omega.tip });
    if (on("momentum") && this.#momentum.drawn) labels.push({ text: "L", ink: "ink", tip: this.#momentum.tip });
    if (on("torque") && this.#torque.drawn) labels.push({ text: "N", ink: "torque", tip: this.#torque.tip });
    for (const { layer, text, tip, turns, ink } of this.#axes) {
      if (!on(layer)) continue;
      labels.push({ text, ink, tip: turns ? tip.clone().applyQuaternion(this.#bodyFrame.quaternion) : tip });
    }
    return labels;
  }

  #outline(): Vector3[] {
    const turned = (points: Vector3[]): Vector3[] => points.map((p) => p.clone().applyQuaternion(this.#bodyFrame.quaternion));
    if (this.picture === "poinsot" && this.#poinsot) return turned(this.#poinsot.outline);
    if (this.picture === "cones" && this.#cones) return turned(this.#cones.outline);
    if (this.picture === "sphere") return round(this.orbit.camera.position);
    const ellipsoid = this.layers.find((layer) => layer.id === "ellipsoid")?.on.body === true;
    return turned(ellipsoid ? [...this.model.outline, ...this.model.ellipsoidOutline] : this.model.outline);
  }
}

function scale(values: Float64Array): number {
  const most = values.reduce((a, b) => Math.max(a, b), 0);
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

function meanPlace(lever: Vector, motion: Motion): Vector3 {
  const sum = new Vector3();
  if (length(lever) === 0) return sum;
  for (let i = 0; i < motion.count; i += 1) sum.add(new Vector3(...rotate(motion.attitudeOf(i), lever)));
  return sum.divideScalar(motion.count);
}

function inverse([w, x, y, z]: Attitude): Attitude {
  return [w, -x, -y, -z];
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
