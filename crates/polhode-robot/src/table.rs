//! Table of a model's links, one row each: mass, centre, moments, equivalent box, density, verdict.

use polhode_document::Section;
use polhode_document::layout::{columns, plain_spaces, printable};
use polhode_document::number::number;
use polhode_source::text::counted;

use crate::check::LinkGeometry;
use crate::model::{Inertial, Link, Slot, Tensor};
use crate::moments::Moments;
use crate::report::{CheckReport, format_name};

/// Significant digits; enough to show a wrong power of ten or a difference between left and right.
const DIGITS: usize = 4;

/// Column titles, with units.
const HEADS: [&str; 13] = [
    "link",
    "mass/kg",
    "x/mm",
    "y/mm",
    "z/mm",
    "i1/kg·m²",
    "i2/kg·m²",
    "i3/kg·m²",
    "a/mm",
    "b/mm",
    "c/mm",
    "kg/m³",
    "verdict",
];

/// Explanation of the columns.
pub(crate) const COLUMNS: [&str; 3] = [
    "x y z: centre of mass in the link's frame   i1 ≤ i2 ≤ i3: principal moments about it",
    "a ≥ b ≥ c: edges of the uniform box with the same mass and moments",
    "kg/m³: mass divided by the volume of the link's geometry",
];

impl CheckReport {
    /// Returns one line for each link, with an explanation of the columns. Missing and unphysical
    /// values are shown as a dash.
    pub fn to_table(&self) -> String {
        let heading = format!(
            "{}   {}, {}\n{}\n\n",
            printable(&self.model.path.to_string_lossy()),
            format_name(self.model.format),
            counted(self.model.links.len(), "link"),
            COLUMNS.join("\n"),
        );
        let mut rows = vec![HEADS.map(str::to_owned).to_vec()];
        rows.extend(self.rows());
        let lines: String = columns(&rows).iter().map(|line| format!("{line}\n")).collect();
        plain_spaces(&(heading + &lines))
    }

    /// Returns the table as a section of a page.
    pub(crate) fn links(&self) -> Section {
        let mut section = Section::new(0, "Links");
        section.table(&HEADS, self.rows().collect());
        section
    }

    fn rows(&self) -> impl Iterator<Item = Vec<String>> {
        let verdicts = self.verdicts();
        let nothing = LinkGeometry::default();
        self.model.links.iter().enumerate().map(move |(k, link)| {
            let verdict = match verdicts.get(link.name.text.as_str()) {
                Some(&severity) => severity.name(),
                _ if link.inertial.is_none() => "no mass",
                _ => "ok",
            };
            row(link, self.geometry.get(k).unwrap_or(&nothing), verdict)
        })
    }
}

fn row(link: &Link, geometry: &LinkGeometry, verdict: &str) -> Vec<String> {
    let cell = |x: Option<f64>| x.map_or_else(|| "—".to_owned(), |x| number(x, DIGITS));
    let mass = link.inertial.as_ref().and_then(|inertial| inertial.mass.finite());
    let center = link.inertial.as_ref().filter(|inertial| inertial.pose.unreadable.is_empty());
    let center = center.map(|inertial| inertial.pose.position);
    let moments = link.inertial.as_ref().and_then(moments);
    let edges = mass.filter(|&mass| mass > 0.0).and_then(|mass| moments.and_then(|m| m.equivalent_box(mass)));
    let volume = volume(geometry);
    let density = mass.and_then(|mass| volume.map(|volume| mass / volume));
    let triple = |values: Option<[f64; 3]>, factor: f64| {
        std::array::from_fn::<_, 3, _>(|k| cell(values.and_then(|v| v.get(k).map(|x| x * factor))))
    };
    let mut row = vec![printable(&link.name.text), cell(mass)];
    row.extend(triple(center, 1e3));
    row.extend(triple(moments.map(|m| m.values), 1.0));
    row.extend(triple(edges, 1e3));
    row.extend([cell(density), verdict.to_owned()]);
    row
}

/// Returns the principal moments, also of unphysical tensors; `None` if an element is missing or
/// unreadable.
fn moments(inertial: &Inertial) -> Option<Moments> {
    let elements = match &inertial.tensor {
        Tensor::Missing(_) => return None,
        Tensor::Six(slots) => slots.each_ref().map(Slot::finite),
        Tensor::Diagonal(slots) => {
            let [a, b, c] = slots.each_ref().map(Slot::finite);
            [a, b, c, Some(0.0), Some(0.0), Some(0.0)]
        }
    };
    let [Some(xx), Some(yy), Some(zz), Some(xy), Some(xz), Some(yz)] = elements else { return None };
    Some(Moments::of(&[xx, yy, zz, xy, xz, yz]))
}

/// Returns the volume of the link's shapes of the most reliable kind, m³.
fn volume(geometry: &LinkGeometry) -> Option<f64> {
    geometry.volumes.iter().min_by_key(|volume| volume.kind).map(|volume| volume.volume)
}
