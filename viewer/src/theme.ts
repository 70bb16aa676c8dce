/** Light, dark, or as the system has it. */
import { byId } from "./dom";

/** Calls back when the colours have changed. */
export function onTheme(changed: () => void): void {
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
