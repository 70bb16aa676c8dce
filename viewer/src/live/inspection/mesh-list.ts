/** Findings of a mesh as text: an entry for each, with its number in the picture. */
import { element } from "../../dom";
import { grouped } from "../../format";
import type { MeshFinding, MeshInspection } from "../protocol";
import { badge, entry, type Listed, listed } from "./listed";
import { INKS } from "./mesh-scene";

const WORDS: Record<MeshFinding["severity"], string> = { error: "Error", warning: "Warning", info: "Note" };

/** `isStill`: true if there is no motion to return to. */
export function meshList(mesh: MeshInspection, isStill: boolean, choose: (item: number) => void): Listed {
  const errors = mesh.findings.filter(({ severity }) => severity === "error").length;
  const shown = mesh.triangles.length / 3;
  const triangles = `${grouped(mesh.of)} triangles`;
  const verdict =
    errors === 0
      ? [element("h2", {}, "It bounds a solid"), `${triangles}. ${mesh.findings.length === 0 ? "Nothing was found that is wrong with it. " : ""}${isStill ? "Open it again to see it move. " : ""}`]
      : [element("h2", {}, "It bounds no solid"), `${triangles}, ${errors === 1 ? "one error" : `${errors} errors`}. Without a solid there is no mass, and no motion. `];
  const host = element(
    "div",
    {},
    verdict[0],
    element(
      "p",
      {},
      verdict[1],
      shown < mesh.of ? `The picture has ${grouped(shown)} of them; findings are of all. ` : "",
      mesh.findings.length > 0 ? "A number in the picture is that of the finding." : "",
    ),
    element("ol", { class: "entries" }, ...mesh.findings.map((finding, k) => item(finding, k, choose))),
  );
  return listed(host, mesh.findings.length);
}

function item({ code, severity, message, hint, edges, faces }: MeshFinding, k: number, choose: (item: number) => void): HTMLElement {
  const said = [badge(String(k + 1), INKS[severity]), " ", element("b", {}, WORDS[severity]), ` ${message} `, element("code", {}, code)];
  const help = hint === null ? [] : [element("p", { class: "hint" }, hint)];
  if (edges.length > 0 || faces.length > 0) {
    const made = entry(k, choose, said);
    made.append(...help);
    return made;
  }
  return element("li", {}, element("p", { class: "entry" }, ...said), ...help);
}
