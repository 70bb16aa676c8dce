/** A message or a question at the upper edge of the page. */
import { element } from "../dom";

export class Notice {
  readonly host = element("div", { id: "notice", role: "status", hidden: true });
  #timer = 0;

  /** Shows a message for some seconds, or until an answer is chosen. */
  say(words: string, answers: { label: string; then: () => void }[] = []): void {
    clearTimeout(this.#timer);
    const close = (): void => {
      this.host.hidden = true;
      this.host.replaceChildren();
    };
    const buttons = (answers.length > 0 ? answers : [{ label: "Close", then: (): void => undefined }]).map(({ label, then }) => {
      const click = (): void => {
        close();
        then();
      };
      return element("button", { type: "button", click }, label);
    });
    this.host.replaceChildren(element("span", {}, words), ...buttons);
    this.host.hidden = false;
    if (answers.length === 0) this.#timer = window.setTimeout(close, 8000);
  }

  clear(): void {
    clearTimeout(this.#timer);
    this.host.hidden = true;
  }
}
