//! Test of typical mistakes in a log.

use nalgebra::DMatrix;

use super::finding::{Mistake, PayloadFinding};
use super::log::PayloadLog;
use super::motion::Motion;
use super::regression::push;
use super::small::{self, Matrix6, Vector6};
use crate::least_squares::{Information, Rows, stacked};

const ALL: [Mistake; 9] = [
    Mistake::AccelerationInG,
    Mistake::AccelerationHasGravity,
    Mistake::GravityReversed,
    Mistake::OmegaInDegrees,
    Mistake::AlphaInDegrees,
    Mistake::AnglesInDegrees,
    Mistake::AlphaReversed,
    Mistake::TorqueInCentimetres,
    Mistake::TorqueInMillimetres,
];
/// Ratios of χ², corrected to as read, that prove a mistake: [`BETTER`] if the corrected reduced χ²
/// is below [`NOISE`], otherwise [`FAR_BETTER`]. Many changes lower a large χ², but correcting a
/// mistake lowers it far more.
const BETTER: f64 = 0.5;
const NOISE: f64 = 2.0;
const FAR_BETTER: f64 = 1e-3;
/// Upper bound on the unexplained share of the squared torque, for a change of its unit. Division
/// by 1000 makes any torque and its residual small.
const EXPLAINED: f64 = 0.1;
/// Maximum number of rows used in the tests.
const TRIED: usize = 1000;

/// Returns the mistake whose correction explains the wrench best, if χ² falls enough.
pub(super) fn likeliest(log: &PayloadLog, noise: &Matrix6, weights: &[f64]) -> Option<PayloadFinding> {
    let as_given = fit(log, noise, weights, None)?.chi_square;
    let tried = ALL.into_iter().filter_map(|mistake| {
        let undone = fit(log, noise, weights, Some(mistake))?;
        let is_unit = matches!(mistake, Mistake::TorqueInCentimetres | Mistake::TorqueInMillimetres);
        let explains = !is_unit || undone.torque_left < EXPLAINED;
        (undone.mass > 0.0 && explains).then_some((mistake, undone.chi_square))
    });
    let (mistake, undone) = tried.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let better = if undone < NOISE { BETTER } else { FAR_BETTER };
    (undone < better * as_given).then_some(PayloadFinding::Likely { mistake, as_given, undone })
}

/// Unconstrained least-squares fit.
struct Fit {
    mass: f64,
    /// Reduced χ².
    chi_square: f64,
    /// Unexplained share of the squared torque.
    torque_left: f64,
}

fn fit(log: &PayloadLog, noise: &Matrix6, weights: &[f64], mistake: Option<Mistake>) -> Option<Fit> {
    let n = log.unknowns();
    let l = small::cholesky(noise)?;
    let (mut force, mut torque) = (Rows::new(0, n), Rows::new(0, n));
    let stride = log.rows().len().div_ceil(TRIED);
    for (row, _) in log.rows().iter().zip(weights).step_by(stride).filter(|(_, w)| **w > 0.0) {
        let mut wrench = row.wrench();
        let mut motion = row.motion();
        if let Some(mistake) = mistake {
            undo(mistake, row.acceleration.to_array(), row.gravity.to_array(), &mut motion, &mut wrench);
        }
        let regressor = motion.regressor();
        let residual = small::forward(&l, wrench);
        push(log, &l, &regressor, residual, [&mut force, &mut torque]);
    }
    let count = force.count() + torque.count();
    let torque = torque.triangle(&[]).ok()?;
    let triangle: DMatrix<f64> = stacked(&force.triangle(&[]).ok()?, &torque).ok()?;
    let (r, z) = (triangle.columns(0, n), triangle.column(n));
    let information = Information::of(&r.into_owned()).ok()?;
    let mut numbers = &information.root * (information.root.transpose() * r.tr_mul(&z));
    let left = z - r * &numbers;
    numbers += &information.root * (information.root.transpose() * r.tr_mul(&left));
    let left = z - r * &numbers;
    let torque_left = (torque.column(n) - torque.columns(0, n) * &numbers).norm_squared();
    Some(Fit {
        mass: numbers[0],
        chi_square: left.norm_squared() / (count as f64 - n as f64).max(1.0),
        torque_left: torque_left / torque.column(n).norm_squared(),
    })
}

fn undo(mistake: Mistake, a: [f64; 3], g: [f64; 3], motion: &mut Motion, wrench: &mut Vector6) {
    /// Standard gravity, m/s².
    const G: f64 = 9.806_65;
    let degrees = core::f64::consts::PI / 180.0;
    let m = &mut motion.0;
    match mistake {
        Mistake::AccelerationInG => (0..3).for_each(|k| m[6 + k] = G * a[k] - g[k]),
        Mistake::AccelerationHasGravity => m[6..].copy_from_slice(&a),
        Mistake::GravityReversed => (0..3).for_each(|k| m[6 + k] = a[k] + g[k]),
        Mistake::OmegaInDegrees => m[..3].iter_mut().for_each(|w| *w *= degrees),
        Mistake::AlphaInDegrees => m[3..6].iter_mut().for_each(|w| *w *= degrees),
        Mistake::AnglesInDegrees => m[..6].iter_mut().for_each(|w| *w *= degrees),
        Mistake::AlphaReversed => m[3..6].iter_mut().for_each(|w| *w = -*w),
        Mistake::TorqueInCentimetres => wrench[3..].iter_mut().for_each(|t| *t *= 1e-2),
        Mistake::TorqueInMillimetres => wrench[3..].iter_mut().for_each(|t| *t *= 1e-3),
    }
}
