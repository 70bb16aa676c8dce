/** What is plotted over time: the same figures on the screen and in the files that it saves. */
import { euler313, type Vector } from "./attitude";
import { at, lengths, type Motion } from "./motion";

export interface Line {
  label: string;
  /** A custom property of theme.css without its dashes. */
  ink: string;
  values: Float64Array;
  dash?: number[];
}

export interface Figure {
  id: string;
  title: string;
  unit: string;
  log: boolean;
  /** The values are angles in (−180°, 180°]: a line is broken where it leaps. */
  wraps: boolean;
  /** So many samples say how large the values are: a motion that runs away leaves the plot at its end. */
  telling: number;
  lines: Line[];
}

/** Zero cannot stand on a log scale; it is drawn here. */
export const DRIFT_FLOOR = 1e-17;

/** Near an end of θ sin θ is below this: there only the sum of φ and ψ exists, or their difference. */
const NEAR = 0.02;

/** Where sin θ is below this, φ and ψ are rounding. */
const NOTHING = 1e-9;

/** A turn of φ or ψ from a sample to the next that is not followed near an end of θ, rad. */
const LEAP = 1;

/** An angle in degrees that changes by more from a sample to the next leaps. */
export const HALF_TURN = 150;

export function figuresOf(motion: Motion): Figure[] {
  const made = [omega(motion), energy(motion), momentum(motion), ...torque(motion), ...wheels(motion), angles(motion)];
  if (motion.drift.length > 0) made.push(drift(motion));
  return made.map((figure) => {
    const lasts = motion.complete || figure.log || figure.wraps;
    return { ...figure, telling: lasts ? motion.count : telling(figure.lines) };
  });
}

type Made = Omit<Figure, "telling">;

const AXES = ["axis-1", "axis-2", "axis-3"];

function omega(motion: Motion): Made {
  const lines = ["ωx", "ωy", "ωz"].map((label, k) => ({ label, ink: AXES[k], values: column(motion.omega, k) }));
  const size = { label: "|ω|", ink: "quiet", values: lengths(motion.omega), dash: [4, 4] };
  return { ...plain, id: "omega", title: "Angular velocity, body axes", unit: "rad/s", lines: [...lines, size] };
}

function energy(motion: Motion): Made {
  const { kinetic, potential } = motion;
  const lines: Line[] = [{ label: potential ? "kinetic" : "kinetic T", ink: "omega", values: kinetic }];
  if (potential) {
    lines.push({ label: "potential", ink: "torque", values: potential, dash: [6, 3] });
    lines.push({ label: "total", ink: "ink", values: kinetic.map((t, i) => t + potential[i]) });
  }
  return { ...plain, id: "energy", title: "Energy", unit: "J", lines };
}

function momentum(motion: Motion): Made {
  const lines: Line[] = [{ label: "|L|", ink: "ink", values: lengths(motion.momentum) }];
  const parts = motion.torque !== null || motion.wheels.length > 0;
  if (parts) {
    ["LX", "LY", "LZ"].forEach((label, k) => {
      lines.push({ label, ink: AXES[k], values: column(motion.momentum, k), dash: [6, 3] });
    });
  }
  const whose = motion.wheels.length > 0 ? ", wheels included" : parts ? ", space axes" : "";
  return { ...plain, id: "momentum", title: `Angular momentum${whose}`, unit: "kg·m²/s", lines };
}

/** None where no torque acts. */
function torque({ torque }: Motion): Made[] {
  if (torque === null) return [];
  const lines = ["Nx", "Ny", "Nz"].map((label, k) => ({ label, ink: AXES[k], values: column(torque, k) }));
  const size = { label: "|N|", ink: "quiet", values: lengths(torque), dash: [4, 4] };
  return [{ ...plain, id: "torque", title: "Torque, body axes", unit: "N·m", lines: [...lines, size] }];
}

/** Momenta and speeds; none without a wheel. */
function wheels({ wheels }: Motion): Made[] {
  const line = (label: string, values: Float64Array, k: number): Line => ({ label, ink: AXES[k % 3], values });
  const h = wheels.map(({ name, momentum }, k) => line(name, momentum, k));
  const speeds = wheels.flatMap(({ name, speed }, k) => (speed ? [line(name, speed, k)] : []));
  const made: Made[] = [];
  if (h.length > 0) made.push({ ...plain, id: "wheels", title: "Wheels, momentum along their axes", unit: "kg·m²/s", lines: h });
  if (speeds.length > 0) made.push({ ...plain, id: "wheel-speeds", title: "Wheels, speed in the body", unit: "rad/s", lines: speeds });
  return made;
}

function angles(motion: Motion): Made {
  const degrees = (angle: number): number => (angle * 180) / Math.PI;
  const rows = Array.from({ length: motion.count }, (_, i) => euler313(motion.attitudeOf(i)));
  const both = told(rows);
  // At the start alone nothing is missed.
  const missed = rows.map(([, theta], i) => i > 0 && !both[i] && theta < Math.PI / 2);
  const [up, down] = [missed.includes(true), both.some((has, i) => i > 0 && !has && !missed[i])];
  const line = (label: string, ink: string, value: (row: Vector, i: number) => number, dash?: number[]): Line => ({
    label,
    ink,
    values: Float64Array.from(rows, (row, i) => degrees(value(row, i))),
    ...(dash ? { dash } : {}),
  });
  const one = (k: number) => (row: Vector, i: number): number => (both[i] ? row[k] : Number.NaN);
  const lines = [
    line("φ precession", AXES[0], one(0)),
    line("θ nutation", AXES[1], (row) => row[1]),
    line("ψ spin", AXES[2], one(2)),
  ];
  // (w, x, y, z) = (cos ½θ cos ½(φ + ψ), sin ½θ cos ½(φ − ψ), sin ½θ sin ½(φ − ψ), cos ½θ sin ½(φ + ψ))
  const turn = (y: number, x: number): number => {
    const angle = 2 * Math.atan2(y, x);
    return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  };
  const sum = (row: Vector, i: number): number => {
    const [w, , , z] = motion.attitudeOf(i);
    return row[1] > Math.PI - NEAR ? Number.NaN : turn(z, w);
  };
  const difference = (row: Vector, i: number): number => {
    const [, x, y] = motion.attitudeOf(i);
    return row[1] < NEAR ? Number.NaN : turn(y, x);
  };
  if (up) lines.push(line("φ + ψ", "ink", sum));
  if (down) lines.push(line("φ − ψ", "quiet", difference, [6, 3]));
  const shown = lines.filter(({ values }) => values.some(Number.isFinite));
  return { ...plain, id: "angles", title: "Attitude, Euler angles 3-1-3", unit: "°", wraps: true, lines: shown };
}

/** Whether φ and ψ can be told: not at an end of θ, and not near one where samples do not follow their half turn. */
function told(rows: Vector[]): boolean[] {
  const has = rows.map(([, theta]) => Math.sin(theta) >= NOTHING);
  const near = rows.map(([, theta]) => Math.sin(theta) < NEAR);
  const leap = (i: number, k: number): number => {
    const turn = rows[i][k] - rows[i - 1][k];
    return Math.abs(turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
  };
  for (let from = 0; from < rows.length; ) {
    let to = from + 1;
    let followed = true;
    for (; to < rows.length && near[to] === near[from]; to += 1) {
      if (has[to] && has[to - 1] && Math.max(leap(to, 0), leap(to, 2)) >= LEAP) followed = false;
    }
    if (near[from] && !followed) has.fill(false, from, to);
    from = to;
  }
  return has;
}

function drift(motion: Motion): Made {
  const inks = ["omega", "ink", "torque", "axis-1", "axis-3", "axis-2"];
  const lines = motion.drift.map(({ name, values }, k) => ({
    label: name,
    ink: inks[k % inks.length],
    values: values.map((v) => Math.max(Math.abs(v), DRIFT_FLOOR)),
  }));
  return { ...plain, id: "drift", title: "Drift of what should stay", unit: "relative; 0 is drawn at 10⁻¹⁷", log: true, lines };
}

const plain = { log: false, wraps: false };

function column(rows: Float64Array, k: number): Float64Array {
  return Float64Array.from({ length: rows.length / 3 }, (_, i) => at(rows, i)[k]);
}

/** Without the last samples of a run-away, each of which is far beyond all before it. */
function telling(lines: Line[]): number {
  const count = lines[0]?.values.length ?? 0;
  const soFar = new Float64Array(count);
  for (let i = 0; i < count; i += 1) {
    soFar[i] = Math.max(i > 0 ? soFar[i - 1] : 0, ...lines.map(({ values }) => Math.abs(values[i])));
  }
  let last = count;
  while (last > Math.ceil(count / 2) && last > 1 && soFar[last - 1] > 4 * soFar[last - 2]) last -= 1;
  return last;
}

/** True if nothing but zeros is drawn: its axis needs no other mark. */
export function isZero(figure: Figure): boolean {
  return !figure.log && !figure.wraps && figure.lines.every(({ values }) => values.every((v) => v === 0));
}

/** The range of an axis: with room around the values, and never so small that rounding errors fill the plot. */
export function rangeOf(figure: Figure, first = 0, last = Infinity): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const { values } of figure.lines) {
    for (let i = first; i <= Math.min(last, values.length - 1, figure.telling - 1); i += 1) {
      if (!Number.isFinite(values[i])) continue;
      low = Math.min(low, values[i]);
      high = Math.max(high, values[i]);
    }
  }
  if (!(low <= high)) return [0, 1];
  if (figure.log) return [10 ** Math.floor(Math.log10(low)), 10 ** Math.max(Math.ceil(Math.log10(high)), Math.floor(Math.log10(low)) + 1)];
  if (figure.wraps) return [-180, 180];
  const size = Math.max(Math.abs(low), Math.abs(high));
  // What is constant is drawn as a constant: changes below a thousandth belong to the drift plot.
  const room = high - low < 1e-3 * size ? 0.1 * size : 0.06 * (high - low);
  return room === 0 ? [-1, 1] : [low - room, high + room];
}

/** Powers of ten between two of them, about `count`. */
export function decades(low: number, high: number, count: number): number[] {
  const [from, to] = [Math.round(Math.log10(low)), Math.round(Math.log10(high))];
  const every = Math.max(Math.ceil((to - from) / Math.max(count, 1)), 1);
  const out: number[] = [];
  for (let k = from; k <= to; k += every) out.push(10 ** k);
  return out;
}

/** Steps of 1, 2 or 5 times a power of ten, about `count` of them; of 30° multiples for angles. */
export function ticks(low: number, high: number, count: number, degrees = false): { values: number[]; step: number } {
  const rough = (high - low) / Math.max(count, 1);
  const decade = 10 ** Math.floor(Math.log10(rough));
  const mantissa = rough / decade;
  // The nearest as a ratio: between two of them the border is their geometric mean.
  let step = decade * (mantissa ** 2 < 2 ? 1 : mantissa ** 2 < 10 ? 2 : mantissa ** 2 < 50 ? 5 : 10);
  if (degrees) step = [15, 30, 45, 90, 180].find((d) => d >= rough) ?? 180;
  const values: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) values.push(k * step);
  return { values, step };
}
