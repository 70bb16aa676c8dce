/**
 * Script of an output that shows a motion. The output contains the packed data of the motion. The
 * viewer is in the first such output of the notebook. Without scripts, the output shows a sentence.
 */
import { beside } from "./beside";
import { frame } from "./frame";
import { known, wait } from "./shared";

const ABSENT =
  "The viewer of this motion is in another output of this notebook, which has not been shown yet or is gone. " +
  "Scroll to the first motion of the notebook; or restart the kernel, and run the cell again.";

for (const output of document.querySelectorAll<HTMLElement>(".polhode-motion:not([data-shown])")) {
  output.dataset.shown = "";
  const key = output.dataset.viewer ?? "";
  const show = (viewer: Promise<string>): void => {
    viewer.then(
      (page) => output.replaceChildren(frame(page, output.querySelector<HTMLScriptElement>("script.polhode-packed")?.text ?? "")),
      (problem: unknown) => say(`The viewer is damaged: ${String(problem)}`),
    );
  };
  const say = (words: string): void => {
    const said = output.querySelector("p");
    if (said) said.textContent = words;
  };
  const start = (): void => {
    const viewer = known(key);
    if (viewer) show(viewer);
    else {
      say(ABSENT);
      wait(key, show);
    }
  };
  if (output.dataset.beside === undefined) start();
  else beside(output, start);
}
