/**
 * Torques that can be added to a scenario, with a size that has a visible effect on this body
 * during its run.
 */
import type { PageData } from "../data";
import { element } from "../dom";
import type { Motion } from "../motion";
import type { Session } from "./session";

/** Data from which the sizes are derived. */
interface Numbers {
  page: PageData;
  motion: Motion;
}

interface Addable {
  label: string;
  /** Name. A torque without one cannot be switched off. */
  name: string;
  text: (sizes: Sizes) => string;
  /** Returns null if the torque can be added to this scenario, else the reason. */
  refused?: (text: string) => string | null;
}

interface Sizes {
  /** Duration, s. */
  time: number;
  /** Greatest principal moment, kg·m². */
  moment: number;
  /** Angular speed, rad/s. */
  rate: number;
  /** Angular momentum, kg·m²/s. */
  momentum: number;
}

const ADDABLE: Addable[] = [
  {
    label: "Drag, linear",
    name: "drag",
    text: ({ moment, time }) => `model = "drag"\nlaw = "linear"\ncoefficient = "${short((3 * moment) / time)} N m s"`,
  },
  {
    label: "Constant, in the body",
    name: "push",
    text: ({ momentum, time }) => `model = "constant"\naxes = "body"\ntorque = [0, 0, "${short(momentum / time)} N m"]`,
  },
  {
    label: "Constant, in space",
    name: "push",
    text: ({ momentum, time }) => `model = "constant"\naxes = "space"\ntorque = [0, 0, "${short(momentum / time)} N m"]`,
  },
  {
    label: "Energy sink",
    name: "energy sink",
    // The nutation of a spinning body grows as exp(t/τ), 1/τ = α L² (1/i₁ − 1/i₃), and 1/i₁ − 1/i₃
    // is about 1/i₃.
    text: ({ moment, momentum, time }) => `model = "energy_sink"\ncoefficient = "${short((3 * moment) / (time * momentum ** 2))} /(N m s)"`,
  },
  {
    label: "Gravity gradient",
    name: "gravity gradient",
    text: () => `model = "gravity_gradient"`,
    refused: (text) => (/^\s*\[orbit\]/m.test(text) ? null : "needs an [orbit]"),
  },
  {
    label: "A formula",
    name: "formula",
    text: ({ momentum, time, rate }) =>
      `model = "formula"\naxes = "body"\ntorque = ["${short(momentum / time)}[N m]*sin(${short(rate)}[rad/s]*t)", "0", "0"]`,
  },
];

/** Creates a menu of the torques. */
export function addable(session: Session, numbers: () => Numbers): HTMLElement {
  const choice = element("select", { "aria-label": "Add a torque", class: "quiet" });
  const fill = (): void => {
    choice.replaceChildren(element("option", { value: "" }, "Add torque …"));
    ADDABLE.forEach(({ label, refused }, k) => {
      const why = refused?.(session.text) ?? null;
      const option = element("option", { value: String(k) }, why ? `${label} (${why})` : label);
      option.disabled = why !== null;
      choice.append(option);
    });
  };
  fill();
  choice.addEventListener("focus", fill);
  choice.addEventListener("change", () => {
    const chosen = ADDABLE[Number(choice.value)];
    choice.value = "";
    if (!chosen) return;
    const name = `name = "${free(chosen.name, session.text)}"`;
    const text = `${session.text.trimEnd()}\n\n[[torque]]\n${name}\n${chosen.text(sizesOf(numbers()))}\n`;
    session.replace(text, `add ${chosen.label}`);
  });
  return choice;
}

/** Returns the name, with a number appended if it exists already. */
function free(name: string, text: string): string {
  const isTaken = (tried: string): boolean => text.includes(`"${tried}"`);
  let tried = name;
  for (let k = 2; isTaken(tried); k += 1) tried = `${name} ${k}`;
  return tried;
}

function sizesOf({ page, motion }: Numbers): Sizes {
  const moment = page.body.principal.moments[2] || 1;
  const rate = motion.meanRate() || 1;
  const time = motion.times[motion.count - 1] - motion.times[0] || 10;
  return { moment, rate, time, momentum: moment * rate };
}

function short(value: number): string {
  return String(Number(value.toPrecision(2)));
}
