//! Pictures of documents besides graphs.

use serde_json::{Value, json};

use super::graph::{COLUMNS, Canvas};
use crate::layout::{plain_spaces, printable};

/// A picture on a page. Texts have the dots in letters, and nothing of the rest, of which they have the numbers.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Drawing {
    /// Dots over an axis.
    Scatter(Scatter),
    /// The moments on their triangle.
    Triangle(Triangle),
    /// How errors hang together.
    Correlations(Correlations),
}

/// Dots over an axis, and a band about zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// What it shows.
    pub title: String,
    /// The name and the unit of what runs to the right.
    pub across: [&'static str; 2],
    /// The name and the unit of what is drawn over it.
    pub up: [&'static str; 2],
    /// Dots of several kinds.
    pub series: Vec<Series>,
    /// The band is from − to + this.
    pub band: f64,
    /// What the band is.
    pub band_name: &'static str,
}

/// Dots of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What they are.
    pub name: String,
    /// What they are in letters.
    pub mark: char,
    /// From left to right.
    pub points: Vec<[f64; 2]>,
}

/// The triangle of moments with a body on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// i1/i3 and i2/i3.
    pub ratios: [f64; 2],
    /// Where they are with a probability: its outline. The smallest first.
    pub regions: Vec<(f64, Vec<[f64; 2]>)>,
}

/// A matrix of correlations.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlations {
    /// The numbers.
    pub names: Vec<String>,
    /// Row by row; `None` of a number that has no error.
    pub rows: Vec<Vec<Option<f64>>>,
}

impl Drawing {
    /// What stands below the picture.
    pub(crate) fn caption(&self) -> Option<String> {
        let Self::Triangle(triangle) = self else { return None };
        let percent = |p: f64| format!("{:.0} %", 100.0 * p);
        let regions: Vec<String> = triangle.regions.iter().map(|(p, _)| percent(*p)).collect();
        let of_regions = if regions.is_empty() {
            String::new()
        } else {
            format!(
                " Where (i1/i3, i2/i3) are with a probability of {}: the ellipse of their covariance, each of its points at its place in the triangle, and cut off where no body is possible.",
                regions.join(" and ")
            )
        };
        Some(format!(
            "A body is where masses in the corners, as large as its second moments ∫x² dm along the principal axes, balance. Inside are all possible bodies, on the edges laminae, in the corners rods.{of_regions}"
        ))
    }

    /// In letters, if it can be.
    pub(super) fn lines(&self) -> Vec<String> {
        match self {
            Self::Scatter(scatter) => scatter.lines(),
            Self::Triangle(_) | Self::Correlations(_) => Vec::new(),
        }
    }

    pub(super) fn to_json(&self) -> Value {
        match self {
            Self::Scatter(scatter) => json!({
                "kind": "scatter",
                "title": plain_spaces(&scatter.title),
                "across": scatter.across,
                "up": scatter.up,
                "series": scatter.series.iter().map(|s| json!({ "name": s.name, "points": s.points })).collect::<Value>(),
                "band": { "half_width": scatter.band, "name": scatter.band_name },
            }),
            Self::Triangle(triangle) => triangle.to_json(),
            Self::Correlations(all) => {
                json!({ "kind": "correlations", "names": all.names, "rows": all.rows })
            }
        }
    }
}

impl Series {
    /// Its points; of more than two for each of so many columns the least and the greatest of each column.
    pub(crate) fn seen(&self, columns: usize, [left, right]: [f64; 2]) -> Vec<[f64; 2]> {
        if self.points.len() <= 2 * columns {
            return self.points.clone();
        }
        let column = |point: &[f64; 2]| ((point[0] - left) / (right - left) * columns as f64) as usize;
        let by_height = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let ends = |part: &[[f64; 2]]| -> Vec<[f64; 2]> {
            let both = [part.iter().min_by(by_height), part.iter().max_by(by_height)];
            both.into_iter().flatten().copied().collect()
        };
        self.points.chunk_by(|a, b| column(a) == column(b)).flat_map(ends).collect()
    }
}

impl Triangle {
    /// `{"kind": "triangle", "ratios": […], "place": […], "regions": [{"probability": …, "outline": […]}]}`
    pub(crate) fn to_json(&self) -> Value {
        let region = |(probability, outline): &(f64, Vec<[f64; 2]>)| json!({ "probability": probability, "outline": outline });
        let [first, second] = self.ratios;
        json!({
            "kind": "triangle",
            "ratios": self.ratios,
            "place": polhode_identify::on_triangle([first, second, 1.0]),
            "corners": polhode_identify::TRIANGLE,
            "regions": self.regions.iter().map(region).collect::<Value>(),
        })
    }
}

impl Scatter {
    /// All that is drawn, from left to right and from below.
    pub(crate) fn ends(&self) -> [[f64; 2]; 2] {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let wider = |[a, b]: [f64; 2], x: f64| [a.min(x), b.max(x)];
        let points = self.series.iter().flat_map(|series| &series.points);
        let start = [none, [-self.band, self.band]];
        points.fold(start, |[x, y], point| [wider(x, point[0]), wider(y, point[1])])
    }

    fn lines(&self) -> Vec<String> {
        let mut canvas = Canvas::new(self.ends());
        let [[left, right], _] = self.ends();
        for height in [-self.band, self.band] {
            canvas.level(left, right, height);
        }
        for series in &self.series {
            series.seen(COLUMNS, [left, right]).into_iter().for_each(|point| canvas.put(point, series.mark));
        }
        let mut lines = vec![printable(&self.title)];
        lines.extend(canvas.lines(self.across, self.up));
        let names = self.series.iter().map(|series| format!("{}  {}", series.mark, printable(&series.name)));
        let names: Vec<String> = names.chain([format!("- - -  {}", self.band_name)]).collect();
        lines.push(names.join("   "));
        lines
    }
}
