/**
 * Page in a frame of a notebook: it shows packed data, and then the data that the surrounding
 * document sends.
 */
import { type App, say } from "../app";
import { bytesOf } from "../base64";
import type { PageData } from "../data";
import { unpack } from "../packed";
import { setTheme } from "../theme";
import type { ToFrame } from "./message";

/** `begin` shows the first data. An empty text means that all data are sent. */
export function follow(text: string, begin: (page: PageData) => App): void {
  let app: App | null = null;
  /** Number of the last data: the latest are shown, whichever are unpacked first. */
  let last = 0;
  const show = async (packed: Uint8Array<ArrayBuffer>): Promise<void> => {
    last += 1;
    const mine = last;
    try {
      const page = await unpack(packed);
      if (mine !== last) return;
      if (app) app.show(page);
      else app = begin(page);
      say(null);
    } catch (problem) {
      say(problem);
    }
  };
  addEventListener("message", (event: MessageEvent<ToFrame>) => {
    if (event.source !== parent || parent === window) return;
    const { polhode } = event.data;
    if (polhode === "theme") setTheme(event.data.theme);
    if (polhode === "motion") void show(new Uint8Array(event.data.packed));
  });
  if (text.trim() === "") parent.postMessage({ polhode: "ready" }, "*");
  else void show(bytesOf(text));
}
