/** What the page uses of omggif, which has no types. */
declare module "omggif" {
  export class GifWriter {
    /** Writes a header into the buffer. The palette has 2ⁿ colours, 0xrrggbb; `loop: 0` is without end. */
    constructor(buffer: Uint8Array, width: number, height: number, options: { palette: number[]; loop: number });
    /** Returns where the buffer's content ends; `delay` in 1/100 s. With disposal 1 the frame stays. */
    addFrame(x: number, y: number, width: number, height: number, pixels: Uint8Array, options: { delay: number; disposal: number; transparent?: number }): number;
    end(): number;
    getOutputBufferPosition(): number;
    setOutputBufferPosition(position: number): void;
  }
}
