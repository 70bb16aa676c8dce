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
  button.addEventListener("click", () => {
    root.dataset.theme = dark() ? "light" : "dark";
    name();
    changed();
  });
  system.addEventListener("change", changed);
  name();
}
