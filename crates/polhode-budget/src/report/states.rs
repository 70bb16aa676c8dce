//! Tables of a body over time and by tank fill, with all digits.

use polhode::motion::MassRow;

use super::BudgetReport;
use super::changing::Changing;
use super::numbers::{rates, ten};
use super::table::to_csv;
use super::workbook::Cell;
use crate::SequenceRow;

/// Returns a table of times, the ten numbers and their rates, with headings.
pub(crate) fn history(rows: &[SequenceRow]) -> Vec<Vec<Cell>> {
    let headings = MassRow::COLUMNS.iter().chain(&MassRow::RATE_COLUMNS).map(|name| Cell::of(name));
    let row = |row: &SequenceRow| {
        let numbers = [row.time].into_iter().chain(ten(&row.properties)).chain(rates(row));
        numbers.map(Cell::Number).collect()
    };
    [headings.collect()].into_iter().chain(rows.iter().map(row)).collect()
}

impl BudgetReport {
    /// Returns CSV of the body over time, if that is known ([`BudgetReport::with_sequence`]). It
    /// has mass, centre of mass, the tensor about it and their rates, along the axes of the body.
    /// It also has the configuration and the liquid in each tank. Two rows with the same time are
    /// just before and just after an event.
    pub fn to_time_csv(&self) -> Option<String> {
        self.over_time().map(|rows| to_csv(&rows))
    }

    /// Returns CSV of the body by the liquid in each tank, with derivatives per kilogram of it.
    pub fn to_fill_csv(&self) -> Option<String> {
        self.by_fill().map(|rows| to_csv(&rows))
    }

    pub(crate) fn over_time(&self) -> Option<Vec<Vec<Cell>>> {
        // A file has one sequence, in the configuration in which it begins.
        let mut cases = self.cases.iter();
        let all = cases.find_map(|case| case.changing.as_ref()?.over_time())?;
        let mut table = history(&all.all);
        for (k, line) in table.iter_mut().enumerate() {
            let row = k.checked_sub(1).and_then(|k| all.all.get(k));
            let configuration =
                row.map_or_else(|| Cell::of("configuration"), |row| Cell::of_option(all.configuration(row)));
            line.insert(0, configuration);
            line.extend(all.tanks.iter().enumerate().map(|(j, tank)| match row {
                Some(row) => row.liquid.get(j).map_or(Cell::Empty, |mass| Cell::Number(*mass)),
                None => Cell::Text(format!("liquid_kg {tank}")),
            }));
        }
        Some(table)
    }

    pub(crate) fn by_fill(&self) -> Option<Vec<Vec<Cell>>> {
        let columns = ["configuration", "tank", "fill", "liquid_kg", "level_m"];
        let [_, numbers @ ..] = &MassRow::COLUMNS;
        let headings = columns.iter().chain(numbers).map(|name| Cell::of(name));
        // Derivatives per kilogram in the tank, of all numbers except the mass.
        let per_kg = numbers.iter().skip(1).map(|name| Cell::Text(format!("{name}_per_kg")));
        let mut table = vec![headings.chain(per_kg).collect()];
        for case in &self.cases {
            let tanks = case.changing.iter().flat_map(Changing::by_fill);
            table.extend(tanks.map(|(tank, fill, liquid, level, row)| {
                let words = [Cell::of_option(case.name.as_deref()), Cell::of(tank)];
                let level = level.map_or(Cell::Empty, Cell::Number);
                let [_, slopes @ ..] = rates(row);
                words
                    .into_iter()
                    .chain([Cell::Number(fill), Cell::Number(liquid), level])
                    .chain(ten(&row.properties).map(Cell::Number))
                    .chain(slopes.map(Cell::Number))
                    .collect()
            }));
        }
        (table.len() > 1).then_some(table)
    }
}
