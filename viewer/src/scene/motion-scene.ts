/**
 * Contents of the 3-D view for one motion: the body, arrows, axes, and the pictures of a free
 * motion, which are made when they are first shown. Space axes are those of three.js, with z up.
 * The group `body` has the attitude and position of the body and contains everything that rotates
 * with it. A body that turns in place is at the origin.
 */
import { Group, type Object3D, Quaternion, Vector3 } from "three";
import { inverse, type Quaternion as Attitude, rotate, type Vector } from "../attitude";
import type { FreeData, PageData } from "../data";
import { length, lengths, type Moment, type Motion } from "../motion";
import { Arrow } from "./arrows";
import { Axes } from "./axes";
import { BodyModel } from "./body";
import { Cones } from "./cones";
import { ContactScene } from "./contact-scene";
import { dispose } from "./dispose";
import { corners, equivalentBox } from "./equivalent-box";
import { Contents, directions, type Seen } from "./framing";
import type { Label } from "./labels";
import type { Layer, Picture } from "./layers";
import { Marker } from "./marker";
import { Orbit } from "./orbit";
import type { Palette } from "./palette";
import { Poinsot } from "./poinsot";
import { Sky } from "./sky";
import { MomentumSphere, rim } from "./sphere";
import { HeavyBody } from "./top";
import { axis, telling, Trail, type TrailCurves, type Trailed } from "./trails";
import { Wheels } from "./wheels";

/** Length of the longest arrow in the body's picture, relative to the body's radius. */
const LONGEST = 1.5;
/** Range of the longest arrow within which arrows keep their scale. */
const KEPT = [0.35 * LONGEST, 1.7 * LONGEST] as const;
const AXES = 1.3;
/** Maximum number of places of a label that are examined at every time. */
const FEW = 20;
const THICK = 0.019;

interface Scales {
  omega: number;
  momentum: number;
  torque: number;
}

export class MotionScene {
  readonly space = new Group();
  readonly body = new Group();
  /** Arrows that begin at the centre of the body. */
  readonly #carried = new Group();
  readonly layers: Layer[] = [];
  readonly model: BodyModel;
  readonly pictures: Picture[];
  readonly principal: Quaternion;
  /** The most informative trail. */
  readonly telling: Trailed;
  readonly omega: Arrow;
  /** Length of a unit of each arrow in the body's picture. */
  readonly scales: Scales;
  poinsot: Poinsot | null = null;
  cones: Cones | null = null;
  sphere: MomentumSphere | null = null;

  readonly #page: PageData;
  readonly #motion: Motion;
  readonly #palette: Palette;
  readonly #free: FreeData | null;
  readonly #momentum: Arrow;
  readonly #torque: Arrow;
  readonly #axes: Axes;
  readonly #heavy: HeavyBody | null;
  readonly #contact: ContactScene | null;
  readonly #wheels: Wheels | null;
  readonly #sky: Sky | null;
  readonly #orbit: Orbit | null;
  readonly #contents: Contents;
  /** Pairs of a picture and a layer that is on in it at first. */
  readonly #first: Set<string>;
  readonly #trails = new Map<Trailed, Trail>();
  readonly #trailGroup: Group;
  /** Converts a place in the body to space. */
  readonly #turned = (p: Vector3): Vector3 => p.clone().applyQuaternion(this.body.quaternion).add(this.body.position);

  /**
   * `before` is the previous scene. Its switches are kept, and its scales and frames if they fit,
   * or always if `isHeld`.
   */
  constructor(page: PageData, motion: Motion, trail: Group, palette: Palette, before: MotionScene | null, isHeld = false) {
    this.#page = page;
    this.#motion = motion;
    this.#palette = palette;
    this.#trailGroup = trail;
    this.model = new BodyModel(page.body, motion.wheels.length > 0, palette, before?.model ?? null);
    const [w, x, y, z] = page.body.principal.quaternion;
    this.principal = new Quaternion(x, y, z, w).normalize();
    this.scales = {
      omega: isHeld && before ? before.scales.omega : scale(before?.scales.omega, motion.telling, lengths(motion.omega)),
      momentum: scale(before?.scales.momentum, motion.telling, lengths(motion.momentum), ...motion.wheels.map(({ momentum }) => momentum)),
      torque: motion.torque === null ? 0 : scale(before?.scales.torque, motion.telling, lengths(motion.torque)),
    };
    this.telling = telling(page, motion);
    this.#free = page.free !== null && page.free.energy > 0 && page.free.momentum > 0 ? page.free : null;
    this.pictures = this.#free ? ["body", "poinsot", "cones", "sphere"] : ["body"];
    this.#axes = new Axes(this.principal, AXES, 0.92 * LONGEST, palette);
    this.#heavy = HeavyBody.of(page, motion, this.model, AXES, palette);
    this.#contact = motion.contact && new ContactScene(motion.contact, motion, this.model.radius, this.model.outline, palette);
    this.#wheels = motion.wheels.length > 0 ? new Wheels(motion, this.scales.momentum, palette) : null;
    this.#sky = Sky.of(motion, palette);
    this.#orbit = Orbit.of(page.scene.orbit, motion, palette);
    this.omega = new Arrow("omega", THICK, palette);
    this.#momentum = new Arrow("ink", THICK, palette);
    this.#torque = new Arrow("torque", THICK, palette);
    this.#build();
    this.#contents = new Contents(before && before.#contents, isHeld);
    this.#first = new Set(this.layers.flatMap(({ id, on }) => this.pictures.filter((p) => on[p]).map((p) => `${p} ${id}`)));
    for (const layer of this.layers) {
      const was = before?.layers.find(({ id }) => id === layer.id);
      for (const picture of Object.keys(layer.on) as Picture[]) layer.on[picture] = was?.on[picture] ?? layer.on[picture] === true;
    }
  }

  /** Releases GPU memory, except for objects that a later scene took over. */
  dispose(): void {
    for (const part of [this.space, this.body, ...(this.#orbit ? [this.#orbit.root] : [])]) dispose(part, this.#palette);
  }

  /** Makes the contents of a picture. */
  open(picture: Picture): void {
    if (!this.#free) return;
    if (picture === "poinsot" && !this.poinsot) {
      const p = new Poinsot(this.#free, this.#page.body, this.#motion, this.#palette);
      this.poinsot = p;
      this.#fill({ inertia: p.ellipsoid, polhode: p.polhode }, this.body);
      this.#fill({ plane: p.plane, contact: p.contact, herpolhode: p.herpolhode }, this.space);
    }
    if (picture === "cones" && !this.cones) {
      const c = new Cones(this.#free, this.#motion, this.#palette);
      this.cones = c;
      this.#fill({ "body-cone": c.body }, this.body);
      this.#fill({ "space-cone": c.space }, this.space);
    }
    if (picture === "sphere" && !this.sphere) {
      const s = new MomentumSphere(this.#free, this.#page.body, this.#palette);
      this.sphere = s;
      this.#fill({ sphere: s.object }, this.body);
      for (const [id, object] of Object.entries({ family: s.family, separatrix: s.separatrix, trace: s.trace, mark: s.mark })) {
        this.layers.find((layer) => layer.id === id)?.objects.push(object);
      }
    }
  }

  /** The orbit, if it is shown. */
  get orbit(): Orbit | null {
    return this.#orbit?.object.visible ? this.#orbit : null;
  }

  /** Updates the scene to `time`, or to a given attitude. */
  pose(time: number, picture: Picture, trailed: Trailed, trails: TrailCurves, held: Attitude | null): void {
    const now = this.#motion.at(time);
    if (held) now.attitude = held;
    this.#turn(now, time, picture);
    this.#contact?.pose(now, time, this.#turned);
    if (picture === "body") this.#drawTrail(time, now, trailed, trails);
    if (picture === "cones") this.cones?.draw(time);
    if (picture === "sphere") this.sphere?.draw(rotate(inverse(now.attitude), now.momentum));
  }

  /** Position of the body. */
  get middle(): Vector3 {
    return this.body.position;
  }

  /**
   * Sets the frame of the camera's position. In Poinsot's picture and that of the cones, the
   * invariable plane is horizontal, with L upward.
   */
  aim(picture: Picture, rides: "space" | "body", frame: Quaternion): void {
    const level = picture === "poinsot" ? this.poinsot : picture === "cones" ? this.cones : null;
    frame.identity();
    if (rides === "body") {
      frame.copy(this.body.quaternion);
      if (picture !== "body") frame.multiply(this.principal);
    } else if (level) frame.setFromUnitVectors(new Vector3(0, 0, 1), level.up);
  }

  /**
   * Returns the points that the camera must see, in the frame of `aim`. It includes layers that are
   * on now or were at first, so that switching a layer off does not move the camera.
   */
  content(picture: Picture, rides: "space" | "body"): Vector3[] {
    const seen = (id: string): boolean => this.#isOn(id, picture) || this.#first.has(`${picture} ${id}`);
    const shown = this.layers.filter(({ id }) => seen(id)).map(({ id }) => id);
    return this.#contents.of([picture, rides, ...shown].join(), this.#motion, () => this.#seen(new Set(shown), picture, rides));
  }

  #seen(shown: ReadonlySet<string>, picture: Picture, rides: "space" | "body"): Seen {
    const moves = this.#contact !== null;
    // A camera that rotates with the body moves with it, and sees only the ground behind the body.
    const [goesAlong, origin] = [moves && rides === "body", new Vector3()];
    const seen = (id: string): boolean => shown.has(id) && !(goesAlong && id === "space-axes");
    const outline = this.#outline(seen, picture);
    const back = new Quaternion();
    const isSphere = picture === "sphere";
    return {
      at: (now, time, isWhole) => {
        this.#turn(now, time, picture);
        this.aim(picture, rides, back);
        back.invert();
        const named = this.#names(seen, picture, time, null).flatMap(({ tip, along }) => {
          if (!along) return [tip];
          // Curves have many of these.
          return isWhole || along.length <= FEW ? along : [];
        });
        // Tips of arrows are at different places at different times, and so is all of a moving
        // body.
        const moved = moves && isWhole ? outline.map(this.#turned) : [];
        if (goesAlong) origin.copy(this.middle);
        const ground = goesAlong || !seen("ground") ? [] : (this.#contact?.rim ?? []);
        return [...named, ...moved, ...ground, ...(this.#heavy?.floor(seen) ?? [])].map((p) => p.clone().sub(origin).applyQuaternion(back));
      },
      rigid: isSphere ? directions(100) : moves ? [] : outline,
      turn: () => (isSphere ? back.clone() : back.clone().multiply(this.body.quaternion)),
    };
  }

  /** Makes the following frames independent of the previous motion. */
  refit(): void {
    this.#contents.refit();
  }

  // Updates the body and the arrows.
  #turn(now: Moment, time: number, picture: Picture): void {
    const [w, x, y, z] = now.attitude;
    this.body.quaternion.set(x, y, z, w);
    this.body.position.set(...now.center).divideScalar(this.model.radius);
    this.#carried.position.copy(this.body.position);
    const rolling = picture === "poinsot" ? this.poinsot : picture === "cones" ? this.cones : null;
    const omegaScale = rolling?.scale ?? this.scales.omega;
    const omega = rotate(now.attitude, now.omega).map((c) => c * omegaScale) as Vector;
    this.omega.point(...omega);
    this.poinsot?.contact.position.set(...omega);
    // Except in the body's picture, only the direction of L is meaningful.
    const shown = picture === "poinsot" ? (this.poinsot?.arrow ?? 1) : 1.25;
    const long = picture === "body" ? this.scales.momentum : shown / length(now.momentum);
    // Arrows begin on the momentum sphere, not in it.
    const foot = picture === "sphere" ? 1 : 0;
    const [lx, ly, lz] = now.momentum.map((c) => c * long);
    this.#momentum.point(lx, ly, lz, foot);
    this.#axes.begin(foot);
    if (now.torque) this.#torque.point(...(now.torque.map((c) => c * this.scales.torque) as Vector));
    if (picture === "body") {
      this.#heavy?.pose(now.attitude, this.#turned);
      this.#wheels?.pose(time);
      this.#sky?.pose(time);
      this.#orbit?.pose(time);
    }
  }

  #isOn(id: string, picture: Picture): boolean {
    return this.layers.find((layer) => layer.id === id)?.on[picture] === true;
  }

  /** Returns labels of visible layers, optionally only of `ids`. */
  labels(picture: Picture, time: number, eye: Vector3, ids: readonly string[] | null): Label[] {
    return this.#names((id) => (ids?.includes(id) ?? true) && this.#isOn(id, picture), picture, time, eye);
  }

  // Without an eye, labels that depend on its position are omitted.
  #names(on: (id: string) => boolean, picture: Picture, time: number, eye: Vector3 | null): Label[] {
    const turned = this.#turned;
    const labels: Label[] = [];
    const from = (arrow: Arrow): Vector3 => arrow.tip.clone().add(this.middle);
    if (on("omega") && this.omega.drawn) labels.push({ text: "𝛚", ink: "omega", tip: from(this.omega) });
    if (on("momentum") && this.#momentum.drawn) labels.push({ text: "𝐋", ink: "ink", tip: from(this.#momentum) });
    if (on("torque") && this.#torque.drawn) labels.push({ text: "𝐍", ink: "torque", tip: from(this.#torque) });
    labels.push(...this.#axes.labels(on, turned));
    if (picture === "body") labels.push(...(this.#sky?.labels(on, turned) ?? []), ...(this.#wheels?.labels(on, time, turned) ?? []), ...(this.#heavy?.labels(on) ?? []));
    if (picture === "poinsot") labels.push(...(this.poinsot?.labels(on, turned) ?? []));
    if (picture === "cones") labels.push(...(this.cones?.labels(on, turned) ?? []));
    if (picture === "sphere" && eye) labels.push(...(this.sphere?.labels(on, turned, eye) ?? []));
    // Arrows first: other labels get the remaining space.
    return [...labels.filter(({ along }) => !along), ...labels.filter(({ along }) => along)];
  }

  /** Returns points that no label of an arrow may cover. */
  outline(picture: Picture, eye: Vector3): Vector3[] {
    return picture === "sphere" ? rim(eye) : this.#outline((id) => this.#isOn(id, picture), picture).map(this.#turned);
  }

  // Returns the outline in body axes.
  #outline(on: (id: string) => boolean, picture: Picture): Vector3[] {
    if (picture === "poinsot" && this.poinsot) return this.poinsot.outline;
    if (picture === "cones" && this.cones) return this.cones.outline;
    const box = on("box") ? corners(this.#page.body, this.model.radius) : [];
    return [...this.model.outline, ...(on("ellipsoid") ? this.model.ellipsoidOutline : []), ...box];
  }

  #build(): void {
    const hasShapes = this.model.hasShapes;
    const body = hasShapes ? this.model.shapes : this.model.ellipsoid;
    this.body.add(this.model.ellipsoid, this.model.shapes);
    this.#put("body", hasShapes ? "Body" : "Equimomental ellipsoid", null, "area", { body: true, poinsot: false, cones: false }, body);
    if (hasShapes) this.#put("ellipsoid", "Equimomental ellipsoid", null, "area", { body: false }, this.model.ellipsoid);
    const box = equivalentBox(this.#page.body, this.model.radius, this.#palette);
    for (const { objects } of box) this.body.add(...objects);
    this.layers.push(...box);
    this.#carried.add(this.omega.object, this.#momentum.object, this.#torque.object);
    this.space.add(this.#carried);
    const all = { body: true, poinsot: true, cones: true };
    this.#put("omega", "ω", "omega", "arrow", { ...all }, this.omega.object);
    this.#put("momentum", "L", "ink", "arrow", { ...all, sphere: true }, this.#momentum.object);
    if (this.#motion.torque) this.#put("torque", "Torque N", "torque", "arrow", { body: true }, this.#torque.object);
    else this.#torque.object.visible = false;
    this.space.add(this.#axes.space);
    this.body.add(this.#axes.body, this.#axes.principal);
    this.layers.push(...this.#axes.layers);
    if (this.#contact) {
      this.space.add(this.#contact.space);
      this.body.add(this.#contact.body);
      this.layers.push(...this.#contact.layers);
      // At the origin of a bowl there is nothing else.
      const spaceAxes = this.layers.find(({ id }) => id === "space-axes");
      if (spaceAxes && this.#motion.contact?.ground.form !== "plane") spaceAxes.on.body = false;
    }
    // A body on the ground has the curve of its contact point instead.
    this.#put("trail", "Trail", null, "line", { body: this.#contact === null }, this.#trailGroup);
    if (this.#page.body.about === "pivot") {
      const { object } = new Marker("ink", 0.03, false, this.#palette);
      this.space.add(object);
      this.#put("pivot", "Pivot", "ink", "area", { body: true }, object);
    }
    if (this.#heavy) {
      this.space.add(...this.#heavy.objects);
      this.layers.push(...this.#heavy.layers);
    }
    if (this.#wheels) {
      this.body.add(this.#wheels.rings, this.#wheels.arrows);
      this.layers.push(...this.#wheels.layers);
    }
    if (this.#sky) {
      this.space.add(this.#sky.space);
      this.body.add(this.#sky.body);
      this.layers.push(...this.#sky.layers);
      if (this.#orbit) this.#put("orbit", "Orbit", "quiet", "line", { body: true }, this.#orbit.object);
      // A satellite is seen against its directions; the rest is on request.
      const others = ["momentum", "torque", "space-axes", "trail"];
      if (this.#motion.directions.some(({ name }) => name === "nadir")) for (const layer of this.layers) if (others.includes(layer.id)) layer.on.body = false;
    }
    if (this.#free) this.#describe(this.#free);
  }

  // Describes the layers of the pictures before these are made.
  #describe(free: FreeData): void {
    this.#put("inertia", "Inertia ellipsoid", null, "area", { poinsot: true });
    this.#put("plane", "Invariable plane", "faint", "area", { poinsot: true });
    this.#put("contact", "Point of contact", "omega", "area", { poinsot: true });
    this.#put("polhode", "Polhode", "omega", "line", { poinsot: true });
    this.#put("herpolhode", "Herpolhode", "torque", "line", { poinsot: true });
    this.#put("body-cone", "Body cone", "axis-1", "area", { cones: true });
    this.#put("space-cone", "Space cone", "torque", "area", { cones: true });
    this.#put("sphere", "Momentum sphere", null, "area", { sphere: true });
    this.#put("family", "Other motions", "contour", "line", { sphere: true });
    // A symmetric body has no separatrix.
    this.#put("separatrix", "Separatrix", "ink", "line", free.separatrix.some(({ length }) => length > 0) ? { sphere: true } : {});
    this.#put("trace", "This motion", "omega", "line", { sphere: true });
    this.#put("mark", "L now", "ink", "area", { sphere: true });
  }

  #put(id: string, label: string, ink: Layer["ink"], look: Layer["look"], on: Layer["on"], ...objects: Object3D[]): void {
    this.layers.push({ id, label, ink, look, on, objects });
  }

  #fill(made: Record<string, Group>, into: Group): void {
    for (const [id, object] of Object.entries(made)) {
      into.add(object);
      this.layers.find((layer) => layer.id === id)?.objects.push(object);
    }
  }

  #drawTrail(time: number, now: Moment, what: Trailed, curves: TrailCurves): void {
    if (!this.#trailGroup.visible) return;
    const trail = this.#trails.get(what) ?? new Trail(this.#motion, what, this.scales.omega, AXES, this.model.radius);
    this.#trails.set(what, trail);
    const [v, long] = what === "omega" ? [now.omega, this.scales.omega] : [axis(what), AXES];
    curves.draw(trail, time, rotate(now.attitude, v).map((c, k) => c * long + now.center[k] / this.model.radius) as Vector);
  }
}

/**
 * Returns the scale at which the longest arrow of the first `telling` samples has the length
 * LONGEST, or the previous scale if it fits.
 */
function scale(before: number | undefined, telling: number, ...rows: Float64Array[]): number {
  let most = 0;
  for (const values of rows) for (let i = 0; i < telling; i += 1) most = Math.max(most, Math.abs(values[i]));
  if (before && most * before >= KEPT[0] && most * before <= KEPT[1]) return before;
  return most > 0 ? LONGEST / most : 0;
}
