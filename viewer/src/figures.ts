/** Figures of quantities over time, the same on the screen and in saved files. */
import { angles } from "./angles";
import { inverse, type Quaternion, rotate, type Vector, writeRotated } from "./attitude";
import { contactFigures } from "./contact-figures";
import { lengths, type Motion } from "./motion";
import type { Figure, Line } from "./plot/lines";
import { extent } from "./plot/scale";

/** Rounding threshold relative to the largest line: smaller values count as zero. */
const ROUNDING = 1e-12;

/** Name of the only drift that is not relative. */
const ATTITUDE_ERROR = "attitude error, rad (estimate)";

const AXES = ["axis-1", "axis-2", "axis-3"];

type Made = Omit<Figure, "telling" | "nothing" | "aliased"> & Partial<Pick<Figure, "nothing">>;

/** A figure that is made when it is shown. */
export interface FigureMaker {
  id: string;
  make: () => Figure;
}

/**
 * Makes all figures. `principal` takes components along principal axes to components in body axes;
 * the principal axes are about the point that the body turns about.
 */
export function figuresOf(motion: Motion, principal: Principal): Figure[] {
  return makersOf(motion, principal).map(({ make }) => make());
}

export function makersOf(motion: Motion, principal: Principal): FigureMaker[] {
  const free = motion.torque === null && motion.wheels.length === 0;
  const all: [id: string, make: (() => Made) | null][] = [
    ["omega", () => omega(motion)],
    ["omega-principal", isAlongBody(principal.quaternion) ? null : () => omegaAlongPrincipal(motion, principal.quaternion)],
    ["pointing", motion.pointings.length > 0 ? () => pointing(motion) : null],
    ...(motion.contact ? contactFigures(motion, motion.contact).map((figure): [string, () => Made] => [figure.id, () => figure]) : []),
    ["energy", motion.contact ? null : () => (free ? shares(motion, principal) : energy(motion))],
    ["momentum", () => (free ? momentumInBody(motion, principal.quaternion) : momentumInSpace(motion))],
    ["torque", motion.torque === null ? null : torque(motion, motion.torque)],
    ["wheels", motion.wheels.length > 0 ? () => wheelMomenta(motion) : null],
    ["wheel-speeds", motion.wheels.some(({ speed }) => speed) ? () => wheelSpeeds(motion) : null],
    ["angles", () => angles(motion)],
    ["drift", motion.drift.some(isRelative) ? () => drift(motion) : null],
    ["attitude-error", motion.drift.some((one) => !isRelative(one)) ? () => attitudeError(motion) : null],
  ];
  return all.flatMap(([id, make]) => (make ? [{ id, make: (): Figure => completed(make(), motion) }] : []));
}

interface Principal {
  moments: number[];
  quaternion: Quaternion;
}

function completed(figure: Made, motion: Motion): Figure {
  // Drifts are on a logarithmic scale, and angles do not diverge.
  const telling = figure.log || figure.id === "angles" ? motion.count : motion.telling;
  const [low, high] = extent(figure.lines.map(({ values }) => values), 0, telling - 1) ?? [0, 0];
  const ranAway = telling < motion.count ? `The motion runs away: ranges and constants are without the last ${samples(motion.count - telling)}.` : null;
  return { nothing: ROUNDING * Math.max(-low, high), ...figure, telling, aliased: motion.aliased, ...(ranAway ? { note: ranAway } : {}) };
}

function omega(motion: Motion): Made {
  const lines = vector(motion, motion.omega, ["ωx", "ωy", "ωz"], "|ω|");
  return { ...plain, id: "omega", title: "Angular velocity, body axes", quantity: "ω", unit: "rad/s", lines };
}

/**
 * Returns true if the principal axes are along the body axes. Lines along both would then be the
 * same.
 */
function isAlongBody(principal: Quaternion): boolean {
  const axes = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as Vector[]).map((axis) => rotate(principal, axis));
  return axes.every((axis) => Math.max(...axis.map(Math.abs)) > 1 - 1e-12);
}

function omegaAlongPrincipal(motion: Motion, principal: Quaternion): Made {
  const rows = rotated(motion.omega, inverse(principal));
  const lines = vector(motion, rows, ["ω₁", "ω₂", "ω₃"]);
  return { ...plain, id: "omega-principal", title: "Angular velocity, principal axes", quantity: "ω", unit: "rad/s", lines };
}

function pointing({ pointings }: Motion): Made {
  const lines = pointings.map(({ name, values }, k): Line => ({
    symbol: pointings.length === 1 ? "angle" : name,
    label: name,
    values: values.map((angle) => (angle * 180) / Math.PI),
    ...look(k),
  }));
  return { ...plain, id: "pointing", title: "Where the body points", quantity: "angle", unit: "°", lines, nothing: 1e-7 };
}

function energy(motion: Motion): Made {
  const { kinetic, potential, work } = motion;
  const lines: Line[] = [{ symbol: "T", label: "T kinetic", ink: "omega", values: kinetic }];
  if (potential) {
    const total = kinetic.map((t, i) => t + potential[i]);
    lines.push({ symbol: "U", label: "U potential", ink: "torque", values: potential, dash: [6, 3] });
    lines.push({ symbol: "T + U", label: "T + U", ink: "ink", values: total, ...balance(motion, "T + U") });
  }
  if (work) lines.push({ symbol: "work", label: work.name, ink: "torque", values: work.values, dash: [6, 3] });
  return { ...plain, id: "energy", title: "Energy", quantity: "energy", unit: "J", lines };
}

/** Returns the terms ½ iₖ ωₖ² of the kinetic energy along the principal axes. */
function shares(motion: Motion, { moments, quaternion }: { moments: number[]; quaternion: Quaternion }): Made {
  const rows = rotated(motion.omega, inverse(quaternion));
  const lines: Line[] = ["½i₁ω₁²", "½i₂ω₂²", "½i₃ω₃²"].map((symbol, k) => {
    const values = column(rows, k).map((w) => 0.5 * moments[k] * w * w);
    return { symbol, label: symbol, ink: AXES[k], values };
  });
  lines.push({ symbol: "T", label: "T", ink: "omega", values: motion.kinetic, dash: [4, 4], ...balance(motion, "T") });
  return { ...plain, id: "energy", title: "Kinetic energy, principal axes", quantity: "energy", unit: "J", lines };
}

function momentumInSpace(motion: Motion): Made {
  const size = { symbol: "|L|", label: "|L|", ink: "ink", values: lengths(motion.momentum), ...balance(motion, "|L|") };
  const lines = [size, ...vector(motion, motion.momentum, ["LX", "LY", "LZ"]).map((line) => ({ ...line, dash: [6, 3] }))];
  const title = `Angular momentum${motion.wheels.length > 0 ? ", wheels included" : ", space axes"}`;
  return { ...plain, id: "momentum", title, quantity: "L", unit: "kg·m²/s", lines };
}

/** Returns L in the body. For a free body, L is constant in space, but moves in the body. */
function momentumInBody(motion: Motion, principal: Quaternion): Made {
  const body = rotated(motion.momentum, inverses(motion.attitude));
  const lines = vector(motion, rotated(body, inverse(principal)), ["L₁", "L₂", "L₃"]);
  lines.push({ symbol: "|L|", label: "|L|", ink: "ink", values: lengths(motion.momentum), dash: [4, 4], ...balance(motion, "|L|") });
  return { ...plain, id: "momentum", title: "Angular momentum, principal axes", quantity: "L", unit: "kg·m²/s", lines };
}

function torque(motion: Motion, rows: Float64Array): () => Made {
  return () => {
    const lines = vector(motion, rows, ["Nx", "Ny", "Nz"], "|N|");
    return { ...plain, id: "torque", title: "Torque, body axes", quantity: "N", unit: "N·m", lines };
  };
}

function wheelMomenta({ wheels }: Motion): Made {
  const lines = wheels.map(({ name, momentum }, k) => wheelLine("h", name, momentum, k, wheels.length));
  return { ...plain, id: "wheels", title: "Wheels, momentum along their axes", quantity: "h", unit: "kg·m²/s", lines };
}

function wheelSpeeds({ wheels }: Motion): Made {
  const lines = wheels.flatMap(({ name, speed }, k) => (speed ? [wheelLine("Ω", name, speed, k, wheels.length)] : []));
  return { ...plain, id: "wheel-speeds", title: "Wheels, speed in the body", quantity: "Ω", unit: "rad/s", lines };
}

function wheelLine(symbol: string, name: string, values: Float64Array, k: number, of: number): Line {
  return { symbol: of > 1 ? `${symbol} of ${name}` : symbol, label: name, values, ...look(k) };
}

const isRelative = ({ name }: { name: string }): boolean => name !== ATTITUDE_ERROR;

const DOTS = "A dot for each sample, a line for the largest so far.";

function drift(motion: Motion): Made {
  const inks = ["omega", "ink", "torque", "axis-1", "axis-3", "axis-2"];
  const lines = motion.drift.filter(isRelative).map(({ name, values }, k) => ({
    symbol: name,
    label: name,
    ink: inks[k % inks.length],
    values: values.map(Math.abs),
  }));
  return { id: "drift", title: "Drift of what should stay", quantity: "drift", unit: "relative", log: true, lines, note: DOTS };
}

function attitudeError(motion: Motion): Made {
  const errors = motion.drift.filter((one) => !isRelative(one));
  const lines = errors.map(({ values }): Line => ({ symbol: "the attitude", label: "attitude", ink: "ink", values: values.map(Math.abs) }));
  return { id: "attitude-error", title: "Estimated error of the attitude", quantity: "error", unit: "rad", log: true, lines, note: DOTS };
}

const plain = { log: false };

/** Returns the style of the k-th of lines without a style of their own: twelve different ones. */
function look(k: number): Pick<Line, "ink" | "dash"> {
  const inks = [...AXES, "omega", "torque", "ink"];
  const dashed = (k + Math.floor(k / inks.length)) % 2 === 1;
  return { ink: inks[k % inks.length], ...(dashed ? { dash: [6, 3] } : {}) };
}

/** Returns three components, and the magnitude unless it equals one of the components. */
function vector({ telling }: Motion, rows: Float64Array, symbols: string[], size?: string): Line[] {
  const lines: Line[] = symbols.map((symbol, k) => ({ symbol, label: symbol, ink: AXES[k], values: column(rows, k) }));
  const all = lengths(rows);
  const nothing = ROUNDING * all.subarray(0, telling).reduce((most, v) => Math.max(most, v), 0);
  const moving = lines.filter(({ values }) => values.subarray(0, telling).some((v) => Math.abs(v) > nothing));
  if (size && moving.length > 1) lines.push({ symbol: size, label: size, ink: "quiet", values: all, dash: [4, 4] });
  return lines;
}

/** Returns the largest error of the balance with this name. */
function balance(motion: Motion, wanted: string): { drift?: number } {
  const found = motion.drift.find(({ name }) => name === wanted);
  return found ? { drift: found.values.subarray(0, motion.telling).reduce((most, v) => Math.max(most, Math.abs(v)), 0) } : {};
}

function samples(count: number): string {
  return count === 1 ? "sample" : `${count} samples`;
}

/** Rotates rows of three, all by one rotation or each by its own. */
function rotated(rows: Float64Array, by: ArrayLike<number>): Float64Array {
  const out = new Float64Array(rows.length);
  const step = by.length === 4 ? 0 : 4;
  for (let i = 0; 3 * i < rows.length; i += 1) writeRotated(by, step * i, rows, 3 * i, out, 3 * i);
  return out;
}

function inverses(attitudes: Float64Array): Float64Array {
  return attitudes.map((c, i) => (i % 4 === 0 ? c : -c));
}

function column(rows: Float64Array, k: number): Float64Array {
  const out = new Float64Array(rows.length / 3);
  for (let i = 0; i < out.length; i += 1) out[i] = rows[3 * i + k];
  return out;
}
