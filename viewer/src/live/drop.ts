/** Files that are dropped on the page, or chosen: they go to the server as one set, and what they are is opened. */
import { element } from "../dom";
import type { DocumentInfo } from "./protocol";
import { Refused, server } from "./server";

/** Of a set, the file that names the others comes first. */
const MAIN = ["toml", "urdf", "sdf", "xml", "xacro", "gltf"];

export class Drop {
  readonly button: HTMLElement;
  readonly #input = element("input", { type: "file", multiple: true, hidden: true, "aria-label": "Files to open" });
  readonly #opened: (document: DocumentInfo) => void;
  readonly #said: (words: string) => void;

  constructor(opened: (document: DocumentInfo) => void, said: (words: string) => void) {
    this.#opened = opened;
    this.#said = said;
    this.#input.addEventListener("change", () => {
      void this.#send([...(this.#input.files ?? [])]);
      this.#input.value = "";
    });
    const choose = element("button", { type: "button", title: "Scenarios, meshes, molecules, particles; a scenario with its mesh", click: () => this.#input.click() }, "Open…");
    this.button = element("span", {}, choose, this.#input);
    const zone = element("div", { id: "drop-zone", hidden: true }, element("p", {}, "Drop a scenario, with its mesh; or meshes, molecules, particles"));
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
      void this.#send([...(event.dataTransfer?.files ?? [])]);
    });
  }

  async #send(files: File[]): Promise<void> {
    if (files.length === 0) return;
    const rank = ({ name }: File): number => {
      const found = MAIN.indexOf(name.toLowerCase().split(".").at(-1) ?? "");
      return found < 0 ? MAIN.length : found;
    };
    const [main] = [...files].sort((a, b) => rank(a) - rank(b));
    // Those that name no others are each shown.
    const shown = files.filter((file) => rank(main) === MAIN.length || rank(file) < MAIN.length);
    // Below 2⁵³, so that two pages hardly have the same.
    const set = Math.floor(Math.random() * 2 ** 52);
    this.#said(files.length === 1 ? `Opening ${main.name} …` : `Opening ${main.name} with ${files.length - 1} more …`);
    try {
      for (const file of files) await server.drop(set, file);
      const opened = [];
      for (const { name } of shown) opened.push(await server.open({ set, name }));
      this.#opened(opened[shown.indexOf(main)]);
    } catch (problem) {
      const hint = problem instanceof Refused && problem.hint ? ` — ${problem.hint}` : "";
      this.#said(`${main.name}: ${problem instanceof Error ? problem.message : String(problem)}${hint}`);
    }
  }
}
