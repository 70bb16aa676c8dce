//! Graph drawn with characters, for plain text.

use crate::layout::width;
use crate::number::number;

/// Curve over an axis, with a level line.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    /// Title of the graph.
    pub title: String,
    /// Name and unit of the horizontal axis.
    pub across: [&'static str; 2],
    /// Name and unit of the vertical axis.
    pub up: [&'static str; 2],
    /// Points of the curve, from left to right.
    pub points: Vec<[f64; 2]>,
    /// Level line: start, end and height, and its name.
    pub level: ([f64; 3], &'static str),
}

/// Width of a graph, columns.
pub const COLUMNS: usize = 60;
const ROWS: usize = 13;

/// Character grid of a plot.
#[derive(Debug)]
pub struct Canvas {
    ends: [[f64; 2]; 2],
    cells: Vec<[char; COLUMNS]>,
}

impl Canvas {
    /// Creates an empty canvas for these ranges of x and y.
    pub fn new(ends: [[f64; 2]; 2]) -> Self {
        Self { ends, cells: vec![[' '; COLUMNS]; ROWS] }
    }

    fn column(&self, x: f64) -> usize {
        place(x, self.ends[0], COLUMNS)
    }

    fn row(&self, y: f64) -> usize {
        ROWS - 1 - place(y, self.ends[1], ROWS)
    }

    /// Draws a horizontal line of hyphens.
    pub fn level(&mut self, from: f64, to: f64, height: f64) {
        let (row, columns) = (self.row(height), self.column(from)..=self.column(to));
        self.cells[row][columns].fill('-');
    }

    /// Draws a character at a point.
    pub fn put(&mut self, [x, y]: [f64; 2], mark: char) {
        let (row, column) = (self.row(y), self.column(x));
        self.cells[row][column] = mark;
    }

    /// Returns the rows with the axis names and the numbers at the ends of the axes.
    pub fn lines(&self, across: [&str; 2], up: [&str; 2]) -> Vec<String> {
        let [[left, right], [low, high]] = self.ends;
        let [top, bottom] = [high, low].map(|y| number(y, 3));
        let beside = width(&top).max(width(&bottom));
        let mut lines = vec![format!("{} ({})", up[0], up[1])];
        for (k, cells) in self.cells.iter().enumerate() {
            let label = match k {
                0 => top.as_str(),
                k if k == ROWS - 1 => bottom.as_str(),
                _ => "",
            };
            let cells: String = cells.iter().collect();
            lines.push(format!("{label:>beside$} │{}", cells.trim_end()));
        }
        let [left, right] = [left, right].map(|x| number(x, 3));
        let gap = COLUMNS.saturating_sub(width(&left) + width(&right));
        lines.push(format!("{:beside$} └{}", "", "─".repeat(COLUMNS)));
        lines.push(format!(
            "{:beside$}  {left}{}{right}   {} ({})",
            "",
            " ".repeat(gap),
            across[0],
            across[1]
        ));
        lines
    }
}

fn place(value: f64, [a, b]: [f64; 2], count: usize) -> usize {
    let part = if b > a { (value - a) / (b - a) } else { 0.5 };
    ((part * (count - 1) as f64).round() as usize).min(count - 1)
}

/// Returns the lines of the graph: title, rows, and the numbers at the ends of the axes.
pub fn lines(graph: &Graph) -> Vec<String> {
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let ([from, to, height], name) = graph.level;
    let across = ends(&mut graph.points.iter().map(|p| p[0]));
    let up = ends(&mut graph.points.iter().map(|p| p[1]).chain([height]));
    let mut canvas = Canvas::new([across, up]);
    canvas.level(from, to, height);
    graph.points.iter().for_each(|&point| canvas.put(point, '•'));
    let mut lines = vec![graph.title.clone()];
    lines.extend(canvas.lines(graph.across, graph.up));
    lines.push(format!("- - -  {name}"));
    lines
}
