/**
 * Buttons next to a figure's title that save it as a file. Each label names the figure, for screen
 * readers.
 */
import { element } from "../dom";
import { savePng, saveSvg } from "./files";

export function saveButtons(title: string, file: string, svg: () => string): HTMLElement[] {
  const button = (kind: string, click: () => void): HTMLElement => {
    return element("button", { class: "small", type: "button", title: `Save as ${kind}`, "aria-label": `${title}: save as ${kind}`, click }, kind);
  };
  return [button("SVG", () => saveSvg(file, svg())), button("PNG", () => void savePng(file, svg()))];
}
