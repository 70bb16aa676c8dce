//! Linear programs of a few dozen rows: the bounded simplex method on a dense tableau.

/// Linear program: minimize c·x with A x + b ≥ 0 or = 0 and 0 ≤ x ≤ u. Rows are of the order of 1.
#[derive(Debug, Default)]
pub(super) struct Program {
    pub(super) cost: Vec<f64>,
    pub(super) upper: Vec<f64>,
    pub(super) rows: Vec<Inequality>,
}

/// Row of A x + b.
#[derive(Debug)]
pub(super) struct Inequality {
    pub(super) by: Vec<f64>,
    pub(super) constant: f64,
    /// True for the condition = 0; false for ≥ 0.
    pub(super) is_zero: bool,
}

/// Optimal solution, or the point of least total violation if there is none.
#[derive(Debug)]
pub(super) struct Solution {
    pub(super) is_feasible: bool,
    pub(super) x: Vec<f64>,
    /// Dual variables of the rows; if infeasible, those of the least total violation.
    pub(super) duals: Vec<f64>,
}

/// Feasibility tolerances: the first by default, the second if rounding permits no better.
const FEASIBLE: [f64; 2] = [1e-14, 1e-10];

/// Least pivot and least reduced cost of an entering variable, for columns of the order of 1.
const PIVOT: f64 = 1e-9;
const DESCENT: f64 = 1e-12;

/// Simplex tableau: rows x_B + T x_N = right of the basic variables x_B, and the row of reduced
/// costs.
///
/// The last column has the right sides. A variable at its upper bound is complemented: it is
/// replaced by its distance from the bound, so that all x_N are 0.
struct Tableau {
    rows: Vec<Vec<f64>>,
    basis: Vec<usize>,
    upper: Vec<f64>,
    is_complemented: Vec<bool>,
    tolerance: f64,
}

impl Program {
    pub(super) fn solve(&self) -> Solution {
        let (n, m) = (self.cost.len(), self.rows.len());
        let most = |k: usize| self.rows.iter().fold(0.0, |most: f64, row| most.max(row.by[k].abs()));
        let units: Vec<f64> =
            (0..n).map(most).map(|most| if most > 0.0 { 1.0 / most } else { 1.0 }).collect();
        let row = |(i, row): (usize, &Inequality)| {
            let slacks = (0..m).map(|k| f64::from(u8::from(k == i)));
            row.by
                .iter()
                .zip(&units)
                .map(|(by, unit)| -by * unit)
                .chain(slacks)
                .chain([row.constant])
                .collect()
        };
        let mut cost: Vec<f64> = self.cost.iter().zip(&units).map(|(cost, unit)| cost * unit).collect();
        cost.resize(n + m + 1, 0.0);
        let slack = |row: &Inequality| if row.is_zero { 0.0 } else { f64::INFINITY };
        let upper = self.upper.iter().zip(&units).map(|(upper, unit)| upper / unit);
        let mut tableau = Tableau {
            rows: self.rows.iter().enumerate().map(row).chain([cost]).collect(),
            basis: (n..n + m).collect(),
            upper: upper.chain(self.rows.iter().map(slack)).collect(),
            is_complemented: vec![false; n + m],
            tolerance: FEASIBLE[0],
        };
        tableau.run();
        let violated = tableau.violated();
        let row_of = |k: usize| tableau.basis.iter().position(|basic| *basic == k);
        let x = (0..n).map(|k| {
            let x = row_of(k).map_or(0.0, |i| tableau.right(i).max(0.0));
            units[k] * if tableau.is_complemented[k] { (tableau.upper[k] - x).max(0.0) } else { x }
        });
        let dual = |k: usize| {
            // A basic slack has the dual 1 if its row is violated, and 0 otherwise.
            let row = row_of(k).map(|i| f64::from(u8::from(violated.contains(&i))));
            let own = row.unwrap_or_else(|| tableau.gradient(&violated, k));
            let own = if tableau.is_complemented[k] { -own } else { own };
            if self.rows[k - n].is_zero { own } else { own.max(0.0) }
        };
        Solution { is_feasible: violated.is_empty(), x: x.collect(), duals: (n..n + m).map(dual).collect() }
    }
}

impl Tableau {
    fn right(&self, i: usize) -> f64 {
        self.rows[i][self.upper.len()]
    }

    /// Returns the rows whose basic variables are negative.
    fn violated(&self) -> Vec<usize> {
        (0..self.basis.len()).filter(|i| self.right(*i) < -self.tolerance).collect()
    }

    /// Returns the derivative of the cost, or of the total violation, with respect to a variable.
    fn gradient(&self, violated: &[usize], k: usize) -> f64 {
        let of_cost = [self.basis.len()];
        let rows = if violated.is_empty() { &of_cost } else { violated };
        rows.iter().map(|i| self.rows[*i][k]).sum()
    }

    fn run(&mut self) {
        let all = self.upper.len();
        let patience = 2 * (all + self.basis.len());
        for step in 0..2 * patience {
            if step == patience {
                self.tolerance = FEASIBLE[1];
            }
            for i in 0..self.basis.len() {
                if self.right(i) > self.upper[self.basis[i]] + self.tolerance {
                    self.complement_basic(i);
                }
            }
            let violated = self.violated();
            let gradients =
                (0..all).filter(|k| self.upper[*k] > 0.0).map(|k| (self.gradient(&violated, k), k));
            let mut down = gradients.filter(|(by, _)| *by < -DESCENT);
            // Bland's rule cannot cycle, but is slower.
            let best = if step < patience { down.min_by(|a, b| a.0.total_cmp(&b.0)) } else { down.next() };
            let Some((_, enters)) = best else {
                if violated.is_empty() || violated.iter().any(|i| self.right(*i) < -FEASIBLE[1]) {
                    break;
                }
                self.tolerance = FEASIBLE[1];
                continue;
            };
            // Ratio test: a violated row leaves the basis at 0, another row at one of its bounds.
            let (mut far, mut leaves, mut pivot) = (self.upper[enters], None, 0.0);
            for i in 0..self.basis.len() {
                let (by, right) = (self.rows[i][enters], self.right(i));
                let room = self.upper[self.basis[i]] - right;
                let (ratio, turns) = match right < -self.tolerance {
                    true if by < -PIVOT => (right / by, false),
                    false if by > PIVOT => (right.max(0.0) / by, false),
                    false if by < -PIVOT && room.is_finite() => (room.max(0.0) / -by, true),
                    _ => continue,
                };
                if ratio < far || (ratio == far && by.abs() > pivot) {
                    (far, leaves, pivot) = (ratio, Some((i, turns)), by.abs());
                }
            }
            match leaves {
                Some((i, turns)) => {
                    if turns {
                        self.complement_basic(i);
                    }
                    self.pivot(i, enters);
                }
                None if far.is_finite() => self.complement(enters),
                None => break,
            }
        }
    }

    /// Complements a nonbasic variable.
    fn complement(&mut self, k: usize) {
        let all = self.upper.len();
        for row in &mut self.rows {
            row[all] -= row[k] * self.upper[k];
            row[k] = -row[k];
        }
        self.is_complemented[k] = !self.is_complemented[k];
    }

    /// Complements the basic variable of a row.
    fn complement_basic(&mut self, i: usize) {
        let (k, all) = (self.basis[i], self.upper.len());
        self.rows[i].iter_mut().for_each(|x| *x = -*x);
        self.rows[i][k] = 1.0;
        self.rows[i][all] += self.upper[k];
        self.is_complemented[k] = !self.is_complemented[k];
    }

    fn pivot(&mut self, i: usize, enters: usize) {
        let by = self.rows[i][enters];
        self.rows[i].iter_mut().for_each(|x| *x /= by);
        let row = core::mem::take(&mut self.rows[i]);
        for other in self.rows.iter_mut().filter(|other| !other.is_empty()) {
            let factor = other[enters];
            other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
            other[enters] = 0.0;
        }
        self.rows[i] = row;
        self.basis[i] = enters;
    }
}
