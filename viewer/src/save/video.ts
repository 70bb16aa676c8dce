/**
 * A film as WebM: frames with their exact times pass through the browser's encoder, as fast as it
 * accepts them.
 */
import { type Chunk, type Track, webm } from "./webm";

/** Bits for each pixel. Drawings need fewer than camera pictures, but they have sharp lines. */
const BITS = 0.15;
const LEAST = 1e6;
/** Time between key frames, s. */
const KEYS = 2;
/** Maximum number of frames that wait for the encoder. */
const WAITING = 4;

/** VP9 in profile 0 at level 6.2, which is sufficient for all sizes of the page; else VP8. */
const CODECS = [
  { name: "V_VP9", config: "vp09.00.62.08" },
  { name: "V_VP8", config: "vp8" },
] as const;

/** Returns the reason why this browser makes no video; null if it does. */
export function noVideo(): string | null {
  if ("VideoEncoder" in window) return null;
  return isSecureContext ? "this browser has no video encoder (WebCodecs)" : "browsers encode video only for pages from disk, from this machine or over HTTPS";
}

export class VideoWriter {
  readonly #encoder: VideoEncoder;
  readonly #chunks: Chunk[] = [];
  readonly #track: Track;
  readonly #rate: number;
  #problem: Error | null = null;
  /** Continues frames that wait for the encoder. */
  #wake: () => void = () => undefined;
  #count = 0;
  #size = 0;

  static async of(width: number, height: number, rate: number): Promise<VideoWriter> {
    const bitrate = Math.max(LEAST, Math.round(BITS * width * height * rate));
    for (const { name, config } of CODECS) {
      const wanted: VideoEncoderConfig = { codec: config, width, height, bitrate, framerate: rate, latencyMode: "quality" };
      if ((await VideoEncoder.isConfigSupported(wanted)).supported) return new VideoWriter(wanted, name);
    }
    throw new Error(`This browser encodes no WebM of ${width} × ${height} px. Take a smaller one, or another format.`);
  }

  private constructor(config: VideoEncoderConfig, codec: Track["codec"]) {
    const { width, height, framerate = 1 } = config;
    this.#rate = framerate;
    this.#track = { codec, width, height, frame: 1000 / framerate, duration: 0, colour: {} };
    this.#encoder = new VideoEncoder({
      output: (chunk, about) => {
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        this.#chunks.push({ time: Math.round(chunk.timestamp / 1000), isKey: chunk.type === "key", data });
        this.#size += data.length;
        if (about?.decoderConfig?.colorSpace) this.#track.colour = about.decoderConfig.colorSpace;
      },
      error: (problem) => {
        this.#problem = problem;
        this.#wake();
      },
    });
    this.#encoder.addEventListener("dequeue", () => this.#wake());
    this.#encoder.configure(config);
  }

  get size(): number {
    return this.#size;
  }

  async add({ canvas }: CanvasRenderingContext2D, k: number): Promise<void> {
    while (this.#encoder.encodeQueueSize >= WAITING && !this.#problem) {
      await new Promise<void>((done) => {
        this.#wake = done;
      });
    }
    if (this.#problem) throw this.#problem;
    const frame = new VideoFrame(canvas, { timestamp: Math.round((1e6 * k) / this.#rate), duration: Math.round(1e6 / this.#rate), alpha: "discard" });
    this.#encoder.encode(frame, { keyFrame: k % Math.max(1, Math.round(KEYS * this.#rate)) === 0 });
    frame.close();
    this.#count = k + 1;
  }

  async finish(): Promise<Blob> {
    await this.#encoder.flush();
    if (this.#problem) throw this.#problem;
    if (this.#chunks.length !== this.#count) throw new Error(`The encoder made ${this.#chunks.length} frames of ${this.#count}.`);
    return webm(this.#chunks, { ...this.#track, duration: (1000 * this.#count) / this.#rate });
  }

  close(): void {
    if (this.#encoder.state !== "closed") this.#encoder.close();
  }
}
