//! Bodies that the errors of a list allow, at random.

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Body, Direction, Part, Position, Rotation};

use crate::budget::{Budget, combined};
use crate::draw::mass_sd;
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::random::Random;
use crate::row::CopyErrors;
use crate::tensor::scaled;
use crate::tree::row_name;
use crate::uncertainty::{Factor, NUMBERS, RowError};

/// The least number of draws of which a standard deviation says anything.
const LEAST: usize = 10;

/// Whole bodies, each made of possible parts.
///
/// Masses are log-normal, centres, positions and rotation vectors normal, with the means and standard deviations that the list states; tensors are normal, and where no body
/// could have that, the nearest that one could. Amounts and densities of liquids are log-normal; where there would be more than a tank holds, it is full. Of correlated errors the normal variables behind these are correlated.
#[derive(Clone, Debug, PartialEq)]
pub struct Draws {
    /// One of each draw.
    pub bodies: Vec<MassProperties<Body>>,
    /// Of how many draws some part had to be moved to be possible: bodies that a draw of the numbers alone would have made of parts that cannot exist, or of tanks that hold less.
    pub moved: usize,
}

/// A row whose errors, or those of what stands in it, change the whole.
struct Varied {
    row: usize,
    factors: Vec<Factor>,
    mass_sd: f64,
    /// What stands in it and never changes, its own part too if that does not.
    fixed: Option<MassProperties<Part>>,
}

impl Budget {
    /// So many bodies. The same seed gives the same ones, and more draws go on where fewer end.
    ///
    /// # Errors
    /// [`BudgetError::Draws`] of fewer than ten; [`BudgetError::Part`] where errors are so large that a part is not finite.
    pub fn draws(&self, basis: Basis, seed: u64, count: usize) -> Result<Draws, BudgetError> {
        if count < LEAST {
            return Err(BudgetError::Draws { given: count, needed: LEAST });
        }
        let (varied, fixed) = self.varied(basis)?;
        let mut inside: Vec<Vec<MassProperties<Part>>> = vec![Vec::new(); self.places.len()];
        let (mut bodies, mut moved) = (Vec::with_capacity(count), 0);
        for draw in 0..count {
            if let Some(body) = fixed {
                bodies.push(body);
                continue;
            }
            let (body, changed) = self.drawn(basis, &varied, &mut inside, seed, draw)?;
            bodies.push(body);
            moved += usize::from(changed);
        }
        Ok(Draws { bodies, moved })
    }

    fn drawn(
        &self,
        basis: Basis,
        varied: &[Varied],
        inside: &mut [Vec<MassProperties<Part>>],
        seed: u64,
        draw: usize,
    ) -> Result<(MassProperties<Body>, bool), BudgetError> {
        let shared: Vec<[f64; NUMBERS]> = (0..self.list.groups.len())
            .map(|group| {
                let mut random = Random::new(seed, draw, !(group as u64));
                core::array::from_fn(|_| random.normal())
            })
            .collect();
        let mut moved = false;
        for Varied { row: k, factors, mass_sd, fixed } in varied {
            let (row, place) = (&self.list.rows[*k], &self.places[*k]);
            let impossible = |error| BudgetError::Part { row: row_name(&self.list.rows, *k), error };
            let overflow = || BudgetError::Value {
                row: row_name(&self.list.rows, *k),
                what: "the rotation",
                value: f64::INFINITY,
                rule: "finite in every draw",
            };
            let mut random = Random::new(seed, draw, *k as u64);
            let mut unmoved = core::mem::take(&mut inside[*k]);
            unmoved.extend(*fixed);
            let (draws, copies) = match row.quantity.errors {
                CopyErrors::Alike => (1, f64::from(row.quantity.count)),
                CopyErrors::Independent => (row.quantity.count, 1.0),
            };
            for _ in 0..draws {
                let error = self.error(*k, factors, &shared, &mut random);
                let mut all = unmoved.clone();
                if let Some(part) = place.part.as_ref().filter(|_| factors.iter().any(of_part)) {
                    let (drawn, changed) = part.drawn(row, *mass_sd, &error).map_err(impossible)?;
                    if let Some(drawn) = drawn {
                        all.push(scaled(&drawn, place.scale(basis)).map_err(impossible)?);
                    }
                    moved |= changed;
                }
                let Some(one) = combined(&all).map_err(BudgetError::Sum)? else { continue };
                let copy = scaled(&one, copies).map_err(BudgetError::Sum)?;
                let frame = row.place.drawn(&error).ok_or_else(overflow)?;
                // The root's parent is the body.
                let parent = self.tree.parents[*k].unwrap_or(*k);
                inside[parent].push(placed(&copy, frame).map_err(impossible)?);
            }
        }
        let whole = core::mem::take(&mut inside[self.root()]);
        let whole = combined(&whole).map_err(BudgetError::Sum)?.ok_or(BudgetError::Empty)?;
        Ok((whole.into_body(), moved))
    }

    /// An error of a row: of each factor's variable, √ρ of it are its group's.
    fn error(
        &self,
        k: usize,
        factors: &[Factor],
        shared: &[[f64; NUMBERS]],
        random: &mut Random,
    ) -> RowError {
        let mut error = RowError::default();
        for factor in factors {
            let group = self.places[k].group;
            let rho = group.map_or(0.0, |group| self.list.groups[group].correlation(factor.kind()));
            let common = group.map_or(0.0, |group| shared[group][factor.number]);
            let z = rho.sqrt() * common + (1.0 - rho).sqrt() * random.normal();
            error.add(&factor.error, z);
        }
        error
    }

    /// Rows that vary, each before that in which it stands; or the whole, if none does.
    #[allow(clippy::type_complexity, reason = "either is empty")]
    fn varied(&self, basis: Basis) -> Result<(Vec<Varied>, Option<MassProperties<Body>>), BudgetError> {
        let rows = &self.list.rows;
        let factors: Vec<Vec<Factor>> = rows.iter().map(|row| row.factors().unwrap_or_default()).collect();
        let mut varies: Vec<bool> = factors.iter().map(|factors| !factors.is_empty()).collect();
        for &k in self.tree.order.iter().rev() {
            if let Some(parent) = self.tree.parents[k] {
                varies[parent] |= varies[k];
            }
        }
        if !varies[self.root()] {
            return Ok((Vec::new(), Some(self.mass_properties(basis)?)));
        }
        let mut inside: Vec<Vec<MassProperties<Part>>> = vec![Vec::new(); rows.len()];
        let mut all = Vec::new();
        for (&k, factors) in self.tree.order.iter().rev().map(|k| (k, &factors[*k])) {
            let impossible = |error| BudgetError::Part { row: row_name(rows, k), error };
            let mut parts = core::mem::take(&mut inside[k]);
            if let Some(part) = self.places[k].part.as_ref().filter(|_| !factors.iter().any(of_part)) {
                parts.push(scaled(&part.properties, self.places[k].scale(basis)).map_err(impossible)?);
            }
            let fixed = combined(&parts).map_err(BudgetError::Sum)?;
            if varies[k] {
                all.push(Varied { row: k, mass_sd: mass_sd(factors), factors: factors.clone(), fixed });
            } else if let (Some(one), Some(parent)) = (fixed, self.tree.parents[k]) {
                let copies = scaled(&one, f64::from(rows[k].quantity.count)).map_err(BudgetError::Sum)?;
                let place = (rows[k].place.position, rows[k].place.rotation);
                inside[parent].push(placed(&copies, place).map_err(impossible)?);
            }
        }
        Ok((all, None))
    }
}

/// Whether an error is of the part, and not of its frame.
fn of_part(factor: &Factor) -> bool {
    !factor.kind().is_of_frame()
}

fn placed(
    body: &MassProperties<Part>,
    (position, rotation): (Position<Part>, Rotation<Part, Part>),
) -> Result<MassProperties<Part>, BodyError> {
    body.placed(position, rotation)
}

impl Draws {
    /// The angle of a principal axis, 0 to 2, either way along it, from a direction, of each body: from 0 to π/2 rad. `None` if the direction is zero or not finite.
    pub fn tilts(&self, axis: usize, from: Direction<Body>) -> Option<Vec<f64>> {
        let from = from.direction()?;
        let tilt = |body: &MassProperties<Body>| {
            let angle = body.principal().axis(axis % 3).angle_to(from);
            angle.min(core::f64::consts::PI - angle)
        };
        Some(self.bodies.iter().map(tilt).collect())
    }
}
