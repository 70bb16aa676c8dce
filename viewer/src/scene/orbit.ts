/**
 * The orbit of a satellite: a curve to scale about its central body, with the present place and the
 * velocity there, seen from the direction of the camera. It is in a corner of the picture, because
 * a body that fills the picture is too small beside its orbit.
 */
import { type Camera, DirectionalLight, Group, HemisphereLight, Mesh, MeshStandardMaterial, OrthographicCamera, Scene, SphereGeometry, Vector3, Vector4, type WebGLRenderer } from "three";
import type { OrbitData } from "../data";
import type { Motion } from "../motion";
import { Arrow } from "./arrows";
import { Conic } from "./conic";
import { kept } from "./dispose";
import { curve } from "./lines";
import { Marker } from "./marker";
import type { Palette } from "./palette";

/** Size of the corner: part of the picture, its limits and its distance from the edges, px. */
const PART = 0.24;
const LEAST = 88;
const MOST = 168;
const EDGE = 8;
/** Half of the side of the corner; the curve is in a sphere of radius 1. */
const HALF = 1.2;
/** Radius of a central body that is too small, or unknown. */
const SMALL = 0.05;
/** Number of samples that determine how much of a long orbit is shown. */
const SEEN = 65;
const BALL = kept(new SphereGeometry(1, 32, 24));

/** Part of the picture that the orbit takes, px from the upper left corner. */
export interface Corner {
  x: number;
  y: number;
  size: number;
}

export class Orbit {
  /** Everything that the layer switches. */
  readonly object = new Group();
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera(-HALF, HALF, HALF, -HALF, 0, 4 * HALF);
  readonly #conic: Conic;
  readonly #motion: Motion;
  /** Indices of directions of the motion. */
  readonly #nadir: number;
  readonly #velocity: number;
  readonly #place = new Group();
  readonly #arrow: Arrow;
  readonly #before = new Vector4();

  constructor(data: OrbitData, motion: Motion, palette: Palette) {
    const index = (name: string): number => motion.directions.findIndex((direction) => direction.name === name);
    this.#motion = motion;
    this.#nadir = index("nadir");
    this.#velocity = index("velocity");
    this.#conic = new Conic(data, Array.from({ length: SEEN }, (_, k) => this.#out(motion.times[Math.round((k / (SEEN - 1)) * (motion.count - 1))])));
    const points = this.#conic.points.flatMap((p) => p.toArray());
    const pen = { ink: "quiet", width: 1.8 } as const;
    const ball = new Mesh(BALL, palette.shared("central body", "earth", () => new MeshStandardMaterial({ roughness: 0.8 })));
    ball.scale.setScalar(Math.max((data.central ?? 0) / this.#conic.unit, SMALL));
    ball.position.copy(this.#conic.at(new Vector3()));
    this.#arrow = new Arrow("quiet", 0.022, palette);
    this.#place.add(new Marker("danger", 0.055, true, palette).object, this.#arrow.object);
    this.object.add(curve(points, 1, pen, palette), curve(points, 1, { ...pen, strength: 0.4, behind: true }, palette), ball, this.#place);
    const lamp = new DirectionalLight(0xffffff, 1.7);
    lamp.position.set(-0.5, 0.55, 1);
    this.#camera.add(lamp);
    const sky = new HemisphereLight(0xffffff, 0xa0a4ab, 1.9);
    sky.position.set(0, 0, 1);
    this.#scene.add(this.object, this.#camera, sky);
  }

  /** Returns null for a motion without an orbit. */
  static of(data: OrbitData | null, motion: Motion, palette: Palette): Orbit | null {
    const has = (name: string): boolean => motion.directions.some((direction) => direction.name === name);
    return data && has("nadir") && has("velocity") ? new Orbit(data, motion, palette) : null;
  }

  /** Root of all objects. */
  get root(): Scene {
    return this.#scene;
  }

  /** Place of the body now, and points of the curve, in the space of the corner. */
  get place(): Vector3 {
    return this.#place.position;
  }

  get points(): readonly Vector3[] {
    return this.#conic.points;
  }

  pose(time: number): void {
    const out = this.#out(time);
    this.#place.position.copy(this.#conic.at(out.multiplyScalar(this.#conic.distance(out))));
    const [x, y, z] = this.#motion.directionAt(this.#velocity, time).map((c) => 0.42 * c);
    this.#arrow.point(x, y, z);
  }

  /** Returns the corner in a picture of this size. */
  corner(width: number, height: number): Corner {
    const size = Math.round(Math.min(Math.max(PART * Math.min(width, height), LEAST), MOST));
    return { x: EDGE, y: Math.round(height) - size - EDGE, size };
  }

  /** Draws the corner over a picture of this size, seen by `camera`. */
  draw(renderer: WebGLRenderer, { quaternion }: Camera, width: number, height: number): void {
    const { x, y, size } = this.corner(width, height);
    this.#camera.quaternion.copy(quaternion);
    this.#camera.position.set(0, 0, 2 * HALF).applyQuaternion(quaternion);
    renderer.getViewport(this.#before);
    renderer.autoClear = false;
    renderer.clearDepth();
    renderer.setViewport(x, Math.round(height) - y - size, size, size);
    renderer.render(this.#scene, this.#camera);
    renderer.setViewport(this.#before);
    renderer.autoClear = true;
  }

  // Unit vector from the central body.
  #out(time: number): Vector3 {
    return new Vector3(...this.#motion.directionAt(this.#nadir, time)).negate();
  }
}
