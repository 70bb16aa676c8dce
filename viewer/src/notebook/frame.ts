/** The viewer in a frame of its own, whose scripts reach nothing outside: in a notebook, with the notebook's colours. */
import { PACKED, type ToFrame } from "./message";

/** Where its data go. */
const HELD = 'id="polhode-data" type="application/json">';

/** The viewer's page with packed data in it; an empty text makes it ask for them. */
export function frame(viewer: string, packed: string): HTMLIFrameElement {
  const theme = themeOf(document);
  const made = document.createElement("iframe");
  made.setAttribute("sandbox", "allow-scripts");
  made.title = "motion";
  made.style.cssText = "display: block; width: 100%; height: 640px; border: 0";
  // A function: "$&" in a page is no pattern.
  const page = viewer.replace(HELD, () => `${HELD.replace("application/json", PACKED)}${packed}`);
  made.srcdoc = theme === null ? page : page.replace('<html lang="en">', `<html lang="en" data-theme="${theme}">`);
  const tell = (): void => {
    const now = themeOf(document);
    if (now !== null) send(made, { polhode: "theme", theme: now });
  };
  new MutationObserver(tell).observe(document.body, { attributes: true, attributeFilter: ["data-jp-theme-light", "class"] });
  // JupyterLab takes out what is out of sight: when it comes back it is loaded anew.
  made.addEventListener("load", tell);
  return made;
}

export function send(to: HTMLIFrameElement, message: ToFrame): void {
  to.contentWindow?.postMessage(message, "*");
}

/** Whether JupyterLab or Visual Studio Code are light or dark; null of what has the system's colours. */
function themeOf({ body }: Document): "light" | "dark" | null {
  const isLight = body.dataset.jpThemeLight;
  if (isLight !== undefined) return isLight === "false" ? "dark" : "light";
  if (body.classList.contains("vscode-dark") || body.classList.contains("vscode-high-contrast")) return "dark";
  return body.classList.contains("vscode-light") ? "light" : null;
}
