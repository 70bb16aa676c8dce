//! Graph of a worked solution: a curve over an axis, and a level line.

use super::axes::{Area, Axes, Axis};
use super::legend::{Key, heading};
use super::picture::Picture;
use super::sheet::{Colour, Pen, Sheet};
use crate::graph::Graph;

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 280.0;
const MARGIN: f64 = 10.0;

impl Picture {
    /// Returns the picture of a graph.
    pub fn of_graph(graph: &Graph) -> Self {
        let mut sheet = Sheet::new(WIDTH, HEIGHT, graph.title.clone());
        let ([from, to, height], name) = graph.level;
        let curve = Pen::solid(Colour::AXES[1], 1.8);
        let level = Pen::solid(Colour::BLACK, 1.3).dashed(&[7.0, 2.5]);
        let whole = Area { left: MARGIN, top: MARGIN, right: WIDTH - MARGIN, bottom: HEIGHT - MARGIN };
        let keys = [Key::line(curve, graph.up[0]), Key::line(level, name)];
        let used = heading(&mut sheet, whole, &graph.title, "", &keys);
        let ends = |values: &mut dyn Iterator<Item = f64>| {
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
        };
        let x = ends(&mut graph.points.iter().map(|p| p[0]));
        let y = ends(&mut graph.points.iter().map(|p| p[1]).chain([height]));
        let axes = Axes::within(
            whole.below(used),
            Axis::linear(x, 0.0, 7.0, graph.across[0], graph.across[1]),
            Axis::linear(y, 0.06, 5.0, graph.up[0], graph.up[1]),
            None,
        );
        axes.draw(&mut sheet);
        sheet.line(graph.points.iter().map(|&p| axes.at(p)).collect(), curve);
        sheet.line(vec![axes.at([from, height]), axes.at([to, height])], level);
        Self { sheet }
    }
}
