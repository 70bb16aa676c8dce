/** Events by name. Each name has a letter, so that no text covers a curve. */
export interface Marked {
  letter: string;
  name: string;
  /** Times, ascending, s. */
  times: number[];
}

export interface Mark {
  letter: string;
  time: number;
}

export function marked(events: readonly { time: number; name: string }[]): Marked[] {
  const names = [...new Set(events.map(({ name }) => name))];
  return names.map((name, k) => ({
    letter: k < 26 ? String.fromCharCode(65 + k) : String(k + 1),
    name,
    times: events.filter((event) => event.name === name).map(({ time }) => time),
  }));
}

export function marksOf(all: readonly Marked[]): Mark[] {
  return all.flatMap(({ letter, times }) => times.map((time) => ({ letter, time }))).sort((a, b) => a.time - b.time);
}

/**
 * Returns the text at each of some places, px, in ascending order. Letters that would overlap are
 * combined at the first place.
 */
export function labels(places: readonly number[], letters: readonly string[], width: number): string[] {
  const out = letters.map(() => "");
  let first = -1;
  places.forEach((place, k) => {
    const right = first < 0 ? -Infinity : places[first] + (width * out[first].length) / 2;
    if (place - width / 2 >= right) first = k;
    if (!out[first].includes(letters[k])) out[first] = `${out[first]}${letters[k]}`.slice(0, 4);
    // More than three letters do not fit.
    if (out[first].length > 3) out[first] = `${out[first].slice(0, 2)}…`;
  });
  return out;
}
