//! `[[torque]]`: one module per model.

mod constant;
mod drag;
mod energy_sink;
mod formula;
mod gravity;
mod gravity_gradient;
mod magnetic;
#[cfg(feature = "parquet")]
mod parquet;
pub(crate) mod schedule;
mod table;
mod table_columns;
mod thruster;
mod torsion;

use std::ops::Range;

use polhode::body::BodyPart;
use polhode::motion::Orbit;
use polhode::motion::torque::{MagneticField, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};

use super::body::Pivot;

/// Names of the models in a file.
const MODELS: [&str; 10] = [
    "constant",
    "gravity",
    "gravity_gradient",
    "drag",
    "torsion",
    "magnetic",
    "thruster",
    "energy_sink",
    "formula",
    "table",
];

/// All torques of a file.
#[derive(Debug, Default)]
pub(crate) struct Torques {
    pub models: Vec<TorqueModel>,
    /// Name of each torque; `None` if it has none.
    pub names: Vec<Option<String>>,
    /// Numbers of the torques that are off until an event switches them on.
    pub switched_off: Vec<usize>,
    pub places: Vec<TorquePlaces>,
}

/// Places in a torque's table for errors of the motion.
#[derive(Clone, Debug)]
pub(crate) struct TorquePlaces {
    pub model: Range<usize>,
    pub pulses: Option<Range<usize>>,
    pub formulas: Option<Range<usize>>,
    /// Places of the three formulas along body axes, if they are given so.
    pub along_body: Vec<Range<usize>>,
}

impl TorquePlaces {
    fn of(table: &Table<'_>, model: &Value<'_>) -> Self {
        let formulas = table.get("torque");
        let is_along_body = table.get("axes").is_some_and(|axes| axes.string() == Ok("body"));
        let components = formulas.filter(|_| is_along_body).and_then(|all| all.fixed::<3>("formulas").ok());
        Self {
            model: model.span(),
            pulses: table.get("pulses").map(|pulses| pulses.span()),
            formulas: formulas.map(|formulas| formulas.span()),
            along_body: components.iter().flatten().map(Value::span).collect(),
        }
    }
}

/// Keys of every torque, in addition to those of its schedule.
const KEYS: [&str; 3] = ["model", "name", "on"];

/// Reads all torques on a body with these parts, in an orbit, until the end of the run; gravity may
/// give the pivot, or repeat it.
pub(crate) fn torques<'a>(
    root: &Table<'a>,
    parts: &[BodyPart],
    orbit: Option<&Orbit>,
    end: Option<f64>,
    pivot: &mut Option<Pivot<'a>>,
) -> Result<Torques, FormatError> {
    let mut torques = Torques::default();
    let Some(list) = root.get("torque") else { return Ok(torques) };
    for table in list.tables("torque")? {
        let named = table.require("model", "model = \"gravity\"")?;
        let name = named.choice(&MODELS)?;
        torques.places.push(TorquePlaces::of(&table, &named));
        let table = table.called(format!("[[torque]] of model \"{name}\""));
        let model = match name {
            "constant" => constant::constant(&table)?,
            "gravity_gradient" => gravity_gradient::gravity_gradient(&table, parts, orbit)?,
            "drag" => drag::drag(&table)?,
            "torsion" => torsion::torsion(&table)?,
            "magnetic" => magnetic::magnetic(&table, orbit)?,
            "thruster" => thruster::thruster(&table)?,
            "energy_sink" => energy_sink::energy_sink(&table)?,
            "formula" => formula::formula(&table)?,
            "table" => table::table(&table, end)?,
            _ if torques.models.iter().any(|model| matches!(model, TorqueModel::Gravity(_))) => {
                let rule = "used once: this is a second gravity";
                return Err(named.invalid(rule).with_hint("add the accelerations"));
            }
            _ => gravity::gravity(&table, pivot)?,
        };
        let model = schedule::scheduled(&table, model)?;
        torques.put(&table, model)?;
    }
    if let Some(pivot) = pivot {
        list.tables("torque")?.iter().try_for_each(|table| gravity_gradient::refuse_pivot(table, pivot))?;
    }
    Ok(torques)
}

impl Torques {
    /// Returns the field of the magnetic torques, if all have the same.
    pub(crate) fn field(&self) -> Option<&MagneticField> {
        let mut fields = self.models.iter().filter_map(|model| {
            let model = if let TorqueModel::Scheduled(scheduled) = model { &scheduled.torque } else { model };
            if let TorqueModel::Magnetic(magnetic) = model { Some(&magnetic.field) } else { None }
        });
        let first = fields.next()?;
        fields.all(|other| other == first).then_some(first)
    }

    /// Adds a torque with its `name` and its initial `on` state.
    fn put(&mut self, table: &Table<'_>, model: TorqueModel) -> Result<(), FormatError> {
        let name = match table.get("name") {
            None => None,
            Some(value) => match value.string()? {
                name if self.names.iter().any(|other| other.as_deref() == Some(name)) => {
                    let hint = "events switch torques by name: give each torque its own name";
                    return Err(value.invalid("different from the names of other torques").with_hint(hint));
                }
                name => Some(name.to_owned()),
            },
        };
        if let Some(on) = table.get("on")
            && !on.boolean()?
        {
            if name.is_none() {
                let hint = "an event that switches the torque on needs its name: give it a name";
                return Err(on.invalid("true for a torque without a name").with_hint(hint));
            }
            self.switched_off.push(self.models.len());
        }
        self.names.push(name);
        self.models.push(model);
        Ok(())
    }
}

/// Refuses keys that are neither the model's own nor common to all torques.
fn allow(table: &Table<'_>, own: &[&'static str]) -> Result<(), FormatError> {
    let keys: Vec<&'static str> = KEYS.iter().chain(own).chain(&schedule::KEYS).copied().collect();
    table.allow(&keys)
}
