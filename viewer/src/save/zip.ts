/** A ZIP file of files that are stored as they are: pictures are compressed already. Names are ASCII. (PKWARE's APPNOTE 6.3.10) */

/** What fits without the extension for large files. */
const MOST_BYTES = 0xffff_ffff;
const MOST_FILES = 0xffff;

/** 1980-01-01: the same files are the same ZIP. */
const DATE = (1 << 5) | 1;

export class Zip {
  readonly #parts: Blob[] = [];
  readonly #directory: Uint8Array<ArrayBuffer>[] = [];
  #size = 0;

  get size(): number {
    return this.#size;
  }

  async add(name: string, content: Blob): Promise<void> {
    if (this.#directory.length === MOST_FILES || this.#size + content.size > MOST_BYTES) throw new Error(`a ZIP has at most ${MOST_FILES} files and 4 GB`);
    const letters = new TextEncoder().encode(name);
    const crc = crc32(new Uint8Array(await content.arrayBuffer()));
    // Version 2.0, no flags, stored.
    const common = [u16(20), u16(0), u16(0), u16(0), u16(DATE), u32(crc), u32(content.size), u32(content.size), u16(letters.length), u16(0)];
    const local = joined(u32(0x0403_4b50), ...common, letters);
    this.#directory.push(joined(u32(0x0201_4b50), u16(20), ...common, u16(0), u16(0), u16(0), u32(0), u32(this.#size), letters));
    this.#parts.push(new Blob([local]), content);
    this.#size += local.length + content.size;
  }

  finish(): Blob {
    const count = this.#directory.length;
    const long = this.#directory.reduce((sum, { length }) => sum + length, 0);
    const end = joined(u32(0x0605_4b50), u16(0), u16(0), u16(count), u16(count), u32(long), u32(this.#size), u16(0));
    return new Blob([...this.#parts, ...this.#directory, end], { type: "application/zip" });
  }
}

const u16 = (x: number): number[] => [x & 255, (x >>> 8) & 255];
const u32 = (x: number): number[] => [...u16(x & 0xffff), ...u16(x >>> 16)];

function joined(...parts: ArrayLike<number>[]): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(parts.flatMap((part) => Array.from(part)));
}

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k += 1) c = c & 1 ? 0xedb8_8320 ^ (c >>> 1) : c >>> 1;
  return c;
});

export function crc32(bytes: Uint8Array): number {
  let c = 0xffff_ffff;
  for (const byte of bytes) c = TABLE[(c ^ byte) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}
