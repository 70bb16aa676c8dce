//! Angles of the two cones that ω describes in a free motion, in the body and in space.

use polhode::motion::{FreeMotion, Regime};
use polhode::observe::SymmetricTopKind;
use serde_json::{Value, json};

use crate::report::free_facts::FreeFacts;

/// Angles of ω from the axis that L circles, and from L.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ConeAngles {
    /// Least and greatest angle between ω and the line of the axis that L circles, rad; equal for a
    /// circular cone.
    pub body: [f64; 2],
    /// Least and greatest angle between ω and L, rad.
    pub space: [f64; 2],
    /// Direction of the precession of a symmetric top; `None` for other bodies, whose cones are not
    /// circular.
    pub precession: Option<Precession>,
}

/// Direction of rotation of a free symmetric top about its axis e, relative to its precession about
/// L.
///
/// It is prograde if ψ̇ and φ̇ cos θ have the same sign, else retrograde.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precession {
    /// Prolate top, I_e < I_t: the body cone rolls on the outside of the space cone.
    Prograde,
    /// Oblate top, I_e > I_t: ψ̇ = −(I_e − I_t) ω_e / I_t is opposite to ω_e. The space cone is
    /// inside the body cone, which rolls around it.
    Retrograde,
}

impl ConeAngles {
    /// Returns the angles of a free motion.
    ///
    /// Along the labelled axes ω = (a1 cn, a2 sn, a3 dn). Its angles have extrema where sn = 0, at
    /// (a1, 0, a3), and where |sn| = 1, at (0, a2, k₁ a3).
    pub(crate) fn of(free: &FreeFacts) -> Self {
        let motion = &free.motion;
        let [a1, a2, a3] = motion.amplitudes().map(f64::abs);
        let [i1, i2, i3] = motion.labelled_moments();
        let ends = [(a1, a3, i1), (a2, motion.complementary_modulus() * a3, i2)];
        let body = ends.map(|(across, along, _)| across.atan2(along));
        // tan ∠(ω, L) = |ω × L| / (ω · L) for ω = (a, b) and L = (i a, i3 b), scaled against
        // overflow.
        let space = ends.map(|(across, along, moment)| {
            let (rate, largest) = (across.max(along), moment.max(i3));
            let ([a, b], [i, k]) = ([across / rate, along / rate], [moment / largest, i3 / largest]);
            (a * b * (k - i).abs()).atan2(i * a * a + k * b * b)
        });
        let precession = free.top.map(|(top, _)| match top.kind() {
            SymmetricTopKind::Prolate => Precession::Prograde,
            SymmetricTopKind::Oblate => Precession::Retrograde,
        });
        Self { body: ascending(body), space: ascending(space), precession }
    }

    pub(crate) fn json(&self) -> Value {
        json!({
            "body": self.body,
            "space": self.space,
            "precession": self.precession.map(Precession::name),
        })
    }
}

impl Precession {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Prograde => "prograde",
            Self::Retrograde => "retrograde",
        }
    }
}

/// Returns true unless ω is constant in the body.
pub(crate) const fn is_moving(motion: &FreeMotion) -> bool {
    !matches!(motion.regime(), Regime::Permanent(_) | Regime::AtRest)
}

fn ascending([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use polhode::math::{AngularVelocity, Attitude};
    use polhode::motion::State;

    fn facts(moments: [f64; 3], omega: [f64; 3]) -> FreeFacts {
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let start = State { time: 0.3, attitude, omega: AngularVelocity::from_array(omega) };
        FreeFacts::of(FreeMotion::of_moments(moments, start).unwrap())
    }

    fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
        let dot: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        let norm = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        (dot / norm(a) / norm(b)).acos()
    }

    #[test]
    fn they_are_the_extremes_along_the_motion() {
        for omega in [[0.5, 1.0, -0.7], [0.9, -0.4, 0.3], [-1.3, 0.2, 0.1]] {
            let free = facts([1.0, 1.7, 2.3], omega);
            let axis = if free.motion.circles_least() { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
            let (period, l) = (free.motion.period().unwrap(), free.motion.momentum().to_array());
            let (mut body, mut space) = (Vec::new(), Vec::new());
            for k in 0..20_000 {
                let state = free.motion.at(0.3 + period * f64::from(k) / 20_000.0);
                let from_axis = angle(state.omega.to_array(), axis);
                body.push(from_axis.min(PI - from_axis));
                space.push(angle(state.omega_space().to_array(), l));
            }
            let found = ConeAngles::of(&free);
            assert_eq!(found.precession, None);
            for (seen, [least, most]) in [(body, found.body), (space, found.space)] {
                let [low, high] =
                    [seen.iter().copied().fold(PI, f64::min), seen.iter().copied().fold(0.0, f64::max)];
                assert!(
                    (low - least).abs() < 1e-7 && (high - most).abs() < 1e-7,
                    "{low} {least} {high} {most}"
                );
                assert!(least < most);
            }
        }
    }

    /// Returns ψ̇ from attitudes: the rate of the body about e, relative to the plane of e and L.
    fn spin(free: &FreeFacts, axis: [f64; 3], across: [f64; 3]) -> f64 {
        let (top, _) = free.top.unwrap();
        let l = top.momentum_direction().to_array();
        let at = |time: f64| {
            let state = free.motion.at(time);
            let turned = |v: [f64; 3]| (state.attitude * polhode::math::Direction::from_array(v)).to_array();
            let (e, mark) = (turned(axis), turned(across));
            let cross = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            let node = cross(l, e);
            dot(cross(node, mark), e).atan2(dot(node, mark))
        };
        (at(0.301) - at(0.3)) / 0.001
    }

    #[test]
    fn oblate_tops_precess_retrograde_and_prolate_ones_prograde() {
        for (moments, axis, across, omega, wanted) in [
            ([0.7, 0.7, 1.15], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.4, -0.3, 1.1], Precession::Retrograde),
            ([0.7, 0.7, 1.15], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.4, -0.3, -1.1], Precession::Retrograde),
            ([0.5, 1.3, 1.3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.9, 0.3, -0.5], Precession::Prograde),
            ([0.5, 1.3, 1.3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.9, 0.3, -0.5], Precession::Prograde),
        ] {
            let free = facts(moments, omega);
            let (top, cones) = free.top.unwrap();
            let found = ConeAngles::of(&free);
            assert_eq!(found.precession, Some(wanted));
            for [least, most] in [found.body, found.space] {
                assert!((most - least).abs() < 1e-15);
            }
            assert!((found.body[0] - cones.body_half_angle).abs() < 1e-15);
            assert!((found.space[0] - cones.space_half_angle).abs() < 1e-15);
            // φ̇ > 0 about L; its component along e has the sign of L · e, which equals that of ω ·
            // e.
            let spin = spin(&free, axis, across);
            assert!((spin + top.body_rate()).abs() < 1e-6, "{spin}");
            assert_eq!(spin * top.spin() > 0.0, wanted == Precession::Prograde);
            // If e, L and ω are in this order, L is inside the body cone.
            let inside = cones.nutation < cones.body_half_angle;
            assert_eq!(inside, wanted == Precession::Retrograde);
        }
    }

    #[test]
    fn a_permanent_rotation_has_none() {
        let free = facts([1.0, 2.0, 3.0], [0.0, 0.0, -2.0]);
        let found = ConeAngles::of(&free);
        assert_eq!((found.body, found.space, is_moving(&free.motion)), ([0.0; 2], [0.0; 2], false));
    }
}
