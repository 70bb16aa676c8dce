//! Tanks and changes over time, with their rows and configurations resolved.

use polhode_source::{FormatError, FormatErrorKind};

use super::NamedBudget;
use super::plan::Plan;
use super::plan::sequence::{OverTime, PlannedChange, PlannedSequence};
use super::plan::tank::PlannedTank;
use crate::{Basis, Budget, Change, LiquidErrors, Row, Rows, Sequence, SequenceError, Tank};

/// Tanks, and prescribed changes of the body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Prescribed {
    /// Each configuration without liquid, with its tanks.
    stages: Vec<(NamedBudget, Vec<FilledTank>)>,
    /// Changes over time, if there are any.
    pub over_time: Option<OverTime>,
}

/// Tank with its contents at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledTank {
    pub tank: Tank,
    /// Mass of the liquid, kg.
    pub mass: f64,
    /// Errors of the amount and the density.
    pub errors: LiquidErrors,
    /// Name of the group with which its errors are correlated.
    pub group: Option<String>,
}

impl Prescribed {
    /// Returns the tanks of a configuration. If the sequence begins in it, also returns the
    /// changes.
    pub fn sequence(&self, configuration: Option<&str>, basis: Basis) -> Option<Sequence<'_>> {
        let (stage, tanks) = self.stage(configuration)?;
        let tanks = tanks.iter().map(|one| (one.tank.clone(), one.mass));
        let mut sequence = Sequence::of(&stage.budget, basis, tanks);
        if let Some(over_time) = self.over_time.as_ref().filter(|all| all.configuration == stage.name) {
            sequence.burns.clone_from(&over_time.burns);
            let change = |change: &PlannedChange| match change {
                PlannedChange::Drop { time, rows } => Some(Change::Drop { time: *time, rows: rows.clone() }),
                PlannedChange::Deploy { time, configuration } => {
                    let budget = &self.stage(Some(configuration))?.0.budget;
                    Some(Change::Become { time: *time, name: configuration.clone(), budget })
                }
            };
            sequence.changes = over_time.changes.iter().map(change).collect::<Option<_>>()?;
        }
        Some(sequence)
    }

    /// Iterates over the configurations without liquid. Each has its name, its budget, and its
    /// tanks with their contents at the start.
    pub fn dry(&self) -> impl Iterator<Item = (Option<&str>, &Budget, &[FilledTank])> {
        self.stages.iter().map(|(stage, tanks)| (stage.name.as_deref(), &stage.budget, &tanks[..]))
    }

    fn stage(&self, name: Option<&str>) -> Option<&(NamedBudget, Vec<FilledTank>)> {
        self.stages.iter().find(|(stage, _)| stage.name.as_deref() == name)
    }

    /// Returns true if a tank is in a configuration.
    fn has(&self, configuration: Option<&str>, tank: &str) -> bool {
        self.stage(configuration).is_some_and(|(_, tanks)| tanks.iter().any(|one| one.tank.name == tank))
    }
}

/// Adds the liquid in tanks to each configuration. Appends sentences about the assumptions to
/// `lines`.
pub(crate) fn with_liquid(
    configurations: Vec<NamedBudget>,
    plan: &Plan,
    lines: &mut Vec<String>,
) -> Result<(Vec<NamedBudget>, Option<Prescribed>), FormatError> {
    if plan.tanks.is_empty() && plan.sequence.is_none() {
        return Ok((configurations, None));
    }
    let names: Vec<&str> = configurations.iter().filter_map(|one| one.name.as_deref()).collect();
    for tank in &plan.tanks {
        check(tank, &configurations, &names)?;
    }
    let mut wet = Vec::new();
    let mut stages = Vec::new();
    for dry in configurations.iter().cloned() {
        let NamedBudget { name, budget } = &dry;
        let inside = plan.tanks.iter().filter(|tank| tank.is_in(name.as_deref(), budget));
        let inside: Vec<(&PlannedTank, FilledTank)> =
            inside.map(|tank| (tank, tank.placed(budget))).collect();
        wet.push(NamedBudget { name: name.clone(), budget: filled(budget, &inside)? });
        if !inside.is_empty() {
            let of = name.as_ref().map_or_else(String::new, |name| format!(" in the configuration {name}"));
            let each = inside.iter().map(|(tank, _)| tank.in_words()).collect::<Vec<_>>().join(", ");
            lines.push(format!("tank contents are included, without growth allowance{of}: {each}"));
        }
        stages.push((dry, inside.into_iter().map(|(_, placed)| placed).collect()));
    }
    let mut prescribed = Prescribed { stages, over_time: None };
    if let Some(sequence) = &plan.sequence {
        let over_time = over_time(sequence, &names)?;
        let begin = over_time.configuration.clone();
        begins_with(&prescribed, begin.as_deref(), sequence)?;
        same_tanks(&prescribed, &over_time, &plan.tanks)?;
        prescribed.over_time = Some(over_time);
        if let Some(of_file) = prescribed.sequence(begin.as_deref(), plan.questions.basis) {
            // Two points between corners suffice: the errors of a tank occur at an end.
            let tried = of_file.rows([0.0, sequence.stated.until], 2);
            tried.map_err(|error| blame(&error, sequence, &plan.tanks))?;
        }
    }
    Ok((wet, Some(prescribed)))
}

/// Checks that the draining tanks are in the configuration in which the sequence begins.
fn begins_with(
    prescribed: &Prescribed,
    begin: Option<&str>,
    sequence: &PlannedSequence,
) -> Result<(), FormatError> {
    let mut burns = sequence.stated.burns.iter().zip(&sequence.burns);
    let Some((burn, [place, _])) = burns.find(|(burn, _)| !prescribed.has(begin, &burn.tank)) else {
        return Ok(());
    };
    let names = prescribed.stages.iter().filter_map(|(stage, _)| stage.name.as_deref());
    let names = names.filter(|name| prescribed.has(Some(name), &burn.tank));
    let names: Vec<String> = names.map(|name| format!("\"{name}\"")).collect();
    let begin = begin.unwrap_or_default();
    let rule = format!("in the configuration \"{begin}\", in which the body begins");
    let there = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    Err(invalid(place, "tank", &burn.tank, rule).with_hint(format!("it is in {there}")))
}

/// Checks that later configurations have the same tanks as the first. Liquid cannot appear or
/// vanish in a deployment.
fn same_tanks(
    prescribed: &Prescribed,
    over_time: &OverTime,
    tanks: &[PlannedTank],
) -> Result<(), FormatError> {
    let begin = over_time.configuration.as_deref();
    for change in &over_time.changes {
        let PlannedChange::Deploy { configuration, .. } = change else { continue };
        let is_in_one = |tank: &&PlannedTank| {
            prescribed.has(begin, &tank.name) != prescribed.has(Some(configuration), &tank.name)
        };
        if let Some(tank) = tanks.iter().find(is_in_one) {
            let begin = begin.unwrap_or_default();
            let rule = format!(
                "such that the tank \"{}\" is in \"{begin}\" and \"{configuration}\", or in neither",
                tank.name
            );
            return Err(match tank.configurations.join(", ") {
                // Its frame is in only one of them.
                all if all.is_empty() => tank.refused(rule),
                all => invalid(&tank.places[1], "configuration", &all, rule),
            });
        }
    }
    Ok(())
}

impl PlannedTank {
    fn is_in(&self, name: Option<&str>, budget: &Budget) -> bool {
        let named = self.configurations.is_empty()
            || name.is_some_and(|name| self.configurations.iter().any(|other| other == name));
        named && self.frame.as_ref().is_none_or(|frame| has_row(budget, frame))
    }

    fn placed(&self, budget: &Budget) -> FilledTank {
        let root = || budget.rows().name(budget.root()).to_owned();
        let frame = self.frame.clone().unwrap_or_else(root);
        let tank = Tank { name: self.name.clone(), frame, liquid: self.liquid.clone() };
        FilledTank { tank, mass: self.mass, errors: self.errors, group: self.group.clone() }
    }

    /// Returns words such as `12 ± 0.3 kg in "fuel", its density ± 2 %`.
    fn in_words(&self) -> String {
        let LiquidErrors { amount, density, .. } = self.errors;
        let rounded = |x: f64| format!("{x:.2e}").parse::<f64>().unwrap_or(x);
        let error = if amount > 0.0 { format!(" ± {}", rounded(amount)) } else { String::new() };
        let exactly = if amount == 0.0 && density == 0.0 { ", exactly" } else { "" };
        let of_density = match density {
            0.0 => String::new(),
            density => format!(", its density ± {} %", rounded(100.0 * density)),
        };
        format!("{}{error} kg in \"{}\"{of_density}{exactly}", self.mass, self.name)
    }

    /// Returns an error at the tank's frame.
    fn refused(&self, rule: String) -> FormatError {
        invalid(&self.places[0], "frame", self.frame.as_deref().unwrap_or_default(), rule)
    }
}

fn has_row(budget: &Budget, name: &str) -> bool {
    budget.rows().position(name).is_some()
}

/// Returns an error at the place of another error.
fn invalid(place: &FormatError, key: &str, value: &str, rule: String) -> FormatError {
    let kind = FormatErrorKind::Value { key: key.to_owned(), value: format!("{value:?}"), rule };
    place.clone().replaced(kind)
}

/// Checks that the frame of a tank is a row, that its configurations exist, and that no row has its
/// name.
fn check(tank: &PlannedTank, configurations: &[NamedBudget], names: &[&str]) -> Result<(), FormatError> {
    for name in &tank.configurations {
        if !names.contains(&name.as_str()) {
            let error = invalid(&tank.places[1], "configuration", name, "a configuration".to_owned());
            return Err(error.suggesting(name, names.iter().copied()));
        }
    }
    if configurations.iter().any(|one| has_row(&one.budget, &tank.name)) {
        let error = invalid(
            &tank.places[0],
            "the tank",
            &tank.name,
            "different from the names of all rows".to_owned(),
        );
        return Err(
            error.with_hint("the contents of a tank become a row with its name: give the tank another name")
        );
    }
    let Some(frame) = &tank.frame else { return Ok(()) };
    if !configurations.iter().any(|one| has_row(&one.budget, frame)) {
        let error = tank.refused("the name of a row, in whose frame the tank is".to_owned());
        let names = configurations.iter().map(|one| one.budget.rows());
        let names = names.flat_map(|rows| (0..rows.len()).map(move |k| rows.name(k)));
        return Err(error.suggesting(frame, names));
    }
    let absent = tank.configurations.iter().find(|name| {
        let one = configurations.iter().find(|one| one.name.as_ref() == Some(name));
        one.is_some_and(|one| !has_row(&one.budget, frame))
    });
    let rule = |name: &String| format!("the name of a row in the configuration \"{name}\"");
    absent.map_or(Ok(()), |name| Err(tank.refused(rule(name))))
}

/// Returns a list with a row for the liquid in each tank.
fn filled(dry: &Budget, tanks: &[(&PlannedTank, FilledTank)]) -> Result<Budget, FormatError> {
    let Some((first, _)) = tanks.first() else { return Ok(dry.clone()) };
    // Subtotals refer to the rows of the file and were checked before.
    let mut rows: Rows = dry.rows().iter().map(|row| Row { subtotal: None, ..row }).collect();
    for (tank, placed) in tanks {
        let tried = Sequence::of(dry, Basis::Basic, [(placed.tank.clone(), tank.mass)]).at(0.0);
        if let Err(error) = tried {
            let [frame, _, contents] = &tank.places;
            let place = if matches!(error, SequenceError::Fill { .. }) { contents } else { frame };
            return Err(place.clone().replaced(FormatErrorKind::subject(&error, error.hint())));
        }
        if let Some(mut row) = placed.tank.row(tank.mass, tank.errors) {
            row.group.clone_from(&tank.group);
            rows.push(row);
        }
    }
    let budget = Budget::new(rows, dry.groups().to_vec(), dry.growth_table().clone());
    budget.map_err(|error| first.places[2].clone().replaced(FormatErrorKind::subject(&error, error.hint())))
}

fn over_time(sequence: &PlannedSequence, names: &[&str]) -> Result<OverTime, FormatError> {
    let known = |name: &str, place: &FormatError| {
        if names.contains(&name) {
            return Ok(());
        }
        let rule =
            if names.is_empty() { "left out: the file has no configurations" } else { "a configuration" };
        let error = invalid(place, "configuration", name, rule.to_owned());
        Err(error.suggesting(name, names.iter().copied()))
    };
    let configuration = match (&sequence.stated.configuration, names) {
        (Some(name), _) => {
            known(name, &sequence.place)?;
            Some(name.clone())
        }
        (None, []) => None,
        (None, [only]) => Some((*only).to_owned()),
        (None, _) => {
            let kind = FormatErrorKind::MissingKey {
                key: "configuration",
                table: "[sequence]".to_owned(),
                example: "configuration = \"stowed\"",
            };
            return Err(sequence.place.clone().replaced(kind));
        }
    };
    for (change, place) in sequence.stated.changes.iter().zip(&sequence.changes) {
        if let PlannedChange::Deploy { configuration, .. } = change {
            known(configuration, place)?;
        }
    }
    Ok(OverTime { configuration, ..sequence.stated.clone() })
}

/// Returns the error at the item that causes it.
fn blame(error: &SequenceError, sequence: &PlannedSequence, tanks: &[PlannedTank]) -> FormatError {
    let burns = || sequence.stated.burns.iter().zip(&sequence.burns).rev();
    let changes = || sequence.stated.changes.iter().zip(&sequence.changes).rev();
    let of_burn = |tank: &str, until: f64| {
        burns().find(|(burn, _)| burn.tank == tank && burn.from <= until).map(|(_, [_, flow])| flow)
    };
    let change = |is: &dyn Fn(&PlannedChange) -> bool| {
        changes().find(|(change, _)| is(change)).map(|(_, place)| place)
    };
    // No two changes have the same time.
    let at_time = |time: f64| change(&|change| change.time() == time);
    let dropping = |row: &str| {
        change(&|change| match change {
            PlannedChange::Drop { rows, .. } => rows.iter().any(|other| other == row),
            PlannedChange::Deploy { .. } => false,
        })
    };
    let of_tank = |name: &str| tanks.iter().find(|tank| tank.name == name).map(|tank| &tank.places[0]);
    let place = match error {
        SequenceError::Fill { tank, time, .. } => of_burn(tank, *time),
        SequenceError::MissingRow { row, .. } => dropping(row),
        SequenceError::Copies { tank, .. } => of_tank(tank),
        SequenceError::Gone { what, time } => of_burn(what, *time).or_else(|| dropping(what)),
        SequenceError::Simultaneous { time }
        | SequenceError::MassChanges { time, .. }
        | SequenceError::Nothing { time } => at_time(*time),
        _ => None,
    };
    place.unwrap_or(&sequence.place).clone().replaced(FormatErrorKind::subject(error, error.hint()))
}
