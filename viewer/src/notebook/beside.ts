/**
 * The output of a widget's motion, which stands before the widget's own: it is seen where there is no widget, as in a notebook that is opened again
 * without its kernel, and hidden where there is one.
 */

/** How long a widget may take to appear where nothing says that it is on its way, ms. */
const PATIENCE = 2000;

/** What JupyterLab says in the place of a widget that it waits for, and of one that it does not have. */
const LOADING = "Loading widget";
const NOT_FOUND = "Error displaying widget";

/** Calls `show` once, when the output is to be seen. */
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
