/** The HTML page of a report inside this page: a shadow tree with its own style. */
import { element } from "../../dom";

/** The list of contents is above the report, because this page has other things beside it. */
const HERE = "body { display: block; max-width: 76rem; padding: 8px 20px 40px; } nav { position: static; max-height: none; border: 0; margin-top: 1.2rem; } nav ul { columns: 15rem; }";

export function showPage(host: HTMLElement, html: string): void {
  // Scripts of a parsed page do not run.
  const page = new DOMParser().parseFromString(html, "text/html");
  const styles = [...page.querySelectorAll("style")].map(({ textContent }) => textContent ?? "");
  const root = host.shadowRoot ?? shadow(host);
  root.replaceChildren(element("style", {}, ...styles, HERE), page.body);
}

/** The address of this page is that of its state: a link in the report scrolls to its section. */
function shadow(host: HTMLElement): ShadowRoot {
  const root = host.attachShadow({ mode: "open" });
  root.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest("a") : null;
    const id = link?.getAttribute("href");
    if (!id?.startsWith("#")) return;
    event.preventDefault();
    root.getElementById(id.slice(1))?.scrollIntoView();
  });
  return root;
}
