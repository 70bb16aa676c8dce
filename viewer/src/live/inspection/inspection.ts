/**
 * Inspection of a file that is not a scenario: the object in 3-D, and the list of findings next to
 * it. It replaces the motion.
 */
import type { App } from "../../app";
import { byId, element, icon } from "../../dom";
import { fileName, saveCanvas } from "../../save/files";
import type { DocumentContent, DocumentInfo } from "../protocol";
import type { Listed } from "./listed";
import { meshList } from "./mesh-list";
import { MeshScene } from "./mesh-scene";
import { robotList } from "./robot-list";
import { RobotScene } from "./robot-scene";
import { type Still, StillView } from "./still";

export type Inspected = Extract<DocumentContent, { kind: "mesh" | "robot" }>;

export class Inspection {
  /** Document shown; null if it is a motion. */
  document: DocumentInfo | null = null;
  chosen: number | null = null;
  readonly #app: App;
  readonly #scene = element("section", { class: "view inspection", "aria-label": "3-D view of the file" });
  readonly #side = element("section", { class: "side inspection", "aria-label": "What was found" });
  readonly #panel = element("div", { class: "inspection-panel", tabindex: "-1" });
  readonly #bar = element("div", { class: "bar" });
  #view: StillView | null = null;
  #still: Still | null = null;
  #list: Listed | null = null;

  constructor(main: HTMLElement, app: App) {
    this.#app = app;
    this.#scene.append(this.#bar);
    this.#side.append(this.#panel);
    main.append(this.#scene, this.#side);
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.document && this.chosen !== null && !document.querySelector("dialog[open]")) this.choose(null);
    });
  }

  /** Access for tests, and for inspection in the console. */
  get view(): StillView | null {
    return this.#view;
  }

  show(info: DocumentInfo, content: Inspected): void {
    const isSame = this.document?.id === info.id;
    const [had, top] = [isSame ? this.chosen : null, isSame ? this.#panel.scrollTop : 0];
    this.document = info;
    this.#app.isAway = true;
    this.#app.clock.pause();
    document.body.classList.add("inspecting");
    document.title = `${info.name} · polhode`;
    byId("title").textContent = info.name;
    byId("source").textContent = "";
    const view = this.#open();
    const choose = (item: number | null): void => this.choose(item === this.chosen ? null : item);
    this.#list = content.kind === "mesh" ? meshList(content.mesh, info.kind === "mesh", choose) : robotList(content.robot, info.name, choose);
    this.#panel.replaceChildren(this.#list.host);
    if (view) {
      this.#still = content.kind === "mesh" ? new MeshScene(content.mesh, view.palette) : new RobotScene(content.robot, view.palette);
      view.show(this.#still, isSame);
      this.#fillBar(view, this.#still, info.name);
    }
    this.choose(had !== null && had < this.#list.count ? had : null);
    this.#panel.scrollTop = top;
    if (!isSame) this.#panel.focus();
  }

  hide(): void {
    if (!this.document) return;
    this.document = null;
    this.chosen = null;
    this.#still = null;
    this.#view?.clear();
    this.#app.isAway = false;
    this.#app.name();
    document.body.classList.remove("inspecting");
  }

  /** Highlights one of the listed items; null shows all. */
  choose(item: number | null): void {
    this.chosen = item;
    this.#list?.choose(item);
    const side = this.#still?.choose(item);
    if (side) this.#view?.from(side);
    this.#view?.invalidate();
  }

  #open(): StillView | null {
    if (this.#view) return this.#view;
    try {
      const view = new StillView();
      view.clicked = (item) => this.choose(item);
      this.#scene.append(view.host);
      this.#view = view;
    } catch (problem) {
      this.#scene.replaceChildren(element("p", { class: "hint" }, `This browser has no WebGL, so the 3-D view is empty. What was found is all here. ${String(problem)}`));
    }
    return this.#view;
  }

  #fillBar(view: StillView, still: Still, name: string): void {
    const parts = still.parts.map((part) => {
      const button = element("button", { type: "button", class: "quiet", "aria-pressed": String(part.isOn) }, part.name);
      button.addEventListener("click", () => {
        part.isOn = !part.isOn;
        part.show(part.isOn);
        button.setAttribute("aria-pressed", String(part.isOn));
        view.invalidate();
      });
      return button;
    });
    const round = (label: string, picture: string, click: () => void): HTMLElement => element("button", { type: "button", class: "round", "aria-label": label, title: label, click }, icon(picture));
    const home = round("Camera home", "home", () => {
      this.choose(null);
      view.orbit.home();
    });
    const photo = round("Save the picture as PNG", "photo", () => saveCanvas(`${fileName(name)}-findings`, view.photograph()));
    this.#bar.replaceChildren(...parts, element("span", { class: "space" }), home, photo);
  }
}
