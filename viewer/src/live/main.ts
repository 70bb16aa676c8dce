/** The live page: the viewer with the data of a scenario that knobs, scene and editor change. */
import { App, orSay } from "../app";
import { byId, element } from "../dom";
import { Actions } from "./actions";
import { Drop } from "./drop";
import { Editor } from "./editor";
import { EMPTY } from "./empty";
import { Exercises } from "./exercise";
import { embedded } from "./embedded";
import { Files } from "./files";
import { frame, isPlain } from "./framed";
import { Inspection } from "./inspection/inspection";
import { Knobs } from "./knobs";
import { lessonOf, Lessons } from "./lesson";
import { readFragment } from "./link";
import { Notice } from "./notice";
import { MomentsPad } from "./pad";
import type { DocumentInfo } from "./protocol";
import { Report } from "./report/report";
import { engine } from "./engine";
import { Session } from "./session";
import { Shown } from "./shown";
import { Throw } from "./throw";
import { TipHandle } from "./tip";

orSay(() => {
  const session = new Session();
  const app = new App(EMPTY, ({ plots, working, numbers, about }) => [
    { ...plots, title: "Motion" },
    {
      id: "scenario",
      title: "Scenario",
      fill: (host) => {
        new Editor(host, session, "scenario");
        return undefined;
      },
    },
    working,
    numbers,
    {
      id: "lesson",
      title: "Lessons",
      fill: (host) => {
        host.append(lessons.host, exercises.host);
        void exercises.list();
        return undefined;
      },
    },
    about,
  ]);
  document.body.classList.add("live", "waiting");
  const files = new Files();
  let first = files.areGiven || !isPlain(location.hash) ? null : embedded.first;
  session.listen({
    moved: (page, { anew, isWorked }) => {
      // Until the worked solution arrives, the previous one is kept; it is not visible.
      const shown = isWorked ? page : { ...page, explanation: app.page.explanation };
      // The example continues where it is shown already.
      app.show(shown, anew && app.page.title !== first?.title);
      first = null;
      document.body.classList.remove("waiting", "early");
    },
  });
  troubles(session);
  frame(app, session);
  const notice = new Notice();
  const main = document.querySelector("main") ?? document.body;
  const inspection = new Inspection(main, app);
  const report = new Report(main, app, session);
  const shown = new Shown(session, inspection, report, notice);
  shown.takes = (id) => lessons.reread(id);
  const drop = new Drop((document) => shown.open(document), (words) => notice.say(words));
  const actions = new Actions(session, notice);
  actions.host.prepend(shown.choice, shown.other, drop.button);
  byId("theme").before(actions.host);
  document.querySelector("header")?.after(notice.host);
  const pad = new MomentsPad(session);
  const knobs = new Knobs(session, pad.host, () => ({ page: app.page, motion: app.motion }));
  document.querySelector(".view")?.append(knobs.host);
  const lessons = new Lessons({ app, session, choose: (keys) => knobs.show(keys), say: (words) => notice.say(words), listed: (all) => void shown.update(all) });
  const exercises = new Exercises(app, (words) => notice.say(words));
  session.wantsWorking = () => app.tabs.current === "working" || lessons.wantsWorking;
  if (app.view) {
    new TipHandle(app, app.view, session);
    const hand = new Throw(app, app.view, session);
    byId("ride").before(hand.button);
    app.keys.set("g", () => hand.toggle());
  }
  const keys: [string, string][] = [["g", "take the body and throw it"], ["Ctrl + Z", "undo"], ["Ctrl + Y", "redo"], ["Tab to ω", "arrows move its tip, + and − its length"]];
  document.querySelector("#help dl")?.append(...keys.flatMap(([key, what]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, what)]));
  window.polhodeLive = session;
  window.polhodeInspection = inspection;
  window.polhodeReport = report;
  if (first) {
    app.show(first, true);
    document.body.classList.add("early");
  }
  void begin(files, session, shown, notice, lessons, exercises);
});

declare global {
  interface Window {
    /** Access for tests, and for inspection in the console. */
    polhodeLive?: Session;
    polhodeInspection?: Inspection;
    polhodeReport?: Report;
  }
}

// Shows errors. The last valid motion stays, dimmed.
function troubles(session: Session): void {
  const box = element("div", { id: "trouble", role: "status", hidden: true });
  byId("stage").append(box);
  session.listen({
    changed: () => {
      const { trouble } = session;
      document.body.classList.toggle("troubled", trouble !== null);
      box.hidden = trouble === null;
      const words = trouble ? [element("p", {}, trouble.message), ...(trouble.hint ? [element("p", { class: "hint" }, `hint: ${trouble.hint}`)] : [])] : [];
      box.replaceChildren(...words);
    },
  });
}

async function begin(files: Files, session: Session, shown: Shown, notice: Notice, lessons: Lessons, exercises: Exercises): Promise<void> {
  // A lesson changes the address.
  const fragment = location.hash;
  try {
    const linked = await readFragment(location.hash).catch(() => {
      files.problems.push("The link is damaged: this is the document itself.");
      return null;
    });
    await files.open();
    let { documents, first } = await engine.documents();
    if (linked && !documents.some((one) => isOf(one, linked))) {
      // The link has the scenario's text, but the page does not have its file.
      const path = `linked/${linked.name}`;
      await engine.put(path, new Blob([linked.text]));
      await engine.open(path, "linked");
      ({ documents, first } = await engine.documents());
    }
    const wanted = (linked && documents.find((one) => isOf(one, linked))) ?? documents.find(({ id }) => id === first) ?? documents[0];
    void shown.update(documents);
    const lesson = lessonOf(location.hash) ?? files.lesson;
    if (lesson !== null) await lessons.open(lesson);
    if (!session.document && wanted) await shown.open(wanted, linked?.text);
    else if (!session.document) notice.say("Drop a scenario, a parts list, a log, a mesh, a robot or a molecule on the page, or open a file.");
    // An opened document clears the notice.
    if (files.problems.length > 0) notice.say(files.problems.join("\n"));
    exercises.openLinked(fragment);
    files.watch(
      (all) => void shown.update(all),
      (isLost) => document.body.classList.toggle("lost", isLost),
    );
  } catch (problem) {
    notice.say(problem instanceof Error ? problem.message : String(problem));
  }
}

const isOf = ({ kind, name }: DocumentInfo, linked: { name: string }): boolean => kind === "scenario" && name === linked.name;
