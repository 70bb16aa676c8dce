/** A list whose entries are also in the picture, and can be selected in both. */
import { element } from "../../dom";

export interface Listed {
  host: HTMLElement;
  /** Number of items that can be selected. */
  count: number;
  choose: (item: number | null) => void;
}

/** Creates a selectable entry. `more` is visible only while the entry is selected. */
export function entry(item: number, choose: (item: number) => void, said: (Node | string)[], more: (Node | string)[] = []): HTMLElement {
  const button = element("button", { type: "button", class: "entry", "aria-pressed": "false", click: () => choose(item) }, ...said);
  const host = element("li", { "data-item": String(item) }, button);
  if (more.length > 0) host.append(element("div", { class: "entry-more", hidden: true }, ...more));
  return host;
}

export function listed(host: HTMLElement, count: number): Listed {
  const choose = (item: number | null): void => {
    for (const one of host.querySelectorAll<HTMLElement>("[data-item]")) {
      const isChosen = one.dataset.item === String(item);
      one.querySelector(".entry")?.setAttribute("aria-pressed", String(isChosen));
      const more = one.querySelector<HTMLElement>(".entry-more");
      if (more) more.hidden = !isChosen;
      if (!isChosen) continue;
      one.closest("details")?.setAttribute("open", "");
      one.scrollIntoView({ block: "nearest" });
    }
  };
  return { host, count, choose };
}

/** Creates a coloured word. */
export function badge(text: string, ink: string): HTMLElement {
  const made = element("span", { class: "badge" }, text);
  made.style.setProperty("--ink-of", `var(--${ink})`);
  return made;
}
