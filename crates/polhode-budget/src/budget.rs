//! Parts lists that make one body.

use std::collections::HashMap;

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Body, Frame, Part, Position, Rotation};

use crate::error::{BudgetError, RowName};
use crate::group::Group;
use crate::growth::{Basis, Growth, GrowthTable, MassStatement, RULE};
use crate::row::{CopyErrors, Place, Row};
use crate::tensor::{TensorPoint, mass_properties, scaled};
use crate::tree::{Tree, names, row_name};
use crate::uncertainty::{Factor, NotUncertainty, PartUncertainty};

/// A parts list, as it is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartsList {
    /// In any order.
    pub rows: Vec<Row>,
    /// The groups that rows name.
    pub groups: Vec<Group>,
    /// Growth allowances by maturity code.
    pub growth: GrowthTable,
}

/// A parts list of which all rows make one possible body.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    pub(crate) list: PartsList,
    pub(crate) tree: Tree,
    /// Of each row.
    pub(crate) places: Vec<Placed>,
}

/// What a row comes to by where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placed {
    /// Of its frame's origin in the body.
    pub(crate) position: Position<Body>,
    pub(crate) rotation: Rotation<Body, Part>,
    /// How many of the row in which it stands there are in the body.
    pub(crate) frames: f64,
    /// By what its part's mass is multiplied on the predicted basis.
    pub(crate) growth: f64,
    pub(crate) group: Option<usize>,
    pub(crate) part: Option<PlacedPart>,
}

/// A part that can exist, in its row's frame.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlacedPart {
    pub(crate) properties: MassProperties<Part>,
    /// The elements of the tensor as given, and the point that they are about, if that is not the centre of mass.
    pub(crate) elements: [f64; 6],
    pub(crate) about: Option<Position<Part>>,
}

impl PartsList {
    /// Whether the list makes a body.
    ///
    /// # Errors
    /// [`BudgetError`] that names the row and what is wrong with it.
    pub fn budget(self) -> Result<Budget, BudgetError> {
        let names = names(&self.rows)?;
        let tree = Tree::new(&self.rows, &names)?;
        let mut groups = HashMap::with_capacity(self.groups.len());
        for (k, group) in self.groups.iter().enumerate() {
            group.check()?;
            if groups.insert(group.name.as_str(), k).is_some() {
                return Err(BudgetError::DuplicateGroup { group: group.name.clone() });
            }
        }
        let mut places: Vec<Option<Placed>> = vec![None; self.rows.len()];
        for &k in &tree.order {
            let parent = tree.parents[k].and_then(|parent| Some((parent, places[parent].as_ref()?)));
            let placed = self.placed(k, parent, &groups)?;
            places[k] = Some(placed);
        }
        let mut places: Vec<Placed> = places.into_iter().flatten().collect();
        for k in 0..places.len() {
            places[k].part = self.part(k, &places, &names)?;
        }
        if places.iter().all(|place| place.part.is_none()) {
            return Err(BudgetError::Empty);
        }
        let budget = Budget { list: self, tree, places };
        budget.check()?;
        Ok(budget)
    }

    fn placed(
        &self,
        k: usize,
        parent: Option<(usize, &Placed)>,
        groups: &HashMap<&str, usize>,
    ) -> Result<Placed, BudgetError> {
        let row = &self.rows[k];
        let name = || row_name(&self.rows, k);
        let require = |what, value: f64, holds: bool, rule| {
            if holds { Ok(()) } else { Err(BudgetError::Value { row: name(), what, value, rule }) }
        };
        for value in row.place.position.to_array() {
            require("the position", value, value.is_finite(), "finite")?;
        }
        require("the quantity", f64::from(row.quantity.count), row.quantity.count > 0, "1 at least")?;
        let growth = match &row.growth {
            Growth::None => 0.0,
            Growth::Fraction(value) => *value,
            Growth::Code(code) => self
                .growth
                .get(code)
                .ok_or_else(|| BudgetError::MaturityCode { row: name(), code: code.clone() })?,
        };
        require("the growth allowance", growth, growth >= 0.0 && growth.is_finite(), RULE)?;
        let what = "the allowable mass";
        if let Some(value) = row.allowable {
            require(what, value, value > 0.0 && value.is_finite(), "positive and finite")?;
        }
        let group = match &row.group {
            None => None,
            Some(group) => Some(
                *groups
                    .get(group.as_str())
                    .ok_or_else(|| BudgetError::MissingGroup { row: name(), group: group.clone() })?,
            ),
        };
        row.factors().map_err(|error| error.of(name()))?;
        let Place { position, rotation } = row.place;
        Ok(match parent {
            None => Placed {
                position: Rotation::<Body, Part>::identity() * position,
                rotation: Rotation::<Body, Part>::identity() * rotation,
                frames: 1.0,
                growth: 1.0 + growth,
                group,
                part: None,
            },
            Some((parent, frame)) => Placed {
                position: frame.position + frame.rotation * position,
                rotation: frame.rotation * rotation,
                frames: frame.frames * f64::from(self.rows[parent].quantity.count),
                growth: 1.0 + growth,
                group,
                part: None,
            },
        })
    }

    fn part(
        &self,
        k: usize,
        places: &[Placed],
        names: &HashMap<&str, usize>,
    ) -> Result<Option<PlacedPart>, BudgetError> {
        let Some(part) = &self.rows[k].part else { return Ok(None) };
        let name = || row_name(&self.rows, k);
        let about = match &part.tensor.about {
            TensorPoint::CenterOfMass => None,
            TensorPoint::At(point) => Some(*point),
            TensorPoint::OriginOf(frame) => {
                let other = names.get(frame.as_str()).map(|&other| &places[other]);
                let other =
                    other.ok_or_else(|| BudgetError::MissingFrame { row: name(), frame: frame.clone() })?;
                Some(places[k].rotation.inverse() * (other.position - places[k].position))
            }
        };
        let elements = part.tensor.elements();
        let properties = mass_properties(part.mass, part.center_of_mass, elements, about)
            .map_err(|error| BudgetError::Part { row: name(), error })?;
        if let PartUncertainty::Liquid(liquid) = &self.rows[k].uncertainty.part
            && !liquid.is(&properties)
        {
            return Err(BudgetError::NotTheLiquid { row: name() });
        }
        Ok(Some(PlacedPart { properties, elements, about }))
    }
}

impl Row {
    /// Its errors as independent ones, of the tensor's elements.
    pub(crate) fn factors(&self) -> Result<Vec<Factor>, NotUncertainty> {
        let sign = self.part.as_ref().map_or(1.0, |part| part.tensor.sign.factor());
        let mut all = self.uncertainty.factors(sign)?;
        if self.part.is_none() {
            all.retain(|factor| factor.kind().is_of_frame());
        }
        Ok(all)
    }
}

impl NotUncertainty {
    fn of(self, row: RowName) -> BudgetError {
        match self {
            Self::Deviation { what, value } => BudgetError::Deviation { row, what, value },
            Self::Covariance { what, element } => BudgetError::Covariance { row, what, element },
        }
    }
}

impl Budget {
    /// The list that it was made of.
    pub const fn list(&self) -> &PartsList {
        &self.list
    }

    /// The row in which all others stand.
    pub fn root(&self) -> usize {
        self.tree.order[0]
    }

    /// In which row each row stands; the root in none.
    pub fn parents(&self) -> &[Option<usize>] {
        &self.tree.parents
    }

    /// One copy of a row's part, in its own frame; `None` of a frame alone, and of a row that is not there.
    pub fn given(&self, row: usize) -> Option<&MassProperties<Part>> {
        self.places.get(row)?.part.as_ref().map(|part| &part.properties)
    }

    /// The growth allowance of a row's part, as a fraction of its basic mass; zero of a row that is not there.
    pub fn growth(&self, row: usize) -> f64 {
        self.places.get(row).map_or(0.0, |place| place.growth - 1.0)
    }

    /// The mass properties of the whole, along the axes of the body, in which the root's frame stands.
    ///
    /// # Errors
    /// [`BudgetError::Sum`] if it overflows.
    pub fn mass_properties(&self, basis: Basis) -> Result<MassProperties<Body>, BudgetError> {
        self.whole(&self.subtrees(basis)?)
    }

    /// The masses of each row with all in it: of its copies in one of the row in which it stands.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
    pub fn mass_statements(&self) -> Result<Vec<MassStatement>, BudgetError> {
        let (basic, predicted) = (self.subtrees(Basis::Basic)?, self.subtrees(Basis::Predicted)?);
        let mass = |one: &Option<MassProperties<Body>>, row: &Row| {
            one.map_or(0.0, |one| one.mass() * f64::from(row.quantity.count))
        };
        let of = |((basic, predicted), row): ((_, _), &Row)| MassStatement {
            basic: mass(basic, row),
            predicted: mass(predicted, row),
            allowable: row.allowable,
        };
        Ok(basic.iter().zip(&predicted).zip(&self.list.rows).map(of).collect())
    }

    fn check(&self) -> Result<(), BudgetError> {
        for (k, row) in self.list.rows.iter().enumerate() {
            let given = row.quantity.count;
            let is_drawn = row.quantity.errors == CopyErrors::Independent
                && given > MOST_DRAWN
                && row.factors().is_ok_and(|factors| !factors.is_empty());
            if is_drawn {
                return Err(BudgetError::Copies {
                    row: row_name(&self.list.rows, k),
                    given,
                    most: MOST_DRAWN,
                });
            }
        }
        for (child, parent) in self.tree.parents.iter().enumerate() {
            if let Some(parent) = *parent
                && self.list.rows[parent].quantity.errors == CopyErrors::Independent
                && self.list.rows[parent].quantity.count > 1
            {
                let [row, inside] = [parent, child].map(|k| row_name(&self.list.rows, k));
                return Err(BudgetError::IndependentAssembly { row, inside });
            }
        }
        if self.list.rows.iter().all(|row| row.subtotal.is_none()) {
            return Ok(());
        }
        let statements = self.mass_statements()?;
        for (k, (row, statement)) in self.list.rows.iter().zip(statements).enumerate() {
            let Some(subtotal) = row.subtotal else { continue };
            let (stated, tolerance, sum) = (subtotal.mass, subtotal.tolerance, statement.basic);
            let name = row_name(&self.list.rows, k);
            if !(tolerance >= 0.0 && tolerance.is_finite()) {
                let what = "the subtotal's tolerance";
                return Err(BudgetError::Value {
                    row: name,
                    what,
                    value: tolerance,
                    rule: "zero or positive",
                });
            }
            if !((stated - sum).abs() <= tolerance + ROUNDING * sum) {
                return Err(BudgetError::Subtotal { row: name, stated, sum, tolerance });
            }
        }
        Ok(())
    }

    pub(crate) fn whole(
        &self,
        subtrees: &[Option<MassProperties<Body>>],
    ) -> Result<MassProperties<Body>, BudgetError> {
        let root = self.root();
        let one = subtrees[root].ok_or(BudgetError::Empty)?;
        scaled(&one, f64::from(self.list.rows[root].quantity.count)).map_err(BudgetError::Sum)
    }

    /// A row's part in the body.
    pub(crate) fn own(&self, k: usize, basis: Basis) -> Result<Option<MassProperties<Body>>, BudgetError> {
        let place = &self.places[k];
        let Some(part) = &place.part else { return Ok(None) };
        let placed = part.properties.placed(place.position, place.rotation);
        let part = placed.and_then(|placed| scaled(&placed, place.scale(basis)));
        part.map(Some).map_err(|error| BudgetError::Part { row: row_name(&self.list.rows, k), error })
    }

    /// One copy of the part of each row, without what stands in it, in the body; `None` of frames alone.
    ///
    /// # Errors
    /// [`BudgetError::Part`] if one overflows.
    pub fn parts(&self, basis: Basis) -> Result<Vec<Option<MassProperties<Body>>>, BudgetError> {
        (0..self.places.len()).map(|k| self.own(k, basis)).collect()
    }

    /// One copy of each row with all in it, in the body; `None` of frames without mass.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
    pub fn subtrees(&self, basis: Basis) -> Result<Vec<Option<MassProperties<Body>>>, BudgetError> {
        let mut inside: Vec<Vec<MassProperties<Body>>> = vec![Vec::new(); self.places.len()];
        let mut all = vec![None; self.places.len()];
        for &k in self.tree.order.iter().rev() {
            let mut parts = core::mem::take(&mut inside[k]);
            parts.extend(self.own(k, basis)?);
            all[k] = combined(&parts).map_err(BudgetError::Sum)?;
            if let (Some(one), Some(parent)) = (&all[k], self.tree.parents[k]) {
                let count = f64::from(self.list.rows[k].quantity.count);
                inside[parent].push(scaled(one, count).map_err(BudgetError::Sum)?);
            }
        }
        Ok(all)
    }
}

/// Copies of independent errors that are drawn one by one.
const MOST_DRAWN: u32 = 10_000;

/// The rounding of a sum and of decimal numbers in it.
const ROUNDING: f64 = 1e-12;

impl Placed {
    /// By what the part's mass is multiplied.
    pub(crate) const fn scale(&self, basis: Basis) -> f64 {
        match basis {
            Basis::Basic => 1.0,
            Basis::Predicted => self.growth,
        }
    }
}

/// All of them together, if there are any.
pub(crate) fn combined<F: Frame>(
    parts: &[MassProperties<F>],
) -> Result<Option<MassProperties<F>>, BodyError> {
    match parts {
        [] => Ok(None),
        [one] => Ok(Some(*one)),
        parts => MassProperties::combined(parts).map(Some),
    }
}
