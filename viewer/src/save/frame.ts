/** Frames of the 3-D view for files. */
import { WebGLRenderer } from "three";
import { element } from "../dom";
import { compose } from "../scene/compose";
import { Labels } from "../scene/labels";
import type { View } from "../scene/scene";
import type { Order } from "./film";

/** Draws frames of any size, with its own renderer and labels, independent of the screen. */
export class Frames {
  readonly #view: View;
  readonly #renderer = new WebGLRenderer({ antialias: true, alpha: true });
  readonly #canvas = document.createElement("canvas");
  readonly #pen: CanvasRenderingContext2D;
  readonly #host = element("div", { class: "frame-names", "aria-hidden": "true" });
  #names = new Labels(this.#host);
  #layout = { width: 1, height: 1, ratio: 1 };
  #paper = true;

  /** Throws if the browser provides no further WebGL context. */
  constructor(view: View) {
    this.#view = view;
    this.#renderer.debug.checkShaderErrors = false;
    const pen = this.#canvas.getContext("2d", { willReadFrequently: true });
    if (!pen) throw new Error("This browser gives no canvas to draw frames on.");
    this.#pen = pen;
    document.body.append(this.#host);
  }

  /** True if the GPU context was lost. */
  get isLost(): boolean {
    return this.#renderer.getContext().isContextLost();
  }

  /**
   * Sets the size of the following frames, px. The picture is that of a page of `shown` px,
   * enlarged with its text and lines; in a smaller picture they keep their size. Throws if the size
   * is not available, instead of drawing a smaller frame.
   */
  begin({ width, height, paper }: Order, shown: { width: number; height: number }): void {
    const gl = this.#renderer.getContext();
    const [across, down] = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
    const most = gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number;
    if (width > Math.min(across, most) || height > Math.min(down, most)) {
      throw new Error(`The GPU draws pictures of at most ${Math.min(across, most)} × ${Math.min(down, most)} px, not of ${width} × ${height}.`);
    }
    const ratio = Math.max(1, Math.min(width / shown.width, height / shown.height));
    this.#layout = { width: width / ratio, height: height / ratio, ratio };
    this.#paper = paper;
    // Sizes are rounded down.
    this.#renderer.setDrawingBufferSize((width + 0.01) / ratio, (height + 0.01) / ratio, ratio);
    if (this.isLost || gl.drawingBufferWidth !== width || gl.drawingBufferHeight !== height) {
      throw new Error(`The GPU has no room for a picture of ${width} × ${height} px. Take a smaller one.`);
    }
    Object.assign(this.#canvas, { width, height });
    // A canvas that is too large for the browser stays empty.
    this.#pen.fillRect(width - 1, height - 1, 1, 1);
    if (this.#pen.getImageData(width - 1, height - 1, 1, 1).data[3] !== 255) {
      throw new Error(`This browser has no room for a picture of ${width} × ${height} px. Take a smaller one.`);
    }
    this.#host.style.width = `${this.#layout.width}px`;
    this.#host.style.height = `${this.#layout.height}px`;
    // Labels stay near their previous places, but those of previous frames do not count.
    this.#host.replaceChildren();
    this.#names = new Labels(this.#host);
  }

  /** Draws the frame of a time. It is valid until the next call. */
  draw(time: number): CanvasRenderingContext2D {
    const { width, height, ratio } = this.#layout;
    this.#view.draw(this.#renderer, this.#names, time, width, height);
    if (this.isLost) throw new Error("The GPU has lost the picture. Take a smaller one.");
    compose(this.#pen, this.#renderer.domElement, this.#names.placed, ratio, this.#paper);
    return this.#pen;
  }

  /** Releases the memory of frames. */
  end(): void {
    this.#renderer.setDrawingBufferSize(1, 1, 1);
    Object.assign(this.#canvas, { width: 1, height: 1 });
    this.#view.invalidate();
  }
}
