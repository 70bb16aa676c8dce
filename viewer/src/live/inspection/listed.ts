/** A list whose entries stand in the picture too, and are chosen here or there. */
import { element } from "../../dom";

export interface Listed {
  host: HTMLElement;
  /** How many can be chosen. */
  count: number;
  choose: (item: number | null) => void;
}

/** An entry that can be chosen: what is in it, and in `more` what is seen of it only then. */
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

/** A word in a colour. */
export function badge(text: string, ink: string): HTMLElement {
  const made = element("span", { class: "badge" }, text);
  made.style.setProperty("--ink-of", `var(--${ink})`);
  return made;
}
