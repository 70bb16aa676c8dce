//! `[[tank]]`: what liquids are in, and how much of them.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_budget::{Down, Liquid, LiquidTable, ProductSign, SequenceError, TankShape, Vessel};

use super::{PRODUCTS, fraction, names, sign_of};
use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::reader::{Table, Value};
use crate::unit::Dimension;

/// A tank as a file gives it: which row it stands in is not known yet.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::budget) struct PlannedTank {
    pub(in crate::budget) name: String,
    /// The row in whose frame it is; that of all without.
    pub(in crate::budget) frame: Option<String>,
    /// Where it is; all that have its frame if empty.
    pub(in crate::budget) configurations: Vec<String>,
    pub(in crate::budget) liquid: Liquid,
    /// At first, kg.
    pub(in crate::budget) mass: f64,
    /// An error at its frame, its configurations and its contents each.
    pub(in crate::budget) places: [FormatError; 3],
}

const KEYS: [&str; 15] = [
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
];

/// The keys that only shapes have.
const OF_SHAPES: [&str; 7] = ["size", "radius", "semi_axes", "length", "ends", "density", "settles"];

const SHAPES: [(&str, &[&str]); 4] = [
    ("box", &["size"]),
    ("sphere", &["radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("cylinder", &["radius", "length", "ends"]),
];

const DOWN: [(&str, Down); 6] = [
    ("-x", Down::MinusX),
    ("-y", Down::MinusY),
    ("-z", Down::MinusZ),
    ("x", Down::PlusX),
    ("y", Down::PlusY),
    ("z", Down::PlusZ),
];

/// Reads all tanks; `products` says what products are where a tank does not.
pub(super) fn tanks(
    value: &Value<'_>,
    products: Option<ProductSign>,
) -> Result<Vec<PlannedTank>, FormatError> {
    let mut tanks: Vec<PlannedTank> = Vec::new();
    for (table, whole) in value.array_of_tables("tank")?.iter().map(|value| (value.table(), value)) {
        let table = table?;
        let tank = tank(&table, whole, products)?;
        if tanks.iter().any(|other| other.name == tank.name) {
            return Err(table.require("name", "")?.invalid("the name of no other tank"));
        }
        tanks.push(tank);
    }
    Ok(tanks)
}

fn tank(
    table: &Table<'_>,
    whole: &Value<'_>,
    products: Option<ProductSign>,
) -> Result<PlannedTank, FormatError> {
    table.allow(&KEYS)?;
    let name = table.require("name", "name = \"fuel\"")?;
    let text = name.string()?.trim().to_owned();
    if text.is_empty() {
        return Err(name.invalid("a name"));
    }
    let frame = table.get("frame");
    let configuration = table.get("configuration");
    table.at_most_one(&["shape", "table"], "a tank is given by its shape, or by a table of what is in it")?;
    let liquid = match (table.get("shape"), table.get("table")) {
        (_, Some(states)) => {
            if let Some(value) = OF_SHAPES.into_iter().find_map(|key| table.get(key)) {
                return Err(value.invalid("left out beside a table").with_hint("it goes with shape"));
            }
            let sign = match table.get("products") {
                Some(value) => sign_of(value.choice(&PRODUCTS.map(|(name, _)| name))?),
                None => products,
            };
            Liquid::Table(states_of(&states, sign)?)
        }
        (Some(shape), None) => {
            if let Some(value) = table.get("products") {
                return Err(value.invalid("left out without a table"));
            }
            Liquid::Vessel(Box::new(vessel(table, &shape)?))
        }
        (None, None) => {
            return Err(table.missing("shape", "shape = \"sphere\", or [[tank.table]] with mass and center"));
        }
    };
    let capacity = liquid.capacity();
    let given =
        table.at_most_one(&["mass", "fill"], "mass is what is in the tank, fill the same as a part")?;
    let given = given.ok_or_else(|| table.missing("mass", "mass = \"12 kg\", or fill = \"80 %\""))?;
    let mass = if given.key() == "mass" {
        let mass = given.quantity(Dimension::MASS)?;
        // What is written with some digits fills a tank that is computed.
        if !(mass >= 0.0 && mass <= capacity * (1.0 + 1e-9)) {
            return Err(
                given.invalid(format!("not negative, and no more than the tank holds, {capacity} kg"))
            );
        }
        mass.min(capacity)
    } else {
        let part = fraction(&given)?;
        if !(0.0..=1.0).contains(&part) {
            return Err(given.invalid("from 0 to 100 %"));
        }
        part * capacity
    };
    let here = |value: Option<Value<'_>>| value.as_ref().unwrap_or(whole).invalid("right");
    Ok(PlannedTank {
        name: text,
        frame: frame.as_ref().map(|value| value.string().map(|text| text.trim().to_owned())).transpose()?,
        configurations: configuration.as_ref().map_or(Ok(Vec::new()), configurations)?,
        liquid,
        mass,
        places: [here(frame.or(Some(name))), here(configuration.or(Some(name))), here(Some(given))],
    })
}

/// A name, or several.
fn configurations(value: &Value<'_>) -> Result<Vec<String>, FormatError> {
    if value.is_array() { names(value) } else { Ok(vec![value.string()?.trim().to_owned()]) }
}

fn vessel(table: &Table<'_>, shape: &Value<'_>) -> Result<Vessel, FormatError> {
    let name = shape.choice(&SHAPES.map(|(name, _)| name))?;
    let sizes = SHAPES.iter().find(|(known, _)| *known == name).map_or(&[][..], |(_, sizes)| sizes);
    for key in OF_SHAPES.into_iter().filter(|key| !["density", "settles"].contains(key)) {
        if let Some(value) = table.get(key).filter(|_| !sizes.contains(&key)) {
            let hint = format!("its sizes are {}", sizes.join(", "));
            return Err(value.invalid(format!("left out of a tank that is a {name}")).with_hint(hint));
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
    let density = in_range(&density, density.positive(Dimension::DENSITY)?, DENSITIES)?;
    let settles = table.require("settles", "settles = \"-z\"")?.choice(&DOWN.map(|(name, _)| name))?;
    let down = DOWN.iter().find(|(name, _)| *name == settles).map_or(Down::MinusZ, |(_, down)| *down);
    Vessel::new(shape, density, down).map_err(|error| table.error(FormatErrorKind::Sequence(error)))
}

fn not_negative(value: &Value<'_>) -> Result<f64, FormatError> {
    let length = value.quantity(Dimension::LENGTH)?;
    match length {
        0.0 => Ok(length),
        length if length > 0.0 => in_range(value, length, SIZES),
        _ => Err(value.invalid("zero or positive")),
    }
}

/// Of tanks, m, and of liquids, kg/m³: beyond them levels are rounding.
const SIZES: [f64; 2] = [1e-6, 1e6];
const DENSITIES: [f64; 2] = [1e-6, 1e6];

fn in_range(value: &Value<'_>, number: f64, [least, most]: [f64; 2]) -> Result<f64, FormatError> {
    if number >= least && number <= most {
        return Ok(number);
    }
    Err(value.invalid(format!("from {least:e} to {most:e}, in SI")))
}

/// `[[tank.table]]`: `mass`, `level`, `center`, `moments` and `products` about the centre.
fn states_of(value: &Value<'_>, sign: Option<ProductSign>) -> Result<LiquidTable, FormatError> {
    let mut rows: Vec<MassProperties<Part>> = Vec::new();
    let mut levels: Vec<f64> = Vec::new();
    let mut with_levels = None;
    for table in value.tables("tank.table")? {
        table.allow(&["mass", "level", "center", "moments", "products"])?;
        let given = table.require("mass", "mass = \"12 kg\"")?;
        let mass = given.positive(Dimension::MASS)?;
        if rows.last().is_some_and(|row| row.mass() >= mass) {
            return Err(given.invalid("more than that of the row before"));
        }
        let level = table.get("level");
        if *with_levels.get_or_insert(level.is_some()) != level.is_some() {
            return Err(table.missing("level", "level = \"120 mm\", in all rows or in none"));
        }
        if let Some(level) = level {
            let height = not_negative(&level)?;
            if levels.last().is_some_and(|last| *last >= height) {
                return Err(level.invalid("more than that of the row before"));
            }
            levels.push(height);
        }
        let center = table.require("center", "center = [0, 0, \"120 mm\"]")?.quantities(Dimension::LENGTH)?;
        let moments = match table.get("moments") {
            Some(value) => value.quantities(Dimension::INERTIA)?,
            None if table.get("products").is_none() => [0.0; 3],
            None => return Err(table.missing("moments", "moments = [0.2, 0.2, 0.1]")),
        };
        let mut products = [0.0; 3];
        if let Some(value) = table.get("products") {
            products = value.quantities(Dimension::INERTIA)?;
            if sign.is_none() && products != [0.0; 3] {
                let hint =
                    "say products = \"tensor elements\" or \"positive integrals\" in the tank or in the file";
                return Err(value.invalid("beside what their sign is").with_hint(hint));
            }
        }
        if sign == Some(ProductSign::PositiveIntegral) {
            products = products.map(|product| -product);
        }
        let inertia = InertiaTensor::with_negative_products(moments, products);
        let row =
            inertia.and_then(|inertia| MassProperties::new(mass, Position::from_array(center), inertia));
        rows.push(row.map_err(|error| given.body(error))?);
    }
    let levels = Some(levels).filter(|levels| !levels.is_empty());
    LiquidTable::new(rows, levels)
        .map_err(|error: SequenceError| value.error(FormatErrorKind::Sequence(error)))
}
