/** Actions on the scenario as a whole: the buttons of the heading, and their keys. */
import { element } from "../dom";
import { fileName, save } from "../save/files";
import { fragmentOf, LONGEST } from "./link";
import type { Notice } from "./notice";
import type { Session } from "./session";

export class Actions {
  readonly host = element("div", { id: "actions", role: "group", "aria-label": "Scenario" });
  readonly #session: Session;
  readonly #notice: Notice;
  readonly #undo = this.#button("Undo", "Undo (Ctrl+Z)", () => this.#session.undo());
  readonly #redo = this.#button("Redo", "Redo (Ctrl+Y)", () => this.#session.redo());
  readonly #reset = this.#button("Reset", "Back to the file's text", () => this.#session.reset());

  constructor(session: Session, notice: Notice) {
    this.#session = session;
    this.#notice = notice;
    const link = this.#button("Link", "A link that brings this state back", () => void this.#link());
    const toml = this.#button("Save TOML", "Save the scenario", () => this.#save());
    this.host.append(this.#undo, this.#redo, this.#reset, link, toml);
    session.listen({ changed: () => this.#update() });
    this.#update();
    document.addEventListener("keydown", (event) => {
      // In a text field, its own undo takes precedence.
      const isTyped = event.target instanceof HTMLElement && event.target.closest("input:not([type=range]), textarea, [contenteditable=true]");
      if (isTyped || document.body.classList.contains("reporting") || event.altKey || !(event.ctrlKey || event.metaKey)) return;
      const key = event.key.toLowerCase();
      if (key === "z" && !event.shiftKey) session.undo();
      else if (key === "y" || (key === "z" && event.shiftKey)) session.redo();
      else return;
      event.preventDefault();
    });
  }

  #button(text: string, title: string, click: () => void): HTMLButtonElement {
    return element("button", { type: "button", title, click }, text);
  }

  #update(): void {
    const { history, isChanged } = this.#session;
    this.#undo.disabled = !history.canUndo;
    this.#redo.disabled = !history.canRedo;
    this.#reset.disabled = !isChanged;
  }

  async #link(): Promise<void> {
    const { document, text } = this.#session;
    const fragment = await fragmentOf({ name: document?.name ?? "", text });
    if (fragment.length > LONGEST) {
      this.#notice.say(`The scenario is too long for a link (${Math.ceil(fragment.length / 1000)} kB of ${LONGEST / 1000}): save it as TOML.`);
      return;
    }
    history.replaceState(null, "", fragment);
    try {
      await navigator.clipboard.writeText(location.href);
      this.#notice.say("The link is copied; it is the page's address too.");
    } catch {
      this.#notice.say("The page's address is the link now.");
    }
  }

  #save(): void {
    const { document, text } = this.#session;
    const name = document?.name.replace(/\.[^.]*$/, "") ?? "scenario";
    save(`${fileName(name)}.toml`, new Blob([text], { type: "application/toml" }));
  }
}
