/** A knob: its name, an input field with its value in the scenario, and a slider. */
import { element } from "../dom";
import type { Knob } from "./protocol";
import { placeOf, PLACES, type Range, stepOf, toml, typedToml, valueAt } from "./range";

/** Callbacks of a knob. */
export interface Turn {
  /** Sets a value as TOML. */
  set: (key: string, value: string) => void;
  /** Begin and end of a drag. */
  hold: () => void;
  release: () => void;
}

let count = 0;

export class KnobControl {
  readonly host: HTMLElement;
  #knob: Knob;
  #range: Range;
  readonly #turn: Turn;
  readonly #label = element("label", { class: "knob-label" });
  readonly #field = element("input", { type: "text", class: "knob-value", spellcheck: "false", autocomplete: "off" });
  readonly #unit = element("span", { class: "unit" });
  readonly #slider = element("input", { type: "range", min: "0", max: String(PLACES), step: "1" });
  readonly #said = element("p", { class: "knob-said", role: "status", hidden: true });
  #isDragged = false;

  constructor(knob: Knob, turn: Turn) {
    this.#knob = knob;
    this.#range = rangeOf(knob);
    this.#turn = turn;
    count += 1;
    this.#field.id = `knob-${count}`;
    this.#label.htmlFor = this.#field.id;
    this.#said.id = `knob-said-${count}`;
    this.#field.setAttribute("aria-describedby", this.#said.id);
    this.host = element(
      "div",
      { class: "knob" },
      this.#label,
      element("div", { class: "knob-line" }, this.#slider, element("span", { class: "knob-entry" }, this.#field, this.#unit)),
      this.#said,
    );
    this.host.dataset.key = knob.key;
    this.#listen();
    this.update(knob);
  }

  /** Updates the knob from the scenario. The range stays while it contains the value. */
  update(knob: Knob): void {
    const before = this.#knob;
    this.#knob = knob;
    const { value, unit } = knob;
    const isOutside = value < this.#range.low || value > this.#range.high;
    if (isOutside || unit !== before.unit || knob.scale !== this.#range.scale) this.#range = rangeOf(knob);
    this.#label.textContent = knob.label;
    this.#label.title = `${knob.label}: ${knob.what}\n${knob.key}`;
    this.#unit.textContent = unit === "" ? knob.si : "";
    this.#slider.setAttribute("aria-label", knob.label);
    if (document.activeElement !== this.#field) this.#write();
    if (!this.#isDragged) this.#slider.value = String(placeOf(value, this.#range));
    this.#paint();
  }

  /** Shows an error that the value caused; null removes it. */
  say(message: string | null): void {
    this.#said.textContent = message ?? "";
    this.#said.hidden = message === null;
    this.host.classList.toggle("wrong", message !== null);
    this.#field.setAttribute("aria-invalid", String(message !== null));
  }

  #write(): void {
    const { value, unit } = this.#knob;
    this.#field.value = `${shown(value)}${unit === "" ? "" : ` ${unit}`}`;
  }

  #paint(): void {
    const { value, unit, si } = this.#knob;
    this.#slider.style.setProperty("--part", `${(100 * placeOf(value, this.#range)) / PLACES}%`);
    this.#slider.setAttribute("aria-valuetext", `${shown(value)} ${unit || si}`.trim());
  }

  #go(place: number): void {
    const value = valueAt(place, this.#range);
    this.#slider.value = String(place);
    this.#knob = { ...this.#knob, value };
    this.#write();
    this.#paint();
    this.#turn.set(this.#knob.key, toml(value, this.#knob.unit));
  }

  #listen(): void {
    const slider = this.#slider;
    slider.addEventListener("pointerdown", () => {
      this.#isDragged = true;
      this.#turn.hold();
    });
    slider.addEventListener("input", () => this.#go(Number(slider.value)));
    slider.addEventListener("change", () => this.#end());
    for (const end of ["pointerup", "pointercancel"]) slider.addEventListener(end, () => this.#end());
    slider.addEventListener("keydown", (event) => {
      const step = stepOf(event.key, event.shiftKey);
      if (step === null || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      this.#go(Math.min(Math.max(placeOf(this.#knob.value, this.#range) + step, 0), PLACES));
    });
    this.#field.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.#type();
      if (event.key === "Escape") {
        this.#write();
        this.say(null);
      }
    });
    this.#field.addEventListener("focus", () => this.#field.select());
    this.#field.addEventListener("change", () => this.#type());
  }

  #type(): void {
    const { key, unit } = this.#knob;
    const value = typedToml(this.#field.value, unit);
    if (value === toml(this.#knob.value, unit)) return;
    this.#turn.set(key, value);
  }

  // A drag to an end of the range extends it.
  #end(): void {
    if (!this.#isDragged) return;
    this.#isDragged = false;
    this.#turn.release();
    const place = placeOf(this.#knob.value, this.#range);
    if (place > 0.01 * PLACES && place < 0.99 * PLACES) return;
    this.#range = rangeOf(this.#knob);
    this.#slider.value = String(placeOf(this.#knob.value, this.#range));
    this.#paint();
  }
}

function rangeOf({ low, high, scale, value }: Knob): Range {
  // A value that was dragged after the range was sent may be at its end.
  return { low: Math.min(low, value), high: Math.max(high, value), scale: low > 0 && value > 0 ? scale : "linear" };
}

function shown(value: number): string {
  return String(Number(value.toPrecision(12)));
}
