/** The HTML page of a report inside this page: its own style in a shadow, with this page's colours. */
import { element } from "../../dom";

/** Figures are drawn on white paper; a dark page turns them over. */
const OWN = ".page { padding: 4px 20px 40px; max-width: 60rem; } .page h1:first-child { margin-top: 12px; } figure svg { filter: var(--figure); }";

export function showPage(host: HTMLElement, html: string): void {
  // Scripts of a parsed page do not run.
  const page = new DOMParser().parseFromString(html, "text/html");
  const styles = [...page.querySelectorAll("style")].map(({ textContent }) => textContent ?? "");
  const content = page.querySelector("main") ?? page.body;
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  root.replaceChildren(element("style", {}, ...styles, OWN), element("div", { class: "page" }, ...content.childNodes));
}
