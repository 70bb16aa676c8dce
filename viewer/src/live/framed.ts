/**
 * The page as a part of another page, at `polhode.html#frame`: the scene, its answer, the first
 * knobs and, if there is room, the plots. The motion plays, and scrolling stays with the other page.
 * `#frame=light` and `#frame=dark` set the theme.
 */
import type { App } from "../app";
import { byId } from "../dom";
import { setTheme } from "../theme";
import type { Session } from "./session";

const FRAGMENT = /^#frame(?:=(light|dark))?$/;

/** Returns true if the fragment of an address restores no state and opens nothing. */
export const isPlain = (fragment: string): boolean => fragment === "" || FRAGMENT.test(fragment);

/** Prepares the page if its address requests a frame. */
export function frame(app: App, session: Session): void {
  const requested = FRAGMENT.exec(location.hash);
  if (!requested) return;
  const [, theme] = requested;
  if (theme === "light" || theme === "dark") setTheme(theme);
  document.body.classList.add("framed");
  // The wheel scrolls the other page, as elsewhere on it. With Ctrl it zooms, as two fingers do.
  const keepFromCamera = (event: WheelEvent): void => {
    if (!event.ctrlKey) event.stopImmediatePropagation();
  };
  byId("canvas").addEventListener("wheel", keepFromCamera, { capture: true });
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  session.listen({
    moved: (_, { anew }) => {
      if (anew) app.clock.play();
    },
  });
}
