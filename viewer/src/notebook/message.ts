/** Messages between a notebook's document and its frames with the viewer. */

/** Type of an element with packed data; the element is empty if the data are sent. */
export const PACKED = "application/octet-stream";

/**
 * Messages of the document to a frame. The frame sends `{ polhode: "ready" }` if it has nothing to
 * show yet.
 */
export type ToFrame = { polhode: "theme"; theme: "light" | "dark" } | { polhode: "motion"; packed: ArrayBuffer };
