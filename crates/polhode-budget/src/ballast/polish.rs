//! Few pieces that meet all limits to rounding, from many that nearly do.

use super::interval::Interval;
use super::linear::{inner, null_vector, solved};
use super::problem::{Column, Problem};
use super::relaxation::Work;
use super::row::{Coordinate, Functional, Kind, Moments, Product, weights};
use super::sums::Pieces;
use crate::growth::Basis;

/// Masses below this part of all ballast are none.
const NOTHING: f64 = 1e-9;

/// Limits that are nearer than this part of their size to being broken are kept exactly.
const ACTIVE: f64 = 1e-6;

/// By how much of its own size, and by how many roundings of what it is the difference of, a limit is kept inside.
const INSIDE: (f64, f64) = (1e-13, 4.0 * f64::EPSILON);

/// By how much of the same a limit may be broken.
const BROKEN: (f64, f64) = (1e-11, 16.0 * f64::EPSILON);

/// How near a piece is to its site, as a part of its coordinates and of the site.
const AT: f64 = 1e-12;

/// Pieces nearer than this part of a site's size are one, if that will do: programs with pieces end with some on each side of the best place.
const NEAR: f64 = 1e-2;

/// Masses below this part of all ballast are left out, if that will do.
const FEW: f64 = 1e-6;

/// By how much ballast of fewer pieces may be heavier.
const HEAVIER: f64 = 2e-10;

/// What a limit comes to.
struct State {
    /// At least zero, or zero.
    value: f64,
    is_zero: bool,
    /// How the moments change it.
    slope: Functional,
    /// Size of its terms, and of what they are the difference of.
    size: (f64, f64),
}

/// What may be changed of a piece: its mass, or its place along a direction.
struct Freedom {
    piece: usize,
    along: Option<[f64; 3]>,
}

impl Problem {
    /// Few pieces by which all limits are met, for a price of pieces where they are; `None` if they are not met.
    pub(super) fn polished(
        &self,
        pieces: &[(Column, f64)],
        price: Option<&Functional>,
        work: &mut Work,
    ) -> Option<Vec<(Column, f64)>> {
        let total: f64 = pieces.iter().map(|(_, mass)| mass).sum();
        let mut pieces: Vec<_> = pieces.iter().copied().filter(|(_, mass)| *mass > NOTHING * total).collect();
        self.reduce(&mut pieces);
        let few = self.merged(&pieces, FEW * total);
        let settled = price.map(|price| self.settled(&few, price));
        let moves = few.iter().any(|(column, _)| self.has_free_pieces(column.site));
        // The fewest that are as light as any.
        let mut best = self.corrected(pieces);
        let more = [Some(few.clone()), settled].into_iter().flatten().map(|few| self.corrected(few));
        for few in more.flatten() {
            let allowed = best.as_ref().map_or(f64::INFINITY, |best| mass(best) * (1.0 + HEAVIER));
            if mass(&few) <= allowed {
                best = Some(few);
            }
        }
        if best.is_none() && moves {
            let spread = self.spread(&few);
            best = self.corrected(spread.clone());
            for pieces in [few, spread] {
                best = best.or_else(|| self.moved(&pieces, work).and_then(|few| self.corrected(few)));
            }
        }
        best
    }

    pub(super) fn corrected(&self, mut pieces: Vec<(Column, f64)>) -> Option<Vec<(Column, f64)>> {
        for (column, mass) in &mut pieces {
            if self.charts[column.site].is_point()
                && let Some(sums) = &self.sums[column.site]
            {
                *mass = sums.near(*mass, [0, sums.len() - 1]);
            }
        }
        let with = |active: f64| {
            let mut pieces = pieces.clone();
            for _ in 0..6 {
                self.correct(&mut pieces, active)?;
            }
            pieces.retain(|(_, mass)| *mass > 0.0);
            self.is_met(&pieces).then_some(pieces)
        };
        // Of limits that are near, more may be kept exactly than can be: then those that are broken.
        with(ACTIVE).or_else(|| with(0.0))
    }

    /// Pieces that are near each other become one at their centre of mass; those of less than a mass are left out.
    fn merged(&self, pieces: &[(Column, f64)], least: f64) -> Vec<(Column, f64)> {
        let mut merged: Vec<(Column, f64)> = Vec::with_capacity(pieces.len());
        for (column, mass) in pieces {
            let chart = &self.charts[column.site];
            if self.has_free_pieces(column.site) {
                merged.push((*column, *mass));
                continue;
            }
            let same = merged
                .iter_mut()
                .find(|(other, _)| other.site == column.site && chart.are_near(other.at, column.at, NEAR));
            match same {
                None => merged.push((*column, *mass)),
                Some((other, sum)) => {
                    let share = mass / (*sum + mass);
                    let between =
                        core::array::from_fn(|k| other.at[k] + share * (column.at[k] - other.at[k]));
                    other.at = chart.nearest(between);
                    *sum += mass;
                }
            }
        }
        merged.retain(|(_, mass)| *mass > least);
        merged
    }

    /// The functions of the moments that limits are made of, the mass before all.
    pub(super) fn functions(&self) -> Vec<Functional> {
        let mut functions = vec![Functional::mass()];
        functions.extend(self.blocks.iter().flat_map(|block| block.rows.iter().copied()));
        for product in &self.products {
            let [u, v] = product.axes;
            functions.extend([Functional::second(u, v), Functional::first(u), Functional::first(v)]);
        }
        functions
    }

    /// Of more pieces than there are linear functions in all limits, some can be left out without changing any (Carathéodory).
    fn reduce(&self, pieces: &mut Vec<(Column, f64)>) {
        let functions = self.functions();
        loop {
            // Pieces of sites that have sizes or a most stay.
            let (free, kept): (Vec<_>, Vec<_>) =
                pieces.iter().copied().partition(|(column, _)| self.is_free(column.site));
            let columns: Vec<Vec<f64>> = free
                .iter()
                .map(|(column, _)| {
                    let w = weights(self.local(column.at));
                    functions.iter().map(|f| f.at(&w).middle()).collect()
                })
                .collect();
            let Some(null) = null_vector(&columns) else { break };
            // The first mass to vanish.
            let step = free.iter().zip(&null).filter(|(_, z)| **z > 0.0).map(|((_, m), z)| m / z);
            let step = step.fold(f64::INFINITY, f64::min);
            if !step.is_finite() {
                break;
            }
            let total: f64 = free.iter().map(|(_, mass)| mass).sum();
            let moved = free.iter().zip(&null).map(|((column, mass), z)| (*column, mass - step * z));
            let left: Vec<_> = moved.filter(|(_, mass)| *mass > NOTHING * 1e-3 * total).collect();
            if left.len() == free.len() {
                break;
            }
            *pieces = [kept, left].concat();
        }
    }

    /// The pieces that a mass at one place of a site is made of: of one size or none at a point, of any mass where there are no sizes; `None` if it cannot be there.
    pub(super) fn pieces_of(&self, site: usize, mass: f64) -> Option<Vec<Pieces>> {
        match &self.sums[site] {
            None => Some(vec![Pieces { size: mass, count: 1 }]),
            Some(sums) => sums.pieces(mass, false),
        }
    }

    /// The mass of all as the sum of their pieces.
    pub(super) fn mass(&self, pieces: &[(Column, f64)]) -> Option<f64> {
        let all: Option<Vec<_>> =
            pieces.iter().map(|(column, mass)| self.pieces_of(column.site, *mass)).collect();
        Some(all?.into_iter().flatten().map(|one| one.mass()).sum())
    }

    fn is_free(&self, site: usize) -> bool {
        self.sizes[site].is_empty() && self.most[site].is_infinite()
    }

    /// Changes masses and places, in proportion, so that what is at its limit is just inside.
    fn correct(&self, pieces: &mut [(Column, f64)], near: f64) -> Option<()> {
        let states = self.states(pieces);
        let inside = |state: &State| INSIDE.0 * state.size.0 + INSIDE.1 * state.size.1;
        let active: Vec<&State> = states
            .iter()
            .filter(|state| state.is_zero || state.value < near * state.size.0 + inside(state))
            .collect();
        let mut free = Vec::new();
        for (piece, (column, _)) in pieces.iter().enumerate() {
            if self.sizes[column.site].is_empty() {
                free.push(Freedom { piece, along: None });
            }
            let along = self.charts[column.site].freedoms(column.at);
            free.extend(along.into_iter().map(|along| Freedom { piece, along: Some(along) }));
        }
        // x += Jᵀ (J Jᵀ)⁻¹ (what is missing), in units of each row, each mass and each site.
        let change = |state: &State, freedom: &Freedom| {
            let (column, mass) = &pieces[freedom.piece];
            let r = self.local(column.at);
            let by = match freedom.along {
                None => state.slope.at(&weights(r)),
                Some(e) => state.slope.slope(&r, &e.map(Interval::from)),
            };
            mass * by.middle() / state.size.0
        };
        let rows: Vec<Vec<f64>> =
            active.iter().map(|state| free.iter().map(|freedom| change(state, freedom)).collect()).collect();
        let wanted: Vec<f64> = active
            .iter()
            .map(|state| (if state.is_zero { 0.0 } else { inside(state) } - state.value) / state.size.0)
            .collect();
        let gram: Vec<Vec<f64>> = rows.iter().map(|a| rows.iter().map(|b| inner(a, b)).collect()).collect();
        let multipliers = solved(gram, wanted);
        for (k, freedom) in free.iter().enumerate() {
            let by = rows.iter().zip(&multipliers).map(|(row, y)| row[k] * y).sum::<f64>();
            let (column, mass) = &mut pieces[freedom.piece];
            match freedom.along {
                None => *mass += *mass * by,
                Some(e) => column.at = core::array::from_fn(|k| column.at[k] + by * e[k]),
            }
            if !(*mass >= 0.0 && mass.is_finite()) {
                return None;
            }
        }
        for (column, _) in pieces {
            column.at = self.charts[column.site].nearest(column.at);
        }
        Some(())
    }

    /// Whether pieces are at their sites and meet all limits, but for rounding; proved.
    pub(super) fn is_met(&self, pieces: &[(Column, f64)]) -> bool {
        let at_sites = pieces.iter().all(|(column, mass)| {
            let reach = column.at.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let size_holds = self.pieces_of(column.site, *mass).is_some();
            let chart = &self.charts[column.site];
            let near = chart.nearest(column.at).into_iter().zip(column.at).map(|(a, b)| (a - b).abs());
            let near = near.fold(0.0, f64::max) <= AT * reach.max(chart.size());
            *mass >= 0.0 && size_holds && near
        });
        let within_sites = (0..self.charts.len()).all(|site| {
            let own = pieces.iter().filter(|(column, _)| column.site == site);
            let sum: f64 = own.clone().map(|(_, mass)| mass).sum();
            let is_one = self.sums[site].is_none() || !self.charts[site].is_point() || own.count() <= 1;
            is_one && sum <= self.most[site] * (1.0 + BROKEN.0)
        });
        let allowed = |state: &State| BROKEN.0 * state.size.0 + BROKEN.1 * state.size.1;
        at_sites
            && within_sites
            && self.states(pieces).iter().all(|state| {
                let below = state.value >= -allowed(state);
                below && (!state.is_zero || state.value <= allowed(state))
            })
    }

    /// Every limit with these pieces: values that are to be positive are rounded down, as far as it is not known what they are.
    fn states(&self, pieces: &[(Column, f64)]) -> Vec<State> {
        let at: Vec<Moments> = pieces.iter().map(|(column, _)| weights(self.local(column.at))).collect();
        let mut all = Vec::new();
        for block in &self.blocks {
            let rows: Vec<(Interval, (f64, f64))> =
                block.rows.iter().map(|row| value(row, &at, pieces)).collect();
            if let (Kind::Cone, [first, rest @ ..]) = (block.kind, &rows[..]) {
                let norm = rest.iter().map(|(value, _)| value.square()).sum::<Interval>().sqrt();
                let turned = block.rows[1..].iter().zip(rest);
                let slope = turned.fold(block.rows[0], |sum, (row, (value, _))| {
                    let cosine = if norm.high > 0.0 { value.middle() / norm.high } else { 0.0 };
                    sum - *row * Interval::from(cosine)
                });
                let size = rows.iter().fold((0.0, 0.0), |(a, b), (_, (c, d))| (a + c, b + d));
                all.push(State { value: (first.0 - norm).low, is_zero: false, slope, size });
                continue;
            }
            let is_zero = block.kind == Kind::Zero;
            all.extend(block.rows.iter().zip(rows).map(|(row, (value, size))| State {
                value: if is_zero { value.middle() } else { value.low },
                is_zero,
                slope: *row,
                size,
            }));
        }
        for product in &self.products {
            all.extend(self.product_states(product, &at, pieces));
        }
        all
    }

    fn product_states(&self, product: &Product, at: &[Moments], pieces: &[(Column, f64)]) -> Vec<State> {
        let whole = self.with(product.basis, pieces);
        let value = product.value(&whole);
        let [u, v] = product.axes;
        let [us, vs] = [u, v].map(|u| Functional::first(u).at(&whole));
        let mass = whole[0];
        // The derivative of u·W v − (u·S)(v·S)/M
        let slope = Functional::second(u, v)
            - Functional::first(u) * vs.over(mass)
            - Functional::first(v) * us.over(mass)
            + Functional::mass() * (us.over(mass) * vs.over(mass));
        let before = product.value(self.whole(product.basis)).middle();
        let moved: f64 =
            at.iter().zip(pieces).map(|(w, (_, mass))| (slope.at(w).middle() * mass).abs()).sum();
        let terms =
            Functional::second(u, v).by.iter().zip(&whole).map(|(l, w)| (*l * *w).size()).sum::<f64>();
        let state = |value: f64, is_zero, sign: f64, bound: f64| State {
            value,
            is_zero,
            slope: slope * Interval::from(sign),
            size: ((before - bound).abs() + moved, terms + (us * vs).over(mass).size() + bound.abs()),
        };
        match (product.least, product.most) {
            (Some(least), Some(most)) if least == most => {
                vec![state(value.middle() - least, true, 1.0, least)]
            }
            (least, most) => {
                let least = least.map(|least| state((value - least.into()).low, false, 1.0, least));
                let most = most.map(|most| state((Interval::from(most) - value).low, false, -1.0, most));
                least.into_iter().chain(most).collect()
            }
        }
    }

    /// By how much a product about the centre is beside its limits, and the centre's coordinates, with these pieces.
    pub(super) fn broken_products(&self, pieces: &[(Column, f64)]) -> Vec<f64> {
        let beside = |product: &Product| {
            let value = product.value(&self.with(product.basis, pieces)).middle();
            let below = product.least.map_or(0.0, |least| least - value);
            below.max(product.most.map_or(0.0, |most| value - most)).max(0.0)
        };
        self.products.iter().map(beside).collect()
    }

    /// The coordinates of the centre that are searched.
    pub(super) fn center(&self, pieces: &[(Column, f64)]) -> Vec<f64> {
        let wholes = [Basis::Basic, Basis::Predicted].map(|basis| self.with(basis, pieces));
        let at = |coordinate: &Coordinate| {
            let whole = &wholes[usize::from(coordinate.basis == Basis::Predicted)];
            Functional::first(coordinate.along).at(whole).over(whole[0]).middle()
        };
        self.coordinates.iter().map(at).collect()
    }
}

/// A function of the pieces, the size of its terms, and of what its constant is the difference of.
fn value(row: &Functional, at: &[Moments], pieces: &[(Column, f64)]) -> (Interval, (f64, f64)) {
    let (mut value, mut size) = (row.constant, row.constant.size());
    for (w, (_, mass)) in at.iter().zip(pieces) {
        let term = row.at(w) * Interval::from(*mass);
        value = value + term;
        size += term.size();
    }
    (value, (size, row.size))
}

fn mass(pieces: &[(Column, f64)]) -> f64 {
    pieces.iter().map(|(_, mass)| mass).sum()
}
