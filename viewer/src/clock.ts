/**
 * Time that all views show. The clock is independent of the screen: the drawing loop calls
 * `advance` with the elapsed seconds, and views subscribe.
 */
export class Clock {
  /** Time of the motion, s. */
  time: number;
  playing = false;
  loop = true;
  /** Seconds of the motion in one second of real time. */
  speed: number;

  readonly #listeners: (() => void)[] = [];

  #times: Float64Array;

  /** `times` are ascending and not empty. */
  constructor(times: Float64Array, speed = 1) {
    this.#times = times;
    this.time = times[0];
    this.speed = speed;
  }

  get times(): Float64Array {
    return this.#times;
  }

  /**
   * Replaces the times by those of another motion. The clock continues from the same time if they
   * contain it.
   */
  replace(times: Float64Array): void {
    this.#times = times;
    this.time = Math.min(Math.max(this.time, this.start), this.end);
    if (this.end <= this.start) this.playing = false;
    this.#tell();
  }

  get start(): number {
    return this.#times[0];
  }

  get end(): number {
    return this.times[this.times.length - 1];
  }

  subscribe(listener: () => void): void {
    this.#listeners.push(listener);
  }

  /** Advances by real time, s. */
  advance(seconds: number): void {
    if (!this.playing) return;
    const length = this.end - this.start;
    let time = this.time + seconds * this.speed;
    if (time >= this.end) {
      if (this.loop && length > 0) {
        time = this.start + ((time - this.start) % length);
      } else {
        time = this.end;
        this.playing = false;
      }
    }
    this.time = time;
    this.#tell();
  }

  set(time: number): void {
    if (!Number.isFinite(time)) return;
    this.time = Math.min(Math.max(time, this.start), this.end);
    this.#tell();
  }

  play(): void {
    if (this.end <= this.start) return;
    if (this.time >= this.end) this.time = this.start;
    this.playing = true;
    this.#tell();
  }

  pause(): void {
    this.playing = false;
    this.#tell();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Moves to the next sample, or to the previous one for -1. */
  step(direction: 1 | -1): void {
    this.playing = false;
    let i = this.index();
    if (direction > 0) i = Math.min(i + 1, this.times.length - 1);
    // Several samples may have the same time.
    else while (i > 0 && this.times[i] >= this.time) i -= 1;
    this.set(this.times[i]);
  }

  /** Changes to the next speed of 1, 2, 5, 10, …, or to the previous one for -1. */
  changeSpeed(direction: 1 | -1): void {
    this.speed = neighbour(this.speed, direction);
    this.#tell();
  }

  setLoop(loop: boolean): void {
    this.loop = loop;
    this.#tell();
  }

  /** Returns the index of the last sample that is not later than now. */
  index(): number {
    return indexAt(this.times, this.time);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }
}

/** Returns the index of the last of ascending `times` not later than `time`; 0 if all are later. */
export function indexAt(times: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * Duration of the period on the screen, s: the middle of the range of 5 to 10 s on a logarithmic
 * scale.
 */
const PERIOD = 5 * Math.SQRT2;
/** Angular speed on the screen above which a rotation is blurred, rad/s. */
const FASTEST = 80;
/** Shortest duration of a motion on the screen, s. */
const FLASH = 2;

/**
 * Returns a speed of the clock at which the eye can follow. `period` is the period of the motion,
 * s, or null if nothing repeats. Without a period, the speed is 1 if the eye can follow the
 * rotation at `rate`, rad/s.
 */
export function watchable(rate: number, duration: number, period: number | null): number {
  const turns = rate > 0 && Number.isFinite(rate);
  if (period !== null && period > 0 && Number.isFinite(period)) {
    // A run shorter than the period is treated as a period.
    const shown = duration > 0 ? Math.min(period, duration) : period;
    return fitting(Math.min(shown / PERIOD, turns ? FASTEST / rate : Infinity));
  }
  const seen = turns ? rate : duration > 0 ? 20 / duration : 1;
  if (seen > 0.15 && seen < 30 && !(duration > 0 && duration < FLASH)) return 1;
  // A run must not pass too fast, however slowly the body turns.
  const longest = duration > 0 ? duration / PERIOD : Infinity;
  return nearest(Math.min((seen < 1 ? 1.5 : 6) / seen, longest));
}

// Returns the nearest of 1, 2, 3, 5, 10, … by ratio, less than a factor √2 away.
function fitting(value: number): number {
  const decade = 10 ** Math.floor(Math.log10(value));
  const off = (step: number): number => Math.abs(Math.log((step * decade) / value));
  const best = [1, 2, 3, 5, 10].reduce((a, b) => (off(b) < off(a) ? b : a));
  return Number((best * decade).toPrecision(1));
}

function nearest(value: number): number {
  const decade = 10 ** Math.floor(Math.log10(value));
  const mantissa = value / decade;
  return decade * (mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10);
}

/** Returns the next of 1, 2, 5, 10, … above or below. */
function neighbour(speed: number, direction: 1 | -1): number {
  const decade = 10 ** Math.floor(Math.log10(speed));
  const steps = [0.5, 1, 2, 5, 10, 20].map((step) => Number((step * decade).toPrecision(1)));
  const next = direction > 0 ? steps.find((step) => step > speed * (1 + 1e-9)) : steps.reverse().find((step) => step < speed * (1 - 1e-9));
  return next ?? speed;
}
