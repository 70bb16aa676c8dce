//! Tanks and what is to happen, where their rows and configurations are known.

use polhode::math::{AngularVelocity, Body};
use polhode::motion::Outflow;
use polhode_budget::{Basis, Budget, Burn, Change, LiquidErrors, Row, Rows, Sequence, SequenceError, Tank};

use super::NamedBudget;
use super::plan::Plan;
use super::plan::sequence::{PlannedChange, PlannedSequence};
use super::plan::tank::PlannedTank;
use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::suggestion::nearest;

/// Tanks, and what is to happen to the body over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Prescribed {
    /// Each configuration without what is in its tanks, and these.
    stages: Vec<DryBudget>,
    /// What happens, if anything is said of it.
    pub over_time: Option<OverTime>,
}

/// A configuration without the liquid in it.
#[derive(Clone, Debug, PartialEq)]
struct DryBudget {
    name: Option<String>,
    budget: Budget,
    tanks: Vec<FilledTank>,
}

/// A tank, and what is in it at first.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledTank {
    /// The tank.
    pub tank: Tank,
    /// Of the liquid, kg.
    pub mass: f64,
    /// How well that is known.
    pub errors: LiquidErrors,
    /// The group with which its errors are correlated.
    pub group: Option<String>,
}

/// What happens to the body.
#[derive(Clone, Debug, PartialEq)]
pub struct OverTime {
    /// The configuration that it begins as.
    pub configuration: Option<String>,
    /// To when it is wanted, from 0 on, s.
    pub until: f64,
    /// What the body has at first.
    pub spin: Option<AngularVelocity<Body>>,
    /// Where mass leaves.
    pub outflow: Outflow,
    burns: Vec<Burn>,
    changes: Vec<PlannedChange>,
}

impl Prescribed {
    /// The tanks of a configuration, and, if it is the one that it begins with, what happens.
    pub fn sequence(&self, configuration: Option<&str>, basis: Basis) -> Option<Sequence<'_>> {
        let stage = self.stage(configuration)?;
        let tanks = stage.tanks.iter().map(|one| (one.tank.clone(), one.mass));
        let mut sequence = Sequence::of(&stage.budget, basis, tanks);
        if let Some(over_time) = self.over_time.as_ref().filter(|all| all.configuration == stage.name) {
            sequence.burns.clone_from(&over_time.burns);
            let change = |change: &PlannedChange| match change {
                PlannedChange::Drop { time, rows } => Some(Change::Drop { time: *time, rows: rows.clone() }),
                PlannedChange::Deploy { time, configuration } => {
                    let budget = &self.stage(Some(configuration))?.budget;
                    Some(Change::Become { time: *time, name: configuration.clone(), budget })
                }
            };
            sequence.changes = over_time.changes.iter().map(change).collect::<Option<_>>()?;
        }
        Some(sequence)
    }

    /// Each configuration without what is in its tanks, and these with what is in them at first.
    pub fn dry(&self) -> impl Iterator<Item = (Option<&str>, &Budget, &[FilledTank])> {
        self.stages.iter().map(|stage| (stage.name.as_deref(), &stage.budget, &stage.tanks[..]))
    }

    fn stage(&self, name: Option<&str>) -> Option<&DryBudget> {
        self.stages.iter().find(|stage| stage.name.as_deref() == name)
    }
}

impl OverTime {
    /// Whether the body is another at the end.
    pub const fn has_changes(&self) -> bool {
        !self.burns.is_empty() || !self.changes.is_empty()
    }

    /// What leaves tanks.
    pub fn burns(&self) -> &[Burn] {
        &self.burns
    }

    /// What happens at once.
    pub fn changes(&self) -> &[PlannedChange] {
        &self.changes
    }
}

/// Adds what is in the tanks to each configuration; lines are added about what was taken as given.
pub(super) fn with_liquid(
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
    for NamedBudget { name, budget } in configurations.iter().cloned() {
        let inside = plan.tanks.iter().filter(|tank| tank.is_in(name.as_deref(), &budget));
        let inside: Vec<(&PlannedTank, Tank)> = inside.map(|tank| (tank, tank.placed(&budget))).collect();
        let all = filled(&budget, &inside)?;
        if !inside.is_empty() {
            let of = name.as_ref().map_or_else(String::new, |name| format!(" in the configuration {name}"));
            let each = inside.iter().map(|(tank, _)| tank.in_words()).collect::<Vec<_>>().join(", ");
            lines.push(format!("what is in tanks counts, and does not grow{of}: {each}"));
        }
        wet.push(NamedBudget { name: name.clone(), budget: all });
        let tanks = inside.into_iter().map(|(tank, placed)| tank.filled(placed)).collect();
        stages.push(DryBudget { name, budget, tanks });
    }
    let mut prescribed = Prescribed { stages, over_time: None };
    if let Some(sequence) = &plan.sequence {
        prescribed.over_time = Some(over_time(sequence, &names)?);
        begins_with(&prescribed, sequence)?;
        same_tanks(&prescribed, &plan.tanks)?;
        let configuration = prescribed.over_time.as_ref().and_then(|all| all.configuration.clone());
        if let Some(of_file) = prescribed.sequence(configuration.as_deref(), plan.questions.basis) {
            // Two places between corners: what is wrong with a tank is so at an end.
            let tried = of_file.rows([0.0, sequence.until], 2);
            tried.map_err(|error| blame(&error, sequence, &plan.tanks))?;
        }
    }
    Ok((wet, Some(prescribed)))
}

/// Are the tanks that drain in what it begins as?
fn begins_with(prescribed: &Prescribed, sequence: &PlannedSequence) -> Result<(), FormatError> {
    let Some(over_time) = &prescribed.over_time else { return Ok(()) };
    let has = |stage: &DryBudget, name: &str| stage.tanks.iter().any(|one| one.tank.name == name);
    let begin = prescribed.stage(over_time.configuration.as_deref());
    for (burn, [place, _]) in &sequence.burns {
        if begin.is_some_and(|stage| has(stage, &burn.tank)) {
            continue;
        }
        let stages = prescribed.stages.iter().filter(|stage| has(stage, &burn.tank));
        let names: Vec<String> =
            stages.filter_map(|stage| Some(format!("\"{}\"", stage.name.as_ref()?))).collect();
        let rule = format!(
            "in the configuration \"{}\", as which the body begins",
            over_time.configuration.as_deref().unwrap_or_default()
        );
        let error = invalid(place, "tank", &burn.tank, rule);
        return Err(match &names[..] {
            [] => error.with_hint("it is in none"),
            _ => error.with_hint(format!("it is in {}", names.join(", "))),
        });
    }
    Ok(())
}

/// Are the tanks of what it begins as also in what it becomes? Liquid does not appear, nor go, as arms unfold.
fn same_tanks(prescribed: &Prescribed, tanks: &[PlannedTank]) -> Result<(), FormatError> {
    let Some(over_time) = &prescribed.over_time else { return Ok(()) };
    let has = |name: Option<&str>, tank: &PlannedTank| {
        prescribed
            .stage(name)
            .is_some_and(|stage| stage.tanks.iter().any(|other| other.tank.name == tank.name))
    };
    let begin = over_time.configuration.as_deref();
    for change in &over_time.changes {
        let PlannedChange::Deploy { configuration, .. } = change else { continue };
        if let Some(tank) = tanks.iter().find(|tank| has(begin, tank) != has(Some(configuration), tank)) {
            let begin = begin.unwrap_or_default();
            let rule = format!(
                "such that the tank \"{}\" is in \"{begin}\" and \"{configuration}\", or in neither",
                tank.name
            );
            return Err(match tank.configurations.join(", ") {
                // Its frame is in one of them only.
                all if all.is_empty() => tank.refused(0, rule),
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

    fn placed(&self, budget: &Budget) -> Tank {
        let root = || budget.rows().name(budget.root()).to_owned();
        let frame = self.frame.clone().unwrap_or_else(root);
        Tank { name: self.name.clone(), frame, liquid: self.liquid.clone() }
    }

    fn filled(&self, placed: Tank) -> FilledTank {
        FilledTank { tank: placed, mass: self.mass, errors: self.errors, group: self.group.clone() }
    }

    /// `12 ± 0.3 kg in "fuel", its density ± 2 %`
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

    fn refused(&self, place: usize, rule: String) -> FormatError {
        let value = [self.frame.clone().unwrap_or_default(), String::new(), String::new()];
        let value = value.get(place).cloned().unwrap_or_default();
        invalid(&self.places[place.min(2)], ["frame", "configuration", "mass"][place.min(2)], &value, rule)
    }
}

fn has_row(budget: &Budget, name: &str) -> bool {
    budget.rows().position(name).is_some()
}

/// At the place of another error.
fn invalid(place: &FormatError, key: &str, value: &str, rule: String) -> FormatError {
    let kind = FormatErrorKind::Value { key: key.to_owned(), value: format!("{value:?}"), rule };
    place.clone().replaced(kind)
}

fn suggested<'a>(error: FormatError, word: &str, all: impl IntoIterator<Item = &'a str>) -> FormatError {
    match nearest(word, all) {
        Some(near) => error.with_hint(format!("did you mean \"{near}\"?")),
        None => error,
    }
}

/// Is the frame of a tank a row, are its configurations some, and is its name that of no row?
fn check(tank: &PlannedTank, configurations: &[NamedBudget], names: &[&str]) -> Result<(), FormatError> {
    for name in &tank.configurations {
        if !names.contains(&name.as_str()) {
            let error = invalid(&tank.places[1], "configuration", name, "a configuration".to_owned());
            return Err(suggested(error, name, names.iter().copied()));
        }
    }
    if configurations.iter().any(|one| has_row(&one.budget, &tank.name)) {
        let error = invalid(&tank.places[0], "the tank", &tank.name, "called as no row is".to_owned());
        return Err(
            error.with_hint("what is in a tank becomes a row of its name: call the tank itself otherwise")
        );
    }
    let Some(frame) = &tank.frame else { return Ok(()) };
    if !configurations.iter().any(|one| has_row(&one.budget, frame)) {
        let error = tank.refused(0, "the name of a row, in whose frame the tank is".to_owned());
        let names = configurations.iter().map(|one| one.budget.rows());
        let names = names.flat_map(|rows| (0..rows.len()).map(move |k| rows.name(k)));
        return Err(suggested(error, frame, names));
    }
    let absent = tank.configurations.iter().find(|name| {
        let one = configurations.iter().find(|one| one.name.as_ref() == Some(name));
        one.is_some_and(|one| !has_row(&one.budget, frame))
    });
    match absent {
        Some(name) => Err(tank.refused(0, format!("the name of a row in the configuration \"{name}\""))),
        None => Ok(()),
    }
}

/// A list with what is in its tanks: a row each.
fn filled(dry: &Budget, tanks: &[(&PlannedTank, Tank)]) -> Result<Budget, FormatError> {
    if tanks.is_empty() {
        return Ok(dry.clone());
    }
    // Subtotals are of the rows that the file has, and are met.
    let mut rows: Rows = dry.rows().iter().map(|row| Row { subtotal: None, ..row }).collect();
    for (tank, placed) in tanks {
        let in_copies = Sequence::of(dry, Basis::Basic, [(placed.clone(), tank.mass)]).at(0.0).err();
        let place = match in_copies {
            Some(SequenceError::Fill { .. }) => 2,
            _ => 0,
        };
        if let Some(error) = in_copies {
            return Err(tank.places[place].clone().replaced(FormatErrorKind::subject(&error, error.hint())));
        }
        if let Some(mut row) = placed.row(tank.mass, tank.errors) {
            row.group.clone_from(&tank.group);
            rows.push(row);
        }
    }
    let budget = Budget::new(rows, dry.groups().to_vec(), dry.growth_table().clone());
    budget.map_err(|error| match tanks.first() {
        Some((tank, _)) => tank.places[2].clone().replaced(FormatErrorKind::subject(&error, error.hint())),
        None => FormatError::new("".as_ref(), None, FormatErrorKind::subject(&error, error.hint())),
    })
}

fn over_time(sequence: &PlannedSequence, names: &[&str]) -> Result<OverTime, FormatError> {
    let known = |name: &str, place: &FormatError| {
        if names.contains(&name) {
            return Ok(());
        }
        let rule = if names.is_empty() { "left out: the file has none" } else { "a configuration" };
        let error = invalid(place, "configuration", name, rule.to_owned());
        Err(suggested(error, name, names.iter().copied()))
    };
    let configuration = match (&sequence.configuration, names) {
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
    for (change, place) in &sequence.changes {
        if let PlannedChange::Deploy { configuration, .. } = change {
            known(configuration, place)?;
        }
    }
    Ok(OverTime {
        configuration,
        until: sequence.until,
        spin: sequence.spin,
        outflow: sequence.outflow.clone(),
        burns: sequence.burns.iter().map(|(burn, _)| burn.clone()).collect(),
        changes: sequence.changes.iter().map(|(change, _)| change.clone()).collect(),
    })
}

/// The error at what is to blame.
fn blame(error: &SequenceError, sequence: &PlannedSequence, tanks: &[PlannedTank]) -> FormatError {
    let of_burn = |tank: &str, until: f64| {
        let mut burns = sequence.burns.iter().rev();
        burns.find(|(burn, _)| burn.tank == tank && burn.from <= until).map(|(_, [_, flow])| flow)
    };
    let at_time =
        |time: f64| sequence.changes.iter().find(|(change, _)| change.time() == time).map(|(_, place)| place);
    let dropping = |row: &str| {
        let mut changes = sequence.changes.iter().rev();
        let drops = |change: &PlannedChange| match change {
            PlannedChange::Drop { rows, .. } => rows.iter().any(|other| other == row),
            PlannedChange::Deploy { .. } => false,
        };
        changes.find(|(change, _)| drops(change)).map(|(_, place)| place)
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
