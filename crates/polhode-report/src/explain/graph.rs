//! A graph in letters, for texts without pictures.

use super::document::Graph;
use crate::layout::width;
use crate::number::number;

const COLUMNS: usize = 60;
const ROWS: usize = 13;

/// The lines of the picture: its title, the rows, and the ends of the axes in numbers.
pub(super) fn lines(graph: &Graph) -> Vec<String> {
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    };
    let ([from, to, height], name) = graph.level;
    let [left, right] = ends(&mut graph.points.iter().map(|p| p[0]));
    let [low, high] = ends(&mut graph.points.iter().map(|p| p[1]).chain([height]));
    let place = |value: f64, [a, b]: [f64; 2], count: usize| {
        let part = if b > a { (value - a) / (b - a) } else { 0.5 };
        ((part * (count - 1) as f64).round() as usize).min(count - 1)
    };
    let mut cells = vec![[' '; COLUMNS]; ROWS];
    let row = |y: f64| ROWS - 1 - place(y, [low, high], ROWS);
    let column = |x: f64| place(x, [left, right], COLUMNS);
    cells[row(height)][column(from)..=column(to)].fill('-');
    for [x, y] in &graph.points {
        cells[row(*y)][column(*x)] = '•';
    }
    let [top, bottom] = [high, low].map(|y| number(y, 3));
    let beside = width(&top).max(width(&bottom));
    let mut lines = vec![graph.title.clone(), format!("{} ({})", graph.up[0], graph.up[1])];
    for (k, cells) in cells.iter().enumerate() {
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
        graph.across[0],
        graph.across[1]
    ));
    lines.push(format!("- - -  {name}"));
    lines
}
