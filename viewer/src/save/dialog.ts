/** Dialog for saving the 3-D view: a picture, or a film of a part of the motion. */
import type { Clock } from "../clock";
import { byId, element } from "../dom";
import { number, timeUnit } from "../format";
import type { View } from "../scene/scene";
import { fileName, save } from "./files";
import { type Format, frameCount, type Order, refusal } from "./film";
import { Frames } from "./frame";
import { record } from "./record";
import { noVideo } from "./video";

const FORMATS: Record<Format, { name: string; ending: string; rate: number }> = {
  png: { name: "Picture: PNG", ending: "png", rate: 1 },
  webm: { name: "Film: WebM", ending: "webm", rate: 30 },
  gif: { name: "Film: GIF", ending: "gif", rate: 20 },
  zip: { name: "Frames: PNG in a ZIP", ending: "zip", rate: 30 },
};

/** Default size of a picture relative to the screen. */
const PRINT = 2;
/** Default width of a GIF, px. GIF files are large for their content. */
const GIF_WIDTH = 640;
/** Default maximum duration of a film, s; of a longer run, it is the beginning. */
const LONGEST = 60;

export class SaveDialog {
  readonly #view: View;
  readonly #clock: Clock;
  readonly #title: () => string;
  #unit = timeUnit(0);
  readonly #format = choice("save-format", Object.entries(FORMATS).map(([value, { name }]) => [value, name]));
  readonly #from = field("save-from");
  readonly #to = field("save-to");
  readonly #speed = field("save-speed");
  readonly #rate = field("save-rate");
  readonly #width = field("save-width");
  readonly #height = field("save-height");
  readonly #paper = choice("save-paper", [["paper", "Paper"], ["none", "Transparent"]]);
  readonly #said = element("p", { id: "save-said", role: "status" });
  readonly #progress = element("progress", { id: "save-progress", "aria-label": "Frames saved", hidden: true });
  readonly #go = element("button", { id: "save-go", type: "submit", class: "primary" }, "Save");
  readonly #stop = element("button", { id: "save-stop", type: "button", click: () => this.#cancel() }, "Close");
  readonly #fields: HTMLFieldSetElement;
  readonly #ofFilms: HTMLElement[];
  readonly #times = row("Time", labelled("from", this.#from), labelled("to", this.#to));
  readonly #dialog: HTMLDialogElement;
  /** Fields that the user has filled in, which defaults do not overwrite. */
  readonly #own = new Set<HTMLElement>();
  #isPicture = true;
  #frames: Frames | null = null;
  #running: AbortController | null = null;

  /** `title`: title of the current motion. */
  constructor(view: View, clock: Clock, title: () => string) {
    this.#view = view;
    this.#clock = clock;
    this.#title = title;
    const pace = row("Speed", labelled("× real time", this.#speed), labelled("frames per s", this.#rate));
    const scales = [1, 2, 4].map((k) => {
      return element("button", { type: "button", class: "small", "aria-label": `${k} times the size on the screen`, click: () => this.#scale(k) }, `${k}×`);
    });
    this.#ofFilms = [this.#times, pace];
    const why = noVideo();
    this.#fields = element(
      "fieldset",
      {},
      row("Format", this.#format),
      this.#times,
      pace,
      row("Size (px)", labelled("width", this.#width), labelled("height", this.#height), element("span", { class: "scales" }, ...scales)),
      row("Background", this.#paper),
    );
    if (why) {
      this.#format.querySelector<HTMLOptionElement>("[value=webm]")?.toggleAttribute("disabled", true);
      this.#fields.prepend(element("p", { class: "hint" }, `No WebM here: ${why}.`));
    }
    this.#fields.addEventListener("input", (event) => this.#changed(event.target as HTMLElement));
    const form = element("form", {}, element("h2", { id: "save-title" }, "Save the 3-D view"), this.#fields, this.#said, this.#progress, element("p", { class: "ends" }, this.#go, this.#stop));
    form.noValidate = true;
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.#save();
    });
    this.#dialog = element("dialog", { id: "save-dialog", "aria-labelledby": "save-title" }, form);
    this.#dialog.addEventListener("cancel", (event) => {
      if (!this.#running) return;
      event.preventDefault();
      this.#cancel();
    });
    this.#dialog.addEventListener("close", () => this.#running?.abort());
    document.body.append(this.#dialog);
  }

  open(): void {
    this.#clock.pause();
    this.#own.clear();
    this.#measure();
    this.#dialog.showModal();
  }

  /** Handles the change to another motion. A recording of the previous one ends. */
  changed(): void {
    if (!this.#dialog.open) return;
    this.#measure();
    this.#running?.abort(new Error("The motion has changed meanwhile: nothing is saved."));
  }

  #measure(): void {
    const { start, end } = this.#clock;
    const unit = timeUnit(Math.max(Math.abs(end), Math.abs(start)));
    // A time that the user has entered is in the previous unit.
    if (unit.seconds !== this.#unit.seconds) for (const input of [this.#from, this.#to]) this.#own.delete(input);
    this.#unit = unit;
    rename(this.#times, `Time (${unit.name})`);
    this.#defaults();
  }

  get #shown(): { width: number; height: number } {
    const { clientWidth: width, clientHeight: height } = byId("stage");
    return { width, height };
  }

  #defaults(): void {
    const format = this.#format.value as Format;
    const clock = this.#clock;
    const { width, height } = this.#shown;
    const part = format === "png" ? PRINT : format === "gif" ? Math.min(1, GIF_WIDTH / width) : 1;
    const end = Math.min(clock.end, clock.start + LONGEST * clock.speed);
    const put = (input: HTMLInputElement, value: number): void => {
      if (!this.#own.has(input)) input.value = String(value);
    };
    put(this.#from, short(clock.start / this.#unit.seconds));
    put(this.#to, short(end / this.#unit.seconds));
    put(this.#speed, short(clock.speed));
    put(this.#rate, FORMATS[format].rate);
    // Even sizes, because films have colours for blocks of two by two pixels.
    put(this.#width, 2 * Math.round((part * width) / 2));
    put(this.#height, 2 * Math.round((part * height) / 2));
    const pictures = format === "png" || format === "zip";
    this.#paper.disabled = !pictures;
    if (!pictures) this.#paper.value = "paper";
    for (const films of this.#ofFilms) films.hidden = format === "png";
    this.#judge();
  }

  #changed(what: HTMLElement): void {
    if (what === this.#format) {
      // The size of a picture would be too large for a film.
      const isPicture = this.#format.value === "png";
      if (isPicture !== this.#isPicture) for (const input of [this.#width, this.#height]) this.#own.delete(input);
      this.#isPicture = isPicture;
      this.#defaults();
    } else this.#own.add(what);
    // The height follows the width until the user has set it.
    if (what === this.#width && !this.#own.has(this.#height)) {
      const { width, height } = this.#shown;
      this.#height.value = String(Math.max(1, Math.round((this.#width.valueAsNumber * height) / width)) || "");
    }
    this.#judge();
  }

  #scale(k: number): void {
    const { width, height } = this.#shown;
    this.#width.value = String(k * width);
    this.#height.value = String(k * height);
    for (const input of [this.#width, this.#height]) this.#own.add(input);
    this.#judge();
  }

  get #order(): Order {
    const time = (input: HTMLInputElement): number => input.valueAsNumber * this.#unit.seconds;
    return {
      format: this.#format.value as Format,
      from: time(this.#from),
      to: time(this.#to),
      speed: this.#speed.valueAsNumber,
      rate: this.#rate.valueAsNumber,
      width: this.#width.valueAsNumber,
      height: this.#height.valueAsNumber,
      paper: this.#paper.value === "paper",
    };
  }

  /** Shows a description of the result, or the reason why it is impossible. */
  #judge(): void {
    const order = this.#order;
    const why = this.#refusal(order);
    const count = frameCount(order);
    const shown = number(this.#clock.time / this.#unit.seconds);
    this.#say(why ?? (order.format === "png" ? `The view at t = ${shown} ${this.#unit.name}.` : `${count} frames, a film of ${number(count / order.rate, 3)} s.`), why !== null);
    this.#go.disabled = why !== null || this.#running !== null;
  }

  #refusal(order: Order): string | null {
    return refusal(order, this.#clock.start, this.#clock.end, this.#unit);
  }

  #say(words: string, isProblem: boolean): void {
    this.#said.textContent = words;
    this.#said.classList.toggle("problem", isProblem);
  }

  async #save(): Promise<void> {
    const order = this.#order;
    if (this.#running || this.#refusal(order)) return;
    const running = new AbortController();
    const count = order.format === "png" ? 1 : frameCount(order);
    this.#run(running);
    this.#progress.max = count;
    this.#progress.value = 0;
    this.#say(`Saving ${count === 1 ? "a picture" : `${count} frames`} …`, false);
    try {
      if (!this.#frames || this.#frames.isLost) this.#frames = new Frames(this.#view);
      const progress = (done: number): void => {
        this.#progress.value = done;
      };
      const file = await record(order, this.#frames, this.#shown, this.#clock.time, progress, running.signal);
      running.signal.throwIfAborted();
      const name = `${fileName(this.#title())}-${nameOf(order)}.${FORMATS[order.format].ending}`;
      save(name, file);
      this.#say(`Saved ${name}: ${number(file.size / 1e6, 3)} MB.`, false);
    } catch (problem) {
      if (running.signal.aborted && running.signal.reason instanceof DOMException) this.#say("Cancelled: nothing is saved.", false);
      else this.#say(problem instanceof Error ? problem.message : String(problem), true);
    }
    this.#run(null);
  }

  #run(running: AbortController | null): void {
    this.#running = running;
    this.#fields.disabled = running !== null;
    this.#go.disabled = running !== null || this.#refusal(this.#order) !== null;
    this.#progress.hidden = running === null;
    this.#stop.textContent = running ? "Cancel" : "Close";
    this.#stop.focus();
  }

  #cancel(): void {
    if (this.#running) this.#running.abort();
    else this.#dialog.close();
  }
}

function nameOf({ format, width, height }: Order): string {
  return format === "png" ? `${width}x${height}` : format === "zip" ? "frames" : "film";
}

/** Removes rounding errors. */
function short(value: number): number {
  return Number(value.toPrecision(12));
}

function field(id: string): HTMLInputElement {
  return element("input", { id, type: "number", step: "any", inputmode: "decimal" });
}

function choice(id: string, options: [string, string][]): HTMLSelectElement {
  return element("select", { id }, ...options.map(([value, text]) => element("option", { value }, text)));
}

function labelled(text: string, input: HTMLElement): HTMLElement {
  return element("label", {}, text, input);
}

/** Creates a row with a name and its elements. */
function row(name: string, ...parts: HTMLElement[]): HTMLElement {
  const [only] = parts;
  const isAlone = parts.length === 1 && only !== undefined && only.id !== "";
  const said = isAlone ? element("label", { for: only.id }, name) : element("span", { "aria-hidden": "true" }, name);
  return element("div", { class: "row", ...(isAlone ? {} : { role: "group", "aria-label": name }) }, said, element("div", {}, ...parts));
}

function rename(row: HTMLElement, name: string): void {
  row.setAttribute("aria-label", name);
  row.querySelector("span")?.replaceChildren(name);
}
