/** What a notebook's document and its frames with the viewer have in common. */

/** The type of an element with packed data, which is empty where they are sent. */
export const PACKED = "application/octet-stream";

/** What the document says to a frame. The frame says `{ polhode: "ready" }` when it has nothing to show yet. */
export type ToFrame = { polhode: "theme"; theme: "light" | "dark" } | { polhode: "motion"; packed: ArrayBuffer };
