/** Dialog for a question with yes and no. */
import { element } from "../dom";

let open: Promise<boolean> | null = null;

/**
 * Asks a question; the result is false if it is closed without an answer. While a question is open,
 * further calls get its answer.
 */
export function ask(words: string, yes: string): Promise<boolean> {
  open ??= new Promise<boolean>((resolve) => {
    const dialog = element("dialog", { class: "question" });
    const answer = (value: string, text: string): HTMLElement => element("button", { type: "button", click: () => dialog.close(value) }, text);
    dialog.append(element("p", {}, words), element("div", { class: "answers" }, answer("yes", yes), answer("no", "Cancel")));
    dialog.addEventListener("close", () => {
      dialog.remove();
      open = null;
      resolve(dialog.returnValue === "yes");
    });
    document.body.append(dialog);
    dialog.showModal();
  });
  return open;
}
