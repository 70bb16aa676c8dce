//! Outcomes of free motion in closed form, without samples.

use polhode::motion::{FreeMotion, Method, Regime, Rotor, Scenario};

use super::extrema::{Extrema, angle, is_determined};
use super::instant::Instant;

/// Outcomes of a free motion.
pub(super) struct Found {
    pub(super) start: Instant,
    pub(super) end: Instant,
    pub(super) extrema: Extrema,
}

/// Returns the free motion of a scenario and its end time, s. `None` if torques act, or if events
/// or pointings need samples.
pub(super) fn motion(scenario: &Scenario, rotor: &Rotor) -> Option<(FreeMotion, f64)> {
    let run = scenario.run()?;
    let end = run.times.last().copied().filter(|end| end.is_finite())?;
    let alone = scenario.is_free() && scenario.events().is_empty() && scenario.pointings().is_empty();
    let exact = matches!(run.method, Method::Auto | Method::Exact);
    if !(alone && exact && end >= scenario.start().time) {
        return None;
    }
    FreeMotion::of(rotor, scenario.start()).ok().map(|motion| (motion, end))
}

/// Returns the start, end and extrema; `None` if energy or momentum overflow.
pub(super) fn outcome(motion: &FreeMotion, end: f64) -> Option<Found> {
    let (start, last) = (motion.start(), motion.at(end));
    let [l0, l1] = [start, last].map(|state| state.attitude * motion.angular_momentum(&state));
    let instant = |state: polhode::motion::State, momentum: f64| Instant {
        state,
        kinetic_energy: 0.5 * state.omega.dot(motion.angular_momentum(&state)),
        momentum,
    };
    let (first, last) = (instant(start, l0.norm()), instant(last, l1.norm()));
    let numbers = [first.kinetic_energy, first.momentum, last.kinetic_energy, last.momentum];
    if !numbers.iter().all(|x| x.is_finite()) {
        return None;
    }
    let relative = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part / whole };
    let extrema = Extrema {
        omega: Some(omega(motion)),
        from_least: angles(motion, 0),
        from_greatest: angles(motion, 2),
        torque: None,
        energy_drift: Some(relative(
            (last.kinetic_energy - first.kinetic_energy).abs(),
            first.kinetic_energy,
        )),
        momentum_drift: Some(relative((l1 - l0).norm(), first.momentum)),
    };
    Some(Found { start: first, end: last, extrema })
}

/// Returns the extrema of |ω|. |ω|² = a1² cn² + a2² sn² + a3² dn² is linear in sn², so they are at
/// sn = 0 and sn = 1.
fn omega(motion: &FreeMotion) -> [f64; 2] {
    if let Regime::Permanent(_) | Regime::AtRest = motion.regime() {
        return [motion.start().omega.norm(); 2];
    }
    let ([a1, a2, a3], k1) = (motion.amplitudes(), motion.complementary_modulus());
    let (at_0, at_1) = (libm::hypot(a1, a3), libm::hypot(a2, a3 * k1));
    [at_0.min(at_1), at_0.max(at_1)]
}

/// Returns the smallest and largest angle between L and principal axis 0 or 2, rad. `None` if the
/// tensor does not determine the axis, or L is zero.
fn angles(motion: &FreeMotion, axis: usize) -> Option<[f64; 2]> {
    use std::f64::consts::{FRAC_PI_2, PI};
    let principal = motion.principal();
    if !is_determined(principal.symmetry(), axis) || motion.regime() == Regime::AtRest {
        return None;
    }
    let momentum = motion.angular_momentum(&motion.start());
    let at_start = angle(principal.axis(axis), momentum)?;
    if let Regime::Permanent(_) = motion.regime() {
        return Some([at_start; 2]);
    }
    if motion.circles_least() == (axis == 0) {
        let [least, most] = motion.nutation_range();
        return Some(if at_start > FRAC_PI_2 { [PI - most, PI - least] } else { [least, most] });
    }
    // L along the other extreme axis is i1 a1 cn, which oscillates between ± its amplitude.
    let ([i1, ..], [a1, ..]) = (motion.labelled_moments(), motion.amplitudes());
    let swing = libm::asin((i1 * a1 / momentum.norm()).min(1.0));
    Some([FRAC_PI_2 - swing, FRAC_PI_2 + swing])
}
