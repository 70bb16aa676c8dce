/** The numbers: groups of rows, and what polhode found worth saying. */
import type { FactGroup, PageData } from "../data";
import { element } from "../dom";

export function facts(host: HTMLElement, page: PageData, notes: string[]): void {
  const findings = [...page.findings, ...notes.map((message) => ({ severity: "info" as const, message }))];
  if (findings.length > 0) {
    const list = element("ul", { class: "findings" });
    for (const { severity, message } of findings) {
      const warns = severity === "warning";
      list.append(
        element("li", { class: warns ? "warning" : "info" }, element("b", {}, warns ? "Warning" : "Note"), ` ${message}`),
      );
    }
    host.append(list);
  }
  for (const group of page.facts) host.append(table(group));
  host.append(element("p", { class: "hint" }, `${page.motion.count} samples, method: ${page.motion.method}.`));
}

function table(group: FactGroup): HTMLElement {
  const body = element("tbody");
  for (const { label, value, unit, note } of group.rows) {
    const number = element("td", { class: "value" }, value);
    if (unit !== "") number.append(element("span", { class: "unit" }, unit));
    body.append(element("tr", {}, element("th", { scope: "row" }, label), number));
    if (note !== "") body.append(element("tr", { class: "note" }, element("td", { colspan: "2" }, note)));
  }
  return element("section", { class: "facts" }, element("h3", {}, group.title), element("table", {}, body));
}
