/** Numbers: groups of rows, and findings. */
import type { FactGroup, PageData } from "../data";
import { element } from "../dom";
import { words } from "../format";

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

/** Returns a text without line breaks inside quantities. */
function unbroken(text: string): (Node | string)[] {
  return words(text).flatMap((word, k) => [k > 0 ? " " : "", element("span", word.whole ? { class: "nowrap" } : {}, word.text)]);
}

function table(group: FactGroup): HTMLElement {
  const body = element("tbody");
  for (const { label, value, unit, note } of group.rows) {
    const cell = element("td", { class: "value" }, ...unbroken(value));
    // The unit stays with the last number.
    if (unit !== "") {
      const last = cell.lastElementChild;
      const shown = element("span", { class: "unit" }, unit);
      if (last) last.append(unit === "°" ? "" : "\u00a0", shown);
      else cell.append(shown);
    }
    body.append(element("tr", {}, element("th", { scope: "row" }, label), cell));
    if (note !== "") body.append(element("tr", { class: "note" }, element("td", { colspan: "2" }, ...unbroken(note))));
  }
  return element("section", { class: "facts" }, element("h3", {}, group.title), element("table", {}, body));
}
