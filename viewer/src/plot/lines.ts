/** A line over time. */
export interface Line {
  /** Symbol for axes, such as ω or T + U. */
  symbol: string;
  /** Label in the legend, such as "θ nutation". */
  label: string;
  /** Name of a custom property of theme.css without its dashes. */
  ink: string;
  /** Values, one for each sample, in the figure's unit; NaN where there is none. */
  values: Float64Array;
  dash?: number[];
  /** True if the line has an axis of its own. */
  alone?: boolean;
  /** 1 where the line does not continue from the previous sample. */
  starts?: Uint8Array;
  /** Largest error of the balance of the same quantity, relative. */
  drift?: number;
}

/** A figure: lines of one quantity. */
export interface Figure {
  id: string;
  title: string;
  /** Quantity of an axis with several lines. */
  quantity: string;
  unit: string;
  /**
   * True for a logarithmic scale, with a dot for each sample and a line for the largest value so
   * far. Zeros are omitted.
   */
  log: boolean;
  /**
   * Number of samples that determine the size of the values. A diverging motion leaves the plot at
   * its end.
   */
  telling: number;
  /** Threshold below which values are rounding errors. */
  nothing: number;
  /** True if the samples may miss oscillations. */
  aliased: boolean;
  lines: Line[];
  /** Note on omitted parts and the reason. */
  note?: string;
}
