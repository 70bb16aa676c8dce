/** Range of a knob: conversion between values and slider positions. Pure functions. */

/** Number of slider positions. */
export const PLACES = 1000;

export interface Range {
  low: number;
  high: number;
  scale: "linear" | "log";
}

/** Returns the slider position from 0 to PLACES; values beyond the range are at its ends. */
export function placeOf(value: number, { low, high, scale }: Range): number {
  const part = scale === "log" && value > 0 ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return PLACES * Math.min(Math.max(Number.isFinite(part) ? part : 0, 0), 1);
}

/** Number of steps of a fine drag. */
export const FINE_PLACES = 10 * PLACES;

/** Returns the value at a position, with no more digits than `places` steps resolve. */
export function valueAt(place: number, { low, high, scale }: Range, places = PLACES): number {
  const part = Math.min(Math.max(place / PLACES, 0), 1);
  if (part === 0) return low;
  if (part === 1) return high;
  if (scale === "log") return Number((low * (high / low) ** part).toPrecision(places > PLACES ? 5 : 4));
  const step = 10 ** Math.floor(Math.log10((high - low) / places));
  const value = Math.round((low + part * (high - low)) / step) * step;
  // Removes the rounding error of the product.
  return Number(value.toPrecision(12)) + 0;
}

/** Returns the step of a key in slider positions; null for other keys. */
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

/** Returns a number with a unit as TOML: `"4 mm"`, or 4. */
export function toml(value: number, unit: string): string {
  return unit === "" ? String(value) : quoted(`${value} ${unit}`);
}

/** Returns typed text as TOML. A plain number gets the knob's unit; text with a unit is kept. */
export function typedToml(text: string, unit: string): string {
  const typed = text.trim().replaceAll("−", "-");
  const isNumber = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(typed);
  return isNumber ? toml(Number(typed), unit) : quoted(typed);
}

// A basic string of TOML is escaped as in JSON.
function quoted(text: string): string {
  return JSON.stringify(text);
}
