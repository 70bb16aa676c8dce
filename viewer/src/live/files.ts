/**
 * Files that the page begins with: those in the page, or those that `polhode live` serves and
 * watches.
 */
import { inflated } from "../packed";
import { bytesOf32768 } from "./base32768";
import { engine } from "./engine";
import type { DocumentInfo } from "./protocol";

/** Polling intervals, ms. */
const OFTEN = 500;
const SELDOM = 2000;
/** Size of the length of the JSON, bytes. */
const WORD = 8;

/** Files and what to open. */
interface Pack {
  /** Paths of the files to open. */
  open: string[];
  /** Lesson to begin with: one of the page's, or a file. */
  lesson: { id: string } | { path: string } | null;
  files: { path: string; bytes: Blob }[];
}

export class Files {
  /** What could not be opened, with the reasons. */
  readonly problems: string[] = [];
  /** Id of the lesson to begin with. */
  lesson: string | null = null;
  readonly #address = document.querySelector<HTMLMetaElement>('meta[name="polhode-files"]')?.content ?? null;
  #tag = "";

  /** True if the page has files of its own, or a server of some. */
  get areGiven(): boolean {
    return this.#address !== null || packed() !== null;
  }

  /** Gives the files to the engine, and opens them. Without any, the example is opened. */
  async open(): Promise<void> {
    const pack = await this.#pack();
    if (pack) await this.#put(pack);
    for (const path of pack?.open ?? []) await engine.open(path).catch((problem: unknown) => this.problems.push(`${path.split("/").at(-1)}: ${String(problem instanceof Error ? problem.message : problem)}`));
    const lesson = pack?.lesson ?? null;
    if (lesson) this.lesson = "id" in lesson ? lesson.id : (await engine.lessonFile(lesson.path)).id;
    else if (!pack || pack.open.length === 0) await engine.openExample();
  }

  /**
   * Polls the files while the page is visible. `told` receives the documents when a file has
   * changed; `lost` receives whether the server is unreachable.
   */
  watch(told: (all: DocumentInfo[]) => void, lost: (isLost: boolean) => void): void {
    if (this.#address === null) return;
    const look = async (): Promise<boolean> => {
      try {
        const pack = await this.#pack();
        lost(false);
        if (!pack) return true;
        await this.#put(pack);
        told((await engine.documents()).documents);
        return true;
      } catch {
        lost(true);
        return false;
      }
    };
    const ask = async (): Promise<void> => {
      const isThere = document.hidden || (await look());
      setTimeout(() => void ask(), isThere ? OFTEN : SELDOM);
    };
    setTimeout(() => void ask(), OFTEN);
    document.addEventListener("visibilitychange", () => {
      if (!document.hidden) void look();
    });
  }

  async #put({ files }: Pack): Promise<void> {
    for (const { path, bytes } of files) await engine.put(path, bytes);
  }

  /** Returns the files of the page or of the server; null if there are none, or none has changed. */
  async #pack(): Promise<Pack | null> {
    if (this.#address === null) {
      const pack = packed();
      return pack ? read(await inflated(pack)) : null;
    }
    const answer = await fetch(this.#address, { cache: "no-store", headers: this.#tag === "" ? {} : { "If-None-Match": this.#tag } });
    if (answer.status === 304) return null;
    if (!answer.ok) throw new Error(`the server answers ${answer.status} ${answer.statusText}`);
    const pack = read(await answer.blob());
    this.#tag = answer.headers.get("ETag") ?? "";
    return pack;
  }
}

/** Returns the files in the page, deflated; null if there are none. */
function packed(): Uint8Array<ArrayBuffer> | null {
  const place = document.getElementById("polhode-files");
  return place && bytesOf32768(place.textContent, Number(place.dataset.length));
}

/** Reads a pack: the length of the JSON as a u64, the JSON, and the files one after another. */
async function read(pack: Blob): Promise<Pack> {
  const length = Number(new DataView(await pack.slice(0, WORD).arrayBuffer()).getBigUint64(0, true));
  const { open, lesson, files } = JSON.parse(await pack.slice(WORD, WORD + length).text()) as Omit<Pack, "files"> & { files: { path: string; length: number }[] };
  let at = WORD + length;
  const parts = files.map(({ path, length }) => ({ path, bytes: pack.slice(at, (at += length)) }));
  return { open, lesson, files: parts };
}
