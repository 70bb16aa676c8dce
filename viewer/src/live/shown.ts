/**
 * Selection of the document: the motion of a scenario, or the inspection of another file. It
 * follows changes of the file.
 */
import { element } from "../dom";
import type { Inspection } from "./inspection/inspection";
import type { Notice } from "./notice";
import type { Report } from "./report/report";
import type { DocumentContent, DocumentInfo } from "./protocol";
import { engine, Refused } from "./engine";
import type { Session } from "./session";

export class Shown {
  /** Selection of a document. */
  readonly choice = element("select", { "aria-label": "Document", id: "documents", hidden: true });
  /** Button to switch between the motion of a mesh and its inspection. */
  readonly other = element("button", { type: "button", id: "other", hidden: true, click: () => this.#toggle() });
  /** Returns true if a lesson takes over the file's new text. */
  takes: (id: number) => Promise<boolean> = () => Promise.resolve(false);
  readonly #session: Session;
  readonly #inspection: Inspection;
  readonly #report: Report;
  readonly #notice: Notice;
  #all: DocumentInfo[] = [];
  /** Number of the last request: the latest one is shown, whichever answer arrives first. */
  #asked = 0;

  constructor(session: Session, inspection: Inspection, report: Report, notice: Notice) {
    this.#session = session;
    this.#inspection = inspection;
    this.#report = report;
    report.opened = (document) => void this.open(document);
    this.#notice = notice;
    this.choice.addEventListener("change", () => {
      const chosen = this.#all.find(({ id }) => String(id) === this.choice.value);
      if (chosen) void this.open(chosen);
    });
    session.listen({ changed: () => this.#name() });
  }

  get document(): DocumentInfo | null {
    return this.#away ?? this.#session.document;
  }

  /** Document that is shown instead of the motion. */
  get #away(): DocumentInfo | null {
    return this.#inspection.document ?? this.#report.document;
  }

  /** Opens a document; for a scenario, `text` replaces its own if that was changed. */
  async open(info: DocumentInfo, text?: string): Promise<void> {
    this.#asked += 1;
    const asked = this.#asked;
    // Returns to the unchanged motion.
    if (this.#away && info.id === this.#session.document?.id && text === undefined) {
      this.#inspection.hide();
      this.#report.hide();
      this.#session.tell();
      await this.update(this.#all);
      return;
    }
    await this.#ask(info, engine.document(info.id), asked, text);
    if (!this.#all.some(({ id }) => id === info.id)) await this.update((await engine.documents()).documents);
  }

  #toggle(): void {
    const info = this.document;
    if (!info) return;
    if (this.#inspection.document) void this.open(info);
    else {
      this.#asked += 1;
      void this.#ask(info, engine.mesh(info.id), this.#asked);
    }
  }

  async #ask(info: DocumentInfo, answer: Promise<DocumentContent>, asked: number, text?: string): Promise<void> {
    try {
      const content = await answer;
      if (asked !== this.#asked) return;
      this.#notice.clear();
      if (content.kind === "scenario") {
        this.#inspection.hide();
        this.#report.hide();
        this.#session.open(info, content.text, text);
      } else if (content.kind === "table") {
        this.#inspection.hide();
        this.#report.show(info, content.table);
      } else {
        this.#report.hide();
        this.#inspection.show(info, content);
      }
    } catch (problem) {
      if (asked !== this.#asked) return;
      const hint = problem instanceof Refused && problem.hint ? ` — ${problem.hint}` : "";
      this.#notice.say(`${info.name}: ${problem instanceof Error ? problem.message : String(problem)}${hint}`);
    }
    this.#name();
  }

  /** Updates the documents. The one that is shown may have changed on the disk. */
  async update(all: DocumentInfo[]): Promise<void> {
    this.#all = all;
    this.choice.replaceChildren(...all.map(({ id, name }) => element("option", { value: String(id) }, name)));
    this.#name();
    const mine = this.document;
    const now = all.find(({ id }) => id === mine?.id);
    if (!mine || !now || now.stamp === mine.stamp) return;
    if (this.#away) {
      this.#asked += 1;
      await this.#ask(now, now.mesh ? engine.mesh(now.id) : engine.document(now.id), this.#asked);
    } else if (!(await this.takes(mine.id))) await this.#reread(now);
  }

  async #reread(now: DocumentInfo): Promise<void> {
    const session = this.#session;
    const content = await engine.document(now.id);
    if (content.kind !== "scenario" || session.document?.id !== now.id) return;
    const { text } = content;
    if (!session.isChanged || text === session.text) {
      session.reload(now, text);
      return;
    }
    session.document = now;
    this.#notice.say(`${now.name} changed on disk.`, [
      { label: "Take it", then: () => session.reload(now, text) },
      {
        label: "Keep mine",
        then: () => {
          session.fileText = text;
        },
      },
    ]);
  }

  #name(): void {
    this.choice.value = String(this.document?.id ?? "");
    this.choice.hidden = this.#all.length < 2;
    const { document } = this;
    this.other.hidden = !(document?.mesh === true && document.kind === "scenario");
    [this.other.textContent, this.other.title] = this.#inspection.document ? ["Motion", "How it moves"] : ["Mesh", "What is found in the mesh"];
  }
}
