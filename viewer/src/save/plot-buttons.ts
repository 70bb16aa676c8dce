/** The buttons beside a figure's title: it as a file. Each says which figure, for those who hear them one after the other. */
import { element } from "../dom";
import { savePng, saveSvg } from "./files";

export function saveButtons(title: string, file: string, svg: () => string): HTMLElement[] {
  const button = (kind: string, click: () => void): HTMLElement => {
    return element("button", { class: "small", type: "button", title: `Save as ${kind}`, "aria-label": `${title}: save as ${kind}`, click }, kind);
  };
  return [button("SVG", () => saveSvg(file, svg())), button("PNG", () => void savePng(file, svg()))];
}
