/** Exercises: the list of topics, and the open exercise with its answers, their grades and its solution. */
import type { App } from "../app";
import { element } from "../dom";
import { working } from "../panels/working";
import { engine, reason } from "./engine";
import type { ExerciseAnswer, Exercises as Topics } from "./protocol";

/** Exercise as the address names it. */
interface Name {
  topic: string;
  seed: number;
  symbols: boolean;
}

const PREFIX = "#exercise=";

export class Exercises {
  readonly host = element("div", { class: "exercise" });
  readonly #app: App;
  readonly #say: (words: string) => void;
  #requested: Promise<Topics["topics"]> | null = null;
  /** Edited answers by the fragment of their exercise. */
  readonly #edited = new Map<string, string>();
  /** Counts requests: an answer to an earlier one is not shown. */
  #latest = 0;

  constructor(app: App, say: (words: string) => void) {
    this.#app = app;
    this.#say = say;
    window.addEventListener("hashchange", () => this.openLinked(location.hash));
  }

  /** Shows the topics, unless an exercise is open. */
  async list(): Promise<void> {
    const all = await this.#topics;
    if (this.host.querySelector("form")) return;
    const one = ({ topic, title }: Topics["topics"][number]): HTMLElement =>
      element("li", {}, element("button", { type: "button", click: () => void this.#open({ topic, seed: 1, symbols: false }) }, title));
    this.host.replaceChildren(element("h2", {}, "Exercises"), element("p", {}, "Compute, and have the answers graded."), element("ol", { class: "topics" }, ...all.map(one)));
  }

  /** Opens the exercise in the fragment of an address, if it names one. */
  openLinked(fragment: string): void {
    if (!fragment.startsWith(PREFIX)) return;
    const [, topic, seed, symbols] = /^([a-z0-9-]+)(?:,(\d{1,15}))?(,symbols)?$/.exec(fragment.slice(PREFIX.length)) ?? [];
    if (topic === undefined) this.#say(`The link is damaged: an exercise is ${PREFIX}TOPIC,SEED, such as ${PREFIX}box-about-corner,7`);
    else void this.#open({ topic, seed: Number(seed ?? 1), symbols: symbols !== undefined });
  }

  /** Topics, which the page does not request before it shows them. */
  get #topics(): Promise<Topics["topics"]> {
    this.#requested ??= engine.exercises().then(
      ({ topics }) => topics,
      (problem: unknown) => {
        this.#say(reason(problem));
        this.#requested = null;
        return [];
      },
    );
    return this.#requested;
  }

  async #open(name: Name): Promise<void> {
    const answer = await this.#ask(name, null, false);
    if (!answer) return;
    const hasSymbols = (await this.#topics).some(({ topic, symbols }) => topic === name.topic && symbols);
    history.replaceState(null, "", fragmentOf(name));
    this.#app.tabs.open("lesson");
    this.#show(name, answer, hasSymbols);
    this.host.querySelector<HTMLElement>("h2")?.focus({ preventScroll: true });
    this.host.parentElement?.scrollTo({ top: 0 });
    this.host.parentElement?.scrollIntoView({ block: "nearest" });
  }

  /** Returns null if the exercise is refused, or another request has followed. */
  async #ask(name: Name, answers: string | null, solution: boolean): Promise<ExerciseAnswer | null> {
    this.#latest += 1;
    const request = this.#latest;
    try {
      const answer = await engine.exercise({ ...name, answers, solution });
      return request === this.#latest ? answer : null;
    } catch (problem) {
      this.#say(reason(problem));
      return null;
    }
  }

  #close(): void {
    this.#latest += 1;
    history.replaceState(null, "", location.pathname);
    this.host.replaceChildren();
    void this.list();
  }

  #show(name: Name, { problem: [title, ...rest], template }: ExerciseAnswer, hasSymbols: boolean): void {
    const key = fragmentOf(name);
    const button = (text: string, click: () => void): HTMLButtonElement => element("button", { type: "button", click }, text);
    const problem = element("div", {});
    working(problem, rest);
    const answers = element("textarea", { "aria-label": "Answers", spellcheck: "false", autocapitalize: "off", autocomplete: "off", wrap: "off" });
    answers.value = this.#edited.get(key) ?? template;
    answers.rows = Math.max(3, answers.value.split("\n").length);
    answers.addEventListener("input", () => this.#edited.set(key, answers.value));
    const grades = element("div", { class: "exercise-grades", role: "status" });
    const solution = element("div", {});
    const solve = button("Solution", async () => {
      const answer = await this.#ask(name, null, true);
      if (!answer?.solution) return;
      const heading = element("h3", { tabindex: "-1" }, "Solution");
      solution.replaceChildren(heading);
      // The first block is the title.
      working(solution, answer.solution.slice(1));
      solve.disabled = true;
      heading.focus();
    });
    const next = button("Next", () => void this.#open({ ...name, seed: name.seed + 1 }));
    // The problem in symbols is the same for each seed.
    next.hidden = name.symbols;
    const symbols = element("input", { type: "checkbox" });
    symbols.checked = name.symbols;
    symbols.addEventListener("change", () => void this.#open({ ...name, symbols: symbols.checked }));
    const form = element("form", {}, answers, element("nav", { class: "lesson-nav", "aria-label": "Exercise" }, element("button", { type: "submit" }, "Grade"), solve, next));
    form.addEventListener("submit", async (event) => {
      event.preventDefault();
      const answer = await this.#ask(name, answers.value, false);
      if (!answer) return;
      grades.replaceChildren(...graded(answer));
      const [error] = answer.errors;
      if (error?.from == null) return;
      answers.focus();
      answers.setSelectionRange(error.from, error.to ?? error.from);
    });
    this.host.replaceChildren(
      element("div", { class: "lesson-head" }, element("h2", { tabindex: "-1" }, title.kind === "heading" ? title.text : ""), button("All exercises", () => this.#close())),
      ...(hasSymbols ? [element("label", {}, symbols, " In symbols")] : []),
      problem,
      element("h3", {}, "Answers"),
      form,
      grades,
      solution,
    );
  }
}

/** Returns the grades of the answers, or the error in their text. */
function graded({ grades, errors }: ExerciseAnswer): HTMLElement[] {
  const errorList = errors.map(({ message, hint, line, column }) => `${line === null ? "" : `Line ${line}, column ${column}: `}${message}${hint === null ? "" : `\nhint: ${hint}`}`);
  if (!grades) return [element("ul", { class: "errors" }, ...errorList.map((words) => element("li", {}, words)))];
  const right = grades.filter(({ grade }) => grade === "right").length;
  const rows = grades.map(({ name, grade, reason }) => element("li", { class: grade === "right" ? "right" : "" }, element("strong", {}, `${name}: ${grade}`), reason === "" ? "" : `, ${reason}`));
  return [element("p", {}, `${right} of ${grades.length} right`), element("ul", {}, ...rows)];
}

const fragmentOf = ({ topic, seed, symbols }: Name): string => `${PREFIX}${topic},${seed}${symbols ? ",symbols" : ""}`;
