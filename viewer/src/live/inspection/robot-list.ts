/** Links of a robot as text: those with findings first, and the repair if there is one. */
import { element } from "../../dom";
import { number } from "../../format";
import type { RobotInspection, RobotLink } from "../protocol";
import { badge, entry, type Listed, listed } from "./listed";
import { repair } from "./repair";
import { INKS } from "./robot-scene";

const WORDS: Record<RobotLink["verdict"], string> = { impossible: "impossible", suspect: "suspect", ok: "no finding", none: "no inertial" };
const WORST: RobotLink["verdict"][] = ["impossible", "suspect", "ok", "none"];

type Finding = RobotInspection["findings"][number];

export function robotList(robot: RobotInspection, file: string, choose: (item: number) => void): Listed {
  const of = (k: number | null): Finding[] => robot.findings.filter(({ link }) => link === k);
  const all = robot.links.map((link, k) => ({ link, k, findings: of(k) }));
  all.sort((a, b) => WORST.indexOf(a.link.verdict) - WORST.indexOf(b.link.verdict) || a.k - b.k);
  const items = (some: typeof all): HTMLElement => {
    return element("ul", { class: "entries" }, ...some.map(({ link, k, findings }) => entry(k, choose, [badge(WORDS[link.verdict], INKS[link.verdict]), " ", element("b", {}, link.name), ...mass(link)], [...findings.map(sentence), ...numbers(link)])));
  };
  const [told, quiet] = [all.filter(({ findings }) => findings.length > 0), all.filter(({ findings }) => findings.length === 0)];
  const host = element("div", {}, element("h2", {}, robot.name), element("p", {}, summary(robot)), element("p", { class: "hint" }, "All joints are at zero. A box is the uniform one with the link's mass and inertia: where it does not look like the link, the numbers are of something else."));
  host.append(...of(null).map(sentence));
  if (told.length > 0) host.append(element("h3", {}, "Findings"), items(told));
  if (quiet.length > 0) {
    const rest = element("details", { open: told.length === 0 }, element("summary", {}, told.length === 0 ? count(quiet.length, "link") : count(quiet.length, "other link")), items(quiet));
    host.append(rest);
  }
  if (told.some(({ link }) => link.verdict === "impossible" || link.verdict === "suspect")) host.append(repair(robot.repair, file));
  return listed(host, robot.links.length);
}

function summary({ links }: RobotInspection): string {
  const counts = WORST.map((verdict) => ({ verdict, count: links.filter((link) => link.verdict === verdict).length })).filter(({ count }) => count > 0);
  const words = { impossible: "impossible", suspect: "suspect", ok: "without a finding", none: "without an inertial" };
  return `${count(links.length, "link")}: ${counts.map(({ verdict, count }) => `${count} ${words[verdict]}`).join(", ")}.`;
}

function mass({ inertial }: RobotLink): string[] {
  return inertial ? [` ${short(inertial.mass)}\u00a0kg`] : [];
}

function sentence({ severity, message, file, line, code }: Finding): HTMLElement {
  const ink = severity === "note" ? "quiet" : INKS[severity];
  return element("p", { class: "finding" }, badge(severity, ink), ` ${file === undefined ? "" : `${file}, `}line ${line}: ${message} `, element("code", {}, code));
}

function numbers({ inertial }: RobotLink): HTMLElement[] {
  if (!inertial) return [];
  const row = (name: string, values: number[], unit: string): HTMLElement => {
    const value = element("td", {}, values.map((x) => short(x)).join(", "), "\u00a0", element("span", { class: "unit" }, unit));
    return element("tr", {}, element("th", { scope: "row" }, name), value);
  };
  const rows = [row("Mass", [inertial.mass], "kg"), row("Centre of mass, link's frame", inertial.center, "m")];
  if (inertial.box) rows.push(row("Edges of the equivalent box", inertial.box.size, "m"));
  return [element("table", { class: "entry-numbers" }, element("tbody", {}, ...rows))];
}

// Formats a number with up to five digits, without trailing zeros.
function short(value: number): string {
  return number(value).replace(/(\.\d*?)0+(?!\d)/, "$1").replace(/\.(?!\d)/, "");
}

function count(n: number, what: string): string {
  return `${n} ${what}${n === 1 ? "" : "s"}`;
}
