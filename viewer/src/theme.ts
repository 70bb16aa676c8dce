/** Theme: light, dark, or that of the system. */
import { byId, element } from "./dom";

/** Cache, because reading the style sheet is slow. */
const known = new Map<string, string>();

/** Element whose colour is read: the property has the colours of both themes. */
let probe: HTMLElement | null = null;

/** Returns the colour of theme.css with this name, without its dashes, as #rrggbb. */
export function ink(name: string): string {
  const value = known.get(name) ?? read(name);
  known.set(name, value);
  return value;
}

function read(name: string): string {
  if (!probe) document.body.append((probe = element("span", { hidden: true })));
  probe.style.color = `var(--${name})`;
  const channels = getComputedStyle(probe).color.match(/\d+/g) ?? [];
  return `#${channels.slice(0, 3).map((c) => Number(c).toString(16).padStart(2, "0")).join("")}`;
}

/** Message that sets the theme of the surrounding document. */
const TOLD = "polhode-theme";

/** Takes the theme of the surrounding document. */
export function setTheme(theme: "light" | "dark"): void {
  const root = document.documentElement;
  root.dataset.theme = theme;
  root.dispatchEvent(new Event(TOLD));
}

/** Registers a callback for changes of the colours. */
export function onTheme(then: () => void): void {
  const changed = (): void => {
    known.clear();
    then();
  };
  const system = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  const dark = (): boolean => (root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark";
  const button = byId<HTMLButtonElement>("theme");
  const name = (): void => button.setAttribute("aria-label", dark() ? "Light colours" : "Dark colours");
  root.addEventListener(TOLD, () => {
    name();
    changed();
  });
  button.addEventListener("click", () => setTheme(dark() ? "light" : "dark"));
  system.addEventListener("change", changed);
  name();
}
