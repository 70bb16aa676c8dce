//! Random bodies, drawn from the errors of a list.

use polhode::body::MassProperties;
use polhode::infer::random::Random;
use polhode::math::{Body, Direction, Part};

use crate::budget::{Budget, PlacedPart};
use crate::draw::mass_sd;
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::row::CopyErrors;
use crate::subtrees::combined;
use crate::tensor::scaled;
use crate::tree::row_name;
use crate::uncertainty::{Factor, NONE, NUMBERS, RowError};

/// Least number of draws for a meaningful standard deviation.
const LEAST: usize = 10;

/// Largest number of drawn rows: draws times uncertain rows. A million take about half a second.
pub const MOST_DRAWN_ROWS: u64 = 10_000_000_000;

/// Random bodies, each made of physically possible parts.
///
/// Masses are log-normal. Centres of mass, positions and rotation vectors are normal. Their means
/// and standard deviations are those that the list states. Tensors are normal; an impossible tensor
/// is replaced by the nearest possible one. Amounts and densities of liquids are log-normal; a tank
/// that would overflow is full. If errors are correlated, the normal variables from which they are
/// computed are correlated.
#[derive(Clone, Debug, PartialEq)]
pub struct Draws {
    /// Body of each draw.
    pub bodies: Vec<MassProperties<Body>>,
    /// Number of draws in which some part had to be moved to be possible. Without this step, the
    /// bodies would contain parts that cannot exist, or tanks that overflow.
    pub moved: usize,
}

/// Row whose errors, or those of its descendants, change the whole.
struct Varied {
    factors: Vec<Factor>,
    mass_sd: f64,
    /// Own part of the row, if it has errors.
    part: Option<PlacedPart>,
    /// Exact contents of the row: descendants that do not vary, and its own part if that does not
    /// vary.
    fixed: Option<MassProperties<Part>>,
}

/// Rows that vary, each before its parent.
struct VariedRows {
    rows: Vec<u32>,
    /// Exact contents of rows with children, by slot.
    fixed: Vec<Option<MassProperties<Part>>>,
    /// Prepared rows. Empty for long lists, whose rows are prepared again in each draw.
    ready: Vec<Varied>,
}

/// Largest number of rows that are kept prepared: about 10 MB, or up to 30 MB if all numbers have
/// errors.
const MOST_READY: usize = 10_000;

impl Budget {
    /// Draws `count` bodies. The same seed gives the same bodies, and more draws extend the same
    /// sequence.
    ///
    /// # Errors
    /// [`BudgetError::Draws`] for fewer than ten draws; [`BudgetError::TooManyDraws`] beyond
    /// [`MOST_DRAWN_ROWS`]; [`BudgetError::Part`] if errors are so large that a part is not finite.
    pub fn draws(&self, basis: Basis, seed: u64, count: usize) -> Result<Draws, BudgetError> {
        self.draws_watched(basis, seed, count, &mut |_| ())
    }

    /// Draws as [`Budget::draws`] does, and calls `reached` after each body with the number of
    /// bodies so far.
    ///
    /// # Errors
    /// Same as [`Budget::draws`].
    pub fn draws_watched(
        &self,
        basis: Basis,
        seed: u64,
        count: usize,
        reached: &mut dyn FnMut(usize),
    ) -> Result<Draws, BudgetError> {
        if count < LEAST {
            return Err(BudgetError::Draws { given: count, needed: LEAST });
        }
        let Some(varied) = self.varied(basis)? else {
            let bodies = vec![self.mass_properties(basis)?; count];
            return Ok(Draws { bodies, moved: 0 });
        };
        let rows = varied.rows.len();
        let most = usize::try_from(MOST_DRAWN_ROWS / rows.max(1) as u64).unwrap_or(usize::MAX);
        if count > most {
            return Err(BudgetError::TooManyDraws { given: count, rows, most });
        }
        let mut inside: Vec<Vec<MassProperties<Part>>> = vec![Vec::new(); self.tree.inner];
        let (mut bodies, mut moved) = (Vec::with_capacity(count), 0);
        for draw in 0..count {
            let (body, changed) = self.drawn(basis, &varied, &mut inside, seed, draw)?;
            bodies.push(body);
            moved += usize::from(changed);
            reached(bodies.len());
        }
        Ok(Draws { bodies, moved })
    }

    fn drawn(
        &self,
        basis: Basis,
        varied: &VariedRows,
        inside: &mut [Vec<MassProperties<Part>>],
        seed: u64,
        draw: usize,
    ) -> Result<(MassProperties<Body>, bool), BudgetError> {
        let shared: Vec<[f64; NUMBERS]> = (0..self.groups.len())
            .map(|group| {
                let mut random = Random::new(seed, draw, !(group as u64));
                core::array::from_fn(|_| random.normal())
            })
            .collect();
        let (mut moved, mut whole) = (false, Vec::new());
        for (number, &k) in varied.rows.iter().enumerate() {
            let k = k as usize;
            let made;
            let row = match varied.ready.get(number) {
                Some(row) => row,
                None => {
                    made = self.prepared(k, basis, &varied.fixed)?;
                    &made
                }
            };
            let impossible = |error| BudgetError::Part { row: row_name(&self.rows, k), error };
            let overflow = || BudgetError::Value {
                row: row_name(&self.rows, k),
                what: "the rotation",
                value: f64::INFINITY,
                rule: "finite in every draw",
            };
            let mut random = Random::new(seed, draw, k as u64);
            let slot = self.tree.slot(k).and_then(|slot| inside.get_mut(slot));
            let mut unmoved = slot.map(core::mem::take).unwrap_or_default();
            unmoved.extend(row.fixed);
            let quantity = self.rows.quantity(k);
            let (draws, copies) = match quantity.errors {
                CopyErrors::Alike => (1, f64::from(quantity.count)),
                CopyErrors::Independent => (quantity.count, 1.0),
            };
            let parent = self.tree.parent(k).and_then(|parent| self.tree.slot(parent));
            for copy in 1..=draws {
                let error = self.error(k, &row.factors, &shared, &mut random);
                let mut all = if copy == draws { core::mem::take(&mut unmoved) } else { unmoved.clone() };
                if let Some(part) = &row.part {
                    let (drawn, changed) = part
                        .drawn(row.mass_sd, self.rows.liquid(k), self.rows.tensor_follows_mass(k), &error)
                        .map_err(impossible)?;
                    if let Some(drawn) = drawn {
                        all.push(scaled(&drawn, self.factor(k, basis)).map_err(impossible)?);
                    }
                    moved |= changed;
                }
                let Some(one) = combined(&all).map_err(BudgetError::Sum)? else { continue };
                let copy = scaled(&one, copies).map_err(BudgetError::Sum)?;
                let (position, rotation) = self.rows.place(k).drawn(&error).ok_or_else(overflow)?;
                let copy: MassProperties<Part> = copy.placed(position, rotation).map_err(impossible)?;
                match parent.and_then(|parent| inside.get_mut(parent)) {
                    Some(inside) => inside.push(copy),
                    // The root's parent is the body.
                    None => whole.push(copy),
                }
            }
        }
        let whole = combined(&whole).map_err(BudgetError::Sum)?.ok_or(BudgetError::Empty)?;
        Ok((whole.into_body(), moved))
    }

    /// Draws the error of a row. The variable of each factor is the sum of √ρ times that of the
    /// group and √(1 − ρ) times that of the row.
    fn error(
        &self,
        k: usize,
        factors: &[Factor],
        shared: &[[f64; NUMBERS]],
        random: &mut Random,
    ) -> RowError {
        let mut error = NONE;
        let group = self.group(k);
        for factor in factors {
            let rho = group.map_or(0.0, |group| self.groups[group].correlation(factor.kind()));
            let common = group.map_or(0.0, |group| shared[group][factor.number]);
            let z = rho.sqrt() * common + (1.0 - rho).sqrt() * random.normal();
            error.add(&factor.error, z);
        }
        error
    }

    /// Prepares a row for the draws.
    fn prepared(
        &self,
        k: usize,
        basis: Basis,
        fixed: &[Option<MassProperties<Part>>],
    ) -> Result<Varied, BudgetError> {
        let mut factors = self.factors(k);
        factors.shrink_to_fit();
        let is_drawn = factors.iter().any(of_part);
        let part = if is_drawn { self.placed_part(k)? } else { None };
        let fixed = match self.tree.slot(k) {
            Some(slot) => fixed.get(slot).copied().flatten(),
            None if is_drawn => None,
            None => self.fixed_part(k, basis)?,
        };
        Ok(Varied { mass_sd: mass_sd(&factors), factors, part, fixed })
    }

    /// Returns the nominal part of a row on a basis, in its own frame.
    fn fixed_part(&self, k: usize, basis: Basis) -> Result<Option<MassProperties<Part>>, BudgetError> {
        let Some(part) = self.placed_part(k)? else { return Ok(None) };
        let part = scaled(&part.properties, self.factor(k, basis));
        part.map(Some).map_err(|error| BudgetError::Part { row: row_name(&self.rows, k), error })
    }

    /// Returns the rows that vary, or `None` if none does.
    fn varied(&self, basis: Basis) -> Result<Option<VariedRows>, BudgetError> {
        let mut varies: Vec<bool> = (0..self.rows.len()).map(|k| !self.factors(k).is_empty()).collect();
        for k in self.tree.order().rev() {
            if let Some(parent) = self.tree.parent(k) {
                varies[parent] |= varies[k];
            }
        }
        if !varies[self.root()] {
            return Ok(None);
        }
        let mut inside: Vec<Vec<MassProperties<Part>>> = vec![Vec::new(); self.tree.inner];
        let mut all = VariedRows { rows: Vec::new(), fixed: vec![None; self.tree.inner], ready: Vec::new() };
        for k in self.tree.order().rev() {
            let slot = self.tree.slot(k);
            if varies[k] {
                all.rows.push(k as u32); // row indices fit in `u32`: see `Tree`
            }
            if varies[k] && slot.is_none() {
                continue;
            }
            let mut parts = slot.map(|slot| core::mem::take(&mut inside[slot])).unwrap_or_default();
            if !self.factors(k).iter().any(of_part) {
                parts.extend(self.fixed_part(k, basis)?);
            }
            let fixed = combined(&parts).map_err(BudgetError::Sum)?;
            let parent = self.tree.parent(k).and_then(|parent| self.tree.slot(parent));
            if varies[k] {
                slot.into_iter().for_each(|slot| all.fixed[slot] = fixed);
            } else if let (Some(one), Some(parent)) = (fixed, parent) {
                let impossible = |error| BudgetError::Part { row: row_name(&self.rows, k), error };
                let copies =
                    scaled(&one, f64::from(self.rows.quantity(k).count)).map_err(BudgetError::Sum)?;
                let place = self.rows.place(k);
                inside[parent].push(copies.placed(place.position, place.rotation).map_err(impossible)?);
            }
        }
        if all.rows.len() <= MOST_READY {
            let ready = all.rows.iter().map(|&k| self.prepared(k as usize, basis, &all.fixed));
            all.ready = ready.collect::<Result<_, _>>()?;
        }
        Ok(Some(all))
    }
}

/// Returns true if an error belongs to the part, not to its frame.
fn of_part(factor: &Factor) -> bool {
    !factor.kind().is_of_frame()
}

impl Draws {
    /// Returns the angle between a principal axis, 0 to 2, and a direction for each body, 0 to π/2
    /// rad. Both senses of the axis count. Returns `None` if the direction is zero or not finite.
    pub fn tilts(&self, axis: usize, from: Direction<Body>) -> Option<Vec<f64>> {
        let from = from.direction()?;
        let tilt = |body: &MassProperties<Body>| {
            let angle = body.principal().axis(axis % 3).angle_to(from);
            angle.min(core::f64::consts::PI - angle)
        };
        Some(self.bodies.iter().map(tilt).collect())
    }
}
