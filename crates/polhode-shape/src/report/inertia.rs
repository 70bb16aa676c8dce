//! Report of `polhode inertia`: mass, centre of mass, inertia, principal axes.

use std::fmt::Write as _;

use polhode::body::{BodyError, Finding, MassProperties, PrincipalFrame, Symmetry};
use polhode::math::{Body, Frame, Part, Position, Rotation};
use polhode::motion::Scenario;
use polhode_document::Extra;
use polhode_document::SourceInfo;
use polhode_document::VERSION;
use polhode_document::finding;
use polhode_document::json::{matrix, numbers, vector};
use polhode_document::layout::{WIDTH, columns, labelled, matrix_rows, plain_spaces, wrap};
use polhode_document::number::{DIGITS, alike, number, tidy, tidy_beside, tidy_matrix};
use polhode_document::unit;
use serde_json::{Map, Value, json};

use crate::report::block;
use crate::report::block::Geometry;
use crate::report::{PartRow, parts};

/// Report of a body's mass properties.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::Position;
/// use polhode_document::SourceInfo;
/// use polhode_shape::report::InertiaReport;
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia)?;
/// let report = InertiaReport::new(SourceInfo::new("body.toml", "scenario"), body);
/// assert_eq!(report.to_json()["inertia"]["tensor"][0][1], 0.4);
/// assert!(report.to_text().contains("inertia about the centre of mass, along body axes"));
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct InertiaReport {
    /// Source of the body.
    pub source: SourceInfo,
    /// Mass, centre of mass and inertia tensor.
    pub properties: MassProperties<Body>,
    /// Enclosed volume, m³.
    pub volume: Option<f64>,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Mass per volume, kg/m³.
    pub density: Option<f64>,
    /// Additional reference point for the tensor.
    pub about: Option<Position<Body>>,
    /// Additional axes for the tensor; the columns of the rotation are their directions in body
    /// axes.
    pub axes: Option<Rotation<Body, Part>>,
    /// Additional blocks for this kind of body: its parts, a molecule's rotational constants.
    pub extras: Vec<Extra>,
    /// Findings of the reader and of the computation.
    pub findings: Vec<Finding>,
}

impl InertiaReport {
    /// Sets the volume, m³, and the mean density unless it overflows or underflows.
    #[must_use]
    pub fn with_volume(self, volume: Option<f64>) -> Self {
        let density =
            volume.map(|volume| self.properties.mass() / volume).filter(|density| density.is_normal());
        Self { volume, density, ..self }
    }

    /// Returns the interpretation of a mesh if it is not a solid: `convex_hull`, `sheet`.
    pub fn taken_as(&self) -> Option<&str> {
        self.source.fields.get("taken_as")?.as_str().filter(|&taken_as| taken_as != "solid")
    }

    /// Creates a report with only source and mass properties.
    pub fn new(source: SourceInfo, properties: MassProperties<Body>) -> Self {
        Self {
            source,
            properties,
            volume: None,
            surface_area: None,
            density: None,
            about: None,
            axes: None,
            extras: Vec::new(),
            findings: Vec::new(),
        }
    }

    /// Creates the report of parts that form one body, with their total mass and volume. Several
    /// parts are listed in a table.
    ///
    /// # Errors
    /// [`BodyError`] without parts, or if their sum is not a physical body.
    pub fn of_parts(source: SourceInfo, rows: &[PartRow]) -> Result<Self, BodyError> {
        let bodies: Vec<_> = rows.iter().map(|row| row.properties).collect();
        let properties = match bodies.as_slice() {
            [only] => *only,
            _ => MassProperties::combined(&bodies)?,
        };
        let volume: Option<f64> = rows.iter().map(|row| row.volume).sum();
        let extras = if rows.len() > 1 { vec![parts(rows)] } else { Vec::new() };
        Ok(Self { extras, ..Self::new(source, properties).with_volume(volume) })
    }

    /// Creates the report of a scenario's body at the start. If it has a pivot, the tensor about
    /// the pivot is included.
    pub fn of_scenario(source: SourceInfo, scenario: &Scenario) -> Self {
        let geometry = Geometry::of_parts(scenario.parts(), scenario.body().mass());
        Self {
            volume: geometry.volume,
            surface_area: geometry.surface_area,
            density: geometry.density,
            about: scenario.pivot(),
            findings: scenario.findings().iter().cloned().chain(scenario.taken_at_start()).collect(),
            ..Self::new(source, *scenario.body())
        }
    }

    /// Returns one object with the stable keys of the JSON contract. `inertia_about` and
    /// `inertia_in_axes` are present only if requested.
    pub fn to_json(&self) -> Value {
        let mut object = Map::new();
        object.insert("polhode".to_owned(), VERSION.into());
        object.insert("source".to_owned(), self.source.to_json());
        block::insert(&mut object, &self.properties, self.geometry());
        if let Some(point) = self.about {
            let tensor = self.properties.inertia_about(point);
            let about = json!({
                "point": vector(point),
                "tensor": matrix(tensor.matrix()),
                "principal": block::principal(&PrincipalFrame::about_pivot(&tensor)),
            });
            object.insert("inertia_about".to_owned(), about);
        }
        if let Some(axes) = self.axes {
            let along = json!({
                "about": "center_of_mass",
                "quaternion_wxyz": numbers(&axes.canonical_quaternion()),
                "tensor": matrix(self.properties.inertia().in_frame(axes.inverse()).matrix()),
            });
            object.insert("inertia_in_axes".to_owned(), along);
        }
        for Extra { key, json, .. } in &self.extras {
            object.insert((*key).to_owned(), json.clone());
        }
        object.insert("findings".to_owned(), finding::to_json(&self.findings));
        Value::Object(object)
    }

    /// Returns the report as text of about one screen.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}\n", self.source.heading());
        self.write_mass(&mut text);
        self.write_inertia(&mut text);
        self.write_about(&mut text);
        self.write_axes(&mut text);
        for extra in &self.extras {
            text.push('\n');
            text.push_str(&extra.text);
        }
        let findings = finding::to_text(&self.findings);
        if !findings.is_empty() {
            text.push('\n');
            text.push_str(&findings);
        }
        plain_spaces(&text)
    }

    fn geometry(&self) -> Geometry {
        Geometry { volume: self.volume, surface_area: self.surface_area, density: self.density }
    }

    fn write_mass(&self, text: &mut String) {
        let mass = unit::mass(self.properties.mass());
        let mass = match (self.density, self.volume) {
            (Some(density), Some(volume)) => {
                format!("{mass}   ({} kg/m³ × {})", number(density, DIGITS), unit::volume(volume))
                    .replace("   ", "\u{a0}\u{a0}\u{a0}")
            }
            (None, Some(volume)) => format!("{mass}   (volume {})", unit::volume(volume)),
            _ => mass,
        };
        text.push_str(&labelled("mass", &mass));
        if let Some(area) = self.surface_area {
            text.push_str(&labelled("surface area", &unit::area(area)));
        }
        let center = tidy(self.properties.center_of_mass().to_array());
        text.push_str(&line("centre of mass", &unit::lengths_in(self.size(), center)));
    }

    /// Returns the largest radius of gyration, m.
    fn size(&self) -> f64 {
        unit::size(&self.properties)
    }

    fn write_inertia(&self, text: &mut String) {
        let inertia = self.properties.inertia();
        text.push_str(&heading(
            "inertia about the centre of mass, along body axes, off-diagonal = -∫xy dm, in kg·m²",
        ));
        text.push_str(&tensor(inertia.matrix()));
        let principal = self.properties.principal();
        text.push_str(&moments(&principal));
        text.push_str(&line("gyration radii", &unit::lengths(self.properties.gyration_radii())));
        text.push_str(&axes(&principal));
    }

    fn write_about(&self, text: &mut String) {
        let Some(point) = self.about else { return };
        let about = self.properties.inertia_about(point);
        let place = unit::place_in(self.size(), tidy(point.to_array()));
        text.push_str(&heading(&format!(
            "inertia about {place}, along body axes, off-diagonal = -∫xy dm, in kg·m²"
        )));
        text.push_str(&tensor(about.matrix()));
        let principal = PrincipalFrame::about_pivot(&about);
        text.push_str(&moments(&principal));
        text.push_str(&axes(&principal));
    }

    fn write_axes(&self, text: &mut String) {
        let Some(turn) = self.axes else { return };
        let [_, x, y, z] = turn.canonical_quaternion();
        let axis = Position::<Body>::new(x, y, z)
            .direction()
            .map_or([0.0, 0.0, 1.0], polhode::math::Vector::to_array);
        let axis = alike(&tidy(axis), 6).join(",\u{a0}");
        text.push_str(&heading(&format!(
            "inertia about the centre of mass, along axes rotated from the body axes by {}° about ({axis}), in kg·m²",
            number(turn.angle().to_degrees(), 6),
        )));
        text.push_str(&tensor(self.properties.inertia().in_frame(turn.inverse()).matrix()));
    }
}

/// Returns a heading after a blank line.
fn heading(text: &str) -> String {
    format!("\n{}\n", wrap(text, "", WIDTH).join("\n"))
}

/// Returns a line with a label; double spaces in the text are kept.
fn line(label: &str, text: &str) -> String {
    labelled(label, &text.replace(' ', "\u{a0}"))
}

fn tensor(rows: [[f64; 3]; 3]) -> String {
    matrix_rows(&tidy_matrix(rows), 6).iter().map(|row| format!("    {}\n", row.trim_end())).collect()
}

/// Returns the principal moments, and the directions that their symmetry leaves undetermined.
fn moments<F: Frame>(principal: &PrincipalFrame<F>) -> String {
    let [_, _, i3] = principal.moments();
    let moments = alike(&tidy_beside(principal.moments(), i3 * 1e-16), DIGITS).join("  ");
    line("principal", &format!("{moments}  kg·m²   {}", principal.symmetry().name()))
        + &labelled("", principal.symmetry().freedom())
}

/// Returns the principal axes, one per line; nothing if every axis is principal.
fn axes<F: Frame>(principal: &PrincipalFrame<F>) -> String {
    if principal.symmetry() == Symmetry::Point {
        return String::new();
    }
    let cells = principal.axes().map(|axis| tidy(axis.to_array()));
    let cells = alike(cells.as_flattened(), DIGITS);
    let rows: Vec<Vec<String>> = cells.chunks(3).map(<[String]>::to_vec).collect();
    let mut text = String::from("principal axes   right-handed, unit vectors in body axes\n");
    for (k, row) in columns(&rows).iter().enumerate() {
        let _ = writeln!(text, "    axis {}   {row}", k + 1);
    }
    text
}
