/**
 * A mesh and its errors: edges and triangles that findings mark, in their colours, with the numbers
 * of the list.
 */
import { BufferAttribute, BufferGeometry, DoubleSide, Group, type Material, Mesh, MeshBasicMaterial, MeshStandardMaterial, Vector3 } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { f32 } from "../../decode";
import { Solids } from "../../scene/body";
import type { Label } from "../../scene/labels";
import { lineMaterial, segments } from "../../scene/lines";
import type { Ink, Palette } from "../../scene/palette";
import type { MeshFinding, MeshInspection } from "../protocol";
import type { Still } from "./still";
import { box, Fitted } from "./fitted";

export const INKS: Record<MeshFinding["severity"], Ink> = { error: "danger", warning: "warn", info: "axis-1" };

/** Maximum number of points next to which a finding's number may be placed. */
const PLACES = 24;
/** Maximum number of points that represent a finding, which may have 60,000. */
const TELLING = 2_000;

export class MeshScene implements Still {
  readonly object: Group;
  readonly parts: Still["parts"];
  readonly outline: Vector3[];
  readonly #marks: Marks[];
  #chosen: number | null = null;

  constructor(mesh: MeshInspection, palette: Palette) {
    const whole = new Group();
    const { name, vertices, triangles, of } = mesh;
    const solids = new Solids([{ kind: "mesh", name, vertices, triangles, of, position: [0, 0, 0], quaternion: [1, 0, 0, 0] }], false, palette);
    // Open meshes show their inside. Marks are in the surface, which is drawn a little behind them.
    const look = { side: DoubleSide, roughness: 0.55, metalness: 0.05, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const opaque = palette.shared("inspected", "solid", () => new MeshStandardMaterial(look));
    const glass = palette.shared("inspected glass", "solid", () => new MeshStandardMaterial({ ...look, transparent: true, opacity: 0.3, depthWrite: false }));
    const paint = (material: Material): void => {
      solids.group.traverse((part) => {
        if (part instanceof Mesh && !(part instanceof LineSegments2)) part.material = material;
      });
    };
    paint(opaque);
    this.#marks = mesh.findings.map((finding, k) => new Marks(finding, k, palette));
    whole.add(solids.group, ...this.#marks.map(({ group }) => group));
    const fitted = new Fitted(whole, [...solids.farthest, ...this.#marks.flatMap(({ places }) => places)]);
    this.object = fitted.group;
    this.outline = fitted.points;
    for (const marks of this.#marks) marks.places = fitted.toPicture(marks.places);
    this.parts = [{ name: "See through it", isOn: false, show: (isOn) => paint(isOn ? glass : opaque) }];
  }

  choose(item: number | null): Vector3 | null {
    this.#chosen = item;
    this.#marks.forEach(({ group }, k) => {
      group.visible = item === null || item === k;
    });
    const places = item === null ? [] : this.#marks[item].places;
    if (places.length === 0) return null;
    // View from the side on which the marks are.
    const middle = places.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(places.length);
    return middle.length() > 0.15 ? middle : null;
  }

  content(): Vector3[] {
    const places = this.#chosen === null ? [] : this.#marks[this.#chosen].places;
    // Leave enough space around a small finding to recognise its place.
    return places.length > 0 ? box(places, 0.25) : this.outline;
  }

  labels(): Label[] {
    const shown = this.#marks.filter(({ group, places }) => group.visible && places.length > 0);
    return shown.map(({ number, ink, places }) => {
      const every = Math.ceil(places.length / PLACES);
      return { text: String(number), ink, tip: places[0], along: places.filter((_, k) => k % every === 0) };
    });
  }

  at(): null {
    return null;
  }
}

/** Marks of a finding. */
class Marks {
  readonly group = new Group();
  readonly number: number;
  readonly ink: Ink;
  /** Ends of the edges or corners of the triangles; for many, a representative subset. */
  places: Vector3[];

  constructor({ edges, faces, severity, code }: MeshFinding, k: number, palette: Palette) {
    this.number = k + 1;
    this.ink = INKS[severity];
    const [ends, corners] = [f32(edges, `${code}: edges`), f32(faces, `${code}: faces`)];
    if (corners.length > 0) this.#triangles(corners, palette);
    if (ends.length > 0) this.#edges(ends, palette);
    this.places = telling(ends.length > 0 ? ends : corners);
  }

  // Marks behind other surfaces shine through.
  #triangles(corners: Float32Array, palette: Palette): void {
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
    const look = { side: DoubleSide, transparent: true, depthWrite: false };
    const seen = palette.shared("mark", this.ink, () => new MeshBasicMaterial({ ...look, opacity: 0.75 }));
    const behind = palette.shared("mark behind", this.ink, () => new MeshBasicMaterial({ ...look, opacity: 0.22, depthTest: false }));
    const [above, below] = [new Mesh(geometry, seen), new Mesh(geometry, behind)];
    [above.renderOrder, below.renderOrder] = [6, 5];
    this.group.add(above, below);
  }

  #edges(ends: Float32Array, palette: Palette): void {
    const geometry = segments(ends);
    const [above, below] = [
      new LineSegments2(geometry, lineMaterial({ ink: this.ink, width: 4 }, palette)),
      new LineSegments2(geometry, lineMaterial({ ink: this.ink, width: 2.5, opacity: 0.5, onTop: true }, palette)),
    ];
    [above.renderOrder, below.renderOrder] = [8, 7];
    this.group.add(above, below);
  }
}

/** Returns representative points of many: some of them, and the outermost along each axis. */
function telling(numbers: Float32Array): Vector3[] {
  const count = numbers.length / 3;
  const every = Math.ceil(count / TELLING);
  const told = Array.from({ length: Math.ceil(count / (every || 1)) }, (_, k) => every * k);
  if (every > 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      let [least, most] = [0, 0];
      for (let k = 1; k < count; k += 1) {
        if (numbers[3 * k + axis] < numbers[3 * least + axis]) least = k;
        if (numbers[3 * k + axis] > numbers[3 * most + axis]) most = k;
      }
      told.push(least, most);
    }
  }
  return told.map((k) => new Vector3().fromArray(numbers, 3 * k));
}
