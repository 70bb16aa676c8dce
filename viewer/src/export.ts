/** Files that the page saves: a plot as SVG or PNG, the 3-D view as PNG. Plots are drawn anew, black on white, for paper. */
import { decades, type Figure, HALF_TURN, isZero, rangeOf, ticks } from "./figures";
import { mark, powerOfTen, timeUnit } from "./format";

const WIDTH = 640;
const HEIGHT = 360;
const PLOT = { left: 74, right: 16, top: 40, bottom: 50 };
const FONT = "Helvetica, Arial, sans-serif";
/** The light theme's colours, whatever the screen shows. */
const PAPER: Record<string, string> = {
  "axis-1": "#0072b2",
  "axis-2": "#d55e00",
  "axis-3": "#009e73",
  omega: "#aa4499",
  torque: "#c98500",
  ink: "#000000",
  quiet: "#666666",
};

/** `from` and `to` are seconds: what is zoomed to. Events stand at their times. */
export function svgOf(
  figure: Figure,
  times: Float64Array,
  from: number,
  to: number,
  events: readonly { time: number; name: string }[] = [],
): string {
  const first = Math.max(times.findIndex((t) => t >= from) - 1, 0);
  let last = times.findIndex((t) => t > to);
  if (last < 0) last = times.length - 1;
  const unit = timeUnit(Math.max(Math.abs(from), Math.abs(to)));
  const [low, high] = rangeOf(figure, first, last);
  const level = figure.log ? Math.log10 : (v: number): number => v;
  const right = WIDTH - PLOT.right;
  const bottom = HEIGHT - PLOT.bottom;
  const x = (t: number): number => PLOT.left + ((t - from) / (to - from || 1)) * (right - PLOT.left);
  const y = (v: number): number => bottom - ((level(v) - level(low)) / (level(high) - level(low))) * (bottom - PLOT.top);

  const parts: string[] = [];
  const text = (at: [number, number], words: string, rest = ""): void => {
    parts.push(`<text x="${at[0].toFixed(1)}" y="${at[1].toFixed(1)}" ${rest}>${escape(words)}</text>`);
  };
  const rule = (a: number, b: number, c: number, d: number, color: string): void => {
    parts.push(`<line x1="${r(a)}" y1="${r(b)}" x2="${r(c)}" y2="${r(d)}" stroke="${color}"/>`);
  };
  const across = ticks(from / unit.seconds, to / unit.seconds, 7);
  for (const value of across.values) {
    rule(x(value * unit.seconds), PLOT.top, x(value * unit.seconds), bottom, "#e3e3e3");
    text([x(value * unit.seconds), bottom + 18], mark(value, across.step), 'text-anchor="middle"');
  }
  const up = isZero(figure) ? [0] : figure.log ? decades(low, high, 7) : ticks(low, high, 6, figure.wraps).values;
  const step = figure.log ? 1 : ticks(low, high, 6, figure.wraps).step;
  for (const value of up) {
    rule(PLOT.left, y(value), right, y(value), "#e3e3e3");
    text([PLOT.left - 8, y(value) + 4], figure.log ? powerOfTen(value) : mark(value, step), 'text-anchor="end"');
  }
  parts.push(
    `<clipPath id="plot"><rect x="${PLOT.left}" y="${PLOT.top}" width="${right - PLOT.left}" height="${bottom - PLOT.top}"/></clipPath>`,
  );
  for (const line of figure.lines) {
    const path = pathOf(line.values, times, first, last, x, y, figure.wraps);
    const dash = line.dash ? ` stroke-dasharray="${line.dash.join(" ")}"` : "";
    parts.push(
      `<path d="${path}" fill="none" stroke="${PAPER[line.ink] ?? "#000000"}" stroke-width="1.6" stroke-linejoin="round"${dash} clip-path="url(#plot)"/>`,
    );
  }
  let free = PLOT.left;
  for (const { time, name } of events.filter((event) => event.time >= from && event.time <= to)) {
    const at = x(time);
    parts.push(`<line x1="${r(at)}" y1="${PLOT.top}" x2="${r(at)}" y2="${bottom}" stroke="#666666" stroke-dasharray="2 3"/>`);
    if (at - 14 < free) continue;
    free = at;
    const place = `${r(at - 5)} ${bottom - 6}`;
    text([at - 5, bottom - 6], name, `fill="#666666" font-size="11" transform="rotate(-90 ${place})" paint-order="stroke" stroke="#ffffff" stroke-width="3"`);
  }
  parts.push(
    `<rect x="${PLOT.left}" y="${PLOT.top}" width="${right - PLOT.left}" height="${bottom - PLOT.top}" fill="none" stroke="#000000"/>`,
  );
  text([(PLOT.left + right) / 2, HEIGHT - 12], `time / ${unit.name}`, 'text-anchor="middle"');
  const middle = (PLOT.top + bottom) / 2;
  text([16, middle], `${figure.title} / ${figure.unit}`, `text-anchor="middle" transform="rotate(-90 16 ${middle})"`);
  let key = PLOT.left;
  for (const line of figure.lines) {
    const dash = line.dash ? ` stroke-dasharray="${line.dash.join(" ")}"` : "";
    parts.push(
      `<line x1="${key}" y1="24" x2="${key + 24}" y2="24" stroke="${PAPER[line.ink] ?? "#000000"}" stroke-width="2"${dash}/>`,
    );
    text([key + 30, 28], line.label);
    key += 52 + 7.2 * line.label.length;
  }
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT}" viewBox="0 0 ${WIDTH} ${HEIGHT}">` +
    `<rect width="${WIDTH}" height="${HEIGHT}" fill="#ffffff"/>` +
    `<g font-family="${FONT}" font-size="12.5" fill="#000000">${parts.join("")}</g></svg>\n`
  );
}

export function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export function saveSvg(name: string, svg: string): void {
  save(`${name}.svg`, new Blob([svg], { type: "image/svg+xml" }));
}

/** At three pixels to one. */
export async function savePng(name: string, svg: string): Promise<void> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = 3 * WIDTH;
  canvas.height = 3 * HEIGHT;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  saveCanvas(name, canvas);
}

export function saveCanvas(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => {
    if (blob) save(`${name}.png`, blob);
  }, "image/png");
}

/** A name for files: "T-handle in free fall" → "t-handle-in-free-fall". */
export function fileName(title: string): string {
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
  return name.slice(0, 60) || "polhode";
}

function pathOf(
  values: Float64Array,
  times: Float64Array,
  first: number,
  last: number,
  x: (t: number) => number,
  y: (v: number) => number,
  wraps: boolean,
): string {
  let path = "";
  let lifted = true;
  for (let i = first; i <= last; i += 1) {
    if (!Number.isFinite(values[i])) {
      lifted = true;
      continue;
    }
    const leaps = i > first && wraps && Math.abs(values[i] - values[i - 1]) > HALF_TURN;
    path += `${lifted || leaps ? "M" : "L"}${r(x(times[i]))} ${r(y(values[i]))}`;
    lifted = false;
  }
  return path;
}

function r(value: number): string {
  return String(Math.round(value * 100) / 100);
}

function escape(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
