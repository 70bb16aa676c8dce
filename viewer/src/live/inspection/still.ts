/**
 * View of static objects in 3-D: the contents of an inspected file. A frame is drawn only after a
 * change.
 */
import { type Group, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { element } from "../../dom";
import { OrbitCamera } from "../../scene/camera";
import { compose } from "../../scene/compose";
import { dispose } from "../../scene/dispose";
import { type Label, Labels } from "../../scene/labels";
import { Light } from "../../scene/light";
import { Palette } from "../../scene/palette";
import { onTheme } from "../../theme";

/** A static object; size 1 is the distance from its centre to its farthest point. */
export interface Still {
  readonly object: Group;
  /** Parts that can be hidden. */
  readonly parts: { name: string; isOn: boolean; show: (isOn: boolean) => void }[];
  /** Points that the camera must see. */
  content: () => Vector3[];
  labels: () => Label[];
  /** Points around which no name may be placed. */
  readonly outline: Vector3[];
  /**
   * Highlights one of the listed items, or all; returns the direction from which to view it, if
   * that matters.
   */
  choose: (item: number | null) => Vector3 | null;
  /** Returns the first item that a ray hits. */
  at: (ray: Raycaster) => number | null;
}

/** Largest movement of a press that counts as a click, px. */
const CLICK = 4;
const TURN = 0.12;
/** Elevation at which the sides of an object viewed from above are still visible, rad. */
const STEEP = 1.1;

export class StillView {
  readonly host = element("div", { class: "still" });
  readonly orbit: OrbitCamera;
  readonly palette = new Palette();
  /** Called when a listed item was clicked, or when nothing was hit. */
  clicked: (item: number | null) => void = () => undefined;

  readonly #canvas = element("canvas", { tabindex: "0", "aria-label": "What was found, in three dimensions; drag to turn the camera, or use the arrow keys" });
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #light = new Light();
  readonly #labels: Labels;
  #still: Still | null = null;
  #size = { width: 1, height: 1 };
  #isWaiting = false;

  /** Throws if the browser has no WebGL. */
  constructor() {
    const names = element("div", { class: "names-over", "aria-hidden": "true" });
    this.host.append(this.#canvas, names);
    this.#renderer = new WebGLRenderer({ canvas: this.#canvas, antialias: true, alpha: true });
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.orbit = new OrbitCamera(this.#canvas, () => this.invalidate(), () => undefined);
    this.#labels = new Labels(names);
    this.#scene.add(...this.#light.objects);
    new ResizeObserver(() => this.#resize()).observe(this.host);
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
    this.#listenForClicks();
    onTheme(() => {
      this.palette.refresh();
      this.invalidate();
    });
  }

  /** Numbers of objects on the graphics card. */
  get memory(): { geometries: number; textures: number } {
    const { geometries, textures } = this.#renderer.info.memory;
    return { geometries, textures };
  }

  /** Replaces the object. The camera stays if it is another state of the same object. */
  show(still: Still, isSame: boolean): void {
    this.clear();
    this.#still = still;
    this.#scene.add(still.object);
    if (!isSame) this.orbit.home();
    this.invalidate();
  }

  /** Releases the memory of the graphics card. */
  clear(): void {
    if (this.#still) dispose(this.#still.object, this.palette);
    this.#still = null;
  }

  /** Views the object from this direction. */
  from({ x, y, z }: Vector3): void {
    const { orbit } = this;
    orbit.azimuth = Math.hypot(x, y) > 1e-3 ? Math.atan2(y, x) + 0.25 : orbit.azimuth;
    orbit.height = Math.min(Math.max(Math.atan2(z, Math.hypot(x, y)), -STEEP), STEEP);
    this.invalidate();
  }

  invalidate(): void {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    requestAnimationFrame(() => {
      this.#isWaiting = false;
      this.#draw();
    });
  }

  /** Returns the frame as on the screen, with names. */
  photograph(): HTMLCanvasElement {
    this.#draw();
    const out = element("canvas");
    out.width = this.#canvas.width;
    out.height = this.#canvas.height;
    const pen = out.getContext("2d");
    if (pen) compose(pen, this.#canvas, this.#labels.placed, out.width / this.#size.width, true);
    return out;
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width < 1 || height < 1) return;
    this.#size = { width, height };
    this.#renderer.setSize(width, height, false);
    this.#draw();
  }

  #draw(): void {
    const { width, height } = this.#size;
    const still = this.#still;
    this.orbit.content = still?.content() ?? [];
    this.orbit.place(width, height);
    this.#light.follow(this.orbit);
    this.#renderer.render(this.#scene, this.orbit.camera);
    this.#labels.draw(still?.labels() ?? [], still?.outline ?? [], new Vector3(), this.orbit.camera, width, height);
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turns: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const turn = turns[event.key];
    if (turn) this.orbit.turn(TURN * turn[0], TURN * turn[1]);
    else if (event.key === "i" || event.key === "o") this.orbit.dolly(event.key === "i" ? 1.15 : 1 / 1.15);
    else if (event.key === "r") this.orbit.home();
    else return;
    event.preventDefault();
  }

  #listenForClicks(): void {
    let pressed: [number, number] | null = null;
    this.#canvas.addEventListener("pointerdown", ({ offsetX, offsetY }) => {
      pressed = [offsetX, offsetY];
    });
    this.#canvas.addEventListener("pointerup", ({ offsetX: x, offsetY: y }) => {
      const isClick = pressed !== null && Math.hypot(x - pressed[0], y - pressed[1]) < CLICK;
      pressed = null;
      if (!isClick || !this.#still) return;
      const ray = new Raycaster();
      ray.setFromCamera(new Vector2((2 * x) / this.#size.width - 1, 1 - (2 * y) / this.#size.height), this.orbit.camera);
      this.clicked(this.#still.at(ray));
    });
  }
}
