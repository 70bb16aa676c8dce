//! The solver of conic programs, Clarabel: what it says is checked by who asks.

use super::row::Kind;

/// A matrix by its columns.
#[derive(Debug)]
pub(super) struct Columns {
    rows: usize,
    starts: Vec<usize>,
    places: Vec<usize>,
    values: Vec<f64>,
}

/// What the solver says.
#[derive(Debug)]
pub(super) struct Solved {
    /// Whether there is an x.
    pub(super) is_feasible: bool,
    pub(super) x: Vec<f64>,
    /// The dual: of what is not feasible, a certificate.
    pub(super) z: Vec<f64>,
}

impl Columns {
    pub(super) fn of_rows(rows: usize) -> Self {
        Self { rows, starts: vec![0], places: Vec::new(), values: Vec::new() }
    }

    /// One more, by its rows in their order.
    pub(super) fn push(&mut self, column: impl Iterator<Item = (usize, f64)>) {
        for (place, value) in column {
            self.places.push(place);
            self.values.push(value);
        }
        self.starts.push(self.places.len());
    }
}

/// Whether this was built with the solver.
pub(super) const IS_THERE: bool = cfg!(feature = "ballast");

/// The least Σ x of A x + s = b with s in cones.
///
/// `None` if the solver gives up, or if a number is not finite.
#[cfg(feature = "ballast")]
pub(super) fn least_sum(a: Columns, b: &[f64], cones: &[(Kind, usize)]) -> Option<Solved> {
    use clarabel::algebra::CscMatrix;
    use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};

    if !a.values.iter().chain(b).all(|x| x.is_finite()) {
        return None;
    }
    let columns = a.starts.len() - 1;
    let cone = |(kind, rows): &(Kind, usize)| match kind {
        Kind::Zero => SupportedConeT::ZeroConeT(*rows),
        Kind::Positive => SupportedConeT::NonnegativeConeT(*rows),
        Kind::Cone => SupportedConeT::SecondOrderConeT(*rows),
    };
    let cones: Vec<SupportedConeT<f64>> = cones.iter().map(cone).collect();
    let a = CscMatrix::new(a.rows, columns, a.starts, a.places, a.values);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(1e-14)
        .tol_gap_rel(1e-13)
        .tol_feas(1e-13)
        .tol_infeas_abs(1e-12)
        .tol_infeas_rel(1e-12)
        .build()
        .ok()?;
    let (q, p) = (vec![1.0; columns], CscMatrix::zeros((columns, columns)));
    let mut solver = DefaultSolver::new(&p, &q, &a, b, &cones, settings).ok()?;
    solver.solve();
    let solution = solver.solution;
    // Whatever the solver says of its own tolerances: what is proved is checked, and so are the pieces.
    let is_feasible = match solution.status {
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => false,
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible | SolverStatus::Unsolved => {
            return None;
        }
        _ => true,
    };
    Some(Solved { is_feasible, x: solution.x, z: solution.z })
}

/// Nothing is solved.
#[cfg(not(feature = "ballast"))]
#[allow(clippy::needless_pass_by_value, reason = "as where there is a solver")]
pub(super) fn least_sum(a: Columns, b: &[f64], cones: &[(Kind, usize)]) -> Option<Solved> {
    let _ = (a.rows, a.starts, a.places, a.values, b, cones);
    None
}

#[cfg(all(test, feature = "ballast"))]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_not_finite_are_not_given_to_the_solver() {
        let solved = |element: f64, right: f64| {
            let mut a = Columns::of_rows(1);
            a.push([(0, element)].into_iter());
            least_sum(a, &[right], &[(Kind::Positive, 1)])
        };
        // x ≥ 2: −x + s = −2
        assert!((solved(-1.0, -2.0).unwrap().x[0] - 2.0).abs() < 1e-9);
        assert!(solved(f64::NAN, -2.0).is_none() && solved(-1.0, f64::INFINITY).is_none());
    }
}
