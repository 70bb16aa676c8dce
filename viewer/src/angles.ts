/**
 * Euler angles over time. φ and ψ are drawn continuously, not reduced to −180° … 180°. At θ = 0
 * only φ + ψ is defined, and at 180° only φ − ψ. Near these angles, if samples do not resolve φ and
 * ψ, the sum or the difference is drawn too.
 */
import { euler313, type Vector } from "./attitude";
import { at, length, type Motion } from "./motion";
import type { Figure, Line } from "./plot/lines";

/** Limit of sin θ, below which only φ + ψ or φ − ψ may be resolved. */
const NEAR = 0.02;

/** Limit of sin θ, below which φ and ψ are rounding errors. */
const NOTHING = 1e-9;

/** Largest resolved change of φ or ψ between samples near θ = 0 or 180°, rad. */
const LEAP = 1;

/** Change between samples that counts as the half turn of φ and ψ when θ passes 0 or 180°, °. */
const HALF_TURN = 150;

/** Largest rotation of the body between samples for which the angles are resolved, rad. */
const FOLLOWED = Math.PI / 2;

export function angles(motion: Motion): Omit<Figure, "telling" | "aliased"> {
  const rows = Array.from({ length: motion.count }, (_, i) => euler313(motion.attitudeOf(i)));
  const followed = rows.map((_, i) => i > 0 && turn(motion, i) <= FOLLOWED);
  const both = told(rows);
  // Nothing is missing if only the start is affected.
  const missed = rows.map(([, theta], i) => i > 0 && !both[i] && theta < Math.PI / 2);
  const [up, down] = [missed.includes(true), both.some((has, i) => i > 0 && !has && !missed[i])];
  const inks = ["axis-1", "axis-2", "axis-3"];
  const line = (symbol: string, label: string, ink: string, value: (row: Vector, i: number) => number, dash?: number[]): Line => ({
    symbol,
    label,
    ink,
    ...goingOn(Float64Array.from(rows, value), followed),
    ...(dash ? { dash } : {}),
  });
  const one = (k: number) => (row: Vector, i: number): number => (both[i] ? row[k] : Number.NaN);
  const theta = Float64Array.from(rows, (row) => degrees(row[1]));
  const lines: Line[] = [
    { symbol: "θ", label: "θ nutation", ink: inks[1], values: theta, alone: true },
    line("φ", "φ precession", inks[0], one(0)),
    line("ψ", "ψ spin", inks[2], one(2)),
  ];
  // (w, x, y, z) = (cos ½θ cos ½(φ + ψ), sin ½θ cos ½(φ − ψ), sin ½θ sin ½(φ − ψ), cos ½θ sin ½(φ + ψ))
  const sum = (row: Vector, i: number): number => {
    const [w, , , z] = motion.attitudeOf(i);
    return row[1] > Math.PI - NEAR ? Number.NaN : 2 * Math.atan2(z, w);
  };
  const difference = (row: Vector, i: number): number => {
    const [, x, y] = motion.attitudeOf(i);
    return row[1] < NEAR ? Number.NaN : 2 * Math.atan2(y, x);
  };
  if (up) lines.push(line("φ + ψ", "φ + ψ", "ink", sum));
  if (down) lines.push(line("φ − ψ", "φ − ψ", "quiet", difference, [6, 3]));
  const shown = lines.filter(({ values }) => values.some(Number.isFinite));
  const gaps = followed.some((follows, i) => i > 0 && !follows);
  return {
    id: "angles",
    title: "Attitude, Euler angles 3-1-3",
    quantity: "angle",
    unit: "°",
    log: false,
    nothing: degrees(NOTHING),
    lines: shown,
    ...(gaps ? { note: "Where the body turns by more than 90° from a sample to the next, φ and ψ cannot be followed and are left out." } : {}),
  };
}

/** Rotation |ω| Δt from the previous sample to sample i, rad. */
function turn(motion: Motion, i: number): number {
  const rate = Math.max(length(at(motion.omega, i - 1)), length(at(motion.omega, i)));
  return (motion.times[i] - motion.times[i - 1]) * rate;
}

/**
 * Unwraps angles, rad, given up to whole turns, to continuous ones, °; after each gap they begin in
 * (−180°, 180°].
 */
function goingOn(raw: Float64Array, followed: readonly boolean[]): Pick<Line, "values" | "starts"> {
  const values = new Float64Array(raw.length).fill(Number.NaN);
  const starts = new Uint8Array(raw.length);
  const near = (angle: number, place: number): number => angle - 360 * Math.round((angle - place) / 360);
  raw.forEach((angle, i) => {
    if (!Number.isFinite(angle)) return;
    const before = i > 0 && followed[i] ? values[i - 1] : Number.NaN;
    const next = near(degrees(angle), before);
    starts[i] = Math.abs(next - before) < HALF_TURN ? 0 : 1;
    values[i] = starts[i] === 0 ? next : near(degrees(angle), 0);
  });
  // A sample without a line to another one is dropped.
  for (let i = 0; i < values.length; i += 1) {
    const alone = starts[i] === 1 && (i + 1 >= values.length || starts[i + 1] === 1 || !Number.isFinite(values[i + 1]));
    if (alone && values.length > 1) values[i] = Number.NaN;
  }
  return { values, starts };
}

/**
 * Returns for each sample whether φ and ψ are resolved: not at θ = 0 or 180°, and not near these if
 * samples do not resolve their half turn.
 */
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

function degrees(angle: number): number {
  return (angle * 180) / Math.PI;
}
