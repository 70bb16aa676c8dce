//! Few pieces that meet all limits to rounding, from many that nearly do.

use super::interval::Interval;
use super::problem::{Column, Problem};
use super::relaxation::beside;
use super::row::{Functional, Kind, weights};
use crate::growth::Basis;

/// Masses below this part of all ballast are none.
const NOTHING: f64 = 1e-9;

/// Limits that are nearer than this part of their size to being broken are kept exactly.
const ACTIVE: f64 = 1e-6;

/// By how much of its own size, and by how many roundings of what it is the difference of, a limit is kept inside.
const INSIDE: (f64, f64) = (1e-13, 4.0 * f64::EPSILON);

/// By how much of the same a limit may be broken.
const BROKEN: (f64, f64) = (1e-11, 16.0 * f64::EPSILON);

/// What a limit comes to.
struct State {
    /// At least zero, or zero.
    value: f64,
    is_zero: bool,
    /// How each piece changes it.
    by: Vec<f64>,
    /// Size of its terms, and of what they are the difference of.
    size: (f64, f64),
}

impl Problem {
    /// Pieces of which no two are near, no more than it takes; `None` if they do not meet all limits.
    pub(super) fn polished(&self, pieces: &[(Column, f64)]) -> Option<Vec<(Column, f64)>> {
        let total: f64 = pieces.iter().map(|(_, mass)| mass).sum();
        let mut pieces: Vec<_> = pieces.iter().copied().filter(|(_, mass)| *mass > NOTHING * total).collect();
        self.merge(&mut pieces);
        self.reduce(&mut pieces);
        self.merge(&mut pieces);
        for (column, mass) in &mut pieces {
            if let Some(size) = self.nearest_size(column.site, *mass) {
                *mass = size;
            }
        }
        for _ in 0..4 {
            self.correct(&mut pieces)?;
        }
        pieces.retain(|(_, mass)| *mass > 0.0);
        self.is_met(&pieces).then_some(pieces)
    }

    /// The size of a site that is nearest to a mass, if it has sizes.
    pub(super) fn nearest_size(&self, site: usize, mass: f64) -> Option<f64> {
        let beside = |size: &f64| (size - mass).abs();
        self.sizes[site].iter().copied().min_by(|a, b| beside(a).total_cmp(&beside(b)))
    }

    /// Pieces that are near each other become one at their centre of mass.
    fn merge(&self, pieces: &mut Vec<(Column, f64)>) {
        let mut merged: Vec<(Column, f64)> = Vec::with_capacity(pieces.len());
        for (column, mass) in pieces.drain(..) {
            let same = merged.iter_mut().find(|(other, _)| {
                other.site == column.site && self.charts[column.site].are_near(other.at, column.at)
            });
            match same {
                None => merged.push((column, mass)),
                Some((other, sum)) => {
                    let share = mass / (*sum + mass);
                    other.at = core::array::from_fn(|k| other.at[k] + share * (column.at[k] - other.at[k]));
                    *sum += mass;
                }
            }
        }
        *pieces = merged;
    }

    /// Of more pieces than there are linear functions in all limits, some can be left out without changing any (Carathéodory).
    fn reduce(&self, pieces: &mut Vec<(Column, f64)>) {
        let mut functions: Vec<Functional> = vec![Functional::mass()];
        functions.extend(self.blocks.iter().flat_map(|block| block.rows.iter().copied()));
        for product in &self.products {
            let [u, v] = product.axes;
            functions.extend([Functional::second(u, v), Functional::first(u), Functional::first(v)]);
        }
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

    fn is_free(&self, site: usize) -> bool {
        self.sizes[site].is_empty() && self.most[site].is_infinite()
    }

    /// Changes masses, each by about the same part, so that what is at its limit is just inside.
    fn correct(&self, pieces: &mut [(Column, f64)]) -> Option<()> {
        let states = self.states(pieces);
        let inside = |state: &State| INSIDE.0 * state.size.0 + INSIDE.1 * state.size.1;
        let active: Vec<&State> = states
            .iter()
            .filter(|state| state.is_zero || state.value < ACTIVE * state.size.0 + INSIDE.1 * state.size.1)
            .collect();
        let weight: Vec<f64> = pieces
            .iter()
            .map(|(column, mass)| if self.sizes[column.site].is_empty() { *mass } else { 0.0 })
            .collect();
        // x += D² Jᵀ (J D² Jᵀ)⁻¹ (what is missing), in units of each row.
        let rows: Vec<Vec<f64>> = active
            .iter()
            .map(|state| state.by.iter().zip(&weight).map(|(by, d)| by * d / state.size.0).collect())
            .collect();
        let wanted: Vec<f64> = active
            .iter()
            .map(|state| (if state.is_zero { 0.0 } else { inside(state) } - state.value) / state.size.0)
            .collect();
        let gram: Vec<Vec<f64>> = rows.iter().map(|a| rows.iter().map(|b| inner(a, b)).collect()).collect();
        let multipliers = solved(gram, wanted);
        for (k, (_, mass)) in pieces.iter_mut().enumerate() {
            *mass += weight[k] * rows.iter().zip(&multipliers).map(|(row, y)| row[k] * y).sum::<f64>();
            if !(*mass >= 0.0 && mass.is_finite()) {
                return None;
            }
        }
        Some(())
    }

    /// Whether pieces are at their sites and meet all limits, but for rounding; proved.
    pub(super) fn is_met(&self, pieces: &[(Column, f64)]) -> bool {
        let at_sites = pieces.iter().all(|(column, mass)| {
            let reach = column.at.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let size_holds = self.sizes[column.site].is_empty() || self.sizes[column.site].contains(mass);
            let near = self.charts[column.site].distance(column.at)
                <= 1e-12 * reach.max(self.charts[column.site].size());
            *mass >= 0.0 && size_holds && near
        });
        let within_sites = (0..self.charts.len()).all(|site| {
            let own = pieces.iter().filter(|(column, _)| column.site == site);
            let sum: f64 = own.map(|(_, mass)| mass).sum();
            sum <= self.most[site] * (1.0 + BROKEN.0)
        });
        let allowed = |state: &State| BROKEN.0 * state.size.0 + BROKEN.1 * state.size.1;
        at_sites
            && within_sites
            && self.states(pieces).iter().all(|state| {
                let below = state.value >= -allowed(state);
                below && (!state.is_zero || state.value <= allowed(state))
            })
    }

    /// Every limit with these pieces: values that are below zero are rounded down, as far as it is not known what they are.
    fn states(&self, pieces: &[(Column, f64)]) -> Vec<State> {
        let at: Vec<[Interval; 10]> =
            pieces.iter().map(|(column, _)| weights(self.local(column.at))).collect();
        let mut all = Vec::new();
        for block in &self.blocks {
            let rows: Vec<Row> = block.rows.iter().map(|row| Row::new(row, &at, pieces)).collect();
            match (block.kind, &rows[..]) {
                (Kind::Cone, [first, rest @ ..]) => {
                    let values: Vec<f64> = rows.iter().map(|row| row.value.middle()).collect();
                    let norm = rest.iter().map(|row| row.value.square()).sum::<Interval>().sqrt();
                    let by = (0..pieces.len()).map(|k| {
                        let along = rest.iter().zip(&values[1..]).map(|(row, x)| row.by[k] * x).sum::<f64>();
                        first.by[k] - if norm.high > 0.0 { along / norm.high } else { 0.0 }
                    });
                    let sizes = rows.iter().map(|row| row.size);
                    let size = sizes.fold((0.0, 0.0), |(a, b), (c, d): (f64, f64)| (a + c, b + d));
                    debug_assert!(beside(block.kind, &values) >= 0.0);
                    all.push(State {
                        value: (first.value - norm).low,
                        is_zero: false,
                        by: by.collect(),
                        size,
                    });
                }
                (kind, _) => all.extend(rows.into_iter().map(|row| State {
                    value: if kind == Kind::Zero { row.value.middle() } else { row.value.low },
                    is_zero: kind == Kind::Zero,
                    by: row.by,
                    size: row.size,
                })),
            }
        }
        for product in &self.products {
            all.extend(self.product_states(product, &at, pieces));
        }
        all
    }

    fn product_states(
        &self,
        product: &super::row::Product,
        at: &[[Interval; 10]],
        pieces: &[(Column, f64)],
    ) -> Vec<State> {
        let whole = self.with(product.basis, pieces);
        let value = product.value(&whole);
        let [u, v] = product.axes;
        let [su, sv] = [u, v].map(|u| Functional::first(u).at(&whole).middle());
        let (m, integral) = (whole[0].middle(), Functional::second(u, v));
        // ∂/∂m = (u·r)(v·r) − ((u·r)(v·S) + (v·r)(u·S))/M + (u·S)(v·S)/M²
        let by: Vec<f64> = at
            .iter()
            .map(|w| {
                let [ur, vr] = [u, v].map(|u| Functional::first(u).at(w).middle());
                integral.at(w).middle() - (ur * sv + vr * su) / m + su * sv / (m * m)
            })
            .collect();
        let before = product.value(self.whole(product.basis)).middle();
        let moved: f64 = by.iter().zip(pieces).map(|(by, (_, mass))| (by * mass).abs()).sum();
        let terms = integral.by.iter().zip(&whole).map(|(l, w)| (*l * *w).size()).sum::<f64>();
        let state = |value: f64, is_zero, sign: f64, bound: f64| State {
            value,
            is_zero,
            by: by.iter().map(|by| sign * by).collect(),
            size: ((before - bound).abs() + moved, terms + (su * sv / m).abs() + bound.abs()),
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
        let beside = |product: &super::row::Product| {
            let value = product.value(&self.with(product.basis, pieces)).middle();
            let below = product.least.map_or(0.0, |least| least - value);
            below.max(product.most.map_or(0.0, |most| value - most)).max(0.0)
        };
        self.products.iter().map(beside).collect()
    }

    /// The coordinates of the centre that are searched.
    pub(super) fn center(&self, pieces: &[(Column, f64)]) -> Vec<f64> {
        let wholes = [Basis::Basic, Basis::Predicted].map(|basis| self.with(basis, pieces));
        let at = |coordinate: &super::row::Coordinate| {
            let whole = &wholes[usize::from(coordinate.basis == Basis::Predicted)];
            Functional::first(coordinate.along).at(whole).over(whole[0]).middle()
        };
        self.coordinates.iter().map(at).collect()
    }
}

/// A function of the pieces.
struct Row {
    value: Interval,
    by: Vec<f64>,
    size: (f64, f64),
}

impl Row {
    fn new(row: &Functional, at: &[[Interval; 10]], pieces: &[(Column, f64)]) -> Self {
        let by: Vec<Interval> = at.iter().map(|w| row.at(w)).collect();
        let terms = by.iter().zip(pieces).map(|(by, (_, mass))| *by * Interval::from(*mass));
        let (mut value, mut size) = (row.constant, row.constant.size());
        for term in terms {
            value = value + term;
            size += term.size();
        }
        Self { value, by: by.iter().map(|by| by.middle()).collect(), size: (size, row.size) }
    }
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// x of A x = b, A symmetric and not negative; zero where rows depend on those before.
fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    let diagonal: Vec<f64> = (0..n).map(|k| a[k][k]).collect();
    let mut order = Vec::with_capacity(n);
    let mut left: Vec<usize> = (0..n).collect();
    loop {
        let relative = |k: &usize| if diagonal[*k] > 0.0 { a[*k][*k] / diagonal[*k] } else { 0.0 };
        let Some(place) = (0..left.len()).max_by(|i, j| relative(&left[*i]).total_cmp(&relative(&left[*j])))
        else {
            break;
        };
        if relative(&left[place]) < 1e-12 {
            break;
        }
        let pivot = left.swap_remove(place);
        order.push(pivot);
        let row = a[pivot].clone();
        for &k in &left {
            let factor = a[k][pivot] / row[pivot];
            a[k].iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            b[k] -= factor * b[pivot];
        }
    }
    let mut x = vec![0.0; n];
    for &k in order.iter().rev() {
        let known: f64 = order.iter().filter(|j| **j != k).map(|&j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    x
}

/// z with Σ z of columns zero and some z positive, if there are more columns than their rank.
fn null_vector(columns: &[Vec<f64>]) -> Option<Vec<f64>> {
    let rows = columns.first()?.len();
    // One column more than rows depends on the others; fewer may.
    let count = columns.len().min(rows + 1);
    let mut a: Vec<Vec<f64>> =
        (0..rows).map(|i| columns[..count].iter().map(|column| column[i]).collect()).collect();
    for row in &mut a {
        let most = row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if most > 0.0 {
            row.iter_mut().for_each(|x| *x /= most);
        }
    }
    let (mut pivots, mut next) = (Vec::new(), 0);
    for column in 0..count {
        let best = (next..rows).max_by(|i, j| a[*i][column].abs().total_cmp(&a[*j][column].abs()));
        let Some(best) = best.filter(|best| a[*best][column].abs() > 1e-10) else {
            // This column depends on the pivots.
            let mut z = vec![0.0; columns.len()];
            z[column] = 1.0;
            for (row, pivot) in pivots.iter().enumerate() {
                z[*pivot] = -a[row][column];
            }
            return Some(z);
        };
        a.swap(next, best);
        let factor = 1.0 / a[next][column];
        a[next].iter_mut().for_each(|x| *x *= factor);
        let row = a[next].clone();
        for (i, other) in a.iter_mut().enumerate() {
            if i != next {
                let factor = other[column];
                other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            }
        }
        pivots.push(column);
        next += 1;
    }
    None
}
