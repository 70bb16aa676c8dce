/**
 * The widget of `polhode.widget` (anywidget): knobs, and the motion that the kernel computes for
 * their values.
 *
 * At most one request is in flight. Later changes are sent after its answer, with the latest
 * values.
 */
import { element } from "../dom";
import { placeOf, PLACES, stepOf, valueAt } from "../live/range";
import { frame, send } from "./frame";
import { bring, known, wait } from "./shared";

/** Traits; `_widget.py` describes them. */
interface Traits {
  viewer_key: string;
  knobs: Knob[];
  asked: { turn: number; values: Values };
  answer: { turn: number; values: Values; refusal: { message: string; hint: string | null; key: string | null } | null; notes: string[] };
  packed: DataView<ArrayBuffer>;
}

type Values = Record<string, number>;

interface Knob {
  key: string;
  label: string;
  unit: string;
  what: string;
  low: number;
  high: number;
  scale: "linear" | "log";
}

interface Model {
  get<K extends keyof Traits>(name: K): Traits[K];
  set<K extends keyof Traits>(name: K, value: Traits[K]): void;
  save_changes(): void;
  on(event: string, then: (message: unknown, buffers: DataView<ArrayBuffer>[]) => void): void;
  off(event: string, then: (message: unknown, buffers: DataView<ArrayBuffer>[]) => void): void;
  send(message: unknown): void;
}

/** Time after which the kernel is reported as slow, ms. */
const SLOW = 1500;

let made = 0;

function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  const undo: (() => void)[] = [];
  const on = (event: string, then: (message: unknown, buffers: DataView<ArrayBuffer>[]) => void): void => {
    model.on(event, then);
    undo.push(() => model.off(event, then));
  };
  const controls = model.get("knobs").map((knob) => new Control(knob, (value) => turn(knob.key, value)));
  const words = element("span");
  const back = element("button", { type: "button", title: "Reset the knobs to the motion shown" }, "Back");
  const refusal = element("p", { class: "polhode-refusal", role: "alert", hidden: true }, words, " ", back);
  const notes = element("p", { class: "polhode-notes", role: "status" });
  const stage = element("div", { class: "polhode-stage" }, element("p", {}, "Loading the viewer from the kernel. If the kernel was restarted or is not running, run the cell again."));
  el.classList.add("polhode-widget");
  el.replaceChildren(
    stage,
    element("div", { class: "polhode-knobs", role: "group", "aria-label": "Knobs" }, ...controls.map(({ host }) => host)),
    refusal,
    notes,
  );

  const wanted: Values = { ...model.get("answer").values };
  /** Number of the request in flight. */
  let asked: number | null = null;
  let late = 0;
  const isWanted = (values: Values): boolean => Object.entries(wanted).every(([key, value]) => values[key] === value);
  const ask = (): void => {
    asked = model.get("asked").turn + 1;
    model.set("asked", { turn: asked, values: { ...wanted } });
    model.save_changes();
    late = window.setTimeout(() => {
      notes.textContent = "The kernel has not answered yet: it is busy, or there is none. The motion is that of before.";
    }, SLOW);
  };
  const turn = (key: string, value: number): void => {
    wanted[key] = value;
    if (asked === null && (!isWanted(model.get("answer").values) || model.get("answer").refusal !== null)) ask();
  };
  const answered = (): void => {
    const answer = model.get("answer");
    // This answers an older request, or contains values that Python has set meanwhile.
    if (asked !== null && answer.turn < asked) return;
    window.clearTimeout(late);
    const isOld = asked !== null && !isWanted(model.get("asked").values);
    asked = null;
    if (isOld) ask();
    else settle(answer);
  };
  const settle = (answer: Traits["answer"]): void => {
    // A refused value stays at its knob.
    if (answer.refusal === null) Object.assign(wanted, answer.values);
    for (const control of controls) control.show(wanted[control.knob.key]);
    tell(answer);
  };
  const tell = ({ refusal: refused, notes: said }: Traits["answer"]): void => {
    refusal.hidden = refused === null;
    if (refused !== null) words.textContent = `${refused.message}${refused.hint === null ? "" : ` (hint: ${refused.hint})`} The motion is that of before.`;
    for (const control of controls) control.mark(refused !== null && refused.key === control.knob.key);
    notes.textContent = said.join(" ");
  };
  back.addEventListener("click", () => settle({ ...model.get("answer"), refusal: null }));
  on("change:answer", answered);

  let shown: HTMLIFrameElement | null = null;
  const show = (): void => {
    const { buffer, byteOffset, byteLength } = model.get("packed");
    if (shown) send(shown, { polhode: "motion", packed: buffer.slice(byteOffset, byteOffset + byteLength) });
  };
  const ready = (event: MessageEvent<{ polhode?: string } | null>): void => {
    if (shown && event.source === shown.contentWindow && event.data?.polhode === "ready") show();
  };
  addEventListener("message", ready);
  undo.push(() => removeEventListener("message", ready));
  on("change:packed", show);
  const place = (viewer: Promise<string>): void => {
    void viewer.then((page) => {
      if (shown) return;
      shown = frame(page, "");
      stage.replaceChildren(shown);
    });
  };
  const key = model.get("viewer_key");
  const viewer = known(key);
  if (viewer) place(viewer);
  else {
    wait(key, place);
    on("msg:custom", (message, [packed]) => {
      if ((message as { viewer?: string }).viewer === key) bring(key, new Uint8Array(packed.buffer, packed.byteOffset, packed.byteLength));
    });
    model.send({ viewer: key });
  }
  settle(model.get("answer"));
  return () => {
    for (const step of undo) step();
  };
}

/** A knob: its name with the unit, a slider, and an input field. */
class Control {
  readonly host: HTMLElement;
  readonly knob: Knob;
  readonly #slider = element("input", { type: "range", min: "0", max: String(PLACES), step: "1" });
  readonly #field = element("input", { type: "number", step: "any" });
  #value = NaN;

  constructor(knob: Knob, turn: (value: number) => void) {
    this.knob = knob;
    made += 1;
    const [slider, field] = [this.#slider, this.#field];
    slider.id = `polhode-knob-${made}`;
    const name = knob.unit === "" ? knob.label : `${knob.label}, ${knob.unit}`;
    const label = element("label", { for: slider.id, title: `${knob.key}: ${knob.what}` }, name);
    field.setAttribute("aria-label", name);
    this.host = element("div", { class: "polhode-knob" }, label, slider, field);
    this.host.dataset.key = knob.key;
    const go = (value: number): void => {
      this.show(value);
      turn(value);
    };
    slider.addEventListener("input", () => go(valueAt(Number(slider.value), knob)));
    slider.addEventListener("keydown", (event) => {
      const step = stepOf(event.key, event.shiftKey);
      if (step === null || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      go(valueAt(Math.min(Math.max(Number(slider.value) + step, 0), PLACES), knob));
    });
    field.addEventListener("change", () => {
      const { valueAsNumber: typed } = field;
      // A refused value is requested once; leaving the field is not a change.
      if (Number.isFinite(typed) && typed !== this.#value) go(typed);
    });
    // Keep the notebook's own keys from acting.
    this.host.addEventListener("keydown", (event) => event.stopPropagation());
  }

  show(value: number): void {
    this.#value = value;
    const said = String(Number(value.toPrecision(12)));
    this.#slider.value = String(placeOf(value, this.knob));
    this.#slider.setAttribute("aria-valuetext", `${said} ${this.knob.unit}`.trim());
    if (document.activeElement !== this.#field || this.#field.valueAsNumber !== value) this.#field.value = said;
  }

  mark(isRefused: boolean): void {
    this.host.classList.toggle("polhode-refused", isRefused);
    this.#field.setAttribute("aria-invalid", String(isRefused));
  }
}

export default { render };
