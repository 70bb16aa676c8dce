//! Statements of a file outside its parts, as TOML. The keys are the same in a plan, in the head of
//! a CSV, and in additional sheets of a workbook.

mod cad;
mod contents;
mod group;
pub(crate) mod growth;
mod limit;
mod result;
pub(crate) mod sequence;
mod site;
mod size;
mod states;
pub(crate) mod table_file;
pub(crate) mod tank;

use polhode::math::Position;
use polhode_shape::cad::CadOptions;
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::Questions;
use crate::{Ballast, Group, GrowthTable, Limit, ProductSign, TensorPoint};
use sequence::PlannedSequence;
use table_file::{Sheets, TableOrigin};
use tank::PlannedTank;

/// Statements of a file outside its parts.
#[derive(Debug, Default)]
pub(crate) struct Plan {
    pub title: Option<String>,
    /// Sign convention of products of inertia, for rows without their own.
    pub products: Option<ProductSign>,
    /// Reference point of tensors, for rows without their own.
    pub about: Option<TensorPoint>,
    /// Number of standard deviations in an error after ±.
    pub coverage_factor: Option<f64>,
    /// True if numbers in text have a decimal comma.
    pub decimal_comma: Option<bool>,
    /// Columns and sheets for people, which are not read.
    pub ignore: Vec<String>,
    /// All configurations, in the wanted order.
    pub configurations: Option<Vec<String>>,
    pub groups: Vec<Group>,
    pub growth: GrowthTable,
    pub cad: CadOptions,
    pub questions: Questions,
    pub limits: Vec<Limit>,
    pub ballast: Option<Ballast>,
    pub tanks: Vec<PlannedTank>,
    pub sequence: Option<PlannedSequence>,
    pub places: Places,
}

/// Error templates at the places of declarations that may be unused.
#[derive(Debug, Default)]
pub(crate) struct Places {
    pub ignore: Vec<FormatError>,
    pub groups: Vec<FormatError>,
    pub cad: Option<FormatError>,
}

/// Keys of a plan.
pub(crate) const KEYS: [&str; 20] = [
    "title",
    "products",
    "about",
    "coverage_factor",
    "decimal",
    "ignore",
    "configurations",
    "growth",
    "group",
    "cad",
    "result",
    "limit",
    "site",
    "ballast",
    "tank",
    "sequence",
    "burn",
    "drop",
    "deploy",
    "exit",
];

/// Keys with a table as value, and keys with a list of tables. A workbook has a sheet for each.
pub(crate) const TABLES: [&str; 5] = ["growth", "cad", "result", "ballast", "sequence"];
pub(crate) const LISTS: [&str; 8] = ["group", "limit", "site", "tank", "burn", "drop", "deploy", "exit"];

/// Reads all keys of a plan. `others` are additional keys that are allowed. Tables may also be in
/// `sheets` of the workbook.
pub(crate) fn plan(
    root: &Table<'_>,
    others: &[&'static str],
    sheets: Option<&Sheets<'_>>,
) -> Result<Plan, FormatError> {
    root.allow(&[&KEYS[..], others].concat())?;
    let mut plan = Plan {
        title: root.get("title").map(|title| title.string().map(str::to_owned)).transpose()?,
        products: root.get("products").map(|value| value.named(&ProductSign::NAMED)).transpose()?,
        about: root.get("about").map(|value| about(&value)).transpose()?,
        ignore: root.get("ignore").map_or(Ok(Vec::new()), |value| names(&value))?,
        configurations: root.get("configurations").map(|value| names(&value)).transpose()?,
        ..Plan::default()
    };
    if let Some(value) = root.get("ignore") {
        let names = value.elements("an array of strings")?;
        plan.places.ignore = names.iter().map(|name| name.invalid("right")).collect();
    }
    if let Some(value) = root.get("coverage_factor") {
        let factor = value.number()?;
        if !(factor > 0.0) {
            return Err(value
                .invalid("positive")
                .with_hint("with 2, ± 0.4 g is a standard deviation of 0.2 g"));
        }
        plan.coverage_factor = Some(factor);
    }
    if let Some(value) = root.get("decimal") {
        plan.decimal_comma = Some(value.named(&[("point", false), ("comma", true)])?);
    }
    if let Some(value) = root.get("growth") {
        plan.growth = growth::table(&value)?;
    }
    if let Some(value) = root.get("group") {
        plan.groups = group::groups(&value)?;
        let name = |table: Table<'_>| Ok(table.require("name", "name = \"wheels\"")?.invalid("right"));
        plan.places.groups = value.tables("group")?.into_iter().map(name).collect::<Result<_, _>>()?;
    }
    if let Some(value) = root.get("cad") {
        plan.cad = cad::options(&value.table()?)?;
        plan.places.cad = Some(value.invalid("right"));
    }
    if let Some(value) = root.get("result") {
        plan.questions = result::questions(&value.table()?)?;
    }
    if let Some(value) = root.get("limit") {
        plan.limits = limit::limits(&value, plan.products)?;
    }
    if let Some(value) = root.get("tank") {
        plan.tanks = tank::tanks(&value, &plan, sheets)?;
    }
    plan.sequence = sequence::sequence(root, &plan.tanks)?;
    let asked = root.get("ballast");
    match (root.get("site"), &asked) {
        (Some(sites), _) => plan.ballast = Some(site::ballast(&sites, asked.as_ref())?),
        (None, Some(_)) => return Err(root.missing("site", "[[site]] with name and at, a place for ballast")),
        (None, None) => {}
    }
    if let Some(value) = root.get("site").filter(|_| plan.limits.is_empty()) {
        return Err(value.invalid("given with [[limit]], which the ballast must meet"));
    }
    Ok(plan)
}

impl Plan {
    /// Returns true if a sheet of the workbook is the table of a tank.
    pub(crate) fn has_sheet(&self, name: &str) -> bool {
        let tables = self.tanks.iter().filter_map(|tank| tank.table.as_ref());
        tables.into_iter().any(|table| table.from == TableOrigin::Sheet(name.to_owned()))
    }

    /// Moves the places of a plan whose text was made of other texts to these texts.
    pub(crate) fn moved(mut self, moved: impl Fn(FormatError) -> FormatError) -> Self {
        let Places { ignore, groups, cad } = &mut self.places;
        for place in ignore.iter_mut().chain(groups).chain(cad) {
            *place = moved(place.clone());
        }
        for tank in &mut self.tanks {
            tank.places = tank.places.clone().map(&moved);
        }
        if let Some(sequence) = &mut self.sequence {
            let burns = sequence.burns.iter_mut().flatten();
            for place in burns.chain(&mut sequence.changes).chain([&mut sequence.place]) {
                *place = moved(place.clone());
            }
        }
        self
    }
}

/// Reads `about`: `"center"`, `"origin"`, the name of a frame, or a point.
fn about(value: &Value<'_>) -> Result<TensorPoint, FormatError> {
    if value.is_array() {
        return Ok(TensorPoint::At(Position::from_array(value.quantities(Dimension::LENGTH)?)));
    }
    value.string().map(point_named)
}

/// Returns the reference point of a tensor from its name.
pub(crate) fn point_named(name: &str) -> TensorPoint {
    match name {
        "center" => TensorPoint::CenterOfMass,
        "origin" => TensorPoint::At(Position::ZERO),
        frame => TensorPoint::OriginOf(frame.to_owned()),
    }
}

/// Reads strings, each at most once.
fn names(value: &Value<'_>) -> Result<Vec<String>, FormatError> {
    let mut names: Vec<String> = Vec::new();
    for element in value.elements("an array of strings")? {
        let name = element.string()?.trim();
        if name.is_empty() || names.iter().any(|other| other == name) {
            return Err(element.invalid("listed only once"));
        }
        names.push(name.to_owned());
    }
    Ok(names)
}

/// Reads a fraction such as `0.15` or `"15 %"`.
fn fraction(value: &Value<'_>) -> Result<f64, FormatError> {
    let percent = value.string().ok().and_then(super::measured::percent);
    match percent {
        Some(Ok(fraction)) => Ok(fraction),
        Some(Err(_)) => Err(value.invalid("a number in percent").with_hint("write \"15 %\"")),
        None => value.quantity(Dimension::NONE),
    }
}
