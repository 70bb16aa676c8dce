/** Bands behind the curves for sliding and flying; rolling has none. */
import type { Phase } from "../contact";

export interface Band {
  from: number;
  to: number;
  /** Name of a custom property of theme.css without its dashes. */
  ink: string;
}

/** Opacity of the ink over the paper. */
export const STRENGTH = 0.13;

const INKS: Record<string, string> = { sliding: "torque", flying: "axis-1" };

export function bandsOf(phases: readonly Phase[]): Band[] {
  return phases.flatMap(({ name, from, to }) => (INKS[name] ? [{ from, to, ink: INKS[name] }] : []));
}

export interface PhaseWords {
  ink: string | null;
  text: string;
}

/**
 * Describes each phase once: "sliding until t = 1.2 s", "rolling: 3 times, 4.1 s in all". `say`
 * formats a time with its unit.
 */
export function words(phases: readonly Phase[], say: (seconds: number) => string): PhaseWords[] {
  return [...new Set(phases.map(({ name }) => name))].map((name) => {
    const own = phases.filter((phase) => phase.name === name);
    const ink = INKS[name] ?? null;
    if (own.length === phases.length) return { ink, text: `${name} throughout` };
    if (own.length === 1) return { ink, text: `${name} from ${say(own[0].from)} to ${say(own[0].to)}` };
    return { ink, text: `${name}: ${own.length} times, ${say(own.reduce((sum, { from, to }) => sum + to - from, 0))} in all` };
  });
}
