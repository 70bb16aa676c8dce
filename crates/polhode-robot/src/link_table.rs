//! Table of all links of a model as bodies, and of the whole robot: as text, JSON and CSV.

use std::fmt::Write as _;

use polhode::body::{Finding, MassProperties};
use polhode::math::{Body, Rotation};
use polhode_document::SourceInfo;
use polhode_document::csv_name;
use polhode_document::layout::{columns, plain_spaces, printable};
use polhode_document::number::exact as decimal;
use polhode_document::number::number;
use polhode_shape::report::InertiaReport;
use polhode_source::text::counted;
use serde_json::{Map, Value, json};

use crate::body::{LinkMass, link_mass};
use crate::inertia::{of_lumps, of_model};
use crate::link_error::LinkError;
use crate::lump::Lumping;
use crate::model::{GeometryShape, Link, RobotModel};

/// Significant digits in the text table.
const DIGITS: usize = 4;

/// Column titles of the text table, with units.
const HEADS: [&str; 15] = [
    "link",
    "mass/kg",
    "x/mm",
    "y/mm",
    "z/mm",
    "i1/kg·m²",
    "i2/kg·m²",
    "i3/kg·m²",
    "ixx",
    "ixy",
    "ixz",
    "iyy",
    "iyz",
    "izz",
    "shape",
];

/// CSV columns after `file`, `row`, `name`, `frame` and `shape`, with their units.
const NUMBERS: [&str; 13] = [
    "mass_kg",
    "center_of_mass_x_m",
    "center_of_mass_y_m",
    "center_of_mass_z_m",
    "ixx_kg_m2",
    "ixy_kg_m2",
    "ixz_kg_m2",
    "iyy_kg_m2",
    "iyz_kg_m2",
    "izz_kg_m2",
    "i1_kg_m2",
    "i2_kg_m2",
    "i3_kg_m2",
];

/// Links of a robot, and the whole robot.
#[derive(Clone, Debug)]
pub struct LinkTable {
    /// Links in file order.
    pub rows: Vec<LinkRow>,
    /// All links as one body, in the model's frame, at the requested joint values.
    pub whole: InertiaReport,
    /// Name of the model after "of": `of arm`
    name: String,
}

/// Row of the table: one link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkRow {
    /// Name of the link.
    pub link: String,
    /// Kinds of its shapes: `box`, `mesh`.
    pub shapes: Vec<String>,
    /// Mass properties in the link's own frame; `None` if it has no mass.
    pub properties: Option<MassProperties<Body>>,
    /// Correction that made its tensor physical, kg·m²; usually zero.
    pub rounding: f64,
}

impl LinkTable {
    /// Builds the table of a model, with joint values by name, rad or m.
    ///
    /// # Errors
    /// [`LinkError`] if a link has unphysical mass properties, or if the links cannot be joined.
    pub fn of(model: &RobotModel, positions: &[(String, f64)]) -> Result<Self, LinkError> {
        let mut whole = of_lumps(model, Lumping::All, positions, false)?.into_iter();
        let whole = whole.next().ok_or_else(|| LinkError::massless(None))?;
        let rows = model.links.iter().map(|link| row(model, link)).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { rows, whole, name: of_model(model) })
    }

    /// Returns the findings about the whole model.
    pub fn findings(&self) -> &[Finding] {
        &self.whole.findings
    }

    /// Returns the text table with an explanation of its columns.
    pub fn to_text(&self) -> String {
        let SourceInfo { path, description, .. } = &self.whole.source;
        let mut text = format!(
            "{}   {} {}\n\
             x y z: centre of mass   ixx … izz: tensor about it, kg·m², off-diagonal = -∫xy dm   i1 ≤ i2 ≤ i3: its principal moments\n\
             each link: in its own frame and axes; last row: {}\n\n",
            printable(path),
            counted(self.rows.len(), "link"),
            printable(&self.name),
            printable(description),
        );
        let mut rows = vec![HEADS.map(str::to_owned).to_vec()];
        rows.extend(self.rows.iter().map(|row| cells(&row.link, row.properties.as_ref(), &row.shape())));
        rows.push(cells("whole robot", Some(&self.whole.properties), ""));
        for line in columns(&rows) {
            let _ = writeln!(text, "{}", line.trim_end());
        }
        for row in self.rows.iter().filter(|row| row.rounding > 0.0) {
            let (link, rounding) = (printable(&row.link), row.rounding);
            let _ = writeln!(
                text,
                "\n{link}: tensor changed by {rounding:.1e} kg·m², within its printed digits, to satisfy the triangle inequality"
            );
        }
        for finding in self.findings() {
            let (severity, message) = (finding.severity.name(), printable(&finding.message));
            let place =
                finding.place.as_ref().map_or_else(String::new, |place| format!(" {}", printable(place)));
            let _ = writeln!(text, "\n{severity}:{place} {message} [{}]", finding.code);
        }
        plain_spaces(&text)
    }

    /// Returns one object with `links` and `whole`. `links` is an array in file order; links with
    /// mass have the keys of `polhode inertia --json`. `whole` is the object that `--lump all`
    /// prints.
    pub fn to_json(&self) -> Value {
        let links: Vec<Value> = self.rows.iter().map(|row| row.to_json(&self.whole.source)).collect();
        json!({
            "polhode": polhode_document::VERSION,
            "file": self.whole.source.path,
            "links": links,
            "whole": self.whole.to_json(),
        })
    }

    /// Returns the header line of [`LinkTable::to_csv`].
    pub fn csv_head() -> String {
        let names = ["file", "row", "name", "frame", "shape"];
        names.into_iter().chain(NUMBERS).collect::<Vec<_>>().join(",") + "\n"
    }

    /// Returns one line for each link (`link` in the column `row`) and one for the whole robot
    /// (`whole`), without a header. Numbers are exact, in SI units. A link without mass has empty
    /// numbers and the `shape` `massless`.
    pub fn to_csv(&self) -> String {
        let file = csv_name(&self.whole.source.path);
        let mut text = String::new();
        let mut line =
            |row: &str, name: &str, frame: &str, shape: &str, body: Option<&MassProperties<Body>>| {
                let numbers = body.map_or_else(|| vec![String::new(); NUMBERS.len()], exact);
                let words = [file.clone(), row.to_owned(), csv_name(name), csv_name(frame), csv_name(shape)];
                let _ = writeln!(text, "{},{}", words.join(","), numbers.join(","));
            };
        for row in &self.rows {
            line("link", &row.link, &row.link, &row.shape(), row.properties.as_ref());
        }
        let frame = self.whole.source.fields.get("link").and_then(Value::as_str).unwrap_or("model");
        line(
            "whole",
            self.name.strip_prefix("of ").unwrap_or_default(),
            frame,
            "",
            Some(&self.whole.properties),
        );
        text
    }
}

impl LinkRow {
    /// Returns the kinds of shapes, or `massless`.
    fn shape(&self) -> String {
        match &self.properties {
            None => "massless".to_owned(),
            Some(_) => self.shapes.join(" "),
        }
    }

    fn to_json(&self, source: &SourceInfo) -> Value {
        let mut object = Map::new();
        object.insert("link".to_owned(), self.link.as_str().into());
        object.insert("shapes".to_owned(), self.shapes.clone().into());
        object.insert("massless".to_owned(), self.properties.is_none().into());
        if self.rounding > 0.0 {
            object.insert("rounding".to_owned(), self.rounding.into());
        }
        let report = self.properties.map(|body| InertiaReport::new(source.clone(), body).to_json());
        if let Some(Value::Object(report)) = report {
            let own = |key: &str| !matches!(key, "polhode" | "source" | "findings");
            object.extend(report.into_iter().filter(|(key, _)| own(key)));
        }
        Value::Object(object)
    }
}

fn row(model: &RobotModel, link: &Link) -> Result<LinkRow, LinkError> {
    let name = &link.name.text;
    let (properties, rounding) = match link_mass(model.format, link) {
        Ok(LinkMass::None) => (None, 0.0),
        Ok(LinkMass::Body(body)) => {
            (Some(body.properties.in_frame::<Body>(Rotation::identity())), body.rounding)
        }
        Err(error) => return Err(error.of_link(name)),
    };
    let mut shapes: Vec<String> = Vec::new();
    for geometry in &link.geometry {
        let kind = kind(&geometry.shape);
        if !shapes.iter().any(|known| known == kind) {
            shapes.push(kind.to_owned());
        }
    }
    Ok(LinkRow { link: name.clone(), shapes, properties, rounding })
}

fn kind(shape: &GeometryShape) -> &str {
    match shape {
        GeometryShape::Box(_) => "box",
        GeometryShape::Sphere(_) => "sphere",
        GeometryShape::Cylinder { .. } => "cylinder",
        GeometryShape::Capsule { .. } => "capsule",
        GeometryShape::Ellipsoid(_) => "ellipsoid",
        GeometryShape::Cone { .. } => "cone",
        GeometryShape::Mesh { .. } | GeometryShape::Inline { .. } => "mesh",
        GeometryShape::Other(name) => name,
    }
}

/// Returns the tensor elements xx xy xz yy yz zz, kg·m².
fn elements(body: &MassProperties<Body>) -> [f64; 6] {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    [xx, xy, xz, yy, yz, zz]
}

fn cells(name: &str, body: Option<&MassProperties<Body>>, shape: &str) -> Vec<String> {
    let mut cells = vec![printable(name)];
    match body {
        None => cells.extend(vec!["—".to_owned(); NUMBERS.len()]),
        Some(body) => {
            let moments = body.principal().moments();
            let trace: f64 = moments.iter().sum();
            let size = (trace / body.mass()).sqrt();
            cells.push(number(body.mass(), DIGITS));
            cells.extend(shown(body.center_of_mass().to_array().map(|c| 1e3 * c), 1e3 * size));
            cells.extend(shown(moments, trace));
            cells.extend(shown(elements(body), trace));
        }
    }
    cells.push(printable(shape));
    cells
}

/// Formats numbers for the text table. Values at rounding level relative to the largest, or to
/// `scale`, become zero.
fn shown<const N: usize>(values: [f64; N], scale: f64) -> [String; N] {
    let largest = values.iter().fold(scale, |largest, value| largest.max(value.abs()));
    values.map(|value| number(if value.abs() < 1e-14 * largest { 0.0 } else { value }, DIGITS))
}

/// Formats numbers exactly, so that parsing returns the same values.
fn exact(body: &MassProperties<Body>) -> Vec<String> {
    let center = body.center_of_mass().to_array();
    let moments = body.principal().moments();
    let all = [body.mass()].into_iter().chain(center).chain(elements(body)).chain(moments);
    all.map(|number| decimal(number + 0.0)).collect() // −0 + 0 = 0
}
