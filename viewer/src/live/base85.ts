/**
 * Base 85: five characters for four bytes. In a page it is 6 % shorter than base64. Its digits have no
 * meaning in HTML.
 */

/** The printable characters of ASCII after `"`, without `&'/<>\` and the backquote. */
export const DIGITS = Array.from({ length: 0x7f - 0x23 }, (_, k) => String.fromCharCode(0x23 + k))
  .filter((digit) => !"&'/<>\\`".includes(digit))
  .join("");

/** Decodes `length` bytes. */
export function bytesOf85(text: string, length: number): Uint8Array<ArrayBuffer> {
  const values = new Uint8Array(128);
  for (let k = 0; k < DIGITS.length; k += 1) values[DIGITS.charCodeAt(k)] = k;
  const words = Math.ceil(length / 4);
  if (text.length !== 5 * words) throw new Error(`${text.length} characters are not ${length} bytes`);
  const view = new DataView(new ArrayBuffer(4 * words));
  for (let k = 0; k < words; k += 1) {
    let word = 0;
    for (let at = 5 * k; at < 5 * k + 5; at += 1) word = 85 * word + values[text.charCodeAt(at)];
    view.setUint32(4 * k, word);
  }
  return new Uint8Array(view.buffer, 0, length);
}

/** Encodes bytes. */
export function text85(bytes: Uint8Array): string {
  const padded = new Uint8Array(4 * Math.ceil(bytes.length / 4));
  padded.set(bytes);
  const view = new DataView(padded.buffer);
  let text = "";
  for (let at = 0; at < padded.length; at += 4) {
    let word = view.getUint32(at);
    let group = "";
    for (let k = 0; k < 5; k += 1) {
      group = DIGITS[word % 85] + group;
      word = Math.floor(word / 85);
    }
    text += group;
  }
  return text;
}
