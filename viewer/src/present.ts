/**
 * Presentation: full screen with large type, where a key reveals one step after the other: the
 * body, the answer, then the sections of the open panel.
 */
import { byId } from "./dom";
import type { Tabs } from "./panels/tabs";

/** Size of the type of plots relative to that of the page. */
const LARGE = 1.5;
/** Steps before the sections of the panel: the body alone, and the answer. */
const FIRST = 2;

/** What a presentation changes. */
interface Presented {
  /** Actions of keys. */
  keys: Map<string, () => void>;
  tabs: Tabs;
  /** Sets the size of the type of plots. */
  magnify(size: number): void;
}

export class Presentation {
  readonly #app: Presented;
  #step: number | null = null;

  constructor(app: Presented) {
    this.#app = app;
    byId("present").addEventListener("click", () => this.toggle());
    app.keys.set("p", () => this.toggle());
    app.tabs.subscribe(() => this.#show());
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement && this.#step !== null) this.toggle();
    });
  }

  /** Number of the step that is shown, from 0; null outside a presentation. */
  get step(): number | null {
    return this.#step;
  }

  toggle(): void {
    const isOn = this.#step === null;
    this.#step = isOn ? 0 : null;
    const { keys } = this.#app;
    const own: [string, () => void][] = [
      ["PageDown", () => this.#go(1)],
      ["PageUp", () => this.#go(-1)],
      ["Escape", () => this.toggle()],
    ];
    for (const [key, act] of own) {
      if (isOn) keys.set(key, act);
      else keys.delete(key);
    }
    document.body.classList.toggle("presenting", isOn);
    byId("present").setAttribute("aria-pressed", String(isOn));
    this.#app.magnify(isOn ? LARGE : 1);
    this.#show();
    // Without permission it stays in its window.
    if (isOn) void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement) void document.exitFullscreen();
  }

  // Sections of the open panel: plots, or the blocks of the worked solution.
  #sections(): HTMLElement[] {
    const panel = byId(`panel-${this.#app.tabs.current}`);
    const plots = [...panel.querySelectorAll<HTMLElement>(".plot")];
    return plots.length > 0 ? plots : ([...panel.children] as HTMLElement[]);
  }

  #go(by: number): void {
    if (this.#step === null) return;
    this.#step = Math.min(Math.max(this.#step + by, 0), FIRST - 1 + this.#sections().length);
    this.#show();
    if (by > 0) this.#sections()[this.#step - FIRST]?.scrollIntoView({ block: "nearest" });
  }

  #show(): void {
    const step = this.#step ?? Infinity;
    document.body.classList.toggle("present-body", step < 1);
    document.body.classList.toggle("present-view", step < FIRST);
    this.#sections().forEach((section, k) => section.classList.toggle("later", k + FIRST > step));
  }
}
