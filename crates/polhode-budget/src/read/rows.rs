//! Rows of cells as rows of a parts list.

use std::collections::HashMap;

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_source::{ContentError, FormatError};

use super::access::Access;
use super::cell::Cell;
use super::cells::{Cells, Reader};
use super::heading::Columns;
use super::key::{
    ALLOWABLE, CONFIGURATION, COPIES, GROUP, GROWTH, MASS, MATURITY, NAME, PARENT, PATH, QUANTITY, SUBTOTAL,
};
use super::number::Amount;
use super::plan::Plan;
use super::plan::growth::{BARE_GROWTH, BARE_GROWTH_HINT};
use super::sheet::Sheet;
use super::taken::Taken;
use crate::{CopyErrors, Growth, Quantity, Row, Spread, Subtotal, Uncertainty};

/// Reader of rows, one after another.
pub(crate) struct Rows<'s, 'a> {
    pub reader: Reader<'s, 'a>,
    pub plan: &'s Plan,
    pub access: Access<'s>,
    pub taken: Taken,
    /// Mass properties of files and shapes that were computed before, by their description.
    pub known: HashMap<String, MassProperties<Part>>,
}

/// Rows of a table as rows of a parts list.
#[derive(Debug, Default)]
pub(crate) struct ReadRows {
    pub rows: crate::Rows,
    /// Index of each row in the table.
    pub origins: Vec<u32>,
    /// Names of configurations: those of the plan first, then others in the order of the rows.
    pub configurations: Vec<String>,
    /// Rows that are not in all configurations, each with the index of one in which it is, in the
    /// order of rows.
    pub members: Vec<(u32, u32)>,
}

/// Largest number of configurations. Each has a copy of its rows, so more could fill the memory.
const MOST_CONFIGURATIONS: u32 = 100;

/// Names of rows that are totals of others.
const TOTALS: [&str; 9] =
    ["total", "totals", "grand total", "sum", "subtotal", "sub-total", "total mass", "summe", "gesamt"];

impl ReadRows {
    /// Returns the index of a configuration, or `None` if there are too many.
    fn number_of(&mut self, name: String) -> Option<u32> {
        let known = self.configurations.iter().position(|known| *known == name);
        let number = known.unwrap_or(self.configurations.len());
        if known.is_none() {
            self.configurations.push(name);
        }
        u32::try_from(number).ok().filter(|number| known.is_some() || *number < MOST_CONFIGURATIONS)
    }
}

impl<'s, 'a> Rows<'s, 'a> {
    pub(crate) fn new(
        sheet: &'s Sheet<'a>,
        columns: &'s Columns,
        plan: &'s Plan,
        access: Access<'s>,
    ) -> Self {
        let reader = Reader::new(sheet, columns, plan.coverage_factor.unwrap_or(1.0));
        Self { reader, plan, access, taken: Taken::default(), known: HashMap::new() }
    }

    /// Reads all rows below the headings.
    pub(crate) fn all(&mut self) -> Result<ReadRows, FormatError> {
        let (sheet, columns) = (self.reader.sheet, self.reader.columns);
        let configurations = self.plan.configurations.clone().unwrap_or_default();
        let mut all = ReadRows { configurations, ..ReadRows::default() };
        for (origin, row) in (0..).zip(sheet.rows.iter()).skip(columns.row + 1) {
            let cells = sheet.row(row);
            let Some(cells) = Cells::of(sheet, columns, &cells)? else { continue };
            let (row, configurations) = self.row(&cells)?;
            for name in configurations {
                let number = all.number_of(name).ok_or_else(|| self.too_many(cells.first))?;
                all.members.push((all.origins.len() as u32, number)); // A table has fewer than 2³² rows.
            }
            all.rows.push(row);
            all.origins.push(origin);
        }
        Ok(all)
    }

    fn too_many(&self, cell: &Cell<'_>) -> FormatError {
        let error = ContentError::unsupported(format!("more than {MOST_CONFIGURATIONS} configurations"));
        self.reader.sheet.error(cell, error.into())
    }

    fn row(&mut self, cells: &Cells<'_, 'a>) -> Result<(Row, Vec<String>), FormatError> {
        let name = self.name(cells)?;
        let parent = self.reader.label(cells, PARENT)?;
        if let (Some(parent), Some(cell), Some((path, _))) =
            (&parent, cells.cell(PARENT), name.rsplit_once('/'))
            && parent != path
        {
            let error = self.reader.invalid(cell, format!("\"{path}\", as in the path, or left out"));
            return Err(error.with_hint("a name with / is a path: the parent row comes before /"));
        }
        let (place, position, rotation) = self.reader.place(cells)?;
        let quantity = self.quantity(cells)?;
        let (part, uncertainty) =
            self.part(cells)?.map_or((None, None), |(part, own)| (Some(part), Some(own)));
        if part.is_none() {
            let errs = position != Spread::Exact || rotation != Spread::Exact;
            let keys = if errs { &[GROWTH, MATURITY][..] } else { &[GROWTH, MATURITY, GROUP] };
            if let Some(cell) = cells.any(keys.iter().copied()) {
                let error = self.reader.invalid(cell, "left out of a row without mass");
                return Err(error.with_hint("a frame has no mass of its own: give it to the rows in it"));
            }
        }
        let subtotal = self.subtotal(cells)?;
        let allowable = self.reader.number(cells, ALLOWABLE)?;
        if let Some(given) = allowable.filter(|given| !(given.value > 0.0)) {
            return Err(self.reader.invalid(given.cell, "positive"));
        }
        let row = Row {
            parent,
            quantity,
            place,
            part,
            uncertainty: Uncertainty { part: uncertainty.unwrap_or_default(), position, rotation },
            group: self.reader.label(cells, GROUP)?,
            growth: self.growth(cells)?,
            subtotal,
            allowable: allowable.map(|given| given.value),
            ..Row::frame(name)
        };
        Ok((row, self.configurations(cells)?))
    }

    fn name(&self, cells: &Cells<'_, 'a>) -> Result<String, FormatError> {
        const TOTAL: &str = "write a sum in the column subtotal of the parent row";
        let name = [NAME, PATH].iter().find_map(|key| cells.cell(*key));
        let Some(cell) = name else {
            let missing = ContentError::missing(format!("name in row {}", cells.first.row));
            let is_total = cells.cell(MASS).is_some() || cells.cell(SUBTOTAL).is_some();
            let error = self.reader.sheet.error(cells.first, missing.into());
            return Err(error.with_hint_of(is_total.then_some(TOTAL)));
        };
        if self.reader.sheet.is_remark(cells.first) {
            let error = self.reader.invalid(cells.first, "without # in front, below the headings");
            return Err(error.with_hint(
                "remarks (##) belong above the headings: delete the line, or put a name that begins with # in quotes",
            ));
        }
        let name = self.reader.label_of(cell)?;
        if name.split('/').any(|name| name.trim().is_empty()) {
            return Err(self.reader.invalid(cell, "a name, or names separated by /"));
        }
        // In `Total (all)`, the text in brackets is a remark.
        let plain = name.split(['(', '[', ':']).next().unwrap_or_default().trim().to_lowercase();
        if TOTALS.contains(&plain.as_str()) && cells.cell(MASS).is_some() {
            return Err(self.reader.invalid(cell, "the name of a part, not of a sum").with_hint(TOTAL));
        }
        Ok(name)
    }

    fn quantity(&mut self, cells: &Cells<'_, 'a>) -> Result<Quantity, FormatError> {
        let mut quantity = Quantity::ONE;
        if let Some(given) = self.reader.number(cells, QUANTITY)? {
            if !(given.value >= 1.0 && given.value <= f64::from(u32::MAX) && given.value.fract() == 0.0) {
                let error = self.reader.invalid(given.cell, "an integer, at least 1");
                return Err(error.with_hint("delete the row of a part that is absent"));
            }
            quantity.count = given.value as u32;
        }
        if let (Some(text), Some(cell)) = (self.reader.text(cells, COPIES)?, cells.cell(COPIES)) {
            let named = CopyErrors::NAMED.into_iter().find(|(name, _)| *name == text);
            let (_, errors) = named.ok_or_else(|| {
                let hint =
                    "alike: one estimate for all copies; independent: each copy was weighed separately";
                self.reader.invalid(cell, "alike or independent").with_hint(hint)
            })?;
            quantity.errors = errors;
        }
        self.taken.alike_copies += usize::from(quantity.count > 1 && cells.cell(COPIES).is_none());
        Ok(quantity)
    }

    fn growth(&mut self, cells: &Cells<'_, 'a>) -> Result<Growth, FormatError> {
        let code = self.reader.label(cells, MATURITY)?;
        let fraction = self.reader.number(cells, GROWTH)?;
        if let (Some(code), Some(_), Some(cell)) = (&code, fraction, cells.cell(MATURITY))
            && self.plan.growth.get(code).is_none()
        {
            let error = self.reader.invalid(cell, "a code of the table of growth allowances, or left out");
            return Err(
                error.with_hint("add the code to growth, or leave it out if the row states its growth")
            );
        }
        if let Some(given) = fraction.filter(|given| !(given.value >= 0.0)) {
            return Err(self.reader.invalid(given.cell, "zero or positive"));
        }
        if let Some(given) = fraction.filter(|given| given.value > 1.0 && !self.reader.is_percent(given.cell))
        {
            return Err(self.reader.invalid(given.cell, BARE_GROWTH).with_hint(BARE_GROWTH_HINT));
        }
        let of_code = code.as_deref().and_then(|code| self.plan.growth.get(code));
        if let (Some(given), Some(allowance)) = (fraction, of_code)
            && (given.value - allowance).abs() > 1e-9
        {
            let rule = format!("that of its maturity code, {} %, or left out", 100.0 * allowance);
            return Err(self.reader.invalid(given.cell, rule));
        }
        Ok(match (code, fraction) {
            (_, Some(given)) => Growth::Fraction(given.value),
            (Some(code), None) => Growth::Code(code),
            (None, None) => Growth::None,
        })
    }

    fn subtotal(&mut self, cells: &Cells<'_, 'a>) -> Result<Option<Subtotal>, FormatError> {
        let Some(given) = self.reader.number(cells, SUBTOTAL)? else { return Ok(None) };
        let tolerance = match self.reader.tolerance(cells, given)? {
            Some(Amount::Absolute(tolerance)) => tolerance,
            Some(Amount::Relative(fraction)) => fraction * given.value.abs(),
            None => self.reader.half_digit(given.cell)?,
        };
        Ok(Some(Subtotal { mass: given.value, tolerance }))
    }

    fn configurations(&self, cells: &Cells<'_, 'a>) -> Result<Vec<String>, FormatError> {
        let (Some(text), Some(cell)) = (self.reader.label(cells, CONFIGURATION)?, cells.cell(CONFIGURATION))
        else {
            return Ok(Vec::new());
        };
        let mut names: Vec<String> = Vec::new();
        for name in text.split([',', ';']).map(str::trim) {
            if name.is_empty() || names.iter().any(|other| other == name) {
                return Err(self
                    .reader
                    .invalid(cell, "names of configurations, each once, separated by commas"));
            }
            if let Some(known) = &self.plan.configurations
                && !known.iter().any(|other| other == name)
            {
                let error = self.reader.invalid(cell, format!("one of {}", known.join(", ")));
                let near = polhode_source::nearest(name, known.iter().map(String::as_str));
                return Err(match near {
                    Some(near) => error.with_hint(format!("did you mean {near}?")),
                    None => error.with_hint("the header lists them all: configurations = [...]"),
                });
            }
            names.push(name.to_owned());
        }
        Ok(names)
    }
}
