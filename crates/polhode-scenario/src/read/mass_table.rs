//! Table of a `[mass_history]`: times with the mass properties of the whole body, as CSV.
//!
//! Column names include units: `time_s`, `mass_kg`, `center_x_m …`, `inertia_xx_kg_m2 …` about the
//! centre of mass. Optional columns have the rates, `mass_rate_kg_s`, `center_rate_x_m_s …`,
//! `inertia_rate_xx_kg_m2_s …`. The order is arbitrary. Other columns are ignored, unless their
//! names are similar to these, which is an error. Two rows with the same time are a jump.

use std::ops::Range;

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Position, Velocity};
use polhode::motion::{MassRates, MassRow};
use polhode_source::FormatError;
use polhode_source::csv;
use polhode_source::csv::{fields, missing};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

const NAMES: [&str; 11] = MassRow::COLUMNS;
const RATES: [&str; 10] = MassRow::RATE_COLUMNS;

/// Relative tolerance for the agreement of the body at the start with `[body]`.
const SAME: f64 = 1e-6;

/// Reads the file named by `table`; `products` states the sign convention of the products of
/// inertia, as for a tensor.
pub(crate) fn rows(value: &Value<'_>, table: &Table<'_>) -> Result<Vec<MassRow>, FormatError> {
    let sign = match table.get("products") {
        Some(name) if name.choice(&["negative_integral", "positive_integral"])? == "positive_integral" => {
            -1.0
        }
        _ => 1.0,
    };
    let path = value.path()?;
    let bytes = csv::bytes(value, &path)?;
    let rows = of_text(&bytes, sign).map_err(|error| {
        FormatError::of_content(&path, &bytes, error).named_in(value.source().path, value.place())
    })?;
    Ok(rows)
}

/// Returns true if two bodies differ by more than the precision of a table.
pub(crate) fn differs(a: &MassProperties<Body>, b: &MassProperties<Body>) -> bool {
    let size = (b.inertia().matrix()[0][0] / b.mass()).sqrt() + b.gyration_radii()[2];
    let elements = |body: &MassProperties<Body>| body.inertia().matrix();
    let [p, q] = [elements(a), elements(b)];
    let apart = p.as_flattened().iter().zip(q.as_flattened()).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max);
    (a.mass() - b.mass()).abs() > SAME * b.mass()
        || (a.center_of_mass() - b.center_of_mass()).norm() > SAME * (size + b.center_of_mass().norm())
        || apart > SAME * q[0][0].max(q[1][1]).max(q[2][2])
}

fn of_text(bytes: &[u8], sign: f64) -> Result<Vec<MassRow>, ContentError> {
    let text = csv::text(bytes)?;
    let mut lines = fields(text);
    let Some((_, header)) = lines.next() else {
        return Err(missing("lines").hint(format!("write a header such as {}", NAMES.join(","))));
    };
    let places = places(text, &header)?;
    let with_rates = places.len() > NAMES.len();
    let mut rows: Vec<MassRow> = Vec::new();
    for (line, fields) in lines {
        let numbers = csv::numbers::<21>(text, &line, &fields, header.len(), &places)?;
        let [time, mass, x, y, z, xx, yy, zz, xy, xz, yz, rates @ ..] = numbers;
        if rows.last().is_some_and(|last| time < last.time) {
            return Err(csv::value(
                "time_s",
                &time.to_string(),
                "not before the time of the previous row",
                line,
            ));
        }
        let refused = |error| {
            ContentError::new(ContentErrorKind::Body(Box::new(error)), ContentPlace::Text(line.clone()))
        };
        let products = [xy, xz, yz].map(|product| sign * product);
        let inertia = InertiaTensor::with_negative_products([xx, yy, zz], products).map_err(refused)?;
        let body = MassProperties::new(mass, Position::new(x, y, z), inertia).map_err(refused)?;
        let [mass, x, y, z, xx, yy, zz, xy, xz, yz] = rates;
        let inertia = [xx, yy, zz, sign * xy, sign * xz, sign * yz];
        let rates = MassRates { mass, center_of_mass: Velocity::new(x, y, z), inertia };
        rows.push(MassRow { time, body, rates: with_rates.then_some(rates) });
    }
    if rows.is_empty() {
        return Err(missing("rows").hint("write one line per time below the header"));
    }
    Ok(rows)
}

/// Returns the positions of the columns; the columns of the rates must be complete or absent.
fn places(text: &str, header: &[Range<usize>]) -> Result<Vec<usize>, ContentError> {
    let named = |field: &Range<usize>| text[field.clone()].trim_matches('"');
    let place = |name: &str| header.iter().position(|field| named(field) == name);
    let is_known = |name: &str| NAMES.contains(&name) || RATES.contains(&name);
    for (k, field) in header.iter().enumerate() {
        let name = named(field);
        if is_known(name) && place(name) != Some(k) {
            return Err(csv::value("the column", name, "there once", field.clone()));
        }
        let sounds = ["time", "mass", "center", "inertia"].iter().any(|begin| name.starts_with(begin));
        if sounds && !is_known(name) {
            let error = csv::value("the column", name, "one of a mass history's", field.clone());
            return Err(error.hint(format!(
                "the columns are {}, and perhaps {}",
                NAMES.join(", "),
                RATES.join(", ")
            )));
        }
    }
    let require = |name: &&str| {
        place(name).ok_or_else(|| {
            let hint = format!("the columns are {}, and perhaps {}", NAMES.join(", "), RATES.join(", "));
            missing(&format!("column {name}")).hint(hint)
        })
    };
    let mut places = NAMES.iter().map(require).collect::<Result<Vec<_>, _>>()?;
    if RATES.iter().any(|name| place(name).is_some()) {
        places.extend(RATES.iter().map(require).collect::<Result<Vec<_>, _>>()?);
    }
    Ok(places)
}
