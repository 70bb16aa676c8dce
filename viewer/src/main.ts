/** The page: reads its data, makes the view and the panels, and lets the clock run. */
import { Clock, watchable } from "./clock";
import { readPage } from "./decode";
import { byId, element } from "./dom";
import { fileName, saveCanvas } from "./save/files";
import { keys } from "./keys";
import { Motion } from "./motion";
import { about } from "./panels/about";
import { facts } from "./panels/facts";
import { legend } from "./panels/legend";
import { Plots } from "./panels/plots";
import { scenario } from "./panels/scenario";
import { type Tab, tabs } from "./panels/tabs";
import { toolbar } from "./panels/toolbar";
import { working } from "./panels/working";
import { saveDialog } from "./save/dialog";
import { View } from "./scene/scene";
import { onTheme } from "./theme";

/** For tests and for curious people at the console. */
interface Hook {
  clock: Clock;
  /** (w, x, y, z) of the displayed body, read back from the scene; null without WebGL. */
  attitudeAt: (time: number) => [number, number, number, number] | null;
  picture: () => HTMLCanvasElement | null;
  view: View | null;
  ready: Promise<void>;
}

declare global {
  interface Window {
    polhode?: Hook;
  }
}

function start(): void {
  const page = readPage(document);
  const motion = new Motion(page.motion);
  const duration = motion.times[motion.count - 1] - motion.times[0];
  const clock = new Clock(motion.times, watchable(motion.meanRate(), duration, page.scene.period));
  document.title = `${page.title} · polhode`;
  byId("title").textContent = page.title;
  byId("source").textContent = page.source;

  let view: View | null = null;
  try {
    view = new View(byId<HTMLCanvasElement>("canvas"), byId("labels"), page, motion);
  } catch (problem) {
    byId("no-view").hidden = false;
    byId("no-view").append(element("p", {}, String(problem)));
  }
  const show = view ? legend(view, page.scene.captions) : (): void => undefined;
  toolbar(clock);
  const plots = panels(page, motion, clock, notes(view, motion));
  keys(clock, view, show);
  const redraw = (): void => {
    view?.recolor();
    plots()?.redraw();
  };
  onTheme(redraw);
  byId("help-button").addEventListener("click", () => byId<HTMLDialogElement>("help").showModal());
  byId("photograph").addEventListener("click", () => {
    if (view) saveCanvas(`${fileName(page.title)}-frame`, view.photograph());
  });
  if (view) saveDialog(view, clock, page.title);
  else byId("save").hidden = true;

  const shown = view;
  if (shown) {
    clock.subscribe(() => {
      shown.time = clock.time;
    });
    const stage = byId("stage");
    new ResizeObserver(() => shown.resize(stage.clientWidth, stage.clientHeight)).observe(stage);
    shown.resize(stage.clientWidth, stage.clientHeight);
  }
  run(clock);
  window.polhode = {
    clock,
    attitudeAt: (time) => shown?.attitudeAt(time) ?? null,
    picture: () => shown?.photograph() ?? null,
    view: shown,
    ready: new Promise((resolve) => requestAnimationFrame(() => resolve())),
  };
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
}

function panels(
  page: ReturnType<typeof readPage>,
  motion: Motion,
  clock: Clock,
  said: string[],
): () => Plots | null {
  let plots: Plots | null = null;
  const all: Tab[] = [
    {
      id: "plots",
      title: "Plots",
      fill: (host) => {
        plots = new Plots(host, motion, page.body, page.top, clock, page.title);
      },
    },
    { id: "numbers", title: "Numbers", fill: (host) => facts(host, page, said) },
  ];
  if (page.explanation.length > 0) {
    all.push({ id: "working", title: "Working", fill: (host) => working(host, page.explanation) });
  }
  all.push(
    { id: "scenario", title: "Scenario", fill: (host) => scenario(host, page) },
    { id: "about", title: "About", fill: (host) => about(host, page.source) },
  );
  tabs(byId("tabs"), byId("panels"), all);
  return () => plots;
}

/** What the page itself has to say about how it shows the motion. */
function notes(view: View | null, motion: Motion): string[] {
  const said: string[] = [];
  if (view?.model.coarser) said.push(`The mesh is ${view.model.coarser}; the motion is that of all of them.`);
  if (motion.largestTurn > Math.PI / 2) {
    said.push(
      `The body turns by up to ${(motion.largestTurn / (2 * Math.PI)).toFixed(1)} turns from one sample to the next: ` +
        "the picture shows the samples truly, and takes a steady and short way between them.",
    );
  }
  byId("view-note").textContent = view?.model.coarser ? `Mesh ${view.model.coarser}` : "";
  return said;
}

function run(clock: Clock): void {
  let before: number | null = null;
  const tick = (now: number): void => {
    // A page that was hidden does not leap.
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

try {
  start();
} catch (problem) {
  byId("problem").hidden = false;
  byId("problem").textContent = problem instanceof Error ? problem.message : String(problem);
}
