//! `[[tank]]`: tanks and the amount of liquid in them.

use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

use super::contents::{Known, contents, quantity, relative};
use super::size::{DENSITIES, SIZES, in_range, not_negative};
use super::table_file::{ReadTable, Sheets, table_of};
use super::{Plan, names};
use crate::{Down, Liquid, LiquidErrors, ProductSign, TankShape, Vessel};

/// Tank as given in a file. Its row is not resolved yet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlannedTank {
    pub name: String,
    /// Name of the row in whose frame it is; `None` for the root.
    pub frame: Option<String>,
    /// Configurations in which it is. If empty, it is in all that have its frame.
    pub configurations: Vec<String>,
    pub liquid: Liquid,
    /// Mass of the liquid at the start, kg.
    pub mass: f64,
    pub errors: LiquidErrors,
    /// True if an error is after ±.
    pub has_mark: bool,
    /// Name of the group with which its errors are correlated.
    pub group: Option<String>,
    /// File or sheet from which its table was read, if that is not the plan.
    pub table: Option<ReadTable>,
    /// Error templates at its frame, its configurations and its contents.
    pub places: [FormatError; 3],
}

const KEYS: [&str; 19] = [
    "name",
    "frame",
    "configuration",
    "shape",
    "size",
    "radius",
    "semi_axes",
    "length",
    "ends",
    "density",
    "settles",
    "table",
    "products",
    "mass",
    "fill",
    "mass_sd",
    "fill_sd",
    "density_sd",
    "group",
];

/// Keys that only shapes have.
const OF_SHAPES: [&str; 7] = ["size", "radius", "semi_axes", "length", "ends", "density", "settles"];

/// Shapes, with the keys of their sizes.
const SHAPES: [(&str, &[&str]); 4] = [
    ("box", &["size"]),
    ("sphere", &["radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("cylinder", &["radius", "length", "ends"]),
];

/// Reads all tanks. `plan` has the other statements, and `sheets` are those of its workbook, if
/// any.
pub(crate) fn tanks(
    value: &Value<'_>,
    plan: &Plan,
    sheets: Option<&Sheets<'_>>,
) -> Result<Vec<PlannedTank>, FormatError> {
    let mut tanks: Vec<PlannedTank> = Vec::new();
    for (table, whole) in value.array_of_tables("tank")?.iter().map(|value| (value.table(), value)) {
        let table = table?;
        let tank = tank(&table, whole, plan, sheets)?;
        if tanks.iter().any(|other| other.name == tank.name) {
            return Err(table.require("name", "")?.invalid("unique among the tanks"));
        }
        tanks.push(tank);
    }
    Ok(tanks)
}

fn tank(
    table: &Table<'_>,
    whole: &Value<'_>,
    plan: &Plan,
    sheets: Option<&Sheets<'_>>,
) -> Result<PlannedTank, FormatError> {
    table.allow(&KEYS)?;
    let name = table.require("name", "name = \"fuel\"")?;
    let text = name.string()?.trim().to_owned();
    if text.is_empty() {
        return Err(name.invalid("a name"));
    }
    let frame = table.get("frame");
    let configuration = table.get("configuration");
    table.at_most_one(&["shape", "table"], "a tank has either a shape or a table of its contents")?;
    let coverage_factor = plan.coverage_factor.unwrap_or(1.0);
    let (liquid, density, read) = match (table.get("shape"), table.get("table")) {
        (_, Some(states)) => {
            if let Some(value) = OF_SHAPES.into_iter().find_map(|key| table.get(key)) {
                return Err(value.invalid("left out, because a table is given").with_hint("it needs shape"));
            }
            let sign = table.get("products").map(|value| value.named(&ProductSign::NAMED)).transpose()?;
            let (states, read) = table_of(&states, sign.or(plan.products), plan.decimal_comma, sheets)?;
            let density = table.get("density_sd").map(|value| relative(&value)).transpose()?;
            (Liquid::Table(states), density.unwrap_or(Known::EXACT), read)
        }
        (Some(shape), None) => {
            if let Some(value) = table.get("products") {
                return Err(value.invalid("left out without a table"));
            }
            let (vessel, density) = vessel(table, &shape, coverage_factor)?;
            (Liquid::Vessel(Box::new(vessel)), density, None)
        }
        (None, None) => {
            let example = "shape = \"sphere\", or [[tank.table]] with mass and center";
            return Err(table.missing("shape", example));
        }
    };
    let of_density = density.sd / density.value;
    let (mass, errors, known, given) = contents(table, liquid.capacity(), of_density, coverage_factor)?;
    let group = table.get("group").map(|value| group(&value, &errors, plan)).transpose()?;
    let here = |value: Option<Value<'_>>| value.as_ref().unwrap_or(whole).invalid("right");
    Ok(PlannedTank {
        name: text,
        frame: frame.as_ref().map(|value| value.string().map(|text| text.trim().to_owned())).transpose()?,
        configurations: configuration.as_ref().map_or(Ok(Vec::new()), configurations)?,
        liquid,
        mass,
        errors,
        has_mark: known.is_after_mark || density.is_after_mark,
        group,
        table: read,
        places: [here(frame.or(Some(name))), here(configuration.or(Some(name))), here(Some(given))],
    })
}

/// Reads a name, or an array of names.
fn configurations(value: &Value<'_>) -> Result<Vec<String>, FormatError> {
    if value.is_array() { names(value) } else { Ok(vec![value.string()?.trim().to_owned()]) }
}

/// Reads the group of a tank whose contents have errors.
fn group(value: &Value<'_>, errors: &LiquidErrors, plan: &Plan) -> Result<String, FormatError> {
    let name = value.string()?.trim();
    let names = || plan.groups.iter().map(|group| group.name.as_str());
    if !names().any(|other| other == name) {
        return Err(value.invalid("the name of a [[group]]").suggesting(name, names()));
    }
    if errors.amount == 0.0 && errors.density == 0.0 {
        return Err(value.invalid("left out: the tank has no errors"));
    }
    Ok(name.to_owned())
}

fn vessel(
    table: &Table<'_>,
    shape: &Value<'_>,
    coverage_factor: f64,
) -> Result<(Vessel, Known), FormatError> {
    let (name, sizes) = shape.named(&SHAPES.map(|shape| (shape.0, shape)))?;
    for key in OF_SHAPES.into_iter().filter(|key| !["density", "settles"].contains(key)) {
        if let Some(value) = table.get(key).filter(|_| !sizes.contains(&key)) {
            let hint = format!("its sizes are {}", sizes.join(", "));
            return Err(value.invalid(format!("left out: the tank is a {name}")).with_hint(hint));
        }
    }
    let positive = |key, example| {
        let value = table.require(key, example)?;
        in_range(&value, value.positive(Dimension::LENGTH)?, SIZES)
    };
    let three = |key, example| {
        let value = table.require(key, example)?;
        let sizes = value.positives::<3>(Dimension::LENGTH)?;
        sizes.iter().try_for_each(|size| in_range(&value, *size, SIZES).map(|_| ()))?;
        Ok::<_, FormatError>(sizes)
    };
    let shape = match name {
        "box" => TankShape::Box(three("size", "size = [\"200 mm\", \"300 mm\", \"400 mm\"]")?),
        "sphere" => TankShape::Ellipsoid([positive("radius", "radius = \"200 mm\"")?; 3]),
        "ellipsoid" => {
            TankShape::Ellipsoid(three("semi_axes", "semi_axes = [\"200 mm\", \"200 mm\", \"150 mm\"]")?)
        }
        _ => {
            let radius = positive("radius", "radius = \"150 mm\"")?;
            let length = not_negative(&table.require("length", "length = \"300 mm\"")?)?;
            let ends = match table.get("ends") {
                None => [0.0; 2],
                Some(value) => {
                    let [low, high] = value.fixed::<2>("heights, at -z and at z")?;
                    [not_negative(&low)?, not_negative(&high)?]
                }
            };
            TankShape::Cylinder { radius, length, ends }
        }
    };
    let density = table.require("density", "density = \"1.01 g/cm^3\"")?;
    let known = quantity(&density, table.get("density_sd").as_ref(), Dimension::DENSITY, coverage_factor)?;
    in_range(&density, known.value, DENSITIES)?;
    let down = table.require("settles", "settles = \"-z\"")?.named(&Down::NAMED)?;
    let vessel = Vessel::new(shape, known.value, down);
    Ok((vessel.map_err(|error| table.error(FormatErrorKind::subject(&error, error.hint())))?, known))
}
