/**
 * Knobs below the scene: the most informative ones, the others behind "more", switches of torques,
 * and torques to add.
 */
import { element } from "../dom";
import { KnobControl, type Turn } from "./knob";
import type { Knob } from "./protocol";
import type { Session } from "./session";
import { addable } from "./torques";

/** Maximum number of knobs in front, in two rows; one row in a low window. */
const MOST = 7;
const ROWS = 2;
const LOW = 700;

const GROUPS: Record<Knob["group"], string> = {
  body: "Body",
  start: "Start",
  torque: "Torques",
  wheel: "Wheels",
  run: "Run",
  other: "Other",
};

export class Knobs {
  readonly host = element("section", { id: "knobs", "aria-label": "Knobs" });
  readonly #session: Session;
  readonly #turn: Turn;
  readonly #controls = new Map<string, KnobControl>();
  readonly #main = element("div", { class: "knob-grid" });
  readonly #rest = element("div", { class: "knob-rest", id: "knob-rest", hidden: true });
  readonly #switches = element("div", { class: "switches", role: "group", "aria-label": "Torques" });
  readonly #more = element("button", { type: "button", class: "quiet", "aria-expanded": "false", "aria-controls": "knob-rest" });
  #layout = "";
  /** Number of knobs for which there is room. */
  #room = MOST;
  /** Keys of the knobs in front, until another document is opened. */
  #front: string[] = [];
  /** Keys of the knobs of a lesson; null without one. */
  #only: string[] | null = null;
  readonly #foot: HTMLElement;

  /** `numbers` determines the sizes of an added torque. */
  constructor(session: Session, pad: HTMLElement, numbers: Parameters<typeof addable>[1]) {
    this.#session = session;
    this.#turn = {
      set: (key, value) => session.edit({ set: key, value }),
      hold: () => session.hold(),
      release: () => session.release(),
    };
    this.#more.addEventListener("click", () => this.#open(this.#rest.hidden));
    this.#foot = element("div", { class: "knob-foot" }, this.#switches, addable(session, numbers), pad, this.#more);
    this.host.append(this.#main, this.#rest, this.#foot);
    session.listen({
      changed: () => this.#update(),
      moved: (_, { anew }) => {
        if (anew) this.#front = [];
      },
    });
    new ResizeObserver(() => {
      const columns = getComputedStyle(this.#main).gridTemplateColumns.split(" ").length;
      this.#room = Math.min(columns * (innerHeight < LOW ? 1 : ROWS), MOST);
      this.#update();
    }).observe(document.body);
  }

  /** Shows only these knobs; null shows all again. */
  show(only: string[] | null): void {
    this.#only = only;
    this.#foot.hidden = only !== null;
    this.#open(false);
  }

  #open(isOpen: boolean): void {
    this.#rest.hidden = !isOpen;
    this.#more.setAttribute("aria-expanded", String(isOpen));
    this.#layout = "";
    this.#update();
  }

  #update(): void {
    const { switches, trouble } = this.#session;
    const knobs = this.#session.knobs.filter(({ key }) => this.#only?.includes(key) ?? true);
    const ranked = [...knobs].sort((a, b) => a.rank - b.rank);
    const there = new Set(knobs.map(({ key }) => key));
    // Knobs in front stay there while values change.
    this.#front = this.#front.filter((key) => there.has(key));
    for (const { key } of ranked) if (this.#front.length < MOST && !this.#front.includes(key)) this.#front.push(key);
    const front = this.#front.slice(0, this.#room);
    const layout = JSON.stringify([front, knobs.map(({ key, group }) => [key, group]), this.#rest.hidden]);
    if (layout !== this.#layout) {
      this.#layout = layout;
      this.#arrange(knobs, front);
    }
    for (const knob of knobs) {
      const control = this.#controls.get(knob.key);
      if (!this.#session.isWaiting(knob.key)) control?.update(knob);
      control?.say(trouble?.key === knob.key ? `${trouble.message}${trouble.hint ? ` — ${trouble.hint}` : ""}` : null);
    }
    this.#showSwitches(switches);
  }

  #arrange(knobs: Knob[], front: string[]): void {
    const there = new Set(knobs.map(({ key }) => key));
    for (const key of this.#controls.keys()) if (!there.has(key)) this.#controls.delete(key);
    const focused = document.activeElement;
    const control = (knob: Knob): HTMLElement => {
      const known = this.#controls.get(knob.key) ?? new KnobControl(knob, this.#turn);
      this.#controls.set(knob.key, known);
      return known.host;
    };
    const named = new Map(knobs.map((knob) => [knob.key, knob]));
    this.#main.replaceChildren(...front.flatMap((key) => named.get(key) ?? []).map(control));
    const rest = knobs.filter(({ key }) => !front.includes(key));
    const groups = [...new Set(rest.map(({ group }) => group))];
    this.#rest.replaceChildren(
      ...(this.#rest.hidden ? [] : groups).map((group) => {
        const own = rest.filter((knob) => knob.group === group);
        return element("div", {}, element("h3", {}, GROUPS[group]), element("div", { class: "knob-grid" }, ...own.map(control)));
      }),
    );
    this.#more.textContent = this.#rest.hidden ? `More (${rest.length})` : "Less";
    this.#more.hidden = rest.length === 0;
    if (focused instanceof HTMLElement && focused !== document.activeElement && this.host.contains(focused)) focused.focus();
  }

  #showSwitches(switches: Session["switches"]): void {
    if (this.#switches.children.length !== switches.length) {
      this.#switches.replaceChildren(...switches.map(() => element("button", { type: "button", role: "switch", class: "switch" })));
    }
    switches.forEach(({ key, label, on }, k) => {
      const button = this.#switches.children[k] as HTMLButtonElement;
      button.textContent = label;
      button.dataset.key = key;
      button.setAttribute("aria-checked", String(on));
      button.onclick = () => this.#session.edit({ set: key, value: String(!on) });
    });
    this.#switches.hidden = switches.length === 0;
  }
}
