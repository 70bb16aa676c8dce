/** The worked solution. */
import type { ExplanationBlock } from "../data";
import { element } from "../dom";
import { safeMath } from "./mathml";

export function working(host: HTMLElement, blocks: ExplanationBlock[]): void {
  for (const block of blocks) host.append(draw(block));
}

function draw(block: ExplanationBlock): HTMLElement {
  switch (block.kind) {
    case "heading":
      // The page's own headings are one level higher.
      return element((["h2", "h3", "h4"] as const)[block.level - 1] ?? "h4", {}, block.text);
    case "text":
      return element("p", {}, block.text);
    case "lines":
      return element("pre", { class: "lines", tabindex: "0" }, block.lines.join("\n"));
    case "formula": {
      const math = safeMath(block.mathml);
      const box = element("div", { class: "formula", tabindex: "0" });
      if (math) box.append(math);
      else box.append(element("code", {}, block.text));
      return box;
    }
    case "picture": {
      // An SVG in an image element cannot run scripts or load anything.
      const src = `data:image/svg+xml,${encodeURIComponent(block.svg)}`;
      return element("figure", {}, element("img", { src, alt: block.text }));
    }
    case "table": {
      const head = element("tr", {}, ...block.header.map((text) => element("th", { scope: "col" }, text)));
      const rows = block.rows.map((row) => element("tr", {}, ...row.map((text) => element("td", {}, text))));
      const table = element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows));
      return element("div", { class: "table", tabindex: "0" }, table);
    }
  }
}
