//! Moments that deviate strongly from those of the link's geometry: `inertia.geometry`.
//!
//! Bodies are not uniform, so the sum of the moments may differ by a factor of three. The sum does
//! not depend on the axes. The bound follows from extreme mass distributions: with all mass at the
//! corners of a box, the sum is three times that of the uniform box, and no distribution within the
//! box has more. A thin shell has 5/3 (ball) to 2 (tube). Below a third, the mass is within 0.6 of
//! the size.
//!
//! Exceptions:
//!
//! - Hulls and solids with an implausible density are not used.
//! - A primitive of low density is a simplified box around the body. It gives an upper bound for
//!   the moments, and a lower bound only if all three have the same ratio.
//! - Any solid of low density may contain a compact body. Then all moments are small, and their sum
//!   is at least that of a steel ball.
//! - Rounding of the written digits is included. One solid that agrees is sufficient.

use super::body::{Body, NAMES};
use super::dummy::{FRAME, Held};
use super::factor::RULE;
use super::finding;
use super::gyration::is_padded;
use super::material::is_solid;
use super::possible::TYPED;
use super::written::{short, significant};
use crate::finding::{Finding, Severity};
use crate::geometry::{Volume, VolumeKind};
use crate::moments::{Elements, trace};

/// Permitted ratio of the sums of the moments, in both directions.
const FACTOR: f64 = 3.0;

/// Density below which a primitive is assumed to be a box around the body, kg/m³.
const AROUND: f64 = 300.0;

/// Density below which the body may be compact within its solid, kg/m³. Aluminium, 2,700 kg/m³,
/// that fills a fifth of the volume has a third of the moments, since 5^(−2/3) = 0.34.
const COMPACT: f64 = 500.0;

/// Density of steel, kg/m³.
const STEEL: f64 = 7850.0;

/// Factor within which ratios count as equal.
const ONE_RATIO: f64 = 1.01;

fn extremes(values: [f64; 3]) -> [f64; 2] {
    [values.into_iter().fold(f64::INFINITY, f64::min), values.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// Returns true if the moments are equal, as for cubes and balls. Equal ratios are then no evidence
/// about the shape.
fn is_isotropic([xx, yy, zz, ..]: Elements) -> bool {
    let [least, greatest] = extremes([xx, yy, zz]);
    greatest <= 1.05 * least
}

pub(super) fn check(body: &Body, held: Held, findings: &mut Vec<Finding>) {
    if body.geometry.is_incomplete || !body.has_plausible_density() {
        return;
    }
    // Numbers with one digit were typed and are exact.
    let rounded = body.numbers().filter(|(k, number)| *k < 3 && significant(&number.text) >= 2);
    let digits = rounded.map(|(k, _)| body.rounding[k]).sum::<f64>() / trace(&body.written);
    // Moment about each axis: ⅖ m r².
    let radius = (0.75 * body.mass / STEEL / std::f64::consts::PI).cbrt();
    let ball = 1.2 * body.mass * radius * radius;
    let factor = FACTOR * (1.0 + digits.min(TYPED));
    let mut worst: Option<(f64, [f64; 3], &Volume)> = None;
    for solid in body.solids() {
        let target = body.in_inertial_axes(&body.implied(solid, body.mass));
        let ratios = [0, 1, 2].map(|k| body.written[k] / target[k]);
        let ratio = trace(&body.written) / trace(&target);
        let density = body.mass / solid.volume;
        let accuses = solid.kind != VolumeKind::Hull && is_solid(density);
        let [least, greatest] = extremes(ratios);
        let is_proportional = greatest <= ONE_RATIO * least && !is_isotropic(target);
        let is_compact = density < COMPACT && greatest < 1.0 / FACTOR && trace(&body.written) >= ball;
        let is_box = solid.kind == VolumeKind::Primitives && density < AROUND;
        let is_around = (is_box || is_compact) && !is_proportional;
        let off = if is_around { ratio } else { ratio.max(1.0 / ratio) };
        if !(off > factor) {
            return;
        }
        if accuses && worst.is_none_or(|(least, ..)| off < least) {
            worst = Some((off, ratios, solid));
        }
    }
    let Some((off, ratios, solid)) = worst else { return };
    let target = body.in_inertial_axes(&body.implied(solid, body.mass));
    let list = |values: [f64; 3], digits| {
        [0, 1, 2].map(|k| format!("{} {}", NAMES[k], short(values[k], digits))).join(", ")
    };
    let [xx, yy, zz, ..] = target;
    let message = format!(
        "ixx, iyy, izz are {} times those of the geometry with {} kg ({} kg·m²)",
        list(ratios, 3),
        short(body.mass, 4),
        list([xx, yy, zz], 4),
    );
    let is_dummy = held == Held::Dummy || body.mass <= FRAME;
    let severity = if is_dummy || is_padded(body, held, off) { Severity::Note } else { Severity::Suspect };
    let mut found = finding("inertia.geometry", severity, body.link, body.tensor_place(), message, RULE);
    let ratio = trace(&body.written) / trace(&target);
    found.numbers =
        vec![("ratio", ratio), ("ratio_xx", ratios[0]), ("ratio_yy", ratios[1]), ("ratio_zz", ratios[2])];
    findings.push(found);
}
