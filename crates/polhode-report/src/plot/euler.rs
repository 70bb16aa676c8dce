//! Euler angles against time: the nutation θ above, φ and ψ below.
//!
//! φ and ψ are drawn as they go on, not from −180° to 180°. Where θ is 0 or 180° only their sum or difference exists, and
//! near there they may turn by half a turn from one sample to the next: a curve that cannot be followed is broken.

use std::f64::consts::{FRAC_PI_2, TAU};

use polhode::Sample;

use super::axes::{Area, Axes, Key};
use super::error::PlotError;
use super::motion::MotionFigures;
use super::series::{Heading, axis, pieces, time_axis};
use super::sheet::{Pen, Point, Sheet};

pub(super) fn draw(
    motion: &MotionFigures<'_>,
    sheet: &mut Sheet,
    heading: Heading<'_>,
) -> Result<(), PlotError> {
    // A turn that is missed would be drawn as a slower one.
    let turn = largest_turn(motion.samples());
    if !(turn <= FRAC_PI_2) {
        return Err(PlotError::TooCoarse { turn });
    }
    let [phi, theta, psi] = [Pen::axis(0), Pen::axis(1), Pen::axis(2)];
    let keys = [(theta, "θ nutation"), (phi, "φ precession"), (psi, "ψ spin")];
    let area = heading(sheet, &keys.map(|(pen, name)| Key::line(pen, name)));
    let middle = area.top + 0.4 * area.height();
    let (upper, lower) = (Area { bottom: middle, ..area }, area.below(0.4 * area.height() + 4.0));

    let (x, scale) = time_axis(motion.samples(), area.width());
    let angles: Vec<(f64, [f64; 3])> =
        motion.samples().iter().map(|s| (s.state.time / scale, s.state.attitude.euler313())).collect();
    let nutation: Vec<Point> = angles.iter().map(|(t, [_, theta, _])| [*t, theta.to_degrees()]).collect();
    let around = [0, 2].map(|k| followed(&angles, k));
    let values = || around.iter().flatten().flatten().map(|p| p[1]);
    let most = values().map(f64::abs).fold(0.0, f64::max);
    let (unit, size) = if most > 20.0 * 360.0 { ("turns", 360.0) } else { ("deg", 1.0) };
    let around = around.map(|pieces| -> Vec<Vec<Point>> {
        pieces.into_iter().map(|piece| piece.into_iter().map(|[t, a]| [t, a / size]).collect()).collect()
    });
    let theta_axis = axis(nutation.iter().map(|p| p[1]), upper.height(), "θ", "deg");
    let other_axis = axis(around.iter().flatten().flatten().map(|p| p[1]), lower.height(), "φ, ψ", unit);
    let left = Axes::beside(&theta_axis).max(Axes::beside(&other_axis));
    let axes = Axes::within(upper, x.clone().bare(), theta_axis, Some(left));
    axes.draw(sheet);
    pieces(&axes, &[nutation], theta, sheet);
    let axes = Axes::within(lower, x, other_axis, Some(left));
    axes.draw(sheet);
    for (curve, pen) in around.iter().zip([phi, psi]) {
        pieces(&axes, curve, pen, sheet);
    }
    Ok(())
}

/// The largest |ω| Δt, rad.
fn largest_turn(samples: &[Sample]) -> f64 {
    let turn = |pair: &[Sample]| match pair {
        [a, b] => (b.state.time - a.state.time) * a.state.omega.norm().max(b.state.omega.norm()),
        _ => 0.0,
    };
    samples.windows(2).map(turn).fold(0.0, f64::max)
}

/// φ (k = 0) or ψ (k = 2) in degrees, as it goes on, in the pieces that can be followed.
fn followed(angles: &[(f64, [f64; 3])], k: usize) -> Vec<Vec<Point>> {
    /// Nearer to θ = 0 or 180° than this φ and ψ are rounding, rad.
    const POLE: f64 = 1e-6;
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut last: Option<f64> = None;
    let mut lifted = true;
    let at_pole = |angle: &[f64; 3]| angle[1].sin() < POLE;
    // A body that turns about its own axis 3 and the space's: all of its turn is in φ.
    let always = angles.iter().all(|(_, angle)| at_pole(angle));
    for (t, angle) in angles {
        if at_pole(angle) && !always {
            lifted = true;
            continue;
        }
        let raw = angle.get(k).copied().unwrap_or_default();
        let next = last.map_or(raw, |last| raw + TAU * ((last - raw) / TAU).round());
        lifted |= last.is_some_and(|last| (next - last).abs() > FRAC_PI_2);
        if lifted {
            pieces.push(Vec::new());
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push([*t, next.to_degrees()]);
        }
        (last, lifted) = (Some(next), false);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_go_on_and_break_at_the_poles() {
        // φ goes round at 40°/s; in the middle the body passes θ = 0, where φ jumps by half a turn.
        let angle = |k: i32| {
            let t = 0.5 * f64::from(k);
            let jump = if k > 40 { 180.0 } else { 0.0 };
            let phi = (40.0 * t + jump + 25.0_f64).to_radians();
            let wrapped = phi - TAU * (phi / TAU).round();
            (t, [wrapped, if k == 40 { 0.0 } else { 0.3 }, 0.1])
        };
        let pieces = followed(&(0..80).map(angle).collect::<Vec<_>>(), 0);
        assert_eq!(pieces.len(), 2);
        for p in &pieces[0] {
            assert!((p[1] - (40.0 * p[0] + 25.0)).abs() < 1e-9);
        }
        let rise = pieces[1][38][1] - pieces[1][0][1];
        assert!((rise - 20.0 * 38.0).abs() < 1e-9);
    }
}
