/**
 * Colour quantisation: the fixed colours, and the means of boxes into which the others are divided
 * where they vary most.
 */

/** Colour as 0xrrggbb. */
export type Colour = number;

/** Number of pixels sampled in a picture. */
const SAMPLED = 100_000;
/** Number of bits of a channel that distinguish colours. */
const BITS = 6;
const UNKNOWN = 0xffff;

interface Bin {
  weight: number;
  rgb: number[];
}

interface Box {
  bins: Bin[];
  mean: number[];
  /** Channel with the largest variation, and the sum of squares there. */
  channel: number;
  spread: number;
}

export class Colours {
  readonly all: Colour[];
  readonly #channels: number[][];
  /** Index of the nearest colour, by the leading bits of a colour. */
  readonly #nearest = new Uint16Array(1 << (3 * BITS)).fill(UNKNOWN);

  /** Chooses at most `count` colours; pictures are bytes r g b a of each pixel. */
  constructor(fixed: Colour[], pictures: Iterable<Uint8ClampedArray>, count: number) {
    this.all = [...fixed, ...cut(binned(pictures), count - fixed.length)];
    this.#channels = this.all.map(channels);
    fixed.forEach((colour, k) => {
      this.#nearest[key(...(channels(colour) as [number, number, number]))] = k;
    });
  }

  /** Returns the index of the colour of each pixel. */
  index(picture: Uint8ClampedArray): Uint8Array {
    const found = new Uint8Array(picture.length / 4);
    for (let i = 0; i < found.length; i += 1) {
      const at = key(picture[4 * i], picture[4 * i + 1], picture[4 * i + 2]);
      if (this.#nearest[at] === UNKNOWN) this.#nearest[at] = this.#search(at);
      found[i] = this.#nearest[at];
    }
    return found;
  }

  // All colours of a bin get the same result, whichever comes first, so that nothing flickers.
  #search(at: number): number {
    const middle = [2, 1, 0].map((c) => ((((at >> (c * BITS)) & ((1 << BITS) - 1)) + 0.5) * 256) / (1 << BITS));
    let [best, least] = [0, Infinity];
    this.#channels.forEach((colour, k) => {
      const far = colour.reduce((sum, x, c) => sum + (x - middle[c]) ** 2, 0);
      if (far < least) [best, least] = [k, far];
    });
    return best;
  }
}

function channels(colour: Colour): number[] {
  return [colour >> 16, (colour >> 8) & 255, colour & 255];
}

function key(r: number, g: number, b: number): number {
  const drop = 8 - BITS;
  return ((r >> drop) << (2 * BITS)) | ((g >> drop) << BITS) | (b >> drop);
}

function binned(pictures: Iterable<Uint8ClampedArray>): Bin[] {
  const sums = new Map<number, [count: number, r: number, g: number, b: number]>();
  for (const picture of pictures) {
    const every = Math.ceil(picture.length / 4 / SAMPLED);
    for (let i = 0; i < picture.length; i += 4 * every) {
      const [r, g, b] = [picture[i], picture[i + 1], picture[i + 2]];
      const at = key(r, g, b);
      const sum = sums.get(at);
      if (sum) [1, r, g, b].forEach((x, c) => (sum[c] += x));
      else sums.set(at, [1, r, g, b]);
    }
  }
  // Thin lines get more weight than their area.
  return [...sums.values()].map(([count, ...rgb]) => ({ weight: Math.sqrt(count), rgb: rgb.map((x) => x / count) }));
}

/**
 * Repeatedly cuts the box that varies most at its mean. (P. Heckbert, Color image quantization for
 * frame buffer display, 1982)
 */
function cut(bins: Bin[], count: number): Colour[] {
  const boxes = bins.length > 0 ? [boxOf(bins)] : [];
  while (boxes.length < count) {
    const worst = boxes.reduce((a, b) => (b.spread > a.spread ? b : a), boxes[0]);
    if (!worst || worst.spread < 1e-6) break;
    const isLow = ({ rgb }: Bin): boolean => rgb[worst.channel] < worst.mean[worst.channel];
    boxes[boxes.indexOf(worst)] = boxOf(worst.bins.filter(isLow));
    boxes.push(boxOf(worst.bins.filter((bin) => !isLow(bin))));
  }
  return boxes.map(({ mean }) => mean.reduce((colour, x) => (colour << 8) | Math.round(x), 0));
}

function boxOf(bins: Bin[]): Box {
  const total = bins.reduce((sum, { weight }) => sum + weight, 0);
  const mean = [0, 1, 2].map((c) => bins.reduce((sum, { weight, rgb }) => sum + weight * rgb[c], 0) / total);
  const spreads = mean.map((m, c) => bins.reduce((sum, { weight, rgb }) => sum + weight * (rgb[c] - m) ** 2, 0));
  const spread = Math.max(...spreads);
  return { bins, mean, channel: spreads.indexOf(spread), spread };
}
