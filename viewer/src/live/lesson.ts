/**
 * Lessons: the list, and the open lesson with its steps: read, predict, see, change. Until the
 * question of a step is answered, the scene shows only the body at the start.
 */
import type { App } from "../app";
import { element } from "../dom";
import { working } from "../panels/working";
import type { DocumentInfo, Lesson, LessonInfo, LessonStep } from "./protocol";
import { engine, reason } from "./engine";
import type { Session } from "./session";

interface Surroundings {
  app: App;
  session: Session;
  /** Selects the only knobs to show; null for all. */
  choose: (keys: string[] | null) => void;
  /** Called with all documents after a lesson has been opened. */
  listed: (documents: DocumentInfo[]) => void;
  say: (words: string) => void;
}

export class Lessons {
  readonly host = element("div", { class: "lesson" });
  readonly #of: Surroundings;
  #lesson: Lesson | null = null;
  #document: DocumentInfo | null = null;
  #k = 0;
  /** Chosen answer of each step. */
  readonly #chosen = new Map<number, number>();
  readonly #working = element("details", { class: "lesson-working" });
  /** Elements that are disabled before the answer. */
  readonly #covered = [".bar", ".transport", "#legend", "#knobs"];

  constructor(of: Surroundings) {
    this.#of = of;
    const { app, session } = of;
    app.clock.subscribe(() => {
      if (this.isAsking && (app.clock.playing || app.clock.time !== app.clock.start)) this.#rewind();
    });
    session.listen({
      moved: () => this.#work(),
      changed: () => {
        if (this.#lesson && session.document?.id !== this.#lesson.document) this.#close();
      },
    });
    this.#working.addEventListener("toggle", () => {
      if (this.#working.open) session.settle();
    });
    void this.#list();
  }

  /** True if the worked solution is open in the lesson. */
  get wantsWorking(): boolean {
    return this.#lesson !== null && this.#working.open && this.#of.app.tabs.current === "lesson";
  }

  get isAsking(): boolean {
    return this.#step?.question != null && !this.#chosen.has(this.#k);
  }

  get #step(): LessonStep | undefined {
    return this.#lesson?.steps[this.#k];
  }

  /** Opens a lesson at its first step. */
  async open(id: string): Promise<void> {
    if (!(await this.#read(id))) return;
    this.#chosen.clear();
    history.replaceState(null, "", `#lesson=${encodeURIComponent(id)}`);
    this.#of.app.tabs.open("lesson");
    this.#go(0);
    this.#of.listed((await engine.documents()).documents);
  }

  /**
   * Reads the lesson again if its file has changed, and continues at the same step. Returns false
   * if the document is not that of the open lesson.
   */
  async reread(document: number): Promise<boolean> {
    if (this.#lesson?.document !== document) return false;
    if (await this.#read(this.#lesson.id)) this.#go(Math.min(this.#k, this.#lesson.steps.length - 1));
    return true;
  }

  async #read(id: string): Promise<boolean> {
    try {
      const lesson = await engine.lesson(id);
      const { documents } = await engine.documents();
      const document = documents.find((one) => one.id === lesson.document);
      if (!document) throw new Error("the lesson's scenario is not there");
      [this.#lesson, this.#document] = [lesson, document];
      return true;
    } catch (problem) {
      this.#of.say(reason(problem));
      return false;
    }
  }

  #close(): void {
    if (!this.#lesson) return;
    this.#lesson = null;
    this.#of.choose(null);
    this.#cover();
    if (location.hash.startsWith("#lesson=")) history.replaceState(null, "", location.pathname);
    void this.#list();
  }

  async #list(): Promise<void> {
    let all: LessonInfo[] = [];
    try {
      all = (await engine.lessons()).lessons;
    } catch (problem) {
      this.#of.say(problem instanceof Error ? problem.message : String(problem));
    }
    if (this.#lesson) return;
    const one = ({ id, title, summary }: LessonInfo): HTMLElement =>
      element("li", {}, element("button", { type: "button", click: () => void this.open(id) }, title), element("p", {}, summary));
    this.host.replaceChildren(element("h2", {}, "Lessons"), element("p", {}, "Read, predict, see, turn."), element("ol", { class: "lessons" }, ...all.map(one)));
  }

  #go(k: number): void {
    this.#k = k;
    const step = this.#step;
    if (!this.#lesson || !this.#document || !step) return;
    this.#of.choose(step.knobs);
    this.#cover();
    this.#of.session.open(this.#document, step.scenario);
    this.#show();
    this.host.querySelector<HTMLElement>("h3")?.focus({ preventScroll: true });
    this.host.parentElement?.scrollIntoView({ block: "nearest" });
  }

  #show(): void {
    const [lesson, step] = [this.#lesson, this.#step];
    if (!lesson || !step) return;
    const count = lesson.steps.length;
    const button = (text: string, isOn: boolean, click: () => void): HTMLButtonElement => {
      const made = element("button", { type: "button", click }, text);
      made.disabled = !isOn;
      return made;
    };
    const isLast = this.#k === count - 1;
    const next = isLast ? button("Other lessons", !this.isAsking, () => this.#close()) : button("Next", !this.isAsking, () => this.#go(this.#k + 1));
    next.classList.add("lesson-next");
    this.host.replaceChildren(
      element("div", { class: "lesson-head" }, element("h2", {}, lesson.title), button("All lessons", true, () => this.#close())),
      element("h3", { tabindex: "-1" }, `Step ${this.#k + 1} of ${count}`),
      ...paragraphs(step.text),
      ...this.#question(step),
      this.#working,
      element("nav", { class: "lesson-nav", "aria-label": "Steps" }, button("Back", this.#k > 0, () => this.#go(this.#k - 1)), next),
    );
    this.#working.hidden = step.working === null || this.isAsking;
    this.#work();
  }

  #question({ question }: LessonStep): HTMLElement[] {
    if (!question) return [];
    const chosen = this.#chosen.get(this.#k);
    const submit = element("button", { type: "submit" }, "This is my prediction");
    submit.disabled = true;
    const choices = question.answers.map((answer, k) => {
      const input = element("input", { type: "radio", name: "answer", value: String(k) });
      input.checked = chosen === k;
      input.disabled = chosen !== undefined;
      input.addEventListener("change", () => void (submit.disabled = false));
      const isRight = chosen !== undefined && k === question.right;
      const mark = isRight ? "✓ right" : chosen === k ? "✗" : "";
      const label = element("label", { class: isRight ? "right" : "" }, input, element("span", {}, answer), ...(mark ? [element("span", { class: "mark" }, mark)] : []));
      return label;
    });
    const form = element("form", { class: "lesson-question" }, element("fieldset", {}, element("legend", {}, question.text), ...choices));
    if (chosen === undefined) form.append(submit);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const picked = form.querySelector<HTMLInputElement>("input:checked");
      if (picked && this.isAsking) this.#answer(Number(picked.value));
    });
    const why = element("div", { class: "lesson-why", role: "status", tabindex: "-1" });
    if (chosen !== undefined) {
      const [first, ...rest] = paragraphs(question.why);
      first.prepend(element("strong", {}, chosen === question.right ? "Right. " : "Not quite. "));
      why.append(first, ...rest);
    }
    return [form, why];
  }

  #answer(k: number): void {
    this.#chosen.set(this.#k, k);
    this.#cover();
    this.#show();
    this.host.querySelector<HTMLElement>(".lesson-why")?.focus({ preventScroll: true });
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.#of.app.clock.play();
  }

  #cover(): void {
    const { app } = this.#of;
    document.body.classList.toggle("asking", this.isAsking);
    for (const part of this.#covered) document.querySelector<HTMLElement>(part)?.toggleAttribute("inert", this.isAsking);
    if (app.view) app.view.isBare = this.isAsking;
    if (this.isAsking) this.#rewind();
  }

  #rewind(): void {
    const { clock } = this.#of.app;
    if (clock.playing) clock.pause();
    if (clock.time !== clock.start) clock.set(clock.start);
  }

  // Shows the part of the worked solution that belongs to the step.
  #work(): void {
    const wanted = this.#step?.working;
    if (wanted == null || this.isAsking) return;
    const blocks = this.#of.app.page.explanation;
    const begin = blocks.findIndex((block) => block.kind === "heading" && block.level === 2 && block.text.startsWith(wanted));
    const length = blocks.slice(begin + 1).findIndex((block) => block.kind === "heading" && block.level <= 2);
    const part = begin < 0 ? [] : blocks.slice(begin + 1, length < 0 ? undefined : begin + 1 + length);
    const heading = blocks[begin];
    const body = element("div", {});
    working(body, part);
    this.#working.replaceChildren(element("summary", {}, heading?.kind === "heading" ? `Working: ${heading.text}` : "Working"), body);
  }
}

function paragraphs(text: string): HTMLElement[] {
  return text.split(/\n\s*\n/).map((words) => element("p", {}, words.trim()));
}

/** Returns the lesson in the fragment of an address. */
export function lessonOf(fragment: string): string | null {
  const [, id] = /^#lesson=(.+)$/.exec(fragment) ?? [];
  try {
    return id === undefined ? null : decodeURIComponent(id);
  } catch {
    return null;
  }
}
