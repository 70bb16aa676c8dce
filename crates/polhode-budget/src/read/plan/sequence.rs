//! `[sequence]`, `[[burn]]`, `[[drop]]`, `[[deploy]]` and `[[exit]]`: changes of the body over
//! time.

use polhode::math::{AngularVelocity, Body};
use polhode::motion::Outflow;
use polhode_scenario::read::mass_history;
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::names;
use super::tank::PlannedTank;
use crate::Burn;

/// Dimension of a mass flow, kg/s.
const FLOW: Dimension = Dimension::new(1, 0, -1, 0);

/// Changes of the body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct OverTime {
    /// Configuration in which the sequence begins.
    pub configuration: Option<String>,
    /// End of the sequence, s. The sequence begins at t = 0.
    pub until: f64,
    /// Angular velocity at the start, body axes, rad/s.
    pub spin: Option<AngularVelocity<Body>>,
    /// Exits through which mass leaves.
    pub outflow: Outflow,
    /// Flows out of tanks.
    pub burns: Vec<Burn>,
    /// Instantaneous changes of the body.
    pub changes: Vec<PlannedChange>,
}

impl OverTime {
    /// Returns true if the body changes during the sequence.
    pub const fn has_changes(&self) -> bool {
        !self.burns.is_empty() || !self.changes.is_empty()
    }
}

/// Sequence as given in a file. Its rows and configurations are not resolved yet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlannedSequence {
    pub stated: OverTime,
    /// Error templates at the tank and at the flow of each burn.
    pub burns: Vec<[FormatError; 2]>,
    /// Error template at the place of each change.
    pub changes: Vec<FormatError>,
    /// Error template at `configuration`, or at the section.
    pub place: FormatError,
}

/// Instantaneous change of the body.
#[derive(Clone, Debug, PartialEq)]
pub enum PlannedChange {
    /// Removal of rows.
    Drop {
        /// Time of the removal, s.
        time: f64,
        /// Names of the rows.
        rows: Vec<String>,
    },
    /// Change to another configuration.
    Deploy {
        /// Time of the change, s.
        time: f64,
        /// Name of the configuration.
        configuration: String,
    },
}

impl PlannedChange {
    pub(crate) const fn time(&self) -> f64 {
        match self {
            Self::Drop { time, .. } | Self::Deploy { time, .. } => *time,
        }
    }
}

/// Reads the sequence of a plan, if there is one.
pub(crate) fn sequence(
    root: &Table<'_>,
    tanks: &[PlannedTank],
) -> Result<Option<PlannedSequence>, FormatError> {
    let Some(section) = root.get("sequence") else {
        return match ["burn", "drop", "deploy", "exit"].into_iter().find_map(|key| root.get(key)) {
            Some(value) => Err(value
                .invalid("with [sequence]")
                .with_hint("write [sequence], and under it until = \"60 s\"")),
            None => Ok(None),
        };
    };
    let table = section.table()?;
    table.allow(&["configuration", "until", "spin", "in_place"])?;
    let configuration = table.get("configuration");
    let spin = table.get("spin").map(|value| value.quantities(Dimension::ANGULAR_VELOCITY)).transpose()?;
    let until = table.require("until", "until = \"60 s\"")?.positive(Dimension::TIME)?;
    let (burns, of_burns): (Vec<_>, Vec<_>) = burns(root, tanks, until)?.into_iter().unzip();
    let outflow = outflow(root, &table)?;
    if let Some(value) = root.get("exit").or(table.get("in_place")).filter(|_| burns.is_empty()) {
        return Err(value.invalid("left out without [[burn]]"));
    }
    let place = configuration.as_ref().unwrap_or(&section).invalid("right");
    let configuration = configuration.map(|value| value.string().map(|text| text.trim().to_owned()));
    let (configuration, spin) = (configuration.transpose()?, spin.map(AngularVelocity::from_array));
    let (changes, of_changes) = changes(root, until)?.into_iter().unzip();
    let stated = OverTime { configuration, until, spin, outflow, burns, changes };
    Ok(Some(PlannedSequence { stated, burns: of_burns, changes: of_changes, place }))
}

fn outflow(root: &Table<'_>, table: &Table<'_>) -> Result<Outflow, FormatError> {
    let in_place = table.get("in_place");
    match (root.get("exit"), &in_place) {
        (Some(_), Some(value)) => {
            Err(value.invalid("left out with [[exit]]: mass that stays in place leaves through no exit"))
        }
        (Some(value), None) => Ok(Outflow::Exits(mass_history::exits(&value, "exit")?)),
        (None, Some(value)) if value.boolean()? => Ok(Outflow::InPlace),
        (None, _) => Ok(Outflow::None),
    }
}

fn burns(
    root: &Table<'_>,
    tanks: &[PlannedTank],
    last: f64,
) -> Result<Vec<(Burn, [FormatError; 2])>, FormatError> {
    let Some(list) = root.get("burn") else { return Ok(Vec::new()) };
    let burn = |table: Table<'_>| {
        table.allow(&["tank", "from", "until", "flow", "mass"])?;
        let tank = table.require("tank", "tank = \"fuel\"")?;
        let name = tank.string()?.trim();
        let names = tanks.iter().map(|tank| tank.name.as_str());
        if !names.clone().any(|other| other == name) {
            return Err(tank.invalid("the name of a [[tank]]").suggesting(name, names));
        }
        let from = table.get("from").map_or(Ok(0.0), |from| time(&from))?;
        let end = table.require("until", "until = \"40 s\"")?;
        let until = end.quantity(Dimension::TIME)?;
        if !(until > from) {
            return Err(end.invalid(format!("after the burn begins, at {from} s")));
        }
        if until > last {
            return Err(end.invalid(format!("within the sequence, which ends at {last} s")));
        }
        let given =
            table.at_most_one(&["flow", "mass"], "mass is the total outflow, flow the outflow per second")?;
        let given = given.ok_or_else(|| table.missing("flow", "flow = \"0.2 kg/s\", or mass = \"12 kg\""))?;
        let flow = match given.key() {
            "flow" => given.positive(FLOW)?,
            _ => given.positive(Dimension::MASS)? / (until - from),
        };
        let places = [tank.invalid("right"), given.invalid("right")];
        Ok((Burn { tank: name.to_owned(), from, until, flow }, places))
    };
    list.tables("burn")?.into_iter().map(burn).collect()
}

fn changes(root: &Table<'_>, last: f64) -> Result<Vec<(PlannedChange, FormatError)>, FormatError> {
    let mut changes: Vec<(PlannedChange, FormatError)> = Vec::new();
    let mut add = |change: PlannedChange, at: &Value<'_>, place: &Value<'_>| {
        if changes.iter().any(|(other, _)| other.time() == change.time()) {
            let hint = "list all rows that are dropped together in one [[drop]]";
            return Err(at.invalid("different from the times of the other changes").with_hint(hint));
        }
        changes.push((change, place.invalid("right")));
        Ok(())
    };
    if let Some(list) = root.get("drop") {
        for table in list.tables("drop")? {
            table.allow(&["time", "rows"])?;
            let rows = table.require("rows", "rows = [\"booster\"]")?;
            let at = table.require("time", "time = \"70 s\"")?;
            let all = if rows.is_array() { names(&rows)? } else { vec![rows.string()?.trim().to_owned()] };
            if all.is_empty() {
                return Err(rows.invalid("the names of one or more rows"));
            }
            add(PlannedChange::Drop { time: later(&at, last)?, rows: all }, &at, &rows)?;
        }
    }
    if let Some(list) = root.get("deploy") {
        for table in list.tables("deploy")? {
            table.allow(&["time", "configuration"])?;
            let to = table.require("configuration", "configuration = \"deployed\"")?;
            let at = table.require("time", "time = \"70 s\"")?;
            let configuration = to.string()?.trim().to_owned();
            add(PlannedChange::Deploy { time: later(&at, last)?, configuration }, &at, &to)?;
        }
    }
    Ok(changes)
}

fn time(value: &Value<'_>) -> Result<f64, FormatError> {
    let time = value.quantity(Dimension::TIME)?;
    if time >= 0.0 { Ok(time) } else { Err(value.invalid("not negative: the sequence starts at 0")) }
}

fn later(value: &Value<'_>, last: f64) -> Result<f64, FormatError> {
    let time = value.quantity(Dimension::TIME)?;
    if time > 0.0 && time < last {
        Ok(time)
    } else {
        Err(value.invalid(format!("after 0, when the sequence starts, and before {last} s, when it ends")))
    }
}
