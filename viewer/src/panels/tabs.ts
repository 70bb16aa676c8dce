/** Tabs according to the ARIA practices: arrow keys move between them. */
import { element } from "../dom";

export interface Tab {
  id: string;
  title: string;
  /** Fills the panel; the returned function updates it. */
  fill: (host: HTMLElement) => (() => void) | undefined;
}

/** Tabs. A panel is filled when it is first opened, and updated while it is open. */
export class Tabs {
  readonly #bar: HTMLElement;
  readonly #panels: HTMLElement;
  readonly #all: Tab[];
  readonly #filled = new Map<string, (() => void) | undefined>();
  readonly #stale = new Set<string>();
  readonly #listeners: (() => void)[] = [];
  #open = "";

  constructor(bar: HTMLElement, panels: HTMLElement, all: Tab[]) {
    this.#bar = bar;
    this.#panels = panels;
    this.#all = all;
    all.forEach(({ id, title }, k) => {
      const button = element(
        "button",
        { role: "tab", type: "button", id: `tab-${id}`, "aria-controls": `panel-${id}`, click: () => this.open(id) },
        title,
      );
      button.addEventListener("keydown", (event) => {
        const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (step === 0) return;
        event.stopPropagation();
        event.preventDefault();
        const next = all[(k + step + all.length) % all.length].id;
        this.open(next);
        bar.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
      });
      bar.append(button);
      panels.append(
        element("div", { role: "tabpanel", id: `panel-${id}`, "aria-labelledby": `tab-${id}`, class: "panel", hidden: true }),
      );
    });
    this.open(all[0].id);
  }

  /** The open tab. */
  get current(): string {
    return this.#open;
  }

  /** Registers a callback for a change of the open tab. */
  subscribe(listener: () => void): void {
    this.#listeners.push(listener);
  }

  open(id: string): void {
    // On a phone not all tabs are visible. The first one is at the start; scrolling to it would also
    // scroll a page around this one.
    const isScrolled = this.#open !== "" && this.#bar.scrollWidth > this.#bar.clientWidth;
    this.#open = id;
    for (const tab of this.#all) {
      const chosen = tab.id === id;
      const button = this.#bar.querySelector<HTMLButtonElement>(`#tab-${tab.id}`);
      button?.setAttribute("aria-selected", String(chosen));
      if (button) button.tabIndex = chosen ? 0 : -1;
      if (chosen && button && isScrolled) button.scrollIntoView({ block: "nearest", inline: "nearest" });
      const panel = this.#panels.querySelector<HTMLElement>(`#panel-${tab.id}`);
      if (!panel) continue;
      panel.hidden = !chosen;
      if (!chosen) continue;
      if (!this.#filled.has(id)) this.#filled.set(id, tab.fill(panel));
      else if (this.#stale.delete(id)) this.#filled.get(id)?.();
    }
    for (const listener of this.#listeners) listener();
  }

  /** Updates the panels after a change of their contents. */
  refresh(): void {
    for (const id of this.#filled.keys()) {
      if (id === this.#open) this.#filled.get(id)?.();
      else this.#stale.add(id);
    }
  }
}
