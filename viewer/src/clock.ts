/**
 * The time that all views show. It knows no screen: whoever draws calls `advance` with the seconds that passed, and whoever shows
 * something subscribes.
 */
export class Clock {
  /** s of the motion */
  time: number;
  playing = false;
  loop = true;
  /** Seconds of the motion in one second. */
  speed: number;

  readonly #listeners: (() => void)[] = [];

  #times: Float64Array;

  /** `times` ascend; there is at least one. */
  constructor(times: Float64Array, speed = 1) {
    this.#times = times;
    this.time = times[0];
    this.speed = speed;
  }

  get times(): Float64Array {
    return this.#times;
  }

  /** Another motion's times: it goes on as it went, from the same time if they contain it. */
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

  /** Real time has passed, in s. */
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

  /** To the next sample, or with -1 to the one before. */
  step(direction: 1 | -1): void {
    this.playing = false;
    let i = this.index();
    if (direction > 0) i = Math.min(i + 1, this.times.length - 1);
    // Samples may share a time.
    else while (i > 0 && this.times[i] >= this.time) i -= 1;
    this.set(this.times[i]);
  }

  /** To the next speed of 1, 2, 5, 10, … or with -1 to the one before. */
  changeSpeed(direction: 1 | -1): void {
    this.speed = neighbour(this.speed, direction);
    this.#tell();
  }

  setLoop(loop: boolean): void {
    this.loop = loop;
    this.#tell();
  }

  /** The last sample that is not later than now. */
  index(): number {
    return indexAt(this.times, this.time);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }
}

/** The last of ascending `times` that is not later than `time`; 0 if all are. */
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

/** On the screen the period that the eye is to follow takes 5 to 10 s: in the middle of them, as speeds go by factors. */
const PERIOD = 5 * Math.SQRT2;
/** Of the screen, rad/s: what turns faster is a blur. */
const FASTEST = 80;
/** s: what takes less flashes by. */
const FLASH = 2;

/**
 * A speed at which the eye can follow. `period`: what the motion shows takes so long, s; null where nothing repeats, and then it is 1 if
 * the eye can follow the real one, where the body turns by `rate` rad/s.
 */
export function watchable(rate: number, duration: number, period: number | null): number {
  const turns = rate > 0 && Number.isFinite(rate);
  if (period !== null && period > 0 && Number.isFinite(period)) {
    // A run that is shorter than the period is seen as long.
    const shown = duration > 0 ? Math.min(period, duration) : period;
    return fitting(Math.min(shown / PERIOD, turns ? FASTEST / rate : Infinity));
  }
  const seen = turns ? rate : duration > 0 ? 20 / duration : 1;
  if (seen > 0.15 && seen < 30 && !(duration > 0 && duration < FLASH)) return 1;
  // However slow the body is, the run does not flash by.
  const longest = duration > 0 ? duration / PERIOD : Infinity;
  return nearest(Math.min((seen < 1 ? 1.5 : 6) / seen, longest));
}

// The nearest by factors of 1, 2, 3, 5, 10, …: less than √2 away.
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

/** The next of 1, 2, 5, 10, … above or below. */
function neighbour(speed: number, direction: 1 | -1): number {
  const decade = 10 ** Math.floor(Math.log10(speed));
  const steps = [0.5, 1, 2, 5, 10, 20].map((step) => Number((step * decade).toPrecision(1)));
  const next = direction > 0 ? steps.find((step) => step > speed * (1 + 1e-9)) : steps.reverse().find((step) => step < speed * (1 - 1e-9));
  return next ?? speed;
}
