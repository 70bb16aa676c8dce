/**
 * Report on a table or a plan: the page that the command writes, its options, and the editor of a
 * plan. It replaces the motion.
 */
import type { App } from "../../app";
import { byId, element } from "../../dom";
import { fileName, save } from "../../save/files";
import { Editor } from "../editor";
import { engine, Refused } from "../engine";
import type { DocumentInfo, Options, ReportAnswer, TableContent, TableKind } from "../protocol";
import type { Session } from "../session";
import { kindQuestion, optionFields } from "./form";
import { showPage } from "./page";
import { Plan } from "./plan";

/** Choices of the reader for a table. */
interface State {
  info: DocumentInfo;
  table: TableContent;
  kind: TableKind | null;
  /** Options of each kind. */
  options: Partial<Record<TableKind, Options>>;
  /** True if a run is judged by the scenario that is open. */
  byOpen: boolean;
  plan: Plan | null;
}

export class Report {
  document: DocumentInfo | null = null;
  /** Last report; null if there is none, or an error instead. */
  shown: ReportAnswer["report"] = null;
  /** True while a report is computed. */
  isComputing = false;
  /** Opens another document that was made from a table. */
  opened: (document: DocumentInfo) => void = () => undefined;
  readonly #app: App;
  readonly #session: Session;
  readonly #status = element("span", { class: "report-status", role: "status" });
  readonly #cancel = element("button", { type: "button", class: "quiet", hidden: true, click: () => this.#stop?.abort() }, "Cancel");
  readonly #again = element("button", { type: "button", class: "quiet", hidden: true, click: () => void this.compute() }, "Compute");
  readonly #saves: HTMLButtonElement[];
  readonly #error = element("div", { class: "report-error", role: "alert", hidden: true });
  readonly #page = element("div", { class: "report-page" });
  readonly #scroll = element("div", { class: "report-scroll", tabindex: "0", role: "region", "aria-label": "Report" }, this.#page);
  readonly #panel = element("div", { class: "report-panel", tabindex: "-1" });
  readonly #states = new Map<number, State>();
  #stop: AbortController | null = null;

  constructor(main: HTMLElement, app: App, session: Session) {
    this.#app = app;
    this.#session = session;
    const saved = (label: string, of: "html" | "json"): HTMLButtonElement => element("button", { type: "button", class: "quiet", click: () => this.#save(of) }, label);
    this.#saves = [saved("Save report (HTML)", "html"), saved("Save JSON", "json")];
    const bar = element("div", { class: "bar" }, this.#status, this.#cancel, this.#again, element("span", { class: "space" }), ...this.#saves);
    main.append(
      element("section", { class: "view report", "aria-label": "Report on the table" }, bar, this.#error, this.#scroll),
      element("section", { class: "side report", "aria-label": "Table and options" }, this.#panel),
    );
  }

  show(info: DocumentInfo, table: TableContent): void {
    const isSame = this.document?.id === info.id;
    this.document = info;
    this.#app.isAway = true;
    this.#app.clock.pause();
    document.body.classList.add("reporting");
    document.title = `${info.name} · polhode`;
    byId("title").textContent = info.name;
    byId("source").textContent = "";
    const state = this.#stateOf(info, table);
    this.#fill(state);
    if (!isSame) {
      this.shown = null;
      this.#tell("");
      this.#panel.focus();
      this.#scroll.scrollTop = 0;
    }
    void this.compute();
  }

  hide(): void {
    if (!this.document) return;
    this.#stop?.abort();
    this.#stop = null;
    this.document = null;
    this.#app.isAway = false;
    this.#app.name();
    document.body.classList.remove("reporting");
  }

  /** Computes the report again, and ends a computation that is not wanted any more. */
  async compute(): Promise<void> {
    this.#stop?.abort();
    this.#stop = null;
    this.#again.hidden = true;
    const state = this.document && this.#states.get(this.document.id);
    if (!state) return;
    const { kind, plan } = state;
    if (kind === null) {
      this.#tell("Choose what the file is.");
      return;
    }
    const stop = new AbortController();
    this.#stop = stop;
    this.isComputing = true;
    this.#status.textContent = "Computing …";
    this.#cancel.hidden = false;
    this.#scroll.setAttribute("aria-busy", "true");
    const options = state.options[kind] ?? {};
    const open = this.#session.document;
    const isByOpen = kind === "judge" && state.byOpen && open !== null && !isWithoutScenario(options);
    const request = { document: state.info.id, kind, text: plan?.text ?? null, scenario: isByOpen ? { document: open.id, text: this.#session.text } : null, options };
    try {
      const answer = await engine.report(request, stop.signal);
      if (this.#stop === stop) this.#receive(state, answer);
    } catch (problem) {
      if (this.#stop !== stop) return;
      if (stop.signal.aborted) {
        this.shown = null;
        this.#tell("Cancelled.");
      } else this.#fail(problem);
      this.#again.hidden = false;
    }
  }

  #stateOf(info: DocumentInfo, table: TableContent): State {
    const old = this.#states.get(info.id);
    if (old) {
      // A file that has changed on the disk replaces the text; undo brings the edited one back.
      if (old.table.text !== table.text && table.text !== null) old.plan?.replace(table.text, "file");
      return Object.assign(old, { info, table });
    }
    const [only, other] = table.kinds;
    const kind = other ? null : (only?.kind ?? null);
    const plan = table.text === null ? null : new Plan(info, table.text, () => void this.compute());
    const state: State = { info, table, kind, options: {}, byOpen: !table.has_scenario, plan };
    this.#states.set(info.id, state);
    return state;
  }

  #fill(state: State): void {
    const { info, table, kind, plan } = state;
    const known = table.kinds.find((one) => one.kind === kind);
    const parts: HTMLElement[] = [];
    if (table.kinds.length > 1) parts.push(kindQuestion(info.name, table, kind, (chosen) => void this.#choose(state, chosen)));
    else if (known) parts.push(element("p", {}, known.what));
    if (kind === "judge") parts.push(this.#reference(state));
    if (known && known.fields.length > 0) parts.push(optionFields(known.fields, (state.options[known.kind] ??= {}), kind === "judge" && !state.byOpen && !table.has_scenario, () => void this.compute()));
    const box = element("div", { class: "report-editor", hidden: plan === null });
    this.#panel.replaceChildren(...parts, box);
    if (plan) new Editor(box, plan, "plan");
  }

  /** Says by what a run is judged. */
  #reference(state: State): HTMLElement {
    const open = this.#session.document;
    const select = element("select", { "aria-label": "Scenario of the run" });
    select.append(element("option", { value: "" }, state.table.has_scenario ? "Scenario that the log names" : "No scenario: moments, or another log"));
    if (open) select.append(element("option", { value: "open" }, `Open scenario: ${open.name}`));
    select.value = state.byOpen && open ? "open" : "";
    select.addEventListener("change", () => {
      state.byOpen = select.value === "open";
      this.#fill(state);
      this.#panel.querySelector("select")?.focus();
      void this.compute();
    });
    return element("p", {}, "Judged by: ", select, element("span", { class: "hint" }, " With moments or against, no scenario is used."));
  }

  async #choose(state: State, kind: TableKind): Promise<void> {
    if (kind === "particles") {
      try {
        this.opened(await engine.particles(state.info.id));
      } catch (problem) {
        this.#fail(problem);
      }
      return;
    }
    state.kind = kind;
    this.#fill(state);
    this.#panel.querySelector<HTMLElement>("input:checked")?.focus();
    await this.compute();
  }

  #receive({ plan }: State, { report, error }: ReportAnswer): void {
    plan?.tell(error ? [error] : []);
    this.shown = report;
    if (report) {
      showPage(this.#page, report.html);
      byId("title").textContent = report.title;
    }
    this.#tell(report?.has_failed ? "A limit is exceeded, or a mistake was found." : "", error);
  }

  /** Ends the wait: shows the report if there is one, a status, and an error. */
  #tell(status: string, error: ReportAnswer["error"] = null): void {
    this.#stop = null;
    this.isComputing = false;
    this.#cancel.hidden = true;
    this.#status.textContent = status;
    this.#scroll.hidden = this.shown === null;
    this.#scroll.removeAttribute("aria-busy");
    for (const button of this.#saves) button.disabled = this.shown === null;
    this.#error.hidden = !error;
    const hint = error?.hint ? [element("p", { class: "hint" }, `hint: ${error.hint}`)] : [];
    const places = error && error.places !== "" ? [element("pre", {}, error.places)] : [];
    this.#error.replaceChildren(...(error ? [element("p", {}, error.message), ...places, ...hint] : []));
  }

  #fail(problem: unknown): void {
    this.shown = null;
    const message = problem instanceof Error ? problem.message : String(problem);
    this.#tell("", { from: null, to: null, line: null, column: null, places: "", message, hint: problem instanceof Refused ? problem.hint : null });
  }

  #save(of: "html" | "json"): void {
    if (!this.shown || !this.document) return;
    const name = fileName(this.document.name.replace(/\.[^.]*$/, ""));
    save(`${name}-report.${of}`, new Blob([this.shown[of]], { type: of === "html" ? "text/html" : "application/json" }));
  }
}

/** Returns true if the options state the motion of a run, so that no scenario may. */
const isWithoutScenario = (options: Options): boolean => ["moments", "against"].some((key) => key in options);
