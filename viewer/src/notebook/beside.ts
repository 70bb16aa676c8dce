/**
 * Static output of a widget's motion, placed before the widget. It is visible where there is no
 * widget, such as in a notebook without its kernel, and hidden next to a widget.
 */

/** Time for a widget to appear if nothing indicates that it is loading, ms. */
const PATIENCE = 2000;

/** Texts of JupyterLab instead of a widget that is loading, and of one that it does not have. */
const LOADING = "Loading widget";
const NOT_FOUND = "Error displaying widget";

/** Calls `show` once, when the output must become visible. */
export function beside(output: HTMLElement, show: () => void): void {
  const area = output.closest<HTMLElement>(".jp-OutputArea, .output") ?? output.parentElement ?? document.body;
  const own = output.closest<HTMLElement>(".jp-OutputArea-child") ?? output;
  const began = performance.now();
  let isShown = false;
  const look = (): void => {
    if (!output.isConnected) return;
    const isThere = area.querySelector(".polhode-widget") !== null;
    const others = [...area.querySelectorAll<HTMLElement>(".jp-OutputArea-child")].filter((other) => other !== own);
    const gone = others.filter((other) => other.textContent.includes(NOT_FOUND));
    const isAwaited = gone.length === 0 && (performance.now() - began < PATIENCE || others.some((other) => other.textContent.includes(LOADING)));
    const isSeen = !isThere && !isAwaited;
    own.style.display = isSeen ? "" : "none";
    for (const other of gone) other.style.display = isSeen ? "none" : "";
    if (isSeen && !isShown) {
      isShown = true;
      show();
    }
  };
  look();
  new MutationObserver(look).observe(area, { childList: true, subtree: true, characterData: true });
  setTimeout(look, PATIENCE + 50);
}
