//! Euler angles against time: the nutation θ above, φ and ψ below.
//!
//! φ and ψ are drawn as continuous curves, not limited to −180° … 180°. At θ = 0 only φ + ψ is
//! defined, and at θ = 180° only φ − ψ.
//!
//! When a body passes close to such a pole, φ and ψ change by half a turn within a short time. If
//! the samples do not resolve this, both curves have a gap within 1.1° of the pole. The continuous
//! sum or difference is drawn in addition. It is drawn alone if θ stays at the pole.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use polhode::motion::Sample;
use polhode_document::figure::sheet::{Colour, Pen, Point};

use super::chart::{Chart, Quantity};
use super::curve::Curve;
use super::error::PlotError;
use super::figure::Figure;
use super::plotted::PlottedMotion;
use crate::report::sampling::largest_turn;

/// Value of sin θ below which the attitude is close to a pole: within 1.1°.
const NEAR: f64 = 0.02;

/// Value of sin θ below which φ and ψ are rounding errors; if always below, θ is one too.
const NOTHING: f64 = 1e-9;

/// Largest change of φ or ψ between samples that can be followed close to a pole, rad.
const LEAP: f64 = 1.0;

/// Curve in pieces without gaps: time, s, and angle, degrees.
type Pieces = Vec<Vec<Point>>;

/// Returns a chart of the Euler angles.
///
/// # Errors
/// [`PlotError::TooCoarse`] if the body turns too far from a sample to the next.
pub(crate) fn chart<'a>(motion: &'a PlottedMotion<'a>) -> Result<Chart<'a>, PlotError> {
    // A missed revolution would be drawn as a slower rotation.
    let turn = largest_turn(motion.samples());
    if !(turn <= FRAC_PI_2) {
        return Err(PlotError::TooCoarse { figure: Figure::Euler, turn });
    }
    let angles = Angles::of(motion.samples());
    let thin = Pen::solid(Colour::BLACK, 1.1);
    let curve = |pen, name: &str, symbol: &str, pieces| Curve {
        pen,
        name: name.to_owned(),
        symbol: symbol.to_owned(),
        pieces,
    };
    let mut around = vec![
        curve(Pen::axis(0), "φ precession", "φ", angles.phi()),
        curve(Pen::axis(2), "ψ spin", "ψ", angles.psi()),
        curve(thin, "φ + ψ", "φ + ψ", angles.sum()),
        curve(thin.dashed(&[7.0, 2.5]), "φ − ψ", "φ − ψ", angles.difference()),
    ];
    around.retain(|curve| !curve.pieces.is_empty());
    let around = Quantity::new("", "deg", around).made_of(180.0);
    Ok(match angles.stays() {
        Some(end) => {
            let sign = if end == 0 { "+" } else { "−" };
            Chart::new(motion, vec![around])
                .saying(&format!("θ = {end}\u{a0}deg: of φ and ψ there is only φ\u{a0}{sign}\u{a0}ψ"))
        }
        None => {
            let tilt = curve(Pen::axis(1), "θ nutation", "θ", angles.theta());
            Chart::new(motion, vec![Quantity::new("θ", "deg", vec![tilt]).made_of(180.0), around])
        }
    })
}

/// Euler angles of the attitudes of a motion.
struct Angles(Vec<At>);

/// Euler angles of one attitude: time, s; φ, θ, ψ; φ + ψ; φ − ψ, rad.
struct At {
    time: f64,
    euler: [f64; 3],
    sum: f64,
    difference: f64,
    /// True if φ and ψ are defined and can be followed.
    has_both: bool,
    /// True if they cannot be followed from the previous sample.
    is_beyond: bool,
}

impl Angles {
    fn of(samples: &[Sample]) -> Self {
        let at = |s: &Sample| {
            let [w, x, y, z] = s.state.attitude.quaternion();
            // The quaternion is (cos ½θ cos ½(φ + ψ), sin ½θ cos ½(φ − ψ), sin ½θ sin ½(φ − ψ), cos
            // ½θ sin ½(φ + ψ)).
            let [sum, difference] = [2.0 * z.atan2(w), 2.0 * y.atan2(x)];
            let euler = s.state.attitude.euler313();
            At {
                time: s.state.time,
                euler,
                sum,
                difference,
                has_both: euler[1].sin() >= NOTHING,
                is_beyond: false,
            }
        };
        let mut all: Vec<At> = samples.iter().map(at).collect();
        let beyond: Vec<bool> =
            all.windows(2).map(|w| matches!(w, [a, b] if a.leap(b) > FRAC_PI_2)).collect();
        for (at, beyond) in all.iter_mut().skip(1).zip(beyond) {
            at.is_beyond = beyond;
        }
        for part in all.chunk_by_mut(|a, b| a.is_near() == b.is_near()) {
            let followed = part.windows(2).all(|pair| matches!(pair, [a, b] if a.leap(b) < LEAP));
            if part.first().is_some_and(At::is_near) && !followed {
                part.iter_mut().for_each(|at| at.has_both = false);
            }
        }
        Self(all)
    }

    /// Returns the pole at which θ stays, 0 or 180, degrees; `None` if it leaves the pole.
    fn stays(&self) -> Option<u8> {
        let within = |end: f64| self.0.iter().all(|at| (at.euler[1] - end).abs() < NOTHING);
        if within(0.0) {
            return Some(0);
        }
        within(PI).then_some(180)
    }

    fn theta(&self) -> Pieces {
        vec![self.0.iter().map(|at| [at.time, at.euler[1].to_degrees()]).collect()]
    }

    fn phi(&self) -> Pieces {
        followed(self.0.iter().map(|at| (at.time, at.has_both.then_some(at.euler[0]))))
    }

    fn psi(&self) -> Pieces {
        followed(self.0.iter().map(|at| (at.time, at.has_both.then_some(at.euler[2]))))
    }

    /// Returns φ + ψ if φ and ψ have a gap near θ = 0; it has a gap itself near 180°.
    fn sum(&self) -> Pieces {
        self.instead(|theta| theta < FRAC_PI_2, |at| at.sum)
    }

    /// Returns φ − ψ if φ and ψ have a gap near θ = 180°; it has a gap itself near 0.
    fn difference(&self) -> Pieces {
        self.instead(|theta| theta > FRAC_PI_2, |at| at.difference)
    }

    /// Returns the angle that replaces φ and ψ in their gaps near one pole; empty for a gap at the
    /// start only.
    fn instead(&self, here: impl Fn(f64) -> bool, value: impl Fn(&At) -> f64) -> Pieces {
        let wanted = self.0.iter().skip(1).any(|at| (at.is_beyond || !at.has_both) && here(at.euler[1]));
        let value = |at: &At| (wanted && (here(at.euler[1]) || !at.is_near())).then(|| value(at));
        followed(self.0.iter().map(|at| (at.time, value(at))))
    }
}

impl At {
    /// Returns true close to a pole.
    fn is_near(&self) -> bool {
        self.euler[1].sin() < NEAR
    }

    /// Returns the larger change of φ and ψ to the next sample, rad; 0 for undefined angles.
    fn leap(&self, next: &Self) -> f64 {
        let ([phi, _, psi], [next_phi, _, next_psi]) = (self.euler, next.euler);
        let turn = |a: f64, b: f64| (b - a - TAU * ((b - a) / TAU).round()).abs();
        let both = self.has_both && next.has_both;
        if both { turn(phi, next_phi).max(turn(psi, next_psi)) } else { 0.0 }
    }
}

/// Returns a continuous angle, degrees, from times, s, and angles, rad.
///
/// It has gaps where the angle is undefined or cannot be followed.
///
/// A pole changes the angle by half a turn in an unknown direction. After the pole it therefore
/// restarts between −180° and 180°.
fn followed(angles: impl Iterator<Item = (f64, Option<f64>)>) -> Pieces {
    let mut pieces: Pieces = Vec::new();
    let mut last: Option<f64> = None;
    let mut lifted = true;
    for (time, angle) in angles {
        let Some(raw) = angle else {
            lifted = true;
            continue;
        };
        let wrapped = raw - TAU * (raw / TAU).round();
        let near = last.map_or(wrapped, |last| raw + TAU * ((last - raw) / TAU).round());
        let jumps = last.is_some_and(|last| (near - last).abs() > FRAC_PI_2);
        let next = if jumps { wrapped } else { near };
        lifted |= jumps;
        if lifted {
            pieces.push(Vec::new());
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push([time, next.to_degrees()]);
        }
        (last, lifted) = (Some(next), false);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use polhode::math::{AngularVelocity, Attitude};
    use polhode::motion::{FreeMotion, State, Trajectory};

    use super::*;

    #[test]
    fn angles_go_on_and_break_where_there_are_none() {
        // φ rotates at 40°/s. Halfway the body passes θ = 0, where φ jumps by half a turn.
        let angle = |k: i32| {
            let t = 0.5 * f64::from(k);
            let jump = if k > 40 { 180.0 } else { 0.0 };
            let phi = (40.0 * t + jump + 25.0_f64).to_radians();
            let wrapped = phi - TAU * (phi / TAU).round();
            (t, (k != 40).then_some(wrapped))
        };
        let pieces = followed((0..80).map(angle));
        assert_eq!(pieces.len(), 2);
        for p in &pieces[0] {
            assert!((p[1] - (40.0 * p[0] + 25.0)).abs() < 1e-9);
        }
        let rise = pieces[1][38][1] - pieces[1][0][1];
        assert!((rise - 20.0 * 38.0).abs() < 1e-9);
    }

    /// A sphere rotates about an axis in the x-z plane of space, so that its Euler angles are
    /// known.
    #[test]
    fn sums_and_differences_go_on_through_the_ends() {
        let turning = |omega: AngularVelocity<polhode::math::Body>| {
            let start = State { time: 0.0, attitude: Attitude::identity(), omega };
            let motion = FreeMotion::of_moments([1.7; 3], start).unwrap();
            let times: Vec<f64> = (0..=300).map(|k| 0.018 * f64::from(k)).collect();
            Trajectory::of_motion(motion, &times).unwrap()
        };
        // Rotation about z: θ = 0, and only φ + ψ = ω t is defined.
        let about_z = turning(AngularVelocity::new(0.0, 0.0, 2.0));
        let angles = Angles::of(about_z.samples());
        assert_eq!(angles.stays(), Some(0));
        assert!(angles.phi().is_empty() && angles.psi().is_empty() && angles.difference().is_empty());
        let [sum] = &angles.sum()[..] else { panic!("it is broken") };
        assert!(sum.iter().all(|[t, a]| (a - (2.0 * t).to_degrees()).abs() < 1e-9));
        // Rotation about x: θ rises to 180° and falls again; φ and ψ are piecewise constant, φ − ψ
        // is constant.
        let about_x = turning(AngularVelocity::new(1.1, 0.0, 0.0));
        let angles = Angles::of(about_x.samples());
        assert_eq!(angles.stays(), None);
        let [rising, falling] = &angles.phi()[..] else { panic!("it is not broken in the middle") };
        assert!(
            rising.iter().all(|p| p[1].abs() < 1e-9)
                && falling.iter().all(|p| (p[1].abs() - 180.0).abs() < 1e-9)
        );
        let [difference] = &angles.difference()[..] else { panic!("it is broken") };
        assert!(difference.iter().all(|p| p[1].abs() < 1e-9 && p[0] > 0.0));
        // For so fast a rotation no sample is close to the pole, and φ still cannot be followed.
        let fast = turning(AngularVelocity::new(70.3, 0.0, 0.0));
        let angles = Angles::of(&fast.samples()[..5]);
        assert_eq!((angles.phi().len(), angles.difference().len()), (2, 1));
        assert!(angles.phi().iter().flatten().all(|p| p[1].abs() < 180.1));
        // At a distance from the pole the angles are followed all the way.
        let beside = turning(AngularVelocity::new(1.1, 0.0, 0.02));
        assert!(Angles::of(beside.samples()).difference().is_empty());
    }
}
