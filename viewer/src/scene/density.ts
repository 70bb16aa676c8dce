/**
 * Density of the drawing in any rectangle of the picture: points counted in cells, with cumulative
 * sums from the upper left.
 */
const CELL = 5;

export class Density {
  readonly #columns: number;
  readonly #rows: number;
  readonly #sums: Uint32Array;

  constructor(points: [number, number][], width: number, height: number) {
    this.#columns = Math.ceil(width / CELL) + 1;
    this.#rows = Math.ceil(height / CELL) + 1;
    const n = this.#columns;
    const sums = new Uint32Array(n * this.#rows);
    for (const [x, y] of points) {
      const [i, k] = [Math.floor(x / CELL) + 1, Math.floor(y / CELL) + 1];
      if (i > 0 && k > 0 && i < n && k < this.#rows) sums[k * n + i] += 1;
    }
    for (let k = 1; k < this.#rows; k += 1) {
      for (let i = 1; i < n; i += 1) sums[k * n + i] += sums[k * n + i - 1] + sums[(k - 1) * n + i] - sums[(k - 1) * n + i - 1];
    }
    this.#sums = sums;
  }

  /** Returns the number of points in the cells that a box around (x, y) touches. */
  count(x: number, y: number, w: number, h: number): number {
    const column = (at: number): number => Math.min(Math.max(Math.floor(at / CELL), 0), this.#columns - 2);
    const row = (at: number): number => Math.min(Math.max(Math.floor(at / CELL), 0), this.#rows - 2);
    const [left, right] = [column(x - w / 2), column(x + w / 2) + 1];
    const [top, bottom] = [row(y - h / 2) * this.#columns, (row(y + h / 2) + 1) * this.#columns];
    return this.#sums[bottom + right] - this.#sums[bottom + left] - this.#sums[top + right] + this.#sums[top + left];
  }
}
