/** What is drawn over time. */
export interface Line {
  /** On an axis: ω, T + U. */
  symbol: string;
  /** In the key: θ nutation. */
  label: string;
  /** A custom property of theme.css without its dashes. */
  ink: string;
  /** One for each sample, in the figure's unit; NaN where there is none. */
  values: Float64Array;
  dash?: number[];
  /** On an axis of its own. */
  alone?: boolean;
  /** 1 where the line does not go on from the sample before. */
  starts?: Uint8Array;
  /** How far the balance of the same quantity fails at the worst sample, relative. */
  drift?: number;
}

/** Lines of one quantity. */
export interface Figure {
  id: string;
  title: string;
  /** What an axis with several lines shows. */
  quantity: string;
  unit: string;
  /** Logarithmic: a dot for each sample, a line for the largest so far. Zero has no place. */
  log: boolean;
  /** So many samples say how large the values are: a motion that runs away leaves the plot at its end. */
  telling: number;
  /** What is smaller is zero but for rounding. */
  nothing: number;
  /** The samples may miss what oscillates. */
  aliased: boolean;
  lines: Line[];
  /** What is not drawn, and why. */
  note?: string;
}
