/** The module of the engine and the worker's script, which the page contains (`boot.ts`). */
import type { Embedded } from "./boot";

declare global {
  interface Window {
    polhodeEmbedded: Embedded;
  }
}

export const embedded = window.polhodeEmbedded;
