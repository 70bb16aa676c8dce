/** The scenario file as it was read, and the command that made the page. */
import type { PageData } from "../data";
import { element } from "../dom";

export function scenario(host: HTMLElement, page: PageData): void {
  host.append(element("p", { class: "hint" }, "Made by: ", element("code", {}, page.source)));
  if (page.scenario !== null) host.append(element("pre", { class: "scenario", tabindex: "0" }, page.scenario));
  else host.append(element("p", {}, "This motion was not read from a scenario file."));
}
