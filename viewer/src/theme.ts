/** Light, dark, or as the system has it. */
import { byId } from "./dom";

/** Asking the style sheet costs more than all else about a colour. */
const known = new Map<string, string>();

/** The colour of theme.css with this name, without its dashes. */
export function ink(name: string): string {
  const value = known.get(name) ?? getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  known.set(name, value);
  return value;
}

/** Told that the colours are to be those of the document around. */
const TOLD = "polhode-theme";

/** Takes the colours of the document around. */
export function setTheme(theme: "light" | "dark"): void {
  const root = document.documentElement;
  root.dataset.theme = theme;
  root.dispatchEvent(new Event(TOLD));
}

/** Calls back when the colours have changed. */
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
