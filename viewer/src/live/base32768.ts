/**
 * Base 32768: one UTF-16 character for 15 bits, with which a page in UTF-16 takes 16 bytes for 15.
 * Its digits, U+4000 … U+BFFF, have no meaning in HTML.
 */

/** Code of digit 0. */
const ZERO = 0x4000;
/** Bits of a digit. */
const BITS = 15;

/** Decodes `length` bytes. */
export function bytesOf32768(text: string, length: number): Uint8Array<ArrayBuffer> {
  if (text.length !== Math.ceil((8 * length) / BITS)) throw new Error(`${text.length} characters are not ${length} bytes`);
  const bytes = new Uint8Array(length);
  let waiting = 0;
  let bits = 0;
  for (let k = 0, at = 0; k < length; k += 1) {
    if (bits < 8) {
      waiting = ((waiting & ((1 << bits) - 1)) << BITS) | (text.charCodeAt(at) - ZERO);
      at += 1;
      bits += BITS;
    }
    bits -= 8;
    bytes[k] = waiting >> bits;
  }
  return bytes;
}

/** Encodes bytes, the most significant bit first. */
export function text32768(bytes: Uint8Array): string {
  const codes = new Uint16Array(Math.ceil((8 * bytes.length) / BITS));
  for (let k = 0; k < codes.length; k += 1) {
    const byte = Math.floor((BITS * k) / 8);
    const three = ((bytes[byte] ?? 0) << 16) | ((bytes[byte + 1] ?? 0) << 8) | (bytes[byte + 2] ?? 0);
    codes[k] = ZERO + ((three >> (24 - BITS - ((BITS * k) % 8))) & (2 ** BITS - 1));
  }
  return Array.from(codes, (code) => String.fromCharCode(code)).join("");
}
