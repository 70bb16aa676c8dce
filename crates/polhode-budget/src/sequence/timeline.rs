//! Checked sequence, divided into stages between changes.

use std::collections::HashSet;

use polhode::body::MassProperties;
use polhode::math::Body;

use super::loaded::{PlacedTank, rates};
use super::{Change, Sequence, SequenceRow};
use crate::budget::Budget;
use crate::error::BudgetError;
use crate::sequence_error::SequenceError;
use crate::subtrees::combined;
use crate::tank::Slice;
use crate::tensor::scaled;

/// Stages of a sequence, between changes of the body.
#[derive(Debug)]
pub(super) struct Timeline<'a> {
    sequence: &'a Sequence<'a>,
    stages: Vec<Stage<'a>>,
}

/// Stage from one change to the next.
#[derive(Debug)]
struct Stage<'a> {
    from: f64,
    /// Mass properties without liquid.
    dry: Option<MassProperties<Body>>,
    /// Place of each tank; `None` for a removed tank.
    tanks: Vec<Option<PlacedTank<'a>>>,
}

/// Side from which the limit at a time is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Before,
    After,
}

/// Largest relative difference of the mass when a body takes another form.
const SAME: f64 = 1e-12;

impl<'a> Timeline<'a> {
    /// Checks a sequence and divides it into stages.
    ///
    /// # Errors
    /// [`SequenceError`] that names the invalid item.
    pub(super) fn of(sequence: &'a Sequence<'a>) -> Result<Self, SequenceError> {
        sequence.check()?;
        let mut changes: Vec<&Change<'a>> = sequence.changes.iter().collect();
        changes.sort_by(|a, b| a.time().total_cmp(&b.time()));
        if let Some(pair) = changes.windows(2).find(|pair| pair[0].time() == pair[1].time()) {
            return Err(SequenceError::Simultaneous { time: pair[0].time() });
        }
        let (mut budget, mut gone) = (sequence.budget, Vec::<&str>::new());
        let mut stages = vec![Stage::of(sequence, budget, &gone, f64::NEG_INFINITY)?];
        for change in changes {
            let time = change.time();
            match change {
                Change::Drop { rows, .. } => {
                    for row in rows {
                        if budget.rows.position(row).is_none() {
                            let by = "a change".to_owned();
                            return Err(SequenceError::MissingRow { by, row: row.clone() });
                        }
                        if budget.is_within(row, &gone) {
                            return Err(SequenceError::Gone { what: row.clone(), time });
                        }
                    }
                    gone.extend(rows.iter().map(String::as_str));
                }
                Change::Become { budget: next, .. } => budget = next,
            }
            let stage = Stage::of(sequence, budget, &gone, time)?;
            if let (Change::Become { .. }, Some(before)) = (change, stages.last()) {
                let [before, after] = [before, &stage].map(|stage| stage.dry.map_or(0.0, |dry| dry.mass()));
                if (before - after).abs() > SAME * before {
                    return Err(SequenceError::MassChanges { time, before, after });
                }
            }
            stages.push(stage);
        }
        Ok(Self { sequence, stages })
    }

    pub(super) fn after(&self, time: f64) -> Result<SequenceRow, SequenceError> {
        self.row(time, Side::After)
    }

    pub(super) fn rows(
        &self,
        [from, to]: [f64; 2],
        pieces: usize,
    ) -> Result<Vec<SequenceRow>, SequenceError> {
        let rule = "finite, and the last after the first";
        if !(from < to && from.is_finite() && to.is_finite()) {
            return Err(SequenceError::Value { what: "the last time", value: to, rule });
        }
        let burns = self.sequence.burns.iter().flat_map(|burn| [burn.from, burn.until]);
        let mut corners: Vec<f64> = burns.chain(self.stages.iter().map(|stage| stage.from)).collect();
        corners.retain(|time| *time > from && *time < to);
        corners.extend([from, to]);
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        let mut rows = Vec::new();
        for pair in corners.windows(2) {
            let &[begin, end] = pair else { continue };
            rows.push(self.row(begin, Side::After)?);
            let count = pieces.max(1);
            for k in 1..count {
                rows.push(self.row(begin + (end - begin) * (k as f64 / count as f64), Side::After)?);
            }
            rows.push(self.row(end, Side::Before)?);
        }
        Ok(rows)
    }

    /// Returns the body with all tanks filled to a fraction of their capacity.
    pub(super) fn filled(&self, fraction: f64) -> Result<SequenceRow, SequenceError> {
        let Some(stage) = self.stages.first() else { return Err(SequenceError::Nothing { time: 0.0 }) };
        let capacities = self.sequence.tanks.iter().map(|(tank, _)| tank.liquid.capacity());
        let loads: Vec<[f64; 2]> = capacities.map(|full| [fraction * full, full]).collect();
        stage.loaded(0.0, &loads)
    }

    fn row(&self, time: f64, side: Side) -> Result<SequenceRow, SequenceError> {
        let begun = self.stages.partition_point(|stage| match side {
            Side::Before => stage.from < time,
            Side::After => stage.from <= time,
        });
        // The first stage starts at −∞.
        let changes = begun.saturating_sub(1);
        let Some(stage) = self.stages.get(changes) else { return Err(SequenceError::Nothing { time }) };
        let loads: Vec<[f64; 2]> =
            self.sequence.tanks.iter().map(|(tank, mass)| self.load(&tank.name, *mass, time, side)).collect();
        for ((load, place), (tank, _)) in loads.iter().zip(&stage.tanks).zip(&self.sequence.tanks) {
            if place.is_none() && load[1] != 0.0 {
                return Err(SequenceError::Gone { what: tank.name.clone(), time });
            }
        }
        Ok(SequenceRow { changes, ..stage.loaded(time, &loads)? })
    }

    /// Returns the mass in a tank, kg, and its rate of change, kg/s.
    fn load(&self, tank: &str, at_first: f64, time: f64, side: Side) -> [f64; 2] {
        let burns = self.sequence.burns.iter().filter(|burn| burn.tank == tank);
        burns.fold([at_first, 0.0], |[mass, rate], burn| {
            let spent = burn.flow * (time.min(burn.until) - burn.from).max(0.0);
            let is_on = match side {
                Side::Before => burn.from < time && time <= burn.until,
                Side::After => burn.from <= time && time < burn.until,
            };
            [mass - spent, rate - if is_on { burn.flow } else { 0.0 }]
        })
    }
}

impl<'a> Stage<'a> {
    fn of(
        sequence: &'a Sequence<'a>,
        budget: &'a Budget,
        gone: &[&str],
        from: f64,
    ) -> Result<Self, SequenceError> {
        let dry = budget.without(gone, sequence.basis)?;
        let place = |(tank, _): &'a (crate::tank::Tank, f64)| {
            if budget.is_within(&tank.frame, gone) {
                return Ok(None);
            }
            let missing = || SequenceError::MissingRow {
                by: format!("the tank \"{}\"", tank.name),
                row: tank.frame.clone(),
            };
            let k = budget.rows.position(&tank.frame).ok_or_else(missing)?;
            let placed = budget.frame(k);
            if placed.frames * f64::from(budget.rows.quantity(k).count) != 1.0 {
                let (tank, row) = (tank.name.clone(), tank.frame.clone());
                return Err(SequenceError::Copies { tank, row });
            }
            Ok(Some(PlacedTank { tank, position: placed.position, rotation: placed.rotation }))
        };
        let tanks = sequence.tanks.iter().map(place).collect::<Result<_, _>>()?;
        Ok(Self { from, dry, tanks })
    }

    /// Returns the body with these masses, kg, and rates of change, kg/s, in the tanks.
    fn loaded(&self, time: f64, loads: &[[f64; 2]]) -> Result<SequenceRow, SequenceError> {
        let of_sum = |error| SequenceError::Budget(BudgetError::Sum(error));
        let (mut parts, mut slices) = (Vec::from_iter(self.dry), Vec::<(f64, Slice)>::new());
        let mut liquid = Vec::with_capacity(loads.len());
        for (tank, &[mass, rate]) in self.tanks.iter().zip(loads) {
            let Some(tank) = tank else {
                liquid.push(0.0);
                continue;
            };
            let fill = tank.filled(mass, time)?;
            liquid.push(fill.properties.map_or(0.0, |liquid| liquid.mass()));
            parts.extend(tank.liquid(&fill).map_err(of_sum)?);
            slices.push((rate, tank.slice(&fill.next)));
        }
        let properties = combined(&parts).map_err(of_sum)?.ok_or(SequenceError::Nothing { time })?;
        Ok(SequenceRow { time, changes: 0, properties, rates: rates(&properties, &slices), liquid })
    }
}

impl Sequence<'_> {
    fn check(&self) -> Result<(), SequenceError> {
        let mut names = HashSet::new();
        for (tank, _) in &self.tanks {
            if !names.insert(tank.name.as_str()) {
                return Err(SequenceError::DuplicateTank { tank: tank.name.clone() });
            }
        }
        let require = |what, value: f64, holds: bool, rule| {
            if holds { Ok(()) } else { Err(SequenceError::Value { what, value, rule }) }
        };
        for burn in &self.burns {
            if !names.contains(burn.tank.as_str()) {
                return Err(SequenceError::MissingTank { tank: burn.tank.clone() });
            }
            let rule = "finite and not negative: inflow is not supported";
            require("the flow out of a tank", burn.flow, burn.flow >= 0.0 && burn.flow.is_finite(), rule)?;
            let holds = burn.from < burn.until && burn.from.is_finite() && burn.until.is_finite();
            require("the end of a burn", burn.until, holds, "finite, and after its start")?;
        }
        let mut times = self.changes.iter().map(Change::time);
        times.try_for_each(|time| require("the time of a change", time, time.is_finite(), "finite"))
    }
}

impl Budget {
    /// Returns true if a row is one of these rows or a descendant of one.
    fn is_within(&self, name: &str, rows: &[&str]) -> bool {
        let mut at = self.rows.position(name);
        while let Some(k) = at {
            if rows.contains(&self.rows.name(k)) {
                return true;
            }
            at = self.tree.parent(k);
        }
        false
    }

    /// Combines all rows except these and their descendants.
    fn without(
        &self,
        rows: &[&str],
        basis: crate::growth::Basis,
    ) -> Result<Option<MassProperties<Body>>, BudgetError> {
        let mut is_gone = vec![false; self.rows.len()];
        let mut parts = Vec::new();
        for k in self.tree.order() {
            is_gone[k] = rows.contains(&self.rows.name(k))
                || self.tree.parent(k).is_some_and(|parent| is_gone[parent]);
            if !is_gone[k]
                && let Some(own) = self.own(k, basis)?
            {
                let count = self.frame(k).frames * f64::from(self.rows.quantity(k).count);
                parts.push(scaled(&own, count).map_err(BudgetError::Sum)?);
            }
        }
        combined(&parts).map_err(BudgetError::Sum)
    }
}
