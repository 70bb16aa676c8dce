/**
 * Legend of the event letters above the plots, where a click moves to the next time of an event;
 * and legend of the bands behind the plots.
 */
import type { Clock } from "../clock";
import type { Phase } from "../contact";
import { element } from "../dom";
import { number } from "../format";
import type { Marked } from "../plot/events";
import { words } from "../plot/phases";

export function eventKey(all: readonly Marked[], count: number, clock: Clock, unit: { name: string; seconds: number }): HTMLElement {
  const host = element("div", { class: "events", role: "group", "aria-label": "Events" });
  for (const { letter, name, times } of all) {
    const at = `${number(times[0] / unit.seconds, 4)}\u00a0${unit.name}`;
    const when = times.length > 1 ? `${times.length}\u00a0×, first at t\u00a0=\u00a0${at}` : `at t\u00a0=\u00a0${at}`;
    const go = (): void => {
      clock.pause();
      clock.set(times.find((time) => time > clock.time) ?? times[0]);
    };
    host.append(
      element(
        "button",
        { type: "button", class: "event-entry", title: "Go to its next time", click: go },
        element("b", {}, letter),
        element("span", {}, `${name}, `, element("span", { class: "unit" }, when)),
      ),
    );
  }
  const shown = all.reduce((sum, { times }) => sum + times.length, 0);
  if (count > shown) host.append(element("p", { class: "hint" }, `The first ${shown} of ${count} events.`));
  return host;
}

/** Creates the legend of the phases: rolling, sliding and flying. */
export function phaseKey(phases: readonly Phase[], unit: { name: string; seconds: number }): HTMLElement {
  const say = (seconds: number): string => `${number(seconds / unit.seconds, 4)}\u00a0${unit.name}`;
  const host = element("div", { class: "phases", role: "group", "aria-label": "Phases of the contact" });
  for (const { ink, text } of words(phases, say)) {
    const band = element("span", { class: "band", "aria-hidden": "true" });
    if (ink) band.style.background = `color-mix(in srgb, var(--${ink}) 30%, transparent)`;
    host.append(element("span", { class: "phase" }, band, text));
  }
  return host;
}
