/** Declarations of the used parts of omggif, which has no types. */
declare module "omggif" {
  export class GifWriter {
    /**
     * Writes a header into the buffer. The palette has 2ⁿ colours, 0xrrggbb; `loop: 0` means
     * endless.
     */
    constructor(buffer: Uint8Array, width: number, height: number, options: { palette: number[]; loop: number });
    /**
     * Returns the end of the buffer's content. `delay` is in 1/100 s. With disposal 1 the frame
     * remains.
     */
    addFrame(x: number, y: number, width: number, height: number, pixels: Uint8Array, options: { delay: number; disposal: number; transparent?: number }): number;
    end(): number;
    getOutputBufferPosition(): number;
    setOutputBufferPosition(position: number): void;
  }
}
