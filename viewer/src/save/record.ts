/** Draws an order frame by frame at exact times, so that a slow machine makes the same film. */
import { Zip, ZipPassThrough } from "fflate";
import { frameCount, frameTime, type Order } from "./film";
import type { Frames } from "./frame";
import { GifWriter } from "./gif";
import { VideoWriter } from "./video";

/** Number of frames from which the colours of a GIF are chosen. */
const SAMPLES = 8;

interface Writer {
  readonly size: number;
  add: (pen: CanvasRenderingContext2D, k: number) => Promise<void> | void;
  finish: () => Promise<Blob> | Blob;
  close?: () => void;
}

/** Maximum size of a file, bytes. */
const MOST = 1e9;

/**
 * Records an order. `shown` is the size of the view on the screen, and `now` the time of a picture.
 * Rejects when `signal` is aborted, or if the recording fails.
 */
export async function record(
  order: Order,
  frames: Frames,
  shown: { width: number; height: number },
  now: number,
  progress: (done: number) => void,
  signal: AbortSignal,
): Promise<Blob> {
  let writer: Writer | null = null;
  try {
    frames.begin(order, shown);
    if (order.format === "png") return await png(frames.draw(now).canvas);
    const count = frameCount(order);
    writer = await writerOf(order, frames, count);
    frames.begin(order, shown);
    for (let k = 0; k < count; k += 1) {
      signal.throwIfAborted();
      await writer.add(frames.draw(frameTime(order, k)), k);
      if (writer.size > MOST) throw new Error(`The file has reached ${MOST / 1e9} GB at frame ${k + 1} of ${count}. Take a shorter time, fewer frames or a smaller picture.`);
      progress(k + 1);
      await turn();
    }
    return await writer.finish();
  } finally {
    writer?.close?.();
    frames.end();
  }
}

async function writerOf(order: Order, frames: Frames, count: number): Promise<Writer> {
  const { format, width, height, rate } = order;
  if (format === "webm") return VideoWriter.of(width, height, rate);
  return format === "zip" ? new PngWriter(count) : new GifWriter(width, height, rate, sampled(order, frames, count));
}

function* sampled(order: Order, frames: Frames, count: number): Generator<CanvasRenderingContext2D> {
  const all = Math.min(SAMPLES, count);
  for (let j = 0; j < all; j += 1) yield frames.draw(frameTime(order, Math.floor(((j + 0.5) * count) / all)));
}

/**
 * Date of every file in a ZIP, local time as in the format. It is fixed, so that the same pictures
 * give the same bytes.
 */
const DATE = new Date(1980, 0, 1);

/**
 * A ZIP of pictures, named by their number and stored without compression, because PNG is
 * compressed already.
 */
class PngWriter {
  readonly #parts: Blob[] = [];
  readonly #zip: Zip;
  readonly #digits: number;
  #size = 0;

  constructor(count: number) {
    this.#digits = Math.max(4, String(count).length);
    this.#zip = new Zip((problem, bytes) => {
      if (problem) throw problem;
      this.#parts.push(new Blob([bytes]));
      this.#size += bytes.length;
    });
  }

  get size(): number {
    return this.#size;
  }

  async add({ canvas }: CanvasRenderingContext2D, k: number): Promise<void> {
    const file = new ZipPassThrough(`frame-${String(k + 1).padStart(this.#digits, "0")}.png`);
    file.mtime = DATE;
    const picture = await png(canvas);
    this.#zip.add(file);
    file.push(new Uint8Array(await picture.arrayBuffer()), true);
  }

  finish(): Blob {
    this.#zip.end();
    return new Blob(this.#parts, { type: "application/zip" });
  }
}

function png(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((done, fail) => {
    canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error(`This browser makes no PNG of ${canvas.width} × ${canvas.height} px.`))), "image/png");
  });
}

/** Lets the page redraw and handle events. Timers are slow in a page that is not visible. */
function turn(): Promise<void> {
  return new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(null);
  });
}
