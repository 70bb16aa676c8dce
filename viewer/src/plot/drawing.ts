/** Drawings as lists of marks, converted to elements of the page or to the text of an SVG file. */

export type Mark =
  | { kind: "path"; d: string; ink?: string; width?: number; dash?: number[] | undefined; fill?: string; opacity?: number; box?: Box }
  | { kind: "text"; at: [number, number]; text: string; anchor?: "start" | "middle" | "end"; ink?: string; size?: number; upright?: boolean; halo?: boolean };

/** A clipping rectangle. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Returns the colour for a name in theme.css. */
export type Colours = (ink: string) => string;

export const onScreen: Colours = (ink) => `var(--${ink})`;

/** Returns colours of the light theme for printing, whatever the theme of the screen. */
export const onPaper: Colours = (ink) => PAPER[ink] ?? "#000000";

const PAPER: Record<string, string> = {
  "axis-1": "#0072b2",
  "axis-2": "#d55e00",
  "axis-3": "#009e73",
  omega: "#aa4499",
  torque: "#c98500",
  ink: "#000000",
  quiet: "#666666",
  grid: "#e3e3e3",
  line: "#b8bfc6",
  paper: "#ffffff",
};

/** Returns the text of an SVG file, black on white. */
export function svgText(marks: readonly Mark[], width: number, height: number): string {
  const all = marks.map((mark) => {
    const { tag, attributes, text } = described(mark, onPaper);
    const written = Object.entries(attributes).map(([name, value]) => ` ${name}="${escape(value)}"`).join("");
    return boxed(mark, `<${tag}${written}>${escape(text)}</${tag}>`);
  });
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">` +
    `<rect width="${width}" height="${height}" fill="#ffffff"/>` +
    `<g font-family="Helvetica, Arial, sans-serif">${all.join("")}</g></svg>\n`
  );
}

/** Returns the marks as elements, in the theme's colours. */
export function svgElements(marks: readonly Mark[]): SVGElement[] {
  return marks.map((mark) => {
    const { tag, attributes, text } = described(mark, onScreen);
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.textContent = text;
    return made;
  });
}

/**
 * Estimates the width of a text, px. The true width depends on the font on the reader's machine.
 */
export function textWidth(text: string, size: number): number {
  return 0.58 * size * [...text].length;
}

/** Splits a text into lines no wider than `width`, px; a wider word is broken. */
export function wrapped(text: string, width: number, size = 12.5): string[] {
  const most = Math.max(Math.floor(width / textWidth("0", size)), 1);
  const out: string[] = [];
  let row = "";
  for (const word of text.split(" ")) {
    const letters = [...word];
    const pieces = Array.from({ length: Math.max(Math.ceil(letters.length / most), 1) }, (_, k) => letters.slice(k * most, (k + 1) * most).join(""));
    for (const piece of pieces) {
      const longer = row === "" ? piece : `${row} ${piece}`;
      if ([...longer].length <= most) row = longer;
      else {
        out.push(row);
        row = piece;
      }
    }
  }
  return [...out, row].filter((line) => line !== "");
}

/** Returns the path of a polyline. */
export function through(points: readonly (readonly [number, number])[]): string {
  return points.map(([x, y], k) => `${k === 0 ? "M" : "L"}${round(x)} ${round(y)}`).join("");
}

export function ring([x, y]: readonly [number, number], radius: number): string {
  const r = round(radius);
  return `M${round(x - radius)} ${round(y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
}

function described(mark: Mark, colours: Colours): { tag: string; attributes: Record<string, string>; text: string } {
  if (mark.kind === "path") {
    const { d, ink, width = 1, dash, fill, opacity } = mark;
    const attributes: Record<string, string> = { d, fill: fill ? colours(fill) : "none" };
    if (ink) Object.assign(attributes, { stroke: colours(ink), "stroke-width": String(width), "stroke-linejoin": "round" });
    if (dash) attributes["stroke-dasharray"] = dash.join(" ");
    if (opacity !== undefined) attributes.opacity = String(opacity);
    return { tag: "path", attributes, text: "" };
  }
  const { at, text, anchor = "start", ink = "ink", size = 12.5, upright, halo } = mark;
  const [x, y] = at.map(round);
  const attributes: Record<string, string> = { x: String(x), y: String(y), "text-anchor": anchor, fill: colours(ink), "font-size": String(size) };
  if (upright) attributes.transform = `rotate(-90 ${x} ${y})`;
  if (halo) Object.assign(attributes, { "paint-order": "stroke", stroke: colours("paper"), "stroke-width": "3" });
  return { tag: "text", attributes, text };
}

// An inner SVG clips its contents.
function boxed(mark: Mark, written: string): string {
  if (mark.kind !== "path" || !mark.box) return written;
  const { left, top, width, height } = mark.box;
  return `<svg x="${left}" y="${top}" width="${width}" height="${height}" viewBox="${left} ${top} ${width} ${height}">${written}</svg>`;
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}

function escape(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
