/** A knob: its name, an input field with its value in the scenario, a slider, and its range. */
import { element } from "../dom";
import { number } from "../format";
import type { Knob } from "./protocol";
import { FINE_PLACES, placeOf, PLACES, type Range, stepOf, toml, typedToml, valueAt } from "./range";
import { Steering } from "./steering";

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
  readonly #slider = element("input", { type: "range", min: "0", max: String(PLACES), step: "any" });
  readonly #low = element("span");
  readonly #high = element("span");
  readonly #said = element("p", { class: "knob-said", role: "status", hidden: true });
  #isDragged = false;
  /** Values before the last two presses on the track. */
  #before: [number, number];

  constructor(knob: Knob, turn: Turn) {
    this.#knob = knob;
    this.#range = rangeOf(knob);
    this.#turn = turn;
    this.#before = [knob.value, knob.value];
    count += 1;
    this.#field.id = `knob-${count}`;
    this.#label.htmlFor = this.#field.id;
    this.#said.id = `knob-said-${count}`;
    this.#field.setAttribute("aria-describedby", this.#said.id);
    const track = element("div", { class: "knob-track", title: "Drag; Shift: ten times finer; double-click: type a value" }, this.#slider);
    this.host = element(
      "div",
      { class: "knob" },
      element("div", { class: "knob-line" }, this.#label, element("span", { class: "knob-entry" }, this.#field, this.#unit)),
      track,
      element("div", { class: "knob-range", "aria-hidden": "true" }, this.#low, this.#high),
      this.#said,
    );
    this.host.dataset.key = knob.key;
    this.#listen();
    this.#steer(track);
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
    const text = `${shown(value)}${unit === "" ? "" : ` ${unit}`}`;
    this.#field.value = text;
    this.#field.style.width = `calc(${Math.max(text.length, 4) + 1}ch + 10px)`;
  }

  #paint(): void {
    const { value, unit, si } = this.#knob;
    const { low, high } = this.#range;
    const here = placeOf(value, this.#range);
    // The coloured part begins at zero where the range contains it.
    const zero = low < 0 && high > 0 ? placeOf(0, this.#range) : 0;
    this.#slider.style.setProperty("--from", `${(100 * Math.min(zero, here)) / PLACES}%`);
    this.#slider.style.setProperty("--to", `${(100 * Math.max(zero, here)) / PLACES}%`);
    this.#low.textContent = end(low);
    this.#high.textContent = end(high);
    this.#slider.setAttribute("aria-valuetext", `${shown(value)} ${unit || si}`.trim());
  }

  #go(place: number, places = PLACES): void {
    this.#put(place, valueAt(place, this.#range, places));
  }

  #put(place: number, value: number): void {
    this.#slider.value = String(place);
    this.#knob = { ...this.#knob, value };
    this.#write();
    this.#paint();
    this.#turn.set(this.#knob.key, toml(value, this.#knob.unit));
  }

  #listen(): void {
    const slider = this.#slider;
    slider.addEventListener("input", () => this.#go(Number(slider.value)));
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

  #steer(track: HTMLElement): void {
    new Steering(track, this.#slider, {
      place: () => placeOf(this.#knob.value, this.#range),
      begin: () => {
        this.#isDragged = true;
        this.#before = [this.#before[1], this.#knob.value];
        this.#turn.hold();
      },
      go: (place, isFine) => this.#go(place, isFine ? FINE_PLACES : PLACES),
      end: () => this.#end(),
      // The first press of the double click may have moved the thumb.
      type: () => {
        const [before] = this.#before;
        if (before !== this.#knob.value) this.#put(placeOf(before, this.#range), before);
        this.#field.focus();
      },
    });
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

/** Formats an end of the range, without zeros at its end. */
function end(value: number): string {
  return number(value, 3).replace(/\.0+$|(\.\d*[1-9])0+$/, "$1");
}

function shown(value: number): string {
  return String(Number(value.toPrecision(12)));
}
