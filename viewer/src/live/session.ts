/**
 * The scenario's text, which is all the state that there is. Knobs and the scene ask for edits, the editor for another text; the server
 * answers with the text, its motion and its knobs. One request is under way at most, and the newest of what came meanwhile waits: of
 * each key the last value.
 */
import type { FreeData, PageData, Shape } from "../data";
import { History } from "./history";
import type { DocumentInfo, Edit, Knob, MotionAnswer, Switch, TextError } from "./protocol";
import { Refused, server } from "./server";

/** After the last change all is asked for, with what takes time, ms. */
const SETTLED = 250;
/** A request is given up if it takes longer and another waits, ms. */
const PATIENCE = { least: 60, most: 4000 };

export interface Trouble {
  message: string;
  hint: string | null;
  /** The knob that was turned to it. */
  key: string | null;
}

/** What hears of the session. */
export interface Listener {
  /** Text, knobs, errors, or what can be undone have changed. */
  changed?: () => void;
  /** Another motion; `anew` of another document, `isWorked` if the worked solution is its. */
  moved?: (page: PageData, how: { anew: boolean; isWorked: boolean }) => void;
}

export class Session {
  document: DocumentInfo | null = null;
  /** As the file has it. */
  fileText = "";
  text = "";
  knobs: Knob[] = [];
  switches: Switch[] = [];
  errors: TextError[] = [];
  /** Why the motion that is shown is not that of the text, or the text not what was asked for; null if both are. */
  trouble: Trouble | null = null;
  /** ms that the last answer took there, and on the way. */
  took = { there: 0, all: 0 };
  /** Whether the worked solution is looked at. */
  wantsWorking = (): boolean => false;

  readonly history = new History();
  readonly #listeners: Listener[] = [];
  readonly #waiting = new Map<string, Edit>();
  #flight: { stop: AbortController; since: number; edits: Map<string, Edit> } | null = null;
  /** Of the text that is under way: an answer to an older one is nothing. */
  #version = 0;
  #isDue = false;
  #anew = false;
  #patience: number = PATIENCE.least;
  #timer = 0;
  #lastKey: string | null = null;
  /** Why the last edit could not be made. */
  #refused: Trouble | null = null;
  #body: { key: string; shapes: Shape[]; others: Pick<FreeData, "family" | "separatrix"> | null } | null = null;

  listen(listener: Listener): void {
    this.#listeners.push(listener);
  }

  get isChanged(): boolean {
    return this.text !== this.fileText;
  }

  /** Whether what is shown is of the text as it is. */
  get isSettled(): boolean {
    return this.#flight === null && !this.#isDue && this.trouble === null;
  }

  /** Begins with a document; `text` instead of its own if that was changed. */
  open(document: DocumentInfo, fileText: string, text = fileText): void {
    this.document = document;
    this.fileText = fileText;
    [this.knobs, this.switches] = [[], []];
    this.history.clear();
    this.#anew = true;
    this.#take(text);
  }

  /** The file is another one now. */
  reload(document: DocumentInfo, fileText: string): void {
    this.document = document;
    this.fileText = fileText;
    if (fileText === this.text) this.tell();
    else this.replace(fileText, "file");
  }

  /** Another text, by `kind`: changes of one kind that follow each other are one step of undoing. */
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
    // An attitude with its ω says all that an ω says.
    if (key === "attitude") this.#waiting.delete("omega");
    this.#waiting.delete(key);
    this.#waiting.set(key, edit);
    this.#lastKey = key;
    this.#refused = null;
    this.#isDue = true;
    this.#go();
  }

  /** Whether a later value of this key is still to be sent: what the last answer says of it is of before. */
  isWaiting(key: string): boolean {
    return this.#waiting.has(key);
  }

  /** Between the two all changes of one thing are one step of undoing. */
  hold(): void {
    this.history.hold();
  }

  release(): void {
    this.history.release();
  }

  /** Asks for all again: the panels that need what takes time are open. */
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
    // It would answer at last: the next one is waited for longer.
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
      const answer = await server.motion(request, flight.stop.signal);
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
    // A text with an error has but some of its knobs, and will have all again.
    if (answer.motion || this.knobs.length === 0) [this.knobs, this.switches] = [answer.knobs, answer.switches];
    const [error] = answer.errors;
    const trouble = { message: error?.message ?? "there is no motion", hint: error?.hint ?? null, key: this.#lastKey };
    // Beside a motion an error is of an edit that could not be made: the text is as it was, and it is said until the next change.
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

  /** Listeners are told how it stands. */
  tell(): void {
    for (const { changed } of this.#listeners) changed?.();
  }
}

/** What an edit changes. */
export function keyOf(edit: Edit): string {
  if ("set" in edit) return edit.set;
  if ("attitude" in edit) return "attitude";
  return "omega" in edit ? "omega" : "moments";
}
