/** Documents of the server, polled while the page is visible, so that changed files are shown. */
import type { DocumentInfo } from "./protocol";
import { server } from "./server";

/** Polling intervals, ms. */
const OFTEN = 500;
const SELDOM = 2000;

export class Watch {
  all: DocumentInfo[] = [];
  readonly #told: (all: DocumentInfo[]) => void;
  readonly #lost: (isLost: boolean) => void;

  /**
   * `told` receives the documents when one of them has changed; `lost` receives whether the server
   * is unreachable.
   */
  constructor(told: (all: DocumentInfo[]) => void, lost: (isLost: boolean) => void) {
    this.#told = told;
    this.#lost = lost;
  }

  start(all: DocumentInfo[]): void {
    this.all = all;
    setTimeout(() => void this.#ask(), OFTEN);
    document.addEventListener("visibilitychange", () => {
      if (!document.hidden) void this.#look();
    });
  }

  async #ask(): Promise<void> {
    const isThere = document.hidden || (await this.#look());
    setTimeout(() => void this.#ask(), isThere ? OFTEN : SELDOM);
  }

  async #look(): Promise<boolean> {
    try {
      const { documents } = await server.documents();
      this.#lost(false);
      const isSame = documents.length === this.all.length && documents.every(({ id, stamp }, k) => id === this.all[k].id && stamp === this.all[k].stamp);
      this.all = documents;
      if (!isSame) this.#told(documents);
      return true;
    } catch {
      this.#lost(true);
      return false;
    }
  }
}
