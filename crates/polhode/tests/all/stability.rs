//! Permanent rotations and small oscillations, compared with closed forms and simulated
//! perturbations.

use polhode::motion::torque::EnergySink;
use polhode::motion::{Motor, Pendulum};
use polhode::observe::{Libration, PermanentRotation, SmallOscillations, Stability};
use polhode::prelude::*;

fn tensor(moments: [f64; 3], r: Rotation<Body, Body>) -> InertiaTensor<Body> {
    InertiaTensor::diagonal(moments).unwrap().in_frame(r)
}

fn generic_turn() -> Rotation<Body, Body> {
    Rotation::from_axis_angle(Direction::new(0.3, -0.8, 0.5), 1.1).unwrap()
}

fn free(moments: [f64; 3]) -> Rotor {
    Rotor::free(
        &MassProperties::new(2.3, Position::new(0.1, -0.2, 0.3), tensor(moments, generic_turn())).unwrap(),
    )
}

fn spin(axis: Direction<Body>, rate: f64) -> AngularVelocity<Body> {
    AngularVelocity::from_array((axis * rate).to_array())
}

/// Returns the growth rate of a small perturbation of ω after a time, and its largest magnitude.
fn departure(rotor: &Rotor, omega: AngularVelocity<Body>, end: f64) -> (f64, f64) {
    let small = 1e-7;
    let off = AngularVelocity::new(0.5 * small, -0.3 * small, 0.7 * small);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega: omega + off };
    let times: Vec<f64> = (0..=400).map(|k| end * f64::from(k) / 400.0).collect();
    let motion = Trajectory::compute(rotor, &[], start, &times, Method::Taylor, 1e-14).unwrap();
    let sizes: Vec<f64> = motion.samples().iter().map(|s| (s.state.omega - omega).norm() / small).collect();
    // over the last half, where only the growing part remains
    let rate = (sizes[400] / sizes[200]).ln() / (times[400] - times[200]);
    (rate, sizes.iter().copied().fold(0.0, f64::max))
}

#[test]
fn the_intermediate_axis_grows_and_the_others_do_not() {
    let moments = [1.3, 2.9, 3.7];
    let rotor = free(moments);
    let omega = 2.3;
    for k in 0..3 {
        let at = spin(rotor.principal().axis(k), omega);
        let found = PermanentRotation::of(&rotor, at).unwrap();
        let [i1, i2, i3] = moments;
        let (i, j) = [(i2, i3), (i1, i3), (i1, i2)][k];
        let c = omega * omega * (moments[k] - i) * (moments[k] - j) / (i * j);
        match found.stability {
            Stability::Stable { frequency, .. } => {
                assert!((frequency / c.sqrt() - 1.0).abs() < 1e-14);
                assert!(departure(&rotor, at, 12.0).1 < 5.0);
                assert_ne!(k, 1);
            }
            Stability::Unstable { growth_rate, .. } => {
                assert!(
                    (growth_rate / (((i2 - i1) * (i3 - i2) / (i1 * i3)).sqrt() * omega) - 1.0).abs() < 1e-14
                );
                let (rate, _) = departure(&rotor, at, 9.0);
                assert!((rate / growth_rate - 1.0).abs() < 1e-3, "{rate} {growth_rate}");
                assert_eq!(k, 1);
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn equal_moments_are_marginal() {
    for (moments, marginal) in [([2.0, 2.0, 3.0], [true, true, false]), ([2.0; 3], [true; 3])] {
        let rotor = free(moments);
        for (k, marginal) in marginal.into_iter().enumerate() {
            let found = PermanentRotation::of(&rotor, spin(rotor.principal().axis(k), 1.7)).unwrap();
            assert_eq!(found.stability == Stability::Marginal, marginal, "{moments:?} {k}");
        }
    }
}

/// A wheel of momentum h along the intermediate axis 2, at ω:
/// c = (h + (i2 − i1) ω)(h + (i2 − i3) ω)/(i1 i3). The threshold is h = (i3 − i2) ω, or
/// h = −(i2 − i1) ω against the spin.
#[test]
fn a_wheel_makes_the_intermediate_axis_stable_beyond_its_threshold() {
    let moments = [1.3, 2.9, 3.7];
    let [i1, i2, i3] = moments;
    let omega = 2.3;
    for (threshold, across) in
        [((i3 - i2) * omega, (i2 - i1) * omega), (-(i2 - i1) * omega, -(i3 - i2) * omega)]
    {
        for (part, stable) in [(0.9, false), (0.9999, false), (1.0001, true), (1.1, true)] {
            let rotor = free(moments);
            let axis = rotor.principal().axis(1);
            let h = part * threshold;
            let rotor = rotor.with_wheels(&[Wheel::new(axis, h, Motor::HeldSpeed).unwrap()]).unwrap();
            let found = PermanentRotation::of(&rotor, spin(axis, omega)).unwrap();
            let c = (h + (i2 - i1) * omega) * (h + (i2 - i3) * omega) / (i1 * i3);
            assert!(across * threshold > 0.0 && (c > 0.0) == stable);
            match found.stability {
                Stability::Stable { frequency, .. } => {
                    assert!(stable && (frequency / c.sqrt() - 1.0).abs() < 1e-11);
                }
                Stability::Unstable { growth_rate, .. } => {
                    assert!(!stable && (growth_rate / (-c).sqrt() - 1.0).abs() < 1e-11);
                }
                other => panic!("{other:?}"),
            }
            if (part - 1.0).abs() > 0.01 {
                let (rate, size) = departure(&rotor, spin(axis, omega), 12.0);
                if stable {
                    assert!(size < 20.0, "{part}: {size}");
                } else {
                    assert!((rate / (-c).sqrt() - 1.0).abs() < 0.01, "{part}: {rate} {c}");
                }
            }
        }
    }
}

#[test]
fn all_permanent_rotations_are_found() {
    let body = free([1.3, 2.9, 3.7]);
    // Without wheels: both senses about each axis.
    let all = PermanentRotation::all(&body, 5.0).unwrap();
    assert_eq!(all.len(), 6);
    let names: Vec<_> = all.iter().map(|p| p.stability.name()).collect();
    assert_eq!(names, ["stable", "stable", "unstable", "unstable", "stable", "stable"]);
    assert_eq!(PermanentRotation::all(&body, 0.0).unwrap().len(), 0);
    // With a generic wheel: six rotations if it is weak, two if it dominates; also along a
    // principal axis, and nearly zero.
    let [a, b, c] = [0, 1, 2].map(|k| body.principal().axis(k));
    let generic = a * 0.5 - b * 0.7 + c * 0.3;
    for (axis, h, count) in [
        (generic, 0.05, 6),
        (generic, 1e-9, 6),
        (generic, 40.0, 2),
        (b, 0.4, 6),
        (b, 40.0, 2),
        (a + c, 0.2, 6),
    ] {
        let rotor = body.clone().with_wheels(&[Wheel::new(axis, h, Motor::HeldSpeed).unwrap()]).unwrap();
        let all = PermanentRotation::all(&rotor, 5.0).unwrap();
        assert_eq!(all.len(), count, "{h}: {all:?}");
        for p in &all {
            assert!((p.momentum.norm() / 5.0 - 1.0).abs() < 1e-13, "{h}: {p:?}");
            let bending = p.momentum.cross(p.omega).norm();
            assert!(bending < 2e-13 * p.momentum.norm() * p.omega.norm(), "{h}: {bending:e} {p:?}");
            // Each of them is a permanent rotation.
            assert_eq!(PermanentRotation::of(&rotor, p.omega).unwrap().stability.name(), p.stability.name());
        }
        // Extrema on a sphere: the numbers of maxima and minima exceed that of saddles by two
        // (Euler, Poincaré).
        let saddles = all.iter().filter(|p| p.stability.name() == "unstable").count();
        assert_eq!(all.len() - saddles, saddles + 2, "{h}: {all:?}");
    }
    // Two equal moments, with a wheel along the axis of symmetry and one across it.
    let oblate = free([2.0, 2.0, 3.1]);
    for k in [0, 2] {
        let wheel = Wheel::new(oblate.principal().axis(k), 0.3, Motor::HeldSpeed).unwrap();
        let all = PermanentRotation::all(&oblate.clone().with_wheels(&[wheel]).unwrap(), 5.0).unwrap();
        assert!(
            all.len() >= 2 && all.iter().all(|p| p.momentum.cross(p.omega).norm() < 1e-12),
            "{k}: {all:?}"
        );
    }
}

#[test]
fn what_is_no_permanent_rotation_is_refused() {
    let body = free([1.3, 2.9, 3.7]);
    let off = PermanentRotation::of(&body, AngularVelocity::new(1.0, 2.0, 3.0));
    assert!(matches!(off, Err(MotionError::NotSteady { .. })), "{off:?}");
    let motor = Motor::Torque { inertia: 0.1, torque: 0.2, schedule: None };
    let driven =
        body.clone().with_wheels(&[Wheel::new(body.principal().axis(0), 1.0, motor).unwrap()]).unwrap();
    assert!(PermanentRotation::all(&driven, 5.0).is_err());
    let rod = Rotor::free(
        &MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([0.0, 1.0, 1.0]).unwrap()).unwrap(),
    );
    assert!(PermanentRotation::all(&rod, 5.0).is_err());
    assert!(PermanentRotation::all(&body, f64::NAN).is_err());
}

const G: f64 = 9.80665;

fn gravity() -> [TorqueModel; 1] {
    [TorqueModel::Gravity(UniformGravity::STANDARD)]
}

fn at(attitude: Attitude, omega: AngularVelocity<Body>) -> State {
    State { time: 0.0, attitude, omega }
}

/// Returns a body that hangs 0.37 m below its pivot, with given moments along x, y, z there, in
/// arbitrarily rotated axes.
fn hanging(moments: [f64; 3], r: Rotation<Body, Body>) -> (Rotor, Attitude) {
    let lever = Position::new(0.0, 0.0, -0.37);
    let mass = 2.3;
    let center = [moments[0] - mass * 0.37 * 0.37, moments[1] - mass * 0.37 * 0.37, moments[2]];
    let body = MassProperties::new(mass, r * lever, tensor(center, r)).unwrap();
    let upright = Attitude::identity() * r.inverse();
    (Rotor::pivoted(&body, Position::ZERO), upright)
}

#[test]
fn a_hanging_body_swings_about_two_axes() {
    let moments = [0.71, 0.83, 0.42];
    let r = generic_turn();
    let (rotor, upright) = hanging(moments, r);
    let swings =
        SmallOscillations::about_equilibrium(&rotor, &gravity(), at(upright, AngularVelocity::ZERO)).unwrap();
    assert_eq!((swings.modes.len(), swings.neutral), (2, 2));
    assert!(swings.is_stable());
    // the lower frequency is about the axis of greater moment
    for (mode, (moment, axis)) in swings.modes.iter().zip([(0.83, [0.0, 1.0, 0.0]), (0.71, [1.0, 0.0, 0.0])])
    {
        let expected = (2.3 * G * 0.37 / moment).sqrt();
        assert!((mode.frequency / expected - 1.0).abs() < 1e-10, "{mode:?} {expected}");
        assert_eq!(mode.growth_rate, 0.0);
        let along = r * Direction::<Body>::from_array(axis);
        assert!((mode.axis.dot(along).abs() - 1.0).abs() < 1e-9 && mode.minor_axis.norm() < 1e-9, "{mode:?}");
    }
    // The pendulum of the library has the same frequency about a fixed axis.
    let g = upright.inverse() * Acceleration::new(0.0, 0.0, -G);
    let pendulum = Pendulum::hung(&rotor, r * Direction::new(1.0, 0.0, 0.0), g).unwrap();
    assert!((swings.modes[1].frequency / pendulum.small_frequency() - 1.0).abs() < 1e-10);
    // Upside down it falls at the same rates.
    let over: Rotation<Space, Space> =
        Rotation::from_axis_angle(Direction::new(0.0, 1.0, 0.0), std::f64::consts::PI).unwrap();
    let falls =
        SmallOscillations::about_equilibrium(&rotor, &gravity(), at(over * upright, AngularVelocity::ZERO))
            .unwrap();
    assert!(!falls.is_stable());
    assert!((falls.modes[0].growth_rate / swings.modes[1].frequency - 1.0).abs() < 1e-9, "{falls:?}");
    assert_eq!(falls.modes[0].frequency, 0.0);
}

#[test]
fn the_nearest_equilibrium_is_found() {
    let (rotor, upright) = hanging([0.71, 0.83, 0.42], generic_turn());
    let away: Rotation<Space, Space> =
        Rotation::from_axis_angle(Direction::new(0.3, 0.9, -0.2), 0.6).unwrap();
    let start = at(away * upright, AngularVelocity::ZERO);
    let refused = SmallOscillations::about_equilibrium(&rotor, &gravity(), start);
    assert!(matches!(refused, Err(MotionError::NotSteady { .. })), "{refused:?}");
    let found = SmallOscillations::equilibrium_near(&rotor, &gravity(), start).unwrap();
    let lever = found.attitude * rotor.lever();
    assert!(lever.angle_to(Direction::new(0.0, 0.0, -1.0)) < 1e-14, "{lever:?}");
    assert!(SmallOscillations::about_equilibrium(&rotor, &gravity(), found).unwrap().is_stable());
    // The torque cannot vanish: an equilibrium does not exist.
    let constant = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, 0.2, 0.3)))];
    let none = SmallOscillations::equilibrium_near(&rotor, &constant, start);
    assert!(matches!(none, Err(MotionError::NotSteady { .. })), "{none:?}");
}

#[test]
fn a_wheel_makes_a_pendulum_a_gyroscope() {
    // Two equal moments I, a wheel h along the vertical: I s² ± i h s + M g l = 0, so ϖ = (√(h² + 4
    // I M g l) ± h)/2I.
    let (i, h) = (0.83, 1.9);
    let (rotor, upright) = hanging([i, i, 0.42], generic_turn());
    let wheel = Wheel::new(generic_turn() * Direction::new(0.0, 0.0, 1.0), h, Motor::HeldSpeed).unwrap();
    let rotor = rotor.with_wheels(&[wheel]).unwrap();
    let swings =
        SmallOscillations::about_equilibrium(&rotor, &gravity(), at(upright, AngularVelocity::ZERO)).unwrap();
    let root = (h * h + 4.0 * i * 2.3 * G * 0.37).sqrt();
    assert_eq!(swings.modes.len(), 2);
    for (mode, expected) in swings.modes.iter().zip([(root - h) / (2.0 * i), (root + h) / (2.0 * i)]) {
        assert!((mode.frequency / expected - 1.0).abs() < 1e-10, "{mode:?} {expected}");
        // It moves on a cone.
        assert!((mode.minor_axis.norm() - 1.0).abs() < 1e-8, "{mode:?}");
    }
}

/// A top that stands on its tip, with moments A across and C along at the pivot, spinning at ω3.
/// Its axis z = x + iy in space satisfies A z̈ − i C ω3 ż − M g l z = 0, so z = e^(iνt) with A
/// ν² − C ω3 ν + M g l = 0. In body axes, which turn at ω3, the frequency is ν − ω3.
#[test]
fn a_sleeping_top_wakes_below_its_threshold() {
    let (a, c, mgl) = (0.83, 0.42, 2.3 * G * 0.37);
    let (rotor, hangs) = hanging([a, a, c], Rotation::identity());
    let over: Rotation<Space, Space> =
        Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::PI).unwrap();
    let threshold = 2.0 * (mgl * a).sqrt() / c;
    for (part, sleeps) in [(0.5, false), (0.999, false), (1.001, true), (1.7, true)] {
        let omega = part * threshold;
        let top = SmallOscillations::about_equilibrium(
            &rotor,
            &gravity(),
            at(over * hangs, AngularVelocity::new(0.0, 0.0, omega)),
        )
        .unwrap();
        assert_eq!(top.is_stable(), sleeps, "{part}: {top:?}");
        let square = (c * omega) * (c * omega) - 4.0 * a * mgl;
        if sleeps {
            for sign in [1.0, -1.0] {
                let nu = (c * omega + sign * square.sqrt()) / (2.0 * a);
                let seen = (nu - omega).abs();
                assert!(
                    top.modes.iter().any(|m| (m.frequency - seen).abs() < 1e-8 * omega),
                    "{part} {seen}: {top:?}"
                );
            }
        } else {
            let growth = (-square).sqrt() / (2.0 * a);
            assert!((top.modes[0].growth_rate / growth - 1.0).abs() < 1e-8, "{part} {growth}: {top:?}");
            assert!((top.modes[0].frequency - (c * omega / (2.0 * a) - omega).abs()).abs() < 1e-8 * omega);
        }
    }
}

#[test]
fn friction_inside_damps_nutation_at_the_rate_of_its_closed_form() {
    // Spin about the axis of symmetry: tan θ is proportional to exp(αL²(1/I − 1/J)t).
    for (along, across) in [(1.3, 2.1), (3.3, 2.1)] {
        let body = MassProperties::new(
            1.0,
            Position::ZERO,
            InertiaTensor::diagonal([across, across, along]).unwrap(),
        )
        .unwrap();
        let rotor = Rotor::free(&body);
        let omega = 1.9;
        let alpha = 0.013;
        let sink = [TorqueModel::EnergySink(EnergySink::new(alpha).unwrap())];
        let spin = at(Attitude::identity(), AngularVelocity::new(0.0, 0.0, omega));
        let found = SmallOscillations::about_equilibrium(&rotor, &sink, spin).unwrap();
        let l = along * omega;
        let growth = alpha * l * l * (1.0 / along - 1.0 / across);
        let nutation = found.modes.iter().find(|m| m.growth_rate != 0.0).unwrap();
        assert!((nutation.growth_rate / growth - 1.0).abs() < 1e-9, "{found:?} {growth}");
        assert!(
            (nutation.frequency / ((along / across - 1.0) * omega).abs() - 1.0).abs() < 1e-9,
            "{found:?}"
        );
    }
}

#[test]
fn a_free_body_at_rest_has_only_neutral_ways() {
    let found = SmallOscillations::about_equilibrium(
        &free([1.3, 2.9, 3.7]),
        &[],
        at(Attitude::identity(), AngularVelocity::ZERO),
    )
    .unwrap();
    assert_eq!((found.modes.len(), found.neutral), (0, 6));
}

/// NASA's check-case 10A prints 3257.94 s in the orbit plane and 2821.46 s across it, for a
/// cylinder of 500 and 12 250 kg·m². These are 2π/(n √(3k)) and 2π/(2n √k) with k = 11 750/12 250
/// and an orbit of 5526.6 s. The second neglects the coupling of roll with yaw; with it, the period
/// is 2π/(n √(1 + 3k)), 0.5 % shorter.
#[test]
fn the_printed_libration_of_a_cylinder() {
    let [plane, across] = [3257.94, 2821.46];
    let tau = std::f64::consts::TAU;
    // Orbit of the case: a from its first state, µ = 3.986 004 415e14 m³/s².
    let n = (3.986_004_415e14_f64 / 6_758_662.0_f64.powi(3)).sqrt();
    let k: f64 = 11_750.0 / 12_250.0;
    let found = Libration::of([12_250.0, 12_250.0, 500.0], n).unwrap();
    assert!((tau / found.pitch.unwrap() / plane - 1.0).abs() < 6e-4);
    assert!((tau / (2.0 * n * k.sqrt()) / across - 1.0).abs() < 6e-4);
    // The two periods agree on the orbit to all their digits.
    let [from_plane, from_across] = [plane * (3.0 * k).sqrt(), across * 2.0 * k.sqrt()];
    assert!((from_plane / from_across - 1.0).abs() < 3e-6, "{from_plane} {from_across}");
    let [yaw, roll] = found.roll_yaw.unwrap();
    assert_eq!(yaw, 0.0); // about the axis of symmetry
    assert!((roll / n - (1.0 + 3.0 * k).sqrt()).abs() < 1e-14);
}
