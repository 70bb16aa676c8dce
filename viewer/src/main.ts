/**
 * Page that `polhode` writes: it shows its data and plays. In a notebook, the data are packed, and
 * later data replace them.
 */
import { App, orSay } from "./app";
import type { PageData } from "./data";
import { readPage } from "./decode";
import { follow } from "./notebook/follow";
import { PACKED } from "./notebook/message";

orSay(() => {
  const held = document.getElementById("polhode-data");
  if (held instanceof HTMLScriptElement && held.type === PACKED) follow(held.text, begin);
  else begin(readPage(document));
});

function begin(first: PageData): App {
  const app = new App(first, ({ plots, numbers, working, scenario, about }) => {
    return [plots, numbers, ...(first.explanation.length > 0 ? [working] : []), scenario, about];
  });
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) app.clock.play();
  return app;
}
