/**
 * Objects of a body on the ground: the ground, the curves of the contact point, and the surface
 * that touches.
 */
import { Group, type Object3D, Vector3 } from "three";
import type { Contact } from "../contact";
import type { Moment, Motion } from "../motion";
import { Solids } from "./body";
import { ContactPath, places } from "./contact-path";
import { Ground } from "./ground";
import type { Layer } from "./layers";
import { Marker } from "./marker";
import type { Ink, Palette } from "./palette";
import { Shadow } from "./shadow";

/** Radius of the mark of the contact point, relative to the body and to the length of its path. */
const MARK = [0.035, 0.004] as const;

export class ContactScene {
  readonly layers: Layer[] = [];
  /** Group fixed in space, and group that rotates with the body. */
  readonly space = new Group();
  readonly body = new Group();
  readonly #ground: Ground;
  readonly #paths: { path: ContactPath; layer: Layer }[] = [];
  readonly #touch: Group;
  readonly #unit: number;
  /** Shadow on a plane; null on other ground. */
  readonly #shadow: Shadow | null;

  /** `unit`: metres of length 1. `outline`: points of the body, in that unit. */
  constructor(contact: Contact, motion: Motion, unit: number, outline: readonly Vector3[], palette: Palette) {
    const start = motion.times[0];
    const until = contact.touchesUntil;
    const at = places(contact, start, unit);
    this.#unit = unit;
    this.#ground = new Ground(contact, motion, unit, palette);
    this.space.add(this.#ground.object);
    const name = this.#ground.label.split(",")[0].toLowerCase();
    const turns = contact.ground.rate !== 0;
    const trace = new Group();
    this.#ground.object.add(trace);
    this.#shadow = contact.ground.form === "plane" ? new Shadow(new Vector3(...contact.ground.axis), outline, palette) : null;
    if (this.#shadow) this.space.add(this.#shadow.object);
    this.#put("ground", this.#ground.label, "faint", "area", true, this.#ground.object.children[0], ...(this.#shadow ? [this.#shadow.object] : []));
    this.#draw("ground-path", turns ? "Path in space" : `Path on the ${name}`, "torque", true, new ContactPath(motion, until, at.ground, "torque", palette), this.space);
    if (turns) this.#draw("ground-trace", `Path on the ${name}`, "axis-2", false, new ContactPath(motion, until, at.trace, "axis-2", palette), trace);
    this.#draw("body-path", "Path on the body", "omega", true, new ContactPath(motion, until, at.body, "omega", palette), this.body);
    this.#draw("center-path", "Path of the centre of mass", "contour", false, new ContactPath(motion, Infinity, at.center, "contour", palette), this.space);
    const way = Math.max(...Array.from({ length: motion.telling }, (_, i) => new Vector3().fromArray(contact.center, 3 * i).length())) / unit;
    this.#touch = new Marker("omega", Math.max(MARK[0], MARK[1] * way), true, palette).object;
    this.space.add(this.#touch);
    this.#put("touch", "Point of contact", "omega", "area", true, this.#touch);
    if (!contact.surface) return;
    const { group } = new Solids([contact.surface], true, palette);
    group.scale.setScalar(1 / unit);
    this.body.add(group);
    this.#put("surface", "Surface that touches", null, "area", true, group);
  }

  /** Points of the edge of the ground. */
  get rim(): readonly Vector3[] {
    return this.#ground.rim;
  }

  /** `turned` converts a place in the body to space. */
  pose(now: Moment, time: number, turned: (p: Vector3) => Vector3): void {
    this.#ground.pose(time);
    this.#shadow?.pose(turned);
    for (const { path, layer } of this.#paths) if (layer.on.body === true) path.draw(now, time);
    const point = now.point ?? now.center;
    this.#touch.position.set(...point).divideScalar(this.#unit);
  }

  #draw(id: string, label: string, ink: Ink, on: boolean, path: ContactPath, into: Group): void {
    into.add(path.object);
    this.#paths.push({ path, layer: this.#put(id, label, ink, "line", on, path.object) });
  }

  #put(id: string, label: string, ink: Layer["ink"], look: Layer["look"], on: boolean, ...objects: Object3D[]): Layer {
    const layer: Layer = { id, label, ink, look, on: { body: on }, objects };
    this.layers.push(layer);
    return layer;
  }
}
