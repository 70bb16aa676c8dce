/**
 * A film as GIF: 255 colours shared by all frames, and in each frame only the pixels that differ
 * from the previous one.
 */
import { GifWriter as Encoder } from "omggif";
import { INKS } from "../scene/palette";
import { ink as colour } from "../theme";
import { Colours } from "./colours";

/** Index of the colour for unchanged pixels, of 256. */
const SAME = 255;

export class GifWriter {
  readonly #buffer: Uint8Array<ArrayBuffer>;
  readonly #encoder: Encoder;
  readonly #parts: Blob[] = [];
  readonly #rate: number;
  readonly #colours: Colours;
  #before: Uint8Array | null = null;
  #size = 0;

  /** `samples`: frames of several times, each valid until the next. */
  constructor(width: number, height: number, rate: number, samples: Iterable<CanvasRenderingContext2D>) {
    this.#rate = rate;
    // Paper and inks are exact. Not every page has all of them.
    const inks = INKS.map(colour).flatMap((value) => (value === "" ? [] : [parseInt(value.slice(1), 16)]));
    this.#colours = new Colours(inks, pictures(samples), SAME);
    // At most one code of 12 bits for each pixel.
    this.#buffer = new Uint8Array(Math.ceil(1.6 * width * height) + 4096);
    const all = Array.from({ length: 256 }, (_, k) => this.#colours.all[k] ?? 0);
    this.#encoder = new Encoder(this.#buffer, width, height, { palette: all, loop: 0 });
    this.#move(this.#encoder.getOutputBufferPosition());
  }

  get size(): number {
    return this.#size;
  }

  add(pen: CanvasRenderingContext2D, k: number): void {
    const { data, width, height } = pixels(pen);
    const index = this.#colours.index(data);
    const before = this.#before;
    const shown = before ? index.map((colour, i) => (colour === before[i] ? SAME : colour)) : index;
    // Delays are in hundredths of a second. The rounding error of a frame is compensated in the
    // next.
    const time = (frame: number): number => Math.round((100 * frame) / this.#rate);
    const how = { delay: time(k + 1) - time(k), disposal: 1 };
    this.#move(this.#encoder.addFrame(0, 0, width, height, shown, before ? { ...how, transparent: SAME } : how));
    this.#before = index;
  }

  finish(): Blob {
    this.#move(this.#encoder.end());
    return new Blob(this.#parts, { type: "image/gif" });
  }

  // Moves the data to the browser's storage for large objects.
  #move(count: number): void {
    if (count > this.#buffer.length) throw new Error(`a frame of the GIF has ${count} bytes, more than ${this.#buffer.length}`);
    this.#parts.push(new Blob([this.#buffer.slice(0, count)]));
    this.#size += count;
    this.#encoder.setOutputBufferPosition(0);
  }
}

function pixels(pen: CanvasRenderingContext2D): ImageData {
  return pen.getImageData(0, 0, pen.canvas.width, pen.canvas.height);
}

function* pictures(frames: Iterable<CanvasRenderingContext2D>): Generator<Uint8ClampedArray> {
  for (const frame of frames) yield pixels(frame).data;
}
