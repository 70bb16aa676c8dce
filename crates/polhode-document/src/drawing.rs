//! Pictures of documents, except graphs.

use polhode::body::{MOMENT_TRIANGLE, place_in_moment_triangle};
use serde_json::{Value, json};

use super::graph::{COLUMNS, Canvas};
use crate::layout::{plain_spaces, printable, width};

/// Picture as data. Plain text draws scatter plots and bars with characters; for the others it has
/// only the numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Drawing {
    /// Dots over an axis.
    Scatter(Scatter),
    /// Ratios of principal moments on the triangle of physical bodies.
    Triangle(Triangle),
    /// Correlation matrix.
    Correlations(Correlations),
    /// Panels of horizontal bars.
    Bars(Bars),
    /// Boxes in space.
    Solids(Solids),
}

/// Dots over an axis, with a band around zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Scatter {
    /// Title of the picture.
    pub title: String,
    /// Name and unit of the horizontal axis.
    pub across: [&'static str; 2],
    /// Name and unit of the vertical axis.
    pub up: [&'static str; 2],
    /// Series of dots.
    pub series: Vec<Series>,
    /// Half-width of the band; it extends from −`band` to +`band`.
    pub band: f64,
    /// Name of the band.
    pub band_name: &'static str,
}

/// Dots of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name of the series.
    pub name: String,
    /// Character of the dots in plain text.
    pub mark: char,
    /// Points from left to right.
    pub points: Vec<[f64; 2]>,
}

/// Triangle of moments with one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Ratios i1/i3 and i2/i3 of the principal moments of inertia.
    pub ratios: [f64; 2],
    /// Standard deviations of the ratios, if known.
    pub sd: Option<[f64; 2]>,
    /// Confidence regions: probability, and outline in (i1/i3, i2/i3). The smallest comes first.
    pub regions: Vec<(f64, Vec<[f64; 2]>)>,
    /// Ratios i1/i3 and i2/i3 of bodies drawn from the error distribution.
    pub cloud: Vec<[f64; 2]>,
}

/// Panels of bars.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    /// Title of the picture.
    pub title: String,
    /// Text below the picture.
    pub caption: &'static str,
    /// Names of the kinds of bars.
    pub kinds: Vec<&'static str>,
    /// Panels by row, from left to right.
    pub panels: Vec<BarPanel>,
}

/// Horizontal bars over one axis, from top to bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct BarPanel {
    /// Title of the panel.
    pub title: String,
    /// Name and unit of the horizontal axis.
    pub across: [&'static str; 2],
    /// Bars from top to bottom.
    pub bars: Vec<Bar>,
}

/// Horizontal bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Name of the bar.
    pub name: String,
    /// Value at its start.
    pub from: f64,
    /// Value at its end.
    pub to: f64,
    /// Size as text.
    pub size: String,
    /// Index of its kind, which determines its colour.
    pub kind: usize,
}

/// Boxes in space, and axes through a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Solids {
    /// Title of the picture.
    pub title: String,
    /// Text below the picture.
    pub caption: String,
    /// Boxes in any order.
    pub solids: Vec<Solid>,
    /// Names of the groups.
    pub groups: Vec<String>,
    /// Point of the axes, m.
    pub center: [f64; 3],
    /// Unit vectors of the axes.
    pub axes: [[f64; 3]; 3],
}

/// Box with any orientation.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of the part.
    pub name: String,
    /// Centre, m.
    pub center: [f64; 3],
    /// Vectors from the centre to the middles of three faces, orthogonal, m.
    pub halves: [[f64; 3]; 3],
    /// Index of its group; an index out of range means no group.
    pub group: usize,
}

/// Correlation matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlations {
    /// Names of the quantities.
    pub names: Vec<String>,
    /// Correlations by row; `None` for a quantity without an error.
    pub rows: Vec<Vec<Option<f64>>>,
}

impl Drawing {
    /// Returns the text below the picture.
    pub fn caption(&self) -> Option<String> {
        let triangle = match self {
            Self::Triangle(triangle) => triangle,
            Self::Bars(bars) => return (!bars.caption.is_empty()).then(|| bars.caption.to_owned()),
            Self::Solids(solids) => return Some(solids.caption.clone()),
            Self::Scatter(_) | Self::Correlations(_) => return None,
        };
        let percent = |p: f64| format!("{:.0} %", 100.0 * p);
        let regions: Vec<String> = triangle.regions.iter().map(|(p, _)| percent(*p)).collect();
        let of_regions = if regions.is_empty() {
            String::new()
        } else {
            format!(
                " The blue regions contain the true ratios with a probability of {}: the ellipse of their covariance, cut off where no body can exist.",
                regions.join(" and ")
            )
        };
        let of_cloud = match triangle.cloud.len() {
            0 => String::new(),
            count => format!(" Dots are {count} bodies that the errors allow."),
        };
        Some(format!(
            "The point shows how the mass extends along the principal axes 1, 2 and 3: in a corner along one of them (a rod), on an edge along two (a thin plate), in the middle equally along all three (a sphere or a cube). i1 ≤ i2 ≤ i3 are the principal moments. Outside the triangle one moment would exceed the sum of the other two.{of_regions}{of_cloud}"
        ))
    }

    /// Returns the picture in characters; empty if it cannot be drawn so.
    pub fn lines(&self) -> Vec<String> {
        match self {
            Self::Scatter(scatter) => scatter.lines(),
            Self::Bars(bars) => bars.lines(),
            Self::Triangle(_) | Self::Correlations(_) | Self::Solids(_) => Vec::new(),
        }
    }

    /// Returns `{"kind": …, …}` with the numbers of the picture.
    pub fn to_json(&self) -> Value {
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
            Self::Bars(bars) => bars.to_json(),
            Self::Solids(solids) => solids.to_json(),
        }
    }
}

impl Series {
    /// Returns the points; if there are more than two per column, the least and the greatest of
    /// each column.
    pub fn seen(&self, columns: usize, [left, right]: [f64; 2]) -> Vec<[f64; 2]> {
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
    /// Returns `{"kind": "triangle", "ratios": […], "place": […], "regions": [{"probability": …,
    /// "outline": […]}]}`.
    pub fn to_json(&self) -> Value {
        let region = |(probability, outline): &(f64, Vec<[f64; 2]>)| json!({ "probability": probability, "outline": outline });
        let [first, second] = self.ratios;
        json!({
            "kind": "triangle",
            "ratios": self.ratios,
            "place": place_in_moment_triangle([first, second, 1.0]),
            "corners": MOMENT_TRIANGLE,
            "regions": self.regions.iter().map(region).collect::<Value>(),
            "cloud": self.cloud,
        })
    }
}

impl Scatter {
    /// Returns the ranges of x and y, the band included.
    pub fn ends(&self) -> [[f64; 2]; 2] {
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

/// Columns of the longest bar.
const LONGEST: usize = 40;
const NAME: usize = 32;

impl Bars {
    /// Draws a single panel in characters. Several panels would be too long; a table has their
    /// numbers.
    fn lines(&self) -> Vec<String> {
        let [panel] = &self.panels[..] else { return Vec::new() };
        let [least, greatest] = panel.ends();
        let column = |x: f64| ((x - least) / (greatest - least) * LONGEST as f64).round() as usize;
        let names: Vec<String> = panel.bars.iter().map(|bar| shortened(&printable(&bar.name))).collect();
        let beside = names.iter().map(|name| width(name)).max().unwrap_or(0);
        let mut lines = vec![format!("{} ({})", printable(&panel.title), panel.across[1])];
        for (bar, name) in panel.bars.iter().zip(names) {
            let (from, to) = (column(bar.from.min(bar.to)), column(bar.from.max(bar.to)));
            let drawn = format!("{}{}", " ".repeat(from), "█".repeat((to - from).max(1)));
            let gap = beside - width(&name);
            lines.push(format!("{name}{:gap$} │{drawn:<1$}  {2}", "", LONGEST + 1, bar.size));
        }
        lines
    }

    fn to_json(&self) -> Value {
        let bar = |bar: &Bar| json!({ "name": plain_spaces(&bar.name), "from": bar.from, "to": bar.to });
        let panel = |panel: &BarPanel| {
            json!({
                "title": plain_spaces(&panel.title),
                "across": panel.across,
                "bars": panel.bars.iter().map(bar).collect::<Value>(),
            })
        };
        json!({
            "kind": "bars",
            "title": plain_spaces(&self.title),
            "panels": self.panels.iter().map(panel).collect::<Value>(),
        })
    }
}

impl BarPanel {
    /// Returns the range of all bars, zero included.
    pub fn ends(&self) -> [f64; 2] {
        let wider = |[a, b]: [f64; 2], x: f64| [a.min(x), b.max(x)];
        self.bars.iter().flat_map(|bar| [bar.from, bar.to]).fold([0.0; 2], wider)
    }
}

fn shortened(name: &str) -> String {
    if width(name) <= NAME {
        return name.to_owned();
    }
    name.chars().take(NAME - 1).chain(['…']).collect()
}

impl Solids {
    /// Returns `{"kind": "solids", …}` with the numbers of the picture.
    pub fn to_json(&self) -> Value {
        let solid = |solid: &Solid| {
            json!({
                "name": solid.name,
                "group": self.groups.get(solid.group),
                "center": solid.center,
                "halves": solid.halves,
            })
        };
        json!({
            "kind": "solids",
            "title": plain_spaces(&self.title),
            "solids": self.solids.iter().map(solid).collect::<Value>(),
            "center": self.center,
            "axes": self.axes,
        })
    }
}
