/**
 * Formatting of numbers: four or more digits, a minus sign, powers of ten, and times in a suitable
 * unit.
 */

/** Formats a number, such as 1.234, 0.01234 or 1.234×10⁻⁵. */
export function number(value: number, figures = 5): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) {
    const before = Math.floor(Math.log10(size)) + 1;
    return minus(value.toFixed(Math.min(Math.max(figures - before, 0), 8)));
  }
  const [mantissa, exponent] = value.toExponential(figures - 1).split("e");
  return `${minus(mantissa)}×10${superscript(Number(exponent))}`;
}

/** Formats a whole number with commas between thousands: 34,061. */
export function grouped(count: number): string {
  return String(count).replace(/\B(?=(\d{3})+$)/g, ",");
}

/** Unit after a number. */
const UNIT = /^\(?[kMGTmµnpf]?(?:rad|deg|°|kg|g|m|s|h|d|J|N|W|A|T|V|Pa|Hz|K|turns)(?:[⁻¹²³]*)(?:[·/][A-Za-z]+[⁻¹²³]*)*[),;:.]*$/;

/** Length above which a word may be broken anywhere. */
const LONGEST = 36;

/** Length above which words are not joined at signs. */
const LONG = 28;

/**
 * Splits a text into words between which lines may break. A number stays with its unit, and with an
 * adjacent "=", "…" or "→".
 */
export function words(text: string): { text: string; whole: boolean }[] {
  const parts: string[] = [];
  let joins = false;
  for (const word of text.split(/[ \n]+/).filter((part) => part !== "")) {
    const last = parts.at(-1);
    const isUnit = last !== undefined && /[\d⁰¹²³⁴⁵⁶⁷⁸⁹)]$/.test(last) && UNIT.test(word);
    const isSign = /^[=…→±]$/.test(word);
    const isPower = word.startsWith("×10");
    const fits = last !== undefined && last.length + word.length < (isUnit || isPower ? LONGEST : LONG);
    if (last !== undefined && fits && (joins || isUnit || isSign || isPower)) {
      parts[parts.length - 1] = `${last}\u00a0${word}`;
    } else parts.push(word);
    joins = isSign;
  }
  return parts.map((part) => ({ text: part, whole: part.length <= LONGEST }));
}

/** Formats a tick label of an axis, as short as possible. */
export function mark(value: number, step: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) {
    return minus(value.toFixed(Math.min(Math.max(-Math.floor(Math.log10(step) + 1e-9), 0), 12)));
  }
  const exponent = Math.floor(Math.log10(size) + 1e-12);
  const digits = Math.min(Math.max(exponent - Math.floor(Math.log10(step) + 1e-9), 0), 12);
  return `${minus((value / 10 ** exponent).toFixed(digits))}×10${superscript(exponent)}`;
}

/** Formats a power of ten, such as 10⁻¹². */
export function powerOfTen(value: number): string {
  return `10${superscript(Math.round(Math.log10(value)))}`;
}

/** Returns a unit of time in which `seconds` is a readable number. */
export function timeUnit(seconds: number): { name: string; seconds: number } {
  const units: [string, number][] = [
    ["ps", 1e-12],
    ["ns", 1e-9],
    ["µs", 1e-6],
    ["ms", 1e-3],
    ["s", 1],
    ["h", 3600],
    ["d", 86400],
  ];
  let best = units[0];
  for (const unit of units) {
    const least = unit[0] === "h" ? 3 * 3600 : unit[0] === "d" ? 3 * 86400 : 0.5 * unit[1];
    if (seconds >= least) best = unit;
  }
  if (seconds === 0) return { name: "s", seconds: 1 };
  return { name: best[0], seconds: best[1] };
}

function minus(text: string): string {
  return text.replace("-", "−");
}

export function superscript(value: number): string {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return [...String(value)].map((c) => (c === "-" ? "⁻" : digits[Number(c)])).join("");
}
