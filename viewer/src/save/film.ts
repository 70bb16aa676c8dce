/** An order to save the 3-D view: a picture of the current time, or a film. */
import { grouped, number } from "../format";

export type Format = "png" | "webm" | "gif" | "zip";

export interface Film {
  /** Times of the motion, s. */
  from: number;
  to: number;
  /** Seconds of the motion in one second of the film. */
  speed: number;
  /** Frames per second. */
  rate: number;
}

export interface Order extends Film {
  format: Format;
  /** Size, px. */
  width: number;
  height: number;
  /** True for a paper background, false for a transparent one. */
  paper: boolean;
}

/** Minimum size, px, which has space for labels. */
const SMALLEST = 64;
/** Maximum number of pixels of a frame. With antialiasing, each takes 40 bytes of GPU memory. */
const PIXELS = 40e6;
/**
 * Maximum number of pixels of all frames. For a T-handle, each pixel takes 0.03 bytes in a GIF,
 * 0.08 in a PNG and 0.01 in a video. Other scenes may take ten times as much, and frames stay in
 * memory until they are saved.
 */
const ALL_PIXELS = { gif: 4e8, zip: 2e9, webm: 1e10 };
const FRAMES = 9999;
/**
 * Maximum frame rate, 1/s. GIF counts hundredths of a second, and browsers show delays of less than
 * two as ten.
 */
const FASTEST = { gif: 50, zip: 120, webm: 120 };
const NAMES = { gif: "GIF", zip: "ZIP of pictures", webm: "WebM film" };

export function frameCount({ from, to, speed, rate }: Film): number {
  // A partial frame counts as one, but a rounding error does not.
  return Math.max(1, Math.ceil(((to - from) / speed) * rate - 1e-6));
}

/** Returns the time that frame k shows, s. */
export function frameTime({ from, speed, rate }: Film, k: number): number {
  return from + (k * speed) / rate;
}

/**
 * Returns the reason why an order cannot be saved; null if it can. The motion lasts from `start` to
 * `end`, which are shown in `unit`.
 */
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
  // Ends that were displayed rounded are accepted.
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

// Returns the largest size with the same aspect ratio.
function fitting({ width, height }: Order, pixels: number): string {
  const part = Math.sqrt(pixels / (width * height));
  return `${Math.floor(width * part)} × ${Math.floor(height * part)} px`;
}

function millions(pixels: number): string {
  return `${grouped(Math.round(pixels / 1e6))} million pixels`;
}
