/** Tabs as the ARIA practices have them: arrow keys move between them. */
import { element } from "../dom";

export interface Tab {
  id: string;
  title: string;
  fill: (host: HTMLElement) => void;
}

/** A tab's panel is filled when it is first opened. */
export function tabs(bar: HTMLElement, panels: HTMLElement, all: Tab[]): (id: string) => void {
  const filled = new Set<string>();
  const open = (id: string): void => {
    for (const tab of all) {
      const chosen = tab.id === id;
      const button = bar.querySelector<HTMLButtonElement>(`#tab-${tab.id}`);
      button?.setAttribute("aria-selected", String(chosen));
      if (button) button.tabIndex = chosen ? 0 : -1;
      const panel = panels.querySelector<HTMLElement>(`#panel-${tab.id}`);
      if (!panel) continue;
      panel.hidden = !chosen;
      if (chosen && !filled.has(id)) {
        filled.add(id);
        tab.fill(panel);
      }
    }
  };
  all.forEach(({ id, title }, k) => {
    const button = element(
      "button",
      { role: "tab", type: "button", id: `tab-${id}`, "aria-controls": `panel-${id}`, click: () => open(id) },
      title,
    );
    button.addEventListener("keydown", (event) => {
      const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (step === 0) return;
      event.stopPropagation();
      event.preventDefault();
      const next = all[(k + step + all.length) % all.length].id;
      open(next);
      bar.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
    });
    bar.append(button);
    panels.append(
      element("div", { role: "tabpanel", id: `panel-${id}`, "aria-labelledby": `tab-${id}`, class: "panel", hidden: true }),
    );
  });
  open(all[0].id);
  return open;
}
