/** The page that `polhode` writes: it shows the data that it holds, and plays. */
import { App, orSay } from "./app";
import { readPage } from "./decode";

orSay(() => {
  const page = readPage(document);
  const app = new App(page, ({ plots, numbers, working, scenario, about }) => {
    return [plots, numbers, ...(page.explanation.length > 0 ? [working] : []), scenario, about];
  });
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) app.clock.play();
});
