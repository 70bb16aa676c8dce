//! Nonlinear least squares with shared parameters and local parameters of groups of rows.
//!
//! The method is Levenberg–Marquardt on triangular factors. Each group has rows of residuals
//! r = measured − predicted and derivatives J = ∂predicted/∂p. QR reduces them to an upper
//! triangle. Normal equations, which lose half of the digits, are never formed. A parameter
//! direction that the measurements do not determine appears as a singular value of zero.

mod left;
mod more;
mod outlier;
mod rows;
mod solution;

pub(crate) use left::{Response, response};
pub(crate) use outlier::{Outliers, spread};
pub(crate) use rows::{Rows, stacked};
pub(crate) use solution::{Information, KNOWN, Solution, changes_along, columns};

use nalgebra::{DMatrix, DVector};

use crate::coordinates::Coordinates;
use crate::error::IdentifyError;

/// Measurements, and the model that predicts them.
pub(crate) trait Problem {
    /// Returns the number of groups.
    fn groups(&self) -> usize;

    /// Adds the rows of a group for these shared and local parameters; always the same rows in the
    /// same order.
    ///
    /// # Errors
    /// If the model cannot be evaluated; the fit then rejects the step.
    fn rows(&self, group: usize, shared: &[f64], local: &[f64], rows: &mut Rows)
    -> Result<(), IdentifyError>;

    /// Returns the rows of all groups, in order.
    fn all_rows(&self, shared: &[f64], local: &[Vec<f64>]) -> Vec<Result<Rows, IdentifyError>> {
        (0..self.groups()).map(|group| rows_of(self, group, shared, &local[group])).collect()
    }
}

/// Returns the rows of a group.
pub(crate) fn rows_of<P: Problem + ?Sized>(
    problem: &P,
    group: usize,
    shared: &[f64],
    local: &[f64],
) -> Result<Rows, IdentifyError> {
    let mut rows = Rows::new(local.len(), shared.len());
    problem.rows(group, shared, local, &mut rows).map(|()| rows)
}

/// Current point of the iteration: values of all parameters.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    /// Coordinates of the shared parameters.
    pub(crate) shared: Vec<f64>,
    /// Local parameters of each group.
    pub(crate) local: Vec<Vec<f64>>,
}

/// Maximum number of steps.
const MOST_STEPS: usize = 200;
/// Convergence threshold: a step must lower ½χ² by more than this, in units of χ² per row.
/// Corresponds to 1e-4 of a standard deviation.
const NOTHING: f64 = 1e-9;
/// Convergence threshold for a starting point of another fit: a tenth of a standard deviation.
const NEARLY_NOTHING: f64 = 1e-2;
/// Lower bound on the damping; it suppresses steps in undetermined directions.
const LEAST_DAMPING: f64 = 1e-9;

/// Convergence along a flat valley: stop when [`VALLEY`] steps together lower ½χ² by less than
/// [`LITTLE`], 0.06 of a standard deviation.
const VALLEY: usize = 25;
const LITTLE: f64 = 2e-3;

/// Value of the cost and its linearization at a point.
struct Evaluation {
    /// Upper triangle of each group, by the physical parameters.
    triangles: Vec<DMatrix<f64>>,
    /// Cost: ½χ², with outliers weighted.
    cost: f64,
    /// Number of rows.
    rows: f64,
}

/// Minimizes the sum of squares from a start.
///
/// # Errors
/// If the model cannot be evaluated at the start, or the iteration does not converge.
pub(crate) fn fit(
    problem: &impl Problem,
    coordinates: &Coordinates,
    start: Place,
    outliers: Outliers,
) -> Result<Solution, IdentifyError> {
    descend(problem, coordinates, start, outliers, NOTHING)
}

/// Finds a point near the minimum, as the start of another fit.
///
/// # Errors
/// Same as [`fit`].
pub(crate) fn approach(
    problem: &impl Problem,
    coordinates: &Coordinates,
    start: Place,
    outliers: Outliers,
) -> Result<Solution, IdentifyError> {
    descend(problem, coordinates, start, outliers, NEARLY_NOTHING)
}

fn descend(
    problem: &impl Problem,
    coordinates: &Coordinates,
    start: Place,
    outliers: Outliers,
    nothing: f64,
) -> Result<Solution, IdentifyError> {
    let mut place = start;
    let mut here = evaluate(problem, coordinates, &place, outliers)?;
    let mut scale = Scale::default();
    let (mut damping, mut factor) = (1e-3, 2.0);
    let mut before = here.cost;
    for taken in 1..=MOST_STEPS {
        // Towards the boundary of physical consistency (plates and rods) the minimum may lie at
        // infinity.
        if taken % VALLEY == 0 {
            if before - here.cost <= LITTLE {
                return Ok(Solution::new(place, coordinates, here.triangles));
            }
            before = here.cost;
        }
        let jacobian = coordinates.jacobian(&place.shared);
        let triangles: Vec<_> = here.triangles.iter().map(|t| in_coordinates(t, &jacobian)).collect();
        scale.grow(&triangles, place.shared.len());
        let Some(step) = step(&triangles, &scale, damping, place.shared.len())? else {
            damping *= 10.0;
            continue;
        };
        if step.expected <= nothing * (1.0 + 2.0 * here.cost / here.rows) {
            return Ok(Solution::new(place, coordinates, here.triangles));
        }
        let next = place.moved(&step);
        let there = evaluate(problem, coordinates, &next, outliers);
        let gain = there.as_ref().map_or(-1.0, |there| (here.cost - there.cost) / step.expected);
        match there {
            Ok(there) if gain > 0.0 => {
                (place, here) = (next, there);
                damping = LEAST_DAMPING.max(damping * f64::max(1.0 / 3.0, 1.0 - (2.0 * gain - 1.0).powi(3)));
                factor = 2.0;
            }
            _ => {
                damping *= factor;
                factor *= 2.0;
                // No smaller step lowers the cost: rounding dominates.
                if damping > 1e16 {
                    return Ok(Solution::new(place, coordinates, here.triangles));
                }
            }
        }
    }
    Err(IdentifyError::NoConvergence { steps: MOST_STEPS })
}

/// Minimizes the sum of squares robustly. Measurements beyond `limit` times the spread of the
/// residuals first have a linear cost, and are then left out.
pub(crate) fn fit_robustly(
    problem: &impl Problem,
    coordinates: &Coordinates,
    mut start: Place,
    limit: f64,
) -> Result<(Solution, Outliers), IdentifyError> {
    for _ in 0..ROUNDS {
        let damped = Outliers::Damped(FULL * spread(&all_rows(problem, coordinates, &start)?));
        start = approach(problem, coordinates, start, damped)?.place;
    }
    let left_out = Outliers::LeftOut(limit * spread(&all_rows(problem, coordinates, &start)?));
    Ok((fit(problem, coordinates, start, left_out)?, left_out))
}

/// Threshold of full weight in the first rounds, in units of the spread.
const FULL: f64 = 4.0;
/// Number of times that the spread is estimated again.
const ROUNDS: usize = 2;

fn all_rows(
    problem: &impl Problem,
    coordinates: &Coordinates,
    place: &Place,
) -> Result<Vec<Rows>, IdentifyError> {
    problem.all_rows(&coordinates.physical(&place.shared), &place.local).into_iter().collect()
}

fn evaluate(
    problem: &impl Problem,
    coordinates: &Coordinates,
    place: &Place,
    outliers: Outliers,
) -> Result<Evaluation, IdentifyError> {
    let shared = coordinates.physical(&place.shared);
    let mut evaluation = Evaluation { triangles: Vec::new(), cost: 0.0, rows: 0.0 };
    for rows in problem.all_rows(&shared, &place.local) {
        let rows = rows?;
        let (cost, weights) = outliers.weigh(&rows);
        if !cost.is_finite() {
            return Err(IdentifyError::NotFinite { quantity: "the sum of the squared residuals" });
        }
        evaluation.cost += cost;
        evaluation.rows += rows.count() as f64;
        evaluation.triangles.push(rows.triangle(&weights)?);
    }
    Ok(evaluation)
}

/// Computes `one` for each index below `count`, in parallel. The results are in order and do not
/// depend on the number of threads.
pub(crate) fn side_by_side<T: Send>(count: usize, one: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(count);
    if threads < 2 {
        return (0..count).map(one).collect();
    }
    let one = &one;
    std::thread::scope(|scope| {
        // Each thread takes every n-th index, because neighbours take similar time.
        let parts: Vec<_> = (0..threads)
            .map(|k| scope.spawn(move || (k..count).step_by(threads).map(one).collect::<Vec<T>>()))
            .collect();
        let mut parts: Vec<_> = parts.into_iter().map(|part| part.join().map(Vec::into_iter)).collect();
        let mut all = Vec::with_capacity(count);
        for k in 0..count {
            match &mut parts[k % threads] {
                Ok(part) => all.extend(part.next()),
                // If the model panicked, evaluate it here, so that the panic propagates as without
                // threads.
                Err(_) => all.push(one(k)),
            }
        }
        all
    })
}

/// Transforms the shared columns of a triangle to coordinates.
fn in_coordinates(triangle: &DMatrix<f64>, jacobian: &DMatrix<f64>) -> DMatrix<f64> {
    let (shared, coordinates) = jacobian.shape();
    let local = triangle.ncols() - shared - 1;
    let mut columns = DMatrix::zeros(triangle.nrows(), local + coordinates + 1);
    columns.columns_mut(0, local).copy_from(&triangle.columns(0, local));
    columns.columns_mut(local, coordinates).copy_from(&(triangle.columns(local, shared) * jacobian));
    columns.set_column(local + coordinates, &triangle.column(triangle.ncols() - 1));
    columns
}

/// Largest norm so far of each column: the scale of the damping.
#[derive(Default)]
struct Scale {
    shared: Vec<f64>,
    local: Vec<Vec<f64>>,
}

impl Scale {
    fn grow(&mut self, triangles: &[DMatrix<f64>], shared: usize) {
        self.shared.resize(shared, 0.0);
        self.local.resize(triangles.len(), Vec::new());
        let mut squares = vec![0.0; shared];
        for (triangle, own) in triangles.iter().zip(&mut self.local) {
            let local = triangle.ncols() - shared - 1;
            own.resize(local, 0.0);
            for (k, most) in own.iter_mut().enumerate() {
                *most = most.max(triangle.column(k).norm());
            }
            for (k, sum) in squares.iter_mut().enumerate() {
                *sum += triangle.column(local + k).norm_squared();
            }
        }
        for (most, square) in self.shared.iter_mut().zip(squares) {
            *most = most.max(square.sqrt());
        }
    }
}

/// Step, and the decrease of the cost that the linear model predicts.
struct Step {
    shared: DVector<f64>,
    local: Vec<DVector<f64>>,
    expected: f64,
}

impl Place {
    fn moved(&self, step: &Step) -> Self {
        let add = |a: &[f64], b: &DVector<f64>| a.iter().zip(b.iter()).map(|(a, b)| a + b).collect();
        Self {
            shared: add(&self.shared, &step.shared),
            local: self.local.iter().zip(&step.local).map(|(a, b)| add(a, b)).collect(),
        }
    }
}

/// Solves (JᵀJ + damping D²) step = Jᵀr by triangles, after elimination of each group's local
/// parameters.
///
/// Returns `None` if the system is singular.
fn step(
    triangles: &[DMatrix<f64>],
    scale: &Scale,
    damping: f64,
    shared: usize,
) -> Result<Option<Step>, IdentifyError> {
    let root = damping.sqrt();
    let mut all = DMatrix::zeros(0, shared + 1);
    let mut own = Vec::new();
    for (triangle, scale) in triangles.iter().zip(&scale.local) {
        let local = scale.len();
        let damped = stacked(triangle, &damping_rows(scale, root, 0, triangle.ncols()))?;
        if damped.nrows() > local {
            all = stacked(
                &all,
                &damped.view((local, local), (damped.nrows() - local, shared + 1)).into_owned(),
            )?;
        }
        own.push(damped);
    }
    let all = stacked(&all, &damping_rows(&scale.shared, root, 0, shared + 1))?;
    let by_shared = back_substituted(&all.columns(0, shared).into_owned(), &all.column(shared).into_owned());
    let Some(step_shared) = by_shared else { return Ok(None) };
    let mut local = Vec::new();
    for (damped, scale) in own.iter().zip(&scale.local) {
        let n = scale.len();
        let right = damped.column(n + shared).rows(0, n) - damped.view((0, n), (n, shared)) * &step_shared;
        match back_substituted(&damped.view((0, 0), (n, n)).into_owned(), &right) {
            Some(own) => local.push(own),
            None => return Ok(None),
        }
    }
    // Predicted decrease: ½ (‖r‖² − ‖r − J step‖²).
    let mut expected = 0.0;
    for (triangle, own) in triangles.iter().zip(&local) {
        let n = own.len();
        let moved = triangle.columns(0, n) * own + triangle.columns(n, shared) * &step_shared;
        let residual = triangle.column(n + shared);
        expected += 0.5 * (residual.norm_squared() - (residual - moved).norm_squared());
    }
    Ok(expected.is_finite().then_some(Step { shared: step_shared, local, expected }))
}

/// Lower bound on the scale of a parameter, relative to the largest.
const LEAST_SCALE: f64 = 1e-3;

/// Returns the damping rows: root × scale on the diagonal.
fn damping_rows(scale: &[f64], root: f64, first: usize, width: usize) -> DMatrix<f64> {
    let mut rows = DMatrix::zeros(scale.len(), width);
    // A parameter with little or no effect must not take large steps.
    let least = LEAST_SCALE * scale.iter().copied().fold(0.0, f64::max);
    for (k, scale) in scale.iter().enumerate() {
        // A column of zeros belongs to a parameter without effect: it keeps its value.
        rows[(k, first + k)] = if *scale > 0.0 { root * scale.max(least) } else { 1.0 };
    }
    rows
}

/// Solves R x = b, with R the upper triangle of the first rows.
fn back_substituted(r: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    let n = r.ncols();
    if r.nrows() < n {
        return None;
    }
    r.view((0, 0), (n, n)).solve_upper_triangular(&b.rows(0, n).into_owned())
}
