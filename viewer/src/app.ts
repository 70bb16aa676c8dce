/** Page of a motion, which can be replaced by another: the view, the clock and the panels stay. */
import { Clock, watchable } from "./clock";
import type { PageData } from "./data";
import { byId, element } from "./dom";
import { keys } from "./keys";
import { Motion } from "./motion";
import { about } from "./panels/about";
import { facts } from "./panels/facts";
import { type Legend, legend } from "./panels/legend";
import { Plots } from "./panels/plots";
import { scenario } from "./panels/scenario";
import { type Tab, Tabs } from "./panels/tabs";
import { toolbar } from "./panels/toolbar";
import { working } from "./panels/working";
import { Presentation } from "./present";
import { SaveDialog } from "./save/dialog";
import { fileName, saveCanvas } from "./save/files";
import { View } from "./scene/scene";
import { onTheme } from "./theme";

/** Access for tests, and for inspection in the console. */
interface Hook {
  clock: Clock;
  /** Attitude (w, x, y, z) of the displayed body, read from the scene; null without WebGL. */
  attitudeAt: (time: number) => [number, number, number, number] | null;
  picture: () => HTMLCanvasElement | null;
  view: View | null;
  app: App;
  ready: Promise<void>;
}

declare global {
  interface Window {
    polhode?: Hook;
  }
}

/** The page's own panels. */
export type Panels = Record<"plots" | "numbers" | "working" | "scenario" | "about", Tab>;

export class App {
  readonly clock: Clock;
  /** View of the motion; null if the browser has no WebGL. */
  readonly view: View | null;
  readonly tabs: Tabs;
  /** Actions of additional keys. */
  readonly keys = new Map<string, () => void>();
  /** True while something else is shown instead of the motion. */
  isAway = false;
  page: PageData;
  motion: Motion;
  readonly #legend: Legend | null;
  #saving: SaveDialog | null = null;
  #plots: Plots | null = null;

  /** `choose` selects the panels and their order. */
  constructor(page: PageData, choose: (own: Panels) => Tab[]) {
    this.page = page;
    this.motion = new Motion(page.motion);
    this.clock = new Clock(this.motion.times, this.#speed());
    this.name();
    this.view = this.#open();
    this.#legend = this.view && legend(this.view, page.scene.captions);
    byId("view-note").textContent = this.#coarser();
    toolbar(this.clock);
    this.tabs = new Tabs(byId("tabs"), byId("panels"), choose(this.#panels()));
    keys(this.clock, this.view, (picture) => this.#legend?.show(picture), this.keys, () => this.isAway);
    onTheme(() => {
      this.view?.recolor();
      this.#plots?.redraw();
    });
    byId("help-button").addEventListener("click", () => byId<HTMLDialogElement>("help").showModal());
    byId("photograph").addEventListener("click", () => {
      if (this.view) saveCanvas(`${fileName(this.page.title)}-frame`, this.view.photograph());
    });
    byId("save").hidden = this.view === null;
    byId("save").addEventListener("click", () => this.#save());
    if (this.view) this.#fit(this.view);
    new Presentation(this);
    run(this.clock);
    window.polhode = {
      clock: this.clock,
      attitudeAt: (time) => this.view?.attitudeAt(time) ?? null,
      picture: () => this.view?.photograph() ?? null,
      view: this.view,
      app: this,
      ready: new Promise((resolve) => requestAnimationFrame(() => resolve())),
    };
  }

  /**
   * Shows another motion. Camera, time, speed, layers and panel are kept, unless `anew` shows it as
   * a first one. Throws `BadData`, and then changes nothing.
   */
  show(page: PageData, anew = false): void {
    const motion = new Motion(page.motion);
    this.view?.replace(page, motion, anew);
    this.page = page;
    this.motion = motion;
    this.name();
    if (anew) {
      this.clock.time = motion.times[0];
      this.clock.speed = this.#speed();
    }
    this.#legend?.update(page.scene.captions);
    byId("view-note").textContent = this.#coarser();
    // Panels come before the clock, because its listeners request samples from them.
    this.tabs.refresh();
    this.clock.replace(motion.times);
    this.#saving?.changed();
  }

  /** Sets the size of the type of plots and labels, relative to that of the page. */
  magnify(size: number): void {
    this.#plots?.magnify(size);
    this.view?.labels.remeasure();
    this.view?.invalidate();
  }

  #save(): void {
    if (!this.view) return;
    this.#saving ??= new SaveDialog(this.view, this.clock, () => this.page.title);
    this.#saving.open();
  }

  #speed(): number {
    const { times, count } = this.motion;
    return watchable(this.motion.meanRate(), times[count - 1] - times[0], this.page.scene.period);
  }

  /** Sets the heading to that of the motion. */
  name(): void {
    const { title, source } = this.page;
    if (this.isAway || (byId("title").textContent === title && byId("source").textContent === source)) return;
    document.title = `${title} · polhode`;
    byId("title").textContent = title;
    byId("source").textContent = source;
  }

  #open(): View | null {
    try {
      return new View(byId<HTMLCanvasElement>("canvas"), byId("labels"), this.page, this.motion);
    } catch (problem) {
      byId("no-view").hidden = false;
      byId("no-view").append(element("p", {}, String(problem)));
      return null;
    }
  }

  #fit(view: View): void {
    this.clock.subscribe(() => {
      view.time = this.clock.time;
    });
    const stage = byId("stage");
    new ResizeObserver(() => view.resize(stage.clientWidth, stage.clientHeight)).observe(stage);
    view.resize(stage.clientWidth, stage.clientHeight);
  }

  #panels(): Panels {
    const again = (host: HTMLElement, fill: () => void) => (): void => {
      host.replaceChildren();
      fill();
    };
    const repeated = (id: keyof Panels, title: string, fill: (host: HTMLElement) => void): Tab => ({
      id,
      title,
      fill: (host) => {
        fill(host);
        return again(host, () => fill(host));
      },
    });
    return {
      plots: {
        id: "plots",
        title: "Plots",
        fill: (host) => {
          const plots = new Plots(host, this.page, this.motion, this.clock);
          this.#plots = plots;
          return () => plots.update(this.page, this.motion);
        },
      },
      numbers: repeated("numbers", "Numbers", (host) => facts(host, this.page, this.#notes())),
      working: repeated("working", "Working", (host) => working(host, this.page.explanation)),
      scenario: repeated("scenario", "Scenario", (host) => scenario(host, this.page)),
      about: repeated("about", "About", (host) => about(host, this.page.source)),
    };
  }

  /** Returns the page's own remarks on the display of the motion. */
  #notes(): string[] {
    const said: string[] = [];
    const { largestTurn } = this.motion;
    if (this.view?.model.coarser) said.push(`The mesh is ${this.view.model.coarser}; the motion is that of all of them.`);
    if (largestTurn > Math.PI / 2) {
      said.push(
        `The body turns by up to ${(largestTurn / (2 * Math.PI)).toFixed(1)} turns from one sample to the next: ` +
          "the picture shows the samples truly, and takes a steady and short way between them.",
      );
    }
    return said;
  }

  #coarser(): string {
    return this.view?.model.coarser ? `Mesh ${this.view.model.coarser}` : "";
  }
}

function run(clock: Clock): void {
  let before: number | null = null;
  const tick = (now: number): void => {
    // After a page was hidden, the time does not jump.
    if (before !== null) clock.advance(Math.min(Math.max(now - before, 0) / 1000, 0.25));
    before = clock.playing ? now : null;
    if (clock.playing) requestAnimationFrame(tick);
  };
  clock.subscribe(() => {
    if (clock.playing && before === null) {
      before = performance.now();
      requestAnimationFrame(tick);
    }
  });
}

/** Shows on the page an error that occurs before anything can be shown. */
export function orSay(start: () => void): void {
  try {
    start();
  } catch (problem) {
    say(problem);
  }
}

/** Shows an error on the page; null removes it. */
export function say(problem: unknown): void {
  byId("problem").hidden = problem === null;
  byId("problem").textContent = problem instanceof Error ? problem.message : String(problem ?? "");
}
