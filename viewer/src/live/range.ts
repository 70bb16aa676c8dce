/** The range of a knob: where a value is on its slider, and which values the slider gives. Pure. */

/** Places of a slider. */
export const PLACES = 1000;

export interface Range {
  low: number;
  high: number;
  scale: "linear" | "log";
}

/** From 0 to PLACES; beyond the range it is at its end. */
export function placeOf(value: number, { low, high, scale }: Range): number {
  const part = scale === "log" && value > 0 ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return PLACES * Math.min(Math.max(Number.isFinite(part) ? part : 0, 0), 1);
}

/** A value with no more digits than its slider tells apart. */
export function valueAt(place: number, { low, high, scale }: Range): number {
  const part = Math.min(Math.max(place / PLACES, 0), 1);
  if (part === 0) return low;
  if (part === 1) return high;
  if (scale === "log") return Number((low * (high / low) ** part).toPrecision(4));
  const step = 10 ** Math.floor(Math.log10((high - low) / PLACES));
  const value = Math.round((low + part * (high - low)) / step) * step;
  // Without the rounding of the product.
  return Number(value.toPrecision(12)) + 0;
}

/** How far a key goes, in places; null if it is none of a slider's. */
export function stepOf(key: string, isFine: boolean): number | null {
  const step = isFine ? 1 : PLACES / 100;
  switch (key) {
    case "ArrowRight":
    case "ArrowUp":
      return step;
    case "ArrowLeft":
    case "ArrowDown":
      return -step;
    case "PageUp":
      return PLACES / 10;
    case "PageDown":
      return -PLACES / 10;
    case "Home":
      return -PLACES;
    case "End":
      return PLACES;
    default:
      return null;
  }
}

/** What stands in the scenario for a number in a unit: `"4 mm"`, or 4. */
export function toml(value: number, unit: string): string {
  return unit === "" ? String(value) : quoted(`${value} ${unit}`);
}

/** What was typed, as TOML: a number has the knob's unit, and what has a unit of its own stands as it is. */
export function typedToml(text: string, unit: string): string {
  const typed = text.trim().replaceAll("−", "-");
  const isNumber = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(typed);
  return isNumber ? toml(Number(typed), unit) : quoted(typed);
}

// A basic string of TOML escapes as JSON does.
function quoted(text: string): string {
  return JSON.stringify(text);
}
