/**
 * A WebM file with one video track (RFC 9559, Matroska, which includes WebM). Elements consist of
 * an identifier, a size and contents.
 */

export interface Chunk {
  /** Time, ms. */
  time: number;
  isKey: boolean;
  data: Uint8Array<ArrayBuffer>;
}

export interface Track {
  codec: "V_VP8" | "V_VP9";
  width: number;
  height: number;
  /** Duration of a frame and of the film, ms. */
  frame: number;
  duration: number;
  /** Conversion of the screen's colours by the encoder. */
  colour: { matrix?: string | null; transfer?: string | null; primaries?: string | null; fullRange?: boolean | null };
}

type Bytes = Uint8Array<ArrayBuffer>;

/**
 * Maximum duration of a cluster, ms. Players seek to clusters, and the time of a block within one
 * has 16 bits.
 */
const LONGEST = 30_000;

/** Returns the file. Chunks are in the order of their times, and the first is a key frame. */
export function webm(chunks: readonly Chunk[], track: Track): Blob {
  const clusters: { time: number; parts: Bytes[]; size: number }[] = [];
  for (const { time, isKey, data } of chunks) {
    let last = clusters.at(-1);
    if (!last || isKey || time - last.time > LONGEST) {
      last = { time, parts: [element(0xe7, integer(time))], size: 0 };
      clusters.push(last);
    }
    const after = time - last.time;
    const head = Uint8Array.of(0x81, after >> 8, after & 255, isKey ? 0x80 : 0);
    last.parts.push(header(0xa3, head.length + data.length), head, data);
  }
  const whole = clusters.map(({ time, parts }) => {
    const size = length(parts);
    return { time, parts: [header(0x1f43b675, size), ...parts] };
  });
  const before = joined(info(track), tracks(track));
  // Positions of clusters, from the beginning of the segment's content. The length is fixed,
  // because the positions depend on it.
  const cues = (first: number): Bytes => {
    let at = first;
    const points = whole.map(({ time, parts }) => {
      const point = element(0xbb, element(0xb3, integer(time)), element(0xb7, element(0xf7, integer(1)), element(0xf1, integer(at, 8))));
      at += length(parts);
      return point;
    });
    return element(0x1c53bb6b, ...points);
  };
  const index = cues(before.length + cues(0).length);
  const content = [before, index, ...whole.flatMap(({ parts }) => parts)];
  return new Blob([ebml(), header(0x18538067, length(content)), ...content], { type: "video/webm" });
}

function ebml(): Bytes {
  const numbers = [[0x4286, 1], [0x42f7, 1], [0x42f2, 4], [0x42f3, 8]].map(([id, value]) => element(id, integer(value)));
  return element(0x1a45dfa3, ...numbers, element(0x4282, text("webm")), element(0x4287, integer(4)), element(0x4285, integer(2)));
}

function info({ duration }: Track): Bytes {
  const real = new Uint8Array(8);
  new DataView(real.buffer).setFloat64(0, duration);
  // Times are in units of 10⁶ ns.
  return element(0x1549a966, element(0x2ad7b1, integer(1e6)), element(0x4489, real), element(0x4d80, text("polhode")), element(0x5741, text("polhode")));
}

function tracks({ codec, width, height, frame, colour }: Track): Bytes {
  const video = element(0xe0, element(0xb0, integer(width)), element(0xba, integer(height)), element(0x55b0, ...colours(colour)));
  const numbers = [[0xd7, 1], [0x73c5, 1], [0x83, 1], [0x9c, 0], [0x23e383, Math.round(1e6 * frame)]].map(([id, value]) => element(id, integer(value)));
  return element(0x1654ae6b, element(0xae, ...numbers, element(0x86, text(codec)), video));
}

/** Returns colours in the numbers of ITU-T H.273; unknown ones are omitted. */
function colours({ matrix, transfer, primaries, fullRange }: Track["colour"]): Bytes[] {
  const known: [number, number | undefined][] = [
    [0x55b1, { rgb: 0, bt709: 1, bt470bg: 5, smpte170m: 6 }[matrix ?? ""]],
    [0x55b9, fullRange === undefined || fullRange === null ? undefined : fullRange ? 2 : 1],
    [0x55ba, { bt709: 1, smpte170m: 6, "iec61966-2-1": 13 }[transfer ?? ""]],
    [0x55bb, { bt709: 1, bt470bg: 5, smpte170m: 6 }[primaries ?? ""]],
  ];
  return known.flatMap(([id, value]) => (value === undefined ? [] : [element(id, integer(value))]));
}

function element(id: number, ...content: Bytes[]): Bytes {
  return joined(header(id, length(content)), ...content);
}

/** Returns a header. Identifiers begin with the bits of their length; a size has 8 bytes. */
function header(id: number, size: number): Bytes {
  return joined(integer(id), Uint8Array.of(1), integer(size, 8).subarray(1));
}

/** Returns an integer, most significant byte first, in at least `bytes` bytes. */
function integer(value: number, bytes = 0): Bytes {
  const digits: number[] = [];
  for (let rest = value; rest > 0 || digits.length < Math.max(bytes, 1); rest = Math.floor(rest / 256)) digits.unshift(rest % 256);
  return Uint8Array.from(digits);
}

const text = (words: string): Bytes => new TextEncoder().encode(words);

function length(parts: Bytes[]): number {
  return parts.reduce((sum, part) => sum + part.length, 0);
}

function joined(...parts: Bytes[]): Bytes {
  const all = new Uint8Array(length(parts));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
