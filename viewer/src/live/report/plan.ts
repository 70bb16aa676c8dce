/** Text of a plan that is edited, with its history. */
import type { Edited } from "../editor";
import { History } from "../history";
import type { DocumentInfo, TextError } from "../protocol";

export class Plan implements Edited {
  readonly document: DocumentInfo;
  text: string;
  errors: TextError[] = [];
  readonly #history = new History();
  readonly #listeners: (() => void)[] = [];
  readonly #edited: () => void;

  /** `edited` is called when the text has another content. */
  constructor(document: DocumentInfo, text: string, edited: () => void) {
    this.document = document;
    this.text = text;
    this.#edited = edited;
  }

  listen({ changed }: { changed: () => void }): void {
    this.#listeners.push(changed);
  }

  replace(text: string, kind: string): void {
    if (text === this.text) return;
    this.#history.touch(this.text, kind);
    this.#take(text);
  }

  undo(): void {
    this.#take(this.#history.undo(this.text));
  }

  redo(): void {
    this.#take(this.#history.redo(this.text));
  }

  /** Shows the errors of the text. */
  tell(errors: TextError[]): void {
    this.errors = errors;
    for (const changed of this.#listeners) changed();
  }

  #take(text: string | null): void {
    if (text === null) return;
    this.text = text;
    this.tell(this.errors);
    this.#edited();
  }
}
