/** Keyboard. Keys that a control handles itself take precedence. */
import type { Clock } from "./clock";
import { byId } from "./dom";
import type { Picture } from "./scene/layers";
import type { View } from "./scene/scene";

const TURN = 0.12;
const PICTURES: Record<string, Picture> = { "1": "body", "2": "poinsot", "3": "cones", "4": "sphere" };

/** Keys that also work when the motion is not shown. */
const ALWAYS = ["t", "?"];

/**
 * Installs the keys. `more`: actions of further keys. `isAway`: true while the motion is not shown.
 */
export function keys(clock: Clock, view: View | null, show: (picture: Picture) => void, more: Map<string, () => void>, isAway: () => boolean): void {
  const help = byId<HTMLDialogElement>("help");
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    if (event.defaultPrevented || target.closest("select, textarea, input:not([type=range]), [contenteditable=true]")) return;
    // Space presses a focused button, and arrows scroll a scrollable element.
    if (event.key === " " && target.closest("button, summary, a")) return;
    if (event.key.startsWith("Arrow") && !event.shiftKey && target.closest("pre, .formula, .table")) return;
    if (isAway() && !ALWAYS.includes(event.key)) return;
    const own = more.get(event.key);
    own?.();
    if (own || act(event.key, event.shiftKey, clock, view, show, help)) event.preventDefault();
  });
}

function act(
  key: string,
  shift: boolean,
  clock: Clock,
  view: View | null,
  show: (picture: Picture) => void,
  help: HTMLDialogElement,
): boolean {
  if (shift && view && key.startsWith("Arrow")) {
    const [a, h] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key] ?? [0, 0];
    view.orbit.turn(a * TURN, h * TURN);
    return true;
  }
  switch (key) {
    case " ":
      clock.toggle();
      return true;
    case "ArrowRight":
      clock.step(1);
      return true;
    case "ArrowLeft":
      clock.step(-1);
      return true;
    case "Home":
      clock.set(clock.start);
      return true;
    case "End":
      clock.set(clock.end);
      return true;
    case "-":
    case "−":
      clock.changeSpeed(-1);
      return true;
    case "+":
    case "=":
      clock.changeSpeed(1);
      return true;
    case "l":
      clock.setLoop(!clock.loop);
      return true;
    case "c":
      byId("ride").click();
      return true;
    case "r":
      view?.orbit.home();
      return true;
    case "i":
    case "o":
      view?.orbit.dolly(key === "i" ? 1.15 : 1 / 1.15);
      return true;
    case "t":
      byId("theme").click();
      return true;
    case "s":
      byId("save").click();
      return true;
    case "?":
      help.showModal();
      return true;
    default:
      if (key in PICTURES) show(PICTURES[key]);
      return key in PICTURES;
  }
}
