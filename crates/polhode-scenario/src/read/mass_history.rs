//! `[mass_history]`: changes of the body's mass properties with time.
//!
//! It names parts that burn or are dropped, or a table of the whole body, and the exits of the
//! mass.

use polhode::body::{BodyPart, Finding, InertiaTensor, MassProperties, Severity};
use polhode::math::{Body, Direction, Position};
use polhode::motion::{Exit, MassHistory, MassRow, Outflow};
use polhode_source::nearest;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

use super::mass_table;

/// Mass history, with the changes of each part.
#[derive(Debug)]
pub(crate) struct PartHistory<'a> {
    pub history: MassHistory,
    pub value: Value<'a>,
    happenings: Vec<Happening>,
}

/// Change of a part, with its start time, s.
#[derive(Debug)]
struct Happening {
    what: String,
    from: f64,
}

impl PartHistory<'_> {
    /// Returns findings for changes after the end of the run, unless the whole history is after it.
    pub(crate) fn idle(&self, end: f64) -> Vec<Finding> {
        if !self.history.changes_between(0.0, end) {
            return Vec::new();
        }
        let late = self.happenings.iter().filter(|happening| happening.from >= end);
        late.map(|Happening { what, from }| Finding {
            code: "mass_history.idle",
            severity: Severity::Warning,
            message: format!("{what} at t = {from} s, and the run ends at {end} s"),
            place: None,
        })
        .collect()
    }
}

/// Reads `[mass_history]`: `[[mass_history.burn]]`, `[[mass_history.drop]]` or `table`, and
/// `[[mass_history.exit]]` or `in_place`.
pub(crate) fn read<'a>(
    root: &Table<'a>,
    parts: &[BodyPart],
    body: &MassProperties<Body>,
) -> Result<Option<PartHistory<'a>>, FormatError> {
    let Some(value) = root.get("mass_history") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&["burn", "drop", "table", "products", "exit", "in_place"])?;
    let rule = "the table defines the whole body";
    table.at_most_one(&["burn", "table"], rule)?;
    table.at_most_one(&["drop", "table"], rule)?;
    let outflow = outflow(&table)?;
    let (rows, happenings) = match table.get("table") {
        Some(file) => (mass_table::rows(&file, &table)?, Vec::new()),
        None => {
            if let Some(products) = table.get("products") {
                return Err(products.invalid("left out without a table"));
            }
            of_parts(&table, parts)?
        }
    };
    let is_closed = outflow == Outflow::None;
    let history = MassHistory::new(&rows, outflow).map_err(|error| {
        let error = value.motion(error);
        let hint = "state where the mass leaves: [[mass_history.exit]], or in_place = true if it stays at rest relative to the body where it was";
        if is_closed { error.with_hint(hint) } else { error }
    })?;
    if let Some(file) = table.get("table") {
        let (at_start, _) = history.at(0.0).map_err(|error| file.motion(error))?;
        if mass_table::differs(&at_start, body) {
            let rule = "a table that agrees with [body] at t = 0";
            let hint = "write the values of the table at t = 0 into [body], in a part of shape = \"tensor\"";
            return Err(file.invalid(rule).with_hint(hint));
        }
    }
    Ok(Some(PartHistory { history, value, happenings }))
}

/// Reads `exit`: `position`, for a wide exit `radius` and `axis`, and for several exits `share`; or
/// `in_place = true`.
fn outflow(table: &Table<'_>) -> Result<Outflow, FormatError> {
    let rule = "mass that is left in place passes through no exit";
    let Some(given) = table.at_most_one(&["exit", "in_place"], rule)? else { return Ok(Outflow::None) };
    if given.key() == "in_place" {
        return Ok(if given.boolean()? { Outflow::InPlace } else { Outflow::None });
    }
    Ok(Outflow::Exits(exits(&given, "mass_history.exit")?))
}

/// Reads the exits of the mass from tables with this header.
pub fn exits(given: &Value<'_>, header: &str) -> Result<Vec<Exit>, FormatError> {
    let tables = given.tables(header)?;
    let alone = tables.len() == 1;
    let exit = |table: &Table<'_>| {
        table.allow(&["position", "radius", "axis", "share"])?;
        let position = table.require("position", "position = [0, 0, \"-1.2 m\"]")?;
        let position = Position::from_array(position.quantities(Dimension::LENGTH)?);
        let radius = table.get("radius").map(|radius| radius.positive(Dimension::LENGTH)).transpose()?;
        let axis = match (radius, table.get("axis")) {
            (None, Some(axis)) => {
                return Err(axis
                    .invalid("left out, because the exit has no radius")
                    .with_hint("an exit without a radius is a point"));
            }
            (None, None) => Direction::ZERO,
            (Some(_), _) => {
                let axis = table.require("axis", "axis = [0, 0, 1]")?;
                let direction = Direction::from_array(axis.numbers()?);
                direction.direction().ok_or_else(|| axis.invalid("a direction: finite and not zero"))?
            }
        };
        let share = match table.get("share") {
            Some(share) => share.positive(Dimension::NONE)?,
            None if alone => 1.0,
            None => {
                return Err(table.missing("share", "share = 0.5"));
            }
        };
        Ok(Exit { share, position, axis, radius: radius.unwrap_or(0.0) })
    };
    let exits = tables.iter().map(exit).collect::<Result<Vec<_>, FormatError>>()?;
    let sum: f64 = exits.iter().map(|exit| exit.share).sum();
    if (sum - 1.0).abs() > 1e-9 {
        return Err(given.invalid(format!("exits with shares that add up to 1; the sum is {sum}")));
    }
    Ok(exits)
}

/// History of one part: the times of its burn, the remaining fraction of its mass, and the time of
/// its drop.
#[derive(Clone, Copy, Debug)]
struct Fate {
    burn: Option<[f64; 2]>,
    left: f64,
    dropped: f64,
}

impl Fate {
    const KEPT: Self = Self { burn: None, left: 1.0, dropped: f64::INFINITY };

    /// Returns the remaining fraction just before or just after a time.
    fn at(&self, time: f64, after: bool) -> f64 {
        if self.dropped < time || after && self.dropped == time {
            return 0.0;
        }
        let Some([from, until]) = self.burn else { return 1.0 };
        let part = ((time - from) / (until - from)).clamp(0.0, 1.0);
        // At the end of the burn the fraction is exact.
        if part == 1.0 { self.left } else { 1.0 - (1.0 - self.left) * part }
    }
}

/// Reads `burn`: `part`, `from`, `until`, `left`; and `drop`: `part`, `time`.
fn of_parts(table: &Table<'_>, parts: &[BodyPart]) -> Result<(Vec<MassRow>, Vec<Happening>), FormatError> {
    let mut happenings = Vec::new();
    let mut fates = vec![Fate::KEPT; parts.len()];
    let mut times = vec![0.0];
    for (burn, _) in tables(table, "burn", "mass_history.burn")? {
        burn.allow(&["part", "from", "until", "left"])?;
        let part = burn.require("part", "part = \"propellant\"")?;
        let k = place(&part, parts)?;
        if fates[k].burn.is_some() {
            return Err(part.invalid("named in one burn only"));
        }
        let from = burn.get("from").map_or(Ok(0.0), |from| not_before_start(&from))?;
        let until = burn.require("until", "until = \"40 s\"")?;
        let end = until.quantity(Dimension::TIME)?;
        if !(end > from) {
            return Err(until.invalid(format!("after the burn begins, at {from} s")));
        }
        let whole = parts[k].properties.mass();
        let left = burn.get("left").map_or(Ok(0.0), |left| {
            let mass = left.quantity(Dimension::MASS)?;
            if mass >= 0.0 && mass < whole {
                return Ok(mass);
            }
            Err(left.invalid(format!("not negative, and less than the available mass, {whole} kg")))
        })?;
        (fates[k].burn, fates[k].left) = (Some([from, end]), left / whole);
        times.extend([from, end]);
        happenings.push(Happening { what: format!("the burn of \"{}\" begins", parts[k].name), from });
    }
    for (drop, _) in tables(table, "drop", "mass_history.drop")? {
        drop.allow(&["part", "time"])?;
        let part = drop.require("part", "part = \"case\"")?;
        let k = place(&part, parts)?;
        if fates[k].dropped.is_finite() {
            return Err(part.invalid("dropped once"));
        }
        let value = drop.require("time", "time = \"70 s\"")?;
        let time = value.quantity(Dimension::TIME)?;
        let last = fates[k].burn.map_or(0.0, |[_, end]| end);
        if !(time >= last && time > 0.0) {
            return Err(value.invalid("after the start, and not before the part's burn ends"));
        }
        fates[k].dropped = time;
        times.push(time);
        happenings.push(Happening { what: format!("\"{}\" is dropped", parts[k].name), from: time });
    }
    if fates.iter().all(|fate| fate.burn.is_none() && !fate.dropped.is_finite()) {
        return Err(
            table.missing("burn", "[[mass_history.burn]], [[mass_history.drop]] or table = \"stage.csv\"")
        );
    }
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut rows = Vec::new();
    for time in times {
        for after in [false, true] {
            let dropped = fates.iter().any(|fate| fate.dropped == time);
            if after == dropped || !after {
                rows.push(row(table, parts, &fates, time, after)?);
            }
        }
    }
    Ok((rows, happenings))
}

fn row(
    table: &Table<'_>,
    parts: &[BodyPart],
    fates: &[Fate],
    time: f64,
    after: bool,
) -> Result<MassRow, FormatError> {
    let refuse = |error| table.error(FormatErrorKind::Body(error));
    let mut there = Vec::new();
    for (part, fate) in parts.iter().zip(fates) {
        let factor = fate.at(time, after);
        if factor > 0.0 {
            let body = &part.properties;
            let rows = body.inertia().matrix().map(|row| row.map(|element| factor * element));
            let inertia = InertiaTensor::from_matrix(rows).map_err(refuse)?;
            let scaled = MassProperties::new(factor * body.mass(), body.center_of_mass(), inertia);
            there.push(scaled.map_err(refuse)?);
        }
    }
    let body = MassProperties::combined(&there).map_err(refuse)?;
    Ok(MassRow { time, body, rates: None })
}

fn tables<'a>(
    table: &Table<'a>,
    key: &'static str,
    header: &str,
) -> Result<Vec<(Table<'a>, Value<'a>)>, FormatError> {
    let Some(list) = table.get(key) else { return Ok(Vec::new()) };
    let values = list.array_of_tables(header)?;
    values.into_iter().map(|value| Ok((value.table()?, value))).collect()
}

/// Returns the number of the part with this name.
fn place(value: &Value<'_>, parts: &[BodyPart]) -> Result<usize, FormatError> {
    let name = value.string()?;
    let mut found = parts.iter().enumerate().filter(|(_, part)| part.name == name).map(|(k, _)| k);
    match (found.next(), found.next()) {
        (Some(k), None) => Ok(k),
        (Some(_), Some(_)) => {
            Err(value.invalid("the name of exactly one part; several parts have this name"))
        }
        (None, _) => {
            let error = value.invalid("the name of a part of the body");
            Err(match nearest(name, parts.iter().map(|part| part.name.as_str())) {
                Some(near) => error.with_hint(format!("did you mean \"{near}\"?")),
                None => error.with_hint(format!("give the part name = \"{name}\"")),
            })
        }
    }
}

fn not_before_start(value: &Value<'_>) -> Result<f64, FormatError> {
    let time = value.quantity(Dimension::TIME)?;
    if time >= 0.0 { Ok(time) } else { Err(value.invalid("not negative: a run starts at 0")) }
}
