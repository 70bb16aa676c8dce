/** The live page: the viewer, whose data are what the server makes of a scenario that knobs, the scene and the editor change. */
import { App, orSay } from "../app";
import { byId, element } from "../dom";
import { Actions } from "./actions";
import { Watch } from "./documents";
import { Drop } from "./drop";
import { Editor } from "./editor";
import { EMPTY } from "./empty";
import { Knobs } from "./knobs";
import { lessonOf, Lessons } from "./lesson";
import { readFragment } from "./link";
import { Notice } from "./notice";
import { MomentsPad } from "./pad";
import type { DocumentInfo } from "./protocol";
import { server } from "./server";
import { Session } from "./session";
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
        new Editor(host, session);
        return undefined;
      },
    },
    working,
    numbers,
    {
      id: "lesson",
      title: "Lessons",
      fill: (host) => {
        host.append(lessons.host);
        return undefined;
      },
    },
    about,
  ]);
  document.body.classList.add("live", "waiting");
  session.listen({
    moved: (page, { anew, isWorked }) => {
      // Until the worked solution comes, that of before; nobody sees it.
      const shown = isWorked ? page : { ...page, explanation: app.page.explanation };
      app.show(shown, anew);
      document.body.classList.remove("waiting");
    },
  });
  troubles(session);
  const notice = new Notice();
  const opened = (document: DocumentInfo): void => void open(session, document, notice);
  const drop = new Drop(opened, (words) => notice.say(words));
  const actions = new Actions(session, notice);
  const choice = element("select", { "aria-label": "Document", id: "documents", hidden: true });
  actions.host.prepend(choice, drop.button);
  byId("theme").before(actions.host);
  document.querySelector("header")?.after(notice.host);
  const pad = new MomentsPad(session);
  const knobs = new Knobs(session, pad.host, () => ({ page: app.page, motion: app.motion }));
  document.querySelector(".view")?.append(knobs.host);
  const lessons = new Lessons({ app, session, choose: (keys) => knobs.show(keys), say: (words) => notice.say(words) });
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
  void begin(session, notice, choice, lessons);
});

declare global {
  interface Window {
    /** For tests and for curious people at the console. */
    polhodeLive?: Session;
  }
}

// The last good motion stays, dimmed, with what is wrong.
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

async function begin(session: Session, notice: Notice, choice: HTMLSelectElement, lessons: Lessons): Promise<void> {
  const watch = new Watch(
    (all) => {
      list(all);
      void changed(all);
    },
    (isLost) => document.body.classList.toggle("lost", isLost),
  );
  const list = (all: DocumentInfo[]): void => {
    choice.replaceChildren(...all.map(({ id, name }) => element("option", { value: String(id) }, name)));
    choice.value = String(session.document?.id ?? "");
    choice.hidden = all.length < 2;
  };
  const changed = async (all: DocumentInfo[]): Promise<void> => {
    const mine = session.document;
    const now = all.find(({ id }) => id === mine?.id);
    if (!mine || !now || now.stamp === mine.stamp || (await lessons.reread(mine.id))) return;
    const content = await server.document(now.id);
    if (content.kind !== "scenario") return;
    if (!session.isChanged || content.text === session.text) {
      session.reload(now, content.text);
      return;
    }
    session.document = now;
    notice.say(`${now.name} changed on disk.`, [
      { label: "Take it", then: () => session.reload(now, content.text) },
      {
        label: "Keep mine",
        then: () => {
          session.fileText = content.text;
        },
      },
    ]);
  };
  choice.addEventListener("change", () => {
    const chosen = watch.all.find(({ id }) => String(id) === choice.value);
    if (chosen) void open(session, chosen, notice);
  });
  session.listen({ changed: () => void (choice.value = String(session.document?.id ?? "")) });
  try {
    const { documents, first } = await server.documents();
    const linked = await readFragment(location.hash).catch(() => {
      notice.say("The link is damaged: this is the document itself.");
      return null;
    });
    const wanted = (linked && documents.find(({ name, kind }) => kind === "scenario" && name === linked.name)) ?? documents.find(({ id }) => id === first) ?? documents[0];
    watch.start(documents);
    const lesson = lessonOf(location.hash);
    if (lesson !== null) await lessons.open(lesson);
    if (session.document) return;
    if (wanted) await open(session, wanted, notice, linked?.text);
    else notice.say("Drop a scenario, a mesh, a molecule or particles on the page, or open a file.");
    list(documents);
  } catch (problem) {
    notice.say(problem instanceof Error ? problem.message : String(problem));
  }
}

/** Of what this page does not show: who says what is wrong with it. */
const NOT_SHOWN = {
  mesh: "it bounds no solid, so that it has no motion; polhode inertia says where it is open or crosses itself.",
  robot: "this page does not show robots yet; polhode check says what is wrong with their inertias.",
};

async function open(session: Session, document: DocumentInfo, notice: Notice, text?: string): Promise<void> {
  try {
    const content = await server.document(document.id);
    notice.clear();
    if (content.kind === "scenario") session.open(document, content.text, text);
    else notice.say(`${document.name}: ${NOT_SHOWN[content.kind]}`);
  } catch (problem) {
    notice.say(`${document.name}: ${problem instanceof Error ? problem.message : String(problem)}`);
  }
}
