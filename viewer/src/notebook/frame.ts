/** The viewer in a sandboxed frame of a notebook, with the notebook's colours. */
import { PACKED, type ToFrame } from "./message";

/** Place of the data in the page. */
const HELD = 'id="polhode-data" type="application/json">';

/**
 * Creates a frame with the viewer's page and packed data. With an empty text, the page requests the
 * data.
 */
export function frame(viewer: string, packed: string): HTMLIFrameElement {
  const theme = themeOf(document);
  const made = document.createElement("iframe");
  made.setAttribute("sandbox", "allow-scripts");
  made.title = "motion";
  made.style.cssText = "display: block; width: 100%; height: 640px; border: 0";
  // A function, because "$&" in a page is not a pattern.
  const page = viewer.replace(HELD, () => `${HELD.replace("application/json", PACKED)}${packed}`);
  made.srcdoc = theme === null ? page : page.replace('<html lang="en">', `<html lang="en" data-theme="${theme}">`);
  const tell = (): void => {
    const now = themeOf(document);
    if (now !== null) send(made, { polhode: "theme", theme: now });
  };
  new MutationObserver(tell).observe(document.body, { attributes: true, attributeFilter: ["data-jp-theme-light", "class"] });
  // JupyterLab removes outputs that are out of sight. When they return, they are loaded again.
  made.addEventListener("load", tell);
  return made;
}

export function send(to: HTMLIFrameElement, message: ToFrame): void {
  to.contentWindow?.postMessage(message, "*");
}

/**
 * Returns the theme of JupyterLab or Visual Studio Code; null for programs with the system's
 * colours.
 */
function themeOf({ body }: Document): "light" | "dark" | null {
  const isLight = body.dataset.jpThemeLight;
  if (isLight !== undefined) return isLight === "false" ? "dark" : "light";
  if (body.classList.contains("vscode-dark") || body.classList.contains("vscode-high-contrast")) return "dark";
  return body.classList.contains("vscode-light") ? "light" : null;
}
