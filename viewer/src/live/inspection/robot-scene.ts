/**
 * A robot with all joints at zero: for every link its shapes, the box of its mass and tensor, and
 * its centre of mass.
 */
import { BoxGeometry, EdgesGeometry, Group, Mesh, MeshStandardMaterial, type Object3D, type Raycaster, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { number } from "../../format";
import { Solids } from "../../scene/body";
import type { Label } from "../../scene/labels";
import { lineMaterial, segments } from "../../scene/lines";
import { Marker } from "../../scene/marker";
import type { Ink, Palette } from "../../scene/palette";
import type { RobotInspection, RobotLink } from "../protocol";
import { box, Fitted, outermost } from "./fitted";
import type { Still } from "./still";

export const INKS: Record<RobotLink["verdict"], Ink> = { impossible: "danger", suspect: "warn", ok: "axis-1", none: "quiet" };

/**
 * Radii in the picture: of a centre of mass, and of one with an unphysical tensor, which has no
 * box.
 */
const DOT = 0.012;
const BOXLESS = 0.018;
/** Maximum number of names shown together. */
const NAMED = 14;
/**
 * Limit relative to the robot's size. Boxes farther from its centre are shown only if their link is
 * selected. A wrong unit makes boxes of kilometres.
 */
const FAR = 3;

export class RobotScene implements Still {
  readonly object: Group;
  readonly parts: Still["parts"];
  readonly outline: Vector3[];
  readonly #links: LinkModel[];
  #chosen: number | null = null;

  constructor({ links }: RobotInspection, palette: Palette) {
    const whole = new Group();
    this.#links = links.map((link) => new LinkModel(link, palette));
    whole.add(...this.#links.map(({ group }) => group));
    const fitted = new Fitted(whole, extent(this.#links));
    this.object = fitted.group;
    for (const link of this.#links) link.fit(fitted);
    this.outline = outermost(this.#links.flatMap(({ isFar, points, form, origin }) => [...fitted.toPicture([origin, ...(isFar ? form : [])]), ...(isFar ? [] : points)]));
    this.parts = [
      { name: "Shapes", isOn: true, show: (isOn) => this.#show(isOn, this.parts[1].isOn) },
      { name: "Equivalent boxes", isOn: true, show: (isOn) => this.#show(this.parts[0].isOn, isOn) },
    ];
    this.#show(true, true);
  }

  choose(item: number | null): null {
    this.#chosen = item;
    this.#links.forEach((link, k) => {
      link.isFaint = item !== null && item !== k;
    });
    this.#show(this.parts[0].isOn, this.parts[1].isOn);
    return null;
  }

  content(): Vector3[] {
    const points = this.#chosen === null ? [] : this.#links[this.#chosen].points;
    return points.length > 0 ? box(points, 0.3) : this.outline;
  }

  #show(hasShapes: boolean, hasBoxes: boolean): void {
    this.#links.forEach((link, k) => {
      link.shapes.visible = hasShapes;
      link.inertia.visible = hasBoxes && (!link.isFar || k === this.#chosen);
    });
  }

  labels(): Label[] {
    const isNamed = ({ verdict }: LinkModel, k: number): boolean => (this.#chosen === null ? verdict === "impossible" || verdict === "suspect" : k === this.#chosen);
    const named = this.#links.filter(isNamed).slice(0, NAMED);
    return named.map(({ name, verdict, middle, isFar, far }) => ({ text: isFar && this.#chosen === null ? far : name, key: `link ${name}`, ink: INKS[verdict], tip: middle, along: [middle] }));
  }

  at(ray: Raycaster): number | null {
    const [first] = ray.intersectObjects<Mesh>(this.#links.flatMap(({ solids }) => solids), false);
    const found = this.#links.findIndex(({ solids }) => first !== undefined && solids.includes(first.object));
    return found < 0 ? null : found;
  }
}

/**
 * Returns points that determine the size of the robot, whatever its inertias: its shapes; without
 * shapes, the boxes without findings; or else the origins of its links.
 */
function extent(links: LinkModel[]): Vector3[] {
  const origins = links.map(({ origin }) => origin);
  const shapes = links.flatMap(({ form }) => form);
  const sound = links.flatMap(({ verdict, points }) => (verdict === "ok" ? points : []));
  const some = shapes.length > 0 ? shapes : sound;
  const isSpread = [...some, ...origins].some((p) => p.distanceTo(origins[0]) > 0);
  return isSpread ? [...some, ...origins] : links.flatMap(({ points }) => points);
}

/** A link at its place. */
class LinkModel {
  readonly group = new Group();
  readonly shapes = new Group();
  readonly inertia = new Group();
  readonly name: string;
  readonly verdict: RobotLink["verdict"];
  /** Objects that can be clicked. */
  readonly solids: Mesh[] = [];
  /** Origin of its frame, and outermost points of its shapes, model frame, m. */
  readonly origin: Vector3;
  readonly form: Vector3[];
  /** Outermost points of the whole link, model frame, m; later in coordinates of the picture. */
  points: Vector3[];
  isFar = false;
  /** Its name, and the reason why the box or the centre is not visible. */
  readonly far: string;
  /** Its centre of mass, or the origin of its frame. */
  middle: Vector3;
  readonly #marker: Object3D | null = null;
  readonly #palette: Palette;
  readonly #ink: Ink;

  constructor({ name, position, quaternion, inertial, verdict, shapes }: RobotLink, palette: Palette) {
    [this.name, this.verdict, this.#palette, this.#ink] = [name, verdict, palette, INKS[verdict]];
    this.far = inertial?.box ? `${name}: a box of ${number(Math.max(...inertial.box.size), 2)} m` : `${name}: far away`;
    pose(this.group, position, quaternion);
    const solids = new Solids(shapes, true, palette);
    this.shapes.add(solids.group);
    if (verdict === "impossible" || verdict === "suspect") this.#tint(solids.group);
    const form = shapes.length > 0 ? solids.farthest : [];
    const own = [...form];
    if (inertial) {
      const center = new Vector3(...inertial.center);
      own.push(center);
      if (inertial.box) own.push(...this.#box(inertial.box, center));
      const marker = new Marker(this.#ink, inertial.box ? DOT : BOXLESS, false, palette);
      marker.object.position.copy(center);
      this.inertia.add(marker.object);
      this.#marker = marker.object;
    }
    this.group.add(this.shapes, this.inertia);
    this.group.updateMatrixWorld(true);
    const inModel = (p: Vector3): Vector3 => this.group.localToWorld(p.clone());
    this.origin = inModel(new Vector3());
    this.form = form.map(inModel);
    this.points = own.map(inModel);
    this.middle = inModel(new Vector3(...(inertial?.center ?? [0, 0, 0])));
    this.group.traverse((part) => {
      if (part instanceof Mesh && !(part instanceof LineSegments2) && part.parent !== this.#marker) this.solids.push(part);
    });
  }

  /** Moves the link to its place in the picture. */
  fit(picture: Fitted): void {
    this.points = picture.toPicture(this.points);
    [this.middle] = picture.toPicture([this.middle]);
    this.isFar = this.points.some((p) => p.length() > FAR);
    // A marker scales with the picture, not with the robot.
    this.#marker?.scale.setScalar(1 / picture.group.scale.x);
  }

  /** True while another link is selected. */
  set isFaint(isFaint: boolean) {
    const [glass, edge] = this.#look(isFaint);
    for (const part of this.inertia.children) {
      if (part instanceof LineSegments2) part.material = edge;
      else if (part instanceof Mesh) part.material = glass;
    }
    if (this.#marker) this.#marker.visible = !isFaint;
  }

  // Shapes have the colour of their link, with or without a box of its inertia.
  #tint(shapes: Group): void {
    const tinted = this.#palette.shared("tinted", this.#ink, () => new MeshStandardMaterial({ transparent: true, opacity: 0.35, depthWrite: false, roughness: 0.6 }), 0.8);
    shapes.traverse((part) => {
      if (part instanceof Mesh && !(part instanceof LineSegments2)) part.material = tinted;
    });
  }

  #box({ size, quaternion }: { size: [number, number, number]; quaternion: [number, number, number, number] }, center: Vector3): Vector3[] {
    // The box of a plate has no thickness, but a shaded box needs one.
    const least = 0.004 * Math.max(...size, Number.MIN_VALUE);
    const geometry = new BoxGeometry(...size.map((edge) => Math.max(edge, least)));
    const [glass, edge] = this.#look(false);
    const parts = [new Mesh(geometry, glass), new LineSegments2(segments(new EdgesGeometry(geometry).attributes.position.array), edge)];
    for (const part of parts) {
      pose(part, center.toArray(), quaternion);
      part.renderOrder = 3;
    }
    this.inertia.add(...parts);
    parts[0].updateMatrix();
    const corners = Array.from(geometry.attributes.position.array as Float32Array);
    return Array.from({ length: corners.length / 3 }, (_, k) => new Vector3().fromArray(corners, 3 * k).applyMatrix4(parts[0].matrix));
  }

  #look(isFaint: boolean): [MeshStandardMaterial, ReturnType<typeof lineMaterial>] {
    const opacity = isFaint ? 0.08 : 0.4;
    const glass = this.#palette.shared(`inertia ${opacity}`, this.#ink, () => new MeshStandardMaterial({ transparent: true, opacity, depthWrite: false, roughness: 0.6 }));
    return [glass, lineMaterial({ ink: this.#ink, width: 1.5, opacity: isFaint ? 0.25 : 1 }, this.#palette)];
  }
}

function pose(part: Object3D, position: [number, number, number], [w, x, y, z]: [number, number, number, number]): void {
  part.position.set(...position);
  part.quaternion.set(x, y, z, w).normalize();
}
