/** What is to be saved of the 3-D view: a picture of the time that is shown, or a film. */
import { grouped, number } from "../format";

export type Format = "png" | "webm" | "gif" | "zip";

export interface Film {
  /** Times of the motion, s. */
  from: number;
  to: number;
  /** Seconds of the motion in one of the film. */
  speed: number;
  /** Frames per second. */
  rate: number;
}

export interface Order extends Film {
  format: Format;
  /** px */
  width: number;
  height: number;
  /** On paper, or on nothing. */
  paper: boolean;
}

/** Names have room. */
const SMALLEST = 64;
/** Of one frame: with what smooths its edges it takes 40 bytes of the GPU's memory for each. */
const PIXELS = 40e6;
/** Of all frames. Of a T-handle a GIF has 0.03 bytes for each, a PNG 0.08, a video 0.01; they may be ten times as many, and stay in memory until they are saved. */
const ALL_PIXELS = { gif: 4e8, zip: 2e9, webm: 1e10 };
const FRAMES = 9999;
/** GIF counts hundredths of a second, and browsers show less than two of them as ten. */
const FASTEST = { gif: 50, zip: 120, webm: 120 };
const NAMES = { gif: "GIF", zip: "ZIP of pictures", webm: "WebM film" };

export function frameCount({ from, to, speed, rate }: Film): number {
  // What is left of a frame is one; what rounding leaves is none.
  return Math.max(1, Math.ceil(((to - from) / speed) * rate - 1e-6));
}

/** The time that frame k shows, s. */
export function frameTime({ from, speed, rate }: Film, k: number): number {
  return from + (k * speed) / rate;
}

/** Why it is not saved; null if it can be. The motion goes from `start` to `end`, which are shown in `unit`. */
export function refusal(order: Order, start: number, end: number, unit: { name: string; seconds: number }): string | null {
  const { format, from, to, speed, rate, width, height } = order;
  for (const [what, size] of [["Width", width], ["Height", height]] as const) {
    if (!Number.isInteger(size) || size < SMALLEST) return `${what}: a whole number of pixels, ${SMALLEST} or more.`;
  }
  if (width * height > PIXELS) {
    return `${width} × ${height} px are ${millions(width * height)}; a picture has at most ${millions(PIXELS)}. Up to ${fitting(order, PIXELS)} fit.`;
  }
  if (format === "png") return null;
  const shown = (time: number): string => `${number(time / unit.seconds)} ${unit.name}`;
  // Ends that were shown rounded are the ends.
  const slack = 1e-9 * (end - start);
  for (const [what, time] of [["From", from], ["To", to]] as const) {
    if (!(time >= start - slack && time <= end + slack)) return `${what}: a time of the motion, ${shown(start)} to ${shown(end)}.`;
  }
  if (!(from < to)) return `From ${shown(from)} to ${shown(to)} nothing passes: the first is to be before the last.`;
  if (!(speed > 0 && Number.isFinite(speed))) return "Speed: seconds of the motion in one second, more than 0.";
  if (!(rate >= 1 && rate <= FASTEST[format])) return `Frames per second: 1 to ${FASTEST[format]} in a ${NAMES[format]}.`;
  const count = frameCount(order);
  const room = Math.min(FRAMES, Math.floor(ALL_PIXELS[format] / (width * height)));
  if (count <= room) return null;
  const rule =
    count > FRAMES
      ? `A ${NAMES[format]} has at most ${FRAMES} frames, and these are ${grouped(count)}.`
      : `A ${NAMES[format]} has at most ${millions(ALL_PIXELS[format])} in all, and ${grouped(count)} frames of ${width} × ${height} px have ${millions(count * width * height)}.`;
  const smaller = count > FRAMES ? "" : `, or all of ${fitting(order, ALL_PIXELS[format] / count)}`;
  return `${rule} Take a shorter time, a higher speed, fewer frames per second or a smaller picture: ${grouped(room)} frames of this size fit${smaller}.`;
}

// The largest size of the same shape.
function fitting({ width, height }: Order, pixels: number): string {
  const part = Math.sqrt(pixels / (width * height));
  return `${Math.floor(width * part)} × ${Math.floor(height * part)} px`;
}

function millions(pixels: number): string {
  return `${grouped(Math.round(pixels / 1e6))} million pixels`;
}
