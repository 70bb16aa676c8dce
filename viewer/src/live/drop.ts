/**
 * Files and folders that are dropped on the page, or chosen. They are given to the engine as one
 * set, and then opened.
 */
import { element } from "../dom";
import { chosen, dropped, type DroppedFile, sorted } from "./dropped";
import type { DocumentInfo } from "./protocol";
import { engine, Refused } from "./engine";

/**
 * Maximum number of models or scenarios that are opened. All files of the set may refer to each
 * other.
 */
const MOST = 20;

export class Drop {
  readonly button: HTMLElement;
  readonly #opened: (document: DocumentInfo) => Promise<void>;
  readonly #said: (words: string) => void;
  /** Number of sets so far. */
  #sets = 0;

  constructor(opened: (document: DocumentInfo) => Promise<void>, said: (words: string) => void) {
    this.#opened = opened;
    this.#said = said;
    const files = this.#chooser("Open…", "Scenarios, parts lists, measurements, logs, meshes, robots, molecules; a file with those that it names", {});
    const folder = this.#chooser("Folder…", "A robot's package: the models in it, with their meshes", { webkitdirectory: true });
    this.button = element("span", { class: "choosers" }, ...files, ...folder);
    const zone = element("div", { id: "drop-zone", hidden: true }, element("p", {}, "Drop a scenario, a plan, a robot or a mesh with the files that it names, or their folder; parts lists, logs, molecules, particles"));
    document.body.append(zone);
    document.addEventListener("dragenter", (event) => {
      if (event.dataTransfer?.types.includes("Files")) zone.hidden = false;
    });
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) zone.hidden = true;
    });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      zone.hidden = true;
      if (!event.dataTransfer) return;
      dropped(event.dataTransfer)
        .then((files) => this.#send(files))
        .catch((problem: unknown) => this.#said(`What was dropped cannot be read: ${words(problem)}`));
    });
  }

  #chooser(text: string, title: string, kind: Record<string, true>): HTMLElement[] {
    const input = element("input", { type: "file", multiple: true, hidden: true, "aria-label": title, ...kind });
    input.addEventListener("change", () => {
      void this.#send(chosen(input.files));
      input.value = "";
    });
    return [element("button", { type: "button", class: "webkitdirectory" in kind ? "folder" : "files", title, click: () => input.click() }, text), input];
  }

  async #send(files: DroppedFile[]): Promise<void> {
    if (files.length === 0) return;
    const { sent, opened } = await sorted(files);
    if (sent.length === 0) {
      this.#said("The folder has no file that this page can show: no scenario, plan, table, model, mesh or molecule.");
      return;
    }
    const [main] = opened;
    this.#said(sent.length === 1 ? `Opening ${main.path} …` : `Opening ${main.path} with ${sent.length - 1} more …`);
    this.#sets += 1;
    const set = `dropped/${this.#sets}`;
    try {
      for (const { path, file } of sent) await engine.put(`${set}/${path}`, file);
    } catch (problem) {
      this.#said(`${main.path}: ${words(problem)}`);
      return;
    }
    const problems = opened.length > MOST ? [`${opened.length - MOST} of ${opened.length} are not opened`] : [];
    let first: DocumentInfo | null = null;
    // A log that was dropped with its scenario is judged.
    let table: DocumentInfo | null = null;
    for (const { path } of opened.slice(0, MOST)) {
      try {
        const document = await engine.open(`${set}/${path}`, set);
        first ??= document;
        if (document.kind === "table") table ??= document;
      } catch (problem) {
        problems.push(`${path}: ${words(problem)}`);
      }
    }
    if (first) await this.#opened(first);
    if (table && table !== first) await this.#opened(table);
    if (problems.length > 0) this.#said(problems.join("\n"));
  }
}

function words(problem: unknown): string {
  const hint = problem instanceof Refused && problem.hint ? ` — ${problem.hint}` : "";
  return `${problem instanceof Error ? problem.message : String(problem)}${hint}`;
}
