/** Figures of quantities over time, the same on the screen and in saved files. */
import { angles } from "./angles";
import type { Quaternion } from "./attitude";
import { alongBody, AXIS_SETS, type AxisSet, components } from "./components";
import { contactFigures } from "./contact-figures";
import { lengths, type Motion } from "./motion";
import { constantOf } from "./plot/arrange";
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
 * Makes all figures, with vectors along a set of axes. `principal` takes components along principal
 * axes to components in body axes; the principal axes are about the point that the body turns about.
 */
export function figuresOf(motion: Motion, principal: Principal, set: AxisSet = "body"): Figure[] {
  return makersOf(motion, principal, set).map(({ make }) => make());
}

export function makersOf(motion: Motion, principal: Principal, set: AxisSet): FigureMaker[] {
  const free = motion.torque === null && motion.wheels.length === 0;
  const along = { set, principal: principal.quaternion };
  const parts = free && set !== "space" ? shares(motion, principal, set) : null;
  const all: [id: string, make: (() => Made) | null][] = [
    ["omega", () => omega(motion, along)],
    ["pointing", motion.pointings.length > 0 ? () => pointing(motion) : null],
    ...(motion.contact ? contactFigures(motion, motion.contact).map((figure): [string, () => Made] => [figure.id, () => figure]) : []),
    ["energy", motion.contact ? null : (parts ?? (() => energy(motion)))],
    ["momentum", () => momentum(motion, along, free)],
    ["torque", motion.torque === null ? null : torque(motion, motion.torque, along)],
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

/** Axes along which the components of vectors are drawn. */
interface Along {
  set: AxisSet;
  principal: Quaternion;
}

function completed(figure: Made, motion: Motion): Figure {
  // Drifts are on a logarithmic scale, and angles do not diverge.
  const telling = figure.log || figure.id === "angles" ? motion.count : motion.telling;
  const [low, high] = extent(figure.lines.map(({ values }) => values), 0, telling - 1) ?? [0, 0];
  const ranAway = telling < motion.count ? `The motion runs away: ranges and constants are without the last ${samples(motion.count - telling)}.` : null;
  return { nothing: ROUNDING * Math.max(-low, high), ...figure, telling, aliased: motion.aliased, ...(ranAway ? { note: ranAway } : {}) };
}

function omega(motion: Motion, along: Along): Made {
  const lines = vector(motion, motion.omega, "body", along, "ω", { symbol: "|ω|", ink: "quiet" });
  return { ...plain, id: "omega", title: titled("Angular velocity", along), quantity: "ω", unit: "rad/s", lines };
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

/**
 * Returns the figure of the terms ½ iₖ ωₖ² of the kinetic energy; null along body axes that are not
 * principal axes.
 */
function shares(motion: Motion, { moments, quaternion }: Principal, set: "body" | "principal"): (() => Made) | null {
  const order = set === "body" ? alongBody(quaternion) : [0, 1, 2];
  if (order === null) return null;
  return () => {
    const { subscripts, dash, title } = AXIS_SETS[set];
    const rows = components(motion, motion.omega, "body", set, quaternion);
    const letter = set === "body" ? "I" : "i";
    const lines: Line[] = subscripts.map((subscript, k) => {
      const symbol = `½${letter}${subscript}ω${subscript}²`;
      const values = column(rows, k).map((w) => 0.5 * moments[order[k]] * w * w);
      return { symbol, label: symbol, ink: AXES[k], values, ...(dash ? { dash } : {}) };
    });
    lines.push({ symbol: "T", label: "T", ink: "omega", values: motion.kinetic, dash: [4, 4], ...balance(motion, "T") });
    return { ...plain, id: "energy", title: `Kinetic energy, ${title}`, quantity: "energy", unit: "J", lines };
  };
}

/** For a body that is not free, the constant components in space are stated whatever the axes. */
function momentum(motion: Motion, along: Along, free: boolean): Made {
  const size = { symbol: "|L|", ink: "ink", ...balance(motion, "|L|") };
  const lines = vector(motion, motion.momentum, "space", along, "L", size, true);
  const made = { ...plain, id: "momentum", quantity: "L", unit: "kg·m²/s", lines };
  const nothing = ROUNDING * largest(lengths(motion.momentum), motion.telling);
  if (!free && along.set !== "space") {
    const inSpace = vector(motion, motion.momentum, "space", { ...along, set: "space" }, "L");
    lines.push(...inSpace.filter((line) => (constantOf(line, { log: false, nothing, telling: motion.telling })?.value ?? 0) !== 0));
  }
  return { ...made, title: titled(`Angular momentum${motion.wheels.length > 0 ? ", wheels included" : ""}`, along) };
}

function torque(motion: Motion, rows: Float64Array, along: Along): () => Made {
  return () => {
    const lines = vector(motion, rows, "body", along, "N", { symbol: "|N|", ink: "quiet" });
    return { ...plain, id: "torque", title: titled("Torque", along), quantity: "N", unit: "N·m", lines };
  };
}

function titled(quantity: string, { set }: Along): string {
  return `${quantity}, ${AXIS_SETS[set].title}`;
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
export function look(k: number): Pick<Line, "ink" | "dash"> {
  const inks = [...AXES, "omega", "torque", "ink"];
  const dashed = (k + Math.floor(k / inks.length)) % 2 === 1;
  return { ink: inks[k % inks.length], ...(dashed ? { dash: [6, 3] } : {}) };
}

/**
 * Returns three components along a set of axes, and the magnitude unless it equals one of the
 * components, or always.
 */
function vector(
  motion: Motion,
  given: Float64Array,
  givenAlong: "body" | "space",
  { set, principal }: Along,
  letter: string,
  size?: Pick<Line, "symbol" | "ink" | "drift">,
  always = false,
): Line[] {
  const rows = components(motion, given, givenAlong, set, principal);
  const { subscripts, dash } = AXIS_SETS[set];
  const lines: Line[] = subscripts.map((subscript, k) => {
    const symbol = letter + subscript;
    return { symbol, label: symbol, ink: AXES[k], values: column(rows, k), ...(dash ? { dash } : {}) };
  });
  if (!size) return lines;
  const all = lengths(given);
  const nothing = ROUNDING * largest(all, motion.telling);
  const moving = lines.filter(({ values }) => values.subarray(0, motion.telling).some((v) => Math.abs(v) > nothing));
  if (always || moving.length > 1) lines.push({ label: size.symbol, values: all, dash: [4, 4], ...size });
  return lines;
}

function largest(values: Float64Array, count: number): number {
  return values.subarray(0, count).reduce((most, v) => Math.max(most, v), 0);
}

/** Returns the largest error of the balance with this name. */
function balance(motion: Motion, wanted: string): { drift?: number } {
  const found = motion.drift.find(({ name }) => name === wanted);
  return found ? { drift: found.values.subarray(0, motion.telling).reduce((most, v) => Math.max(most, Math.abs(v)), 0) } : {};
}

function samples(count: number): string {
  return count === 1 ? "sample" : `${count} samples`;
}

function column(rows: Float64Array, k: number): Float64Array {
  const out = new Float64Array(rows.length / 3);
  for (let i = 0; i < out.length; i += 1) out[i] = rows[3 * i + k];
  return out;
}
