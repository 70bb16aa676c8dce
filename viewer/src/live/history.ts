/** History of texts for undo and redo. Changes during one drag are one step. */

/** Maximum length of all texts together, characters. */
const MOST = 4_000_000;

/** Interval within which changes of one kind are one step, ms. */
const TOGETHER = 1000;

export class History {
  #past: string[] = [];
  #future: string[] = [];
  #kind: string | null = null;
  #last = 0;
  #held = false;

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Records the text before it changes; `kind` is the kind of change. */
  touch(text: string, kind: string, now = Date.now()): void {
    const goesOn = kind === this.#kind && (this.#held || now - this.#last < TOGETHER);
    this.#kind = kind;
    this.#last = now;
    this.#future = [];
    if (goesOn) return;
    this.#past.push(text);
    let size = this.#past.reduce((sum, { length }) => sum + length, 0);
    while (size > MOST) size -= this.#past.shift()?.length ?? size;
  }

  /** Makes all changes of one kind one step until `release`, however long they take. */
  hold(): void {
    this.#held = true;
    this.#kind = null;
  }

  release(): void {
    this.#held = false;
    this.#kind = null;
  }

  undo(text: string): string | null {
    return this.#step(this.#past, this.#future, text);
  }

  redo(text: string): string | null {
    return this.#step(this.#future, this.#past, text);
  }

  clear(): void {
    [this.#past, this.#future, this.#kind] = [[], [], null];
  }

  #step(from: string[], to: string[], text: string): string | null {
    const found = from.pop();
    if (found === undefined) return null;
    to.push(text);
    this.#kind = null;
    return found;
  }
}
