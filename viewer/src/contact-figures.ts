/**
 * Figures of a body on the ground: energy, contact forces, slip at the contact point, and height.
 */
import type { Contact } from "./contact";
import type { Motion } from "./motion";
import type { Line } from "./plot/lines";

export interface ContactFigure {
  id: string;
  title: string;
  quantity: string;
  unit: string;
  log: false;
  lines: Line[];
}

/** Returns the figures that replace the energy figure of other motions. */
export function contactFigures(motion: Motion, contact: Contact): ContactFigure[] {
  const figures = [energy(motion, contact), force(contact)];
  if (contact.slip.some((speed) => speed > 0)) {
    figures.push(of("slip", "Slip of the point of contact", "v", "m/s", [{ symbol: "v", label: "v", ink: "torque", values: contact.slip }]));
  }
  const { up, center } = contact;
  if (up) {
    const values = Float64Array.from({ length: motion.count }, (_, i) => center[3 * i] * up[0] + center[3 * i + 1] * up[1] + center[3 * i + 2] * up[2]);
    figures.push(of("height", "Height of the centre of mass", "h", "m", [{ symbol: "h", label: "h", ink: "axis-3", values }]));
  }
  return figures;
}

function energy({ kinetic, potential, drift }: Motion, { frictionWork, groundWork }: Contact): ContactFigure {
  const u = potential ?? new Float64Array(kinetic.length);
  const lines: Line[] = [
    { symbol: "T", label: "T kinetic", ink: "omega", values: kinetic },
    { symbol: "U", label: "U potential", ink: "torque", values: u, dash: [6, 3] },
    { symbol: "T + U", label: "T + U", ink: "ink", values: kinetic.map((t, i) => t + u[i]) },
  ];
  const works: [string, Float64Array, string][] = [
    ["work of friction", frictionWork, "axis-2"],
    ["work of the ground", groundWork, "axis-1"],
  ];
  const done = works.filter(([, values]) => values.some((work) => work !== 0));
  lines.push(...done.map(([label, values, ink]): Line => ({ symbol: label, label, ink, values, dash: [2, 3] })));
  // Without work, T + U itself is constant.
  const largest = drift[0]?.values.reduce((most, d) => Math.max(most, Math.abs(d)), 0);
  if (done.length === 0 && largest !== undefined) lines[2].drift = largest;
  return of("energy", "Energy", "energy", "J", lines);
}

function force({ normalForce, friction }: Contact): ContactFigure {
  const lines: Line[] = [{ symbol: "N", label: "N normal force", ink: "axis-1", values: normalForce }];
  if (friction.some((force) => force > 0)) lines.push({ symbol: "F", label: "F friction", ink: "axis-2", values: friction, dash: [6, 3] });
  return of("contact-force", "Force of the ground", "force", "N", lines);
}

function of(id: string, title: string, quantity: string, unit: string, lines: Line[]): ContactFigure {
  return { id, title, quantity, unit, log: false, lines };
}
