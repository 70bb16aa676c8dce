/**
 * The session: the scenario's text is the only state. Knobs and scene request edits, and the editor
 * sends a new text. The engine answers with the text, its motion and its knobs. At most one request
 * is in flight. Meanwhile, only the latest value of each key waits.
 */
import type { FreeData, PageData, Shape } from "../data";
import { History } from "./history";
import type { DocumentInfo, Edit, Knob, MotionAnswer, Switch, TextError } from "./protocol";
import { engine, Refused } from "./engine";

/** Delay after the last change until the slow parts are requested too, ms. */
const SETTLED = 250;
/** Time after which a request is abandoned if another one waits, ms. */
const PATIENCE = { least: 60, most: 4000 };

export interface Trouble {
  message: string;
  hint: string | null;
  /** Key of the knob that caused it. */
  key: string | null;
}

/** Listener of the session. */
export interface Listener {
  /** Called when text, knobs, errors or the undo history have changed. */
  changed?: () => void;
  /**
   * Called for another motion; `anew` for another document, `isWorked` if the worked solution
   * belongs to it.
   */
  moved?: (page: PageData, how: { anew: boolean; isWorked: boolean }) => void;
}

export class Session {
  document: DocumentInfo | null = null;
  /** Text of the file. */
  fileText = "";
  text = "";
  knobs: Knob[] = [];
  switches: Switch[] = [];
  errors: TextError[] = [];
  /**
   * Error that explains why the motion is not that of the text, or the text not as requested; null
   * otherwise.
   */
  trouble: Trouble | null = null;
  /** Time of the last answer, ms: in the engine, and in total. */
  took = { there: 0, all: 0 };
  /** Returns true if the worked solution is visible. */
  wantsWorking = (): boolean => false;

  readonly history = new History();
  readonly #listeners: Listener[] = [];
  readonly #waiting = new Map<string, Edit>();
  #flight: { stop: AbortController; since: number; edits: Map<string, Edit> } | null = null;
  /** Version of the text in flight. Answers to older versions are dropped. */
  #version = 0;
  #isDue = false;
  #anew = false;
  #patience: number = PATIENCE.least;
  #timer = 0;
  #lastKey: string | null = null;
  /** Reason why the last edit could not be made. */
  #refused: Trouble | null = null;
  #body: { key: string; shapes: Shape[]; others: Pick<FreeData, "family" | "separatrix"> | null } | null = null;

  listen(listener: Listener): void {
    this.#listeners.push(listener);
  }

  get isChanged(): boolean {
    return this.text !== this.fileText;
  }

  /** True if the motion shown belongs to the current text. */
  get isSettled(): boolean {
    return this.#flight === null && !this.#isDue && this.trouble === null;
  }

  /** Opens a document; `text` replaces its own if that was changed. */
  open(document: DocumentInfo, fileText: string, text = fileText): void {
    this.document = document;
    this.fileText = fileText;
    [this.knobs, this.switches] = [[], []];
    this.history.clear();
    this.#anew = true;
    this.#take(text);
  }

  /** Replaces the text after the file has changed. */
  reload(document: DocumentInfo, fileText: string): void {
    this.document = document;
    this.fileText = fileText;
    if (fileText === this.text) this.tell();
    else this.replace(fileText, "file");
  }

  /**
   * Replaces the text. `kind` is the kind of change: successive changes of one kind are one undo
   * step.
   */
  replace(text: string, kind: string): void {
    if (text === this.text) return;
    this.history.touch(this.text, kind);
    this.#take(text);
  }

  reset(): void {
    this.replace(this.fileText, "reset");
  }

  undo(): void {
    const text = this.history.undo(this.text);
    if (text !== null) this.#take(text);
  }

  redo(): void {
    const text = this.history.redo(this.text);
    if (text !== null) this.#take(text);
  }

  edit(edit: Edit): void {
    const key = keyOf(edit);
    this.history.touch(this.text, key);
    // An attitude edit also contains ω.
    if (key === "attitude") this.#waiting.delete("omega");
    this.#waiting.delete(key);
    this.#waiting.set(key, edit);
    this.#lastKey = key;
    this.#refused = null;
    this.#isDue = true;
    this.#go();
  }

  /** Returns true if a later value of this key is waiting: the last answer has an older value. */
  isWaiting(key: string): boolean {
    return this.#waiting.has(key);
  }

  /** All changes of one kind until `release` are one undo step. */
  hold(): void {
    this.history.hold();
  }

  release(): void {
    this.history.release();
  }

  /** Requests everything again, because panels that need the slow parts have been opened. */
  settle(): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => void this.#send(true), this.#isDue || this.#flight ? SETTLED : 0);
  }

  #take(text: string): void {
    this.text = text;
    this.#version += 1;
    this.#waiting.clear();
    this.#flight?.stop.abort();
    this.#flight = null;
    this.#lastKey = null;
    this.#refused = null;
    this.#isDue = true;
    this.tell();
    this.#go();
  }

  #go(): void {
    clearTimeout(this.#timer);
    if (!this.#flight) {
      if (this.#isDue) void this.#send(false);
      return;
    }
    if (!this.#isDue) return;
    const left = this.#patience - (performance.now() - this.#flight.since);
    if (left > 0) {
      this.#timer = window.setTimeout(() => this.#go(), left);
      return;
    }
    // The request would have succeeded later: wait longer for the next one.
    this.#patience = Math.min(2 * this.#patience, PATIENCE.most);
    const { stop, edits } = this.#flight;
    this.#flight = null;
    stop.abort();
    const newer = [...this.#waiting];
    this.#waiting.clear();
    for (const [key, edit] of [...edits, ...newer]) this.#waiting.set(key, edit);
    void this.#send(false);
  }

  async #send(isFull: boolean): Promise<void> {
    if (!this.document || this.#flight) return;
    const edits = new Map(this.#waiting);
    const flight = { stop: new AbortController(), since: performance.now(), edits };
    const version = this.#version;
    this.#waiting.clear();
    this.#isDue = false;
    this.#flight = flight;
    const working = isFull || this.wantsWorking();
    const request = { document: this.document.id, text: this.text, edits: [...edits.values()], error: isFull, working, body: this.#body?.key ?? null };
    try {
      const answer = await engine.motion(request, flight.stop.signal);
      if (this.#flight !== flight || version !== this.#version) return;
      this.#flight = null;
      const all = performance.now() - flight.since;
      this.took = { there: answer.took, all };
      if (!isFull) this.#patience = Math.min(Math.max(PATIENCE.least, 2 * all), PATIENCE.most);
      this.#receive(answer, working);
    } catch (problem) {
      if (this.#flight !== flight) return;
      this.#flight = null;
      this.#fail(problem);
      return;
    }
    if (this.#isDue) this.#go();
    else if (!isFull) this.#timer = window.setTimeout(() => void this.#send(true), SETTLED);
  }

  #receive(answer: MotionAnswer, isWorked: boolean): void {
    this.text = answer.text;
    this.errors = answer.errors;
    // A text with an error has only some of its knobs; they all return when it is fixed.
    if (answer.motion || this.knobs.length === 0) [this.knobs, this.switches] = [answer.knobs, answer.switches];
    const [error] = answer.errors;
    const trouble = { message: error?.message ?? "no motion could be computed", hint: error?.hint ?? null, key: this.#lastKey };
    // An error together with a motion belongs to an edit that could not be made. The text is
    // unchanged, and the error is shown until the next change.
    if (answer.motion && error) this.#refused = trouble;
    this.trouble = answer.motion ? this.#refused : trouble;
    if (answer.motion) {
      const { page, body } = answer.motion;
      if (this.#body?.key === body) {
        page.body.shapes = this.#body.shapes;
        if (page.free) Object.assign(page.free, this.#body.others);
      } else {
        const others = page.free && { family: page.free.family, separatrix: page.free.separatrix };
        this.#body = { key: body, shapes: page.body.shapes, others };
      }
      const anew = this.#anew;
      this.#anew = false;
      try {
        for (const { moved } of this.#listeners) moved?.(page, { anew, isWorked });
      } catch (problem) {
        this.#fail(problem);
        return;
      }
    }
    this.tell();
  }

  #fail(problem: unknown): void {
    const message = problem instanceof Error ? problem.message : String(problem);
    this.trouble = { message, hint: problem instanceof Refused ? problem.hint : null, key: this.#lastKey };
    this.tell();
  }

  /** Notifies the listeners. */
  tell(): void {
    for (const { changed } of this.#listeners) changed?.();
  }
}

/** Returns the key of the value that an edit changes. */
export function keyOf(edit: Edit): string {
  if ("set" in edit) return edit.set;
  if ("attitude" in edit) return "attitude";
  return "omega" in edit ? "omega" : "moments";
}
