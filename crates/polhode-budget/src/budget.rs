//! Checked parts lists: their rows make one body.

use std::collections::{BTreeMap, HashMap};

use polhode::body::MassProperties;
use polhode::math::{Body, Part, Position, Rotation};

use crate::error::{BudgetError, RowName};
use crate::group::Group;
use crate::growth::{GrowthTable, RULE};
use crate::list::PartsList;
use crate::row::{CopyErrors, Place};
use crate::rows::Rows;
use crate::tensor::{TensorPoint, mass_properties};
use crate::tree::{Tree, names, row_name};
use crate::uncertainty::{Factor, NotUncertainty};

/// Parts list whose rows make one physically possible body.
///
/// Contains the rows in packed form and the frames of rows with children. Everything else is
/// computed when it is needed.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    pub(crate) rows: Rows,
    pub(crate) groups: Vec<Group>,
    growth: GrowthTable,
    pub(crate) tree: Tree,
    /// Frames of rows with children, indexed by [`Tree::slot`].
    frames: Vec<PlacedFrame>,
    /// Index of the group of each row, or [`ALONE`]; empty if the list has no groups.
    group_of: Vec<u32>,
    /// Rows whose tensor is about the origin of another row's frame, with the index of that row.
    origins: BTreeMap<usize, usize>,
}

const ALONE: u32 = u32::MAX;

/// Frame of a row in the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PlacedFrame {
    /// Origin of the frame, body axes, m.
    pub(crate) position: Position<Body>,
    pub(crate) rotation: Rotation<Body, Part>,
    /// Number of copies of the parent in the body: the product of the counts of all ancestors.
    pub(crate) frames: f64,
}

/// Physically possible part, in its row's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PlacedPart {
    pub(crate) properties: MassProperties<Part>,
    /// Elements xx, yy, zz, xy, xz, yz of the tensor as given, kg·m². They are about the point
    /// `about`, or about the centre of mass if that is `None`.
    pub(crate) elements: [f64; 6],
    pub(crate) about: Option<Position<Part>>,
}

impl PartsList {
    /// Checks that the rows of the list make one body.
    ///
    /// # Errors
    /// Same as [`Budget::new`].
    pub fn budget(self) -> Result<Budget, BudgetError> {
        Budget::new(self.rows.into_iter().collect(), self.groups, self.growth)
    }
}

impl Budget {
    /// Checks that rows make one body.
    ///
    /// # Errors
    /// [`BudgetError`] with the row and the rule that it violates.
    pub fn new(rows: Rows, groups: Vec<Group>, growth: GrowthTable) -> Result<Self, BudgetError> {
        let names = names(&rows)?;
        let tree = Tree::new(&rows, &names)?;
        let mut numbers = HashMap::with_capacity(groups.len());
        for (k, group) in (0..).zip(&groups) {
            group.check()?;
            if numbers.insert(group.name.as_str(), k).is_some() {
                return Err(BudgetError::DuplicateGroup { group: group.name.clone() });
            }
        }
        let mut group_of = vec![ALONE; if groups.is_empty() { 0 } else { rows.len() }];
        for k in tree.order() {
            let group = check_row(&rows, k, &numbers, &growth)?;
            if let (Some(slot), Some(group)) = (group_of.get_mut(k), group) {
                *slot = group;
            }
        }
        let origin = |k| Some((k, *names.get(rows.tensor_frame(k)?)? as usize));
        let origins = (0..rows.len()).filter_map(origin).collect();
        drop(names);
        let frames = Vec::with_capacity(tree.inner);
        let mut budget = Self { rows, groups, growth, tree, frames, group_of, origins };
        let inner: Vec<usize> = budget.tree.order().filter(|row| budget.tree.slot(*row).is_some()).collect();
        for row in inner {
            budget.frames.push(budget.frame(row));
        }
        budget.check()?;
        Ok(budget)
    }

    fn check(&self) -> Result<(), BudgetError> {
        let mut is_empty = true;
        for k in 0..self.rows.len() {
            let is_part = self.placed_part(k)?.is_some();
            is_empty &= !is_part;
        }
        if is_empty {
            return Err(BudgetError::Empty);
        }
        let is_independent = |row: usize| self.rows.quantity(row).errors == CopyErrors::Independent;
        for row in (0..self.rows.len()).filter(|row| is_independent(*row)) {
            let given = self.rows.quantity(row).count;
            if given > MOST_DRAWN && !self.factors(row).is_empty() {
                return Err(BudgetError::Copies { row: row_name(&self.rows, row), given, most: MOST_DRAWN });
            }
        }
        for child in 0..self.rows.len() {
            let Some(parent) = self.tree.parent(child) else { continue };
            if is_independent(parent) && self.rows.quantity(parent).count > 1 {
                let [row, inside] = [parent, child].map(|k| row_name(&self.rows, k));
                return Err(BudgetError::IndependentAssembly { row, inside });
            }
        }
        self.check_subtotals()
    }

    fn check_subtotals(&self) -> Result<(), BudgetError> {
        if (0..self.rows.len()).all(|k| self.rows.subtotal(k).is_none()) {
            return Ok(());
        }
        let statements = self.mass_statements()?;
        for (k, statement) in statements.iter().enumerate() {
            let Some(subtotal) = self.rows.subtotal(k) else { continue };
            let (stated, tolerance, sum) = (subtotal.mass, subtotal.tolerance, statement.basic);
            let name = || row_name(&self.rows, k);
            if !(tolerance >= 0.0 && tolerance.is_finite()) {
                let what = "the subtotal's tolerance";
                return Err(BudgetError::Value {
                    row: name(),
                    what,
                    value: tolerance,
                    rule: "zero or positive",
                });
            }
            if !((stated - sum).abs() <= tolerance + ROUNDING * sum) {
                return Err(BudgetError::Subtotal { row: name(), stated, sum, tolerance });
            }
        }
        Ok(())
    }

    /// Returns a copy of the list from which the budget was made.
    #[must_use]
    pub fn list(&self) -> PartsList {
        let (groups, growth) = (self.groups.clone(), self.growth.clone());
        PartsList { rows: self.rows.iter().collect(), groups, growth }
    }

    /// Returns the rows of the list.
    pub const fn rows(&self) -> &Rows {
        &self.rows
    }

    /// Returns the groups of the list.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// Returns the growth allowances by maturity code.
    pub const fn growth_table(&self) -> &GrowthTable {
        &self.growth
    }

    /// Returns the index of the root: the row that contains all others.
    pub fn root(&self) -> usize {
        self.tree.root()
    }

    /// Returns the index of a row's parent, or `None` for the root.
    pub fn parent(&self, row: usize) -> Option<usize> {
        self.tree.parent(row)
    }

    /// Returns true if a row has children.
    pub fn has_rows_in(&self, row: usize) -> bool {
        self.tree.slot(row).is_some()
    }

    /// Returns one copy of a row's own part, in the row's frame. Returns `None` for a frame without
    /// mass, or if `row` is out of range.
    pub fn given(&self, row: usize) -> Option<MassProperties<Part>> {
        self.placed_part(row).ok().flatten().map(|part| part.properties)
    }

    /// Returns the growth allowance of a row's part as a fraction of its basic mass; 0 if `row` is
    /// out of range.
    pub fn growth(&self, row: usize) -> f64 {
        self.scale(row) - 1.0
    }

    /// Returns the ratio of predicted to basic mass of a row's part.
    pub(crate) fn scale(&self, row: usize) -> f64 {
        1.0 + self.rows.allowance(row, &self.growth).unwrap_or(0.0) // checked when the budget was made
    }

    /// Returns the index of a row's group in the list of groups.
    pub(crate) fn group(&self, row: usize) -> Option<usize> {
        self.group_of.get(row).filter(|group| **group != ALONE).map(|group| *group as usize)
    }

    /// Returns the errors of a row as independent factors. Products of inertia are converted to
    /// tensor elements.
    pub(crate) fn factors(&self, row: usize) -> Vec<Factor> {
        factors(&self.rows, row).unwrap_or_default() // checked when the budget was made
    }

    /// Returns the frame of a row in the body.
    pub(crate) fn frame(&self, row: usize) -> PlacedFrame {
        let Place { position, rotation } = self.rows.place(row);
        let parent = self.tree.parent(row);
        let frame = parent.and_then(|parent| self.frames.get(self.tree.slot(parent)?));
        match (parent, frame) {
            (Some(parent), Some(frame)) => PlacedFrame {
                position: frame.position + frame.rotation * position,
                rotation: frame.rotation * rotation,
                frames: frame.frames * f64::from(self.rows.quantity(parent).count),
            },
            _ => PlacedFrame {
                position: Rotation::<Body, Part>::identity() * position,
                rotation: Rotation::<Body, Part>::identity() * rotation,
                frames: 1.0,
            },
        }
    }

    /// Returns the axes of the parent's frame in the body.
    pub(crate) fn axes_around(&self, row: usize) -> Rotation<Body, Part> {
        let slot = self.tree.parent(row).and_then(|parent| self.tree.slot(parent));
        let frame = slot.and_then(|slot| self.frames.get(slot));
        frame.map_or_else(Rotation::identity, |frame| frame.rotation)
    }

    /// Returns the part of a row in the row's frame, or `None` for a frame without mass.
    pub(crate) fn placed_part(&self, row: usize) -> Result<Option<PlacedPart>, BudgetError> {
        let Some(part) = self.rows.part(row) else { return Ok(None) };
        let name = || row_name(&self.rows, row);
        let about = match &part.tensor.about {
            TensorPoint::CenterOfMass => None,
            TensorPoint::At(point) => Some(*point),
            TensorPoint::OriginOf(frame) => {
                let missing = || BudgetError::MissingFrame { row: name(), frame: frame.clone() };
                let other = self.origins.get(&row).copied().ok_or_else(missing)?;
                let (own, other) = (self.frame(row), self.frame(other));
                Some(own.rotation.inverse() * (other.position - own.position))
            }
        };
        let elements = part.tensor.elements();
        let properties = mass_properties(part.mass, part.center_of_mass, elements, about)
            .map_err(|error| BudgetError::Part { row: name(), error })?;
        if self.rows.liquid(row).is_some_and(|liquid| !liquid.is(&properties)) {
            return Err(BudgetError::NotTheLiquid { row: name() });
        }
        Ok(Some(PlacedPart { properties, elements, about }))
    }
}

/// Largest number of copies with independent errors. Such copies are drawn one by one.
const MOST_DRAWN: u32 = 10_000;

/// Relative rounding error of a sum, and of the decimal numbers in it.
const ROUNDING: f64 = 1e-12;

/// Checks the numbers of a row, and returns the index of its group.
fn check_row(
    rows: &Rows,
    k: usize,
    groups: &HashMap<&str, u32>,
    table: &GrowthTable,
) -> Result<Option<u32>, BudgetError> {
    let name = || row_name(rows, k);
    let require = |what, value: f64, holds: bool, rule| {
        if holds { Ok(()) } else { Err(BudgetError::Value { row: name(), what, value, rule }) }
    };
    for value in rows.place(k).position.to_array() {
        require("the position", value, value.is_finite(), "finite")?;
    }
    let count = rows.quantity(k).count;
    require("the quantity", f64::from(count), count > 0, "at least 1")?;
    let growth = rows
        .allowance(k, table)
        .map_err(|code| BudgetError::MaturityCode { row: name(), code: code.to_owned() })?;
    require("the growth allowance", growth, growth >= 0.0 && growth.is_finite(), RULE)?;
    if let Some(value) = rows.allowable(k) {
        require("the allowable mass", value, value > 0.0 && value.is_finite(), "positive and finite")?;
    }
    let missing = |group: &str| BudgetError::MissingGroup { row: name(), group: group.to_owned() };
    let number = |group| groups.get(group).copied().ok_or_else(|| missing(group));
    let group = rows.group(k).map(number).transpose()?;
    factors(rows, k).map_err(|error| error.of(name()))?;
    Ok(group)
}

fn factors(rows: &Rows, row: usize) -> Result<Vec<Factor>, NotUncertainty> {
    if rows.is_exact(row) {
        return Ok(Vec::new());
    }
    let sign = if rows.has_part(row) { rows.sign(row).factor() } else { 1.0 };
    let mut all = rows.uncertainty(row).factors(sign)?;
    if !rows.has_part(row) {
        all.retain(|factor| factor.kind().is_of_frame());
    }
    Ok(all)
}

impl NotUncertainty {
    fn of(self, row: RowName) -> BudgetError {
        match self {
            Self::Deviation { what, value } => BudgetError::Deviation { row, what, value },
            Self::Covariance { what, element } => BudgetError::Covariance { row, what, element },
        }
    }
}
