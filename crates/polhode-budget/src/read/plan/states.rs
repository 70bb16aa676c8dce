//! Table of a liquid: mass, centre and tensor for several amounts. It is in `[[tank.table]]`, in a
//! separate CSV, or in a sheet of the workbook.

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_source::nearest;
use polhode_source::text::cut;
use polhode_source::toml::reader::Value;
use polhode_source::unit::{Dimension, unit_of};
use polhode_source::{ContentError, FormatError, FormatErrorKind};

use super::size::not_negative;
use crate::read::cell::{Cell, Content};
use crate::read::heading::{no_unit, plain, split};
use crate::read::number::Unit;
use crate::read::sheet::Sheet;
use crate::{LiquidTable, ProductSign};

/// Row of the table, SI.
#[derive(Default)]
struct State {
    mass: f64,
    level: Option<f64>,
    center: [f64; 3],
    moments: [f64; 3],
    products: [f64; 3],
}

/// Rows that were read so far.
#[derive(Default)]
struct States {
    rows: Vec<MassProperties<Part>>,
    levels: Vec<f64>,
}

/// Error of a row of the table.
enum Wrong {
    /// Name of the invalid number, the rule, and a hint.
    Rule(&'static str, &'static str, Option<&'static str>),
    Body(BodyError),
}

const RISES: &str = "greater than in the row before";
const SIGN: &str = "set products = \"tensor elements\" or \"positive integrals\" in the tank or in the file";

impl States {
    fn add(&mut self, state: &State, sign: Option<ProductSign>) -> Result<(), Wrong> {
        if self.rows.last().is_some_and(|row| row.mass() >= state.mass) {
            return Err(Wrong::Rule("mass", RISES, None));
        }
        if let Some(level) = state.level {
            if self.levels.last().is_some_and(|last| *last >= level) {
                return Err(Wrong::Rule("level", RISES, None));
            }
            self.levels.push(level);
        }
        let products = match sign {
            Some(ProductSign::PositiveIntegral) => state.products.map(|product| -product),
            None if state.products != [0.0; 3] => {
                return Err(Wrong::Rule("products", "given with their sign convention", Some(SIGN)));
            }
            _ => state.products,
        };
        let inertia = InertiaTensor::with_negative_products(state.moments, products);
        let center = Position::from_array(state.center);
        let row = inertia.and_then(|inertia| MassProperties::new(state.mass, center, inertia));
        self.rows.push(row.map_err(Wrong::Body)?);
        Ok(())
    }

    fn table(self, at: impl FnOnce(FormatErrorKind) -> FormatError) -> Result<LiquidTable, FormatError> {
        let levels = Some(self.levels).filter(|levels| !levels.is_empty());
        LiquidTable::new(self.rows, levels)
            .map_err(|error| at(FormatErrorKind::subject(&error, error.hint())))
    }
}

/// Reads `[[tank.table]]`: `mass`, `level`, `center`, `moments` and `products` about the centre.
pub(crate) fn of_tables(value: &Value<'_>, sign: Option<ProductSign>) -> Result<LiquidTable, FormatError> {
    let mut states = States::default();
    let mut with_levels = None;
    for table in value.tables("tank.table")? {
        table.allow(&["mass", "level", "center", "moments", "products"])?;
        let given = table.require("mass", "mass = \"12 kg\"")?;
        let level = table.get("level");
        if *with_levels.get_or_insert(level.is_some()) != level.is_some() {
            return Err(table.missing("level", "level = \"120 mm\", in all rows or in none"));
        }
        let center = table.require("center", "center = [0, 0, \"120 mm\"]")?;
        let products = table.get("products");
        let moments = match table.get("moments") {
            Some(value) => value.quantities(Dimension::INERTIA)?,
            None if products.is_none() => [0.0; 3],
            None => return Err(table.missing("moments", "moments = [0.2, 0.2, 0.1]")),
        };
        let state = State {
            mass: given.positive(Dimension::MASS)?,
            level: level.as_ref().map(not_negative).transpose()?,
            center: center.quantities(Dimension::LENGTH)?,
            moments,
            products: products.as_ref().map_or(Ok([0.0; 3]), |value| value.quantities(Dimension::INERTIA))?,
        };
        states.add(&state, sign).map_err(|wrong| match wrong {
            Wrong::Body(error) => given.body(error),
            Wrong::Rule(name, rule, hint) => {
                table.get(name).as_ref().unwrap_or(&given).invalid(rule).with_hint_of(hint)
            }
        })?;
    }
    states.table(|kind| value.error(kind))
}

const NAMES: [&str; 11] = ["mass", "level", "x", "y", "z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
const MASS: usize = 0;
const LEVEL: usize = 1;
const CENTER: usize = 2;
const MOMENTS: usize = 5;
const PRODUCTS: usize = 8;

fn dimension(key: usize) -> Dimension {
    match key {
        MASS => Dimension::MASS,
        LEVEL..MOMENTS => Dimension::LENGTH,
        _ => Dimension::INERTIA,
    }
}

/// Returns true if a heading identifies a table of a liquid.
pub(crate) fn is_of_mass(heading: &str) -> bool {
    plain(split(heading).0) == NAMES[MASS]
}

/// Column of the table: its key, and its unit if the heading has one.
struct Column {
    key: usize,
    place: usize,
    unit: Option<Unit>,
    /// True if its numbers have units in their cells.
    united: Option<bool>,
}

/// Reads a table whose first row has headings with units: `mass`, at least one of `x`, `y`, `z`,
/// and optionally `level` and `ixx` to `iyz`. The tensor is about the centre of mass.
pub(crate) fn of_sheet(sheet: &Sheet<'_>, sign: Option<ProductSign>) -> Result<LiquidTable, FormatError> {
    let mut rows = sheet.rows.iter();
    let headings = rows.next().map(|row| sheet.row(row)).unwrap_or_default();
    let mut columns = columns(sheet, &headings)?;
    let mut states = States::default();
    for (k, row) in rows.enumerate() {
        let cells = sheet.row(row);
        if let Some(cell) = cells.iter().find(|cell| !columns.iter().any(|one| one.place == cell.column)) {
            return Err(sheet.invalid(cell, "a cell outside the columns", "under a heading"));
        }
        let mut numbers = [0.0; NAMES.len()];
        for column in &mut columns {
            let cell = cells.iter().find(|cell| cell.column == column.place);
            let cell = cell.ok_or_else(|| empty(sheet, k + 1, NAMES[column.key]))?;
            let number = column.number(sheet, cell)?;
            if column.key == MASS && !(number > 0.0) {
                return Err(sheet.invalid(cell, NAMES[MASS], "positive"));
            }
            if column.key == LEVEL && !(number >= 0.0) {
                return Err(sheet.invalid(cell, NAMES[LEVEL], "zero or positive"));
            }
            numbers[column.key] = number;
        }
        let [mass, level, x, y, z, xx, yy, zz, xy, xz, yz] = numbers;
        let has_level = columns.iter().any(|column| column.key == LEVEL);
        let (center, moments, products) = ([x, y, z], [xx, yy, zz], [xy, xz, yz]);
        let state = State { mass, level: has_level.then_some(level), center, moments, products };
        let at = |keys: core::ops::Range<usize>| {
            let column = columns.iter().find(|column| keys.contains(&column.key))?;
            cells.iter().find(|cell| cell.column == column.place)
        };
        states.add(&state, sign).map_err(|wrong| match wrong {
            Wrong::Body(error) => sheet.row_error(Some(k + 1), FormatErrorKind::Body(error)),
            Wrong::Rule(name, rule, hint) => {
                let first = NAMES.iter().position(|known| *known == name);
                let cell = at(first.map_or(PRODUCTS..NAMES.len(), |first| first..first + 1));
                let error = cell.map(|cell| sheet.invalid(cell, name, rule));
                error.unwrap_or_else(|| empty(sheet, k + 1, name)).with_hint_of(hint)
            }
        })?;
    }
    states.table(|kind| FormatError::new(sheet.path(), None, kind))
}

fn empty(sheet: &Sheet<'_>, row: usize, name: &str) -> FormatError {
    let error = ContentError::missing(format!("{name} in this row"));
    sheet.row_error(Some(row), error.into()).with_hint("write 0 if it is zero")
}

fn columns(sheet: &Sheet<'_>, headings: &[Cell<'_>]) -> Result<Vec<Column>, FormatError> {
    let mut all: Vec<Column> = Vec::new();
    for cell in headings {
        if let Content::Broken(broken) = cell.content {
            return Err(sheet.invalid(cell, "the heading", broken.rule()));
        }
        let (name, unit) = split(&cell.text);
        let name = plain(name);
        let Some(key) = NAMES.iter().position(|known| *known == name) else {
            let (suggestion, known) = (nearest(&name, NAMES), NAMES.to_vec());
            let (key, table) = (cut(&cell.text).to_owned(), "the table of a tank".to_owned());
            return Err(sheet.error(cell, FormatErrorKind::UnknownKey { key, table, suggestion, known }));
        };
        if all.iter().any(|other| other.key == key) {
            return Err(sheet.invalid(cell, "the heading", "different from the headings before"));
        }
        let unit = unit.map(|unit| Unit::new(unit, dimension(key))).transpose();
        let unit = unit.map_err(|error| no_unit(error, |kind| sheet.error(cell, kind)))?;
        all.push(Column { key, place: cell.column, unit, united: None });
    }
    let has = |keys: core::ops::Range<usize>| all.iter().filter(|column| keys.contains(&column.key)).count();
    let missing = |what: &str| {
        Err(sheet
            .row_error((!sheet.rows.is_empty()).then_some(0), ContentError::missing(what).into())
            .with_hint("the headings are mass [kg],level [mm],x [mm],y [mm],z [mm],ixx [kg m^2] and so on"))
    };
    if has(MASS..LEVEL) == 0 {
        return missing("column with the heading mass, in the first row");
    }
    if has(CENTER..MOMENTS) == 0 {
        return missing("column x, y or z");
    }
    match has(MOMENTS..PRODUCTS) {
        0 if has(PRODUCTS..NAMES.len()) == 0 => Ok(all),
        3 => Ok(all),
        _ => missing("column of three, ixx, iyy and izz"),
    }
}

impl Column {
    fn number(&mut self, sheet: &Sheet<'_>, cell: &Cell<'_>) -> Result<f64, FormatError> {
        let name = NAMES[self.key];
        if let Content::Broken(broken) = cell.content {
            return Err(sheet.invalid(cell, name, broken.rule()));
        }
        let is_text = cell.content == Content::Text;
        let has_comma = is_text && cell.text.contains(',');
        if is_text && sheet.decimal_comma && cell.text.contains('.') {
            return Err(sheet.invalid(cell, name, "a number with a decimal comma"));
        }
        let text = if has_comma && sheet.decimal_comma {
            cell.text.replace(',', ".")
        } else {
            cell.text.to_string()
        };
        let read = self.unit.as_ref().unwrap_or(&Unit::SI).read(&text, dimension(self.key));
        let read = read.map_err(|error| {
            let hint = "decimal = \"comma\" in the list says that numbers have a decimal comma";
            let is_undeclared = has_comma && !sheet.decimal_comma;
            sheet.error(cell, FormatErrorKind::Unit(error)).with_hint_of(is_undeclared.then_some(hint))
        })?;
        // Zero is zero in every unit.
        let is_united = !unit_of(&text).is_empty();
        if self.unit.is_none() && read.value != 0.0 && *self.united.get_or_insert(is_united) != is_united {
            let error = sheet.invalid(cell, name, "with a unit or without, like the numbers above");
            return Err(error.with_hint("write the unit in the heading, for all rows"));
        }
        Ok(read.value)
    }
}
