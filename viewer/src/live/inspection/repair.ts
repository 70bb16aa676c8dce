/** Repair of a robot's file, shown before anything is written: each line before and after. */
import { element } from "../../dom";
import { save } from "../../save/files";
import type { RobotInspection } from "../protocol";

export function repair(proposed: RobotInspection["repair"], file: string): HTMLElement {
  const host = element("section", { class: "repair" }, element("h3", {}, "Repair"));
  if (!proposed) {
    host.append(element("p", {}, "No fix is written: none is the only one that agrees with the mass, the tensor, the geometry and the density of its link."));
    return host;
  }
  const { text, changes } = proposed;
  const lines = changes.reduce((sum, { after }) => sum + after.split("\n").length, 0);
  const rows = changes.flatMap(({ line, before, after }) => [
    ...before.split("\n").map((old, k) => row(String(line + k), "−", element("del", {}, old))),
    ...after.split("\n").map((now, k) => row(String(line + k), "+", element("ins", {}, now))),
  ]);
  // Named as in `polhode check robot.urdf --fix robot-fixed.urdf`.
  const name = file.replace(/(\.[^.]*)?$/, "-fixed$1");
  const said = element("p", { role: "status" });
  const button = element("button", { type: "button", class: "quiet" }, "Save the repaired file");
  button.addEventListener("click", () => {
    save(name, new Blob([text], { type: "application/xml" }));
    said.textContent = `${name} is among your downloads; the file that was opened is as it was.`;
  });
  host.append(
    element("p", {}, `${lines === 1 ? "One line" : `${lines} lines`} would change; nothing is written yet. On the command line: polhode check ${file} --fix ${name}`),
    element("div", { class: "diff", tabindex: "0", role: "region", "aria-label": "Lines that change" }, element("table", {}, element("tbody", {}, ...rows))),
    element("p", {}, button),
    said,
  );
  return host;
}

function row(line: string, sign: string, text: HTMLElement): HTMLElement {
  const words = sign === "−" ? "before" : "after";
  return element("tr", { class: words }, element("td", {}, line), element("td", { "aria-label": words }, sign), element("td", {}, element("code", {}, text)));
}
