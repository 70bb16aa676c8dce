/** A line at the upper edge that says something, or asks what to do. */
import { element } from "../dom";

export class Notice {
  readonly host = element("div", { id: "notice", role: "status", hidden: true });
  #timer = 0;

  /** For some seconds; or until one of the answers is chosen. */
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
