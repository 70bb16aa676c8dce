/** What is plotted over time: the same figures on the screen and in the files that it saves. */
import { euler313 } from "./attitude";
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
  lines: Line[];
}

/** Zero cannot stand on a log scale; it is drawn here. */
export const DRIFT_FLOOR = 1e-17;

export function figuresOf(motion: Motion): Figure[] {
  const figures: Figure[] = [omega(motion), energy(motion), momentum(motion), angles(motion)];
  if (motion.drift.length > 0) figures.push(drift(motion));
  return figures;
}

const AXES = ["axis-1", "axis-2", "axis-3"];

function omega(motion: Motion): Figure {
  const lines = ["ωx", "ωy", "ωz"].map((label, k) => ({ label, ink: AXES[k], values: column(motion.omega, k) }));
  const size = { label: "|ω|", ink: "quiet", values: lengths(motion.omega), dash: [4, 4] };
  return { ...plain, id: "omega", title: "Angular velocity, body axes", unit: "rad/s", lines: [...lines, size] };
}

function energy(motion: Motion): Figure {
  const { kinetic, potential } = motion;
  const lines: Line[] = [{ label: potential ? "kinetic" : "kinetic T", ink: "omega", values: kinetic }];
  if (potential) {
    lines.push({ label: "potential", ink: "torque", values: potential, dash: [6, 3] });
    lines.push({ label: "total", ink: "ink", values: kinetic.map((t, i) => t + potential[i]) });
  }
  return { ...plain, id: "energy", title: "Energy", unit: "J", lines };
}

function momentum(motion: Motion): Figure {
  const lines: Line[] = [{ label: "|L|", ink: "ink", values: lengths(motion.momentum) }];
  if (motion.torque) {
    ["LX", "LY", "LZ"].forEach((label, k) => {
      lines.push({ label, ink: AXES[k], values: column(motion.momentum, k), dash: [6, 3] });
    });
  }
  return { ...plain, id: "momentum", title: motion.torque ? "Angular momentum, space axes" : "Angular momentum", unit: "kg·m²/s", lines };
}

function angles(motion: Motion): Figure {
  const rows = Array.from({ length: motion.count }, (_, i) => euler313(motion.attitudeOf(i)));
  const lines = ["φ precession", "θ nutation", "ψ spin"].map((label, k) => ({
    label,
    ink: AXES[k],
    values: Float64Array.from(rows, (row) => (row[k] * 180) / Math.PI),
  }));
  return { ...plain, id: "angles", title: "Attitude, Euler angles 3-1-3", unit: "°", wraps: true, lines };
}

function drift(motion: Motion): Figure {
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

/** The range of an axis: with room around the values, and never so small that rounding errors fill the plot. */
export function rangeOf(figure: Figure, first = 0, last = Infinity): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const { values } of figure.lines) {
    for (let i = first; i <= Math.min(last, values.length - 1); i += 1) {
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
  let step = decade * (mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 10);
  if (degrees) step = [15, 30, 45, 90, 180].find((d) => d >= rough) ?? 180;
  const values: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) values.push(k * step);
  return { values, step };
}
